//! Fonts whose glyphs are coverage masks: plain tables for flash.
//!
//! A character is found by its range, ranges and kerning pairs by binary search. Nothing in a font has to be right:
//! whatever its tables hold, drawing does not panic, and draws between the first and the last row of a line.

use core::fmt;

use embedded_graphics::mono_font::DecorationDimensions;

use crate::draw::text::{
    character_tables::{index_in_ranges, kerning_between},
    line::LineFont,
};

/// How many units of [`MaskGlyph::advance`] and of an adjustment in [`MaskFont::kerning`] a pixel has, as a power of two: 16.
const UNIT_BITS: u32 = 4;

/// A font at one size: for each glyph a mask of 4 bits a pixel, its position, its advance, and pairs that are kerned.
///
/// Written by zrow's converter, as a `static`. Characters that the font does not have are drawn as
/// [`replacement`](Self::replacement); without one they take no space, as if they were not in the text.
///
/// Flash: 12 bytes a glyph, 6 bytes a kerning pair, 8 bytes a range of characters, and the masks.
///
/// ```
/// use embedded_graphics::{mono_font::DecorationDimensions, pixelcolor::Gray8, prelude::*, primitives::Rectangle, text::Text};
/// use zrow::{band::Band, draw::{BlendOn, MaskFont, MaskGlyph, MaskTextStyle}};
///
/// // A dash of 2 x 1 pixels, the second of which is covered to a third.
/// static FONT: MaskFont = MaskFont {
///     ranges: &[('-', 1, 0)],
///     glyphs: &[MaskGlyph { offset: 0, left: 0, top: 0, width: 2, height: 1, advance: 2 * 16 }],
///     coverage: &[0xf5],
///     kerning: &[],
///     height: 1,
///     baseline: 0,
///     line_height: 1,
///     underline: DecorationDimensions::new(1, 1),
///     strikethrough: DecorationDimensions::new(0, 1),
///     replacement: None,
/// };
///
/// let mut words = [0; 4];
/// let mut band = Band::<Gray8>::new(Rectangle::new(Point::zero(), Size::new(4, 1)), &mut words)?;
/// Text::new("--", Point::zero(), MaskTextStyle::new(&FONT, Gray8::WHITE)).draw_on(&mut band)?;
/// assert_eq!(words, [255, 85, 255, 85]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
pub struct MaskFont {
    /// Characters that follow each other and have glyphs that follow each other: the first character, how many there are, and
    /// the index of the first one's glyph. In ascending order.
    pub ranges: &'static [(char, u16, u16)],
    /// The glyphs.
    pub glyphs: &'static [MaskGlyph],
    /// The masks of all glyphs: 4 bits a pixel in fifteenths, the left pixel in the upper half of a byte. Each row
    /// begins with a new byte.
    pub coverage: &'static [u8],
    /// Pairs of glyphs that are moved together or apart: the index of the left and of the right one, and what is added to the
    /// advance of the left one, in 1/16 pixel, negative where they move together. Sorted by the left and then by the right glyph.
    pub kerning: &'static [(u16, u16, i16)],
    /// Rows of a line, from the highest to the lowest one in which any glyph has pixels. What a glyph has beyond them is
    /// not drawn.
    pub height: u16,
    /// The row on which letters stand, counted from the first row of a line: the last one of an "H".
    pub baseline: u16,
    /// Rows from one line of a text to the next.
    pub line_height: u16,
    /// Where an underline is, counted from the first row of a line.
    pub underline: DecorationDimensions,
    /// Where a strikethrough is, counted from the first row of a line.
    pub strikethrough: DecorationDimensions,
    /// The glyph of characters that the font does not have.
    pub replacement: Option<u16>,
}

/// Where the mask of a glyph lies in a [`MaskFont`] and in a line of text.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MaskGlyph {
    /// The index of the mask's first byte in [`MaskFont::coverage`].
    pub offset: u32,
    /// Columns from the pen's position to the mask's first column.
    pub left: i16,
    /// Rows from the line's first row to the mask's first row.
    pub top: i16,
    /// Columns of the mask.
    pub width: u8,
    /// Rows of the mask.
    pub height: u8,
    /// How far the pen moves on, in 1/16 pixel. The sum with the kerning is rounded to whole pixels.
    pub advance: u16,
}

impl MaskGlyph {
    /// Bytes of a row of the mask.
    pub(in crate::draw) const fn row_bytes(&self) -> usize {
        (self.width as usize).div_ceil(2)
    }
}

impl MaskFont {
    pub(in crate::draw) fn glyph(&self, index: u16) -> Option<&'static MaskGlyph> {
        self.glyphs.get(usize::from(index))
    }

    /// The bytes of a glyph's mask from a row on.
    pub(in crate::draw) fn mask_from(&self, glyph: &MaskGlyph, row: usize) -> &'static [u8] {
        let row = row * glyph.row_bytes();
        let start = (glyph.offset as usize).checked_add(row);
        start.and_then(|start| self.coverage.get(start..)).unwrap_or_default()
    }
}

/// The pen moves by whole pixels: advances with kerning are rounded to the nearest pixel.
impl LineFont for &MaskFont {
    fn index_of(self, character: char) -> Option<u16> {
        index_in_ranges(self.ranges, character).or(self.replacement)
    }

    fn step(self, index: u16, following: Option<u16>) -> i32 {
        let advance = self.glyph(index).map_or(0, |glyph| i32::from(glyph.advance));
        let kerning = following.map_or(0, |following| kerning_between(self.kerning, index, following));
        (advance + kerning + (1 << UNIT_BITS >> 1)) >> UNIT_BITS
    }

    fn columns(self, pen: i64) -> i64 {
        pen
    }

    fn glyph_columns(self, index: u16, pen: i64) -> Option<(i64, i64)> {
        let glyph = self.glyph(index)?;
        Some(columns_of(glyph, pen))
    }

    fn rows(self) -> i64 {
        self.height.into()
    }

    fn baseline(self) -> i64 {
        self.baseline.into()
    }

    fn line_height(self) -> u32 {
        self.line_height.into()
    }

    fn underline(self) -> DecorationDimensions {
        self.underline
    }

    fn strikethrough(self) -> DecorationDimensions {
        self.strikethrough
    }
}

/// The first column of a glyph's mask and the one behind the last, where the pen is in a column.
pub(in crate::draw) fn columns_of(glyph: &MaskGlyph, pen: i64) -> (i64, i64) {
    let left = pen + i64::from(glyph.left);
    (left, left + i64::from(glyph.width))
}

impl fmt::Debug for MaskFont {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("MaskFont")
            .field("glyphs", &self.glyphs.len())
            .field("height", &self.height)
            .finish_non_exhaustive()
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for MaskFont {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(
            formatter,
            "MaskFont of {} glyphs, {} rows",
            self.glyphs.len(),
            self.height
        );
    }
}
