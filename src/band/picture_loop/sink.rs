//! Sinks: where a finished band goes.

use embedded_graphics::{draw_target::DrawTarget, geometry::Dimensions, primitives::Rectangle};

use crate::{
    band::Band,
    surface::{BandColor, Order},
};

/// Takes each finished band of a picture, top to bottom.
///
/// A closure `FnMut(Band<C, O>) -> Result<(), E>` is one.
#[diagnostic::on_unimplemented(
    message = "`{Self}` takes no bands",
    note = "a display that is a `DrawTarget` takes them as `DisplaySink(&mut display)`, a function of bytes as `BytesSink(..)`"
)]
pub trait Sink<C: BandColor, O: Order> {
    /// What can go wrong on the way to the display.
    type Error;

    /// Takes one band; returns when its words may be drawn over.
    ///
    /// # Errors
    /// Whatever the display reports; it stops the picture loop.
    fn send(&mut self, band: Band<'_, C, O>) -> Result<(), Self::Error>;
}

impl<C: BandColor, O: Order, E, F> Sink<C, O> for F
where
    F: FnMut(Band<'_, C, O>) -> Result<(), E>,
{
    type Error = E;

    fn send(&mut self, band: Band<'_, C, O>) -> Result<(), E> {
        self(band)
    }
}

/// Sends each band to an embedded-graphics display with one `fill_contiguous`.
#[derive(Debug)]
pub struct DisplaySink<'a, D: ?Sized>(pub &'a mut D);

impl<C: BandColor, O: Order, D: DrawTarget<Color = C>> Sink<C, O> for DisplaySink<'_, D> {
    type Error = D::Error;

    fn send(&mut self, band: Band<'_, C, O>) -> Result<(), D::Error> {
        self.0.fill_contiguous(&band.bounding_box(), band.colors())
    }
}

/// Sends each band as the bytes that the display takes: `FnMut(Rectangle, &[u8]) -> Result<(), E>`.
///
/// The bytes are those of [`Band::into_bytes`]: big-endian, packed below 8 bits a pixel.
#[derive(Debug)]
pub struct BytesSink<F>(pub F);

impl<C: BandColor, O: Order, E, F> Sink<C, O> for BytesSink<F>
where
    F: FnMut(Rectangle, &[u8]) -> Result<(), E>,
{
    type Error = E;

    fn send(&mut self, band: Band<'_, C, O>) -> Result<(), E> {
        let area = band.bounding_box();
        (self.0)(area, band.into_bytes())
    }
}

#[cfg(feature = "defmt")]
impl<D: ?Sized> defmt::Format for DisplaySink<'_, D> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "DisplaySink");
    }
}

#[cfg(feature = "defmt")]
impl<F> defmt::Format for BytesSink<F> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "BytesSink");
    }
}
