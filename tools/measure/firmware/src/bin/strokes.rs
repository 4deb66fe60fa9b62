//! Counts wide strokes at 240 x 320 RGB565 on a full-frame `Band`: those of a `PrimitiveStyle`, and a `StrokeStyle`'s.
#![no_std]
#![no_main]

use core::hint::black_box;

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::{
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Line, Polyline, Rectangle, Styled},
};
use fixed::types::U16F16;
use zrow::{
    band::Band,
    draw::{DrawOn, LineCap, LineJoin, PrimitiveStyle, StrokeStyle},
};
use zrow_measure_firmware::{
    inputs::{Colored, colored},
    report,
    run::{Canvas, Checksum, Runner},
    stopwatch::Stopwatch,
};

const WIDTH: usize = 240;
const HEIGHT: usize = 320;
const SCREEN: Size = Size::new(WIDTH as u32, HEIGHT as u32);
const STROKE_WIDTH: u32 = 5;

static DASHES: [U16F16; 2] = [U16F16::lit("12"), U16F16::lit("8")];

/// zrow's canvas.
struct BandFrame<'a>(Band<'a, Rgb565>);

impl Canvas for BandFrame<'_> {
    fn erase(&mut self) {
        self.0.words_mut().fill(0);
    }

    fn checksum(&mut self) -> u32 {
        Checksum::of(self.0.words().iter().copied())
    }
}

#[entry]
fn main() -> ! {
    let mut words = [0; 256];
    let wanted = report::wanted(&mut words);
    let words = cortex_m::singleton!(: [u16; WIDTH * HEIGHT] = [0; WIDTH * HEIGHT]);
    let (Some(peripherals), Some(words)) = (Peripherals::take(), words) else {
        report::exit(false)
    };
    let Ok(band) = Band::new(Rectangle::new(Point::zero(), SCREEN), words) else {
        report::exit(false)
    };
    let mut canvas = BandFrame(band);
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    let lines: [Colored<Line>; 100] =
        colored(|uniform| Line::new(uniform.on_screen(SCREEN), uniform.on_screen(SCREEN)));
    count(&mut runner, "stroke.line", &mut canvas, &lines);
    // Eight vertices, each up to 40 pixels from the one before.
    let vertices: [Colored<[Point; 8]>; 50] = colored(|uniform| {
        let mut at = uniform.on_screen(SCREEN);
        core::array::from_fn(|_| {
            at += Point::new(uniform.number(-40, 41), uniform.number(-40, 41));
            at
        })
    });
    let polylines = vertices.each_ref().map(|vertices| Colored {
        shape: Polyline::new(&vertices.shape),
        color: vertices.color,
    });
    count(&mut runner, "stroke.polyline", &mut canvas, &polylines);
    report::exit(true)
}

/// Counts every kind of stroke with the same inputs.
fn count<S: Primitive + Copy>(runner: &mut Runner, name: &str, canvas: &mut BandFrame<'_>, inputs: &[Colored<S>])
where
    Styled<S, PrimitiveStyle<Rgb565>>: DrawOn<Color = Rgb565>,
    Styled<S, StrokeStyle<'static, Rgb565>>: DrawOn<Color = Rgb565>,
{
    if !runner.wants(name) {
        return;
    }
    runner.count(name, "wide_stroke", canvas, inputs, |canvas, input| {
        let style = PrimitiveStyle::with_stroke(input.color, STROKE_WIDTH);
        let Ok(()) = input.shape.into_styled(style).draw_on(&mut canvas.0);
    });
    let plain: fn(StrokeStyle<'static, Rgb565>) -> StrokeStyle<'static, Rgb565> = |style| style;
    for (variant, styled) in [
        ("styled_stroke", plain),
        ("round_stroke", |style| style.cap(LineCap::Round).join(LineJoin::Round)),
        ("dashed_stroke", |style| style.cap(LineCap::Butt).dashes(&DASHES)),
        ("round_dashed_stroke", |style| {
            style.cap(LineCap::Round).join(LineJoin::Round).dashes(&DASHES)
        }),
    ] {
        let styled = black_box(styled);
        runner.count(name, variant, canvas, inputs, |canvas, input| {
            let style = styled(StrokeStyle::new(input.color, STROKE_WIDTH));
            let Ok(()) = input.shape.into_styled(style).draw_on(&mut canvas.0);
        });
    }
}
