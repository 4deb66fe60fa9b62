//! Driver of the SSD0323, the controller of a 128 x 64 OLED with 16 greys.
//!
//! Two pixels share a byte, the left one in the high nibble; a row is 64 bytes, which is how zrow packs `Gray4` bands.
//! Solomon Systech, "SSD0323 Advance Information", section 9 (command table). Generic over embedded-hal, so that the host
//! tests it too.

use embedded_hal::{digital::OutputPin, spi::SpiDevice};

/// Pixels a row.
pub const WIDTH: usize = 128;
/// Rows of the panel (the controller has memory for 80).
pub const HEIGHT: usize = 64;
/// Bytes a row.
pub const ROW_BYTES: usize = WIDTH / 2;

mod command {
    pub const SET_COLUMNS: u8 = 0x15;
    pub const SET_ROWS: u8 = 0x75;
    pub const SET_CONTRAST: u8 = 0x81;
    pub const FULL_CURRENT: u8 = 0x86;
    pub const SET_REMAP: u8 = 0xa0;
    pub const SET_START_LINE: u8 = 0xa1;
    pub const SET_OFFSET: u8 = 0xa2;
    pub const NORMAL_DISPLAY: u8 = 0xa4;
    pub const SET_MULTIPLEX: u8 = 0xa8;
    pub const DISPLAY_OFF: u8 = 0xae;
    pub const DISPLAY_ON: u8 = 0xaf;
}

/// The address moves along the row first (bit 2 clear). How this panel hangs on its controller: rows alternate between two
/// sides (bit 6) from the last one up (bit 4), and the high nibble is the left pixel (bit 1).
const REMAP: u8 = 0b0101_0010;
/// The panel's first row lies at this row of the controller's memory.
const OFFSET: u8 = 0x4c;

/// What can go wrong while talking to the panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Error<SpiError, PinError> {
    /// The bus failed.
    Spi(SpiError),
    /// The data/command pin failed.
    Pin(PinError),
    /// The rows asked for do not all lie on the panel, or their bytes do not make whole rows.
    OutsidePanel,
}

/// The result of talking to the panel.
pub type Result<Spi, Pin> = core::result::Result<
    (),
    Error<<Spi as embedded_hal::spi::ErrorType>::Error, <Pin as embedded_hal::digital::ErrorType>::Error>,
>;

/// The panel.
pub struct Ssd0323<Spi, Pin> {
    spi: Spi,
    /// High for data, low for commands.
    data_not_command: Pin,
}

impl<Spi: SpiDevice, Pin: OutputPin> Ssd0323<Spi, Pin> {
    /// A panel that has not been spoken to yet.
    pub fn new(spi: Spi, data_not_command: Pin) -> Self {
        Self { spi, data_not_command }
    }

    /// Sets the controller up for this panel and blackens it before it is switched on.
    pub fn initialize(&mut self) -> Result<Spi, Pin> {
        self.command(&[command::DISPLAY_OFF])?;
        self.command(&[command::SET_REMAP, REMAP])?;
        self.command(&[command::SET_START_LINE, 0])?;
        self.command(&[command::SET_OFFSET, OFFSET])?;
        self.command(&[command::SET_MULTIPLEX, HEIGHT as u8 - 1])?;
        self.command(&[command::FULL_CURRENT])?;
        self.command(&[command::SET_CONTRAST, 0x40])?;
        self.command(&[command::NORMAL_DISPLAY])?;
        for row in 0..HEIGHT as i32 {
            self.write_rows(row, &[0; ROW_BYTES])?;
        }
        self.command(&[command::DISPLAY_ON])
    }

    /// Shows packed rows from row `first` downwards: `packed` holds 64 bytes for each.
    pub fn write_rows(&mut self, first: i32, packed: &[u8]) -> Result<Spi, Pin> {
        let (rows, rest) = (packed.len() / ROW_BYTES, packed.len() % ROW_BYTES);
        if rest != 0 || first < 0 || first as usize >= HEIGHT || rows > HEIGHT - first as usize {
            return Err(Error::OutsidePanel);
        }
        if rows == 0 {
            return Ok(());
        }
        // Below 64, so a byte holds them.
        let first = first as u8;
        self.command(&[command::SET_ROWS, first, first + (rows - 1) as u8])?;
        self.command(&[command::SET_COLUMNS, 0, ROW_BYTES as u8 - 1])?;
        self.data_not_command.set_high().map_err(Error::Pin)?;
        self.spi.write(packed).map_err(Error::Spi)
    }

    fn command(&mut self, bytes: &[u8]) -> Result<Spi, Pin> {
        self.data_not_command.set_low().map_err(Error::Pin)?;
        self.spi.write(bytes).map_err(Error::Spi)
    }
}
