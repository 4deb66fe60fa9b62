//! Pictures as PNG files, with a palette where the colours are few.

use std::collections::BTreeSet;

use anyhow::Context;
use embedded_graphics::{geometry::OriginDimensions, pixelcolor::Rgb888};
use embedded_graphics_simulator::OutputImage;

/// Red, green and blue.
pub type Rgb = [u8; 3];

/// The pixels of an image, row by row.
pub fn pixels(image: &OutputImage<Rgb888>) -> Vec<Rgb> {
    image.as_image_buffer().pixels().map(|pixel| pixel.0).collect()
}

/// The colours in ascending order, where a palette of 256 holds them all.
pub fn palette<'a>(pixels: impl IntoIterator<Item = &'a Rgb>) -> Option<Vec<Rgb>> {
    let mut colors = BTreeSet::new();
    let mut last = None;
    for pixel in pixels {
        // Neighbours are alike more often than not.
        if last != Some(pixel) && colors.insert(*pixel) && colors.len() > 256 {
            return None;
        }
        last = Some(pixel);
    }
    Some(colors.into_iter().collect())
}

/// Each pixel's place in a palette that holds all of them.
pub fn indices(pixels: &[Rgb], palette: &[Rgb]) -> Vec<u8> {
    let index = |pixel| palette.binary_search(pixel).unwrap_or_default();
    pixels.iter().map(|pixel| index(pixel) as u8).collect()
}

/// A picture as a PNG file. Nothing is lost.
pub fn png(image: &OutputImage<Rgb888>) -> anyhow::Result<Vec<u8>> {
    let pixels = pixels(image);
    let size = image.size();
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, size.width, size.height);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    let data = match palette(&pixels) {
        Some(palette) => {
            encoder.set_color(png::ColorType::Indexed);
            encoder.set_filter(png::Filter::NoFilter);
            encoder.set_palette(palette.concat());
            indices(&pixels, &palette)
        }
        None => {
            encoder.set_color(png::ColorType::Rgb);
            pixels.concat()
        }
    };
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&data).context("cannot encode a PNG")?;
    writer.finish()?;
    Ok(bytes)
}
