//! The active list: the faces that cross the current row, in any order, or in that of their columns.
//!
//! In a row in which no span overlaps another, nothing has to be compared: such a row is filled without depths, and the
//! picture is the same. The rows of a frame begin so, with the faces in the order of columns, where one comparison a span
//! tells. Where a span overlaps the one before it, the faces are entered once more with their depth planes.
//!
//! With depths the order of the list does not matter: where a fragment is as near as the one that is there, which is
//! seldom, the faces drawn so far tell which of them comes first in the order of the models.

use core::ops::Range;

use crate::{
    geometry::Window,
    target::{BandColor, Order, PixelWord},
    view::{DepthWidth, Position, ScreenPrecision, ScreenVertex},
    visible::{
        DepthRow,
        active_face::{ActiveFace, Rows, Sides, from_top},
        depth_plane::DepthPlane,
        edge::Edge,
    },
};

/// No entry, no slot.
pub(crate) const NONE: u16 = u16::MAX;

/// The corners of a face, clockwise on the screen, and its colour.
pub(crate) type ColoredFace<'t, S, D, W> = ([&'t ScreenVertex<S, D>; 3], W);

/// The faces of a prepared frame, by the row in which they begin. Entries of one row come in ascending order.
pub(crate) trait FaceTable<S: ScreenPrecision, D: DepthWidth, W> {
    /// The pixels that the frame was prepared for.
    fn viewport(&self) -> &Window;
    /// First of the faces that begin in a row, or [`NONE`].
    fn first_in_row(&self, row: i32) -> u16;
    /// The face after an entry that begins in the same row, or [`NONE`].
    fn next(&self, entry: u16) -> u16;
    /// Place of an entry in the order of models and faces.
    fn order(&self, entry: u16) -> u16;
    /// An entry's face.
    fn face(&self, entry: u16) -> Option<ColoredFace<'_, S, D, W>>;
}

/// When a row needs its depths.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(crate) enum DepthUse {
    /// Something else will be compared with them.
    Always,
    /// Only where faces may hide one another.
    WhereFacesMayOverlap,
}

/// How often the faces of a frame are entered in the order of columns: thin spans may change places without overlapping.
const TRIES: u8 = 3;

/// Frames that are drawn with depths after one whose spans overlapped: the next ones are much the same.
const PAUSE: u8 = 16;

/// Room for `N` faces in one row.
#[derive(Debug)]
pub(crate) struct ActiveFaces<S: ScreenPrecision, W, const N: usize> {
    slots: [ActiveFace<S, W>; N],
    first: u16,
    free: u16,
    /// The row that comes next if rows are drawn in order.
    next_row: i32,
    /// Rows drawn without depths since the last restart.
    rows_without_depth: u32,
    /// Whether no span has overlapped another since the list was entered: it is in the order of columns, without planes.
    apart: bool,
    /// How often it may still be entered in that order.
    tries: u8,
    /// Frames until that is tried again.
    pause: u8,
}

impl<S: ScreenPrecision, W: PixelWord, const N: usize> ActiveFaces<S, W, N> {
    pub(crate) const EMPTY: Self = Self {
        slots: [ActiveFace::EMPTY; N],
        first: 0,
        free: 0,
        next_row: 0,
        rows_without_depth: 0,
        apart: false,
        tries: 0,
        pause: 0,
    };

    /// Forgets everything: the next row starts from its faces.
    pub(crate) fn restart(&mut self) {
        self.next_row = i32::MIN;
        self.rows_without_depth = 0;
        self.tries = if self.pause == 0 { TRIES } else { 0 };
        self.pause = self.pause.saturating_sub(1);
    }

    pub(crate) const fn rows_without_depth(&self) -> u32 {
        self.rows_without_depth
    }

    /// Draws all faces of a row.
    #[inline(never)]
    pub(crate) fn draw_row<C, O, D>(
        &mut self,
        faces: &impl FaceTable<S, D, W>,
        row: &mut DepthRow<'_, C, O, D>,
        depth_use: DepthUse,
    ) where
        C: BandColor<Word = W>,
        O: Order,
        D: DepthWidth,
    {
        let may_be_apart = depth_use == DepthUse::WhereFacesMayOverlap;
        if self.next_row != row.y || (self.apart && !may_be_apart) {
            self.enter(faces, row.y, may_be_apart);
        } else {
            self.begin_row(faces, row.y, row.y);
        }
        self.next_row = row.y.wrapping_add(1);
        // A fragment is nearer than a cleared depth, always: without a second one for its pixel no test can fail.
        while self.apart {
            if self.fill_spans(row) {
                self.rows_without_depth = self.rows_without_depth.wrapping_add(1);
                return;
            }
            if self.tries == 0 {
                self.pause = PAUSE;
            }
            // What was filled is drawn again.
            self.enter(faces, row.y, true);
        }
        if may_be_apart && self.first == NONE {
            self.rows_without_depth = self.rows_without_depth.wrapping_add(1);
            return;
        }
        row.clear_depths();
        self.draw_spans(faces, row);
    }

    /// Draws the spans of a row with depths. Takes each face to the next row, and drops those that have ended.
    #[inline(always)]
    fn draw_spans<C, O, D>(&mut self, faces: &impl FaceTable<S, D, W>, row: &mut DepthRow<'_, C, O, D>)
    where
        C: BandColor<Word = W>,
        O: Order,
        D: DepthWidth,
    {
        let next_row = row.y.wrapping_add(1);
        let free_before = self.free;
        let mut previous = NONE;
        let mut current = self.first;
        while let Some(face) = self.slots.get_mut(usize::from(current)) {
            let (start, end) = (face.left.column(), face.right.column());
            if let Some(tied) = row.draw_span(start, end, face.word, &face.plane) {
                self.draw_tied_span(faces, row, current, tied..end, free_before);
            }
            (previous, current) = self.step_down(next_row, previous, current);
        }
    }

    /// Draws the rest of a span, from a column where it is as near as a face that was drawn before it.
    #[cold]
    #[inline(never)]
    fn draw_tied_span<C, O, D>(
        &self,
        faces: &impl FaceTable<S, D, W>,
        row: &mut DepthRow<'_, C, O, D>,
        index: u16,
        columns: Range<i32>,
        free_before: u16,
    ) where
        C: BandColor<Word = W>,
        O: Order,
        D: DepthWidth,
    {
        let Some(face) = self.slots.get(usize::from(index)) else {
            return;
        };
        let order = faces.order(face.entry);
        let y = row.y;
        for column in columns {
            let depth = D::from_interpolated(face.plane.at(column, y));
            // Those that have ended in this row lie before the slots that were free.
            let comes_first = |chain, end| self.comes_first(faces, order, chain..end, [column, y], depth);
            row.draw_pixel(column, face.word, depth, || {
                comes_first(self.first, index) && comes_first(self.free, free_before)
            });
        }
    }

    /// Whether a face comes before those of a chain of slots, up to the slot `chain.end`, that have a pixel at that depth.
    #[inline(never)]
    fn comes_first<D: DepthWidth>(
        &self,
        faces: &impl FaceTable<S, D, W>,
        order: u16,
        chain: Range<u16>,
        [column, row]: [i32; 2],
        depth: D,
    ) -> bool {
        let mut current = chain.start;
        while let Some(face) = self.slots.get(usize::from(current)) {
            if current == chain.end {
                break;
            }
            let is_tied = D::from_interpolated(face.plane.at(column, row)) == depth;
            if is_tied && faces.order(face.entry) <= order && covers(faces, face.entry, column, row) {
                return false;
            }
            current = face.next;
        }
        true
    }

    /// Draws the spans of a row, if they are in the order of columns and none overlaps another. Otherwise some of them,
    /// and the list is worth nothing. Takes each face to the next row, and drops those that have ended.
    // Not inlined: the other loop needs every register.
    #[inline(never)]
    fn fill_spans<C, O, D>(&mut self, row: &mut DepthRow<'_, C, O, D>) -> bool
    where
        C: BandColor<Word = W>,
        O: Order,
        D: DepthWidth,
    {
        let next_row = row.y.wrapping_add(1);
        let mut free_from = i32::MIN;
        let mut previous = NONE;
        let mut current = self.first;
        while let Some(face) = self.slots.get_mut(usize::from(current)) {
            let (start, end) = (face.left.column(), face.right.column());
            if start < end {
                if start < free_from {
                    return false;
                }
                free_from = end;
                row.fill_span(start, end, face.word);
            }
            (previous, current) = self.step_down(next_row, previous, current);
        }
        true
    }

    /// Takes a face to the next row, or drops it if it has ended. Returns the one before the next one, and that.
    #[inline(always)]
    fn step_down(&mut self, next_row: i32, previous: u16, current: u16) -> (u16, u16) {
        let Some(face) = self.slots.get_mut(usize::from(current)) else {
            return (previous, NONE);
        };
        face.step_down();
        let next = face.next;
        if next_row != i32::from(face.turn) || face.take_turn() {
            return (current, next);
        }
        face.next = self.free;
        self.free = current;
        self.link(previous, next);
        (previous, next)
    }

    /// Forgets the list and enters the faces that cross a row, in the order of columns if they may be apart and that may
    /// still be tried.
    #[cold]
    #[inline(never)]
    fn enter<D: DepthWidth>(&mut self, faces: &impl FaceTable<S, D, W>, row: i32, may_be_apart: bool) {
        self.first = NONE;
        self.free = NONE;
        self.apart = may_be_apart && self.tries > 0;
        if self.apart {
            self.tries = self.tries.wrapping_sub(1);
        }
        for (index, slot) in self.slots.iter_mut().enumerate().rev() {
            slot.next = self.free;
            self.free = index as u16;
        }
        for earlier in faces.viewport().top..=row {
            self.begin_row(faces, earlier, row);
        }
    }

    /// Puts the faces that begin in a row into the list, as they are in row `y`.
    #[inline(never)]
    fn begin_row<D: DepthWidth>(&mut self, faces: &impl FaceTable<S, D, W>, begin: i32, y: i32) {
        let mut waiting = faces.first_in_row(begin);
        while waiting != NONE {
            if let Some(begun) = self.begin(faces, waiting, y) {
                if self.apart {
                    self.put_in_order_of_columns(begun);
                } else {
                    self.link(begun, self.first);
                    self.first = begun;
                }
            }
            waiting = faces.next(waiting);
        }
    }

    /// Puts a face where it belongs in the order of columns.
    #[inline(always)]
    fn put_in_order_of_columns(&mut self, begun: u16) {
        let middle = self.slots.get(usize::from(begun)).map(ActiveFace::middle);
        let mut previous = NONE;
        let mut current = self.first;
        let is_before = |face: &&ActiveFace<S, W>| Some(face.middle()) <= middle;
        while let Some(face) = self.slots.get(usize::from(current)).filter(is_before) {
            previous = current;
            current = face.next;
        }
        self.link(begun, current);
        self.link(previous, begun);
    }

    /// Sets a face up in a free slot. `None` where it ends above the row.
    #[inline(always)]
    fn begin<D: DepthWidth>(&mut self, faces: &impl FaceTable<S, D, W>, entry: u16, row: i32) -> Option<u16> {
        let (corners, word) = faces.face(entry)?;
        let index = self.free;
        // Preparing counted the active faces, so there is a slot.
        let face = self.slots.get_mut(usize::from(index))?;
        let corners = from_top(corners);
        let sides = Sides::of(corners);
        let rows = Rows::of::<S>(&sides);
        if row >= rows.bottom {
            return None;
        }
        self.free = face.next;
        face.entry = entry;
        face.word = word;
        if !self.apart {
            match DepthPlane::small(corners, &sides) {
                Some(plane) => face.plane = plane,
                None => set_up_wide_plane(face, faces),
            }
        }
        if !Edge::<S>::MAY_BE_SHORT {
            face.set_up_edges::<true>(&sides, &rows, row);
        } else if !face.set_up_short_edges(&sides, &rows, row) {
            set_up_long_edges(face, faces, row);
        }
        Some(index)
    }

    #[inline(always)]
    fn link(&mut self, previous: u16, next: u16) {
        match self.slots.get_mut(usize::from(previous)) {
            Some(face) => face.next = next,
            None => self.first = next,
        }
    }
}

/// The plane of a face that is not small.
// This and the next one look the face up once more: what is handed over has to be in memory, for the many small ones too.
#[cold]
#[inline(never)]
fn set_up_wide_plane<S: ScreenPrecision, D: DepthWidth, W>(
    face: &mut ActiveFace<S, W>,
    faces: &impl FaceTable<S, D, W>,
) {
    if let Some(corners) = corners_from_top(faces, face.entry) {
        face.plane = DepthPlane::wide(corners, faces.viewport());
    }
}

/// The edges of a face at a row, not all of them short.
#[cold]
#[inline(never)]
fn set_up_long_edges<S: ScreenPrecision, D: DepthWidth, W: Copy>(
    face: &mut ActiveFace<S, W>,
    faces: &impl FaceTable<S, D, W>,
    row: i32,
) {
    if let Some(corners) = corners_from_top(faces, face.entry) {
        let sides = Sides::of(corners);
        face.set_up_edges::<false>(&sides, &Rows::of::<S>(&sides), row);
    }
}

#[cold]
#[inline(never)]
fn corners_from_top<S: ScreenPrecision, D: DepthWidth, W>(
    faces: &impl FaceTable<S, D, W>,
    entry: u16,
) -> Option<[&ScreenVertex<S, D>; 3]> {
    faces.face(entry).map(|(corners, _)| from_top(corners))
}

/// Whether a face covers a pixel, by its corners: an edge that was walked is where it was no longer.
fn covers<S: ScreenPrecision, D: DepthWidth, W>(
    faces: &impl FaceTable<S, D, W>,
    entry: u16,
    column: i32,
    row: i32,
) -> bool {
    let Some([a, b, c]) = corners_from_top(faces, entry) else {
        return false;
    };
    let center = Position {
        x: column << S::FRACTION_BITS,
        y: row << S::FRACTION_BITS,
    };
    [(a, b), (b, c), (c, a)]
        .into_iter()
        .all(|(start, end)| is_right_of(center, start.position(), end.position()))
}

/// Whether a pixel centre is on the inner side of an edge of a face whose corners run clockwise, or on a top or left one.
fn is_right_of(center: Position, start: Position, end: Position) -> bool {
    let (width, height) = (end.x.wrapping_sub(start.x), end.y.wrapping_sub(start.y));
    let (x, y) = (center.x.wrapping_sub(start.x), center.y.wrapping_sub(start.y));
    // Differences below 2^24.
    let side = i64::from(width) * i64::from(y) - i64::from(height) * i64::from(x);
    let is_top_or_left = height < 0 || (height == 0 && width > 0);
    side > 0 || (side == 0 && is_top_or_left)
}
