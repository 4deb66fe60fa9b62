//! Texts in fonts of coverage masks: each glyph is found and placed once, and each row blends a row of each glyph.

use core::num::Wrapping;

use embedded_graphics::{geometry::Point, text::Text};

use crate::{
    band::Band,
    draw::{
        MaskFont, MaskTextStyle,
        payload::Payload,
        picture::{
            item::{Extent, PictureItem, PictureSlot, each_row},
            kinds::line_words::{self, LineRow, glyph_of},
            pool::Pool,
            prepare::{Draft, Prepare, not_used},
        },
        text::blend_mask_row,
    },
    geometry::Window,
    shade::ChannelColor,
    surface::{Order, Target},
};

impl<'a, C: ChannelColor, O: Order> Prepare<'a, C, O> for Text<'_, MaskTextStyle<C>> {
    fn prepare(&self, payload: &mut Payload<'_>) -> Draft<'a, C, O> {
        let style = &self.character_style;
        let kind: &'static dyn PictureItem<C, O> = style.font;
        let bounds = line_words::push::<C, O, _>(self, payload);
        let word = style.text_color.map_or_else(not_used::<C>, Band::<C, O>::word);
        Draft::new(Extent::of(&bounds), word, kind)
    }
}

/// The font of a text draws it from its slot; alone it has nothing to draw.
impl<C: ChannelColor, O: Order> PictureItem<C, O> for MaskFont {
    fn bounds(&self) -> Window {
        Window::EMPTY
    }

    fn draw(&self, _: &mut Band<'_, C, O>) {}

    fn translate(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, by: Point) {
        line_words::translate(pool.slice_mut(slot.at, slot.words), by);
    }

    fn draw_row(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        let words = pool.slice(slot.at, slot.words);
        let color = C::from_word(O::reorder(slot.word));
        line_words::draw_row(words, self, band, |band, line| draw_glyphs(self, band, line, color));
    }

    fn draw_rows(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        each_row(slot, band, |slot, row| self.draw_row(slot, pool, row));
    }
}

/// Blends a row of each glyph of a line.
#[inline]
fn draw_glyphs<C: ChannelColor, O: Order>(
    font: &MaskFont,
    band: &mut Band<'_, C, O>,
    LineRow { glyphs, left, row }: LineRow<'_>,
    color: C,
) {
    let window = band.window();
    let mut pen = Wrapping(left) - Wrapping(window.left);
    for word in glyphs {
        let (index, step) = glyph_of(*word);
        if let Some(glyph) = font.glyph(index) {
            let down = row - i32::from(glyph.top);
            if (down as u32) < u32::from(glyph.height) {
                let column = (pen + Wrapping(i32::from(glyph.left))).0;
                let mask = font.mask_from(glyph, down as usize);
                let Ok(()) = blend_mask_row(band, &window, window.top, column, glyph.width, mask, color);
            }
        }
        pen += step;
    }
}
