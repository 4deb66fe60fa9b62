//! The pixels of the page's canvas as a panel that takes bands.

use core::convert::Infallible;

use embedded_graphics::{
    geometry::Dimensions,
    pixelcolor::{Rgb888, RgbColor},
};
use zrow::band::{Band, LittleEndian, Sink};
use zrow_playground_scene::{HEIGHT, PanelColor, WIDTH};

/// Bytes of a pixel: red, green, blue, and 255 for opaque.
const PIXEL: usize = 4;

/// All pixels of a canvas.
pub type Pixels = [u8; PIXEL * WIDTH * HEIGHT];

/// Writes bands to a canvas.
pub struct Canvas<'a>(pub &'a mut Pixels);

impl<C: PanelColor> Sink<C, LittleEndian> for Canvas<'_> {
    type Error = Infallible;

    fn send(&mut self, band: Band<'_, C, LittleEndian>) -> Result<(), Infallible> {
        let top = band.bounding_box().top_left.y as usize;
        // Bands are as wide as the canvas.
        let pixels = self.0.chunks_exact_mut(PIXEL).skip(top * WIDTH);
        for (pixel, color) in pixels.zip(band.colors()) {
            let color: Rgb888 = color.into();
            pixel.copy_from_slice(&[color.r(), color.g(), color.b(), u8::MAX]);
        }
        Ok(())
    }
}
