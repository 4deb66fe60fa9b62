//! How a colour lies in memory: one word a pixel, in little-endian or in big-endian byte order.

use core::hint::black_box;

use bytemuck::{Pod, cast_mut, try_cast_slice_mut};
use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, IntoStorage, PixelColor, Rgb555, Rgb565, Rgb666,
    Rgb888,
    raw::{BigEndian, LittleEndian, RawData, RawU1, RawU2, RawU4, RawU8, RawU16, RawU24},
};

// Seals what words a colour may have, and is not re-exported.
/// The word of one pixel: `u8`, `u16` or `u32`.
///
/// Inner loops are generic over the word, not over the colour: flash holds one loop a word size.
pub trait PixelWord: Pod + Eq + core::fmt::Debug + sealed::Sealed {
    /// The word of zero bits, for constants.
    const ZERO: Self;

    /// The word with its bytes in big-endian order; its own inverse.
    #[must_use]
    fn to_big_endian(self) -> Self;

    /// The word with its bytes in little-endian order; its own inverse.
    #[must_use]
    fn to_little_endian(self) -> Self;

    /// Writes the word into every pixel of a run. Cost: about one store for 4 bytes.
    fn fill(words: &mut [Self], word: Self);

    /// The word as often as 32 bits hold it.
    #[must_use]
    fn repeated(self) -> u32;

    /// The word that was [`repeated`](Self::repeated).
    #[must_use]
    fn from_repeated(repeated: u32) -> Self;

    /// Writes a [`repeated`](Self::repeated) word into every pixel of a run; inlined, for a loop that is worth a copy
    /// of the code.
    fn fill_repeated(words: &mut [Self], repeated: u32);

    /// Writes the word into the first `width` pixels of every `stride`, which is at least 1.
    fn fill_rows(words: &mut [Self], stride: usize, width: usize, word: Self) {
        let repeated = word.repeated();
        for row in words.chunks_mut(stride.max(1)) {
            if let Some(row) = row.get_mut(..width) {
                Self::fill_repeated(row, repeated);
            }
        }
    }
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for u8 {}
    impl Sealed for u16 {}
    impl Sealed for u32 {}
}

impl PixelWord for u8 {
    const ZERO: Self = 0;

    fn to_big_endian(self) -> Self {
        self
    }

    fn to_little_endian(self) -> Self {
        self
    }

    #[inline(always)]
    fn fill(words: &mut [Self], word: Self) {
        if STORES_ANYWHERE {
            fill_u8(words, word.repeated());
        } else {
            words.fill(word);
        }
    }

    #[inline(always)]
    fn repeated(self) -> u32 {
        u32::from(self) * 0x0101_0101
    }

    fn from_repeated(repeated: u32) -> Self {
        repeated as u8
    }

    #[inline(always)]
    fn fill_repeated(words: &mut [Self], repeated: u32) {
        if STORES_ANYWHERE {
            fill_bytes(words, repeated);
        } else {
            words.fill(repeated as u8);
        }
    }
}

/// Fills pixels with a repeated byte.
#[inline(never)]
fn fill_u8(words: &mut [u8], repeated: u32) {
    u8::fill_repeated(words, repeated);
}

/// Fills pixels with a repeated byte, four a store, also across 32-bit words.
#[inline(always)]
fn fill_bytes(words: &mut [u8], repeated: u32) {
    if words.len() >= 32 {
        fill_last_block::<_, 32, 8>(words, repeated);
        let mut rest = words;
        while fill_leading_block::<_, 64, 16>(&mut rest, repeated) {}
        fill_leading_block::<_, 32, 8>(&mut rest, repeated);
    } else if words.len() >= 16 {
        fill_ends::<_, 16, 4>(words, repeated);
    } else if words.len() >= 8 {
        fill_ends::<_, 8, 2>(words, repeated);
    } else if words.len() >= 4 {
        fill_ends::<_, 4, 1>(words, repeated);
    } else {
        for pixel in words {
            *pixel = repeated as u8;
            // The compiler would call `memset`.
            black_box(());
        }
    }
}

impl PixelWord for u16 {
    const ZERO: Self = 0;

    fn to_big_endian(self) -> Self {
        self.to_be()
    }

    fn to_little_endian(self) -> Self {
        self.to_le()
    }

    #[inline(always)]
    fn fill(words: &mut [Self], word: Self) {
        fill_u16(words, word.repeated());
    }

    #[inline(always)]
    fn repeated(self) -> u32 {
        u32::from(self) | u32::from(self) << 16
    }

    fn from_repeated(repeated: u32) -> Self {
        repeated as u16
    }

    /// Two pixels a store.
    #[inline(always)]
    fn fill_repeated(words: &mut [Self], repeated: u32) {
        let word = repeated as u16;
        if words.len() < SHORT / 2 {
            if words.len() >= 4 {
                fill_ends::<_, 4, 2>(words, repeated);
            } else if words.len() >= 2 {
                fill_ends::<_, 2, 1>(words, repeated);
            } else if let Some(pixel) = words.first_mut() {
                *pixel = word;
            }
        } else if words.len() > 2 * SHORT {
            if STORES_ANYWHERE {
                fill_long_run(words, repeated);
            } else {
                // Pixels at an odd half of a 32-bit word are written singly, the last pixel in any case, because that takes
                // less than a test.
                if let Some(last) = words.last_mut() {
                    *last = word;
                }
                let mut words = words;
                if words.as_ptr().addr() & 2 != 0 {
                    fill_block::<1, u16>(&mut words, word);
                }
                if let Some(pairs) = as_pairs(words) {
                    fill_words(pairs, repeated);
                }
            }
        } else if words.len() >= SHORT {
            fill_ends::<_, SHORT, 8>(words, repeated);
        } else {
            fill_ends::<_, 8, 4>(words, repeated);
        }
    }
}

/// Fills pixels with a repeated word, which takes less to hand over than the word.
#[inline(never)]
fn fill_u16(words: &mut [u16], repeated: u32) {
    // Asked first, because most runs that are worth a call are long.
    if STORES_ANYWHERE && words.len() > 2 * SHORT {
        fill_long_run(words, repeated);
    } else {
        u16::fill_repeated(words, repeated);
    }
}

/// Fills the first `N` pixels and the last `N`, which may overlap: that takes less than counting. `N` pixels are as many
/// bytes as `STORES` words of 32 bits.
///
/// One store for 32 bits, also across 32-bit words where the machine can.
#[inline(always)]
fn fill_ends<W, const N: usize, const STORES: usize>(words: &mut [W], repeated: u32)
where
    [W; N]: Pod,
    [[u8; 4]; STORES]: Pod,
{
    fill_first_block::<_, N, STORES>(words, repeated);
    if let Some(last) = words.last_chunk_mut::<N>() {
        *cast_mut::<_, [[u8; 4]; STORES]>(last) = [repeated.to_ne_bytes(); STORES];
    }
}

/// Fills the first `N` pixels, which are as many bytes as `STORES` words of 32 bits.
#[inline(always)]
fn fill_first_block<W, const N: usize, const STORES: usize>(words: &mut [W], repeated: u32)
where
    [W; N]: Pod,
    [[u8; 4]; STORES]: Pod,
{
    // Bytes have no alignment; a block made elsewhere and copied here would take stack.
    if let Some(first) = words.first_chunk_mut::<N>() {
        *cast_mut::<_, [[u8; 4]; STORES]>(first) = [repeated.to_ne_bytes(); STORES];
    }
}

/// Whether the processor stores 32 bits at any address with one instruction, as a Cortex-M3 and larger ones do.
const STORES_ANYWHERE: bool = cfg!(all(target_arch = "arm", target_has_atomic = "32"));

/// Fills more than 32 pixels, in blocks that halve and begin at whole 32-bit words, where the processor stores 32 bits with one
/// instruction; two a store, so that the last one of an odd number may be left out.
///
/// One store a pair: a Cortex-M4 takes a cycle for it, but three for a store of two pairs.
#[inline(always)]
fn fill_long_run(words: &mut [u16], repeated: u32) {
    // First of all, so that what lies behind it needs no register from here on.
    fill_last_block::<_, { 2 * SHORT }, SHORT>(words, repeated);
    // The first pixel is written singly in any case, because that takes less than a test.
    if let Some(first) = words.first_mut() {
        *first = repeated as u16;
    }
    // 1 where the first pixel is an odd half of a 32-bit word. Computed, not branched on, so that the function has no stack
    // frame.
    let odd = (words.as_ptr().addr() >> 1) & 1;
    let Some(mut rest) = words.get_mut(odd..) else {
        return;
    };
    if rest.len() <= 64 {
        fill_first_block::<_, { 2 * SHORT }, SHORT>(rest, repeated);
        return;
    }
    if rest.len() > 128 {
        while fill_leading_block::<_, 256, 128>(&mut rest, repeated) {
            // The compiler would unroll this loop once more.
            black_box(());
        }
        fill_leading_block::<_, 128, 64>(&mut rest, repeated);
    }
    fill_leading_block::<_, 64, 32>(&mut rest, repeated);
    fill_leading_block::<_, 32, 16>(&mut rest, repeated);
}

/// Fills the last `N` pixels, which are as many bytes as `STORES` words of 32 bits. They overlap what is filled already: that
/// takes less than sorting out the remainder.
#[inline(always)]
fn fill_last_block<W, const N: usize, const STORES: usize>(words: &mut [W], repeated: u32)
where
    [W; N]: Pod,
    [[u8; 4]; STORES]: Pod,
{
    // `last_chunk_mut` would link a panic here, although it has none to take.
    let last = words.len().checked_sub(N).and_then(|start| words.get_mut(start..));
    if let Some(last) = last.and_then(|last| last.first_chunk_mut::<N>()) {
        *cast_mut::<_, [[u8; 4]; STORES]>(last) = [repeated.to_ne_bytes(); STORES];
    }
}

/// Fills the first `N` pixels, which are as many bytes as `STORES` words of 32 bits, and leaves the rest; does nothing where
/// there are no more.
#[inline(always)]
fn fill_leading_block<W, const N: usize, const STORES: usize>(words: &mut &mut [W], repeated: u32) -> bool
where
    [W; N]: Pod,
    [[u8; 4]; STORES]: Pod,
{
    if words.len() <= N {
        return false;
    }
    let Some((block, rest)) = core::mem::take(words).split_first_chunk_mut::<N>() else {
        return false;
    };
    // Bytes have no alignment, so that no two stores become one of 64 bits.
    *cast_mut::<_, [[u8; 4]; STORES]>(block) = [repeated.to_ne_bytes(); STORES];
    *words = rest;
    true
}

/// The pixels as pairs, but for the last of an odd number; `None` where they begin at an odd half of a 32-bit word.
#[inline(always)]
fn as_pairs(words: &mut [u16]) -> Option<&mut [u32]> {
    let even = words.len() & !1;
    try_cast_slice_mut(words.get_mut(..even)?).ok()
}

impl PixelWord for u32 {
    const ZERO: Self = 0;

    fn to_big_endian(self) -> Self {
        self.to_be()
    }

    fn to_little_endian(self) -> Self {
        self.to_le()
    }

    #[inline(never)]
    fn fill(words: &mut [Self], word: Self) {
        fill_words(words, word);
    }

    fn repeated(self) -> u32 {
        self
    }

    fn from_repeated(repeated: u32) -> Self {
        repeated
    }

    #[inline(always)]
    fn fill_repeated(words: &mut [Self], repeated: u32) {
        fill_words(words, repeated);
    }
}

/// Hides a word's value from the compiler, which would fill with a constant 0 by calling the generic `memclr` for every
/// block: that takes twice as long.
pub(crate) fn not_constant<W: PixelWord>(word: W) -> W {
    black_box(word)
}

/// Fills words in blocks, each half as long as the one before it.
#[inline(always)]
fn fill_words(words: &mut [u32], word: u32) {
    let mut rest = words;
    while fill_block::<64, u32>(&mut rest, word) {}
    // No loops from here on, which the compiler would unroll once more.
    fill_block::<32, u32>(&mut rest, word);
    fill_block::<16, u32>(&mut rest, word);
    fill_block::<8, u32>(&mut rest, word);
    fill_block::<4, u32>(&mut rest, word);
    fill_block::<2, u32>(&mut rest, word);
    fill_block::<1, u32>(&mut rest, word);
}

/// Runs of up to twice as many pixels are written as two blocks, which may overlap: that takes less than finding whole
/// 32-bit words.
const SHORT: usize = 16;

/// Fills the first `N` words and leaves the rest; does nothing where there are fewer.
#[inline(always)]
fn fill_block<const N: usize, W: Copy>(words: &mut &mut [W], word: W) -> bool {
    // Tested first, so that `words` is not left empty where no block can be split off.
    if words.len() < N {
        return false;
    }
    let Some((block, rest)) = core::mem::take(words).split_first_chunk_mut::<N>() else {
        return false;
    };
    *block = [word; N];
    *words = rest;
    true
}

/// Byte order of the words of a band: one of embedded-graphics' own, as in its `Framebuffer`.
///
/// - [`LittleEndian`], the default: the order of Cortex-M, RISC-V and Xtensa chips and of most desktops, fastest to draw and to
///   read back there.
/// - [`BigEndian`]: the bytes of a band are what a display takes over SPI, so DMA needs only a cast.
///
/// A function that is generic over the order draws into bands of both:
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::{band::{Band, BigEndian, LittleEndian, Order}, draw::{DrawOn, PrimitiveStyle}};
///
/// fn bar<O: Order>(band: &mut Band<'_, Rgb565, O>, percent: u32) {
///     let bar = Rectangle::new(Point::zero(), Size::new(percent / 25, 1));
///     let Ok(()) = bar.into_styled(PrimitiveStyle::with_fill(Rgb565::RED)).draw_on(band);
/// }
///
/// let (area, mut words) = (Rectangle::new(Point::zero(), Size::new(4, 1)), [0; 4]);
/// // Red is 0xf800: its bytes as they lie in memory.
/// bar(&mut Band::<Rgb565, LittleEndian>::new(area, &mut words)?, 50);
/// assert_eq!(words.map(u16::to_ne_bytes), [[0x00, 0xf8], [0x00, 0xf8], [0; 2], [0; 2]]);
/// bar(&mut Band::<Rgb565, BigEndian>::new(area, &mut words)?, 100);
/// assert_eq!(words.map(u16::to_ne_bytes), [[0xf8, 0x00]; 4]);
/// # Ok::<(), zrow::geometry::TooSmall>(())
/// ```
pub trait Order: Copy + core::fmt::Debug + 'static {
    /// Turns a word from the machine's order to this one, and back: each order is its own inverse.
    #[must_use]
    fn reorder<W: PixelWord>(word: W) -> W;
}

impl Order for LittleEndian {
    fn reorder<W: PixelWord>(word: W) -> W {
        word.to_little_endian()
    }
}

impl Order for BigEndian {
    fn reorder<W: PixelWord>(word: W) -> W {
        word.to_big_endian()
    }
}

/// A colour that a band can hold: all of embedded-graphics' own, and what a program implements this trait for.
///
/// Colours of less than 8 bits take a byte a pixel, so that drawing needs no masks; the sink packs them.
///
/// A program for panels of several kinds is generic over the colour, whose word is what its row consists of:
///
/// ```
/// use embedded_graphics::{
///     mock_display::MockDisplay, pixelcolor::{BinaryColor, Rgb565}, prelude::*, primitives::Circle,
/// };
/// use zrow::{
///     band::{BandColor, DisplaySink, LoopError, PictureLoop},
///     draw::{DrawOn, PrimitiveStyle},
/// };
///
/// /// Shows a disc in the second colour on the first one.
/// fn show<C: BandColor, D: DrawTarget<Color = C>>(
///     display: &mut D,
///     row: &mut [C::Word],
///     [background, color]: [C; 2],
/// ) -> Result<(), LoopError<D::Error>> {
///     let disc = Circle::new(Point::zero(), 9).into_styled(PrimitiveStyle::with_fill(color));
///     PictureLoop::new(display.bounding_box(), background)
///         .draw(row, &mut DisplaySink(display), |band| disc.draw_on(band))
/// }
///
/// let (mut lcd, mut oled) = (MockDisplay::new(), MockDisplay::new());
/// show(&mut lcd, &mut [0u16; 64], [Rgb565::BLACK, Rgb565::CSS_GOLD])?;
/// show(&mut oled, &mut [0u8; 64], [BinaryColor::Off, BinaryColor::On])?;
/// assert_eq!(lcd.get_pixel(Point::new(4, 4)), Some(Rgb565::CSS_GOLD));
/// assert_eq!(oled.get_pixel(Point::new(4, 4)), Some(BinaryColor::On));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
///
/// The inks of an electronic paper are a colour of a program's own, with a byte a pixel. It may as well hold the colour type of a
/// driver:
///
/// ```
/// use embedded_graphics::{pixelcolor::raw::RawU8, prelude::*, primitives::*};
/// use zrow::{band::{Band, BandColor}, draw::{DrawOn, PrimitiveStyle}};
///
/// #[derive(Debug, Copy, Clone, PartialEq)]
/// enum Ink { White, Black, Red }
///
/// impl PixelColor for Ink {
///     type Raw = RawU8;
/// }
///
/// impl BandColor for Ink {
///     type Word = u8;
///
///     fn to_word(self) -> u8 {
///         self as u8
///     }
///
///     fn from_word(word: u8) -> Self {
///         match word { 1 => Self::Black, 2 => Self::Red, _ => Self::White }
///     }
/// }
///
/// let (area, mut words) = (Rectangle::new(Point::zero(), Size::new(4, 1)), [Ink::White.to_word(); 4]);
/// let mut band = Band::<Ink>::new(area, &mut words)?;
/// let bar = Rectangle::new(Point::zero(), Size::new(3, 1)).into_styled(PrimitiveStyle::with_fill(Ink::Red));
/// let Ok(()) = bar.draw_on(&mut band);
/// assert!(band.colors().eq([Ink::Red, Ink::Red, Ink::Red, Ink::White]));
/// # Ok::<(), zrow::geometry::TooSmall>(())
/// ```
pub trait BandColor: PixelColor + 'static {
    /// The word of one pixel: `u8`, `u16` or `u32`.
    type Word: PixelWord;

    /// The word of a colour, in the machine's byte order.
    fn to_word(self) -> Self::Word;

    /// The colour of a word, in the machine's byte order.
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
band_color!(u32, RawU24: Rgb888, Bgr888);

/// 18-bit colours: six bits a channel at the top of three bytes, as panels take them.
macro_rules! six_bit_color {
    ($($color:ident),+) => {$(
        impl BandColor for $color {
            type Word = u32;

            fn to_word(self) -> u32 {
                let packed = self.into_storage();
                (packed & 0x3_f000) << 6 | (packed & 0xfc0) << 4 | (packed & 0x3f) << 2
            }

            fn from_word(word: u32) -> Self {
                let packed = (word >> 6) & 0x3_f000 | (word >> 4) & 0xfc0 | (word >> 2) & 0x3f;
                Self::from(RawU24::from_u32(packed))
            }
        }
    )+};
}

six_bit_color!(Rgb666, Bgr666);

#[cfg(test)]
mod tests {
    use super::{PixelWord, fill_bytes, fill_long_run};

    /// Every length up to two long blocks, from an even and from an odd index.
    fn fills_exactly<W: PixelWord + Default>(word: W) {
        let mut words = [W::default(); 280];
        for start in 0..8 {
            for length in 0..=270 {
                words.fill(W::default());
                if start & 4 == 0 {
                    W::fill(&mut words[start..start + length], word);
                } else {
                    W::fill_repeated(&mut words[start..start + length], word.repeated());
                }
                for (index, &found) in words.iter().enumerate() {
                    let inside = (start..start + length).contains(&index);
                    assert_eq!(found == word, inside, "word {index} of {length} from {start}");
                }
            }
        }
    }

    /// A row that does not fit the stride, or the words that are left, is not filled.
    fn fills_rows_exactly<W: PixelWord + Default>(word: W) {
        for (stride, width, length) in (0..12).flat_map(|s| (0..14).flat_map(move |w| (0..40).map(move |l| (s, w, l))))
        {
            let mut words = [W::default(); 48];
            W::fill_rows(&mut words[3..3 + length], stride, width, word);
            let step = stride.max(1);
            for (index, &found) in words.iter().enumerate() {
                let is_filled = index
                    .checked_sub(3)
                    .filter(|&offset| offset < length)
                    .is_some_and(|offset| {
                        let row = offset / step * step;
                        width <= step.min(length - row) && offset - row < width
                    });
                assert_eq!(found == word, is_filled, "{index}: {width} in {stride}, {length} words");
            }
        }
    }

    #[test]
    fn rows_are_filled_and_nothing_between_them() {
        fills_rows_exactly(0xA5u8);
        fills_rows_exactly(0xA55Au16);
        fills_rows_exactly(0xA55A_C33Cu32);
    }

    /// Also where the processor of the desktop fills in another way.
    #[test]
    fn bytes_are_filled_four_a_store_and_no_other() {
        for (start, length) in (0..5).flat_map(|start| (0..300).map(move |length| (start, length))) {
            let mut bytes = [0; 310];
            fill_bytes(&mut bytes[start..start + length], 0xA5u8.repeated());
            for (index, &found) in bytes.iter().enumerate() {
                let inside = (start..start + length).contains(&index);
                assert_eq!(found == 0xA5, inside, "byte {index} of {length} from {start}");
            }
        }
    }

    /// Also where the processor of the desktop fills in another way.
    #[test]
    fn long_runs_are_filled_two_pixels_a_store_and_no_other() {
        for (start, length) in (0..3).flat_map(|start| (33..600).map(move |length| (start, length))) {
            let mut words = [0; 610];
            fill_long_run(&mut words[start..start + length], 0xA55Au16.repeated());
            for (index, &found) in words.iter().enumerate() {
                let inside = (start..start + length).contains(&index);
                assert_eq!(found == 0xA55A, inside, "pixel {index} of {length} from {start}");
            }
        }
    }

    #[test]
    fn a_fill_writes_its_words_and_no_other() {
        fills_exactly(0xA5u8);
        fills_exactly(0xA55Au16);
        fills_exactly(0xA55A_C33Cu32);
    }
}
