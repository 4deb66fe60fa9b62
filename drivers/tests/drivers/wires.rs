//! Wires that record what a driver sends, by each of the traits that drivers send by.

use std::{cell::RefCell, convert::Infallible, rc::Rc};

use display_interface::{AsyncWriteOnlyDataCommand, DataFormat, DisplayError, WriteOnlyDataCommand};
use embedded_hal::{
    delay::DelayNs,
    digital::{self, InputPin, OutputPin},
    spi::{self, Operation, SpiDevice},
};

/// A command with its data, as the panel sees them.
pub type Command = (u8, Vec<u8>);

#[derive(Debug, Clone, Default)]
pub struct Wires(Rc<RefCell<(bool, Vec<Command>)>>);

impl Wires {
    pub fn send(&self, is_data: bool, bytes: impl IntoIterator<Item = u8>) {
        let commands = &mut self.0.borrow_mut().1;
        for byte in bytes {
            match (is_data, commands.last_mut()) {
                (true, Some((_, data))) => data.push(byte),
                (true, None) => panic!("data before a command"),
                (false, _) => commands.push((byte, Vec::new())),
            }
        }
    }

    /// Bytes that are data or commands as the data/command pin says.
    pub fn send_by_pin(&self, bytes: &[u8]) {
        let is_data = self.0.borrow().0;
        self.send(is_data, bytes.iter().copied());
    }

    /// The bytes that were recorded since this was last asked for.
    pub fn take(&self) -> Vec<Command> {
        std::mem::take(&mut self.0.borrow_mut().1)
    }

    /// The data of all commands of one code since the last call, one after the other.
    pub fn data_of(&self, code: u8) -> Vec<u8> {
        self.take()
            .into_iter()
            .filter(|(command, _)| *command == code)
            .flat_map(|(_, data)| data)
            .collect()
    }

    fn send_format(&self, is_data: bool, format: DataFormat<'_>) -> Result<(), DisplayError> {
        match format {
            DataFormat::U8(bytes) => self.send(is_data, bytes.iter().copied()),
            DataFormat::U8Iter(bytes) => self.send(is_data, bytes),
            DataFormat::U16BE(words) => self.send(is_data, words.iter().flat_map(|word| word.to_be_bytes())),
            DataFormat::U16BEIter(words) => self.send(is_data, words.flat_map(u16::to_be_bytes)),
            _ => return Err(DisplayError::DataFormatNotImplemented),
        }
        Ok(())
    }
}

impl WriteOnlyDataCommand for Wires {
    fn send_commands(&mut self, commands: DataFormat<'_>) -> Result<(), DisplayError> {
        self.send_format(false, commands)
    }

    fn send_data(&mut self, data: DataFormat<'_>) -> Result<(), DisplayError> {
        self.send_format(true, data)
    }
}

impl AsyncWriteOnlyDataCommand for Wires {
    async fn send_commands(&mut self, commands: DataFormat<'_>) -> Result<(), DisplayError> {
        self.send_format(false, commands)
    }

    async fn send_data(&mut self, data: DataFormat<'_>) -> Result<(), DisplayError> {
        self.send_format(true, data)
    }
}

impl spi::ErrorType for Wires {
    type Error = Infallible;
}

impl SpiDevice for Wires {
    fn transaction(&mut self, operations: &mut [Operation<'_, u8>]) -> Result<(), Infallible> {
        for operation in operations {
            let Operation::Write(bytes) = operation else {
                panic!("the panel is only written to");
            };
            self.send_by_pin(bytes);
        }
        Ok(())
    }
}

impl digital::ErrorType for Wires {
    type Error = Infallible;
}

/// The data/command pin.
impl OutputPin for Wires {
    fn set_low(&mut self) -> Result<(), Infallible> {
        self.0.borrow_mut().0 = false;
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        self.0.borrow_mut().0 = true;
        Ok(())
    }
}

impl lcd_async::interface::Interface for Wires {
    type Word = u8;
    type Error = Infallible;
    const KIND: lcd_async::interface::InterfaceKind = lcd_async::interface::InterfaceKind::Serial4Line;

    async fn send_command(&mut self, command: u8, args: &[u8]) -> Result<(), Infallible> {
        self.send(false, [command]);
        self.send(true, args.iter().copied());
        Ok(())
    }

    async fn send_data_slice(&mut self, data: &[u8]) -> Result<(), Infallible> {
        self.send(true, data.iter().copied());
        Ok(())
    }
}

/// A pin or a delay that does nothing; as an input it is low: not busy.
#[derive(Clone, Copy)]
pub struct Unused;

impl digital::ErrorType for Unused {
    type Error = Infallible;
}

impl OutputPin for Unused {
    fn set_low(&mut self) -> Result<(), Infallible> {
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        Ok(())
    }
}

impl InputPin for Unused {
    fn is_high(&mut self) -> Result<bool, Infallible> {
        Ok(false)
    }

    fn is_low(&mut self) -> Result<bool, Infallible> {
        Ok(true)
    }
}

impl DelayNs for Unused {
    fn delay_ns(&mut self, _: u32) {}
}
