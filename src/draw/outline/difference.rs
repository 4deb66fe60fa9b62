//! What changes where one outline takes the place of another one: the edges that only one of them has.
//!
//! ```text
//!        common corners    end        The winding numbers of two outlines differ only within the contours that are left
//!      .-->-------->------o           when all edges are taken out that both have: in each row between the leftmost and
//!      |   .-------<-----o o  new     the rightmost of the other edges. Coverage is the same everywhere else.
//!      |   |            old
//! ```
//!
//! Edges are compared in the order in which the outlines run along them, from their beginnings on and from their ends
//! backwards; outlines of arcs by the parameters of these.
//!
//! Guarantees: no pixel changes outside. Cost: for corners in memory twice as many steps as there are edges, for arcs one
//! step for each arc; and the corners of the edges that differ.

use core::ops::Range;

use crate::{
    coverage::edges::AntialiasedEdge,
    draw::outline::stored::{Corner, Corners, StoredOutline},
};

/// What two outlines have in common.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Common {
    /// Edges: what changes lies between the other edges of both.
    Edges,
    /// No edge: what changes lies between the edges of either.
    Nothing,
    /// It is not known: `call` was called with no edge.
    Unknown,
}

/// Calls `call` with the edges that only one of two outlines has, as long as they are not level, or with more of them, and
/// with whether the new outline has them.
pub(crate) fn changed_edges(old: StoredOutline<'_>, new: StoredOutline<'_>, call: &mut EdgeSink<'_>) -> Common {
    let is_filled_alike = old.fill_rule() == new.fill_rule() && old.method() == new.method();
    match (old.corners(), new.corners()) {
        (Corners::Round, Corners::Round) if is_filled_alike => changed_round(old, new, call),
        (Corners::Round, _) | (_, Corners::Round) => Common::Unknown,
        _ => changed_stored(old, new, is_filled_alike, call),
    }
}

/// Takes edges of outlines, and whether each is one of the new outline.
pub(crate) type EdgeSink<'s> = dyn FnMut(&AntialiasedEdge, bool) + 's;

fn changed_stored(
    old: StoredOutline<'_>,
    new: StoredOutline<'_>,
    is_filled_alike: bool,
    call: &mut EdgeSink<'_>,
) -> Common {
    let is_same = |(one, other): &(AntialiasedEdge, AntialiasedEdge)| one == other;
    let first = old.edges_along().zip(new.edges_along()).take_while(is_same).count();
    let (old_count, new_count) = (old.edges_along().count(), new.edges_along().count());
    let fewer = old_count.min(new_count);
    // The last ones of both, side by side.
    let pairs = old
        .edges_along()
        .skip(old_count - fewer)
        .zip(new.edges_along().skip(new_count - fewer));
    let last = pairs.fold(0, |run, pair| if is_same(&pair) { run + 1 } else { 0 });
    // Where they are filled in another way, common edges do not cancel each other out.
    let (first, last) = if is_filled_alike {
        (first, last.min(fewer - first))
    } else {
        (0, 0)
    };
    for (outline, count, is_new) in [(old, old_count, false), (new, new_count, true)] {
        for edge in outline.edges_along().skip(first).take(count - first - last) {
            call(&edge, is_new);
        }
    }
    if first + last > 0 {
        Common::Edges
    } else {
        Common::Nothing
    }
}

fn changed_round(old: StoredOutline<'_>, new: StoredOutline<'_>, call: &mut EdgeSink<'_>) -> Common {
    let (Some(old_arcs), Some(new_arcs)) = (old.arcs_of_one_contour(), new.arcs_of_one_contour()) else {
        return Common::Unknown;
    };
    let common = |mut pairs: &mut dyn Iterator<Item = (u16, u16)>, from_end: bool| {
        let mut corners = 0;
        for (old_arc, new_arc) in &mut pairs {
            let (one, other) = (old.arc(old_arc), new.arc(new_arc));
            corners += one.common_corners(&other, from_end);
            if one != other {
                break;
            }
        }
        corners
    };
    let first = common(&mut (0..old_arcs).zip(0..new_arcs), false);
    let last = common(&mut (0..old_arcs).rev().zip((0..new_arcs).rev()), true);
    if first == 0 {
        return Common::Unknown;
    }
    let count = |outline: StoredOutline<'_>, arcs: u16| (0..arcs).map(|arc| outline.arc(arc).corners()).sum::<u16>();
    let counts = [count(old, old_arcs), count(new, new_arcs)];
    let last = last.min(counts[0] - first).min(counts[1] - first);
    for (outline, count, is_new) in [(old, counts[0], false), (new, counts[1], true)] {
        // The contour's first corner once more has the position behind the last one.
        call_between(outline, first - 1..count - last, &mut |edge| call(edge, is_new));
    }
    Common::Edges
}

/// Calls with the edges from corner to corner, those of a range of positions.
fn call_between(outline: StoredOutline<'_>, positions: Range<u16>, call: &mut dyn FnMut(&AntialiasedEdge)) {
    let mut from: Corner = outline.corner(positions.start);
    for position in positions {
        let to = outline.corner(position + 1);
        if let Some(edge) = AntialiasedEdge::from_units(from, to) {
            call(&edge);
        }
        from = to;
    }
}
