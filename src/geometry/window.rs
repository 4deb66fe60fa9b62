//! A half-open rectangle of pixels that any embedded-graphics rectangle converts to without overflow.

use embedded_graphics::{
    geometry::{Point, Size},
    primitives::Rectangle,
};

use crate::geometry::{InputError, distance};

/// A rectangle of whole pixels: columns `left <= x < right`, rows `top <= y < bottom`.
///
/// The half-open form cannot hold column or row `i32::MAX`; no display is there. A window without pixels has
/// `left >= right` or `top >= bottom`.
///
/// ```
/// use embedded_graphics::{prelude::*, primitives::Rectangle};
/// use zrow::geometry::Window;
///
/// let panel = Window::from(Rectangle::new(Point::zero(), Size::new(240, 320)));
/// // A label that hangs over the right side: what of it is to be sent?
/// let label = Window::from(Rectangle::new(Point::new(200, 10), Size::new(80, 16)));
/// let visible = label.intersection(&panel);
/// assert_eq!(visible.to_rectangle(), Rectangle::new(Point::new(200, 10), Size::new(40, 16)));
/// assert!(visible.contains(Point::new(239, 25)) && !visible.contains(Point::new(240, 25)));
/// // No row of the label is in the band of the last 20 rows.
/// assert!(!label.meets(&Window { top: 300, ..panel }));
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Window {
    /// First column.
    pub left: i32,
    /// First row.
    pub top: i32,
    /// The column after the last one.
    pub right: i32,
    /// The row after the last one.
    pub bottom: i32,
}

impl Window {
    /// The box around the pixels of two windows.
    pub(crate) fn around(&self, other: &Self) -> Self {
        if self.is_empty() {
            return *other;
        }
        if other.is_empty() {
            return *self;
        }
        Self {
            left: self.left.min(other.left),
            top: self.top.min(other.top),
            right: self.right.max(other.right),
            bottom: self.bottom.max(other.bottom),
        }
    }

    /// The window without pixels.
    pub const EMPTY: Self = Self {
        left: 0,
        top: 0,
        right: 0,
        bottom: 0,
    };

    /// Whether the window contains no pixel.
    pub const fn is_empty(&self) -> bool {
        self.left >= self.right || self.top >= self.bottom
    }

    /// Number of columns; 0 for an empty window.
    pub const fn width(&self) -> u32 {
        if self.is_empty() {
            0
        } else {
            distance(self.left, self.right)
        }
    }

    /// Number of rows; 0 for an empty window.
    pub const fn height(&self) -> u32 {
        if self.is_empty() {
            0
        } else {
            distance(self.top, self.bottom)
        }
    }

    /// Whether the pixel is inside.
    pub const fn contains(&self, point: Point) -> bool {
        self.left <= point.x && point.x < self.right && self.top <= point.y && point.y < self.bottom
    }

    /// The pixels that are in both windows.
    pub fn intersection(&self, other: &Self) -> Self {
        Self {
            left: self.left.max(other.left),
            top: self.top.max(other.top),
            right: self.right.min(other.right),
            bottom: self.bottom.min(other.bottom),
        }
    }

    /// The window moved by some columns and rows; `None` where that leads beyond the number range.
    pub(crate) fn translated(&self, by: Point) -> Option<Self> {
        Some(Self {
            left: self.left.checked_add(by.x)?,
            top: self.top.checked_add(by.y)?,
            right: self.right.checked_add(by.x)?,
            bottom: self.bottom.checked_add(by.y)?,
        })
    }

    /// Checks that all pixels of a window that is not empty have coordinates between two ends, which are included.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] with these ends.
    pub(crate) fn check_domain(&self, (min, max): (i32, i32)) -> Result<(), InputError> {
        if min <= self.left.min(self.top) && self.right.max(self.bottom) - 1 <= max {
            Ok(())
        } else {
            Err(InputError::OutOfDomain { min, max })
        }
    }

    /// Whether a pixel is in both windows.
    pub fn meets(&self, other: &Self) -> bool {
        !self.intersection(other).is_empty()
    }

    /// Whether any of the `height` rows from `top` on, or of the `reach` rows above and below them, may lie in the
    /// window.
    ///
    /// A quick rejection of shapes that are not in a band: a dozen instructions, and no number overflows.
    #[inline]
    pub(crate) const fn may_meet_rows(&self, top: i32, height: u32, reach: u32) -> bool {
        if top >= self.bottom {
            return top.abs_diff(self.bottom) < reach;
        }
        if self.top < top {
            return true;
        }
        let down = self.top.abs_diff(top);
        down < height || down - height < reach
    }

    /// The window widened to whole multiples of so many columns and rows; 0 counts as 1. Where that leads beyond the
    /// number range, the window ends there.
    pub(crate) fn aligned(&self, columns: u32, rows: u32) -> Self {
        let (columns, rows) = (columns.max(1), rows.max(1));
        Self {
            left: align_down(self.left, columns),
            top: align_down(self.top, rows),
            right: align_up(self.right, columns),
            bottom: align_up(self.bottom, rows),
        }
    }

    /// The window with columns and rows exchanged.
    pub(crate) const fn transposed(&self) -> Self {
        Self {
            left: self.top,
            top: self.left,
            right: self.bottom,
            bottom: self.right,
        }
    }

    /// The pixels of the window as an embedded-graphics rectangle.
    pub const fn to_rectangle(&self) -> Rectangle {
        Rectangle::new(Point::new(self.left, self.top), Size::new(self.width(), self.height()))
    }
}

fn align_down(value: i32, grid: u32) -> i32 {
    let aligned = i64::from(value).div_euclid(i64::from(grid)) * i64::from(grid);
    i32::try_from(aligned).unwrap_or(i32::MIN)
}

fn align_up(value: i32, grid: u32) -> i32 {
    let grid = i64::from(grid);
    let aligned = (i64::from(value) + grid - 1).div_euclid(grid) * grid;
    i32::try_from(aligned).unwrap_or(i32::MAX)
}

impl From<Rectangle> for Window {
    /// The pixels of a rectangle; one that reaches beyond `i32::MAX` ends there.
    fn from(rectangle: Rectangle) -> Self {
        let Point { x, y } = rectangle.top_left;
        let Size { width, height } = rectangle.size;
        if width == 0 || height == 0 {
            return Self::EMPTY;
        }
        let end = |start: i32, length: u32| {
            // Wraps beyond the largest coordinate: two instructions fewer than a checked sum, for each shape in each row.
            let end = start.wrapping_add_unsigned(length);
            if end < start { i32::MAX } else { end }
        };
        Self {
            left: x,
            top: y,
            right: end(x, width),
            bottom: end(y, height),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rectangle_beyond_the_number_range_ends_there() {
        let window = Window::from(Rectangle::new(
            Point::new(i32::MAX - 2, i32::MIN),
            Size::new(u32::MAX, u32::MAX),
        ));
        assert_eq!(
            window,
            Window {
                left: i32::MAX - 2,
                top: i32::MIN,
                right: i32::MAX,
                bottom: i32::MAX
            }
        );
        assert_eq!(window.height(), u32::MAX);
    }

    #[test]
    fn rows_are_met_as_in_wider_numbers() {
        let ends = [i32::MIN, i32::MIN + 1, -9, -1, 0, 1, 7, i32::MAX - 1, i32::MAX];
        let lengths = [0, 1, 2, 9, i32::MAX as u32, u32::MAX - 1, u32::MAX];
        for (top, bottom) in ends.into_iter().flat_map(|top| ends.map(|bottom| (top, bottom))) {
            let window = Window {
                left: 0,
                top,
                right: 1,
                bottom,
            };
            for (first, height) in ends.into_iter().flat_map(|first| lengths.map(|height| (first, height))) {
                for reach in lengths {
                    let begin = i64::from(first) - i64::from(reach);
                    let end = i64::from(first) + i64::from(height) + i64::from(reach);
                    let meets = begin < i64::from(bottom) && i64::from(top) < end;
                    let found = window.may_meet_rows(first, height, reach);
                    // A window without rows has nothing to show, whatever the answer.
                    assert!(
                        found == meets || window.is_empty(),
                        "{window:?} {first} {height} {reach}"
                    );
                }
            }
        }
    }

    #[test]
    fn an_empty_rectangle_meets_nothing() {
        let empty = Window::from(Rectangle::new(Point::new(3, 3), Size::new(0, 5)));
        assert!(empty.is_empty());
        assert!(!empty.meets(&Window {
            left: 0,
            top: 0,
            right: 9,
            bottom: 9
        }));
    }
}
