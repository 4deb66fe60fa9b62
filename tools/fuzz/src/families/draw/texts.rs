//! Texts in fonts of coverage masks: on bands, and by embedded-graphics' renderer on a display.

use anyhow::{Context, bail, ensure};
use arbitrary::Arbitrary;
use embedded_graphics::{
    geometry::Dimensions,
    mono_font::DecorationDimensions,
    pixelcolor::Rgb565,
    text::{
        Alignment, Baseline, DecorationColor, LineHeight, Text, TextStyleBuilder,
        renderer::{CharacterStyle, TextRenderer},
    },
};
use zrow::{
    band::{Band, Generic, Order},
    draw::{BlendOn, MaskFont, MaskGlyph, MaskTextStyle, Picture, PictureSlot},
    geometry::Window,
};

use crate::{
    picture::{OnBand, Sheet, agree_on_bands, background, is_same},
    target::{Case, Verdict},
    values::{Hue, Length, List, Spot, Stage},
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

/// A text, its style and its layout.
#[derive(Debug, Arbitrary)]
pub struct MaskTextCase {
    stage: Stage,
    is_odd: bool,
    characters: List<u8, 12>,
    position: Spot,
    text: Option<Hue>,
    background: Option<Hue>,
    underline: Option<Option<Hue>>,
    strikethrough: Option<Option<Hue>>,
    layout: (u8, u8),
    line_height: (bool, Length),
}

impl MaskTextCase {
    fn characters(&self) -> String {
        const CHARACTERS: [char; 8] = ['a', 'b', 'c', 'd', '\n', '\r', ' ', '\u{10ffff}'];
        let list = self.characters.0.iter();
        list.map(|number| CHARACTERS[usize::from(number % 8)]).collect()
    }

    fn style(&self) -> MaskTextStyle<Rgb565> {
        let decoration = |color: Option<Option<Hue>>| match color {
            None => DecorationColor::None,
            Some(None) => DecorationColor::TextColor,
            Some(Some(hue)) => DecorationColor::Custom(hue.color()),
        };
        let font = if self.is_odd { &ODD } else { &EVEN };
        let mut style = MaskTextStyle::new(font, background());
        style.set_text_color(self.text.map(|hue| hue.color()));
        style.set_background_color(self.background.map(|hue| hue.color()));
        style.set_underline_color(decoration(self.underline));
        style.set_strikethrough_color(decoration(self.strikethrough));
        style
    }

    /// Whether a picture, whose columns and rows have 16 bits, shows the whole window.
    fn is_in_a_picture(&self) -> bool {
        let drawn = i32::from(i16::MIN)..i32::from(i16::MAX);
        let Window {
            left,
            top,
            right,
            bottom,
        } = self.stage.window;
        [left, top, right, bottom].iter().all(|side| drawn.contains(side))
    }

    fn text<'t>(&self, characters: &'t str) -> Text<'t, MaskTextStyle<Rgb565>> {
        let (alignment, baseline) = self.layout;
        let alignments = [Alignment::Left, Alignment::Center, Alignment::Right];
        let baselines = [Baseline::Top, Baseline::Bottom, Baseline::Middle, Baseline::Alphabetic];
        let (in_pixels, Length(number)) = self.line_height;
        let layout = TextStyleBuilder::new()
            .alignment(alignments[usize::from(alignment) % 3])
            .baseline(baselines[usize::from(baseline) % 4])
            .line_height(if in_pixels {
                LineHeight::Pixels(number)
            } else {
                LineHeight::Percent(number)
            })
            .build();
        Text::with_text_style(characters, self.stage.point(self.position), self.style(), layout)
    }
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
        let characters = self.characters();
        let text = self.text(&characters);
        let replayed = agree_on_bands(&self.stage, &text)?;
        if self.is_in_a_picture() {
            let prepared = agree_on_bands(&self.stage, &Prepared(&text)).context("prepared")?;
            is_same(&self.stage.window, &replayed, &prepared).context("replayed, the other prepared")?;
        }
        // `Text` itself adds positions and overflows where they are far, so its renderer is called.
        let (style, position) = (text.character_style, text.position);
        let mut sheet = Sheet::new(self.stage.window, background());
        let display = &mut Generic(&mut sheet);
        let Ok(next) = style.draw_string(&characters, position, text.text_style.baseline, display) else {
            bail!("a display that takes all calls failed");
        };
        let Length(width) = self.line_height.1;
        let Ok(_) = style.draw_whitespace(width, position, text.text_style.baseline, display) else {
            bail!("a display that takes all calls failed");
        };
        let metrics = style.measure_string(&characters, position, text.text_style.baseline);
        ensure!(metrics.next_position == next, "{metrics:?}, but drawn up to {next}");
        sheet.was_treated_well().context("on a display")
    }
}
