//! Shapes in an antialiased style, by copy: the outline of the fill, and over it that of the stroke.
//!
//! ```text
//!     colour | outline of the fill | cursor, 2 words | colour | outline of the stroke
//! ```
//!
//! A shape with only one of the two is an outline like any other. One whose stroke lies inside or outside of it, cut off along
//! its outline, is an item of another kind.

use core::ops::Range;

use embedded_graphics::{geometry::Point, primitives::Styled};

use crate::{
    band::Band,
    draw::{
        Antialiased, DrawAntialiased, PrimitiveStyle, StrokeStyle,
        antialiased::LayerSink,
        outline::{self, Progress, StoredOutline},
        payload::Payload,
        picture::{
            item::{Extent, PictureItem, PictureSlot},
            kinds::{
                aligned_stroke,
                outline::{Outline, draw_row},
            },
            pool::Pool,
            prepare::{Draft, Prepare, not_used},
        },
    },
    geometry::{InputError, Window},
    shade::ChannelColor,
    surface::{BandColor, Order, PixelWord, Target},
};

/// Words of a cursor.
const CURSOR_WORDS: usize = 2;

macro_rules! prepared_by_layers {
    ($($style:ty),+) => {$(
        impl<'a, S, C: ChannelColor, O: Order> Prepare<'a, C, O> for Styled<S, Antialiased<$style>>
        where
            Self: DrawAntialiased<Color = C>,
        {
            fn prepare(&self, payload: &mut Payload<'_>) -> Draft<'a, C, O> {
                if self.is_cut_off() {
                    return aligned_stroke::prepare(payload, &|layer| self.aligned_layers(layer));
                }
                prepare(payload, &|layer| self.layers(layer))
            }
        }
    )+};
}
prepared_by_layers!(PrimitiveStyle<C>, StrokeStyle<'_, C>);

/// Writes the layers of a shape.
fn prepare<'a, C: ChannelColor, O: Order>(
    payload: &mut Payload<'_>,
    layers: &dyn Fn(&mut LayerSink<'_, C>) -> Result<(), InputError>,
) -> Draft<'a, C, O> {
    let (mut count, mut segments, mut bounds) = (0, None, Window::EMPTY);
    let written = layers(&mut |layer| {
        if count > 0 {
            payload.push_all(&[0; CURSOR_WORDS]);
        }
        count += 1;
        payload.push_pixel(layer.color.to_word());
        let stored = outline::store(layer.outline, layer.fill_rule, payload)?;
        segments = stored.segments_needed().max(segments);
        bounds = bounds.around(&stored.bounds);
        Ok(())
    });
    let kind: &dyn PictureItem<C, O> = match (&written, count) {
        (Err(_), _) | (_, 0) => {
            return Draft {
                segments: written.map(|()| None),
                ..Draft::nothing()
            };
        }
        (_, 1) => &Outline,
        _ => &Layers,
    };
    Draft {
        segments: Ok(segments),
        ..Draft::new(Extent::of(&bounds), not_used::<C>(), kind)
    }
}

/// How outlines over each other are drawn: the lowest one has its cursor in the slot.
struct Layers;

/// The position of an outline's words in the pool. An item begins within the first 65,536 words, and its upper outline may lie
/// behind them.
#[derive(Debug, Copy, Clone)]
struct Position {
    /// The word of the colour.
    color: usize,
    /// The first word of the cursor; `None` for the one in the slot.
    cursor: Option<usize>,
}

impl Layers {
    /// The layers from the lowest one on.
    fn positions<C: BandColor>(
        slot: &PictureSlot<'_, C, impl Order>,
        pool: &Pool<'_>,
        mut call: impl FnMut(Position, StoredOutline<'_>),
    ) {
        let words = pool.slice(slot.at, slot.words);
        let at = usize::from(slot.at);
        let mut position = 0;
        let mut cursor = None;
        while let Some(rest) = words.get(position + 1..).filter(|rest| !rest.is_empty()) {
            let outline = StoredOutline::new(rest);
            call(
                Position {
                    color: at + position,
                    cursor,
                },
                outline,
            );
            let end = position + 1 + usize::from(outline.words());
            cursor = Some(at + end);
            position = end + CURSOR_WORDS;
        }
    }

    /// Calls with the cursor of each layer, the pool and the layer's position, and sets the cursor to what is returned.
    fn with_cursors<'a, C: BandColor, O: Order>(
        slot: &mut PictureSlot<'a, C, O>,
        pool: &mut Pool<'_>,
        mut call: impl FnMut(&PictureSlot<'a, C, O>, [u32; 2], &mut Pool<'_>, usize) -> [u32; 2],
    ) {
        // No shape has more layers than a fill and a stroke.
        let mut positions = [None; 2];
        let mut rest = positions.iter_mut();
        Self::positions(slot, pool, |position, _| {
            if let Some(room) = rest.next() {
                *room = Some(position);
            }
        });
        for Position { color, cursor } in positions.into_iter().flatten() {
            let before = match cursor {
                None => slot.cursor,
                Some(cursor) => pool.array_at(cursor).copied().unwrap_or_default(),
            };
            let after = call(slot, before, pool, color);
            match cursor {
                None => slot.cursor = after,
                Some(cursor) => {
                    if let Some(words) = pool.array_at(cursor) {
                        *words = after;
                    }
                }
            }
        }
    }
}

impl<C: ChannelColor, O: Order> PictureItem<C, O> for Layers {
    fn bounds(&self) -> Window {
        Window::EMPTY
    }

    fn draw(&self, _: &mut Band<'_, C, O>) {}

    fn check_translated(&self, moved: &Window) -> Result<(), InputError> {
        outline::check_moved(moved)
    }

    fn translate(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, by: Point) {
        let mut rest = pool.slice_mut(slot.at, slot.words);
        while let Some((_, outline)) = rest.split_first_mut() {
            let words = usize::from(StoredOutline::new(outline).words());
            outline::translate(outline, by.into());
            rest = outline.get_mut(words + CURSOR_WORDS..).unwrap_or_default();
        }
    }

    fn enter(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, _: i32) {
        Self::with_cursors(slot, pool, |_, _, pool, at| {
            let (words, memory) = pool.words_and_memory(at);
            let outline = StoredOutline::new(words.get(1..).unwrap_or_default());
            Progress::begin(outline, memory).to_words()
        });
    }

    fn columns_in(&self, slot: &PictureSlot<'_, C, O>, pool: &Pool<'_>, rows: Range<i32>) -> (i32, i32) {
        let (mut left, mut right) = (i32::MAX, i32::MIN);
        Self::positions(slot, pool, |_, outline| {
            let (start, end) = outline.columns_in(&rows);
            (left, right) = (left.min(start), right.max(end));
        });
        (left, right)
    }

    fn draw_row(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        Self::with_cursors(slot, pool, |slot, cursor, pool, at| {
            let (words, memory) = pool.words_and_memory(at);
            let (color, words) = words.split_first().unwrap_or((&0, &[]));
            let color = C::from_word(C::Word::from_repeated(*color));
            draw_row(
                slot,
                Progress::of(cursor),
                (color, StoredOutline::new(words)),
                memory,
                band,
            )
        });
    }

    fn draw_rows(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        for row in slot.extent.rows(&band.window()) {
            if let Some(mut band) = band.one_row(row) {
                self.draw_row(slot, pool, &mut band);
            }
        }
    }
}
