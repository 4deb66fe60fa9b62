//! Planes of faces, stored in eight bytes each, to tell which faces are turned away before any vertex is transformed.
//!
//! The normal of a plane is as long as its face is wide: twice the face's area divided by its longest side, which is the least of
//! its three altitudes. On the screen a corner may be rounded by a part of a pixel, so that a narrow face that is turned away may
//! turn up as a sliver that is not; how far it has to be turned away for that to be impossible is inversely proportional to this
//! altitude. With normals of that length one threshold does for all faces of a model.
//!
//! ```text
//!            /\           normal: across the face, outwards, as long as the altitude h
//!          /  | \
//!        /    |h  \       offset: normal * corner, rounded down
//!      /______|_____\
//! ```
//!
//! Guarantees: each coordinate of a stored normal is within 33/64 of the exact altitude vector in the table's unit; the
//! stored offset is not above that of the stored normal, and less than one of its units below it.

use crate::{
    geometry::TooSmall,
    mesh::{
        BoundingBox, FaceSet,
        convex::position,
        face_normal::{dot, normal, square, way},
    },
};

/// The planes of the faces of a mesh, for models whose faces are culled before their vertices are transformed
/// ([`WithPlanes`](crate::shade::WithPlanes)). A table of planes is found by the compiler, and this is a view of it:
///
/// ```
/// use zrow::scene::{FacePlanes, FaceSet};
///
/// const VERTICES: [[i16; 3]; 4] = [[0, 0, 0], [512, 0, 0], [0, 512, 0], [0, 0, 512]];
/// const FACES: [[u16; 3]; 4] = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
/// static TABLE: [[i16; 4]; 4] = FacePlanes::find(&VERTICES, &FACES);
/// static TETRAHEDRON: FaceSet = match FaceSet::new(&VERTICES, &FACES) {
///     Ok(faces) => faces,
///     Err(_) => panic!("a face names a vertex that is not there"),
/// };
/// const PLANES: FacePlanes = match FacePlanes::new(&TETRAHEDRON, &TABLE) {
///     Ok(planes) => planes,
///     Err(_) => panic!("the table is too short"),
/// };
/// assert_eq!(PLANES.table().len(), 4);
/// ```
///
/// Flash: 8 bytes a face. RAM: 24 bytes where it is kept.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FacePlanes<'a> {
    planes: &'a [[i16; 4]],
    bounds: BoundingBox,
    format: PlaneFormat,
}

/// How the numbers of a table of planes are stored.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct PlaneFormat {
    /// Fractional bits of the normals; negative where their unit is greater than that of the vertices.
    pub(crate) normal_bits: i8,
    /// Bits of the offsets, in the unit of the normals, that are not stored.
    pub(crate) offset_shift: u8,
}

/// Bits of the greatest coordinate of the normals of a table, without the sign.
pub(crate) const NORMAL_BITS: u32 = 13;

/// The most fractional bits of a normal, for meshes of slivers.
const MOST_FRACTION_BITS: i8 = 14;

impl<'a> FacePlanes<'a> {
    /// The table of the planes of `FACES` faces of a mesh: of each the normal, as long as the least altitude of the face, and
    /// how far the plane is along it, in units that suit the mesh. A vertex that is not there counts as the origin.
    ///
    /// In a `static` the compiler finds them. Cost: four divisions of 128 bits and two roots a face.
    pub const fn find<const FACES: usize>(vertices: &[[i16; 3]], faces: &[[u16; 3]; FACES]) -> [[i16; 4]; FACES] {
        let mut planes = [[0; 4]; FACES];
        PlaneFormat::of(vertices, faces).fill(vertices, faces, &mut planes);
        planes
    }

    /// The planes of a mesh, found at run time and written into a table: of one whose vertices move
    /// ([`morphed`](FaceSet::morphed)).
    ///
    /// Cost: as that of [`find`](Self::find); more than the planes save in a few frames.
    ///
    /// ```
    /// use zrow::scene::{FacePlanes, FaceSet};
    ///
    /// let mesh = FaceSet::new(&[[0, 0, 0], [0, 100, 0], [400, 0, -7]], &[[0, 1, 2]])?;
    /// let mut table = [[0; 4]; 1];
    /// let planes = FacePlanes::find_in(&mesh, &mut table)?;
    /// assert_eq!(planes.table(), FacePlanes::find(mesh.vertices(), &[[0, 1, 2]]));
    /// # Ok::<(), zrow::geometry::InputError>(())
    /// ```
    ///
    /// # Errors
    /// [`TooSmall::Normals`] with the number of faces, where the table is shorter.
    pub const fn find_in(mesh: &FaceSet<'_>, table: &'a mut [[i16; 4]]) -> Result<Self, TooSmall> {
        let format = PlaneFormat::of(mesh.vertices(), mesh.faces());
        format.fill(mesh.vertices(), mesh.faces(), table);
        Self::with_format(mesh, table, format)
    }

    /// A view of the table that [`find`](Self::find) made of a mesh with these vertices and faces. Planes of another mesh, also
    /// those from before its vertices were [moved](FaceSet::morphed), may leave faces out that are seen.
    ///
    /// Best in a `const`. Cost: as that of `find`.
    ///
    /// # Errors
    /// [`TooSmall::Normals`] with the number of faces, where the table has fewer planes.
    pub const fn new(mesh: &FaceSet<'_>, table: &'a [[i16; 4]]) -> Result<Self, TooSmall> {
        Self::with_format(mesh, table, PlaneFormat::of(mesh.vertices(), mesh.faces()))
    }

    const fn with_format(mesh: &FaceSet<'_>, table: &'a [[i16; 4]], format: PlaneFormat) -> Result<Self, TooSmall> {
        let faces = mesh.faces().len();
        let Some((planes, _)) = table.split_at_checked(faces) else {
            return Err(TooSmall::Normals(faces));
        };
        Ok(Self {
            planes,
            bounds: mesh.bounds(),
            format,
        })
    }

    /// The table: for each face the normal and the offset of its plane.
    pub const fn table(&self) -> &'a [[i16; 4]] {
        self.planes
    }

    /// The box around the vertices of the mesh.
    pub(crate) const fn bounds(&self) -> &BoundingBox {
        &self.bounds
    }

    pub(crate) const fn format(&self) -> PlaneFormat {
        self.format
    }
}

impl PlaneFormat {
    /// The finest format that all planes of a mesh fit.
    const fn of(vertices: &[[i16; 3]], faces: &[[u16; 3]]) -> Self {
        // An altitude is at most 2^16 sqrt(3) times sqrt(3)/2 long: with -4 fractional bits below 2^13.
        let mut normal_bits = MOST_FRACTION_BITS;
        let mut rest = faces;
        while let [face, others @ ..] = rest {
            let corners = corners(vertices, *face);
            while normal_bits > -4 && largest(altitude(corners, normal_bits)) >= 1 << NORMAL_BITS {
                normal_bits -= 1;
            }
            rest = others;
        }
        let mut offset_shift = 0;
        let mut rest = faces;
        while let [face, others @ ..] = rest {
            let corners = corners(vertices, *face);
            let offset = offset(altitude(corners, normal_bits), corners);
            while offset >> offset_shift != ((offset >> offset_shift) as i16) as i64 {
                offset_shift += 1;
            }
            rest = others;
        }
        Self {
            normal_bits,
            offset_shift,
        }
    }

    /// Writes the planes of faces into a table, as far as it reaches.
    const fn fill(self, vertices: &[[i16; 3]], faces: &[[u16; 3]], table: &mut [[i16; 4]]) {
        let (mut free, mut rest) = (table, faces);
        while let ([plane, others @ ..], [face, later @ ..]) = (free, rest) {
            let corners = corners(vertices, *face);
            let [x, y, z] = altitude(corners, self.normal_bits);
            let offset = offset([x, y, z], corners) >> self.offset_shift;
            *plane = [x as i16, y as i16, z as i16, offset as i16];
            (free, rest) = (others, later);
        }
    }
}

/// The normal of a triangle as long as its least altitude, with fractional bits, rounded to the nearest.
const fn altitude(corners: [[i16; 3]; 3], fraction_bits: i8) -> [i64; 3] {
    let [a, b, c] = corners;
    let [one, two, three] = [square(way(a, b)), square(way(b, c)), square(way(c, a))];
    let longest = greater(one, greater(two, three)) as u64;
    if longest == 0 {
        return [0; 3];
    }
    // A square below 2^36, shifted so that its root has 31 bits.
    let shift = (longest.leading_zeros() - 1) / 2;
    let root = (longest << (2 * shift)).isqrt() as i128;
    let [x, y, z] = normal(corners);
    let bits = shift as i32 + fraction_bits as i32;
    [
        quotient(x, bits, root),
        quotient(y, bits, root),
        quotient(z, bits, root),
    ]
}

/// A number times a power of two, divided by another one, to the nearest.
const fn quotient(number: i64, bits: i32, divisor: i128) -> i64 {
    // The shift is at least 13, for a square below 2^36, and there are -4 bits at least.
    let numerator = ((number as i128) << (bits + 1)) + divisor;
    match numerator.checked_div_euclid(2 * divisor) {
        Some(quotient) => quotient as i64,
        None => 0,
    }
}

/// The offset of the plane through a triangle: the product of a normal and the position of a corner.
const fn offset(normal: [i64; 3], [corner, ..]: [[i16; 3]; 3]) -> i64 {
    dot(normal, way([0; 3], corner)) as i64
}

const fn corners(vertices: &[[i16; 3]], [a, b, c]: [u16; 3]) -> [[i16; 3]; 3] {
    [position(vertices, a), position(vertices, b), position(vertices, c)]
}

const fn largest([x, y, z]: [i64; 3]) -> u64 {
    greater(
        x.unsigned_abs() as u128,
        greater(y.unsigned_abs() as u128, z.unsigned_abs() as u128),
    ) as u64
}

const fn greater(one: u128, other: u128) -> u128 {
    if one > other { one } else { other }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Faces of all sizes and shapes, against floating point.
    #[test]
    fn planes_are_within_their_bounds() {
        let mut state = 0x2545_f491u32;
        let mut next = |bits: u32| {
            // xorshift32 (Marsaglia 2003).
            state ^= state << 13;
            state ^= state >> 17;
            state ^= state << 5;
            ((state as i32) >> (32 - bits)) as i16
        };
        let mut worst = 0.0_f64;
        for round in 0..20_000 {
            let bits = round % 16 + 1;
            let vertices = [[0; 3]; 3].map(|vertex| vertex.map(|_: i16| next(bits)));
            let faces = [[0, 1, 2], [2, 1, 0]];
            let table = FacePlanes::find(&vertices, &faces);
            let mesh = FaceSet::new(&vertices, &faces).unwrap();
            let PlaneFormat {
                normal_bits,
                offset_shift,
            } = FacePlanes::new(&mesh, &table).unwrap().format();
            for (plane, [a, b, c]) in table.into_iter().zip(faces) {
                let [a, b, c] = [a, b, c].map(|index| vertices[usize::from(index)]);
                let outwards = normal([a, b, c]).map(|part| part as f64);
                let longest = [way(a, b), way(b, c), way(c, a)].into_iter().map(square).max().unwrap();
                let [x, y, z, stored] = plane;
                let scale = f64::from(normal_bits).exp2() / (longest.max(1) as f64).sqrt();
                for (found, exact) in [x, y, z].into_iter().zip(outwards) {
                    assert!(i32::from(found).abs() < 1 << NORMAL_BITS);
                    worst = worst.max((f64::from(found) - exact * scale).abs());
                }
                let along = dot([x, y, z].map(i64::from), way([0; 3], a)) as i64;
                let stored = i64::from(stored) << offset_shift;
                assert!(stored <= along && along < stored + (1 << offset_shift), "{plane:?}");
            }
        }
        assert!(worst > 0.49 && worst <= 33.0 / 64.0, "{worst}");
    }
}
