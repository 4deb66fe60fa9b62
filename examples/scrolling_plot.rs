//! A plot that scrolls, its area in a gradient: drawn anew in bands of 16 rows, because no frame has much of the one before.
//!
//! `cargo run --release --example scrolling_plot` plays it on a simulated display and writes `target/scrolling_plot.png`.

use std::{array::from_fn, error::Error, fmt::Debug};

use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_9X15};
use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use embedded_graphics::primitives::Polyline;
use embedded_graphics::{prelude::*, text::Text};
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use zrow::draw::{FillRule, PaintedShape, Polygon};
use zrow::shade::{LinearGradient, Ramp};
use zrow::{geometry::InputError, prelude::*};

const POINTS: usize = 61;
/// The row of the axis.
const BASE: i32 = 239;

/// Shows values from 0 to 200, the newest one at the right, on a display of 240 x 240 pixels.
fn show<D: DrawTarget<Color = Rgb565, Error: Debug>>(display: &mut D, values: &[i32]) -> Result<(), InputError> {
    let [low, middle, high] = [Rgb888::CSS_MIDNIGHT_BLUE, Rgb888::CSS_CRIMSON, Rgb888::CSS_GOLD];
    let ramp = Ramp::new([(0, low), (110, middle), (255, high)])?;
    // The 256 colours of the gradient are computed here, once.
    let gradient = LinearGradient::<_, 3>::new(Point::new(0, BASE), Point::new(0, BASE - 200), ramp)?;
    let fill = PrimitiveStyle::with_fill(Rgb565::WHITE);
    let stroke = PrimitiveStyle::with_stroke(Rgb565::WHITE, 2);
    let font = MonoTextStyle::new(&FONT_9X15, Rgb565::WHITE);
    let title = Text::new("power / kW", Point::new(8, 20), font);
    let (mut history, mut words) = ([0; POINTS], [0; 16 * 240]);
    for &value in values {
        history.rotate_left(1);
        history[POINTS - 1] = value;
        let line: [Point; POINTS] = from_fn(|n| Point::new(4 * n as i32, BASE - history[n]));
        let ends = [Point::new(240, BASE), Point::new(0, BASE)];
        let outline: [Point; POINTS + 2] = from_fn(|n| *line.iter().chain(&ends).nth(n).unwrap());
        // A table of all edges, and of those that one row crosses at most.
        let contours = [outline.as_slice()];
        let area = Polygon::new(&contours, FillRule::NonZero).prepare::<{ POINTS + 2 }, { POINTS + 2 }>()?;
        let (shape, paint) = (area.into_styled(fill), &gradient);
        let scene = |band: &mut Band<'_, Rgb565>| {
            PaintedShape { shape, paint }.draw_on(band)?;
            Polyline::new(&line).into_styled(stroke).draw_on(band)?;
            title.draw_on(band)
        };
        let picture = PictureLoop::new(display.bounding_box(), Rgb565::BLACK).rows(16);
        picture.draw(&mut words, &mut DisplaySink(display), scene).unwrap();
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut display = SimulatorDisplay::<Rgb565>::new(Size::new(240, 240));
    let values: [i32; 100] = from_fn(|n| 45 + 4 * (n % 40).abs_diff(20) as i32 + 5 * (n % 14).abs_diff(7) as i32);
    show(&mut display, &values)?;
    let image = display.to_rgb_output_image(&OutputSettings::default());
    Ok(image.save_png("target/scrolling_plot.png")?)
}
