//! Animations as GIF files: one palette for all frames, and of each frame only the part that changed.

use anyhow::{Context, bail};
use embedded_graphics::{geometry::OriginDimensions, pixelcolor::Rgb888};
use embedded_graphics_simulator::OutputImage;
use gif::{DisposalMethod, Encoder, Frame, Repeat};

use super::files::{Rgb, indices, palette, pixels};

/// Hundredths of a second that a frame stays.
const DELAY: u16 = 5;

/// The frames as a GIF that repeats for ever. Nothing is lost where one palette holds all colours.
pub fn gif(images: Vec<OutputImage<Rgb888>>) -> anyhow::Result<Vec<u8>> {
    let Some(first) = images.first() else {
        bail!("an animation without frames");
    };
    let frames: Vec<Vec<Rgb>> = images.iter().map(pixels).collect();
    let animation = Animation {
        width: u16::try_from(first.size().width)?,
        height: u16::try_from(first.size().height)?,
        palette: palette(frames.iter().flatten()),
        frames,
    };
    let whole = animation.encode(false)?;
    if animation.palette.is_none() {
        // Without a common palette no pixel is transparent.
        return Ok(whole);
    }
    // Which of the two is shorter depends on the picture.
    let sparse = animation.encode(true)?;
    Ok(if sparse.len() < whole.len() { sparse } else { whole })
}

struct Animation {
    width: u16,
    height: u16,
    /// The colours of all frames, where a GIF's palette holds them.
    palette: Option<Vec<Rgb>>,
    frames: Vec<Vec<Rgb>>,
}

impl Animation {
    /// Encodes it, with pixels that stay as they are transparent or not.
    fn encode(&self, sparse: bool) -> anyhow::Result<Vec<u8>> {
        let colors = self.palette.as_deref().unwrap_or_default();
        let mut bytes = Vec::new();
        let mut encoder = Encoder::new(&mut bytes, self.width, self.height, &colors.concat())?;
        encoder.set_repeat(Repeat::Infinite)?;
        let width = usize::from(self.width);
        let mut previous: Option<&[Rgb]> = None;
        for pixels in &self.frames {
            let changed = Changed::new(pixels, previous, width);
            let part = changed.crop(pixels, width);
            let before = previous.filter(|_| sparse).map(|before| changed.crop(before, width));
            let mut frame = match &self.palette {
                Some(palette) => indexed(&changed, &part, before.as_deref(), palette),
                // More colours than a GIF has: each frame gets the palette that comes nearest.
                None => Frame::from_rgb(changed.width, changed.height, &part.concat()),
            };
            frame.left = changed.left;
            frame.top = changed.top;
            frame.delay = DELAY;
            frame.dispose = DisposalMethod::Keep;
            encoder.write_frame(&frame).context("cannot encode a GIF")?;
            previous = Some(pixels);
        }
        drop(encoder);
        Ok(bytes)
    }
}

/// A frame in colours of the common palette. Pixels that are as `before` are transparent, where the palette has a place to
/// spare.
fn indexed(changed: &Changed, part: &[Rgb], before: Option<&[Rgb]>, palette: &[Rgb]) -> Frame<'static> {
    let mut indices = indices(part, palette);
    let transparent = u8::try_from(palette.len()).ok();
    if let (Some(transparent), Some(before)) = (transparent, before) {
        let pixels = part.iter().zip(before);
        for (index, _) in indices
            .iter_mut()
            .zip(pixels)
            .filter(|(_, (now, before))| now == before)
        {
            *index = transparent;
        }
    }
    Frame::from_indexed_pixels(changed.width, changed.height, indices, transparent)
}

/// The smallest block that holds every pixel that differs from the frame before.
struct Changed {
    left: u16,
    top: u16,
    width: u16,
    height: u16,
}

impl Changed {
    fn new(pixels: &[Rgb], previous: Option<&[Rgb]>, width: usize) -> Self {
        let differs = |index: usize| previous.is_none_or(|previous| previous[index] != pixels[index]);
        let (mut left, mut right, mut top, mut bottom) = (usize::MAX, 0, usize::MAX, 0);
        for index in (0..pixels.len()).filter(|&index| differs(index)) {
            let (x, y) = (index % width, index / width);
            left = left.min(x);
            right = right.max(x);
            top = top.min(y);
            bottom = bottom.max(y);
        }
        if left > right {
            // Nothing changed; a frame has at least one pixel.
            (left, right, top, bottom) = (0, 0, 0, 0);
        }
        Self {
            left: left as u16,
            top: top as u16,
            width: (right - left + 1) as u16,
            height: (bottom - top + 1) as u16,
        }
    }

    fn crop(&self, pixels: &[Rgb], width: usize) -> Vec<Rgb> {
        let left = usize::from(self.left);
        let rows = pixels.chunks(width).skip(self.top.into()).take(self.height.into());
        rows.flat_map(|row| &row[left..left + usize::from(self.width)])
            .copied()
            .collect()
    }
}
