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

/// Calls `call` with the edges that only one of two outlines has, as long as they are not level, or with more of them.
/// Returns whether they have any edge in common; where they have none, it calls with none.
pub(crate) fn changed_edges(
    old: StoredOutline<'_>,
    new: StoredOutline<'_>,
    call: &mut dyn FnMut(&AntialiasedEdge),
) -> bool {
    if old.fill_rule() != new.fill_rule() || old.method() != new.method() {
        return false;
    }
    match (old.corners(), new.corners()) {
        (Corners::Round, Corners::Round) => changed_round(old, new, call),
        (Corners::Round, _) | (_, Corners::Round) => false,
        _ => changed_stored(old, new, call),
    }
}

fn changed_stored(old: StoredOutline<'_>, new: StoredOutline<'_>, call: &mut dyn FnMut(&AntialiasedEdge)) -> bool {
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
    let last = last.min(fewer - first);
    if first + last == 0 {
        return false;
    }
    for (outline, count) in [(old, old_count), (new, new_count)] {
        for edge in outline.edges_along().skip(first).take(count - first - last) {
            call(&edge);
        }
    }
    true
}

fn changed_round(old: StoredOutline<'_>, new: StoredOutline<'_>, call: &mut dyn FnMut(&AntialiasedEdge)) -> bool {
    let (Some(old_arcs), Some(new_arcs)) = (old.arcs_of_one_contour(), new.arcs_of_one_contour()) else {
        return false;
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
        return false;
    }
    let count = |outline: StoredOutline<'_>, arcs: u16| (0..arcs).map(|arc| outline.arc(arc).corners()).sum::<u16>();
    let counts = [count(old, old_arcs), count(new, new_arcs)];
    let last = last.min(counts[0] - first).min(counts[1] - first);
    for (outline, count) in [(old, counts[0]), (new, counts[1])] {
        // The contour's first corner once more has the position behind the last one.
        call_between(outline, first - 1..count - last, call);
    }
    true
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
