//! Texts in fonts of coverage masks: each glyph is found and placed once, and each row blends a row of each glyph.
//!
//! The words are a mask of the colours that follow it, those colours, and then for each line its position, its width and
//! the number of its glyphs, followed by a word for each glyph: its index, and how far the pen moves on behind it.

use core::num::Wrapping;

use embedded_graphics::{geometry::Point, mono_font::DecorationDimensions, text::Text};

use crate::{
    band::Band,
    draw::{
        MaskFont, MaskTextStyle,
        payload::{Payload, Reader},
        picture::{
            item::{Extent, PictureItem, PictureSlot, each_row, fill_span},
            pool::Pool,
            prepare::{Draft, Prepare, not_used},
        },
        text::{Line, Lines, blend_mask_row},
    },
    geometry::Window,
    shade::ChannelColor,
    surface::{Order, Target},
};

/// Bits of the first word: which colours there are.
const GLYPHS: u32 = 1;
const BACKGROUND: u32 = 2;
const STRIKETHROUGH: u32 = 4;
const UNDERLINE: u32 = 8;

/// The farthest that a line begins from column or row 0. No line is so long that more of it would be in a picture's columns.
const FARTHEST: i64 = 1 << 30;

impl<'a, C: ChannelColor, O: Order> Prepare<'a, C, O> for Text<'_, MaskTextStyle<C>> {
    fn prepare(&self, payload: &mut Payload<'_>) -> Draft<'a, C, O> {
        let style = &self.character_style;
        let font = style.font;
        let decorations = style.decorations().map(|decoration| decoration.map(|(_, color)| color));
        let [strikethrough, underline] = decorations;
        let colors = [
            (BACKGROUND, style.background_color),
            (STRIKETHROUGH, strikethrough),
            (UNDERLINE, underline),
        ];
        let has_glyphs = if style.text_color.is_some() { GLYPHS } else { 0 };
        let present = colors.iter().filter(|(_, color)| color.is_some());
        payload.push(present.fold(has_glyphs, |bits, (bit, _)| bits | bit));
        for color in colors.iter().filter_map(|&(_, color)| color) {
            payload.push_pixel(Band::<C, O>::word(color));
        }
        let lines = Lines::new(self);
        let mut bounds = Window::EMPTY;
        for line in lines.iter() {
            let window = push_line(&line, font, lines.extent(), payload);
            bounds = bounds.around(&window);
        }
        let kind: &'static dyn PictureItem<C, O> = font;
        Draft::new(
            Extent::of(&bounds),
            style.text_color.map_or_else(not_used::<C>, Band::<C, O>::word),
            kind,
        )
    }
}

/// Writes a line, and returns its box.
fn push_line(line: &Line<'_>, font: &'static MaskFont, extent: i64, payload: &mut Payload<'_>) -> Window {
    let columns = line.columns(font);
    let near = |number: i64| number.clamp(-FARTHEST, FARTHEST) as i32;
    payload.push_signed(near(line.left));
    payload.push_signed(near(line.top));
    payload.push_signed(near(columns.next - line.left));
    payload.push(line.glyphs(font).count() as u32);
    for glyph in line.glyphs(font) {
        // At most 2^12 + 2^11 pixels.
        payload.push(u32::from(glyph.index) << 16 | (glyph.step as u32 & 0xffff));
    }
    Window {
        left: near(columns.start),
        top: near(line.top),
        right: near(columns.end),
        bottom: near(line.top + extent),
    }
}

/// The font of a text draws it from its slot; alone it has nothing to draw.
impl<C: ChannelColor, O: Order> PictureItem<C, O> for MaskFont {
    fn bounds(&self) -> Window {
        Window::EMPTY
    }

    fn draw(&self, _: &mut Band<'_, C, O>) {}

    fn translate(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, by: Point) {
        let Some((present, words)) = pool.slice_mut(slot.at, slot.words).split_first_mut() else {
            return;
        };
        let colors = (*present & !GLYPHS).count_ones() as usize;
        let mut rest = words.get_mut(colors..).unwrap_or_default();
        while let [left, top, _, glyphs, behind @ ..] = rest {
            for (position, by) in [(left, by.x), (top, by.y)] {
                *position = (*position as i32 + by) as u32;
            }
            rest = behind.get_mut(*glyphs as usize..).unwrap_or_default();
        }
    }

    fn draw_row(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        let mut reader = Reader::new(pool.slice(slot.at, slot.words));
        let present = reader.next();
        let mut color = |bit: u32| (present & bit != 0).then(|| reader.next_pixel::<C::Word>());
        let (background, strikethrough, underline) = (color(BACKGROUND), color(STRIKETHROUGH), color(UNDERLINE));
        let text = (present & GLYPHS != 0).then(|| C::from_word(O::reorder(slot.word)));
        let y = band.window().top;
        let mut words = reader.rest();
        while let [left, top, width, count, rest @ ..] = words {
            let left = *left as i32;
            let columns = (left, left.saturating_add(*width as i32));
            let (glyphs, behind) = rest.split_at_checked(*count as usize).unwrap_or((rest, &[]));
            words = behind;
            // Neither is far from 0.
            let row = y - *top as i32;
            if row < 0 {
                continue;
            }
            if row < i32::from(self.height) {
                if let Some(word) = background {
                    fill_span(band, columns, word);
                }
                if let Some(color) = text {
                    draw_glyphs(self, band, glyphs, left, row, color);
                }
            }
            for (dimensions, word) in [(&self.strikethrough, strikethrough), (&self.underline, underline)] {
                if let (Some(word), true) = (word, has_row(dimensions, row)) {
                    fill_span(band, columns, word);
                }
            }
        }
    }

    fn draw_rows(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        each_row(slot, band, |slot, row| self.draw_row(slot, pool, row));
    }
}

/// Whether a decoration is in a row, counted from the first row of its line.
fn has_row(decoration: &DecorationDimensions, row: i32) -> bool {
    // As unsigned numbers, rows above the decoration are far below it.
    (row as u32).wrapping_sub(decoration.offset) < decoration.height && row as u32 >= decoration.offset
}

/// Blends a row of each glyph of a line, whose pen begins in column `left`.
#[inline(always)]
fn draw_glyphs<C: ChannelColor, O: Order>(
    font: &MaskFont,
    band: &mut Band<'_, C, O>,
    glyphs: &[u32],
    left: i32,
    row: i32,
    color: C,
) {
    let window = band.window();
    let mut pen = Wrapping(left) - Wrapping(window.left);
    for word in glyphs {
        let (index, step) = ((word >> 16) as u16, *word as i16);
        if let Some(glyph) = font.glyph(index) {
            let down = row - i32::from(glyph.top);
            if (down as u32) < u32::from(glyph.height) {
                let column = (pen + Wrapping(i32::from(glyph.left))).0;
                let mask = font.mask_from(glyph, down as usize);
                let Ok(()) = blend_mask_row(band, &window, window.top, column, glyph.width, mask, color);
            }
        }
        pen += i32::from(step);
    }
}
