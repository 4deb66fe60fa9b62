//! Ordered dithering: from 8 bits a channel to the fewer levels of a display, so that a mean of pixels keeps what one pixel
//! loses.
//!
//! A level of 8 bits lies between two levels that the display has. The way from the lower one to the upper one is divided into
//! 64 steps, and a pixel takes the upper one where Bayer's threshold at its position, 0 to 63, is below the level's number of
//! steps. Red of `Rgb565` has 41 and 49, as levels 5 and 6, so that 44 is level 6 in 24 of 64 pixels and level 5 in the others:
//!
//! ```text
//! level of 8 bits    41   42   43   44   45   46   47   48   49
//! steps               0    8   16   24   32   40   48   56    0
//! ```
//!
//! Guarantees: a level that the display has stays itself, black and white among them; of every 8 x 8 pixels of one colour so
//! many take the upper level as 64 times its fraction, rounded to the nearest; a brighter level is nowhere darker. The
//! threshold depends on the pixel's position in the picture alone. What a level of the display means in 8 bits is
//! embedded-graphics' conversion: rounded to the nearest.
//!
//! Cost: a table look-up and four operations a channel, and no division. Where words become half as large (`Rgb888` to
//! `Rgb565`), eight pixels side by side of one colour are copied from the eight before them, if those have that colour, too. A table
//! takes 512 bytes of flash; there is one for each number of bits that the display's channels have.
//!
//! Source: Bayer 1973.

use core::ops::Range;

use bytemuck::try_cast_slice_mut;

use crate::{
    geometry::Window,
    shade::{
        BlendedColor, ChannelColor,
        layout::{Channel, Layout},
        ordered_threshold::{BLOCK, thresholds_at},
    },
    surface::{BandColor, Order, PixelWord},
};

/// The word of the colour with 8 bits a channel from which a colour is dithered.
type EightBitWord<C> = <<C as ChannelColor>::EightBit as BandColor>::Word;
/// Where the channels are in that word.
type EightBitLayout<C> = <<C as ChannelColor>::EightBit as BlendedColor>::Layout;

/// Dithers the words of a window in place, row by row without gaps. Returns the words of the display's colours, which are the
/// first ones of the same memory.
pub(crate) fn dither<C: ChannelColor, O: Order>(words: &mut [EightBitWord<C>], window: Window) -> &mut [C::Word] {
    let (pixels, width) = (words.len(), window.width() as usize);
    let mut end = 0;
    for y in window.top..window.bottom {
        let start = end;
        end = pixels.min(start + width);
        dither_row::<C, O>(words, start..end, thresholds_at(window.left, y));
    }
    in_display_words::<C>(words).get_mut(..pixels).unwrap_or_default()
}

/// Dithers some pixels of one row, the first of which takes the first threshold. Their colours are written behind those of the
/// pixels before them.
fn dither_row<C: ChannelColor, O: Order>(words: &mut [EightBitWord<C>], row: Range<usize>, thresholds: &[u8; BLOCK]) {
    if const { size_of::<EightBitWord<C>>() == size_of::<C::Word>() } {
        let words = in_display_words::<C>(words).get_mut(row).unwrap_or_default();
        for block in words.chunks_mut(BLOCK) {
            for (word, &threshold) in block.iter_mut().zip(thresholds) {
                let bits = bits_of::<C::Layout>(O::reorder(*word));
                *word = O::reorder(level_word::<EightBitLayout<C>, C::Layout>(bits, threshold));
            }
        }
    } else {
        narrow_row::<C, O>(words, row, thresholds);
    }
}

/// Dithers some pixels of one row to words of half the size.
fn narrow_row<C: ChannelColor, O: Order>(words: &mut [EightBitWord<C>], row: Range<usize>, thresholds: &[u8; BLOCK]) {
    let mut start = row.start;
    // The word of the block before, if all of its pixels have one.
    let mut last = None;
    while start < row.end {
        let end = row.end.min(start + BLOCK);
        let pixels = words.get(start..end).unwrap_or_default();
        let block = pixels.first_chunk::<BLOCK>();
        let plain =
            block.and_then(|&[first, ref others @ ..]| others.iter().all(|&word| word == first).then_some(first));
        if plain.is_some() && plain == last {
            repeat_block(in_display_words::<C>(words), start);
        } else {
            // A copy, because other pixels of the block are where this one's colours are written.
            let block = block.copied().unwrap_or_else(|| filled_up(pixels));
            let mut narrowed = [C::Word::ZERO; BLOCK];
            for ((narrowed, &word), &threshold) in narrowed.iter_mut().zip(&block).zip(thresholds) {
                let bits = bits_of::<EightBitLayout<C>>(O::reorder(word));
                *narrowed = O::reorder(level_word::<EightBitLayout<C>, C::Layout>(bits, threshold));
            }
            let written = in_display_words::<C>(words).get_mut(start..end).unwrap_or_default();
            match written.first_chunk_mut() {
                Some(written) => *written = narrowed,
                None => written
                    .iter_mut()
                    .zip(narrowed)
                    .for_each(|(written, word)| *written = word),
            }
        }
        last = plain;
        start = end;
    }
}

/// Writes the eight words before an index once more behind it.
#[inline(always)]
fn repeat_block<W: PixelWord>(words: &mut [W], index: usize) {
    if let Some((before, behind)) = words.split_at_mut_checked(index) {
        if let (Some(before), Some(behind)) = (before.last_chunk::<BLOCK>(), behind.first_chunk_mut()) {
            *behind = *before;
        }
    }
}

/// Fewer than eight words at the end of a row, and behind them zeros.
#[cold]
fn filled_up<W: PixelWord>(words: &[W]) -> [W; BLOCK] {
    let mut block = [W::ZERO; BLOCK];
    block.iter_mut().zip(words).for_each(|(copy, &word)| *copy = word);
    block
}

/// The memory of some pixels as words of the display's colour, one or two for each pixel.
fn in_display_words<C: ChannelColor>(words: &mut [EightBitWord<C>]) -> &mut [C::Word] {
    // Does not fail: a word of the display's colour is no larger, and divides the other one.
    try_cast_slice_mut(words).unwrap_or_default()
}

/// A word as 32 bits.
#[inline(always)]
fn bits_of<L: Layout>(word: L::Word) -> u32 {
    word.into()
}

/// The word of the levels that a pixel takes.
#[inline(always)]
fn level_word<F: Layout, L: Layout>(bits: u32, threshold: u8) -> L::Word {
    let level = |from: Channel, to: Channel| match table(to.bits) {
        Some(table) => {
            let steps = table.get(from.of(bits) as usize).copied().unwrap_or(u16::MAX);
            ((u32::from(steps) - u32::from(threshold)) >> STEP_BITS) << to.shift
        }
        None => 0,
    };
    L::narrow(level(F::LOW, L::LOW) | level(F::MIDDLE, L::MIDDLE) | level(F::HIGH, L::HIGH))
}

/// Steps from level to level, as a power of two: the number of thresholds.
const STEP_BITS: u32 = 6;

/// For each level of 8 bits, 64 times the level below it of a channel with fewer bits, the steps beyond that, and 63.
type Steps = [u16; 256];

/// The table of a channel with a number of bits; `None` where the word has no such channel.
const fn table(bits: u32) -> Option<&'static Steps> {
    static ONE: Steps = steps(1);
    static TWO: Steps = steps(2);
    static FOUR: Steps = steps(4);
    static FIVE: Steps = steps(5);
    static SIX: Steps = steps(6);
    static EIGHT: Steps = steps(8);
    match bits {
        0 => None,
        1 => Some(&ONE),
        2 => Some(&TWO),
        4 => Some(&FOUR),
        5 => Some(&FIVE),
        6 => Some(&SIX),
        _ => Some(&EIGHT),
    }
}

/// Computes the table of a channel of 1 to 8 bits.
const fn steps(bits: u32) -> Steps {
    let max = (1 << bits) - 1;
    let mut steps = [0; 256];
    // The level of the display at or below the one of 8 bits.
    let (mut level, mut value) = (0, 0);
    while value < 256 {
        if level < max && value >= shown_as(level + 1, max) {
            level += 1;
        }
        let lower = shown_as(level, max);
        let fraction = if level == max {
            0
        } else {
            let distance = shown_as(level + 1, max) - lower;
            (((value - lower) << STEP_BITS) * 2 + distance) / (2 * distance)
        };
        #[expect(clippy::indexing_slicing, reason = "evaluated by the compiler")]
        {
            steps[value as usize] = ((level << STEP_BITS) + fraction + (1 << STEP_BITS) - 1) as u16;
        }
        value += 1;
    }
    steps
}

/// What a level up to `max` is in 8 bits, rounded to the nearest.
const fn shown_as(level: u32, max: u32) -> u32 {
    (level * 255 * 2 + max) / (2 * max)
}
