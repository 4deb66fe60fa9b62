//! Draws nothing, but holds what the teapot with the effect that is named reads from flash: to be subtracted.
#![no_std]
#![no_main]

use core::hint::black_box;

use cortex_m_rt::entry;
use zrow_measure_firmware::{content, report, stack};
use zrow_scenes::standard::Subject;

/// Links the model of the effect that is named.
macro_rules! hold {
    ($($name:ident: $what:literal, $subject:ty, through $target:ident: [$($look:tt)+];)+) => {
        fn hold() {$(
            if const { content::is(concat!("effect.", stringify!($name))) } {
                black_box(<$subject as Subject>::model());
            }
        )+}
    };
}
zrow_scenes::effects!(hold);

#[entry]
fn main() -> ! {
    hold();
    stack::report(0);
    report::exit(true)
}
