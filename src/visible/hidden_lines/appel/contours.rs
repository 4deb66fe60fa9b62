//! The contour lines of a scene: sides of faces that are seen, with no such face on the other side.
//!
//! Each side of a face runs with its face on the right. Two faces that are seen and share a side have it in opposite directions,
//! and both are taken out. What is left is a contour: a silhouette, where the face on the other side is turned away; a boundary;
//! the side of a face beside one whose back is drawn, twice. No table of edges is needed for it, and any number of faces may
//! meet in a side.

use crate::visible::hidden_lines::LinePoint;

/// A side of a face, which lies on its right.
pub(super) type Side = [LinePoint; 2];

/// The sides of the first faces of a table without a partner among these, as many faces as there was room for.
#[derive(Debug)]
pub(super) struct Contours<'c> {
    sides: &'c mut [Side],
    used: usize,
    /// The index of the first face that found no room.
    pub(super) end: usize,
}

impl<'c> Contours<'c> {
    /// No side of no face.
    pub(super) fn new(sides: &'c mut [Side]) -> Self {
        Self { sides, used: 0, end: 0 }
    }

    /// The sides that are left.
    pub(super) fn sides(&self) -> &[Side] {
        self.sides.get(..self.used).unwrap_or_default()
    }

    /// Adds the sides of the next face; `false` where there may be no room for them, and nothing was added.
    pub(super) fn add(&mut self, sides: [Side; 3]) -> bool {
        if self.sides.len() - self.used < sides.len() {
            return false;
        }
        for side in sides {
            self.add_side(side);
        }
        true
    }

    fn add_side(&mut self, [from, to]: Side) {
        let used = self.sides.get_mut(..self.used).unwrap_or_default();
        // The partner is most often one of the last sides.
        let partner = used.iter().rposition(|side| *side == [to, from]);
        match (partner, used.last().copied()) {
            (Some(partner), Some(last)) => {
                if let Some(slot) = used.get_mut(partner) {
                    *slot = last;
                }
                self.used -= 1;
            }
            _ => {
                if let Some(slot) = self.sides.get_mut(self.used) {
                    *slot = [from, to];
                    self.used += 1;
                }
            }
        }
    }
}
