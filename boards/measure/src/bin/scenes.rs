//! Counts the standard scenes, without a frame buffer.
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use zrow_measure::{
    meshes, report,
    run::Runner,
    standard::{FRAMES, Stage},
    stopwatch::Stopwatch,
};

#[entry]
fn main() -> ! {
    let mut words = [0; 256];
    let wanted = report::wanted(&mut words);
    let stage = cortex_m::singleton!(: Stage = Stage::new());
    let (Some(peripherals), Some(stage)) = (Peripherals::take(), stage) else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    let frames: [u16; FRAMES as usize] = core::array::from_fn(|frame| frame as u16);
    for (name, mesh) in [
        ("scene.sc1", meshes::TORUS_AND_CUBE),
        ("scene.sc2", meshes::ICOSPHERE),
        ("scene.sc3", meshes::CUBE),
    ] {
        if runner.wants(name) {
            let mut scene = stage.with(mesh);
            runner.count(name, "prepare", &mut scene, &frames, |scene, &frame| {
                scene.prepare(frame)
            });
            runner.count(name, "draw", &mut scene, &frames, |scene, &frame| scene.draw(frame));
        }
    }
    report::exit(true)
}
