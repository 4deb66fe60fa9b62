//! The thin outline of a circle or an ellipse as eight arcs, each entered where the window begins.
//!
//! On the two flat arcs of a quarter, seen from its own axis, the outline has one pixel in each step along that axis:
//!
//! ```text
//!            column 0
//!               |
//!   height b    # # #          the arc over the top, one pixel a column
//!               .     # #      ..................... up to its last column
//!               .         #    the arc over the side: the axes exchanged,
//!               .          #   one pixel a row
//!   center      + . . . .  #   row 0
//! ```
//!
//! A column belongs to the arc over the top while the outline is flatter than a diagonal there: at the exact point in the
//! middle of the column, or at the pixel that is nearest to it. On such an arc the height never grows with the column, so
//! what a window shows of it is one range of columns: both ends of the range follow from square roots, and nothing outside
//! the window is walked.
//!
//! Where both arcs of a quarter come to the same pixel, which is at most one, the arc over the top has it.

use embedded_graphics::geometry::Point;

use crate::geometry::Window;

/// An arc over the top of a circle or an ellipse, by distances from the center.
pub(crate) trait Arc {
    /// The last column in which the outline is flatter than a diagonal.
    fn last_column(&self) -> u32;

    /// The height of the pixel that is nearest to the outline in a column up to the last one of the outline.
    fn height(&self, column: u32) -> u32;

    /// The last column of the whole outline with a pixel of at least that height; `None` above the top.
    fn last_column_of(&self, height: u32) -> Option<u32>;
}

/// What decides on an arc whether the next column's pixel is lower.
pub(crate) trait Descent {
    /// The algorithm's own view of an arc.
    type Arc: Arc;

    /// Starts at a column and the height of its pixel.
    fn enter(arc: &Self::Arc, column: u32, height: u32) -> Self;

    /// Goes to the next column; whether its pixel is one lower.
    fn descends(&mut self) -> bool;
}

/// Distances from the center along an axis, towards larger or smaller coordinates, that are in the window.
///
/// Distance 0 counts as towards larger coordinates only, so that no pixel on an axis comes twice.
#[derive(Debug, Copy, Clone)]
struct Distances {
    first: u32,
    last: u32,
}

impl Distances {
    fn between(center: i32, backwards: bool, start: i32, end: i32) -> Option<Self> {
        let [center, start, end] = [center, start, end].map(i64::from);
        let (first, last) = if backwards {
            ((center - (end - 1)).max(1), center - start)
        } else {
            ((start - center).max(0), end - 1 - center)
        };
        // Two coordinates are less than 2^32 apart.
        (first <= last).then_some(Self {
            first: first as u32,
            last: last as u32,
        })
    }
}

/// The pixels of an outline inside a window, each once, arc by arc.
#[derive(Debug, Clone)]
pub(crate) struct ArcPixels<D: Descent> {
    center: Point,
    window: Window,
    /// Over the top, and over the side with the axes exchanged.
    arcs: [D::Arc; 2],
    /// The columns of each arc; the arc over the side has none where the other one has its only pixel.
    last_columns: [Option<u32>; 2],
    /// Number of the arc that comes next: bit 0 is backwards along its columns, bit 1 backwards along its heights, bit 2 the
    /// arc over the side.
    next_arc: u8,
    walk: Option<ArcWalk<D>>,
}

impl<D: Descent> ArcPixels<D> {
    /// The pixels of the outline that has one arc over the top and another one over the side.
    pub fn new(center: Point, top: D::Arc, side: D::Arc, window: &Window) -> Self {
        let (last_column, last_row) = (top.last_column(), side.last_column());
        let column = side.height(last_row);
        let is_shared = column <= last_column && top.height(column) == last_row;
        let last_side = if is_shared {
            last_row.checked_sub(1)
        } else {
            Some(last_row)
        };
        Self {
            center,
            window: *window,
            arcs: [top, side],
            last_columns: [Some(last_column), last_side],
            next_arc: if window.is_empty() { ARCS } else { 0 },
            walk: None,
        }
    }

    /// The visible columns of an arc.
    fn enter(&self, number: u8) -> Option<ArcWalk<D>> {
        let Self {
            center,
            window,
            arcs: [top, side],
            last_columns,
            ..
        } = self;
        let (backwards, downwards, over_side) = (number & 1 != 0, number & 2 != 0, number & 4 != 0);
        let (arc, last_column) = if over_side {
            (side, last_columns[1]?)
        } else {
            (top, last_columns[0]?)
        };
        let x = |backwards| Distances::between(center.x, backwards, window.left, window.right);
        let y = |backwards| Distances::between(center.y, backwards, window.top, window.bottom);
        let (columns, heights) = if over_side {
            (y(backwards)?, x(downwards)?)
        } else {
            (x(backwards)?, y(downwards)?)
        };
        let mut last = columns.last.min(last_column);
        if heights.first > 0 {
            last = last.min(arc.last_column_of(heights.first)?);
        }
        let too_high = heights
            .last
            .checked_add(1)
            .and_then(|height| arc.last_column_of(height));
        let first = columns.first.max(too_high.map_or(0, |column| column + 1));
        if first > last {
            return None;
        }
        let height = arc.height(first);
        let sign = |is_negative: bool| if is_negative { -1 } else { 1 };
        let exchanged = |point: Point| if over_side { Point::new(point.y, point.x) } else { point };
        // In the window, so the sums fit.
        let at = |center: i32, distance: u32, is_negative: bool| {
            (i64::from(center) + i64::from(sign(is_negative)) * i64::from(distance)) as i32
        };
        let center = exchanged(*center);
        Some(ArcWalk {
            point: exchanged(Point::new(
                at(center.x, first, backwards),
                at(center.y, height, downwards),
            )),
            along: exchanged(Point::new(sign(backwards), 0)),
            inwards: exchanged(Point::new(0, -sign(downwards))),
            columns_left: last - first,
            descent: D::enter(arc, first, height),
        })
    }
}

/// The number of arcs of a circle or an ellipse: two in each quarter.
const ARCS: u8 = 8;

impl<D: Descent> Iterator for ArcPixels<D> {
    type Item = Point;

    #[inline]
    fn next(&mut self) -> Option<Point> {
        loop {
            if let Some(walk) = &mut self.walk {
                let point = walk.point;
                if !walk.advance() {
                    self.walk = None;
                }
                return Some(point);
            }
            if self.next_arc == ARCS {
                return None;
            }
            self.walk = self.enter(self.next_arc);
            self.next_arc += 1;
        }
    }
}

/// An arc inside the window, at one of its pixels.
#[derive(Debug, Clone)]
struct ArcWalk<D> {
    /// The current pixel.
    point: Point,
    /// The step to the next column.
    along: Point,
    /// The step to the next lower height.
    inwards: Point,
    /// Columns behind this one that are visible.
    columns_left: u32,
    descent: D,
}

impl<D: Descent> ArcWalk<D> {
    /// Goes to the next visible pixel, if there is one.
    #[inline]
    fn advance(&mut self) -> bool {
        if self.columns_left == 0 {
            return false;
        }
        self.columns_left -= 1;
        self.point += self.along;
        if self.descent.descends() {
            self.point += self.inwards;
        }
        true
    }
}
