//! SysTick as a stopwatch of core cycles.

use cortex_m::peripheral::{SYST, syst::SystClkSource};

/// SysTick counts 24 bits down: 16.7 million cycles, 134 ms at 125 MHz, until it starts again.
const LARGEST: u32 = 0x00ff_ffff;

/// Starts SysTick, which counts down by one each core cycle from then on.
pub fn start(timer: &mut SYST) {
    timer.set_clock_source(SystClkSource::Core);
    timer.set_reload(LARGEST);
    timer.clear_current();
    timer.enable_counter();
}

/// A moment that a stopwatch was started at.
#[derive(Clone, Copy)]
pub struct Moment(u32);

impl Moment {
    /// This very moment. [`start`] must have been called.
    pub fn now() -> Self {
        Self(SYST::get_current())
    }

    /// Core cycles from this moment to a later one, which must be fewer than 16.7 million.
    pub fn cycles_to(self, later: Self) -> u32 {
        self.0.wrapping_sub(later.0) & LARGEST
    }

    /// Core cycles since this moment, which must be fewer than 16.7 million.
    pub fn elapsed(self) -> u32 {
        self.cycles_to(Self::now())
    }
}
