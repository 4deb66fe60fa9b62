//! The circle by its parametric form, `x = r sin t`, `y = r cos t`, sampled at equal angles by rotating one point (the
//! recurrence of Rogers 1985, "Procedural Elements for Computer Graphics"; its drift is what midpoint rules were made against):
//! no square root, no trigonometry but for the one angle.
//!
//! ```text
//!   x' = x cos + y sin         o o             samples on the octant from the top
//!   y' = y cos - x sin             o           to the diagonal, less than a pixel
//!                                    o         apart; the rest is mirrored
//! ```
//!
//! Guarantees: eightfold symmetric, 8-connected, each pixel once, and none between two that already touch. Every pixel is
//! what a point of the circle rounds to, with an error of that point below 1/64 pixel at the largest radius. So its center is
//! at most 0.72 pixel off the circle, where [`Conics::bresenham_circle`](crate::scan::Conics::bresenham_circle) has at most 0.5: a
//! column's pixel is that of a point anywhere in the column, not of its middle, and about one in thirteen is another one.
//! Clipped is unclipped without the pixels outside.
//!
//! Domain: any center, every radius up to [`MAX_RADIUS`].
//!
//! Cost: three products of 64 bits on each axis for each sample, of which an octant has `0.79 r`. **All are taken, however little
//! the window shows**: a point comes only from the one before. That is why the radius is bounded; a circle whose box is
//! outside the window costs nothing.
//!
//! Take it where points on the circle are wanted at equal angles anyway: dials, dashes by angle.

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
    /// The visible pixels of the thin circle about a pixel, by points at equal angles, eight mirrored ones at a time. Radius 0 is that pixel.
    ///
    /// Cost: `0.79 r` samples of six products each, whatever is visible, and eight comparisons with the window for each pixel of
    /// an octant.
    ///
    /// # Errors
    /// [`InputError::RadiusTooLarge`] above 32,767 pixels.
    pub fn parametric_circle(
        center: Point,
        radius: u32,
        window: &Window,
    ) -> Result<impl Iterator<Item = Point> + use<>, InputError> {
        check_radius(radius, MAX_RADIUS)?;
        Ok(SampledPixels::new(
            center,
            Size::new_equal(radius),
            Sweep::Eighth,
            window,
        ))
    }
}
