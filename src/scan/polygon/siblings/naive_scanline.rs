//! Filling row by row without memory of the row before: every row intersects all edges, sorts the crossings, and fills
//! between pairs.
//!
//! Guarantees: the pixels of [`Polygons::scanline`](crate::scan::Polygons::scanline), under both fill rules. Each
//! crossing is computed from the ends of its edge, exactly.
//!
//! The baseline of the edge table and the active edge table (Wylie et al. 1967), which know which edges a row crosses and
//! step from crossing to crossing. Cost: rows times edges, and a division for each crossing of each row. Take it where the
//! RAM counts that a table of edges takes: it needs 8 bytes for each crossing of one row, and nothing else.

use core::{mem, num::NonZeroU32};

use heapless::{Vec, VecView};

use crate::{
    geometry::{DrawError, TooSmall, Vertex, Window, coordinate_after, coordinate_before, divide_wide},
    scan::polygon::{
        edge::ceil_pixel,
        pixel_bounds,
        point_in_polygon::{Units, visit_edges},
        polygons::Polygons,
        scanline_polygon::FillRule,
    },
    surface::Span,
};

/// Where an edge crosses the current row.
#[derive(Debug, Copy, Clone)]
struct RowCrossing {
    /// First pixel whose centre is on the edge or right of it.
    x: i32,
    /// What crossing the edge from left to right adds to the winding number.
    winding: i32,
}

impl Polygons {
    /// Hands over the visible spans of a polygon, top to bottom and left to right in each row, through a table of `N` crossings
    /// on the stack, 8 bytes each: room for every edge that crosses one row.
    ///
    /// The pixels are those of [`Polygons::scanline`](crate::scan::Polygons::scanline).
    ///
    /// Cost: for each row of the bounding box a comparison of all edges, a division for each that crosses, and a sort by
    /// insertion; before, edges squared to see whether the table is large enough.
    ///
    /// # Errors
    /// [`DrawError::TooSmall`] with the number that would do, before anything is handed over; then the first error that `emit` returns.
    pub fn naive_scanline<V: Vertex, E, const N: usize>(
        contours: &[&[V]],
        rule: FillRule,
        window: &Window,
        mut emit: impl FnMut(Span) -> Result<(), E>,
    ) -> Result<(), DrawError<E>> {
        let visible = pixel_bounds::visible(contours, window);
        if visible.is_empty() {
            return Ok(());
        }
        let needed = most_crossings(contours, &visible);
        if needed > N {
            return Err(DrawError::TooSmall(TooSmall::Crossings(needed)));
        }
        let mut crossings = Vec::<_, N>::new();
        for y in visible.top..visible.bottom {
            crossings.clear();
            visit_crossing_edges(contours, y, |top, bottom, winding| {
                let x = crossing(top, bottom, y, V::FRACTION_BITS);
                insert(crossings.as_mut_view(), RowCrossing { x, winding });
            });
            pair(&crossings, rule, y, window, &mut emit).map_err(DrawError::Target)?;
        }
        Ok(())
    }
}

/// The most crossings of a visible row. Their number grows only where an edge begins.
fn most_crossings<V: Vertex>(contours: &[&[V]], visible: &Window) -> usize {
    let mut most = 0;
    visit_edges(contours, |from, to| {
        let y = ceil_pixel(from.1.min(to.1), V::FRACTION_BITS).max(visible.top);
        if y < visible.bottom {
            let mut number = 0usize;
            visit_crossing_edges(contours, y, |_, _, _| number += 1);
            most = most.max(number);
        }
        Some(())
    });
    most
}

/// The edges that cross a row, from top to bottom, with what crossing them from left to right adds.
#[inline]
fn visit_crossing_edges<V: Vertex>(contours: &[&[V]], y: i32, mut visit: impl FnMut(Units, Units, i32)) {
    let row = y << V::FRACTION_BITS;
    visit_edges(contours, |from, to| {
        match (from.1 <= row, to.1 <= row) {
            (true, false) => visit(from, to, 1),
            (false, true) => visit(to, from, -1),
            _ => {}
        }
        Some(())
    });
}

/// The first pixel whose centre is on the edge or right of it, in a row that the edge crosses.
fn crossing(top: Units, bottom: Units, y: i32, fraction_bits: u32) -> i32 {
    let down = (y << fraction_bits).abs_diff(top.1);
    // The product of two 32-bit numbers fits. The way to the crossing is no longer than that to the bottom end.
    let product = u64::from(down) * u64::from(top.0.abs_diff(bottom.0));
    // The edge crosses the row, so its height is not 0.
    let height = NonZeroU32::new(top.1.abs_diff(bottom.1)).unwrap_or(NonZeroU32::MIN);
    let (units, remainder) = divide_wide(product, height);
    let first_unit = if bottom.0 < top.0 {
        coordinate_before(top.0, units)
    } else {
        coordinate_after(top.0, units) + i32::from(remainder != 0)
    };
    ceil_pixel(first_unit, fraction_bits)
}

/// Inserts a crossing behind those that are left of it or in its column, and moves the others on by one.
fn insert(crossings: &mut VecView<RowCrossing>, crossing: RowCrossing) {
    let mut moved = crossing;
    let right_of_it = crossings.iter_mut().skip_while(|other| other.x <= crossing.x);
    right_of_it.for_each(|other| mem::swap(other, &mut moved));
    let pushed = crossings.push(moved);
    debug_assert!(pushed.is_ok(), "the table has room for every edge that crosses the row");
}

/// Hands over the spans between the crossings of a row that are inside by the fill rule.
fn pair<E>(
    crossings: &[RowCrossing],
    rule: FillRule,
    y: i32,
    window: &Window,
    emit: &mut impl FnMut(Span) -> Result<(), E>,
) -> Result<(), E> {
    let mut winding = 0i32;
    let mut start = window.left;
    for crossing in crossings {
        let was_inside = rule.includes(winding);
        winding += crossing.winding;
        let is_inside = rule.includes(winding);
        if is_inside && !was_inside {
            start = crossing.x.max(window.left);
        }
        let end = crossing.x.min(window.right);
        if was_inside && !is_inside && end > start {
            emit(Span::new(y, start, end))?;
        }
    }
    Ok(())
}
