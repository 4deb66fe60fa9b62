//! Counts the Utah teapot without any effect, with each one alone, and with all of them.
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use zrow_measure_firmware::{report, run::Runner, standard::through, stopwatch::Stopwatch};

/// Every fourth frame of the turn: more would be too many instructions for the stopwatch of the slowest core.
const FRAMES: [u32; 16] = [0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44, 48, 52, 56, 60];

/// Counts a frame of each effect that is asked for, each in memory of its own.
macro_rules! count {
    ($($name:ident: $what:literal, $subject:ty, through $target:ident: [$($look:tt)+];)+) => {
        fn count(runner: &mut Runner) {$({
            const NAME: &str = concat!("effect.", stringify!($name));
            type Stage = through::$target<$subject, $($look)+<$subject>>;
            if runner.wants(NAME) {
                let Some(stage) = cortex_m::singleton!(: Stage = Stage::EMPTY) else {
                    report::exit(false)
                };
                runner.count(NAME, "draw", stage, &FRAMES, |stage, &frame| stage.draw(frame));
            }
        })+}
    };
}
zrow_scenes::effects!(count);

#[entry]
fn main() -> ! {
    let mut words = [0; 256];
    let wanted = report::wanted(&mut words);
    let Some(peripherals) = Peripherals::take() else {
        report::exit(false)
    };
    count(&mut Runner::new(Stopwatch::new(peripherals.SYST), wanted));
    report::exit(true)
}
