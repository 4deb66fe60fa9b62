//! Lines one pixel wide without steps, between any points: Gupta-Sproull.

use embedded_graphics::{geometry::Dimensions, primitives::Rectangle};

use crate::{
    coverage::FilteredSegment,
    geometry::{OutOfDomain, Sub8, SubPoint},
    shade::BlendTarget,
};

/// A smooth line between two points: one pixel wide, filtered with a cone of radius 1 pixel, its ends cut straight.
///
/// The line has as much light as its area, the same at any slope and all along it; errors and cost are those of
/// [`gupta_sproull`](crate::coverage::line::gupta_sproull). Ends are anywhere at 1/256 pixel, and either may be the first.
/// Between two pixel centres, it covers half of the first and of the last pixel. Where lines meet, each is drawn over the
/// others.
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
    /// A line between two points. Without length, it draws nothing.
    ///
    /// # Errors
    /// [`OutOfDomain`] where a point is not in the domain of [`Sub8`]: cut the line first, or move it.
    pub fn new(start: SubPoint<Sub8>, end: SubPoint<Sub8>) -> Result<Self, OutOfDomain> {
        FilteredSegment::new(start, end).map(Self)
    }

    /// Draws what is inside the target's window, over what is there.
    ///
    /// # Errors
    /// The target's own.
    pub fn draw<T: BlendTarget>(&self, target: &mut T, color: T::Color) -> Result<(), T::Error> {
        let window = target.window();
        self.0.cover(&window, |span, coverage| {
            target.blend_clipped_span(span, color, coverage)
        })
    }
}

impl Dimensions for FilteredLine {
    /// All pixels that it touches, and some more.
    fn bounding_box(&self) -> Rectangle {
        self.0.window().to_rectangle()
    }
}
