//! A pattern: a small picture that repeats in both directions.
//!
//! Guarantees: pixel (x, y) of the display has the picture's pixel (x - origin.x) mod width, (y - origin.y) mod height,
//! wherever a span begins. Cost: two remainders a span, then a comparison a pixel.

use core::num::NonZeroUsize;

use embedded_graphics::{geometry::Point, pixelcolor::PixelColor};

use crate::{
    geometry::{InputError, remainder_floor},
    shade::Paint,
};

/// A paint: a picture that repeats in both directions.
///
/// ```
/// use embedded_graphics::{pixelcolor::BinaryColor::{self, Off, On}, prelude::*};
/// use zrow::shade::{Paint, Pattern};
///
/// let checks = Pattern::new(2, &[On, Off, Off, On])?;
/// let row: Vec<BinaryColor> = checks.colors_from(Point::new(-3, 0)).take(4).collect();
/// assert_eq!(row, [Off, On, Off, On]);
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct Pattern<'a, C> {
    colors: &'a [C],
    width: NonZeroUsize,
    height: NonZeroUsize,
    origin: Point,
}

impl<'a, C> Pattern<'a, C> {
    /// A pattern whose rows are `width` colours each. Its first pixel is at the origin of the display.
    ///
    /// # Errors
    /// [`InputError::NotARectangle`].
    pub const fn new(width: usize, colors: &'a [C]) -> Result<Self, InputError> {
        let error = InputError::NotARectangle {
            width,
            colors: colors.len(),
        };
        let (Some(height), Some(0)) = (colors.len().checked_div(width), colors.len().checked_rem(width)) else {
            return Err(error);
        };
        let (Some(width), Some(height)) = (NonZeroUsize::new(width), NonZeroUsize::new(height)) else {
            return Err(error);
        };
        Ok(Self {
            colors,
            width,
            height,
            origin: Point::zero(),
        })
    }

    /// The pattern with its first pixel elsewhere.
    #[must_use]
    pub const fn with_origin(self, origin: Point) -> Self {
        Self { origin, ..self }
    }
}

impl<C: PixelColor> Paint for Pattern<'_, C> {
    type Color = C;

    fn colors_from(&self, start: Point) -> impl Iterator<Item = C> {
        let width = self.width.get();
        // Below the number of colours, which is `width * height`.
        let row = remainder_floor(start.y, self.origin.y, self.height) * width;
        let colors = self.colors.get(row..row + width).unwrap_or_default();
        let mut index = remainder_floor(start.x, self.origin.x, self.width);
        core::iter::from_fn(move || {
            let color = colors.get(index).copied();
            index += 1;
            if index >= colors.len() {
                index = 0;
            }
            color
        })
    }
}

#[cfg(feature = "defmt")]
impl<C> defmt::Format for Pattern<'_, C> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "Pattern {}x{}", self.width, self.height);
    }
}
