//! The ellipse by its parametric form, `x = a sin t`, `y = b cos t`, sampled at equal steps of `t` by turning one point (the
//! recurrence of Rogers 1985, "Procedural Elements for Computer Graphics") on the circle that has the longer semi-axis as its
//! radius, and squeezing the shorter axis: no square root, no trigonometry but for the one step.
//!
//! ```text
//!   x' = x cos + y sin        o  o  o            samples of a quarter, less
//!   y' = y cos - x sin                o  o       than a pixel apart; the rest
//!   pixel x', y' b / a                     o     is mirrored
//! ```
//!
//! Guarantees: symmetric about both axes, 8-connected, each pixel once, and none between two that already touch. Every pixel
//! is what a point of the ellipse rounds to, with an error of that point below 1/64 pixel at the largest semi-axis. So its
//! center is at most 0.72 pixel off the ellipse, where [`Conics::midpoint_ellipse`](crate::scan::Conics::midpoint_ellipse) has at most
//! 0.5. Clipped is unclipped without the pixels outside.
//!
//! Domain: any center, semi-axes up to [`MAX_RADIUS`], 0 included.
//!
//! Cost: three products of 64 bits on each axis for each sample, of which a quarter has 1.57 times the longer semi-axis. **All
//! are taken, however little the window shows**: a point comes only from the one before. That is why the semi-axes are
//! bounded; an ellipse whose box is outside the window costs nothing.
//!
//! Take it where points on the ellipse are wanted at equal steps of `t` anyway, as for a turning body.

use embedded_graphics::geometry::{Point, Size};

use crate::scan::round::{conics::Conics, siblings::rotation::MAX_RADIUS};
use crate::{
    geometry::InputError,
    geometry::Window,
    scan::round::{
        radius::check_radius,
        siblings::rotation::{SampledPixels, Sweep},
    },
};

impl Conics {
    /// The visible pixels of the thin ellipse about a pixel with these semi-axes, by points at equal steps of its
    /// parameter, four mirrored ones at a time. A semi-axis of 0 leaves a line.
    ///
    /// Cost: six products for each sample, 1.57 samples for each pixel of the longer semi-axis, whatever is visible, and four
    /// comparisons with the window for each pixel of a quarter.
    ///
    /// # Errors
    /// [`InputError::RadiusTooLarge`] where a semi-axis is above 32,767 pixels.
    pub fn parametric_ellipse(
        center: Point,
        radii: Size,
        window: &Window,
    ) -> Result<impl Iterator<Item = Point> + use<>, InputError> {
        check_radius(radii.width.max(radii.height), MAX_RADIUS)?;
        Ok(SampledPixels::new(center, radii, Sweep::Quarter, window))
    }
}
