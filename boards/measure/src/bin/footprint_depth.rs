//! The torus and the cube through one row of colours and one row of depths, and nothing else.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use zrow_measure::{meshes, report, run::Canvas, stack, standard::Stage};

#[entry]
fn main() -> ! {
    let Some(stage) = cortex_m::singleton!(: Stage = Stage::new()) else {
        report::exit(false)
    };
    let checksum = stage.with(meshes::TORUS_AND_CUBE).checksum();
    stack::report(checksum);
    report::exit(true)
}
