//! Outlines of circles, one pixel wide: what lies between a circle and the one whose box is a pixel smaller on each side.
//!
//! The outer circle is stepped from row to row. The inner one is not, because both have the same middle: where it has k columns
//! fewer on each side than the w columns of the outer one, its slack is
//!
//! ```text
//!     slack of the outer one + difference - k (w + 1) + k^2
//!
//!     ...OOOO...     O: the outline, from column 3 on
//!     .OO....OO.     two columns on each side: k = 2
//! ```
//!
//! with one difference for all rows, by which the inner circle's limit is below the outer one's. The outline has k columns on
//! each side for the smallest k from 1 on for which the column beside k + 1 columns fewer is inside: its slack is below 0.
//! Mostly that is 1.
//!
//! Guarantees: the pixels of the shape's own walk, in additions. The state is the outer circle's row and the difference, 16 bits
//! each number, so that it takes the two words of the cursor and none of the pool.

use core::hint::black_box;

use crate::{
    band::Band,
    clip::shape::circle_limit,
    draw::picture::{
        item::{ItemKind, PictureSlot, set_pixel},
        kinds::curve_row::CurveRow,
        pool::Pool,
    },
    scan::round::{ForwardDifference, circle},
    surface::{BandColor, Order, PixelWord, Target},
};

/// The largest diameter that is kept so: no slack takes more than 16 bits.
pub(super) const MOST: u32 = 1 << 15;

/// The outline of a circle. The cursor is the [`CurveRow`] of the outer circle above the row that comes next, with the difference
/// in the upper half of the second word.
pub(super) struct CircleOutline;

/// By how much an inner circle's slack is above that of the circle around it, where both have the same columns.
fn difference(diameter: u32) -> u32 {
    // What the squares of a pixel's doubled distances leave as the remainder of a division by 4, which slacks are rounded by.
    let remainder = if diameter.is_multiple_of(2) { 2 } else { 0 };
    let quarters = |diameter: u32| (circle_limit(diameter) as i64 - 1 - remainder) >> 2;
    (quarters(diameter) - quarters(diameter - 2)) as u32
}

/// Sets the pixels on both sides of a row that the outer circle has some columns of, from the ends to the middle; those that the
/// band has.
#[inline(always)]
fn set_sides<W: PixelWord>(row: &mut [W], (mut first, width): (i32, i32), inner_slack: i32, word: W) {
    let mut last = first + width - 1;
    set_pixel(row, first, word);
    set_pixel(row, last, word);
    // The inner circle's slack for two columns fewer on each side, and what it is less by for one more column fewer.
    let mut slack = inner_slack + 2 - 2 * width;
    let mut step = width - 4;
    // Mostly there is one pixel on each side. Rows without a hole end in the middle.
    while slack >= 0 && first < last {
        (first, last) = (first + 1, last - 1);
        set_pixel(row, first, word);
        set_pixel(row, last, word);
        slack -= step;
        step -= 2;
        black_box(());
    }
}

impl<C: BandColor, O: Order> ItemKind<C, O> for CircleOutline {
    #[inline]
    fn enter(slot: &mut PictureSlot<'_, C, O>, _: &mut Pool<'_>, row: i32) {
        let extent = slot.extent;
        let diameter = extent.height();
        let down = row - i32::from(extent.first);
        // The lower half mirrors the upper one.
        let mirrored = down.min(diameter - 1 - down);
        let ForwardDifference { inset, error_term, .. } = circle::enter(diameter as u32, mirrored as u32);
        let (left, right) = extent.columns();
        let entered = CurveRow {
            start: left + inset as i32,
            end: right - inset as i32,
            slack: error_term - 1,
        };
        let [columns, slack] = entered.above(extent.edge_below_middle(row), 1).words();
        slot.cursor = [columns, (slack & 0xffff) | difference(diameter as u32) << 16];
    }

    #[inline(always)]
    fn draw_row(slot: &mut PictureSlot<'_, C, O>, _: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        let [columns, packed] = slot.cursor;
        let above = CurveRow::of([columns, packed & 0xffff]);
        let difference = packed >> 16;
        let edge = slot.extent.edge_below_middle(band.window().top);
        let outer = if edge < 0 {
            above.wider(edge.unsigned_abs(), 1)
        } else {
            // In the row above the one that was entered, it may be below 0.
            let slack = (above.slack + edge as u32) & 0xffff;
            CurveRow { slack, ..above }.narrower(1)
        };
        let [columns, slack] = outer.words();
        slot.cursor = [columns, (slack & 0xffff) | (packed & !0xffff)];
        let columns = (outer.start - band.window().left, outer.width() as i32);
        let inner_slack = (outer.slack + difference) as i32;
        set_sides(band.words_mut(), columns, inner_slack, slot.word);
    }
}
