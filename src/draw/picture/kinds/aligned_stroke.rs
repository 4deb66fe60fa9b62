//! Shapes in an antialiased style whose stroke lies inside or outside of them, by copy: for the fill and for the stroke over it
//! an outline of the shape and of a centred stroke, and which combination of the two is drawn.
//!
//! ```text
//!     cursor, 2 words | colour | combination | index of the stroke's first edge | outline | cursor | ...
//! ```

use core::ops::Range;

use embedded_graphics::geometry::Point;

use crate::{
    band::Band,
    coverage::{Combination, CombinedArea, EmitRows},
    draw::{
        antialiased::AlignedSink,
        outline::{self, Progress, StoredOutline},
        payload::Payload,
        picture::{
            item::{Extent, PictureItem, PictureSlot},
            pool::Pool,
            prepare::{Draft, not_used},
        },
    },
    geometry::{InputError, Window},
    shade::{BatchBlend, ChannelColor},
    surface::{BandColor, Order, PixelWord, Target},
};

/// Words of a layer before its outline.
const HEADER_WORDS: usize = 5;

/// Writes the layers of a shape.
pub(super) fn prepare<'a, C: ChannelColor, O: Order>(
    payload: &mut Payload<'_>,
    layers: &dyn Fn(&mut AlignedSink<'_, C>) -> Result<(), InputError>,
) -> Draft<'a, C, O> {
    let (mut segments, mut bounds) = (None, Window::EMPTY);
    let written = layers(&mut |layer| {
        payload.push_all(&[0; 2]);
        payload.push_pixel(layer.color.to_word());
        payload.push(layer.combination as u32);
        let index = payload.needed();
        payload.push(0);
        let stored = outline::store(layer.outline, layer.fill_rule, payload)?;
        let outline = StoredOutline::new(payload.written_from(index + 1));
        let first_of_stroke = outline.index_behind(layer.edges_of_shape);
        payload.set(index, first_of_stroke);
        segments = stored.segments_needed().max(segments);
        bounds = bounds.around(&stored.bounds);
        Ok(())
    });
    match written {
        Err(error) => Draft {
            segments: Err(error),
            ..Draft::nothing()
        },
        Ok(()) => Draft {
            segments: Ok(segments),
            ..Draft::new(Extent::of(&bounds), not_used::<C>(), &AlignedStroke)
        },
    }
}

/// How combinations of a shape and its stroke are drawn, the lowest one first.
struct AlignedStroke;

/// A layer, read from its words.
struct Layer<'w> {
    progress: Progress,
    color: u32,
    area: CombinedArea,
    outline: StoredOutline<'w>,
}

impl<'w> Layer<'w> {
    /// The layer that begins with these words, which others may follow; `None` behind the last one.
    fn of(words: &'w [u32]) -> Option<Self> {
        let (&[edges, next, color, combination, first_of_stroke], outline) =
            words.split_first_chunk::<HEADER_WORDS>()?;
        Some(Self {
            progress: Progress::of([edges, next]),
            color,
            area: CombinedArea {
                combination: Combination::of_word(combination),
                first_of_stroke,
            },
            outline: StoredOutline::new(outline),
        })
    }

    /// How many words it takes.
    fn words(&self) -> usize {
        HEADER_WORDS + usize::from(self.outline.words())
    }
}

impl AlignedStroke {
    /// Calls with each layer and the memory of antialiasing, and keeps how far the layer is drawn then.
    fn go_on<C: BandColor>(
        slot: &PictureSlot<'_, C, impl Order>,
        pool: &mut Pool<'_>,
        mut call: impl FnMut(Layer<'_>, &mut outline::RowMemory<'_>) -> Progress,
    ) {
        let (mut index, end) = (0, usize::from(slot.words));
        while index < end {
            let (words, memory) = pool.words_and_memory(slot.at);
            let Some(layer) = Layer::of(words.get(index..).unwrap_or_default()) else {
                return;
            };
            let words = layer.words();
            let progress = call(layer, memory).to_words();
            let cursor = pool.slice_mut(slot.at, slot.words).get_mut(index..);
            if let Some(cursor) = cursor.and_then(<[u32]>::first_chunk_mut) {
                *cursor = progress;
            }
            index += words;
        }
    }
}

impl<C: ChannelColor, O: Order> PictureItem<C, O> for AlignedStroke {
    fn bounds(&self) -> Window {
        Window::EMPTY
    }

    fn draw(&self, _: &mut Band<'_, C, O>) {}

    fn check_translated(&self, moved: &Window) -> Result<(), InputError> {
        outline::check_moved(moved)
    }

    fn translate(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, by: Point) {
        let mut rest = pool.slice_mut(slot.at, slot.words);
        while let Some(words) = Layer::of(rest).map(|layer| layer.words()) {
            outline::translate(rest.get_mut(HEADER_WORDS..).unwrap_or_default(), by.into());
            rest = rest.get_mut(words..).unwrap_or_default();
        }
    }

    fn enter(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, _: i32) {
        Self::go_on(slot, pool, |layer, memory| Progress::begin(layer.outline, memory));
    }

    fn columns_in(&self, slot: &PictureSlot<'_, C, O>, pool: &Pool<'_>, rows: Range<i32>) -> (i32, i32) {
        let (mut left, mut right) = (i32::MAX, i32::MIN);
        let mut rest = pool.slice(slot.at, slot.words);
        while let Some(layer) = Layer::of(rest) {
            let (start, end) = layer.outline.columns_in(&rows);
            (left, right) = (left.min(start), right.max(end));
            rest = rest.get(layer.words()..).unwrap_or_default();
        }
        (left, right)
    }

    fn draw_row(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        let Window { left, top, right, .. } = band.window();
        let is_last = top + 1 >= i32::from(slot.extent.end);
        Self::go_on(slot, pool, |layer, memory| {
            let Layer {
                mut progress,
                color,
                area,
                outline,
            } = layer;
            let color = C::from_word(C::Word::from_repeated(color));
            let (mut blender, columns) = (band.blender(color), left..right);
            let Ok(()) = progress.draw_row_by(&area, outline, memory, top, columns, &mut blender.row(top));
            if is_last {
                progress.end(outline, memory);
            }
            progress
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
