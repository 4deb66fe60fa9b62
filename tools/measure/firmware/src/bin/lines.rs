//! Counts the line siblings at 240 x 320 RGB565 on a full-frame `Band`: each pixel by pixel through the same loop
//! (`walk.*`), and those that a target takes as a whole that way (`line.whole.*`),
//! where the filtered line joins them.
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::{
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Line, Rectangle},
};
use zrow::{
    band::{Band, Span, Target},
    draw::{DrawOn, FilteredLine, PrimitiveStyle},
    geometry::SubPoint,
    scan::Lines,
};
use zrow_measure_firmware::{
    inputs::{Colored, Uniform, colored},
    report,
    run::{Canvas, Checksum, Runner},
    stopwatch::Stopwatch,
};

const WIDTH: usize = 240;
const HEIGHT: usize = 320;
const SCREEN: Size = Size::new(WIDTH as u32, HEIGHT as u32);

struct Frame<'a>(Band<'a, Rgb565>);

impl Canvas for Frame<'_> {
    fn erase(&mut self) {
        self.0.words_mut().fill(0);
    }

    fn checksum(&mut self) -> u32 {
        Checksum::of(self.0.words().iter().copied())
    }
}

#[entry]
fn main() -> ! {
    let mut words = [0; 1024];
    let wanted = report::wanted(&mut words);
    let words = cortex_m::singleton!(: [u16; WIDTH * HEIGHT] = [0; WIDTH * HEIGHT]);
    let (Some(peripherals), Some(words)) = (Peripherals::take(), words) else {
        report::exit(false)
    };
    let Ok(band) = Band::new(Rectangle::new(Point::zero(), SCREEN), words) else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    let mut frame = Frame(band);
    let on_screen = |uniform: &mut Uniform| Line::new(uniform.on_screen(SCREEN), uniform.on_screen(SCREEN));
    let off_screen =
        |uniform: &mut Uniform| Line::new(uniform.around_screen(SCREEN, 3000), uniform.around_screen(SCREEN, 3000));
    // Rules, chart grids, horizons: at most a row in 16 columns.
    let shallow = |uniform: &mut Uniform| {
        let start = Point::new(uniform.number(0, 40), uniform.number(12, 308));
        Line::new(start, start + Point::new(199, uniform.number(-12, 13)))
    };
    let level = |uniform: &mut Uniform| {
        let start = Point::new(uniform.number(0, 140), uniform.number(0, 320));
        Line::new(start, start + Point::new(uniform.number(0, 100), 0))
    };
    let on_screen: [Colored<Line>; 200] = colored(on_screen);
    let shallow: [Colored<Line>; 200] = colored(shallow);
    let level: [Colored<Line>; 200] = colored(level);
    let off_screen: [Colored<Line>; 200] = colored(off_screen);
    for (walk, whole, inputs) in [
        ("walk.on_screen", "line.whole.on_screen", &on_screen),
        ("walk.shallow", "line.whole.shallow", &shallow),
        ("walk.level", "line.whole.level", &level),
        ("walk.off_screen", "line.whole.off_screen", &off_screen),
    ] {
        walks(&mut runner, walk, &mut frame, inputs);
        wholes(&mut runner, whole, &mut frame, inputs);
    }
    report::exit(true)
}

/// Counts every sibling, pixel by pixel.
fn walks(runner: &mut Runner, name: &str, frame: &mut Frame<'_>, inputs: &[Colored<Line>]) {
    if !runner.wants(name) {
        return;
    }
    macro_rules! count {
        ($([$name:ident] [$($line:tt)+])+) => {$(
            runner.count(name, stringify!($name), frame, inputs, |canvas, Colored { shape, color }| {
                let line = $($line)+(shape.start, shape.end, &canvas.0.window());
                let Ok(()) = canvas.0.draw_iter(line.map(|point| Pixel(point, *color)));
            });
        )+};
    }
    zrow_methods::lines!(count);
}

/// Counts the steps and the runs as a target takes them.
fn wholes(runner: &mut Runner, name: &str, frame: &mut Frame<'_>, inputs: &[Colored<Line>]) {
    if !runner.wants(name) {
        return;
    }
    runner.count(name, "bresenham", frame, inputs, |canvas, input| {
        let style = PrimitiveStyle::with_stroke(input.color, 1);
        let Ok(()) = input.shape.into_styled(style).draw_on(&mut canvas.0);
    });
    runner.count(name, "bresenham_runs", frame, inputs, |canvas, input| {
        let raw = canvas.0.raw(input.color);
        let Line { start, end } = input.shape;
        // Known to all runs of a line: rows are filled as spans, for which a band has less to do than for windows.
        let in_rows = start.x.abs_diff(end.x) >= start.y.abs_diff(end.y);
        let runs = Lines::runs(start, end, &canvas.0.window());
        if in_rows {
            for run in runs {
                let Ok(()) = canvas.0.fill_span(Span::new(run.top, run.left, run.right), raw);
            }
        } else {
            for run in runs {
                let Ok(()) = canvas.0.fill_window(run, raw);
            }
        }
    });
    // Ends beyond its domain are not among the inputs: an error would show as too few instructions.
    runner.count(name, "gupta_sproull", frame, inputs, |canvas, input| {
        let ends = [input.shape.start, input.shape.end].map(SubPoint::from_pixel);
        if let [Ok(start), Ok(end)] = ends
            && let Ok(line) = FilteredLine::new(start, end)
        {
            let Ok(()) = line.draw(&mut canvas.0, input.color);
        }
    });
}
