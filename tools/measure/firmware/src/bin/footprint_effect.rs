//! The Utah teapot with one effect, which is named when the program is built, through one row.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use zrow_measure_firmware::{content, report, run::Canvas, stack, standard::through};

/// The checksum of the effect that is named.
macro_rules! checksum {
    ($($name:ident: $what:literal, $subject:ty, through $target:ident: [$($look:tt)+];)+) => {
        fn checksum() -> u32 {$(
            if const { content::is(concat!("effect.", stringify!($name))) } {
                type Stage = through::$target<$subject, $($look)+<$subject>>;
                let stage = cortex_m::singleton!(: Stage = Stage::EMPTY);
                return stage.map_or(0, Canvas::checksum);
            }
        )+
            0
        }
    };
}
zrow_scenes::effects!(checksum);

#[entry]
fn main() -> ! {
    stack::report(checksum());
    report::exit(true)
}
