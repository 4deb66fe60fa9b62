//! SysTick as a stopwatch.
//!
//! It ticks at 12.5 MHz in QEMU, where `-icount shift=0` makes a tick 80 instructions, and at about 12 MHz out of reset
//! on the board.

use cortex_m::peripheral::{SYST, syst::SystClkSource};

/// SysTick counts 24 bits down: 1.3 s until it starts again.
const LARGEST: u32 = 0x00ff_ffff;

/// Counts ticks since it was restarted.
pub struct Stopwatch {
    timer: SYST,
    start: u32,
}

impl Stopwatch {
    /// Starts the timer.
    pub fn new(mut timer: SYST) -> Self {
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(LARGEST);
        timer.clear_current();
        timer.enable_counter();
        Self { timer, start: LARGEST }
    }

    /// Starts counting from 0.
    pub fn restart(&mut self) {
        self.start = self.timer.cvr.read();
    }

    /// Ticks since the last start, which must be below 1.3 s ago.
    pub fn ticks(&self) -> u32 {
        self.start.wrapping_sub(self.timer.cvr.read()) & LARGEST
    }
}
