//! Outlines of embedded-graphics' `Triangle` in a style.
//!
//! The triangle has its vertices at the centres of pixels and reaches half a pixel beyond the lines between them, as its
//! pixels do: it is the triangle whose sides are moved outwards by half a pixel. A stroke moves the sides further
//! outwards and inwards; outer corners are miter joins, or bevels where the tip is further away than four times that
//! distance, and inner corners are sharp.

use embedded_graphics::{
    geometry::Point,
    pixelcolor::PixelColor,
    primitives::{StrokeAlignment, Triangle},
};
use heapless::Vec;

use crate::{
    draw::{
        PrimitiveStyle, SubOutline,
        antialiased::{
            layers::{Layer, LayerSink, OutlinedShape},
            strokes::{StrokeForm, stroke_layer},
            sub_outline::{self, Corner},
        },
        style::stroke,
    },
    geometry::{InputError, Sub8, SubPixel, Window},
    scan::stroke::{
        line_join::sharp_tip,
        wide_stroke::{Direction, Position, UNIT, cross, miter_tip, negated},
    },
};

/// Widths of strokes beyond this one count as this one, in pixels.
const MOST_WIDTH: u32 = 4_096;

/// A contour, in 1/256 pixel: a corner for each vertex, or two where it is cut off.
type Contour = Vec<Corner, 6>;

/// The outline of a filled triangle, or of its stroke: the area between an outer contour and an inner one.
struct TriangleOutline {
    outer: Contour,
    /// The hole, in the opposite direction; without corners where there is none.
    inner: Contour,
}

impl SubOutline for TriangleOutline {
    fn edges(&self, edge: &mut dyn FnMut(Corner, Corner)) {
        sub_outline::close(self.outer.iter().copied(), edge);
        sub_outline::close(self.inner.iter().rev().copied(), edge);
    }

    fn is_simple(&self) -> bool {
        true
    }
}

/// The distances between the sides of the two contours that a style gives a triangle and the lines between its vertices, in
/// 1/65,536 pixel; negative inside of the triangle.
struct Sides {
    outer: i64,
    inner: i64,
}

impl Sides {
    fn of<C: PixelColor>(style: &PrimitiveStyle<C>) -> Self {
        let half = UNIT / 2;
        let width = i64::from(style.stroke_width.min(MOST_WIDTH)) * UNIT;
        let (outer, inner) = match style.stroke_alignment {
            _ if width == 0 => (half, half),
            StrokeAlignment::Center => (width / 2, -width / 2),
            StrokeAlignment::Inside => (half, half - width),
            StrokeAlignment::Outside => (half + width, half),
        };
        Self { outer, inner }
    }
}

impl OutlinedShape for Triangle {
    fn layers<C: PixelColor>(&self, style: &PrimitiveStyle<C>, layer: &mut LayerSink<'_, C>) -> Result<(), InputError> {
        let is_inside = |pixel: Point| {
            let farthest = Sub8::MAX_UNITS >> Sub8::FRACTION_BITS;
            pixel.x.unsigned_abs().max(pixel.y.unsigned_abs()) <= farthest as u32
        };
        if !self.vertices.into_iter().all(is_inside) {
            return Err(InputError::out_of_domain::<Sub8>());
        }
        let Some(sides) = TriangleSides::new(self) else {
            return line_layer(self, style, layer);
        };
        let Sides { outer, inner } = Sides::of(style);
        let stroke_color = style.effective_stroke_color();
        let hole = sides.contour(inner);
        if let (Some(color), Some(mut filled)) = (style.fill_color, hole.clone()) {
            if stroke_color.is_some() {
                filled = sides.contour((outer + inner) / 2).unwrap_or(filled);
            }
            let outline = TriangleOutline {
                outer: filled,
                inner: Contour::new(),
            };
            layer(&Layer::new(&outline, color))?;
        }
        let stroke = stroke_color.map(|color| (color, sides.contour(outer)));
        if let Some((color, Some(outer))) = stroke {
            let outline = TriangleOutline {
                outer,
                inner: hole.unwrap_or_default(),
            };
            layer(&Layer::new(&outline, color))?;
        }
        Ok(())
    }

    fn may_meet(&self, window: &Window, stroke_width: u32) -> bool {
        let [one, two, three] = self.vertices.map(|vertex| vertex.y);
        let (top, bottom) = (one.min(two).min(three), one.max(two).max(three));
        // The tip of a miter join is four times as far away as half of the stroke's width.
        let reach = stroke_width.saturating_mul(4).saturating_add(4);
        window.may_meet_rows(top, top.abs_diff(bottom), reach)
    }
}

/// Hands over a triangle without an area: the line between its outermost vertices, in the colour and the width that all
/// of its pixels have.
fn line_layer<C: PixelColor>(
    triangle: &Triangle,
    style: &PrimitiveStyle<C>,
    layer: &mut LayerSink<'_, C>,
) -> Result<(), InputError> {
    let width = u64::from(style.stroke_width);
    let (width_in_halves, color) = match style.stroke_alignment {
        _ if width == 0 => (2, style.fill_color),
        StrokeAlignment::Center => (2 * width, style.stroke_color),
        StrokeAlignment::Inside => (2, style.stroke_color),
        StrokeAlignment::Outside => (4 * width + 2, style.stroke_color),
    };
    stroke_layer(triangle, StrokeForm::solid(width_in_halves), color, layer)
}

/// The sides of a triangle with an area, clockwise on the screen.
struct TriangleSides {
    vertices: [Position; 3],
    /// Twice the area, in 1/65,536 pixel squared.
    doubled_area: i64,
}

impl TriangleSides {
    /// `None` where the triangle has no area. The vertices are in the domain of [`Sub8`].
    fn new(triangle: &Triangle) -> Option<Self> {
        let [a, mut b, mut c] = triangle.vertices.map(|vertex| stroke::position(vertex, Point::zero()));
        // Components are below 2^31, so that this fits.
        let doubled_area = cross(between(a, b), between(a, c));
        if doubled_area == 0 {
            return None;
        }
        if doubled_area < 0 {
            (b, c) = (c, b);
        }
        Some(Self {
            vertices: [a, b, c],
            doubled_area: doubled_area.abs(),
        })
    }

    /// The length of all sides, in 1/65,536 pixel.
    fn perimeter(&self) -> i64 {
        let [a, b, c] = self.vertices;
        let length = |(x, y): Position| ((x * x + y * y) as u64).isqrt() as i64;
        length(between(a, b)) + length(between(b, c)) + length(between(c, a))
    }

    /// The contour whose sides lie that far beyond the triangle's, or inside where that is negative; `None` where
    /// nothing is left of it.
    fn contour(&self, beyond: i64) -> Option<Contour> {
        // The triangle's largest circle has the radius doubled area / perimeter. Below 2^30 times 2^33.
        if beyond < 0 && beyond.abs().checked_mul(self.perimeter())? >= self.doubled_area {
            return None;
        }
        let [a, b, c] = self.vertices;
        let [ab, bc, ca] = [(a, b), (b, c), (c, a)].map(|(from, to)| Side::new(from, to, beyond.abs()));
        let mut contour = Contour::new();
        for (before, vertex, after) in [(&ca, a, &ab), (&ab, b, &bc), (&bc, c, &ca)] {
            for (right, down) in corner(before, after, beyond).into_iter().flatten() {
                let units = |position: i64, offset: i64| {
                    let units = sub_outline::rounded(position + offset);
                    units.clamp(i32::MIN.into(), i32::MAX.into()) as i32
                };
                let pushed = contour.push([units(vertex.0, right), units(vertex.1, down)]);
                debug_assert!(pushed.is_ok(), "at most two corners for each of three vertices");
            }
        }
        Some(contour)
    }
}

/// The vector from one position to another.
fn between(from: Position, to: Position) -> Position {
    (to.0 - from.0, to.1 - from.1)
}

/// A side of a triangle, clockwise on the screen.
struct Side {
    /// The direction from one vertex to the next one.
    along: Direction,
    /// The vector that moves the side outwards, at right angles to it.
    outwards: Position,
}

impl Side {
    /// The side between two vertices, and the vector that moves it outwards by `distance`.
    fn new(from: Position, to: Position, distance: i64) -> Self {
        let along = Direction::of(between(from, to));
        Self {
            // Clockwise, normals point inwards.
            outwards: negated(along.normal(distance)),
            along,
        }
    }
}

/// The corner, or both corners, between two sides that are moved outwards by `beyond`, relative to their vertex.
fn corner(before: &Side, after: &Side, beyond: i64) -> [Option<Position>; 2] {
    let distance = beyond.abs();
    if distance == 0 {
        return [Some((0, 0)), None];
    }
    let (one, other) = (after.outwards, before.outwards);
    let tip = miter_tip(one, other, distance);
    if beyond < 0 {
        let tip = tip
            .or_else(|| sharp_tip(before.along, after.along, distance))
            .unwrap_or(one);
        return [Some(negated(tip)), None];
    }
    match tip {
        Some(tip) => [Some(tip), None],
        None => [Some(other), Some(one)],
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::pixelcolor::{Gray4, GrayColor};

    use super::*;
    use crate::draw::pictures::{antialiased, grey_in_white};

    /// Sides along rows and columns are those of pixels.
    #[test]
    fn a_triangle_reaches_half_a_pixel_beyond_its_vertices() {
        let triangle = Triangle::new(Point::new(1, 1), Point::new(13, 7), Point::new(1, 7));
        antialiased(&triangle, PrimitiveStyle::with_fill(Gray4::WHITE)).assert_pattern(&[
            " 1            ",
            " E81          ",
            " FFE81        ",
            " FFFFE81      ",
            " FFFFFFE81    ",
            " FFFFFFFFE81  ",
            " FFFFFFFFFFE81",
            " FFFFFFFFFFFF9",
        ]);
    }

    #[test]
    fn a_stroke_inside_leaves_a_hole() {
        let triangle = Triangle::new(Point::new(0, 13), Point::new(15, 13), Point::new(6, 0));
        antialiased(&triangle, grey_in_white(2, StrokeAlignment::Inside)).assert_pattern(&[
            "     1E2        ",
            "     8FC        ",
            "    1EFF7       ",
            "    7FEFF3      ",
            "    DF9BFD1     ",
            "   5FE66DF9     ",
            "   CF9668FF4    ",
            "  4FE6666AFD1   ",
            "  BFA66666DFA   ",
            " 3FE6666667FF5  ",
            " AFB6666666AFE2 ",
            "2FF766666666CFB ",
            "9FFFFFFFFFFFFFF6",
            "EFFFFFFFFFFFFFFE",
        ]);
    }

    #[test]
    fn a_sharp_corner_is_cut_off() {
        let triangle = Triangle::new(Point::new(12, 5), Point::new(2, 4), Point::new(2, 7));
        antialiased(&triangle, PrimitiveStyle::with_stroke(Gray4::WHITE, 3)).assert_pattern(&[
            "             ",
            "             ",
            " 2           ",
            " FFECB986532 ",
            " FFFFFFFFFFFA",
            " FFFFFFFFFFFB",
            " FFFFFFFFFFFC",
            " FFFFFFFC9631",
            " FFC9631     ",
            " 31          ",
        ]);
    }

    #[test]
    fn a_triangle_without_an_area_is_a_line() {
        let triangle = Triangle::new(Point::new(4, 2), Point::new(4, 0), Point::new(4, 5));
        antialiased(&triangle, PrimitiveStyle::with_fill(Gray4::WHITE))
            .assert_pattern(&["    F", "    F", "    F", "    F", "    F", "    F"]);
    }
}
