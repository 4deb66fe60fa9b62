//! A line of any width with ends at 1/256 pixel: coverage of the line as a thin polygon.

use fixed::types::U24F8;

use crate::{
    draw::{SubOutline, sub_outline},
    geometry::{OutOfDomain, Sub8, SubPoint},
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
        // Below 2^23 each: the square has room for 16 more bits, which the root halves.
        let length = (((dx * dx + dy * dy) as u64) << 16).isqrt() as i64;
        if length == 0 {
            return;
        }
        // Half the width across, rounded: 2^23 * 2^22 * 2^8 fits.
        let across = |part: i64| {
            let numerator = part * i64::from(self.width) * 256;
            (numerator + length).div_euclid(2 * length) as i32
        };
        let (nx, ny) = (across(-dy), across(dx));
        let moved = |[x, y]: [i32; 2], nx: i32, ny: i32| [x.wrapping_add(nx), y.wrapping_add(ny)];
        let (back_x, back_y) = (nx.wrapping_neg(), ny.wrapping_neg());
        let (start, end) = ([x0, y0], [x1, y1]);
        sub_outline::close(
            [
                moved(start, nx, ny),
                moved(end, nx, ny),
                moved(end, back_x, back_y),
                moved(start, back_x, back_y),
            ],
            edge,
        );
    }

    fn is_simple(&self) -> bool {
        true
    }
}
