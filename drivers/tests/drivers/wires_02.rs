//! The recording wires by the traits of embedded-hal 0.2, as drivers from before embedded-hal 1 take them.

use std::convert::Infallible;

use display_interface_04::{DataFormat, DisplayError, WriteOnlyDataCommand};
use embedded_hal_02::{
    blocking::{delay::DelayUs, spi::Write},
    digital::v2::OutputPin,
};

use crate::wires::{Unused, Wires};

impl Write<u8> for Wires {
    type Error = Infallible;

    fn write(&mut self, bytes: &[u8]) -> Result<(), Infallible> {
        self.send_by_pin(bytes);
        Ok(())
    }
}

/// The data/command pin.
impl OutputPin for Wires {
    type Error = Infallible;

    fn set_low(&mut self) -> Result<(), Infallible> {
        embedded_hal::digital::OutputPin::set_low(self)
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        embedded_hal::digital::OutputPin::set_high(self)
    }
}

impl WriteOnlyDataCommand for Wires {
    fn send_commands(&mut self, commands: DataFormat<'_>) -> Result<(), DisplayError> {
        send_format(self, false, commands)
    }

    fn send_data(&mut self, data: DataFormat<'_>) -> Result<(), DisplayError> {
        send_format(self, true, data)
    }
}

fn send_format(wires: &Wires, is_data: bool, format: DataFormat<'_>) -> Result<(), DisplayError> {
    match format {
        DataFormat::U8(bytes) => wires.send(is_data, bytes.iter().copied()),
        DataFormat::U8Iter(bytes) => wires.send(is_data, bytes),
        DataFormat::U16BEIter(words) => wires.send(is_data, words.flat_map(u16::to_be_bytes)),
        _ => return Err(DisplayError::DataFormatNotImplemented),
    }
    Ok(())
}

impl OutputPin for Unused {
    type Error = Infallible;

    fn set_low(&mut self) -> Result<(), Infallible> {
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        Ok(())
    }
}

impl DelayUs<u32> for Unused {
    fn delay_us(&mut self, _: u32) {}
}
