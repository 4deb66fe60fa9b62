//! One family of 2D shapes, named when it is built, drawn through one row of 240 pixels; all of them where none is named.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use zrow_measure_firmware::{family, picture, report, stack};

#[entry]
fn main() -> ! {
    static mut ROW: [u16; picture::WIDTH] = [0; picture::WIDTH];
    let checksum = picture::through_one_row(ROW, family::draw);
    stack::report(checksum);
    report::exit(true)
}
