//! Automatic choice of a coverage method for each shape.
//!
//! [`AntialiasedPolygon::exact_method`] takes the first of these methods whose condition the shape meets:
//!
//! - centre samples, where every edge that is not level lies on pixel boundaries: each pixel is covered wholly or not
//!   at all;
//! - signed area, where the outline is one contour that neither crosses nor touches itself;
//! - inside area, for every other outline.
//!
//! The contour is tested by comparing every two edges exactly, unless [`SubOutline::is_simple`] is known.

use crate::{
    coverage::{AnyCoverage, edges::AntialiasedEdge},
    draw::{AntialiasedPolygon, SubOutline},
};

impl<const EDGES: usize, const ACTIVE: usize> AntialiasedPolygon<EDGES, ACTIVE> {
    /// The cheapest coverage method that is exact for the polygon, which was prepared from `outline`.
    ///
    /// - Every edge along pixel boundaries: [`AnyCoverage::CentreSample`].
    /// - One contour that neither crosses nor touches itself: [`AnyCoverage::SignedArea`].
    /// - Everything else: [`AnyCoverage::InsideArea`].
    ///
    /// Cost: as many steps as there are pairs of edges, unless the outline is known to be simple
    /// ([`SubOutline::is_simple`]) or its edges lie on pixel boundaries. A filtered line is never chosen, since its filter
    /// gives other coverages.
    pub fn exact_method<O: SubOutline + ?Sized>(&self, outline: &O) -> AnyCoverage {
        if self.is_mirrored() {
            AnyCoverage::SignedArea
        } else if self.edges().iter().all(AntialiasedEdge::is_aligned) {
            AnyCoverage::CentreSample
        } else if outline.is_simple() || is_simple(outline, self.edges()) {
            AnyCoverage::SignedArea
        } else {
            AnyCoverage::InsideArea
        }
    }
}

/// Whether an outline is one contour whose edges have no point in common except the ends that neighbours share. `edges`
/// are those of its edges that are not level; level ones are taken from the outline.
fn is_simple<O: SubOutline + ?Sized>(outline: &O, edges: &[AntialiasedEdge]) -> bool {
    let mut end = None;
    let (mut contours, mut level_is_disjoint) = (0u32, true);
    outline.edges(&mut |from, to| {
        // A contour of a single point has no area.
        if from == to {
            return;
        }
        if end != Some(from) {
            contours = contours.saturating_add(1);
        }
        end = Some(to);
        if let Some(level) = AntialiasedEdge::level(from, to) {
            level_is_disjoint &= meets_neighbours_only(&level, edges);
        }
    });
    let before = |index: usize| edges.get(..index).unwrap_or_default();
    let apart = |(index, edge): (usize, &AntialiasedEdge)| meets_neighbours_only(edge, before(index));
    contours <= 1 && level_is_disjoint && edges.iter().enumerate().all(apart)
}

/// Whether `edge` meets the `others` at its ends only, and at most one of them at each end.
fn meets_neighbours_only(edge: &AntialiasedEdge, others: &[AntialiasedEdge]) -> bool {
    let [top, bottom] = edge.ends();
    let (mut at_top, mut at_bottom) = (0u32, 0u32);
    for other in others {
        let [other_top, other_bottom] = other.ends();
        // Most other edges lie above or below this one, without a common y.
        if other_bottom[1] < top[1] || bottom[1] < other_top[1] {
            continue;
        }
        let has = |end: [i32; 2]| u32::from(other_top == end || other_bottom == end);
        at_top += has(top);
        at_bottom += has(bottom);
        if at_top > 1 || at_bottom > 1 || other.touches(edge) {
            return false;
        }
    }
    true
}
