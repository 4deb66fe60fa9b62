//! The cockpit of antialiased shapes and texts as a picture, everything prepared anew, through one row, and nothing else.
#![no_std]
#![no_main]

use core::convert::Infallible;

use cortex_m_rt::entry;
use zrow::band::Band;
use zrow_measure_firmware::{report, run::Checksum, stack};
use zrow_scenes::{Scene, cockpit::Cockpit};

#[entry]
fn main() -> ! {
    static mut ROW: [u16; 240] = [0; 240];
    static mut COCKPIT: Cockpit = Cockpit::new();
    let mut sum = Checksum::default();
    let mut sink = |band: Band<'_, _>| -> Result<(), Infallible> {
        sum.add(band.words().iter().copied());
        Ok(())
    };
    for frame in 0..Cockpit::FRAMES {
        let Ok(mut picture) = COCKPIT.prepare(frame) else {
            report::exit(false)
        };
        let bands = Cockpit::picture();
        if bands.draw(ROW, &mut sink, |band| picture.draw(band)).is_err() {
            report::exit(false)
        }
    }
    stack::report(sum.0);
    report::exit(true)
}
