//! Texts in monospaced fonts: where each glyph lies in the font's image is found once, and each row takes a row of each
//! glyph.
//!
//! The words are 0 and, for each character, the bit of its glyph's first pixel in the image. What has several lines, a
//! background, decorations or glyphs of more than 24 columns is kept as it was given, and drawn as any text in each
//! band: its words begin with 1. What has no pixels has no words.

use core::{hint::black_box, num::Wrapping};

use embedded_graphics::{
    geometry::{Point, Size},
    mono_font::{MonoFont, MonoTextStyle, MonoTextStyleBuilder},
    text::{Alignment, Baseline, DecorationColor, LineHeight, Text, TextStyleBuilder},
};

use crate::{
    band::Band,
    draw::{
        DrawOn,
        eg::{
            font_glyphs::FontGlyphs,
            glyph_bits::{COLUMNS, bits_from, bits_per_row, pixels_from},
            image_bytes::with_bytes,
            text_lines::Lines,
        },
        payload::{Payload, Reader},
        picture::{
            item::{Extent, PictureItem, PictureSlot, each_row, set_pixel},
            kinds::replayed::translate_point,
            pool::Pool,
            prepare::{Draft, Prepare, not_used},
        },
    },
    geometry::{HAS_DIVIDER, Window},
    surface::{BandColor, Order, PixelWord, Target},
};

/// First word of a text that is kept as glyphs.
const AS_GLYPHS: u32 = 0;

/// First word of a text that is kept as it was given.
const AS_GIVEN: u32 = 1;

/// A bit behind every image.
const NO_GLYPH: u32 = 1 << 31;

impl<'a, C: BandColor, O: Order> Prepare<'a, C, O> for Text<'_, MonoTextStyle<'a, C>> {
    fn prepare(&self, payload: &mut Payload<'_>) -> Draft<'a, C, O> {
        let style = &self.character_style;
        let lines = Lines::new(self);
        let (extent, word) = match (glyph_box(&lines, self), style.text_color) {
            (Some(extent), Some(color)) => {
                payload.push(AS_GLYPHS);
                let glyphs = FontGlyphs::of(style.font);
                for character in self.text.chars() {
                    payload.push(glyphs.bit_of(character).unwrap_or(NO_GLYPH));
                }
                (extent, Band::<C, O>::word(color))
            }
            _ => {
                let bounds = lines.bounds();
                if bounds.is_empty() {
                    return Draft::nothing();
                }
                payload.push(AS_GIVEN);
                push_text(self, payload);
                (Extent::of(&bounds), not_used::<C>())
            }
        };
        let kind: &'a dyn PictureItem<C, O> = style.font;
        Draft::new(extent, word, kind)
    }
}

/// The box of the glyphs of a text that has one line and nothing but glyphs, where an extent and the columns that are
/// read at once hold them, and the bytes of a glyph's rows can be counted.
fn glyph_box<C: BandColor>(lines: &Lines<'_, C>, text: &Text<'_, MonoTextStyle<'_, C>>) -> Option<Extent> {
    let style = &text.character_style;
    let is_plain = style.background_color.is_none()
        && matches!(style.underline_color, DecorationColor::None)
        && matches!(style.strikethrough_color, DecorationColor::None)
        && !text.text.bytes().any(|byte| matches!(byte, b'\n' | b'\r'));
    let Size { width, height } = style.font.character_size;
    // A row of a glyph is found by counting the image's bytes in 32 bits.
    let bytes = height.checked_mul(bits_per_row(style.font) / 8);
    if !is_plain || width > COLUMNS as u32 || bytes.is_none() {
        return None;
    }
    Extent::of_whole(&lines.glyphs_of_one_line()?)
}

/// The font of a text draws it from its slot; alone it has nothing to draw.
impl<C: BandColor, O: Order> PictureItem<C, O> for MonoFont<'_> {
    fn bounds(&self) -> Window {
        Window::EMPTY
    }

    fn draw(&self, _: &mut Band<'_, C, O>) {}

    fn translate(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, by: Point) {
        if let [AS_GIVEN, position @ ..] = pool.slice_mut(slot.at, slot.words) {
            translate_point(position, by);
        }
    }

    fn draw_row(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        match pool.slice(slot.at, slot.words) {
            [AS_GLYPHS, glyphs @ ..] => {
                let image = &self.image;
                let stride = bits_per_row(self);
                let down = (band.window().top - i32::from(slot.extent.first)) as u32;
                let drawn = with_bytes(image, |bytes| {
                    let rows = bytes.get((down * (stride / 8)) as usize..).unwrap_or_default();
                    draw_glyphs(self, slot, glyphs, band, |bit| bits_from(rows, bit as usize));
                });
                if drawn.is_none() {
                    draw_pixels(self, slot, glyphs, band, down);
                }
            }
            [_, words @ ..] => draw_text(self, Reader::new(words), band),
            [] => {}
        }
    }
    fn draw_rows(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        each_row(slot, band, |slot, row| self.draw_row(slot, pool, row));
    }
}

/// Draws a row from an image whose bytes are not known, that many rows below the first one.
#[cold]
#[inline(never)]
fn draw_pixels<C: BandColor, O: Order>(
    font: &MonoFont<'_>,
    slot: &PictureSlot<'_, C, O>,
    glyphs: &[u32],
    band: &mut Band<'_, C, O>,
    down: u32,
) {
    let stride = bits_per_row(font).max(1);
    draw_glyphs(font, slot, glyphs, band, |bit| {
        pixels_from(&font.image, (bit % stride) as usize, (down + bit / stride) as usize)
    });
}

/// Draws a row, with what reads a row of a glyph whose first pixel in the image is a bit; the first pixel at the top.
#[inline]
fn draw_glyphs<C: BandColor, O: Order>(
    font: &MonoFont<'_>,
    slot: &PictureSlot<'_, C, O>,
    glyphs: &[u32],
    band: &mut Band<'_, C, O>,
    bits_at: impl Fn(u32) -> u32,
) {
    let width = font.character_size.width;
    // Behind the last glyph there may be any space.
    let advance = Wrapping(width as i32) + Wrapping(font.character_spacing as i32);
    let mask = !(u32::MAX >> width);
    let mut left = Wrapping(i32::from(slot.extent.left) - band.window().left);
    let row = band.words_mut();
    for glyph in glyphs {
        set_pixels(row, left.0, bits_at(*glyph) & mask, slot.word);
        left += advance;
    }
}

/// Sets those pixels of a row, from a column on, whose bits are set, the first one in the highest bit.
#[inline]
fn set_pixels<W: PixelWord>(row: &mut [W], left: i32, mut bits: u32, word: W) {
    if bits == 0 {
        return;
    }
    let glyph = row.get_mut(left as usize..).and_then(<[W]>::first_chunk_mut::<32>);
    match glyph {
        // Where no pixel can be beyond the row, none is compared with its end.
        Some(glyph) if HAS_DIVIDER => {
            while bits != 0 {
                let column = bits.leading_zeros() & 31;
                if let Some(pixel) = glyph.get_mut(column as usize) {
                    *pixel = word;
                }
                bits &= !(1 << 31 >> column);
                // Unrolled, the loop would leave no registers for what is around it.
                black_box(());
            }
        }
        _ => set_visible_pixels(row, left, bits, word),
    }
}

/// As [`set_pixels`], each one if the row has it.
#[inline(never)]
fn set_visible_pixels<W: PixelWord>(row: &mut [W], left: i32, mut bits: u32, word: W) {
    if !HAS_DIVIDER {
        return set_by_column(row, left, bits, word);
    }
    let mut column = left;
    while bits != 0 {
        let gap = bits.leading_zeros();
        column += gap as i32;
        set_pixel(row, column, word);
        column += 1;
        bits = bits << gap << 1;
    }
}

/// Sets those pixels of a row, from a column on, whose bits are set and which the row has: column by column, for a processor
/// without an instruction that counts to the next bit.
#[inline]
fn set_by_column<W: PixelWord>(row: &mut [W], left: i32, bits: u32, word: W) {
    let hidden = left.min(0).unsigned_abs();
    let visible = row.get_mut(left.max(0) as usize..);
    let (Some(mut bits), Some(mut pixels)) = (bits.checked_shl(hidden), visible) else {
        return;
    };
    while let [pixel, rest @ ..] = pixels {
        if bits >> 31 != 0 {
            *pixel = word;
        }
        bits <<= 1;
        if bits == 0 {
            return;
        }
        pixels = rest;
        // Unrolled, the loop would test for both ends at once, by arithmetic.
        black_box(());
    }
}

/// Writes all of a text but its font, its position first.
fn push_text<C: BandColor>(text: &Text<'_, MonoTextStyle<'_, C>>, payload: &mut Payload<'_>) {
    let style = &text.character_style;
    payload.push_signed(text.position.x);
    payload.push_signed(text.position.y);
    payload.push_optional_pixel(style.text_color.map(C::to_word));
    payload.push_optional_pixel(style.background_color.map(C::to_word));
    for color in [style.strikethrough_color, style.underline_color] {
        let (kind, color) = match color {
            DecorationColor::None => (0, None),
            DecorationColor::TextColor => (1, None),
            DecorationColor::Custom(color) => (2, Some(color)),
        };
        payload.push(kind);
        payload.push_optional_pixel(color.map(C::to_word));
    }
    payload.push(match text.text_style.alignment {
        Alignment::Left => 0,
        Alignment::Center => 1,
        Alignment::Right => 2,
    });
    payload.push(match text.text_style.baseline {
        Baseline::Top => 0,
        Baseline::Bottom => 1,
        Baseline::Middle => 2,
        Baseline::Alphabetic => 3,
    });
    match text.text_style.line_height {
        LineHeight::Pixels(pixels) => payload.push_all(&[0, pixels]),
        LineHeight::Percent(percent) => payload.push_all(&[1, percent]),
    }
    payload.push(text.text.len() as u32);
    for bytes in text.text.as_bytes().chunks(4) {
        let mut word = [0; 4];
        for (to, from) in word.iter_mut().zip(bytes) {
            *to = *from;
        }
        payload.push(u32::from_ne_bytes(word));
    }
}

/// Draws a text that was written as words.
#[inline(never)]
fn draw_text<C: BandColor, O: Order>(font: &MonoFont<'_>, mut reader: Reader<'_>, band: &mut Band<'_, C, O>) {
    let position = Point::new(reader.next_signed(), reader.next_signed());
    let mut style = MonoTextStyleBuilder::new().font(font).build();
    style.text_color = reader.next_optional_pixel().map(C::from_word);
    style.background_color = reader.next_optional_pixel().map(C::from_word);
    let mut decoration = || {
        let kind = reader.next();
        let color = reader.next_optional_pixel().map(C::from_word);
        match (kind, color) {
            (1, _) => DecorationColor::TextColor,
            (2, Some(color)) => DecorationColor::Custom(color),
            _ => DecorationColor::None,
        }
    };
    style.strikethrough_color = decoration();
    style.underline_color = decoration();
    let alignment = match reader.next() {
        0 => Alignment::Left,
        1 => Alignment::Center,
        _ => Alignment::Right,
    };
    let baseline = match reader.next() {
        0 => Baseline::Top,
        1 => Baseline::Bottom,
        2 => Baseline::Middle,
        _ => Baseline::Alphabetic,
    };
    let line_height = match (reader.next(), reader.next()) {
        (0, pixels) => LineHeight::Pixels(pixels),
        (_, percent) => LineHeight::Percent(percent),
    };
    let text_style = TextStyleBuilder::new()
        .alignment(alignment)
        .baseline(baseline)
        .line_height(line_height)
        .build();
    let length = reader.next() as usize;
    let bytes = bytemuck::cast_slice(reader.rest()).get(..length).unwrap_or_default();
    // It was one when it was written.
    let Ok(characters) = core::str::from_utf8(bytes) else {
        return;
    };
    let Ok(()) = Text::with_text_style(characters, position, style, text_style).draw_on(band);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_beyond_a_row_are_left_out_with_and_without_counting_zeros() {
        for left in (-40..45).chain([-(1 << 30), 1 << 30]) {
            for bits in [0, 1, 1 << 31, u32::MAX, 0x8000_0001, 0x5a00_0000, 0x00f0_f0f0] {
                let expected: [u16; 40] = core::array::from_fn(|column| {
                    let bit = column as i64 - i64::from(left);
                    u16::from((0..32).contains(&bit) && bits << bit >> 31 != 0)
                });
                let (mut counted, mut by_column) = ([0; 40], [0; 40]);
                set_visible_pixels(&mut counted, left, bits, 1);
                set_by_column(&mut by_column, left, bits, 1);
                assert_eq!((counted, by_column), (expected, expected), "{left}, {bits:#x}");
            }
        }
    }
}
