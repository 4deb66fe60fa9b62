//! Spheres around meshes, from which it is told whether anything of a mesh can be seen.

use crate::mesh::enclosing_ball::ball_around;

/// A small sphere around some points, such as the vertices of a mesh, in their unit: for round meshes, and for those that turn.
///
/// Made in `const`, it is 10 bytes of flash. RAM: 10 bytes where it is kept. Its radius is a whole number; the least sphere
/// around the same points is often some percent smaller (Ritter 1990).
///
/// ```
/// use zrow::scene::{BoundingSphere, FaceSet};
///
/// const ROD: FaceSet = match FaceSet::new(&[[-30, 0, 40], [30, 0, -40], [7, 24, 0]], &[[0, 1, 2]]) {
///     Ok(faces) => faces,
///     Err(_) => panic!("a face names a vertex that is not there"),
/// };
/// const BOUNDS: BoundingSphere = BoundingSphere::around(ROD.vertices());
/// assert_eq!(BOUNDS, BoundingSphere::around(&[[-50, 0, 0], [50, 0, 0]]));
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BoundingSphere {
    pub(super) centre: [i16; 3],
    /// The radius; `None` for the sphere around nothing.
    pub(super) radius: Option<u16>,
}

impl BoundingSphere {
    /// A sphere around points; of no points, the sphere around nothing.
    ///
    /// Cost: four times the distance of a point for each point, best in a `const`.
    pub const fn around(points: &[[i16; 3]]) -> Self {
        match ball_around(points, [1; 3]) {
            Some((centre, radius)) => Self {
                centre,
                radius: Some(radius),
            },
            None => Self {
                centre: [0; 3],
                radius: None,
            },
        }
    }
}
