//! The ST7789 behind a DMA channel: one band is sent while the next one is drawn.
//!
//! ```text
//! core   | draw 0 | start | draw 1 | finish, start | draw 2 | finish, start | ...
//! DMA             |   send 0   |   |       send 1       |   |      send 2      ...
//! ```
//!
//! The bus sends frames of 16 bits, so that a word of colour needs no turning of bytes and takes one transfer of the DMA. A
//! command of 8 bits is sent with a NOP (0x00) before it, and the coordinates of a window are 16 bits each anyway. The window
//! reaches from the first row of a picture to the lower end of the panel and is set once a picture: bands that follow each
//! other are a single stream of pixels.

use core::convert::Infallible;

use embedded_graphics::{pixelcolor::Rgb565, primitives::Rectangle};
use embedded_hal::{digital::OutputPin, spi::SpiBus};
use rp2040_hal::dma::{
    ReadTarget, SingleChannel, WriteTarget,
    single_buffer::{Config, Transfer},
};
use zrow::band::{LittleEndian, LoopError, OverlappingSink};

use crate::stopwatch::Moment;

/// Columns and rows of the panel.
pub const WIDTH: u32 = 240;
pub const HEIGHT: u32 = 320;

const SET_COLUMNS: u16 = 0x2a;
const SET_ROWS: u16 = 0x2b;
const WRITE_PIXELS: u16 = 0x2c;

/// How often the DMA is asked whether it is done before its band is given up. A band takes 7,680 cycles, and a look no fewer than
/// four: the DMA has at least thirteen times as long as it needs.
const MOST_LOOKS: u32 = 25_000;

/// Why a band was not sent.
#[derive(Debug)]
pub enum Error {
    /// The DMA did not come to an end and was stopped.
    Timeout,
    /// The DMA still sends another band.
    Busy,
    /// The band is not as large as its buffer, all of which the DMA sends, or not within the panel.
    Area,
}

/// Core cycles that sending has taken, and those in which the core only waited for the bus.
#[derive(Clone, Copy, Default)]
pub struct Cycles {
    pub sending: u32,
    pub waiting: u32,
}

/// The panel, its bus, and the DMA channel that feeds it.
pub struct Panel<CHANNEL, BUS, DC> {
    /// Not here while a transfer has them.
    idle: Option<(CHANNEL, BUS)>,
    data_not_command: DC,
    /// The left column, the width and the top row of a band that goes on where the last one ended.
    next: Option<(i32, u32, i32)>,
    cycles: Cycles,
}

impl<CHANNEL, BUS, DC> Panel<CHANNEL, BUS, DC>
where
    BUS: SpiBus<u16, Error = Infallible>,
    DC: OutputPin<Error = Infallible>,
{
    /// A panel that is switched on, whose select is low, and on whose bus nothing else is.
    pub fn new(channel: CHANNEL, bus: BUS, data_not_command: DC) -> Self {
        Self {
            idle: Some((channel, bus)),
            data_not_command,
            next: None,
            cycles: Cycles::default(),
        }
    }

    /// The cycles since the last call; the next band begins a picture, also where the last one was not sent to its end.
    pub fn end_picture(&mut self) -> Cycles {
        self.next = None;
        core::mem::take(&mut self.cycles)
    }

    /// Tells the panel where the pixels that follow are to go.
    fn set_window(&mut self, bus: &mut BUS, left: i32, width: u32, top: i32) -> Result<(), Error> {
        let first = u16::try_from(left).map_err(|_| Error::Area)?;
        let top = u16::try_from(top).map_err(|_| Error::Area)?;
        let last = u16::try_from(u32::from(first) + width - 1).map_err(|_| Error::Area)?;
        if u32::from(last) >= WIDTH || u32::from(top) >= HEIGHT {
            return Err(Error::Area);
        }
        self.send(bus, SET_COLUMNS, &[first, last]);
        self.send(bus, SET_ROWS, &[top, HEIGHT as u16 - 1]);
        self.send(bus, WRITE_PIXELS, &[]);
        Ok(())
    }

    /// Sends a command and its operands.
    fn send(&mut self, bus: &mut BUS, command: u16, operands: &[u16]) {
        // The level of the pin is read with the last bit of a byte: it must not change before the bus is idle.
        let Ok(()) = bus.flush();
        let Ok(()) = self.data_not_command.set_low();
        let Ok(()) = bus.write(&[command]);
        let Ok(()) = bus.flush();
        let Ok(()) = self.data_not_command.set_high();
        let Ok(()) = bus.write(operands);
    }
}

impl<CHANNEL, BUS, DC, const N: usize> OverlappingSink<Rgb565, LittleEndian, &'static mut [u16; N]>
    for Panel<CHANNEL, BUS, DC>
where
    CHANNEL: SingleChannel,
    BUS: SpiBus<u16, Error = Infallible> + WriteTarget<TransmittedWord = u16>,
    DC: OutputPin<Error = Infallible>,
    &'static mut [u16; N]: ReadTarget<ReceivedWord = u16>,
{
    type Transfer = Transfer<CHANNEL, &'static mut [u16; N], BUS>;
    type Error = Error;

    fn start(
        &mut self,
        area: Rectangle,
        buffer: &'static mut [u16; N],
    ) -> Result<Self::Transfer, (&'static mut [u16; N], LoopError<Error>)> {
        let begin = Moment::now();
        let (left, width, top) = (area.top_left.x, area.size.width, area.top_left.y);
        let Some((channel, mut bus)) = self.idle.take() else {
            return Err((buffer, LoopError::Sink(Error::Busy)));
        };
        let ready = if (width * area.size.height) as usize != N {
            Err(Error::Area)
        } else if self.next == Some((left, width, top)) {
            Ok(())
        } else {
            self.set_window(&mut bus, left, width, top)
        };
        if let Err(error) = ready {
            self.idle = Some((channel, bus));
            return Err((buffer, LoopError::Sink(error)));
        }
        self.next = Some((left, width, top + area.size.height as i32));
        let transfer = Config::new(channel, buffer, bus).start();
        self.cycles.sending += begin.elapsed();
        Ok(transfer)
    }

    fn finish(&mut self, transfer: Self::Transfer) -> (&'static mut [u16; N], Result<(), Error>) {
        let begin = Moment::now();
        // Whatever the hardware does, this ends, and the buffer comes back.
        let is_done = (0..MOST_LOOKS).any(|_| transfer.is_done());
        let done = Moment::now();
        let (channel, buffer, bus) = if is_done { transfer.wait() } else { transfer.abort() };
        self.idle = Some((channel, bus));
        self.cycles.waiting += begin.cycles_to(done);
        self.cycles.sending += done.elapsed();
        (buffer, if is_done { Ok(()) } else { Err(Error::Timeout) })
    }
}
