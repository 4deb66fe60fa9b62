//! Pages: eight rows of one-bit pixels, a byte a column, as OLED controllers take them.
//!
//! A controller such as the SSD1306 has its memory in pages of eight rows. A byte holds eight pixels one below the other, the
//! topmost one in the lowest bit, so that a row alone cannot be sent without the seven others of its page:
//!
//! ```text
//!              column 0  column 1  column 2
//! row 8k          bit 0     bit 0     bit 0    a row of a band sets one bit in each byte
//! row 8k + 1      bit 1     bit 1     bit 1
//!   ...
//! row 8k + 7      bit 7     bit 7     bit 7    the last row of a page: its bytes are sent
//! ```
//!
//! The rows of bands are collected in the bytes of one page. Guarantees: bands of any height give the same bytes, and a picture is whole
//! whatever an earlier one left in the page. Cost: for each row one pass over the bytes of the page, four columns at once.
//! Source: data sheets of Solomon Systech's SSD1306 (2008, 8.7 and 10.1) and Sino Wealth's SH1106 (2012).

use core::ops::Range;

use embedded_graphics::{pixelcolor::BinaryColor, primitives::Rectangle};

use crate::{
    band::{Band, Sink},
    geometry::{TooSmall, Window, distance},
    surface::Order,
};

/// Rows of a page.
const PAGE_ROWS: i32 = 8;

/// Collects the rows of bands in pages of eight rows, for OLED and LCD controllers whose bytes are vertical: SSD1306, SH1106,
/// SSD1309, ST7565, PCD8544.
///
/// Bands of one row are enough: with 128 columns the row takes 128 bytes and the page 128 more, where a band of eight rows
/// takes 1,024. The sink hands out each [`Page`] as soon as its last row has come, and the last page of the area
/// also where the area ends within it; what lies outside of the area is off there. So a picture whose damage is sent has rectangles of
/// whole pages: `Picture::with_damage(&mut areas, (1, 8))`. A picture that is dithered goes through [`Dithered`](crate::band::Dithered) around this sink. Where the driver is `async`,
/// [`draw_pages_async`](crate::band::PictureLoop::draw_pages_async) takes the place of the sink.
///
/// After an error of the closure the next picture is whole again, from its first page on. A controller whose command was cut off
/// has to be initialized before: it takes the next bytes for the rest of the command.
///
/// RAM: a byte a column, which the caller lends, and 24 bytes and the closure for the sink on a 32-bit machine.
///
/// ```
/// use embedded_graphics::{pixelcolor::BinaryColor, prelude::*, primitives::*};
/// use zrow::{band::{PagesSink, PictureLoop}, draw::{DrawOn, PrimitiveStyle}};
///
/// # #[derive(Default)] struct Bus { commands: Vec<u8>, data: Vec<u8> }
/// # impl Bus {
/// #     fn command(&mut self, bytes: &[u8]) -> Result<(), core::fmt::Error> { self.commands.extend(bytes); Ok(()) }
/// #     fn data(&mut self, bytes: &[u8]) -> Result<(), core::fmt::Error> { self.data.extend(bytes); Ok(()) }
/// # }
/// # let mut bus = Bus::default();
/// let area = Rectangle::new(Point::zero(), Size::new(128, 64));
/// let (mut row, mut page) = ([0; 128], [0; 128]);
/// let mut sink = PagesSink::new(area, &mut page, |page| {
///     bus.command(&page.ssd1306_window(0))?;
///     bus.data(page.bytes)
/// })?;
/// let line = Line::new(Point::new(0, 0), Point::new(63, 63)).into_styled(PrimitiveStyle::with_stroke(BinaryColor::On, 1));
/// PictureLoop::new(area, BinaryColor::Off).draw(&mut row, &mut sink, |band| line.draw_on(band))?;
/// assert_eq!(bus.data.len(), 1024);
/// assert_eq!(bus.data[..9], [1, 2, 4, 8, 16, 32, 64, 128, 0]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct PagesSink<'a, F> {
    rows: PageRows,
    /// A byte for each column of the area.
    page: &'a mut [u8],
    send: F,
}

/// Eight rows of a picture as vertical bytes: one a column, the topmost pixel in the lowest bit.
///
/// A page goes to an SH1106 behind the commands that say where it belongs; column 0 of this panel is column 2 of the
/// controller's memory:
///
/// ```
/// use embedded_graphics::{pixelcolor::BinaryColor, prelude::*, primitives::Rectangle};
/// use zrow::{band::{Page, PagesSink, PictureLoop}, draw::{DrawOn, PrimitiveStyle}};
///
/// # #[derive(Default)] struct Bus { commands: Vec<[u8; 3]>, data: Vec<u8> }
/// # impl Bus {
/// #     fn command(&mut self, bytes: [u8; 3]) -> Result<(), core::fmt::Error> { self.commands.push(bytes); Ok(()) }
/// #     fn data(&mut self, bytes: &[u8]) -> Result<(), core::fmt::Error> { self.data.extend(bytes); Ok(()) }
/// # }
/// # let mut bus = Bus::default();
/// let send = |page: Page<'_>| {
///     bus.command(page.sh1106_window(2))?;
///     bus.data(page.bytes)
/// };
/// // A part of the panel: rows 12 to 19, in pages 1 and 2.
/// let area = Rectangle::new(Point::new(40, 12), Size::new(16, 8));
/// let bar = area.into_styled(PrimitiveStyle::with_fill(BinaryColor::On));
/// let mut page = [0; 16];
/// let mut sink = PagesSink::new(area, &mut page, send)?;
/// PictureLoop::new(area, BinaryColor::Off).draw(&mut [0; 16], &mut sink, |band| bar.draw_on(band))?;
/// assert_eq!(bus.commands, [[0xb1, 0xa, 0x12], [0xb2, 0xa, 0x12]]);
/// // What lies outside of the area is off.
/// assert_eq!((bus.data[0], bus.data[16]), (0b1111_0000, 0b0000_1111));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct Page<'a> {
    /// The pixels of the page: eight rows, of which the first has a number that eight divides.
    pub area: Rectangle,
    /// A byte for each column, from left to right.
    pub bytes: &'a [u8],
}

impl<'a, F> PagesSink<'a, F> {
    /// A sink for pictures of an area, which hands each page to a closure `FnMut(Page) -> Result<(), E>`.
    ///
    /// `area` is that of the [`PictureLoop`](crate::band::PictureLoop); its row 0 is the top of the panel, so that its pages begin
    /// at multiples of eight. What bands have outside of it is not sent.
    ///
    /// A program that shows frame after frame makes a sink for each of them, and lends it the closure: `&mut send`.
    ///
    /// # Errors
    /// [`TooSmall::PageBytes`] where `page` has fewer bytes than the area has columns.
    pub fn new<E>(area: Rectangle, page: &'a mut [u8], send: F) -> Result<Self, TooSmall>
    where
        F: FnMut(Page<'_>) -> Result<(), E>,
    {
        let rows = PageRows::new(area.into());
        let needed = rows.bytes_needed();
        match page.get_mut(..needed) {
            Some(page) => Ok(Self { rows, page, send }),
            None => Err(TooSmall::PageBytes(needed)),
        }
    }
}

impl<O: Order, E, F: FnMut(Page<'_>) -> Result<(), E>> Sink<BinaryColor, O> for PagesSink<'_, F> {
    type Error = E;

    fn send(&mut self, mut band: Band<'_, BinaryColor, O>) -> Result<(), E> {
        let left = band.window.left;
        for y in self.rows.of(&band.window) {
            self.rows
                .collect(self.page, y, left, band.row_mut(y).unwrap_or_default());
            if let Some(area) = self.rows.finished(y) {
                let bytes = &*self.page;
                (self.send)(Page { area, bytes })?;
            }
        }
        Ok(())
    }
}

/// The rows of an area as they come into the bytes of their pages.
#[derive(Debug, Copy, Clone)]
pub(super) struct PageRows {
    window: Window,
}

impl PageRows {
    pub(super) const fn new(area: Window) -> Self {
        Self { window: area }
    }

    /// A byte for each column.
    pub(super) fn bytes_needed(&self) -> usize {
        self.window.width() as usize
    }

    /// The rows of a band that are in the area.
    pub(super) fn of(&self, band: &Window) -> Range<i32> {
        band.top.max(self.window.top)..band.bottom.min(self.window.bottom)
    }

    /// Writes a row of a band, which begins at the column `left`, into its bits of a page. The page may be longer than the area is
    /// wide; the first row of a page turns all of its bits off before.
    pub(super) fn collect(&self, page: &mut [u8], y: i32, left: i32, row: &[u8]) {
        let page = page.get_mut(..self.bytes_needed()).unwrap_or_default();
        if y == self.window.top.max(first_row(y)) {
            page.fill(0);
        }
        // The columns that the row and the page both have.
        let (row, page) = if left < self.window.left {
            (row.get(distance(left, self.window.left) as usize..), Some(page))
        } else {
            (Some(row), page.get_mut(distance(self.window.left, left) as usize..))
        };
        if let (Some(row), Some(page)) = (row, page) {
            set_bits(page, row, y.rem_euclid(PAGE_ROWS) as u32);
        }
    }

    /// The pixels of the page that is finished with a row: the last one of a page or of the area.
    pub(super) fn finished(&self, y: i32) -> Option<Rectangle> {
        let top = first_row(y);
        // A window has no row `i32::MAX`, which would be the last one of the last page.
        let bottom = top.saturating_add(PAGE_ROWS);
        let page = Window {
            top,
            bottom,
            ..self.window
        };
        (y + 1 == bottom.min(self.window.bottom)).then(|| page.to_rectangle())
    }
}

impl Page<'_> {
    /// The commands that tell an SSD1306 or SSD1309 in horizontal addressing mode (`20 00`) where the bytes belong.
    ///
    /// `first_column` is the column of the controller's memory in which the panel's column 0 lies: 0 on panels of 128 columns, 28
    /// on those of 72 x 40, 32 on those of 64 columns.
    pub fn ssd1306_window(&self, first_column: u8) -> [u8; 6] {
        let (left, page) = self.position(first_column);
        let right = left.wrapping_add(self.bytes.len() as u8).wrapping_sub(1);
        [0x21, left, right, 0x22, page, page]
    }

    /// The commands that tell an SH1106, SH1107 or ST7565 where the bytes belong, which addresses one page at a time.
    ///
    /// `first_column` is the column of the controller's memory in which the panel's column 0 lies: 2 on most panels with an SH1106.
    pub fn sh1106_window(&self, first_column: u8) -> [u8; 3] {
        let (left, page) = self.position(first_column);
        [0xb0 | page & 0x0f, left & 0x0f, 0x10 | left >> 4]
    }

    /// The first column in the controller's memory, and the number of the page there; panels have fewer than 256 of both.
    fn position(&self, first_column: u8) -> (u8, u8) {
        let top_left = self.area.top_left;
        let page = top_left.y.div_euclid(PAGE_ROWS);
        ((top_left.x as u8).wrapping_add(first_column), page as u8)
    }
}

/// The first row of the page that a row belongs to.
const fn first_row(y: i32) -> i32 {
    y & -PAGE_ROWS
}

/// Writes the lowest bit of each pixel into one bit of each byte of a page, as many as both have.
fn set_bits(page: &mut [u8], row: &[u8], bit: u32) {
    let length = page.len().min(row.len());
    let (page, row) = (page.get_mut(..length), row.get(..length));
    let (page, row) = (page.unwrap_or_default(), row.unwrap_or_default());
    let (mut fours, row_fours) = (page.chunks_exact_mut(4), row.chunks_exact(4));
    let row_rest = row_fours.remainder();
    for (bytes, pixels) in (&mut fours).zip(row_fours) {
        if let ([a, b, c, d], &[e, f, g, h]) = (bytes, pixels) {
            let kept = u32::from_le_bytes([*a, *b, *c, *d]) & !(0x0101_0101 << bit);
            let bits = (u32::from_le_bytes([e, f, g, h]) & 0x0101_0101) << bit;
            [*a, *b, *c, *d] = (kept | bits).to_le_bytes();
        }
    }
    for (byte, pixel) in fours.into_remainder().iter_mut().zip(row_rest) {
        *byte = *byte & !(1 << bit) | (pixel & 1) << bit;
    }
}

#[cfg(feature = "defmt")]
impl<F> defmt::Format for PagesSink<'_, F> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "PagesSink {}", self.rows.window);
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Page<'_> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "Page {}", Window::from(self.area));
    }
}
