//! The gauge with a sparkline of `gauge_st7789` on an SSD1306 of 128 x 64 pixels: a row and a page of 128 bytes each.
//!
//! `cargo run --release --example gauge_ssd1306` plays it on a simulated display and writes `target/gauge_ssd1306.png`.

use std::{array::from_fn, convert::Infallible, error::Error, fmt::Write};

use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_6X10};
use embedded_graphics::primitives::{Arc, Polyline, Rectangle};
use embedded_graphics::text::{Alignment, Text};
use embedded_graphics::{pixelcolor::BinaryColor, prelude::*};
use embedded_graphics_simulator::{BinaryColorTheme, OutputSettingsBuilder, SimulatorDisplay};
use zrow::band::{LoopError, Page, PagesSink};
use zrow::{heapless::String, prelude::*};

const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(128, 64));

/// Shows values from 0 to 100. With the crate `ssd1306`, a page of rows from `top` on is sent by
/// `display.set_draw_area((0, top), (128, top + 8))?; display.draw(page.bytes)`.
fn show<E>(mut send: impl FnMut(Page<'_>) -> Result<(), E>, values: &[i32]) -> Result<(), LoopError<E>> {
    let stroke = |width| PrimitiveStyle::with_stroke(BinaryColor::On, width);
    let arc = |value: i32| {
        let (start, sweep) = (135.0.deg(), (2.7 * value as f32).deg());
        Arc::with_center(Point::new(32, 34), 55, start, sweep)
    };
    let font = MonoTextStyle::new(&FONT_6X10, BinaryColor::On);
    let (mut history, mut row, mut page) = ([0; 30], [0; 128], [0; 128]);
    for &value in values {
        history.rotate_left(1);
        history[29] = value;
        let points: [Point; 30] = from_fn(|n| Point::new(68 + 2 * n as i32, 56 - history[n] / 2));
        let mut text = String::<8>::new();
        write!(text, "{value} %").unwrap();
        let text = Text::with_alignment(&text, Point::new(32, 37), font, Alignment::Center);
        // A new sink for each frame: it borrows the page.
        let mut sink = PagesSink::new(AREA, &mut page, &mut send)?;
        PictureLoop::new(AREA, BinaryColor::Off).draw(&mut row, &mut sink, |band| {
            let Ok(()) = arc(100).into_styled(stroke(1)).draw_on(band);
            let Ok(()) = arc(value).into_styled(stroke(7)).draw_on(band);
            let Ok(()) = Polyline::new(&points).into_styled(stroke(1)).draw_on(band);
            let Ok(()) = text.draw_on(band);
        })?;
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut display = SimulatorDisplay::<BinaryColor>::new(AREA.size);
    // The controller: the lowest bit of a byte is the uppermost of its eight pixels.
    let send = |page: Page<'_>| -> Result<(), Infallible> {
        let is_on = |at: Point| page.bytes[at.x as usize] >> (at.y % 8) & 1 == 1;
        display.draw_iter(page.area.points().map(|at| Pixel(at, BinaryColor::from(is_on(at)))))
    };
    let values: [i32; 64] = from_fn(|n| 40 + n as i32 / 2 + [0, 18, 25, 18, 0, -18, -25, -18][n % 8]);
    show(send, &values)?;
    let theme = BinaryColorTheme::OledBlue;
    let settings = OutputSettingsBuilder::new().scale(3).theme(theme).build();
    let image = display.to_rgb_output_image(&settings);
    Ok(image.save_png("target/gauge_ssd1306.png")?)
}
