//! A radial gradient: the colour depends on how far a pixel is from a centre.
//!
//! Promises: the level of a pixel is its exact distance, `255 |p - centre| / radius`, rounded to the nearest, wherever a
//! span begins. Squares are compared, stepped by forward differences. Cost: one 64-bit square root a span; then additions
//! and comparisons of 64 bits a pixel, and a few products where the level changes.

use core::marker::PhantomData;

use embedded_graphics::{
    geometry::Point,
    pixelcolor::{PixelColor, Rgb888},
};

use crate::{
    geometry::{OutOfDomain, Sub8, SubPixel},
    shade::{Paint, Ramp, ramp_colors},
};

/// Colours around a centre; beyond the radius they stay what they are there.
///
/// ```
/// use embedded_graphics::{pixelcolor::{Gray8, Rgb888}, prelude::*};
/// use zrow::shade::{Paint, RadialGradient, Ramp};
///
/// let ramp = Ramp::between(Rgb888::WHITE, Rgb888::BLACK);
/// let gradient = RadialGradient::<Gray8, 2>::new(Point::new(2, 0), 3, ramp)?;
/// let row: Vec<u8> = gradient.colors_from(Point::new(0, 0)).take(6).map(|color| color.luma()).collect();
/// assert_eq!(row, [85, 170, 255, 170, 85, 0]);
/// # Ok::<(), zrow::geometry::OutOfDomain>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct RadialGradient<C, const STOPS: usize> {
    center: Point,
    radius: u32,
    ramp: Ramp<STOPS>,
    color: PhantomData<C>,
}

/// Squares of distances are compared in units of the radius' 1/510.
const SCALE: u64 = 510;

impl<C: PixelColor + From<Rgb888>, const STOPS: usize> RadialGradient<C, STOPS> {
    /// A gradient from a centre outwards. Without a radius everything has the last colour.
    ///
    /// # Errors
    /// [`OutOfDomain`] where the radius is more than 8,191 pixels.
    pub fn new(center: Point, radius: u32, ramp: Ramp<STOPS>) -> Result<Self, OutOfDomain> {
        let error = OutOfDomain::of::<Sub8>();
        if radius > (Sub8::MAX_UNITS >> Sub8::FRACTION_BITS) as u32 {
            return Err(error);
        }
        Ok(Self {
            center,
            radius,
            ramp,
            color: PhantomData,
        })
    }
}

/// The levels of a row, pixel by pixel.
struct Levels {
    /// From the centre to the pixel.
    x: i64,
    y: u64,
    radius: u64,
    near: Option<Near>,
}

/// A pixel in the box around the circle.
struct Near {
    /// `(510 distance)^2`, and what leads to the next pixel.
    square: u64,
    difference: i64,
    level: u64,
    /// The squares that have this level: `(2 level - 1)^2 radius^2`, up to the next level's.
    squares: core::ops::Range<u64>,
}

impl Levels {
    fn next_level(&mut self) -> u8 {
        let is_near = self.radius > 0 && self.y <= self.radius && self.x.unsigned_abs() <= self.radius;
        let near = if is_near {
            match self.near.take() {
                Some(near) => Some(near.next(self.radius)),
                None => Some(Near::enter(self.x, self.y, self.radius)),
            }
        } else {
            None
        };
        self.x = self.x.wrapping_add(1);
        self.near = near;
        self.near.as_ref().map_or(255, |near| near.level.min(255) as u8)
    }
}

impl Near {
    /// The first pixel of a run, by a square root. All numbers are below 2^46.
    fn enter(x: i64, y: u64, radius: u64) -> Self {
        let scale = (SCALE * SCALE) as i64;
        let square = (x.unsigned_abs() * x.unsigned_abs() + y * y) * SCALE * SCALE;
        // The greatest k with (2 k - 1) radius <= 510 distance.
        let level = (square.isqrt() + radius).checked_div(2 * radius).unwrap_or(0);
        Self {
            square,
            // (x + 1)^2 - x^2, which may be negative.
            difference: (2 * x + 1) * scale,
            level,
            squares: border(level, radius)..border(level + 1, radius),
        }
    }

    /// The pixel to the right.
    fn next(self, radius: u64) -> Self {
        let square = self.square.wrapping_add_signed(self.difference);
        let (mut level, mut squares) = (self.level, self.squares);
        while square >= squares.end {
            level += 1;
            squares = squares.end..border(level + 1, radius);
        }
        while square < squares.start {
            level -= 1;
            squares = border(level, radius)..squares.start;
        }
        Self {
            square,
            difference: self.difference + (2 * SCALE * SCALE) as i64,
            level,
            squares,
        }
    }
}

/// The least square of a level.
fn border(level: u64, radius: u64) -> u64 {
    let root = (2 * level).saturating_sub(1) * radius;
    root * root
}

impl<C: PixelColor + From<Rgb888>, const STOPS: usize> Paint for RadialGradient<C, STOPS> {
    type Color = C;

    fn colors_from(&self, start: Point) -> impl Iterator<Item = C> {
        let mut levels = Levels {
            x: i64::from(start.x) - i64::from(self.center.x),
            y: u64::from(start.y.abs_diff(self.center.y)),
            radius: u64::from(self.radius),
            near: None,
        };
        ramp_colors(&self.ramp, core::iter::repeat_with(move || levels.next_level()))
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
