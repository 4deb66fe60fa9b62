//! Counts the items of the playground's scenes: a frame of 240 x 320 pixels with one of them, by each method of
//! antialiasing, in bands of some heights, its edges set up anew.
#![no_std]
#![no_main]

use core::{convert::Infallible, fmt::Write as _, hint::black_box};

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::pixelcolor::Rgb565;
use heapless::{String, Vec};
use zrow::band::Band;
use zrow_measure_firmware::{
    report,
    run::{Canvas, Checksum, Runner},
    stopwatch::Stopwatch,
};
use zrow_playground_scene::{COUNTED_ROWS, EMPTY_COUNT, Item, Method, POT_COUNT, PRESETS, Playground, Pot, State};

/// Draws frames; its checksum is that of the last one.
struct Frames(Playground);

impl Frames {
    /// Sets the items up and draws them.
    fn draw(&mut self, mut row: impl FnMut(&[u16])) {
        let mut sink = |band: Band<'_, Rgb565>| {
            row(band.words());
            Ok::<_, Infallible>(())
        };
        if self.0.set_up().is_err() || self.0.draw_directly(&mut sink).is_err() {
            report::exit(false);
        }
    }
}

impl Canvas for Frames {
    fn erase(&mut self) {}

    fn checksum(&mut self) -> u32 {
        let mut checksum = Checksum::default();
        self.draw(|words| checksum.add(words.iter().copied()));
        checksum.0
    }
}

#[entry]
fn main() -> ! {
    let mut words = [0; 512];
    let wanted = report::wanted(&mut words);
    let Some(peripherals) = Peripherals::take() else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    let mut frames = Frames(Playground::new());
    for preset in PRESETS {
        let items = State::of_address(preset.address).items;
        for (item, count) in items.iter().zip(preset.counts) {
            for method in Method::ALL {
                count_frame(
                    &mut runner,
                    &mut frames,
                    count,
                    method.name(),
                    state(Some(item), *method, Pot::None),
                );
            }
        }
    }
    for pot in Pot::ALL.iter().filter(|pot| **pot != Pot::None) {
        count_frame(
            &mut runner,
            &mut frames,
            POT_COUNT,
            pot.name(),
            state(None, Method::None, *pot),
        );
    }
    count_frame(
        &mut runner,
        &mut frames,
        EMPTY_COUNT,
        "draw",
        state(None, Method::None, Pot::None),
    );
    report::exit(true)
}

/// One item or one teapot.
fn state(item: Option<&Item>, method: Method, pot: Pot) -> State {
    State {
        pot,
        method,
        items: item.into_iter().cloned().collect::<Vec<_, _>>(),
        ..State::EMPTY
    }
}

/// Counts a frame in bands of all heights.
fn count_frame(runner: &mut Runner<'_>, frames: &mut Frames, name: &str, variant: &str, state: State) {
    if !runner.wants(name) {
        return;
    }
    for rows in COUNTED_ROWS {
        let mut variant_and_rows = String::<32>::new();
        if write!(variant_and_rows, "{variant}.{rows}").is_err() {
            report::exit(false);
        }
        frames.0.take(State {
            rows: *rows,
            ..state.clone()
        });
        runner.count(name, &variant_and_rows, frames, &[()], |frames, ()| {
            frames.draw(|words| {
                black_box(words);
            });
        });
    }
}
