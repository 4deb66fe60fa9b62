//! embedded-hal's `SpiBus` over the SSI0 port.

use crate::gpio;
use crate::registers::{ClockGate1, Control0, Control1, Peripherals, Ssi, Status};
use core::convert::Infallible;
use embedded_hal::spi::{ErrorType, SpiBus};
use tock_registers::interfaces::{ReadWriteable, Readable, Writeable};

/// SSI0: clock on A2, input on A4, output on A5.
const PINS: u32 = 1 << 2 | 1 << 4 | 1 << 5;
/// 12 MHz / 4 = 3 MHz: the SSD0323 takes at most 4 MHz, and the divider has to be even.
const CLOCK_PRESCALE: u32 = 4;

/// The SSI0 port as the controller of an SPI bus, one byte a word.
pub struct Spi {
    ssi: &'static Ssi,
}

impl Spi {
    /// Sets the port up for the OLED: 3 MHz out of the 12 MHz after reset, clock idle high, data taken on its first
    /// edge. Port A must have its clock already.
    pub fn new(peripherals: &Peripherals) -> Self {
        peripherals.system_control.clock_gate1.modify(ClockGate1::SSI0::SET);
        gpio::give_to_peripheral(peripherals.port_a, PINS);
        let ssi = peripherals.ssi0;
        ssi.control1.set(0);
        ssi.clock_prescale.set(CLOCK_PRESCALE);
        ssi.control0.write(
            Control0::DATA_SIZE::Byte
                + Control0::FRAME_FORMAT::Motorola
                + Control0::CLOCK_POLARITY::IdleHigh
                + Control0::CLOCK_PHASE::FirstEdge
                + Control0::SERIAL_RATE.val(0),
        );
        ssi.control1.write(Control1::ENABLE::SET + Control1::PERIPHERAL::CLEAR);
        Self { ssi }
    }

    /// Queues a byte as soon as the transmit FIFO has room.
    fn send(&mut self, byte: u8) {
        while !self.ssi.status.is_set(Status::TRANSMIT_NOT_FULL) {}
        self.ssi.data.set(u32::from(byte));
    }

    /// Throws away what came in. QEMU stalls a port whose receive FIFO is full, hardware drops bytes.
    fn drain(&mut self) {
        while self.ssi.status.is_set(Status::RECEIVE_NOT_EMPTY) {
            self.ssi.data.get();
        }
    }

    /// Sends one byte and waits for the one that comes back.
    fn exchange(&mut self, byte: u8) -> u8 {
        self.send(byte);
        while !self.ssi.status.is_set(Status::RECEIVE_NOT_EMPTY) {}
        self.ssi.data.get().to_le_bytes()[0]
    }
}

impl ErrorType for Spi {
    type Error = Infallible;
}

impl SpiBus for Spi {
    fn write(&mut self, words: &[u8]) -> Result<(), Infallible> {
        for &word in words {
            self.send(word);
            self.drain();
        }
        Ok(())
    }

    fn read(&mut self, words: &mut [u8]) -> Result<(), Infallible> {
        self.flush()?;
        for word in words {
            *word = self.exchange(0);
        }
        Ok(())
    }

    fn transfer(&mut self, read: &mut [u8], write: &[u8]) -> Result<(), Infallible> {
        self.flush()?;
        for index in 0..read.len().max(write.len()) {
            let incoming = self.exchange(write.get(index).copied().unwrap_or(0));
            if let Some(word) = read.get_mut(index) {
                *word = incoming;
            }
        }
        Ok(())
    }

    fn transfer_in_place(&mut self, words: &mut [u8]) -> Result<(), Infallible> {
        self.flush()?;
        for word in words {
            *word = self.exchange(*word);
        }
        Ok(())
    }

    fn flush(&mut self) -> Result<(), Infallible> {
        while self.ssi.status.is_set(Status::BUSY) {}
        self.drain();
        Ok(())
    }
}
