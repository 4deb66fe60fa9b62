//! N rooks: as many samples as there are sub-scanlines, one in each sub-scanline and in each sub-column of the pixel.
//!
//! Guarantees: any polygon under both rules; exact but for samples nearer than 1/8192 pixel to an edge, which may count as
//! being on its other side; bits only. A side of the inside sets one bit of the first sample right of it, and the bits left
//! of a pixel, taken together by exclusive or, are its samples. Source: edge flags (Ackland and Weste 1981) with n-rooks
//! patterns (Kallio 2007). The pattern of four, {1, 3, 0, 2}, is the standard one of Direct3D.

use core::ops::Range;

use crate::{
    coverage::{
        Coverage, CoverageMethod, Emit, SamplePattern,
        edges::{RowSegment, Y_ONE},
        samples::{
            sample_pattern::spans,
            scanline::{rounded_up, sides_at},
        },
        with_room,
    },
    scan::polygon::scanline_polygon::FillRule,
};

/// Four samples, half a byte a pixel (method T1); eight samples, one byte a pixel, or sixteen, two bytes (method T1b).
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rooks<const SAMPLES: usize>;

/// The sub-column of the sample in each of four sub-scanlines, then in each of eight and of sixteen.
const FOUR: [u8; 4] = [1, 3, 0, 2];
const EIGHT: [u8; 8] = [5, 0, 3, 6, 1, 4, 7, 2];
const SIXTEEN: [u8; 16] = [1, 8, 4, 15, 11, 2, 6, 14, 10, 3, 7, 12, 0, 9, 5, 13];

/// The middle of a sub-scanline or sub-column, of which a pixel has `COUNT`, in 1/256 pixel.
#[inline]
fn middle<const COUNT: usize>(position: i32) -> i32 {
    const { assert!(COUNT > 0 && COUNT <= 16) }
    Y_ONE / 2 * (2 * position + 1) / COUNT as i32
}

/// Calls `flip` for each sample from which on a sub-scanline changes between inside and outside: its pixel, counted
/// from the left column, and its sub-scanline. Samples right of all columns are left out: nothing would clear their
/// bits. The columns are those that [`with_room`] leaves.
#[inline]
fn sides<const COUNT: usize>(
    segments: &mut [RowSegment],
    fill_rule: FillRule,
    columns: &Range<i32>,
    pattern: &[u8; COUNT],
    mut flip: impl FnMut(usize, u32),
) {
    let width = columns.len() as i32;
    for (sub_scanline, position) in (0u32..).zip(pattern) {
        let first_sample = columns.start * Y_ONE + middle::<COUNT>(i32::from(*position));
        sides_at(segments, middle::<COUNT>(sub_scanline as i32), fill_rule, |x, _| {
            let pixel = (rounded_up(x) - first_sample + Y_ONE - 1) >> 8;
            if pixel < width {
                flip(pixel.max(0) as usize, sub_scanline);
            }
        });
    }
}

/// The coverage of a pixel, of whose samples the set bits are inside.
#[inline]
fn coverage<const SAMPLES: usize>(bits: u32) -> Coverage {
    const { assert!(SAMPLES > 0 && SAMPLES <= 16) }
    let samples = SAMPLES as u32;
    ((bits.count_ones() * 510 + samples) / (samples * 2)) as Coverage
}

/// Where the samples are, one in each sub-scanline.
fn positions<const COUNT: usize>(pattern: &[u8; COUNT]) -> impl Iterator<Item = [i32; 2]> {
    let pairs = (0..).zip(pattern);
    pairs.map(move |(sub_scanline, &position)| [middle::<COUNT>(position.into()), middle::<COUNT>(sub_scanline)])
}

impl CoverageMethod for Rooks<4> {
    type Cell = u8;

    fn cells(width: usize) -> usize {
        width.div_ceil(2)
    }

    fn cover_row<E>(
        &self,
        segments: &mut [RowSegment],
        fill_rule: FillRule,
        columns: Range<i32>,
        cells: &mut [u8],
        mut emit: impl Emit<E>,
    ) -> Result<(), E> {
        self.sample_row(segments, fill_rule, columns, cells, |columns, bits| {
            emit.span(columns, coverage::<{ Self::SAMPLES }>(bits))
        })
    }
}

impl SamplePattern for Rooks<4> {
    const SAMPLES: usize = 4;

    fn positions() -> impl Iterator<Item = [i32; 2]> {
        positions(&FOUR)
    }

    fn sample_row<E>(
        &self,
        segments: &mut [RowSegment],
        fill_rule: FillRule,
        columns: Range<i32>,
        cells: &mut [u8],
        emit: impl FnMut(Range<i32>, u32) -> Result<(), E>,
    ) -> Result<(), E> {
        let columns = with_room(&columns, cells.len().saturating_mul(2));
        let shift = |pixel: usize| if pixel & 1 == 0 { 0u32 } else { 4 };
        sides(segments, fill_rule, &columns, &FOUR, |pixel, sub_scanline| {
            if let Some(cell) = cells.get_mut(pixel >> 1) {
                *cell ^= 1 << (sub_scanline + shift(pixel));
            }
        });
        let flips = |pixel: usize| match cells.get_mut(pixel >> 1) {
            Some(cell) => {
                let bits = *cell >> shift(pixel) & 15;
                *cell ^= bits << shift(pixel);
                bits.into()
            }
            None => 0,
        };
        spans(columns, flips, emit)
    }
}

macro_rules! whole_cells {
    ($($method:ty, $cell:ty, $pattern:expr;)*) => { $(
        impl CoverageMethod for $method {
            type Cell = $cell;

            fn cells(width: usize) -> usize {
                width
            }

            fn cover_row<E>(
                &self,
                segments: &mut [RowSegment],
                fill_rule: FillRule,
                columns: Range<i32>,
                cells: &mut [$cell],
                mut emit: impl Emit<E>,
            ) -> Result<(), E> {
                self.sample_row(segments, fill_rule, columns, cells, |columns, bits| {
                    emit.span(columns, coverage::<{ Self::SAMPLES }>(bits))
                })
            }
        }

        impl SamplePattern for $method {
            const SAMPLES: usize = <$cell>::BITS as usize;

            fn positions() -> impl Iterator<Item = [i32; 2]> {
                positions(&$pattern)
            }

            fn sample_row<E>(
                &self,
                segments: &mut [RowSegment],
                fill_rule: FillRule,
                columns: Range<i32>,
                cells: &mut [$cell],
                emit: impl FnMut(Range<i32>, u32) -> Result<(), E>,
            ) -> Result<(), E> {
                let columns = with_room(&columns, cells.len());
                sides(segments, fill_rule, &columns, &$pattern, |pixel, sub_scanline| {
                    if let Some(cell) = cells.get_mut(pixel) {
                        *cell ^= 1 << sub_scanline;
                    }
                });
                let flips = |pixel: usize| cells.get_mut(pixel).map_or(0, core::mem::take).into();
                spans(columns, flips, emit)
            }
        }
    )* };
}

whole_cells! {
    Rooks<8>, u8, EIGHT;
    Rooks<16>, u16, SIXTEEN;
}
