//! The lines of a text in a [`MaskFont`] and the glyphs of a line, each with its position.
//!
//! Positions have 64 bits, so that sums of a 32-bit position and sizes do not overflow. The pen moves by whole pixels:
//! from a glyph to the next one it moves by the glyph's advance and the kerning of the two, rounded to the nearest
//! pixel. What lies before a pair does not matter, so a text that is drawn in pieces loses no more than the kerning
//! between them, and digits of equal widths stay where they are when others change.

use core::str::Chars;

use embedded_graphics::{
    geometry::Point,
    pixelcolor::PixelColor,
    text::{Alignment, Baseline, DecorationColor, LineHeight, Text},
};

use crate::{
    draw::{
        eg::text::{line_height, lines},
        text::{MaskFont, MaskGlyph, MaskTextStyle},
    },
    geometry::Window,
};

/// A glyph of a line.
pub(in crate::draw) struct PositionedGlyph {
    /// The glyph's index in the font.
    pub(in crate::draw) index: u16,
    /// The column of the pen before this glyph.
    pub(in crate::draw) pen: i64,
    /// The columns that the pen moves on from here.
    pub(in crate::draw) step: i32,
}

/// The glyphs of a line, from left to right.
pub(in crate::draw) struct Glyphs<'t> {
    font: &'static MaskFont,
    characters: Chars<'t>,
    /// The glyph that comes next.
    next: Option<u16>,
    pen: i64,
}

impl<'t> Glyphs<'t> {
    /// The glyphs of `line`, of which the first one is placed with the pen in column `pen`.
    pub(in crate::draw) fn new(font: &'static MaskFont, line: &'t str, pen: i64) -> Self {
        let mut glyphs = Self {
            font,
            characters: line.chars(),
            next: None,
            pen,
        };
        glyphs.next = glyphs.next_index();
        glyphs
    }

    /// The column of the pen behind the glyphs that were taken.
    pub(in crate::draw) const fn pen(&self) -> i64 {
        self.pen
    }

    fn next_index(&mut self) -> Option<u16> {
        let font = self.font;
        self.characters.find_map(|character| font.index_of(character))
    }
}

impl Iterator for Glyphs<'_> {
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
    pub(in crate::draw) fn glyphs(&self, font: &'static MaskFont) -> Glyphs<'t> {
        Glyphs::new(font, self.text, self.left)
    }

    /// The columns of the line; each glyph is read.
    pub(in crate::draw) fn columns(&self, font: &'static MaskFont) -> Columns {
        let (mut start, mut end) = (self.left, self.left);
        let mut glyphs = self.glyphs(font);
        for placed in glyphs.by_ref() {
            if let Some(glyph) = font.glyph(placed.index) {
                let (left, right) = columns_of(glyph, placed.pen);
                start = start.min(left);
                end = end.max(right);
            }
        }
        Columns {
            start,
            end: end.max(glyphs.pen()),
            next: glyphs.pen(),
        }
    }
}

/// The first column of a glyph's mask and the one behind the last.
pub(in crate::draw) fn columns_of(glyph: &MaskGlyph, pen: i64) -> (i64, i64) {
    let left = pen + i64::from(glyph.left);
    (left, left + i64::from(glyph.width))
}

/// Rows from the first row of a line to the row that a baseline means.
pub(in crate::draw) fn above_baseline(font: &MaskFont, baseline: Baseline) -> i64 {
    let last = i64::from(font.height.saturating_sub(1));
    match baseline {
        Baseline::Top => 0,
        Baseline::Bottom => last,
        Baseline::Middle => last / 2,
        Baseline::Alphabetic => font.baseline.into(),
    }
}

/// Rows of a line with its decorations.
pub(in crate::draw) fn rows_with_decorations<C>(style: &MaskTextStyle<C>) -> i64 {
    let font = style.font;
    let mut rows = i64::from(font.height);
    for (color, dimensions) in [
        (&style.underline_color, &font.underline),
        (&style.strikethrough_color, &font.strikethrough),
    ] {
        if !matches!(color, DecorationColor::None) {
            rows = rows.max(i64::from(dimensions.offset) + i64::from(dimensions.height));
        }
    }
    rows
}

/// The lines of a text.
pub(in crate::draw) struct Lines<'t> {
    text: &'t str,
    font: &'static MaskFont,
    alignment: Alignment,
    position: Point,
    /// The first row of the first line.
    top: i64,
    /// Rows from the top of a line to the end of its glyphs or its lowest decoration, whichever is further down.
    extent: i64,
    /// Rows from the top of one line to the top of the next.
    line_height: i64,
}

impl<'t> Lines<'t> {
    pub(in crate::draw) fn new<C: PixelColor>(text: &Text<'t, MaskTextStyle<C>>) -> Self {
        let style = &text.character_style;
        let font = style.font;
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
        let mut glyphs = Glyphs::new(self.font, line, 0);
        glyphs.by_ref().for_each(drop);
        match self.alignment {
            Alignment::Right => glyphs.pen() - 1,
            _ => (glyphs.pen() - 1) / 2,
        }
    }
}

/// Rows from the top of one line to the top of the next.
fn height_of_line(height: LineHeight, font: &MaskFont) -> i64 {
    line_height(height, font.line_height.into())
}
