//! Counts forty large textured faces, four of which lie behind each other in the mean pixel: by the depth row, and by intervals.
#![no_std]
#![no_main]

use core::hint::black_box;

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::pixelcolor::Rgb565;
use zrow::{
    shade::{Texels, Textured},
    visible::SpanScanLine,
};
use zrow_measure_firmware::{
    report,
    run::{Canvas, Runner},
    standard::{FRAME_NUMBERS, Stage, checksum_of_frames},
    stopwatch::Stopwatch,
};
use zrow_scenes::squares::OverlappingSquares;

type Squares = Stage<OverlappingSquares, Textured<Texels<Rgb565, 64, 64>>, 80, 40, 40, 240, 320>;

/// The squares, drawn by intervals.
struct ByIntervals {
    squares: Squares,
    method: SpanScanLine<40>,
}

impl Canvas for ByIntervals {
    fn erase(&mut self) {}

    fn checksum(&mut self) -> u32 {
        checksum_of_frames(|frame, words| self.squares.rows_by(frame, &mut self.method, words))
    }
}

#[entry]
fn main() -> ! {
    let mut words = [0; 256];
    let wanted = report::wanted(&mut words);
    let squares = cortex_m::singleton!(: Squares = Squares::EMPTY);
    let by_intervals = cortex_m::singleton!(: ByIntervals = ByIntervals {
        squares: Squares::EMPTY,
        method: SpanScanLine::new(),
    });
    let (Some(peripherals), Some(squares), Some(by_intervals)) = (Peripherals::take(), squares, by_intervals) else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    // Every eighth frame: all of them take longer than the stopwatch counts.
    let frames = FRAME_NUMBERS
        .first_chunk::<8>()
        .unwrap_or(&[0; 8])
        .map(|frame| 8 * frame);
    runner.count("scene.squares", "draw", squares, &frames, |squares, &frame| {
        squares.draw(frame);
    });
    runner.count(
        "scene.squares",
        "intervals",
        by_intervals,
        &frames,
        |by_intervals, &frame| {
            let ByIntervals { squares, method } = by_intervals;
            squares.rows_by(frame, method, |words| {
                black_box(words);
            });
        },
    );
    runner.count("scene.squares", "prepare", squares, &frames, |squares, &frame| {
        squares.prepare(frame)
    });
    report::exit(true)
}
