//! Where the channels of a word are: the outer two go side by side through one multiplication, the middle one alone.
//!
//! Red and blue change places between RGB and BGR; the arithmetic does not see it.

use crate::surface::PixelWord;

/// The bits of a channel in a word; none where the word has no such channel.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Channel {
    pub shift: u32,
    pub bits: u32,
}

impl Channel {
    const NONE: Self = Self { shift: 0, bits: 0 };

    const fn new(shift: u32, bits: u32) -> Self {
        Self { shift, bits }
    }

    #[inline]
    pub const fn of(self, word: u32) -> u32 {
        (word >> self.shift) & self.max()
    }

    /// The largest level of the channel.
    pub const fn max(self) -> u32 {
        (1u32 << self.bits) - 1
    }
}

/// Levels of the channels of a pixel, or sums of products with alphas.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Channels {
    /// The low channel in the lower 16 bits, the high one in the upper 16.
    pub pair: u32,
    /// The channel in the middle.
    pub middle: u32,
}

/// The layout of a word in the machine's byte order.
pub trait Layout {
    type Word: PixelWord + Into<u32>;

    const LOW: Channel;
    const MIDDLE: Channel;
    const HIGH: Channel;

    /// The lower bits as a word.
    fn narrow(bits: u32) -> Self::Word;

    #[inline]
    fn split(word: Self::Word) -> Channels {
        let word = word.into();
        Channels {
            pair: Self::LOW.of(word) | Self::HIGH.of(word) << 16,
            middle: Self::MIDDLE.of(word),
        }
    }

    /// The word with its levels multiplied by a factor of 0 to 32, in 1/32, rounded down.
    #[inline(always)]
    fn scaled(word: Self::Word, factor: u32) -> Self::Word {
        let Channels { pair, middle } = Self::split(word);
        // Levels below 2^8 times 2^5: two of them fit side by side.
        let levels = Self::LOW.max() | Self::HIGH.max() << 16;
        Self::join(Channels {
            pair: ((pair * factor) >> 5) & levels,
            middle: (middle * factor) >> 5,
        })
    }

    /// The word between two: of the other one's levels, a factor of 0 to 32 in 1/32, rounded down. 0 and 32 are the words
    /// themselves.
    #[inline(always)]
    fn mixed(one: Self::Word, other: Self::Word, factor: u32) -> Self::Word {
        let (one, other) = (Self::split(one), Self::split(other));
        // Levels below 2^8 times 2^5: two of them fit side by side.
        let levels = Self::LOW.max() | Self::HIGH.max() << 16;
        let rest = 32 - factor;
        Self::join(Channels {
            pair: ((one.pair * rest + other.pair * factor) >> 5) & levels,
            middle: (one.middle * rest + other.middle * factor) >> 5,
        })
    }

    /// The word with these levels, which must be in range.
    #[inline]
    fn join(channels: Channels) -> Self::Word {
        let low = (channels.pair & 0xffff) << Self::LOW.shift;
        let high = (channels.pair >> 16) << Self::HIGH.shift;
        Self::narrow(low | channels.middle << Self::MIDDLE.shift | high)
    }
}

macro_rules! layout {
    ($layout:ident, $word:ty: $low:expr, $middle:expr, $high:expr) => {
        impl Layout for $layout {
            type Word = $word;
            const LOW: Channel = $low;
            const MIDDLE: Channel = $middle;
            const HIGH: Channel = $high;

            #[inline]
            fn narrow(bits: u32) -> $word {
                bits as $word
            }
        }
    };
}

/// 15-bit colours: five bits a channel.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Word555;
layout!(Word555, u16: Channel::new(0, 5), Channel::new(5, 5), Channel::new(10, 5));

/// 16-bit colours: five, six and five bits.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Word565;
impl Layout for Word565 {
    type Word = u16;
    const LOW: Channel = Channel::new(0, 5);
    const MIDDLE: Channel = Channel::new(5, 6);
    const HIGH: Channel = Channel::new(11, 5);

    #[inline]
    fn narrow(bits: u32) -> u16 {
        bits as u16
    }

    #[inline(always)]
    fn scaled(word: u16, factor: u32) -> u16 {
        close_up(spread(word) * factor)
    }

    #[inline(always)]
    fn mixed(one: u16, other: u16, factor: u32) -> u16 {
        let (one, other) = (spread(one), spread(other));
        // (32 - factor) * one + factor * other, which is below 2^32; the difference may wrap.
        close_up((one << 5).wrapping_add(other.wrapping_sub(one).wrapping_mul(factor)))
    }
}

/// The bits of the channels of a 16-bit colour, the middle one above the others, so that all three have room for five more
/// bits.
const SPREAD_LEVELS: u32 = 0x07e0_f81f;

/// The channels of a 16-bit colour with room for five more bits each.
#[inline(always)]
fn spread(word: u16) -> u32 {
    let word = u32::from(word);
    (word | word << 16) & SPREAD_LEVELS
}

/// The 16-bit colour of channels with five more bits, rounded down.
#[inline(always)]
fn close_up(channels: u32) -> u16 {
    let levels = (channels >> 5) & SPREAD_LEVELS;
    (levels | levels >> 16) as u16
}

/// 18-bit colours: six bits a channel, at the top of each of three bytes.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SixBits;
layout!(SixBits, u32: Channel::new(2, 6), Channel::new(10, 6), Channel::new(18, 6));

/// 24-bit colours: eight bits a channel.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TrueColor;
layout!(TrueColor, u32: Channel::new(0, 8), Channel::new(8, 8), Channel::new(16, 8));

/// Greys: one channel of `BITS` bits in a byte.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Gray<const BITS: u32>;

impl<const BITS: u32> Layout for Gray<BITS> {
    type Word = u8;
    const LOW: Channel = Channel::new(0, BITS);
    const MIDDLE: Channel = Channel::NONE;
    const HIGH: Channel = Channel::NONE;

    #[inline]
    fn narrow(bits: u32) -> u8 {
        bits as u8
    }
}
