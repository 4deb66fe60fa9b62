//! The style of text in a font of outlines, as embedded-graphics' `Text` takes it.

use embedded_graphics::{
    pixelcolor::PixelColor,
    text::{DecorationColor, renderer::CharacterStyle},
};
use fixed::types::U24F8;

use crate::draw::text::{OutlineFont, line::LineStyle, sized_font::SizedFont};

/// Text in an [`OutlineFont`] of any size: for `Text` and everything else that takes embedded-graphics' `TextRenderer`.
///
/// On a band with memory for antialiasing, [`DrawAntialiased::draw_on`](crate::draw::DrawAntialiased::draw_on) blends a text over
/// whatever is there, by the exact area of each pixel; in a [`Picture`](crate::draw::Picture) it is an item that takes a word a
/// glyph. Glyphs begin at any 1/256 pixel, lines and decorations at whole pixels.
///
/// `Text::draw` draws on every `DrawTarget`: with a background colour it fills the line's rows, and blends the glyphs against
/// that colour; without one it draws the pixels that are covered to half at least, because what is below them is not known. It
/// takes 5 KB of the stack, and leaves out those rows of a glyph in which that has more than 64 edges.
///
/// ```
/// # use zrow::draw::{OutlineFont, OutlineGlyph};
/// # static FONT: OutlineFont = OutlineFont {
/// #     units_per_em: 10, ranges: &[('-', 1, 0)],
/// #     glyphs: &[OutlineGlyph { first: 0, points: 4, advance: 10, left: 1, bottom: 0, right: 9, top: 5 }],
/// #     small_points: &[[1, 0], [9, 0], [9, 5], [1, 5]], points: &[], flags: &[0b11_01_01_01], crossing: &[], kerning: &[],
/// #     ascent: 5, descent: 0, line_height: 10, underline: (1, 1), strikethrough: (-3, 1), replacement: None,
/// # };
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray8, prelude::*, text::Text};
/// use zrow::{draw::OutlineTextStyle, fixed::types::U24F8};
///
/// let mut display = MockDisplay::new();
/// let style = OutlineTextStyle::new(&FONT, U24F8::from_num(2.5), Gray8::WHITE).on_background(Gray8::new(60));
/// let next = Text::new("-", Point::new(0, 1), style).draw(&mut display)?;
/// assert_eq!(next, Point::new(3, 1));
/// // The dash begins in a quarter of the first column.
/// assert_eq!(display.get_pixel(Point::new(0, 1)), Some(Gray8::new(206)));
/// # Ok::<(), core::convert::Infallible>(())
/// ```
///
/// A target that cannot be read back has no memory for antialiasing, because nothing can be blended over what it shows:
///
/// ```compile_fail,E0308
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*, text::Text};
/// use zrow::draw::{DrawAntialiased, OutlineTextStyle};
///
/// fn draw(text: &Text<'_, OutlineTextStyle<Rgb565>>, display: &mut MockDisplay<Rgb565>) {
///     let result = text.draw_on::<MockDisplay<Rgb565>, 64, 16>(display);
/// }
/// ```
#[derive(Debug, Copy, Clone)]
#[non_exhaustive]
pub struct OutlineTextStyle<C> {
    /// The font.
    pub font: &'static OutlineFont,
    /// The side of the font's em square in pixels; more than 16,384 count as that.
    pub size: U24F8,
    /// The colour of the glyphs; `None` draws none.
    pub text_color: Option<C>,
    /// The colour of the line's rows behind the glyphs; `None` leaves what is there.
    pub background_color: Option<C>,
    /// The colour of the underline.
    pub underline_color: DecorationColor<C>,
    /// The colour of the line through the middle of letters.
    pub strikethrough_color: DecorationColor<C>,
}

impl<C: PixelColor> OutlineTextStyle<C> {
    /// Glyphs in a colour, without background and decorations. The size is the side of the font's em square in pixels.
    pub const fn new(font: &'static OutlineFont, size: U24F8, text_color: C) -> Self {
        Self {
            font,
            size,
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

impl<C: PixelColor> LineStyle for OutlineTextStyle<C> {
    type Color = C;
    type Font = SizedFont<'static>;

    fn font(&self) -> SizedFont<'static> {
        SizedFont::new(self.font, self.size)
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

impl<C: PixelColor> CharacterStyle for OutlineTextStyle<C> {
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

#[cfg(feature = "defmt")]
impl<C> defmt::Format for OutlineTextStyle<C> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(
            formatter,
            "OutlineTextStyle of {}, {}/256 pixel",
            self.font,
            self.size.to_bits()
        );
    }
}
