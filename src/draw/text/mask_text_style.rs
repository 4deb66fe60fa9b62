//! The style of text in a font of coverage masks, as embedded-graphics' `Text` takes it.

use embedded_graphics::{
    pixelcolor::PixelColor,
    text::{DecorationColor, renderer::CharacterStyle},
};

use crate::draw::text::{MaskFont, line::LineStyle};

/// Text in a [`MaskFont`]: for `Text` and everything else that takes embedded-graphics' `TextRenderer`.
///
/// On a band, [`BlendOn::draw_on`](crate::draw::BlendOn::draw_on) blends a text over whatever is there, and is the
/// faster way. `Text::draw` draws on every `DrawTarget`: with a background colour it fills the line's rows, and blends
/// the glyphs against that colour; without one it draws the pixels that are covered to half at least, because what is
/// below them is not known.
///
/// ```
/// # use embedded_graphics::mono_font::DecorationDimensions;
/// # use zrow::draw::{MaskFont, MaskGlyph};
/// # static FONT: MaskFont = MaskFont {
/// #     ranges: &[('-', 1, 0)],
/// #     glyphs: &[MaskGlyph { offset: 0, left: 0, top: 0, width: 2, height: 1, advance: 2 * 16 }],
/// #     coverage: &[0xf5], kerning: &[], height: 1, baseline: 0, line_height: 1,
/// #     underline: DecorationDimensions::new(1, 1), strikethrough: DecorationDimensions::new(0, 1), replacement: None,
/// # };
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray8, prelude::*, text::Text};
/// use zrow::draw::MaskTextStyle;
///
/// let mut display = MockDisplay::new();
/// let style = MaskTextStyle::new(&FONT, Gray8::WHITE).on_background(Gray8::new(60));
/// let next = Text::new("-", Point::zero(), style).draw(&mut display)?;
/// assert_eq!(next, Point::new(2, 0));
/// assert_eq!(display.get_pixel(Point::new(1, 0)), Some(Gray8::new(60 + (255 - 60) / 3)));
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct MaskTextStyle<C> {
    /// The font.
    pub font: &'static MaskFont,
    /// The colour of the glyphs; `None` draws none.
    pub text_color: Option<C>,
    /// The colour of the line's rows behind the glyphs; `None` leaves what is there.
    pub background_color: Option<C>,
    /// The colour of the underline.
    pub underline_color: DecorationColor<C>,
    /// The colour of the line through the middle of letters.
    pub strikethrough_color: DecorationColor<C>,
}

impl<C: PixelColor> MaskTextStyle<C> {
    /// Glyphs in a colour, without background and decorations.
    pub const fn new(font: &'static MaskFont, text_color: C) -> Self {
        Self {
            font,
            text_color: Some(text_color),
            background_color: None,
            underline_color: DecorationColor::None,
            strikethrough_color: DecorationColor::None,
        }
    }

    /// This style with a background.
    #[must_use]
    pub const fn on_background(self, color: C) -> Self {
        Self {
            background_color: Some(color),
            ..self
        }
    }
}

impl<C: PixelColor> LineStyle for MaskTextStyle<C> {
    type Color = C;
    type Font = &'static MaskFont;

    fn font(&self) -> &'static MaskFont {
        self.font
    }

    fn text_color(&self) -> Option<C> {
        self.text_color
    }

    fn background_color(&self) -> Option<C> {
        self.background_color
    }

    fn decoration_colors(&self) -> [DecorationColor<C>; 2] {
        [self.underline_color, self.strikethrough_color]
    }
}

impl<C: PixelColor> CharacterStyle for MaskTextStyle<C> {
    type Color = C;

    fn set_text_color(&mut self, text_color: Option<C>) {
        self.text_color = text_color;
    }

    fn set_background_color(&mut self, background_color: Option<C>) {
        self.background_color = background_color;
    }

    fn set_underline_color(&mut self, underline_color: DecorationColor<C>) {
        self.underline_color = underline_color;
    }

    fn set_strikethrough_color(&mut self, strikethrough_color: DecorationColor<C>) {
        self.strikethrough_color = strikethrough_color;
    }
}
