//! A gauge of 76 antialiased outlines as a picture that sends what changes, through one row, and nothing else.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use zrow::geometry::Window;
use zrow_measure_firmware::{panel::draw_changes, report, run::Checksum, stack};
use zrow_scenes::gauge::{BACKGROUND, FRAMES, Gauge};

#[entry]
fn main() -> ! {
    static mut ROW: [u16; 240] = [0; 240];
    static mut AREAS: [Window; 16] = [Window::EMPTY; 16];
    static mut GAUGE: Gauge = Gauge::new();
    let Ok((mut picture, changing)) = GAUGE.prepare(AREAS, 0) else {
        report::exit(false)
    };
    let mut sum = Checksum::default();
    for frame in 0..FRAMES {
        if changing.show(&mut picture, frame).is_err() {
            report::exit(false)
        }
        draw_changes(&mut picture, BACKGROUND, ROW, |words| sum.add(words.iter().copied()));
    }
    stack::report(sum.0);
    report::exit(true)
}
