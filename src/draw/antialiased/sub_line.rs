//! A line of any width with ends at 1/256 pixel: coverage of the line as a thin polygon.

use core::num::NonZeroU32;

use fixed::types::U24F8;

use crate::{
    draw::{SubOutline, antialiased::sub_outline},
    geometry::{OutOfDomain, Sub8, SubPoint, divide_floor_wide},
};

/// A line with butt ends. Corners are exact to 1/512 pixel.
///
/// Thinner than a pixel, it gets lighter, not shorter: its area is what it is. For one that looks even from every side, see
/// [`FilteredLine`](crate::draw::FilteredLine).
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SubLine {
    start: SubPoint<Sub8>,
    end: SubPoint<Sub8>,
    /// Units.
    width: u32,
}

impl SubLine {
    /// The line between two points, `width` pixels wide.
    ///
    /// # Errors
    /// [`OutOfDomain`] where a corner may lie outside the domain.
    pub fn new(start: SubPoint<Sub8>, end: SubPoint<Sub8>, width: U24F8) -> Result<Self, OutOfDomain> {
        let width = width.to_bits();
        for point in [start, end] {
            sub_outline::check_extent(point, width / 2 + 1)?;
        }
        Ok(Self { start, end, width })
    }
}

impl SubOutline for SubLine {
    fn edges(&self, edge: &mut dyn FnMut([i32; 2], [i32; 2])) {
        let corner = |point: SubPoint<Sub8>| [point.x_units(), point.y_units()];
        let ([x0, y0], [x1, y1]) = (corner(self.start), corner(self.end));
        let (dx, dy) = (i64::from(x1) - i64::from(x0), i64::from(y1) - i64::from(y0));
        // At most 2^22 each: the square has room for 16 more bits, which the root halves. Twice that is below 2^32.
        let length = (((dx * dx + dy * dy) as u64) << 16).isqrt() as u32;
        let Some(double_length) = NonZeroU32::new(2 * length) else {
            return;
        };
        // Half the width across, rounded: 2^22 * 2^22 * 2^8 fits.
        let across = |part: i64| {
            let numerator = part * i64::from(self.width) * 256;
            divide_floor_wide(numerator + i64::from(length), double_length).0 as i32
        };
        let (nx, ny) = (across(-dy), across(dx));
        // In the domain: half the width, and a unit of rounding, had room around each end.
        sub_outline::close(
            [
                [x0 + nx, y0 + ny],
                [x1 + nx, y1 + ny],
                [x1 - nx, y1 - ny],
                [x0 - nx, y0 - ny],
            ],
            edge,
        );
    }

    fn is_simple(&self) -> bool {
        true
    }
}
