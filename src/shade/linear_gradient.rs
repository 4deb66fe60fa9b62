//! A linear gradient: the colour depends on how far a pixel is along a straight way.
//!
//! Promises: the level of a pixel is its exact place along the way, `255 (p - from).(to - from) / |to - from|^2`, rounded
//! to the nearest (ties up), wherever a span begins. It is stepped by quotient and remainder (Field 1985). Cost: one 64-bit
//! division a span, then additions, and three products where the level changes.

use core::marker::PhantomData;

use embedded_graphics::{
    geometry::Point,
    pixelcolor::{PixelColor, Rgb888},
};

use crate::{
    geometry::{OutOfDomain, Sub8, SubPoint},
    shade::{Paint, Ramp, ramp_colors},
};

/// Colours along a way; beyond its ends they stay what they are there.
///
/// ```
/// use embedded_graphics::{pixelcolor::{Gray8, Rgb888}, prelude::*};
/// use zrow::shade::{LinearGradient, Paint, Ramp};
///
/// let ramp = Ramp::between(Rgb888::BLACK, Rgb888::WHITE);
/// let gradient = LinearGradient::<Gray8, 2>::new(Point::new(10, 0), Point::new(15, 0), ramp)?;
/// let row: Vec<u8> = gradient.colors_from(Point::new(9, 3)).take(8).map(|color| color.luma()).collect();
/// assert_eq!(row, [0, 0, 51, 102, 153, 204, 255, 255]);
/// # Ok::<(), zrow::geometry::OutOfDomain>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct LinearGradient<C, const STOPS: usize> {
    from: Point,
    to: Point,
    ramp: Ramp<STOPS>,
    /// Levels from one column to the next, rounded down, and what that leaves over of `divisor`.
    step: i64,
    remainder_step: u32,
    /// Twice the square of the length; 0 for no length.
    divisor: u32,
    color: PhantomData<C>,
}

impl<C: PixelColor + From<Rgb888>, const STOPS: usize> LinearGradient<C, STOPS> {
    /// A gradient from one pixel to another. Without a length everything has the last colour.
    ///
    /// # Errors
    /// [`OutOfDomain`] where an end lies further than 8,191 pixels from the origin.
    pub fn new(from: Point, to: Point, ramp: Ramp<STOPS>) -> Result<Self, OutOfDomain> {
        SubPoint::<Sub8>::from_pixel(from)?;
        SubPoint::<Sub8>::from_pixel(to)?;
        // Below 2^14 each: the divisor is below 2^30.
        let (x, y) = (to.x - from.x, to.y - from.y);
        let divisor = 2 * (x * x + y * y);
        let (step, remainder_step) = divide(i64::from(2 * 255 * x), divisor as u32);
        Ok(Self {
            from,
            to,
            ramp,
            step,
            remainder_step,
            divisor: divisor as u32,
            color: PhantomData,
        })
    }

    /// The level of a pixel, not yet cut to 0 to 255, and what it leaves over of the divisor.
    fn level(&self, pixel: Point) -> (i64, u32) {
        // 2^33 times 2^14, twice, times 510: below 2^58.
        let along = |pixel: i32, from: i32, to: i32| (i64::from(pixel) - i64::from(from)) * i64::from(to - from);
        let along = along(pixel.x, self.from.x, self.to.x) + along(pixel.y, self.from.y, self.to.y);
        divide(along * 510 + i64::from(self.divisor / 2), self.divisor)
    }
}

/// Rounded down, and the remainder; past every end without a divisor.
fn divide(dividend: i64, divisor: u32) -> (i64, u32) {
    let divisor = i64::from(divisor);
    match (
        dividend.checked_div_euclid(divisor),
        dividend.checked_rem_euclid(divisor),
    ) {
        (Some(quotient), Some(remainder)) => (quotient, remainder as u32),
        _ => (255, 0),
    }
}

impl<C: PixelColor + From<Rgb888>, const STOPS: usize> Paint for LinearGradient<C, STOPS> {
    type Color = C;

    fn colors_from(&self, start: Point) -> impl Iterator<Item = C> {
        let (mut level, mut remainder) = self.level(start);
        let levels = core::iter::repeat_with(move || {
            let current = level.clamp(0, 255) as u8;
            // A window is far too narrow for 2^63 levels.
            level = level.wrapping_add(self.step);
            // Both below 2^30.
            remainder = remainder.wrapping_add(self.remainder_step);
            if remainder >= self.divisor {
                remainder = remainder.wrapping_sub(self.divisor);
                level = level.wrapping_add(i64::from(self.divisor != 0));
            }
            current
        });
        ramp_colors(&self.ramp, levels)
    }
}

#[cfg(feature = "defmt")]
impl<C, const STOPS: usize> defmt::Format for LinearGradient<C, STOPS> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(
            formatter,
            "LinearGradient ({}, {}) to ({}, {}), {}",
            self.from.x,
            self.from.y,
            self.to.x,
            self.to.y,
            self.ramp
        );
    }
}
