//! Whether an outline is one contour that neither crosses nor touches itself.
//!
//! Two edges of one y-monotone chain meet in their common corner alone, so only edges of different chains are compared, and
//! of those only the ones with a common y: each two chains are walked down side by side.
//!
//! ```text
//!     A   B        A0 with B0, then B1; A1 with B1: where an edge ends first, the next one of its chain comes
//!    0|   |0
//!    --   |        chains may meet where one is followed by the other, and nowhere else
//!    1|   --
//!     |   |1
//! ```
//!
//! Guarantees: exact. Cost: for each two chains as many steps as both have edges.

use crate::{
    coverage::edges::AntialiasedEdge,
    draw::{
        SubOutline,
        outline::stored::{Corner, StoredOutline},
    },
};

/// Whether a stored outline is one contour whose edges have no point in common except the ends that neighbours share. Level
/// edges, which are not stored, are taken from the outline.
pub(super) fn is_simple(outline: &dyn SubOutline, stored: StoredOutline<'_>) -> bool {
    let (mut end, mut contours, mut level_is_disjoint) = (None, 0u32, true);
    outline.edges(&mut |from, to| {
        // A contour of a single point has no area.
        if from == to {
            return;
        }
        contours += u32::from(end != Some(from));
        end = Some(to);
        if let (true, Some(level)) = (contours <= 1 && level_is_disjoint, AntialiasedEdge::level(from, to)) {
            level_is_disjoint = meets_neighbours_only(&level, stored);
        }
    });
    contours <= 1 && level_is_disjoint && chains_are_disjoint(stored)
}

/// Whether chains of one contour meet only where one is followed by the other. Not inlined, for what it needs of the stack.
#[inline(never)]
fn chains_are_disjoint(stored: StoredOutline<'_>) -> bool {
    let count = stored.chains_along().count();
    stored.chains_along().enumerate().all(|(index, chain)| {
        let (ends, columns) = (stored.ends_of(chain), stored.columns_of(chain));
        stored
            .chains_along()
            .enumerate()
            .skip(index + 1)
            .all(|(other_index, other)| {
                let other_ends = stored.ends_of(other);
                let ([[_, top], [_, bottom]], [[_, other_top], [_, other_bottom]]) = (ends, other_ends);
                if bottom < other_top || other_bottom < top {
                    return true;
                }
                let other_columns = stored.columns_of(other);
                if columns.end() < other_columns.start() || other_columns.end() < columns.start() {
                    return true;
                }
                // Where level edges lie between the two, these are no common corners.
                let joins = [
                    (other_index == index + 1).then(|| stored.last_of(chain)),
                    (index == 0 && other_index + 1 == count).then(|| stored.last_of(other)),
                ];
                are_disjoint([stored.edges_of(chain), stored.edges_of(other)], joins)
            })
    })
}

/// Whether two chains have no point in common but where one is followed by the other.
fn are_disjoint(
    [mut edges, mut other_edges]: [impl Iterator<Item = AntialiasedEdge>; 2],
    joins: [Option<Corner>; 2],
) -> bool {
    let is_end = |corner: Corner| joins.contains(&Some(corner));
    let (mut edge, mut other) = (edges.next(), other_edges.next());
    while let (Some(this), Some(that)) = (edge, other) {
        let ([_, bottom], [_, other_bottom]) = (this.ends(), that.ends());
        if touches_unless_end(&this, &that, is_end) {
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

/// Whether two edges have a point in common which is not one where their chains may meet.
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
