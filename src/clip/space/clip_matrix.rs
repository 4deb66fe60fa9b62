//! The textbook's viewing pipeline from a model to the screen: one 4x4 matrix, homogeneous coordinates, a division at the end.
//!
//! The matrix is the product P V M of projection, view and model (Roberts 1965, "Homogeneous Matrix Representation and
//! Manipulation of N-Dimensional Constructs"; Foley, van Dam, Feiner and Hughes 1990, chapter 6). It takes a vertex (x, y,
//! z, 1) to clip coordinates (x, y, z, w), in which the visible part of space is -w <= x <= w, -w <= y <= w, 0 <= z <= w:
//!
//! ```text
//!          2f/W   0    2u/W    0          w is the distance from the eye along the viewing direction,
//!     P =    0   2f/H -2v/H    0          f the focal length, W and H the viewport in pixels, (u, v) the way from its
//!            0    0     k   -k near       middle right and down to the camera's centre, k = far / (far - near)
//!            0    0     1      0
//! ```
//!
//! Scenes do not take this path: they rotate vertices by three rows instead of four, and divide by the distance itself. This
//! matrix is there to compare with, and the clippers in homogeneous space take it.
//!
//! Guarantees: no number wraps, for any camera and any pose. Clip coordinates are the exact products of the vertices and the
//! matrix as it is stored: nothing is rounded after the matrix, until a point is cut or put on the screen.

use core::num::NonZeroU64;

use fixed::types::{I2F30, I16F16};

use crate::{
    clip::space::{
        clip_plane::ClipPlane,
        clip_point::ClipPoint,
        scale::{FRACTION_BITS, scale_nearest, scaled},
    },
    geometry::InputError,
    view::{Camera, Pose},
};

/// The 4x4 matrix that takes the vertices of a model to clip coordinates, where the visible part of space is -w <= x <= w,
/// -w <= y <= w and 0 <= z <= w.
///
/// Numbers: 64-bit integers with a common number of fractional bits: 40, or as many fewer as it takes to halve the largest of
/// 2f/W, 2f/H, 2u/W and 2v/H until it is below 2. There f is the focal length, W and H are the size of the viewport, and (u, v) is
/// the way from its middle to the camera's centre; homogeneous coordinates mean the same at any scale. Elements are within six
/// units of those of the exact product, and stay below 2^42; those of the translation are within 2^17 units, and stay below 2^59.
///
/// RAM: 128 bytes.
///
/// ```
/// use embedded_graphics::{prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::I16F16;
/// use zrow::{clip::ClipMatrix, geometry::{Sub4, SubPoint}, scene::{Camera, Pose}};
///
/// let viewport = Rectangle::new(Point::zero(), Size::new(241, 321));
/// let camera = Camera::new(viewport, I16F16::from_num(8))?;
/// let matrix = ClipMatrix::new(&camera, &Pose::IDENTITY, I16F16::from_num(1000))?;
/// let point = matrix.apply([0, 0, 500]);
/// assert!(point.is_inside());
/// // Straight ahead is the centre of the viewport.
/// assert_eq!(point.on_screen::<Sub4>(&camera), SubPoint::from_pixel(Point::new(120, 160)).ok());
/// // What is behind the eye has no position.
/// assert_eq!(matrix.apply([0, 0, -500]).on_screen::<Sub4>(&camera), None);
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ClipMatrix {
    rows: [[i64; 4]; 4],
}

impl ClipMatrix {
    /// The matrix of a camera and of a model in a pose: P V M. `far` is the distance from the eye to the far plane, in units;
    /// what is further away lies outside of the volume.
    ///
    /// With [`Pose::IDENTITY`] for the camera's pose and the model's it is the projection alone, and vertices are points of eye
    /// space.
    ///
    /// Cost: four divisions of 64 bits, one by a step for each of 41 bits, and some 110 multiplications. Source: Roberts 1965.
    ///
    /// # Errors
    /// [`InputError::FarTooClose`] where `far` is less than twice the distance of the near plane.
    pub fn new(camera: &Camera, model: &Pose, far: I16F16) -> Result<Self, InputError> {
        let scales = Scales::new(camera, far)?;
        let [x, y, z] = view_of_model(camera.pose(), model);
        let depth = z.map(|element| scaled(element, scales.depth));
        let near = scaled(i64::from(camera.near().to_bits()) << (FRACTION_BITS - 16), scales.depth);
        let [a, b, c, d] = depth;
        Ok(Self {
            rows: [
                oblique([x, z], [scales.x, scales.centre_x]),
                oblique([y, z], [scales.y, scales.centre_y]),
                [a, b, c, d - near],
                z.map(|element| scaled(element, scales.one)),
            ],
        })
    }

    /// The clip coordinates of a vertex: exactly the product with the matrix.
    ///
    /// Cost: 12 multiplications of 64 bits.
    pub fn apply(&self, vertex: [i16; 3]) -> ClipPoint {
        let [x, y, z, w] = self.rows.map(|row| ClipPlane(row).distance(vertex));
        ClipPoint { x, y, z, w }
    }

    /// The rows: those that make x, y, z and w of clip coordinates.
    pub(super) const fn rows(&self) -> [[i64; 4]; 4] {
        self.rows
    }

    /// The six planes of the visible part of space, in the coordinates of the vertices: left, right, bottom, top, near, far.
    /// Each is the sum or the difference of two rows, so that the distance of a vertex from it is exactly what its clip
    /// coordinates say.
    ///
    /// Source: Gribb and Hartmann 2001.
    pub fn planes(&self) -> [ClipPlane; 6] {
        let [x, y, z, w] = &self.rows;
        let sum = |sign: i64, row: &[i64; 4]| {
            let mut sum = *w;
            for (sum, element) in sum.iter_mut().zip(row) {
                // Two elements below 2^59.
                *sum += sign * element;
            }
            ClipPlane(sum)
        };
        [sum(1, x), sum(-1, x), sum(1, y), sum(-1, y), ClipPlane(*z), sum(-1, z)]
    }
}

/// The elements of the projection, with the fractional bits of the matrix: below 2^42.
struct Scales {
    /// 2f/W: what x in eye space adds to x in clip coordinates.
    x: i64,
    /// 2f/H: what y in eye space adds to y in clip coordinates.
    y: i64,
    /// What z in eye space adds to x in clip coordinates where a camera's centre is beside the middle of its viewport.
    centre_x: i64,
    /// What z in eye space adds to y in clip coordinates where a camera's centre is above or below the middle of its viewport.
    centre_y: i64,
    /// far / (far - near), from 1 to 2.
    depth: i64,
    /// The number 1.
    one: i64,
}

impl Scales {
    /// The elements for a camera and the distance of the far plane.
    fn new(camera: &Camera, far: I16F16) -> Result<Self, InputError> {
        let (near, far) = (i64::from(camera.near().to_bits()), i64::from(far.to_bits()));
        if far < 2 * near {
            return Err(InputError::FarTooClose);
        }
        let viewport = camera.viewport();
        // 2f/W from 16 to 40 fractional bits: a focal length is below 2^11 pixels, so the numerator is below 2^52.
        let focal_length = (camera.focal_length().to_bits() as u64) << (FRACTION_BITS - 16 + 1);
        let ratio = |size: u32| quotient(focal_length, u64::from(size));
        let (x, y) = (ratio(viewport.width()), ratio(viewport.height()));
        // 2 / W of the way from the middle of the viewport to the centre, which is below 2^14 pixels: below 2^55.
        let [right, down] = camera
            .offset()
            .map(|offset| i64::from(offset.to_bits()) << (FRACTION_BITS - 16 + 1));
        let part = |offset: i64, size: u32| quotient(offset.unsigned_abs(), u64::from(size));
        let (centre_x, centre_y) = (part(right, viewport.width()), part(down, viewport.height()));
        // 1 + near / (far - near), from 1 to 2.
        let depth = (1 << FRACTION_BITS) + scale_nearest(1 << FRACTION_BITS, near as u64, (far - near) as u64).0;
        let bits = 64 - (x | y | centre_x | centre_y).leading_zeros();
        let shift = bits.saturating_sub(FRACTION_BITS + 1);
        let half = (1 << shift) >> 1;
        let shifted = |element: u64| ((element + half) >> shift) as i64;
        Ok(Self {
            x: shifted(x),
            y: shifted(y),
            centre_x: shifted(centre_x) * right.signum(),
            centre_y: shifted(centre_y) * -down.signum(),
            depth: shifted(depth),
            one: shifted(1 << FRACTION_BITS),
        })
    }
}

/// A row of P V M: a row of V M times its scale, plus the row of z times what z adds. Scales have the fractional bits of the
/// matrix.
fn oblique([row, z]: [[i64; 4]; 2], [scale, centre]: [i64; 2]) -> [i64; 4] {
    let mut oblique = row.map(|element| scaled(element, scale));
    for (element, z) in oblique.iter_mut().zip(z) {
        *element += scaled(z, centre);
    }
    oblique
}

/// The quotient of two numbers, the divisor positive, rounded to the nearest.
fn quotient(numerator: u64, denominator: u64) -> u64 {
    // The camera checked it: a viewport has pixels.
    let denominator = NonZeroU64::new(denominator).unwrap_or(NonZeroU64::MIN);
    (numerator + denominator.get() / 2) / denominator
}

/// The first three rows of V M, with 40 fractional bits: elements of a rotation, and a translation below 2^17 units.
fn view_of_model(camera: &Pose, model: &Pose) -> [[i64; 4]; 3] {
    let [a, b, c] = model.rotation.inverse().matrix().map(|row| row.map(bits));
    let ([x1, y1, z1], [x0, y0, z0]) = (model.translation, camera.translation);
    let way = |to: I16F16, from: I16F16| i64::from(to.to_bits()) - i64::from(from.to_bits());
    let offset = [way(x1, x0), way(y1, y0), way(z1, z0)];
    camera.rotation.inverse().matrix().map(|row| {
        let row = row.map(bits);
        // 60 fractional bits to 40: the rows are of length 1.
        let element = |column: [i64; 3]| (dot(row, column) + (1 << 19)) >> 20;
        // 46 fractional bits to 40; a vector of at most 2^16 * sqrt(3) units has a product below 2^63.
        [element(a), element(b), element(c), (dot(row, offset) + (1 << 5)) >> 6]
    })
}

fn bits(element: I2F30) -> i64 {
    i64::from(element.to_bits())
}

fn dot([a, b, c]: [i64; 3], [x, y, z]: [i64; 3]) -> i64 {
    a * x + b * y + c * z
}
