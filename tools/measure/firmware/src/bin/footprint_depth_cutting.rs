//! As `footprint_depth`, with a frame that can cut faces.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use zrow_measure_firmware::{report, run::Canvas, stack, standard::Sc1};

#[entry]
fn main() -> ! {
    static mut SC1: Sc1 = Sc1::EMPTY;
    let checksum = SC1.checksum();
    stack::report(checksum);
    report::exit(true)
}
