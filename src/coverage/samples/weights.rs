//! Weights of the samples of a pixel (pixel-weighting masks, Crow 1981; Hearn and Baker 1997): all alike, by a pyramid, or by
//! a bell. The weight of a sample is the product of two numbers, one for its column and one for its row, so that a mask of
//! `N` x `N` weights is one function of an index.

use core::num::NonZeroU32;

// Not re-exported: `Grid` takes what implements it.
/// Weights of the samples along one side of the pixel; the weight of a sample is the product of two.
pub trait Weights {
    /// Weight of sample `index` of `count` along a side, counted from 0: from 1 to 255. The index is below the count, and that
    /// at most 16.
    fn weight(index: i32, count: NonZeroU32) -> i32;
}

/// The box filter: all samples of a pixel have the same weight.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BoxFilter;

/// The Bartlett filter, a pyramid: a sample has the more weight, the nearer it is to the centre of the pixel.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bartlett;

/// The Gaussian filter, a bell with a standard deviation of a quarter of a pixel; of half a pixel where windows reach
/// into neighbouring pixels.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Gaussian;

impl Weights for BoxFilter {
    fn weight(_index: i32, _count: NonZeroU32) -> i32 {
        1
    }
}

impl Weights for Bartlett {
    fn weight(index: i32, count: NonZeroU32) -> i32 {
        (index + 1).min(count.get() as i32 - index)
    }
}

impl Weights for Gaussian {
    fn weight(index: i32, count: NonZeroU32) -> i32 {
        // 8 * exp(-8 d^2) at distances d of 1/32, 3/32 .. 15/32 pixel, rounded.
        const BELL: [i32; 8] = [8, 7, 7, 5, 4, 3, 2, 1];
        let from_centre = (2 * index + 1 - count.get() as i32).unsigned_abs();
        let step = from_centre * 8 / count;
        BELL.get(step as usize).copied().unwrap_or(1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each weight of a side fits eight bits and is at least 1, and the sides are mirror images.
    #[test]
    fn weights_are_positive_bytes_and_symmetric() {
        for count in 1..=16 {
            let samples = NonZeroU32::new(count as u32).unwrap();
            for index in 0..count {
                let weights = |index| {
                    [
                        BoxFilter::weight(index, samples),
                        Bartlett::weight(index, samples),
                        Gaussian::weight(index, samples),
                    ]
                };
                assert!(weights(index).iter().all(|weight| (1..=255).contains(weight)));
                assert_eq!(weights(index), weights(count - 1 - index));
            }
        }
    }
}
