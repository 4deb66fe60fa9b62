//! Counts standard scene 1 in each look, and says how much memory it takes: what an effect costs a frame.
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::pixelcolor::Rgb565;
use zrow::scene::{Deep, DoubleSided, Fine, OnePass, Whole};
use zrow_measure_firmware::{
    report,
    run::Runner,
    standard::{FRAME_NUMBERS, Sc1},
    stopwatch::Stopwatch,
};

/// Counts a frame of the scene in looks, each in memory of its own, with as many slots as are said.
macro_rules! count {
    ($runner:ident, $($name:literal: $look:ty $(, $active:literal)?);+) => {$(
        if $runner.wants($name) {
            let Some(stage) = cortex_m::singleton!(: Sc1<$look $(, $active)?> = Sc1::EMPTY) else {
                report::exit(false)
            };
            $runner.count($name, "draw", stage, &FRAME_NUMBERS, |stage, &frame| stage.draw(frame));
        }
    )+};
}

#[entry]
fn main() -> ! {
    let mut words = [0; 256];
    let wanted = report::wanted(&mut words);
    let Some(peripherals) = Peripherals::take() else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    count!(
        runner,
        "look.plain": Rgb565;
        "look.whole": Whole<Rgb565>;
        "look.one_pass": OnePass<Rgb565>;
        "look.deep": Deep<Rgb565>;
        "look.fine": Fine<Rgb565>;
        "look.fine_deep": Fine<Deep<Rgb565>>;
        "look.double_sided": DoubleSided<Rgb565>, 120
    );
    report::exit(true)
}
