//! What programs use of embedded-graphics' styled shapes beside `draw`, with zrow's style and with its own.

use embedded_graphics::{
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{
        self, Arc, Circle, CornerRadii, Ellipse, Line, Polyline, Primitive, PrimitiveStyleBuilder, Rectangle,
        RoundedRectangle, Sector, Styled, Triangle,
    },
};
use proptest::prelude::*;
use zrow::{
    draw::{FillRule, Points, Polygon, StrokeAlignment, ThinCircle},
    prelude::*,
};

use crate::common::{cases, config, picture};

const AREA: Rectangle = Rectangle::new(Point::new(-60, -60), Size::new(160, 160));

fn style() -> impl Strategy<Value = PrimitiveStyle<Rgb565>> {
    let alignment = prop::sample::select(vec![
        StrokeAlignment::Inside,
        StrokeAlignment::Center,
        StrokeAlignment::Outside,
    ]);
    let colors = (
        prop::option::of(Just(Rgb565::RED)),
        prop::option::of(Just(Rgb565::GREEN)),
    );
    (0..7u32, alignment, colors).prop_map(|(width, alignment, (stroke, fill))| {
        let mut style: PrimitiveStyle<_> = PrimitiveStyleBuilder::new()
            .stroke_width(width)
            .stroke_alignment(alignment)
            .build()
            .into();
        style.stroke_color = stroke;
        style.fill_color = fill;
        style
    })
}

/// `pixels` hands out what is drawn, each pixel once and in order.
macro_rules! check_pixels {
    ($shape:expr, $style:expr) => {{
        let styled = $shape.into_styled($style);
        check_styled_pixels(&styled, styled.pixels());
    }};
}

fn check_styled_pixels<S>(styled: &Styled<S, PrimitiveStyle<Rgb565>>, pixels: impl Iterator<Item = Pixel<Rgb565>>)
where
    Styled<S, PrimitiveStyle<Rgb565>>: DrawOn<Color = Rgb565>,
{
    let style = styled.style;
    let drawn = picture(AREA, |band| {
        let Ok(()) = styled.draw_on(band);
    });
    let expected: Vec<((i32, i32), Rgb565)> = AREA
        .points()
        .zip(drawn)
        .filter(|&(_, color)| color != Rgb565::BLACK)
        .map(|(point, color)| ((point.y, point.x), color))
        .collect();
    let pixels: Vec<((i32, i32), Rgb565)> = pixels.map(|Pixel(point, color)| ((point.y, point.x), color)).collect();
    assert_eq!(pixels, expected, "{style:?}");
}

/// The areas are embedded-graphics' areas, and the pixels that they fill those of the style.
macro_rules! check_areas {
    ($shape:expr, $style:expr, $expected:expr) => {{
        let (style, styled) = ($style, $shape.into_styled($style));
        assert_eq!([styled.fill_area(), styled.stroke_area()], $expected, "{style:?}");
    }};
}

/// embedded-graphics' areas of a shape.
macro_rules! their_areas {
    ($shape:expr, $style:expr) => {{
        let styled = $shape.into_styled(primitives::PrimitiveStyle::from($style));
        [styled.fill_area(), styled.stroke_area()]
    }};
}

fn pixel() -> impl Strategy<Value = Point> {
    (0..30i32, 0..30i32).prop_map(|(x, y)| Point::new(x, y))
}

proptest! {
    #![proptest_config(config(cases(150, 150)))]

    #[test]
    fn pixels_are_those_drawn(
        corners in prop::collection::vec(pixel(), 5),
        size in (1..30u32, 1..30u32),
        angles in (-400.0..400.0f32, -400.0..400.0f32),
        style in style(),
    ) {
        let [a, b, c, d, e] = corners[..] else { return Ok(()) };
        let size = Size::new(size.0, size.1);
        check_pixels!(Line::new(a, b), style);
        let (vertices, spots) = ([a, b, c, d, e], [a]);
        check_pixels!(Polyline::new(&vertices), style);
        check_pixels!(Triangle::new(a, b, c), style);
        check_pixels!(Rectangle::new(a, size), style);
        check_pixels!(RoundedRectangle::with_equal_corners(Rectangle::new(a, size), Size::new(5, 7)), style);
        check_pixels!(Circle::new(a, size.width), style);
        check_pixels!(Ellipse::new(a, size), style);
        check_pixels!(Arc::new(a, size.width, angles.0.deg(), angles.1.deg()), style);
        check_pixels!(Sector::new(a, size.width, angles.0.deg(), angles.1.deg()), style);
        check_pixels!(ThinCircle::new(a, size.width), style);
        check_pixels!(Points::discs(&spots, 4), style);
        let contours: [&[Point]; 1] = [&[a, b, c, d, e]];
        let polygon = Polygon::new(&contours, FillRule::EvenOdd).prepare::<8, 8>().unwrap();
        check_pixels!(&polygon, style);
    }

    #[test]
    fn areas_are_those_of_embedded_graphics(top_left in pixel(), size in (0..30u32, 0..30u32), radii in prop::array::uniform8(0..20u32), style in style()) {
        let size = Size::new(size.0, size.1);
        let rectangle = Rectangle::new(top_left, size);
        check_areas!(rectangle, style, their_areas!(rectangle, style));
        let [a, b, c, d, e, f, g, h] = radii;
        let corners = CornerRadii {
            top_left: Size::new(a, b),
            top_right: Size::new(c, d),
            bottom_right: Size::new(e, f),
            bottom_left: Size::new(g, h),
        };
        let rounded = RoundedRectangle::new(rectangle, corners);
        check_areas!(rounded, style, their_areas!(rounded, style));
        let circle = Circle::new(top_left, size.width);
        check_areas!(circle, style, their_areas!(circle, style));
        let ellipse = Ellipse::new(top_left, size);
        check_areas!(ellipse, style, their_areas!(ellipse, style));
        let sector = Sector::new(top_left, size.width, 30.0.deg(), 200.0.deg());
        check_areas!(sector, style, their_areas!(sector, style));
    }

    /// `draw_on` draws a shape in embedded-graphics' style with the pixels of the same style of zrow.
    #[test]
    fn their_styles_are_drawn_on_a_target(a in pixel(), b in pixel(), c in pixel(), style in style()) {
        let triangle = Triangle::new(a, b, c);
        let ours = picture(AREA, |band| {
            let Ok(()) = triangle.into_styled(style).draw_on(band);
        });
        let theirs = picture(AREA, |band| {
            let Ok(()) = triangle.into_styled(primitives::PrimitiveStyle::from(style)).draw_on(band);
        });
        prop_assert_eq!(ours, theirs);
    }

    #[test]
    fn styles_are_converted_both_ways(style in style()) {
        let theirs = primitives::PrimitiveStyle::from(style);
        prop_assert_eq!(PrimitiveStyle::from(theirs), style);
        prop_assert_eq!(theirs.is_transparent(), style.is_transparent());
    }
}

#[test]
fn areas_of_extreme_shapes_end_with_the_numbers() {
    let style: PrimitiveStyle<Rgb565> = PrimitiveStyleBuilder::new()
        .stroke_width(u32::MAX)
        .stroke_alignment(StrokeAlignment::Outside)
        .build()
        .into();
    let circle = Circle::new(Point::new(i32::MIN, i32::MAX), 3).into_styled(style);
    assert_eq!(circle.stroke_area(), Circle::new(Point::new(i32::MIN, 1), u32::MAX));
    let inside: PrimitiveStyle<_> = PrimitiveStyleBuilder::from(&style.into())
        .stroke_alignment(StrokeAlignment::Inside)
        .build()
        .into();
    assert_eq!(circle.primitive.into_styled(inside).fill_area().diameter, 0);
}

/// A shape with a box as large as the numbers has its first pixel at once.
#[test]
fn pixels_of_the_largest_rectangle_begin_at_once() {
    let all = Rectangle::new(Point::new(i32::MIN, i32::MIN), Size::new(u32::MAX, u32::MAX));
    let styled = all.into_styled(PrimitiveStyle::with_fill(Rgb565::RED));
    let first: Vec<Point> = styled.pixels().take(2).map(|Pixel(point, _)| point).collect();
    assert_eq!(
        first,
        [Point::new(i32::MIN, i32::MIN), Point::new(i32::MIN + 1, i32::MIN)]
    );
}
