//! The inside of contours in one colour: their edges lie in the pool as chains, are set up in the rows in which they begin, and are
//! stepped from row to row.

use core::ops::Range;

use embedded_graphics::geometry::Point;

use crate::{
    band::Band,
    draw::{
        chains::{self, Cursor, StoredChains},
        picture::{
            item::{PictureItem, PictureSlot, fill_span},
            pool::Pool,
        },
    },
    geometry::Window,
    surface::{BandColor, Order, Target},
};

/// How filled contours are drawn: the words are chains, the cursor is a [`Cursor`].
pub(super) struct FilledChains;

/// Sets a slot's cursor to a row.
pub(super) fn enter<C: BandColor>(slot: &mut PictureSlot<'_, C, impl Order>, words: &mut [u32], row: i32) {
    slot.cursor = chains::enter(words, row).to_words();
}

/// Draws a band of one row in the colour of a slot, and moves the slot's cursor to the next row.
#[inline(always)]
pub(super) fn draw_row<C: BandColor, O: Order>(
    slot: &mut PictureSlot<'_, C, O>,
    words: &mut [u32],
    band: &mut Band<'_, C, O>,
) {
    let mut cursor = Cursor::of(slot.cursor);
    let (left, right) = slot.extent.columns();
    cursor.draw_row(words, band.window().top, |start, end| {
        // Beyond 16 bits, a run may be anywhere.
        if start < right && left < end {
            fill_span(band, (start.max(left), end.min(right)), slot.word);
        }
    });
    slot.cursor = cursor.to_words();
}

impl<C: BandColor, O: Order> PictureItem<C, O> for FilledChains {
    fn bounds(&self) -> Window {
        Window::EMPTY
    }

    fn draw(&self, _: &mut Band<'_, C, O>) {}

    fn enter(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, row: i32) {
        enter(slot, pool.slice_mut(slot.at, slot.words), row);
    }

    fn columns_in(&self, slot: &PictureSlot<'_, C, O>, pool: &Pool<'_>, rows: Range<i32>) -> (i32, i32) {
        let (left, right) = slot.extent.columns();
        let columns = StoredChains::new(pool.slice(slot.at, slot.words)).columns_in(&rows);
        columns.map_or((left, left), |(start, end)| (start.max(left), end.min(right)))
    }

    fn translate(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, by: Point) {
        chains::translate(pool.slice_mut(slot.at, slot.words), by);
    }

    fn draw_row(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        draw_row(slot, pool.slice_mut(slot.at, slot.words), band);
    }

    fn draw_rows(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        for row in slot.extent.rows(&band.window()) {
            if let Some(mut band) = band.one_row(row) {
                self.draw_row(slot, pool, &mut band);
            }
        }
    }
}
