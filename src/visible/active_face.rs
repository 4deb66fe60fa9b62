//! A face that crosses the current row: its edges, walked row by row, and its depth plane.

use crate::{
    target::PixelWord,
    view::{DepthWidth, EdgeSum, Position, ScreenPrecision, ScreenVertex},
    visible::{
        depth_plane::DepthPlane,
        edge::{Edge, PixelAfter, Refill, Refills, row_after},
    },
};

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
pub(super) struct ActiveFace<S: ScreenPrecision, W> {
    pub(super) left: Edge<S>,
    pub(super) right: Edge<S>,
    /// The edge between the two lower corners.
    third: Edge<S>,
    /// Of the left and the right edge.
    refills: Refills<S>,
    third_refill: Refill<S>,
    pub(super) plane: DepthPlane,
    /// Its place in the table.
    pub(super) entry: u16,
    /// The one after it in the list.
    pub(super) next: u16,
    /// The row in which the third edge takes over, then the one after the last.
    pub(super) turn: i16,
    /// The row after the last one.
    bottom: i16,
    pub(super) word: W,
    third_side: ThirdSide,
}

impl<S: ScreenPrecision, W: PixelWord> ActiveFace<S, W> {
    pub(super) const EMPTY: Self = Self {
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
        entry: 0,
        next: 0,
        turn: 0,
        bottom: 0,
        word: W::ZERO,
        third_side: ThirdSide::Neither,
    };
}

impl<S: ScreenPrecision, W: Copy> ActiveFace<S, W> {
    /// Sets up the edges as they are in a row, if they are short. `false` where they are not.
    #[inline(always)]
    pub(super) fn set_up_short_edges(&mut self, sides: &Sides, rows: &Rows, row: i32) -> bool {
        let are_short = Edge::<S>::is_short(sides.right.y) && Edge::<S>::is_short(sides.left.y);
        if !Edge::<S>::MAY_BE_SHORT || !are_short {
            return false;
        }
        self.begin_short_edges(sides, rows);
        if row > rows.top {
            self.skip_rows_of_short_edges(row.wrapping_sub(rows.top), row.wrapping_sub(rows.middle));
        }
        if row >= rows.middle {
            // The edge above the middle crosses no row from here on.
            self.take_turn();
        }
        true
    }

    /// Sets up any edges as they are in a row, with code for each of them or with one copy.
    #[inline(always)]
    pub(super) fn set_up_edges<const IN_LINE: bool>(&mut self, sides: &Sides, rows: &Rows, row: i32) {
        self.turn_at(rows);
        let Sides { top, right, left } = *sides;
        let (left_edge, left_refill) = Edge::new::<IN_LINE>(top, left, row);
        let (right_edge, right_refill) = Edge::new::<IN_LINE>(top, right, row);
        (self.left, self.right) = (left_edge, right_edge);
        self.refills = S::EdgeSum::refills(left_refill, right_refill);
        self.third_side = ThirdSide::Neither;
        if rows.middle < rows.bottom {
            self.third_side = rows.third_side;
            let (middle, bottom) = rows.third_edge(left, right);
            (self.third, self.third_refill) =
                Edge::new::<IN_LINE>(top.plus(middle), bottom.minus(middle), row.max(rows.middle));
        }
        if row >= rows.middle {
            self.take_turn();
        }
    }

    /// Twice the middle of its span and how that moves: by this, spans that are apart lie in the order of columns, also
    /// those that begin in the same point.
    #[inline(always)]
    pub(super) fn middle(&self) -> [S::EdgeSum; 2] {
        self.left.plus(&self.right)
    }

    /// The edges from the row in which the face begins, each short.
    #[inline(always)]
    fn begin_short_edges(&mut self, sides: &Sides, rows: &Rows) {
        self.turn_at(rows);
        let Sides { top, right, left } = *sides;
        let down = PixelAfter::of::<S>(top).down;
        self.left = Edge::short(top.x, left, down);
        self.right = Edge::short(top.x, right, down);
        self.refills = S::EdgeSum::NO_REFILLS;
        self.third_refill = S::EdgeSum::NO_REFILL;
        self.third_side = ThirdSide::Neither;
        if rows.middle < rows.bottom {
            self.third_side = rows.third_side;
            let (middle, bottom) = rows.third_edge(left, right);
            let corner = top.plus(middle);
            self.third = Edge::short(corner.x, bottom.minus(middle), PixelAfter::of::<S>(corner).down);
        }
    }

    #[inline(always)]
    fn turn_at(&mut self, rows: &Rows) {
        // Rows of the domain, below 2^13 in size.
        self.bottom = rows.bottom as i16;
        self.turn = rows.middle as i16;
    }

    /// Enters a face with short edges below the rows in which these begin.
    #[cold]
    #[inline(never)]
    fn skip_rows_of_short_edges(&mut self, rows: i32, rows_of_third: i32) {
        self.left.skip_rows(rows);
        self.right.skip_rows(rows);
        self.third.skip_rows(rows_of_third.max(0));
    }

    /// The edges to the next row.
    #[inline(always)]
    pub(super) fn step_down(&mut self) {
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
    pub(super) fn take_turn(&mut self) -> bool {
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
pub(super) fn from_top<S: ScreenPrecision, D: DepthWidth>(
    [a, b, c]: [&ScreenVertex<S, D>; 3],
) -> [&ScreenVertex<S, D>; 3] {
    if a.y_units() <= b.y_units() && a.y_units() <= c.y_units() {
        [a, b, c]
    } else if b.y_units() <= c.y_units() {
        [b, c, a]
    } else {
        [c, a, b]
    }
}

/// The top corner, and where the next one clockwise (right) and the last one (left) are from there.
#[derive(Debug, Copy, Clone)]
pub(super) struct Sides {
    pub(super) top: Position,
    pub(super) right: Position,
    pub(super) left: Position,
}

impl Sides {
    /// Of corners in the order of [`from_top`].
    #[inline(always)]
    pub(super) fn of<S: ScreenPrecision, D: DepthWidth>(corners: [&ScreenVertex<S, D>; 3]) -> Self {
        let [top, right, left] = corners.map(|corner| corner.position());
        Self {
            top,
            right: right.minus(top),
            left: left.minus(top),
        }
    }
}

/// Where the edges of a face begin and end.
#[derive(Debug)]
pub(super) struct Rows {
    /// First row.
    pub(super) top: i32,
    /// On which side the edge between the two lower corners is.
    third_side: ThirdSide,
    /// First row of that edge.
    middle: i32,
    /// The row after the last one.
    pub(super) bottom: i32,
}

impl Rows {
    #[inline(always)]
    pub(super) fn of<S: ScreenPrecision>(sides: &Sides) -> Self {
        let Sides { top, right, left } = *sides;
        let (left_row, right_row) = (
            row_after::<S>(top.y.wrapping_add(left.y)),
            row_after::<S>(top.y.wrapping_add(right.y)),
        );
        Self {
            top: row_after::<S>(top.y),
            third_side: if left.y < right.y {
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
