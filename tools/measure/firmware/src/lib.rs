//! What every measuring firmware shares: the stopwatch, the report lines, the inputs.
//!
//! A report line is `key=value` pairs behind one word that names its kind, for the host to read. Nothing here uses
//! `core::fmt`, so that the flash of a firmware is that of what it draws.
#![no_std]

pub mod content;
pub mod coverages;
pub mod dashboard;
pub mod family;
pub mod inputs;
pub mod outlines;
pub mod panel;
pub mod picture;
pub mod report;
pub mod run;
pub mod stack;
pub mod standard;
pub mod stopwatch;
#[cfg(feature = "text_peers")]
pub mod text;

use core::panic::PanicInfo;

/// Ends the emulation as failed.
#[panic_handler]
fn panic(_info: &PanicInfo) -> ! {
    report::line("panic").end();
    report::exit(false)
}
