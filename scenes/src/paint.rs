//! Shorthand for what every scene does: a shape, a label, a colour.

use core::convert::Infallible;

use embedded_graphics::{
    mono_font::{MonoFont, MonoTextStyle, ascii::FONT_6X10},
    pixelcolor::Rgb565,
    prelude::*,
    text::{Alignment, Baseline, Text, TextStyleBuilder},
};
use zrow::{
    band::{Band, BandColor, Order, Target},
    draw::DrawOn,
};

use crate::Scene;

/// Titles and column heads.
pub const TITLE_COLOR: Rgb565 = rgb(255, 255, 255);

/// Draws a shape on a target that cannot fail.
pub fn shape<T, D>(target: &mut T, drawable: &D)
where
    T: Target<Error = Infallible>,
    D: DrawOn<Color = T::Color>,
{
    let Ok(()) = drawable.draw_on(target);
}

/// Draws text that hangs from a point: left of it, right of it or about it.
pub fn label<C: BandColor, O: Order>(
    band: &mut Band<'_, C, O>,
    text: &str,
    at: Point,
    alignment: Alignment,
    font: &MonoFont<'_>,
    color: C,
) {
    let Ok(()) = hanging(text, at, alignment, font, color).draw_on(band);
}

/// Text that hangs from a point: left of it, right of it or about it.
pub fn hanging<'t, 'f, C: BandColor>(
    text: &'t str,
    at: Point,
    alignment: Alignment,
    font: &'f MonoFont<'f>,
    color: C,
) -> Text<'t, MonoTextStyle<'f, C>> {
    let style = TextStyleBuilder::new()
        .alignment(alignment)
        .baseline(Baseline::Top)
        .build();
    Text::with_text_style(text, at, MonoTextStyle::new(font, color), style)
}

/// The title of a scene, in the middle of its first row.
pub fn title<S: Scene<Color = Rgb565>, O: Order>(band: &mut Band<'_, Rgb565, O>) {
    label(
        band,
        S::TITLE,
        Point::new(160, 4),
        Alignment::Center,
        &FONT_6X10,
        TITLE_COLOR,
    );
}

/// The colour nearest to red, green and blue of 8 bits each.
pub const fn rgb(red: u8, green: u8, blue: u8) -> Rgb565 {
    Rgb565::new(red >> 3, green >> 2, blue >> 3)
}
