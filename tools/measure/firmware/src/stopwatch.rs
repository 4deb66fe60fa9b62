//! Counts instructions with SysTick.
//!
//! Under QEMU's `-icount shift=0` one instruction takes 1 ns of virtual time, so a SysTick tick is a fixed number of
//! instructions: 40 at 25 MHz (`mps2-an386`), 80 at 12.5 MHz (`lm3s6965evb`). Counts repeat exactly.
//!
//! Two hints that every core takes for `nop` mark what is timed, so that a plugin of QEMU can price it in cycles.

use cortex_m::peripheral::{SYST, syst::SystClkSource};

use crate::report;

const RELOAD: u32 = 0x00FF_FFFF;

/// The running SysTick counter.
pub struct Stopwatch {
    systick: SYST,
}

impl Stopwatch {
    /// Starts the counter over its full 24 bits.
    pub fn new(mut systick: SYST) -> Self {
        systick.set_clock_source(SystClkSource::Core);
        systick.set_reload(RELOAD);
        systick.clear_current();
        systick.enable_counter();
        Self { systick }
    }

    /// Runs `work` and returns the ticks it took, or `None` if the counter wrapped meanwhile.
    pub fn time(&mut self, work: impl FnOnce()) -> Option<u32> {
        self.systick.clear_current();
        // Reading the flag resets it.
        let _ = self.systick.has_wrapped();
        let start = SYST::get_current();
        // SAFETY: an unallocated hint, which is a `nop`.
        unsafe { core::arch::asm!(".inst.n 0xbf60", options(nostack, preserves_flags)) };
        work();
        // SAFETY: an unallocated hint, which is a `nop`.
        unsafe { core::arch::asm!(".inst.n 0xbf70", options(nostack, preserves_flags)) };
        let end = SYST::get_current();
        let wrapped = self.systick.has_wrapped();
        // After `clear_current` the counter may still read 0 before it reloads.
        let ticks = start.wrapping_sub(end) & RELOAD;
        (!wrapped || start == 0).then_some(ticks)
    }

    /// Times loops of known length; the host checks that the ticks fit and derives nothing else from them.
    pub fn calibrate(&mut self) {
        for instructions in [2_000_000, 4_000_000] {
            let ticks = self.time(|| known_length(instructions)).unwrap_or_default();
            report::line("calibration")
                .number("instructions", instructions)
                .number("ticks", ticks)
                .end();
        }
    }
}

/// Executes `instructions` instructions, give or take a handful; a multiple of 2.
#[inline(never)]
fn known_length(instructions: u32) {
    // SAFETY: counts a register down; touches neither memory nor stack.
    unsafe {
        core::arch::asm!(
            "2:",
            "subs {rest}, {rest}, #1",
            "bne 2b",
            rest = inout(reg) instructions / 2 => _,
            options(nomem, nostack),
        );
    }
}
