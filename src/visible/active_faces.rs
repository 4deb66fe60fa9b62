//! The active list: the faces that cross the current row, in the order of the models, or in that of their columns.
//!
//! In a row in which no span overlaps another, nothing has to be compared: such a row is filled without depths, and the
//! picture is the same. The rows of a frame begin so, with the faces in the order of columns, where one comparison a span
//! tells. Where a span overlaps the one before it, the faces are entered once more with their depth planes.

use crate::{
    geometry::Window,
    target::{BandColor, Order, PixelWord},
    view::{DepthWidth, EdgeSum, Position, ScreenPrecision, ScreenVertex},
    visible::{
        DepthRow,
        depth_plane::DepthPlane,
        edge::{Edge, PixelAfter, Refill, Refills, row_after},
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

/// On which side of a face the edge between its two lower corners takes over.
// The first one has no bits set, as everything in an empty list.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
enum ThirdSide {
    /// It has already, or crosses no row.
    Neither,
    Left,
    Right,
}

#[derive(Debug, Copy, Clone)]
struct ActiveFace<S: ScreenPrecision, W> {
    left: Edge<S>,
    right: Edge<S>,
    /// The edge between the two lower corners.
    third: Edge<S>,
    /// Of the left and the right edge.
    refills: Refills<S>,
    third_refill: Refill<S>,
    plane: DepthPlane,
    /// Place in the order of models and faces.
    order: u16,
    next: u16,
    /// The row in which the third edge takes over, then the one after the last.
    turn: i16,
    /// The row after the last one.
    bottom: i16,
    word: W,
    third_side: ThirdSide,
}

impl<S: ScreenPrecision, W: PixelWord> ActiveFace<S, W> {
    const EMPTY: Self = Self {
        left: Edge::EMPTY,
        right: Edge::EMPTY,
        third: Edge::EMPTY,
        refills: S::EdgeSum::NO_REFILLS,
        third_refill: S::EdgeSum::NO_REFILL,
        plane: DepthPlane {
            depth: 0,
            per_column: 0,
            per_row: 0,
        },
        order: 0,
        next: 0,
        turn: 0,
        bottom: 0,
        word: W::ZERO,
        third_side: ThirdSide::Neither,
    };
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
///
/// With depths the list is kept in the order of the models, so that of two fragments with the same depth the first face's
/// is drawn, whatever the rows in which they began.
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
        self.walk::<true>(row.y, |face| {
            row.draw_span(face.left.column(), face.right.column(), face.word, &face.plane);
            true
        });
    }

    /// Draws the spans of a row, if they are in the order of columns and none overlaps another. Otherwise some of them,
    /// and the list is worth nothing.
    // Not inlined: the other loop needs every register.
    #[inline(never)]
    fn fill_spans<C, O, D>(&mut self, row: &mut DepthRow<'_, C, O, D>) -> bool
    where
        C: BandColor<Word = W>,
        O: Order,
        D: DepthWidth,
    {
        let mut free_from = i32::MIN;
        self.walk::<false>(row.y, |face| {
            let (start, end) = (face.left.column(), face.right.column());
            if start < end {
                if start < free_from {
                    return false;
                }
                free_from = end;
                row.fill_span(start, end, face.word);
            }
            true
        })
    }

    /// Hands over each face of the list as it is in a row, takes it to the next row, and drops it if it ends there. Stops
    /// where `draw` says so, and returns whether it never did.
    #[inline(always)]
    fn walk<const PLANES: bool>(&mut self, row: i32, mut draw: impl FnMut(&ActiveFace<S, W>) -> bool) -> bool {
        let next_row = row.wrapping_add(1);
        let mut previous = NONE;
        let mut current = self.first;
        while let Some(face) = self.slots.get_mut(usize::from(current)) {
            if !draw(face) {
                return false;
            }
            if PLANES {
                face.plane.step_down();
            }
            face.step_down();
            let next = face.next;
            if next_row == i32::from(face.turn) && !face.take_turn() {
                face.next = self.free;
                self.free = current;
                self.link(previous, next);
            } else {
                previous = current;
            }
            current = next;
        }
        true
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

    /// Puts the faces that begin in a row where they belong in the list, as they are in row `y`.
    #[inline(never)]
    fn begin_row<D: DepthWidth>(&mut self, faces: &impl FaceTable<S, D, W>, begin: i32, y: i32) {
        let mut waiting = faces.first_in_row(begin);
        if self.apart {
            while waiting != NONE {
                if let Some(begun) = self.begin(faces, waiting, y, NONE) {
                    self.put_in_order_of_columns(begun);
                }
                waiting = faces.next(waiting);
            }
            return;
        }
        // They come in the order of the models.
        let mut previous = NONE;
        let mut current = self.first;
        while waiting != NONE {
            let order = faces.order(waiting);
            while let Some(face) = self.slots.get(usize::from(current)).filter(|face| face.order <= order) {
                previous = current;
                current = face.next;
            }
            if let Some(begun) = self.begin(faces, waiting, y, current) {
                self.link(previous, begun);
                previous = begun;
            }
            waiting = faces.next(waiting);
        }
    }

    /// Puts a face where it belongs in the order of columns.
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

    /// Sets a face up in a free slot, before another one. `None` where it ends above the row.
    #[inline(never)]
    fn begin<D: DepthWidth>(
        &mut self,
        faces: &impl FaceTable<S, D, W>,
        entry: u16,
        row: i32,
        next: u16,
    ) -> Option<u16> {
        let (corners, word) = faces.face(entry)?;
        let index = self.free;
        // Preparing counted the active faces, so there is a slot.
        let face = self.slots.get_mut(usize::from(index))?;
        let corners = from_top(corners);
        let rows = Rows::of(corners);
        if row >= rows.bottom {
            return None;
        }
        self.free = face.next;
        face.next = next;
        face.order = faces.order(entry);
        face.word = word;
        face.set_up_edges(corners, &rows, row);
        if !self.apart {
            face.set_up_plane(corners, faces.viewport(), row);
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

impl<S: ScreenPrecision, W: Copy> ActiveFace<S, W> {
    /// Sets the edges up as they are in a row.
    #[inline(always)]
    fn set_up_edges<D: DepthWidth>(&mut self, corners: [&ScreenVertex<S, D>; 3], rows: &Rows, row: i32) {
        let [top, right, left] = corners;
        // Rows of the domain, below 2^13 in size.
        self.bottom = rows.bottom as i16;
        self.turn = rows.middle as i16;
        if !Edge::<S>::MAY_BE_SHORT {
            self.set_up_any_edges::<true>(corners.map(|corner| corner.position()), rows, row);
        } else if are_short(corners) {
            self.set_up_short_edges(corners.map(|corner| corner.position()), rows);
            if row > rows.top {
                self.skip_rows_of_short_edges(row.wrapping_sub(rows.top), row.wrapping_sub(rows.middle));
            }
        } else {
            self.set_up_long_edges(top, right, left, row);
        }
        if row >= rows.middle {
            // The edge above the middle crosses no row from here on.
            self.take_turn();
        }
    }

    #[inline(always)]
    fn set_up_plane<D: DepthWidth>(&mut self, corners: [&ScreenVertex<S, D>; 3], viewport: &Window, row: i32) {
        let [top, right, left] = corners;
        match DepthPlane::small(corners, row) {
            Some(plane) => self.plane = plane,
            None => self.plane.set_wide(top, right, left, viewport, row),
        }
    }

    /// Twice the middle of its span and how that moves: by this, spans that are apart lie in the order of columns, also
    /// those that begin in the same point.
    #[inline(always)]
    fn middle(&self) -> [S::EdgeSum; 2] {
        self.left.plus(&self.right)
    }

    /// The edges from the row in which the face begins, each short.
    #[inline(always)]
    fn set_up_short_edges(&mut self, [top, right, left]: [Position; 3], rows: &Rows) {
        let down = PixelAfter::of::<S>(top).down;
        self.left = Edge::short(top, left, down);
        self.right = Edge::short(top, right, down);
        self.refills = S::EdgeSum::NO_REFILLS;
        self.third_refill = S::EdgeSum::NO_REFILL;
        self.third_side = ThirdSide::Neither;
        if rows.middle < rows.bottom {
            self.third_side = rows.third_side;
            let (middle, bottom) = rows.third_edge(left, right);
            self.third = Edge::short(middle, bottom, PixelAfter::of::<S>(middle).down);
        }
    }

    /// Enters a face with short edges below the rows in which these begin.
    #[cold]
    #[inline(never)]
    fn skip_rows_of_short_edges(&mut self, rows: i32, rows_of_third: i32) {
        self.left.skip_rows(rows);
        self.right.skip_rows(rows);
        self.third.skip_rows(rows_of_third.max(0));
    }

    /// The edges at any row, not all of them short.
    // Not inlined: few faces come here.
    #[inline(never)]
    fn set_up_long_edges<D: DepthWidth>(
        &mut self,
        top: &ScreenVertex<S, D>,
        right: &ScreenVertex<S, D>,
        left: &ScreenVertex<S, D>,
        row: i32,
    ) {
        let corners = [top, right, left];
        let positions = corners.map(|corner| corner.position());
        self.set_up_any_edges::<false>(positions, &Rows::of(corners), row);
    }

    /// The edges at any row, by code for each of them or by one copy.
    #[inline(always)]
    fn set_up_any_edges<const IN_LINE: bool>(&mut self, [top, right, left]: [Position; 3], rows: &Rows, row: i32) {
        let (left_edge, left_refill) = Edge::new::<IN_LINE>(top, left, row);
        let (right_edge, right_refill) = Edge::new::<IN_LINE>(top, right, row);
        (self.left, self.right) = (left_edge, right_edge);
        self.refills = S::EdgeSum::refills(left_refill, right_refill);
        self.third_side = ThirdSide::Neither;
        if rows.middle < rows.bottom {
            self.third_side = rows.third_side;
            let (middle, bottom) = rows.third_edge(left, right);
            (self.third, self.third_refill) = Edge::new::<IN_LINE>(middle, bottom, row.max(rows.middle));
        }
    }

    /// The edges to the next row.
    #[inline(always)]
    fn step_down(&mut self) {
        // Most faces are small: one question for both edges.
        if Edge::<S>::MAY_BE_SHORT && self.refills == S::EdgeSum::NO_REFILLS {
            self.left.step_down_short();
            self.right.step_down_short();
        } else {
            self.left.step_down(S::EdgeSum::left_refill(self.refills));
            self.right.step_down(S::EdgeSum::right_refill(self.refills));
        }
    }

    /// The third edge takes over, or the face ends: then `false`.
    #[inline(always)]
    fn take_turn(&mut self) -> bool {
        if self.third_side == ThirdSide::Neither {
            return false;
        }
        self.turn = self.bottom;
        let (left, right) = (
            S::EdgeSum::left_refill(self.refills),
            S::EdgeSum::right_refill(self.refills),
        );
        if self.third_side == ThirdSide::Left {
            self.left = self.third;
            self.refills = S::EdgeSum::refills(self.third_refill, right);
        } else {
            self.right = self.third;
            self.refills = S::EdgeSum::refills(left, self.third_refill);
        }
        self.third_side = ThirdSide::Neither;
        true
    }
}

/// The corners as the rows meet them: the top, the one clockwise after it (right), the last (left).
#[inline(always)]
fn from_top<S: ScreenPrecision, D: DepthWidth>([a, b, c]: [&ScreenVertex<S, D>; 3]) -> [&ScreenVertex<S, D>; 3] {
    if a.y_units() <= b.y_units() && a.y_units() <= c.y_units() {
        [a, b, c]
    } else if b.y_units() <= c.y_units() {
        [b, c, a]
    } else {
        [c, a, b]
    }
}

/// Where the edges of a face begin and end.
#[derive(Debug)]
struct Rows {
    /// First row.
    top: i32,
    /// On which side the edge between the two lower corners is.
    third_side: ThirdSide,
    /// First row of that edge.
    middle: i32,
    /// The row after the last one.
    bottom: i32,
}

impl Rows {
    #[inline(always)]
    fn of<S: ScreenPrecision, D: DepthWidth>([top, right, left]: [&ScreenVertex<S, D>; 3]) -> Self {
        let row_after = |corner: &ScreenVertex<S, D>| row_after::<S>(corner.y_units());
        let (left_row, right_row) = (row_after(left), row_after(right));
        Self {
            top: row_after(top),
            third_side: if left.y_units() < right.y_units() {
                ThirdSide::Left
            } else {
                ThirdSide::Right
            },
            middle: left_row.min(right_row),
            bottom: left_row.max(right_row),
        }
    }

    /// The middle and the bottom corner.
    #[inline(always)]
    fn third_edge(&self, left: Position, right: Position) -> (Position, Position) {
        if self.third_side == ThirdSide::Left {
            (left, right)
        } else {
            (right, left)
        }
    }
}

/// Whether all edges of a face are short.
#[inline(always)]
fn are_short<S: ScreenPrecision, D: DepthWidth>([top, right, left]: [&ScreenVertex<S, D>; 3]) -> bool {
    let is_short = |corner: &ScreenVertex<S, D>| Edge::<S>::is_short(corner.y_units().wrapping_sub(top.y_units()));
    is_short(right) && is_short(left)
}
