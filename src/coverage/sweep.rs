//! From the differences of a row to its spans: a prefix sum (Crow 1984 in one dimension), by which a row's memory is one
//! number a pixel.

use core::ops::Range;

use crate::coverage::Share;

/// Adds up the differences and hands over spans of the same share. The cells are 0 afterwards. `share` makes a share of
/// a sum.
///
/// # Errors
/// The first of `emit`.
#[inline(always)]
pub(super) fn sweep<E, C: Copy + Default + PartialEq + Into<i32>>(
    columns: Range<i32>,
    cells: &mut [C],
    share: impl Fn(i32) -> Share,
    mut emit: impl FnMut(Range<i32>, Share) -> Result<(), E>,
) -> Result<(), E> {
    let (mut sum, mut start, mut current) = (0i32, columns.start, 0);
    let mut column = columns.start;
    let mut cells = cells.iter_mut();
    while let Some(cell) = cells.next() {
        if *cell != C::default() {
            sum = sum.wrapping_add((*cell).into());
            *cell = C::default();
            let next = share(sum);
            if next != current {
                if current != 0 && start < column.min(columns.end) {
                    let emitted = emit(start..column.min(columns.end), current);
                    if emitted.is_err() {
                        cells.for_each(|cell| *cell = C::default());
                        return emitted;
                    }
                }
                (start, current) = (column, next);
            }
        }
        column = column.wrapping_add(1);
    }
    if current != 0 && start < columns.end {
        emit(start..columns.end, current)?;
    }
    Ok(())
}
