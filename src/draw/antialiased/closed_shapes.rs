//! Outlines of embedded-graphics' `Rectangle`, `RoundedRectangle`, `Circle` and `Ellipse` in a style.
//!
//! The curve is inscribed in the shape's box, whose sides lie half a pixel outside the centres of the outermost pixels. A
//! stroke lies between the curves in two boxes, as many whole pixels outside and inside as for pixels that are not
//! antialiased:
//!
//! ```text
//!   +-----------+   outer box: moved outwards by the stroke's outside part
//!   |+---------+|
//!   ||+-------+||   the fill reaches to the middle of the stroke, where the stroke has a colour
//!   |||       |||   inner box: moved inwards by the stroke's inside part
//! ```
//!
//! Radii of a rounded rectangle that do not fit are scaled down, in each box by a factor of its own, which may let the inner
//! curve leave the outer one. There, stroke and fill are what of them lies inside of the outer curve, as without antialiasing.

use embedded_graphics::{
    geometry::{Dimensions, Size},
    pixelcolor::PixelColor,
    primitives::{Circle, CornerRadii, Ellipse, Rectangle, RoundedRectangle, StrokeAlignment},
};

use crate::{
    coverage::Combination,
    draw::{
        FillRule, PrimitiveStyle, SubOutline,
        antialiased::{
            layers::{AlignedLayer, AlignedSink, Layer, LayerSink, OutlinedShape, edges_with_height},
            outline_arc::{Corner, OutlineArc, WidePosition},
            round_outline::{RoundContour, RoundOutline},
            turn::TURN,
        },
    },
    geometry::{InputError, Window, scale_floor},
};

/// 1/256 pixel, in a pixel and in half of one.
pub(crate) const PIXEL: i64 = 256;
pub(crate) const HALF: i64 = PIXEL / 2;

/// A box whose sides may lie anywhere, as its centre and half its size, in 1/256 pixel.
#[derive(Copy, Clone)]
pub(crate) struct OutlineBox {
    pub(crate) center: WidePosition,
    pub(crate) radii: [i64; 2],
}

impl OutlineBox {
    /// The box around the squares of a rectangle's pixels. A size of 0 has its middle half a pixel behind the position,
    /// as embedded-graphics has it.
    pub(crate) fn of(rectangle: &Rectangle) -> Self {
        let axis = |start: i32, length: u32| {
            let radius = i64::from(length) * HALF;
            let first = i64::from(start) * PIXEL + if length == 0 { HALF } else { -HALF };
            (first + radius, radius)
        };
        let (x, across) = axis(rectangle.top_left.x, rectangle.size.width);
        let (y, down) = axis(rectangle.top_left.y, rectangle.size.height);
        Self {
            center: [x, y],
            radii: [across, down],
        }
    }

    /// The box with each side moved outwards, or inwards where that is negative; `None` where nothing is left of it.
    pub(crate) fn outset(self, by: i64) -> Option<Self> {
        let radii = self.radii.map(|radius| radius + by);
        radii.iter().all(|&radius| radius > 0).then_some(Self { radii, ..self })
    }
}

/// How far the curves of a style lie outside of a shape's box, in 1/256 pixel; negative numbers are inside.
pub(crate) struct Reaches {
    /// The outer curve of the stroke.
    pub(crate) outer: i64,
    /// The inner curve of the stroke, which is that of a fill beside a stroke without a colour.
    pub(crate) inner: i64,
    /// The middle of the stroke.
    pub(crate) middle: i64,
}

impl Reaches {
    /// The curves of a shape at sub-pixel positions: a centred stroke has half of its width on either side.
    pub(crate) fn centred<C: PixelColor>(style: &PrimitiveStyle<C>) -> Self {
        let width = i64::from(style.stroke_width);
        match style.stroke_alignment {
            StrokeAlignment::Center => Self {
                outer: width * HALF,
                inner: -width * HALF,
                middle: 0,
            },
            _ => Self::of(style),
        }
    }

    /// The curves of a shape of whole pixels: a centred stroke of an odd width has its larger half inside, as
    /// embedded-graphics has it.
    pub(crate) fn of<C: PixelColor>(style: &PrimitiveStyle<C>) -> Self {
        let (inside, outside) = style.stroke_widths();
        let (inner, outer) = (-i64::from(inside) * PIXEL, i64::from(outside) * PIXEL);
        Self {
            outer,
            inner,
            middle: (inner + outer) >> 1,
        }
    }
}

/// Whether the window may show a pixel of a closed shape in a box, with its stroke.
pub(crate) fn may_meet(around: &Rectangle, window: &Window, stroke_width: u32) -> bool {
    // A box without rows still has a stroke; and half a pixel beyond its sides a sector has pixels, too.
    let reach = stroke_width.saturating_mul(3).saturating_add(2);
    window.may_meet_rows(around.top_left.y, around.size.height.max(1), reach)
}

/// Hands over the layers of a closed shape. `contour` is its curve in a box that is moved outwards by that many 1/256
/// pixels; `None` where nothing is left of it. `exact_fill` leaves nothing of the fill below the stroke.
pub(crate) fn layers<C: PixelColor>(
    style: &PrimitiveStyle<C>,
    reaches: &Reaches,
    exact_fill: bool,
    contour: &dyn Fn(i64) -> Result<Option<RoundContour>, InputError>,
    layer: &mut LayerSink<'_, C>,
) -> Result<(), InputError> {
    let stroke_color = style.effective_stroke_color();
    let inner = contour(reaches.inner)?;
    if let (Some(color), Some(mut filled)) = (style.fill_color, inner) {
        if stroke_color.is_some() && !exact_fill {
            filled = contour(reaches.middle)?.unwrap_or(filled);
        }
        layer(&Layer::new(&RoundOutline::new(filled), color))?;
    }
    if let Some(color) = stroke_color {
        if let Some(outer) = contour(reaches.outer)? {
            layer(&Layer::new(&RoundOutline::ring(outer, inner), color))?;
        }
    }
    Ok(())
}

impl OutlinedShape for Rectangle {
    fn layers<C: PixelColor>(&self, style: &PrimitiveStyle<C>, layer: &mut LayerSink<'_, C>) -> Result<(), InputError> {
        let around = OutlineBox::of(self);
        let contour = |reach: i64| around.outset(reach).map(|around| rectangle(&around)).transpose();
        layers(style, &Reaches::of(style), true, &contour, layer)
    }

    fn may_meet(&self, window: &Window, stroke_width: u32) -> bool {
        may_meet(&self.bounding_box(), window, stroke_width)
    }
}

impl OutlinedShape for Circle {
    const MAY_BE_MIRRORED: bool = true;

    fn layers<C: PixelColor>(&self, style: &PrimitiveStyle<C>, layer: &mut LayerSink<'_, C>) -> Result<(), InputError> {
        ellipse_layers(&self.bounding_box(), style, layer)
    }

    fn may_meet(&self, window: &Window, stroke_width: u32) -> bool {
        may_meet(&self.bounding_box(), window, stroke_width)
    }
}

impl OutlinedShape for Ellipse {
    const MAY_BE_MIRRORED: bool = true;

    fn layers<C: PixelColor>(&self, style: &PrimitiveStyle<C>, layer: &mut LayerSink<'_, C>) -> Result<(), InputError> {
        ellipse_layers(&self.bounding_box(), style, layer)
    }

    fn may_meet(&self, window: &Window, stroke_width: u32) -> bool {
        may_meet(&self.bounding_box(), window, stroke_width)
    }
}

fn ellipse_layers<C: PixelColor>(
    around: &Rectangle,
    style: &PrimitiveStyle<C>,
    layer: &mut LayerSink<'_, C>,
) -> Result<(), InputError> {
    let around = OutlineBox::of(around);
    let ellipse = |around: OutlineBox| RoundContour::ellipse(around.center, around.radii);
    let contour = |reach: i64| around.outset(reach).map(ellipse).transpose();
    layers(style, &Reaches::of(style), false, &contour, layer)
}

/// The curve of a rounded rectangle in its box, moved outwards by so many 1/256 pixels; `None` where nothing is left of it.
fn rounded_contour(shape: &RoundedRectangle, reach: i64) -> Result<Option<RoundContour>, InputError> {
    let rounded = |around: OutlineBox| rounded_rectangle(&around, &shape.corners, reach);
    OutlineBox::of(&shape.rectangle).outset(reach).map(rounded).transpose()
}

impl OutlinedShape for RoundedRectangle {
    const IS_CUT_OFF: bool = true;

    /// Whether the inner side of the stroke, or the fill below it, leaves the stroke's outer side. Cost: comparisons of radii and
    /// sides; where some do not fit, the contours are computed, and mostly none of their corners.
    fn is_cut_off<C: PixelColor>(&self, style: &PrimitiveStyle<C>) -> bool {
        let reaches = Reaches::of(style);
        if style.effective_stroke_color().is_none() || have_room(self, style.inside_stroke_width()) {
            return false;
        }
        // Where one of them leaves the domain, `layers` says so.
        let contour = |reach: i64| rounded_contour(self, reach).ok().flatten();
        let (Some(outer), Some(inner)) = (contour(reaches.outer), contour(reaches.inner)) else {
            return false;
        };
        let leaves = |contour: &RoundContour, reach: i64| !is_inside(contour, &outer, reaches.outer - reach);
        let middle = style.fill_color.and_then(|_| contour(reaches.middle));
        leaves(&inner, reaches.inner) || middle.is_some_and(|middle| leaves(&middle, reaches.middle))
    }

    fn layers<C: PixelColor>(&self, style: &PrimitiveStyle<C>, layer: &mut LayerSink<'_, C>) -> Result<(), InputError> {
        let contour = |reach: i64| rounded_contour(self, reach);
        layers(style, &Reaches::of(style), false, &contour, layer)
    }

    fn aligned_layers<C: PixelColor>(
        &self,
        style: &PrimitiveStyle<C>,
        layer: &mut AlignedSink<'_, C>,
    ) -> Result<(), InputError> {
        let reaches = Reaches::of(style);
        let contour = |reach: i64| rounded_contour(self, reach);
        let (Some(outer), Some(inner)) = (contour(reaches.outer)?, contour(reaches.inner)?) else {
            return Ok(());
        };
        let middle = contour(reaches.middle)?.unwrap_or(inner);
        let layers = [
            (style.fill_color, Combination::Both, middle),
            (style.effective_stroke_color(), Combination::ShapeAlone, inner),
        ];
        for (color, combination, inner) in layers {
            let Some(color) = color else { continue };
            let outline = TwoContours([outer, inner].map(RoundOutline::new));
            let [outer, _] = &outline.0;
            layer(&AlignedLayer {
                outline: &outline,
                edges_of_shape: edges_with_height(|edge| outer.edges(edge)),
                fill_rule: FillRule::NonZero,
                combination,
                color,
            })?;
        }
        Ok(())
    }

    fn may_meet(&self, window: &Window, stroke_width: u32) -> bool {
        may_meet(&self.bounding_box(), window, stroke_width)
    }
}

/// A contour and, in the place of a stroke, another one.
struct TwoContours([RoundOutline; 2]);

impl SubOutline for TwoContours {
    fn edges(&self, edge: &mut dyn FnMut(Corner, Corner)) {
        for contour in &self.0 {
            contour.edges(edge);
        }
    }
}

/// Whether the radii of a rounded rectangle fit in its box, and those of the inner side of its stroke in theirs: none of them
/// are scaled down.
fn have_room(shape: &RoundedRectangle, inside: u32) -> bool {
    let Size { width, height } = shape.rectangle.size;
    let CornerRadii {
        top_left,
        top_right,
        bottom_right,
        bottom_left,
    } = shape.corners;
    let sides = [
        (top_left.width, top_right.width, width),
        (bottom_left.width, bottom_right.width, width),
        (top_left.height, bottom_left.height, height),
        (top_right.height, bottom_right.height, height),
    ];
    let inside = u64::from(inside);
    let fits = |(one, other, side): (u32, u32, u32), by: u64| {
        let [one, other] = [one, other].map(|radius| u64::from(radius).saturating_sub(by));
        one + other <= u64::from(side).saturating_sub(2 * by)
    };
    sides.into_iter().all(|side| fits(side, 0) && fits(side, inside))
}

/// Whether the contour of a rounded rectangle lies in another one whose box is larger by a distance on each side.
///
/// Radii that are smaller by that distance, or larger than that, have all of their arc inside. Else no corner of the contour
/// may be cut off by the other one, which is convex.
fn is_inside(inner: &RoundContour, outer: &RoundContour, distance: i64) -> bool {
    // Scaled radii are rounded down by less than 1/256 pixel.
    let reaches = |(inner, outer): (u32, u32)| i64::from(inner) + 1 + distance >= i64::from(outer);
    let mut arcs = inner.arcs().iter().zip(outer.arcs());
    let are_nested = arcs.all(|(inner, outer)| inner.radii.into_iter().zip(outer.radii).all(reaches));
    are_nested || {
        let mut corners = (0..inner.corners()).map(|index| inner.corner(index));
        let is_cut_off = |corner: Corner| {
            outer
                .arcs()
                .iter()
                .zip(OUTWARDS)
                .any(|(arc, to)| cuts_off(arc, to, corner))
        };
        !corners.any(is_cut_off)
    }
}

/// Whether a corner lies outside of a quarter of an ellipse, on the side of that from its centre, or less than 1/64 pixel inside,
/// where the chords are.
fn cuts_off(arc: &OutlineArc, [to_right, downwards]: [i64; 2], [x, y]: Corner) -> bool {
    const TOLERANCE: u32 = 4;
    let [center_x, center_y] = arc.center.map(i64::from);
    let (right, below) = (
        to_right * (i64::from(x) - center_x),
        downwards * (i64::from(y) - center_y),
    );
    if right <= 0 || below <= 0 {
        return false;
    }
    let squares = [right, below].map(|distance| i128::from(distance).pow(2));
    let [across, down] = arc
        .radii
        .map(|radius| i128::from(radius.saturating_sub(TOLERANCE)).pow(2));
    squares[0] * down + squares[1] * across > across * down
}

/// Right and down from the centre to the arc of each corner of a rounded rectangle, in the order of its contour.
const OUTWARDS: [[i64; 2]; 4] = [[1, -1], [1, 1], [-1, 1], [-1, -1]];

/// The contour along the sides of a box.
fn rectangle(around: &OutlineBox) -> Result<RoundContour, InputError> {
    let ([x, y], [across, down]) = (around.center, around.radii);
    let corner = |right: i64, below: i64| OutlineArc::point([x + right, y + below]);
    Ok(RoundContour::new(&[
        corner(-across, -down)?,
        corner(across, -down)?,
        corner(across, down)?,
        corner(-across, down)?,
    ]))
}

/// The contour along the sides of a box whose corners are quarter ellipses. Their radii are those of a box that is
/// `reach` smaller; where two of them exceed a side, all are scaled down by the same factor, the one that makes the
/// tightest side fit (CSS Backgrounds and Borders, W3C).
fn rounded_rectangle(around: &OutlineBox, corners: &CornerRadii, reach: i64) -> Result<RoundContour, InputError> {
    const QUARTER: i32 = TURN / 4;
    let length = |length: u32| (i64::from(length) * PIXEL + reach).max(0);
    let radius = |size: Size| [length(size.width), length(size.height)];
    let clockwise = [
        corners.top_left,
        corners.top_right,
        corners.bottom_right,
        corners.bottom_left,
    ];
    let radii = clockwise.map(radius);
    let ([x, y], [across, down]) = (around.center, around.radii);
    let [top_left, top_right, bottom_right, bottom_left] = radii;
    let sides = [
        (top_left[0] + top_right[0], 2 * across),
        (bottom_left[0] + bottom_right[0], 2 * across),
        (top_left[1] + bottom_left[1], 2 * down),
        (top_right[1] + bottom_right[1], 2 * down),
    ];
    // The factor is a side through a sum of radii, which lie below 2^41 each.
    let (mut part, mut whole) = (1i64, 1i64);
    for (sum, side) in sides {
        if sum > side && i128::from(side) * i128::from(whole) < i128::from(part) * i128::from(sum) {
            (part, whole) = (side, sum);
        }
    }
    let fitting = |length: i64| {
        core::num::NonZeroU64::new(whole as u64).map_or(length, |whole| scale_floor(length, part as u64, whole))
    };
    let arc = |radii: [i64; 2], [right, below]: [i64; 2], quarter: i32| {
        let radii = radii.map(fitting);
        let center = [x + right * (across - radii[0]), y + below * (down - radii[1])];
        let is_round = radii.iter().all(|&radius| radius > 0);
        if is_round {
            OutlineArc::new(center, radii, (quarter * QUARTER, QUARTER))
        } else {
            OutlineArc::point([x + right * across, y + below * down])
        }
    };
    // From the top on, so that the contour has two chains in y.
    Ok(RoundContour::new(&[
        arc(top_right, OUTWARDS[0], 3)?,
        arc(bottom_right, OUTWARDS[1], 0)?,
        arc(bottom_left, OUTWARDS[2], 1)?,
        arc(top_left, OUTWARDS[3], 2)?,
    ]))
}

#[cfg(test)]
mod tests {
    use embedded_graphics::{
        geometry::Point,
        pixelcolor::{Gray4, GrayColor},
        primitives::{PrimitiveStyleBuilder, StrokeAlignment},
    };

    use super::*;
    use crate::draw::pictures::antialiased;

    const FILL: PrimitiveStyle<Gray4> = PrimitiveStyle::with_fill(Gray4::WHITE);

    fn stroke(width: u32, alignment: StrokeAlignment) -> PrimitiveStyle<Gray4> {
        PrimitiveStyleBuilder::new()
            .stroke_color(Gray4::WHITE)
            .stroke_width(width)
            .stroke_alignment(alignment)
            .build()
            .into()
    }

    #[test]
    fn a_disc_of_9_pixels_touches_the_sides_of_its_box() {
        let disc = Circle::new(Point::new(1, 0), 9);
        antialiased(&disc, FILL).assert_pattern(&[
            "  18DFD81 ",
            " 1CFFFFFC1",
            " 8FFFFFFF8",
            " DFFFFFFFD",
            " FFFFFFFFF",
            " DFFFFFFFD",
            " 8FFFFFFF8",
            " 1CFFFFFC1",
            "  18DFD81 ",
        ]);
    }

    #[test]
    fn a_ring_2_pixels_wide() {
        let circle = Circle::new(Point::new(0, 0), 11);
        antialiased(&circle, stroke(2, StrokeAlignment::Inside)).assert_pattern(&[
            "  29DFD92  ",
            " 4EFFFFFE4 ",
            "2EFA3 3AFE2",
            "9FA     AF9",
            "DF3     3FD",
            "FF       FF",
            "DF3     3FD",
            "9FA     AF9",
            "2EFA3 3AFE2",
            " 4EFFFFFE4 ",
            "  29DFD92  ",
        ]);
    }

    #[test]
    fn a_frame_has_the_pixels_of_one_that_is_not_antialiased() {
        let frame = Rectangle::new(Point::new(2, 1), Size::new(7, 5));
        antialiased(&frame, stroke(3, StrokeAlignment::Center)).assert_pattern(&[
            " FFFFFFFFF",
            " FFFFFFFFF",
            " FFFFFFFFF",
            " FFF   FFF",
            " FFFFFFFFF",
            " FFFFFFFFF",
            " FFFFFFFFF",
        ]);
    }

    #[test]
    fn four_different_corners_cut_by_the_left_edge() {
        let rectangle = Rectangle::new(Point::new(-2, 0), Size::new(14, 9));
        let corners = CornerRadii {
            top_left: Size::new(3, 3),
            top_right: Size::new(6, 4),
            bottom_right: Size::new(2, 2),
            bottom_left: Size::zero(),
        };
        antialiased(&RoundedRectangle::new(rectangle, corners), FILL).assert_pattern(&[
            "EFFFFFFD93  ",
            "FFFFFFFFFF9 ",
            "FFFFFFFFFFF8",
            "FFFFFFFFFFFE",
            "FFFFFFFFFFFF",
            "FFFFFFFFFFFF",
            "FFFFFFFFFFFF",
            "FFFFFFFFFFFE",
            "FFFFFFFFFFE5",
        ]);
    }

    /// The stroke is drawn over the fill, which reaches below it: no background shows between the two colours.
    #[test]
    fn a_grey_ellipse_in_a_white_stroke() {
        let style = PrimitiveStyle {
            fill_color: Some(Gray4::new(8)),
            ..stroke(2, StrokeAlignment::Outside)
        };
        antialiased(&Ellipse::new(Point::new(2, 2), Size::new(12, 7)), style).assert_pattern(&[
            "   17BDFFDB71   ",
            "  7EFFFFFFFFE7  ",
            " AFFDA9889ADFFA ",
            "6FEA88888888AEF6",
            "DFA8888888888AFD",
            "FF888888888888FF",
            "DFA8888888888AFD",
            "6FEA88888888AEF6",
            " AFFDA9889ADFFA ",
            "  7EFFFFFFFFE7  ",
            "   17BDFFDB71   ",
        ]);
    }
}
