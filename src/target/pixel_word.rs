//! How a colour lies in memory: one word a pixel, in native or in big-endian byte order.

use bytemuck::{Pod, pod_align_to_mut};
use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, IntoStorage, PixelColor, Rgb555, Rgb565, Rgb666,
    Rgb888,
    raw::{RawData, RawU1, RawU2, RawU4, RawU8, RawU16, RawU24},
};

/// The word of one pixel: `u8`, `u16` or `u32`.
///
/// Inner loops are generic over the word, not over the colour: flash holds one loop a word size.
pub trait PixelWord: Pod + Eq + core::fmt::Debug + sealed::Sealed {
    /// The word with its bytes in big-endian order; its own inverse.
    #[must_use]
    fn swapped_to_big_endian(self) -> Self;

    /// Writes the word into every pixel of a run. Cost: about one store for 8 bytes.
    fn fill(words: &mut [Self], word: Self);
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for u8 {}
    impl Sealed for u16 {}
    impl Sealed for u32 {}
}

impl PixelWord for u8 {
    fn swapped_to_big_endian(self) -> Self {
        self
    }

    fn fill(words: &mut [Self], word: Self) {
        words.fill(word);
    }
}

impl PixelWord for u16 {
    fn swapped_to_big_endian(self) -> Self {
        self.to_be()
    }

    fn fill(words: &mut [Self], word: Self) {
        // Two pixels a store: the pairs in the middle are written as 32-bit words.
        let (head, pairs, tail) = pod_align_to_mut::<u16, u32>(words);
        head.fill(word);
        u32::fill(pairs, u32::from(word) << 16 | u32::from(word));
        tail.fill(word);
    }
}

impl PixelWord for u32 {
    fn swapped_to_big_endian(self) -> Self {
        self.to_be()
    }

    fn fill(words: &mut [Self], word: Self) {
        let mut blocks = words.chunks_exact_mut(32);
        for block in &mut blocks {
            block.fill(word);
        }
        blocks.into_remainder().fill(word);
    }
}

/// Byte order of the words of a band.
pub trait Order: Copy + core::fmt::Debug + Default + 'static {
    /// From native order to this one, and back: each order is its own inverse.
    #[must_use]
    fn reorder<W: PixelWord>(word: W) -> W;
}

/// The machine's own byte order: fastest to draw and to read back.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Native;

/// Big-endian words: the bytes of a band are what a display takes over SPI, so DMA needs only a cast.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BigEndian;

impl Order for Native {
    fn reorder<W: PixelWord>(word: W) -> W {
        word
    }
}

impl Order for BigEndian {
    fn reorder<W: PixelWord>(word: W) -> W {
        word.swapped_to_big_endian()
    }
}

/// A colour that a band can hold: all of embedded-graphics' own.
///
/// Colours of less than 8 bits take a byte a pixel, so that drawing needs no masks; the sink packs them.
pub trait BandColor: PixelColor {
    /// The word of one pixel.
    type Word: PixelWord;

    /// The word of a colour, native byte order.
    fn to_word(self) -> Self::Word;

    /// The colour of a word, native byte order.
    fn from_word(word: Self::Word) -> Self;
}

macro_rules! band_color {
    ($word:ty, $raw:ident: $($color:ident),+) => {$(
        impl BandColor for $color {
            type Word = $word;

            fn to_word(self) -> $word {
                self.into_storage()
            }

            fn from_word(word: $word) -> Self {
                Self::from($raw::from_u32(u32::from(word)))
            }
        }
    )+};
}

band_color!(u8, RawU1: BinaryColor);
band_color!(u8, RawU2: Gray2);
band_color!(u8, RawU4: Gray4);
band_color!(u8, RawU8: Gray8);
band_color!(u16, RawU16: Rgb555, Bgr555, Rgb565, Bgr565);
band_color!(u32, RawU24: Rgb666, Bgr666, Rgb888, Bgr888);
