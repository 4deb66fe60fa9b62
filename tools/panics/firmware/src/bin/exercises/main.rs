//! Calls the whole public API of zrow with values that the compiler knows nothing of.
//!
//! `cargo run --release -- panics` at the root of the repository builds this program, links it, and reads which panics are
//! in it.
//!
//! A module for each folder of zrow's `src/` holds exercises: functions that are not inlined, so that their names say what
//! reached a panic. Functions are called by their whole names, and each trait is exercised by a function of its name that
//! every implementation instantiates: zrow's test `exercises` reads these names and fails where one is missing.

#![no_std]
#![no_main]

mod band;
mod clip;
mod coverage;
mod draw;
mod foreign;
mod geometry;
mod mesh;
mod scan;
mod scene;
mod shade;
mod surface;
mod view;
mod visible;

use zrow_panics_firmware::call_all;

static EXERCISES: &[&[fn()]] = &[
    geometry::EXERCISES,
    surface::EXERCISES,
    view::EXERCISES,
    mesh::EXERCISES,
    clip::EXERCISES,
    scan::EXERCISES,
    coverage::EXERCISES,
    shade::EXERCISES,
    band::EXERCISES,
    draw::EXERCISES,
    visible::EXERCISES,
    scene::EXERCISES,
];

/// The entry point: what is not reached from here is not linked.
#[unsafe(no_mangle)]
extern "C" fn enter() -> ! {
    call_all(EXERCISES)
}
