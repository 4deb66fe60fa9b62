//! Bounding volumes: boxes, spheres and cylinders around meshes, all of them as a centre and how far they reach along three
//! axes, from which it is told whether they can be seen.
//!
//! ```text
//!     straight along all axes    along one of them     along none
//!     +-------+                  .-----.               .---.
//!     |   c   |                  |  c  |              (  c  )
//!     +-------+                  '-----'               '---'
//!     a box                      a cylinder            a sphere
//! ```

use crate::mesh::{BoundingBox, BoundingCylinder, BoundingSphere, bounding_cylinder::Axis};

/// A [`BoundingBox`], a [`BoundingSphere`] or a [`BoundingCylinder`], made by `into()`: what
/// [`Shading::bounds`](crate::shade::Shading::bounds) gives, and [`Camera::may_see`](crate::scene::Camera::may_see) takes.
///
/// Bounds of different kinds in one table:
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::I16F16;
/// use zrow::scene::{BoundingBox, BoundingSphere, BoundingVolume, Camera, Pose};
///
/// let camera = Camera::new(Rectangle::new(Point::zero(), Size::new(64, 64)), I16F16::from_num(128))?;
/// // A wall ahead, a ball to its left, and a mast behind the camera.
/// let scenery: [BoundingVolume; 3] = [
///     BoundingBox::around(&[[-300, 0, 1000], [300, 200, 1020]]).into(),
///     BoundingSphere::around(&[[-5000, 0, 1000], [-4800, 0, 1000]]).into(),
///     BoundingBox::around(&[[0, 0, -500], [10, 900, -490]]).into(),
/// ];
/// let may_be_seen = scenery.map(|bounds| camera.may_see::<Rgb565>(bounds, &Pose::IDENTITY));
/// assert_eq!(may_be_seen, [true, false, false]);
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BoundingVolume {
    centre: [i16; 3],
    /// Half the sides of a box along x, y and z, the radius of a sphere, or the radius and half the length of a cylinder, in
    /// the unit of the vertices that are inside.
    halves: [u16; 3],
    /// Along which of x, y and z the volume is straight; it is round across the others.
    straight: [bool; 3],
    is_nothing: bool,
}

impl BoundingVolume {
    /// The volume around nothing.
    const NOTHING: Self = Self {
        centre: [0; 3],
        halves: [0; 3],
        straight: [true; 3],
        is_nothing: true,
    };

    /// The centre, and three points half as far from it as the volume reaches along x, y and z, to the side on which the origin
    /// is; `None` of the volume around nothing.
    pub(crate) fn points(&self) -> Option<[[i16; 3]; 4]> {
        if self.is_nothing {
            return None;
        }
        let [x, y, z] = self.centre;
        let [half_x, half_y, half_z] = self.halves;
        Some([
            self.centre,
            [towards_origin(x, half_x), y, z],
            [x, towards_origin(y, half_y), z],
            [x, y, towards_origin(z, half_z)],
        ])
    }

    /// Along which of its axes the volume is straight.
    pub(crate) const fn straight(&self) -> [bool; 3] {
        self.straight
    }
}

/// A coordinate moved towards 0, and maybe beyond, by half of a length, rounded up: half as long, it fits.
fn towards_origin(coordinate: i16, length: u16) -> i16 {
    let (coordinate, half) = (i32::from(coordinate), i32::from(length.div_ceil(2)));
    (if coordinate < 0 {
        coordinate + half
    } else {
        coordinate - half
    }) as i16
}

impl From<BoundingBox> for BoundingVolume {
    fn from(bounds: BoundingBox) -> Self {
        let (centre, Some(greatest)) = (bounds.middle(), bounds.greatest()) else {
            return Self::NOTHING;
        };
        let ([x, y, z], [x2, y2, z2]) = (centre, greatest);
        Self {
            centre,
            halves: [x2.abs_diff(x), y2.abs_diff(y), z2.abs_diff(z)],
            straight: [true; 3],
            is_nothing: false,
        }
    }
}

impl From<BoundingSphere> for BoundingVolume {
    fn from(sphere: BoundingSphere) -> Self {
        let BoundingSphere {
            centre,
            radius: Some(radius),
        } = sphere
        else {
            return Self::NOTHING;
        };
        Self {
            centre,
            halves: [radius; 3],
            straight: [false; 3],
            is_nothing: false,
        }
    }
}

impl From<BoundingCylinder> for BoundingVolume {
    fn from(cylinder: BoundingCylinder) -> Self {
        let BoundingCylinder {
            centre,
            half_length,
            radius,
            axis: Some(axis),
        } = cylinder
        else {
            return Self::NOTHING;
        };
        let straight = [axis == Axis::X, axis == Axis::Y, axis == Axis::Z];
        Self {
            centre,
            halves: straight.map(|is_straight| if is_straight { half_length } else { radius }),
            straight,
            is_nothing: false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Small and large coordinates, and those at both ends of their range.
    const COORDINATES: [i16; 7] = [i16::MIN, -20_001, -1, 0, 2, 17_000, i16::MAX];

    fn corners() -> impl Iterator<Item = [i16; 3]> + Clone {
        let all = COORDINATES.into_iter();
        let pairs = all.flat_map(|x| COORDINATES.map(|y| (x, y)));
        pairs.flat_map(|(x, y)| COORDINATES.map(|z| [x, y, z]))
    }

    /// Checks bounds of some points against their definitions.
    fn check(points: &[[i16; 3]], bounds: impl Into<BoundingVolume>) {
        let bounds = bounds.into();
        let distances = |point: [i16; 3]| {
            let mut centre = bounds.centre.into_iter();
            point.map(|coordinate| i64::from(coordinate.abs_diff(centre.next().unwrap_or_default())))
        };
        for &point in points {
            let mut round = 0;
            let mut radius = 0;
            for ((distance, half), straight) in distances(point).into_iter().zip(bounds.halves).zip(bounds.straight) {
                let half = i64::from(half);
                if straight {
                    assert!(distance <= half, "{point:?} in {bounds:?}");
                } else {
                    round += distance * distance;
                    radius = half;
                }
            }
            assert!(round <= radius * radius, "{point:?} in {bounds:?}");
        }
        let [centre, others @ ..] = bounds.points().unwrap();
        assert_eq!(centre, bounds.centre);
        for (axis, point) in others.into_iter().enumerate() {
            for (other, moved) in distances(point).into_iter().enumerate() {
                let expected = if other == axis {
                    bounds.halves[axis].div_ceil(2)
                } else {
                    0
                };
                assert_eq!(moved, i64::from(expected), "axis {axis} of {bounds:?}");
            }
        }
    }

    /// Two or three points, over the whole range of coordinates.
    #[test]
    fn all_bounds_are_around_their_points() {
        for (index, a) in corners().enumerate() {
            for b in corners().skip(index % 5).step_by(5) {
                for points in [&[a, b][..], &[a, b, [-300, 4_000, 77]]] {
                    check(points, BoundingBox::around(points));
                    check(points, BoundingSphere::around(points));
                    check(points, BoundingCylinder::around(points));
                }
            }
        }
    }
}
