//! The bounding box of every shape in every style is the smallest one around its pixels.

mod common;

use common::{config, painted};
use embedded_graphics::{
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{
        self, Arc, Circle, CornerRadii, Ellipse, Line, Polyline, Rectangle, RoundedRectangle, Sector, StyledDimensions,
        Triangle,
    },
};
use fixed::types::{U8F8, U16F16};
use proptest::prelude::*;
use zrow::{
    draw::{
        DashPattern, DrawOn, FillRule, LineCap, LineJoin, Path, PathCommand, Points, Polygon, PrimitiveStyle,
        PrimitiveStyleBuilder, StrokeAlignment, StrokeStyle, StrokedShape, StyledShape, ThinCircle,
    },
    geometry::{Sub8, SubPoint},
};

/// Where everything that is drawn here lies.
const AREA: Rectangle = Rectangle::new(Point::new(-90, -90), Size::new(220, 220));

/// Fill and stroke are both visible.
fn style() -> impl Strategy<Value = PrimitiveStyle<Rgb565>> {
    let alignment = prop::sample::select(vec![
        StrokeAlignment::Inside,
        StrokeAlignment::Center,
        StrokeAlignment::Outside,
    ]);
    let width = prop_oneof![Just(0), Just(1), Just(2), Just(3), 4..14u32];
    (width, alignment).prop_map(|(width, alignment)| {
        PrimitiveStyleBuilder::new()
            .fill_color(Rgb565::GREEN)
            .stroke_color(Rgb565::RED)
            .stroke_width(width)
            .stroke_alignment(alignment)
            .build()
    })
}

/// The smallest rectangle around pixels; `None` where there are none.
fn around(pixels: &[Point]) -> Option<Rectangle> {
    let first = *pixels.first()?;
    let (least, most) = pixels.iter().fold((first, first), |(least, most), &pixel| {
        (least.component_min(pixel), most.component_max(pixel))
    });
    Some(Rectangle::with_corners(least, most))
}

/// Compares the box of a shape with the pixels that it draws. A shape without a pixel has an empty box.
fn check<S>(shape: &S, style: PrimitiveStyle<Rgb565>, name: &dyn core::fmt::Debug)
where
    S: StyledShape + StyledDimensions<PrimitiveStyle<Rgb565>>,
{
    let pixels = painted(AREA, |band| {
        let Ok(()) = shape.draw_styled_on(&style, band);
    });
    let bounds = shape.styled_bounding_box(&style);
    match around(&pixels) {
        Some(expected) => assert_eq!(bounds, expected, "{name:?} in {style:?}"),
        None => assert!(
            bounds.is_zero_sized(),
            "{bounds:?} of {name:?} in {style:?}, which has no pixel"
        ),
    }
}

/// Compares the box of a shape with embedded-graphics' box, and finds all its pixels in there.
fn check_against_embedded_graphics<S>(shape: &S, style: PrimitiveStyle<Rgb565>)
where
    S: StyledShape
        + StyledDimensions<PrimitiveStyle<Rgb565>>
        + StyledDimensions<primitives::PrimitiveStyle<Rgb565>>
        + core::fmt::Debug,
{
    let mut theirs = primitives::PrimitiveStyle::new();
    theirs.stroke_width = style.stroke_width;
    theirs.stroke_alignment = style.stroke_alignment;
    theirs.stroke_color = style.stroke_color;
    theirs.fill_color = style.fill_color;
    let bounds = shape.styled_bounding_box(&style);
    assert_eq!(bounds, shape.styled_bounding_box(&theirs), "{shape:?} in {style:?}");
    let pixels = painted(AREA, |band| {
        let Ok(()) = shape.draw_styled_on(&style, band);
    });
    for pixel in pixels {
        assert!(
            bounds.contains(pixel),
            "{pixel} of {shape:?} in {style:?} is outside {bounds:?}"
        );
    }
}

/// Compares the box of a stroke with the pixels that it draws; a dashed one may have less in it.
fn check_stroke<S>(shape: &S, style: StrokeStyle<'_, Rgb565>) -> Result<(), TestCaseError>
where
    S: StrokedShape + Primitive + Clone + core::fmt::Debug,
    for<'s> S: StyledDimensions<StrokeStyle<'s, Rgb565>>,
{
    let of = |style: StrokeStyle<'_, Rgb565>| {
        let styled = shape.clone().into_styled(style);
        let pixels = painted(AREA, |band| {
            let Ok(()) = styled.draw_on(band);
        });
        (pixels, shape.styled_bounding_box(&style))
    };
    let (pixels, bounds) = of(style);
    match around(&pixels) {
        Some(expected) => prop_assert_eq!(bounds, expected, "{:?} in {:?}", shape, style),
        None => prop_assert!(
            bounds.is_zero_sized(),
            "{:?} of {:?} in {:?}, which has no pixel",
            bounds,
            shape,
            style
        ),
    }
    let lengths = [U16F16::from_num(2), U16F16::from_num(3)];
    let (dashes, bounds) = of(style.dashes(DashPattern::new(&lengths)));
    prop_assert!(
        dashes.iter().all(|&pixel| bounds.contains(pixel)),
        "dashes of {:?} in {:?}",
        shape,
        style
    );
    Ok(())
}

fn stroke_style() -> impl Strategy<Value = StrokeStyle<'static, Rgb565>> {
    let cap = prop::sample::select(vec![
        LineCap::WholePixel,
        LineCap::Butt,
        LineCap::Square,
        LineCap::Round,
    ]);
    let join = prop::sample::select(vec![
        LineJoin::Bevel,
        LineJoin::Round,
        LineJoin::Miter {
            limit: U8F8::from_num(3),
        },
    ]);
    (1..14u32, cap, join).prop_map(|(width, cap, join)| StrokeStyle::new(Rgb565::RED, width).cap(cap).join(join))
}

fn pixel() -> impl Strategy<Value = Point> {
    prop_oneof![
        (0..30i32, 0..30i32),
        (0..6i32, 0..6i32),
        (0..30i32, 10..12i32),
        (10..12i32, 0..30i32),
    ]
    .prop_map(|(x, y)| Point::new(x, y))
}

/// In 1/256 pixel; small polygons and thin ones among them.
fn position() -> impl Strategy<Value = SubPoint<Sub8>> {
    prop_oneof![
        (0..8_000i32, 0..8_000i32),
        (0..700i32, 0..700i32),
        (0..8_000i32, 2_000..2_300i32),
        (2_000..2_300i32, 0..8_000i32),
        (0..12i32, 0..12i32).prop_map(|(x, y)| (256 * x, 256 * y)),
    ]
    .prop_map(|(x, y)| SubPoint::from_units(x, y).unwrap())
}

fn fill_rule() -> impl Strategy<Value = FillRule> {
    prop::sample::select(vec![FillRule::EvenOdd, FillRule::NonZero])
}

fn size() -> impl Strategy<Value = Size> {
    prop_oneof![(0..40u32, 0..40u32), (0..5u32, 0..40u32), (0..40u32, 0..5u32),]
        .prop_map(|(width, height)| Size::new(width, height))
}

proptest! {
    #![proptest_config(config(600))]

    #[test]
    fn lines(from in pixel(), to in pixel(), style in style()) {
        let line = Line::new(from, to);
        if style.stroke_width > 0 {
            check(&line, style, &line);
        }
    }

    #[test]
    fn strokes_with_caps_and_joins(
        vertices in prop::collection::vec(pixel(), 0..6),
        contour in prop::collection::vec(position(), 0..6),
        size in size(),
        style in stroke_style(),
    ) {
        check_stroke(&Polyline::new(&vertices), style)?;
        check_stroke(&Polygon::new(&[contour.as_slice()], FillRule::NonZero), style)?;
        if let [a, b, c, ..] = vertices[..] {
            check_stroke(&Line::new(a, b), style)?;
            check_stroke(&Triangle::new(a, b, c), style)?;
            check_stroke(&Rectangle::new(a, size), style)?;
        }
    }

    #[test]
    fn polylines(vertices in prop::collection::vec(pixel(), 0..7), x in -9..9i32, y in -9..9i32, style in style()) {
        let polyline = Polyline { translate: Point::new(x, y), vertices: &vertices };
        if style.stroke_width > 0 {
            check(&polyline, style, &polyline);
        }
    }

    #[test]
    fn triangles(a in pixel(), b in pixel(), c in pixel(), style in style()) {
        let triangle = Triangle::new(a, b, c);
        check(&triangle, style, &triangle);
    }

    #[test]
    fn polygons_of_pixels(contours in prop::collection::vec(prop::collection::vec(pixel(), 0..7), 0..3), rule in fill_rule(), style in style()) {
        let contours: Vec<&[Point]> = contours.iter().map(Vec::as_slice).collect();
        let polygon = Polygon::new(&contours, rule).prepare::<16, 16>().unwrap();
        check(&polygon, style, &contours);
    }

    #[test]
    fn polygons_of_positions(contours in prop::collection::vec(prop::collection::vec(position(), 0..7), 0..3), rule in fill_rule(), style in style()) {
        let contours: Vec<&[SubPoint<Sub8>]> = contours.iter().map(Vec::as_slice).collect();
        let polygon = Polygon::new(&contours, rule).prepare::<16, 16>().unwrap();
        check(&polygon, style, &contours);
    }

    #[test]
    fn paths(commands in prop::collection::vec(command(), 0..7), rule in fill_rule(), style in style()) {
        let path = Path::new(&commands, rule).unwrap();
        if style.stroke_width > 0 {
            check(&path, style, &commands);
        }
        let filled = path.prepare::<256, 64>().unwrap();
        check(&filled, style, &commands);
    }

    #[test]
    fn shapes_in_a_box(top_left in pixel(), size in size(), style in style()) {
        if size.width == 0 || size.height == 0 {
            return Ok(());
        }
        let rectangle = Rectangle::new(top_left, size);
        check(&rectangle, style, &rectangle);
        let circle = Circle::new(top_left, size.width);
        check(&circle, style, &circle);
        let thin = ThinCircle::new(top_left, size.width);
        if style.stroke_width > 0 {
            check(&thin, style, &thin);
        }
        let centers = [top_left, top_left + size];
        let (squares, discs) = (Points::squares(&centers, size.height), Points::discs(&centers, size.height));
        check(&squares, style, &squares);
        check(&discs, style, &discs);
    }

    /// Their boxes are what layouts are made of, so they are embedded-graphics' own: also where an ellipse has no pixel in
    /// the first row of its box (8 x 2 in its first column), and around the whole circle of an arc or a sector.
    #[test]
    fn boxes_of_shapes_that_may_not_fill_them(
        top_left in pixel(),
        size in size(),
        radii in prop::array::uniform8(0..30u32),
        angles in (-400.0..400.0f32, -400.0..400.0f32),
        style in style(),
    ) {
        let (start, sweep) = (angles.0.deg(), angles.1.deg());
        let [a, b, c, d, e, f, g, h] = radii;
        let corners = CornerRadii {
            top_left: Size::new(a, b),
            top_right: Size::new(c, d),
            bottom_right: Size::new(e, f),
            bottom_left: Size::new(g, h),
        };
        check_against_embedded_graphics(&Ellipse::new(top_left, size), style);
        check_against_embedded_graphics(&RoundedRectangle::new(Rectangle::new(top_left, size), corners), style);
        check_against_embedded_graphics(&Arc::new(top_left, size.width, start, sweep), style);
        check_against_embedded_graphics(&Sector::new(top_left, size.width, start, sweep), style);
    }
}

fn command() -> impl Strategy<Value = PathCommand<Sub8>> {
    prop_oneof![
        position().prop_map(PathCommand::MoveTo),
        position().prop_map(PathCommand::LineTo),
        (position(), position()).prop_map(|(control, end)| PathCommand::QuadraticTo(control, end)),
        (position(), position(), position()).prop_map(|(one, other, end)| PathCommand::CubicTo(one, other, end)),
        Just(PathCommand::Close),
    ]
}
