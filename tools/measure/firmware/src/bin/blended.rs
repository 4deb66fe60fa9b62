//! Counts antialiased shapes, blended into 240 x 320 RGB565: on a band as high as the frame, and on bands of one row, which have to
//! make the same pixels.
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::{
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Circle, Line, Rectangle, Styled, Triangle},
};
use zrow::{
    band::Band,
    draw::{Antialiased, DrawAntialiased, PrimitiveStyle},
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
/// Edges of an outline, and those of them in one row.
const EDGES: usize = 256;
const ACTIVE: usize = 64;

/// The pixels of a frame, and what antialiasing needs of memory for a row.
struct Frame {
    words: [u16; WIDTH * HEIGHT],
    cells: [i32; WIDTH + 1],
}

impl Frame {
    /// Draws a shape in bands of so many rows.
    fn draw(&mut self, rows: usize, shape: &impl DrawAntialiased<Color = Rgb565>) {
        for (top, words) in (0..).step_by(rows).zip(self.words.chunks_mut(rows * WIDTH)) {
            let area = Rectangle::new(Point::new(0, top), Size::new(WIDTH as u32, rows as u32));
            if let Ok(mut band) = Band::<Rgb565>::new(area, words) {
                let drawn = shape.draw_on(&mut band.antialiased::<EDGES, ACTIVE>(&mut self.cells));
                // Else nothing is drawn, and the checksums of both heights are that of nothing.
                if drawn.is_err() {
                    report::exit(false);
                }
            }
        }
    }
}

impl Canvas for Frame {
    fn erase(&mut self) {
        self.words.fill(0);
    }

    fn checksum(&mut self) -> u32 {
        Checksum::of(self.words.iter().copied())
    }
}

#[entry]
fn main() -> ! {
    let mut words = [0; 512];
    let wanted = report::wanted(&mut words);
    let frame = cortex_m::singleton!(: Frame = Frame { words: [0; WIDTH * HEIGHT], cells: [0; WIDTH + 1] });
    let (Some(peripherals), Some(frame)) = (Peripherals::take(), frame) else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    // On the Cortex-M0+ a disc in bands of one row takes 12.5 million instructions; 671 million wrap the stopwatch.
    let discs: [Colored<Circle>; 40] = colored(|uniform| Circle::with_center(uniform.on_screen(SCREEN), 101));
    let fill = PrimitiveStyle::with_fill;
    count(&mut runner, frame, "blend.disc", &discs, fill);
    let lines: [Colored<Line>; 100] =
        colored(|uniform| Line::new(uniform.on_screen(SCREEN), uniform.on_screen(SCREEN)));
    count(&mut runner, frame, "blend.line", &lines, |color| {
        PrimitiveStyle::with_stroke(color, 5)
    });
    let triangles: [Colored<Triangle>; 100] = colored(|uniform| {
        Triangle::new(
            uniform.on_screen(SCREEN),
            uniform.on_screen(SCREEN),
            uniform.on_screen(SCREEN),
        )
    });
    count(&mut runner, frame, "blend.triangle", &triangles, fill);
    report::exit(true)
}

/// Counts shapes on a frame, and on bands of one row.
fn count<S: Primitive + Copy, const N: usize>(
    runner: &mut Runner<'_>,
    frame: &mut Frame,
    name: &str,
    inputs: &[Colored<S>; N],
    style: impl Fn(Rgb565) -> PrimitiveStyle<Rgb565>,
) where
    Styled<S, Antialiased<PrimitiveStyle<Rgb565>>>: DrawAntialiased<Color = Rgb565>,
{
    if !runner.wants(name) {
        return;
    }
    let styled = inputs
        .each_ref()
        .map(|input| input.shape.into_styled(style(input.color).antialiased()));
    for (variant, rows) in [("frame", HEIGHT), ("rows", 1)] {
        runner.count(name, variant, frame, &styled, |frame, shape| frame.draw(rows, shape));
    }
}
