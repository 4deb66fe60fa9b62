//! The ends of a stroke.
//!
//! Guarantees: what a cap adds to the rectangle along the stroke's last segment, in 1/65,536 pixel. Sources: the butt,
//! square and round caps of PostScript (Adobe 1985), and the end that this library's lines have by default.

use crate::scan::stroke::wide_stroke::{Offsets, Position, UNIT};

/// How an open stroke, or a dash, begins and ends.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*, primitives::Line};
/// use zrow::draw::{LineCap, StrokeStyle};
///
/// // From column 3 to column 7, five pixels wide.
/// let line = Line::new(Point::new(3, 2), Point::new(7, 2));
/// for (cap, pattern) in [
///     (LineCap::WholePixel, ["   #####  "; 5]),
///     (LineCap::Butt, ["   ####   "; 5]),
///     (LineCap::Square, [" #########"; 5]),
///     (LineCap::Round, ["  ####### ", " #########", " #########", " #########", "  ####### "]),
/// ] {
///     let mut display = MockDisplay::new();
///     line.into_styled(StrokeStyle::new(BinaryColor::On, 5).cap(cap)).draw(&mut display)?;
///     display.assert_pattern(&pattern);
/// }
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum LineCap {
    /// Half a pixel beyond the end point, so that the stroke reaches to the outer side of that pixel: a level line from
    /// column 3 to column 5 takes three columns, as in embedded-graphics. Take it for strokes between whole pixels. In an
    /// antialiased stroke of a shape at sub-pixel positions it counts as [`Butt`](Self::Butt).
    #[default]
    WholePixel,
    /// At the end point, exactly: a level line from column 3 to column 5 takes two columns. Take it where strokes, or
    /// dashes, are to be as long as they say.
    Butt,
    /// Half the width beyond the end point.
    Square,
    /// A disc about the end point, as wide as the stroke.
    Round,
}

impl LineCap {
    /// How much longer the cap makes the stroke's rectangle, as a vector along the stroke.
    pub(crate) fn extension(self, offsets: &Offsets) -> Position {
        match self {
            Self::WholePixel => offsets.half_pixel,
            Self::Butt | Self::Round => (0, 0),
            // The normal, turned back along the stroke.
            Self::Square => (offsets.normal.1, -offsets.normal.0),
        }
    }

    /// How far the cap reaches beyond the end point, in 1/65,536 pixel, but for rounding.
    pub(crate) const fn reach(self, half_width: i64) -> i64 {
        match self {
            Self::WholePixel => UNIT / 2,
            Self::Butt => 0,
            Self::Square | Self::Round => half_width,
        }
    }

    /// Whether the caps of two dashes of a segment close a gap between them, in 1/65,536 pixel: they touch, and where they
    /// are round, the notch between the two discs is at most half a unit deep.
    pub(crate) const fn bridges(self, gap: u32, half_width: i64) -> bool {
        match self {
            Self::Butt | Self::WholePixel | Self::Square => gap as i64 <= 2 * self.reach(half_width),
            // The notch is gap^2 / (8 half_width) deep: the sagitta of half the gap.
            Self::Round => gap as u64 * gap as u64 <= 4 * half_width as u64,
        }
    }
}
