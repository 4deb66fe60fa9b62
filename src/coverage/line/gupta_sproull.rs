//! Gupta-Sproull lines: a line one pixel wide, filtered with a cone, from tables of distances.
//!
//! A line is a rectangle of width 1 from end to end. Around the centre of each pixel stands a cone of radius 1 pixel and
//! volume 1; the coverage of the pixel is the volume of that part of the cone which stands on the rectangle:
//!
//! ```text
//!     start                                end
//!       +-----------------------------------+  ---
//!       |             line                  |   | 1/2
//!       + - - - - - - - - - - - - - - - - - +  ---     ---
//!       |                                   |           | distance from the line
//!       +---------------------o-------------+          ---
//!                           pixel
//!       |<--- from_start ---->|<-- to_end ->|
//! ```
//!
//! Let `A(d)` be the volume over a line without ends, at a distance `d` from it, and `L(t)` the volume of the cone between
//! its axis and an end at a distance `t`, negative behind the axis. Between two ends the volume is nearly
//! `A(d) * (L(from_start) + L(to_end))`, which would be exact for a filter that is a product, as a cone is not: that is
//! wrong by up to 2.4/255 at one end, and by twice as much where both are under the cone. What it lacks is nearly a product
//! again, `Q(d) * (P(from_start) + P(to_end))`, whose factors are what is lacking at `t = 1/2` and at `d = 1/4` (a cross
//! approximation of rank one; 0.16/255 is left). Both products are odd in the distances from the ends, so that their sums
//! hold for lines of every length, shorter than the cone too. `A` and `Q` are one table of 25 entries, `L` and `P` one of
//! 17, at every 1/16 pixel, interpolated. The entries of `A` and `L` are beside their curves by half of what interpolation
//! lacks in the middle between two, which halves its error.
//!
//! Guarantees:
//! - Before it is rounded to 1/255, the coverage is within 0.2/255 of the filtered ideal where the cone reaches no end,
//!   which is all but about two pixels on either side of an end. At an end it is within 0.4/255, and where both ends are
//!   under the cone within 0.55/255, for lines of any length, direction and position.
//! - The coverage depends on the distances only, so that intensity varies neither along the line nor with its slope. The
//!   coverage of a column (of a row, where the line is steep) sums to the area that is visible there within 0.7 %, and
//!   exactly for an upright or a level line, but for rounding.
//! - To the bit: either order of the ends gives the same picture, a line that is mirrored (in x, in y, at a diagonal) or
//!   shifted by whole pixels the mirrored or shifted picture, and a window its part of the picture.
//!
//! Cost: integers only; a square root and two divisions for a line, up to five divisions for a window, and for a pixel two
//! multiplications, or ten near the ends. 168 bytes of tables.
//!
//! Source: Gupta and Sproull 1981; the tables are closed forms. End points: a product of edges, as in McNamara, McCormack
//! and Jouppi 2000, and its correction.

use core::ops::Range;

use crate::{
    coverage::{
        Coverage,
        line::cone::{ACROSS, FRACTION_BITS, Factors, PIXEL, interpolated},
    },
    geometry::{InputError, Sub8, SubPixel, SubPoint, Window, divide_long},
    surface::Span,
};

/// The distance from which on nothing of the line is under the cone.
const REACH: i32 = PIXEL + PIXEL / 2;
/// A distance to the end that the walk goes to is cut off here: 10 pixels less, which is more than a walk near an end takes
/// off, are still further than the cone reaches.
const FAR: i32 = 12 * PIXEL;

/// All pixels that a line can touch: the domain of [`Sub8`] and the reach of the cone.
const DOMAIN: Window = Window {
    left: -8200,
    top: -8200,
    right: 8200,
    bottom: 8200,
};

/// A line that is ready to be filtered in any number of windows.
///
/// Inside, the axis along which it is longer is the major one, and the line goes up in number along it. The minor axis is
/// mirrored where the line would go down there.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FilteredSegment {
    x_major: bool,
    mirrored: bool,
    /// Direction: what a step along the major axis adds to the distance along the line, and one along the minor axis to
    /// the distance from the line. At least 0.7, but for a line without length. Even, as `minor`.
    major: i32,
    /// What a step along the minor axis adds to the distance along the line, and one along the major axis takes off the
    /// distance from the line. From 0 to `major`.
    minor: i32,
    /// Distance of the origin from the line.
    offset: i64,
    /// Distance of the origin from the middle of the line, along it.
    progress: i64,
    half_length: i64,
    /// Steps along the major axis, each the first of its kind: within the cone's reach of the start, where the line begins;
    /// after that; within its reach of the end; after that, where nothing of the line is.
    steps: [i32; 4],
}

impl FilteredSegment {
    /// The line from one end to the other, in either order. A line without length covers nothing.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where an end is not in the domain of [`Sub8`].
    pub fn new(start: SubPoint<Sub8>, end: SubPoint<Sub8>) -> Result<Self, InputError> {
        let (start, end) = ((start.x_units(), start.y_units()), (end.x_units(), end.y_units()));
        let inside = |units: i32| (Sub8::MIN_UNITS..=Sub8::MAX_UNITS).contains(&units);
        if ![start.0, start.1, end.0, end.1].into_iter().all(inside) {
            return Err(InputError::out_of_domain::<Sub8>());
        }
        let x_major = start.0.abs_diff(end.0) >= start.1.abs_diff(end.1);
        let axes = |(x, y): (i32, i32)| if x_major { (x, y) } else { (y, x) };
        let (first, last) = (axes(start).min(axes(end)), axes(start).max(axes(end)));
        let mirrored = last.1 < first.1;
        let upwards = |(major, minor): (i32, i32)| (major, if mirrored { -minor } else { minor });
        Ok(Self::upwards(upwards(first), upwards(last), x_major, mirrored))
    }

    /// The line between two ends, mirrored so that no coordinate of the second one is less and the major one differs most.
    fn upwards(first: (i32, i32), last: (i32, i32), x_major: bool, mirrored: bool) -> Self {
        // Below 2^23 each, so the square is below 2^45.
        let (run, rise) = (i64::from(last.0 - first.0), i64::from(last.1 - first.1));
        let square = (run * run + rise * rise).max(1) as u64;
        // The length with as many bits as an `i32` holds, which are so many more than it has in 1/256 pixel.
        let spare = (square.leading_zeros() - 2) / 2;
        let root = (square << (2 * spare)).isqrt() as i32;
        // With one bit less than distances.
        let direction = |delta: i64| {
            let dividend = (delta << (spare + FRACTION_BITS - 1)) + i64::from(root / 2);
            divide_long(dividend, root).0 << 1
        };
        let (major, minor) = (direction(run), direction(rise));
        // Distances are from the middle, so that neither end is nearer to exact than the other one. Its coordinates are
        // in 1/512 pixel and below 2^23: products are below 2^51.
        let middle = (i64::from(first.0 + last.0), i64::from(first.1 + last.1));
        let (along, across) = (i64::from(major), i64::from(minor));
        // Along the major axis, nothing that is within 1 pixel of an end and 1.5 pixels of the line is further from the end
        // than this, in 1/256 pixel: 1.8 pixels at most.
        let reach = ceil_shift(major + minor + minor / 2, FRACTION_BITS - Sub8::FRACTION_BITS);
        Self {
            x_major,
            mirrored,
            major,
            minor,
            offset: rounded_to_odd(across * middle.0 - along * middle.1),
            progress: rounded_to_odd(-along * middle.0 - across * middle.1),
            // Without a run there is no rise either, and no length.
            half_length: if run == 0 {
                0
            } else {
                (i64::from(root) << (FRACTION_BITS - Sub8::FRACTION_BITS - 1)) >> spare
            },
            steps: [
                first_after(first.0 - reach),
                first_at(first.0 + reach),
                first_after(last.0 - reach),
                first_at(last.0 + reach),
            ],
        }
    }

    /// A window around all pixels that have coverage; empty for a line without length.
    pub fn window(&self) -> Window {
        if self.half_length == 0 {
            return Window::EMPTY;
        }
        let [first, .., last] = self.steps;
        // At most five pixels of a step are within the cone's reach of the line.
        let end = self.first_minor(last) + 5;
        let minor = self.first_minor(first)..end;
        let minor = if self.mirrored { mirrored(&minor) } else { minor };
        let (columns, rows) = if self.x_major {
            (first..last, minor)
        } else {
            (minor, first..last)
        };
        Window {
            left: columns.start,
            top: rows.start,
            right: columns.end,
            bottom: rows.end,
        }
    }

    /// Hands over the pixels of the window that have coverage, as spans of one pixel, each once, along the line.
    ///
    /// # Errors
    /// The first error that `emit` returns.
    pub fn cover<E>(&self, window: &Window, mut emit: impl FnMut(Span, Coverage) -> Result<(), E>) -> Result<(), E> {
        let Some((major, minor)) = self.visible(window) else {
            return Ok(());
        };
        let [_, after_start, near_end, _] = self.steps;
        // Not by `clamp`, which panics where the range is empty: these are in order, but no compiler proves it.
        let after_start = after_start.max(major.start).min(major.end);
        let near_end = near_end.max(after_start).min(major.end);
        self.walk::<true, E>(major.start..after_start, &minor, &mut emit)?;
        self.walk::<false, E>(after_start..near_end, &minor, &mut emit)?;
        self.walk::<true, E>(near_end..major.end, &minor, &mut emit)
    }

    /// The steps along the major axis that have a pixel in the window, and its minor coordinates; `None` where there is
    /// none.
    fn visible(&self, window: &Window) -> Option<(Range<i32>, Range<i32>)> {
        let window = window.intersection(&DOMAIN);
        if window.is_empty() || self.half_length == 0 {
            return None;
        }
        let (columns, rows) = (window.left..window.right, window.top..window.bottom);
        let (major, minor) = if self.x_major { (columns, rows) } else { (rows, columns) };
        let minor = if self.mirrored { mirrored(&minor) } else { minor };
        let [first, .., end] = self.steps;
        let first = major.start.max(first);
        let last = major.end.min(end) - 1;
        if first > last {
            return None;
        }
        // Where what is taken off the distance gets there, the line comes near the first row, or leaves the last one.
        let entry = self.distance(0, minor.start) - i64::from(REACH);
        let exit = self.distance(0, minor.end - 1) + i64::from(REACH);
        let taken_off = |step: i32| i64::from(self.minor) * i64::from(step);
        if entry >= taken_off(last) || exit <= taken_off(first) {
            return None;
        }
        // Where these divide, the quotient is between both steps, and the divisor is not 0.
        let visible_first = if entry >= taken_off(first) {
            divide_long(entry, self.minor).0 + 1
        } else {
            first
        };
        let visible_end = if exit <= taken_off(last) {
            divide_long(exit - 1, self.minor).0 + 1
        } else {
            last + 1
        };
        Some((visible_first..visible_end, minor))
    }

    /// Distance of a pixel from the line.
    fn distance(&self, major: i32, minor: i32) -> i64 {
        self.offset + i64::from(self.major) * i64::from(minor) - i64::from(self.minor) * i64::from(major)
    }

    /// The first pixel of a step along the major axis that is near enough to the line.
    fn first_minor(&self, major: i32) -> i32 {
        let beyond = -i64::from(REACH) - self.distance(major, 0);
        divide_long(beyond, self.major).0 + 1
    }

    /// Walks along the major axis, and in each step across the line. `ENDS`: whether an end may be under the cone.
    fn walk<const ENDS: bool, E>(
        &self,
        steps: Range<i32>,
        visible: &Range<i32>,
        emit: &mut impl FnMut(Span, Coverage) -> Result<(), E>,
    ) -> Result<(), E> {
        if steps.is_empty() {
            return Ok(());
        }
        let mut first_minor = self.first_minor(steps.start);
        let mut first_distance = self.distance(steps.start, first_minor) as i32;
        let mut first_ends = if ENDS {
            self.ends_at(steps.start, first_minor)
        } else {
            Ends::default()
        };
        for major in steps {
            let skipped = (visible.start - first_minor).max(0);
            let mut minor = first_minor + skipped;
            let mut distance = first_distance + self.major * skipped;
            let mut ends = first_ends.moved(self.minor * skipped);
            while distance < REACH && minor < visible.end {
                let across = interpolated(&ACROSS, distance.unsigned_abs());
                let volume = if ENDS { ends.volume(across) } else { across.product };
                // At most 199.0 levels.
                let coverage = ((volume + 128) >> 8) as Coverage;
                if coverage > 0 {
                    emit(self.pixel(major, minor), coverage)?;
                }
                minor += 1;
                distance += self.major;
                ends = ends.moved(self.minor);
            }
            first_distance -= self.minor;
            first_ends = first_ends.moved(self.major);
            // At most once: the line goes up by no more than it goes along.
            if first_distance <= -REACH {
                first_minor += 1;
                first_distance += self.major;
                first_ends = first_ends.moved(self.minor);
            }
        }
        Ok(())
    }

    fn ends_at(&self, major: i32, minor: i32) -> Ends {
        let steps = i64::from(self.major) * i64::from(major) + i64::from(self.minor) * i64::from(minor);
        let from_middle = self.progress + steps;
        // An end that the cone does not reach from here is not reached later, as it is left behind.
        Ends {
            from_start: (self.half_length + from_middle).min(i64::from(PIXEL)) as i32,
            to_end: (self.half_length - from_middle).min(i64::from(FAR)) as i32,
        }
    }

    #[inline]
    fn pixel(&self, major: i32, minor: i32) -> Span {
        let minor = if self.mirrored { -minor } else { minor };
        let (x, y) = if self.x_major { (major, minor) } else { (minor, major) };
        Span::new(y, x, x + 1)
    }
}

/// `value / 2^bits`, rounded up.
fn ceil_shift(value: i32, bits: u32) -> i32 {
    (value + (1 << bits) - 1) >> bits
}

/// The first pixel whose centre is at a coordinate in 1/256 pixel or after it.
fn first_at(units: i32) -> i32 {
    ceil_shift(units, Sub8::FRACTION_BITS)
}

/// The first pixel whose centre is after a coordinate in 1/256 pixel.
fn first_after(units: i32) -> i32 {
    (units >> Sub8::FRACTION_BITS) + 1
}

/// The range of the negated numbers; within the domain.
fn mirrored(range: &Range<i32>) -> Range<i32> {
    1 - range.end..1 - range.start
}

/// Distances of a pixel from both ends, along the line, towards the inside. That from an end which is left behind, or which
/// nobody asks for, may grow until it wraps.
#[derive(Copy, Clone, Default)]
struct Ends {
    from_start: i32,
    to_end: i32,
}

impl Ends {
    #[inline]
    fn moved(self, by: i32) -> Self {
        Self {
            from_start: self.from_start.wrapping_add(by),
            to_end: self.to_end.wrapping_sub(by),
        }
    }

    /// The volume of the cone over the line between both ends, in 1/256 of a level, from the factors of the distance from
    /// the line.
    #[inline]
    fn volume(self, across: Factors) -> i32 {
        let (start, end) = (Factors::to_end(self.from_start), Factors::to_end(self.to_end));
        // The ends are in order and `L` is odd and grows, so that the sum is from 0 to 2^16.
        let product = (across.product as u32 * (start.product + end.product) as u32) >> 16;
        // In 1/2^14 of 1/8192 of a level: below 2^15 times 2^16.
        let correction = (across.correction * (start.correction + end.correction)) >> 19;
        (product as i32 + correction).max(0)
    }
}

/// Converts a product of distances in 1/512 pixel to a distance: an even number where that is exact, otherwise the odd
/// number between two even ones.
///
/// Rounded so, the negated product becomes the negated distance, and a product that is larger by whole pixels a
/// distance that is larger by as many. Rounding down is not symmetric, and rounding towards zero does not move with the
/// line.
fn rounded_to_odd(product: i64) -> i64 {
    const BITS: u32 = Sub8::FRACTION_BITS + 2;
    (product >> BITS) << 1 | i64::from(product & ((1 << BITS) - 1) != 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_to_odd_is_symmetric_and_moves_with_the_line() {
        for product in -5000..5000i64 {
            let rounded = rounded_to_odd(product);
            assert_eq!(rounded_to_odd(-product), -rounded);
            assert_eq!(rounded_to_odd(product + 7 * 1024), rounded + 14);
            assert!((rounded * 512 - product).abs() < 512);
        }
    }
}
