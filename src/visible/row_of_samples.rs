//! How the active list draws a row of pixels of which each has several samples: for each sample a row of its own, in which all
//! faces are seen from its position instead of from the centres of pixels.
//!
//! ```text
//!     +-------+-------+-------+     The samples 1 of all pixels lie in one line, and each is as far from its pixel's centre
//!     |   0   |   0   |   0   |     as the others: they are the centres of the pixels for faces that are moved the other way.
//!     | 2   1 | 2   1 | 2   1 |     So a row is drawn once a sample, one after the other, with the same depth row.
//!     +-------+-------+-------+
//! ```
//!
//! The faces that may cover samples of the row lie in slots, linked in the order of models and faces: of equally near
//! fragments the one that is drawn first is the one that stays. For each sample the span of a face is found by one division a
//! side, and its planes are set up, so that nothing but the list is kept from row to row.
//!
//! Guarantees: a sample is covered by the rule of the centre of a pixel, exactly, and has the depth that the face's plane has
//! there; so faces that share an edge share no sample and leave none out. Cost: setting up each face of a row for each sample.
//!
//! Source: multisampling (Akeley 1993), one sample after the other as in an accumulation buffer (Haeberli and Akeley 1990).

use crate::{
    shade::{Planes, Shading},
    surface::Order,
    view::{DepthWidth, Position, ScreenPrecision},
    visible::{
        DepthRow,
        active_face::{ActiveFace, NOTHING, Surroundings, from_top},
        active_faces::{ActiveList, pixels_within},
        attribute_planes::set_up_attributes,
        blended_row::blend_faces,
        count::Count,
        depth_plane::DepthPlane,
        edge::row_before,
        face_table::{FaceTable, NONE},
        shaded_span::{shaded_row, word_at},
        sides::{SamplePosition, Sides},
    },
};

impl<S: ScreenPrecision, H: Shading> ActiveList<S, H> {
    /// Brings the list to the faces that may cover samples of a row. `false` where there are none.
    #[inline(never)]
    pub(crate) fn begin_samples<O: Order, D: DepthWidth>(
        &mut self,
        faces: &impl FaceTable<S, D, H>,
        row: &DepthRow<'_, H::Color, O, D>,
    ) -> bool {
        let follows = self.is_at(row);
        (self.first_column, self.next_row) = (row.left, row.y + 1);
        if follows {
            self.drop_ended(row.y);
            self.link_faces_of(faces, row.y, row.y);
        } else {
            (self.used, self.free, self.first) = (0, 0, NONE);
            for earlier in faces.viewport().top..row.y + 1 {
                self.link_faces_of(faces, earlier, row.y);
            }
        }
        self.first != NONE
    }

    /// Gives the slots of those faces free that end above a row.
    fn drop_ended(&mut self, row: i32) {
        let (mut previous, mut current) = (NONE, self.first);
        while let Some(face) = self.slots.get_mut(usize::from(current)) {
            let (slot, next) = (current, face.next_free());
            current = next;
            if face.last_row() >= row {
                previous = slot;
                continue;
            }
            face.set_next_free(self.free);
            self.free = slot;
            self.link_after(previous, next);
        }
    }

    /// Links the faces of a bucket that may cover samples of a row.
    fn link_faces_of<D: DepthWidth>(&mut self, faces: &impl FaceTable<S, D, H>, bucket: i32, row: i32) {
        let mut waiting = faces.first_in_row(bucket);
        while waiting != NONE {
            self.link_face(faces, waiting, row);
            waiting = faces.next(waiting);
        }
    }

    fn link_face<D: DepthWidth>(&mut self, faces: &impl FaceTable<S, D, H>, node: u16, row: i32) {
        let Some(([a, b, c], word)) = faces.face(node) else {
            return;
        };
        let lowest = a.y_units().max(b.y_units()).max(c.y_units());
        // Samples are up to half a pixel above the centres.
        let last = row_before::<S>(lowest + (1 << S::FRACTION_BITS) / 2).min(faces.viewport().bottom - 1);
        if last < row {
            return;
        }
        let key = |node: u16| (faces.order(node), node);
        let (mut previous, mut next) = (NONE, self.first);
        while let Some(face) = self.slots.get(usize::from(next)) {
            if key(face.node) > key(node) {
                break;
            }
            (previous, next) = (next, face.next_free());
        }
        // Preparing counted the faces of each row, so there is a slot.
        let slot = self.free;
        let Some(face) = self.slots.get_mut(usize::from(slot)) else {
            return;
        };
        if slot == self.used {
            self.used = slot + 1;
            self.free = self.used;
        } else {
            self.free = face.next_free();
        }
        (face.node, face.word) = (node, word);
        face.end_after(last);
        face.set_translucent(faces.is_translucent(node));
        face.set_next_free(next);
        self.link_after(previous, slot);
    }

    fn link_after(&mut self, previous: u16, next: u16) {
        match self.slots.get_mut(usize::from(previous)) {
            Some(face) => face.set_next_free(next),
            None => self.first = next,
        }
    }

    /// Draws all faces of a row as they are seen from a sample of each pixel, so far right of and below the centre in units.
    /// Returns the columns outside of which nothing was drawn.
    #[inline(never)]
    pub(crate) fn draw_sample<F, O, D>(
        &mut self,
        faces: &F,
        row: &mut DepthRow<'_, H::Color, O, D>,
        sample: Position,
    ) -> [i32; 2]
    where
        F: FaceTable<S, D, H>,
        O: Order,
        D: DepthWidth,
    {
        row.clear_depths();
        let surroundings = Surroundings {
            viewport: faces.viewport(),
            first_column: self.first_column,
            without_plane: false,
            sample,
        };
        let (mut left, mut right) = (row.words.len() as i32, 0);
        let mut current = self.first;
        while let Some(face) = self.slots.get_mut(usize::from(current)) {
            current = face.next_free();
            set_up(face, faces, row.y, &surroundings);
            let [start, end] = face.span();
            if start < end {
                (left, right) = (left.min(start), right.max(end));
                if !face.is_translucent() {
                    draw_span(faces, row, face);
                }
            }
        }
        if H::BLENDS {
            blend_faces(faces, row, &|visit| {
                let mut current = self.first;
                while let Some(face) = self.slots.get(usize::from(current)) {
                    visit(face);
                    current = face.next_free();
                }
            });
        }
        [left.max(0), right.min(row.words.len() as i32)]
    }
}

/// Sets up the span of a face in a row, and what it is drawn with.
#[inline(always)]
fn set_up<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    face: &mut ActiveFace<S, H>,
    faces: &impl FaceTable<S, D, H>,
    row: i32,
    surroundings: &Surroundings<'_, Position>,
) {
    let Some((corners, _)) = faces.face(face.node) else {
        return;
    };
    let Surroundings {
        viewport,
        first_column,
        sample,
        ..
    } = *surroundings;
    let from_top = from_top(corners);
    let sides = sample.see(Sides::of(from_top, first_column));
    face.set_up_span(&sides, row);
    let [start, end] = face.span();
    if start >= end {
        return;
    }
    if H::Attributes::VARY {
        set_up_attributes(face, faces, corners, surroundings, |_, _| NOTHING);
        return;
    }
    face.plane = DepthPlane::small(from_top, &sides, false).unwrap_or_else(|| {
        let sides = sample.see(Sides::of(from_top, 0));
        DepthPlane::wide_at(from_top, &sides, viewport, first_column)
    });
}

/// Draws the pixels of a face's span that are nearer than the stored depths. Where both are equal, what was drawn before is the
/// face that comes first.
#[inline(always)]
fn draw_span<S: ScreenPrecision, O: Order, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    row: &mut DepthRow<'_, H::Color, O, D>,
    face: &ActiveFace<S, H>,
) {
    let [mut start, end] = face.span();
    if H::Attributes::VARY {
        if let Some(left_over) = shaded_row(faces, row).draw_span(face, [start, end]) {
            draw_rest(faces, row, face, left_over);
        }
        return;
    }
    faces.count().tested(pixels_within(row.words.len(), start, end));
    while let Some(left_over) = row.draw_span(face, [start, end]) {
        start = end.min(row.words.len() as i32) - left_over as i32 + 1;
    }
}

/// Draws the rest of a span whose attributes vary, of which the first pixel is as near as what was drawn there before.
#[cold]
#[inline(never)]
fn draw_rest<S: ScreenPrecision, O: Order, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    row: &mut DepthRow<'_, H::Color, O, D>,
    face: &ActiveFace<S, H>,
    left_over: usize,
) {
    let [start, end] = face.span();
    let last = end.min(row.words.len() as i32);
    let [left, y] = row.start();
    for column in last - left_over as i32 + 1..last {
        let depth = D::from_interpolated(face.plane.at(column, y).0);
        if row.depths.get(column as usize).is_some_and(|stored| depth > *stored) {
            if let Some(word) = word_at(faces, face, [start, end], [column + left, y], left) {
                row.draw_pixel(column, word, depth, || false);
            }
        }
    }
}
