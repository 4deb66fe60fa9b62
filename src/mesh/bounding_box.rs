//! Boxes around meshes, from which it is told whether anything of a mesh can be seen.

/// The smallest box with sides along x, y and z around some points, such as the vertices of a mesh, in their unit.
///
/// Made in `const`, it is 12 bytes of flash. RAM: 12 bytes where it is kept.
///
/// ```
/// use zrow::scene::{BoundingBox, FaceSet};
///
/// const TETRAHEDRON: FaceSet = match FaceSet::new(
///     &[[0, 0, 0], [512, 0, 0], [0, 512, -7], [0, 0, 512]],
///     &[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]],
/// ) {
///     Ok(faces) => faces,
///     Err(_) => panic!("a face names a vertex that is not there"),
/// };
/// const BOUNDS: BoundingBox = TETRAHEDRON.bounds();
/// assert_eq!(BOUNDS, BoundingBox::around(&[[0, 512, 512], [512, 0, -7]]));
/// assert_eq!(BOUNDS.joined(&BoundingBox::around(&[])), BOUNDS);
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BoundingBox {
    /// The least x, y and z; greater than the greatest ones where the box is around nothing.
    least: [i16; 3],
    greatest: [i16; 3],
}

impl BoundingBox {
    /// The box around points; of no points, the box around nothing.
    pub const fn around(points: &[[i16; 3]]) -> Self {
        let mut bounds = Self {
            least: [i16::MAX; 3],
            greatest: [i16::MIN; 3],
        };
        let mut rest = points;
        while let [point, others @ ..] = rest {
            bounds = bounds.joined(&Self {
                least: *point,
                greatest: *point,
            });
            rest = others;
        }
        bounds
    }

    /// The box around two boxes, such as those of two meshes that stand in the same place.
    #[must_use]
    pub const fn joined(&self, other: &Self) -> Self {
        let ([x1, y1, z1], [x2, y2, z2]) = (self.least, other.least);
        let least = [lesser(x1, x2), lesser(y1, y2), lesser(z1, z2)];
        let ([x1, y1, z1], [x2, y2, z2]) = (self.greatest, other.greatest);
        Self {
            least,
            greatest: [greater(x1, x2), greater(y1, y2), greater(z1, z2)],
        }
    }

    /// The corner with the least coordinates, and the one with the greatest.
    pub(crate) const fn ends(&self) -> [[i16; 3]; 2] {
        [self.least, self.greatest]
    }

    /// The eight corners; none of the box around nothing.
    pub(crate) fn corners(&self) -> impl Iterator<Item = [i16; 3]> {
        let ([x1, y1, z1], [x2, y2, z2]) = (self.least, self.greatest);
        let corner = move |number: u8| {
            let side = |bit: u8, least, greatest| if number & bit == 0 { least } else { greatest };
            [side(1, x1, x2), side(2, y1, y2), side(4, z1, z2)]
        };
        let count = if x1 > x2 { 0 } else { 8 };
        (0..count).map(corner)
    }
}

const fn lesser(one: i16, other: i16) -> i16 {
    if one < other { one } else { other }
}

const fn greater(one: i16, other: i16) -> i16 {
    if one > other { one } else { other }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::vec::Vec;

    use super::*;

    #[test]
    fn corners_are_those_of_the_points() {
        let bounds = BoundingBox::around(&[[3, -4, 9], [-2, 8, 9], [0, 0, i16::MIN]]);
        let mut corners: Vec<_> = bounds.corners().collect();
        corners.sort_unstable();
        let expected = [-2, 3].map(|x| [-4, 8].map(|y| [i16::MIN, 9].map(|z| [x, y, z])));
        assert_eq!(corners, expected.as_flattened().as_flattened());
        assert_eq!(BoundingBox::around(&[]).corners().count(), 0);
        assert_eq!(
            BoundingBox::around(&[[7; 3]]).corners().collect::<Vec<_>>(),
            [[7; 3]; 8]
        );
    }
}
