//! The circle by its equation, `y = sqrt(r^2 - x^2)`: one integer square root a column, the schoolbook way.
//!
//! ```text
//!   y |  . # # #          Up to the diagonal only, where each column has one pixel;
//!     |          # #      beyond it the axes change places. Taken over the whole
//!     |              #    quarter, as the equation tempts to, columns near the side
//!     +----------------   would leave gaps.
//!        column x
//! ```
//!
//! Guarantees: in the octant from the top to the diagonal the pixel of each column that is nearest to the exact circle, the
//! pixels of [`Conics::bresenham_circle`](crate::scan::Conics::bresenham_circle), each once, for every center and every radius up to
//! [`MAX_RADIUS`]: twice the height is rounded down by an exact root, and its half rounded up. Clipped is unclipped without
//! the pixels outside; octants and columns outside the window are not walked.
//!
//! Cost: up to three integer square roots for each octant, and one of 64 bits for each pixel: the dearest by far.
//!
//! Take it to check the others by, or where single pixels of a circle are wanted: it needs none of the pixels before.

use embedded_graphics::geometry::Point;

use crate::scan::round::{bresenham_circle::MAX_RADIUS, conics::Conics};
use crate::{
    geometry::InputError,
    geometry::Window,
    scan::round::{
        radius::check_radius,
        siblings::{arcs::ArcPixels, circle_arc::CircleArc, root_descent::RootDescent},
    },
};

impl Conics {
    /// The visible pixels of the thin circle about a pixel, by a square root a column, octant by octant. Radius 0 is that pixel.
    ///
    /// Cost: up to three integer square roots for each of the eight octants, and one for each visible pixel.
    /// Source: the schoolbook, with an exact root.
    ///
    /// # Errors
    /// [`InputError::RadiusTooLarge`] above 2,147,483,647 pixels.
    pub fn square_root_circle(
        center: Point,
        radius: u32,
        window: &Window,
    ) -> Result<impl Iterator<Item = Point> + use<>, InputError> {
        check_radius(radius, MAX_RADIUS)?;
        let arc = CircleArc { radius };
        Ok(ArcPixels::<RootDescent<CircleArc>>::new(center, arc, arc, window))
    }
}
