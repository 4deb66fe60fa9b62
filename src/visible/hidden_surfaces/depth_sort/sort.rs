//! The list of faces is painted from its farthest end, and what is in the way of its first face is moved or split.

use core::{cmp::Reverse, marker::PhantomData};

use crate::{
    geometry::Window,
    shade::Shading,
    view::{DepthWidth, ScreenPrecision},
    visible::{face_table::FaceTable, painter::Painter, work::Work},
};

use super::{
    along_rows::relation_along_rows,
    counters::{DepthSortCounters, add},
    pairs::{Extents, Relation, Side, are_apart, comes_first, depth_margin, side_of_plane},
    waiting::Waiting,
};

/// By what faces that wait are sorted: the depth of their farthest corner. Of equally far ones the one that is seen where both
/// are as near comes last.
pub(super) fn from_back<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    node: u16,
) -> (Option<i32>, Reverse<u16>) {
    let farthest = Extents::of(faces, node).map(|face| face.farthest());
    (farthest, Reverse(faces.order(node)))
}

/// The faces of a window while they are painted.
pub(super) struct Sort<'s, S, D, H, F> {
    pub(super) faces: &'s F,
    pub(super) window: &'s Window,
    pub(super) waiting: Waiting<'s>,
    pub(super) counters: &'s mut DepthSortCounters,
    look: PhantomData<(S, D, H)>,
}

impl<'s, S, D, H, F> Sort<'s, S, D, H, F>
where
    S: ScreenPrecision,
    D: DepthWidth,
    H: Shading,
    F: FaceTable<S, D, H>,
{
    /// Paints faces of a table that wait into a window.
    pub(super) fn new(
        faces: &'s F,
        window: &'s Window,
        waiting: Waiting<'s>,
        counters: &'s mut DepthSortCounters,
    ) -> Self {
        Self {
            faces,
            window,
            waiting,
            counters,
            look: PhantomData,
        }
    }

    /// Paints all faces that wait.
    pub(super) fn paint_all(&mut self, painter: &mut impl Painter<S, H>) {
        while !self.waiting.is_empty() {
            self.take_step(painter);
        }
    }

    /// Paints the first entry of the list, or takes what is in its way out of it.
    fn take_step(&mut self, painter: &mut impl Painter<S, H>) {
        let mut from = self.waiting.first() + 1;
        loop {
            let first = self.waiting.first();
            let Some((other, relation)) = self.find_in_the_way(first, from) else {
                self.paint(first..first + 1, painter);
                return;
            };
            let is_cycle = self.waiting.was_moved(other);
            if (is_cycle || relation == Relation::Penetrates) && self.split_first(other, painter) {
                // What is left of the first entry is behind those that it was behind before. All of them may have moved up.
                from = other - (first - self.waiting.first());
                continue;
            }
            if is_cycle {
                self.paint_cycle(other, painter);
            } else {
                self.move_to_front(other);
            }
            return;
        }
    }

    /// The first entry from one on that an entry may not be painted before.
    fn find_in_the_way(&mut self, entry: usize, from: usize) -> Option<(usize, Relation)> {
        let faces = self.faces;
        let face = Extents::of(faces, self.waiting.node(entry)?)?;
        let margin = depth_margin::<D>(faces.viewport());
        // Found once, for all that are compared with the face.
        let (nearest, pixels) = (face.nearest(), face.pixels());
        for index in from..self.waiting.end() {
            let other = Extents::of(faces, self.waiting.node(index)?)?;
            let distance = other.farthest() - nearest;
            if distance > margin && !self.waiting.was_moved(index) {
                // All others are as near, or nearer.
                break;
            }
            let is_behind = distance > margin || (distance == margin && comes_first(faces, &other, &face));
            if !is_behind && other.node != face.node {
                add(&mut self.counters.pairs, 1);
                if !pixels.meet(&other) {
                    add(&mut self.counters.extents_apart, 1);
                    continue;
                }
                let relation = self.relation([entry, index], &face, &other);
                if relation != Relation::Behind {
                    return Some((index, relation));
                }
            }
        }
        None
    }

    /// Whether a face is in front of another one in pixels that both cover, by tests B to D and by stored depths.
    // Not inlined, so that the loop around it, which test A ends for most pairs, stays small.
    #[inline(never)]
    fn relation(
        &mut self,
        [entry, index]: [usize; 2],
        face: &Extents<'_, S, D>,
        other: &Extents<'_, S, D>,
    ) -> Relation {
        let (faces, counters) = (self.faces, &mut *self.counters);
        let waiting = &self.waiting;
        let entries = [entry, index];
        if waiting.is_known_behind(entries, [face.node, other.node]) {
            return Relation::Behind;
        }
        let is_first = comes_first(faces, face, other);
        let side = side_of_plane(face.corners, other.corners, is_first, faces.viewport());
        let of_other = if side == Side::Neither {
            side_of_plane(other.corners, face.corners, !is_first, faces.viewport())
        } else {
            side.opposite()
        };
        if of_other == Side::InFront {
            add(&mut counters.ordered_by_planes, 1);
            return Relation::Behind;
        }
        if are_apart(face.corners, other.corners) {
            add(&mut counters.projections_apart, 1);
            return Relation::Behind;
        }
        // Of parts the faces may overlap where the parts do not.
        if of_other == Side::Behind && !entries.into_iter().any(|entry| waiting.is_part(entry)) {
            return Relation::InFront;
        }
        add(&mut counters.compared_in_rows, 1);
        let [conditions, of_other] = entries.map(|entry| waiting.conditions(entry));
        let pair = [(face, conditions), (other, of_other)];
        relation_along_rows(faces, self.window, pair, is_first, &mut counters.pixels_compared)
    }

    /// Moves an entry of the list to its front.
    fn move_to_front(&mut self, entry: usize) {
        add(&mut self.counters.moves, 1);
        self.waiting.move_to_front(entry);
    }

    /// Splits the first entry by the plane of another one: what is in front of it goes back to the sorted part of the list.
    /// Returns `false` where there is no room for that, or the first entry was split by this plane before.
    fn split_first(&mut self, other: usize, painter: &mut impl Painter<S, H>) -> bool {
        let (faces, waiting) = (self.faces, &mut self.waiting);
        let (Some(node), Some(other)) = (waiting.node(waiting.first()), waiting.node(other)) else {
            return false;
        };
        let behind = from_back(faces, node);
        let is_split = waiting.split_first(other, |waiting| from_back(faces, waiting) <= behind);
        add(&mut self.counters.splits, is_split.into());
        if is_split {
            painter.report(|| Work::Split {
                face: faces.order(node).into(),
                by: faces.order(other).into(),
            });
        }
        is_split
    }

    /// Paints the entries from the first one to another one, which hide each other in a cycle, each where it is not behind
    /// another one of them. What is in their way joins them where it was moved before, or else goes to the front.
    fn paint_cycle(&mut self, mut last: usize, painter: &mut impl Painter<S, H>) {
        let first = self.waiting.first();
        let mut entry = first;
        while entry <= last {
            match self.find_in_the_way(entry, last + 1) {
                None => entry += 1,
                Some((other, _)) if self.waiting.was_moved(other) => (last, entry) = (other, first),
                Some((other, _)) => {
                    self.move_to_front(other);
                    return;
                }
            }
        }
        add(&mut self.counters.in_cycles, (last + 1 - first) as u32);
        self.paint(first..last + 1, painter);
    }
}
