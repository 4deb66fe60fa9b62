//! How the active list draws a row that more faces cross than it has slots for.
//!
//! Guarantees: the picture is that of a list with room for all faces. Cost of a row that does not fit: a look at each face that
//! begins in it or above, and setting up those that cross it. Rows that fit go on from row to row, with depths always.

use crate::{
    shade::Shading,
    surface::Order,
    view::{DepthWidth, ScreenPrecision},
    visible::{
        DepthRow,
        active_face::WordOf,
        active_faces::ActiveList,
        blended_row::blend_faces,
        face_table::{FaceTable, NONE},
        passes::{Passes, for_each_crossing, surroundings},
        silhouette_pixels::{InSlots, InTable, mix_silhouettes},
        silhouette_row::RowEdges,
    },
};

impl<S: ScreenPrecision, H: Shading> ActiveList<S, H> {
    /// Begins a frame of which the fullest row has so many faces.
    pub(crate) fn restart_passes(&mut self, most_active: usize) {
        self.passes.restart(most_active > self.capacity());
    }

    /// Whether the frame has rows with more faces than there are slots.
    #[inline]
    pub(crate) const fn needs_passes(&self) -> bool {
        self.passes.are_needed
    }

    /// How many rows of the frame took more than one pass so far.
    pub(crate) const fn rows_in_passes(&self) -> u32 {
        self.passes.rows
    }

    /// Draws all faces of a row, in as many passes as they take.
    #[cold]
    #[inline(never)]
    pub(crate) fn draw_row_in_passes<'e, F, O, D>(
        &mut self,
        faces: &F,
        row: &mut DepthRow<'_, H::Color, O, D>,
        mut edges: impl RowEdges<'e, WordOf<H>, D>,
    ) where
        F: FaceTable<S, D, H>,
        O: Order,
        D: DepthWidth,
    {
        row.clear_depths();
        let mut is_left = self.begin_passes(faces, [row.left, row.y]);
        while is_left {
            self.draw_pass(faces, row);
            is_left = self.next_pass(faces, row.y);
        }
        let (at, is_whole) = ([row.left, row.y], self.next_row == row.y + 1);
        // The constant first: for other looks the compiler does not even begin with what follows.
        if F::ANTIALIASES {
            if let Some(edges) = edges.columns() {
                if is_whole {
                    mix_silhouettes(faces, row, edges, &InSlots(self.in_use()));
                } else {
                    mix_silhouettes(faces, row, edges, &InTable::new(faces, at));
                }
            }
        }
        if H::BLENDS && is_whole {
            self.blend_row(faces, row);
        } else if H::BLENDS {
            let is_translucent = |node| faces.is_translucent(node);
            blend_faces(faces, row, &|visit| {
                for_each_crossing(faces, at, &is_translucent, visit)
            });
        } else if is_whole && edges.columns().is_some() {
            self.take_all_down(row.y);
        }
    }

    /// Brings the list to a row, from a column on, with the faces of its first pass. `false` where no face crosses the row.
    pub(super) fn begin_passes<D: DepthWidth>(
        &mut self,
        faces: &impl FaceTable<S, D, H>,
        [left, row]: [i32; 2],
    ) -> bool {
        let follows = self.next_row == row && self.first_column == left && !self.disjoint;
        let fits = self.passes.crossing(faces, row) <= self.capacity();
        self.next_row = if fits { row + 1 } else { i32::MIN };
        if follows && fits {
            self.passes.next = (row, NONE);
            self.begin_faces(faces, faces.first_in_row(row), false);
            self.close_gaps();
            return self.used > 0;
        }
        (self.first_column, self.disjoint) = (left, false);
        (self.used, self.free) = (0, 0);
        self.passes.next = Passes::from_top(faces).next;
        if !fits {
            self.passes.count_row();
        }
        self.next_pass(faces, row)
    }

    /// Enters as many of the faces that cross a row and have not been drawn as there are slots. Where none is left the list
    /// stays as it is, and the result is `false`.
    #[cold]
    #[inline(never)]
    pub(super) fn next_pass<D: DepthWidth>(&mut self, faces: &impl FaceTable<S, D, H>, row: i32) -> bool {
        let surroundings = surroundings(faces, self.first_column);
        let mut entered = false;
        while !entered || usize::from(self.used) < self.capacity() {
            let Some(node) = self.passes.next_crossing(faces, row) else {
                break;
            };
            if !entered {
                (self.used, self.free, entered) = (0, 0, true);
            }
            let slot = self.used;
            self.begin(faces, node, &surroundings);
            self.enter_begun(faces, slot, row);
        }
        entered
    }
}
