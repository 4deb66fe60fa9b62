//! A 2D picture through one row of 240 pixels, and nothing else.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use zrow_measure_firmware::{picture, report, stack};

#[entry]
fn main() -> ! {
    static mut ROW: [u16; picture::WIDTH] = [0; picture::WIDTH];
    let checksum = picture::shapes(ROW);
    stack::report(checksum);
    report::exit(true)
}
