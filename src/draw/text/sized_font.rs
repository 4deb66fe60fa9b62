//! A font of outlines at one size: where its lines, its glyphs and their outlines are, in pixels.

use embedded_graphics::mono_font::DecorationDimensions;
use fixed::types::U24F8;

use crate::{
    draw::text::{
        glyph_outline::GlyphOutline,
        line::{Line, LineFont},
        outline_font::{OutlineFont, OutlineGlyph},
        scale::Scale,
    },
    geometry::{InputError, Sub8, SubPixel, Window},
};

/// A font of outlines at one size. The pen moves in font units, so that no rounding adds up along a line.
#[derive(Debug, Copy, Clone)]
pub(in crate::draw) struct SizedFont<'f> {
    /// The font.
    pub(in crate::draw) font: &'f OutlineFont,
    /// How long a font unit is.
    pub(in crate::draw) scale: Scale,
}

/// Rounds 1/256 pixel to the nearest pixel, halves up.
const fn nearest_pixel(units: i64) -> i64 {
    (units + 128) >> 8
}

/// Rounds 1/256 pixel up to whole pixels.
const fn pixels_up(units: i64) -> i64 {
    (units + 255) >> 8
}

impl<'f> SizedFont<'f> {
    /// A font in a size in pixels of the em square. Cost: a division.
    pub(super) fn new(font: &'f OutlineFont, size: U24F8) -> Self {
        Self {
            font,
            scale: Scale::new(size, font.units_per_em),
        }
    }

    /// A length in font units, in 1/256 pixel.
    fn length(self, units: i64) -> i64 {
        self.scale.length(2 * units)
    }

    /// Rows of a line above the baseline.
    fn rows_above(self) -> i64 {
        pixels_up(self.length(self.font.ascent.into()))
    }

    /// Where a decoration is.
    fn decoration(self, (below, thickness): (i16, u16)) -> DecorationDimensions {
        let offset = self.rows_above() + nearest_pixel(self.length(below.into()));
        let height = nearest_pixel(self.length(thickness.into()));
        // Below 2^26 pixels.
        DecorationDimensions::new(offset.max(0) as u32, height.max(1) as u32)
    }

    /// A glyph with its position: the pen in font units from the left end of a line, which is at column `left`. `baseline` is the
    /// row on which letters stand. `None` where it has no outline.
    pub(in crate::draw) fn place(self, index: u16, pen: i64, (left, baseline): (i64, i64)) -> Option<PlacedGlyph<'f>> {
        let glyph = self.font.glyph(index)?;
        let is_empty = glyph.left >= glyph.right || glyph.bottom >= glyph.top || glyph.points == 0;
        (!is_empty).then(|| PlacedGlyph {
            font: self,
            glyph,
            is_crossing: self.font.is_crossing(index),
            // The number of a column fits 32 bits, and the pen is not far from there.
            origin: [256 * left + self.length(pen), 256 * (baseline + 1)],
        })
    }

    /// A glyph with its position as [`place`](Self::place) gives it; `None` where it has no points in a row, of which these are the
    /// [half units](Scale::half_units_in_row).
    #[inline(always)]
    pub(in crate::draw) fn place_in(
        self,
        units: &[i32; 2],
        index: u16,
        pen: i64,
        position: (i64, i64),
    ) -> Option<PlacedGlyph<'f>> {
        let [first, last] = *units;
        let glyph = self.font.glyph(index)?;
        if last < 2 * i32::from(glyph.bottom) || 2 * i32::from(glyph.top) < first {
            return None;
        }
        self.place(index, pen, position)
    }

    /// The glyphs of a line that have an outline.
    pub(in crate::draw) fn placed<'t>(self, line: &Line<'t>) -> impl Iterator<Item = PlacedGlyph<'f>> + use<'f, 't> {
        let position = (line.left, line.top + self.baseline());
        line.glyphs(self)
            .filter_map(move |glyph| self.place(glyph.index, glyph.pen, position))
    }
}

impl LineFont for SizedFont<'_> {
    fn index_of(self, character: char) -> Option<u16> {
        self.font.index_of(character)
    }

    fn step(self, index: u16, following: Option<u16>) -> i32 {
        self.font.step(index, following)
    }

    fn columns(self, pen: i64) -> i64 {
        nearest_pixel(self.length(pen))
    }

    fn glyph_columns(self, index: u16, pen: i64) -> Option<(i64, i64)> {
        let glyph = self.place(index, pen, (0, 0))?;
        Some(glyph.columns())
    }

    fn rows(self) -> i64 {
        self.rows_above() + pixels_up(self.length(self.font.descent.into()))
    }

    fn baseline(self) -> i64 {
        (self.rows_above() - 1).max(0)
    }

    fn line_height(self) -> u32 {
        nearest_pixel(self.length(self.font.line_height.into())) as u32
    }

    fn underline(self) -> DecorationDimensions {
        self.decoration(self.font.underline)
    }

    fn strikethrough(self) -> DecorationDimensions {
        self.decoration(self.font.strikethrough)
    }
}

/// A glyph with its position.
#[derive(Debug, Copy, Clone)]
pub(in crate::draw) struct PlacedGlyph<'f> {
    font: SizedFont<'f>,
    glyph: &'static OutlineGlyph,
    /// Whether contours of the glyph cross, overlap or touch.
    is_crossing: bool,
    /// Where the pen and the baseline are, in 1/256 pixel from the upper left corner of pixel (0, 0).
    origin: [i64; 2],
}

impl<'f> PlacedGlyph<'f> {
    /// The x of the left and the right side of the glyph's bounds, in 1/256 pixel from the corner of pixel (0, 0).
    pub(super) fn sides(&self) -> [i64; 2] {
        [self.glyph.left, self.glyph.right]
            .map(|units| self.origin[0] + self.font.scale.coordinate(2 * i32::from(units)))
    }

    /// The y of the upper and the lower side of the glyph's bounds, in 1/256 pixel from the corner of pixel (0, 0).
    pub(super) fn heights(&self) -> [i64; 2] {
        [self.glyph.top, self.glyph.bottom]
            .map(|units| self.origin[1] - self.font.scale.coordinate(2 * i32::from(units)))
    }

    /// Whether contours of the glyph cross, overlap or touch.
    pub(super) const fn is_crossing(&self) -> bool {
        self.is_crossing
    }

    /// The first column of the pixels that the bounds reach, and the one behind the last.
    pub(in crate::draw) fn columns(&self) -> (i64, i64) {
        let [left, right] = self.sides();
        (left >> 8, pixels_up(right))
    }

    /// The first row of the pixels that the bounds reach, and the one behind the last.
    pub(in crate::draw) fn rows(&self) -> (i64, i64) {
        let [top, bottom] = self.heights();
        (top >> 8, pixels_up(bottom))
    }

    /// The part of a window in which the glyph may have pixels.
    pub(in crate::draw) fn visible(&self, window: &Window) -> Window {
        let clip = |side: i64, first: i32, end: i32| side.min(end.into()).max(first.into()) as i32;
        let ((left, right), (top, bottom)) = (self.columns(), self.rows());
        Window {
            left: clip(left, window.left, window.right),
            top: clip(top, window.top, window.bottom),
            right: clip(right, window.left, window.right),
            bottom: clip(bottom, window.top, window.bottom),
        }
    }

    /// The outline in pixels.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where the bounds leave the domain of [`Sub8`].
    pub(in crate::draw) fn outline(&self) -> Result<GlyphOutline<'f>, InputError> {
        /// How far the pen may be from the glyph, in 1/256 pixel, so that no sum exceeds 32 bits.
        const FARTHEST: i64 = 1 << 29;
        let domain = i64::from(Sub8::MIN_UNITS) + 128..=i64::from(Sub8::MAX_UNITS) + 128;
        let are_inside = self
            .sides()
            .iter()
            .chain(&self.heights())
            .all(|side| domain.contains(side));
        if !are_inside || self.origin.iter().any(|units| units.abs() > FARTHEST) {
            return Err(InputError::out_of_domain::<Sub8>());
        }
        // From the corner of a pixel to its centre.
        let origin = self.origin.map(|units| (units - 128) as i32);
        Ok(GlyphOutline {
            font: self.font.font,
            glyph: self.glyph,
            scale: self.font.scale,
            is_crossing: self.is_crossing,
            origin,
        })
    }
}
