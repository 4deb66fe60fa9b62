//! Half planes between the directions of angles, row by row: which columns of a row lie in one.

use core::{f32::consts::TAU, num::NonZeroU32};

use embedded_graphics::{geometry::Angle, primitives::Rectangle};
use micromath::F32Ext;

use crate::geometry::divide_floor_wide;

/// The length of a normal vector.
pub const NORMAL_LENGTH: i32 = 1 << 10;

/// The middle of a box of pixels, in half pixels: twice its column and twice its row. Both are below 2^34.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Center {
    pub(crate) x_2: i64,
    pub(crate) y_2: i64,
}

impl Center {
    /// The middle of a rectangle, which stays where it is when the rectangle grows or shrinks by as much on all sides.
    ///
    /// A size of 0 has its centre half a pixel behind the position, as embedded-graphics has it.
    pub fn of(rectangle: &Rectangle) -> Self {
        let middle = |start: i32, length: u32| {
            let last = match length {
                0 => 1,
                _ => i64::from(length) - 1,
            };
            2 * i64::from(start) + last
        };
        Self {
            x_2: middle(rectangle.top_left.x, rectangle.size.width),
            y_2: middle(rectangle.top_left.y, rectangle.size.height),
        }
    }

    /// The centre with columns and rows exchanged.
    #[must_use]
    pub(crate) const fn transposed(self) -> Self {
        Self {
            x_2: self.y_2,
            y_2: self.x_2,
        }
    }
}

/// The columns `start <= x < end` of a row.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Columns {
    /// First column.
    pub start: i32,
    /// The column after the last one.
    pub end: i32,
}

impl Columns {
    /// Whether a column lies in the range.
    pub const fn contains(&self, x: i32) -> bool {
        self.start <= x && x < self.end
    }

    /// Whether there are no columns.
    pub const fn is_empty(&self) -> bool {
        self.start >= self.end
    }

    /// The columns that lie in both ranges.
    #[must_use]
    pub fn intersection(self, other: Self) -> Self {
        Self {
            start: self.start.max(other.start),
            end: self.end.min(other.end),
        }
    }
}

/// The points whose product with a normal vector is not less than a limit; distances from the centre in half pixels.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct HalfPlane {
    /// The half plane's normal vector, each component at most [`NORMAL_LENGTH`].
    pub(crate) normal: (i32, i32),
    /// The limit: the least product of a point of the half plane with its normal vector, within [`FARTHEST`].
    pub(crate) least: i64,
}

/// No point is as far from a line through the centre, times [`NORMAL_LENGTH`]: distances are below 2^36 half pixels.
const FARTHEST: i64 = 1 << 50;

impl HalfPlane {
    /// The points to the right of a line from the centre, as one looks along an angle, and on it. The line is moved to the
    /// left by `beyond` half pixels times [`NORMAL_LENGTH`], or to the right where that is negative.
    pub fn right_of(angle: Angle, beyond: i64) -> Self {
        Self::new(normal(angle), beyond)
    }

    /// The points to the left of a line from the centre, and on it. The line is moved to the right by `beyond` half pixels
    /// times [`NORMAL_LENGTH`], or to the left where that is negative.
    pub fn left_of(angle: Angle, beyond: i64) -> Self {
        let (x, y) = normal(angle);
        Self::new((-x, -y), beyond)
    }

    fn new(normal: (i32, i32), beyond: i64) -> Self {
        // Further out, a line has all points on one side wherever it is.
        let least = -beyond.clamp(-FARTHEST, FARTHEST);
        Self { normal, least }
    }

    /// The half plane with columns and rows exchanged.
    #[must_use]
    pub(crate) const fn transposed(self) -> Self {
        let (x, y) = self.normal;
        Self { normal: (y, x), ..self }
    }

    /// The half plane on the other side of the line, with the points on the line.
    #[must_use]
    pub(crate) const fn opposite(self) -> Self {
        let (x, y) = self.normal;
        Self {
            normal: (-x, -y),
            least: -self.least,
        }
    }

    /// The columns of a row that are in the half plane, of those that are visible.
    pub fn columns(&self, center: Center, y: i32, visible: Columns) -> Columns {
        // Rows and centres are below 2^34, normals below 2^11, so what follows is below 2^52.
        let rest = self.least - i64::from(self.normal.1) * (2 * i64::from(y) - center.y_2);
        // Reversed columns stay without a column.
        let clamp = |x: i64| x.max(visible.start.into()).min(visible.end.into()) as i32;
        let x = self.normal.0;
        let Some(size) = NonZeroU32::new(x.unsigned_abs()) else {
            let end = if rest <= 0 { visible.end } else { visible.start };
            return Columns { end, ..visible };
        };
        let (quotient, _) = divide_floor_wide(-rest, size);
        if x > 0 {
            // x (2 column - center) >= rest, both rounded up.
            let column = (center.x_2 - quotient + 1) >> 1;
            Columns {
                start: clamp(column),
                ..visible
            }
        } else {
            let column = (center.x_2 + quotient) >> 1;
            Columns {
                end: clamp(column + 1),
                ..visible
            }
        }
    }
}

/// An angle of 2^22 turns, in radians, from which on there are no directions.
const NO_DIRECTION: f32 = (1 << 22) as f32 * TAU;

/// The vector at right angles to a direction, to its right on the display; the zero vector for an angle without a
/// direction.
fn normal(angle: Angle) -> (i32, i32) {
    // As embedded-graphics has it: micromath's sine of half a turn is not 0.
    if angle == Angle::from_degrees(180.0) {
        return (0, -NORMAL_LENGTH);
    }
    let radians = angle.to_radians();
    // Bits of positive numbers have the order of the numbers. Infinity comes after them, and what is not a number last.
    if radians.abs().to_bits() >= NO_DIRECTION.to_bits() {
        return (0, 0);
    }
    // Within 1,024: a test asks for it at every angle.
    let scaled = |value: f32| (value * NORMAL_LENGTH as f32) as i32;
    (-scaled(F32Ext::sin(radians)), scaled(F32Ext::cos(radians)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn length(radians: f32) -> i32 {
        let (x, y) = normal(Angle::from_radians(radians));
        x.abs().max(y.abs())
    }

    /// Every number from 2^21 turns on, where micromath begins to lose directions, and every 997th one below and beyond.
    #[test]
    fn no_normal_vector_is_longer_than_it_should_be() {
        let all_from = (0.5 * NO_DIRECTION).to_bits();
        let end = NO_DIRECTION.to_bits();
        for bits in (0..all_from).step_by(997).chain(all_from..end) {
            let radians = f32::from_bits(bits);
            assert!(
                length(radians) <= NORMAL_LENGTH && length(-radians) <= NORMAL_LENGTH,
                "{radians}"
            );
        }
        for bits in (end..=u32::MAX >> 1).step_by(997) {
            let radians = f32::from_bits(bits);
            assert!(length(radians) == 0 && length(-radians) == 0, "{radians}");
        }
    }
}
