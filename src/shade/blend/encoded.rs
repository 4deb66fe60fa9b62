//! Blending levels as they are stored, gamma-encoded: `(alpha * colour + (255 - alpha) * below) / 255`, two channels in one word.
//!
//! Guarantees: the nearest level, exactly. The sum of both products is at most 255 * 255, two such sums fit into 32 bits,
//! and no quotient lies half way between two levels, because 255 is odd.
//!
//! Source of the division: Blinn 1994, "Three Wrongs Make a Right", IEEE Computer Graphics and Applications 15(6).

use crate::{
    coverage::Coverage,
    shade::{
        blend::TransferFunction,
        layout::{Channels, Layout},
    },
    surface::Order,
};

/// Blends the levels of a channel as they are stored: what most libraries do, and the default.
///
/// On a display, which has a gamma of about 2.2, half of white over black is a fifth of its light:
/// thin bright shapes on dark ground look thinner than they are, see [`Gamma`](crate::shade::blend::Gamma).
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Encoded;

impl TransferFunction for Encoded {
    #[inline]
    fn blend<L: Layout, O: Order>(words: &mut [L::Word], color: L::Word, alpha: Coverage) {
        let rest = u32::from(Coverage::MAX) - u32::from(alpha);
        let drawn = L::split(color);
        // What the colour adds is the same for every pixel, and so is the 128 that makes a division round.
        let pair = drawn.pair * u32::from(alpha) + 0x0080_0080;
        let middle = drawn.middle * u32::from(alpha) + 0x80;
        for word in words {
            let below = L::split(O::reorder(*word));
            let mixed = Channels {
                pair: pair_of_levels(below.pair * rest + pair),
                middle: level(below.middle * rest + middle),
            };
            *word = O::reorder(L::join(mixed));
        }
    }
}

/// A 255th, rounded to the nearest, of a sum to which 128 was added.
#[inline]
const fn level(sum: u32) -> u32 {
    (sum + (sum >> 8)) >> 8
}

/// A 255th, rounded to the nearest, of the sum in each half of a word, to which 128 was added (Blinn 1994). Neither half carries
/// into the other: 255 * 255 + 128 + 254 is below 2^16.
#[inline]
const fn pair_of_levels(sums: u32) -> u32 {
    ((sums + ((sums >> 8) & 0x00ff_00ff)) >> 8) & 0x00ff_00ff
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_sum_is_divided_exactly_alone_and_in_pairs() {
        for sum in 0..=255 * 255 {
            let nearest = (2 * sum + 255) / 510;
            assert_eq!(level(sum + 128), nearest);
            for other in [0, sum, 255 * 255] {
                let both = pair_of_levels((sum + 128) | (other + 128) << 16);
                assert_eq!(both, nearest | ((2 * other + 255) / 510) << 16);
                let swapped = pair_of_levels((other + 128) | (sum + 128) << 16);
                assert_eq!(swapped, ((2 * other + 255) / 510) | nearest << 16);
            }
        }
    }
}
