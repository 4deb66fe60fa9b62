//! Filling of polygons and paths: the edges of all contours are collected into a table once, sorted by their first row,
//! and then scan-converted for each band.
//!
//! Guarantees: a table that is too small is reported by [`set_up`], with the exact number that is needed; [`draw`]
//! fails with the target's own error only.

use heapless::{Vec, VecView};

use crate::{
    geometry::TooSmall,
    scan::polygon::{
        ActiveEdge, Edge, edge_table,
        scanline_polygon::{self, FillRule, PartRule, Windings},
    },
    surface::Target,
};

/// Calls its argument with each edge of closed contours, in the same order at every call.
pub(super) type Edges<'a> = dyn Fn(&mut dyn FnMut(Edge)) + 'a;

/// Collects the edges of `source` into a table, sorted by their first row. `ACTIVE` is the largest number of edges that
/// may cross one row.
///
/// # Errors
/// [`TooSmall`] with the exact number that is needed, where there are more than `EDGES` edges or where more than
/// `ACTIVE` of them cross one row.
pub(super) fn set_up<const EDGES: usize, const ACTIVE: usize>(
    source: &Edges<'_>,
) -> Result<Vec<Edge, EDGES>, TooSmall> {
    let mut edges = Vec::new();
    collect(source, edges.as_mut_view())?;
    let needed = edge_table::most_active(&edges);
    trace!(
        "contours: {} of {} edges, {} of {} active",
        edges.len(),
        EDGES,
        needed,
        ACTIVE
    );
    if needed > ACTIVE {
        return Err(TooSmall::ActiveEdges(needed));
    }
    Ok(edges)
}

/// Pushes the edges of `source` into an empty table and sorts them.
fn collect(source: &Edges<'_>, edges: &mut VecView<Edge>) -> Result<(), TooSmall> {
    let mut needed = 0usize;
    source(&mut |edge| {
        needed = needed.saturating_add(1);
        // A full table drops the edge, which is still counted: `needed` is reported below.
        let _ = edges.push(edge);
    });
    if needed > edges.len() {
        return Err(TooSmall::Edges(needed));
    }
    edge_table::sort(edges);
    Ok(())
}

/// Fills the visible part of the polygon whose edges [`set_up`] has sorted. `ACTIVE` must not be smaller than it was
/// there.
pub(super) fn draw<T: Target, const ACTIVE: usize>(
    edges: &[Edge],
    fill_rule: FillRule,
    color: T::Color,
    target: &mut T,
) -> Result<(), T::Error> {
    let raw = target.raw(color);
    let window = target.window();
    let mut active = Vec::<ActiveEdge<'_, Edge>, ACTIVE>::new();
    let rule = PartRule::fill(fill_rule);
    let active = active.as_mut_view();
    scanline_polygon::scan(edges, active, Windings::default(), rule, &window, |span, _| {
        target.fill_clipped_span(span, raw)
    })
}
