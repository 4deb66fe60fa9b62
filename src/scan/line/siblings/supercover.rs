//! The supercover of a segment: every cell that it touches, for marching through a grid (Amanatides and Woo 1987, "A Fast
//! Voxel Traversal Algorithm for Ray Tracing", Eurographics '87; supercover as Andres, Nehlig and Françon 1997 define it).
//!
//! Guarantees: a cell is the closed square around a pixel, its sides and corners included, and it belongs where the segment
//! between the two pixel centres has a point in common with it. So where the segment passes exactly through a corner, all
//! four cells there belong, and neighbouring cells always share a side: nothing slips through diagonally. Exact for any
//! `i32` end points; clipped is unclipped without the cells outside; the order of the end points changes the order of the
//! cells and not the cells.
//!
//! Amanatides and Woo compare, a cell at a time, how far along the segment the next column and the next row begin. Here
//! that comparison is the error term of Bresenham's line, moved by half a pixel: it says in which row the segment leaves
//! a column, and all cells up to there belong to the column.
//!
//! Cost: one division for each end that is cut (32-bit where the products fit); a comparison and a sum a column.
//!
//! Take it for line of sight, ray marching and collision on a grid of cells; as a drawn line it is too thick.

use core::{fmt::Debug, num::NonZeroU32};

use embedded_graphics::geometry::Point;

use crate::{
    geometry::{Window, quotient_down},
    scan::line::{
        kuzmin::{Distances, Slope, VisibleSteps, is_outside},
        lines::Lines,
    },
};

impl Lines {
    /// The visible pixels of the line between two pixels, both included, with every other pixel whose square the segment touches.
    ///
    /// Cells are closed squares around pixels, from the first pixel to the second; neighbouring ones share a side. Exact.
    ///
    /// Cost: one division for each end that is cut; a comparison and a sum a column. Source: Amanatides and Woo 1987; Andres,
    /// Nehlig and Françon 1997.
    ///
    /// ```
    /// use embedded_graphics::geometry::Point;
    /// use zrow::{geometry::Window, scan::Lines};
    ///
    /// let map = Window { left: 0, top: 0, right: 8, bottom: 8 };
    /// let wall = Point::new(2, 0);
    /// let mut cells = Lines::supercover(Point::new(0, 0), Point::new(4, 2), &map);
    /// assert!(cells.all(|cell| cell != wall));
    /// ```
    pub fn supercover(
        start: Point,
        end: Point,
        window: &Window,
    ) -> impl Iterator<Item = Point> + Clone + Debug + use<> {
        line(start, end, window).unwrap_or_default()
    }
}

/// The visible part of the line; `None` where no pixel of it is in the window.
fn line(from: Point, to: Point, window: &Window) -> Option<SupercoverCells> {
    if is_outside(from, to, window) {
        return None;
    }
    let (x, y) = (
        Axis::new(from.x, to.x, window.left, window.right)?,
        Axis::new(from.y, to.y, window.top, window.bottom)?,
    );
    let x_major = x.delta >= y.delta;
    let (major, minor) = if x_major { (x, y) } else { (y, x) };
    let leaving = leaving(&major, &minor);
    // A column shows cells from where it leaves into the window to where it still begins in it.
    let first = leaving.first_step_at(minor.visible.first)?.saturating_sub(1);
    let first = first.max(major.visible.first);
    let last = last_column_from(&leaving, minor.visible.last).min(major.visible.last);
    let columns = last.checked_sub(first)?;
    let entered = leaving.offset(first);
    Some(SupercoverCells {
        x_major,
        // Entering a column steps there. The column before the first one may lie beyond the number range.
        major: major.coordinate(first).wrapping_sub(major.step()),
        major_step: major.step(),
        columns: columns.saturating_add(1),
        minor_start: minor.start,
        minor_step: minor.step(),
        visible_first: minor.visible.first,
        visible_last: minor.visible.last.min(minor.delta),
        cells: 0,
        minor: 0,
        row: entered,
        error: leaving.error(&VisibleSteps {
            first,
            last,
            minor_offset: entered,
        }),
        rise: leaving.rise,
        until_next_row: leaving.run - leaving.rise,
        meets_corners: (major.delta ^ minor.delta) & 1 == 0,
    })
}

/// One axis of the segment, and how far along it the window shows the segment.
struct Axis {
    start: i32,
    backwards: bool,
    delta: u32,
    visible: Distances,
}

impl Axis {
    fn new(from: i32, to: i32, first: i32, end: i32) -> Option<Self> {
        let backwards = to < from;
        let visible = Distances::between(i64::from(from), backwards, first, end)?;
        let delta = from.abs_diff(to);
        (visible.first <= delta).then_some(Self {
            start: from,
            backwards,
            delta,
            visible: Distances {
                last: visible.last.min(delta),
                ..visible
            },
        })
    }

    fn step(&self) -> i32 {
        if self.backwards { -1 } else { 1 }
    }

    fn coordinate(&self, distance: u32) -> i32 {
        moved(self.start, distance, self.step())
    }
}

/// The coordinate `distance` away from `start`, in the direction of `step`. What is in the window fits 32 bits.
fn moved(start: i32, distance: u32, step: i32) -> i32 {
    if step < 0 {
        start.wrapping_sub_unsigned(distance)
    } else {
        start.wrapping_add_unsigned(distance)
    }
}

/// The row in which the segment enters a column, which is where it leaves the column before: half a column before its
/// centre, and half a row on because rows begin half before theirs, `floor((step * rise + (run - rise) / 2) / run)`.
fn leaving(major: &Axis, minor: &Axis) -> Slope {
    Slope {
        rise: minor.delta,
        run: major.delta,
        start: (major.delta - minor.delta) >> 1,
        steps: major.delta,
        end_offset: minor.delta,
    }
}

/// The last column that has a cell in `row` or a row before it; a corner of a cell is enough.
fn last_column_from(leaving: &Slope, row: u32) -> u32 {
    // A level segment begins and ends in its only row.
    let (false, Some(rise)) = (row >= leaving.end_offset, NonZeroU32::new(leaving.rise)) else {
        return leaving.steps;
    };
    // step * rise <= (row + 1) * run - (run - rise) / 2, which is at most (2^32 - 1)^2: fits u64.
    let half = leaving.run - leaving.rise - leaving.start;
    let target = (u64::from(row) + 1) * u64::from(leaving.run) - u64::from(half);
    quotient_down(target, rise)
}

/// The cells in the order in which the segment reaches them. At a corner that it passes through, the two cells beside
/// the corner come in between.
///
/// Columns here are those of the major axis, rows those of the minor axis, counted from the start of the segment.
#[derive(Debug, Clone, Default)]
struct SupercoverCells {
    x_major: bool,
    /// Coordinate of the column that is walked through; before the walk that of the column before the first one.
    major: i32,
    major_step: i32,
    /// Columns that are still to come.
    columns: u32,
    /// Coordinate of row 0.
    minor_start: i32,
    minor_step: i32,
    visible_first: u32,
    visible_last: u32,
    /// Cells of this column that are still to come, and the coordinate of the next of them.
    cells: u32,
    minor: i32,
    /// The row in which the next column is entered, and the error term there.
    row: u32,
    error: u32,
    rise: u32,
    /// `run - rise`: from this error on, the segment leaves the column in the next row.
    until_next_row: u32,
    /// Whether the segment can pass through a corner: only where both deltas are odd, or both even.
    meets_corners: bool,
}

impl SupercoverCells {
    /// Walks through the next column.
    fn enter_column(&mut self) {
        // Through a corner, the segment also touches the row before.
        let through_corner = self.meets_corners && self.error == 0;
        let first = self.row.saturating_sub(u32::from(through_corner));
        if self.error >= self.until_next_row {
            self.error -= self.until_next_row;
            self.row = self.row.saturating_add(1);
        } else {
            self.error += self.rise;
        }
        let first = first.max(self.visible_first);
        self.minor = moved(self.minor_start, first, self.minor_step);
        // The column is visible, so it has a cell.
        let last = self.row.min(self.visible_last);
        self.cells = (last - first).saturating_add(1);
        // The column before the first one wrapped if it lies beyond the number range: this is how it comes back.
        self.major = self.major.wrapping_add(self.major_step);
    }
}

impl Iterator for SupercoverCells {
    type Item = Point;

    #[inline]
    fn next(&mut self) -> Option<Point> {
        if self.cells == 0 {
            self.columns = self.columns.checked_sub(1)?;
            self.enter_column();
        }
        self.cells -= 1;
        let (major, minor) = (self.major, self.minor);
        // After the last cell of a column the coordinate is not used, and may leave the number range.
        self.minor = minor.wrapping_add(self.minor_step);
        Some(if self.x_major {
            Point::new(major, minor)
        } else {
            Point::new(minor, major)
        })
    }
}
