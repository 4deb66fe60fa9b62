//! Arcs, sectors and rounded rectangles against embedded-graphics, and beyond its number range against themselves moved.

use embedded_graphics::{
    mock_display::MockDisplay,
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{
        self, Arc, CornerRadii, OffsetOutline, PrimitiveStyleBuilder, Rectangle, RoundedRectangle, Sector, Styled,
        StyledDrawable,
    },
};
use micromath::F32Ext;
use proptest::{prelude::*, test_runner::Config};
use zrow::draw::{DrawOn, PrimitiveStyle, StrokeAlignment};

use crate::common::{cases, config, picture};
use crate::reference::directions::{NO_DIRECTION, middle_2x, normal};

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
        let mut style: PrimitiveStyle<_> = PrimitiveStyleBuilder::new()
            .stroke_width(self.width)
            .stroke_alignment(self.alignment)
            .build()
            .into();
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

fn by_us<S>(window: Rectangle, shape: &S, style: &Style) -> Vec<Rgb565>
where
    for<'s> Styled<&'s S, PrimitiveStyle<Rgb565>>: DrawOn<Color = Rgb565>,
{
    picture(window, |band| {
        let Ok(()) = Styled::new(shape, style.ours()).draw_on(band);
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

/// The window of the same picture where shape and window are moved by as much.
fn moved(window: Rectangle, by: Point) -> Rectangle {
    Rectangle::new(window.top_left + by, window.size)
}

proptest! {
    #![proptest_config(Config { max_global_rejects: 60_000, ..config(cases(200, 1_500)) })]

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

/// Any angle that a number can be: small and ordinary ones, those near 2^22 turns, from which on there is no direction, and
/// what is no angle.
fn any_radians() -> impl Strategy<Value = f32> {
    let edge = NO_DIRECTION.to_bits();
    prop_oneof![
        2 => any::<u32>().prop_map(f32::from_bits),
        2 => degrees().prop_map(|degrees| degrees.deg().to_radians()),
        1 => (edge - 3..edge + 3, any::<bool>()).prop_map(|(bits, negative)| {
            if negative { -f32::from_bits(bits) } else { f32::from_bits(bits) }
        }),
        1 => prop::sample::select(vec![
            0.0, -0.0, f32::MIN_POSITIVE, -1e-40, 1e7, 1e9, 1.4e10, -1.4e10, 1e20, -1e20, f32::MAX, f32::MIN,
            f32::INFINITY, f32::NEG_INFINITY, f32::NAN,
        ]),
    ]
}

/// embedded-graphics' rule for the pixels of an arc or a sector, pixel by pixel in exact arithmetic.
struct AngleRule {
    start: Angle,
    sweep: Angle,
    /// Doubled.
    center: (i128, i128),
}

impl AngleRule {
    fn new(corner: Point, diameter: u32, start: Angle, sweep: Angle) -> Self {
        let center = (middle_2x(corner.x, diameter), middle_2x(corner.y, diameter));
        Self { start, sweep, center }
    }

    /// How far to the right of a direction from the centre a pixel lies.
    fn distance(&self, angle: Angle, pixel: Point) -> i128 {
        let (x, y) = normal(angle);
        x * (2 * i128::from(pixel.x) - self.center.0) + y * (2 * i128::from(pixel.y) - self.center.1)
    }

    /// Whether a pixel is between both angles, with each side moved outwards by so much.
    fn contains(&self, pixel: Point, outwards: i128) -> bool {
        let end = self.start + self.sweep;
        let (first, last) = if self.sweep < Angle::zero() {
            (end, self.start)
        } else {
            (self.start, end)
        };
        let right = self.distance(first, pixel) >= -outwards;
        let left = self.distance(last, pixel) <= outwards;
        if self.sweep.abs() >= 360.0.deg() {
            true
        } else if self.sweep.abs() >= 180.0.deg() {
            right || left
        } else {
            right && left
        }
    }

    /// The colour of a pixel of a sector that has this one in the whole disc.
    fn in_sector(&self, pixel: Point, style: &Style, in_disc: Rgb565) -> Rgb565 {
        let (outside, inside) = match style.alignment {
            StrokeAlignment::Inside => (0, style.width),
            StrokeAlignment::Center => (style.width / 2, style.width.div_ceil(2)),
            StrokeAlignment::Outside => (style.width, 0),
        };
        let (outside, inside) = (i128::from(outside), i128::from(inside));
        if !self.contains(pixel, outside * 2048 + 1024) {
            return Rgb565::BLACK;
        }
        let mut is_fill = self.contains(pixel, 1024 - inside * 2048);
        let sweep = self.sweep.abs();
        let half = self.start + Angle::from_radians(self.sweep.to_radians() / 2.0);
        let beyond = outside * 4096;
        if !is_fill && sweep < 55.0.deg() && self.distance(half - 90.0.deg(), pixel) <= -beyond {
            return Rgb565::BLACK;
        }
        let is_inward = sweep > 305.0.deg() && sweep < 360.0.deg();
        is_fill |= is_inward && self.distance(half + 90.0.deg(), pixel) <= -beyond;
        match in_disc {
            FILL if !is_fill && style.stroke => STROKE,
            FILL if !is_fill => Rgb565::BLACK,
            color => color,
        }
    }
}

proptest! {
    #![proptest_config(Config { max_global_rejects: 60_000, ..config(cases(750, 6_000)) })]

    /// No angle panics, and each has the pixels of its definition, wherever the shape lies.
    #[test]
    fn angles_of_any_size(
        x in -40..50i32,
        y in -40..50i32,
        diameter in 0..70u32,
        start in any_radians(),
        sweep in any_radians(),
        style in styles(),
        far in prop::sample::select(vec![Point::new(0, 0), Point::new(i32::MAX - 200, i32::MIN + 100)]),
    ) {
        let (start, sweep, turn) = (start.rad(), sweep.rad(), 360.0.deg());
        let window = moved(WINDOW, far);
        let corner = Point::new(x, y) + far;
        let rule = AngleRule::new(corner, diameter, start, sweep);

        let whole = by_us(window, &Arc::new(corner, diameter, start, turn), &style);
        let expected: Vec<Rgb565> = window
            .points()
            .zip(whole)
            .map(|(point, color)| if rule.contains(point, 0) { color } else { Rgb565::BLACK })
            .collect();
        prop_assert_eq!(by_us(window, &Arc::new(corner, diameter, start, sweep), &style), expected, "an arc");

        // Of a fill without a colour, the whole disc says where the stroke may be.
        let disc_style = Style { fill: true, ..style };
        let whole = by_us(window, &Sector::new(corner, diameter, start, turn), &disc_style);
        let expected: Vec<Rgb565> = window
            .points()
            .zip(whole)
            .map(|(point, color)| rule.in_sector(point, &style, color))
            .map(|color| if color == FILL && !style.fill { Rgb565::BLACK } else { color })
            .collect();
        prop_assert_eq!(by_us(window, &Sector::new(corner, diameter, start, sweep), &style), expected, "a sector");
    }

    /// Numbers of any size that are angles like any other: next to nothing, and up to some turns.
    #[test]
    fn small_angles_are_those_of_embedded_graphics(
        diameter in 0..60u32,
        start in any_small_radians(),
        sweep in any_small_radians(),
        style in styles(),
    ) {
        let (start, sweep) = (start.rad(), sweep.rad());
        let half = start + Angle::from_radians(sweep.to_radians() / 2.0);
        let angles = [start, start + sweep, half - 90.0.deg(), half + 90.0.deg()];
        prop_assume!(has_same_normals(&angles));
        let corner = Point::new(-3, 1);
        let arc = Arc::new(corner, diameter, start, sweep);
        prop_assert_eq!(by_us(WINDOW, &arc, &style), by_embedded_graphics(&arc, &style));
        let sector = Sector::new(corner, diameter, start, sweep);
        prop_assert_eq!(by_us(WINDOW, &sector, &style), by_embedded_graphics(&sector, &style));
    }
}

/// Subnormal numbers and all others below 1,000.
fn any_small_radians() -> impl Strategy<Value = f32> {
    let bits = prop_oneof![
        0..0x80_0000u32,
        0..1_000f32.to_bits(),
        1e-3f32.to_bits()..1_000f32.to_bits()
    ];
    (bits, any::<bool>()).prop_map(|(bits, negative)| f32::from_bits(bits | u32::from(negative) << 31))
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
    #![proptest_config(Config { max_global_rejects: 60_000, ..config(cases(500, 4_000)) })]

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
                    assert!(outer.into_styled(PrimitiveStyle::with_fill(color)).draw_on(band).is_ok());
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
    #![proptest_config(config(cases(100, 1_000)))]

    /// Corners of displays, and beyond 32-bit numbers; the upper right one may reach beyond the middle row.
    #[test]
    fn unequal_corners_are_quarters_of_ellipses(
        log_size in 5..13u32,
        radii in prop::array::uniform8(0.1..1.0f32),
        position in (0.0..1.0f32, 0.0..1.0f32),
    ) {
        let length = 1u32 << log_size;
        let (width, height) = (2 * length, 3 * length);
        let part = |length: u32, fraction: f32| (length as f32 * fraction) as u32;
        let radius = |index: usize, most: u32| Size::new(part(length, radii[index]), part(most, radii[index + 1]));
        let corners = CornerRadii {
            top_left: radius(0, length),
            top_right: radius(2, 2 * length),
            bottom_right: radius(4, length),
            bottom_left: radius(6, length),
        };
        let shape = RoundedRectangle::new(Rectangle::new(Point::zero(), Size::new(width, height)), corners);
        let window_at = Point::new(part(width, position.0) as i32 - 20, part(height, position.1) as i32 - 20);
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

/// An angle that is too large for a direction, infinite or not a number: each pixel is on that side, so a whole ring shows.
#[test]
fn angles_without_a_direction_have_no_sides() {
    let style = Style {
        width: 3,
        alignment: StrokeAlignment::Inside,
        stroke: true,
        fill: false,
    };
    let corner = Point::new(2, 1);
    let ring = by_us(WINDOW, &Arc::new(corner, 41, 0.0.deg(), 360.0.deg()), &style);
    for angle in [1e8, 2e10, 1e20, f32::MAX, f32::INFINITY, f32::NAN] {
        for angle in [angle, -angle] {
            assert_eq!(
                by_us(WINDOW, &Arc::new(corner, 41, angle.rad(), 1.0.deg()), &style),
                ring,
                "{angle}"
            );
            by_us(WINDOW, &Arc::new(corner, 41, 1.0.deg(), angle.rad()), &style);
            by_us(WINDOW, &Sector::new(corner, 41, angle.rad(), 1.0.deg()), &style);
            by_us(WINDOW, &Sector::new(corner, 41, 1.0.deg(), angle.rad()), &style);
        }
    }
}
