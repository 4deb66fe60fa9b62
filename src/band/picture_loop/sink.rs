//! Sinks: where a finished band goes.

use embedded_graphics::{draw_target::DrawTarget, geometry::Dimensions, primitives::Rectangle};

use crate::{
    band::Band,
    surface::{BandColor, Order},
};

/// Takes each finished band of a picture, top to bottom.
///
/// A closure `FnMut(Band<C, O>) -> Result<(), E>` is one.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*, primitives::Circle};
/// use zrow::{band::{Band, DisplaySink, Order, PictureLoop, Sink}, draw::{DrawOn, PrimitiveStyle}};
///
/// /// Sends inverted colours to another sink, for a panel that inverts what it shows.
/// struct Inverted<S>(S);
///
/// impl<O: Order, S: Sink<Rgb565, O>> Sink<Rgb565, O> for Inverted<S> {
///     type Error = S::Error;
///
///     fn send(&mut self, mut band: Band<'_, Rgb565, O>) -> Result<(), S::Error> {
///         for word in band.words_mut() {
///             *word = !*word;
///         }
///         self.0.send(band)
///     }
/// }
///
/// let mut display = MockDisplay::<Rgb565>::new();
/// let (area, mut row) = (display.bounding_box(), [0; 64]);
/// let mut sink = Inverted(DisplaySink(&mut display));
/// let disc = Circle::new(Point::zero(), 9).into_styled(PrimitiveStyle::with_fill(Rgb565::RED));
/// PictureLoop::new(area, Rgb565::BLACK).draw(&mut row, &mut sink, |band| disc.draw_on(band))?;
/// assert_eq!(display.get_pixel(Point::new(4, 4)), Some(Rgb565::CYAN));
/// assert_eq!(display.get_pixel(Point::new(9, 4)), Some(Rgb565::WHITE));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` takes no bands",
    note = "a display that is a `DrawTarget` takes them as `DisplaySink(&mut display)`",
    note = "a function of bytes takes them as `BytesSink(|area: Rectangle, bytes: &[u8]| ..)`, with the types of its arguments",
    note = "a `PagesSink` takes those of a picture in `BinaryColor`"
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
///
/// [`PictureLoop`](crate::band::PictureLoop) has an example.
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
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::{Circle, Rectangle}};
/// use zrow::{band::{BigEndian, BytesSink, PictureLoop}, draw::{DrawOn, PrimitiveStyle}};
///
/// # #[derive(Default)] struct Driver { windows: Vec<Rectangle>, data: Vec<u8> }
/// # impl Driver {
/// #     fn set_window(&mut self, area: Rectangle) -> Result<(), core::fmt::Error> { self.windows.push(area); Ok(()) }
/// #     fn write_pixels(&mut self, bytes: &[u8]) -> Result<(), core::fmt::Error> { self.data.extend(bytes); Ok(()) }
/// # }
/// # let mut driver = Driver::default();
/// let area = Rectangle::new(Point::zero(), Size::new(32, 24));
/// let disc = Circle::new(Point::zero(), 24).into_styled(PrimitiveStyle::with_fill(Rgb565::RED));
/// let mut sink = BytesSink(|area: Rectangle, bytes: &[u8]| {
///     driver.set_window(area)?;
///     driver.write_pixels(bytes)
/// });
/// PictureLoop::new(area, Rgb565::BLACK)
///     .rows(8)
///     .in_order::<BigEndian>()
///     .draw(&mut [0; 32 * 8], &mut sink, |band| disc.draw_on(band))?;
/// assert_eq!(driver.windows.len(), 3);
/// let pixel = |x: usize, y: usize| &driver.data[2 * (32 * y + x)..][..2];
/// assert_eq!((pixel(12, 12), pixel(28, 12)), (&[0xf8, 0][..], &[0, 0][..]));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
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
