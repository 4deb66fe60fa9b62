//! From the differences of a row to its spans: a prefix sum (Crow 1984 in one dimension), by which a row's memory is one
//! number a pixel.

use core::ops::Range;

use crate::coverage::Share;

/// How far a row is covered.
#[derive(Copy, Clone)]
pub(super) struct Covered {
    /// All columns before this one are handed over.
    pub(super) end: i32,
    /// What holds from there on, so far.
    pub(super) sum: i32,
}

impl Covered {
    #[inline(always)]
    pub(super) fn new(first_column: i32) -> Self {
        Self {
            end: first_column,
            sum: 0,
        }
    }

    /// Hands over what comes before a column, all alike.
    ///
    /// # Errors
    /// That of `emit`.
    #[inline(always)]
    pub(super) fn hand_over<E>(
        &self,
        end: i32,
        share: impl Fn(i32) -> Share,
        mut emit: impl FnMut(Range<i32>, Share) -> Result<(), E>,
    ) -> Result<(), E> {
        let share = share(self.sum);
        if share != 0 && self.end < end {
            emit(self.end..end, share)
        } else {
            Ok(())
        }
    }
}

/// Adds up the differences and hands over spans of the same share. The cells are 0 afterwards, but not after an error.
/// `before` is what comes before the columns, and `share` makes a share of a sum.
///
/// # Errors
/// The first of `emit`.
#[inline(always)]
fn spans<E, C: Copy + Default + PartialEq + Into<i32>>(
    before: Covered,
    columns: Range<i32>,
    cells: &mut [C],
    share: impl Fn(i32) -> Share,
    mut emit: impl FnMut(Range<i32>, Share) -> Result<(), E>,
) -> Result<(), E> {
    let (mut sum, mut start, mut current) = (before.sum, before.end, share(before.sum));
    let mut column = columns.start;
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
            let end = column.min(columns.end);
            if current != 0 && start < end {
                emit(start..end, current)?;
            }
            (start, current) = (column, next);
        }
    }
    if current != 0 && start < columns.end {
        emit(start..columns.end, current)?;
    }
    Ok(())
}

/// The same, and the cells are 0 after an error, too.
///
/// # Errors
/// The first of `emit`.
#[inline(always)]
pub(super) fn sweep<E, C: Copy + Default + PartialEq + Into<i32>>(
    before: Covered,
    columns: Range<i32>,
    cells: &mut [C],
    share: impl Fn(i32) -> Share,
    emit: impl FnMut(Range<i32>, Share) -> Result<(), E>,
) -> Result<(), E> {
    let swept = spans(before, columns, cells, share, emit);
    if swept.is_err() {
        cells.fill(C::default());
    }
    swept
}
