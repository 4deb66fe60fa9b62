//! From the differences of a row to its spans: a prefix sum (Crow 1984 in one dimension), by which a row's memory is one
//! number a pixel. Pixels with the same coverage are one span.

use core::ops::Range;

use crate::coverage::Coverage;

/// Adds up the differences and hands over spans of the same coverage. The cells are 0 afterwards, but not after an error.
/// `coverage` turns a sum into coverage.
///
/// # Errors
/// The first of `emit`.
#[inline(always)]
fn spans<E, C: Copy + Default + PartialEq + Into<i32>>(
    columns: Range<i32>,
    cells: &mut [C],
    coverage: impl Fn(i32) -> Coverage,
    mut emit: impl FnMut(Range<i32>, Coverage) -> Result<(), E>,
) -> Result<(), E> {
    // Columns are counted from the first one.
    let width = columns.end - columns.start;
    let mut emit =
        |start: i32, end: i32, coverage: Coverage| emit(columns.start + start..columns.start + end, coverage);
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
            let next = coverage(sum);
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
    coverage: impl Fn(i32) -> Coverage,
    emit: impl FnMut(Range<i32>, Coverage) -> Result<(), E>,
) -> Result<(), E> {
    let swept = spans(columns, cells, coverage, emit);
    if swept.is_err() {
        cells.fill(C::default());
    }
    swept
}
