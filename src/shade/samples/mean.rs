//! The mean of many colours: levels are added up channel by channel, and rounded once.
//!
//! Guarantees: with weights that add up to a power of two, each channel is the weighted mean of its levels as they are
//! stored, rounded to the nearest (ties up), so that the mean of one colour is that colour, to the bit. Sums in 32 bits, no
//! division. `BinaryColor` has nothing to round to: an ordered threshold at the pixel's position says which of the two it is,
//! as in [blending](crate::shade::blend).

use crate::{
    shade::layout::{Channel, Layout},
    surface::Order,
};

/// Sums of the levels of the low, the middle and the high channel; where there is only one, it is the low one.
pub type Levels = [u32; 3];

const fn channels<L: Layout>() -> [Channel; 3] {
    [L::LOW, L::MIDDLE, L::HIGH]
}

/// Adds the levels of a pixel's word to the sums of its channels, each `weight` times. The sums stay below 2^32 where the weights
/// of a pixel add up to 2^24 at most.
#[inline(always)]
pub(crate) fn add_levels<L: Layout, O: Order>(sums: &mut Levels, word: L::Word, weight: u32) {
    let word = O::reorder(word).into();
    for (sum, channel) in sums.iter_mut().zip(channels::<L>()) {
        *sum += channel.of(word) * weight;
    }
}

/// The word of the mean colour, from sums whose weights add up to `1 << bits`: each channel rounded to the nearest level.
#[inline(always)]
pub(crate) fn mean_word<L: Layout, O: Order>(sums: Levels, bits: u32) -> L::Word {
    // A level times 2^24 and a half of 2^24 stay below 2^32.
    let half = (1u32 << bits) >> 1;
    let parts = sums.into_iter().zip(channels::<L>());
    let word = parts.fold(0, |word, (sum, channel)| word | ((sum + half) >> bits) << channel.shift);
    O::reorder(L::narrow(word))
}
