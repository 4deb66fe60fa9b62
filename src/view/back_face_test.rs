//! Back-face culling in object space: whether a face is turned away, by its plane and the position of the eye among the vertices
//! of its model, before any of them is transformed.
//!
//! A face is seen from behind where the eye is behind its plane. Whether it is drawn is decided by its corners on the screen,
//! though, which are rounded; so it is taken for turned away here only where rounding cannot have turned it round. Its corners
//! come from an exact projection by moving each by less than `e` units along x and y; two of its sides, `u` and `v`, then change by
//! less than `2e` along each. Twice its area on the screen, the cross product of both, changes by less than
//!
//! ```text
//!     2 sqrt(2) e (|u| + |v|) + 8 e^2
//! ```
//!
//! With the focal length `f`, corners at distances up to `Z`, the eye `q` beyond the plane times the face's least altitude `h`
//! (`q h` is the product with a normal of that length), and the secant `k` of the angle to the corner farthest off the axis, twice
//! the area is at least `f^2 q h L / Z^3` for the longest side `L`, of which no side on the screen is longer than `f k L / Z`, all
//! with the distances of the same corners. The sign is certain where
//!
//! ```text
//!     q h > 7 e k Z^2 / f
//! ```
//!
//! because of `h < 0.87 L` and `q < k Z`. Where rays are parallel it is `q h > 7 e / s`, for a scale `s` and the cosine `q` of the
//! angle between the normal and the rays.
//!
//! Guarantees: a face that is taken for turned away has no area on the screen, or one that is negative; all its corners are on
//! the screen and between the near and the far plane. Also counted are the rounding of stored normals, which is below 33/64 of
//! their unit, and of the eye: the matrix that transforms vertices is taken to be exact as it is rounded, so that only how far
//! the rounded eye is from the origin of eye space matters.
//!
//! Source: back faces by their planes as in Roberts (1963), "Machine perception of three-dimensional solids", with the eye in
//! object space as in Blinn (1993), "Backface culling snags", IEEE Computer Graphics and Applications 13(6).

use core::num::Wrapping;

use crate::view::{DepthWidth, EyeTransform, Projection, ScreenPrecision, ToEye};

/// What the planes of a model's faces are compared with in a frame.
#[derive(Debug, Copy, Clone)]
pub(crate) struct BackFaceTest {
    /// The eye among the vertices; where rays are parallel, the way to the viewer. At most 2^15 in size.
    eye: [i32; 3],
    /// What an offset is multiplied by, so that it has the unit of the product of a normal and the eye.
    per_offset: i32,
    /// What the eye's distance from the plane of a face that is turned away is less than.
    limit: i32,
}

/// What is known of a mesh and its planes: the box around its vertices, by its middle and half its sides, and how the planes are
/// stored.
#[derive(Debug, Copy, Clone)]
pub(crate) struct PlanesOfMesh {
    pub(crate) middle: [i16; 3],
    pub(crate) halves: [u16; 3],
    /// Fractional bits of normals.
    pub(crate) normal_bits: i8,
    /// Bits of offsets that are not stored.
    pub(crate) offset_shift: u8,
}

impl BackFaceTest {
    /// Whether a face is turned away for certain: its normal and its offset. Cost: four multiplications.
    #[inline(always)]
    pub(crate) fn is_turned_away(&self, [x, y, z, offset]: [i16; 4]) -> bool {
        let [x, y, z, offset] = [x, y, z, offset].map(|number| Wrapping(i32::from(number)));
        let [eye_x, eye_y, eye_z] = self.eye.map(Wrapping);
        // Three products of 13 and 15 bits, and an offset that stands for three more: the planes of a mesh do not wrap. Those of
        // another one may leave any faces out.
        let distance = x * eye_x + y * eye_y + z * eye_z - offset * Wrapping(self.per_offset);
        distance.0 < self.limit
    }

    /// The test with a limit of 64 bits, which is positive; `None` where nothing may be below it.
    fn new(eye: [i64; 3], per_offset: i32, limit: i64) -> Option<Self> {
        // No distance is 2^31 or more.
        let limit = i32::try_from(limit).ok()?;
        Some(Self {
            eye: eye.map(|coordinate| coordinate as i32),
            per_offset,
            limit: -limit,
        })
    }
}

/// Where the box around a model is in eye space, in 1/4096 unit.
struct EyeBox {
    /// The most that x and y are in size.
    aside: i64,
    nearest: i64,
    farthest: i64,
}

impl EyeBox {
    fn new<S: ScreenPrecision>(transform: &EyeTransform<S>, planes: &PlanesOfMesh) -> Self {
        let middle = transform.apply(planes.middle);
        let reach = |row: [i64; 3]| {
            let products = row.into_iter().zip(planes.halves);
            // Three products of 46 bits; two points of eye space are rounded.
            (products.map(|(part, half)| part.abs() * i64::from(half)).sum::<i64>() >> 18) + 3
        };
        let [x, y, z] = transform.rows_bits().map(reach);
        let (middle_x, middle_y, middle_z) = (i64::from(middle.x), i64::from(middle.y), i64::from(middle.z));
        Self {
            aside: (middle_x.abs() + x).max(middle_y.abs() + y),
            nearest: middle_z - z,
            farthest: middle_z + z,
        }
    }
}

/// Units of the screen that are left beside the guard band: more than projection rounds by.
const MARGIN: i64 = 8;

impl<S: ScreenPrecision, D: DepthWidth> Projection<S, D> {
    /// The test for the faces of a model in perspective; `None` where some of it may be off the screen, or where nothing is
    /// certain.
    // Once a model and frame.
    #[inline(never)]
    pub(crate) fn back_face_test(&self, transform: &EyeTransform<S>, planes: &PlanesOfMesh) -> Option<BackFaceTest> {
        let bounds = EyeBox::new(transform, planes);
        let is_behind = self.far != 0 && bounds.farthest > i64::from(self.far);
        if bounds.nearest < i64::from(self.near) || is_behind {
            return None;
        }
        // The tangent of the angle to the axis along x and y each, with 16 fractional bits. The secant of the whole angle is
        // below 1 and that, up to 2.
        let tangent = (bounds.aside << 16) / bounds.nearest.max(1) + 1;
        let focal_length = i64::from(self.scale);
        if tangent > 2 << 16 || ((focal_length * tangent) >> 16) + MARGIN > self.distance_to_guard_band() {
            return None;
        }
        let eye = EyeInModel::new(transform, planes)?;
        // 7 e k Z^2 / f: 2 e has 8 fractional bits, k Z^2 as well.
        let distance = (bounds.farthest >> 8) + 1;
        let secant = (tangent >> 8) + 257;
        let product = (distance * distance * secant) >> 8;
        let needed = 7 * self.rounding(tangent, bounds.nearest) * (product + 1) / (2 * focal_length).max(1) + 1;
        // The matrix is orthonormal to within 1/128.
        let sure = needed + (needed >> 6) + eye.uncertainty(planes);
        if sure >= 1 << 44 {
            return None;
        }
        let sure = shifted(sure, i32::from(planes.normal_bits) - 4) + eye.rounding_of_normals(planes);
        BackFaceTest::new(eye.rounded, eye.per_offset(planes)?, (sure >> eye.shift) + 2)
    }

    /// The test for the faces of a model where rays are parallel, as [`back_face_test`](Self::back_face_test) is in perspective.
    #[inline(never)]
    pub(crate) fn parallel_back_face_test(
        &self,
        transform: &EyeTransform<S>,
        planes: &PlanesOfMesh,
    ) -> Option<BackFaceTest> {
        let bounds = EyeBox::new(transform, planes);
        if bounds.nearest < i64::from(self.near) || bounds.farthest > i64::from(self.far) {
            return None;
        }
        let scale = i64::from(self.scale);
        if ((bounds.aside * scale) >> (36 - S::FRACTION_BITS)) + MARGIN > self.distance_to_guard_band() {
            return None;
        }
        // To the viewer: the cross product of the axes that are right and up on the screen, with 28 fractional bits.
        let [[a, b, c], [d, e, f], _] = narrow(transform.rows_bits());
        let towards = [c * e - b * f, a * f - c * d, b * d - a * e].map(|part| part >> 13);
        // A rounding by one unit between two corners, and by 1/4096 unit of the vertices, with 8 fractional bits.
        let scale = scale << S::FRACTION_BITS;
        let rounding = 256 + (scale >> 28) + 2;
        let needed = ((7 * rounding) << 31) / scale.max(1) + 1;
        // The way to the viewer, of 2^15 units, is within 6 of them, and a normal below 2^14; it is within 33/64.
        let sure = shifted(needed + (needed >> 6), i32::from(planes.normal_bits) - 1) + (1 << 18);
        BackFaceTest::new(towards, 0, sure)
    }

    /// The fewest units from the picture's centre to a side of the guard band.
    fn distance_to_guard_band(&self) -> i64 {
        let distance = |center: i32| (S::MAX_UNITS - center).min(center - S::MIN_UNITS);
        i64::from(distance(self.center_x).min(distance(self.center_y)))
    }

    /// By how much the way between two corners may be rounded along x or y, in units of the screen with 8 fractional bits.
    fn rounding(&self, tangent: i64, nearest: i64) -> i64 {
        // A unit for rounding to units, a ratio's last bit, its relative error for each corner, and a unit of eye space.
        let (focal_length, one) = (i64::from(self.scale), 1 << 16);
        let ratio_bits = self.exact_ratio_bits();
        256 + ((focal_length * (one + 2 * tangent)) >> (8 + ratio_bits))
            + ((focal_length * (one + tangent)) >> 8) / nearest.max(1)
            + 2
    }
}

/// The eye among the vertices of a model, in 1/4096 unit.
struct EyeInModel {
    /// Bits fewer, so that coordinates of the eye and of all vertices are at most 2^15 in size.
    shift: u32,
    rounded: [i64; 3],
    /// How far the rounded eye is from the origin of eye space, the sum along the axes.
    residual: i64,
}

impl EyeInModel {
    fn new<S: ScreenPrecision>(transform: &EyeTransform<S>, planes: &PlanesOfMesh) -> Option<Self> {
        let (rows, offset) = (transform.rows_bits(), transform.offset_bits());
        // The inverse of a rotation is its transpose: products of 15 and 30 bits.
        let mut eye = [0; 3];
        for (row, offset) in narrow(rows).into_iter().zip(offset) {
            for (sum, element) in eye.iter_mut().zip(row) {
                *sum -= element * offset;
            }
        }
        let eye = eye.map(|sum| sum >> 14);
        let farthest_vertex = planes.middle.into_iter().zip(planes.halves);
        let farthest = farthest_vertex.map(|(middle, half)| (i64::from(middle).abs() + i64::from(half)) << 12);
        let size = eye.into_iter().map(i64::abs).chain(farthest).max()?;
        let shift = (64 - size.leading_zeros()).saturating_sub(15);
        let rounded = eye.map(|coordinate| (coordinate + ((1 << shift) >> 1)) >> shift);
        let exact = rounded.map(|coordinate| coordinate << shift);
        let mut residual = 0;
        for (row, offset) in rows.into_iter().zip(offset) {
            // A row is a unit vector, and the eye below 2^31 along each axis: the sum is below 2^62.
            let product = row
                .into_iter()
                .zip(exact)
                .map(|(element, part)| element * part)
                .sum::<i64>();
            // Both are rounded down.
            residual += ((product >> 30) + offset).abs() + 2;
        }
        Some(Self {
            shift,
            rounded,
            residual,
        })
    }

    /// What an offset is multiplied by; `None` where its unit is finer than that of the product of a normal and the eye.
    fn per_offset(&self, planes: &PlanesOfMesh) -> Option<i32> {
        let shift = (u32::from(planes.offset_shift) + 12).checked_sub(self.shift)?;
        (shift < 31).then(|| 1 << shift)
    }

    /// How much a normal as long as a face's altitude is high times how far the eye is off is at most, with 16 fractional bits.
    fn uncertainty(&self, planes: &PlanesOfMesh) -> i64 {
        (2 * sum(planes.halves) * self.residual) << 4
    }

    /// How much the product of a normal and the way from a vertex to the eye is off because the normal is rounded, in 1/4096
    /// unit of both.
    fn rounding_of_normals(&self, planes: &PlanesOfMesh) -> i64 {
        let ways = self.rounded.into_iter().zip(planes.middle);
        let to_middle = ways.map(|(eye, middle)| ((eye << self.shift) - (i64::from(middle) << 12)).abs());
        ((to_middle.sum::<i64>() + (sum(planes.halves) << 12)) * 33) >> 6
    }
}

/// The sum of the lengths of half the sides of a box.
fn sum(halves: [u16; 3]) -> i64 {
    halves.into_iter().map(i64::from).sum()
}

/// Rows with 30 fractional bits rounded to 14.
fn narrow(rows: [[i64; 3]; 3]) -> [[i64; 3]; 3] {
    rows.map(|row| row.map(|element| (element + (1 << 15)) >> 16))
}

/// A number times a power of two, rounded up.
fn shifted(number: i64, bits: i32) -> i64 {
    if bits < 0 {
        (number >> bits.unsigned_abs()) + 1
    } else {
        number << bits
    }
}
