//! The midpoint ellipse (Pitteway 1967, "Algorithm for Drawing Ellipses or Hyperbolae with a Digital Plotter", The Computer
//! Journal 10(3); Van Aken 1984, "An Efficient Ellipse-Drawing Algorithm", IEEE Computer Graphics and Applications 4(9)):
//! on which side of the ellipse lies the point midway between the two pixels that may come next?
//!
//! ```text
//!   # E          region 1, flatter than a diagonal: a pixel a column, E or SE
//!     M SE
//!        . .
//!            #   region 2, steeper: a pixel a row, S or SE
//!           S M SE
//! ```
//!
//! Textbooks walk from region 1 into region 2 as the gradient changes sides, and lose the tips of thin ellipses, where row 0 is
//! reached first. Here region 2 is walked upwards from the tip: it is region 1 of the ellipse with its axes exchanged.
//!
//! Guarantees: a column belongs to region 1 where the exact ellipse in the middle of it, or the pixel nearest to that, is on the
//! flat side of the diagonal: `b^2 x <= a^2 y`; rows alike. Each has the pixel nearest to the exact ellipse (there are no ties),
//! each pixel comes once, and all together are 8-connected. With equal axes they are
//! [`Conics::bresenham_circle`](crate::scan::Conics::bresenham_circle)'s. Clipped is unclipped without the pixels outside; what is outside
//! the window is not walked.
//!
//! Domain: any center, semi-axes up to [`MAX_RADIUS`], 0 included.
//!
//! Cost: up to three integer square roots and divisions of 128 bits for each of eight arcs; a comparison and two sums of 64
//! bits a pixel.
//!
//! Take it for thin ellipses about a pixel: [`Conics::square_root_ellipse`](crate::scan::Conics::square_root_ellipse) divides in each step.

use embedded_graphics::geometry::{Point, Size};

use crate::{
    geometry::InputError,
    geometry::Window,
    scan::round::{
        conics::Conics,
        siblings::{
            arcs::{ArcPixels, Descent},
            circle_arc::square,
            ellipse_arc::EllipseArc,
        },
    },
};

impl Conics {
    /// The visible pixels of the thin ellipse about a pixel with these semi-axes, by the midpoint rule, arc by arc. A semi-axis of 0 leaves a line.
    ///
    /// Cost: up to three integer square roots and divisions of 128 bits for each of eight arcs, and constant for each visible
    /// pixel.
    /// Source: Pitteway 1967; Van Aken 1984.
    ///
    /// # Errors
    /// [`InputError::RadiusTooLarge`] where a semi-axis is above 524,287 pixels.
    pub fn midpoint_ellipse(
        center: Point,
        radii: Size,
        window: &Window,
    ) -> Result<impl Iterator<Item = Point> + use<>, InputError> {
        let [top, side] = EllipseArc::both(radii)?;
        Ok(ArcPixels::<MidpointDescent>::new(center, top, side, window))
    }
}

/// The decision variable and its increments.
#[derive(Debug, Clone)]
struct MidpointDescent {
    /// Four times the implicit function `b^2 x^2 + a^2 y^2 - a^2 b^2` at the midpoint ahead: above 0 where that is outside.
    decision: i64,
    /// What a step to the side adds to the decision variable.
    east: i64,
    /// What each step to the side adds more than the one before, `8 b^2`.
    east_increment: i64,
    /// What a step down adds to the decision variable besides.
    south: i64,
    /// What each step down adds more than the one before, `8 a^2`.
    south_increment: i64,
    /// Rows above the axis: no outline goes below it.
    height: u32,
}

impl Descent for MidpointDescent {
    type Arc = EllipseArc;

    fn enter(arc: &EllipseArc, column: u32, height: u32) -> Self {
        let (a_2, b_2) = (square(arc.a) as i64, square(arc.b) as i64);
        let (x, y) = (i64::from(column), i64::from(height));
        let [wide_a_2, wide_b_2] = [a_2, b_2].map(i128::from);
        let [next_2, middle_2] = [(2 * x + 2) * (2 * x + 2), (2 * y - 1) * (2 * y - 1)].map(i128::from);
        Self {
            // Next to the ellipse the terms cancel to less than 2^62.
            decision: (wide_b_2 * next_2 + wide_a_2 * middle_2 - 4 * wide_a_2 * wide_b_2) as i64,
            east: 4 * b_2 * (2 * x + 3),
            east_increment: 8 * b_2,
            south: -8 * a_2 * (y - 1),
            south_increment: 8 * a_2,
            height,
        }
    }

    #[inline]
    fn descends(&mut self) -> bool {
        let descends = self.decision > 0 && self.height > 0;
        self.decision += self.east;
        self.east += self.east_increment;
        if descends {
            self.decision += self.south;
            self.south += self.south_increment;
            self.height -= 1;
        }
        descends
    }
}
