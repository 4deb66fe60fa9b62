//! What polygons and paths share: the edges of their contours in a table, set up once and filled band after band.

use heapless::{Vec, VecView};

use crate::{
    geometry::{Table, TooSmall},
    scan::polygon::{
        ActiveEdge, Edge, edge_table,
        scanline_polygon::{self, FillRule, PartRule, Windings},
    },
    surface::Target,
};

/// Generates the edges of closed contours, the same ones at each call.
pub(super) type Edges<'a> = dyn Fn(&mut dyn FnMut(Edge)) + 'a;

/// The table of these edges, sorted. `ACTIVE` must be enough for those that cross one row.
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
        return Err(TooSmall {
            table: Table::ActiveEdges,
            needed,
        });
    }
    Ok(edges)
}

fn collect(source: &Edges<'_>, edges: &mut VecView<Edge>) -> Result<(), TooSmall> {
    let mut needed = 0usize;
    source(&mut |edge| {
        needed = needed.saturating_add(1);
        // Without room it is only counted.
        let _ = edges.push(edge);
    });
    if needed > edges.len() {
        return Err(TooSmall {
            table: Table::Edges,
            needed,
        });
    }
    edge_table::sort(edges);
    Ok(())
}

/// Fills what is visible of a table that was set up with the same `ACTIVE`.
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
