//! Filters over the samples of a picture: how much each sample counts for a pixel.
//!
//! A filter is a product of one along the rows and the same along the columns. Its weights are integers whose sum is a
//! power of two, so that a mean needs a shift and no division, and is rounded once. The names are those of
//! [`Grid`](crate::coverage::Grid), whose masks end at the pixel's boundary; here the windows of the last two reach into
//! the neighbouring pixels, as they do in signal processing:
//!
//! | filter | window, in pixels | weights |
//! |---|---|---|
//! | [`BoxFilter`] | 1 x 1 | all alike |
//! | [`Bartlett`] | 2 x 2 | 1, 3, 5 up to the middle and down again: a pyramid, whose sections are those of the cone |
//! | [`Gaussian`] | 3 x 3 | `exp(-2 d^2)` at a distance of `d` pixels: a standard deviation of half a pixel, cut at three |
//!
//! Source: Crow 1981; Foley, van Dam, Feiner and Hughes 1990. The Gaussian is in units of 1/4,096 of its sum, within half
//! a unit of the closed form.

use crate::coverage::{Bartlett, BoxFilter, Gaussian};

/// How much the samples around a pixel count, where a pixel has `N` x `N` samples.
pub trait SampleFilter<const N: usize> {
    /// What holds the weighted sum of a channel's levels over the window of a pixel.
    type Sum: SampleSum;

    /// Along one side of the window: `N` for each pixel of its width, which is 1, 2 or 3, about the pixel in question.
    const WEIGHTS: &'static [u16];

    /// The sum of the weights is 2 to this power, up to 12.
    const SUM_BITS: u32;
}

/// A number that sums are kept in: `u16` or `u32`.
pub trait SampleSum: Copy + Default + core::fmt::Debug + sealed::Sealed {
    /// The sum with more in it.
    #[must_use]
    fn plus(self, more: u32) -> Self;

    /// The sum.
    fn get(self) -> u32;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for u16 {}
    impl Sealed for u32 {}
}

impl SampleSum for u16 {
    #[inline(always)]
    fn plus(self, more: u32) -> Self {
        self.wrapping_add(more as Self)
    }

    #[inline(always)]
    fn get(self) -> u32 {
        self.into()
    }
}

impl SampleSum for u32 {
    #[inline(always)]
    fn plus(self, more: u32) -> Self {
        self.wrapping_add(more)
    }

    #[inline(always)]
    fn get(self) -> u32 {
        self
    }
}

macro_rules! filters {
    ($($samples:literal: $bartlett:ty, $gaussian:expr;)+) => { $(
        impl SampleFilter<$samples> for BoxFilter {
            // 16 * 16 * 255 is below 2^16.
            type Sum = u16;
            const WEIGHTS: &'static [u16] = &[1; $samples];
            const SUM_BITS: u32 = ($samples as u32).ilog2();
        }

        impl SampleFilter<$samples> for Bartlett {
            type Sum = $bartlett;
            const WEIGHTS: &'static [u16] = &mirrored::<$samples, { $samples * 2 }>(pyramid());
            // 1 + 3 + .. + (2 n - 1) is n^2, twice.
            const SUM_BITS: u32 = ($samples as u32).ilog2() * 2 + 1;
        }

        impl SampleFilter<$samples> for Gaussian {
            type Sum = u32;
            const WEIGHTS: &'static [u16] = &mirrored::<{ $samples / 2 * 3 }, { $samples * 3 }>($gaussian);
            const SUM_BITS: u32 = 12;
        }
    )+ };
}

filters! {
    2: u16, [72, 531, 1_445];
    4: u32, [19, 65, 177, 375, 618, 794];
    8: u32, [7, 13, 24, 43, 71, 109, 159, 218, 279, 337, 382, 406];
    16: u32, [3, 4, 6, 8, 11, 14, 19, 24, 31, 40, 49, 60, 73, 87, 101, 116, 132, 147, 162, 175, 186, 195, 201, 204];
}

/// 1, 3, 5 and so on.
const fn pyramid<const HALF: usize>() -> [u16; HALF] {
    let mut weights = [1; HALF];
    let mut index = 1;
    while index < HALF {
        #[allow(clippy::indexing_slicing, reason = "evaluated by the compiler")]
        {
            weights[index] = weights[index - 1] + 2;
        }
        index += 1;
    }
    weights
}

/// The same weights there and back again.
const fn mirrored<const HALF: usize, const WHOLE: usize>(half: [u16; HALF]) -> [u16; WHOLE] {
    let mut whole = [0; WHOLE];
    let mut index = 0;
    while index < HALF {
        #[allow(clippy::indexing_slicing, reason = "evaluated by the compiler")]
        {
            whole[index] = half[index];
            whole[WHOLE - 1 - index] = half[index];
        }
        index += 1;
    }
    whole
}

#[cfg(test)]
mod tests {
    extern crate std;

    use super::*;
    use std::vec::Vec;

    fn check<const N: usize, F: SampleFilter<N>>(pixels: usize, weight: impl Fn(f64) -> f64, tolerance: f64) {
        let weights = F::WEIGHTS;
        let sum = 1u32 << F::SUM_BITS;
        assert_eq!(weights.len(), pixels * N);
        assert_eq!(weights.iter().map(|&weight| u32::from(weight)).sum::<u32>(), sum);
        // Distances of the samples from the middle of the pixel, in pixels.
        let distance = |index: usize| (index as f64 + 0.5) / N as f64 - pixels as f64 / 2.0;
        let exact: Vec<f64> = (0..weights.len()).map(|index| weight(distance(index))).collect();
        let scale = f64::from(sum) / exact.iter().sum::<f64>();
        for (&weight, exact) in weights.iter().zip(exact) {
            assert!((f64::from(weight) - exact * scale).abs() <= tolerance, "{weight}");
        }
    }

    #[test]
    fn weights_are_those_of_the_closed_forms() {
        macro_rules! check {
            ($($samples:literal)+) => { $(
                check::<$samples, BoxFilter>(1, |_| 1.0, 0.0);
                check::<$samples, Bartlett>(2, |distance| 1.0 - distance.abs(), 1e-9);
                check::<$samples, Gaussian>(3, |distance| (-2.0 * distance * distance).exp(), 0.501);
                let most = u64::from(<BoxFilter as SampleFilter<$samples>>::SUM_BITS) * 2;
                assert!(255u64 << most <= u64::from(u16::MAX));
            )+ };
        }
        check!(2 4 8 16);
        assert!(255u32 << (<Bartlett as SampleFilter<2>>::SUM_BITS * 2) <= u32::from(u16::MAX));
    }
}
