//! The mean of many colours: levels are added up channel by channel, and rounded once.
//!
//! Promises: with weights that add up to a power of two, each channel is the weighted mean of its levels as they are
//! stored, rounded to the nearest (ties up), so that the mean of one colour is that colour, to the bit. Sums in 32 bits,
//! no division.

use crate::{
    shade::blend::layout::{Channel, Layout},
    target::{BandColor, Order},
};

/// A colour with levels that can be added up: all of embedded-graphics' but `BinaryColor`, between whose two there is
/// nothing.
pub trait ChannelColor: BandColor {
    /// Where the channels are.
    #[doc(hidden)]
    type Layout: Layout<Word = Self::Word>;

    /// 3, or 1 for greys.
    const CHANNELS: usize = if Self::Layout::MIDDLE.bits == 0 { 1 } else { 3 };
}

/// Sums of the levels of the low, the middle and the high channel; where there is only one, it is the low one.
pub(crate) type Levels = [u32; 3];

const fn channels<L: Layout>() -> [Channel; 3] {
    [L::LOW, L::MIDDLE, L::HIGH]
}

/// Adds the levels of a word to what is there, each so many times.
#[inline(always)]
pub(crate) fn add_levels<L: Layout, O: Order>(sums: &mut Levels, word: L::Word, weight: u32) {
    let word = O::reorder(word).into();
    for (sum, channel) in sums.iter_mut().zip(channels::<L>()) {
        *sum = sum.wrapping_add(channel.of(word).wrapping_mul(weight));
    }
}

/// The mean of sums whose weights add up to `1 << bits`, which is at most 24.
#[inline(always)]
pub(crate) fn mean_word<L: Layout, O: Order>(sums: Levels, bits: u32) -> L::Word {
    // A level times 2^24 and a half of 2^24 stay below 2^32.
    let half = (1u32 << bits) >> 1;
    let parts = sums.into_iter().zip(channels::<L>());
    let word = parts.fold(0, |word, (sum, channel)| {
        word | (sum.wrapping_add(half) >> bits) << channel.shift
    });
    O::reorder(L::narrow(word))
}
