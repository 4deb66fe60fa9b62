//! The picture loop for `async` displays whose bytes are vertical: page n + 1 is drawn while the future of page n is pending.
//!
//! ```text
//! drawn      page 0 | page 1          | page 2          |
//! on the bus        | page 0          | page 1          | page 2
//! ```
//!
//! Bands of one row are drawn and collected until their page is whole. Guarantees: bands of any height give the same bytes as
//! [`PagesSink`](crate::band::PagesSink) does, and one transfer is under way at a time.

use core::pin::pin;

use embedded_graphics::{pixelcolor::BinaryColor, primitives::Rectangle};

use crate::{
    band::{
        Band, LoopError, Page, PictureLoop, SceneResult,
        picture_loop::{asynchronous::while_sent, pages::PageRows, picture_loop::BandError},
    },
    geometry::{TooSmall, Window},
    surface::Order,
};

impl<O: Order> PictureLoop<BinaryColor, O> {
    /// Draws the whole picture once, on a display whose bytes are vertical ([`Page`]) and whose transfers are futures, as with
    /// embassy: an SSD1306 or SH1106 over I2C or SPI. `send` gets each page of eight rows.
    ///
    /// `buffer` takes the words of a band, of which one row is enough; each of `pages` has a byte for each column of the area. A
    /// transfer is polled once, so that it starts, then the next page is drawn into the other bytes, then the transfer is
    /// awaited. Dropping the future drops the transfer under way. A program that shows frame after frame lends its closure to
    /// each of them: `&mut send`. A picture in grey that is to be dithered goes through [`draw`](Self::draw) instead.
    ///
    /// RAM: three bytes a column with bands of one row, 384 for 128 columns, and the future.
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::BinaryColor, prelude::*, primitives::Rectangle};
    /// use zrow::band::{LoopError, Page, PictureLoop};
    ///
    /// async fn show(bus: &mut Vec<u8>) -> Result<(), LoopError<()>> {
    ///     let area = Rectangle::new(Point::zero(), Size::new(128, 64));
    ///     let send = async |page: Page<'_>| {
    ///         // Await the driver here.
    ///         bus.extend(page.ssd1306_window(0));
    ///         bus.extend_from_slice(page.bytes);
    ///         Ok(())
    ///     };
    ///     let picture = PictureLoop::new(area, BinaryColor::Off);
    ///     picture.draw_pages_async(&mut [0; 128], [&mut [0; 128], &mut [0; 128]], send, |_| {}).await
    /// }
    /// ```
    ///
    /// # Errors
    /// [`LoopError::TooSmall`] before anything is drawn, with the words that `buffer` should have or, if those are enough, with
    /// [`TooSmall::PageBytes`]; [`LoopError::Sink`] and [`LoopError::Scene`] as [`draw`](Self::draw).
    pub async fn draw_pages_async<E, F, R>(
        &self,
        buffer: &mut [u8],
        pages: [&mut [u8]; 2],
        mut send: impl AsyncFnMut(Page<'_>) -> Result<(), E>,
        mut scene: F,
    ) -> Result<(), LoopError<E, R::Error>>
    where
        F: FnMut(&mut Band<'_, BinaryColor, O>) -> R,
        R: SceneResult,
    {
        self.check(buffer)?;
        let area = self.area();
        let pages_of_area = PageRows::new(area);
        let needed = pages_of_area.bytes_needed();
        let [drawn, waiting] = pages.map(|page| page.get_mut(..needed));
        let (Some(mut drawn), Some(mut waiting)) = (drawn, waiting) else {
            return Err(TooSmall::PageBytes(needed).into());
        };
        let mut rows = BandRows {
            windows: self.windows(),
            pages: pages_of_area,
            band: Window {
                bottom: area.top,
                ..area
            },
            next_row: area.top,
        };
        let mut next_page = |page: &mut [u8]| rows.next_page(self, buffer, page, &mut scene);
        let mut finished = next_page(drawn)?;
        while let Some(area) = finished {
            let page = Page { area, bytes: drawn };
            finished = while_sent(pin!(send(page)), || next_page(waiting)).await?;
            core::mem::swap(&mut drawn, &mut waiting);
        }
        trace!("{}: sent", self);
        Ok(())
    }
}

/// The rows of bands, drawn as they are needed, on their way into pages.
struct BandRows<W> {
    /// The bands that are not drawn yet.
    windows: W,
    pages: PageRows,
    /// The band in the buffer.
    band: Window,
    /// The first of its rows that is in no page yet.
    next_row: i32,
}

impl<W: Iterator<Item = Window>> BandRows<W> {
    /// Collects rows in a page until it is finished; `None` after the last page.
    fn next_page<O: Order, R: SceneResult>(
        &mut self,
        picture_loop: &PictureLoop<BinaryColor, O>,
        buffer: &mut [u8],
        page: &mut [u8],
        scene: &mut impl FnMut(&mut Band<'_, BinaryColor, O>) -> R,
    ) -> Result<Option<Rectangle>, BandError<R::Error>> {
        loop {
            let mut band = Band::<BinaryColor, O>::over(self.band, buffer).map_err(BandError::TooSmall)?;
            let (left, rows) = (self.band.left, self.pages.of(&self.band));
            for y in rows.start.max(self.next_row)..rows.end {
                self.pages.collect(page, y, left, band.row_mut(y).unwrap_or_default());
                if let Some(area) = self.pages.finished(y) {
                    self.next_row = y + 1;
                    return Ok(Some(area));
                }
            }
            let Some(window) = self.windows.next() else {
                return Ok(None);
            };
            // The scene may have rotated the band.
            self.band = picture_loop.draw_band(window, buffer, scene)?.window;
            self.next_row = self.band.top;
        }
    }
}
