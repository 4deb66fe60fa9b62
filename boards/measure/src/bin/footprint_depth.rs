//! The torus and the cube through one row of colours and one row of depths, and nothing else.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use zrow_measure::{report, run::Canvas, stack, standard::Sc1};

#[entry]
fn main() -> ! {
    let Some(sc1) = cortex_m::singleton!(: Sc1 = Sc1::EMPTY) else {
        report::exit(false)
    };
    let checksum = sc1.checksum();
    stack::report(checksum);
    report::exit(true)
}
