//! A triangle in homogeneous coordinates, without clipping and without a division (Olano and Greer 1997, "Triangle Scan
//! Conversion Using 2D Homogeneous Coordinates", SIGGRAPH/Eurographics Workshop on Graphics Hardware).
//!
//! The edge between two corners and the eye span a plane. The cross product of the corners' (x, y, w) is at right angles to it:
//! for the direction (X, Y, 1) of a pixel its product says on which side the ray passes, whether the corners are in front of
//! the eye, behind it, or beside it. Where all three say what the determinant of the corners says, the ray meets the triangle
//! in front of the eye.
//!
//! ```text
//!            c               | xa ya wa |
//!          / | \             | xb yb wb |   e_ab = a x b,  e_bc = b x c,  e_ca = c x a
//!        a - * - b           | xc yc wc |
//!         \  |  /
//!            eye             e_bc za + e_ca zb + e_ab zc >= 0 on this side of the near plane
//! ```
//!
//! Near and far plane are two more such functions: they are the depths of the corners, weighted by the edges opposite.
//!
//! Guarantees: no number wraps, whatever the coordinates. Each corner is rounded once to 19 bits, to fewer where the viewport
//! has more than 2^21 pixels, so that an edge moves by some 2^-18 of the viewport: on 320 x 240 pixels 1/800 of one. So the
//! pixels are those of a triangle that is clipped first, but where an edge passes that near to a pixel's centre, or as near as
//! that way snaps corners, half a unit. It is more where the eye lies nearly on an edge, between its corners. Near and far
//! plane cut within 2^-18 of how far the corners are from them. Two triangles with a common edge have no common pixel along it,
//! and leave none out, whatever is rounded: both compute the same function, but for its sign.
//!
//! Take it where faces are large, or around the eye, and clipping is to be saved: it has no cases. It asks pixels from the left
//! side of the window on, as long as it does not know where a row begins.

use crate::{
    clip::ClipPoint,
    geometry::Window,
    scan::{polygon::Polygons, triangle::siblings::edge_function::row_span},
    surface::Span,
    view::Camera,
};

impl Polygons {
    /// Hands over the visible spans of a triangle in clip coordinates, top to bottom, without clipping it: what of it lies
    /// between near and far plane and in the camera's viewport, in a window. Right for corners beside the eye and behind it.
    ///
    /// Takes any numbers as coordinates. A pixel on an edge belongs to the triangle to the right of it, or below. A triangle
    /// that is seen from its edge has no pixels.
    ///
    /// Cost: some 60 products to set up; five additions a pixel of the window, up to the right end of each row's span. Source:
    /// Olano and Greer 1997.
    ///
    /// ```
    /// use core::convert::Infallible;
    /// use embedded_graphics::{prelude::*, primitives::Rectangle};
    /// use zrow::fixed::types::I16F16;
    /// use zrow::{clip::ClipMatrix, scan::Polygons, scene::{Camera, Pose}};
    ///
    /// let viewport = Rectangle::new(Point::zero(), Size::new(8, 8));
    /// let camera = Camera::new(viewport, I16F16::from_num(10))?;
    /// let matrix = ClipMatrix::new(&camera, &Pose::IDENTITY, I16F16::from_num(1000))?;
    /// // A floor around the eye: all below the horizon.
    /// let floor = [[-3000, -9, -3000], [3000, -9, -3000], [0, -9, 3000]].map(|vertex| matrix.apply(vertex));
    /// let mut rows = 0;
    /// let Ok(()) = Polygons::homogeneous_triangle(floor, &camera, &camera.viewport(), |span| {
    ///     assert!(span.y >= 4);
    ///     rows += 1;
    ///     Ok::<(), Infallible>(())
    /// });
    /// assert_eq!(rows, 4);
    /// # Ok::<(), zrow::geometry::InputError>(())
    /// ```
    ///
    /// # Errors
    /// The first error that `emit` returns.
    pub fn homogeneous_triangle<E>(
        corners: [ClipPoint; 3],
        camera: &Camera,
        window: &Window,
        mut emit: impl FnMut(Span) -> Result<(), E>,
    ) -> Result<(), E> {
        let viewport = camera.viewport();
        let window = window.intersection(&viewport);
        let Some(functions) = set_up(corners, &viewport) else {
            return Ok(());
        };
        if window.is_empty() {
            return Ok(());
        }
        for y in window.top..window.bottom {
            if let Some(span) = row(y, &window, &functions, &viewport) {
                emit(span)?;
            }
        }
        Ok(())
    }
}

/// The span of a row. One copy for all types of `emit`.
#[inline(never)]
fn row(y: i32, window: &Window, functions: &[PixelFunction; 5], viewport: &Window) -> Option<Span> {
    let (column, row) = (window.left - viewport.left, y - viewport.top);
    let mut values = functions.map(|function| function.at(column, row));
    row_span(y, window.left..window.right, |_| {
        let is_inside = values.iter().all(|&value| value >= 0);
        for (value, function) in values.iter_mut().zip(functions) {
            *value += function.x_step;
        }
        is_inside
    })
}

/// A function that is linear on the screen, from the first pixel of the viewport on: 0 or more inside.
#[derive(Copy, Clone)]
struct PixelFunction {
    first: i64,
    x_step: i64,
    y_step: i64,
}

impl PixelFunction {
    /// `x` times the position in the viewport from -1 to 1, plus `y` times that upwards, plus `one`; times the viewport's
    /// pixels, so that all numbers are whole. Below 2^62 for all pixels and those around.
    fn new([x, y, one]: [i64; 3], viewport: &Window) -> Self {
        let (width, height) = (i64::from(viewport.width()), i64::from(viewport.height()));
        // Centres of pixels, in half pixels from the middle: from 1 - size to size - 1.
        Self {
            first: x * height * (1 - width) - y * width * (1 - height) + one * width * height,
            x_step: 2 * x * height,
            y_step: -2 * y * width,
        }
    }

    fn at(&self, column: i32, row: i32) -> i64 {
        self.first + self.x_step * i64::from(column) + self.y_step * i64::from(row)
    }
}

/// The functions of three edges, of the near and of the far plane; `None` where the triangle is seen from its edge.
fn set_up(corners: [ClipPoint; 3], viewport: &Window) -> Option<[PixelFunction; 5]> {
    // Below 2^28 pixels.
    let pixels = u64::from(viewport.width()) * u64::from(viewport.height());
    let bits = ((59 - (64 - pixels.leading_zeros())) / 2).min(19);
    let shifts = corners.map(|corner| excess([corner.x, corner.y, corner.z, corner.w], bits));
    let [a, b, c] = [0, 1, 2].map(|index| rounded(&corners, &shifts, index));
    let edges = [cross(&b, &c), cross(&c, &a), cross(&a, &b)];
    let [of_a, _, _] = edges;
    // Three products below 2^58.
    let determinant = dot(of_a, a);
    if determinant == 0 {
        return None;
    }
    let edges = edges.map(|edge| edge.map(|element| element * determinant.signum()));
    let plane = |distances: [i64; 3]| {
        let [from_a, from_b, from_c] = depths(distances, shifts, bits);
        let [bc, ca, ab] = edges;
        let mut function = [0; 3];
        for (((element, a), b), c) in function.iter_mut().zip(bc).zip(ca).zip(ab) {
            // Three products below 2^58.
            *element = a * from_a + b * from_b + c * from_c;
        }
        let most = 2 * bits + 1;
        let excess = excess(function, most) as i32;
        PixelFunction::new(function.map(|element| shifted(element, excess)), viewport)
    };
    let near = plane(corners.map(|corner| corner.z));
    // Of points by hand it may not fit.
    let far = plane(corners.map(|corner| corner.w.saturating_sub(corner.z)));
    let [bc, ca, ab] = edges.map(|edge| {
        let function = PixelFunction::new(edge, viewport);
        // An edge owns the pixels on it where the triangle is to the right of it, or below a level one.
        let is_owner = function.x_step > 0 || function.x_step == 0 && function.y_step >= 0;
        PixelFunction {
            first: function.first - i64::from(!is_owner),
            ..function
        }
    });
    Some([bc, ca, ab, near, far])
}

/// By how many bits the largest of some numbers exceeds so many.
fn excess<const N: usize>(numbers: [i64; N], bits: u32) -> u32 {
    length(numbers).saturating_sub(bits)
}

/// How many bits the largest of some numbers has.
fn length<const N: usize>(numbers: [i64; N]) -> u32 {
    let all = numbers.iter().fold(0, |all, number| all | number.unsigned_abs());
    64 - all.leading_zeros()
}

/// A corner divided by a power of two of its own, which makes it no other one: rounded to the nearest.
fn rounded(corners: &[ClipPoint; 3], shifts: &[u32; 3], index: usize) -> [i64; 3] {
    let (corner, shift) = (corners.get(index), shifts.get(index).copied().unwrap_or_default());
    corner.map_or([0; 3], |corner| {
        [corner.x, corner.y, corner.w].map(|number| shifted(number, shift as i32))
    })
}

/// Distances of the corners from a plane, divided as the corners are, and all times the largest power of two for which they
/// have at most so many bits: they are much smaller than the corners near the far plane.
fn depths(distances: [i64; 3], shifts: [u32; 3], bits: u32) -> [i64; 3] {
    let needed = distances
        .iter()
        .zip(shifts)
        .map(|(&distance, shift)| length([distance]) as i32 - shift as i32);
    let raise = bits as i32 - needed.max().unwrap_or(0);
    let [a, b, c] = shifts.map(|shift| shift as i32 - raise);
    let [from_a, from_b, from_c] = distances;
    [shifted(from_a, a), shifted(from_b, b), shifted(from_c, c)]
}

/// A number divided by a power of two, rounded to the nearest; for a negative exponent multiplied, where that fits.
const fn shifted(number: i64, exponent: i32) -> i64 {
    if exponent > 64 {
        0
    } else if exponent > 0 {
        ((number >> (exponent - 1)) + 1) >> 1
    } else if number == 0 {
        0
    } else {
        number << -exponent
    }
}

/// The cross product of two corners in x, y and w: at most 2^39 for coordinates of 19 bits.
fn cross([x, y, w]: &[i64; 3], [other_x, other_y, other_w]: &[i64; 3]) -> [i64; 3] {
    [
        y * other_w - w * other_y,
        w * other_x - x * other_w,
        x * other_y - y * other_x,
    ]
}

fn dot([a, b, c]: [i64; 3], [x, y, z]: [i64; 3]) -> i64 {
    a * x + b * y + c * z
}
