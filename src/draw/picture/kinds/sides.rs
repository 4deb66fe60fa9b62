//! The two sides of a stroke in a row: as many columns from its left end as from its right end.

use core::hint::black_box;

use crate::{
    band::Band,
    draw::picture::item::{fill_span, span_of},
    surface::{BandColor, Order},
};

/// Fills the first and the last `columns` of the columns from `start` to before `end`.
#[inline(always)]
pub(super) fn fill_sides<C: BandColor, O: Order>(
    band: &mut Band<'_, C, O>,
    (start, end): (i32, i32),
    columns: i32,
    word: C::Word,
) {
    /// Up to this many pixels a side, writing them one by one takes less than filling two spans.
    const SHORT: u32 = 8;
    // Without a column this wraps around to the largest number, which is not short.
    if (columns - 1) as u32 >= SHORT {
        return fill_long_sides(band, (start, end), columns, word);
    }
    let Some(run) = span_of(band, (start, end)) else {
        return fill_long_sides(band, (start, end), columns, word);
    };
    let mut pixels = run.iter_mut();
    let mut remaining = columns;
    while let Some(first) = pixels.next() {
        *first = word;
        if let Some(last) = pixels.next_back() {
            *last = word;
        }
        remaining -= 1;
        if remaining == 0 {
            return;
        }
        // Mostly there is one pixel on each side: the compiler would prepare for more.
        black_box(());
    }
}

/// Fills sides of any length.
#[inline(never)]
fn fill_long_sides<C: BandColor, O: Order>(
    band: &mut Band<'_, C, O>,
    (start, end): (i32, i32),
    columns: i32,
    word: C::Word,
) {
    fill_span(band, (start, start + columns), word);
    fill_span(band, (end - columns, end), word);
}
