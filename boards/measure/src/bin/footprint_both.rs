//! What the 2D picture and the scene take together.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use zrow_measure::{picture, report, run::Canvas, stack, standard::Sc1};

#[entry]
fn main() -> ! {
    let row = cortex_m::singleton!(: [u16; picture::WIDTH] = [0; picture::WIDTH]);
    let sc1 = cortex_m::singleton!(: Sc1 = Sc1::EMPTY);
    let (Some(row), Some(sc1)) = (row, sc1) else {
        report::exit(false)
    };
    let checksum = picture::shapes(row) ^ sc1.checksum();
    stack::report(checksum);
    report::exit(true)
}
