//! Counts a dashboard in bands of some rows: every item prepared anew as a picture, and every item replayed into each band.
#![no_std]
#![no_main]

use core::{convert::Infallible, hint::black_box};

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
use zrow::band::{Band, PictureLoop};
use zrow_measure_firmware::{
    dashboard::{AREA, Dashboard, Memory},
    report,
    run::{Canvas, Checksum, Runner},
    stopwatch::Stopwatch,
};

const PIXELS: usize = 240 * 320;

/// How a frame is drawn: the dashboard with or without its texts, prepared or replayed, in bands of so many rows.
#[derive(Clone, Copy)]
struct Way {
    with_texts: bool,
    is_prepared: bool,
    rows: u32,
}

/// The dashboard, what it is prepared in, and as many rows as a band may have.
struct Frame<'a> {
    dashboard: &'a Dashboard,
    memory: &'a mut Memory,
    words: &'a mut [u16],
    way: Way,
}

impl Frame<'_> {
    /// Draws a frame, and hands on every band.
    #[inline(never)]
    fn draw(&mut self, mut output: impl FnMut(&[u16])) {
        let Way {
            with_texts,
            is_prepared,
            rows,
        } = self.way;
        let mut sink = |band: Band<'_, Rgb565>| -> Result<(), Infallible> {
            output(black_box(band.words()));
            Ok(())
        };
        let bands = PictureLoop::new(AREA, Rgb565::BLACK).rows(rows);
        let drawn = if is_prepared {
            let Ok(mut picture) = self.dashboard.prepare(with_texts, self.memory) else {
                report::exit(false)
            };
            bands.draw(self.words, &mut sink, |band| picture.draw(band))
        } else {
            bands.draw(self.words, &mut sink, |band| self.dashboard.draw(with_texts, band))
        };
        if drawn.is_err() {
            report::exit(false)
        }
    }
}

impl Canvas for Frame<'_> {
    fn erase(&mut self) {}

    /// Of all pixels of a frame, which is drawn once more for that.
    fn checksum(&mut self) -> u32 {
        let mut sum = Checksum::default();
        self.draw(|words| sum.add(words.iter().copied()));
        sum.0
    }
}

#[entry]
fn main() -> ! {
    let mut words = [0; 512];
    let wanted = report::wanted(&mut words);
    let Some(peripherals) = Peripherals::take() else {
        report::exit(false)
    };
    let Some(words) = cortex_m::singleton!(: [u16; PIXELS] = [0; PIXELS]) else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    let dashboard = black_box(Dashboard::default());
    let mut memory = Memory::default();
    let mut frame = Frame {
        dashboard: &dashboard,
        memory: &mut memory,
        words,
        way: Way {
            with_texts: false,
            is_prepared: true,
            rows: 1,
        },
    };
    let mut count = |name: &str, with_texts: bool, rows: u32| {
        if !runner.wants(name) {
            return;
        }
        for (variant, is_prepared) in [("prepared", true), ("replayed", false)] {
            frame.way = Way {
                with_texts,
                is_prepared,
                rows,
            };
            runner.count(name, variant, &mut frame, &[(); 2], |frame, ()| {
                frame.draw(|words| {
                    black_box(words);
                });
            });
        }
    };
    count("picture.shapes", false, 1);
    count("picture.dashboard", true, 1);
    count("picture.dashboard.rows_2", true, 2);
    count("picture.dashboard.rows_4", true, 4);
    count("picture.dashboard.rows_8", true, 8);
    count("picture.dashboard.rows_16", true, 16);
    count("picture.dashboard.rows_32", true, 32);
    count("picture.dashboard.rows_320", true, 320);
    report::exit(true)
}
