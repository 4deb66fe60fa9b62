//! Whether an outline is one contour that neither crosses nor touches itself.
//!
//! Two edges of one y-monotone chain meet in their common corner alone, so only edges of different chains are compared, and
//! of those only the ones with a common y: each two chains are walked down side by side.
//!
//! ```text
//!     A   B        A0 with B0, then B1; A1 with B1: where an edge ends first, the next one of its chain comes
//!    0|   |0
//!    --   |        chains may meet where both begin or end, no third chain there, and nowhere else
//!    1|   --
//!     |   |1
//! ```
//!
//! Guarantees: exact. Cost: for each two chains as many steps as both have edges.

use crate::{
    coverage::edges::AntialiasedEdge,
    draw::{
        SubOutline,
        outline::stored::{Chain, Corner, StoredOutline},
    },
};

/// Whether a stored outline is one contour whose edges have no point in common except the ends that neighbours share. Level
/// edges, which are not stored, are taken from the outline.
pub(super) fn is_simple(outline: &dyn SubOutline, stored: StoredOutline<'_>) -> bool {
    let (mut end, mut contours, mut level_is_disjoint) = (None, 0u32, true);
    outline.edges(&mut |from, to| {
        contours += u32::from(end != Some(from));
        end = Some(to);
        if let (true, Some(level)) = (contours <= 1 && level_is_disjoint, AntialiasedEdge::level(from, to)) {
            level_is_disjoint = meets_neighbours_only(&level, stored);
        }
    });
    contours <= 1
        && level_is_disjoint
        && stored.chains().all(|chain| {
            let others = || {
                let mut rest = Some(chain);
                core::iter::from_fn(move || {
                    rest = stored.chain(rest?.next);
                    rest
                })
            };
            has_free_ends(stored, chain) && others().all(|other| are_disjoint(stored, chain, other))
        })
}

/// Whether at most one other chain begins or ends at either end of a chain.
fn has_free_ends(stored: StoredOutline<'_>, chain: Chain) -> bool {
    stored.ends_of(chain).iter().all(|end| {
        let others = stored.chains().flat_map(|other| stored.ends_of(other));
        // Itself is one of them.
        others.filter(|other| other == end).count() <= 2
    })
}

/// Whether two chains have no point in common but where both begin or end.
fn are_disjoint(stored: StoredOutline<'_>, one: Chain, other: Chain) -> bool {
    let (one_ends, other_ends) = (stored.ends_of(one), stored.ends_of(other));
    let is_end = |corner: Corner| one_ends.contains(&corner) && other_ends.contains(&corner);
    let (mut edges, mut other_edges) = (stored.edges_of(one), stored.edges_of(other));
    let (mut edge, mut other) = (edges.next(), other_edges.next());
    while let (Some(this), Some(that)) = (edge, other) {
        let ([_, bottom], [_, other_bottom]) = (this.ends(), that.ends());
        let shared = this.ends().into_iter().filter(|end| that.ends().contains(end));
        if shared.clone().any(|corner| !is_end(corner)) || this.touches(&that) {
            return false;
        }
        // Where both end at one y, the next edge of either is compared with both of the other chain.
        if bottom[1] <= other_bottom[1] {
            edge = edges.next();
        }
        if other_bottom[1] <= bottom[1] {
            let next = other_edges.next();
            // What begins where the other ends may touch that end.
            if let (true, Some(next)) = (bottom[1] == other_bottom[1], &next) {
                if touches_unless_end(&this, next, is_end) {
                    return false;
                }
            }
            if let (true, Some(next)) = (bottom[1] == other_bottom[1], &edge) {
                if touches_unless_end(next, &that, is_end) {
                    return false;
                }
            }
            other = next;
        }
    }
    true
}

/// Whether two edges have a point in common which is not an end of both chains.
fn touches_unless_end(edge: &AntialiasedEdge, other: &AntialiasedEdge, is_end: impl Fn(Corner) -> bool) -> bool {
    let mut shared = edge.ends().into_iter().filter(|end| other.ends().contains(end));
    edge.touches(other) || shared.any(|corner| !is_end(corner))
}

/// Whether a level edge meets stored ones at its ends only, and at most one of them at each end.
fn meets_neighbours_only(level: &AntialiasedEdge, stored: StoredOutline<'_>) -> bool {
    let [left, right] = level.ends();
    let (mut at_left, mut at_right) = (0u32, 0u32);
    let y = left[1];
    for chain in stored.chains() {
        let [top, bottom] = stored.ends_of(chain);
        if y < top[1] || bottom[1] < y {
            continue;
        }
        for edge in stored.edges_of(chain) {
            let [top, bottom] = edge.ends();
            if y < top[1] || bottom[1] < y {
                continue;
            }
            let has = |end: Corner| u32::from(top == end || bottom == end);
            at_left += has(left);
            at_right += has(right);
            if at_left > 1 || at_right > 1 || edge.touches(level) {
                return false;
            }
        }
    }
    true
}
