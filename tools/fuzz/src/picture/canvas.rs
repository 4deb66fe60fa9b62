//! A band with words behind it that nobody may touch.

use anyhow::{Context, ensure};
use embedded_graphics::pixelcolor::{
    Rgb565,
    raw::{RawData, RawU16},
};
use zrow::{
    band::{Band, Order},
    geometry::Window,
};

use crate::target::Verdict;

/// Words behind those of the band.
const GUARDS: usize = 8;
/// What they hold.
const GUARD: u16 = 0xd1ce;

/// The colour of what nothing was drawn on; no [`Hue`](crate::values::Hue) is like it.
pub fn background() -> Rgb565 {
    Rgb565::from(RawU16::from_u32(0x2a15))
}

/// The memory of a band.
#[derive(Debug, Clone)]
pub struct Canvas {
    window: Window,
    words: Vec<u16>,
}

impl Canvas {
    /// The memory for the pixels of a window.
    pub fn new(window: Window) -> Self {
        let pixels = window.width() as usize * window.height() as usize;
        Self {
            window,
            words: vec![GUARD; pixels + GUARDS],
        }
    }

    /// Draws on the background, and returns the colours.
    ///
    /// # Errors
    /// The drawing's; or words behind the band were written.
    pub fn draw<O: Order>(
        &mut self,
        draw: impl FnOnce(&mut Band<'_, Rgb565, O>) -> Verdict,
    ) -> anyhow::Result<Vec<Rgb565>> {
        let area = self.window.to_rectangle();
        let mut band = Band::<Rgb565, O>::new(area, &mut self.words).context("a band over enough words")?;
        band.fill(background());
        draw(&mut band)?;
        let colors: Vec<_> = band.colors().collect();
        let behind = self.words.iter().skip(colors.len());
        ensure!(behind.eq(&[GUARD; GUARDS]), "words behind the band are written");
        Ok(colors)
    }
}
