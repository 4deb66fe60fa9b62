//! Rings, straight into the words of a band.
//!
//! Guarantees: walked and written in one loop, a row and its mirrored row at once, without a batch of rows on the stack.

use core::{hint::black_box, num::Wrapping, ops::Range};

use crate::{
    band::rows::BandRows,
    surface::{PixelWord, Ring, SymmetricBox},
};

/// Fills the rows of a ring.
#[inline(never)]
pub(crate) fn fill_ring<W: PixelWord>(rows: BandRows<'_, W>, shape: &SymmetricBox, ring: Ring, raw: W) {
    let BandRows { words, window, stride } = rows;
    // A band without columns shows nothing.
    let stride = stride.max(1);
    let mut ring = ring.shifted((Wrapping(shape.left()) - Wrapping(window.left)).0 as u32);
    // The index at which a row begins; some number where the row is not visible.
    let line = |row: u32| {
        let below_top = Wrapping(shape.y(row) as u32) - Wrapping(window.top as u32);
        Wrapping(below_top.0 as usize) * Wrapping(stride)
    };
    // Where rows of both halves are visible, they come last, up to the middle; before them there is one half only.
    let Range { start, end } = shape.rows;
    let pairs_start = shape.upper.start.max(shape.lower.start).max(start).min(end);
    for rows in [start..pairs_start, pairs_start..end] {
        if rows.is_empty() {
            continue;
        }
        let is_upper = shape.upper.contains(&rows.start);
        let is_lower = shape.lower.contains(&rows.start);
        let length = Wrapping(stride * rows.len());
        // The mirrored row of the first row is the last one.
        let lower_end = line(SymmetricBox::mirrored(rows.start, shape.size.height)) + Wrapping(stride);
        let start = if is_upper { line(rows.start) } else { lower_end - length };
        let end = if is_lower { lower_end } else { start + length };
        let Some(mut words) = words.get_mut(start.0..end.0) else {
            return;
        };
        if is_upper && is_lower {
            fill_rows(|| take_pair(&mut words, stride), &mut ring, raw);
        }
        if is_upper {
            fill_rows(|| Some([take_first(&mut words, stride)?]), &mut ring, raw);
        } else {
            fill_rows(|| Some([take_last(&mut words, stride)?]), &mut ring, raw);
        }
    }
}

#[inline(always)]
fn take_first<'a, W>(words: &mut &'a mut [W], stride: usize) -> Option<&'a mut [W]> {
    words.split_off_mut(..stride)
}

#[inline(always)]
fn take_last<'a, W>(words: &mut &'a mut [W], stride: usize) -> Option<&'a mut [W]> {
    let kept = words.len().checked_sub(stride)?;
    words.split_off_mut(kept..)
}

/// Takes the first row and the last one off `words`; `None` where there is only one row, or none.
#[inline(always)]
fn take_pair<'a, W>(words: &mut &'a mut [W], stride: usize) -> Option<[&'a mut [W]; 2]> {
    let between = words.len().checked_sub(stride)?.checked_sub(stride)?;
    let above = words.split_off_mut(..stride)?;
    let below = words.split_off_mut(between..)?;
    Some([above, below])
}

/// Fills the pixels on both sides of the hole, column by column; a column that is not visible has an index beyond the
/// row.
///
/// `next_rows` has the rows that come next, alone or in pairs.
#[inline(always)]
fn fill_rows<'a, W: PixelWord, const N: usize>(
    mut next_rows: impl FnMut() -> Option<[&'a mut [W]; N]>,
    ring: &mut Ring,
    raw: W,
) {
    let Some(mut rows) = next_rows() else { return };
    let mut walk = *ring;
    walk.advance();
    let mut column = walk.inner.column;
    let mut mirrored = walk.sum - column;
    // One loop, not one in the other: the compiler would keep a pointer for each of the pixels, and there are no registers
    // left. Each side has at least one column.
    loop {
        column -= 1;
        for index in [column, mirrored] {
            for row in &mut rows {
                if let Some(word) = row.get_mut(index.0 as usize) {
                    *word = raw;
                }
            }
        }
        mirrored += 1;
        if column == walk.outer.column {
            let Some(next) = next_rows() else { break };
            rows = next;
            walk.advance();
            column = walk.inner.column;
            mirrored = walk.sum - column;
        }
        black_box(());
    }
    *ring = walk;
}
