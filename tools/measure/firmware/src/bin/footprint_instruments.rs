//! The panel of antialiased instruments as a picture that sends what changes, through one row, and nothing else.
#![no_std]
#![no_main]

use core::convert::Infallible;

use cortex_m_rt::entry;
use zrow::{
    band::{Band, PictureLoop},
    geometry::Window,
};
use zrow_measure_firmware::{report, run::Checksum, stack};
use zrow_scenes::{
    Scene,
    instruments::{DAMAGE_AREAS, Instruments},
};

#[entry]
fn main() -> ! {
    static mut ROW: [u16; 240] = [0; 240];
    static mut AREAS: [Window; DAMAGE_AREAS] = [Window::EMPTY; DAMAGE_AREAS];
    static mut PANEL: Instruments = Instruments::new();
    let Ok((mut picture, changing)) = PANEL.prepare_with_damage(AREAS, 0) else {
        report::exit(false)
    };
    let mut sum = Checksum::default();
    let mut sink = |band: Band<'_, _>| -> Result<(), Infallible> {
        sum.add(band.words().iter().copied());
        Ok(())
    };
    for frame in 0..64 {
        if changing.show(&mut picture, frame).is_err() {
            report::exit(false)
        }
        while let Some(area) = picture.next_damage() {
            let bands = PictureLoop::new(area, Instruments::BACKGROUND);
            if bands.draw(ROW, &mut sink, |band| picture.draw(band)).is_err() {
                report::exit(false)
            }
        }
    }
    stack::report(sum.0);
    report::exit(true)
}
