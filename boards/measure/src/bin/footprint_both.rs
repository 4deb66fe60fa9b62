//! What the 2D picture and the scene take together.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use zrow_measure::{meshes, picture, report, run::Canvas, stack, standard::Stage};

#[entry]
fn main() -> ! {
    let row = cortex_m::singleton!(: [u16; picture::WIDTH] = [0; picture::WIDTH]);
    let stage = cortex_m::singleton!(: Stage = Stage::new());
    let (Some(row), Some(stage)) = (row, stage) else {
        report::exit(false)
    };
    let checksum = picture::shapes(row) ^ stage.with(meshes::TORUS_AND_CUBE).checksum();
    stack::report(checksum);
    report::exit(true)
}
