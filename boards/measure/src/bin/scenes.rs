//! Counts the standard scenes, without a frame buffer.
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use zrow_measure::{
    report,
    run::Runner,
    standard::{FRAMES, Stage, Standard},
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
    for (name, scene) in [
        ("scene.sc1", Standard::Sc1),
        ("scene.sc2", Standard::Sc2),
        ("scene.sc3", Standard::Sc3),
    ] {
        if runner.wants(name) {
            stage.set_scene(scene);
            runner.count(name, "prepare", stage, &frames, |stage, &frame| stage.prepare(frame));
            runner.count(name, "draw", stage, &frames, |stage, &frame| stage.draw(frame));
        }
    }
    report::exit(true)
}
