//! The panel of antialiased instruments as a picture that sends what changes, through one row, and nothing else.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use zrow::geometry::Window;
use zrow_measure_firmware::{panel::draw_changes, report, run::Checksum, stack};
use zrow_scenes::{
    Scene,
    instruments::{Changing, DAMAGE_AREAS, Instruments},
};

#[entry]
fn main() -> ! {
    static mut ROW: [u16; 240] = [0; 240];
    static mut AREAS: [Window; DAMAGE_AREAS] = [Window::EMPTY; DAMAGE_AREAS];
    static mut PANEL: Instruments = Instruments::new();
    let mut picture = PANEL.picture_with_damage(AREAS);
    let Ok(changing) = Changing::add(&mut picture, 0) else {
        report::exit(false)
    };
    let mut sum = Checksum::default();
    for frame in 0..64 {
        if changing.show(&mut picture, frame).is_err() {
            report::exit(false)
        }
        draw_changes(&mut picture, Instruments::BACKGROUND, ROW, |words| {
            sum.add(words.iter().copied())
        });
    }
    stack::report(sum.0);
    report::exit(true)
}
