//! SPIM3, the only one of the chip that is faster than 8 MHz, with buffers in RAM that is theirs alone.
//!
//! SPIM3 sends wrong bytes where the core accesses the block of RAM that they lie in at the same moment (Nordic, "nRF52840 Errata",
//! anomaly 198). Each of two bands therefore fills a block, so that one is drawn while the other one is sent; a command is copied
//! behind the first band, and the core waits until it is sent.

use core::sync::atomic::{Ordering, compiler_fence};

use embassy_nrf::{
    pac::SPIM3,
    spim::{Error, Spim},
};
use embedded_hal::spi::{ErrorType, SpiBus};
use zrow_async_st7789::WIDTH;

/// Words of a block of RAM.
const BLOCK: usize = 8 * 1024 / 2;
/// Words of a band: the rows that a block has room for, but for one.
const WORDS: usize = 16 * WIDTH as usize;
/// Bytes of a command, or of some of the pixels with which the panel is cleared.
const COMMAND: usize = 64;

/// A block of RAM, and nothing else in it.
#[repr(C, align(8192))]
struct Block {
    band: [u16; WORDS],
    command: [u8; COMMAND],
    rest: [u8; 2 * (BLOCK - WORDS) - COMMAND],
}

impl Block {
    const EMPTY: Self = Self {
        band: [0; WORDS],
        command: [0; COMMAND],
        rest: [0; _],
    };
}

/// Two blocks.
pub struct Blocks([Block; 2]);

impl Blocks {
    /// Blocks of zeros.
    pub const EMPTY: Self = Self([Block::EMPTY; 2]);

    /// The bands, and the bus that sends them.
    pub fn split(&'static mut self, spim: Spim<'static>) -> ([&'static mut [u16]; 2], Bus) {
        let [one, other] = &mut self.0;
        let command = &mut one.command;
        ([&mut one.band, &mut other.band], Bus { spim, command })
    }
}

/// The bus of the panel.
pub struct Bus {
    spim: Spim<'static>,
    command: &'static mut [u8; COMMAND],
}

impl Bus {
    /// Waits for the end of a transfer that has begun, 2 ms at most: the DMA goes on where its future is dropped.
    pub fn settle(&mut self) {
        while SPIM3.events_end().read() == 0 {}
        // The band that was sent is drawn over from here on, and not before.
        compiler_fence(Ordering::SeqCst);
    }
}

impl ErrorType for Bus {
    type Error = Error;
}

/// For commands.
impl SpiBus for Bus {
    fn write(&mut self, words: &[u8]) -> Result<(), Error> {
        for chunk in words.chunks(COMMAND) {
            let command = &mut self.command[..chunk.len()];
            command.copy_from_slice(chunk);
            self.spim.blocking_write_from_ram(command)?;
        }
        Ok(())
    }

    fn read(&mut self, words: &mut [u8]) -> Result<(), Error> {
        self.spim.blocking_read(words)
    }

    fn transfer(&mut self, read: &mut [u8], write: &[u8]) -> Result<(), Error> {
        self.spim.blocking_transfer(read, write)
    }

    fn transfer_in_place(&mut self, words: &mut [u8]) -> Result<(), Error> {
        self.spim.blocking_transfer_in_place(words)
    }

    fn flush(&mut self) -> Result<(), Error> {
        Ok(())
    }
}

/// For bands.
impl embedded_hal_async::spi::SpiBus for Bus {
    async fn write(&mut self, words: &[u8]) -> Result<(), Error> {
        self.spim.write_from_ram(words).await
    }

    async fn read(&mut self, words: &mut [u8]) -> Result<(), Error> {
        self.spim.read(words).await
    }

    async fn transfer(&mut self, read: &mut [u8], write: &[u8]) -> Result<(), Error> {
        self.spim.transfer(read, write).await
    }

    async fn transfer_in_place(&mut self, words: &mut [u8]) -> Result<(), Error> {
        self.spim.transfer_in_place(words).await
    }

    async fn flush(&mut self) -> Result<(), Error> {
        Ok(())
    }
}
