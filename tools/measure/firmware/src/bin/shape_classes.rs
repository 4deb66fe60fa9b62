//! Counts the methods of antialiasing on the shape classes of the accuracy report: from corners to a mask of 48 x 48 bytes.
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use zrow_measure_firmware::{
    report,
    run::{Canvas, Checksum, Runner},
    stopwatch::Stopwatch,
};
use zrow_methods::{Class, Input, METHODS, SHAPES, SIZE};

struct Mask([u8; SIZE * SIZE]);

impl Canvas for Mask {
    fn erase(&mut self) {
        self.0.fill(0);
    }

    fn checksum(&mut self) -> u32 {
        Checksum::of(self.0.iter().map(|coverage| u16::from(*coverage)))
    }
}

#[entry]
fn main() -> ! {
    let mut words = [0; 512];
    let wanted = report::wanted(&mut words);
    let Some(peripherals) = Peripherals::take() else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    let mut mask = Mask([0; SIZE * SIZE]);
    for class in Class::ALL {
        if runner.wants(class.count_name()) {
            let inputs: [Input; SHAPES as usize] = core::array::from_fn(|number| input(class, number as u32));
            for method in METHODS {
                // The last shape stays in the mask.
                runner.count(class.count_name(), method.name, &mut mask, &inputs, |mask, input| {
                    mask.erase();
                    (method.cover)(input, &mut mask.0);
                });
            }
        }
    }
    report::exit(true)
}

fn input(class: Class, number: u32) -> Input {
    match Input::new(&class.shape(number)) {
        Ok(input) => input,
        Err(_) => report::exit(false),
    }
}
