//! Mixing light: levels are turned into light, mixed, and turned back.
//!
//! Promises: for gamma up to 2.4 the result is at most 0.7 levels away from the exact mix (where rounding alone takes 0.5), but
//! for the darkest 24 of 256 levels, where light of 16 bits is coarse: 0.65 levels for gamma 1.8, 1.55 for 2.2, 2.75 for 2.4.
//! Shares 0 and 255 and a colour over itself are exact. A table for each channel width in use: 16 bytes for 2 bits, 64 for 4,
//! 128 for 5, 256 for 6, 1,024 for 8; so 384 bytes for `Rgb565`.
//!
//! The table holds the light of every level and of the middle between every two. What lies above such a middle rounds up,
//! so turning back is a search of as many steps as the channel has bits.

use crate::{
    coverage::Share,
    shade::blend::{
        Transfer,
        layout::{Channel, Channels, Layout},
        sealed::Sealed,
    },
    target::Order,
};

/// Levels stand for light to the power of `TENTHS / 10`, 10 to 30: shapes have the light of their coverage, so that thin ones
/// look neither too thin on dark ground nor too fat on bright ground.
///
/// 22, the default, is what displays are made for.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Gamma<const TENTHS: u32 = 22>;

impl<const TENTHS: u32> Sealed for Gamma<TENTHS> {}

impl<const TENTHS: u32> Transfer for Gamma<TENTHS> {
    fn blend<L: Layout, O: Order>(words: &mut [L::Word], color: L::Word, share: Share) {
        let drawn = L::split(color);
        let low = Mix::new::<TENTHS>(L::LOW, drawn.pair & 0xffff, share);
        let middle = Mix::new::<TENTHS>(L::MIDDLE, drawn.middle, share);
        let high = Mix::new::<TENTHS>(L::HIGH, drawn.pair >> 16, share);
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

/// One channel of a colour that is drawn.
struct Mix {
    bits: u32,
    table: &'static [u16],
    /// Its light times the share, and what rounds.
    light: u32,
    rest: u32,
}

impl Mix {
    #[inline(always)]
    fn new<const TENTHS: u32>(channel: Channel, level: u32, share: Share) -> Self {
        let table = Gamma::<TENTHS>::table(channel.bits);
        Self {
            bits: channel.bits,
            table,
            light: light(table, level).wrapping_mul(u32::from(share)).wrapping_add(0x80),
            rest: u32::from(Share::MAX.wrapping_sub(share)),
        }
    }

    #[inline(always)]
    fn over(&self, below: u32) -> u32 {
        // Below 2^24: the 255th is the exact one, or one less in 65,535, but exact for light mixed with itself.
        let sum = light(self.table, below)
            .wrapping_mul(self.rest)
            .wrapping_add(self.light);
        let mixed = sum.wrapping_add(sum >> 8).wrapping_add(sum >> 16) >> 8;
        let mut level = 0;
        for bit in (0..self.bits).rev() {
            let candidate = level | 1 << bit;
            // The middle between the candidate and the level before it.
            let middle = (2 * candidate as usize).wrapping_sub(1);
            if self.table.get(middle).is_some_and(|&middle| mixed >= u32::from(middle)) {
                level = candidate;
            }
        }
        level
    }
}

#[inline(always)]
fn light(table: &[u16], level: u32) -> u32 {
    table.get(2 * level as usize).copied().map_or(0, u32::from)
}

impl<const TENTHS: u32> Gamma<TENTHS> {
    const TWO: &'static [u16] = &table::<8>(TENTHS);
    const FOUR: &'static [u16] = &table::<32>(TENTHS);
    const FIVE: &'static [u16] = &table::<64>(TENTHS);
    const SIX: &'static [u16] = &table::<128>(TENTHS);
    const EIGHT: &'static [u16] = &table::<512>(TENTHS);

    #[inline(always)]
    const fn table(bits: u32) -> &'static [u16] {
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

/// The light of half levels, from 0 to 65,535, each at least one more than the one before it. The last entry is not used.
///
/// Evaluated by the compiler: no floating point reaches the machine.
const fn table<const ENTRIES: usize>(tenths: u32) -> [u16; ENTRIES] {
    assert!(tenths >= 10 && tenths <= 30, "gamma is 1.0 to 3.0");
    let mut table = [u16::MAX; ENTRIES];
    let last = ENTRIES - 2;
    let (mut entry, mut least) = (0, 0);
    while entry < last {
        let exact = 65_535.0 * power(entry as f64 / last as f64, tenths) + 0.5;
        let rounded = exact as u16;
        #[allow(clippy::indexing_slicing, reason = "evaluated by the compiler")]
        {
            table[entry] = if rounded < least { least } else { rounded };
            least = table[entry] + 1;
        }
        entry += 1;
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

const fn raised(base: f64, exponent: u32) -> f64 {
    let (mut product, mut factor) = (1.0, 0);
    while factor < exponent {
        product *= base;
        factor += 1;
    }
    product
}
