//! The greys of the OLED, out of QEMU's screendump or out of the simulator.

use anyhow::{Context, Result, ensure};
use embedded_graphics::{geometry::Point, prelude::PointsIter};
use image::{GrayImage, Luma, RgbImage};
use std::path::Path;
use zrow_scenes::oled::AREA;

/// QEMU shows each pixel of the panel as a block of this side.
pub const MAGNIFICATION: u32 = 4;
/// QEMU shows the grey n (0..=15) as n * 17.
const BRIGHTNESS_STEP: u8 = 17;

/// Every pixel of the panel, row by row, as a grey 0..=15.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Panel {
    greys: Vec<u8>,
}

impl Panel {
    /// Asks for every pixel.
    pub fn from_pixels(grey: impl Fn(Point) -> u8) -> Self {
        Self {
            greys: AREA.points().map(grey).collect(),
        }
    }

    /// Undoes QEMU's magnification.
    ///
    /// # Errors
    /// A size that is not the panel's, a block whose pixels are not all the same, a colour that is none of the 16 greys.
    pub fn from_screendump(dump: &RgbImage) -> Result<Self> {
        let size = (AREA.size.width * MAGNIFICATION, AREA.size.height * MAGNIFICATION);
        ensure!(
            dump.dimensions() == size,
            "QEMU's picture is {:?}, not {size:?}",
            dump.dimensions()
        );
        let greys = AREA.points().map(|point| block(dump, point)).collect::<Result<_>>()?;
        Ok(Self { greys })
    }

    /// Pixels that are not the same in both.
    pub fn differing_pixels(&self, other: &Self) -> usize {
        self.greys
            .iter()
            .zip(&other.greys)
            .filter(|(one, other)| one != other)
            .count()
    }

    /// Writes a PNG as large as QEMU's picture.
    pub fn save(&self, path: &Path) -> Result<()> {
        let (width, height) = (AREA.size.width, AREA.size.height);
        GrayImage::from_fn(width * MAGNIFICATION, height * MAGNIFICATION, |x, y| {
            let index = y / MAGNIFICATION * width + x / MAGNIFICATION;
            Luma([self.greys[index as usize] * BRIGHTNESS_STEP])
        })
        .save(path)
        .with_context(|| format!("cannot write {}", path.display()))
    }
}

/// The grey of the block that stands for one pixel of the panel.
fn block(dump: &RgbImage, point: Point) -> Result<u8> {
    let (left, top) = (point.x as u32 * MAGNIFICATION, point.y as u32 * MAGNIFICATION);
    let color = *dump.get_pixel(left, top);
    for y in top..top + MAGNIFICATION {
        for x in left..left + MAGNIFICATION {
            ensure!(
                *dump.get_pixel(x, y) == color,
                "the block of pixel {point} is not of one colour"
            );
        }
    }
    let [red, green, blue] = color.0;
    ensure!(
        red == green && green == blue && red % BRIGHTNESS_STEP == 0,
        "pixel {point} is none of the panel's greys: {color:?}"
    );
    Ok(red / BRIGHTNESS_STEP)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A different grey for neighbours in both directions.
    fn pattern(point: Point) -> u8 {
        ((point.x + 3 * point.y) % 16) as u8
    }

    fn dump() -> RgbImage {
        RgbImage::from_fn(512, 256, |x, y| {
            let grey = pattern(Point::new(x as i32 / 4, y as i32 / 4));
            image::Rgb([grey * 17; 3])
        })
    }

    #[test]
    fn a_dump_gives_back_the_panel() {
        assert_eq!(Panel::from_screendump(&dump()).unwrap(), Panel::from_pixels(pattern));
    }

    #[test]
    fn one_changed_pixel_is_counted() {
        let original = Panel::from_pixels(pattern);
        let changed = Panel::from_pixels(|point| pattern(point) ^ u8::from(point == Point::new(127, 63)));
        assert_eq!(original.differing_pixels(&changed), 1);
        assert_eq!(original.differing_pixels(&original), 0);
    }

    #[test]
    fn a_torn_block_is_an_error() {
        let mut torn = dump();
        torn.put_pixel(511, 255, image::Rgb([1, 1, 1]));
        assert!(Panel::from_screendump(&torn).is_err());
    }

    #[test]
    fn a_colour_between_the_greys_is_an_error() {
        let mut coloured = dump();
        for (x, y) in (0..4).flat_map(|y| (0..4).map(move |x| (x, y))) {
            coloured.put_pixel(x, y, image::Rgb([18, 18, 18]));
        }
        assert!(Panel::from_screendump(&coloured).is_err());
    }

    #[test]
    fn another_size_is_an_error() {
        assert!(Panel::from_screendump(&RgbImage::new(128, 64)).is_err());
    }
}
