//! Filters over the samples of a picture: how much each sample counts for a pixel.
//!
//! Weights are integers whose sum is a power of two, so that a mean needs a shift and no division, and is rounded once.
//! Most filters are a product of one along the rows and the same along the columns, which takes one pass over the samples.
//! The names are those of [`Grid`](crate::coverage::Grid), whose masks end at the pixel's boundary; here all windows but the
//! first reach into the neighbouring pixels, as they do in signal processing:
//!
//! | filter | window, in pixels | weights |
//! |---|---|---|
//! | [`BoxFilter`] | 1 x 1 | all alike |
//! | [`Bartlett`] | 2 x 2 | a product of 1, 3, 5 up to the middle and down again: Crow's pyramid |
//! | [`ConeFilter`] | 2 x 2 | `1 - d` at a distance of `d` pixels, 0 from there on: round, and no product |
//! | [`Gaussian`] | 3 x 3 | `exp(-2 d^2)` at a distance of `d` pixels: a standard deviation of half a pixel, cut at three |
//!
//! Source: Crow 1981, whose masks (1 2 1, 2 4 2, 1 2 1 and larger) are the pyramid's for an odd number of samples; Gupta and
//! Sproull 1981 for the cone; Foley, van Dam, Feiner and Hughes 1990 for both. The Gaussian is in units of 1/4,096 of its
//! sum, within half a unit of the closed form.

use crate::coverage::{Bartlett, BoxFilter, Gaussian};

/// How much the samples around a pixel count, where a pixel has `N` x `N` samples.
pub trait SampleFilter<const N: usize> {
    /// What holds the weighted sum of a channel's levels over the window of a pixel.
    type Sum: SampleSum;

    /// Pixels along one side of the window, which lies about the pixel in question: 1, 2 or 3.
    const PIXELS: usize;

    /// The weights of the samples of the window.
    const WEIGHTS: SampleWeights;

    /// The sum of all weights is 4 to this power, up to 12.
    const SUM_BITS: u32;

    /// The weight of a sample of the window by its column and row, both counted from 0; 0 outside of it.
    fn weight(column: usize, row: usize) -> u32 {
        let side = Self::PIXELS.saturating_mul(N);
        if column >= side || row >= side {
            return 0;
        }
        match Self::WEIGHTS {
            SampleWeights::Product(weights) => {
                let [across, down] = [column, row].map(|index| weights.get(index).copied().unwrap_or(0));
                u32::from(across) * u32::from(down)
            }
            SampleWeights::EachSample(upper) => {
                let row = row.min(side - 1 - row);
                upper.get(row * side + column).copied().unwrap_or(0).into()
            }
        }
    }
}

// Not re-exported, as `SampleSum`.
/// The weights of a window of some pixels, with `N` samples along one side of each.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum SampleWeights {
    /// The weight of a sample is the product of a weight for its column and a weight for its row. One list serves both;
    /// its sum is 2 to the power of `SUM_BITS`.
    Product(&'static [u16]),
    /// One weight for each sample, row by row, for the upper half of the window; the lower half is its mirror image.
    EachSample(&'static [u16]),
}

/// Samples weighed by a round cone: by 1 in the middle of the pixel, and evenly less down to 0 at a distance of one pixel.
///
/// Each weight is the nearest unit, of which there are 2^16 in all with 2 x 2 samples and 2^20 otherwise; but for the four
/// in the middle, which take what rounding leaves: up to three units of thousands. No product of rows and columns, so that
/// each row of samples is weighed once for each row of pixels that it counts for, two in all. Flash: two bytes for each
/// sample of half a window.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ConeFilter;

/// A number that sums are kept in: `u16` or `u32`.
pub trait SampleSum: Copy + Default + core::fmt::Debug + sealed::Sealed {
    /// The sum with `more` added, modulo 2^16 or 2^32: weights that add up to more than a filter says give wrong colours.
    #[must_use]
    fn plus(self, more: u32) -> Self;

    /// The weighted sum as a number of 32 bits.
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
    ($($samples:literal: $bartlett:ty, $cone_bits:literal, $gaussian:expr;)+) => { $(
        impl SampleFilter<$samples> for BoxFilter {
            // 16 * 16 * 255 is below 2^16.
            type Sum = u16;
            const PIXELS: usize = 1;
            const WEIGHTS: SampleWeights = SampleWeights::Product(&[1; $samples]);
            const SUM_BITS: u32 = ($samples as u32).ilog2();
        }

        impl SampleFilter<$samples> for Bartlett {
            type Sum = $bartlett;
            const PIXELS: usize = 2;
            const WEIGHTS: SampleWeights =
                SampleWeights::Product(&mirrored::<$samples, { $samples * 2 }>(pyramid()));
            // 1 + 3 + .. + (2 n - 1) is n^2, twice.
            const SUM_BITS: u32 = ($samples as u32).ilog2() * 2 + 1;
        }

        impl SampleFilter<$samples> for ConeFilter {
            type Sum = u32;
            const PIXELS: usize = 2;
            const WEIGHTS: SampleWeights = {
                const ROWS: &[[u16; $samples * 2]] = &cone::<$samples, { $samples * 2 }>(1 << ($cone_bits * 2));
                SampleWeights::EachSample(ROWS.as_flattened())
            };
            const SUM_BITS: u32 = $cone_bits;
        }

        impl SampleFilter<$samples> for Gaussian {
            type Sum = u32;
            const PIXELS: usize = 3;
            const WEIGHTS: SampleWeights =
                SampleWeights::Product(&mirrored::<{ $samples / 2 * 3 }, { $samples * 3 }>($gaussian));
            const SUM_BITS: u32 = 12;
        }
    )+ };
}

filters! {
    2: u16, 8, [72, 531, 1_445];
    4: u32, 10, [19, 65, 177, 375, 618, 794];
    8: u32, 10, [7, 13, 24, 43, 71, 109, 159, 218, 279, 337, 382, 406];
    16: u32, 10, [3, 4, 6, 8, 11, 14, 19, 24, 31, 40, 49, 60, 73, 87, 101, 116, 132, 147, 162, 175, 186, 195, 201, 204];
}

/// Weights that rise by the odd numbers, 1, 3, 5 and so on: the left half of a pyramid.
const fn pyramid<const HALF: usize>() -> [u16; HALF] {
    let mut weights = [1; HALF];
    let mut index = 1;
    while index < HALF {
        #[expect(clippy::indexing_slicing, reason = "evaluated by the compiler")]
        {
            weights[index] = weights[index - 1] + 2;
        }
        index += 1;
    }
    weights
}

/// The upper half of a cone over a window of two pixels a side: each weight is rounded, and the four in the middle take what
/// is left over of the sum of all.
const fn cone<const HALF: usize, const SIDE: usize>(sum: u64) -> [[u16; SIDE]; HALF] {
    let mut whole = 0;
    let mut sample = 0;
    while sample < HALF * SIDE {
        whole += 2 * cone_height::<SIDE>(sample);
        sample += 1;
    }
    let (mut weights, mut rest) = ([[0u16; SIDE]; HALF], sum as i64);
    while sample > 0 {
        sample -= 1;
        let weight = (2 * cone_height::<SIDE>(sample) * sum + whole) / (2 * whole);
        rest -= 2 * weight as i64;
        #[expect(clippy::indexing_slicing, reason = "evaluated by the compiler")]
        {
            weights[sample / SIDE][sample % SIDE] = weight as u16;
        }
    }
    #[expect(clippy::indexing_slicing, reason = "evaluated by the compiler")]
    {
        // Of either sign: eight mirror images, or four on a diagonal, make it a whole number for each.
        let each = rest / 4;
        weights[HALF - 1][HALF - 1] = (weights[HALF - 1][HALF - 1] as i64 + each) as u16;
        weights[HALF - 1][HALF] = (weights[HALF - 1][HALF] as i64 + each) as u16;
    }
    weights
}

/// The height of a cone over a sample, counted row by row, in 2^-20 of half the distance between two samples.
const fn cone_height<const SIDE: usize>(sample: usize) -> u64 {
    const BITS: u32 = 20;
    // Distances from the middle, in halves of that between two samples.
    let across = (2 * (sample % SIDE) + 1).abs_diff(SIDE) as u64;
    let down = (2 * (sample / SIDE) + 1).abs_diff(SIDE) as u64;
    let distance = ((across * across + down * down) << (2 * BITS)).isqrt();
    ((SIDE as u64) << BITS).saturating_sub(distance)
}

/// Weights that are symmetric about the middle of the pixel, from those of its left half.
const fn mirrored<const HALF: usize, const WHOLE: usize>(half: [u16; HALF]) -> [u16; WHOLE] {
    let mut whole = [0; WHOLE];
    let mut index = 0;
    while index < HALF {
        #[expect(clippy::indexing_slicing, reason = "evaluated by the compiler")]
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

    #[test]
    fn sums_keep_their_low_bits() {
        let numbers = [0, 1, 0xffff, 0x1_0000, 0xdead_beef, u32::MAX, 12_345];
        let sum = numbers.iter().fold(0u32, |sum, &more| sum.plus(more));
        let expected = numbers.iter().fold(0u32, |sum, &more| sum.wrapping_add(more));
        assert_eq!(sum.get(), expected);
        assert_eq!(
            numbers.iter().fold(0u16, |sum, &more| sum.plus(more)).get(),
            expected & 0xffff
        );
    }

    fn check<const N: usize, F: SampleFilter<N>>(pixels: usize, weight: impl Fn(f64) -> f64, tolerance: f64) {
        let SampleWeights::Product(weights) = F::WEIGHTS else {
            panic!("one for each sample")
        };
        let sum = 1u32 << F::SUM_BITS;
        assert_eq!((weights.len(), F::PIXELS), (pixels * N, pixels));
        assert_eq!(weights.iter().map(|&weight| u32::from(weight)).sum::<u32>(), sum);
        // Distances of the samples from the middle of the pixel, in pixels.
        let distance = |index: usize| (index as f64 + 0.5) / N as f64 - pixels as f64 / 2.0;
        let exact: Vec<f64> = (0..weights.len()).map(|index| weight(distance(index))).collect();
        let scale = f64::from(sum) / exact.iter().sum::<f64>();
        for (&weight, exact) in weights.iter().zip(exact) {
            assert!((f64::from(weight) - exact * scale).abs() <= tolerance, "{weight}");
        }
    }

    fn check_cone<const N: usize>()
    where
        ConeFilter: SampleFilter<N>,
    {
        let SampleWeights::EachSample(upper) = <ConeFilter as SampleFilter<N>>::WEIGHTS else {
            panic!("a product")
        };
        let sum = 1u32 << (2 * <ConeFilter as SampleFilter<N>>::SUM_BITS);
        assert_eq!((upper.len(), <ConeFilter as SampleFilter<N>>::PIXELS), (2 * N * N, 2));
        assert_eq!(upper.iter().map(|&weight| 2 * u32::from(weight)).sum::<u32>(), sum);
        let from_middle = |index: usize| (index as f64 + 0.5) / N as f64 - 1.0;
        let exact = |index: usize| (1.0 - from_middle(index / (2 * N)).hypot(from_middle(index % (2 * N)))).max(0.0);
        let scale = f64::from(sum) / (2.0 * (0..upper.len()).map(exact).sum::<f64>());
        let weight = |row: usize, column: usize| upper[row.min(2 * N - 1 - row) * 2 * N + column];
        for (row, column) in (0..2 * N).flat_map(|row| (0..2 * N).map(move |column| (row, column))) {
            let error = f64::from(weight(row, column)) - exact(row * 2 * N + column) * scale;
            let is_in_the_middle = [row, column].iter().all(|index| (N - 1..=N).contains(index));
            let tolerance = if is_in_the_middle { 3.501 } else { 0.501 };
            assert!(error.abs() <= tolerance, "{N}: {row} {column} {error}");
            let mirrored = [weight(column, row), weight(row, 2 * N - 1 - column)];
            assert_eq!(mirrored, [weight(row, column); 2], "{N}: {row} {column}");
        }
    }

    #[test]
    fn the_cone_is_round() {
        check_cone::<2>();
        check_cone::<4>();
        check_cone::<8>();
        check_cone::<16>();
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
