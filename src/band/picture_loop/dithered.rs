//! A sink that dithers each band on its way to another one.

use core::marker::PhantomData;

use crate::{
    band::{Band, Sink},
    shade::ChannelColor,
    surface::Order,
};

/// A sink for pictures of 8 bits a channel, which hands each band to another sink in a display's colour `C`, dithered.
///
/// The picture loop and what is drawn are in `C::EightBit`: `Rgb888` for a display of `Rgb565`, `Gray8` for one of `Gray4` or
/// `BinaryColor`. A band is dithered in place as [`Band::into_dithered`] does, so that no second row is needed: a row for
/// `Rgb565` takes 4 bytes a pixel instead of 2, one of greys 1 as before. The picture is the same in bands of any height.
/// Where a transfer takes the buffer away ([`OverlappingSink`](crate::band::OverlappingSink)), call `into_dithered` before it starts.
///
/// Cost on a Cortex-M4: 22 instructions a pixel (28 cycles) from `Rgb888` to `Rgb565`, 9 (13) along runs of one colour, 10 (11)
/// for greys. In flash beside the code: 1,152 bytes of tables for `Rgb565`, 640 for greys of one depth.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Rgb565, Rgb888}, prelude::*, primitives::*};
/// use zrow::{band::{DisplaySink, Dithered, PictureLoop}, draw::{DrawOn, PrimitiveStyle}};
///
/// let mut display = MockDisplay::<Rgb565>::new();
/// let mut row = [0u32; 64];
/// let sky = display.bounding_box().into_styled(PrimitiveStyle::with_fill(Rgb888::new(0, 0, 20)));
/// PictureLoop::new(display.bounding_box(), Rgb888::BLACK)
///     .draw(&mut row, &mut Dithered::new(DisplaySink(&mut display)), |band| sky.draw_on(band))?;
/// // Blue 2 of 31 stands for 16, and 3 for 25: four in nine pixels take the brighter one.
/// assert_eq!(display.get_pixel(Point::new(0, 0)), Some(Rgb565::new(0, 0, 3)));
/// assert_eq!(display.get_pixel(Point::new(1, 0)), Some(Rgb565::new(0, 0, 2)));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Dithered<C, S> {
    sink: S,
    color: PhantomData<C>,
}

impl<C: ChannelColor, S> Dithered<C, S> {
    /// Dithers to the colour of a sink. Where the sink takes several, as a [`BytesSink`](crate::band::BytesSink) does, name it:
    /// `Dithered::<Rgb565, _>::new(sink)`.
    pub const fn new(sink: S) -> Self {
        Self {
            sink,
            color: PhantomData,
        }
    }
}

impl<C: ChannelColor, O: Order, S: Sink<C, O>> Sink<C::EightBit, O> for Dithered<C, S> {
    type Error = S::Error;

    fn send(&mut self, band: Band<'_, C::EightBit, O>) -> Result<(), S::Error> {
        self.sink.send(band.into_dithered::<C>())
    }
}

#[cfg(feature = "defmt")]
impl<C, S> defmt::Format for Dithered<C, S> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "Dithered");
    }
}
