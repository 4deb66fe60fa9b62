//! The bounding box of every shape in every style is the smallest one around its pixels.

use embedded_graphics::{
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{
        Arc, Circle, CornerRadii, Ellipse, Line, Polyline, PrimitiveStyleBuilder, Rectangle, RoundedRectangle, Sector,
        Styled, StyledDimensions, Triangle,
    },
};
use fixed::types::{I16F16, U8F8, U16F16};
use proptest::prelude::*;
use zrow::{
    draw::{
        DrawOn, FillRule, LineCap, LineJoin, Path, PathCommand, Points, Polygon, PrimitiveStyle, StrokeAlignment,
        StrokeStyle, ThinCircle,
    },
    geometry::{Sub8, SubPoint},
};

use crate::common::{cases, config, encloses, painted};

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
            .into()
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
    S: StyledDimensions<PrimitiveStyle<Rgb565>>,
    for<'s> Styled<&'s S, PrimitiveStyle<Rgb565>>: DrawOn<Color = Rgb565>,
{
    let pixels = painted(AREA, |band| {
        let Ok(()) = Styled::new(shape, style).draw_on(band);
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

/// Compares the box of a stroke with the pixels that it draws.
fn check_stroke<S>(shape: &S, style: StrokeStyle<'_, Rgb565>) -> Result<(), TestCaseError>
where
    S: Primitive + Clone + core::fmt::Debug,
    for<'s> Styled<S, StrokeStyle<'s, Rgb565>>: DrawOn<Color = Rgb565>,
    for<'s> S: StyledDimensions<StrokeStyle<'s, Rgb565>>,
{
    let styled = shape.clone().into_styled(style);
    let pixels = painted(AREA, |band| {
        let Ok(()) = styled.draw_on(band);
    });
    let bounds = shape.styled_bounding_box(&style);
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
    Ok(())
}

/// Compares the boxes of the strokes of all shapes of these vertices.
fn check_strokes(
    vertices: &[Point],
    contour: &[SubPoint<Sub8>],
    size: Size,
    style: StrokeStyle<'_, Rgb565>,
) -> Result<(), TestCaseError> {
    check_stroke(&Polyline::new(vertices), style)?;
    check_stroke(&Polygon::new(&[contour], FillRule::NonZero), style)?;
    if let [a, b, c, ..] = *vertices {
        check_stroke(&Line::new(a, b), style)?;
        check_stroke(&Triangle::new(a, b, c), style)?;
        check_stroke(&Rectangle::new(a, size), style)?;
    }
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
    #![proptest_config(config(cases(75, 600)))]

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
        check_strokes(&vertices, &contour, size, style)?;
    }

    #[test]
    fn dashes(
        vertices in prop::collection::vec(pixel(), 0..6),
        contour in prop::collection::vec(position(), 0..6),
        size in size(),
        style in stroke_style(),
        lengths in prop::collection::vec(prop_oneof![0..200u32, 20_000..300_000u32, 200_000..4_000_000u32], 1..5),
        offset in 0..4_000_000i32,
    ) {
        let lengths: Vec<U16F16> = lengths.into_iter().map(U16F16::from_bits).collect();
        let style = style.dashes(&lengths).dash_offset(I16F16::from_bits(offset));
        check_strokes(&vertices, &contour, size, style)?;
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

    #[test]
    fn ellipses_and_rounded_rectangles(
        top_left in pixel(),
        size in size(),
        radii in prop::array::uniform8(prop_oneof![0..30u32, 0..4u32]),
        style in style(),
    ) {
        if size.width == 0 || size.height == 0 {
            return Ok(());
        }
        let [a, b, c, d, e, f, g, h] = radii;
        let corners = CornerRadii {
            top_left: Size::new(a, b),
            top_right: Size::new(c, d),
            bottom_right: Size::new(e, f),
            bottom_left: Size::new(g, h),
        };
        let ellipse = Ellipse::new(top_left, size);
        check(&ellipse, style, &ellipse);
        let rectangle = RoundedRectangle::new(Rectangle::new(top_left, size), corners);
        check(&rectangle, style, &rectangle);
        let rectangle = RoundedRectangle::with_equal_corners(Rectangle::new(top_left, size), Size::new(a, b));
        check(&rectangle, style, &rectangle);
    }
}

proptest! {
    #![proptest_config(config(cases(300, 3_000)))]

    #[test]
    fn arcs_and_sectors(
        top_left in pixel(),
        diameter in prop_oneof![1..8u32, 1..60u32],
        start in angle(),
        sweep in angle(),
        style in style(),
    ) {
        if style.stroke_width > 0 {
            let arc = Arc::new(top_left, diameter, start.deg(), sweep.deg());
            check(&arc, style, &arc);
        }
        let sector = Sector::new(top_left, diameter, start.deg(), sweep.deg());
        check(&sector, style, &sector);
    }
}

proptest! {
    #![proptest_config(config(cases(15, 60)))]

    #[test]
    fn large_arcs_and_sectors(
        diameter in 300..700u32,
        start in angle(),
        sweep in angle(),
        width in prop_oneof![1..9u32, 1..300u32],
    ) {
        let area = Rectangle::new(Point::new(-320, -320), Size::new(1_340, 1_340));
        let style = PrimitiveStyle::with_stroke(Rgb565::RED, width);
        let arc = Arc::new(Point::zero(), diameter, start.deg(), sweep.deg());
        let pixels = painted(area, |band| {
            let Ok(()) = arc.into_styled(style).draw_on(band);
        });
        let expected = around(&pixels).unwrap_or_default();
        prop_assert_eq!(arc.styled_bounding_box(&style), expected, "{:?}, {}", arc, width);
        let sector = Sector::new(Point::zero(), diameter, start.deg(), sweep.deg());
        let filled: PrimitiveStyle<_> = PrimitiveStyleBuilder::from(&style.into()).fill_color(Rgb565::RED).build().into();
        let pixels = painted(area, |band| {
            let Ok(()) = sector.into_styled(filled).draw_on(band);
        });
        let expected = around(&pixels).unwrap_or_default();
        prop_assert_eq!(sector.styled_bounding_box(&filled), expected, "{:?}, {}", sector, width);
    }
}

/// Any number, ends of the number range among them.
fn any_number() -> impl Strategy<Value = i32> {
    prop_oneof![
        any::<i32>(),
        prop::sample::select(vec![i32::MIN, i32::MAX, i32::MIN + 9]),
        -40..40i32
    ]
}

proptest! {
    #![proptest_config(config(cases(50, 400)))]

    /// Whatever the numbers are, pixels near the corners of a box and near its middle are inside.
    #[test]
    fn boxes_of_any_numbers(
        numbers in prop::array::uniform4(any_number()),
        more in prop::array::uniform4(any_number()),
        angles in (prop_oneof![angle(), any::<f32>()], prop_oneof![angle(), any::<f32>()]),
        width in prop_oneof![1..9u32, any::<u32>()],
        lengths in prop::collection::vec(prop_oneof![0..200u32, 20_000..300_000u32, any::<u32>()], 1..4),
    ) {
        let [x, y, columns, rows] = numbers;
        let [a, b, c, d] = more.map(|number| number as u32);
        let (top_left, size) = (Point::new(x, y), Size::new(columns as u32, rows as u32));
        let style: PrimitiveStyle<_> = PrimitiveStyleBuilder::new()
            .fill_color(Rgb565::GREEN)
            .stroke_color(Rgb565::RED)
            .stroke_width(width)
            .build().into();
        let (start, sweep) = (angles.0.deg(), angles.1.deg());
        let corners = CornerRadii {
            top_left: Size::new(a, b),
            top_right: Size::new(c, d),
            bottom_right: Size::new(b, c),
            bottom_left: Size::new(d, a),
        };
        check_anywhere(&Arc::new(top_left, size.width, start, sweep), style)?;
        check_anywhere(&Sector::new(top_left, size.width, start, sweep), style)?;
        check_anywhere(&Ellipse::new(top_left, size), style)?;
        check_anywhere(&RoundedRectangle::new(Rectangle::new(top_left, size), corners), style)?;
        let lengths: Vec<U16F16> = lengths.into_iter().map(U16F16::from_bits).collect();
        let dashed = StrokeStyle::new(Rgb565::RED, width).dashes(&lengths);
        check_anywhere(&Line::new(top_left, Point::new(columns, rows)), dashed)?;
    }
}

/// Draws in windows about the corners of a shape's box and its middle: every pixel has to be in the box.
fn check_anywhere<S, St>(shape: &S, style: St) -> Result<(), TestCaseError>
where
    S: Primitive + Clone + StyledDimensions<St> + core::fmt::Debug,
    St: Copy,
    Styled<S, St>: DrawOn<Color = Rgb565>,
{
    let bounds = shape.styled_bounding_box(&style);
    let styled = shape.clone().into_styled(style);
    let far = |start: i32, length: u32| i64::from(start) + i64::from(length);
    for (right, down) in [(0, 0), (1, 0), (0, 1), (1, 1), (2, 2)] {
        let start_at = |start: i32, length: u32, part: i32| {
            let at = match part {
                0 => i64::from(start),
                1 => far(start, length),
                _ => far(start, length / 2),
            };
            (at - 8).clamp(i32::MIN.into(), i64::from(i32::MAX) - 16) as i32
        };
        let corner = Point::new(
            start_at(bounds.top_left.x, bounds.size.width, right),
            start_at(bounds.top_left.y, bounds.size.height, down),
        );
        let pixels = painted(Rectangle::new(corner, Size::new(16, 16)), |band| {
            let Ok(()) = styled.draw_on(band);
        });
        for pixel in pixels {
            prop_assert!(
                encloses(&bounds, pixel),
                "{} of {:?} is outside {:?}",
                pixel,
                shape,
                bounds
            );
        }
    }
    Ok(())
}

/// Degrees: any, narrow sweeps and those close to whole quarters among them.
fn angle() -> impl Strategy<Value = f32> {
    prop_oneof![
        -400.0..400.0f32,
        -4.0..4.0f32,
        (-5..6i32, -1.0..1.0f32).prop_map(|(quarters, more)| 90.0 * quarters as f32 + more),
        (-16..17i32).prop_map(|eighths| 45.0 * eighths as f32),
    ]
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
