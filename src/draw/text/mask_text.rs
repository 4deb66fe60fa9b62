//! embedded-graphics' `Text` in a font of coverage masks, blended over what a target holds.
//!
//! A text outside of the target's rows is left out after a comparison of rows. Of a line that meets them, each glyph is
//! found and its visible rows are blended, one after the other; coverage counts in 15 levels, and each level is a
//! multiple of 17 as an alpha. Where two glyphs overlap, the right one is blended over the left one.

use embedded_graphics::text::Text;

use crate::{
    draw::{
        BlendOn,
        text::{Line, Lines, MaskFont, MaskTextStyle, blend_mask_row, line_fill, mask_font::columns_of},
    },
    geometry::Window,
    shade::{BlendTarget, ChannelColor},
};

/// Blends the text over what the target holds, where that is a band: with any background, on which embedded-graphics'
/// `draw` would have to be told the colour.
///
/// Cost in a row that the text does not meet: that of comparing rows, and of reading the text's bytes below its first
/// line.
impl<C: ChannelColor> BlendOn for Text<'_, MaskTextStyle<C>> {
    type Color = C;

    fn draw_on<B: BlendTarget<Color = C>>(&self, target: &mut B) -> Result<(), B::Error> {
        let window = target.window();
        let lines = Lines::new(self);
        if window.is_empty() || !lines.meet(&window) {
            return Ok(());
        }
        for line in lines.visible(&window) {
            draw_line(target, &window, &self.character_style, &line)?;
        }
        Ok(())
    }
}

/// Draws the visible part of a line: its background, its glyphs, and its decorations.
pub(super) fn draw_line<B: BlendTarget>(
    target: &mut B,
    window: &Window,
    style: &MaskTextStyle<B::Color>,
    line: &Line<'_>,
) -> Result<(), B::Error> {
    let columns = line_fill::columns(style, line);
    line_fill::draw_background(target, window, style, columns, line.top)?;
    if let Some(color) = style.text_color {
        draw_glyphs(target, window, style.font, line, color)?;
    }
    line_fill::draw_decorations(target, window, style, columns, line.top)
}

/// Blends the visible part of the glyphs of a line.
fn draw_glyphs<B: BlendTarget>(
    target: &mut B,
    window: &Window,
    font: &'static MaskFont,
    line: &Line<'_>,
    color: B::Color,
) -> Result<(), B::Error> {
    let (first, end) = (i64::from(window.top) - line.top, i64::from(window.bottom) - line.top);
    let (first, end) = (first.max(0), end.min(font.height.into()));
    for placed in line.glyphs(font) {
        let Some(glyph) = font.glyph(placed.index) else {
            continue;
        };
        let (left, right) = columns_of(glyph, line.left + placed.pen);
        if right <= i64::from(window.left) || left >= i64::from(window.right) {
            continue;
        }
        // At most 255 columns left of the window, or in it.
        let column = (left - i64::from(window.left)) as i32;
        let top = i64::from(glyph.top);
        for row in first.max(top)..end.min(top + i64::from(glyph.height)) {
            // The row is in the window, whose rows are 32-bit numbers.
            let y = (line.top + row) as i32;
            let mask = font.mask_from(glyph, (row - top) as usize);
            blend_mask_row(target, window, y, column, glyph.width, mask, color)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use embedded_graphics::{
        geometry::Point,
        mock_display::MockDisplay,
        mono_font::DecorationDimensions,
        pixelcolor::{Gray4, GrayColor},
        text::{Alignment, Baseline, DecorationColor, LineHeight, TextStyleBuilder},
    };

    use super::*;
    use crate::draw::{MaskGlyph, pictures::blended};

    /// "L" and "T" of 4 x 5 pixels, of which "LT" is kerned by -1.5 pixels and "TL" by -1; "." is the replacement.
    static FONT: MaskFont = MaskFont {
        ranges: &[('.', 1, 2), ('L', 1, 0), ('T', 1, 1)],
        glyphs: &[
            glyph(0, 0, 0, 4, 5, 5 * 16),
            glyph(10, 0, 0, 5, 5, 5 * 16 + 7),
            glyph(25, 1, 4, 1, 1, 2 * 16),
        ],
        coverage: &[
            0xf0, 0x00, 0xf0, 0x00, 0xf0, 0x00, 0xf0, 0x00, 0xff, 0xf8, // L
            0x8f, 0xff, 0x80, 0x00, 0xf0, 0x00, 0x00, 0xf0, 0x00, 0x00, 0xf0, 0x00, 0x00, 0xf0, 0x00, // T
            0xc0, // .
        ],
        kerning: &[(0, 1, -24), (1, 0, -16)],
        height: 6,
        baseline: 4,
        line_height: 7,
        underline: DecorationDimensions::new(6, 1),
        strikethrough: DecorationDimensions::new(2, 1),
        replacement: None,
    };

    const fn glyph(offset: u32, left: i16, top: i16, width: u8, height: u8, advance: u16) -> MaskGlyph {
        MaskGlyph {
            offset,
            left,
            top,
            width,
            height,
            advance,
        }
    }

    fn drawn(text: &Text<'_, MaskTextStyle<Gray4>>) -> MockDisplay<Gray4> {
        blended(|band| {
            let Ok(()) = text.draw_on(band);
        })
    }

    const WHITE: MaskTextStyle<Gray4> = MaskTextStyle::new(&FONT, Gray4::WHITE);

    /// "LT" is 3.5 pixels apart, which is rounded to 4, and "T." 5.4, which is rounded to 5.
    #[test]
    fn kerned_letters_stand_on_the_baseline() {
        drawn(&Text::new("LT.", Point::new(1, 5), WHITE)).assert_pattern(&[
            "             ",
            " F   8FFF8   ",
            " F     F     ",
            " F     F     ",
            " F     F     ",
            " FFF8  F   C ",
        ]);
    }

    /// What the font does not have takes no space, not even between letters that are kerned.
    #[test]
    fn unknown_characters_and_lines_aligned_to_the_right() {
        let style = TextStyleBuilder::new()
            .alignment(Alignment::Right)
            .baseline(Baseline::Top)
            .line_height(LineHeight::Pixels(6))
            .build();
        let text = Text::with_text_style("L?T\n\u{e4}L\r\n.", Point::new(9, 0), WHITE, style);
        drawn(&text).assert_pattern(&[
            " F   8FFF8",
            " F     F  ",
            " F     F  ",
            " F     F  ",
            " FFF8  F  ",
            "          ",
            "     F    ",
            "     F    ",
            "     F    ",
            "     F    ",
            "     FFF8 ",
        ]);
    }

    #[test]
    fn a_background_and_both_decorations() {
        let mut style = WHITE.on_background(Gray4::new(3));
        style.underline_color = DecorationColor::Custom(Gray4::new(9));
        style.strikethrough_color = DecorationColor::TextColor;
        drawn(&Text::new("L.", Point::new(1, 5), style)).assert_pattern(&[
            "        ", " F333333", " F333333", " FFFFFFF", " F333333", " FFF933D", " 3333333", " 9999999",
        ]);
    }
}
