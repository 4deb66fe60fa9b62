//! Output pins of a GPIO port.

use crate::registers::Port;
use core::convert::Infallible;
use embedded_hal::digital::{ErrorType, OutputPin};
use tock_registers::interfaces::{Readable, Writeable};
use tock_registers::registers::ReadWrite;

/// One pin as a digital output.
pub struct Output {
    level: &'static ReadWrite<u32>,
    mask: u32,
}

impl Output {
    /// Makes pin `NUMBER` (0..=7) of `port` an output, low at first.
    pub fn new<const NUMBER: usize>(port: &'static Port) -> Self {
        const { assert!(NUMBER < 8) }
        let mask = 1 << NUMBER;
        port.direction.set(port.direction.get() | mask);
        port.digital_enable.set(port.digital_enable.get() | mask);
        Self {
            level: &port.data[1 << NUMBER],
            mask,
        }
    }
}

/// Hands the pins in `mask` to the peripheral they belong to.
pub fn give_to_peripheral(port: &Port, mask: u32) {
    port.alternate_function.set(port.alternate_function.get() | mask);
    port.digital_enable.set(port.digital_enable.get() | mask);
}

impl ErrorType for Output {
    type Error = Infallible;
}

impl OutputPin for Output {
    fn set_low(&mut self) -> Result<(), Infallible> {
        self.level.set(0);
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        self.level.set(self.mask);
        Ok(())
    }
}
