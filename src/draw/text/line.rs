//! The lines of a text and the glyphs of a line, each with its position, in any font.
//!
//! Positions have 64 bits, so that sums of a 32-bit position and sizes do not overflow. The pen counts from the left end of a
//! line in units of the font: from a glyph to the next one it moves by the glyph's advance and the kerning of the two. What
//! lies before a pair does not matter, so a text that is drawn in pieces loses no more than the kerning between them, and
//! digits of equal widths stay where they are when others change.

use core::str::Chars;

use embedded_graphics::{
    geometry::Point,
    mono_font::DecorationDimensions,
    pixelcolor::PixelColor,
    text::{Alignment, Baseline, DecorationColor, LineHeight, Text},
};

use crate::{
    draw::eg::text_lines::{line_height, lines},
    geometry::Window,
};

/// A font at one size, as far as lines of text are laid out in it.
pub(in crate::draw) trait LineFont: Copy {
    /// The index of a character's glyph, or that of the replacement. `None` where the font has neither.
    fn index_of(self, character: char) -> Option<u16>;

    /// How far the pen moves from a glyph to the one that follows, `None` for the last one, in units of the pen. Fits 16 bits.
    fn step(self, index: u16, following: Option<u16>) -> i32;

    /// How many columns so many units of the pen are, rounded to the nearest.
    fn columns(self, pen: i64) -> i64;

    /// The first column in which a glyph may have pixels and the one behind the last, from the left end of the line; `None` where
    /// it has none.
    fn glyph_columns(self, index: u16, pen: i64) -> Option<(i64, i64)>;

    /// Rows of a line.
    fn rows(self) -> i64;

    /// The row on which letters stand, counted from the first row of a line: the last one of an "H".
    fn baseline(self) -> i64;

    /// Rows from one line to the next.
    fn line_height(self) -> u32;

    /// Where an underline is, counted from the first row of a line.
    fn underline(self) -> DecorationDimensions;

    /// Where a strikethrough is, counted from the first row of a line.
    fn strikethrough(self) -> DecorationDimensions;
}

/// A style of text, as far as lines are drawn in it.
pub(in crate::draw) trait LineStyle {
    /// The colour type of the target.
    type Color: PixelColor;
    /// The font at one size.
    type Font: LineFont;

    /// The font at its size.
    fn font(&self) -> Self::Font;

    /// The colour of the glyphs; `None` draws none.
    fn text_color(&self) -> Option<Self::Color>;

    /// The colour of the line's rows behind the glyphs; `None` leaves what is there.
    fn background_color(&self) -> Option<Self::Color>;

    /// The colours of the underline and of the strikethrough.
    fn decoration_colors(&self) -> [DecorationColor<Self::Color>; 2];

    /// The decorations that are drawn, the strikethrough first: where each is, and its colour.
    fn decorations(&self) -> [Option<(DecorationDimensions, Self::Color)>; 2] {
        let [underline, strikethrough] = self.decoration_colors();
        let color = |color| match color {
            DecorationColor::None => None,
            DecorationColor::TextColor => self.text_color(),
            DecorationColor::Custom(color) => Some(color),
        };
        [
            color(strikethrough).map(|color| (self.font().strikethrough(), color)),
            color(underline).map(|color| (self.font().underline(), color)),
        ]
    }
}

/// A glyph of a line.
pub(in crate::draw) struct PositionedGlyph {
    /// The glyph's index in the font.
    pub(in crate::draw) index: u16,
    /// The pen before this glyph, from the left end of the line.
    pub(in crate::draw) pen: i64,
    /// How far the pen moves on from here.
    pub(in crate::draw) step: i32,
}

/// The glyphs of a line, from left to right.
pub(in crate::draw) struct Glyphs<'t, F> {
    font: F,
    characters: Chars<'t>,
    /// The glyph that comes next.
    next: Option<u16>,
    pen: i64,
}

impl<'t, F: LineFont> Glyphs<'t, F> {
    /// The glyphs of `line`.
    pub(in crate::draw) fn new(font: F, line: &'t str) -> Self {
        let mut glyphs = Self {
            font,
            characters: line.chars(),
            next: None,
            pen: 0,
        };
        glyphs.next = glyphs.next_index();
        glyphs
    }

    /// The columns of the glyphs that were taken, to where the pen is.
    pub(in crate::draw) fn width(&self) -> i64 {
        self.font.columns(self.pen)
    }

    fn next_index(&mut self) -> Option<u16> {
        let font = self.font;
        self.characters.find_map(|character| font.index_of(character))
    }
}

impl<F: LineFont> Iterator for Glyphs<'_, F> {
    type Item = PositionedGlyph;

    fn next(&mut self) -> Option<PositionedGlyph> {
        let index = self.next?;
        self.next = self.next_index();
        let (pen, step) = (self.pen, self.font.step(index, self.next));
        self.pen += i64::from(step);
        Some(PositionedGlyph { index, pen, step })
    }
}

/// A line of text and its position.
pub(in crate::draw) struct Line<'t> {
    pub(in crate::draw) text: &'t str,
    /// The column of the pen before the first glyph.
    pub(in crate::draw) left: i64,
    /// The line's first row.
    pub(in crate::draw) top: i64,
}

/// The columns that the glyphs of a line have pixels in, and where the pen ends.
pub(in crate::draw) struct Columns {
    /// The first column with a pixel, and not right of the line's `left`.
    pub(in crate::draw) start: i64,
    /// The column behind the last one with a pixel, and not left of `next`.
    pub(in crate::draw) end: i64,
    /// The column of the pen behind the line.
    pub(in crate::draw) next: i64,
}

impl<'t> Line<'t> {
    pub(in crate::draw) fn glyphs<F: LineFont>(&self, font: F) -> Glyphs<'t, F> {
        Glyphs::new(font, self.text)
    }

    /// The columns of the line; each glyph is read.
    pub(in crate::draw) fn columns(&self, font: impl LineFont) -> Columns {
        let (mut start, mut end) = (self.left, self.left);
        let mut glyphs = self.glyphs(font);
        for placed in glyphs.by_ref() {
            if let Some((left, right)) = font.glyph_columns(placed.index, placed.pen) {
                start = start.min(self.left + left);
                end = end.max(self.left + right);
            }
        }
        let next = self.left + glyphs.width();
        Columns {
            start,
            end: end.max(next),
            next,
        }
    }
}

/// Rows from the first row of a line to the row that a baseline means.
pub(in crate::draw) fn above_baseline(font: impl LineFont, baseline: Baseline) -> i64 {
    let last = (font.rows() - 1).max(0);
    match baseline {
        Baseline::Top => 0,
        Baseline::Bottom => last,
        Baseline::Middle => last / 2,
        Baseline::Alphabetic => font.baseline(),
    }
}

/// Rows of a line with its decorations.
pub(in crate::draw) fn rows_with_decorations(style: &impl LineStyle) -> i64 {
    let font = style.font();
    let mut rows = font.rows();
    let dimensions = [font.underline(), font.strikethrough()];
    for (color, dimensions) in style.decoration_colors().into_iter().zip(dimensions) {
        if !matches!(color, DecorationColor::None) {
            rows = rows.max(i64::from(dimensions.offset) + i64::from(dimensions.height));
        }
    }
    rows
}

/// The lines of a text.
pub(in crate::draw) struct Lines<'t, F> {
    text: &'t str,
    font: F,
    alignment: Alignment,
    position: Point,
    /// The first row of the first line.
    top: i64,
    /// Rows from the top of a line to the end of its glyphs or its lowest decoration, whichever is further down.
    extent: i64,
    /// Rows from the top of one line to the top of the next.
    line_height: i64,
}

impl<'t, F: LineFont> Lines<'t, F> {
    pub(in crate::draw) fn new<S: LineStyle<Font = F>>(text: &Text<'t, S>) -> Self {
        let style = &text.character_style;
        let font = style.font();
        Self {
            text: text.text,
            font,
            alignment: text.text_style.alignment,
            position: text.position,
            top: i64::from(text.position.y) - above_baseline(font, text.text_style.baseline),
            extent: rows_with_decorations(style),
            line_height: height_of_line(text.text_style.line_height, font),
        }
    }

    /// Rows from the top of a line to the end of its glyphs or its lowest decoration.
    pub(in crate::draw) const fn extent(&self) -> i64 {
        self.extent
    }

    /// Whether the window shows a row between the top of the first line and the end of the last. Cost: each byte of the
    /// text is read where the window begins below the first line.
    pub(in crate::draw) fn meet(&self, window: &Window) -> bool {
        let (top, bottom) = (i64::from(window.top), i64::from(window.bottom));
        if bottom <= self.top {
            return false;
        }
        if top < self.top + self.extent {
            return true;
        }
        let further = self.text.bytes().filter(|&byte| byte == b'\n').count() as i64;
        top < self.top + self.line_height.saturating_mul(further) + self.extent
    }

    /// The lines, from the first to the last.
    pub(in crate::draw) fn iter(&self) -> impl Iterator<Item = Line<'t>> {
        self.tops().map(|(line, top)| self.line(line, top))
    }

    /// The lines that have a row in a window.
    pub(in crate::draw) fn visible(&self, window: &Window) -> impl Iterator<Item = Line<'t>> {
        let (first, bottom) = (i64::from(window.top) - self.extent, i64::from(window.bottom));
        self.tops()
            .take_while(move |&(_, top)| top < bottom)
            .filter(move |&(_, top)| top > first)
            .map(|(line, top)| self.line(line, top))
    }

    /// Each line with its first row.
    fn tops(&self) -> impl Iterator<Item = (&'t str, i64)> {
        let (mut next, height) = (self.top, self.line_height);
        lines(self.text).map(move |line| {
            let top = next;
            next = next.saturating_add(height);
            (line, top)
        })
    }

    /// A line with its position, which takes a walk along the line where it is not left-aligned. A carriage return at
    /// the end counts for the alignment, but is not drawn.
    fn line(&self, line: &'t str, top: i64) -> Line<'t> {
        Line {
            text: line.strip_suffix('\r').unwrap_or(line),
            left: i64::from(self.position.x) - self.before_position(line),
            top,
        }
    }

    /// Columns from the left end of a line to the text's position, by the text's alignment.
    fn before_position(&self, line: &str) -> i64 {
        if self.alignment == Alignment::Left {
            return 0;
        }
        let mut glyphs = Glyphs::new(self.font, line);
        glyphs.by_ref().for_each(drop);
        match self.alignment {
            Alignment::Right => glyphs.width() - 1,
            _ => (glyphs.width() - 1) / 2,
        }
    }
}

/// Rows from the top of one line to the top of the next.
fn height_of_line(height: LineHeight, font: impl LineFont) -> i64 {
    line_height(height, font.line_height())
}
