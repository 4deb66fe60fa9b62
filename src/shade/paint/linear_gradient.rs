//! A linear gradient: the colour depends on how far a pixel is along a straight line.
//!
//! Guarantees: the level of a pixel is its exact position along the line, `255 (p - from).(to - from) / |to - from|^2`,
//! rounded to the nearest (ties up), wherever a span begins; in spans of up to 4 million pixels. It is stepped by
//! quotient and remainder (Field 1985), and its colour looked up. Cost: one division a span, of 64 bits where the
//! numbers need them, then about 16 instructions a pixel on a Cortex-M4.

use core::num::{NonZeroU32, Wrapping};

use embedded_graphics::{
    geometry::Point,
    pixelcolor::{PixelColor, Rgb888},
};

use crate::{
    geometry::{InputError, Sub8, SubPoint, divide_floor_wide},
    shade::{Paint, Ramp, paint::ramp::Colors},
};

/// A paint whose colours change along a straight line; beyond its ends the colours of the ends go on.
///
/// RAM: its 256 colours, 512 bytes in RGB565, 28 bytes and the [ramp](Ramp). Make it once, not for each band, because making it computes all of them.
///
/// ```
/// use embedded_graphics::{pixelcolor::{Gray8, Rgb888}, prelude::*};
/// use zrow::shade::{LinearGradient, Paint, Ramp};
///
/// let ramp = Ramp::between(Rgb888::BLACK, Rgb888::WHITE);
/// let gradient = LinearGradient::<Gray8, 2>::new(Point::new(10, 0), Point::new(15, 0), ramp)?;
/// let row: Vec<u8> = gradient.colors_from(Point::new(9, 3)).take(8).map(|color| color.luma()).collect();
/// assert_eq!(row, [0, 0, 51, 102, 153, 204, 255, 255]);
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct LinearGradient<C, const STOPS: usize> {
    from: Point,
    to: Point,
    ramp: Ramp<STOPS>,
    /// Levels from one column to the next, rounded down, and what that leaves over of `divisor`.
    step: i32,
    remainder_step: u32,
    /// Twice the square of the length; `None` for no length.
    divisor: Option<NonZeroU32>,
    colors: Colors<C>,
}

impl<C: PixelColor + From<Rgb888>, const STOPS: usize> LinearGradient<C, STOPS> {
    /// A gradient from one pixel to another. Without a length everything has the last colour.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where an end lies further than 8,191 pixels from the origin.
    pub fn new(from: Point, to: Point, ramp: Ramp<STOPS>) -> Result<Self, InputError> {
        SubPoint::<Sub8>::from_pixel(from)?;
        SubPoint::<Sub8>::from_pixel(to)?;
        // Below 2^14 each: the divisor is below 2^30.
        let (x, y) = (to.x - from.x, to.y - from.y);
        let divisor = NonZeroU32::new(2 * (x * x + y * y) as u32);
        // 255 levels a column at most.
        let (step, remainder_step) = divisor.map_or((0, 0), |divisor| divide_floor_wide(i64::from(510 * x), divisor));
        Ok(Self {
            from,
            to,
            ramp,
            step: step as i32,
            remainder_step,
            divisor,
            colors: ramp.colors(),
        })
    }

    /// The level of a pixel, not yet cut to 0 to 255, and the remainder of its division. Without a length, each pixel
    /// is past the end.
    ///
    /// The level is cut to 2^30: at 255 levels a pixel that takes 4 million pixels to come back from.
    fn level(&self, pixel: Point) -> (i32, u32) {
        const MOST: i64 = 1 << 30;
        let Some(divisor) = self.divisor else { return (255, 0) };
        // 2^33 times 2^14, twice, times 510: below 2^58.
        let along = |pixel: i32, from: i32, to: i32| (i64::from(pixel) - i64::from(from)) * i64::from(to - from);
        let along = along(pixel.x, self.from.x, self.to.x) + along(pixel.y, self.from.y, self.to.y);
        let (level, remainder) = divide_floor_wide(along * 510 + i64::from(divisor.get() / 2), divisor);
        (level.clamp(-MOST, MOST) as i32, remainder)
    }
}

impl<C: PixelColor + From<Rgb888>, const STOPS: usize> Paint for LinearGradient<C, STOPS> {
    type Color = C;

    #[inline]
    fn colors_from(&self, start: Point) -> impl Iterator<Item = C> {
        let (level, remainder) = self.level(start);
        // More than 4 million pixels away it may wrap.
        let mut level = Wrapping(level);
        let Self {
            step,
            remainder_step,
            divisor,
            ref colors,
            ..
        } = *self;
        // Less the divisor: it overflows when a level more is due. Without one, nothing is added that could.
        let divisor = Wrapping(divisor.map_or(0, NonZeroU32::get));
        let mut error = Wrapping(remainder) - divisor;
        core::iter::repeat_with(move || {
            let color = colors.at(level.0.clamp(0, 255) as u8);
            let (next, is_due) = error.0.overflowing_add(remainder_step);
            level += step;
            error = Wrapping(next);
            if is_due {
                level += 1;
                error -= divisor;
            }
            color
        })
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
