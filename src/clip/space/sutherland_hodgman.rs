//! Sutherland and Hodgman (1974, "Reentrant Polygon Clipping", Communications of the ACM 17(1)) in homogeneous coordinates: a
//! face against -w <= x <= w, -w <= y <= w, 0 <= z <= w, one plane after the other.
//!
//! ```text
//!          B                    from outside to inside: the crossing, then the corner
//!         / \                   from inside to inside:  the corner
//!     ---*---*--- the plane     from inside to outside: the crossing
//!       /     \
//!      A-------C                A B C becomes A * * C
//! ```
//!
//! A corner that a plane adds is the exact crossing of the edge between two corners, each number rounded once; the same for
//! both faces that share the edge, because rounding does not depend on the direction. Attributes are cut by the same fraction
//! of the edge. They vary evenly in homogeneous space as they do in eye space, so that nothing is divided by w.
//!
//! Guarantees: corners are in the volume but for one unit of the matrix's format. Right for corners beside the eye and behind
//! it, and for a face around the eye.

use heapless::Vec;

use crate::clip::space::{clip_matrix::ClipMatrix, clip_point::ClipPoint, fraction::Fraction};

/// A corner: its position, and numbers that vary evenly over the face.
pub(super) type Corner<P, const N: usize> = (P, [i32; N]);

/// The corners of a convex polygon. A face has three, and each of the six planes adds one.
pub(super) type Corners<P, const N: usize> = Vec<Corner<P, N>, 9>;

impl ClipMatrix {
    /// What a camera sees of a face: the corners of a convex polygon in clip coordinates, in the order of the face's vertices,
    /// with `N` numbers that vary evenly over it, such as texture coordinates. Empty where nothing of it is visible.
    ///
    /// Takes any vertices and attributes. Each number is the exact one at a crossing, rounded once to the nearest.
    ///
    /// Cost: three products with the matrix; for each corner that a plane adds a division for each of its numbers, by a step
    /// for each bit. Source: Sutherland and Hodgman 1974, in homogeneous coordinates as Blinn and Newell 1978.
    ///
    /// ```
    /// use embedded_graphics::{prelude::*, primitives::Rectangle};
    /// use zrow::fixed::types::I16F16;
    /// use zrow::{clip::ClipMatrix, scene::{Camera, Pose}};
    ///
    /// let viewport = Rectangle::new(Point::zero(), Size::new(240, 240));
    /// let camera = Camera::new(viewport, I16F16::from_num(10))?;
    /// let matrix = ClipMatrix::new(&camera, &Pose::IDENTITY, I16F16::from_num(1000))?;
    /// // One corner is behind the eye; the near plane cuts its edges, where the brightness is half of 100.
    /// let face = [([-50, 5, 110], [0]), ([50, 5, 110], [0]), ([0, 5, -90], [100])];
    /// let polygon = matrix.sutherland_hodgman(&face);
    /// assert!(polygon.iter().all(|(_, [brightness])| (0..=50).contains(brightness)));
    /// assert_eq!(polygon.iter().filter(|(_, [brightness])| *brightness == 50).count(), 2);
    /// # Ok::<(), zrow::geometry::InputError>(())
    /// ```
    pub fn sutherland_hodgman<const N: usize>(
        &self,
        face: &[([i16; 3], [i32; N]); 3],
    ) -> Vec<(ClipPoint, [i32; N]), 9> {
        let distances: [fn(&ClipPoint) -> i64; 6] = [
            |point| point.w + point.x,
            |point| point.w - point.x,
            |point| point.w + point.y,
            |point| point.w - point.y,
            |point| point.z,
            |point| point.w - point.z,
        ];
        let mut polygon = Corners::<ClipPoint, N>::new();
        for (vertex, attributes) in face {
            let pushed = polygon.push((self.apply(*vertex), *attributes));
            debug_assert!(pushed.is_ok(), "three corners of nine");
        }
        for distance in distances {
            polygon = cut(&polygon, distance, crossing);
        }
        polygon
    }
}

/// The point at a fraction of an edge.
fn crossing(fraction: &Fraction, from: &ClipPoint, to: &ClipPoint) -> ClipPoint {
    ClipPoint {
        x: fraction.between(from.x, to.x),
        y: fraction.between(from.y, to.y),
        z: fraction.between(from.z, to.z),
        w: fraction.between(from.w, to.w),
    }
}

/// The part of a polygon where the distance from a plane is 0 or more, its corners in the same order.
pub(super) fn cut<P: Copy, const N: usize>(
    polygon: &Corners<P, N>,
    distance: impl Fn(&P) -> i64,
    crossing: impl Fn(&Fraction, &P, &P) -> P,
) -> Corners<P, N> {
    let mut kept = Corners::new();
    // A convex polygon crosses a plane twice, and gains one corner at most. Where rounding has bent an edge that lies on the
    // plane by a unit, there may be more crossings within that unit: those for which there is no room are left out.
    let mut keep = |corner| _ = kept.push(corner);
    let Some(mut previous) = polygon.last() else {
        return Corners::new();
    };
    for corner in polygon {
        let (before, here) = (distance(&previous.0), distance(&corner.0));
        if (before < 0) != (here < 0) {
            let fraction = Fraction::of_crossing(before, here);
            let mut attributes = previous.1;
            for (from, to) in attributes.iter_mut().zip(corner.1) {
                // Between two numbers of 32 bits.
                *from = fraction.between((*from).into(), to.into()) as i32;
            }
            keep((crossing(&fraction, &previous.0, &corner.0), attributes));
        }
        if here >= 0 {
            keep(*corner);
        }
        previous = corner;
    }
    kept
}
