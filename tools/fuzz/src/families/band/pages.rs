//! One-bit pictures in pages of eight rows.

use anyhow::ensure;
use arbitrary::Arbitrary;
use embedded_graphics::{geometry::Dimensions, pixelcolor::BinaryColor, primitives::Rectangle};
use zrow::{
    band::{Band, LittleEndian, LoopError, Page, PagesSink, PictureLoop, Sink},
    geometry::{TooSmall, Window},
};

use super::{
    Broken,
    futures::{block_on, slowly},
};
use crate::{
    target::{Case, Verdict},
    values::{Count, Int, Stage},
};

/// Bands of any height, whose rows go into pages, and a page that may be too small.
#[derive(Debug, Arbitrary)]
pub struct PagesCase {
    stage: Stage,
    pixels: [u32; 16],
    fails_at: u8,
    page_bytes: u8,
    before: u8,
    any: [Int; 4],
    any_size: [Count; 2],
}

/// The first row of each page, and its bytes.
type Pages = Vec<(i32, Vec<u8>)>;

/// Notes a page, unless it is the one that fails.
fn note(pages: &mut Pages, page: Page<'_>, fails_at: usize) -> Result<(), Broken> {
    if pages.len() == fails_at {
        return Err(Broken);
    }
    pages.push((page.area.top_left.y, page.bytes.to_vec()));
    Ok(())
}

impl PagesCase {
    /// The pixel of a row and a column of the stage.
    fn pixel(&self, x: i32, y: i32) -> bool {
        let Window { left, top, .. } = self.stage.window;
        self.pixels[(y - top) as usize % 16] >> ((x - left) as u32 % 32) & 1 == 1
    }

    /// The bytes of a page, pixel by pixel.
    fn bytes(&self, top: i32) -> Vec<u8> {
        let window = self.stage.window;
        let rows = (0..8).filter(|bit| (window.top..window.bottom).contains(&(top + bit)));
        let byte = |x| rows.clone().map(|bit| u8::from(self.pixel(x, top + bit)) << bit).sum();
        (window.left..window.right).map(byte).collect()
    }

    /// Draws the pixels of a band.
    fn draw_band(&self, band: &mut Band<'_, BinaryColor, LittleEndian>) {
        let Window { left, top, bottom, .. } = band.bounding_box().into();
        for y in top..bottom {
            let row = band.row_mut(y).unwrap_or_default();
            for (word, x) in row.iter_mut().zip(left..) {
                *word = u8::from(self.pixel(x, y)) | self.before << 1;
            }
        }
    }

    /// A loop over the stage, and a buffer for it.
    fn picture_loop(&self) -> (PictureLoop<BinaryColor>, Vec<u8>) {
        let picture_loop = PictureLoop::new(self.stage.area(), BinaryColor::On).rows(self.stage.rows);
        let words = vec![self.before; picture_loop.words_needed()];
        (picture_loop, words)
    }

    /// The pages that are sent, up to one that fails.
    fn draw(&self, page: &mut [u8], fails_at: usize) -> (Pages, Result<(), LoopError<Broken>>) {
        let mut pages = Vec::new();
        let sink = PagesSink::new(self.stage.area(), page, |page| note(&mut pages, page, fails_at));
        let sent = match sink {
            Ok(mut sink) => {
                let (picture_loop, mut words) = self.picture_loop();
                picture_loop.draw(&mut words, &mut sink, |band: &mut Band<'_, _, _>| self.draw_band(band))
            }
            Err(error) => Err(error.into()),
        };
        (pages, sent)
    }

    /// The pages that are sent by futures, up to one that fails.
    fn draw_async(&self, page: &mut [u8], fails_at: usize) -> (Pages, Result<(), LoopError<Broken>>) {
        let (picture_loop, mut words) = self.picture_loop();
        let (mut pages, mut other) = (Vec::new(), page.to_vec());
        let send = async |page: Page<'_>| {
            slowly().await;
            note(&mut pages, page, fails_at)
        };
        let sent = block_on(picture_loop.draw_pages_async(
            &mut words,
            [page, &mut other],
            send,
            |band: &mut Band<'_, _, _>| self.draw_band(band),
        ));
        (pages, sent)
    }

    /// Areas and bands anywhere: nothing but pages within the number range comes of them.
    fn check_anywhere(&self) -> Verdict {
        let area = |[x, y]: [Int; 2], size: [u32; 2]| Rectangle::new([x.0, y.0].into(), size.into());
        let size = self.any_size.map(|count| count.0);
        let [x, y, z, w] = self.any;
        let (mut page, mut words) = ([self.before; 256], [self.before; 256]);
        let mut pages = Vec::new();
        let sink = PagesSink::new(area([x, y], size), &mut page, |page| {
            pages.push(page.area.top_left.y);
            page.ssd1306_window(self.fails_at);
            page.sh1106_window(self.fails_at);
            Ok::<(), Broken>(())
        });
        if let (Ok(mut sink), Ok(band)) = (sink, Band::<BinaryColor>::new(area([z, w], [16, 16]), &mut words)) {
            ensure!(sink.send(band).is_ok());
        }
        ensure!(pages.iter().all(|top| top % 8 == 0) && pages.len() <= 3, "{pages:?}");
        Ok(())
    }
}

impl Case for PagesCase {
    fn check(&self) -> Verdict {
        self.check_anywhere()?;
        let window = self.stage.window;
        let columns = window.width() as usize;
        let mut page = vec![self.before; usize::from(self.page_bytes) % 32];
        let ways = [Self::draw, Self::draw_async];
        if page.len() < columns {
            for draw in ways {
                let (pages, sent) = draw(self, &mut page, usize::MAX);
                let error = LoopError::TooSmall(TooSmall::PageBytes(columns));
                ensure!(sent == Err(error) && pages.is_empty(), "{sent:?} of {columns} columns");
            }
            page.resize(columns, self.before);
        }
        let tops = (window.top.div_euclid(8)..=(window.bottom - 1).div_euclid(8)).map(|page| page * 8);
        let expected: Pages = tops.map(|top| (top, self.bytes(top))).collect();
        let fails_at = usize::from(self.fails_at) % expected.len();
        for draw in ways {
            let (pages, sent) = draw(self, &mut page, fails_at);
            ensure!(sent == Err(LoopError::Sink(Broken)), "{sent:?} at page {fails_at}");
            ensure!(pages == expected[..fails_at], "other pages before a failure: {pages:?}");
            let (pages, sent) = draw(self, &mut page, usize::MAX);
            ensure!(
                sent == Ok(()) && pages == expected,
                "{sent:?}: {pages:?}, not {expected:?}"
            );
        }
        Ok(())
    }
}
