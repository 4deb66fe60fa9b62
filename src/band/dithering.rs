//! A band of 8 bits a channel becomes one of the display's colours, dithered in place.

use crate::{
    band::Band,
    shade::{ChannelColor, dither},
    surface::Order,
};

impl<'a, C: ChannelColor, O: Order> Band<'a, C, O> {
    /// The band in a colour of the display with fewer bits, dithered in place by an 8 x 8 Bayer matrix (Bayer 1973): the words
    /// of the result are the first ones of the same memory, and what lies behind them is used up.
    ///
    /// `Rgb888` becomes `Rgb565`, `Rgb555` or `Rgb666`, `Bgr888` their counterparts, `Gray8` becomes `Gray4`, `Gray2` or
    /// `BinaryColor`. The pattern depends on the position of a pixel in the picture alone, not on the band; a colour that the
    /// display has stays itself, and the mean of any 8 x 8 pixels of another one is within 1/128 of the distance between the
    /// display's two levels around it. [`Dithered`](crate::band::Dithered) does so on the way to a sink, and says what it costs.
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::{BinaryColor, Gray8}, prelude::*, primitives::Rectangle};
    /// use zrow::band::Band;
    ///
    /// let mut words = [0u8; 8];
    /// let mut band = Band::<Gray8>::new(Rectangle::new(Point::zero(), Size::new(8, 1)), &mut words)?;
    /// band.fill(Gray8::new(128));
    /// assert_eq!(band.into_dithered::<BinaryColor>().into_bytes(), [0b1010_1010]);
    /// # Ok::<(), zrow::geometry::TooSmall>(())
    /// ```
    pub fn into_dithered<D: ChannelColor<EightBit = C>>(self) -> Band<'a, D, O> {
        Band {
            window: self.window,
            stride: self.stride,
            words: dither::<D, O>(self.words, self.window),
            order: self.order,
        }
    }
}
