//! Antialiased lines one pixel wide between any points, filtered with a cone (Gupta and Sproull 1981).
//!
//! The coverage of a pixel is the volume of a cone of radius 1 pixel around the pixel's centre over the line, from
//! tables of distances; each covered pixel is blended over the target.

use embedded_graphics::{geometry::Dimensions, primitives::Rectangle};

use crate::{
    coverage::{Coverage, FilteredSegment},
    geometry::{InputError, Sub8, SubPoint, Window},
    shade::BlendTarget,
    surface::Span,
};

/// An antialiased line between two points: one pixel wide, filtered with a cone of radius 1 pixel, with ends cut
/// straight.
///
/// The coverage of each column (of each row, where the line is steep) adds up to the visible area of the line within
/// 0.7 %: intensity varies neither with the slope nor along the line. Before it is rounded to 1/255, the coverage of a
/// pixel is within 0.2/255 of the filtered ideal, near one end within 0.4/255, near both within 0.55/255. Cost:
/// integers only; a square root and two divisions for a line, up to five divisions for a window, and for a pixel two
/// multiplications, or ten near the ends.
///
/// Ends lie anywhere at 1/256 pixel; exchanging them does not change the picture. A line between two pixel centres
/// covers half of its first and of its last pixel. Lines that meet are blended over each other, one after the other.
///
/// ```
/// use embedded_graphics::{pixelcolor::Gray8, prelude::*, primitives::Rectangle};
/// use zrow::{band::Band, draw::FilteredLine, geometry::SubPoint};
///
/// let mut words = [0; 8 * 5];
/// let mut band = Band::<Gray8>::new(Rectangle::new(Point::zero(), Size::new(8, 5)), &mut words)?;
/// // From the left side of pixel (2, 2) to the right side of pixel (5, 2).
/// let line = FilteredLine::new(SubPoint::from_units(384, 512)?, SubPoint::from_units(1408, 512)?)?;
/// let Ok(()) = line.draw(&mut band, Gray8::WHITE);
/// assert_eq!(words[2 * 8..3 * 8], [0, 24, 175, 199, 199, 175, 24, 0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FilteredLine(FilteredSegment);

impl FilteredLine {
    /// A line between two points. A line without length draws nothing.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where a point is not in the domain of [`Sub8`]: clip or move the line first.
    pub fn new(start: SubPoint<Sub8>, end: SubPoint<Sub8>) -> Result<Self, InputError> {
        FilteredSegment::new(start, end).map(Self)
    }

    /// Blends the line over the target, inside the target's window.
    ///
    /// # Errors
    /// The target's own error.
    pub fn draw<T: BlendTarget>(&self, target: &mut T, color: T::Color) -> Result<(), T::Error> {
        let window = target.window();
        self.cover(&window, |span, coverage| {
            target.blend_clipped_span(span, color, coverage)
        })
    }

    /// Calls `emit` with each covered pixel of a window as a span of one pixel and its coverage: each pixel once, in
    /// order along the line.
    ///
    /// # Errors
    /// The first error that `emit` returns.
    pub fn cover<E>(&self, window: &Window, emit: impl FnMut(Span, Coverage) -> Result<(), E>) -> Result<(), E> {
        self.0.cover(window, emit)
    }
}

impl Dimensions for FilteredLine {
    /// A box around all pixels that the line covers; may be larger than necessary.
    fn bounding_box(&self) -> Rectangle {
        self.0.window().to_rectangle()
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::{
        mock_display::MockDisplay,
        pixelcolor::{Gray4, GrayColor},
    };

    use super::*;
    use crate::draw::pictures::{at, blended};

    /// Draws a line between two points (column, row).
    fn drawn(start: (f32, f32), end: (f32, f32)) -> MockDisplay<Gray4> {
        let line = FilteredLine::new(at(start.0, start.1), at(end.0, end.1)).unwrap();
        blended(|band| {
            let Ok(()) = line.draw(band, Gray4::WHITE);
        })
    }

    /// The line's own row has 0.78 of its light and each row beside it 0.11, because the cone is wider than the line.
    #[test]
    fn a_level_line_has_three_rows() {
        drawn((1.5, 2.0), (10.5, 2.0)).assert_pattern(&[
            "            ",
            "  222222222 ",
            " 1ACCCCCCCA1",
            "  222222222 ",
        ]);
    }

    #[test]
    fn a_diagonal_line_is_symmetric() {
        drawn((2.0, 2.0), (9.0, 9.0)).assert_pattern(&[
            "          ",
            "          ",
            "  65      ",
            "  5C5     ",
            "   5C5    ",
            "    5C5   ",
            "     5C5  ",
            "      5C5 ",
            "       5C5",
            "        56",
        ]);
    }

    #[test]
    fn a_level_line_between_two_rows_is_as_light_in_both() {
        drawn((1.5, 2.5), (10.5, 2.5)).assert_pattern(&[
            "            ",
            "            ",
            " 17888888871",
            " 17888888871",
        ]);
    }

    #[test]
    fn a_line_cut_by_the_left_edge_from_either_end() {
        let pattern = [
            "            ",
            "1           ",
            "B841        ",
            "38BB831     ",
            "  148BB73   ",
            "     149CA62",
            "        25A6",
        ];
        drawn((-6.0, 0.0), (11.0, 6.0)).assert_pattern(&pattern);
        drawn((11.0, 6.0), (-6.0, 0.0)).assert_pattern(&pattern);
    }
}
