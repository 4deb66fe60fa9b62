//! Supersampling on a grid of `N` x `N` samples a pixel: the baseline that the other methods are measured against.
//!
//! Guarantees: any polygon under both rules; exact but for samples nearer than 1/8192 pixel to an edge, which may count as
//! being on its other side.
//!
//! The samples of a pixel are weighted by [`Weights`]: all alike, by a pyramid ([`Bartlett`](crate::coverage::Bartlett)), or by
//! a bell ([`Gaussian`](crate::coverage::Gaussian)). The masks end at the pixel's own boundary.

use core::{marker::PhantomData, num::NonZeroU32, ops::Range};

use crate::{
    coverage::{
        Coverage, CoverageMethod, Emit, SamplePattern,
        edges::{RowSegment, Y_ONE},
        samples::{
            BoxFilter, Weights,
            sample_pattern::spans,
            scanline::{rounded_up, sides_at},
            sub_scanlines::add_side,
        },
        sweep::sweep_row,
        with_room,
    },
    scan::polygon::scanline_polygon::FillRule,
};

/// Supersampling with `N` x `N` samples a pixel: 2, 4, 8 or 16 along each side.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Grid<const N: i32, W = BoxFilter>(PhantomData<W>);

impl<const N: i32, W> Grid<N, W> {
    /// The method with a grid of samples and these weights.
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

impl<const N: i32, W: Weights> CoverageMethod for Grid<N, W> {
    type Cell = i16;

    fn cells(width: usize) -> usize {
        width.saturating_add(1)
    }

    fn cover_row<E>(
        &self,
        segments: &mut [RowSegment],
        fill_rule: FillRule,
        columns: Range<i32>,
        cells: &mut [i16],
        mut emit: impl Emit<E>,
    ) -> Result<(), E> {
        let count = const {
            assert!(N > 0 && N <= 16 && N.count_ones() == 1, "a power of two up to 16");
            NonZeroU32::new(N as u32).unwrap()
        };
        let columns = with_room(&columns, cells.len());
        let weights_before = |index: i32| (0..index).map(|index| W::weight(index, count)).sum::<i32>();
        let side = weights_before(N);
        for sub_scanline in 0..N {
            let y = Y_ONE / 2 * (sub_scanline * 2 + 1) / N;
            let row_weight = W::weight(sub_scanline, count);
            sides_at(segments, y, fill_rule, |x, sign| {
                add_side(cells, &columns, rounded_up(x), sign * row_weight, |x| {
                    // The weights of the samples left of the side; samples lie in the middle of their cells.
                    let left = weights_before((x * N + Y_ONE / 2 - 1) >> 8);
                    (side - left, left)
                });
            });
        }
        let whole = (side * side).max(1);
        // One division a row: the product is right to 1/255 of a level, so it is rounded as the quotient but for ties.
        let scale = ((255 << 16) + whole / 2) / whole;
        // From 0 to `whole`, unless the cells were not 0 at first: then coverages are wrong, but nothing overflows.
        let coverage = |sum: i32| (sum.wrapping_mul(scale).wrapping_add(1 << 15) >> 16) as Coverage;
        sweep_row(columns, cells, coverage, &mut emit)
    }
}

macro_rules! patterns {
    ($($side:literal)+) => { $(
        impl SamplePattern for Grid<$side> {
            const SAMPLES: usize = $side * $side;

            fn positions() -> impl Iterator<Item = [i32; 2]> {
                let positions = (0..$side).flat_map(|sub_scanline| (0..$side).map(move |position| [position, sub_scanline]));
                positions.map(|position| position.map(|index| Y_ONE / 2 * (2 * index + 1) / $side))
            }

            fn sample_row<E>(
                &self,
                segments: &mut [RowSegment],
                fill_rule: FillRule,
                columns: Range<i32>,
                cells: &mut [i16],
                emit: impl FnMut(Range<i32>, u32) -> Result<(), E>,
            ) -> Result<(), E> {
                const MIDDLE: i32 = Y_ONE / 2 / $side;
                let columns = with_room(&columns, cells.len());
                // Samples right of all columns are left out: nothing would clear their bits.
                let cells = cells.get_mut(..columns.len()).unwrap_or_default();
                let left = columns.start * Y_ONE;
                for sub_scanline in 0..$side {
                    sides_at(segments, Y_ONE / $side * sub_scanline + MIDDLE, fill_rule, |x, _| {
                        for column in 0..$side {
                            // The first pixel whose sample in this column is not left of the side.
                            let from_sample = rounded_up(x) - left - (Y_ONE / $side * column + MIDDLE);
                            let pixel = (from_sample + Y_ONE - 1) >> 8;
                            if let Some(cell) = cells.get_mut(pixel.max(0) as usize) {
                                *cell ^= 1 << ($side * sub_scanline + column);
                            }
                        }
                    });
                }
                let bits = |cell: &mut i16| core::mem::take(cell) as u16;
                let flips = |pixel: usize| cells.get_mut(pixel).map_or(0, bits).into();
                spans(columns, flips, emit)
            }
        }
    )+ };
}

patterns!(2 4);
