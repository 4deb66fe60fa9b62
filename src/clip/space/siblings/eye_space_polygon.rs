//! Sutherland and Hodgman's polygon clipping (1974) in eye space: against the six planes of what a camera sees, one after the
//! other, in the space of the vertices; what is left is brought to clip coordinates at last.
//!
//! Guarantees: the polygon of [`ClipMatrix::sutherland_hodgman`], but for rounding: the corners that planes add are rounded to
//! 1/65,536 of the vertices' unit here, and to a unit of the matrix there. Where a corner lies so near to a plane that this
//! decides, one of both may have a corner more, beside another one.
//!
//! Take it where the distances of the vertices are wanted in space, as for a collision; in homogeneous coordinates the planes
//! take no products at all.

use heapless::Vec;

use crate::clip::space::{
    clip_matrix::ClipMatrix,
    clip_plane::ClipPlane,
    clip_point::ClipPoint,
    fraction::Fraction,
    scale::{FRACTION_BITS, scaled},
    sutherland_hodgman::{Corners, cut},
};

/// Fractional bits of positions in eye space.
const POSITION_BITS: u32 = 16;

impl ClipMatrix {
    /// What a camera sees of a face, cut by planes in the space of the vertices, which is eye space where the matrix is the
    /// projection alone: the corners of a convex polygon in clip coordinates, and `N` numbers that vary evenly over it. Empty
    /// where nothing of it is visible.
    ///
    /// The polygon is that of [`sutherland_hodgman`](Self::sutherland_hodgman) but for the rounding of corners to 1/65,536
    /// unit.
    ///
    /// Takes any vertices and attributes. Cost: nine products of 64 bits for each corner and plane, and 36 for each corner of
    /// the result. Source: Sutherland and Hodgman 1974; planes as Gribb and Hartmann 2001.
    pub fn sutherland_hodgman_in_eye_space<const N: usize>(
        &self,
        face: &[([i16; 3], [i32; N]); 3],
    ) -> Vec<(ClipPoint, [i32; N]), 9> {
        let mut polygon = Corners::<[i64; 3], N>::new();
        for (vertex, attributes) in face {
            let position = vertex.map(|axis| i64::from(axis) << POSITION_BITS);
            let pushed = polygon.push((position, *attributes));
            debug_assert!(pushed.is_ok(), "three corners of nine");
        }
        for plane in self.planes() {
            polygon = cut(&polygon, |position| distance(&plane, *position), crossing);
        }
        let mut visible = Vec::new();
        for (position, attributes) in &polygon {
            let [x, y, z, w] = self.rows().map(|row| distance(&ClipPlane(row), *position));
            let pushed = visible.push((ClipPoint { x, y, z, w }, *attributes));
            debug_assert!(pushed.is_ok(), "nine corners of nine");
        }
        visible
    }
}

/// How far inside a position is, rounded down to the unit of the matrix: below 2^61.
fn distance(plane: &ClipPlane, position: [i64; 3]) -> i64 {
    let ([a, b, c, offset], [x, y, z]) = (plane.0, position);
    // With 40 fractional bits, as `scaled` takes them: below 2^55.
    let product = |element, axis| scaled(axis << (FRACTION_BITS - POSITION_BITS), element);
    product(a, x) + product(b, y) + product(c, z) + offset
}

/// The position at a fraction of an edge.
fn crossing(fraction: &Fraction, [x0, y0, z0]: &[i64; 3], [x1, y1, z1]: &[i64; 3]) -> [i64; 3] {
    [
        fraction.between(*x0, *x1),
        fraction.between(*y0, *y1),
        fraction.between(*z0, *z1),
    ]
}
