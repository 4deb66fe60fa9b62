//! The active list: the faces that cross the current row, in the order of the models.

use crate::{
    target::{BandColor, Order, PixelWord},
    view::{DepthWidth, ScreenPrecision, ScreenVertex},
    visible::{DepthRow, depth_plane::DepthPlane, edge::Edge},
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
    /// Of column 0 in the current row.
    depth: u32,
    per_column: u32,
    per_row: u32,
    entry: u16,
    next: u16,
    /// The row in which the third edge takes over.
    middle: i16,
    /// The row after the last one.
    bottom: i16,
    word: W,
    third_is_left: bool,
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
        slots: [ActiveFace {
            left: Edge::EMPTY,
            right: Edge::EMPTY,
            depth: 0,
            per_column: 0,
            per_row: 0,
            entry: 0,
            next: 0,
            middle: 0,
            bottom: 0,
            word: W::ZERO,
            third_is_left: false,
        }; N],
        first: 0,
        free: 0,
        next_row: 0,
    };

    /// Forgets everything: the next row starts from its faces.
    pub(crate) fn restart(&mut self) {
        self.next_row = i32::MIN;
    }

    fn clear(&mut self) {
        self.first = NONE;
        self.free = NONE;
        for (index, slot) in self.slots.iter_mut().enumerate().rev() {
            slot.next = self.free;
            self.free = index as u16;
        }
    }

    /// Draws all faces of a row.
    pub(crate) fn draw_row<C, O, D>(&mut self, faces: &impl FaceTable<S, D, W>, row: &mut DepthRow<'_, C, O, D>)
    where
        C: BandColor<Word = W>,
        O: Order,
        D: DepthWidth,
    {
        if self.next_row != row.y {
            self.clear();
            for earlier in faces.top()..row.y {
                self.begin(faces, earlier, row.y);
            }
        }
        self.begin(faces, row.y, row.y);
        self.next_row = row.y.wrapping_add(1);
        let next_row = self.next_row;

        let mut previous = NONE;
        let mut current = self.first;
        while let Some(face) = self.slots.get_mut(usize::from(current)) {
            row.draw_span(face.left.x(), face.right.x(), face.word, face.depth, face.per_column);
            let next = face.next;
            if next_row == i32::from(face.bottom) {
                face.next = self.free;
                self.free = current;
                self.link(previous, next);
            } else {
                face.advance(faces, next_row);
                previous = current;
            }
            current = next;
        }
    }

    /// Puts the faces that begin in a row among the others, as they are in row `y`.
    fn begin<D: DepthWidth>(&mut self, faces: &impl FaceTable<S, D, W>, begin: i32, y: i32) {
        let mut entry = faces.first_in_row(begin);
        let mut previous = NONE;
        let mut current = self.first;
        while entry != NONE {
            let order = place(faces, entry);
            while let Some(face) = self.slots.get(usize::from(current)) {
                if place(faces, face.entry) > order {
                    break;
                }
                previous = current;
                current = face.next;
            }
            if let Some(mut face) = ActiveFace::at_row(faces, entry, y)
                && let Some(slot) = self.slots.get_mut(usize::from(self.free))
            {
                face.next = current;
                let index = self.free;
                self.free = slot.next;
                *slot = face;
                self.link(previous, index);
                previous = index;
            }
            entry = faces.next(entry);
        }
    }

    fn link(&mut self, previous: u16, next: u16) {
        match self.slots.get_mut(usize::from(previous)) {
            Some(face) => face.next = next,
            None => self.first = next,
        }
    }
}

/// Where an entry belongs in the list. Pieces of one face come last first, as the table has them.
#[inline(always)]
fn place<S: ScreenPrecision, D: DepthWidth, W>(faces: &impl FaceTable<S, D, W>, entry: u16) -> (u16, u16) {
    (faces.order(entry), !entry)
}

/// The corners as the rows meet them: the top, then clockwise.
struct FromTop<'a, S: ScreenPrecision, D: DepthWidth> {
    top: &'a ScreenVertex<S, D>,
    right: &'a ScreenVertex<S, D>,
    left: &'a ScreenVertex<S, D>,
}

impl<'a, S: ScreenPrecision, D: DepthWidth> FromTop<'a, S, D> {
    fn new([a, b, c]: &'a [ScreenVertex<S, D>; 3]) -> Self {
        let (y_a, y_b, y_c) = (a.y_units(), b.y_units(), c.y_units());
        let (top, right, left) = if y_a <= y_b && y_a <= y_c {
            (a, b, c)
        } else if y_b <= y_c {
            (b, c, a)
        } else {
            (c, a, b)
        };
        Self { top, right, left }
    }

    /// Whether the edge between the two lower corners is on the left side.
    fn third_is_left(&self) -> bool {
        self.left.y_units() < self.right.y_units()
    }

    fn third_edge(&self, row: i32) -> Edge<S> {
        if self.third_is_left() {
            Edge::new(self.left, self.right, row)
        } else {
            Edge::new(self.right, self.left, row)
        }
    }
}

/// The first row whose centre is at that height or below it.
#[inline(always)]
fn row_of<S: ScreenPrecision, D: DepthWidth>(vertex: &ScreenVertex<S, D>) -> i32 {
    vertex.y_units().wrapping_add((1 << S::FRACTION_BITS) - 1) >> S::FRACTION_BITS
}

impl<S: ScreenPrecision, W: Copy> ActiveFace<S, W> {
    /// The face in a row at or below its first one; `None` where it ends above.
    fn at_row<D: DepthWidth>(faces: &impl FaceTable<S, D, W>, entry: u16, row: i32) -> Option<Self> {
        let corners = faces.corners(entry)?;
        let from_top = FromTop::new(&corners);
        let FromTop { top, right, left } = from_top;
        let third_is_left = from_top.third_is_left();
        let (middle, bottom) = if third_is_left { (left, right) } else { (right, left) };
        let (middle, bottom) = (row_of(middle), row_of(bottom));
        if row >= bottom {
            return None;
        }
        let third = row >= middle;
        let left_edge = if third && third_is_left {
            from_top.third_edge(row)
        } else {
            Edge::new(top, left, row)
        };
        let right_edge = if third && !third_is_left {
            from_top.third_edge(row)
        } else {
            Edge::new(top, right, row)
        };
        let plane = DepthPlane::new(&corners, row);
        Some(Self {
            left: left_edge,
            right: right_edge,
            depth: plane.depth,
            per_column: plane.per_column,
            per_row: plane.per_row,
            entry,
            next: NONE,
            // Rows of the domain, below 2^13 in size.
            middle: middle as i16,
            bottom: bottom as i16,
            word: faces.word(entry)?,
            third_is_left,
        })
    }

    /// To a row that the face still crosses.
    #[inline(always)]
    fn advance<D: DepthWidth>(&mut self, faces: &impl FaceTable<S, D, W>, row: i32) {
        self.depth = self.depth.wrapping_add(self.per_row);
        self.left.step_down();
        self.right.step_down();
        if row == i32::from(self.middle) {
            self.turn(faces, row);
        }
    }

    fn turn<D: DepthWidth>(&mut self, faces: &impl FaceTable<S, D, W>, row: i32) {
        if let Some(corners) = faces.corners(self.entry) {
            let third = FromTop::new(&corners).third_edge(row);
            if self.third_is_left {
                self.left = third;
            } else {
                self.right = third;
            }
        }
    }
}
