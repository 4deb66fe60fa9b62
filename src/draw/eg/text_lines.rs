//! The lines of an embedded-graphics' `Text` in a monospaced font, and where each is.

use embedded_graphics::{
    mono_font::{MonoFont, MonoTextStyle},
    pixelcolor::PixelColor,
    text::{Alignment, Baseline, DecorationColor, LineHeight, Text},
};

use crate::geometry::Window;

/// The lines of a text and their positions. Coordinates have 64 bits, so that sums of a 32-bit position and sizes do
/// not overflow.
pub(in crate::draw) struct Lines<'t, C: PixelColor> {
    pub(super) text: &'t Text<'t, MonoTextStyle<'t, C>>,
    pub(super) font: &'t MonoFont<'t>,
    /// Columns of a glyph.
    pub(super) width: i64,
    /// Rows of a glyph.
    pub(super) height: i64,
    /// Columns between two glyphs.
    pub(super) spacing: i64,
    /// Row of the first line's top.
    pub(super) top: i64,
    /// Rows from the top of a line to the end of its glyphs or its lowest decoration, whichever is further down.
    pub(super) extent: i64,
    /// Rows from the top of one line to the top of the next.
    pub(super) line_height: i64,
}

impl<'t, C: PixelColor> Lines<'t, C> {
    pub(in crate::draw) fn new(text: &'t Text<'t, MonoTextStyle<'t, C>>) -> Self {
        let style = &text.character_style;
        let font = style.font;
        let rows = font.character_size.height;
        let above_baseline = match text.text_style.baseline {
            Baseline::Top => 0,
            Baseline::Bottom => rows.saturating_sub(1),
            Baseline::Middle => rows.saturating_sub(1) / 2,
            Baseline::Alphabetic => font.baseline,
        };
        let end = |color: &DecorationColor<C>, offset: u32, height: u32| match color {
            DecorationColor::None => 0,
            _ => i64::from(offset) + i64::from(height),
        };
        let (strikethrough, underline) = (&font.strikethrough, &font.underline);
        let extent = i64::from(rows)
            .max(end(
                &style.strikethrough_color,
                strikethrough.offset,
                strikethrough.height,
            ))
            .max(end(&style.underline_color, underline.offset, underline.height));
        Self {
            text,
            font,
            width: font.character_size.width.into(),
            height: rows.into(),
            spacing: font.character_spacing.into(),
            top: i64::from(text.position.y) - i64::from(above_baseline),
            extent,
            line_height: line_height(text.text_style.line_height, rows),
        }
    }

    /// A window around all lines. Its sides saturate at the ends of the number range.
    pub(in crate::draw) fn bounds(&self) -> Window {
        let (mut left, mut right, mut bottom) = (i64::MAX, i64::MIN, self.top + self.extent);
        for (line, further) in lines(self.text.text).zip(0..) {
            let start = i64::from(self.text.position.x) - self.before_position(line);
            let glyphs = line.chars().count() as i64;
            left = left.min(start);
            right = right.max(start + glyphs * (self.width + self.spacing));
            bottom = self.top + self.line_height.saturating_mul(further) + self.extent;
        }
        let side = |side: i64| side.max(i32::MIN.into()).min(i32::MAX.into()) as i32;
        Window {
            left: side(left),
            top: side(self.top),
            right: side(right),
            bottom: side(bottom),
        }
    }

    /// The box of the glyphs of a text, which must have one line. `None` where a side exceeds the number range, or the
    /// box is empty.
    pub(in crate::draw) fn glyphs_of_one_line(&self) -> Option<Window> {
        let left = i64::from(self.text.position.x) - self.before_position(self.text.text);
        let glyphs = self.text.text.chars().count() as i64;
        let right = left + glyphs * (self.width + self.spacing) - self.spacing;
        let side = |side: i64| i32::try_from(side).ok();
        let window = Window {
            left: side(left)?,
            top: side(self.top)?,
            right: side(right)?,
            bottom: side(self.top + self.height)?,
        };
        (!window.is_empty()).then_some(window)
    }

    /// Whether the window shows a row between the top of the first line and the end of the last. Cost: each byte of the
    /// text is read where the window begins below the first line.
    pub(super) fn meet(&self, window: &Window) -> bool {
        let (top, bottom) = (i64::from(window.top), i64::from(window.bottom));
        if bottom <= self.top {
            return false;
        }
        if top < self.top + self.extent {
            return true;
        }
        let further = self.text.text.bytes().filter(|&byte| byte == b'\n').count() as i64;
        top < self.top + self.line_height.saturating_mul(further) + self.extent
    }

    /// The number of columns from the left end of a line to the text's position, by the text's alignment.
    pub(super) fn before_position(&self, line: &str) -> i64 {
        let width = || {
            let glyphs = line.chars().count() as i64;
            (glyphs * (self.width + self.spacing) - self.spacing).max(0)
        };
        match self.text.text_style.alignment {
            Alignment::Left => 0,
            Alignment::Right => width() - 1,
            Alignment::Center => (width() - 1) / 2,
        }
    }
}

/// Rows from the top of one line to the top of the next, at most `i32::MAX`. `rows` is the height of a glyph.
pub(in crate::draw) fn line_height(line_height: LineHeight, rows: u32) -> i64 {
    let height = match line_height {
        // The default of 100 % is a case of its own, which needs no division.
        LineHeight::Percent(100) => rows.into(),
        LineHeight::Percent(percent) => u64::from(rows) * u64::from(percent) / 100,
        LineHeight::Pixels(pixels) => pixels.into(),
    };
    height.min(i32::MAX as u64) as i64
}

/// The lines of a text, separated by newlines, as `str::split('\n')` returns them.
pub(in crate::draw) fn lines(text: &str) -> impl Iterator<Item = &str> {
    let mut rest = Some(text);
    core::iter::from_fn(move || {
        let text = rest?;
        let end = text.bytes().position(|byte| byte == b'\n');
        rest = end.and_then(|end| text.get(end + 1..));
        text.get(..end.unwrap_or(text.len()))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_those_of_split() {
        for text in ["", "a", "\n", "a\n", "\nb", "a\r\n\n\u{e4}b\n\n"] {
            assert!(lines(text).eq(text.split('\n')), "{text:?}");
        }
    }
}
