//! Automatic choice of a coverage method for each shape.
//!
//! [`AutoCoverage`] takes the first of these methods whose condition the shape meets:
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

/// Picks the coverage method for a shape. An [`AnyCoverage`] implements this trait as well: it picks itself for every
/// shape.
pub trait CoverageChoice {
    /// Picks the method for `polygon`, which was prepared from `outline`.
    fn choose<O: SubOutline + ?Sized, const EDGES: usize, const ACTIVE: usize>(
        &mut self,
        outline: &O,
        polygon: &AntialiasedPolygon<EDGES, ACTIVE>,
    ) -> AnyCoverage;
}

impl CoverageChoice for AnyCoverage {
    fn choose<O: SubOutline + ?Sized, const EDGES: usize, const ACTIVE: usize>(
        &mut self,
        _outline: &O,
        _polygon: &AntialiasedPolygon<EDGES, ACTIVE>,
    ) -> AnyCoverage {
        *self
    }
}

/// Picks the cheapest coverage method that is exact for a shape, and counts how often each was picked.
///
/// - Every edge along pixel boundaries: [`AnyCoverage::CentreSample`].
/// - One contour that neither crosses nor touches itself: [`AnyCoverage::SignedArea`].
/// - Everything else: [`AnyCoverage::InsideArea`].
///
/// Cost: for each shape as many steps as there are pairs of edges, unless the outline is known to be simple
/// ([`SubOutline::is_simple`]) or its edges lie on pixel boundaries. A filtered line is never chosen, since its filter
/// gives other coverages. The counts wrap at 2^32.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AutoCoverage {
    /// Number of shapes whose edges lie on pixel boundaries.
    pub aligned: u32,
    /// Number of shapes of one contour that neither crosses nor touches itself.
    pub simple: u32,
    /// Number of all other shapes.
    pub other: u32,
}

impl CoverageChoice for AutoCoverage {
    fn choose<O: SubOutline + ?Sized, const EDGES: usize, const ACTIVE: usize>(
        &mut self,
        outline: &O,
        polygon: &AntialiasedPolygon<EDGES, ACTIVE>,
    ) -> AnyCoverage {
        let (count, method) = if polygon.edges().iter().all(AntialiasedEdge::is_aligned) {
            (&mut self.aligned, AnyCoverage::CentreSample)
        } else if outline.is_simple() || is_simple(outline, polygon.edges()) {
            (&mut self.simple, AnyCoverage::SignedArea)
        } else {
            (&mut self.other, AnyCoverage::InsideArea)
        };
        *count = count.wrapping_add(1);
        method
    }
}

/// Whether an outline is one contour whose edges have no point in common except the ends that neighbours share. `edges`
/// are those of its edges that are not level; level ones are taken from the outline.
fn is_simple<O: SubOutline + ?Sized>(outline: &O, edges: &[AntialiasedEdge]) -> bool {
    let mut end = None;
    let (mut contours, mut level_is_disjoint) = (0u32, true);
    outline.edges(&mut |from, to| {
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
