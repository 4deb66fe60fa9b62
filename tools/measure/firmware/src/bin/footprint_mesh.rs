//! Draws nothing, but holds what the scene reads from flash: to be subtracted.
#![no_std]
#![no_main]

use core::hint::black_box;
use cortex_m_rt::entry;
use zrow_measure_firmware::{report, stack};
use zrow_scenes::meshes::{TORUS_AND_CUBE, TORUS_AND_CUBE_COLORS};

#[entry]
fn main() -> ! {
    black_box((&TORUS_AND_CUBE, &TORUS_AND_CUBE_COLORS));
    stack::report(0);
    report::exit(true)
}
