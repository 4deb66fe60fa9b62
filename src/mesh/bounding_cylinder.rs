//! Cylinders around meshes, from which it is told whether anything of a mesh can be seen.

use crate::mesh::{BoundingBox, enclosing_ball::ball_around};

/// A small cylinder around some points, such as the vertices of a mesh, in their unit: for upright meshes that turn about their
/// axis, such as trees, and for wheels and shafts. Its axis is parallel to x, y or z, whichever makes it smallest.
///
/// Made in `const`, it is 12 bytes of flash. RAM: 12 bytes where it is kept.
///
/// ```
/// use zrow::scene::{BoundingCylinder, FaceSet};
///
/// const FIR: FaceSet = match FaceSet::new(
///     &[[-30, 0, 0], [30, 0, 0], [0, 0, 30], [0, 0, -30], [0, 200, 0]],
///     &[[0, 4, 2], [2, 4, 1], [1, 4, 3], [3, 4, 0]],
/// ) {
///     Ok(faces) => faces,
///     Err(_) => panic!("a face names a vertex that is not there"),
/// };
/// const BOUNDS: BoundingCylinder = BoundingCylinder::around(FIR.vertices());
/// // Around y, from 0 to 200, with a radius of 30.
/// assert_eq!(BOUNDS, BoundingCylinder::around(&[[-30, 200, 0], [30, 200, 0], [0, 0, 30], [0, 0, -30]]));
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BoundingCylinder {
    pub(super) centre: [i16; 3],
    /// Half of the cylinder's length along its axis, and its radius across.
    pub(super) half_length: u16,
    pub(super) radius: u16,
    /// `None` for the cylinder around nothing.
    pub(super) axis: Option<Axis>,
}

/// The axis that a cylinder's is parallel to.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) enum Axis {
    X,
    Y,
    Z,
}

impl BoundingCylinder {
    /// A cylinder around points; of no points, the cylinder around nothing.
    ///
    /// Cost: twelve times the distance of a point for each point, best in a `const`.
    pub const fn around(points: &[[i16; 3]]) -> Self {
        let along_x = Self::along(Axis::X, points);
        let along_y = Self::along(Axis::Y, points);
        let along_z = Self::along(Axis::Z, points);
        let smaller = if along_z.volume() < along_x.volume() {
            along_z
        } else {
            along_x
        };
        // Upright where several are as small.
        if smaller.volume() < along_y.volume() {
            smaller
        } else {
            along_y
        }
    }

    /// The cylinder around an axis.
    const fn along(axis: Axis, points: &[[i16; 3]]) -> Self {
        let bounds = BoundingBox::around(points);
        let ([x, y, z], Some([x2, y2, z2])) = (bounds.middle(), bounds.greatest()) else {
            return Self {
                centre: [0; 3],
                half_length: 0,
                radius: 0,
                axis: None,
            };
        };
        let weights = match axis {
            Axis::X => [0, 1, 1],
            Axis::Y => [1, 0, 1],
            Axis::Z => [1, 1, 0],
        };
        let ([ball_x, ball_y, ball_z], radius) = match ball_around(points, weights) {
            Some(ball) => ball,
            None => ([0; 3], 0),
        };
        let (centre, half_length) = match axis {
            Axis::X => ([x, ball_y, ball_z], x2.abs_diff(x)),
            Axis::Y => ([ball_x, y, ball_z], y2.abs_diff(y)),
            Axis::Z => ([ball_x, ball_y, z], z2.abs_diff(z)),
        };
        Self {
            centre,
            half_length,
            radius,
            axis: Some(axis),
        }
    }

    /// How large the cylinder is, but for a constant factor; flat ones by their area.
    const fn volume(&self) -> u64 {
        let radius = self.radius as u64;
        radius * radius * (self.half_length as u64 + 1)
    }
}
