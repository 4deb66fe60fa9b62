//! Numbers over their whole type, dense where they are likely to go wrong, and styles made of them.

use embedded_graphics::{
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{CornerRadii, PrimitiveStyleBuilder, Rectangle},
};
use proptest::prelude::*;
use zrow::draw::{PrimitiveStyle, StrokeAlignment};

pub const STROKE: Rgb565 = Rgb565::RED;
pub const FILL: Rgb565 = Rgb565::GREEN;

pub const ALIGNMENTS: [StrokeAlignment; 3] = [
    StrokeAlignment::Inside,
    StrokeAlignment::Center,
    StrokeAlignment::Outside,
];

pub fn style((stroke, fill): (bool, bool), width: u32, alignment: StrokeAlignment) -> PrimitiveStyle<Rgb565> {
    let mut style: PrimitiveStyle<_> = PrimitiveStyleBuilder::new()
        .stroke_width(width)
        .stroke_alignment(alignment)
        .build()
        .into();
    style.stroke_color = stroke.then_some(STROKE);
    style.fill_color = fill.then_some(FILL);
    style
}

/// A stroke, a stroke and a fill, a fill that leaves room for the stroke.
pub const COLORS: [(bool, bool); 3] = [(true, false), (true, true), (false, true)];

/// Styles that paint something, unless the stroke has no width.
pub fn any_style(width: impl Strategy<Value = u32>) -> impl Strategy<Value = PrimitiveStyle<Rgb565>> {
    let (colors, alignments) = (COLORS.to_vec(), ALIGNMENTS.to_vec());
    (prop::sample::select(colors), width, prop::sample::select(alignments))
        .prop_map(|(colors, width, alignment)| style(colors, width, alignment))
}

pub fn any_corners(length: impl Strategy<Value = u32> + Clone) -> impl Strategy<Value = CornerRadii> {
    let radius = || (length.clone(), length.clone()).prop_map(|(width, height)| Size::new(width, height));
    let equal = radius().prop_map(CornerRadii::new);
    let mixed = (radius(), radius(), radius(), radius()).prop_map(|(a, b, c, d)| CornerRadii {
        top_left: a,
        top_right: b,
        bottom_right: c,
        bottom_left: d,
    });
    prop_oneof![1 => equal, 2 => mixed]
}

/// Lengths over their whole type: near zero, near those that 11, 16, 31 and 32 bits end at, and any.
pub fn any_length() -> impl Strategy<Value = u32> + Clone {
    let near = |end: u32| {
        let offset = -30..=30i64;
        offset.prop_map(move |by| (i64::from(end) + by).clamp(0, i64::from(u32::MAX)) as u32)
    };
    prop_oneof![
        3 => 0..64u32,
        1 => 0..1500u32,
        1 => near(1 << 11),
        1 => near(1 << 16),
        2 => near(1 << 31),
        2 => near(u32::MAX),
        1 => any::<u32>(),
    ]
    .boxed()
}

/// Coordinates over their whole type: near zero, near both ends, and any.
pub fn any_coordinate() -> impl Strategy<Value = i32> {
    prop_oneof![
        3 => -60..60i32,
        1 => i32::MIN..i32::MIN + 60,
        1 => i32::MAX - 60..=i32::MAX,
        1 => any::<i32>(),
    ]
}

/// A window somewhere, and which point of a shape's border it shows.
#[derive(Debug, Copy, Clone)]
pub struct View {
    /// Where the point is to be, unless no shape can begin so far away.
    point: [i32; 2],
    /// From the window's corner to the point.
    offset: [u8; 2],
    /// On the right half of the shape, on the lower one.
    is_far: [bool; 2],
    /// Along the quarter of an ellipse, in radians.
    angle: f64,
    /// 0: the ellipse is that of the shape's corner; 1: it fills the shape.
    scale: f64,
}

pub fn any_view() -> impl Strategy<Value = View> {
    let point = [any_coordinate(), any_coordinate()];
    let offset = prop::array::uniform2(0..36u8);
    let scale = prop::sample::select(vec![0.0, 0.0, 0.3, 1.0]);
    (point, offset, any::<[bool; 2]>(), 0.0..1.6f64, scale).prop_map(|(point, offset, is_far, angle, scale)| View {
        point,
        offset,
        is_far,
        angle,
        scale,
    })
}

impl View {
    /// Columns and rows of the window.
    pub const SIZE: Size = Size::new(43, 37);

    /// The window, and where a shape begins whose border it shows; the shape's corners have a radius, and its stroke reaches
    /// so far out.
    pub fn position(&self, size: Size, radius: Size, outside: u32) -> (Rectangle, Point) {
        let (left, x) = self.position_on_axis(0, size.width, radius.width, outside, self.angle.cos());
        let (top, y) = self.position_on_axis(1, size.height, radius.height, outside, self.angle.sin());
        (Rectangle::new(Point::new(left, top), Self::SIZE), Point::new(x, y))
    }

    fn position_on_axis(&self, axis: usize, length: u32, radius: u32, outside: u32, part: f64) -> (i32, i32) {
        let outside = f64::from(outside.min((u32::MAX - length) / 2));
        let half = f64::from(length) / 2.0 + outside;
        let radius = (f64::from(radius) + outside).min(half);
        let inset = (radius + (half - radius) * self.scale) * (1.0 - part);
        let from_start = if self.is_far[axis] {
            2.0 * half - 1.0 - inset
        } else {
            inset
        };
        let start = (f64::from(self.point[axis]) - from_start + outside) as i32;
        let window = f64::from(start) - outside + from_start - f64::from(self.offset[axis]);
        // No window has the last coordinate.
        ((window as i32).min(i32::MAX - 48), start)
    }

    /// The radius of the corner on whose side the point is.
    pub fn radius_of(&self, corners: &CornerRadii) -> Size {
        match self.is_far {
            [false, false] => corners.top_left,
            [true, false] => corners.top_right,
            [true, true] => corners.bottom_right,
            [false, true] => corners.bottom_left,
        }
    }
}
