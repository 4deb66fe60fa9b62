//! Colours whose pixels can be mixed: blended over each other, and added up to a mean.

use embedded_graphics::{
    geometry::Point,
    pixelcolor::{Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666, Rgb888},
};

use crate::{
    coverage::Coverage,
    shade::{
        blend::TransferFunction,
        layout::{Gray, Layout, SixBits, TrueColor, Word555, Word565},
        ordered_threshold,
        samples::mean::{Levels, mean_word},
    },
    surface::{BandColor, Native, Order, PixelWord, not_constant},
};

/// A colour whose pixels can be blended and added up: all of embedded-graphics'.
pub trait ChannelColor: BandColor {
    /// The layout that says where in a word the channels are.
    #[doc(hidden)]
    type Layout: Layout<Word = Self::Word>;

    /// Number of channels: 3, or 1 for greys.
    const CHANNELS: usize = if Self::Layout::MIDDLE.bits == 0 { 1 } else { 3 };

    /// Whether there are levels between the darkest and the brightest, so that colours can be mixed.
    #[doc(hidden)]
    const IS_MIXED: bool = Self::Layout::LOW.bits > 1;

    /// The mean of the colours of a pixel, from sums whose weights add up to `1 << bits`, which is at most 24.
    #[doc(hidden)]
    #[inline(always)]
    fn mean<O: Order>(sums: Levels, bits: u32, _position: impl FnOnce() -> Point) -> Self::Word {
        mean_word::<Self::Layout, O>(sums, bits)
    }

    /// Blends a colour over a run of words in a row. The first one stands for the pixel at `position`, which counts where
    /// the colour has no levels to mix.
    ///
    /// For an alpha of 0 or 255 a [`Band`](crate::band::Band) has a shorter way: it leaves the words alone, or fills them.
    fn blend_run<T: TransferFunction, O: Order>(
        words: &mut [Self::Word],
        position: Point,
        color: Self,
        alpha: Coverage,
    );

    /// Blends this colour over another one at a pixel.
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::{BinaryColor, Gray8}, prelude::*};
    /// use zrow::shade::{ChannelColor, Encoded, Gamma};
    ///
    /// let position = Point::zero();
    /// assert_eq!(Gray8::WHITE.over::<Encoded>(Gray8::BLACK, 100, position), Gray8::new(100));
    /// assert_eq!(Gray8::WHITE.over::<Gamma>(Gray8::BLACK, 100, position), Gray8::new(167));
    /// assert_eq!(BinaryColor::On.over::<Encoded>(BinaryColor::Off, 100, position), BinaryColor::On);
    /// assert_eq!(BinaryColor::On.over::<Encoded>(BinaryColor::Off, 100, position + Point::new(1, 0)), BinaryColor::Off);
    /// ```
    #[must_use]
    fn over<T: TransferFunction>(self, below: Self, alpha: Coverage, position: Point) -> Self {
        let mut word = [below.to_word()];
        blend_words::<Self, T, Native>(&mut word, position, self, alpha);
        let [word] = word;
        Self::from_word(word)
    }
}

/// Blends a colour over a run of words in a row, the first of which stands for the pixel at `position`.
///
/// Alpha 255 fills, alpha 0 does nothing. Cost: for words of 16 bits a load, a store, two multiplications and some 14
/// operations a pixel; [`Gamma`](crate::shade::Gamma) takes several times that.
#[inline]
pub fn blend_words<C: ChannelColor, T: TransferFunction, O: Order>(
    words: &mut [C::Word],
    position: Point,
    color: C,
    alpha: Coverage,
) {
    match alpha {
        0 => {}
        Coverage::MAX => C::Word::fill(words, not_constant(O::reorder(color.to_word()))),
        _ => C::blend_run::<T, O>(words, position, color, alpha),
    }
}

macro_rules! channels {
    ($($layout:ty: $($color:ident),+;)+) => {$($(
        impl ChannelColor for $color {
            type Layout = $layout;

            #[inline]
            fn blend_run<T: TransferFunction, O: Order>(words: &mut [Self::Word], _: Point, color: Self, alpha: Coverage) {
                T::blend::<$layout, O>(words, color.to_word(), alpha);
            }
        }
    )+)+};
}

channels! {
    Gray<2>: Gray2;
    Gray<4>: Gray4;
    Gray<8>: Gray8;
    Word555: Rgb555, Bgr555;
    Word565: Rgb565, Bgr565;
    SixBits: Rgb666, Bgr666;
    TrueColor: Rgb888, Bgr888;
}

impl ChannelColor for BinaryColor {
    type Layout = Gray<1>;

    fn mean<O: Order>([sum, ..]: Levels, bits: u32, position: impl FnOnce() -> Point) -> u8 {
        ordered_threshold::mean(sum, bits, position())
    }

    #[inline]
    fn blend_run<T: TransferFunction, O: Order>(words: &mut [u8], position: Point, color: Self, alpha: Coverage) {
        ordered_threshold::blend(words, position, color.to_word(), alpha);
    }
}
