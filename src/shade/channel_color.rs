//! Colours whose pixels can be mixed: blended over each other, and added up to a mean.

use embedded_graphics::{
    geometry::Point,
    pixelcolor::{Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666, Rgb888},
};

use crate::{
    coverage::Coverage,
    shade::{
        blend::{Encoded, Gamma, TransferFunction},
        layout::{Gray, Layout, SixBits, TrueColor, Word555, Word565},
        ordered_threshold,
        samples::mean::{Levels, mean_word},
    },
    surface::{BandColor, LittleEndian, Order, PixelWord, not_constant},
};

/// A colour whose pixels can be blended and added up: all of embedded-graphics'. The trait is sealed.
pub trait ChannelColor: BlendedColor {
    /// Number of channels: 3, or 1 for greys.
    const CHANNELS: usize = if Self::Layout::MIDDLE.bits == 0 { 1 } else { 3 };

    /// The colour with the same channels in 8 bits each, `Rgb888`, `Bgr888` or `Gray8`: that in which a picture is drawn which
    /// is [dithered](crate::band::Dithered) to this one.
    type EightBit: ChannelColor;

    /// Blends this colour over another one at a pixel. Levels stand for light to the power of `TENTHS / 10`, 10 to 30: 10 mixes
    /// them as they are, as a band does; others mix light, as [`in_linear_light`](crate::band::Band::in_linear_light) does.
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::{BinaryColor, Gray8}, prelude::*};
    /// use zrow::shade::ChannelColor;
    ///
    /// let position = Point::zero();
    /// assert_eq!(Gray8::WHITE.over::<10>(Gray8::BLACK, 100, position), Gray8::new(100));
    /// assert_eq!(Gray8::WHITE.over::<22>(Gray8::BLACK, 100, position), Gray8::new(167));
    /// assert_eq!(BinaryColor::On.over::<10>(BinaryColor::Off, 100, position), BinaryColor::On);
    /// assert_eq!(BinaryColor::On.over::<10>(BinaryColor::Off, 100, position + Point::new(1, 0)), BinaryColor::Off);
    /// ```
    #[must_use]
    fn over<const TENTHS: u32>(self, below: Self, alpha: u8, position: Point) -> Self {
        let mut word = [below.to_word()];
        if TENTHS == 10 {
            blend_words::<Self, Encoded, LittleEndian>(&mut word, position, self, alpha);
        } else {
            blend_words::<Self, Gamma<TENTHS>, LittleEndian>(&mut word, position, self, alpha);
        }
        let [word] = word;
        Self::from_word(word)
    }
}

// Seals `ChannelColor`, and is not re-exported.
/// How the pixels of a colour are blended and added up.
pub trait BlendedColor: BandColor {
    /// The layout that says where in a word the channels are.
    type Layout: Layout<Word = Self::Word>;

    /// Whether there are levels between the darkest and the brightest, so that colours can be mixed.
    const IS_MIXED: bool = Self::Layout::LOW.bits > 1;

    /// The mean of the colours of a pixel, from sums whose weights add up to `1 << bits`, which is at most 24.
    #[inline]
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
}

/// Blends a colour over a run of words in a row, the first of which stands for the pixel at `position`.
///
/// Alpha 255 fills, alpha 0 does nothing. Cost: for words of 16 bits a load, a store, two multiplications and some 14
/// operations a pixel; `Gamma` takes several times that.
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
    ($($layout:ty, $eight_bit:ident: $($color:ident),+;)+) => {$($(
        impl ChannelColor for $color {
            type EightBit = $eight_bit;
        }

        impl BlendedColor for $color {
            type Layout = $layout;

            #[inline]
            fn blend_run<T: TransferFunction, O: Order>(words: &mut [Self::Word], _: Point, color: Self, alpha: Coverage) {
                T::blend::<$layout, O>(words, color.to_word(), alpha);
            }
        }
    )+)+};
}

channels! {
    Gray<2>, Gray8: Gray2;
    Gray<4>, Gray8: Gray4;
    Gray<8>, Gray8: Gray8;
    Word555, Rgb888: Rgb555;
    Word555, Bgr888: Bgr555;
    Word565, Rgb888: Rgb565;
    Word565, Bgr888: Bgr565;
    SixBits, Rgb888: Rgb666;
    SixBits, Bgr888: Bgr666;
    TrueColor, Rgb888: Rgb888;
    TrueColor, Bgr888: Bgr888;
}

impl ChannelColor for BinaryColor {
    type EightBit = Gray8;
}

impl BlendedColor for BinaryColor {
    type Layout = Gray<1>;

    fn mean<O: Order>([sum, ..]: Levels, bits: u32, position: impl FnOnce() -> Point) -> u8 {
        ordered_threshold::mean(sum, bits, position())
    }

    #[inline]
    fn blend_run<T: TransferFunction, O: Order>(words: &mut [u8], position: Point, color: Self, alpha: Coverage) {
        ordered_threshold::blend(words, position, color.to_word(), alpha);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Alpha 0 and 255 in the loop itself, which `blend_words` leaves out.
    fn ends_are_exact<C: ChannelColor + PartialEq, T: TransferFunction>(levels: impl Fn(u32) -> C) {
        for number in 0..4096 {
            let (color, below) = (levels(number), levels(number * 7 + 5));
            for (alpha, expected) in [(0, below), (255, color)] {
                let mut word = [below.to_word()];
                C::blend_run::<T, LittleEndian>(&mut word, Point::new(3, -5), color, alpha);
                assert_eq!(word, [expected.to_word()], "{number} to {alpha}");
            }
        }
    }

    #[test]
    fn the_loop_itself_is_exact_at_both_ends() {
        let grey = |number: u32| Gray8::new(number as u8);
        let color = |number: u32| Rgb565::new(number as u8, (number >> 3) as u8, (number >> 5) as u8);
        let bright = |number: u32| Rgb888::new(number as u8, (number >> 2) as u8, (number >> 4) as u8);
        ends_are_exact::<Gray2, Encoded>(|number| Gray2::new(number as u8));
        ends_are_exact::<Gray8, Encoded>(grey);
        ends_are_exact::<Rgb565, Encoded>(color);
        ends_are_exact::<Rgb888, Encoded>(bright);
        ends_are_exact::<Gray8, Gamma>(grey);
        ends_are_exact::<Rgb565, Gamma<18>>(color);
        ends_are_exact::<Rgb888, Gamma<10>>(bright);
        ends_are_exact::<Rgb888, Gamma<30>>(bright);
        ends_are_exact::<Bgr666, Gamma<24>>(|number| {
            Bgr666::new(number as u8, (number >> 3) as u8, (number >> 6) as u8)
        });
    }
}
