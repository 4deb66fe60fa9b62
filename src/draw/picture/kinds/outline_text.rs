//! Texts in fonts of outlines: glyphs are found and spaced once, and each row finds the edges that it meets in flash.
//!
//! The first word is the scale; the others are those of any text, in which the pen moves in font units.

use core::ops::Range;

use embedded_graphics::{geometry::Point, text::Text};

use crate::{
    band::Band,
    draw::{
        OutlineFont, OutlineTextStyle, SubOutline,
        outline::{self, RowMemory},
        payload::Payload,
        picture::{
            item::{Extent, PictureItem, PictureSlot, each_row},
            kinds::line_words::{self, LineRow, glyph_of},
            pool::Pool,
            prepare::{Draft, Prepare, not_used},
        },
        text::{LineFont, LineStyle, Lines, Scale, SizedFont},
    },
    geometry::{InputError, Window},
    shade::ChannelColor,
    surface::{Order, Target},
};

impl<'a, C: ChannelColor, O: Order> Prepare<'a, C, O> for Text<'_, OutlineTextStyle<C>> {
    fn prepare(&self, payload: &mut Payload<'_>) -> Draft<'a, C, O> {
        let style = &self.character_style;
        let kind: &'static dyn PictureItem<C, O> = style.font;
        payload.push(style.font().scale.to_word());
        let bounds = line_words::push::<C, O, _>(self, payload);
        let word = style.text_color.map_or_else(not_used::<C>, Band::<C, O>::word);
        match most_segments(self) {
            Ok(segments) => Draft {
                segments: Ok(segments),
                ..Draft::new(Extent::of(&bounds), word, kind)
            },
            Err(error) => Draft {
                segments: Err(error),
                ..Draft::nothing()
            },
        }
    }
}

/// The most segments that a glyph of a text has in a row, of those whose contours cross: the others need cells alone. `None` where
/// there are no glyphs. Cost: each outline whose contours cross is flattened.
fn most_segments<C: ChannelColor>(text: &Text<'_, OutlineTextStyle<C>>) -> Result<Option<usize>, InputError> {
    let font = text.character_style.font();
    let mut most = None;
    for line in Lines::new(text).iter() {
        for glyph in font.placed(&line) {
            let outline = glyph.outline()?;
            let segments = if outline.is_simple() {
                0
            } else {
                // In the domain, as the outline is.
                let (top, bottom) = glyph.rows();
                segments_of(&outline, top as i32..bottom as i32)
            };
            most = most.max(Some(segments));
        }
    }
    Ok(most)
}

/// The most segments that an outline has in one of some rows.
fn segments_of(outline: &dyn SubOutline, rows: Range<i32>) -> usize {
    let most = outline::most_edges(outline, rows, usize::MAX);
    if most < usize::MAX {
        return most;
    }
    let mut edges = 0;
    outline.edges(&mut |_, _| edges += 1);
    edges
}

/// The font of a text draws it from its slot; alone it has nothing to draw.
impl<C: ChannelColor, O: Order> PictureItem<C, O> for OutlineFont {
    fn bounds(&self) -> Window {
        Window::EMPTY
    }

    fn draw(&self, _: &mut Band<'_, C, O>) {}

    fn check_translated(&self, moved: &Window) -> Result<(), InputError> {
        outline::check_moved(moved)
    }

    fn translate(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, by: Point) {
        if let Some((_, words)) = pool.slice_mut(slot.at, slot.words).split_first_mut() {
            line_words::translate(words, by);
        }
    }

    fn draw_row(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        let color = C::from_word(O::reorder(slot.word));
        let (words, memory) = pool.words_and_memory(slot.at);
        let words = words.get(..usize::from(slot.words)).unwrap_or_default();
        let Some((scale, words)) = words.split_first() else {
            return;
        };
        let font = SizedFont {
            font: self,
            scale: Scale::of_word(*scale),
        };
        line_words::draw_row(words, font, band, |band, line| {
            draw_glyphs(font, band, memory, line, color)
        });
    }

    fn draw_rows(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        each_row(slot, band, |slot, row| self.draw_row(slot, pool, row));
    }
}

/// Blends a row of each glyph of a line.
#[inline(never)]
fn draw_glyphs<C: ChannelColor, O: Order>(
    font: SizedFont<'_>,
    band: &mut Band<'_, C, O>,
    memory: &mut RowMemory<'_>,
    LineRow { glyphs, left, row }: LineRow<'_>,
    color: C,
) {
    let window = band.window();
    let above_baseline = font.baseline() as i32 - row;
    let baseline = i64::from(window.top) + i64::from(above_baseline);
    let units = font.scale.half_units_in_row(above_baseline);
    let mut pen = 0;
    for word in glyphs {
        let (index, step) = glyph_of(*word);
        let glyph = font.place_in(&units, index, pen, (left.into(), baseline));
        // A picture has fewer than 2^16 words, so that the sum of as many steps of 16 bits is in the number range.
        pen += i64::from(step);
        let Some(glyph) = glyph else { continue };
        let visible = glyph.visible(&window);
        // It was in the domain when the text was added.
        let (false, Ok(outline)) = (visible.is_empty(), glyph.outline()) else {
            continue;
        };
        let Ok(()) = outline.blend_row(band, color, memory, &units, &visible);
    }
}
