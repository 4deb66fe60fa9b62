//! Eye space as the grid has it: what the screen stores is projected back, so that rays begin at the eye.
//!
//! ```text
//!              x/d                    A corner at x, y on the screen, from the middle of the viewport, with stored depth d
//!               |        . B          lies at (x/d, y/d, 1/d): d falls as 1 over the distance. The ray through a pixel at
//!               |   . '               x, y is the line of points (x t, y t, t), and t is the distance on it. Planes stay
//!     eye ------+--------------- 1/d  planes and straight lines stay straight, because depths are even on the screen.
//!               |  ' . A
//! ```
//!
//! Up to the unit of each axis, and where the camera looks beside the middle up to a shear, that is the space in which the camera
//! is at the origin: neither the focal length nor the near plane has to be known. Distances are scaled so that the farthest
//! corner is 2^30 away. Rounding is kept as an interval: the true distance of a depth lies between the two ends.
//!
//! Where rays are parallel, depths are even in space: x and y are those of the screen, and the distance is what a depth is less
//! than the nearest one, exactly.
//!
//! Guarantees: the box of a face contains each point at which a ray through the centre of a pixel that the face covers meets the
//! plane through its corners. Cost: a 64-bit division for each corner.

use core::num::NonZeroU64;

use crate::{
    geometry::Window,
    view::{DepthWidth, ScreenPrecision, ScreenVertex},
};

/// Bits of the distance of the farthest corner.
const DISTANCE_BITS: u32 = 30;

/// How the corners of some faces lie in eye space.
#[derive(Debug, Copy, Clone)]
pub(super) struct EyeSpace {
    is_parallel: bool,
    /// The stored depth, in units, that distances are measured with: the least one of all corners, or where rays are parallel
    /// the greatest.
    reference: i32,
    /// The middle of the viewport on the screen, in units of the precision.
    middle: [i32; 2],
    /// How far a pixel of the viewport is from the middle at most, in units of the precision.
    reach: [i32; 2],
}

/// A box in eye space: x, y and the distance.
#[derive(Debug, Copy, Clone)]
pub(super) struct EyeBox {
    pub(super) least: [i64; 3],
    pub(super) greatest: [i64; 3],
}

/// A ray: where it begins, at distance 0, and how far it goes along each axis for one unit of distance.
#[derive(Debug, Copy, Clone)]
pub(super) struct Ray {
    pub(super) start: [i32; 3],
    pub(super) slope: [i32; 3],
}

impl EyeSpace {
    /// The space for a viewport, given the least and the greatest stored depth of all corners, in units.
    pub(super) fn new<S: ScreenPrecision>(viewport: &Window, [least, greatest]: [i32; 2], is_parallel: bool) -> Self {
        let middle = |start: i32, end: i32| ((start + end) >> 1) << S::FRACTION_BITS;
        // Below 2^13 pixels times 2^8.
        let reach = |start: i32, end: i32| ((end - start + 2) >> 1) << S::FRACTION_BITS;
        Self {
            is_parallel,
            reference: if is_parallel { greatest } else { least },
            middle: [
                middle(viewport.left, viewport.right),
                middle(viewport.top, viewport.bottom),
            ],
            reach: [
                reach(viewport.left, viewport.right),
                reach(viewport.top, viewport.bottom),
            ],
        }
    }

    /// Between which distances a stored depth in units lies.
    fn distances(&self, depth: i32) -> [i64; 2] {
        if self.is_parallel {
            return [i64::from(self.reference - depth); 2];
        }
        let divisor = NonZeroU64::new(depth.max(1) as u64).unwrap_or(NonZeroU64::MIN);
        // Depths have 24 bits.
        let quotient = (((self.reference.max(1) as u64) << DISTANCE_BITS) / divisor) as i64;
        [quotient, quotient + 1]
    }

    /// A distance behind which no point is that has a depth of at least so many units.
    pub(super) fn farthest_distance(&self, depth: i32) -> i32 {
        if !self.is_parallel && depth <= 0 {
            return i32::MAX;
        }
        let [_, greatest] = self.distances(depth);
        greatest.min(i32::MAX.into()) as i32
    }

    /// The box around the corners of a face.
    pub(super) fn box_of<S: ScreenPrecision, D: DepthWidth>(&self, corners: [&ScreenVertex<S, D>; 3]) -> EyeBox {
        let [a, b, c] = corners.map(|corner| self.box_of_corner(corner));
        a.around(b).around(c)
    }

    /// The box in which a corner is.
    fn box_of_corner<S: ScreenPrecision, D: DepthWidth>(&self, corner: &ScreenVertex<S, D>) -> EyeBox {
        let [near, far] = self.distances(corner.z.units());
        let [middle_x, middle_y] = self.middle;
        let (x, y) = (
            i64::from(corner.x_units() - middle_x),
            i64::from(corner.y_units() - middle_y),
        );
        if self.is_parallel {
            return EyeBox {
                least: [x, y, near],
                greatest: [x, y, far],
            };
        }
        // Below 2^22 units from the middle, times 2^30.
        EyeBox {
            least: [(x * near).min(x * far), (y * near).min(y * far), near],
            greatest: [(x * near).max(x * far), (y * near).max(y * far), far],
        }
    }

    /// By how much boxes are to be larger on each side so that rays may turn into the next cell too early, by so many units of
    /// distance.
    pub(super) fn padding(&self, early: i32) -> [i64; 3] {
        let [reach_x, reach_y] = self.reach;
        if self.is_parallel {
            [0; 3]
        } else {
            [
                i64::from(reach_x) * i64::from(early),
                i64::from(reach_y) * i64::from(early),
                0,
            ]
        }
    }

    /// The sides of a box by which lengths along its axes are compared, as if the field of view was a quarter of a turn; where
    /// rays are parallel nothing is known of the unit of distances, and all sides count as equal.
    pub(super) fn sides(&self, face_box: &EyeBox) -> [u64; 3] {
        let EyeBox { least, greatest } = face_box;
        let [reach_x, reach_y] = self.reach;
        if self.is_parallel {
            return [1 << DISTANCE_BITS; 3];
        }
        let reach = NonZeroU64::new(reach_x.max(reach_y) as u64).unwrap_or(NonZeroU64::MIN);
        let side = |axis: [i64; 2]| axis[1].abs_diff(axis[0]);
        [
            side([least[0], greatest[0]]) / reach,
            side([least[1], greatest[1]]) / reach,
            side([least[2], greatest[2]]),
        ]
    }

    /// The ray through the centre of a pixel.
    pub(super) fn ray<S: ScreenPrecision>(&self, [column, row]: [i32; 2]) -> Ray {
        let [middle_x, middle_y] = self.middle;
        let x = (column << S::FRACTION_BITS) - middle_x;
        let y = (row << S::FRACTION_BITS) - middle_y;
        if self.is_parallel {
            Ray {
                start: [x, y, 0],
                slope: [0, 0, 1],
            }
        } else {
            Ray {
                start: [0; 3],
                slope: [x, y, 1],
            }
        }
    }
}

impl EyeBox {
    /// The box around two boxes.
    pub(super) fn around(self, other: Self) -> Self {
        let ([a, b, c], [d, e, f]) = (self.least, other.least);
        let ([g, h, i], [j, k, l]) = (self.greatest, other.greatest);
        Self {
            least: [a.min(d), b.min(e), c.min(f)],
            greatest: [g.max(j), h.max(k), i.max(l)],
        }
    }

    /// The box with so much more on each side.
    pub(super) fn padded(self, [x, y, z]: [i64; 3]) -> Self {
        let ([a, b, c], [d, e, f]) = (self.least, self.greatest);
        Self {
            least: [a - x, b - y, c - z],
            greatest: [d + x, e + y, f + z],
        }
    }
}
