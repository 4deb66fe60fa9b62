//! Counts the standard scenes, without a frame buffer.
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use zrow_measure_firmware::{
    report,
    run::Runner,
    standard::{FRAME_NUMBERS, Sc1, Sc1InPasses, Sc2, Sc3, count},
    stopwatch::Stopwatch,
};

#[entry]
fn main() -> ! {
    let mut words = [0; 256];
    let wanted = report::wanted(&mut words);
    let sc1 = cortex_m::singleton!(: Sc1 = Sc1::EMPTY);
    let passes = cortex_m::singleton!(: Sc1InPasses = Sc1InPasses::EMPTY);
    let sc2 = cortex_m::singleton!(: Sc2 = Sc2::EMPTY);
    let sc3 = cortex_m::singleton!(: Sc3 = Sc3::EMPTY);
    let (Some(peripherals), Some(sc1), Some(passes), Some(sc2), Some(sc3)) =
        (Peripherals::take(), sc1, passes, sc2, sc3)
    else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    count(&mut runner, "scene.sc1", sc1);
    if runner.wants("scene.sc1") {
        runner.count("scene.sc1", "passes", passes, &FRAME_NUMBERS, |stage, &frame| {
            stage.draw(frame)
        });
    }
    count(&mut runner, "scene.sc2", sc2);
    count(&mut runner, "scene.sc3", sc3);
    report::exit(true)
}
