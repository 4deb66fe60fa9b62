//! Outlines of circles, one pixel wide: what lies between a circle and the one whose box is a pixel smaller on each side.
//!
//! Both circles are stepped from row to row by forward differences, and both have the same increments of their rows, because
//! they have the same middle. They are kept as the columns before their first pixels, each with its error term in 16 bits, so
//! that they take the two words of the cursor and none of the pool.
//!
//! ```text
//!     ...OOOO...     O: the outline, from column 3 on
//!     .OO....OO.     the columns before the outer circle's first pixel: 1; before the inner one's, in its box: 2
//! ```
//!
//! Guarantees: the pixels of the shape's own walk, in additions.

use core::{hint::black_box, num::Wrapping};

use crate::{
    band::Band,
    draw::picture::{
        item::{ItemKind, PictureSlot},
        kinds::sides::fill_sides,
        pool::Pool,
    },
    scan::round::{ForwardDifference, circle},
    surface::{BandColor, Order, Target},
};

/// The largest diameter that is kept so: no error term exceeds it by more than 2.
pub(super) const MOST: u32 = 1 << 15;

/// The outline of a circle. The cursor is the next [`CircleRow`] of the outer circle, and of the inner one.
pub(super) struct CircleOutline;

/// A row of a circle.
#[derive(Clone, Copy)]
struct CircleRow {
    /// Columns of the circle's box before the first pixel.
    inset: i32,
    /// By how much the sum of squares would have to be smaller for one more column on each side to be inside.
    error_term: u32,
}

impl CircleRow {
    /// A row without a hole, such as the first and the last one of an outline: the columns before the hole reach to the middle.
    const fn none(diameter: i32) -> Self {
        Self {
            inset: diameter / 2,
            error_term: 0,
        }
    }

    /// A row of a circle.
    #[inline(never)]
    fn at(diameter: i32, row: i32) -> Self {
        // The lower half mirrors the upper one.
        let row = row.min(diameter - 1 - row);
        let ForwardDifference { inset, error_term, .. } = circle::enter(diameter as u32, row as u32);
        Self {
            inset: inset as i32,
            error_term,
        }
    }

    #[inline]
    const fn of(word: u32) -> Self {
        Self {
            inset: (word & 0xffff) as i32,
            error_term: word >> 16,
        }
    }

    /// The row as a word. After a circle's last row, the error term is void, and may be cut off.
    #[inline]
    const fn word(self) -> u32 {
        self.inset as u32 | self.error_term << 16
    }

    /// The row below this one in the upper half. `above_middle` is twice the distance of this row from the middle, less one.
    #[inline(always)]
    fn next_wider(self, diameter: i32, above_middle: u32) -> Self {
        let mut row_increment = above_middle;
        let Self {
            mut inset,
            mut error_term,
        } = self;
        let mut column_increment = (diameter - 2 * inset) as u32;
        while row_increment >= error_term {
            row_increment -= error_term;
            inset -= 1;
            column_increment += 2;
            error_term = column_increment;
            // Keeps the compiler from unrolling this loop, which mostly runs once.
            black_box(());
        }
        Self {
            inset,
            error_term: error_term - row_increment,
        }
    }

    /// The row below this one in the lower half. `below_middle` is twice the distance of this row from the middle, plus one.
    #[inline(always)]
    fn next_narrower(self, diameter: i32, below_middle: u32) -> Self {
        // After the last row no column may be left to give up. The increment then wraps around below 0 to a number larger than
        // the error term, which ends the loop.
        let mut column_increment = Wrapping((diameter - 2 * self.inset) as u32);
        let mut error_term = self.error_term + below_middle;
        let mut inset = self.inset;
        while error_term > column_increment.0 {
            error_term -= column_increment.0;
            column_increment -= 2;
            inset += 1;
            black_box(());
        }
        Self { inset, error_term }
    }
}

impl<C: BandColor, O: Order> ItemKind<C, O> for CircleOutline {
    #[inline]
    fn enter(slot: &mut PictureSlot<'_, C, O>, _: &mut Pool<'_>, row: i32) {
        let diameter = slot.extent.height();
        let down = row - i32::from(slot.extent.first);
        let inner = if down == 0 || down == diameter - 1 {
            CircleRow::none(diameter)
        } else {
            CircleRow::at(diameter - 2, down - 1)
        };
        slot.cursor = [CircleRow::at(diameter, down), inner].map(CircleRow::word);
    }

    #[inline(always)]
    fn draw_row(slot: &mut PictureSlot<'_, C, O>, _: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        let [outer, inner] = slot.cursor.map(CircleRow::of);
        let (left, right) = slot.extent.columns();
        let columns = (left + outer.inset, right - outer.inset);
        fill_sides(band, columns, inner.inset + 1 - outer.inset, slot.word);

        // The compiler would read all of the slot before it draws, which takes more registers than there are.
        let slot = black_box(slot);
        let [outer, inner] = slot.cursor.map(CircleRow::of);
        let diameter = slot.extent.height();
        let below_middle = slot.extent.below_middle(band.window().top);
        let next = if below_middle < 0 {
            let above_middle = (-1 - below_middle) as u32;
            let next_inner = if below_middle == 1 - diameter {
                CircleRow::at(diameter - 2, 0)
            } else {
                inner.next_wider(diameter - 2, above_middle)
            };
            [outer.next_wider(diameter, above_middle), next_inner]
        } else {
            let below_middle = (below_middle + 1) as u32;
            // Behind its last row the inner circle has no column, so that both sides meet in the outer one's last row.
            [
                outer.next_narrower(diameter, below_middle),
                inner.next_narrower(diameter - 2, below_middle),
            ]
        };
        slot.cursor = next.map(CircleRow::word);
    }
}
