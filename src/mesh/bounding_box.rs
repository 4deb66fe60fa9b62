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

    /// The middle of the box, rounded down, which is nearer to the least coordinates; of the box around nothing, any point.
    pub(super) const fn middle(&self) -> [i16; 3] {
        let ([x1, y1, z1], [x2, y2, z2]) = (self.least, self.greatest);
        [middle(x1, x2), middle(y1, y2), middle(z1, z2)]
    }

    /// The middle of the box, and how far it reaches from there along each axis; `None` of the box around nothing.
    pub(crate) fn middle_and_halves(&self) -> Option<([i16; 3], [u16; 3])> {
        let (middle, [x2, y2, z2]) = (self.middle(), self.greatest()?);
        let [x, y, z] = middle;
        Some((middle, [x2.abs_diff(x), y2.abs_diff(y), z2.abs_diff(z)]))
    }

    /// The corner with the greatest coordinates; `None` of the box around nothing.
    pub(super) const fn greatest(&self) -> Option<[i16; 3]> {
        let ([x1, ..], [x2, ..]) = (self.least, self.greatest);
        if x1 > x2 { None } else { Some(self.greatest) }
    }
}

const fn middle(one: i16, other: i16) -> i16 {
    ((one as i32 + other as i32) >> 1) as i16
}

const fn lesser(one: i16, other: i16) -> i16 {
    if one < other { one } else { other }
}

const fn greater(one: i16, other: i16) -> i16 {
    if one > other { one } else { other }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_are_those_of_the_points() {
        let bounds = BoundingBox::around(&[[3, -4, 9], [-2, 8, 9], [0, 0, i16::MIN]]);
        assert_eq!((bounds.least, bounds.greatest), ([-2, -4, i16::MIN], [3, 8, 9]));
        assert_eq!(bounds.middle(), [0, 2, -16_380]);
        assert_eq!(BoundingBox::around(&[]).greatest(), None);
        assert_eq!(BoundingBox::around(&[[7; 3]]).greatest(), Some([7; 3]));
    }
}
