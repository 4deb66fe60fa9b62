//! Draws lines in bands of one row and writes `target/line.png`: 240 words of memory for a picture of 240 x 160 pixels.
//!
//! `cargo run --release --example line`

use std::error::Error;

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Line};
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use zrow::{
    band::{DisplaySink, PictureLoop},
    draw::{DrawOn, PrimitiveStyle},
};

fn main() -> Result<(), Box<dyn Error>> {
    // On a microcontroller, this is the display's driver.
    let mut display = SimulatorDisplay::<Rgb565>::new(Size::new(240, 160));
    let mut row = [0; 240];
    PictureLoop::new(display.bounding_box(), Rgb565::CSS_MIDNIGHT_BLUE).draw(
        &mut row,
        &mut DisplaySink(&mut display),
        |band| {
            for step in 0..16 {
                // One end is far off the screen: what is not visible costs nothing.
                let line = Line::new(Point::new(20, 140), Point::new(1600, 600 - 160 * step));
                let style = PrimitiveStyle::with_stroke(Rgb565::CSS_GOLD, 1);
                let Ok(()) = line.into_styled(style).draw_on(band);
            }
            let style = PrimitiveStyle::with_stroke(Rgb565::CSS_TOMATO, 7);
            let Ok(()) = Line::new(Point::new(20, 20), Point::new(220, 50))
                .into_styled(style)
                .draw_on(band);
        },
    )?;
    let picture = display.to_rgb_output_image(&OutputSettings::default());
    picture.save_png("target/line.png")?;
    Ok(())
}
