//! Texts in fonts of outlines: on bands, from a picture, and by embedded-graphics' renderer on a display.

use anyhow::{Context, bail};
use arbitrary::Arbitrary;
use embedded_graphics::{geometry::Dimensions, pixelcolor::Rgb565, text::Text};
use zrow::{
    band::{Band, LittleEndian, Order},
    draw::{
        AntialiasingMemory, DrawAntialiased, FillRule, OutlineFont, OutlineGlyph, OutlineTextStyle, Picture,
        PictureSlot,
    },
    fixed::types::U24F8,
    geometry::DrawError,
};

use crate::{
    families::draw::text_look::TextLook,
    picture::{Canvas, OnBand, agree_on_bands, background, is_same},
    target::{Case, Verdict},
    values::{List, Number},
};

const EDGES: usize = 1_024;
const ACTIVE: usize = 128;

/// Glyphs whose tables hold what they should not: bounds that cut or are none, points, flags and pairs that are not there.
static ODD: OutlineFont = OutlineFont {
    units_per_em: 9,
    ranges: &[('a', 4, 0), ('c', u16::MAX, u16::MAX - 1)],
    glyphs: &[
        glyph((0, 7), 9, [0, 0, 9, 9]),
        glyph((3, u16::MAX), u16::MAX, [-40, -30, 90, 120]),
        glyph((u32::MAX, 3), 0, [i16::MIN, i16::MIN, i16::MAX, i16::MAX]),
        glyph((2, 9), 5, [4, 4, 3, 3]),
    ],
    small_points: &[],
    points: &[
        [0, 0],
        [90, 9],
        [i16::MAX, i16::MIN],
        [4, 5],
        [-30, 9],
        [7, 7],
        [7, -90],
        [0, 4],
        [i16::MIN, 2],
        [5, 5],
    ],
    flags: &[0b01_00_00_10, 0b00_11_00_01],
    crossing: &[1, 2],
    kerning: &[(1, 0, i16::MIN), (0, 9, i16::MAX)],
    ascent: 12,
    descent: u16::MAX,
    line_height: 3,
    underline: (i16::MAX, u16::MAX),
    strikethrough: (i16::MIN, 90),
    replacement: Some(1),
};

/// Two glyphs as a converter writes them.
static EVEN: OutlineFont = OutlineFont {
    units_per_em: 20,
    ranges: &[('a', 2, 0)],
    glyphs: &[glyph((0, 8), 12, [1, 0, 11, 10]), glyph((8, 4), 14, [-1, -3, 12, 15])],
    small_points: &[
        [1, 5],
        [1, 10],
        [11, 10],
        [11, 0],
        [1, 0],
        [4, 3],
        [8, 3],
        [6, 8],
        [-1, -3],
        [12, 1],
        [10, 15],
        [0, 6],
    ],
    points: &[],
    flags: &[0b00_00_00_01, 0b11_01_01_10, 0b10_01_00_01],
    crossing: &[],
    kerning: &[(0, 1, -3)],
    ascent: 15,
    descent: 3,
    line_height: 24,
    underline: (1, 1),
    strikethrough: (-6, 1),
    replacement: None,
};

const fn glyph((first, points): (u32, u16), advance: u16, [left, bottom, right, top]: [i16; 4]) -> OutlineGlyph {
    OutlineGlyph {
        first,
        points,
        advance,
        left,
        bottom,
        right,
        top,
    }
}

/// A font of any points.
#[derive(Debug, Arbitrary)]
struct AnyFont {
    units_per_em: Number<u16>,
    bounds: [Number<i16>; 4],
    points: List<[Number<i16>; 2], 12>,
    flags: List<u8, 4>,
}

/// Which font a text has.
#[derive(Debug, Arbitrary)]
enum Choice {
    Odd,
    Even,
    Any(AnyFont),
}

/// A text, its font and its size.
#[derive(Debug, Arbitrary)]
pub struct OutlineTextCase {
    look: TextLook,
    font: Choice,
    size: Number<u32>,
}

impl AnyFont {
    /// The font stays in memory: fonts are `static`.
    fn leak(&self) -> &'static OutlineFont {
        let [left, bottom, right, top] = self.bounds.map(|Number(side)| side);
        let points: Vec<[i16; 2]> = self
            .points
            .0
            .iter()
            .map(|point| point.map(|Number(axis)| axis))
            .collect();
        Box::leak(Box::new(OutlineFont {
            units_per_em: self.units_per_em.0,
            ranges: &[('a', 4, 0)],
            glyphs: vec![glyph((0, 12), 9, [left, bottom, right, top])].leak(),
            points: points.leak(),
            flags: self.flags.0.clone().leak(),
            replacement: Some(0),
            ..METRICS
        }))
    }
}

/// Metrics without glyphs.
const METRICS: OutlineFont = OutlineFont {
    units_per_em: 20,
    ranges: &[],
    glyphs: &[],
    small_points: &[],
    points: &[],
    flags: &[],
    crossing: &[],
    kerning: &[],
    ascent: 90,
    descent: 80,
    line_height: 24,
    underline: (1, 1),
    strikethrough: (-6, 1),
    replacement: None,
};

type OutlineText<'t> = Text<'t, OutlineTextStyle<Rgb565>>;

/// Draws on a band, with memory of its own.
fn draw<O: Order>(
    text: &OutlineText<'_>,
    band: &mut Band<'_, Rgb565, O>,
) -> Result<(), DrawError<core::convert::Infallible>> {
    let mut row = vec![0; zrow::band::Target::window(band).width() as usize + 1];
    text.draw_on(&mut band.antialiased::<EDGES, ACTIVE>(&mut row))
}

/// A text that is set up in each band.
struct Replayed<'p, 't>(&'p OutlineText<'t>);

impl OnBand for Replayed<'_, '_> {
    fn draw_on_band<O: Order>(&self, band: &mut Band<'_, Rgb565, O>) -> Verdict {
        match draw(self.0, band) {
            Ok(()) => Ok(()),
            Err(error) => bail!("{error}, where there is none in the whole window"),
        }
    }
}

/// A text in a picture of its own.
struct Prepared<'p, 't>(&'p OutlineText<'t>);

impl OnBand for Prepared<'_, '_> {
    fn draw_on_band<O: Order>(&self, band: &mut Band<'_, Rgb565, O>) -> Verdict {
        let (mut slots, mut pool) = ([PictureSlot::EMPTY; 1], [0; 80]);
        let mut memory = AntialiasingMemory::<33, 1_024, 1>::new();
        let mut picture = Picture::<Rgb565, O>::new(band.bounding_box(), &mut slots, &mut pool, &mut [])
            .with_antialiasing(&mut memory);
        picture.add(self.0)?;
        picture.draw(band);
        Ok(())
    }
}

/// A text as one outline, in a picture of its own.
struct Outline<'p, 't>(&'p OutlineText<'t>);

impl OnBand for Outline<'_, '_> {
    fn draw_on_band<O: Order>(&self, band: &mut Band<'_, Rgb565, O>) -> Verdict {
        let (mut slots, mut pool) = ([PictureSlot::EMPTY; 1], vec![0; 20_000]);
        let mut memory = AntialiasingMemory::<33, 2_048, 1>::new();
        let mut picture = Picture::<Rgb565, O>::new(band.bounding_box(), &mut slots, &mut pool, &mut [])
            .with_antialiasing(&mut memory);
        picture.add_outline(self.0, FillRule::NonZero, background())?;
        picture.draw(band);
        Ok(())
    }
}

impl Case for OutlineTextCase {
    fn check(&self) -> Verdict {
        let characters = self.look.characters();
        let font = match &self.font {
            Choice::Odd => &ODD,
            Choice::Even => &EVEN,
            Choice::Any(font) => font.leak(),
        };
        let style = OutlineTextStyle::new(font, U24F8::from_bits(self.size.0), background());
        let text = self.look.text(&characters, style);
        let stage = &self.look.stage;
        let mut result = Ok(());
        Canvas::new(stage.window).draw::<LittleEndian>(|band| {
            result = draw(&text, band);
            Ok(())
        })?;
        if result.is_ok() {
            let replayed = agree_on_bands(stage, &Replayed(&text))?;
            // A text of which a part is outside of the domain may be drawn where that is not seen, but not added.
            let prepared = Canvas::new(stage.window).draw::<LittleEndian>(|band| Prepared(&text).draw_on_band(band));
            if self.look.is_in_a_picture() && prepared.is_ok() {
                let prepared = agree_on_bands(stage, &Prepared(&text)).context("prepared")?;
                is_same(&stage.window, &replayed, &prepared).context("replayed, the other prepared")?;
            }
        }
        // Memory may be too small for it, and a part of it outside of the domain.
        let outline = Canvas::new(stage.window).draw::<LittleEndian>(|band| Outline(&text).draw_on_band(band));
        if outline.is_ok() {
            agree_on_bands(stage, &Outline(&text)).context("as an outline")?;
        }
        self.look.check_renderer(&text)
    }
}
