//! Mixing light: levels are turned into light, mixed, and turned back.
//!
//! A table holds the light of each level, with 24 bits, so that the darkest of 256 levels differ. A mix is not divided by
//! 255 but compared with 255 times the light in the middle between every two levels, which is in the table, too: from there
//! on, light rounds up to the next level. So turning back is a binary search with a step for each bit of the channel.
//!
//! Guarantees: for every channel and all levels, the result is at most 0.502 levels away from the exact mix for gamma up to
//! 2.5, and at most 0.53 up to 3.0 (rounding alone takes 0.5); a gamma of 1.0 gives the nearest level, as
//! [`Encoded`](crate::shade::blend::Encoded) does. Alpha 0 and 255 and a colour over itself are exact.
//!
//! Cost: integers only, no division; about ten operations a channel and one of its bits. A table for each channel width in
//! use: 32 bytes for 2 bits, 128 for 4, 256 for 5, 512 for 6, 2,048 for 8; so 768 bytes for `Rgb565`.

use crate::{
    coverage::Coverage,
    shade::{
        blend::TransferFunction,
        layout::{Channel, Channels, Layout},
    },
    surface::Order,
};

/// Levels stand for light to the power of `TENTHS / 10`, 10 to 30: shapes have the light of their coverage, so that thin
/// ones look neither too thin on dark ground nor too fat on bright ground.
///
/// 22, the default, is what displays are made for.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Gamma<const TENTHS: u32 = 22>;

impl<const TENTHS: u32> TransferFunction for Gamma<TENTHS> {
    fn blend<L: Layout, O: Order>(words: &mut [L::Word], color: L::Word, alpha: Coverage) {
        let drawn = L::split(color);
        let low = Mix::new::<TENTHS>(L::LOW, drawn.pair & 0xffff, alpha);
        let middle = Mix::new::<TENTHS>(L::MIDDLE, drawn.middle, alpha);
        let high = Mix::new::<TENTHS>(L::HIGH, drawn.pair >> 16, alpha);
        for word in words {
            let below = L::split(O::reorder(*word));
            let mixed = Channels {
                pair: low.over(below.pair & 0xffff) | high.over(below.pair >> 16) << 16,
                middle: middle.over(below.middle),
            };
            *word = O::reorder(L::join(mixed));
        }
    }
}

/// How one channel of a colour with alpha is mixed with the levels that lie below it.
struct Mix {
    bits: u32,
    table: &'static [u32],
    /// The light of the colour that is drawn, times its alpha.
    light: u32,
    /// 255 less the alpha: the weight of the light of what is below.
    rest: u32,
}

impl Mix {
    #[inline]
    fn new<const TENTHS: u32>(channel: Channel, level: u32, alpha: Coverage) -> Self {
        let table = Gamma::<TENTHS>::table(channel.bits);
        Self {
            bits: channel.bits,
            table,
            light: light(table, level) * u32::from(alpha),
            rest: u32::from(Coverage::MAX - alpha),
        }
    }

    /// The level that is nearest to the mix with a level below.
    #[inline]
    fn over(&self, below: u32) -> u32 {
        // The coverages add up to 255, so the sum is below 2^32.
        let mixed = light(self.table, below) * self.rest + self.light;
        let mut level = 0;
        for bit in (0..self.bits).rev() {
            let candidate = level | 1 << bit;
            // The middle between the candidate and the level before it.
            let middle = 2 * candidate as usize - 1;
            if self.table.get(middle).is_some_and(|&middle| mixed >= middle) {
                level = candidate;
            }
        }
        level
    }
}

/// The light of a level, 24 bits, by its table.
#[inline]
fn light(table: &[u32], level: u32) -> u32 {
    table.get(2 * level as usize).copied().unwrap_or(0)
}

impl<const TENTHS: u32> Gamma<TENTHS> {
    const TWO: &'static [u32] = &table::<8>(TENTHS);
    const FOUR: &'static [u32] = &table::<32>(TENTHS);
    const FIVE: &'static [u32] = &table::<64>(TENTHS);
    const SIX: &'static [u32] = &table::<128>(TENTHS);
    const EIGHT: &'static [u32] = &table::<512>(TENTHS);

    #[inline]
    const fn table(bits: u32) -> &'static [u32] {
        match bits {
            2 => Self::TWO,
            4 => Self::FOUR,
            5 => Self::FIVE,
            6 => Self::SIX,
            8 => Self::EIGHT,
            _ => &[],
        }
    }
}

/// The light of the brightest level, 24 bits.
const WHITE: u32 = (1 << 24) - 1;

/// The light of every level, at twice its number, and before it the least mix that rounds up to that level, in 1/255 of
/// light. The last entry is not used.
///
/// Evaluated by the compiler: no floating point reaches the machine.
const fn table<const ENTRIES: usize>(tenths: u32) -> [u32; ENTRIES] {
    assert!(tenths >= 10 && tenths <= 30, "gamma is 1.0 to 3.0");
    let mut table = [u32::MAX; ENTRIES];
    let last = ENTRIES - 2;
    let mut darker = 0;
    let mut entry = 0;
    while entry <= last {
        let light = WHITE as f64 * power(entry as f64 / last as f64, tenths) + 0.5;
        #[expect(clippy::indexing_slicing, reason = "evaluated by the compiler")]
        {
            table[entry] = light as u32;
            if entry > 0 {
                let middle = 255.0 * WHITE as f64 * power((entry - 1) as f64 / last as f64, tenths);
                // Rounded up: what is mixed is whole.
                table[entry - 1] = middle as u32 + 1;
                assert!(
                    darker < table[entry - 1] && table[entry - 1] <= 255 * table[entry],
                    "every level is its own"
                );
            }
            darker = 255 * table[entry];
        }
        entry += 2;
    }
    table
}

/// `base` to the power of `tenths / 10`, for a base from 0 to 1: the tenth root by bisection.
const fn power(base: f64, tenths: u32) -> f64 {
    let target = raised(base, tenths);
    let (mut low, mut high) = (0.0, 1.0);
    let mut step = 0;
    while step < 50 {
        let middle = (low + high) / 2.0;
        if raised(middle, 10) < target {
            low = middle;
        } else {
            high = middle;
        }
        step += 1;
    }
    high
}

/// `base` to the power of a whole number.
const fn raised(base: f64, exponent: u32) -> f64 {
    let (mut product, mut factor) = (1.0, 0);
    while factor < exponent {
        product *= base;
        factor += 1;
    }
    product
}
