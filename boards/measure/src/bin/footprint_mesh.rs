//! Draws nothing, but holds what the scene reads from flash: to be subtracted.
#![no_std]
#![no_main]

use core::hint::black_box;
use cortex_m_rt::entry;
use zrow_measure::{meshes, report, stack, standard::COLORS};

#[entry]
fn main() -> ! {
    black_box((&meshes::TORUS_AND_CUBE, &COLORS));
    stack::report(0);
    report::exit(true)
}
