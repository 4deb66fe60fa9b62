//! Coverage masks: how much of each pixel an outline covers, in 4 bits.

use anyhow::bail;
use zrow::{
    coverage::{CoverageMethod, InsideArea},
    draw::{AntialiasedPolygon, FillRule},
    geometry::{InputError, TooSmall, Window},
};

use crate::outline::Contours;

/// Edges of a glyph at most, and in a row of pixels.
const EDGES: usize = 8192;
const ACTIVE: usize = 2048;

/// Columns and rows of a mask at most.
const LARGEST: u32 = 255;

/// The mask of a glyph, without rows and columns at its sides that are empty.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mask {
    /// The pixels, from that of which the pen is at the left side and the baseline at the lower side: that is column 0, row
    /// 0.
    pub window: Window,
    /// Fifteenths of each pixel, row by row.
    pub fifteenths: Vec<u8>,
}

impl Mask {
    /// The mask of an outline, by its exact area and the nonzero rule.
    ///
    /// # Errors
    /// An outline with too many edges, and one that is too large.
    pub fn of(contours: &Contours) -> anyhow::Result<Self> {
        let polygon = match AntialiasedPolygon::<EDGES, ACTIVE>::prepare(contours, FillRule::NonZero) {
            Ok(polygon) => polygon,
            Err(InputError::TooSmall(full)) => {
                let needed = full.needed();
                bail!("its outline has {needed} edges in all or in one row: more than a glyph should")
            }
            Err(_) => bail!("it is too large: choose a smaller --size"),
        };
        let window = polygon.bounds();
        if window.width() > LARGEST + 2 || window.height() > LARGEST + 2 {
            bail!(
                "it is {} x {} pixels large, and a mask has up to {LARGEST} x {LARGEST}: choose a smaller --size",
                window.width(),
                window.height()
            );
        }
        let width = window.width() as usize;
        let mut fifteenths = vec![0; width * window.height() as usize];
        let mut row_memory = vec![Default::default(); InsideArea::cells(width)];
        polygon.cover(&InsideArea, &window, &mut row_memory, |span, coverage| {
            let row = (span.y - window.top) as usize * width;
            let columns = (span.start - window.left) as usize..(span.end - window.left) as usize;
            fifteenths[row..][columns].fill(quantized(coverage));
            Ok::<_, TooSmall>(())
        })?;
        let mask = Self { window, fifteenths }.trimmed();
        if mask.window.width() > LARGEST || mask.window.height() > LARGEST {
            bail!("it is more than {LARGEST} pixels large: choose a smaller --size");
        }
        Ok(mask)
    }

    /// Fifteenths of a pixel; 0 outside.
    fn at(&self, x: i32, y: i32) -> u8 {
        if x < self.window.left || x >= self.window.right || y < self.window.top || y >= self.window.bottom {
            return 0;
        }
        let row = (y - self.window.top) as usize * self.window.width() as usize;
        self.fifteenths[row + (x - self.window.left) as usize]
    }

    fn trimmed(&self) -> Self {
        let Window {
            left,
            top,
            right,
            bottom,
        } = self.window;
        let points = || (top..bottom).flat_map(move |y| (left..right).map(move |x| (x, y)));
        let covered = || points().filter(|&(x, y)| self.at(x, y) > 0);
        let (Some(left), Some(top)) = (covered().map(|(x, _)| x).min(), covered().map(|(_, y)| y).min()) else {
            return Self {
                window: Window::EMPTY,
                fifteenths: Vec::new(),
            };
        };
        let window = Window {
            left,
            top,
            right: covered().map(|(x, _)| x + 1).max().unwrap_or(left),
            bottom: covered().map(|(_, y)| y + 1).max().unwrap_or(top),
        };
        let columns = window.left..window.right;
        let rows = (window.top..window.bottom).flat_map(|y| columns.clone().map(move |x| (x, y)));
        Self {
            window,
            fifteenths: rows.map(|(x, y)| self.at(x, y)).collect(),
        }
    }

    /// The bytes of the mask: two pixels a byte, the left one in the upper half, and each row from a new byte on.
    pub fn bytes(&self) -> Vec<u8> {
        let width = (self.window.width() as usize).max(1);
        let rows = self.fifteenths.chunks(width);
        rows.flat_map(|row| {
            row.chunks(2)
                .map(|pair| pair[0] << 4 | pair.get(1).copied().unwrap_or(0))
        })
        .collect()
    }
}

/// The nearest number of fifteenths of a coverage of 255ths; none is half way between two.
pub fn quantized(coverage: u8) -> u8 {
    ((u16::from(coverage) + 8) / 17) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coverage_is_rounded_to_the_nearest_fifteenth() {
        for coverage in 0..=255u8 {
            let distance = |fifteenths: u8| (i32::from(fifteenths) * 17 - i32::from(coverage)).abs();
            let nearest = (0..=15).min_by_key(|&fifteenths| distance(fifteenths)).unwrap();
            assert_eq!(quantized(coverage), nearest, "{coverage}");
        }
    }

    /// A square of 1.5 pixels: one pixel whole, two half, and one to a quarter.
    #[test]
    fn a_square_between_pixels() {
        let square = Contours(vec![vec![(-128, -128), (256, -128), (256, 256), (-128, 256)]]);
        let mask = Mask::of(&square).unwrap();
        assert_eq!(
            mask.window,
            Window {
                left: 0,
                top: 0,
                right: 2,
                bottom: 2
            }
        );
        // 128 of 255 is 7.5 fifteenths, and a bit more.
        assert_eq!(mask.fifteenths, [15, 8, 8, 4]);
        assert_eq!(mask.bytes(), [0xf8, 0x84]);
    }

    #[test]
    fn an_outline_without_area_has_no_mask() {
        let mask = Mask::of(&Contours::default()).unwrap();
        assert!(mask.window.is_empty() && mask.bytes().is_empty());
    }

    #[test]
    fn what_is_too_large_says_so() {
        let large = |units: i32| Contours(vec![vec![(0, 0), (units, 0), (units, units), (0, units)]]);
        for units in [300 * 256, 9000 * 256] {
            let error = Mask::of(&large(units)).unwrap_err().to_string();
            assert!(error.contains("smaller --size"), "{error}");
        }
    }
}
