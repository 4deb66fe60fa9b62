//! Gupta-Sproull lines: a line one pixel wide, filtered with a cone, from a table of distances.
//!
//! Promises: a pixel's share is the volume that a cone of radius 1 pixel and volume 1 around its centre has over the line, a
//! rectangle of width 1 from end to end, as a product of two tables: across the line (25 entries, of the distance to it) and
//! along it (17 entries, of the distances to both ends). Where the cone does not reach an end, which is all but the last
//! pixel, the share is within 0.32/255 of the filtered ideal before it is rounded to 1/255; at an end within 2.7/255, because
//! a cone is no product. It depends on these distances only, so that intensity varies neither along the line nor with its
//! slope. The shares of a column (of a row, where the line is steep) sum to the area that is visible there within 0.7 %, and
//! exactly for an upright or a level line, but for rounding.
//!
//! Either order of the ends gives the same picture, and a part of it is the same through any window. Integers only: a square
//! root and two divisions for a line, up to five divisions for a window, and for a pixel two multiplications, or six at the
//! ends. 84 bytes of tables.
//!
//! Source: Gupta and Sproull 1981; the table is its closed form at every 1/16 pixel, interpolated. End points: a product of
//! edges, as in McNamara, McCormack and Jouppi 2000.

use core::ops::Range;

use crate::{
    coverage::Share,
    geometry::{OutOfDomain, Sub8, SubPixel, SubPoint, Window, divide_long},
    target::Span,
};

/// Fractional bits of distances and of the direction: 16 pixels are the range of 32 bits, and after 2^15 pixels of rounded
/// steps a distance is off by 1/2^12 pixel at most.
const FRACTION_BITS: u32 = 27;
const PIXEL: i32 = 1 << FRACTION_BITS;
/// From here on nothing of the line is under the cone.
const REACH: i32 = PIXEL + PIXEL / 2;
/// A distance to the end that the walk goes to is cut off here: 10 pixels less, which is more than a walk near an end takes
/// off, are still further than the cone reaches.
const FAR: i32 = 12 * PIXEL;

/// Volume of the cone over a line of width 1 without ends, in 1/65,536, at distances of 1/16 pixel.
const ACROSS: [u16; 25] = [
    51_109, 50_788, 49_829, 48_252, 46_086, 43_379, 40_191, 36_612, 32_768, 28_879, 25_092, 21_474, 18_070, 14_919,
    12_046, 9_473, 7_213, 5_275, 3_661, 2_366, 1_379, 684, 252, 45, 0,
];

/// Volume of the cone between its middle and a distance, in 1/65,536, at distances of 1/16 pixel.
const ALONG: [u16; 17] = [
    0, 3_889, 7_676, 11_294, 14_698, 17_849, 20_722, 23_295, 25_555, 27_493, 29_107, 30_402, 31_389, 32_084, 32_516,
    32_723, 32_768,
];

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
    /// Direction: what a step along the major axis adds to the distance from the start, and one along the minor axis to
    /// the distance from the line. At least 0.7, but for a line without length.
    major: i32,
    /// What a step along the minor axis adds to the distance from the start, and one along the major axis takes off the
    /// distance from the line. From 0 to `major`.
    minor: i32,
    /// Distance of the origin from the line.
    offset: i64,
    /// Distance of the origin from the start, along the line.
    progress: i64,
    length: i64,
    /// Whole part of the major coordinates of both ends.
    ends: [i32; 2],
}

impl FilteredSegment {
    /// From one end to the other, in either order. A line without length covers nothing.
    ///
    /// # Errors
    /// [`OutOfDomain`] where an end is not in the domain of [`Sub8`].
    pub fn new(start: SubPoint<Sub8>, end: SubPoint<Sub8>) -> Result<Self, OutOfDomain> {
        let (start, end) = ((start.x_units(), start.y_units()), (end.x_units(), end.y_units()));
        let inside = |units: i32| (Sub8::MIN_UNITS..=Sub8::MAX_UNITS).contains(&units);
        if ![start.0, start.1, end.0, end.1].into_iter().all(inside) {
            return Err(OutOfDomain::of::<Sub8>());
        }
        let x_major = start.0.abs_diff(end.0) >= start.1.abs_diff(end.1);
        let axes = |(x, y): (i32, i32)| if x_major { (x, y) } else { (y, x) };
        let (first, last) = (axes(start).min(axes(end)), axes(start).max(axes(end)));
        let mirrored = last.1 < first.1;
        let upwards = |(major, minor): (i32, i32)| (major, if mirrored { -minor } else { minor });
        Ok(Self::upwards(upwards(first), upwards(last), x_major, mirrored))
    }

    /// From ends of which no coordinate of the second is less, and the major one differs most.
    fn upwards(first: (i32, i32), last: (i32, i32), x_major: bool, mirrored: bool) -> Self {
        // Below 2^23 each, so the square is below 2^45.
        let (run, rise) = (i64::from(last.0 - first.0), i64::from(last.1 - first.1));
        let square = (run * run + rise * rise).max(1) as u64;
        // The length with as many bits as an `i32` holds, which are so many more than it has in 1/256 pixel.
        let spare = (square.leading_zeros() - 2) / 2;
        let root = (square << (2 * spare)).isqrt() as i32;
        let of_length = |delta: i64| divide_long((delta << (spare + FRACTION_BITS)) + i64::from(root / 2), root).0;
        let (major, minor) = (of_length(run), of_length(rise));
        // Below 2^28 times 2^21.
        let product = |one: i32, other: i32| i64::from(one) * i64::from(other);
        Self {
            x_major,
            mirrored,
            major,
            minor,
            offset: (product(minor, first.0) - product(major, first.1)) >> Sub8::FRACTION_BITS,
            progress: -((product(major, first.0) + product(minor, first.1)) >> Sub8::FRACTION_BITS),
            // Without a run there is no rise either, and no length.
            length: if run == 0 {
                0
            } else {
                (i64::from(root) << (FRACTION_BITS - Sub8::FRACTION_BITS)) >> spare
            },
            ends: [first.0 >> Sub8::FRACTION_BITS, last.0 >> Sub8::FRACTION_BITS],
        }
    }

    /// A window around all pixels that have a share; empty for a line without length.
    pub fn window(&self) -> Window {
        if self.length == 0 {
            return Window::EMPTY;
        }
        let (first, last) = (self.ends[0] - 1, self.ends[1] + 3);
        // As many rows are near to the line at most.
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

    /// Hands over the pixels of the window that have a share, as spans of one pixel, each once, along the line.
    ///
    /// # Errors
    /// The first of `emit`.
    pub fn cover<E>(&self, window: &Window, mut emit: impl FnMut(Span, Share) -> Result<(), E>) -> Result<(), E> {
        let Some((major, minor)) = self.visible(window) else {
            return Ok(());
        };
        // The cone reaches an end only near it: 2.1 pixels along the major axis.
        let near_start = (self.ends[0] + 4).clamp(major.start, major.end);
        let near_end = (self.ends[1] - 2).clamp(near_start, major.end);
        self.walk::<true, E>(major.start..near_start, &minor, &mut emit)?;
        self.walk::<false, E>(near_start..near_end, &minor, &mut emit)?;
        self.walk::<true, E>(near_end..major.end, &minor, &mut emit)
    }

    /// The steps along the major axis that have a pixel in the window, and its minor coordinates; `None` where there is none.
    fn visible(&self, window: &Window) -> Option<(Range<i32>, Range<i32>)> {
        let window = window.intersection(&DOMAIN);
        if window.is_empty() || self.length == 0 {
            return None;
        }
        let (columns, rows) = (window.left..window.right, window.top..window.bottom);
        let (major, minor) = if self.x_major { (columns, rows) } else { (rows, columns) };
        let minor = if self.mirrored { mirrored(&minor) } else { minor };
        let first = major.start.max(self.ends[0] - 1);
        let last = (major.end - 1).min(self.ends[1] + 2);
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
        emit: &mut impl FnMut(Span, Share) -> Result<(), E>,
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
            let skipped = visible.start.wrapping_sub(first_minor).max(0);
            let mut minor = first_minor.wrapping_add(skipped);
            let mut distance = first_distance.wrapping_add(self.major.wrapping_mul(skipped));
            let mut ends = first_ends.moved(self.minor.wrapping_mul(skipped));
            while distance < REACH && minor < visible.end {
                let across = interpolated(&ACROSS, distance.unsigned_abs());
                let volume = if ENDS {
                    across.wrapping_mul(ends.volume()) >> 16
                } else {
                    across
                };
                let share = (volume.wrapping_mul(255).wrapping_add(1 << 15) >> 16) as Share;
                if share > 0 {
                    emit(self.pixel(major, minor), share)?;
                }
                minor = minor.wrapping_add(1);
                distance = distance.wrapping_add(self.major);
                ends = ends.moved(self.minor);
            }
            first_distance = first_distance.wrapping_sub(self.minor);
            first_ends = first_ends.moved(self.major);
            // At most once: the line goes up by no more than it goes along.
            if first_distance <= -REACH {
                first_minor = first_minor.wrapping_add(1);
                first_distance = first_distance.wrapping_add(self.major);
                first_ends = first_ends.moved(self.minor);
            }
        }
        Ok(())
    }

    fn ends_at(&self, major: i32, minor: i32) -> Ends {
        let steps = i64::from(self.major) * i64::from(major) + i64::from(self.minor) * i64::from(minor);
        let from_start = self.progress + steps;
        // An end that the cone does not reach from here is not reached later, as it is left behind.
        Ends {
            from_start: from_start.min(i64::from(PIXEL)) as i32,
            to_end: (self.length - from_start).min(i64::from(FAR)) as i32,
        }
    }

    #[inline(always)]
    fn pixel(&self, major: i32, minor: i32) -> Span {
        let minor = if self.mirrored { minor.wrapping_neg() } else { minor };
        let (x, y) = if self.x_major { (major, minor) } else { (minor, major) };
        Span::new(y, x, x.wrapping_add(1))
    }
}

/// The range of the negated numbers; within the domain.
fn mirrored(range: &Range<i32>) -> Range<i32> {
    1 - range.end..1 - range.start
}

/// Distances of a pixel from both ends, along the line, towards the inside.
#[derive(Copy, Clone, Default)]
struct Ends {
    from_start: i32,
    to_end: i32,
}

impl Ends {
    #[inline(always)]
    fn moved(self, by: i32) -> Self {
        Self {
            from_start: self.from_start.wrapping_add(by),
            to_end: self.to_end.wrapping_sub(by),
        }
    }

    /// The volume of the cone between both ends, in 1/65,536.
    fn volume(self) -> u32 {
        let volume = half_volume(self.from_start).wrapping_add(half_volume(self.to_end));
        volume.max(0) as u32
    }
}

/// The volume of the cone between its middle and an end, negative for an end that is behind it.
fn half_volume(distance: i32) -> i32 {
    let volume = interpolated(&ALONG, distance.unsigned_abs()) as i32;
    if distance < 0 { -volume } else { volume }
}

/// An entry of a table, or what is between two; beyond the table the last one.
#[inline(always)]
fn interpolated<const ENTRIES: usize>(table: &[u16; ENTRIES], distance: u32) -> u32 {
    const PITCH_BITS: u32 = FRACTION_BITS - 4;
    let entry = (distance >> PITCH_BITS) as usize;
    let (Some(&from), Some(&to)) = (table.get(entry), table.get(entry.wrapping_add(1))) else {
        return table.last().copied().map_or(0, u32::from);
    };
    // In 1/2^12 of the pitch: no two neighbours differ by more than 2^12.
    let part = ((distance >> (PITCH_BITS - 12)) & 0xfff) as i32;
    let difference = i32::from(to).wrapping_sub(i32::from(from));
    i32::from(from).wrapping_add(difference.wrapping_mul(part) >> 12) as u32
}

#[cfg(test)]
mod tests {
    extern crate std;

    use core::f64::consts::PI;

    use super::*;

    /// Volume of the cone between its middle and a distance: the integral of its section.
    fn closed_form(distance: f64) -> f64 {
        let u = distance.abs().min(1.0);
        let cubic = if u == 0.0 { 0.0 } else { u.powi(3) * (1.0 / u).acosh() };
        ((2.0 * u * (1.0 - u * u).sqrt() + u.asin() - cubic) / PI).copysign(distance)
    }

    fn line_closed_form(distance: f64) -> f64 {
        closed_form(distance + 0.5) - closed_form(distance - 0.5)
    }

    #[test]
    fn tables_are_their_closed_forms() {
        for (place, exact) in [(0.0, 198.86), (0.5, 127.5), (1.0, 28.07), (1.5, 0.0)] {
            assert!((line_closed_form(place) * 255.0 - exact).abs() < 0.005, "{place}");
        }
        for (entry, &volume) in ACROSS.iter().enumerate() {
            let exact = line_closed_form(entry as f64 / 16.0) * 65_536.0;
            assert_eq!(f64::from(volume), exact.round(), "{entry}");
        }
        for (entry, &volume) in ALONG.iter().enumerate() {
            let exact = closed_form(entry as f64 / 16.0) * 65_536.0;
            assert_eq!(f64::from(volume), exact.round(), "{entry}");
        }
    }

    #[test]
    fn interpolation_is_within_a_third_of_a_level() {
        let mut largest = (0f64, 0f64);
        for step in 0..=15_500 {
            let distance = f64::from(step) / 10_000.0;
            let units = (distance * f64::from(PIXEL)) as u32;
            let across = f64::from(interpolated(&ACROSS, units)) / 65_536.0;
            let along = f64::from(interpolated(&ALONG, units)) / 65_536.0;
            largest.0 = largest.0.max((across - line_closed_form(distance)).abs() * 255.0);
            largest.1 = largest.1.max((along - closed_form(distance)).abs() * 255.0);
        }
        assert!(largest.0 < 0.32 && largest.1 < 0.2, "{largest:?}");
    }
}
