//! "42 km/h" in fonts of several kinds, each drawn by the function of its name.

use core::hint::black_box;

use embedded_graphics::{
    Drawable,
    geometry::{Point, Size},
    mono_font::{MonoTextStyle, ascii::FONT_10X20},
    pixelcolor::{Rgb565, RgbColor},
    primitives::Rectangle,
    text::Text,
};
use fixed::types::U24F8;
use u8g2_fonts::{
    FontRenderer,
    fonts::u8g2_font_helvR18_tr,
    types::{FontColor, VerticalPosition},
};
use zrow::{
    band::Band,
    draw::{
        AntialiasingMemory, BlendOn, DrawAntialiased, DrawOn, MaskTextStyle, OutlineTextStyle, Picture, PictureSlot,
    },
};
use zrow_scenes::fonts::{DEJAVU_SANS_24, DEJAVU_SANS_OUTLINES};

use crate::report;

/// Columns of what is drawn into.
pub const WIDTH: usize = 160;
/// Rows of it.
pub const HEIGHT: usize = 32;
/// The text, which ends within these columns in every font.
const TEXT: &str = "42 km/h";

/// The baseline of the text.
fn position() -> Point {
    black_box(Point::new(8, 24))
}

fn outline_text() -> Text<'static, OutlineTextStyle<Rgb565>> {
    let style = OutlineTextStyle::new(
        &DEJAVU_SANS_OUTLINES,
        black_box(U24F8::const_from_int(24)),
        Rgb565::WHITE,
    );
    Text::new(black_box(TEXT), position(), style)
}

fn mask_text() -> Text<'static, MaskTextStyle<Rgb565>> {
    Text::new(
        black_box(TEXT),
        position(),
        MaskTextStyle::new(&DEJAVU_SANS_24, Rgb565::WHITE),
    )
}

fn mono_text() -> Text<'static, MonoTextStyle<'static, Rgb565>> {
    Text::new(
        black_box(TEXT),
        position(),
        MonoTextStyle::new(&FONT_10X20, Rgb565::WHITE),
    )
}

/// DejaVu Sans at 24 pixels, from its outlines.
pub fn outlines(band: &mut Band<'_, Rgb565>) {
    let mut cells = [0; WIDTH + 1];
    let drawn = outline_text().draw_on(&mut band.antialiased::<128, 48>(&mut cells));
    if drawn.is_err() {
        report::exit(false)
    }
}

/// DejaVu Sans at 24 pixels, from its masks of that size.
pub fn masks(band: &mut Band<'_, Rgb565>) {
    let Ok(()) = mask_text().draw_on(band);
}

/// embedded-graphics' font of 10 x 20 pixels, by zrow.
pub fn mono(band: &mut Band<'_, Rgb565>) {
    let Ok(()) = mono_text().draw_on(band);
}

/// embedded-graphics' font of 10 x 20 pixels, by its own renderer.
pub fn embedded_graphics(band: &mut Band<'_, Rgb565>) {
    let Ok(_) = mono_text().draw(band);
}

/// Helvetica at 18 points, whose capitals are 19 pixels high, by `u8g2-fonts`.
pub fn u8g2(band: &mut Band<'_, Rgb565>) {
    let renderer = FontRenderer::new::<u8g2_font_helvR18_tr>();
    let color = FontColor::Transparent(Rgb565::WHITE);
    let drawn = renderer.render(black_box(TEXT), position(), VerticalPosition::Baseline, color, band);
    if drawn.is_err() {
        report::exit(false)
    }
}

/// The memory of a picture of one text.
pub struct Memory {
    slots: [PictureSlot<'static, Rgb565>; 1],
    pool: [u32; 16],
    buckets: [u16; HEIGHT],
    antialiasing: AntialiasingMemory<{ WIDTH + 1 }, 48, 0>,
}

impl Memory {
    /// Memory without a picture.
    pub const fn new() -> Self {
        Self {
            slots: [PictureSlot::EMPTY; 1],
            pool: [0; 16],
            buckets: [0; HEIGHT],
            antialiasing: AntialiasingMemory::new(),
        }
    }

    fn picture(&mut self) -> Picture<'_, 'static, Rgb565> {
        let area = Rectangle::new(Point::zero(), Size::new(WIDTH as u32, HEIGHT as u32));
        Picture::new(area, &mut self.slots, &mut self.pool, &mut self.buckets).with_antialiasing(&mut self.antialiasing)
    }

    /// A picture of the text from outlines.
    pub fn outlines(&mut self) -> Picture<'_, 'static, Rgb565> {
        let mut picture = self.picture();
        if picture.add(&outline_text()).is_err() {
            report::exit(false)
        }
        picture
    }

    /// A picture of the text from masks.
    pub fn masks(&mut self) -> Picture<'_, 'static, Rgb565> {
        let mut picture = self.picture();
        if picture.add(&mask_text()).is_err() {
            report::exit(false)
        }
        picture
    }
}

impl Default for Memory {
    fn default() -> Self {
        Self::new()
    }
}
