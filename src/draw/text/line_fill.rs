//! What a line of text has beside its glyphs: the rows of its background and those of its decorations, in whole pixels.

use embedded_graphics::text::DecorationColor;

use crate::{
    draw::{
        eg::text::fill,
        text::line::{Line, LineFont, LineStyle},
    },
    geometry::Window,
    surface::Target,
};

/// The columns of a line that are filled, its first one and the one behind its last; none where nothing but glyphs is drawn, so
/// that no glyph has to be read.
pub(super) fn columns(style: &impl LineStyle, line: &Line<'_>) -> (i64, i64) {
    let [underline, strikethrough] = style.decoration_colors();
    let has_decorations = !matches!(
        (underline, strikethrough),
        (DecorationColor::None, DecorationColor::None)
    );
    let end = if has_decorations || style.background_color().is_some() {
        line.columns(style.font()).next
    } else {
        line.left
    };
    (line.left, end)
}

/// Fills the visible part of the background of some columns of a line whose first row is `top`.
pub(super) fn draw_background<T: Target>(
    target: &mut T,
    window: &Window,
    style: &impl LineStyle<Color = T::Color>,
    columns: (i64, i64),
    top: i64,
) -> Result<(), T::Error> {
    let Some(color) = style.background_color() else {
        return Ok(());
    };
    let rows = (top, top + style.font().rows());
    fill(target, window, columns, rows, color)
}

/// Fills the visible part of the decorations of some columns of a line whose first row is `top`.
pub(super) fn draw_decorations<T: Target>(
    target: &mut T,
    window: &Window,
    style: &impl LineStyle<Color = T::Color>,
    columns: (i64, i64),
    top: i64,
) -> Result<(), T::Error> {
    for (dimensions, color) in style.decorations().into_iter().flatten() {
        let first = top + i64::from(dimensions.offset);
        let rows = (first, first + i64::from(dimensions.height));
        fill(target, window, columns, rows, color)?;
    }
    Ok(())
}
