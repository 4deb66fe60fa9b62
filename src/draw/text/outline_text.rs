//! embedded-graphics' `Text` in a font of outlines, blended over what a target holds.
//!
//! A text outside of the target's rows is left out after a comparison of rows. Of a line that meets them, each glyph that meets
//! the target is set up as a polygon, or walked along where the target has one row, and drawn by the exact area. Where two
//! glyphs overlap, the right one is blended over the left one.

use core::mem::discriminant;

use embedded_graphics::{
    geometry::Dimensions,
    pixelcolor::{Gray8, GrayColor},
    text::Text,
};

use crate::{
    band::Band,
    coverage::{AnyCoverage, CoverageMethod, RowSegment},
    draw::{
        AntialiasedPolygon, DrawAntialiased, FillRule, OutlineTextStyle,
        antialiased::{AntialiasedTarget, Layer, LayerSink, draw_error},
        outline::RowMemory,
        text::{
            glyph_outline::GlyphOutline,
            line::{Line, LineFont, LineStyle, Lines},
            line_fill,
            sized_font::SizedFont,
        },
    },
    geometry::{DrawError, InputError, TooSmall, Window},
    shade::{BlendTarget, ChannelColor},
    surface::Target,
};

/// Blends the text over what the target holds. Where that has one row of a glyph whose contours do not cross, the glyph takes no
/// memory but that of the row.
///
/// Cost in a band that the text does not meet: that of comparing rows, and of reading the text's bytes below its first line.
impl<C: ChannelColor> DrawAntialiased for Text<'_, OutlineTextStyle<C>> {
    type Color = C;

    fn layers(&self, layer: &mut LayerSink<'_, C>) -> Result<(), InputError> {
        let style = &self.character_style;
        let (font, Some(color)) = (style.font(), style.text_color) else {
            return Ok(());
        };
        for line in Lines::new(self).iter() {
            for glyph in font.placed(&line) {
                layer(&Layer::new(&glyph.outline()?, color))?;
            }
        }
        Ok(())
    }

    fn may_meet(&self, window: &Window) -> bool {
        !window.is_empty() && Lines::new(self).meet(window)
    }

    fn draw_on<T: BlendTarget<Color = C>, const EDGES: usize, const ACTIVE: usize>(
        &self,
        target: &mut AntialiasedTarget<'_, T, EDGES, ACTIVE>,
    ) -> Result<(), DrawError<T::Error>> {
        let window = target.window();
        let lines = Lines::new(self);
        if window.is_empty() || !lines.meet(&window) {
            return Ok(());
        }
        let needed = AnyCoverage::cells(window.width() as usize);
        if target.row_memory.len() < needed {
            return Err(DrawError::TooSmall(TooSmall::Cells(needed)));
        }
        let mut missing = None;
        for line in lines.visible(&window) {
            draw_line(target, &window, &self.character_style, &line, &mut missing)?;
        }
        missing.map_or(Ok(()), |missing| Err(DrawError::TooSmall(missing)))
    }
}

/// The part of a window that has the rows of a line, in which its glyphs are drawn.
fn rows_of(font: SizedFont<'_>, line: &Line<'_>, window: &Window) -> Window {
    let clip = |row: i64| row.min(window.bottom.into()).max(window.top.into()) as i32;
    Window {
        top: clip(line.top),
        bottom: clip(line.top + font.rows()),
        ..*window
    }
}

/// Draws the visible part of a line: its background, its glyphs, and its decorations. From the first glyph on for which there
/// is too little memory, none is drawn, and what all of them need is kept.
fn draw_line<T: BlendTarget, const EDGES: usize, const ACTIVE: usize>(
    AntialiasedTarget { target, row_memory }: &mut AntialiasedTarget<'_, T, EDGES, ACTIVE>,
    window: &Window,
    style: &OutlineTextStyle<T::Color>,
    line: &Line<'_>,
    missing: &mut Option<TooSmall>,
) -> Result<(), DrawError<T::Error>>
where
    T::Color: ChannelColor,
{
    let columns = line_fill::columns(style, line);
    line_fill::draw_background(*target, window, style, columns, line.top).map_err(DrawError::Target)?;
    if let Some(color) = style.text_color {
        let font = style.font();
        let rows = rows_of(font, line, window);
        for glyph in font.placed(line) {
            let visible = glyph.visible(&rows);
            if !visible.is_empty() {
                let outline = glyph.outline().map_err(draw_error)?;
                // A row of the line is not far from the baseline.
                let above_baseline = (line.top + font.baseline() - i64::from(visible.top)) as i32;
                let target = AntialiasedTarget::<_, EDGES, ACTIVE>::new(*target, row_memory);
                draw_glyph(target, &outline, color, (&visible, above_baseline), missing)?;
            }
        }
    }
    line_fill::draw_decorations(*target, window, style, columns, line.top).map_err(DrawError::Target)
}

/// Draws a glyph in the part of a window in which it lies, whose first row is so many rows above the baseline.
fn draw_glyph<T: BlendTarget, const EDGES: usize, const ACTIVE: usize>(
    AntialiasedTarget { target, row_memory }: AntialiasedTarget<'_, T, EDGES, ACTIVE>,
    outline: &GlyphOutline<'_>,
    color: T::Color,
    (visible, above_baseline): (&Window, i32),
    missing: &mut Option<TooSmall>,
) -> Result<(), DrawError<T::Error>> {
    if visible.height() == 1 && !outline.is_crossing && missing.is_none() {
        let units = outline.scale.half_units_in_row(above_baseline);
        let mut memory = RowMemory::of(row_memory, &mut []);
        let blended = outline.blend_row(target, color, &mut memory, &units, visible);
        return blended.map_err(DrawError::Target);
    }
    let mut polygon = AntialiasedPolygon::<EDGES, ACTIVE>::empty();
    match polygon.set_up(outline, FillRule::NonZero) {
        Ok(()) if missing.is_none() => polygon.draw_in(visible, &outline.method(), color, target, row_memory),
        Ok(()) => Ok(()),
        Err(InputError::TooSmall(error)) => {
            add_needed(missing, error);
            Ok(())
        }
        Err(error) => Err(draw_error(error)),
    }
}

/// Keeps how much of the memory is needed that was too small first.
#[cold]
fn add_needed(missing: &mut Option<TooSmall>, error: TooSmall) {
    match missing {
        None => *missing = Some(error),
        Some(missing) if discriminant(missing) == discriminant(&error) && missing.needed() < error.needed() => {
            *missing = error;
        }
        Some(_) => {}
    }
}

/// The most edges that a glyph may have in a row, of which [`draw_row`] keeps as many on the stack.
const MOST_EDGES: usize = 64;

/// The most columns of the band of [`draw_row`].
pub(super) const COLUMNS: usize = 64;

/// Draws the glyphs of a line in white on a band of one row and at most [`COLUMNS`] columns, those that have no more than
/// [`MOST_EDGES`] edges in it.
pub(super) fn draw_row(font: SizedFont<'_>, line: &Line<'_>, band: &mut Band<'_, Gray8>) {
    let (mut cells, mut segments) = ([0; COLUMNS + 1], [RowSegment::EMPTY; MOST_EDGES]);
    let mut memory = RowMemory::of(&mut cells, &mut segments);
    let window = rows_of(font, line, &band.bounding_box().into());
    // A row of the line is not far from the baseline.
    let above_baseline = line.top + font.baseline() - i64::from(window.top);
    let units = font.scale.half_units_in_row(above_baseline as i32);
    for glyph in font.placed(line) {
        let visible = glyph.visible(&window);
        let (false, Ok(outline)) = (visible.is_empty(), glyph.outline()) else {
            continue;
        };
        let Ok(()) = outline.blend_row(band, Gray8::WHITE, &mut memory, &units, &visible);
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::{
        geometry::Point,
        mock_display::MockDisplay,
        pixelcolor::Gray4,
        text::{Alignment, DecorationColor, TextStyleBuilder, renderer::CharacterStyle},
    };
    use fixed::types::U24F8;

    use super::*;
    use crate::draw::{OutlineFont, OutlineGlyph, pictures::blended};

    /// "l" and a "c" of which the right side is a curve, 8 units high; "lc" is kerned by -1 unit.
    static FONT: OutlineFont = OutlineFont {
        units_per_em: 8,
        ranges: &[('c', 1, 1), ('l', 1, 0)],
        glyphs: &[glyph(0, 4, 3, [0, 0, 2, 8]), glyph(4, 3, 9, [1, 0, 9, 8])],
        small_points: &[[0, 0], [2, 0], [2, 8], [0, 8], [1, 0], [1, 8], [9, 4]],
        points: &[],
        flags: &[0b11_01_01_01, 0b10_01_01],
        crossing: &[],
        kerning: &[(0, 1, -1)],
        ascent: 8,
        descent: 1,
        line_height: 10,
        underline: (0, 1),
        strikethrough: (-4, 1),
        replacement: None,
    };

    const fn glyph(first: u32, points: u16, advance: u16, [left, bottom, right, top]: [i16; 4]) -> OutlineGlyph {
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

    /// Draws text in bands of one row.
    fn drawn(text: &Text<'_, OutlineTextStyle<Gray4>>) -> MockDisplay<Gray4> {
        blended(|band| text.draw_on(&mut band.antialiased::<64, 16>(&mut [0; 64])).unwrap())
    }

    fn style(size: f32) -> OutlineTextStyle<Gray4> {
        OutlineTextStyle::new(&FONT, U24F8::from_num(size), Gray4::WHITE)
    }

    #[test]
    fn a_pixel_a_unit() {
        drawn(&Text::new("lc", Point::new(1, 8), style(8.0))).assert_pattern(&[
            "         ",
            " FF B3   ",
            " FF FF7  ",
            " FF FFF6 ",
            " FF FFFE ",
            " FF FFFE ",
            " FF FFF6 ",
            " FF FF7  ",
            " FF B3   ",
        ]);
    }

    #[test]
    fn one_pixel_and_a_quarter_a_unit() {
        drawn(&Text::new("lc", Point::new(0, 9), style(10.0))).assert_pattern(&[
            "FF8491    ",
            "FF84FE5   ",
            "FF84FFF7  ",
            "FF84FFFF4 ",
            "FF84FFFFA ",
            "FF84FFFFA ",
            "FF84FFFF4 ",
            "FF84FFF7  ",
            "FF84FE5   ",
            "FF8491    ",
        ]);
    }

    #[test]
    fn lines_aligned_to_the_right_with_a_background_and_decorations() {
        let mut style = style(4.0).on_background(Gray4::new(2));
        style.set_underline_color(DecorationColor::TextColor);
        style.set_strikethrough_color(DecorationColor::Custom(Gray4::new(7)));
        let layout = TextStyleBuilder::new().alignment(Alignment::Right).build();
        drawn(&Text::with_text_style("l\nlc", Point::new(7, 4), style, layout)).assert_pattern(&[
            "        ", "      F2", "      F2", "      77", "      F2", "      FF", "  F87222", "  F9F622", "  777777",
            "  F87222", "  FFFFFF",
        ]);
    }
}
