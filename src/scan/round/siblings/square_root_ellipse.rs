//! The ellipse by its equation, `y = b / a sqrt(a^2 - x^2)`: one integer square root a column or row, the schoolbook way.
//!
//! ```text
//!   y |  . # # # #           A root a column while the ellipse is flatter than a
//!     |            # #       diagonal, then a root a row, so that no pixel is skipped.
//!     |                #
//!     +-------------------
//!           column x
//! ```
//!
//! Guarantees: the pixels of [`Conics::midpoint_ellipse`](crate::scan::Conics::midpoint_ellipse), each once: twice the height is rounded
//! down by an exact division and an exact root, and its half rounded up. Clipped is unclipped without the pixels outside;
//! what is outside the window is not walked.
//!
//! Domain: any center, semi-axes up to [`MAX_RADIUS`], 0 included.
//!
//! Cost: up to three integer square roots and divisions for each of eight arcs, and one root and one division for each pixel, of
//! 64 bits where the product of the semi-axes is below 2^31 and of 128 bits above: the dearest by far.
//!
//! Take it to check the others by, or where single pixels of an ellipse are wanted: it needs none of the pixels before.

use embedded_graphics::geometry::{Point, Size};

use crate::{
    geometry::InputError,
    geometry::Window,
    scan::round::{
        conics::Conics,
        siblings::{arcs::ArcPixels, ellipse_arc::EllipseArc, root_descent::RootDescent},
    },
};

impl Conics {
    /// The visible pixels of the thin ellipse about a pixel with these semi-axes, by a square root a column, arc by arc. A semi-axis of 0 leaves a line.
    ///
    /// Cost: up to three integer square roots and divisions for each of eight arcs, one of both for each visible pixel.
    /// Source: the schoolbook, with an exact division and root.
    ///
    /// # Errors
    /// [`InputError::RadiusTooLarge`] where a semi-axis is above 524,287 pixels.
    pub fn square_root_ellipse(
        center: Point,
        radii: Size,
        window: &Window,
    ) -> Result<impl Iterator<Item = Point> + use<>, InputError> {
        let [top, side] = EllipseArc::both(radii)?;
        Ok(ArcPixels::<RootDescent<EllipseArc>>::new(center, top, side, window))
    }
}
