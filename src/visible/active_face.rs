//! A face that crosses the current row: its edges, walked row by row, and its depth plane.

use core::{fmt, num::Wrapping};

use crate::{
    geometry::Window,
    shade::{Planes, Shading},
    surface::{BandColor, PixelWord},
    view::{DepthWidth, EdgeSum, Position, ScreenPrecision, ScreenVertex},
    visible::{
        depth_plane::DepthPlane,
        edge::{CarryCorrections, Edge, EdgePair, PixelAfter, row_after},
        sides::Sides,
    },
};

/// On which side of a face the edge between its two lower corners takes over.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
enum ThirdSide {
    Left,
    Right,
}

/// The last row of a face, whether it is translucent, and the side of its third edge: in one integer, because the
/// active faces take most of the memory of a scene.
#[derive(Debug, Copy, Clone)]
struct Bottom(i16);

impl Bottom {
    const ZERO: Self = Self(0);

    /// The last row of a face which ends above a row, and the side of its third edge; the face is not translucent.
    #[inline(always)]
    fn above(row: i32, side: ThirdSide) -> Self {
        // Rows of the domain are below 2^13 in size.
        Self(((row << 2) + (side as i32 - (1 << 2))) as i16)
    }

    #[inline(always)]
    fn row(self) -> i32 {
        i32::from(self.0) >> 2
    }

    #[inline(always)]
    fn side(self) -> ThirdSide {
        if self.0 & 1 == ThirdSide::Left as i16 {
            ThirdSide::Left
        } else {
            ThirdSide::Right
        }
    }

    const TRANSLUCENT: i16 = 1 << 1;
}

/// Subtracted from the number of the row before a face's next event row to mark that each of its rows is an event row: below
/// the numbers of all rows, because those are below 2^13 in size.
const EACH_ROW: i16 = 1 << 14;

/// The word of a pixel with a shading.
pub type WordOf<H> = <<H as Shading>::Color as BandColor>::Word;

/// What an active face keeps of the attributes of a shading.
type PlanesOf<H> = <<H as Shading>::Attributes as Planes>::Planes;

// Not re-exported.
/// A face that crosses the row which is drawn.
pub struct ActiveFace<S: ScreenPrecision, H: Shading> {
    edges: EdgePair<S>,
    /// The edge between the two lower corners.
    third: Edge<S>,
    /// What is added to the sums of the left and the right edge in rows in which their error terms carry. Not used where both
    /// edges are short: those need no correction.
    carry_corrections: CarryCorrections<S>,
    pub(super) plane: DepthPlane,
    /// The face's index in the table of faces.
    pub(super) node: u16,
    /// The row before the next event row, which needs more than a step of the edges: the row before the third edge takes over,
    /// then the last row. With carry corrections each row is an event row: then this is less by [`EACH_ROW`], and so less than
    /// any row. The row before, because it is compared with a row that was just drawn.
    row_before_event: i16,
    bottom: Bottom,
    pub(super) word: WordOf<H>,
    pub(super) attributes: PlanesOf<H>,
}

impl<S: ScreenPrecision, H: Shading> fmt::Debug for ActiveFace<S, H> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut debug = formatter.debug_struct("ActiveFace");
        debug.field("node", &self.node).finish_non_exhaustive()
    }
}

#[cfg(feature = "defmt")]
impl<S: ScreenPrecision, H: Shading> defmt::Format for ActiveFace<S, H> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "ActiveFace {}", self.node);
    }
}

impl<S: ScreenPrecision, H: Shading> Copy for ActiveFace<S, H> {}

impl<S: ScreenPrecision, H: Shading> Clone for ActiveFace<S, H> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: ScreenPrecision, H: Shading> ActiveFace<S, H> {
    pub(super) const EMPTY: Self = Self {
        edges: EdgePair::EMPTY,
        third: Edge::EMPTY,
        carry_corrections: S::EdgeSum::NO_CARRY_CORRECTIONS,
        plane: DepthPlane::ZERO,
        node: 0,
        row_before_event: 0,
        bottom: Bottom::ZERO,
        word: WordOf::<H>::ZERO,
        attributes: H::Attributes::NO_PLANES,
    };
}

/// The parts of a face that are not small and still have to be set up: bits, because they are returned in a register.
pub(super) type LeftOver = u32;
pub(super) const NOTHING: LeftOver = 0;
const PLANE: LeftOver = 1;
const EDGES: LeftOver = 2;

/// What a face is set up for.
#[derive(Debug)]
pub(super) struct Surroundings<'v, P = ()> {
    pub(super) viewport: &'v Window,
    /// The first column of the row that is drawn, from which columns count.
    pub(super) first_column: i32,
    /// Whether the face needs no depth plane.
    pub(super) without_plane: bool,
    /// The position in each pixel at which the face is looked at: the centre, or a distance from it.
    pub(super) sample: P,
}

impl<S: ScreenPrecision, H: Shading> ActiveFace<S, H> {
    /// Sets up the edges of a face without attributes for its first row, and its depth plane, from its corners, clockwise, as
    /// far as it is small. Returns the parts that are left.
    // A function of its own, because it needs all registers.
    #[inline(never)]
    pub(super) fn set_up_small<D: DepthWidth>(
        &mut self,
        a: &ScreenVertex<S, D>,
        b: &ScreenVertex<S, D>,
        c: &ScreenVertex<S, D>,
        surroundings: &Surroundings<'_>,
    ) -> LeftOver {
        let corners = from_top([a, b, c]);
        let sides = Sides::of(corners, surroundings.first_column);
        if Edge::<S>::MAY_BE_SHORT && !Self::are_short(&sides) {
            return if surroundings.without_plane {
                EDGES
            } else {
                PLANE | EDGES
            };
        }
        let mut left_over = NOTHING;
        if !surroundings.without_plane {
            match DepthPlane::small(corners, &sides, Edge::<S>::MAY_BE_SHORT) {
                Some(plane) => self.plane = plane,
                None => left_over = PLANE,
            }
        }
        if Edge::<S>::MAY_BE_SHORT {
            self.set_up_short_edges(&sides);
        } else {
            self.set_up_edges::<true>(&sides, row_after::<S>(sides.top.y));
        }
        left_over
    }

    /// Sets up the edges of a face for its first row, as far as they are short. Returns whether they are left.
    #[inline(always)]
    pub(super) fn set_up_small_edges(&mut self, sides: &Sides) -> LeftOver {
        if !Edge::<S>::MAY_BE_SHORT {
            self.set_up_edges::<true>(sides, row_after::<S>(sides.top.y));
        } else if Self::are_short(sides) {
            self.set_up_short_edges(sides);
        } else {
            return EDGES;
        }
        NOTHING
    }

    /// Sets up what is left over, from the corners as [`from_top`] has them.
    pub(super) fn set_up_rest<D: DepthWidth>(
        &mut self,
        left_over: LeftOver,
        corners: [&ScreenVertex<S, D>; 3],
        surroundings: &Surroundings<'_>,
    ) {
        let Surroundings {
            viewport, first_column, ..
        } = *surroundings;
        let sides = Sides::of(corners, first_column);
        // With attributes, the plane of the depth is set up together with theirs.
        if !H::Attributes::VARY && left_over & PLANE != 0 {
            // Without short edges it was tried before.
            let small = if Edge::<S>::MAY_BE_SHORT {
                DepthPlane::small(corners, &sides, false)
            } else {
                None
            };
            self.plane = small.unwrap_or_else(|| DepthPlane::wide(corners, viewport, first_column));
        }
        if left_over & EDGES != 0 {
            self.set_up_long_edges(&sides, row_after::<S>(sides.top.y));
        }
    }

    /// Sets up the edges as they are in the first row of the face, which are short.
    #[inline(always)]
    fn set_up_short_edges(&mut self, sides: &Sides) {
        let Sides { top, right, left } = *sides;
        let down = PixelAfter::of::<S>(top).down;
        self.edges.set_left(Edge::short(top.x, left, down));
        self.edges.set_right(Edge::short(top.x, right, down));
        let rows = self.turn_at(sides);
        if rows.middle < rows.bottom {
            let (middle, bottom) = rows.third_edge(sides);
            let corner = top.plus(middle);
            self.third = Edge::short(corner.x, bottom.minus(middle), PixelAfter::of::<S>(corner).down);
            if rows.middle == row_after::<S>(top.y) {
                // The edge above the middle crosses no row.
                self.take_third_edge(rows.third_side);
                self.row_before_event = (rows.bottom - 1) as i16;
            }
        }
    }

    /// Sets up edges as they are in a row, not all of them short.
    #[cold]
    #[inline(never)]
    fn set_up_long_edges(&mut self, sides: &Sides, row: i32) {
        self.set_up_edges::<false>(sides, row);
    }

    /// Sets up any edges as they are in a row, with code for each of them or with one copy.
    #[inline(always)]
    fn set_up_edges<const IN_LINE: bool>(&mut self, sides: &Sides, row: i32) {
        let Sides { top, right, left } = *sides;
        let (left_edge, left_carry_correction) = Edge::new::<IN_LINE>(top, left, row);
        let (right_edge, right_carry_correction) = Edge::new::<IN_LINE>(top, right, row);
        self.edges.set_left(left_edge);
        self.edges.set_right(right_edge);
        self.carry_corrections = S::EdgeSum::carry_corrections(left_carry_correction, right_carry_correction);
        let rows = self.turn_at(sides);
        if rows.middle < rows.bottom {
            let (middle, bottom) = rows.third_edge(sides);
            let first = row.max(rows.middle);
            (self.third, _) = Edge::new::<IN_LINE>(top.plus(middle), bottom.minus(middle), first);
        }
        if row >= rows.middle {
            self.end_long_edge(rows.middle - 1);
        }
        if Edge::<S>::MAY_BE_SHORT {
            self.row_before_event -= EACH_ROW;
        }
    }

    /// The next face in the list: kept in the field of the depth plane, because faces in the list have none.
    #[inline(always)]
    pub(super) fn next(&self) -> u16 {
        self.plane.origin.0 as u16
    }

    #[inline(always)]
    pub(super) fn set_next(&mut self, next: u16) {
        self.plane.origin = Wrapping(next.into());
    }

    /// The next free slot, once the face has ended: kept in `row_before_event`, because the depth plane may still be needed.
    #[inline(always)]
    pub(super) fn next_free(&self) -> u16 {
        self.row_before_event as u16
    }

    #[inline(always)]
    pub(super) fn set_next_free(&mut self, next: u16) {
        self.row_before_event = next as i16;
    }

    /// The middle of the face's span, and twice its step from row to row: these order disjoint spans by columns,
    /// also those that begin in the same point.
    #[inline(always)]
    pub(super) fn middle(&self) -> [S::EdgeSum; 2] {
        self.edges.middle()
    }

    /// Sets the rows in which edges end.
    #[inline(always)]
    fn turn_at(&mut self, sides: &Sides) -> EdgeRows {
        let rows = EdgeRows::of::<S>(sides);
        let is_translucent = self.is_translucent();
        self.bottom = Bottom::above(rows.bottom, rows.third_side);
        if is_translucent {
            // Edges are set up once more where a face is entered below its first row.
            self.set_translucent(true);
        }
        self.row_before_event = (rows.middle - 1) as i16;
        rows
    }

    /// Steps a face from its first row down to another row. Returns `false` where that is after its last row.
    #[inline(never)]
    pub(super) fn enter(&mut self, sides: &Sides, row: i32) -> bool {
        if row > self.bottom.row() {
            return false;
        }
        let first = row_after::<S>(sides.top.y);
        if Edge::<S>::MAY_BE_SHORT && !self.has_carry_corrections() {
            // At most 62.
            for reached in first..row {
                self.next_span();
                self.leave_row_seldom(reached);
            }
        } else {
            self.set_up_long_edges(sides, row);
        }
        true
    }

    /// Sets the span up for one row alone, by the sides of the face. It has no columns where the face does not cross the row.
    #[inline]
    pub(super) fn set_up_span(&mut self, sides: &Sides, row: i32) {
        let Sides { top, right, left } = *sides;
        let rows = EdgeRows::of::<S>(sides);
        if row < row_after::<S>(top.y) || row >= rows.bottom {
            self.edges = EdgePair::EMPTY;
            return;
        }
        let (mut left_edge, mut right_edge) = ((top, left), (top, right));
        if row >= rows.middle {
            let (middle, bottom) = rows.third_edge(sides);
            let third = (top.plus(middle), bottom.minus(middle));
            if rows.third_side == ThirdSide::Left {
                left_edge = third;
            } else {
                right_edge = third;
            }
        }
        self.edges.set_left(Edge::in_row(left_edge.0, left_edge.1, row));
        self.edges.set_right(Edge::in_row(right_edge.0, right_edge.1, row));
    }

    /// The last row.
    #[inline]
    pub(super) fn last_row(&self) -> i32 {
        self.bottom.row()
    }

    /// Sets the last row, of a face whose span is set up for each row.
    #[inline]
    pub(super) fn end_after(&mut self, row: i32) {
        self.bottom = Bottom::above(row + 1, ThirdSide::Right);
    }

    /// The columns of the face's span in the current row.
    #[inline]
    pub(super) fn span(&self) -> [i32; 2] {
        self.edges.columns()
    }

    /// Whether the face is mixed with what is behind it, once it is set up.
    #[inline]
    pub(super) fn is_translucent(&self) -> bool {
        H::BLENDS && self.bottom.0 & Bottom::TRANSLUCENT != 0
    }

    /// Says of a face that is set up whether it is mixed with what is behind it.
    #[inline]
    pub(super) fn set_translucent(&mut self, is_translucent: bool) {
        if H::BLENDS {
            self.bottom.0 &= !Bottom::TRANSLUCENT;
            self.bottom.0 |= if is_translucent { Bottom::TRANSLUCENT } else { 0 };
        }
    }

    #[inline(always)]
    fn are_short(sides: &Sides) -> bool {
        Edge::<S>::MAY_BE_SHORT && Edge::<S>::are_short([sides.right, sides.left])
    }

    /// Overwrites the slot of another face with this one.
    // A function of its own, for which the compiler knows that the two do not overlap: else it would call `memmove`.
    #[inline(never)]
    pub(super) fn move_to(&self, other: &mut Self) {
        if !H::Attributes::VARY {
            *other = *self;
            return;
        }
        // Part by part: all of it at once is a call of `memcpy`, which many programs do not have otherwise.
        let Self {
            edges,
            third,
            carry_corrections,
            plane,
            node,
            row_before_event,
            bottom,
            word,
            attributes,
        } = self;
        (other.edges, other.third, other.carry_corrections) = (*edges, *third, *carry_corrections);
        (other.plane, other.node, other.row_before_event) = (*plane, *node, *row_before_event);
        (other.bottom, other.word, other.attributes) = (*bottom, *word, *attributes);
    }

    /// The columns of the face's span in the current row; steps its edges to the next row.
    #[inline(always)]
    pub(super) fn next_span(&mut self) -> [i32; 2] {
        let columns = self.edges.columns();
        self.edges.step_down();
        if !Edge::<S>::MAY_BE_SHORT {
            self.edges.carry_correction(self.carry_corrections);
        }
        columns
    }

    /// Completes the step of [`next_span`](Self::next_span) out of a row, if the one below it is an event row. Returns `false`
    /// where the face has ended.
    #[inline(always)]
    pub(super) fn leave_row(&mut self, row: i32) -> bool {
        row < i32::from(self.row_before_event) || self.take_event(row)
    }

    /// [`leave_row`](Self::leave_row) for callers that seldom need it: a cold copy of its own, so that the frequent call
    /// stays inlined.
    #[cold]
    #[inline(never)]
    pub(super) fn leave_row_seldom(&mut self, row: i32) -> bool {
        self.leave_row(row)
    }

    /// Handles the event row below a row: the end of an edge, or carry corrections. Returns `false` where the face has ended.
    #[inline(always)]
    fn take_event(&mut self, row: i32) -> bool {
        if !Edge::<S>::MAY_BE_SHORT {
            self.end_long_edge(row)
        } else if row == self.bottom.row() {
            // Most often so: asked first.
            false
        } else if self.has_carry_corrections() {
            self.take_event_with_carry_corrections(row)
        } else {
            self.end_short_edge(row)
        }
    }

    #[inline(never)]
    fn take_event_with_carry_corrections(&mut self, row: i32) -> bool {
        self.edges.carry_correction(self.carry_corrections);
        if row == i32::from(self.row_before_event + EACH_ROW) {
            if !self.end_long_edge(row) {
                return false;
            }
            self.row_before_event -= EACH_ROW;
        }
        true
    }

    /// Whether the edges have carry corrections.
    #[inline(always)]
    fn has_carry_corrections(&self) -> bool {
        Edge::<S>::MAY_BE_SHORT && self.row_before_event < -EACH_ROW / 2
    }

    /// Exchanges an edge whose last row this is for the third one, without what it adds after a carry. `false` where the face
    /// has ended.
    #[inline(always)]
    fn end_short_edge(&mut self, row: i32) -> bool {
        if row == self.bottom.row() {
            return false;
        }
        self.row_before_event = self.bottom.row() as i16;
        self.take_third_edge(self.bottom.side());
        true
    }

    /// Exchanges the edge on a side for the third one.
    #[inline(always)]
    fn take_third_edge(&mut self, side: ThirdSide) {
        if side == ThirdSide::Left {
            self.edges.set_left(self.third);
        } else {
            self.edges.set_right(self.third);
        }
    }

    /// Exchanges an edge whose last row this is for the third one, with its carry correction, which follows from those of
    /// the left and the right edge: one of these is as high as the other one and the third together. `false` where the face
    /// has ended.
    #[inline(never)]
    fn end_long_edge(&mut self, row: i32) -> bool {
        if !self.end_short_edge(row) {
            return false;
        }
        let (left, right) = (
            S::EdgeSum::left_carry_correction(self.carry_corrections),
            S::EdgeSum::right_carry_correction(self.carry_corrections),
        );
        self.carry_corrections = if self.bottom.side() == ThirdSide::Left {
            S::EdgeSum::carry_corrections(S::EdgeSum::carry_correction_of_rest(right, left), right)
        } else {
            S::EdgeSum::carry_corrections(left, S::EdgeSum::carry_correction_of_rest(left, right))
        };
        true
    }
}

/// The corners as the rows meet them: the top, the one clockwise after it (right), the last (left).
#[inline(always)]
pub(super) fn from_top<S: ScreenPrecision, D: DepthWidth>(
    corners: [&ScreenVertex<S, D>; 3],
) -> [&ScreenVertex<S, D>; 3] {
    in_order_of_rows(corners, corners)
}

/// What belongs to the corners of a face, in the order in which [`from_top`] has the corners.
#[inline(always)]
pub(super) fn in_order_of_rows<S: ScreenPrecision, D: DepthWidth, T>(
    [first, second, third]: [&ScreenVertex<S, D>; 3],
    [a, b, c]: [T; 3],
) -> [T; 3] {
    if first.y_units() <= second.y_units() && first.y_units() <= third.y_units() {
        [a, b, c]
    } else if second.y_units() <= third.y_units() {
        [b, c, a]
    } else {
        [c, a, b]
    }
}

/// Where the edges of a face end.
#[derive(Debug)]
struct EdgeRows {
    /// On which side the edge between the two lower corners is.
    third_side: ThirdSide,
    /// First row of that edge.
    middle: i32,
    /// The row after the last one.
    bottom: i32,
}

impl EdgeRows {
    #[inline(always)]
    fn of<S: ScreenPrecision>(sides: &Sides) -> Self {
        let Sides { top, right, left } = *sides;
        let (third_side, middle, bottom) = if left.y < right.y {
            (ThirdSide::Left, left.y, right.y)
        } else {
            (ThirdSide::Right, right.y, left.y)
        };
        Self {
            third_side,
            middle: row_after::<S>(top.y + middle),
            bottom: row_after::<S>(top.y + bottom),
        }
    }

    /// The ends of the third edge: the middle and the bottom corner.
    #[inline(always)]
    fn third_edge(&self, sides: &Sides) -> (Position, Position) {
        if self.third_side == ThirdSide::Left {
            (sides.left, sides.right)
        } else {
            (sides.right, sides.left)
        }
    }
}
