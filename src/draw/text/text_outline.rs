//! The outline of a whole text: the contours of all its glyphs, as a shape of its own.
//!
//! ```text
//!     .-.  . . .-.
//!     |-|  |/  | |     the glyphs' contours, one glyph after the other, line by line, where drawing the text puts them
//!     | |  |\  '-'
//! ```
//!
//! Guarantees: the corners are those that drawing the text finds in its rows. Where glyphs overlap, they are one shape: neither
//! is blended over the other. Cost: all curves are flattened each time that the edges are asked for.

use embedded_graphics::{pixelcolor::PixelColor, text::Text};

use crate::{
    draw::{
        OutlineTextStyle, SubOutline,
        text::{
            line::{LineStyle, Lines},
            sized_font::PlacedGlyph,
        },
    },
    geometry::{Sub8, SubPixel},
};

/// A corner of an outline: x and y in 1/256 pixel.
type Corner = [i32; 2];

/// An edge outside of the domain of [`Sub8`]: it stands for a glyph that leaves it.
const OUTSIDE: [Corner; 2] = [[Sub8::MAX_UNITS + 1, 0], [Sub8::MAX_UNITS + 1, 1]];

/// The glyphs of a text, as one shape: what takes an outline takes a text. Colours and decorations of its style count for nothing,
/// and what a glyph has above or below the rows of its line is part of it.
///
/// A [`Picture`](crate::draw::Picture) takes it as the clip path of a group, which shows what lies in the letters. It keeps the
/// outlines of all glyphs, flattened, and has to have room for the segments that a row has of all of them: "42 km/h" at 24 pixels
/// takes 1,512 bytes of the pool and 77 segments. A text that is only to be read is smaller as it is
/// ([`Picture::add`](crate::draw::Picture::add)).
///
/// ```
/// # use zrow::draw::{OutlineFont, OutlineGlyph};
/// # static FONT: OutlineFont = OutlineFont {
/// #     units_per_em: 10, ranges: &[('-', 1, 0)],
/// #     glyphs: &[OutlineGlyph { first: 0, points: 4, advance: 10, left: 1, bottom: 0, right: 9, top: 5 }],
/// #     small_points: &[[1, 0], [9, 0], [9, 5], [1, 5]], points: &[], flags: &[0b11_01_01_01], crossing: &[], kerning: &[],
/// #     ascent: 5, descent: 0, line_height: 10, underline: (1, 1), strikethrough: (-3, 1), replacement: None,
/// # };
/// use embedded_graphics::{pixelcolor::Gray8, prelude::*, primitives::Rectangle, text::Text};
/// use zrow::{
///     band::Band,
///     draw::{AntialiasingMemory, FillRule, Group, OutlineTextStyle, Picture, PictureSlot, PrimitiveStyle},
///     fixed::types::U24F8,
/// };
///
/// let text = Text::new("--", Point::zero(), OutlineTextStyle::new(&FONT, U24F8::from_num(2.5), Gray8::WHITE));
///
/// let area = Rectangle::new(Point::zero(), Size::new(5, 1));
/// let (mut slots, mut pool, mut kept, mut words) = ([PictureSlot::EMPTY; 3], [0; 40], [0; 5], [0; 5]);
/// let mut memory = AntialiasingMemory::<6, 4, 4>::new();
/// let mut picture = Picture::new(area, &mut slots, &mut pool, &mut [])
///     .with_antialiasing(&mut memory)
///     .with_group_rows(&mut kept);
/// picture.begin_path_group(Group::new(), &text, FillRule::NonZero)?;
/// picture.add(&area.into_styled(PrimitiveStyle::with_fill(Gray8::WHITE)))?;
/// picture.end_group()?;
/// picture.draw(&mut Band::<Gray8>::new(area, &mut words)?);
/// // From 0.25 to 2.25 and from 2.75 to 4.75 columns: the third one has a quarter of each dash.
/// assert_eq!(words, [191, 255, 128, 255, 191]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
impl<C: PixelColor> SubOutline for Text<'_, OutlineTextStyle<C>> {
    fn edges(&self, edge: &mut dyn FnMut(Corner, Corner)) {
        for_each_glyph(self, |glyph| match glyph.outline() {
            Ok(outline) => outline.edges(edge),
            Err(_) => {
                let [from, to] = OUTSIDE;
                edge(from, to);
            }
        });
    }

    /// The middle of the box around all glyphs.
    fn anchor(&self) -> Option<Corner> {
        let mut around: Option<GlyphBox> = None;
        for_each_glyph(self, |glyph| {
            let glyph = GlyphBox::of(glyph);
            around = Some(around.map_or(glyph, |around| around.joined(&glyph)));
        });
        around.map(|around| around.middle())
    }

    /// Signed area is exact where no glyph's contours cross and no two glyphs' boxes overlap.
    fn is_simple(&self) -> bool {
        let font = self.character_style.font();
        let (mut above, mut is_simple) = (i64::MIN, true);
        for line in Lines::new(self).iter() {
            let (mut right, mut bottom) = (i64::MIN, above);
            for glyph in font.placed(&line) {
                let GlyphBox { x, y } = GlyphBox::of(&glyph);
                is_simple &= !glyph.is_crossing() && right <= x[0] && above <= y[0];
                (right, bottom) = (x[1], bottom.max(y[1]));
            }
            above = bottom;
        }
        is_simple
    }
}

/// Calls with each glyph that has an outline, from left to right and from line to line.
fn for_each_glyph<C: PixelColor>(text: &Text<'_, OutlineTextStyle<C>>, mut call: impl FnMut(&PlacedGlyph<'_>)) {
    let font = text.character_style.font();
    for line in Lines::new(text).iter() {
        for glyph in font.placed(&line) {
            call(&glyph);
        }
    }
}

/// The box around glyphs: its sides from left to right and from top to bottom, in 1/256 pixel from the corner of pixel (0, 0).
#[derive(Debug, Copy, Clone)]
struct GlyphBox {
    x: [i64; 2],
    y: [i64; 2],
}

impl GlyphBox {
    fn of(glyph: &PlacedGlyph<'_>) -> Self {
        Self {
            x: glyph.sides(),
            y: glyph.heights(),
        }
    }

    fn joined(&self, other: &Self) -> Self {
        let join = |one: [i64; 2], other: [i64; 2]| [one[0].min(other[0]), one[1].max(other[1])];
        Self {
            x: join(self.x, other.x),
            y: join(self.y, other.y),
        }
    }

    /// The middle, in 1/256 pixel from the centre of pixel (0, 0); anywhere for glyphs that are outside of every domain.
    fn middle(&self) -> Corner {
        [self.x, self.y].map(|[start, end]| ((start + end) / 2 - 128) as i32)
    }
}
