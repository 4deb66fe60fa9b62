//! Strokes inside or outside of a polygon that go on from row to row, alone or beside a fill.
//!
//! ```text
//!     words of the stroke, which side, is filled | stroke | chains
//!
//!     inside:    . . . # # # - - - # # # . . .        # : runs of the stroke in a row, - : runs of the inside
//!     outside:   # # # - - - - - - - - - # # #        the stroke is drawn where both are, or where the inside is not
//! ```
//!
//! The stroke is a centred one of twice the width, kept as [`WalkedStroke`](super::walked_stroke::WalkedStroke) keeps it, and the
//! inside of the polygon lies in chains as that of a fill.
//!
//! Guarantees: the pixels of the stroke that is generated anew. Cost of a row: what the stroke and the fill take, and for each run
//! of the inside a look at each polygon of the stroke that the row meets. Memory: that of both.

use core::ops::Range;

use embedded_graphics::{geometry::Point, primitives::StrokeAlignment};

use crate::{
    band::Band,
    draw::{
        chains::{self, ContourEdges, Cursor},
        payload::Payload,
        picture::{
            item::{Extent, PictureItem, PictureSlot, fill_span},
            kinds::{
                contour_stroke::{ContourStroke, StrokeWords},
                filled_chains,
                walked_stroke::{Parts, WalkedStroke},
            },
            pool::Pool,
            prepare::{Draft, not_used},
        },
    },
    geometry::Window,
    surface::{BandColor, Order, PixelWord, Target},
};

/// In the first word: whether the stroke is inside, and whether there is a fill, above the number of words before the chains.
const IS_INSIDE: u32 = 1 << 31;
const IS_FILLED: u32 = 1 << 30;
const LENGTH: u32 = IS_FILLED - 1;

/// How a stroke inside or outside of its contours is drawn: the fill in the slot's colour, and the stroke in its own.
struct AsideStroke;

impl ContourStroke<'_> {
    /// The item of a stroke in a colour inside or outside of its contours, whose inside has these edges, with or without a fill.
    pub(super) fn walked_aside<'a, C: BandColor, O: Order>(
        &self,
        (fill, edges): (Option<C>, &ContourEdges<'_>),
        (color, width): (C, u32),
        alignment: StrokeAlignment,
        payload: &mut Payload<'_>,
    ) -> Draft<'a, C, O> {
        let start = payload.needed();
        payload.push(0);
        payload.push_pixel(Band::<C, O>::word(color));
        let around_stroke = self.store_walked(width.saturating_mul(2), payload);
        let is_inside = alignment == StrokeAlignment::Inside;
        let flags = [(IS_INSIDE, is_inside), (IS_FILLED, fill.is_some())];
        let flags = flags.into_iter().filter(|(_, is_set)| *is_set).map(|(flag, _)| flag);
        // A pool has no more words than 16 bits tell.
        payload.set(start, flags.sum::<u32>() | (payload.needed() - start) as u32 & LENGTH);
        let mut bounds = chains::store(edges, payload);
        if !is_inside {
            bounds = bounds.around(&around_stroke);
        }
        let word = fill.map_or(not_used::<C>(), Band::<C, O>::word);
        Draft::new(Extent::of(&bounds), word, &AsideStroke)
    }
}

/// The first word, those of the stroke, and those of the inside.
fn split<'p>(
    slot: &PictureSlot<'_, impl BandColor, impl Order>,
    pool: &'p mut Pool<'_>,
) -> (u32, &'p mut [u32], &'p mut [u32]) {
    let words = pool.slice_mut(slot.at, slot.words);
    let first = words.first().copied().unwrap_or(0);
    let (stroke, inside) = words
        .split_at_mut_checked((first & LENGTH) as usize)
        .unwrap_or_default();
    (first, stroke.get_mut(1..).unwrap_or_default(), inside)
}

impl<C: BandColor, O: Order> PictureItem<C, O> for AsideStroke {
    fn bounds(&self) -> Window {
        Window::EMPTY
    }

    fn draw(&self, _: &mut Band<'_, C, O>) {}

    fn enter(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, row: i32) {
        let (_, stroke, inside) = split(slot, pool);
        WalkedStroke::enter(stroke, row);
        filled_chains::enter(slot, inside, row);
    }

    fn columns_in(&self, slot: &PictureSlot<'_, C, O>, _: &Pool<'_>, _: Range<i32>) -> (i32, i32) {
        slot.extent.columns()
    }

    fn translate(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, by: Point) {
        let (_, stroke, inside) = split(slot, pool);
        WalkedStroke::translate(stroke, by);
        chains::translate(inside, by);
    }

    fn draw_row(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        let (flags, stroke, inside) = split(slot, pool);
        let Some(mut stroke) = Parts::of(stroke) else { return };
        let (row, word) = (band.window().top, C::Word::from_repeated(stroke.color()));
        // Beyond 16 bits, a run may be anywhere.
        let (left, right) = slot.extent.columns();
        let mut outside = left;
        let mut cursor = Cursor::of(slot.cursor);
        cursor.draw_row(inside, row, |start, end| {
            let (start, end) = (start.max(left).min(right), end.max(left).min(right));
            if flags & IS_FILLED != 0 {
                fill_span(band, (start, end), slot.word);
            }
            let columns = if flags & IS_INSIDE != 0 {
                start..end
            } else {
                outside..start
            };
            stroke.fill_within(columns, word, band);
            outside = end;
        });
        slot.cursor = cursor.to_words();
        if flags & IS_INSIDE == 0 {
            stroke.fill_within(outside..right, word, band);
        }
        stroke.step();
        stroke.end_row(row, slot.extent);
    }

    fn draw_rows(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        for row in slot.extent.rows(&band.window()) {
            if let Some(mut band) = band.one_row(row) {
                self.draw_row(slot, pool, &mut band);
            }
        }
    }
}
