//! Paints, and the target on which they take the place of colours.

use embedded_graphics::{geometry::Point, pixelcolor::PixelColor};

/// What an area is painted with: a colour for each pixel of the display.
pub trait Paint {
    /// The colour of the display that the paint is for.
    type Color: PixelColor;

    /// The colours from a pixel on, to the right, without end.
    fn colors_from(&self, start: Point) -> impl Iterator<Item = Self::Color>;
}

impl<P: Paint> Paint for &P {
    type Color = P::Color;

    fn colors_from(&self, start: Point) -> impl Iterator<Item = P::Color> {
        P::colors_from(self, start)
    }
}

// Not re-exported: `Target::painted` makes one of a target, and says what it is.
/// A target on which every pixel gets the paint's colour. `draw` says how.
#[derive(Debug)]
pub struct Painted<'t, T, P> {
    pub(crate) target: &'t mut T,
    pub(crate) paint: P,
}
