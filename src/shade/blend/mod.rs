//! Blending: a colour over what is drawn already, as much of it as its alpha says.
//!
//! Guarantees: each channel is `(alpha * color + (255 - alpha) * below) / 255`, rounded once to the nearest level, so that
//! it is never off by more than half a level; alpha 0 leaves what is below and alpha 255 writes the colour, to the bit; a
//! colour over itself stays the same. Integers only, and no division a pixel. [`Gamma`] does the same in linear light.
//!
//! `BinaryColor` has nothing between its two: a pixel takes the colour or stays, by an ordered threshold (Bayer 1973) at its
//! position in the picture. Of every 8 x 8 pixels, `alpha * 64 / 255` take it, rounded to the nearest.
//!
//! Source: `over` of Porter and Duff 1984 on what is opaque; the division by 255 is Blinn 1994 ("Three wrongs make a
//! right"), tested for every sum.

mod encoded;
mod gamma;

pub use encoded::Encoded;
pub use gamma::Gamma;

use embedded_graphics::{
    geometry::Point,
    pixelcolor::{Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666, Rgb888},
};

use crate::{
    coverage::Coverage,
    shade::{
        ChannelColor,
        layout::{Gray, Layout, SixBits, TrueColor, Word555, Word565},
        ordered_threshold,
    },
    surface::{BandColor, Native, Order, PixelWord, not_constant},
};

/// What the levels of a channel mean where two colours are mixed: [`Encoded`] or [`Gamma`].
pub trait TransferFunction: Copy + core::fmt::Debug + Default + 'static + sealed::Sealed {
    /// Blends a colour over a run of words.
    #[doc(hidden)]
    fn blend<L: Layout, O: Order>(words: &mut [L::Word], color: L::Word, alpha: Coverage);
}

mod sealed {
    pub trait Sealed {}
}

/// A colour that can be blended: all that a band can hold.
pub trait Blend: BandColor {
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
    /// use zrow::shade::{Blend, Encoded, Gamma};
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
/// operations a pixel; [`Gamma`] takes several times that.
#[inline]
pub fn blend_words<C: Blend, T: TransferFunction, O: Order>(
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

macro_rules! blend_channels {
    ($($layout:ty: $($color:ident),+;)+) => {$($(
        impl Blend for $color {
            #[inline]
            fn blend_run<T: TransferFunction, O: Order>(words: &mut [Self::Word], _: Point, color: Self, alpha: Coverage) {
                T::blend::<$layout, O>(words, color.to_word(), alpha);
            }
        }

        impl ChannelColor for $color {
            type Layout = $layout;
        }
    )+)+};
}

blend_channels! {
    Gray<2>: Gray2;
    Gray<4>: Gray4;
    Gray<8>: Gray8;
    Word555: Rgb555, Bgr555;
    Word565: Rgb565, Bgr565;
    SixBits: Rgb666, Bgr666;
    TrueColor: Rgb888, Bgr888;
}

impl Blend for BinaryColor {
    #[inline]
    fn blend_run<T: TransferFunction, O: Order>(words: &mut [u8], position: Point, color: Self, alpha: Coverage) {
        ordered_threshold::blend(words, position, color.to_word(), alpha);
    }
}
