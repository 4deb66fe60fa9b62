//! The box of a shape that a stroke makes larger or smaller, without overflow.

use embedded_graphics::{
    geometry::{Point, Size},
    primitives::Rectangle,
};

use crate::geometry::Window;

/// A box of pixels whose top left corner may lie outside the number range of a `Point`: within 2^34 of zero, where moving
/// the sides of a `Rectangle` once leads at most.
///
/// Growing and shrinking keep the centre, as embedded-graphics' `OffsetOutline` does.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct WideRectangle {
    /// First column.
    pub left: i64,
    /// First row.
    pub top: i64,
    /// Number of columns and of rows.
    pub size: Size,
}

impl WideRectangle {
    /// Moves each side outwards by that many pixels.
    ///
    /// A size ends at `u32::MAX`: where it would become larger, its sides move by less. A size of 0 has its centre half a
    /// pixel behind its position, which is where embedded-graphics has it.
    #[must_use]
    pub fn outset(self, by: u32) -> Self {
        self.resized(
            |length| outset_length(length, by),
            |position, moved| position - i64::from(moved),
        )
    }

    /// Moves each side inwards by that many pixels; a size that has no more pixels to give is 0.
    #[must_use]
    pub fn inset(self, by: u32) -> Self {
        self.resized(
            |length| inset_length(length, by),
            |position, moved| position + i64::from(moved),
        )
    }

    /// Changes width and height: `length` returns how far the position moves and the new length, `moved` moves the
    /// position on its axis.
    #[inline]
    fn resized(self, length: impl Fn(u32) -> (u32, u32), moved: impl Fn(i64, u32) -> i64) -> Self {
        let (right, width) = length(self.size.width);
        // Squares are the most frequent ones.
        let (down, height) = if self.size.height == self.size.width {
            (right, width)
        } else {
            length(self.size.height)
        };
        Self {
            left: moved(self.left, right),
            top: moved(self.top, down),
            size: Size::new(width, height),
        }
    }

    /// The rectangle with columns and rows exchanged.
    #[must_use]
    pub const fn transposed(self) -> Self {
        Self {
            left: self.top,
            top: self.left,
            size: Size::new(self.size.height, self.size.width),
        }
    }

    /// Whether the rectangle contains no pixel.
    pub const fn is_empty(&self) -> bool {
        self.size.width == 0 || self.size.height == 0
    }

    /// The pixels of the rectangle that have `i32` coordinates, as embedded-graphics' rectangle.
    pub fn to_rectangle(self) -> Rectangle {
        let (x, width) = clamp_axis(self.left, self.size.width);
        let (y, height) = clamp_axis(self.top, self.size.height);
        Rectangle::new(Point::new(x, y), Size::new(width, height))
    }

    /// The pixels of the rectangle that have `i32` coordinates, as a window.
    pub fn to_window(self) -> Window {
        self.to_rectangle().into()
    }
}

impl From<Rectangle> for WideRectangle {
    fn from(rectangle: Rectangle) -> Self {
        Self {
            left: i64::from(rectangle.top_left.x),
            top: i64::from(rectangle.top_left.y),
            size: rectangle.size,
        }
    }
}

/// How far the position moves outwards, and the new length, where both sides of a length move outwards by `by` pixels.
fn outset_length(length: u32, by: u32) -> (u32, u32) {
    let by = by.min((u32::MAX - length) / 2);
    (if length == 0 { by.saturating_sub(1) } else { by }, length + 2 * by)
}

/// How far the position moves inwards, and the new length, where both sides of a length move inwards by `by` pixels.
fn inset_length(length: u32, by: u32) -> (u32, u32) {
    let by_at_most = length.saturating_sub(1) / 2;
    if by > by_at_most {
        (by_at_most, 0)
    } else {
        // Not more than the length, also where that is 0.
        (by, length - 2 * by)
    }
}

fn clamp_axis(start: i64, length: u32) -> (i32, u32) {
    if start > i64::from(i32::MAX) {
        return (i32::MAX, 0);
    }
    let first = start.max(i64::from(i32::MIN));
    let end = (start + i64::from(length)).max(first);
    // Between 0 and `length`, and `first` is a coordinate: both narrowings are exact.
    (first as i32, (end - first) as u32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn growing_and_shrinking_follow_embedded_graphics() {
        for width in 0..6 {
            for height in 0..6 {
                let rectangle = Rectangle::new(Point::new(-7, 9), Size::new(width, height));
                for offset in 0..9 {
                    let wide = WideRectangle::from(rectangle);
                    assert_eq!(wide.outset(offset).to_rectangle(), rectangle.offset(offset as i32));
                    assert_eq!(wide.inset(offset).to_rectangle(), rectangle.offset(-(offset as i32)));
                }
            }
        }
    }

    #[test]
    fn the_largest_rectangle_stays_in_the_number_range() {
        let wide = WideRectangle::from(Rectangle::new(
            Point::new(i32::MIN, i32::MAX),
            Size::new(u32::MAX - 4, 0),
        ));
        let grown = wide.outset(u32::MAX);
        assert_eq!(grown.size, Size::new(u32::MAX, u32::MAX - 1));
        assert_eq!(grown.left, i64::from(i32::MIN) - 2);
        assert_eq!(
            grown.to_rectangle(),
            Rectangle::new(Point::new(i32::MIN, 1), Size::new(u32::MAX - 2, u32::MAX - 1))
        );
    }

    /// Boxes of any position and size keep the pixels that have coordinates, and no others.
    #[test]
    fn the_part_with_coordinates_is_exact() {
        let ends = [i32::MIN, i32::MIN + 1, -7, 0, 9, i32::MAX - 1, i32::MAX].map(i64::from);
        let lengths = [0, 1, 2, 9, u32::MAX / 2, u32::MAX - 1, u32::MAX];
        let coordinates = i64::from(i32::MIN)..i64::from(i32::MAX) + 1;
        for left in ends
            .into_iter()
            .flat_map(|end| [end - (1 << 33), end - 3, end, end + 1, end + (1 << 33)])
        {
            for (width, by) in lengths.into_iter().flat_map(|width| lengths.map(|by| (width, by))) {
                let wide = WideRectangle {
                    left,
                    top: 0,
                    size: Size::new(width, 1),
                };
                for wide in [wide, wide.outset(by), wide.inset(by)] {
                    let rectangle = wide.to_rectangle();
                    let part = |left: i64, width: u32| {
                        let end = (left + i64::from(width)).min(coordinates.end);
                        let first = left.max(coordinates.start);
                        (first < end).then_some((first, end))
                    };
                    assert_eq!(
                        part(rectangle.top_left.x.into(), rectangle.size.width),
                        part(wide.left, wide.size.width),
                        "{wide:?} is {rectangle:?}"
                    );
                }
            }
        }
    }
}
