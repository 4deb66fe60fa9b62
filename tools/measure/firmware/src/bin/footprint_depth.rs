//! The torus and the cube through one row of colours and one row of depths, and nothing else: no face has to be cut.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use embedded_graphics::pixelcolor::Rgb565;
use zrow::scene::{OnePass, Whole};
use zrow_measure_firmware::{report, run::Canvas, stack, standard::Sc1};

#[entry]
fn main() -> ! {
    static mut SC1: Sc1<Whole<OnePass<Rgb565>>> = Sc1::EMPTY;
    let checksum = SC1.checksum();
    stack::report(checksum);
    report::exit(true)
}
