//! embedded-graphics' `Text` in a monospaced font: the visible rows of the visible glyphs are filled as spans.
//!
//! embedded-graphics decodes every pixel of every glyph for each band, and the band tests each pixel that is set. Here
//! a line of text outside the window is skipped after a comparison of rows. Of a line that meets the window, only the
//! visible glyphs and rows are read from the font's image, up to 24 columns at once:
//!
//! ```text
//!   the font's image, one bit a pixel:   ..###...|.####...|   row of "OB"
//!                                          \_ run of ones: one span
//! ```
//!
//! Guarantees: the pixels of embedded-graphics' own renderer, with its alignments, baselines, line heights, backgrounds
//! and decorations, in any font. Positions beyond the number range are exact, where embedded-graphics overflows.

use core::{num::Wrapping, ops::Range};

use embedded_graphics::{
    mono_font::MonoTextStyle,
    pixelcolor::PixelColor,
    text::{DecorationColor, Text},
};

use crate::{
    draw::{
        DrawOn,
        eg::{
            font_glyphs::FontGlyphs,
            glyph_bits::{COLUMNS, bits_from, bits_per_row, pixels_from},
            image_bytes::with_bytes,
            text_lines::{Lines, lines},
        },
    },
    geometry::{Window, leading_zeros},
    surface::{Span, Target},
};

/// Draws text in a monospaced font. `Drawable::draw` of the same text is embedded-graphics' own implementation, which
/// is slow in bands of few rows.
impl<C: PixelColor> DrawOn for Text<'_, MonoTextStyle<'_, C>> {
    type Color = C;

    fn draw_on<T: Target<Color = C>>(&self, target: &mut T) -> Result<(), T::Error> {
        if is_missed(self, &target.window()) {
            return Ok(());
        }
        draw(self, target)
    }
}

/// Draws the rows that the target has of a text. Not inlined, so that what is not met does not have its stack frame.
#[inline(never)]
fn draw<C: PixelColor, T: Target<Color = C>>(
    text: &Text<'_, MonoTextStyle<'_, C>>,
    target: &mut T,
) -> Result<(), T::Error> {
    let window = target.window();
    let lines = Lines::new(text);
    if window.is_empty() || !lines.meet(&window) {
        return Ok(());
    }
    let image = &text.character_style.font.image;
    match with_bytes(image, |bytes| lines.draw(target, &window, Some(bytes))) {
        Some(drawn) => drawn,
        None => lines.draw(target, &window, None),
    }
}

/// Whether a window is above a text, or below one that has a single line and no decoration: a quick answer for most
/// texts that are not met. Others may not be met either.
fn is_missed<C: PixelColor>(text: &Text<'_, MonoTextStyle<'_, C>>, window: &Window) -> bool {
    let style = &text.character_style;
    let (font, row) = (style.font, text.position.y);
    let height = font.character_size.height;
    if row >= window.bottom {
        // The first row is at most so far above the text's position.
        return row.abs_diff(window.bottom) >= height.max(font.baseline);
    }
    let is_plain = matches!(
        (&style.underline_color, &style.strikethrough_color),
        (DecorationColor::None, DecorationColor::None)
    );
    let down = window.top.saturating_sub(row);
    down >= 0 && down as u32 >= height && is_plain && !has_line_break(text.text.as_bytes())
}

/// Whether a byte of a text is a newline. Cost: a dozen instructions for four bytes.
fn has_line_break(bytes: &[u8]) -> bool {
    // A newline becomes 0, which alone borrows from its highest bit without having had it (Mycroft 1987).
    let is_in = |word: &[u8; 4]| {
        let word = u32::from_ne_bytes(*word) ^ 0x0A0A_0A0A;
        (Wrapping(word) - Wrapping(0x0101_0101)).0 & !word & 0x8080_8080 != 0
    };
    let last = bytes.len().checked_sub(4).and_then(|start| bytes.get(start..));
    let Some(last) = last.and_then(|last| last.first_chunk()) else {
        return bytes.contains(&b'\n');
    };
    // The last word may overlap with the one before it.
    let mut rest = bytes;
    while let Some((word, after)) = rest.split_first_chunk() {
        if is_in(word) {
            return true;
        }
        rest = after;
    }
    is_in(last)
}

impl<C: PixelColor> Lines<'_, C> {
    /// Draws the visible lines. Without the `bytes` of the font's image, its pixels are read one by one. Not inlined,
    /// because there are two calls.
    #[inline(never)]
    fn draw<T: Target<Color = C>>(
        &self,
        target: &mut T,
        window: &Window,
        bytes: Option<&[u8]>,
    ) -> Result<(), T::Error> {
        let mut top = self.top;
        for line in lines(self.text.text) {
            if top >= i64::from(window.bottom) {
                break;
            }
            if top + self.extent > i64::from(window.top) {
                self.draw_line(target, window, bytes, line, top)?;
            }
            top += self.line_height;
        }
        Ok(())
    }

    /// Draws a line, whose first row is `top`. A carriage return at the end counts for the alignment, but is not drawn.
    fn draw_line<T: Target<Color = C>>(
        &self,
        target: &mut T,
        window: &Window,
        bytes: Option<&[u8]>,
        line: &str,
        top: i64,
    ) -> Result<(), T::Error> {
        let drawn = line.strip_suffix('\r').unwrap_or(line);
        let left = i64::from(self.text.position.x) - self.before_position(line);
        let style = &self.text.character_style;
        let has_glyphs = style.text_color.is_some() || style.background_color.is_some();
        let rows = self.visible_rows(window, top);
        if has_glyphs && !rows.is_empty() {
            let mut glyphs = Glyphs {
                lines: self,
                places: FontGlyphs::of(self.font),
                text: style.text_color.map(|color| target.raw(color)),
                background: style.background_color.map(|color| target.raw(color)),
                target,
                window,
                bytes,
                bits_per_row: bits_per_row(self.font) as usize,
                // Exact: the row is in the window, whose rows are 32-bit numbers.
                first_row: (top + i64::from(rows.start)) as i32,
                rows,
            };
            glyphs.draw(drawn, left)?;
        }
        for (decoration, color) in [
            (&self.font.strikethrough, &style.strikethrough_color),
            (&self.font.underline, &style.underline_color),
        ] {
            let color = match color {
                DecorationColor::None => None,
                DecorationColor::TextColor => style.text_color,
                DecorationColor::Custom(color) => Some(*color),
            };
            if let Some(color) = color {
                let glyphs = drawn.chars().count() as i64;
                let behind_last = if has_glyphs && glyphs > 0 { self.spacing } else { 0 };
                let end = left + glyphs * (self.width + self.spacing) - behind_last;
                let first = top + i64::from(decoration.offset);
                let rows = (first, first + i64::from(decoration.height));
                fill(target, window, (left, end), rows, color)?;
            }
        }
        Ok(())
    }

    /// The rows of a line's glyphs that a window shows, counted from the first row of the line, which is `top`.
    fn visible_rows(&self, window: &Window, top: i64) -> Range<u32> {
        // Between 0 and the rows of a glyph, which are a 32-bit number.
        let row = |side: i32| (i64::from(side) - top).min(self.height).max(0) as u32;
        row(window.top)..row(window.bottom)
    }
}

/// The glyphs of one line.
struct Glyphs<'g, 't, C: PixelColor, T: Target> {
    lines: &'g Lines<'t, C>,
    /// The places of the glyphs in the font's image.
    places: FontGlyphs<'t>,
    /// The colours of the text and of what is behind it, as the target has them.
    text: Option<T::Raw>,
    background: Option<T::Raw>,
    target: &'g mut T,
    window: &'g Window,
    /// The bytes of the font's image, one bit for each pixel, with rows padded to whole bytes; `None` where they cannot
    /// be read.
    bytes: Option<&'g [u8]>,
    /// Bits from a row of the font's image to the next one.
    bits_per_row: usize,
    /// The visible rows, counted from the first one of the line, and the row of the picture in which they begin.
    rows: Range<u32>,
    first_row: i32,
}

impl<C: PixelColor, T: Target<Color = C>> Glyphs<'_, '_, C, T> {
    /// Draws the visible glyphs of a line from column `x` on, and fills the background between them.
    fn draw(&mut self, line: &str, mut x: i64) -> Result<(), T::Error> {
        let Lines { width, spacing, .. } = *self.lines;
        let (left, right) = (i64::from(self.window.left), i64::from(self.window.right));
        let background = self.lines.text.character_style.background_color;
        let mut characters = line.chars();
        let mut next = characters.next();
        while let Some(character) = next {
            if x >= right {
                break;
            }
            next = characters.next();
            let end = x + width;
            if end > left {
                self.draw_glyph(character, x)?;
            }
            if let (Some(color), Some(_)) = (background, next) {
                self.fill((end, end + spacing), color)?;
            }
            x = end + spacing;
        }
        Ok(())
    }

    /// Fills the visible part of columns in all visible rows of the glyphs.
    // Not inlined: what does not depend on the columns would be computed for each glyph of a text without a background.
    #[inline(never)]
    fn fill(&mut self, columns: (i64, i64), color: C) -> Result<(), T::Error> {
        let first = i64::from(self.first_row);
        let rows = (first, first + i64::from(self.rows.end - self.rows.start));
        fill(self.target, self.window, columns, rows, color)
    }

    /// Draws the visible part of one glyph, whose first column is `x`. Draws nothing where the font's image does not
    /// have it.
    fn draw_glyph(&mut self, character: char, x: i64) -> Result<(), T::Error> {
        let Some((column, row)) = self.places.cell(character) else {
            return Ok(());
        };
        let mut done = 0;
        let width = self.lines.font.character_size.width;
        while done < width {
            let columns = (width - done).min(COLUMNS as u32);
            if let Some((start, visible)) = visible_columns(self.window, x + i64::from(done), columns) {
                self.draw_columns((column + done as usize, row), start, visible)?;
            }
            done += columns;
        }
        Ok(())
    }

    /// Draws up to [`COLUMNS`] columns of a glyph, of which the bits in `visible` are shown. The first one is `x`, and begins
    /// at a pixel of the font's image.
    fn draw_columns(&mut self, (column, row): (usize, usize), x: Wrapping<i32>, visible: u32) -> Result<(), T::Error> {
        for (down, y) in self.rows.clone().zip(self.first_row..) {
            let row = row + down as usize;
            let bits = match self.bytes {
                Some(bytes) => bits_from(bytes, row * self.bits_per_row + column),
                None => pixels_from(&self.lines.font.image, column, row),
            };
            // Text and background are drawn as separate runs, each pixel once, so that a display that is drawn on
            // directly does not flicker.
            if let Some(raw) = self.text {
                self.draw_runs(y, x, bits & visible, raw)?;
            }
            if let Some(raw) = self.background {
                self.draw_runs(y, x, !bits & visible, raw)?;
            }
        }
        Ok(())
    }

    /// Fills each run of ones in `bits`, whose highest bit is the pixel in column `x`; all of them are visible.
    fn draw_runs(&mut self, y: i32, x: Wrapping<i32>, mut bits: u32, raw: T::Raw) -> Result<(), T::Error> {
        let mut end = x;
        while bits != 0 {
            let gap = leading_zeros(bits);
            bits <<= gap;
            // The result is less than 32, because no more than `COLUMNS` bits are set.
            let run = leading_zeros(!bits);
            bits <<= run;
            let start = end + Wrapping(gap as i32);
            end = start + Wrapping(run as i32);
            self.target.fill_clipped_span(Span::new(y, start.0, end.0), raw)?;
        }
        Ok(())
    }
}

/// The first of some columns, at most [`COLUMNS`], with a bit for each that a window shows, the first one in the highest bit;
/// `None` where it shows none. The first column may be left of the number range: only visible columns are exact then.
#[inline]
fn visible_columns(window: &Window, first: i64, columns: u32) -> Option<(Wrapping<i32>, u32)> {
    let all = !(u32::MAX >> columns);
    let columns = i64::from(columns);
    let (before, room) = (i64::from(window.left) - first, i64::from(window.right) - first);
    if before <= 0 && columns <= room {
        return Some((Wrapping(first as i32), all));
    }
    if columns <= before || room <= 0 {
        return None;
    }
    let left = u32::MAX >> before.max(0);
    let right = if room < columns { !(u32::MAX >> room) } else { all };
    Some((Wrapping(first as i32), left & right))
}

/// Fills the visible part of a rectangle of columns and rows; `right` and `bottom` are excluded.
pub(in crate::draw) fn fill<T: Target>(
    target: &mut T,
    window: &Window,
    (left, right): (i64, i64),
    (top, bottom): (i64, i64),
    color: T::Color,
) -> Result<(), T::Error> {
    // Not `clamp`, which contains a panic for an empty range: the window is not empty here, but the compiler does not
    // know.
    let clip = |value: i64, first: i32, end: i32| value.min(end.into()).max(first.into()) as i32;
    let visible = Window {
        left: clip(left, window.left, window.right),
        top: clip(top, window.top, window.bottom),
        right: clip(right, window.left, window.right),
        bottom: clip(bottom, window.top, window.bottom),
    };
    let raw = target.raw(color);
    target.fill_window(visible, raw)
}

#[cfg(test)]
mod tests {
    use embedded_graphics::{
        geometry::Point,
        mock_display::MockDisplay,
        mono_font::{
            MonoTextStyleBuilder,
            ascii::{FONT_4X6, FONT_6X10},
        },
        pixelcolor::{BinaryColor, Rgb888},
        prelude::RgbColor,
        text::{Alignment, Baseline, TextStyleBuilder},
    };

    use super::*;
    use crate::surface::Generic;

    fn drawn<C: PixelColor>(text: &Text<'_, MonoTextStyle<'_, C>>) -> MockDisplay<C> {
        let mut display = MockDisplay::new();
        let Ok(()) = text.draw_on(&mut Generic(&mut display));
        display
    }

    #[test]
    fn two_letters() {
        let text = Text::new("zr", Point::new(0, 7), MonoTextStyle::new(&FONT_6X10, BinaryColor::On));
        drawn(&text).assert_pattern(&[
            "            ",
            "            ",
            "            ",
            "##### # ##  ",
            "   #  ##  # ",
            "  #   #     ",
            " #    #     ",
            "##### #     ",
        ]);
    }

    #[test]
    fn two_centred_lines() {
        let style = TextStyleBuilder::new()
            .alignment(Alignment::Center)
            .baseline(Baseline::Top);
        let letters = MonoTextStyle::new(&FONT_4X6, BinaryColor::On);
        let text = Text::with_text_style("row\n1", Point::new(5, 0), letters, style.build());
        drawn(&text).assert_pattern(&[
            "            ",
            "# #  #  # # ",
            "##  # # # # ",
            "#   # # ### ",
            "#    #  # # ",
            "            ",
            "     #      ",
            "    ##      ",
            "     #      ",
            "     #      ",
            "    ###     ",
        ]);
    }

    #[test]
    fn green_on_blue_with_a_red_line_below() {
        let letters = MonoTextStyleBuilder::new()
            .font(&FONT_4X6)
            .text_color(Rgb888::GREEN)
            .background_color(Rgb888::BLUE)
            .underline_with_color(Rgb888::RED);
        let text = Text::with_baseline("up", Point::new(1, 1), letters.build(), Baseline::Top);
        drawn(&text).assert_pattern(&[
            "         ",
            " BBBBBBBB",
            " GBGBGGBB",
            " GBGBGBGB",
            " GBGBGGBB",
            " BGGBGBBB",
            " BBBBGBBB",
            " RRRRRRRR",
        ]);
    }
}
