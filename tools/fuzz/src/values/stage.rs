//! Where a picture lies: a small window anywhere in `i32`, cut into bands and a smaller window.

use arbitrary::{Arbitrary, Result, Unstructured};
use embedded_graphics::{geometry::Point, primitives::Rectangle};
use zrow::geometry::Window;

use super::{Int, Spot, numbers::around_zero};

/// The window of a picture, and the parts in which it is drawn as well.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct Stage {
    /// Up to 24 x 16 pixels, at least one.
    pub window: Window,
    /// Rows of a band.
    pub rows: u32,
    /// A part of the window; it has pixels.
    pub part: Window,
    /// Whether bands are drawn from the last one to the first one.
    pub upwards: bool,
}

/// Most columns of a picture.
const MOST_COLUMNS: i32 = 24;
/// Most rows of a picture.
const MOST_ROWS: i32 = 16;

impl<'a> Arbitrary<'a> for Stage {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> Result<Self> {
        let (width, height) = (
            bytes.int_in_range(1..=MOST_COLUMNS)?,
            bytes.int_in_range(1..=MOST_ROWS)?,
        );
        let (left, top) = match bytes.arbitrary::<u8>()? {
            0..=159 => (0, 0),
            160..=207 => (start(bytes, width)?, start(bytes, height)?),
            208..=231 => (start(bytes, width)?, 0),
            _ => (0, start(bytes, height)?),
        };
        let window = Window {
            left,
            top,
            right: left + width,
            bottom: top + height,
        };
        let (columns, rows) = (bytes.int_in_range(1..=width)?, bytes.int_in_range(1..=height)?);
        let (part_left, part_top) = (
            left + bytes.int_in_range(0..=width - columns)?,
            top + bytes.int_in_range(0..=height - rows)?,
        );
        Ok(Self {
            window,
            rows: bytes.int_in_range(1..=MOST_ROWS as u32)?,
            part: Window {
                left: part_left,
                top: part_top,
                right: part_left + columns,
                bottom: part_top + rows,
            },
            upwards: bytes.arbitrary()?,
        })
    }
}

/// The first coordinate of a picture of that length: close to it there is `i32::MIN`, `i32::MAX`, an edge or nothing.
fn start(bytes: &mut Unstructured<'_>, length: i32) -> Result<i32> {
    let last = i32::MAX - length;
    Ok(match bytes.arbitrary::<u8>()? {
        0..=79 => around_zero(bytes, -40, 40)?,
        80..=119 => i32::MIN + bytes.int_in_range(0..=3)?,
        120..=159 => last - bytes.int_in_range(0..=3)?,
        160..=223 => Int::arbitrary(bytes)?.0.saturating_sub(length / 2).min(last),
        _ => bytes.int_in_range(i32::MIN..=last)?,
    })
}

impl Stage {
    /// The first pixel.
    pub const fn origin(&self) -> Point {
        Point::new(self.window.left, self.window.top)
    }

    /// All of it.
    pub const fn area(&self) -> Rectangle {
        self.window.to_rectangle()
    }

    /// The pixel that a spot stands for.
    pub fn point(&self, spot: Spot) -> Point {
        spot.from(self.origin())
    }

    /// Pixels of the window.
    pub const fn pixels(&self) -> usize {
        self.window.width() as usize * self.window.height() as usize
    }

    /// The windows of its bands, in the order in which they are drawn.
    pub fn bands(&self, rows: u32) -> Vec<Window> {
        let Window { top, bottom, .. } = self.window;
        let tops = (top..bottom).step_by(rows as usize);
        let mut bands: Vec<_> = tops
            .map(|top| Window {
                top,
                bottom: bottom.min(top.saturating_add_unsigned(rows)),
                ..self.window
            })
            .collect();
        if self.upwards {
            bands.reverse();
        }
        bands
    }

    /// Whether sub-pixel coordinates around it are in the domain of [`Sub8`](zrow::geometry::Sub8), and its pixels are.
    pub fn is_in_domain(&self) -> bool {
        let domain = -8_000..=8_000;
        let Window {
            left,
            top,
            right,
            bottom,
        } = self.window;
        [left, top, right, bottom].iter().all(|side| domain.contains(side))
    }
}
