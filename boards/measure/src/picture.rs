//! Pictures drawn through one row, for the memory they take.

use core::hint::black_box;

use embedded_graphics::{
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Line, Rectangle},
};
use zrow::{
    band::{Band, PictureLoop},
    draw::{DrawOn, PrimitiveStyle},
};

use crate::run::Checksum;

/// Columns of the 2D picture.
pub const WIDTH: usize = 240;
/// The 2D picture.
pub const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(WIDTH as u32, 320));

/// Draws every 2D shape through one row; returns the checksum of all rows.
#[inline(never)]
pub fn shapes(row: &mut [u16]) -> u32 {
    let center = black_box(Point::new(120, 160));
    let line = Line::new(center - Point::new(100, 90), center + Point::new(110, 70))
        .into_styled(PrimitiveStyle::with_stroke(Rgb565::CSS_ORANGE, 1));
    let mut sum = Checksum::default();
    let mut sink = |band: Band<'_, Rgb565>| -> Result<(), core::convert::Infallible> {
        sum.add(black_box(band.words()).iter().copied());
        Ok(())
    };
    let drawn = PictureLoop::new(AREA, Rgb565::BLACK).draw(row, &mut sink, |band: &mut Band<'_, Rgb565>| {
        let Ok(()) = line.draw_on(band);
    });
    if drawn.is_ok() { sum.0 } else { 0 }
}
