//! Fonts whose glyphs are outlines of quadratic curves: plain tables for flash, for text of any size.
//!
//! A character is found by its range, ranges and kerning pairs by binary search. Nothing in a font has to be right: whatever
//! its tables hold, drawing does not panic, a contour is closed, and a glyph draws inside of its bounds.

use core::fmt;

use crate::draw::text::character_tables::{index_in_ranges, kerning_between};

/// A font for any size: for each glyph the contours of its outline, its bounds, its advance, and pairs that are kerned.
///
/// Written by zrow's converter, as a `static`: `cargo run --release -- font FILE.ttf --outlines --chars '0-9.:°C'` in zrow's
/// repository. Lengths are in font units, of which the em square has
/// [`units_per_em`](Self::units_per_em); x grows to the right from where the pen is, and y upwards from the baseline.
/// Characters that the font does not have are drawn as [`replacement`](Self::replacement); without one they take no space, as
/// if they were not in the text. [`OutlineTextStyle`](crate::draw::OutlineTextStyle) draws text in it.
///
/// A contour is a list of points as in TrueType (Apple 1990): it begins with a point on it, between two of which lies a
/// straight line, or with one control point between them a quadratic Bézier curve. Between two control points that follow
/// each other a point on the contour is implied, in the middle. The last point is followed by the first one. What lies inside
/// of the contours by the nonzero rule is filled.
///
/// Flash: 16 bytes a glyph, 2 or 4 bytes and 2 bits a point, 6 bytes a kerning pair, 8 bytes a range of characters.
///
/// ```
/// use embedded_graphics::{pixelcolor::Gray8, prelude::*, primitives::Rectangle, text::Text};
/// use zrow::{
///     band::Band,
///     draw::{DrawAntialiased, OutlineFont, OutlineGlyph, OutlineTextStyle},
///     fixed::types::U24F8,
/// };
///
/// // A dash from a tenth to nine tenths of the em square.
/// static FONT: OutlineFont = OutlineFont {
///     units_per_em: 10,
///     ranges: &[('-', 1, 0)],
///     glyphs: &[OutlineGlyph { first: 0, points: 4, advance: 10, left: 1, bottom: 0, right: 9, top: 5 }],
///     small_points: &[[1, 0], [9, 0], [9, 5], [1, 5]],
///     points: &[],
///     flags: &[0b11_01_01_01],
///     crossing: &[],
///     kerning: &[],
///     ascent: 5,
///     descent: 0,
///     line_height: 10,
///     underline: (1, 1),
///     strikethrough: (-3, 1),
///     replacement: None,
/// };
///
/// let (mut words, mut row_memory) = ([0; 5], [0; 6]);
/// let mut band = Band::<Gray8>::new(Rectangle::new(Point::zero(), Size::new(5, 1)), &mut words)?;
/// let style = OutlineTextStyle::new(&FONT, U24F8::from_num(2.5), Gray8::WHITE);
/// Text::new("--", Point::zero(), style).draw_on(&mut band.antialiased::<2, 2>(&mut row_memory))?;
/// // From 0.25 to 2.25 and from 2.75 to 4.75 columns: the third one has a quarter of each dash.
/// assert_eq!(words, [191, 255, 112, 255, 191]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
pub struct OutlineFont {
    /// Font units of the em square, whose side is what the size of a text means. With none, nothing is drawn.
    pub units_per_em: u16,
    /// Characters that follow each other and have glyphs that follow each other: the first character, how many there are, and
    /// the index of the first one's glyph. In ascending order.
    pub ranges: &'static [(char, u16, u16)],
    /// The glyphs.
    pub glyphs: &'static [OutlineGlyph],
    /// The points of all contours as (x, y), where all of them fit 8 bits: then [`points`](Self::points) is not read.
    pub small_points: &'static [[i8; 2]],
    /// The points of all contours as (x, y), where [`small_points`](Self::small_points) is empty.
    pub points: &'static [[i16; 2]],
    /// Two bits for each point, those of four in a byte, the first one in the lowest bits: 1 for a point on the contour, and 2
    /// for the last one of a contour.
    pub flags: &'static [u8],
    /// The indices of glyphs whose contours cross, overlap or touch, sorted: their coverage takes longer to compute. The coverage of
    /// all others is the signed area, in which what lies in two contours counts twice, and a hole runs the other way.
    pub crossing: &'static [u16],
    /// Pairs of glyphs that are moved together or apart: the index of the left and of the right one, and what is added to the
    /// advance of the left one, negative where they move together. Sorted by the left and then by the right glyph.
    pub kerning: &'static [(u16, u16, i16)],
    /// How far glyphs reach above the baseline. What a glyph has in rows beyond is not drawn.
    pub ascent: u16,
    /// How far glyphs reach below the baseline. What a glyph has in rows beyond is not drawn.
    pub descent: u16,
    /// From one baseline to the next.
    pub line_height: u16,
    /// From the baseline down to the upper side of an underline, and its thickness.
    pub underline: (i16, u16),
    /// From the baseline down to the upper side of a strikethrough, negative because it lies above, and its thickness.
    pub strikethrough: (i16, u16),
    /// The glyph of characters that the font does not have.
    pub replacement: Option<u16>,
}

/// Where the contours of a glyph lie in an [`OutlineFont`], and how far they reach, in font units.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OutlineGlyph {
    /// The index of the first point of the first contour.
    pub first: u32,
    /// How many points the contours have.
    pub points: u16,
    /// How far the pen moves on.
    pub advance: u16,
    /// The smallest x of a point. Points beyond the bounds are drawn as if they lay on them.
    pub left: i16,
    /// The smallest y of a point.
    pub bottom: i16,
    /// The largest x of a point.
    pub right: i16,
    /// The largest y of a point.
    pub top: i16,
}

/// A point of a contour.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(super) struct OutlinePoint {
    /// (x, y) in half a font unit, y upwards.
    pub(super) position: [i32; 2],
    /// Whether the contour passes through the point; or else it is a control point.
    pub(super) is_on_contour: bool,
    /// Whether the contour ends with it.
    pub(super) is_last: bool,
}

impl OutlineFont {
    /// The index of a character's glyph, or that of the replacement. `None` where the font has neither.
    pub(super) fn index_of(&self, character: char) -> Option<u16> {
        index_in_ranges(self.ranges, character).or(self.replacement)
    }

    /// The glyph with an index.
    pub(in crate::draw) fn glyph(&self, index: u16) -> Option<&'static OutlineGlyph> {
        self.glyphs.get(usize::from(index))
    }

    /// Whether the contours of a glyph cross, overlap or touch.
    pub(super) fn is_crossing(&self, index: u16) -> bool {
        self.crossing.binary_search(&index).is_ok()
    }

    /// Font units from a glyph's pen position to that of the glyph that follows, `None` for the last one; 16 bits with sign.
    pub(super) fn step(&self, index: u16, following: Option<u16>) -> i32 {
        let advance = self.glyph(index).map_or(0, |glyph| i32::from(glyph.advance));
        let kerning = following.map_or(0, |following| kerning_between(self.kerning, index, following));
        // Not `clamp`, which contains a panic for an empty range.
        (advance + kerning).min(i16::MAX.into()).max(i16::MIN.into())
    }

    /// The point with an index; `None` behind the last one.
    #[inline(always)]
    pub(super) fn point(&self, index: usize) -> Option<OutlinePoint> {
        let [x, y] = match self.small_points.get(index) {
            Some(point) => point.map(i32::from),
            None if self.small_points.is_empty() => self.points.get(index)?.map(i32::from),
            None => return None,
        };
        let flags = self.flags.get(index / 4)? >> (2 * (index & 3));
        Some(OutlinePoint {
            position: [2 * x, 2 * y],
            is_on_contour: flags & 1 != 0,
            is_last: flags & 2 != 0,
        })
    }
}

impl fmt::Debug for OutlineFont {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("OutlineFont")
            .field("glyphs", &self.glyphs.len())
            .field("units_per_em", &self.units_per_em)
            .finish_non_exhaustive()
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for OutlineFont {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(
            formatter,
            "OutlineFont of {} glyphs, {} units per em",
            self.glyphs.len(),
            self.units_per_em
        );
    }
}
