//! A line of any width with ends at 1/256 pixel: the rectangle around the line, as an outline for antialiasing.
//!
//! The direction across the line is its direction turned by a quarter, scaled to half of the width; each corner is an
//! end of the line plus or minus that vector:
//!
//! ```text
//!    start + n              end + n
//!       +----------------------+      ---
//!       |start              end|       | width
//!       +----------------------+      ---
//!    start - n              end - n
//! ```

use core::num::NonZeroU32;

use embedded_graphics::{
    geometry::Dimensions,
    pixelcolor::PixelColor,
    primitives::{Primitive, Rectangle},
};
use fixed::types::U24F8;

use crate::{
    draw::{
        FillRule, PrimitiveStyle, StrokedShape, SubOutline,
        antialiased::{
            layers::{LayerSink, OutlinedShape},
            strokes::{fill_and_stroke, position},
            sub_outline::{self, Corner},
        },
    },
    geometry::{InputError, Sub8, SubPoint, divide_floor_wide},
    scan::stroke::wide_stroke::Path,
};

/// A line with butt ends. Its corners are rounded to 1/256 pixel. Its length is first rounded down to 1/65,536 pixel,
/// which makes a very short line wider by the same ratio.
///
/// A line thinner than a pixel gets lighter, not shorter: its coverage adds up to its area. For a line of one pixel
/// whose intensity does not depend on its slope, see [`FilteredLine`](crate::draw::FilteredLine).
///
/// ```
/// use embedded_graphics::{pixelcolor::Gray8, prelude::*, primitives::Rectangle};
/// use zrow::{
///     band::Band,
///     draw::{DrawAntialiased, PrimitiveStyle, SubLine},
///     fixed::types::U24F8,
///     geometry::{Sub8, SubPoint},
/// };
///
/// // Along the middle of row 1, from the centre of pixel 1 to that of pixel 5, half a pixel wide.
/// let at = |x, y| SubPoint::<Sub8>::from_pixel(Point::new(x, y));
/// let hand = SubLine::new(at(1, 1)?, at(5, 1)?, U24F8::from_num(0.5))?;
///
/// let mut words = [0; 8 * 3];
/// let mut band = Band::<Gray8>::new(Rectangle::new(Point::zero(), Size::new(8, 3)), &mut words)?;
/// let style = PrimitiveStyle::with_fill(Gray8::WHITE).antialiased();
/// hand.into_styled(style).draw_on(&mut band.antialiased::<4, 4>(&mut [0; 9]))?;
/// assert_eq!(words[8..16], [0, 64, 128, 128, 128, 64, 0, 0]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SubLine {
    start: SubPoint<Sub8>,
    end: SubPoint<Sub8>,
    /// Width of the line in 1/256 pixel.
    width: u32,
}

impl SubLine {
    /// A line between two points, `width` pixels wide. A line without length has no edges.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where half of the width around an end, and 1/256 pixel of rounding, leaves the domain of
    /// [`Sub8`].
    pub fn new(start: SubPoint<Sub8>, end: SubPoint<Sub8>, width: U24F8) -> Result<Self, InputError> {
        let width = width.to_bits();
        for point in [start, end] {
            sub_outline::check_extent(point, width / 2 + 1)?;
        }
        Ok(Self { start, end, width })
    }
}

impl SubLine {
    /// The corners of the rectangle around the line; `None` for a line without length.
    fn corners(&self) -> Option<[Corner; 4]> {
        let corner = |point: SubPoint<Sub8>| [point.x_units(), point.y_units()];
        let ([x0, y0], [x1, y1]) = (corner(self.start), corner(self.end));
        let (dx, dy) = (i64::from(x1) - i64::from(x0), i64::from(y1) - i64::from(y0));
        // The differences are at most 2^22 each, so that the sum of squares has room for 16 more bits: the root is the
        // length in 1/65,536 pixel, and twice that is below 2^32.
        let length = (((dx * dx + dy * dy) as u64) << 16).isqrt() as u32;
        let double_length = NonZeroU32::new(2 * length)?;
        // A component of the line's direction scaled to half of the width, rounded to the nearest 1/256 pixel: 2^22 *
        // 2^22 * 2^8 fits `i64`.
        let across = |part: i64| {
            let numerator = part * i64::from(self.width) * 256;
            divide_floor_wide(numerator + i64::from(length), double_length).0 as i32
        };
        let (nx, ny) = (across(-dy), across(dx));
        // No overflow: `new` has checked that half the width and 1/256 pixel of rounding fit around each end.
        Some([
            [x0 + nx, y0 + ny],
            [x1 + nx, y1 + ny],
            [x1 - nx, y1 - ny],
            [x0 - nx, y0 - ny],
        ])
    }
}

impl SubOutline for SubLine {
    /// The first corner is an upper end of both y-monotone chains, so that a picture keeps no more than these two.
    fn edges(&self, edge: &mut dyn FnMut(Corner, Corner)) {
        let Some(mut corners) = self.corners() else { return };
        let uppermost = (0..).zip(corners).min_by_key(|(_, [_, y])| *y);
        corners.rotate_left(uppermost.map_or(0, |(index, _)| index));
        sub_outline::close(corners, edge);
    }

    fn is_simple(&self) -> bool {
        true
    }
}

impl Dimensions for SubLine {
    /// The pixels that the line may cover.
    fn bounding_box(&self) -> Rectangle {
        let [first, last] = sub_outline::around(self.corners().into_iter().flatten());
        sub_outline::pixels_between(first, last)
    }
}

impl Primitive for SubLine {}

/// The stroke of a style runs around the line, which is what the fill fills.
impl StrokedShape for SubLine {
    fn paths(&self, width_in_halves: u64, call: &mut dyn FnMut(&Path<'_>)) {
        let Some(corners) = self.corners() else { return };
        let vertex = |index: usize| position(corners.get(index).copied().unwrap_or_default());
        call(&Path::new(&vertex, corners.len(), true, width_in_halves));
    }

    fn is_sub_pixel(&self) -> bool {
        true
    }
}

impl OutlinedShape for SubLine {
    fn layers<C: PixelColor>(&self, style: &PrimitiveStyle<C>, layer: &mut LayerSink<'_, C>) -> Result<(), InputError> {
        fill_and_stroke(self, FillRule::NonZero, style, layer)
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::{
        mock_display::MockDisplay,
        pixelcolor::{Gray4, GrayColor},
    };

    use super::*;
    use crate::{
        coverage::SignedArea,
        draw::{
            AntialiasedPolygon,
            pictures::{at, blended},
        },
    };

    /// Draws a line between two points (column, row), `width` pixels wide.
    fn drawn(start: (f32, f32), end: (f32, f32), width: f32) -> MockDisplay<Gray4> {
        let line = SubLine::new(at(start.0, start.1), at(end.0, end.1), U24F8::from_num(width)).unwrap();
        let polygon = AntialiasedPolygon::<4, 4>::prepare(&line, FillRule::NonZero).unwrap();
        blended(|band| polygon.draw(&SignedArea, Gray4::WHITE, band, &mut [0; 17]).unwrap())
    }

    /// Between two pixel centres the line covers half of the first and of the last column.
    #[test]
    fn a_level_line_2_pixels_wide_covers_half_of_the_rows_beside_it() {
        drawn((1.0, 2.0), (10.0, 2.0), 2.0).assert_pattern(&[
            "           ",
            " 4888888884",
            " 8FFFFFFFF8",
            " 4888888884",
        ]);
    }

    #[test]
    fn a_line_half_a_pixel_wide_is_half_as_light() {
        drawn((0.5, 1.0), (9.5, 1.0), 0.5).assert_pattern(&[
            "          ", //
            " 888888888",
        ]);
    }

    #[test]
    fn a_diagonal_line_3_pixels_wide_has_straight_ends() {
        drawn((3.0, 3.0), (10.0, 10.0), 3.0).assert_pattern(&[
            "            ",
            "            ",
            "    5       ",
            "   8F9      ",
            "  5FFF9     ",
            "   9FFF9    ",
            "    9FFF9   ",
            "     9FFF9  ",
            "      9FFF9 ",
            "       9FFF5",
            "        9F8 ",
            "         5  ",
        ]);
    }

    #[test]
    fn a_line_cut_by_the_left_edge() {
        drawn((-6.0, -0.5), (10.0, 5.5), 1.5).assert_pattern(&[
            "           ",
            "83         ",
            "FFC61      ",
            "16CFFA5    ",
            "   38EFE83 ",
            "      5AFF8",
            "        164",
        ]);
    }

    #[test]
    fn a_line_without_length_draws_nothing() {
        drawn((4.0, 4.0), (4.0, 4.0), 3.0).assert_pattern(&[]);
    }
}
