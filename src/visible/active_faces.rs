//! The active list: the faces that cross the current row, in any order, or in that of their columns.
//!
//! In a row in which no span overlaps another, nothing has to be compared: such a row is filled without depths, and the
//! picture is the same. The rows of a frame begin so, with the faces in the order of columns, where one comparison a span
//! tells. Where a span overlaps the one before it, the faces are entered once more with their depth planes.
//!
//! Faces whose attributes are divided by the depth have their planes anyway and are in no order. A row that a few of them cross
//! is drawn without depths where no two of their spans overlap, which is found by comparing each with each.
//!
//! With depths the faces lie in the first slots, one after the other, in any order: where a fragment is as near as the
//! one that is there, which is seldom, the faces drawn so far tell which of them comes first in the order of the models.

use crate::{
    clip::convex::CutAttributes,
    shade::{Planes, Shading},
    surface::{BandColor, Order},
    view::{DepthWidth, ScreenPrecision},
    visible::{
        DepthRow,
        active_face::{ActiveFace, NOTHING, Surroundings, WordOf},
        attribute_planes::set_up_attributes,
        count::Count,
        face_table::{ColoredFace, FaceTable, NONE, corners_from_top, covers, set_up_rest},
        passes::{self, Passes},
        shaded_span::{is_seen, may_be_untested, shaded_row, span_around, word_at},
        sides::Sides,
        silhouette_pixels::{InSlots, mix_silhouettes},
        silhouette_row::RowEdges,
    },
};

/// When a row needs its depths.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(crate) enum DepthUse {
    /// Always, because something else will be compared with the depths.
    Always,
    /// Only where faces may hide one another.
    WhereFacesMayOverlap,
}

/// How often the faces of a frame are entered in the order of columns: thin spans may change places without overlapping.
const ATTEMPTS: u8 = 3;

/// Frames that are drawn with depths after one whose spans overlapped: the next ones are much the same.
const BACK_OFF_FRAMES: u8 = 16;

/// Faces whose attributes are divided by the depth and that are compared with each other in a row, at most: of more some
/// overlap, as a rule.
pub(crate) const FEW: usize = 4;

/// The active list. `F` are its slots, an array of [`ActiveFace`]s or, where they are used, a slice of any length: as many
/// faces can cross a row. A row with more is drawn in [passes](Passes).
#[derive(Debug)]
pub struct ActiveFaces<F: ?Sized> {
    /// All slots that are in use, or have been, lie before this one.
    pub(super) used: u16,
    /// Head of the list of free slots, which ends at the first slot that was never used.
    pub(super) free: u16,
    /// Head of the list of faces in the order of columns.
    pub(super) first: u16,
    /// The row that comes next if rows are drawn in order, and the column with which they begin: edges and planes count
    /// from there.
    pub(super) next_row: i32,
    pub(super) first_column: i32,
    /// Rows drawn without depths since the last restart.
    rows_without_depth: u32,
    /// Whether no span has overlapped another since the list was entered: it is in the order of columns, without planes.
    pub(super) disjoint: bool,
    /// How often the faces may still be entered in the order of columns.
    attempts_left: u8,
    /// Frames until the order of columns is tried again.
    back_off_frames: u8,
    pub(super) passes: Passes,
    pub(super) slots: F,
}

#[cfg(feature = "defmt")]
impl<F: ?Sized> defmt::Format for ActiveFaces<F> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "ActiveFaces, {} in use", self.used);
    }
}

/// An active list with any number of slots.
pub type ActiveList<S, H> = ActiveFaces<[ActiveFace<S, H>]>;

impl<S: ScreenPrecision, H: Shading, const N: usize> ActiveFaces<[ActiveFace<S, H>; N]> {
    pub(crate) const EMPTY: Self = Self {
        used: 0,
        free: 0,
        first: 0,
        next_row: 0,
        first_column: 0,
        rows_without_depth: 0,
        disjoint: false,
        attempts_left: 0,
        back_off_frames: 0,
        passes: Passes::NONE,
        slots: [ActiveFace::EMPTY; N],
    };
}

impl<S: ScreenPrecision, H: Shading> ActiveList<S, H> {
    /// Whether rows may be filled without depths. Where attributes are divided by the depth, faces need their planes anyway.
    const MAY_BE_DISJOINT: bool = !H::Attributes::NEED_DEPTH;

    /// The faces that there is room for in one row.
    pub(crate) const fn capacity(&self) -> usize {
        self.slots.len()
    }

    /// Forgets everything: the next row starts from its faces.
    pub(crate) fn restart(&mut self) {
        self.next_row = i32::MIN;
        self.rows_without_depth = 0;
        self.attempts_left = if self.back_off_frames == 0 { ATTEMPTS } else { 0 };
        self.back_off_frames = self.back_off_frames.saturating_sub(1);
    }

    /// Has no row: the next one is begun with all faces anew.
    pub(crate) const fn leave_rows(&mut self) {
        self.next_row = i32::MIN;
    }

    /// Whether the row that was drawn last had no depths.
    pub(crate) const fn is_disjoint(&self) -> bool {
        self.disjoint
    }

    pub(crate) const fn rows_without_depth(&self) -> u32 {
        self.rows_without_depth
    }

    /// Counts a row that was drawn without depths, modulo 2^32.
    #[inline]
    fn count_row_without_depth(&mut self) {
        self.rows_without_depth = self.rows_without_depth.wrapping_add(1);
    }

    /// Draws all faces of a row.
    #[inline(never)]
    pub(crate) fn draw_row<'e, F, O, D>(
        &mut self,
        faces: &F,
        row: &mut DepthRow<'_, H::Color, O, D>,
        depth_use: DepthUse,
        mut edges: impl RowEdges<'e, WordOf<H>, D>,
    ) where
        F: FaceTable<S, D, H>,
        O: Order,
        D: DepthWidth,
    {
        // Nothing but the faces is compared with the depths: a row without faces and silhouettes needs none.
        let only_faces = depth_use == DepthUse::WhereFacesMayOverlap;
        let may_be_disjoint = only_faces && Self::MAY_BE_DISJOINT && !steps_at_end::<_, _, _, F>();
        if !self.is_at(row) || (self.disjoint && !may_be_disjoint) {
            self.first_column = row.left;
            self.enter(faces, row.y, may_be_disjoint);
        } else {
            let first = faces.first_in_row(row.y);
            if first != NONE {
                self.begin_faces(faces, first, self.disjoint);
            }
        }
        self.next_row = row.y + 1;
        // A fragment is nearer than a cleared depth, always: without a second one for its pixel no test can fail.
        while Self::MAY_BE_DISJOINT && self.disjoint {
            if self.fill_spans(faces, row) {
                self.count_row_without_depth();
                return;
            }
            if self.attempts_left == 0 {
                self.back_off_frames = BACK_OFF_FRAMES;
            }
            // The pixels that were filled are drawn again.
            self.enter(faces, row.y, true);
        }
        self.close_gaps();
        if only_faces && self.used == 0 && edges.columns().is_none_or(|edges| edges.is_untouched()) {
            self.count_row_without_depth();
            return;
        }
        if may_be_untested::<_, _, _, F>() && only_faces && self.are_few_and_apart() {
            row.is_tested = false;
            self.count_row_without_depth();
        } else {
            row.clear_depths();
        }
        if F::DRAWS_IN_PASSES {
            self.draw_pass(faces, row);
        } else {
            self.draw_all_spans(faces, row);
        }
        // The constant first: for other looks the compiler does not even begin with what follows.
        if F::ANTIALIASES {
            if let Some(edges) = edges.columns() {
                mix_silhouettes(faces, row, edges, &InSlots(self.in_use()));
            }
        }
        if H::BLENDS {
            self.blend_row(faces, row);
        } else if F::ANTIALIASES {
            self.take_all_down(row.y);
        }
    }

    /// Whether at most [`FEW`] faces cross the row, and no span of one has a column in common with that of another.
    #[inline(never)]
    fn are_few_and_apart(&self) -> bool {
        let mut faces = self.in_use();
        if faces.len() > FEW {
            return false;
        }
        while let [face, others @ ..] = faces {
            let [start, end] = face.span();
            let overlaps = |other: &ActiveFace<S, H>| {
                let [other_start, other_end] = other.span();
                start < other_end && other_start < end
            };
            if others.iter().any(overlaps) {
                return false;
            }
            faces = others;
        }
        true
    }

    /// Whether a row is the one that comes next.
    #[inline]
    pub(crate) fn is_at<C: BandColor, O: Order, D: DepthWidth>(&self, row: &DepthRow<'_, C, O, D>) -> bool {
        self.next_row == row.y && self.first_column == row.left
    }

    /// The faces of all slots in use, one after the other.
    pub(super) fn in_use(&self) -> &[ActiveFace<S, H>] {
        self.slots.get(..usize::from(self.used)).unwrap_or_default()
    }

    /// The faces in the order of columns, while they are [disjoint](Self::is_disjoint).
    pub(super) fn in_order(&self) -> impl Iterator<Item = &ActiveFace<S, H>> {
        let mut slot = self.first;
        core::iter::from_fn(move || {
            let face = self.slots.get(usize::from(slot))?;
            slot = face.next();
            Some(face)
        })
    }

    /// Takes all faces to the row below a row, and gives the slots of those free that have ended.
    #[inline(never)]
    pub(super) fn take_all_down(&mut self, row: i32) {
        // What the loop changes is in a variable and not in `self`, which would take a register.
        let (used, mut free) = (self.used, self.free);
        let mut active = self.slots.get_mut(..usize::from(used)).unwrap_or_default();
        while let [face, others @ ..] = active {
            face.next_span();
            if !face.leave_row(row) {
                face.set_next_free(free);
                free = used - others.len() as u16 - 1;
            }
            active = others;
        }
        self.free = free;
    }

    /// Draws the spans of a row with depths, out of line: passes draw them too.
    #[inline(never)]
    pub(super) fn draw_pass<O, D>(&mut self, faces: &impl FaceTable<S, D, H>, row: &mut DepthRow<'_, H::Color, O, D>)
    where
        O: Order,
        D: DepthWidth,
    {
        self.draw_all_spans(faces, row);
    }

    /// Draws the spans of a row with depths. Takes each face to the next row, and gives the slots of those free that have
    /// ended, unless the faces are needed once more.
    #[inline(always)]
    fn draw_all_spans<O, D>(&mut self, faces: &impl FaceTable<S, D, H>, row: &mut DepthRow<'_, H::Color, O, D>)
    where
        O: Order,
        D: DepthWidth,
    {
        let mut first_slot = 0;
        while let Some(tie) = self.draw_spans(faces, first_slot, row) {
            self.draw_tied_span(faces, row, &tie);
            first_slot = tie.index + 1;
        }
    }

    /// Moves the last faces to where others have ended, so that the faces lie one after the other.
    #[inline]
    pub(super) fn close_gaps(&mut self) {
        let end = self.used;
        if self.free == end {
            return;
        }
        // Faces end in the order of slots, so the head of the free list is the last gap.
        while self.free != end {
            self.free = self.drop_last_into(self.free);
        }
        self.free = self.used;
    }

    /// Moves the last face into a free slot. Returns the next free slot.
    fn drop_last_into(&mut self, slot: u16) -> u16 {
        self.used -= 1;
        let Some((faces, [last, ..])) = self.slots.split_at_mut_checked(usize::from(self.used)) else {
            return self.used;
        };
        let Some(gap) = faces.get_mut(usize::from(slot)) else {
            return last.next_free();
        };
        let next = gap.next_free();
        last.move_to(gap);
        next
    }

    /// Draws the spans of a row with depths from a slot on, up to a tie. Takes each face to the next row, and gives the
    /// slots of those free that have ended.
    #[inline]
    fn draw_spans<F, O, D>(&mut self, faces: &F, first_slot: u16, row: &mut DepthRow<'_, H::Color, O, D>) -> Option<Tie>
    where
        F: FaceTable<S, D, H>,
        O: Order,
        D: DepthWidth,
    {
        let y = row.y;
        // What the loop changes is in variables and not in `self`, which would take a register.
        let (used, mut free) = (self.used, self.free);
        let mut active = self.slots.get_mut(usize::from(first_slot)..usize::from(used))?;
        let mut tie = None;
        while let [face, others @ ..] = active {
            // Counted where it is needed, from what is left: that is seldom.
            let index = || used - others.len() as u16 - 1;
            let steps_at_end = steps_at_end::<_, _, _, F>();
            let [start, end] = if steps_at_end { face.span() } else { face.next_span() };
            let left_over = if face.is_translucent() {
                None
            } else if H::Attributes::VARY {
                if start < end {
                    shaded_row(faces, row).draw_span(face, [start, end])
                } else {
                    None
                }
            } else {
                faces.count().tested(pixels_within(row.words.len(), start, end));
                row.draw_span(face, [start, end])
            };
            if let Some(left_over) = left_over {
                tie = Some(Tie {
                    index: index(),
                    left_over,
                });
                break;
            }
            if !steps_at_end && !face.leave_row(y) {
                face.set_next_free(free);
                free = index();
            }
            active = others;
        }
        self.free = free;
        tie
    }

    /// Draws the rest of a span, from a column where it is as near as a face that was drawn before it, and takes its face
    /// to the next row, as [`draw_spans`](Self::draw_spans) does the others.
    #[cold]
    #[inline(never)]
    fn draw_tied_span<F, O, D>(&mut self, faces: &F, row: &mut DepthRow<'_, H::Color, O, D>, tie: &Tie)
    where
        F: FaceTable<S, D, H>,
        O: Order,
        D: DepthWidth,
    {
        let Some((drawn, [face, ..])) = self.slots.split_at_mut_checked(usize::from(tie.index)) else {
            return;
        };
        let order = faces.order(face.node);
        let y = row.y;
        // The edges may have been taken to the next row already.
        let is_covered = |column: i32| covers(faces, face.node, column + self.first_column, y);
        let mut end = row.words.len() as i32;
        while end > 0 && !is_covered(end - 1) {
            end -= 1;
        }
        let span = if H::Attributes::VARY {
            span_around(&is_covered, end)
        } else {
            [end; 2]
        };
        for column in end - tie.left_over as i32..end {
            let depth = D::from_interpolated(face.plane.at(column, y).0);
            let is_tied = |other: &&ActiveFace<S, H>| D::from_interpolated(other.plane.at(column, y).0) == depth;
            let in_picture = [column + self.first_column, y];
            let word = if H::Attributes::VARY {
                word_at(faces, face, span, in_picture, self.first_column)
            } else {
                Some(face.word)
            };
            let Some(word) = word else { continue };
            row.draw_pixel(column, word, depth, || {
                if F::DRAWS_IN_PASSES && self.passes.are_needed {
                    passes::comes_first_of_all(faces, face, self.first_column, in_picture)
                } else {
                    comes_first(
                        drawn.iter().filter(is_tied),
                        faces,
                        order,
                        in_picture,
                        self.first_column,
                    )
                }
            });
        }
        if !steps_at_end::<_, _, _, F>() && !face.leave_row_seldom(y) {
            face.set_next_free(self.free);
            self.free = tie.index;
        }
    }

    /// Draws the spans of a row without depths, as long as they are in the order of columns and none overlaps another.
    /// Otherwise returns `false`: only some spans are drawn, and the faces must be entered again. Steps each face to
    /// the next row, and drops those that have ended.
    // Not inlined: the other loop needs every register.
    #[inline(never)]
    pub(super) fn fill_spans<O, D>(
        &mut self,
        faces: &impl FaceTable<S, D, H>,
        row: &mut DepthRow<'_, H::Color, O, D>,
    ) -> bool
    where
        O: Order,
        D: DepthWidth,
    {
        let y = row.y;
        let mut free_from = i32::MIN;
        let mut previous = NONE;
        let mut current = self.first;
        while let Some(face) = self.slots.get_mut(usize::from(current)) {
            let [start, end] = face.next_span();
            // As unsigned numbers first: where that holds, the span begins in the row.
            let begins_inside = (start as usize) < end as usize;
            if begins_inside || start < end {
                if start < free_from {
                    return false;
                }
                free_from = end;
                if H::Attributes::VARY {
                    shaded_row(faces, row).fill_span(face, [start, end]);
                } else if begins_inside {
                    row.fill_span(start, end, face.word);
                } else {
                    row.fill_cut_span(start, end, O::reorder(face.word));
                }
                faces.count().filled(pixels_within(row.words.len(), start, end));
            }
            (previous, current) = self.take_down(y, previous, current);
        }
        true
    }

    /// Steps a face to the row below a row, or drops it if it has ended. Returns the slots of the face before the next one and
    /// of the next one.
    #[inline]
    fn take_down(&mut self, row: i32, previous: u16, current: u16) -> (u16, u16) {
        let Some(face) = self.slots.get_mut(usize::from(current)) else {
            return (previous, NONE);
        };
        let next = face.next();
        if face.leave_row(row) {
            return (current, next);
        }
        face.set_next_free(self.free);
        self.free = current;
        self.link(previous, next);
        (previous, next)
    }

    /// Empties the list and enters the faces that cross a row: in the order of columns, if they may be disjoint and
    /// attempts are left.
    #[cold]
    #[inline(never)]
    pub(super) fn enter<D: DepthWidth>(&mut self, faces: &impl FaceTable<S, D, H>, row: i32, may_be_disjoint: bool) {
        self.used = 0;
        self.free = 0;
        self.first = NONE;
        self.disjoint = may_be_disjoint && self.attempts_left > 0;
        if self.disjoint {
            self.attempts_left -= 1;
        }
        for earlier in faces.viewport().top..row + 1 {
            let first = self.used;
            self.begin_faces(faces, faces.first_in_row(earlier), false);
            self.enter_begun(faces, first, row);
        }
        if Self::MAY_BE_DISJOINT && self.disjoint {
            let mut near = NONE;
            for slot in 0..self.used {
                self.put_in_order_of_columns(slot, near);
                near = slot;
            }
        }
    }

    /// Empties the list and enters the faces that cross a row in the order of columns, however often that was done in the frame.
    pub(super) fn enter_in_order<D: DepthWidth>(&mut self, faces: &impl FaceTable<S, D, H>, row: i32) {
        let attempts = self.attempts_left;
        self.attempts_left = 1;
        self.enter(faces, row, true);
        self.attempts_left = attempts;
    }

    /// Takes the faces from a slot on to a row, and drops those that end above it.
    pub(super) fn enter_begun<D: DepthWidth>(&mut self, faces: &impl FaceTable<S, D, H>, first: u16, row: i32) {
        let first_column = self.first_column;
        let mut slot = first;
        while slot < self.used {
            let Some(face) = self.slots.get_mut(usize::from(slot)) else {
                return;
            };
            let corners = corners_from_top(faces, face.node);
            if corners.is_some_and(|corners| face.enter(&Sides::of(corners, first_column), row)) {
                slot += 1;
            } else {
                self.drop_last_into(slot);
            }
        }
        self.free = self.used;
    }

    /// Sets up the faces that begin in a row, from the first of their nodes on, as they are in it, and puts them into the order
    /// of columns.
    #[inline(never)]
    pub(super) fn begin_faces<D: DepthWidth>(&mut self, faces: &impl FaceTable<S, D, H>, first: u16, in_order: bool) {
        let mut waiting = first;
        let surroundings = Surroundings {
            viewport: faces.viewport(),
            first_column: self.first_column,
            without_plane: self.disjoint,
            sample: (),
        };
        let mut near = NONE;
        loop {
            let face = match faces.face_of_first_model(waiting) {
                // No face has that number.
                None if waiting == NONE => return,
                // Taken apart, so that the corners of all other faces stay in registers.
                None => faces.other_face(waiting).map(|([a, b, c], word)| ([a, b, c], word)),
                face => face,
            };
            let begun = face.and_then(|face| self.begin_face(faces, waiting, face, &surroundings));
            if Self::MAY_BE_DISJOINT && in_order {
                if let Some(begun) = begun {
                    self.put_in_order_of_columns(begun, near);
                    near = begun;
                }
            }
            waiting = faces.next(waiting);
        }
    }

    /// Puts a face where it belongs in the order of columns: right of the face in the slot `near`, if that is no farther right,
    /// as often the one before it in a mesh is.
    #[inline(never)]
    fn put_in_order_of_columns(&mut self, begun: u16, near: u16) {
        let Some(middle) = self.slots.get(usize::from(begun)).map(ActiveFace::middle) else {
            return;
        };
        let (mut previous, mut current) = (NONE, self.first);
        if let Some(face) = self.slots.get(usize::from(near)) {
            if face.middle() <= middle {
                (previous, current) = (near, face.next());
            }
        }
        while let Some(face) = self.slots.get(usize::from(current)) {
            if face.middle() > middle {
                break;
            }
            previous = current;
            current = face.next();
        }
        self.link(begun, current);
        self.link(previous, begun);
    }

    /// Sets a face up in a free slot, as it is in its first row.
    #[inline(always)]
    pub(super) fn begin<D: DepthWidth>(
        &mut self,
        faces: &impl FaceTable<S, D, H>,
        node: u16,
        surroundings: &Surroundings<'_>,
    ) -> Option<u16> {
        let face = faces.face(node)?;
        self.begin_face(faces, node, face, surroundings)
    }

    /// Sets a face with these corners and this colour up in a free slot, as it is in its first row.
    // In the rows of frames that fit it has one caller: out of line it would take 1.5 % of the instructions of a torus and a
    // cube.
    #[inline(always)]
    fn begin_face<D: DepthWidth>(
        &mut self,
        faces: &impl FaceTable<S, D, H>,
        node: u16,
        ([a, b, c], word): ColoredFace<'_, S, D, H>,
        surroundings: &Surroundings<'_>,
    ) -> Option<u16> {
        let index = self.free;
        // Preparing counted the active faces, so there is a slot.
        let face = self.slots.get_mut(usize::from(index))?;
        if index == self.used {
            self.used = index + 1;
            self.free = self.used;
        } else {
            self.free = face.next_free();
        }
        face.node = node;
        face.word = word;
        let left_over = if H::Attributes::VARY {
            set_up_attributes(face, faces, [a, b, c], surroundings, ActiveFace::set_up_small_edges)
        } else {
            face.set_up_small(a, b, c, surroundings)
        };
        if left_over != NOTHING {
            set_up_rest(face, faces, left_over, surroundings);
        }
        face.set_translucent(faces.is_translucent(node));
        Some(index)
    }

    fn link(&mut self, previous: u16, next: u16) {
        match self.slots.get_mut(usize::from(previous)) {
            Some(face) => face.set_next(next),
            None => self.first = next,
        }
    }
}

/// Whether the faces of a row are needed once more when its opaque spans are drawn, and taken to the next row after that.
const fn steps_at_end<S: ScreenPrecision, D: DepthWidth, H: Shading, F: FaceTable<S, D, H>>() -> bool {
    H::BLENDS || F::ANTIALIASES
}

/// How many pixels of a span lie in a row of so many.
#[inline(always)]
pub(super) fn pixels_within(row: usize, start: i32, end: i32) -> usize {
    let (start, end) = (start.max(0), end.min(row as i32));
    if start < end { (end - start) as usize } else { 0 }
}

/// The rest of a span, from a pixel at which its depth equals the stored one.
#[derive(Debug)]
struct Tie {
    /// The slot of the face that has the span.
    index: u16,
    /// Pixels of the row up to the end of the span.
    left_over: usize,
}

/// Whether a face comes before all faces of `drawn` that are seen at a pixel, in the order of models and faces.
fn comes_first<'f, S: ScreenPrecision + 'f, D: DepthWidth, H: Shading>(
    mut drawn: impl Iterator<Item = &'f ActiveFace<S, H>>,
    faces: &impl FaceTable<S, D, H>,
    order: u16,
    at: [i32; 2],
    first_column: i32,
) -> bool {
    !drawn.any(|face| faces.order(face.node) <= order && is_seen(faces, face, at, first_column))
}

#[cfg(test)]
mod tests {
    use embedded_graphics::pixelcolor::Rgb565;

    use super::*;
    use crate::geometry::Sub4;

    /// A frame that is prepared once and drawn for days.
    #[test]
    fn rows_are_counted_beyond_the_greatest_number() {
        let mut list = ActiveFaces::<[ActiveFace<Sub4, Rgb565>; 0]>::EMPTY;
        let list: &mut ActiveList<Sub4, Rgb565> = &mut list;
        list.rows_without_depth = u32::MAX;
        list.count_row_without_depth();
        assert_eq!(list.rows_without_depth(), 0);
        list.passes.rows = u32::MAX;
        list.passes.count_row();
        assert_eq!(list.rows_in_passes(), 0);
    }
}
