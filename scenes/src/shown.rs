//! A simulated display for tests: it shows a `Picture` band by band, or only the rectangles of it that have changed.

extern crate std;

use std::{vec, vec::Vec};

use core::convert::Infallible;

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use zrow::{
    band::{Band, PictureLoop},
    draw::Picture,
};

/// The words of an area, drawn in bands of so many rows.
pub fn drawn(
    area: Rectangle,
    background: Rgb565,
    rows: usize,
    mut draw: impl FnMut(&mut Band<'_, Rgb565>),
) -> Vec<u16> {
    let mut shown = Vec::new();
    let mut words = vec![0; area.size.width as usize * rows];
    let mut sink = |band: Band<'_, Rgb565>| -> Result<(), Infallible> {
        shown.extend_from_slice(band.words());
        Ok(())
    };
    PictureLoop::new(area, background)
        .draw(&mut words, &mut sink, |band| draw(band))
        .unwrap();
    shown
}

/// A display whose pixels stay until they are sent again. Its area begins at the origin.
pub struct Display {
    area: Rectangle,
    background: Rgb565,
    words: Vec<u16>,
}

impl Display {
    /// A display that shows nothing yet.
    pub fn new(area: Rectangle, background: Rgb565) -> Self {
        let Size { width, height } = area.size;
        Self {
            area,
            background,
            words: vec![0; (width * height) as usize],
        }
    }

    /// Its pixels, row by row.
    pub fn words(&self) -> &[u16] {
        &self.words
    }

    /// Draws what has changed in a picture, through one row. Returns how many pixels are sent.
    pub fn send_changes(&mut self, picture: &mut Picture<'_, 'static, Rgb565>) -> usize {
        let width = self.area.size.width as usize;
        let (mut row, mut sent) = (vec![0; width], 0);
        while let Some(area) = picture.next_damage() {
            let mut sink = |band: Band<'_, Rgb565>| -> Result<(), Infallible> {
                let at = band.bounding_box().top_left;
                let start = at.y as usize * width + at.x as usize;
                self.words[start..start + band.words().len()].copy_from_slice(band.words());
                sent += band.words().len();
                Ok(())
            };
            PictureLoop::new(area, self.background)
                .draw(&mut row, &mut sink, |band| picture.draw(band))
                .unwrap();
        }
        sent
    }
}
