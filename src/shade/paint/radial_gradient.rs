//! A radial gradient: the colour depends on how far a pixel is from a centre.
//!
//! Guarantees: the level of a pixel is its exact distance, `255 |p - centre| / radius`, rounded to the nearest, wherever a
//! span begins; in spans of up to a billion pixels. The square of the distance is stepped by forward differences, and
//! compared with those at which the levels begin. Cost: 8 comparisons to enter a span, then 32-bit additions, and a
//! comparison for each level that goes by, 255 a radius: at a radius of 60, 40 instructions a pixel on a Cortex-M4, fewer
//! at a larger one.

use core::num::Wrapping;

use embedded_graphics::{
    geometry::Point,
    pixelcolor::{PixelColor, Rgb888},
};

use crate::{
    geometry::{InputError, Sub8, SubPixel},
    shade::{Paint, Ramp, paint::ramp::Colors},
};

/// A paint whose colours change with the distance from a centre; beyond the radius the last colour goes on.
///
/// RAM: its 256 colours, 512 bytes in RGB565, 1,040 bytes, most of them squares of radii, and the [ramp](Ramp). Make it once, not
/// for each band, because making it computes all of them.
///
/// ```
/// use embedded_graphics::{pixelcolor::{Gray8, Rgb888}, prelude::*};
/// use zrow::shade::{Paint, RadialGradient, Ramp};
///
/// let ramp = Ramp::between(Rgb888::WHITE, Rgb888::BLACK);
/// let gradient = RadialGradient::<Gray8, 2>::new(Point::new(2, 0), 3, ramp)?;
/// let row: Vec<u8> = gradient.colors_from(Point::new(0, 0)).take(6).map(|color| color.luma()).collect();
/// assert_eq!(row, [85, 170, 255, 170, 85, 0]);
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct RadialGradient<C, const STOPS: usize> {
    center: Point,
    radius: u32,
    ramp: Ramp<STOPS>,
    colors: Colors<C>,
    borders: Borders,
}

impl<C: PixelColor + From<Rgb888>, const STOPS: usize> RadialGradient<C, STOPS> {
    /// A gradient from a centre outwards. Without a radius everything has the last colour.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where the radius is more than 8,191 pixels.
    pub fn new(center: Point, radius: u32, ramp: Ramp<STOPS>) -> Result<Self, InputError> {
        if radius > (Sub8::MAX_UNITS >> Sub8::FRACTION_BITS) as u32 {
            return Err(InputError::out_of_domain::<Sub8>());
        }
        Ok(Self {
            center,
            radius,
            ramp,
            colors: ramp.colors(),
            borders: Borders::new(radius),
        })
    }
}

/// For each level the least squared distance that has it, and a last entry that no distance reaches.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
struct Borders([u32; 257]);

impl Borders {
    /// Level `n` begins half a level before it, at `((2 n - 1) radius / 510)^2`, rounded up.
    fn new(radius: u32) -> Self {
        const DIVISOR: u32 = 510 * 510;
        // By its differences, the second of which is 8 radius^2; with remainders, so that nothing is rounded on the way. All
        // below 2^30.
        let square = radius * radius;
        let parts = |number: u32| (number / DIVISOR, number % DIVISOR);
        let sum = |one: (u32, u32), other: (u32, u32)| {
            let (carry, remainder) = parts(one.1 + other.1);
            (one.0 + other.0 + carry, remainder)
        };
        let (mut border, mut step, second) = (parts(square), (0, 0), parts(8 * square));
        let mut borders = [0; 257];
        for begin in borders.iter_mut().skip(1) {
            *begin = border.0 + u32::from(border.1 != 0);
            step = sum(step, second);
            border = sum(border, step);
        }
        if let Some(last) = borders.last_mut() {
            *last = u32::MAX;
        }
        Self(borders)
    }

    #[inline]
    fn begin(&self, level: u8) -> u32 {
        // There is an entry for each level.
        self.0.get(usize::from(level)).copied().unwrap_or(0)
    }

    #[inline]
    fn end(&self, level: u8) -> u32 {
        self.0.get(usize::from(level) + 1).copied().unwrap_or(u32::MAX)
    }

    /// The highest level that begins at or before a square.
    fn level(&self, square: u32) -> u8 {
        self.0.partition_point(|&begin| begin <= square).saturating_sub(1) as u8
    }
}

/// A walk along a row of pixels that keeps the square of the distance to the gradient's centre.
struct DistanceWalk {
    /// Column of the pixel, from the left side of the box around the circle, modulo 2^32.
    column: Wrapping<u32>,
    /// Column of the right side of that box.
    last_column: u32,
    /// The square of the distance to the centre, modulo 2^32 outside the box.
    square: Wrapping<u32>,
    /// How much more the next pixel's square is than this one's, modulo 2^32.
    difference: Wrapping<u32>,
    /// Level of the ramp at the pixel.
    level: u8,
}

impl DistanceWalk {
    fn enter<C, const STOPS: usize>(gradient: &RadialGradient<C, STOPS>, start: Point) -> Self {
        /// The square of a distance that no pixel has.
        const FAR: i64 = 1 << 30;
        let y = start.y.abs_diff(gradient.center.y);
        let x = if y > gradient.radius {
            FAR
        } else {
            (i64::from(start.x) - i64::from(gradient.center.x)).clamp(-FAR, FAR)
        };
        let (x, y) = (Wrapping(x as u32), Wrapping(y));
        let mut walk = Self {
            column: x + Wrapping(gradient.radius),
            last_column: gradient.radius * 2,
            square: x * x + y * y,
            difference: x * Wrapping(2) + Wrapping(1),
            level: 255,
        };
        if walk.is_in_box() {
            walk.level = gradient.borders.level(walk.square.0);
        }
        walk
    }

    #[inline]
    const fn is_in_box(&self) -> bool {
        self.column.0 <= self.last_column
    }

    /// Returns the level of the pixel, and moves on to the next pixel.
    #[inline]
    fn next(&mut self, borders: &Borders) -> u8 {
        let mut level = 255;
        if self.is_in_box() {
            level = self.level;
            // 2 x + 1: to the right of the centre the distance grows from pixel to pixel.
            if self.difference.0 as i32 > 1 {
                while self.square.0 >= borders.end(level) {
                    level += 1;
                }
            } else {
                while self.square.0 < borders.begin(level) {
                    level -= 1;
                }
            }
            self.level = level;
        }
        self.column += 1;
        self.square += self.difference;
        self.difference += 2;
        level
    }
}

impl<C: PixelColor + From<Rgb888>, const STOPS: usize> Paint for RadialGradient<C, STOPS> {
    type Color = C;

    #[inline]
    fn colors_from(&self, start: Point) -> impl Iterator<Item = C> {
        let mut walk = DistanceWalk::enter(self, start);
        let Self { colors, borders, .. } = self;
        core::iter::repeat_with(move || colors.at(walk.next(borders)))
    }
}

#[cfg(feature = "defmt")]
impl<C, const STOPS: usize> defmt::Format for RadialGradient<C, STOPS> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(
            formatter,
            "RadialGradient ({}, {}) radius {}, {}",
            self.center.x,
            self.center.y,
            self.radius,
            self.ramp
        );
    }
}
