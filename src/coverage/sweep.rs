//! From the differences of a row to its spans: a prefix sum, which is a summed-area table (Crow 1984) in one dimension. Row
//! memory is one number a pixel, and pixels with equal coverage are one span.
//!
//! ```text
//!   differences   0  64  191   0   0   0  -255   0
//!   sum           0  64  255  255 255 255   0    0       spans: 1..2 with 64, 2..6 with 255
//! ```

use core::{num::Wrapping, ops::Range};

use crate::coverage::{Coverage, Emit};

/// Sums differences up, from the `sum` left of them, and emits the pixels from column `x` on that have coverage, in spans of
/// equal coverage. `coverage` turns a sum into coverage. Returns the last sum. The differences are 0 afterwards, but not after
/// an error.
///
/// # Errors
/// The first error that `emit` returns.
#[inline(always)]
pub(super) fn sweep<E, C: Copy + Default + Into<i32>>(
    differences: &mut [C],
    mut x: i32,
    mut sum: Wrapping<i32>,
    coverage: impl Fn(i32) -> Coverage,
    emit: &mut impl Emit<E>,
) -> Result<Wrapping<i32>, E> {
    // Emits a pixel or a span, unless it is outside the shape.
    let pixel = |emit: &mut _, x: i32, sum: Wrapping<i32>| match coverage(sum.0) {
        0 => Ok(()),
        coverage => Emit::pixel(emit, x, coverage),
    };
    let span = |emit: &mut _, columns: Range<i32>, sum: Wrapping<i32>| match coverage(sum.0) {
        0 => Ok(()),
        coverage => Emit::span(emit, columns, coverage),
    };
    // Pixels without a difference that are not emitted yet: the inside of a shape, mostly.
    let mut waiting = 0;
    let mut fours = differences.chunks_exact_mut(4);
    for four in &mut fours {
        let Some(four) = four.first_chunk_mut::<4>() else {
            continue;
        };
        let [a, b, c, d] = four.map(Into::into);
        if a | b | c | d == 0 {
            waiting += 4;
        } else {
            *four = [C::default(); 4];
            if waiting != 0 {
                span(emit, x - waiting..x, sum)?;
                waiting = 0;
            }
            let [a, b, c, d] = [Wrapping(a), Wrapping(b), Wrapping(c), Wrapping(d)];
            let (one, two) = (sum + a, sum + a + b);
            let (three, four) = (two + c, two + c + d);
            sum = four;
            for (offset, sum) in (0..).zip([one, two, three, four]) {
                // A sum of 0 is outside the shape, whatever the rounding.
                if sum.0 != 0 {
                    pixel(emit, x + offset, sum)?;
                }
            }
        }
        x += 4;
    }
    if waiting != 0 {
        span(emit, x - waiting..x, sum)?;
    }
    for difference in fours.into_remainder() {
        sum += Wrapping(core::mem::take(difference).into());
        pixel(emit, x, sum)?;
        x += 1;
    }
    Ok(sum)
}

/// Emits the spans of a row of differences, one for each of the columns and more for what lies right of them. All of them are 0
/// afterwards, also after an error.
///
/// # Errors
/// The first error that `emit` returns.
#[inline(always)]
pub(super) fn sweep_row<E, C: Copy + Default + Into<i32>>(
    columns: Range<i32>,
    differences: &mut [C],
    coverage: impl Fn(i32) -> Coverage,
    emit: &mut impl Emit<E>,
) -> Result<(), E> {
    let (visible, right) = differences.split_at_mut_checked(columns.len()).unwrap_or_default();
    let swept = sweep(visible, columns.start, Wrapping(0), coverage, emit).map(drop);
    right.fill(C::default());
    if swept.is_err() {
        visible.fill(C::default());
    }
    swept
}
