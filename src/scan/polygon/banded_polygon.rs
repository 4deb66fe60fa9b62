//! Scan-line conversion of any number of edges through a small table: bands are halved until their edges fit.
//!
//! Guarantees: every pixel that [`Polygons::scanline`](crate::scan::Polygons::scanline) would hand over with a table large enough, and nothing is ever left
//! out. The edges are generated anew for each band (the band bisection of FreeType's smooth rasterizer, Turner 1996-2002).
//! A single row whose edges do not fit is cut into columns; what lies left of these is a winding number.

use heapless::{Vec, VecView};

use crate::{
    geometry::Window,
    scan::polygon::{
        ActiveEdge, Part, ScanEdge,
        bisection::Bisection,
        edge_table,
        scanline_polygon::{self, PartRule, Windings},
    },
    surface::Span,
};

/// Edges in the table: 640 bytes of stack on a 32-bit machine with the active edges.
const TABLE: usize = 14;

/// Generates the edges of closed contours; may leave out contours that do not reach the window.
pub type EdgeSource<'a, G> = dyn Fn(&Window, &mut dyn FnMut(G)) + 'a;

/// Hands over the visible spans of a source, top to bottom and left to right in each row, each pixel at most once.
///
/// Cost: that of [`scanline_polygon::scan`], and one run of the source for each band.
///
/// # Errors
/// The first error that `emit` returns.
pub fn scan<G: ScanEdge + Copy, E>(
    source: &EdgeSource<'_, G>,
    rule: PartRule,
    window: &Window,
    mut emit: impl FnMut(Span, Part) -> Result<(), E>,
) -> Result<(), E> {
    let mut edges = Vec::<G, TABLE>::new();
    let mut bands = Bisection::new(window);
    while let Some(band) = bands.next_band() {
        let Some(left_of_band) = collect(source, &band, edges.as_mut_view()) else {
            bands.halve(&band);
            continue;
        };
        let mut active = Vec::<ActiveEdge<'_, G>, TABLE>::new();
        scanline_polygon::scan(&edges, active.as_mut_view(), left_of_band, rule, &band, &mut emit)?;
        bands.done(&band, edges.len() <= TABLE / 2);
    }
    Ok(())
}

/// Fills the table with the edges that a band needs, sorted; `None` where they are too many.
///
/// In a band of one row, the edges that cross it left of its columns become winding numbers.
fn collect<G: ScanEdge + Copy>(source: &EdgeSource<'_, G>, band: &Window, edges: &mut VecView<G>) -> Option<Windings> {
    edges.clear();
    let mut left_of_band = Windings::default();
    let mut fits = true;
    let one_row = band.height() == 1;
    source(band, &mut |edge| {
        if edge.end_row() <= band.top || edge.first_row() >= band.bottom {
            return;
        }
        if one_row {
            let x = edge.crossing_at(band.top).x;
            if x >= band.right {
                return;
            }
            if x <= band.left {
                left_of_band.cross(&edge);
                return;
            }
        }
        fits &= edges.push(edge).is_ok();
    });
    if !fits {
        return None;
    }
    edge_table::sort(edges);
    Some(left_of_band)
}
