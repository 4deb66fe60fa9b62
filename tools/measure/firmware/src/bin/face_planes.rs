//! Counts the Utah teapot in each shading, with back faces culled by their planes before vertices are transformed.
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use zrow_measure_firmware::{
    report,
    run::Runner,
    standard::{FlatLitPlaneTeapot, FlatPlaneTeapot, GouraudPlaneTeapot, TexturedPlaneTeapot, count},
    stopwatch::Stopwatch,
};

#[entry]
fn main() -> ! {
    let mut words = [0; 256];
    let wanted = report::wanted(&mut words);
    let flat = cortex_m::singleton!(: FlatPlaneTeapot = FlatPlaneTeapot::EMPTY);
    let flat_lit = cortex_m::singleton!(: FlatLitPlaneTeapot = FlatLitPlaneTeapot::EMPTY);
    let gouraud = cortex_m::singleton!(: GouraudPlaneTeapot = GouraudPlaneTeapot::EMPTY);
    let textured = cortex_m::singleton!(: TexturedPlaneTeapot = TexturedPlaneTeapot::EMPTY);
    let (Some(peripherals), Some(flat), Some(flat_lit), Some(gouraud), Some(textured)) =
        (Peripherals::take(), flat, flat_lit, gouraud, textured)
    else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    count(&mut runner, "scene.teapot_planes.flat", flat);
    count(&mut runner, "scene.teapot_planes.flat_lit", flat_lit);
    count(&mut runner, "scene.teapot_planes.gouraud", gouraud);
    count(&mut runner, "scene.teapot_planes.textured_lit", textured);
    report::exit(true)
}
