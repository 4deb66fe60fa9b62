//! What the 2D picture and the scene take together.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use embedded_graphics::pixelcolor::Rgb565;
use zrow::scene::{OnePass, Whole};
use zrow_measure_firmware::{picture, report, run::Canvas, stack, standard::Sc1};

#[entry]
fn main() -> ! {
    static mut ROW: [u16; picture::WIDTH] = [0; picture::WIDTH];
    static mut SC1: Sc1<Whole<OnePass<Rgb565>>> = Sc1::EMPTY;
    let checksum = picture::shapes(ROW) ^ SC1.checksum();
    stack::report(checksum);
    report::exit(true)
}
