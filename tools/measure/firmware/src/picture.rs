//! Pictures drawn through one row, for the memory they take.

use core::hint::black_box;

use embedded_graphics::{
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Circle, Ellipse, Line, PrimitiveStyleBuilder, Rectangle, Triangle},
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

/// Draws the basic 2D shapes through one row; returns the checksum of all rows.
#[inline(never)]
pub fn shapes(row: &mut [u16]) -> u32 {
    let center = black_box(Point::new(120, 160));
    let wide = PrimitiveStyleBuilder::new()
        .stroke_color(Rgb565::CSS_WHITE)
        .stroke_width(3)
        .fill_color(Rgb565::CSS_NAVY);
    let thin = PrimitiveStyle::from(wide.stroke_width(1).build());
    let wide = PrimitiveStyle::from(wide.build());
    let corner = |x, y| center + Point::new(x, y);
    let line = Line::new(corner(-100, -90), corner(110, 70)).into_styled(thin);
    let rectangle = Rectangle::with_center(corner(-50, 60), Size::new(100, 70)).into_styled(wide);
    let circle = Circle::with_center(corner(30, -60), 101).into_styled(wide);
    let ellipse = Ellipse::with_center(corner(60, 80), Size::new(120, 80)).into_styled(wide);
    let triangle = Triangle::new(corner(-90, -20), corner(-20, -140), corner(10, 30)).into_styled(thin);
    through_one_row(row, |band| {
        let Ok(()) = rectangle.draw_on(band);
        let Ok(()) = circle.draw_on(band);
        let Ok(()) = ellipse.draw_on(band);
        let Ok(()) = triangle.draw_on(band);
        let Ok(()) = line.draw_on(band);
    })
}

/// Draws a picture through one row; returns the checksum of all rows.
#[inline(always)]
pub fn through_one_row(row: &mut [u16], mut draw: impl FnMut(&mut Band<'_, Rgb565>)) -> u32 {
    let mut sum = Checksum::default();
    let mut sink = |band: Band<'_, Rgb565>| -> Result<(), core::convert::Infallible> {
        sum.add(black_box(band.words()).iter().copied());
        Ok(())
    };
    let drawn = PictureLoop::new(AREA, Rgb565::BLACK).draw(row, &mut sink, |band: &mut Band<'_, Rgb565>| draw(band));
    if drawn.is_ok() { sum.0 } else { 0 }
}
