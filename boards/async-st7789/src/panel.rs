//! An ST7789 on a bus whose transfers are futures: one band is sent by DMA while the next one is drawn.
//!
//! ```text
//! core   | draw 0 | poll 0 | draw 1 | await 0, poll 1 | draw 2 | await 1, poll 2 | ...
//! DMA             |  send 0 ...     |    send 1 ...            |    send 2 ...
//! ```
//!
//! The bus has to start the DMA before the future of a transfer is first pending. The commands that say where pixels go are therefore
//! written without a future, 11 bytes, and only where a band does not go on where the last one ended: the window reaches from the
//! first row of a picture to the lower end of the panel, so that the bands of a picture are a single stream.

use core::{convert::Infallible, mem};

use embedded_graphics::primitives::Rectangle;
use embedded_hal::{delay::DelayNs, digital::OutputPin, spi::SpiBus};
use embedded_hal_bus::spi::ExclusiveDevice;
use mipidsi::{Builder, interface::SpiInterface, models::ST7789, options::ColorInversion};

/// Columns of the panel.
pub const WIDTH: u32 = 240;
/// Rows of the panel's memory. A module of 240 x 240 pixels shows the upper 240.
pub const HEIGHT: u32 = 320;

const SET_COLUMNS: u8 = 0x2a;
const SET_ROWS: u8 = 0x2b;
const WRITE_PIXELS: u8 = 0x2c;

/// Why a band was not sent; `E` is the error of the bus.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Error<E> {
    /// The bus failed.
    Bus(E),
    /// The band is not within the panel, or has another number of bytes than its area.
    Area,
}

/// The panel could not be switched on: the bus failed.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct StartError;

/// The pins of the panel beside its bus.
pub struct Pins<P> {
    /// Low for commands, high for their operands and for pixels: DC, or RS.
    pub data_not_command: P,
    /// Low while the panel listens: CS.
    pub select: P,
    /// Low resets the panel: RES, or RST.
    pub reset: P,
    /// High lights it: BL, or LED.
    pub backlight: P,
}

/// The panel, and its bus, on which nothing else is.
pub struct Panel<BUS, P> {
    bus: BUS,
    settle: fn(&mut BUS),
    pins: Pins<P>,
    /// The left column, the width and the top row of a band that goes on where the last one ended.
    next: Option<(i32, u32, i32)>,
}

impl<BUS, P> Panel<BUS, P>
where
    BUS: SpiBus,
    P: OutputPin<Error = Infallible>,
{
    /// Switches the panel on, black and then lit. Where the future of a transfer is dropped, `settle` waits until the bus reads no more
    /// of its bytes and sends none.
    ///
    /// # Errors
    /// The bus fails.
    pub fn start(
        mut bus: BUS,
        settle: fn(&mut BUS),
        mut pins: Pins<P>,
        delay: &mut impl DelayNs,
    ) -> Result<Self, StartError> {
        // mipidsi switches the panel on, over a bus and pins that it only borrows.
        let Ok(device) = ExclusiveDevice::new_no_delay(&mut bus, &mut pins.select);
        let mut bytes = [0; 16];
        let interface = SpiInterface::new(device, &mut pins.data_not_command, &mut bytes);
        Builder::new(ST7789, interface)
            .reset_pin(&mut pins.reset)
            .display_size(WIDTH as u16, HEIGHT as u16)
            .invert_colors(ColorInversion::Inverted)
            .init(delay)
            .map_err(|_| StartError)?;
        let Ok(()) = pins.select.set_low();
        let mut panel = Self {
            bus,
            settle,
            pins,
            next: None,
        };
        panel.clear().map_err(|_| StartError)?;
        let Ok(()) = panel.pins.backlight.set_high();
        Ok(panel)
    }

    /// Makes the whole panel black.
    fn clear(&mut self) -> Result<(), Error<BUS::Error>> {
        self.set_window(0, WIDTH, 0)?;
        for _ in 0..HEIGHT * WIDTH / 32 {
            self.bus.write(&[0; 64]).map_err(Error::Bus)?;
        }
        self.bus.flush().map_err(Error::Bus)
    }

    /// Tells the panel where the pixels that follow are to go.
    fn set_window(&mut self, left: i32, width: u32, top: i32) -> Result<(), Error<BUS::Error>> {
        let first = u16::try_from(left).map_err(|_| Error::Area)?;
        let top = u16::try_from(top).map_err(|_| Error::Area)?;
        let end = u32::from(first).saturating_add(width);
        if width == 0 || end > WIDTH || u32::from(top) >= HEIGHT {
            return Err(Error::Area);
        }
        self.command(SET_COLUMNS, &range(first, (end - 1) as u16))?;
        self.command(SET_ROWS, &range(top, (HEIGHT - 1) as u16))?;
        self.command(WRITE_PIXELS, &[])
    }

    /// Sends a command and its operands.
    fn command(&mut self, command: u8, operands: &[u8]) -> Result<(), Error<BUS::Error>> {
        // The level of the pin is read with the last bit of a byte: it must not change before the bus is idle.
        self.bus.flush().map_err(Error::Bus)?;
        let Ok(()) = self.pins.data_not_command.set_low();
        self.bus.write(&[command]).map_err(Error::Bus)?;
        self.bus.flush().map_err(Error::Bus)?;
        let Ok(()) = self.pins.data_not_command.set_high();
        if operands.is_empty() {
            return Ok(());
        }
        self.bus.write(operands).map_err(Error::Bus)?;
        self.bus.flush().map_err(Error::Bus)
    }
}

impl<BUS, P> Panel<BUS, P>
where
    BUS: SpiBus + embedded_hal_async::spi::SpiBus,
    P: OutputPin<Error = Infallible>,
{
    /// Sends the bytes of a band. Where the bus has a DMA, it runs when the future is first pending. Of a future that is dropped
    /// before its end, the pixels are lost, and the next band is where it belongs all the same: the bus settles first.
    ///
    /// # Errors
    /// The bus fails, the area is not within the panel, or there are other than two bytes for each of its pixels.
    pub async fn send(&mut self, area: Rectangle, bytes: &[u8]) -> Result<(), Error<BUS::Error>> {
        let (left, width, top) = (area.top_left.x, area.size.width, area.top_left.y);
        let bottom = i64::from(top) + i64::from(area.size.height);
        let is_whole = u64::from(width) * u64::from(area.size.height) * 2 == bytes.len() as u64;
        if !is_whole || bottom > i64::from(HEIGHT) {
            return Err(Error::Area);
        }
        // Until all is sent, nobody knows where the panel is.
        if self.next.take() != Some((left, width, top)) {
            self.set_window(left, width, top)?;
        }
        let transfer = Transfer {
            bus: &mut self.bus,
            settle: self.settle,
        };
        transfer.send(bytes).await.map_err(Error::Bus)?;
        self.next = Some((left, width, bottom as i32));
        Ok(())
    }
}

/// A transfer, after which the bus settles where its future is dropped before its end.
struct Transfer<'a, BUS> {
    bus: &'a mut BUS,
    settle: fn(&mut BUS),
}

impl<BUS: embedded_hal_async::spi::SpiBus> Transfer<'_, BUS> {
    async fn send(self, bytes: &[u8]) -> Result<(), BUS::Error> {
        let mut result = self.bus.write(bytes).await;
        if result.is_ok() {
            result = self.bus.flush().await;
        }
        mem::forget(self);
        result
    }
}

impl<BUS> Drop for Transfer<'_, BUS> {
    fn drop(&mut self) {
        (self.settle)(self.bus);
    }
}

/// The first and the last column or row, big-endian.
fn range(first: u16, last: u16) -> [u8; 4] {
    let ([a, b], [c, d]) = (first.to_be_bytes(), last.to_be_bytes());
    [a, b, c, d]
}
