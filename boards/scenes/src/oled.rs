//! The scene of the 128 x 64 OLED in 16 greys.

use embedded_graphics::{
    mono_font::{MonoTextStyle, ascii::FONT_6X10},
    pixelcolor::Gray4,
    prelude::*,
    primitives::{Line, Rectangle},
    text::{Baseline, Text},
};
use zrow::{
    band::Band,
    draw::{DrawOn, PrimitiveStyle},
    target::Order,
};

use crate::{PrepareError, Scene};

/// The whole panel.
pub const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(128, 64));
/// Frames of one turn of the animation.
pub const FRAMES: u32 = 64;

/// The scene and what it keeps from frame to frame.
#[derive(Debug, Default)]
pub struct Oled {
    frame: u32,
}

impl Scene for Oled {
    type Color = Gray4;
    const NAME: &'static str = "oled";
    const TITLE: &'static str = "OLED in 16 greys";
    const AREA: Rectangle = AREA;
    const BACKGROUND: Gray4 = Gray4::BLACK;
    const FRAMES: u32 = FRAMES;

    fn prepare(&mut self, frame: u32) -> Result<(), PrepareError> {
        self.frame = frame % FRAMES;
        Ok(())
    }

    fn draw<O: Order>(&mut self, band: &mut Band<'_, Gray4, O>) {
        let travel = 2 * self.frame as i32;
        for (index, shade) in (1..16).enumerate() {
            let step = 4 * index as i32;
            let line = Line::new(Point::new(travel - 20, step), Point::new(127 - travel + step, 63));
            let Ok(()) = line
                .into_styled(PrimitiveStyle::with_stroke(Gray4::new(shade), 1))
                .draw_on(band);
        }
        let style = MonoTextStyle::new(&FONT_6X10, Gray4::WHITE);
        band.draw(&Text::with_baseline(
            "zrow",
            Point::new(travel, 27),
            style,
            Baseline::Top,
        ));
    }
}
