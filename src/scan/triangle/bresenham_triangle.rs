//! embedded-graphics' triangle: three Bresenham lines and all pixels between them, row by row, without walking the lines.
//!
//! In each step of its major axis an edge has the pixel nearest to the exact line. Where two pixels are equally near (a
//! tie), it has the one nearer to the vertex that its walk begins at. A filled triangle walks each edge from its upper
//! vertex to its lower one. An outline is walked clockwise: right edges from top to bottom, left edges from bottom to top.
//!
//! ```text
//! corners (2,0) (4,4) (0,4): in rows 1 and 3 both slanted edges lie in the middle between two pixels
//!
//!   filled     outline
//!     #           #
//!     #          ##
//!    ###         # #
//!    ###        #  #
//!   #####       #####
//! ```
//!
//! Guarantees: embedded-graphics' pixels, where its numbers do not overflow, in any order of the vertices; a filled
//! triangle is its own mirror image where its vertices are; a clipped triangle has the pixels of the whole one inside the
//! window; any `i32` vertices; work bounded by the visible rows. A row takes from each edge the first or last pixel of its
//! run, stepped by quotient and remainder (Field 1985), so that flat edges cost a row no more than steep ones.

use core::num::{NonZeroU32, Wrapping};

use embedded_graphics::geometry::Point;

use crate::{
    geometry::{Window, distance, divide_wide},
    scan::{
        polygon::Edge,
        triangle::{
            small_triangle::{self, SmallTriangle},
            vertex_order::from_top_to_bottom,
        },
    },
    surface::{Span, Trapezoids},
};

/// Visible rows of a triangle.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Rows<'a> {
    /// One row, clipped, not empty.
    One(Span),
    /// All rows of a triangle that is not larger than a display.
    Many(&'a Trapezoids),
}

/// Hands over all visible rows: the edges and all between. Rows come top to bottom.
///
/// Cost: one division an edge for a triangle of at most 1,023 rows and columns, which comes all at once. Any other comes
/// row by row, for two divisions an edge (64-bit only where the products need it).
///
/// # Errors
/// The first error that `emit` returns.
#[inline]
pub fn fill<E>(
    vertices: &[Point; 3],
    window: &Window,
    mut emit: impl FnMut(Rows<'_>) -> Result<(), E>,
) -> Result<(), E> {
    match &small_triangle::visible(vertices, window) {
        SmallTriangle::Nothing => Ok(()),
        SmallTriangle::Rows(trapezoids) => emit(Rows::Many(trapezoids)),
        SmallTriangle::Unfit => {
            // Copies, so that those of a small triangle need not be in memory.
            let (vertices, window) = (*vertices, *window);
            fill_row_by_row(vertices, &window, |span| emit(Rows::One(span)))
        }
    }
}

/// Fills a triangle row by row: kept out of the code for small triangles, which are the many.
#[inline(never)]
fn fill_row_by_row<E>(
    vertices: [Point; 3],
    window: &Window,
    mut emit: impl FnMut(Span) -> Result<(), E>,
) -> Result<(), E> {
    let Some(triangle) = TriangleLines::visible(vertices, window) else {
        return Ok(());
    };
    let mut outer = triangle.walk(WalkedEnds::Outer, DOWNWARDS);
    let mut y = triangle.first_row;
    loop {
        let (left, right) = outer.row(&triangle, y);
        let span = clip(y, left, right, window);
        if !span.is_empty() {
            emit(span)?;
        }
        if y >= triangle.last_row {
            return Ok(());
        }
        y += 1;
        outer.advance();
    }
}

/// One row of an outline. Each span is clipped and may be empty; where the edges touch, all is in `left`.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OutlineRow {
    /// Pixels of the left edges.
    pub left: Span,
    /// Pixels between the edges.
    pub inside: Span,
    /// Pixels of the right edges.
    pub right: Span,
}

/// Hands over each visible row of a triangle's outline, the pixels of its edges apart from those between them. Rows come
/// top to bottom.
///
/// Cost: twice that of [`fill`].
///
/// # Errors
/// The first error that `emit` returns.
// Not inlined: two walks would be on the stack of a caller that draws several shapes.
#[inline(never)]
pub fn outline<E>(
    vertices: [Point; 3],
    window: &Window,
    mut emit: impl FnMut(OutlineRow) -> Result<(), E>,
) -> Result<(), E> {
    let Some((vertices, rows)) = visible_rows(vertices, window) else {
        return Ok(());
    };
    // Made in place: an optional triangle would be copied, and there is little stack.
    let triangle = TriangleLines::new(vertices, rows);
    let mut outer = triangle.walk(WalkedEnds::Outer, CLOCKWISE);
    let mut inner = triangle.walk(WalkedEnds::Inner, CLOCKWISE);
    for y in triangle.first_row..=triangle.last_row {
        let (left, right) = outer.row(&triangle, y);
        let (left_end, right_start) = inner.row(&triangle, y);
        let nothing = Span::new(y, 0, 0);
        // Two runs, where a pixel lies between them. Otherwise one: where both edges are on one line and have a tie, the
        // right edge may begin further left than the left edge, and the left edge may end further right.
        emit(if i64::from(right_start) - i64::from(left_end) > 1 {
            OutlineRow {
                left: clip(y, left, left_end, window),
                inside: clip(y, left_end + 1, right_start - 1, window),
                right: clip(y, right_start, right, window),
            }
        } else {
            OutlineRow {
                left: clip(y, left.min(right_start), right.max(left_end), window),
                inside: nothing,
                right: nothing,
            }
        })?;
        outer.advance();
        inner.advance();
    }
    Ok(())
}

/// Generates the edges around the pixels that [`fill`] would hand over, for the scan conversion of polygons.
///
/// Cost: that of setting up the triangle for each of its vertices' rows; for every visible row where its rightmost vertex is in
/// column `i32::MAX`.
pub fn edges(vertices: [Point; 3], window: &Window, sink: &mut dyn FnMut(Edge)) {
    let Some(mut triangle) = TriangleLines::visible(vertices, window) else {
        return;
    };
    // The edge right of the last column there is would be beyond the number range.
    let rightmost = triangle.top.x.max(triangle.middle.x).max(triangle.bottom.x);
    while triangle.first_row <= triangle.last_row {
        let y = triangle.first_row;
        let mut walk = triangle.walk(WalkedEnds::Outer, DOWNWARDS);
        if y == walk.special_row || rightmost == i32::MAX {
            let (left, right) = walk.row(&triangle, y);
            let end = y.saturating_add(1);
            sink(RunEnd::standing(left).edge(y, end, 0, true));
            sink(RunEnd::standing(right.saturating_add(1)).edge(y, end, 0, false));
            triangle.first_row = end;
        } else {
            let end = walk.special_row.min(triangle.last_row.saturating_add(1));
            sink(walk.left.edge(y, end, 0, true));
            sink(walk.right.edge(y, end, 1, false));
            triangle.first_row = end;
        }
    }
}

/// Pixels `left..=right` of a row that the window shows. The window is not empty.
#[inline(always)]
fn clip(y: i32, left: i32, right: i32, window: &Window) -> Span {
    Span::new(y, left.max(window.left), right.min(window.right - 1) + 1)
}

/// An end of the run of pixels that a line has in a row.
#[derive(Copy, Clone, PartialEq, Eq)]
enum RunEndSide {
    Left,
    Right,
}

/// Which ends of the runs of the left and right edges are walked: those away from each other, or those that face.
#[derive(Copy, Clone)]
enum WalkedEnds {
    /// The left edge's left ends and the right edge's right ends.
    Outer,
    /// The left edge's right ends and the right edge's left ends.
    Inner,
}

/// The vertex of an edge that its ties go to: the one where Bresenham's line would begin.
#[derive(Copy, Clone, PartialEq, Eq)]
enum Start {
    Top,
    Bottom,
}

/// Where the left and the right edges of a filled triangle begin.
const DOWNWARDS: [Start; 2] = [Start::Top, Start::Top];

/// Where the left and the right edges of an outline begin.
const CLOCKWISE: [Start; 2] = [Start::Bottom, Start::Top];

/// A triangle with rows in the window.
struct TriangleLines {
    top: Point,
    middle: Point,
    bottom: Point,
    long: TriangleLine,
    upper: TriangleLine,
    lower: TriangleLine,
    /// The side of the long edge on which the middle vertex lies.
    middle_side: RunEndSide,
    first_row: i32,
    last_row: i32,
}

impl TriangleLines {
    fn visible(vertices: [Point; 3], window: &Window) -> Option<Self> {
        let (vertices, rows) = visible_rows(vertices, window)?;
        Some(Self::new(vertices, rows))
    }

    /// The triangle of vertices in the order from top to bottom, with its first and its last visible row.
    #[inline(always)]
    fn new([top, middle, bottom]: [Point; 3], (first_row, last_row): (i32, i32)) -> Self {
        Self {
            top,
            middle,
            bottom,
            long: TriangleLine::new(top, bottom),
            upper: TriangleLine::new(top, middle),
            lower: TriangleLine::new(middle, bottom),
            middle_side: side_of(top, bottom, middle),
            first_row,
            last_row,
        }
    }

    fn walk(&self, ends: WalkedEnds, [left_start, right_start]: [Start; 2]) -> BoundaryWalk {
        let left_edges_end = match ends {
            WalkedEnds::Outer => RunEndSide::Left,
            WalkedEnds::Inner => RunEndSide::Right,
        };
        let right_edges_end = match ends {
            WalkedEnds::Outer => RunEndSide::Right,
            WalkedEnds::Inner => RunEndSide::Left,
        };
        let left = RunSide {
            end: left_edges_end,
            start: left_start,
        };
        let right = RunSide {
            end: right_edges_end,
            start: right_start,
        };
        let (short_side, long_side) = match self.middle_side {
            RunEndSide::Left => (left, right),
            RunEndSide::Right => (right, left),
        };
        let first_row = self.first_row;
        let long = self.long.run_end(long_side, first_row);
        let short = if first_row <= self.middle.y {
            self.upper.run_end(short_side, first_row)
        } else {
            self.lower.run_end(short_side, first_row)
        };
        let (left, right) = match self.middle_side {
            RunEndSide::Left => (short, long),
            RunEndSide::Right => (long, short),
        };
        let special_row = if first_row == self.top.y {
            first_row
        } else {
            self.special_row_from(first_row)
        };
        BoundaryWalk {
            left,
            right,
            short_side,
            long_side,
            special_row,
        }
    }

    /// The next row, from this one on, where a vertex other than the top one lies.
    fn special_row_from(&self, y: i32) -> i32 {
        if y <= self.middle.y {
            self.middle.y
        } else {
            self.bottom.y
        }
    }
}

/// The vertices from top to bottom, and the first and last visible row; `None` where nothing is visible.
fn visible_rows(vertices: [Point; 3], window: &Window) -> Option<([Point; 3], (i32, i32))> {
    if window.is_empty() {
        return None;
    }
    let [top, middle, bottom] = from_top_to_bottom(vertices);
    let first_row = top.y.max(window.top);
    let last_row = bottom.y.min(window.bottom - 1);
    let leftmost = top.x.min(middle.x).min(bottom.x);
    let rightmost = top.x.max(middle.x).max(bottom.x);
    if first_row > last_row || leftmost >= window.right || rightmost < window.left {
        return None;
    }
    Some(([top, middle, bottom], (first_row, last_row)))
}

/// Twice the area between three points, in square pixels; numbers that do not fit end at `u64::MAX`.
pub fn doubled_area([a, b, c]: [Point; 3]) -> u64 {
    // The difference of two products, of which only the signs and sizes fit.
    let product = |x: i32, from_x: i32, y: i32, from_y: i32| {
        let size = u64::from(x.abs_diff(from_x)) * u64::from(y.abs_diff(from_y));
        (size, (x < from_x) != (y < from_y))
    };
    let (one, one_is_negative) = product(b.x, a.x, c.y, a.y);
    let (other, other_is_negative) = product(c.x, a.x, b.y, a.y);
    if one_is_negative == other_is_negative {
        one.abs_diff(other)
    } else {
        one.saturating_add(other)
    }
}

/// The side of the line from `top` to `bottom` on which a point between their rows lies; on the line either will do.
fn side_of(top: Point, bottom: Point, point: Point) -> RunEndSide {
    let line_product = u64::from(top.x.abs_diff(bottom.x)) * u64::from(top.y.abs_diff(point.y));
    let point_product = u64::from(top.x.abs_diff(point.x)) * u64::from(top.y.abs_diff(bottom.y));
    let point_is_left = match (bottom.x < top.x, point.x < top.x) {
        (false, false) => line_product > point_product,
        (true, true) => line_product < point_product,
        (line_is_leftwards, _) => !line_is_leftwards,
    };
    if point_is_left {
        RunEndSide::Left
    } else {
        RunEndSide::Right
    }
}

/// What is walked of an edge: an end of its runs, and the vertex that its ties go to.
#[derive(Copy, Clone)]
struct RunSide {
    end: RunEndSide,
    start: Start,
}

/// Both boundaries of the triangle in one row, stepped from row to row.
struct BoundaryWalk {
    left: RunEnd,
    right: RunEnd,
    short_side: RunSide,
    long_side: RunSide,
    /// The next row where a vertex lies: runs end there with the line, and the short edges meet.
    special_row: i32,
}

impl BoundaryWalk {
    #[inline(always)]
    fn row(&mut self, triangle: &TriangleLines, y: i32) -> (i32, i32) {
        if y == self.special_row {
            self.row_of_a_vertex(triangle, y)
        } else {
            (self.left.x.0, self.right.x.0)
        }
    }

    #[inline(always)]
    fn advance(&mut self) {
        self.left.advance();
        self.right.advance();
    }

    #[inline(never)]
    fn row_of_a_vertex(&mut self, triangle: &TriangleLines, y: i32) -> (i32, i32) {
        let middle_is_left = triangle.middle_side == RunEndSide::Left;
        let (short, long) = if middle_is_left {
            (&mut self.left, &self.right)
        } else {
            (&mut self.right, &self.left)
        };
        let long_x = triangle.long.end_in_row(long, self.long_side.end, y);
        let short_x = if y == triangle.middle.y {
            let upper_x = triangle.upper.end_in_row(short, self.short_side.end, y);
            *short = triangle.lower.run_end(self.short_side, y);
            let lower_x = triangle.lower.end_in_row(short, self.short_side.end, y);
            match self.short_side.end {
                RunEndSide::Left => upper_x.min(lower_x),
                RunEndSide::Right => upper_x.max(lower_x),
            }
        } else if y < triangle.middle.y {
            triangle.upper.end_in_row(short, self.short_side.end, y)
        } else {
            triangle.lower.end_in_row(short, self.short_side.end, y)
        };
        self.special_row = triangle.special_row_from(y.saturating_add(1));
        if middle_is_left {
            (short_x, long_x)
        } else {
            (long_x, short_x)
        }
    }
}

/// A line from top to bottom (in one row: from left to right).
struct TriangleLine {
    top: Point,
    bottom: Point,
    columns: u32,
    rows: u32,
    leftwards: bool,
}

impl TriangleLine {
    fn new(top: Point, bottom: Point) -> Self {
        Self {
            top,
            bottom,
            columns: top.x.abs_diff(bottom.x),
            rows: top.y.abs_diff(bottom.y),
            leftwards: bottom.x < top.x,
        }
    }

    /// Whether that end of a run is the one nearer to the top of the line.
    fn is_near(&self, side: RunEndSide) -> bool {
        self.leftwards == (side == RunEndSide::Right)
    }

    /// The end of the run in row `y`, in rows of the line's ends too: there a run ends with the line.
    fn end_in_row(&self, run_end: &RunEnd, side: RunEndSide, y: i32) -> i32 {
        let near = self.is_near(side);
        if near && y == self.top.y {
            self.top.x
        } else if !near && y == self.bottom.y {
            self.bottom.x
        } else {
            run_end.x.0
        }
    }

    /// The end of the runs from row `y` on, entered exactly; in the rows of the line's ends only `end_in_row` is right.
    ///
    /// In row k of the line the run reaches `floor((k * columns + bias) / rows)` columns away from the top. The biases
    /// follow from the pixels' rule, the nearest one on the minor axis: a steep line has one pixel a row, the run of a flat
    /// line takes in what is nearer than half a row. The ties of one kind take the smaller offset, those of the other kind
    /// the larger one.
    fn run_end(&self, side: RunSide, y: i32) -> RunEnd {
        let Some(divisor) = NonZeroU32::new(self.rows) else {
            return RunEnd::standing(self.bottom.x);
        };
        let (columns, rows) = (self.columns, divisor.get());
        let (quotient, remainder) = (columns / divisor, columns % divisor);
        // Quotient and remainder of `row * columns + bias`, at most `rows * columns + columns`.
        let offset_of_sum = |row: u32, bias: (u32, u32)| self.offset_of_sum(row, bias, divisor);
        let offset = |row: u32, bias: u32| offset_of_sum(row, (bias, 0));
        let row = distance(self.top.y, y);
        let ties_to_bottom = u32::from(side.start == Start::Bottom);
        let (offset, error) = if columns < rows {
            offset(row, (rows - 1 + ties_to_bottom) >> 1)
        } else if self.is_near(side.end) {
            // The first column nearer than half a row: (row - 1/2) * columns / rows, rounded up where ties go to the bottom,
            // and up to the next one where they go to the top.
            let bias = ((columns >> 1) + (columns & ties_to_bottom), rows - ties_to_bottom);
            match row.checked_sub(1) {
                Some(row) => offset_of_sum(row, bias),
                // Unused itself, but the next row is stepped from it.
                None => step_back(offset_of_sum(0, bias), (quotient, remainder), rows),
            }
        } else {
            // The last column nearer than half a row: (row + 1/2) * columns / rows, rounded down where ties go to the top,
            // and down to the one before where they go to the bottom.
            offset(row, (columns - ties_to_bottom) >> 1)
        };
        let (top_x, columns) = (Wrapping(self.top.x), Wrapping(offset as i32));
        let step = Wrapping(quotient as i32);
        if self.leftwards {
            let exact = remainder == 0;
            RunEnd {
                x: top_x - columns,
                // The mirror image: rows - 1 - error, less the rows.
                error: Wrapping(!error),
                step: -step - Wrapping(i32::from(!exact)),
                error_step: if exact { 0 } else { rows - remainder },
                rows,
            }
        } else {
            RunEnd {
                x: top_x + columns,
                error: Wrapping(error) - Wrapping(rows),
                step,
                error_step: remainder,
                rows,
            }
        }
    }

    /// Quotient (which fits: it is a column of a line) and remainder of `row * columns`, the bias added, over the line's
    /// rows.
    fn offset_of_sum(&self, row: u32, bias: (u32, u32), rows: NonZeroU32) -> (u32, u32) {
        // Fits: each factor and bias is below 2^32.
        let dividend = u64::from(row) * u64::from(self.columns) + u64::from(bias.0) + u64::from(bias.1);
        divide_wide(dividend, rows)
    }
}

/// The offset and error term of the row before, modulo 2^32.
fn step_back(at: (u32, u32), step: (u32, u32), rows: u32) -> (u32, u32) {
    let (error, borrow) = at.1.overflowing_sub(step.1);
    let offset = Wrapping(at.0) - Wrapping(step.0) - Wrapping(u32::from(borrow));
    let corrected = Wrapping(error) + Wrapping(if borrow { rows } else { 0 });
    (offset.0, corrected.0)
}

/// One end of the runs of an edge, stepped from row to row. Columns are modulo 2^32: before the first row and after the last
/// one they may leave the number range, and are not used.
struct RunEnd {
    x: Wrapping<i32>,
    /// Remainder less `rows`: it overflows when a column more is due.
    error: Wrapping<u32>,
    step: Wrapping<i32>,
    error_step: u32,
    rows: u32,
}

impl RunEnd {
    const fn standing(x: i32) -> Self {
        Self {
            x: Wrapping(x),
            error: Wrapping(0),
            step: Wrapping(0),
            error_step: 0,
            rows: 0,
        }
    }

    /// The boundary as an edge of a polygon, `shift` columns to the right.
    fn edge(&self, row: i32, end_row: i32, shift: i32, downwards: bool) -> Edge {
        let (x, step) = (self.x + Wrapping(shift), (self.step.0, self.error_step));
        // A standing end has no rows, and takes no step.
        let rows = NonZeroU32::new(self.rows).unwrap_or(NonZeroU32::MIN);
        Edge::stepped((row, end_row), x.0, self.error.0, step, rows, downwards)
    }

    #[inline(always)]
    fn advance(&mut self) {
        self.x += self.step;
        let (error, carry) = self.error.0.overflowing_add(self.error_step);
        self.error = Wrapping(error);
        if carry {
            self.error -= self.rows;
            self.x += 1;
        }
    }
}
