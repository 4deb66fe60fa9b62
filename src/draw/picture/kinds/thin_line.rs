//! Lines of one pixel's width: in each row one run of pixels, whose end moves by a whole number of columns and an error
//! term.
//!
//! A line with m columns and n rows below its upper end has, in the k-th row from 0 on, the pixels up to column
//!
//! ```text
//!   flat (m >= n):   floor((s + (k + 1) m) / n)  with  s = floor((m - 1) / 2) - m,  from the end of the row above on
//!   steep (m < n):   floor((s + (k + 1) m) / n)  with  s = floor(n / 2) - m,        only that one
//! ```
//!
//! counted from the upper end towards the lower one; a steep line to the left has floor((n - 1) / 2), so that the pixel
//! of a tie does not depend on the direction. Guarantees: the pixels of Bresenham's line. Cost: a division when it
//! begins, none a row.

use core::ops::Range;

use embedded_graphics::primitives::Line;

use crate::{
    band::Band,
    draw::{
        PrimitiveStyle,
        payload::Payload,
        picture::{
            item::{Extent, ItemKind, PictureItem, PictureSlot, fill_short_span, kind_of, set_pixel},
            kinds::{
                replayed::{out_of_reach, replayed},
                wide_line,
            },
            pool::{Pool, packed},
            prepare::{CopiedShape, Draft},
        },
    },
    geometry::{Bounds, Window, divide_floor},
    surface::{BandColor, Order, Target},
};

/// A line that is at least as wide as high, or higher than wide, and runs to the right or to the left.
///
/// The cursor's first word is the column where the row above ends and the rest of its division, 16 bits each; the
/// second one the quotient and the rest that each row adds.
struct ThinLine<const STEEP: bool, const LEFTWARDS: bool>;

impl CopiedShape for Line {
    fn prepare<'a, C: BandColor, O: Order>(
        &self,
        style: &PrimitiveStyle<C>,
        payload: &mut Payload<'_>,
    ) -> Draft<'a, C, O> {
        use embedded_graphics::primitives::StyledDimensions;
        let Some(color) = style.effective_stroke_color() else {
            return Draft::nothing();
        };
        if style.stroke_width > 1 {
            let window = Window::from(self.styled_bounding_box(style));
            let far = out_of_reach(self, 2 * u64::from(style.stroke_width));
            let window = window.around(&far);
            return wide_line::prepare(self, (color, style.stroke_width), &window, payload)
                .unwrap_or_else(|| replayed(self, style, window, payload));
        }
        let ends = [self.start, self.end];
        let fits = |extent: &Extent| extent.width() <= MOST as i32 && extent.height() <= MOST as i32;
        let Some(extent) = Extent::around(ends).filter(fits) else {
            return replayed(self, style, Bounds::of(ends).to_rectangle().into(), payload);
        };
        let is_downwards = self.start.y < self.end.y;
        let leftwards = if is_downwards {
            self.end.x < self.start.x
        } else {
            self.start.x < self.end.x
        };
        let kind: &dyn PictureItem<C, O> = match (extent.height() > extent.width(), leftwards) {
            (false, false) => kind_of::<C, O, ThinLine<false, false>>(),
            (false, true) => kind_of::<C, O, ThinLine<false, true>>(),
            (true, false) => kind_of::<C, O, ThinLine<true, false>>(),
            (true, true) => kind_of::<C, O, ThinLine<true, true>>(),
        };
        Draft::new(extent, Band::<C, O>::word(color), kind)
    }
}

/// Columns and rows, so that a column fits 16 bits with its sign, and products 32.
pub(super) const MOST: u32 = 1 << 15;

impl<const STEEP: bool, const LEFTWARDS: bool> ThinLine<STEEP, LEFTWARDS> {
    /// The cursor at a row of a line of so many columns and rows below its upper end.
    fn cursor(columns: i32, rows: i32, row: i32) -> [u32; 2] {
        cursor(columns, rows, (STEEP, LEFTWARDS), row)
    }
}

/// The cursor at a row of a line of so many columns and rows below its upper end, which is steep or not and runs to the left or not.
#[inline]
pub(super) fn cursor(columns: i32, rows: i32, (is_steep, runs_left): (bool, bool), row: i32) -> [u32; 2] {
    if rows == 0 {
        // One run of all pixels.
        return [packed(-1, 0), packed(columns + 1, 0)];
    }
    let start = if !is_steep {
        (columns - 1).max(0) / 2
    } else if runs_left {
        (rows - 1) / 2
    } else {
        rows / 2
    };
    let (above, rest) = divide_floor(start - columns + row * columns, rows);
    let (step, rest_step) = divide_floor(columns, rows);
    [packed(above, rest), packed(step, rest_step)]
}

/// Goes on to the next row: the column where the row above ended, and that where it ends.
#[inline]
pub(super) fn next([state, steps]: [&mut u32; 2], rows: i32) -> (i32, i32) {
    let above = i32::from(*state as i16);
    let (mut end, mut rest) = (above + (*steps & 0xffff) as i32, (*state >> 16) + (*steps >> 16));
    if rest >= rows as u32 {
        rest -= rows as u32;
        end += 1;
    }
    *state = packed(end, rest as i32);
    (above, end)
}

impl<C: BandColor, O: Order, const STEEP: bool, const LEFTWARDS: bool> ItemKind<C, O> for ThinLine<STEEP, LEFTWARDS> {
    #[inline]
    fn enter(slot: &mut PictureSlot<'_, C, O>, _: &mut Pool<'_>, row: i32) {
        let Extent { first, .. } = slot.extent;
        let (columns, rows) = (slot.extent.width() - 1, slot.extent.height() - 1);
        slot.cursor = Self::cursor(columns, rows, row - i32::from(first));
    }

    fn columns_in(slot: &PictureSlot<'_, C, O>, rows: Range<i32>) -> (i32, i32) {
        let extent = slot.extent;
        let (left, right) = extent.columns();
        let (first, columns, height) = (i32::from(extent.first), extent.width() - 1, extent.height() - 1);
        // Where the rows end, from the upper end of the line on.
        let end_of = |row: i32| {
            let mut cursor = Self::cursor(columns, height, row - first);
            let (above, end) = next(cursor.each_mut(), height.max(1));
            let start = if STEEP { end } else { above + 1 };
            (start.max(0), end.min(columns))
        };
        let (start, end) = (end_of(rows.start).0, end_of(rows.end - 1).1);
        if LEFTWARDS {
            (right - 1 - end, right - start)
        } else {
            (left + start, left + end + 1)
        }
    }

    #[inline]
    fn draw_row(slot: &mut PictureSlot<'_, C, O>, _: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        let extent = slot.extent;
        let (left, right) = extent.columns();
        // Where that is 0, the run of the one row gets a column too many, which the box cuts off.
        let rows = extent.height() - 1;
        let (above, end) = next(slot.cursor.each_mut(), rows);
        if STEEP {
            let column = if LEFTWARDS { right - 1 - end } else { left + end };
            let band_left = band.window().left;
            set_pixel(band.words_mut(), column - band_left, slot.word);
            return;
        }
        // The first and the last run would be longer than they are in the box.
        let (start, end) = if LEFTWARDS {
            (right - 1 - end, right - 1 - above)
        } else {
            (left + 1 + above, left + 1 + end)
        };
        fill_short_span(band, (start.max(left), end.min(right)), slot.word);
    }
}
