//! The active list: the faces that cross the current row, in the order of the models.

use crate::{
    geometry::Window,
    target::{BandColor, Order, PixelWord},
    view::{DepthWidth, EdgeSum, ScreenPrecision, ScreenVertex},
    visible::{
        DepthRow,
        depth_plane::DepthPlane,
        edge::{Edge, PixelAfter, Refill},
    },
};

/// No entry, no slot.
pub(crate) const NONE: u16 = u16::MAX;

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
    /// The corners, clockwise on the screen, and the colour.
    fn face(&self, entry: u16) -> Option<([&ScreenVertex<S, D>; 3], W)>;
}

#[derive(Debug, Copy, Clone)]
struct ActiveFace<S: ScreenPrecision, W> {
    left: Edge<S>,
    right: Edge<S>,
    /// The edge between the two lower corners.
    third: Edge<S>,
    left_refill: Refill<S>,
    right_refill: Refill<S>,
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
    third_is_left: bool,
}

impl<S: ScreenPrecision, W: PixelWord> ActiveFace<S, W> {
    const EMPTY: Self = Self {
        left: Edge::EMPTY,
        right: Edge::EMPTY,
        third: Edge::EMPTY,
        left_refill: S::EdgeSum::NO_REFILL,
        right_refill: S::EdgeSum::NO_REFILL,
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
        third_is_left: false,
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

/// So few faces in a row are compared with each other: it takes less than one depth test a pixel.
const FEW: usize = 4;

/// Room for `N` faces in one row.
///
/// The list is kept in the order of the models, so that of two fragments with the same depth the first face's is drawn,
/// whatever the rows in which they began.
#[derive(Debug)]
pub(crate) struct ActiveFaces<S: ScreenPrecision, W, const N: usize> {
    slots: [ActiveFace<S, W>; N],
    first: u16,
    free: u16,
    /// The row that comes next if rows are drawn in order.
    next_row: i32,
    /// Faces in the list.
    count: u16,
    /// Rows drawn without depths since the last restart.
    rows_without_depth: u32,
}

impl<S: ScreenPrecision, W: PixelWord, const N: usize> ActiveFaces<S, W, N> {
    pub(crate) const EMPTY: Self = Self {
        slots: [ActiveFace::EMPTY; N],
        first: 0,
        free: 0,
        next_row: 0,
        count: 0,
        rows_without_depth: 0,
    };

    /// Forgets everything: the next row starts from its faces.
    pub(crate) fn restart(&mut self) {
        self.next_row = i32::MIN;
        self.rows_without_depth = 0;
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
        if self.next_row != row.y {
            self.enter(faces, row.y);
        }
        self.begin_row(faces, row.y, row.y);
        let next_row = row.y.wrapping_add(1);
        self.next_row = next_row;
        // A fragment is nearer than a cleared depth, always: without a second one for its pixel no test can fail.
        let few = depth_use == DepthUse::WhereFacesMayOverlap && usize::from(self.count) <= FEW;
        let without_depth = few && self.spans_are_apart();
        if without_depth {
            self.rows_without_depth = self.rows_without_depth.wrapping_add(1);
        } else {
            row.clear_depths();
        }
        let mut previous = NONE;
        let mut current = self.first;
        while let Some(face) = self.slots.get_mut(usize::from(current)) {
            let (start, end) = (face.left.column(), face.right.column());
            if without_depth {
                row.fill_span(start, end, face.word);
            } else {
                row.draw_span(start, end, face.word, &face.plane);
            }
            face.step_down();
            let next = face.next;
            if next_row == i32::from(face.turn) && !face.take_turn() {
                face.next = self.free;
                self.free = current;
                self.count = self.count.wrapping_sub(1);
                self.link(previous, next);
            } else {
                previous = current;
            }
            current = next;
        }
    }

    /// Whether no span overlaps another, of few.
    #[inline(never)]
    fn spans_are_apart(&self) -> bool {
        let mut spans = [(0, 0); FEW];
        let mut count = 0;
        let mut current = self.first;
        while let Some(face) = self.slots.get(usize::from(current)) {
            let span = (face.left.column(), face.right.column());
            let overlaps = |other: &(i32, i32)| other.0 < span.1 && span.0 < other.1;
            if spans.iter().take(count).any(overlaps) {
                return false;
            }
            let Some(place) = spans.get_mut(count) else {
                return false;
            };
            *place = span;
            count += 1;
            current = face.next;
        }
        true
    }

    /// Forgets the list and enters the faces that began above a row and still cross it.
    #[cold]
    #[inline(never)]
    fn enter<D: DepthWidth>(&mut self, faces: &impl FaceTable<S, D, W>, row: i32) {
        self.first = NONE;
        self.free = NONE;
        self.count = 0;
        for (index, slot) in self.slots.iter_mut().enumerate().rev() {
            slot.next = self.free;
            self.free = index as u16;
        }
        for earlier in faces.viewport().top..row {
            self.begin_row(faces, earlier, row);
        }
    }

    /// Puts the faces that begin in a row where they belong in the order, as they are in row `y`.
    #[inline(always)]
    fn begin_row<D: DepthWidth>(&mut self, faces: &impl FaceTable<S, D, W>, begin: i32, y: i32) {
        let mut waiting = faces.first_in_row(begin);
        let mut previous = NONE;
        let mut current = self.first;
        while waiting != NONE {
            let order = faces.order(waiting);
            while let Some(face) = self.slots.get(usize::from(current))
                && face.order <= order
            {
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
        let corners = from_top(corners);
        let rows = Rows::of(corners);
        if row >= rows.bottom {
            return None;
        }
        let index = self.free;
        // Preparing counted the active faces, so there is a slot.
        let face = self.slots.get_mut(usize::from(index))?;
        self.free = face.next;
        self.count = self.count.wrapping_add(1);
        face.next = next;
        face.order = faces.order(entry);
        face.word = word;
        face.third_is_left = rows.third_is_left;
        // Rows of the domain, below 2^13 in size.
        face.bottom = rows.bottom as i16;
        face.turn = rows.middle as i16;
        let [top, right, left] = corners.map(|corner| corner.position());
        let after_top = PixelAfter::of::<S>(top);
        (face.left, face.left_refill) = Edge::new(top, &after_top, left, row);
        (face.right, face.right_refill) = Edge::new(top, &after_top, right, row);
        if rows.middle < rows.bottom {
            let (middle, bottom) = if rows.third_is_left {
                (left, right)
            } else {
                (right, left)
            };
            let after_middle = PixelAfter::of::<S>(middle);
            (face.third, face.third_refill) = Edge::new(middle, &after_middle, bottom, row.max(rows.middle));
        }
        if row >= rows.middle {
            // The edge above the middle crosses no row from here on.
            face.take_turn();
        }
        face.plane = DepthPlane::new(corners, &after_top, faces.viewport(), row);
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
    /// To the next row.
    #[inline(always)]
    fn step_down(&mut self) {
        self.plane.step_down();
        self.left.step_down(self.left_refill);
        self.right.step_down(self.right_refill);
    }

    /// The third edge takes over, or the face ends: then `false`.
    #[inline(always)]
    fn take_turn(&mut self) -> bool {
        if self.turn == self.bottom {
            return false;
        }
        self.turn = self.bottom;
        if self.third_is_left {
            (self.left, self.left_refill) = (self.third, self.third_refill);
        } else {
            (self.right, self.right_refill) = (self.third, self.third_refill);
        }
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
    /// Whether the edge between the two lower corners is on the left side.
    third_is_left: bool,
    /// First row of that edge.
    middle: i32,
    /// The row after the last one.
    bottom: i32,
}

impl Rows {
    #[inline(always)]
    fn of<S: ScreenPrecision, D: DepthWidth>([_, right, left]: [&ScreenVertex<S, D>; 3]) -> Self {
        let row_after = |corner: &ScreenVertex<S, D>| PixelAfter::of::<S>(corner.position()).row;
        let (left_row, right_row) = (row_after(left), row_after(right));
        Self {
            third_is_left: left.y_units() < right.y_units(),
            middle: left_row.min(right_row),
            bottom: left_row.max(right_row),
        }
    }
}
