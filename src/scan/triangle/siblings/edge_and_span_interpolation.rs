//! Attributes of a convex polygon by two linear interpolations (Gouraud 1971): along the edges from row to row, and along each
//! span from its left edge to its right one.
//!
//! ```text
//!        a          In row y the left edge is between a and b, the right one between a and c. `l` and `r` have the
//!       / \         attributes of these edges at the row's centre, and p those between `l` and `r` in proportion to
//!   y  l-p-r        its distances from both.
//!     /     \
//!    b-------c
//! ```
//!
//! In a triangle this is its plane. In a polygon of more corners it is not a plane: an attribute is bilinear, as long as no
//! corner is between, and depends on how the polygon is turned on the screen, because rows go level whatever it does. So a
//! turning quadrangle changes its colours inside; as triangles it does not.
//!
//! Guarantees: the pixels of [`Polygons::scanline`](crate::scan::Polygons::scanline) for convex polygons; each attribute less
//! than one unit from the exact one where it changes by at most 2^15 within a unit of precision along the row, which only
//! slivers exceed, and less than one unit outside of those of both edges anywhere. Positions of edges have 32 bits after a unit
//! of precision, attributes 16; both are stepped from row to row, and attributes from pixel to pixel.

use core::num::{NonZeroU64, Wrapping};

use embedded_graphics::geometry::Point;

use crate::{
    geometry::{SubPixel, SubPoint, Window, quotient_nearest},
    scan::{
        polygon::{Crossing, Edge, Part, Polygons, ceil_pixel},
        triangle::siblings::edge_function::in_domain,
    },
};

/// Fractional bits of positions along a row, after those of a unit of precision, when they are divided.
const POSITION_BITS: u32 = 22;

/// An edge of a polygon on its way down, with its attributes.
#[derive(Copy, Clone)]
struct AttributeEdge<const N: usize> {
    edge: Edge,
    /// The first pixel whose centre is on the edge or right of it, in the current row.
    crossing: Crossing,
    /// The column at which the edge crosses the centre line of the current row of pixels, in sub-pixel units with 32 fractional
    /// bits, and what it gains from row to row.
    x: i64,
    x_step: i64,
    /// The attributes there, with 16 fractional bits, and what a row adds.
    values: [i64; N],
    value_steps: [i64; N],
}

impl Polygons {
    /// Hands over the visible pixels of a convex polygon, top to bottom, each with its attributes, which are interpolated along
    /// edges and then along spans.
    ///
    /// The pixels are those of [`plane_interpolation`](Self::plane_interpolation), and in a triangle so are the attributes to
    /// within two units. In a polygon of more corners they depend on how it is turned.
    ///
    /// Cost: two divisions an edge and two an edge and attribute, one a row and attribute, an addition an attribute and pixel.
    /// Source: Gouraud 1971.
    ///
    /// # Errors
    /// The first error that `emit` returns.
    pub fn edge_and_span_interpolation<S: SubPixel, E, const N: usize>(
        corners: &[(SubPoint<S>, [i16; N])],
        window: &Window,
        mut emit: impl FnMut(Point, [i16; N]) -> Result<(), E>,
    ) -> Result<(), E> {
        let rows = corners.iter().map(|(vertex, _)| in_domain(vertex).map(|(_, y)| y));
        let (Some(Some(top)), Some(Some(bottom))) = (rows.clone().min(), rows.max()) else {
            return Ok(());
        };
        let (top, bottom) = (ceil_pixel(top, S::FRACTION_BITS), ceil_pixel(bottom, S::FRACTION_BITS));
        let mut edges = None;
        for y in top.max(window.top)..bottom.min(window.bottom) {
            let (one, other) = match edges {
                Some(edges) => edges,
                None => {
                    let mut crossing = crossing_edges(corners, y);
                    match (crossing.next(), crossing.next()) {
                        (Some(one), Some(other)) => (one, other),
                        _ => continue,
                    }
                }
            };
            let (left, right) = if one.crossing.x <= other.crossing.x {
                (&one, &other)
            } else {
                (&other, &one)
            };
            draw_span::<S, E, N>(left, right, y, window, &mut emit)?;
            let end = one.edge.end_row.min(other.edge.end_row);
            edges = if y + 1 < end {
                Some((one.next_row(), other.next_row()))
            } else {
                None
            };
        }
        Ok(())
    }
}

/// Hands over the visible pixels of a row between two edges.
fn draw_span<S: SubPixel, E, const N: usize>(
    left: &AttributeEdge<N>,
    right: &AttributeEdge<N>,
    y: i32,
    window: &Window,
    emit: &mut impl FnMut(Point, [i16; N]) -> Result<(), E>,
) -> Result<(), E> {
    let (start, end) = (left.crossing.x.max(window.left), right.crossing.x.min(window.right));
    if start >= end {
        return Ok(());
    }
    let width = (right.x - left.x) >> (32 - POSITION_BITS);
    // Inside the polygon, and so in the domain. A rounded edge may be right of the pixel.
    let from_left = (i64::from(start << S::FRACTION_BITS) << POSITION_BITS) - (left.x >> (32 - POSITION_BITS));
    let from_left = from_left.min(width).max(0);
    let divisor = u64::try_from(width)
        .ok()
        .and_then(NonZeroU64::new)
        .unwrap_or(NonZeroU64::MAX);
    let mut ends = right.values.iter();
    let mut steps = [Wrapping(0); N];
    let mut step = steps.iter_mut();
    let mut values = left.values.map(|value| {
        // Below 2^32 and a quarter of a unit, with 30 more bits. The pixel is not beyond the right edge: what the product is
        // more than that is half of the width.
        let rise = (ends.next().unwrap_or(&value) - value) << (POSITION_BITS + S::FRACTION_BITS);
        let per_column = quotient_nearest(rise, divisor);
        if let Some(step) = step.next() {
            *step = Wrapping(per_column as i32);
        }
        let risen = (from_left * per_column) >> (POSITION_BITS + S::FRACTION_BITS);
        Wrapping((value + risen + (1 << 15)) as i32)
    });
    for x in start..end {
        emit(Point::new(x, y), values.map(|value| (value.0 >> 16) as i16))?;
        for (value, step) in values.iter_mut().zip(&steps) {
            *value += step;
        }
    }
    Ok(())
}

/// The edges of a polygon that cross the centre of a row, at that row: two where the polygon is convex.
fn crossing_edges<S: SubPixel, const N: usize>(
    corners: &[(SubPoint<S>, [i16; N])],
    y: i32,
) -> impl Iterator<Item = AttributeEdge<N>> {
    let ends = corners.iter().cycle().skip(1);
    corners
        .iter()
        .zip(ends)
        .filter_map(move |(from, to)| AttributeEdge::new(from, to, y))
}

impl<const N: usize> AttributeEdge<N> {
    /// The edge between two corners at a row; `None` where it does not cross the row's centre.
    fn new<S: SubPixel>(from: &(SubPoint<S>, [i16; N]), to: &(SubPoint<S>, [i16; N]), y: i32) -> Option<Self> {
        let (from_units, to_units) = (in_domain(&from.0)?, in_domain(&to.0)?);
        let downwards = from_units.1 < to_units.1;
        let (top, bottom) = if downwards {
            (from_units, to_units)
        } else {
            (to_units, from_units)
        };
        let (of_top, of_bottom) = if downwards { (&from.1, &to.1) } else { (&to.1, &from.1) };
        if y < ceil_pixel(top.1, S::FRACTION_BITS) || y >= ceil_pixel(bottom.1, S::FRACTION_BITS) {
            return None;
        }
        let edge = Edge::from_units(top, bottom, S::FRACTION_BITS, Part::Fill)?;
        let height = NonZeroU64::new(u64::from(top.1.abs_diff(bottom.1)))?;
        // Less than a pixel; and rows from there on.
        let to_first_row = i64::from((edge.first_row << S::FRACTION_BITS) - top.1);
        let rows = i64::from(y - edge.first_row);
        // What the first row's centre adds, and each row: the change is below 2^22 units and 32 bits, or 2^16 and 16 bits.
        let along = |change: i64, bits: u32| {
            let step = quotient_nearest(change << (bits + S::FRACTION_BITS), height);
            (
                quotient_nearest((change * to_first_row) << bits, height) + step * rows,
                step,
            )
        };
        let (x, x_step) = along(i64::from(bottom.0) - i64::from(top.0), 32);
        let mut ends = of_bottom.iter();
        let mut value_steps = [0; N];
        let mut steps = value_steps.iter_mut();
        let values = of_top.map(|of_top| {
            let change = i64::from(*ends.next().unwrap_or(&of_top)) - i64::from(of_top);
            let (risen, value_step) = along(change, 16);
            if let Some(step) = steps.next() {
                *step = value_step;
            }
            (i64::from(of_top) << 16) + risen
        });
        Some(Self {
            edge,
            crossing: edge.crossing_at(y),
            x: (i64::from(top.0) << 32) + x,
            x_step,
            values,
            value_steps,
        })
    }

    /// The edge at the next row, which it crosses as well.
    fn next_row(&self) -> Self {
        let mut next = *self;
        next.crossing = self.edge.next_crossing(self.crossing);
        next.x += self.x_step;
        for (value, step) in next.values.iter_mut().zip(&self.value_steps) {
            *value += step;
        }
        next
    }
}
