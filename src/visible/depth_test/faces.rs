//! Draws the faces of a scene into a row that another one was drawn into, by a state of the depth test: in the order of models
//! and faces, because the order shows where depths are not written, or where not only the nearest is drawn.

use embedded_graphics::geometry::Point;

use crate::{
    scan::polygon::edge_table::shell_sort,
    shade::{Planes, Run, Shading},
    surface::{BandColor, Order},
    view::{DepthWidth, ScreenPrecision},
    visible::{
        DepthRow,
        active_face::ActiveFace,
        active_faces::ActiveList,
        count::Count,
        depth_test::state::{DepthState, DepthTest, Test, slope_of_face},
        divided_runs::DividedRuns,
        face_table::{FaceTable, NONE, corners_from_top},
        passes::{Passes, face_in_first_row, surroundings},
        shaded_span::are_even,
        sides::Sides,
    },
};

/// Faces that are drawn after one look at all faces of a table, where more of them cross a row than there are slots for.
const BATCH: usize = 16;

impl<S: ScreenPrecision, H: Shading> ActiveList<S, H> {
    /// Draws all faces of a table into a row, in the order of models and faces. Goes on from row to row as the rows of a frame
    /// do.
    pub(crate) fn draw_row_by_state<F, O, D>(
        &mut self,
        faces: &F,
        row: &mut DepthRow<'_, H::Color, O, D>,
        state: &DepthState<D>,
    ) where
        F: FaceTable<S, D, H>,
        O: Order,
        D: DepthWidth,
    {
        let Some(mut row) = row.within(faces.viewport()) else {
            return;
        };
        faces.count().row();
        let mut tested = TestedRow {
            faces,
            row: &mut row,
            state,
            test: DepthTest::new(state, 0),
        };
        if F::DRAWS_IN_PASSES && self.needs_passes() {
            if self.passes.crossing(faces, tested.row.y) > self.capacity() {
                self.passes.count_row();
                tested.draw_all_of_table();
                return;
            }
            self.begin_passes(faces, tested.row.start());
        } else {
            self.go_to_row(faces, tested.row.start());
        }
        let active = self.slots.get_mut(..usize::from(self.used)).unwrap_or_default();
        shell_sort(active, |face| place(faces, face.node));
        for face in active {
            tested.draw_face(face);
        }
        self.take_all_down(tested.row.y);
    }

    /// Brings the list to a row, from a column on, with depth planes.
    fn go_to_row<D: DepthWidth>(&mut self, faces: &impl FaceTable<S, D, H>, [left, row]: [i32; 2]) {
        let follows = self.next_row == row && self.first_column == left && !self.disjoint;
        if follows {
            self.begin_faces(faces, faces.first_in_row(row), false);
        } else {
            self.first_column = left;
            self.enter(faces, row, false);
        }
        self.next_row = row + 1;
        self.close_gaps();
    }
}

/// The place of a node in the order in which faces are drawn: that of models and faces, the parts of a face as they are stored.
fn place<S: ScreenPrecision, D: DepthWidth, H: Shading>(faces: &impl FaceTable<S, D, H>, node: u16) -> u32 {
    u32::from(faces.order(node)) << 16 | u32::from(node)
}

/// A row in which faces of a table are tested against the depths that are there.
struct TestedRow<'r, 'a, F, C: BandColor, O: Order, D: DepthWidth> {
    faces: &'r F,
    row: &'r mut DepthRow<'a, C, O, D>,
    state: &'r DepthState<D>,
    /// The test of what has no slope.
    test: DepthTest,
}

impl<F, C: BandColor, O: Order, D: DepthWidth> TestedRow<'_, '_, F, C, O, D> {
    /// Draws the faces that cross the row, which are in no slots: the first ones of those that are left, as many as a batch
    /// holds, after each look at all of them.
    #[cold]
    #[inline(never)]
    fn draw_all_of_table<S: ScreenPrecision, H: Shading<Color = C>>(&mut self)
    where
        F: FaceTable<S, D, H>,
    {
        let at = self.row.start();
        let mut from = 0;
        loop {
            let batch = next_places(self.faces, at, from);
            for place in batch {
                if place == u32::MAX {
                    return;
                }
                self.draw_node(place as u16);
                from = place + 1;
            }
        }
    }

    fn draw_node<S: ScreenPrecision, H: Shading<Color = C>>(&mut self, node: u16)
    where
        F: FaceTable<S, D, H>,
    {
        let [left, row] = self.row.start();
        let Some(corners) = corners_from_top(self.faces, node) else {
            return;
        };
        if let Some(mut face) = face_in_first_row(self.faces, node, &surroundings(self.faces, left)) {
            if face.enter(&Sides::of(corners, left), row) {
                self.draw_face(&face);
            }
        }
    }

    /// Draws the span of a face.
    #[inline(never)]
    fn draw_face<S: ScreenPrecision, H: Shading<Color = C>>(&mut self, face: &ActiveFace<S, H>)
    where
        F: FaceTable<S, D, H>,
    {
        let (span, row) = (face.span(), self.row.y);
        let (mut column, last) = (span[0].max(0), span[1].min(self.row.words.len() as i32));
        if column >= last {
            return;
        }
        self.faces.count().tested((last - column) as usize);
        let Some(skin) = self.faces.skin(face.node).copied() else {
            return;
        };
        let test = self.test_of(face);
        let is_divided = !are_even::<S, D, H, F>(face);
        let mut runs = None;
        if is_divided {
            runs = Some(DividedRuns::new::<S, D, H>(face, span, [column, row], self.row.left));
        }
        while column < last {
            let run = match &mut runs {
                Some(runs) => runs.next_run(column),
                None => H::Attributes::even_run(&face.attributes, column, last, row),
            };
            self.faces.count().divisions(u32::from(is_divided));
            let end = run.end.min(last);
            self.draw_run(face, &skin, &test, [column, end], run);
            column = end;
        }
    }

    /// Draws pixels along which the attributes of a face step evenly.
    #[inline(always)]
    fn draw_run<S: ScreenPrecision, H: Shading<Color = C>>(
        &mut self,
        face: &ActiveFace<S, H>,
        skin: &F::Skin,
        test: &DepthTest,
        [column, end]: [i32; 2],
        run: Run<<H::Attributes as Planes>::Values>,
    ) where
        F: FaceTable<S, D, H>,
    {
        let DepthRow {
            y, left, words, depths, ..
        } = &mut *self.row;
        let range = column as usize..end as usize;
        let (Some(words), Some(depths)) = (words.get_mut(range.clone()), depths.get_mut(range)) else {
            return;
        };
        let (mut values, mut interpolated) = (run.values, face.plane.at(column, *y));
        for ((word, stored), x) in words.iter_mut().zip(depths).zip(column..) {
            let depth = test.depth(D::from_interpolated(interpolated.0));
            if test.passes(depth, *stored) {
                self.faces.count().fragment();
                if let Some(fragment) = F::fragment(skin, face.word, &values) {
                    *word = O::reorder(if face.is_translucent() {
                        self.faces.count().blended();
                        F::blend(skin, fragment, O::reorder(*word), Point::new(x + *left, *y))
                    } else {
                        fragment
                    });
                    if Test::<D>::writes(test) {
                        *stored = depth;
                    }
                }
            }
            H::Attributes::step(&mut values, &run.per_column);
            interpolated += face.plane.per_column;
        }
    }

    /// The test of a face.
    fn test_of<S: ScreenPrecision, H: Shading<Color = C>>(&self, face: &ActiveFace<S, H>) -> DepthTest
    where
        F: FaceTable<S, D, H>,
    {
        if self.state.offset.factor == 0 {
            return self.test;
        }
        let slope = corners_from_top(self.faces, face.node).map_or(0, slope_of_face);
        DepthTest::new(self.state, slope)
    }
}

/// The first places from one on of faces that cross a row, in ascending order, and the greatest number where no more are left.
fn next_places<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    [_, row]: [i32; 2],
    from: u32,
) -> [u32; BATCH] {
    let mut first = [u32::MAX; BATCH];
    let mut all = Passes::from_top(faces);
    while let Some(node) = all.next_crossing(faces, row) {
        let mut place = place(faces, node);
        debug_assert!(node != NONE, "the place of no node is the greatest number");
        if place < from {
            continue;
        }
        for kept in &mut first {
            if place < *kept {
                core::mem::swap(kept, &mut place);
            }
        }
    }
    first
}
