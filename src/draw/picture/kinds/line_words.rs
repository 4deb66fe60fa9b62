//! The words of a text in a picture, and how the rows of its lines are drawn, in any font.
//!
//! ```text
//!     colours there are | colours | left, top, width, glyphs of a line | glyph | glyph | .. | left, top, .. of the next line
//! ```
//!
//! A glyph is its index in the upper half of a word, and in the lower one how far the pen moves on behind it.

use core::ops::RangeInclusive;

use embedded_graphics::{geometry::Point, mono_font::DecorationDimensions, text::Text};

use crate::{
    band::Band,
    draw::{
        payload::{Payload, Reader},
        picture::item::fill_span,
        text::{Line, LineFont, LineStyle, Lines},
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

/// The columns and rows in which a line can begin and end: none of them is 2^31 or more columns from the first one of a band, which
/// is within them. No line has so many rows that one which begins above them would be seen.
const NEAR: RangeInclusive<i64> = -(1 << 30)..=(1 << 30) - 1;

/// The column or row of [`NEAR`] that is nearest to a number.
fn near(number: i64) -> i32 {
    number.clamp(*NEAR.start(), *NEAR.end()) as i32
}

/// Writes a text, and returns the box around it.
pub(super) fn push<C: ChannelColor, O: Order, S: LineStyle<Color = C>>(
    text: &Text<'_, S>,
    payload: &mut Payload<'_>,
) -> Window {
    let style = &text.character_style;
    let [strikethrough, underline] = style.decorations().map(|decoration| decoration.map(|(_, color)| color));
    let colors = [
        (BACKGROUND, style.background_color()),
        (STRIKETHROUGH, strikethrough),
        (UNDERLINE, underline),
    ];
    let has_glyphs = if style.text_color().is_some() { GLYPHS } else { 0 };
    let present = colors.iter().filter(|(_, color)| color.is_some());
    payload.push(present.fold(has_glyphs, |bits, (bit, _)| bits | bit));
    for color in colors.iter().filter_map(|&(_, color)| color) {
        payload.push_pixel(Band::<C, O>::word(color));
    }
    let lines = Lines::new(text);
    let mut bounds = Window::EMPTY;
    for line in lines.iter() {
        let window = push_line(&line, style.font(), lines.extent(), payload);
        bounds = bounds.around(&window);
    }
    bounds
}

/// Writes a line, and returns its box. Of one that begins outside of the columns that are [`NEAR`], the background and the
/// decorations are kept, as far as they are near, and no glyph: it takes 64 glyphs or more, each of which is millions of pixels wide,
/// to reach a picture from there.
fn push_line(line: &Line<'_>, font: impl LineFont, extent: i64, payload: &mut Payload<'_>) -> Window {
    let columns = line.columns(font);
    let [left, next] = [line.left, columns.next].map(near);
    payload.push_signed(left);
    payload.push_signed(near(line.top));
    payload.push_signed(next - left);
    let glyphs = || line.glyphs(font).take_while(|_| NEAR.contains(&line.left));
    payload.push(glyphs().count() as u32);
    for glyph in glyphs() {
        payload.push(u32::from(glyph.index) << 16 | (glyph.step as u32 & 0xffff));
    }
    Window {
        left: near(columns.start),
        top: near(line.top),
        right: near(columns.end),
        bottom: near(line.top + extent),
    }
}

/// The index of a glyph's word, and how far the pen moves on behind it.
#[inline(always)]
pub(super) const fn glyph_of(word: u32) -> (u16, i32) {
    ((word >> 16) as u16, word as i16 as i32)
}

/// Moves the lines by some columns and rows.
pub(super) fn translate(words: &mut [u32], by: Point) {
    let Some((present, words)) = words.split_first_mut() else {
        return;
    };
    let colors = (*present & !GLYPHS).count_ones() as usize;
    let mut rest = words.get_mut(colors..).unwrap_or_default();
    while let [left, top, _, glyphs, behind @ ..] = rest {
        for (position, by) in [(left, by.x), (top, by.y)] {
            // A line without pixels may lie far from those that have some, at the ends of [`NEAR`], and stays between them.
            *position = near(i64::from(*position as i32) + i64::from(by)) as u32;
        }
        rest = behind.get_mut(*glyphs as usize..).unwrap_or_default();
    }
}

/// A row of a line, as far as its glyphs are drawn.
#[derive(Debug, Copy, Clone)]
pub(super) struct LineRow<'w> {
    /// The words of the line's glyphs.
    pub(super) glyphs: &'w [u32],
    /// The column in which the line begins.
    pub(super) left: i32,
    /// The row, counted from the first one of the line.
    pub(super) row: i32,
}

/// Draws the row that a band has, of all lines: backgrounds, what `draw_glyphs` draws of a line's glyphs, and decorations.
#[inline(always)]
pub(super) fn draw_row<C: ChannelColor, O: Order>(
    words: &[u32],
    font: impl LineFont,
    band: &mut Band<'_, C, O>,
    mut draw_glyphs: impl FnMut(&mut Band<'_, C, O>, LineRow<'_>),
) {
    let mut reader = Reader::new(words);
    let present = reader.next();
    let mut color = |bit: u32| (present & bit != 0).then(|| reader.next_pixel::<C::Word>());
    let (background, strikethrough, underline) = (color(BACKGROUND), color(STRIKETHROUGH), color(UNDERLINE));
    let y = band.window().top;
    let rows = font.rows();
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
        if i64::from(row) < rows {
            if let Some(word) = background {
                fill_span(band, columns, word);
            }
            if present & GLYPHS != 0 {
                draw_glyphs(band, LineRow { glyphs, left, row });
            }
        }
        if let Some(word) = strikethrough.filter(|_| has_row(&font.strikethrough(), row)) {
            fill_span(band, columns, word);
        }
        if let Some(word) = underline.filter(|_| has_row(&font.underline(), row)) {
            fill_span(band, columns, word);
        }
    }
}

/// Whether a decoration is in a row, counted from the first row of its line.
fn has_row(decoration: &DecorationDimensions, row: i32) -> bool {
    // As unsigned numbers, rows above the line are far below it.
    let from_first = (row as u32).checked_sub(decoration.offset);
    from_first.is_some_and(|row| row < decoration.height)
}
