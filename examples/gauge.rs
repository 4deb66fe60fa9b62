//! Draws a gauge with smooth edges in bands of one row and writes `target/gauge.png`.
//!
//! `cargo run --release --example gauge`

use std::error::Error;

use embedded_graphics::{
    mono_font::{MonoTextStyle, ascii::FONT_10X20},
    pixelcolor::Rgb565,
    prelude::*,
    text::{Alignment, Text},
};
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use zrow::{
    band::{DisplaySink, PictureLoop},
    coverage::{CoverageMethod, SignedArea},
    draw::{AntialiasedPolygon, DrawOn, FillRule, SubArc},
    fixed::types::{U0F16, U24F8},
    geometry::{Sub8, SubPoint},
};

const WIDTH: usize = 240;

/// An arc of a ring from the lower left, over a part of a turn: at most 512 edges, 16 of them in a row.
fn arc(radii: [i32; 2], sweep: f32) -> Result<AntialiasedPolygon<512, 16>, Box<dyn Error>> {
    let centre = SubPoint::<Sub8>::from_units(120 * 256, 120 * 256)?;
    let (radii, start) = (radii.map(U24F8::from_num), U0F16::from_num(0.375));
    let arc = SubArc::new(centre, radii, start, U0F16::from_num(sweep))?;
    Ok(AntialiasedPolygon::prepare(&arc, FillRule::NonZero)?)
}

fn main() -> Result<(), Box<dyn Error>> {
    let (scale, value) = (arc([80, 100], 0.75)?, arc([84, 96], 0.5)?);
    let text = Text::with_alignment(
        "42 km/h",
        Point::new(120, 125),
        MonoTextStyle::new(&FONT_10X20, Rgb565::WHITE),
        Alignment::Center,
    );
    let mut display = SimulatorDisplay::<Rgb565>::new(Size::new(WIDTH as u32, 220));
    // Beside the row of colours, the exact area takes a row of its own.
    let (mut row, mut cells) = ([0; WIDTH], vec![0; SignedArea::cells(WIDTH)]);
    PictureLoop::new(display.bounding_box(), Rgb565::BLACK).draw(&mut row, &mut DisplaySink(&mut display), |band| {
        for (shape, color) in [(&scale, Rgb565::CSS_DIM_GRAY), (&value, Rgb565::CSS_LIME_GREEN)] {
            shape.draw(&SignedArea, color, band, &mut cells).unwrap();
        }
        let Ok(()) = text.draw_on(band);
    })?;
    display
        .to_rgb_output_image(&OutputSettings::default())
        .save_png("target/gauge.png")?;
    Ok(())
}
