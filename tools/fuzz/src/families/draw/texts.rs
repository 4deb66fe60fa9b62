//! Texts in fonts of coverage masks: on bands, and by embedded-graphics' renderer on a display.

use anyhow::Context;
use arbitrary::Arbitrary;
use embedded_graphics::{geometry::Dimensions, mono_font::DecorationDimensions, pixelcolor::Rgb565, text::Text};
use zrow::{
    band::{Band, Order},
    draw::{BlendOn, MaskFont, MaskGlyph, MaskTextStyle, Picture, PictureSlot},
};

use crate::{
    families::draw::text_look::TextLook,
    picture::{OnBand, agree_on_bands, background, is_same},
    target::{Case, Verdict},
};

/// Glyphs whose tables hold what they should not: ranges that overlap, masks and pairs that are not there.
static ODD: MaskFont = MaskFont {
    ranges: &[('a', 4, 0), ('c', u16::MAX, u16::MAX - 1)],
    glyphs: &[
        glyph(0, (-2, 1), (7, 5), 93),
        glyph(3, (120, -3), (255, 255), u16::MAX),
        glyph(u32::MAX, (0, 2), (9, 9), 0),
        glyph(12, (i16::MIN, 0), (200, 3), 16),
    ],
    coverage: &[
        0x12, 0x34, 0x50, 0x0f, 0xff, 0xf0, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0x00, 0x08, 0x80, 0x70, 0x01, 0x10,
    ],
    kerning: &[(1, 0, i16::MIN), (0, 9, i16::MAX)],
    height: 9,
    baseline: 700,
    line_height: 3,
    underline: DecorationDimensions::new(4, 90),
    strikethrough: DecorationDimensions::new(u32::MAX, u32::MAX),
    replacement: Some(1),
};

/// Two glyphs as a converter writes them.
static EVEN: MaskFont = MaskFont {
    ranges: &[('a', 2, 0)],
    glyphs: &[glyph(0, (0, 1), (5, 3), 5 * 16), glyph(9, (-1, 0), (2, 4), 23)],
    coverage: &[
        0xff, 0x83, 0x10, 0x0c, 0xc0, 0x00, 0xff, 0xff, 0xf0, 0x4f, 0xf4, 0xf4, 0x4f,
    ],
    kerning: &[(0, 1, -20)],
    height: 5,
    baseline: 3,
    line_height: 6,
    underline: DecorationDimensions::new(4, 1),
    strikethrough: DecorationDimensions::new(2, 1),
    replacement: None,
};

const fn glyph(offset: u32, (left, top): (i16, i16), (width, height): (u8, u8), advance: u16) -> MaskGlyph {
    MaskGlyph {
        offset,
        left,
        top,
        width,
        height,
        advance,
    }
}

/// A text and its font.
#[derive(Debug, Arbitrary)]
pub struct MaskTextCase {
    look: TextLook,
    is_odd: bool,
}

impl OnBand for Text<'_, MaskTextStyle<Rgb565>> {
    fn draw_on_band<O: Order>(&self, band: &mut Band<'_, Rgb565, O>) -> Verdict {
        let Ok(()) = self.draw_on(band);
        Ok(())
    }
}

/// A text in a picture of its own.
struct Prepared<'p, 't>(&'p Text<'t, MaskTextStyle<Rgb565>>);

impl OnBand for Prepared<'_, '_> {
    fn draw_on_band<O: Order>(&self, band: &mut Band<'_, Rgb565, O>) -> Verdict {
        let (mut slots, mut pool) = ([PictureSlot::EMPTY; 1], [0; 80]);
        let mut picture = Picture::<Rgb565, O>::new(band.bounding_box(), &mut slots, &mut pool, &mut []);
        picture.add(self.0)?;
        picture.draw(band);
        Ok(())
    }
}

impl Case for MaskTextCase {
    fn check(&self) -> Verdict {
        let characters = self.look.characters();
        let font = if self.is_odd { &ODD } else { &EVEN };
        let text = self.look.text(&characters, MaskTextStyle::new(font, background()));
        let stage = &self.look.stage;
        let replayed = agree_on_bands(stage, &text)?;
        if self.look.is_in_a_picture() {
            let prepared = agree_on_bands(stage, &Prepared(&text)).context("prepared")?;
            is_same(&stage.window, &replayed, &prepared).context("replayed, the other prepared")?;
        }
        self.look.check_renderer(&text)
    }
}
