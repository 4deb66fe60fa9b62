//! An antialiased gauge with a sparkline for an ST7789 of 240 x 240 pixels: each frame draws and sends only what changes.
//!
//! `cargo run --release --example gauge_st7789` plays it on a simulated display and writes `target/gauge_st7789.png`.

use std::{array::from_fn, error::Error, fmt::Debug, fmt::Write};

use embedded_graphics::primitives::{Arc, Polyline};
use embedded_graphics::text::{Alignment, Text};
use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use zrow::draw::{AntialiasingMemory, OutlineTextStyle, Picture, PictureSlot};
use zrow::{fixed::types::U24F8, geometry::InputError, geometry::Window, heapless::String, prelude::*};
// Made of a TrueType font by `cargo run --release -- font FILE.ttf --outlines --chars ' 0-9%'`.
use zrow_scenes::fonts::DEJAVU_SANS_OUTLINES;

/// Shows values from 0 to 100. `display` is a `mipidsi::Display` of the model `ST7789`, or any other `DrawTarget`.
fn show<D: DrawTarget<Color = Rgb565, Error: Debug>>(display: &mut D, values: &[i32]) -> Result<(), InputError> {
    let arc = |color, value: i32| {
        let (start, sweep) = (135.0.deg(), (2.7 * value as f32).deg());
        let style = PrimitiveStyle::with_stroke(color, 16).antialiased();
        Arc::with_center(Point::new(120, 108), 180, start, sweep).into_styled(style)
    };
    let font = OutlineTextStyle::new(&DEJAVU_SANS_OUTLINES, U24F8::from_num(44), Rgb565::WHITE);
    let line = PrimitiveStyle::with_stroke(Rgb565::CSS_GOLD, 2).antialiased();
    // All memory there is: items and their words, a bucket a row, rectangles that change, and the edges of a row.
    let (mut slots, mut pool, mut buckets) = ([PictureSlot::EMPTY; 4], [0; 600], [0; 240]);
    let (mut areas, mut edges) = ([Window::EMPTY; 16], AntialiasingMemory::<241, 64, 64>::new());
    let mut picture = Picture::new(display.bounding_box(), &mut slots, &mut pool, &mut buckets)
        .with_damage(&mut areas, (1, 1))
        .with_antialiasing(&mut edges);
    picture.add(&arc(Rgb565::new(4, 9, 6), 100))?;
    let lit = picture.add(&arc(Rgb565::CSS_DEEP_SKY_BLUE, 0))?;
    let number = picture.add(&Text::new("", Point::zero(), font))?;
    let sparkline = picture.add(&Polyline::new(&[]).into_styled(line))?;
    let (mut history, mut row) = ([0; 30], [0; 240]);
    for &value in values {
        history.rotate_left(1);
        history[29] = value;
        let points: [Point; 30] = from_fn(|n| Point::new(62 + 4 * n as i32, 236 - history[n] * 2 / 5));
        let mut text = String::<8>::new();
        write!(text, "{value} %").unwrap();
        let text = Text::with_alignment(&text, Point::new(120, 124), font, Alignment::Center);
        picture.replace(lit, &arc(Rgb565::CSS_DEEP_SKY_BLUE, value))?;
        picture.replace(number, &text)?;
        picture.replace(sparkline, &Polyline::new(&points).into_styled(line))?;
        while let Some(area) = picture.next_damage() {
            let (area, sink) = (PictureLoop::new(area, Rgb565::BLACK), &mut DisplaySink(display));
            area.draw(&mut row, sink, |band| picture.draw(band)).unwrap();
        }
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut display = SimulatorDisplay::<Rgb565>::new(Size::new(240, 240));
    let values: [i32; 64] = from_fn(|n| 40 + n as i32 / 2 + [0, 18, 25, 18, 0, -18, -25, -18][n % 8]);
    show(&mut display, &values)?;
    let image = display.to_rgb_output_image(&OutputSettings::default());
    Ok(image.save_png("target/gauge_st7789.png")?)
}
