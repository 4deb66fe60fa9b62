//! From the differences of a row to its spans: a prefix sum (Crow 1984 in one dimension), by which a row's memory is one
//! number a pixel.

use core::ops::Range;

use crate::coverage::Share;

/// Adds up the differences and hands over spans of the same share. The cells are 0 afterwards, but not after an error.
/// `share` makes a share of a sum.
///
/// # Errors
/// The first of `emit`.
#[inline(always)]
fn spans<E, C: Copy + Default + PartialEq + Into<i32>>(
    columns: Range<i32>,
    cells: &mut [C],
    share: impl Fn(i32) -> Share,
    mut emit: impl FnMut(Range<i32>, Share) -> Result<(), E>,
) -> Result<(), E> {
    // Columns are counted from the first one.
    let width = columns.end - columns.start;
    let mut emit = |start: i32, end: i32, share: Share| emit(columns.start + start..columns.start + end, share);
    let (mut sum, mut start, mut current) = (0i32, 0, 0);
    let mut column = 0i32;
    for four in cells.chunks_mut(4) {
        let first_column = column;
        column = column.wrapping_add(4);
        // The inside of a shape, mostly.
        if four.iter().all(|cell| *cell == C::default()) {
            continue;
        }
        for (column, cell) in (first_column..).zip(four) {
            let difference = core::mem::take(cell);
            if difference == C::default() {
                continue;
            }
            sum = sum.wrapping_add(difference.into());
            let next = share(sum);
            if next == current {
                continue;
            }
            let end = column.min(width);
            if current != 0 && start < end {
                emit(start, end, current)?;
            }
            (start, current) = (column, next);
        }
    }
    if current != 0 && start < width {
        emit(start, width, current)?;
    }
    Ok(())
}

/// Sums the cells of a row up and emits a span for each run of equal coverage. All cells are 0 afterwards, also after an
/// error.
///
/// # Errors
/// The first of `emit`.
#[inline(always)]
pub(super) fn sweep<E, C: Copy + Default + PartialEq + Into<i32>>(
    columns: Range<i32>,
    cells: &mut [C],
    share: impl Fn(i32) -> Share,
    emit: impl FnMut(Range<i32>, Share) -> Result<(), E>,
) -> Result<(), E> {
    let swept = spans(columns, cells, share, emit);
    if swept.is_err() {
        cells.fill(C::default());
    }
    swept
}

/// Sums the cells of a row up where most pixels have a difference: each of those is a span of its own. `column` is that of
/// the first cell, and nothing right of the last one is covered. The cells are 0 afterwards, but not after an error.
///
/// # Errors
/// The first of `emit`.
#[inline(always)]
pub(super) fn sweep_pixels<E>(
    mut column: i32,
    cells: &mut [i32],
    share: impl Fn(i32) -> Share,
    mut emit: impl FnMut(Range<i32>, Share) -> Result<(), E>,
) -> Result<(), E> {
    // So many pixels without a difference are not handed over yet.
    let (mut sum, mut waiting) = (0i32, 0i32);
    let mut fours = cells.chunks_exact_mut(4);
    for four in &mut fours {
        let Some(four) = four.first_chunk_mut::<4>() else {
            continue;
        };
        let [a, b, c, d] = *four;
        if a | b | c | d == 0 {
            waiting = waiting.wrapping_add(4);
        } else {
            *four = [0; 4];
            if waiting != 0 {
                let inside = share(sum);
                if inside != 0 {
                    emit(column.wrapping_sub(waiting)..column, inside)?;
                }
                waiting = 0;
            }
            let (one, two) = (sum.wrapping_add(a), sum.wrapping_add(a).wrapping_add(b));
            let (three, four) = (two.wrapping_add(c), two.wrapping_add(c).wrapping_add(d));
            sum = four;
            for (offset, sum) in [one, two, three, four].into_iter().enumerate() {
                // Outside, which is no question of rounding.
                if sum == 0 {
                    continue;
                }
                let share = share(sum);
                if share != 0 {
                    let column = column.wrapping_add(offset as i32);
                    emit(column..column.wrapping_add(1), share)?;
                }
            }
        }
        column = column.wrapping_add(4);
    }
    if waiting != 0 {
        let inside = share(sum);
        if inside != 0 {
            emit(column.wrapping_sub(waiting)..column, inside)?;
        }
    }
    for difference in fours.into_remainder() {
        sum = sum.wrapping_add(core::mem::take(difference));
        let share = share(sum);
        let end = column.wrapping_add(1);
        if share != 0 {
            emit(column..end, share)?;
        }
        column = end;
    }
    Ok(())
}
