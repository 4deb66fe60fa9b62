//! Counts forty large textured faces, four of which lie behind each other in the mean pixel: by the depth row, and by intervals.
//! And the many small faces of a torus by both.
#![no_std]
#![no_main]

use core::hint::black_box;

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::pixelcolor::Rgb565;
use zrow::{
    scene::Look,
    shade::{Texels, Textured},
    visible::SpanScanLine,
};
use zrow_measure_firmware::{
    report,
    run::{Canvas, Runner},
    standard::{FRAME_NUMBERS, Stage, checksum_of_frames},
    stopwatch::Stopwatch,
};
use zrow_scenes::{
    squares::OverlappingSquares,
    standard::{SmallTorus, Subject},
};

type Squares = ByIntervals<OverlappingSquares, Textured<Texels<Rgb565, 64, 64>>, 80, 40, 40, 240, 320>;
type Torus = ByIntervals<SmallTorus, Rgb565, 296, 588, 60, 128, 64>;

/// A scene that is drawn by intervals, or by the depth row; its picture is that by intervals.
struct ByIntervals<S, L: Look, const V: usize, const F: usize, const A: usize, const COLUMNS: usize, const ROWS: usize>
{
    stage: Stage<S, L, V, F, A, COLUMNS, ROWS>,
    method: SpanScanLine<A>,
}

impl<S, L, const V: usize, const F: usize, const A: usize, const COLUMNS: usize, const ROWS: usize>
    ByIntervals<S, L, V, F, A, COLUMNS, ROWS>
where
    S: Subject,
    L: Look<Color = Rgb565, Shading = S::Shading>,
{
    /// Zeros, so that a `static` lies in `.bss` and nothing comes from the stack.
    const EMPTY: Self = Self {
        stage: Stage::EMPTY,
        method: SpanScanLine::new(),
    };

    /// Counts what drawing a frame takes by the depth row and by intervals.
    fn count(&mut self, runner: &mut Runner, name: &str) {
        if !runner.wants(name) {
            return;
        }
        // Every eighth frame: all of them take longer than the stopwatch counts.
        let frames = FRAME_NUMBERS
            .first_chunk::<8>()
            .unwrap_or(&[0; 8])
            .map(|frame| 8 * frame);
        runner.count(name, "draw", self, &frames, |this, &frame| this.stage.draw(frame));
        runner.count(name, "intervals", self, &frames, |this, &frame| {
            this.stage.rows_by(frame, &mut this.method, |words| {
                black_box(words);
            });
        });
    }
}

impl<S, L, const V: usize, const F: usize, const A: usize, const COLUMNS: usize, const ROWS: usize> Canvas
    for ByIntervals<S, L, V, F, A, COLUMNS, ROWS>
where
    S: Subject,
    L: Look<Color = Rgb565, Shading = S::Shading>,
{
    fn erase(&mut self) {}

    fn checksum(&mut self) -> u32 {
        checksum_of_frames(|frame, words| self.stage.rows_by(frame, &mut self.method, words))
    }
}

#[entry]
fn main() -> ! {
    let mut words = [0; 256];
    let wanted = report::wanted(&mut words);
    let squares = cortex_m::singleton!(: Squares = Squares::EMPTY);
    let torus = cortex_m::singleton!(: Torus = Torus::EMPTY);
    let (Some(peripherals), Some(squares), Some(torus)) = (Peripherals::take(), squares, torus) else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    squares.count(&mut runner, "scene.squares");
    torus.count(&mut runner, "sc1");
    report::exit(true)
}
