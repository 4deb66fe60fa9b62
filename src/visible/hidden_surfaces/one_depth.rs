//! The z-buffer with one depth: pixel by pixel, all faces are asked for the depth that they have there.
//!
//! ```text
//!     for each pixel                      . . . . . . .      The pixel at x lies in A, which has depth 5 there, and in B,
//!       nearest = farther than all        . A A A . . .      which has depth 7: of all faces B is seen. The next pixel
//!       for each face                     . A A x B B .      begins anew: nothing is kept but one depth and one face.
//!         if the pixel lies in it         . A A B B B .
//!           and it is nearer there: take it
//! ```
//!
//! Guarantees: the picture of the depth row. Cost: a point-in-polygon test for each pixel and each face that crosses its row, and
//! the plane of each face that covers it; a turn around the loop for each face that begins above.
//!
//! Source: the z-buffer with a buffer of a single variable (Rogers 1985, "Procedural Elements for Computer Graphics", section
//! 4.7), which swaps the loops of Catmull 1974.

use embedded_graphics::geometry::Point;

use crate::{
    geometry::{TooSmall, Window},
    scan::{FillRule, Location, Polygons},
    shade::Shading,
    surface::Span,
    view::{DepthWidth, ScreenPrecision, ScreenVertex},
    visible::{
        face_table::{FaceTable, corners_from_top, covers},
        hidden_surfaces::placed::{nearest_of_all, paint_row_reporting},
        painter::Painter,
        visibility::{Method, NewMethod},
        work::Work,
    },
};

/// A test of where a point lies with respect to a polygon, such as
/// [`Polygons::winding_number`](crate::scan::Polygons::winding_number), for corners and a point in the same units.
type PointTest = fn(&[&[Point]], FillRule, &Point) -> Location;

/// The z-buffer with one depth ([`Visibility`](crate::visible::Visibility)): no memory but a few variables, whatever the size of picture and scene.
///
/// Take it where not even a row of depths fits, or to see the plainest of all methods. It is slow: each pixel looks at all faces
/// that cross its row. Which of them cover the pixel is decided by a test of points in polygons that it is made with; for points
/// on the boundary of a face the rule for top and left edges decides.
///
/// RAM: a pointer and a counter.
///
/// ```
/// use zrow::{scan::Polygons, visible::OneDepth};
///
/// let method = OneDepth::new(Polygons::crossing_number);
/// assert_eq!(method.points_tested(), 0);
/// ```
///
/// Source: Rogers 1985, section 4.7.
#[derive(Debug)]
pub struct OneDepth {
    test: PointTest,
    points_tested: u32,
}

impl OneDepth {
    /// The method with one of the tests of where a point lies.
    pub const fn new(test: PointTest) -> Self {
        Self { test, points_tested: 0 }
    }

    /// How often a pixel was tested to lie in a face since the method was made, modulo 2^32.
    pub const fn points_tested(&self) -> u32 {
        self.points_tested
    }

    /// Whether a face covers a pixel of the picture.
    fn is_covered<S: ScreenPrecision, D: DepthWidth, H: Shading>(
        &mut self,
        faces: &impl FaceTable<S, D, H>,
        node: u16,
        [column, row]: [i32; 2],
    ) -> bool {
        let Some(corners) = corners_from_top(faces, node) else {
            return false;
        };
        self.points_tested = self.points_tested.wrapping_add(1);
        let corners = corners.map(|corner: &ScreenVertex<S, D>| Point::new(corner.x_units(), corner.y_units()));
        let centre = Point::new(column << S::FRACTION_BITS, row << S::FRACTION_BITS);
        match (self.test)(&[&corners], FillRule::NonZero, &centre) {
            Location::Inside => true,
            Location::Outside => false,
            Location::OnBoundary => covers(faces, node, column, row),
        }
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for OneDepth {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "OneDepth, {} points tested", self.points_tested);
    }
}

impl<D: DepthWidth> NewMethod<D> for OneDepth {
    /// By crossing numbers.
    const NEW: Self = Self::new(Polygons::crossing_number);
}

impl<D: DepthWidth> Method<D> for OneDepth {
    fn draw<S, H, F>(&mut self, faces: &F, window: &Window, painter: &mut impl Painter<S, H>) -> Result<(), TooSmall>
    where
        S: ScreenPrecision,
        H: Shading,
        F: FaceTable<S, D, H>,
    {
        for row in window.top..window.bottom {
            let at = [window.left, row];
            paint_row_reporting(painter, faces, at, 0..window.width() as i32, |painter, column| {
                nearest_of_all(faces, (at, column), |node| {
                    painter.report(|| Work::Tested {
                        face: faces.order(node).into(),
                        span: Span::new(row, window.left + column, window.left + column + 1),
                    });
                    self.is_covered(faces, node, [window.left + column, row])
                })
            });
        }
        Ok(())
    }
}
