//! Reads a texture from a PNG file, as RGB565.

use std::io::Cursor;

use anyhow::{Context, ensure};
use png::{BitDepth, ColorType, Decoder, Limits, Transformations};

use crate::module_parts::rgb565;

/// Width and height at most.
const LARGEST: u32 = 256;
/// Bytes that decoding may take: a texture of the largest size needs a few hundred thousand.
const MEMORY: usize = 16 << 20;

/// A picture of RGB565 words.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Texture {
    /// Pixels from left to right.
    pub width: usize,
    /// Pixels from top to bottom.
    pub height: usize,
    /// Rows from the top on.
    pub words: Vec<u16>,
    /// Whether some pixels are not opaque.
    pub has_alpha: bool,
}

/// Reads a PNG file of 8 bits a channel, or fewer.
///
/// # Errors
/// A file that is no PNG or is broken, and sizes and depths that are not supported.
pub fn parse(bytes: &[u8]) -> anyhow::Result<Texture> {
    let mut decoder = Decoder::new_with_limits(Cursor::new(bytes), Limits { bytes: MEMORY });
    decoder.set_transformations(Transformations::EXPAND);
    decoder.set_ignore_text_chunk(true);
    decoder.set_ignore_iccp_chunk(true);
    let broken = "it is no PNG that can be read: save it as PNG again";
    let header = decoder.read_header_info().context(broken)?;
    let (width, height) = (header.width, header.height);
    ensure!(
        [width, height]
            .iter()
            .all(|size| size.is_power_of_two() && *size <= LARGEST),
        "it has {width} x {height} pixels: scale it to powers of two up to {LARGEST}, such as 64 x 64"
    );
    ensure!(
        header.bit_depth != BitDepth::Sixteen,
        "it has 16 bits a channel: save it with 8"
    );
    let mut reader = decoder.read_info().context(broken)?;
    let size = reader.output_buffer_size().context(broken)?;
    ensure!(size <= MEMORY, broken);
    let mut pixels = vec![0; size];
    let info = reader.next_frame(&mut pixels).context(broken)?;
    pixels.truncate(info.buffer_size());
    let texture = from_pixels(width as usize, height as usize, info.color_type, &pixels);
    ensure!(texture.words.len() == texture.width * texture.height, broken);
    Ok(texture)
}

fn from_pixels(width: usize, height: usize, color: ColorType, bytes: &[u8]) -> Texture {
    let mut has_alpha = false;
    let mut word = |pixel: &[u8]| {
        let (color, alpha) = match *pixel {
            [gray] => ([gray; 3], 255),
            [gray, alpha] => ([gray; 3], alpha),
            [red, green, blue] => ([red, green, blue], 255),
            [red, green, blue, alpha] => ([red, green, blue], alpha),
            _ => ([0; 3], 255),
        };
        has_alpha |= alpha != 255;
        let [red, green, blue] = rgb565(color.map(|component| f64::from(component) / 255.0));
        u16::from(red) << 11 | u16::from(green) << 5 | u16::from(blue)
    };
    let words = bytes.chunks_exact(color.samples()).map(&mut word).collect();
    Texture {
        width,
        height,
        words,
        has_alpha,
    }
}
