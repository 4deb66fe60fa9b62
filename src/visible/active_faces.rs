//! The active list: the faces that cross the current row, in the order of the models.

use crate::{
    target::{BandColor, Order, PixelWord},
    view::{DepthWidth, EdgeSum, Position, ScreenPrecision, ScreenVertex},
    visible::{
        DepthRow,
        depth_plane::DepthPlane,
        edge::{Edge, Refill},
    },
};

/// No entry, no slot.
pub(crate) const NONE: u16 = u16::MAX;

/// The faces of a prepared frame, by the row in which they begin. Entries of one row come in ascending order.
pub(crate) trait FaceTable<S: ScreenPrecision, D: DepthWidth, W> {
    /// First row of the viewport.
    fn top(&self) -> i32;
    /// First of the faces that begin in a row, or [`NONE`].
    fn first_in_row(&self, row: i32) -> u16;
    /// The face after an entry that begins in the same row, or [`NONE`].
    fn next(&self, entry: u16) -> u16;
    /// Place of an entry in the order of models and faces.
    fn order(&self, entry: u16) -> u16;
    /// The corners, clockwise on the screen.
    fn corners(&self, entry: u16) -> Option<[ScreenVertex<S, D>; 3]>;
    /// The colour.
    fn word(&self, entry: u16) -> Option<W>;
}

#[derive(Debug, Copy, Clone)]
struct ActiveFace<S: ScreenPrecision, W> {
    left: Edge<S>,
    right: Edge<S>,
    left_refill: Refill<S>,
    right_refill: Refill<S>,
    plane: DepthPlane,
    entry: u16,
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
        left_refill: S::EdgeSum::NO_REFILL,
        right_refill: S::EdgeSum::NO_REFILL,
        plane: DepthPlane {
            depth: 0,
            per_column: 0,
            per_row: 0,
        },
        entry: 0,
        next: 0,
        turn: 0,
        bottom: 0,
        word: W::ZERO,
        third_is_left: false,
    };
}

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
}

impl<S: ScreenPrecision, W: PixelWord, const N: usize> ActiveFaces<S, W, N> {
    pub(crate) const EMPTY: Self = Self {
        slots: [ActiveFace::EMPTY; N],
        first: 0,
        free: 0,
        next_row: 0,
    };

    /// Forgets everything: the next row starts from its faces.
    pub(crate) fn restart(&mut self) {
        self.next_row = i32::MIN;
    }

    /// Draws all faces of a row. Those that begin in it are set up on the way, where they belong in the order.
    pub(crate) fn draw_row<C, O, D>(&mut self, faces: &impl FaceTable<S, D, W>, row: &mut DepthRow<'_, C, O, D>)
    where
        C: BandColor<Word = W>,
        O: Order,
        D: DepthWidth,
    {
        if self.next_row != row.y {
            self.enter(faces, row.y);
        }
        let next_row = row.y.wrapping_add(1);
        self.next_row = next_row;
        let mut waiting = faces.first_in_row(row.y);
        let mut previous = NONE;
        let mut current = self.first;
        loop {
            if waiting != NONE && self.comes_first(faces, waiting, current) {
                if let Some(begun) = self.begin(faces, waiting, row.y, current) {
                    self.link(previous, begun);
                    current = begun;
                }
                waiting = faces.next(waiting);
            }
            let Some(face) = self.slots.get_mut(usize::from(current)) else {
                break;
            };
            row.draw_span(face.left.column(), face.right.column(), face.word, &face.plane);
            let next = face.next;
            face.step_down();
            if next_row == i32::from(face.turn) && !face.take_turn(faces, next_row) {
                face.next = self.free;
                self.free = current;
                self.link(previous, next);
            } else {
                previous = current;
            }
            current = next;
        }
    }

    /// Enters the faces that began above a row and still cross it.
    #[cold]
    fn enter<D: DepthWidth>(&mut self, faces: &impl FaceTable<S, D, W>, row: i32) {
        self.first = NONE;
        self.free = NONE;
        for (index, slot) in self.slots.iter_mut().enumerate().rev() {
            slot.next = self.free;
            self.free = index as u16;
        }
        for earlier in faces.top()..row {
            let mut waiting = faces.first_in_row(earlier);
            let mut previous = NONE;
            let mut current = self.first;
            while waiting != NONE {
                while !self.comes_first(faces, waiting, current) {
                    previous = current;
                    current = self.slots.get(usize::from(current)).map_or(NONE, |face| face.next);
                }
                if let Some(begun) = self.begin(faces, waiting, row, current) {
                    self.link(previous, begun);
                    previous = begun;
                }
                waiting = faces.next(waiting);
            }
        }
    }

    /// Whether a waiting face is drawn before an active one. Pieces of one face come last first, as the table has them.
    #[inline(always)]
    fn comes_first<D: DepthWidth>(&self, faces: &impl FaceTable<S, D, W>, waiting: u16, current: u16) -> bool {
        let place = |entry: u16| (faces.order(entry), !entry);
        self.slots
            .get(usize::from(current))
            .is_none_or(|face| place(waiting) < place(face.entry))
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
        let corners = faces.corners(entry)?;
        let index = self.free;
        // Preparing counted the active faces, so there is a slot.
        let face = self.slots.get_mut(usize::from(index))?;
        let positions = corners.map(|corner| corner.position());
        let from_top = FromTop::new::<S>(&positions);
        if row >= from_top.bottom_row {
            return None;
        }
        self.free = face.next;
        face.next = next;
        face.entry = entry;
        face.word = faces.word(entry)?;
        // Rows of the domain, below 2^13 in size.
        face.bottom = from_top.bottom_row as i16;
        face.third_is_left = from_top.third_is_left;
        face.turn = face.bottom;
        let third_begun = row >= from_top.middle_row;
        if !third_begun {
            face.turn = from_top.middle_row as i16;
        }
        let third_edge = |third_is_left: bool| third_begun && from_top.third_is_left == third_is_left;
        let left_top = if third_edge(true) { from_top.left } else { from_top.top };
        let left_bottom = if third_edge(true) {
            from_top.right
        } else {
            from_top.left
        };
        let right_top = if third_edge(false) {
            from_top.right
        } else {
            from_top.top
        };
        let right_bottom = if third_edge(false) {
            from_top.left
        } else {
            from_top.right
        };
        (face.left, face.left_refill) = Edge::new(left_top, left_bottom, row);
        (face.right, face.right_refill) = Edge::new(right_top, right_bottom, row);
        face.plane = DepthPlane::new(&corners, row);
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
    #[inline(never)]
    fn take_turn<D: DepthWidth>(&mut self, faces: &impl FaceTable<S, D, W>, row: i32) -> bool {
        if self.turn == self.bottom {
            return false;
        }
        let Some(corners) = faces.corners(self.entry) else {
            return false;
        };
        self.turn = self.bottom;
        let FromTop { left, right, .. } = FromTop::new::<S>(&corners.map(|corner| corner.position()));
        if self.third_is_left {
            (self.left, self.left_refill) = Edge::new(left, right, row);
        } else {
            (self.right, self.right_refill) = Edge::new(right, left, row);
        }
        true
    }
}

/// The corners as the rows meet them.
#[derive(Debug)]
struct FromTop {
    top: Position,
    /// Clockwise after the top.
    right: Position,
    /// Clockwise after that.
    left: Position,
    /// Whether the edge between the two lower corners is on the left side.
    third_is_left: bool,
    /// First row of that edge.
    middle_row: i32,
    /// The row after the last one.
    bottom_row: i32,
}

impl FromTop {
    #[inline(always)]
    fn new<S: ScreenPrecision>(&[a, b, c]: &[Position; 3]) -> Self {
        let (top, right, left) = if a.y <= b.y && a.y <= c.y {
            (a, b, c)
        } else if b.y <= c.y {
            (b, c, a)
        } else {
            (c, a, b)
        };
        // The first row whose centre is at that height or below it.
        let row_of = |corner: Position| corner.y.wrapping_add((1 << S::FRACTION_BITS) - 1) >> S::FRACTION_BITS;
        let (left_row, right_row) = (row_of(left), row_of(right));
        Self {
            top,
            right,
            left,
            third_is_left: left.y < right.y,
            middle_row: left_row.min(right_row),
            bottom_row: left_row.max(right_row),
        }
    }
}
