//! A text with its colours and its layout, in any font, and what embedded-graphics' renderer makes of it on a display.

use anyhow::{Context, bail, ensure};
use arbitrary::Arbitrary;
use embedded_graphics::{
    pixelcolor::Rgb565,
    text::{
        Alignment, Baseline, DecorationColor, LineHeight, Text, TextStyleBuilder,
        renderer::{CharacterStyle, TextRenderer},
    },
};
use zrow::{band::Generic, geometry::Window};

use crate::{
    picture::{Sheet, background},
    target::Verdict,
    values::{Hue, Length, List, Spot, Stage},
};

/// A text, its colours and its layout.
#[derive(Debug, Arbitrary)]
pub struct TextLook {
    pub stage: Stage,
    characters: List<u8, 12>,
    position: Spot,
    text: Option<Hue>,
    background: Option<Hue>,
    underline: Option<Option<Hue>>,
    strikethrough: Option<Option<Hue>>,
    layout: (u8, u8),
    line_height: (bool, Length),
}

impl TextLook {
    pub fn characters(&self) -> String {
        const CHARACTERS: [char; 8] = ['a', 'b', 'c', 'd', '\n', '\r', ' ', '\u{10ffff}'];
        let list = self.characters.0.iter();
        list.map(|number| CHARACTERS[usize::from(number % 8)]).collect()
    }

    /// A style with the colours.
    fn colored<S: CharacterStyle<Color = Rgb565>>(&self, mut style: S) -> S {
        let decoration = |color: Option<Option<Hue>>| match color {
            None => DecorationColor::None,
            Some(None) => DecorationColor::TextColor,
            Some(Some(hue)) => DecorationColor::Custom(hue.color()),
        };
        style.set_text_color(self.text.map(|hue| hue.color()));
        style.set_background_color(self.background.map(|hue| hue.color()));
        style.set_underline_color(decoration(self.underline));
        style.set_strikethrough_color(decoration(self.strikethrough));
        style
    }

    /// Whether a picture, whose columns and rows have 16 bits, shows the whole window.
    pub fn is_in_a_picture(&self) -> bool {
        let drawn = i32::from(i16::MIN)..i32::from(i16::MAX);
        let Window {
            left,
            top,
            right,
            bottom,
        } = self.stage.window;
        [left, top, right, bottom].iter().all(|side| drawn.contains(side))
    }

    /// The text in a style, which gets the colours.
    pub fn text<'t, S: CharacterStyle<Color = Rgb565>>(&self, characters: &'t str, style: S) -> Text<'t, S> {
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
        let position = self.stage.point(self.position);
        Text::with_text_style(characters, position, self.colored(style), layout)
    }

    /// Draws by the style's renderer on a display.
    pub fn check_renderer(&self, text: &Text<'_, impl TextRenderer<Color = Rgb565>>) -> Verdict {
        // `Text` itself adds positions and overflows where they are far, so its renderer is called.
        let (style, position, baseline) = (&text.character_style, text.position, text.text_style.baseline);
        let mut sheet = Sheet::new(self.stage.window, background());
        let display = &mut Generic(&mut sheet);
        let Ok(next) = style.draw_string(text.text, position, baseline, display) else {
            bail!("a display that takes all calls failed");
        };
        let Length(width) = self.line_height.1;
        let Ok(_) = style.draw_whitespace(width, position, baseline, display) else {
            bail!("a display that takes all calls failed");
        };
        let metrics = style.measure_string(text.text, position, baseline);
        ensure!(metrics.next_position == next, "{metrics:?}, but drawn up to {next}");
        sheet.was_treated_well().context("on a display")
    }
}
