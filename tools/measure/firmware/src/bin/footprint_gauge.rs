//! A gauge of 76 antialiased outlines as a picture that sends what changes, through one row, and nothing else.
#![no_std]
#![no_main]

use core::convert::Infallible;

use cortex_m_rt::entry;
use zrow::{
    band::{Band, PictureLoop},
    geometry::Window,
};
use zrow_measure_firmware::{report, run::Checksum, stack};
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
    let mut sink = |band: Band<'_, _>| -> Result<(), Infallible> {
        sum.add(band.words().iter().copied());
        Ok(())
    };
    for frame in 0..FRAMES {
        if changing.show(&mut picture, frame).is_err() {
            report::exit(false)
        }
        while let Some(area) = picture.next_damage() {
            let bands = PictureLoop::new(area, BACKGROUND);
            if bands.draw(ROW, &mut sink, |band| picture.draw(band)).is_err() {
                report::exit(false)
            }
        }
    }
    stack::report(sum.0);
    report::exit(true)
}
