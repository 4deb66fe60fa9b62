//! The midpoint circle (Pitteway 1967, "Algorithm for Drawing Ellipses or Hyperbolae with a Digital Plotter", The Computer
//! Journal 10(3); Van Aken and Novak 1985, "Curve-Drawing Algorithms for Raster Displays", ACM Transactions on Graphics 4(2);
//! with second differences as Foley, van Dam, Feiner and Hughes 1990 have it): on which side of the circle lies the point
//! midway between the two pixels that may come next?
//!
//! ```text
//!   # E      The next pixel is E or SE. The midpoint M between them is inside
//!     M      the circle: E is nearer; it is outside: SE is nearer.
//!     SE
//! ```
//!
//! The decision variable is the circle's implicit function `F(x, y) = x^2 + y^2 - r^2` at M, less a quarter; a step to E adds
//! `2 x + 3` to it, a step to SE `2 (x - y) + 5`, and these two numbers grow by 2 and 2, or 2 and 4.
//!
//! Guarantees: in the octant from the top to the diagonal the pixel of each column that is nearest to the exact circle, the
//! pixels of [`Conics::bresenham_circle`](crate::scan::Conics::bresenham_circle), each once, for every center and every radius up to
//! [`MAX_RADIUS`]. Clipped is unclipped without the pixels outside; octants and columns outside the window are not walked.
//!
//! Cost: up to three integer square roots for each octant; a comparison and two sums of 64 bits a pixel.
//!
//! Take it as the pattern for other curves with an implicit function; for circles Bresenham's rows also say what the circle
//! encloses, in 32 bits.

use embedded_graphics::geometry::Point;

use crate::scan::round::{bresenham_circle::MAX_RADIUS, conics::Conics};
use crate::{
    geometry::InputError,
    geometry::Window,
    scan::round::{
        radius::check_radius,
        siblings::{
            arcs::{ArcPixels, Descent},
            circle_arc::CircleArc,
        },
    },
};

impl Conics {
    /// The visible pixels of the thin circle about a pixel, by the midpoint rule, octant by octant. Radius 0 is that pixel.
    ///
    /// Cost: up to three integer square roots for each of the eight octants, and constant for each visible pixel.
    /// Source: Pitteway 1967; Van Aken and Novak 1985.
    ///
    /// # Errors
    /// [`InputError::RadiusTooLarge`] above 2,147,483,647 pixels.
    pub fn midpoint_circle(
        center: Point,
        radius: u32,
        window: &Window,
    ) -> Result<impl Iterator<Item = Point> + use<>, InputError> {
        check_radius(radius, MAX_RADIUS)?;
        let arc = CircleArc { radius };
        Ok(ArcPixels::<MidpointDescent>::new(center, arc, arc, window))
    }
}

/// The decision variable and its two increments.
#[derive(Debug, Clone)]
struct MidpointDescent {
    /// Above -1 where the midpoint ahead is outside the circle.
    decision: i64,
    /// What a step to the side adds to the decision variable.
    east: i64,
    /// What a step to the side and down adds to the decision variable.
    south_east: i64,
}

impl Descent for MidpointDescent {
    type Arc = CircleArc;

    fn enter(arc: &CircleArc, column: u32, height: u32) -> Self {
        let [x, y, radius] = [column, height, arc.radius].map(i64::from);
        Self {
            // Three squares below 2^62 each.
            decision: (x + 1) * (x + 1) + y * y - y - radius * radius,
            east: 2 * x + 3,
            south_east: 2 * (x - y) + 5,
        }
    }

    #[inline]
    fn descends(&mut self) -> bool {
        let descends = self.decision >= 0;
        self.decision += if descends { self.south_east } else { self.east };
        self.east += 2;
        self.south_east += if descends { 4 } else { 2 };
        descends
    }
}
