//! Arcs, sectors and rounded rectangles against embedded-graphics, and beyond its number range against themselves moved.

mod common;

use common::{config, picture};
use embedded_graphics::{
    mock_display::MockDisplay,
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{self, Arc, CornerRadii, OffsetOutline, Rectangle, RoundedRectangle, Sector, StyledDrawable},
};
use micromath::F32Ext;
use proptest::{prelude::*, test_runner::Config};
use zrow::draw::{PrimitiveStyle, PrimitiveStyleBuilder, StrokeAlignment, StyledShape};

const STROKE: Rgb565 = Rgb565::RED;
const FILL: Rgb565 = Rgb565::GREEN;

/// A style for both libraries.
#[derive(Debug, Clone, Copy)]
struct Style {
    width: u32,
    alignment: StrokeAlignment,
    stroke: bool,
    fill: bool,
}

impl Style {
    fn ours(&self) -> PrimitiveStyle<Rgb565> {
        let mut style = PrimitiveStyleBuilder::new()
            .stroke_width(self.width)
            .stroke_alignment(self.alignment)
            .build();
        style.stroke_color = self.stroke.then_some(STROKE);
        style.fill_color = self.fill.then_some(FILL);
        style
    }

    fn theirs(&self) -> primitives::PrimitiveStyle<Rgb565> {
        let mut style = primitives::PrimitiveStyleBuilder::new()
            .stroke_width(self.width)
            .stroke_alignment(self.alignment)
            .build();
        style.stroke_color = self.stroke.then_some(STROKE);
        style.fill_color = self.fill.then_some(FILL);
        style
    }
}

fn styles() -> impl Strategy<Value = Style> {
    let alignment = prop_oneof![
        Just(StrokeAlignment::Inside),
        Just(StrokeAlignment::Center),
        Just(StrokeAlignment::Outside),
    ];
    let width = prop_oneof![Just(0u32), Just(1), 0u32..12, Just(40)];
    (width, alignment, any::<bool>(), any::<bool>()).prop_map(|(width, alignment, stroke, fill)| Style {
        width,
        alignment,
        stroke,
        fill,
    })
}

/// Whole and half degrees, quarters, sweeps near the angles at which corners are cut off, and any.
fn degrees() -> impl Strategy<Value = f32> {
    prop_oneof![
        (-800i32..=800).prop_map(|half| half as f32 / 2.0),
        (-8i32..=8).prop_map(|quarter| quarter as f32 * 90.0),
        prop::sample::select(vec![
            54.5, 55.0, 55.5, -55.0, 304.5, 305.0, 305.5, -305.0, 359.5, 360.0, 180.0, -180.0
        ]),
        -400.0f32..400.0,
    ]
}

const WINDOW: Rectangle = Rectangle::new(Point::new(-12, -9), Size::new(70, 61));

fn by_embedded_graphics(
    shape: &impl StyledDrawable<primitives::PrimitiveStyle<Rgb565>, Color = Rgb565>,
    style: &Style,
) -> Vec<Rgb565> {
    picture(WINDOW, |band| {
        assert!(shape.draw_styled(&style.theirs(), band).is_ok());
    })
}

fn by_us(window: Rectangle, shape: &impl StyledShape, style: &Style) -> Vec<Rgb565> {
    picture(window, |band| {
        let Ok(()) = shape.draw_styled_on(&style.ours(), band);
    })
}

/// Whether embedded-graphics has the same normal vectors on this machine as on a microcontroller.
///
/// Its sines and cosines are micromath's there. Here they are those of the standard library, which it sees without asking
/// for it, because another library of the tests links that.
fn has_same_normals(angles: &[Angle]) -> bool {
    let scaled = |value: f32| (value * 1024.0) as i32;
    angles.iter().all(|angle| {
        let radians = angle.to_radians();
        *angle == 180.0.deg()
            || scaled(f32::sin(radians)) == scaled(F32Ext::sin(radians))
                && scaled(f32::cos(radians)) == scaled(F32Ext::cos(radians))
    })
}

/// Another place for the same picture: the window and the shape moved by as much.
fn moved(window: Rectangle, by: Point) -> Rectangle {
    Rectangle::new(window.top_left + by, window.size)
}

proptest! {
    #![proptest_config(Config { max_global_rejects: 60_000, ..config(1_500) })]

    #[test]
    fn arcs_are_those_of_embedded_graphics(
        x in -40..50i32,
        y in -40..50i32,
        diameter in 0..70u32,
        start in degrees(),
        sweep in degrees(),
        style in styles(),
        far in prop::sample::select(vec![Point::new(0, 0), Point::new(i32::MAX - 200, i32::MIN + 100)]),
    ) {
        let arc = |by: Point| Arc::new(Point::new(x, y) + by, diameter, start.deg(), sweep.deg());
        prop_assume!(has_same_normals(&[start.deg(), start.deg() + sweep.deg()]));
        let expected = by_embedded_graphics(&arc(Point::zero()), &style);
        prop_assert_eq!(&by_us(WINDOW, &arc(Point::zero()), &style), &expected);
        prop_assert_eq!(by_us(moved(WINDOW, far), &arc(far), &style), expected);
    }

    #[test]
    fn sectors_are_those_of_embedded_graphics(
        x in -40..50i32,
        y in -40..50i32,
        diameter in 0..70u32,
        start in degrees(),
        sweep in degrees(),
        style in styles(),
        far in prop::sample::select(vec![Point::new(0, 0), Point::new(i32::MAX - 200, i32::MIN + 100)]),
    ) {
        let sector = |by: Point| Sector::new(Point::new(x, y) + by, diameter, start.deg(), sweep.deg());
        let half = start.deg() + Angle::from_radians(sweep.deg().to_radians() / 2.0);
        let angles = [start.deg(), start.deg() + sweep.deg(), half - 90.0.deg(), half + 90.0.deg()];
        prop_assume!(has_same_normals(&angles));
        let expected = by_embedded_graphics(&sector(Point::zero()), &style);
        prop_assert_eq!(&by_us(WINDOW, &sector(Point::zero()), &style), &expected);
        prop_assert_eq!(by_us(moved(WINDOW, far), &sector(far), &style), expected);
    }
}

fn corner_radii() -> impl Strategy<Value = CornerRadii> {
    let radius = || (0..24u32, 0..24u32).prop_map(|(width, height)| Size::new(width, height));
    let equal = radius().prop_map(CornerRadii::new);
    let round = (0..40u32).prop_map(|radius| CornerRadii::new(Size::new_equal(radius)));
    let different = (radius(), radius(), radius(), radius()).prop_map(|(a, b, c, d)| CornerRadii {
        top_left: a,
        top_right: b,
        bottom_right: c,
        bottom_left: d,
    });
    prop_oneof![equal, round, different]
}

/// Whether a quarter of an ellipse has a pixel in each of its rows: where it has none, embedded-graphics leaves the corner
/// square in that row.
fn has_every_row(radius: Size) -> bool {
    let (width, height) = (2 * i128::from(radius.width), 2 * i128::from(radius.height));
    let dy = height - 1;
    width == 0 || height == 0 || height * height + width * width * dy * dy < width * width * height * height
}

proptest! {
    #![proptest_config(Config { max_global_rejects: 60_000, ..config(4_000) })]

    #[test]
    fn rounded_rectangles_are_those_of_embedded_graphics(
        x in -40..50i32,
        y in -40..50i32,
        width in 1..70u32,
        height in 1..70u32,
        corners in corner_radii(),
        style in styles(),
        far in prop::sample::select(vec![Point::new(0, 0), Point::new(i32::MAX - 200, i32::MIN + 100)]),
    ) {
        let rectangle = |by: Point| {
            RoundedRectangle::new(Rectangle::new(Point::new(x, y) + by, Size::new(width, height)), corners)
        };
        let (outside, inside) = match style.alignment {
            StrokeAlignment::Inside => (0, style.width),
            StrokeAlignment::Center => (style.width / 2, style.width.div_ceil(2)),
            StrokeAlignment::Outside => (style.width, 0),
        };
        for moved in [rectangle(Point::zero()).offset(outside as i32), rectangle(Point::zero()).offset(-(inside as i32))] {
            let CornerRadii { top_left, top_right, bottom_right, bottom_left } = moved.confine_radii().corners;
            prop_assume!([top_left, top_right, bottom_right, bottom_left].into_iter().all(has_every_row));
            // embedded-graphics confines by one side only; where corners overlap then, it draws one of them.
            let heights = (top_left.height + bottom_left.height).max(top_right.height + bottom_right.height);
            let widths = (top_left.width + top_right.width).max(bottom_left.width + bottom_right.width);
            let size = moved.rectangle.size;
            prop_assume!(heights <= size.height && widths <= size.width);
        }
        let inner = rectangle(Point::zero()).offset(-(inside as i32)).rectangle.size;
        if inner.width == 0 || inner.height == 0 {
            // The stroke takes everything. embedded-graphics loses the rows of an area without columns.
            let outer = rectangle(Point::zero()).offset(outside as i32);
            let stroke = style.ours().effective_stroke_color();
            let whole = picture(WINDOW, |band| {
                if let Some(color) = stroke {
                    assert!(outer.draw_styled_on(&PrimitiveStyle::with_fill(color), band).is_ok());
                }
            });
            prop_assert_eq!(&by_us(WINDOW, &rectangle(Point::zero()), &style), &whole);
            return Ok(());
        }
        let expected = by_embedded_graphics(&rectangle(Point::zero()), &style);
        prop_assert_eq!(&by_us(WINDOW, &rectangle(Point::zero()), &style), &expected);
        prop_assert_eq!(by_us(moved(WINDOW, far), &rectangle(far), &style), expected);
    }
}

/// A quarter ellipse of 1 x 4 has no pixel in its first row, which then has none of the corner's columns.
#[test]
fn a_corner_without_a_pixel_in_a_row_is_cut_off_there() {
    let mut display = MockDisplay::<Rgb565>::new();
    RoundedRectangle::with_equal_corners(Rectangle::new(Point::zero(), Size::new(6, 9)), Size::new(1, 4))
        .into_styled(PrimitiveStyle::with_fill(STROKE))
        .draw(&mut display)
        .unwrap();
    display.assert_pattern(&[
        " RRRR ", "RRRRRR", "RRRRRR", "RRRRRR", "RRRRRR", "RRRRRR", "RRRRRR", "RRRRRR", " RRRR ",
    ]);
}

/// Whether a pixel of the corner's box, counted from the outside, is nearer to the middle of the ellipse than its border is.
fn is_in_quarter_ellipse(radius: Size, x: i64, y: i64) -> bool {
    let (width, height) = (2 * i128::from(radius.width), 2 * i128::from(radius.height));
    let (dx, dy) = (width - 1 - 2 * i128::from(x), height - 1 - 2 * i128::from(y));
    let (width_2, height_2) = (width * width, height * height);
    height_2 * dx * dx + width_2 * dy * dy < width_2 * height_2
}

proptest! {
    #![proptest_config(config(1_000))]

    /// Corners of displays, and beyond 32-bit numbers; the upper right one may reach beyond the middle row.
    #[test]
    fn unequal_corners_are_quarters_of_ellipses(
        log_size in 5..13u32,
        radii in prop::array::uniform8(0.1..1.0f32),
        place in (0.0..1.0f32, 0.0..1.0f32),
    ) {
        let length = 1u32 << log_size;
        let (width, height) = (2 * length, 3 * length);
        let part = |length: u32, share: f32| (length as f32 * share) as u32;
        let radius = |index: usize, most: u32| Size::new(part(length, radii[index]), part(most, radii[index + 1]));
        let corners = CornerRadii {
            top_left: radius(0, length),
            top_right: radius(2, 2 * length),
            bottom_right: radius(4, length),
            bottom_left: radius(6, length),
        };
        let shape = RoundedRectangle::new(Rectangle::new(Point::zero(), Size::new(width, height)), corners);
        let window_at = Point::new(part(width, place.0) as i32 - 20, part(height, place.1) as i32 - 20);
        let window = Rectangle::new(window_at, Size::new(40, 40));
        let style = Style { width: 0, alignment: StrokeAlignment::Center, stroke: false, fill: true };
        let drawn = by_us(window, &shape, &style);
        for (point, color) in window.points().zip(drawn) {
            let inside = shape.rectangle.contains(point) && {
                let (x, y) = (i64::from(point.x), i64::from(point.y));
                let (right, bottom) = (i64::from(width) - 1 - x, i64::from(height) - 1 - y);
                [
                    (corners.top_left, x, y),
                    (corners.top_right, right, y),
                    (corners.bottom_right, right, bottom),
                    (corners.bottom_left, x, bottom),
                ]
                .into_iter()
                .all(|(radius, x, y)| {
                    let is_in_box = x < i64::from(radius.width) && y < i64::from(radius.height);
                    !is_in_box || is_in_quarter_ellipse(radius, x, y)
                })
            };
            prop_assert_eq!(color == FILL, inside, "{:?} {:?}", point, corners);
        }
    }
}

/// Sizes, radii, widths and positions at the ends of their ranges, on windows at the ends of theirs.
#[test]
fn nothing_is_too_large() {
    let extremes = [i32::MIN, -1, 0, 7, i32::MAX];
    let sizes = [0, 1, 9, 0x8000_0001, u32::MAX];
    for (index, &x) in extremes.iter().enumerate() {
        for &size in &sizes {
            for &width in &sizes {
                let style = Style {
                    width,
                    alignment: [
                        StrokeAlignment::Inside,
                        StrokeAlignment::Center,
                        StrokeAlignment::Outside,
                    ][index % 3],
                    stroke: true,
                    fill: true,
                };
                let corner = Point::new(x, extremes[(index + 2) % extremes.len()]);
                let angle = (x as f32).rad();
                for window in [
                    Rectangle::new(corner, Size::new(9, 5)),
                    Rectangle::new(Point::new(i32::MAX - 9, i32::MIN), Size::new(9, 5)),
                    Rectangle::new(Point::new(-3, -3), Size::new(7, 4)),
                ] {
                    by_us(window, &Arc::new(corner, size, angle, 1.0.deg()), &style);
                    by_us(window, &Sector::new(corner, size, angle, -350.0.deg()), &style);
                    let rectangle = Rectangle::new(corner, Size::new(size, size / 3));
                    for radius in [Size::new(size, 3), Size::new(5, size), Size::new(size / 2, size)] {
                        let mut corners = CornerRadii::new(radius);
                        by_us(window, &RoundedRectangle::new(rectangle, corners), &style);
                        corners.top_left = Size::new(1, 2);
                        by_us(window, &RoundedRectangle::new(rectangle, corners), &style);
                    }
                }
            }
        }
    }
}
