//! The ST7789 as a host sees it: commands and data go in, the picture in its memory comes out.

use anyhow::{Context, Result, bail, ensure};
use embedded_graphics::primitives::Rectangle;

/// Columns and rows of the panel.
pub const WIDTH: usize = 240;
pub const HEIGHT: usize = 320;

/// 16 bits a pixel, on both of the panel's interfaces.
const RGB565: u8 = 0x55;

const NOP: u8 = 0x00;
const SLEEP_OUT: u8 = 0x11;
const NORMAL_MODE: u8 = 0x13;
const INVERSION_OFF: u8 = 0x20;
const INVERSION_ON: u8 = 0x21;
const DISPLAY_ON: u8 = 0x29;
const SET_COLUMNS: u8 = 0x2a;
const SET_ROWS: u8 = 0x2b;
const WRITE_PIXELS: u8 = 0x2c;
const SCROLL_AREA: u8 = 0x33;
const ADDRESS_MODE: u8 = 0x36;
const SCROLL_START: u8 = 0x37;
const PIXEL_FORMAT: u8 = 0x3a;

/// First and last column or row of the window, both within it.
type Range = (usize, usize);

/// The state of a panel. All that is sent in another form than the firmware's is an error, not a guess.
pub struct St7789 {
    pixels: Vec<u16>,
    columns: Range,
    rows: Range,
    /// Where the next pixel goes.
    position: (usize, usize),
    command: u8,
    operands: Vec<u8>,
    awake: bool,
    on: bool,
}

impl St7789 {
    /// A panel out of reset, with an empty memory.
    pub fn new() -> Self {
        Self {
            pixels: vec![0; WIDTH * HEIGHT],
            columns: (0, WIDTH - 1),
            rows: (0, HEIGHT - 1),
            position: (0, 0),
            command: NOP,
            operands: Vec::new(),
            awake: false,
            on: false,
        }
    }

    /// Takes bytes that came while the data/command pin was low.
    pub fn take_commands(&mut self, bytes: &[u8]) -> Result<()> {
        for &command in bytes {
            self.end_command()?;
            self.command = command;
            match command {
                SLEEP_OUT => self.awake = true,
                DISPLAY_ON => self.on = true,
                WRITE_PIXELS => self.position = (self.columns.0, self.rows.0),
                NOP | NORMAL_MODE | INVERSION_OFF | INVERSION_ON | SET_COLUMNS | SET_ROWS | SCROLL_AREA
                | ADDRESS_MODE | SCROLL_START | PIXEL_FORMAT => {}
                other => bail!("the panel got the command {other:#04x}, which the firmware does not send"),
            }
        }
        Ok(())
    }

    /// Takes bytes that came while the data/command pin was high: operands of the last command, or pixels.
    pub fn take_data(&mut self, bytes: &[u8]) -> Result<()> {
        self.operands.extend_from_slice(bytes);
        if self.command == WRITE_PIXELS {
            let pixels = std::mem::take(&mut self.operands);
            for pixel in pixels.chunks(2) {
                match *pixel {
                    [high, low] => self.put(u16::from_be_bytes([high, low])),
                    // The other half comes with the next data.
                    _ => self.operands.extend_from_slice(pixel),
                }
            }
            return Ok(());
        }
        match (self.command, self.operands.as_slice()) {
            (SET_COLUMNS, &[a, b, c, d]) => self.columns = range([a, b, c, d], WIDTH)?,
            (SET_ROWS, &[a, b, c, d]) => self.rows = range([a, b, c, d], HEIGHT)?,
            (PIXEL_FORMAT, &[format]) => ensure!(format == RGB565, "{format:#04x} is not 16 bits a pixel"),
            (ADDRESS_MODE, &[mode]) => ensure!(
                mode == 0,
                "{mode:#04x} turns or mirrors the panel, or swaps red and blue"
            ),
            (SCROLL_START, &[high, low]) => ensure!((high, low) == (0, 0), "the panel is scrolled"),
            _ => {}
        }
        Ok(())
    }

    /// The pixels of an area, row by row. The panel must be awake and on.
    pub fn pixels(&self, area: Rectangle) -> Result<Vec<u16>> {
        ensure!(self.awake, "the panel sleeps");
        ensure!(self.on, "the panel is off");
        let left = usize::try_from(area.top_left.x)?;
        let top = usize::try_from(area.top_left.y)?;
        let (width, height) = (area.size.width as usize, area.size.height as usize);
        let row = |row| self.pixels.get(row * WIDTH + left..row * WIDTH + left + width);
        let rows: Option<Vec<_>> = (top..top + height).map(row).collect();
        Ok(rows.context("the area is outside the panel")?.concat())
    }

    /// A command that has not got all its operands has no effect on a panel: the firmware must not send one.
    fn end_command(&mut self) -> Result<()> {
        let operands = match self.command {
            SET_COLUMNS | SET_ROWS => 4,
            PIXEL_FORMAT | ADDRESS_MODE => 1,
            SCROLL_START => 2,
            SCROLL_AREA => 6,
            _ => 0,
        };
        ensure!(
            self.operands.len() == operands,
            "the command {:#04x} got {} bytes of operands, or pixels that are cut, instead of {operands}",
            self.command,
            self.operands.len()
        );
        self.operands.clear();
        Ok(())
    }

    /// Puts a pixel and goes on to the right, then to the next row of the window, and behind the last row to the first.
    fn put(&mut self, color: u16) {
        let (column, row) = self.position;
        self.pixels[row * WIDTH + column] = color;
        self.position = if column < self.columns.1 {
            (column + 1, row)
        } else if row < self.rows.1 {
            (self.columns.0, row + 1)
        } else {
            (self.columns.0, self.rows.0)
        };
    }
}

/// The first and the last column or row, big-endian.
fn range([a, b, c, d]: [u8; 4], end: usize) -> Result<Range> {
    let (first, last) = (u16::from_be_bytes([a, b]).into(), u16::from_be_bytes([c, d]).into());
    ensure!(
        first <= last && last < end,
        "the window reaches from {first} to {last} of {end}"
    );
    Ok((first, last))
}

#[cfg(test)]
mod tests {
    use super::*;
    use embedded_graphics::prelude::*;

    fn send(panel: &mut St7789, command: u8, data: &[u8]) -> Result<()> {
        panel.take_commands(&[command])?;
        panel.take_data(data)
    }

    /// A panel that is switched on as mipidsi does it.
    fn panel() -> St7789 {
        let mut panel = St7789::new();
        send(&mut panel, SLEEP_OUT, &[]).unwrap();
        send(&mut panel, SCROLL_AREA, &[0, 0, 1, 64, 0, 0]).unwrap();
        send(&mut panel, ADDRESS_MODE, &[0]).unwrap();
        send(&mut panel, INVERSION_ON, &[]).unwrap();
        send(&mut panel, PIXEL_FORMAT, &[RGB565]).unwrap();
        send(&mut panel, NORMAL_MODE, &[]).unwrap();
        send(&mut panel, DISPLAY_ON, &[]).unwrap();
        panel
    }

    fn window(panel: &mut St7789, columns: [u8; 2], rows: [u8; 2]) -> Result<()> {
        send(panel, SET_COLUMNS, &[0, columns[0], 0, columns[1]])?;
        send(panel, SET_ROWS, &[0, rows[0], 0, rows[1]])
    }

    fn area(left: i32, top: i32, width: u32, height: u32) -> Rectangle {
        Rectangle::new(Point::new(left, top), Size::new(width, height))
    }

    #[test]
    fn pixels_go_row_by_row_into_the_window() {
        let mut panel = panel();
        window(&mut panel, [10, 11], [20, 22]).unwrap();
        send(&mut panel, WRITE_PIXELS, &[0x12, 0x34, 0, 2, 0, 3, 0, 4]).unwrap();
        assert_eq!(panel.pixels(area(10, 20, 2, 2)).unwrap(), [0x1234, 2, 3, 4]);
        assert_eq!(panel.pixels(area(9, 20, 4, 1)).unwrap(), [0, 0x1234, 2, 0]);
    }

    /// The bytes of one picture come in any number of pieces, and go on behind the last row at the first one.
    #[test]
    fn a_stream_may_be_cut_anywhere_and_wraps_around() {
        let stream = [0, 1, 0, 2, 0, 3, 0, 4, 0, 5];
        for cut in 0..=stream.len() {
            let mut panel = panel();
            window(&mut panel, [0, 1], [0, 1]).unwrap();
            panel.take_commands(&[WRITE_PIXELS]).unwrap();
            panel.take_data(&stream[..cut]).unwrap();
            panel.take_data(&stream[cut..]).unwrap();
            assert_eq!(panel.pixels(area(0, 0, 2, 2)).unwrap(), [5, 2, 3, 4], "cut at {cut}");
        }
    }

    #[test]
    fn a_nop_before_a_command_changes_nothing() {
        let mut panel = panel();
        panel.take_commands(&[NOP, SET_COLUMNS]).unwrap();
        panel.take_data(&[0, 7, 0, 7]).unwrap();
        panel.take_commands(&[NOP, WRITE_PIXELS]).unwrap();
        panel.take_data(&[0xff, 0xff]).unwrap();
        assert_eq!(panel.pixels(area(6, 0, 3, 1)).unwrap(), [0, 0xffff, 0]);
    }

    #[test]
    fn writing_starts_at_the_first_pixel_again() {
        let mut panel = panel();
        window(&mut panel, [3, 5], [0, 9]).unwrap();
        send(&mut panel, WRITE_PIXELS, &[0, 1, 0, 2]).unwrap();
        send(&mut panel, WRITE_PIXELS, &[0, 9]).unwrap();
        assert_eq!(panel.pixels(area(3, 0, 3, 1)).unwrap(), [9, 2, 0]);
    }

    #[test]
    fn what_a_panel_would_not_show_is_an_error() {
        assert!(St7789::new().pixels(area(0, 0, 1, 1)).is_err(), "asleep");
        assert!(panel().pixels(area(0, 300, 1, 21)).is_err(), "below the panel");
        assert!(window(&mut panel(), [9, 8], [0, 0]).is_err(), "an empty window");
        assert!(
            window(&mut panel(), [0, 240], [0, 0]).is_err(),
            "beyond the last column"
        );
        assert!(send(&mut panel(), PIXEL_FORMAT, &[0x66]).is_err(), "18 bits");
        assert!(send(&mut panel(), ADDRESS_MODE, &[0x60]).is_err(), "turned");
        assert!(panel().take_commands(&[0xb2]).is_err(), "unknown");
        let mut cut = panel();
        send(&mut cut, SET_COLUMNS, &[0, 0, 0]).unwrap();
        assert!(cut.take_commands(&[NOP]).is_err(), "three of four operands");
        let mut half = panel();
        send(&mut half, WRITE_PIXELS, &[1]).unwrap();
        assert!(half.take_commands(&[NOP]).is_err(), "half a pixel");
    }
}
