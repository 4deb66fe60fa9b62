//! Filled triangles: the columns of two sides in fixed point, stepped by one addition a row.
//!
//! The words are the rows of the upper part, and for each of the two parts its left and its right side in its first
//! row: the column and the step, in 1/2^20 column from the first column of the box. Guarantees and limits: those of the
//! small triangle. A larger one is drawn anew in each band.

use core::num::Wrapping;

use embedded_graphics::primitives::Triangle;
use fixed::types::I12F20;

use crate::{
    band::Band,
    draw::{
        PrimitiveStyle,
        payload::Payload,
        picture::{
            item::{Extent, ItemKind, PictureSlot, fill_span, kind_of},
            kinds::replayed::{out_of_reach, replayed},
            pool::Pool,
            prepare::{CopiedShape, Draft},
        },
    },
    geometry::{Bounds, Window},
    scan::triangle::small_triangle::{SmallTriangle, visible},
    surface::{BandColor, Order, StraightSide, Target},
};

/// A triangle in one colour. The cursor is the left and the right side's column in the next row.
struct FilledTriangle;

/// Where a side is in a row, and what it gains in each row: in 1/2^20 column.
type Side = [u32; 2];

impl CopiedShape for Triangle {
    fn prepare<'a, C: BandColor, O: Order>(
        &self,
        style: &PrimitiveStyle<C>,
        payload: &mut Payload<'_>,
    ) -> Draft<'a, C, O> {
        use embedded_graphics::primitives::StyledDimensions;
        let (Some(color), None, 0) = (style.fill_color, style.effective_stroke_color(), style.stroke_width) else {
            let mut window = Window::from(self.styled_bounding_box(style));
            if style.stroke_width > 1 {
                // The widest stroke that is generated for any alignment.
                let width_in_halves = 4 * u64::from(style.stroke_width) + 2;
                window = window.around(&out_of_reach(self, width_in_halves));
            }
            return replayed(self, style, window, payload);
        };
        let small = Extent::around(self.vertices).and_then(|extent| match visible(&self.vertices, &extent.window()) {
            SmallTriangle::Rows(rows) => Some((extent, rows)),
            SmallTriangle::Nothing | SmallTriangle::Unfit => None,
        });
        let Some((extent, rows)) = small else {
            return replayed(self, style, Bounds::of(self.vertices).to_rectangle().into(), payload);
        };
        let [upper, lower] = rows.parts;
        payload.push(upper.rows);
        for side in [upper.left, upper.right, lower.left, lower.right] {
            push_side(side, payload);
        }
        Draft::new(extent, Band::<C, O>::word(color), kind_of::<C, O, FilledTriangle>())
    }
}

fn push_side(StraightSide { column, step }: StraightSide, payload: &mut Payload<'_>) {
    payload.push_signed(column.to_bits());
    payload.push_signed(step.to_bits());
}

/// A side's column so many rows below its first one.
fn column_after([column, step]: Side, rows: i32) -> u32 {
    (Wrapping(column) + Wrapping(step) * Wrapping(rows as u32)).0
}

impl<C: BandColor, O: Order> ItemKind<C, O> for FilledTriangle {
    #[inline]
    fn enter(slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, row: i32) {
        let Some([rows, sides @ ..]) = pool.array::<9>(slot.at) else {
            return;
        };
        let [ul0, ul1, ur0, ur1, ll0, ll1, lr0, lr1] = *sides;
        let down = row - i32::from(slot.extent.first);
        let below = down - *rows as i32;
        slot.cursor = if below < 0 {
            [column_after([ul0, ul1], down), column_after([ur0, ur1], down)]
        } else {
            [column_after([ll0, ll1], below), column_after([lr0, lr1], below)]
        };
    }

    #[inline]
    fn draw_row(slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        let Some([upper_rows, sides @ ..]) = pool.array::<9>(slot.at) else {
            return;
        };
        let [
            _,
            upper_left,
            _,
            upper_right,
            lower_left_column,
            lower_left,
            lower_right_column,
            lower_right,
        ] = *sides;
        let extent = slot.extent;
        let (left, right) = extent.columns();
        // The last row of the upper part; the triangle has one below it.
        let last_upper = i32::from(extent.first) + *upper_rows as i32 - 1;
        let columns = |[first, last]: [u32; 2]| {
            let pixel = |column: u32| left + (column as i32 >> I12F20::FRAC_NBITS);
            (pixel(first).max(left), (pixel(last) + 1).min(right))
        };
        let y = band.window().top;
        let columns = columns(slot.cursor);
        slot.cursor = if y == last_upper {
            [lower_left_column, lower_right_column]
        } else {
            let steps = if y < last_upper {
                [upper_left, upper_right]
            } else {
                [lower_left, lower_right]
            };
            let [first, last] = slot.cursor;
            [column_after([first, steps[0]], 1), column_after([last, steps[1]], 1)]
        };
        fill_span(band, columns, slot.word);
    }
}
