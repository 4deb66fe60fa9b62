//! The cockpit of antialiased shapes and texts as a picture, everything prepared anew, through one row, and nothing else.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use zrow_measure_firmware::{panel::draw_frame, report, run::Checksum, stack};
use zrow_scenes::{Scene, cockpit::Cockpit};

#[entry]
fn main() -> ! {
    static mut ROW: [u16; 240] = [0; 240];
    static mut COCKPIT: Cockpit = Cockpit::new();
    let mut sum = Checksum::default();
    for frame in 0..Cockpit::FRAMES {
        draw_frame(COCKPIT, frame, ROW, |words| sum.add(words.iter().copied()));
    }
    stack::report(sum.0);
    report::exit(true)
}
