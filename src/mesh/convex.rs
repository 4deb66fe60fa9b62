//! Whether a mesh is convex: each vertex is on or behind the plane of each face.

use crate::mesh::{
    element::element,
    face_normal::{dot, normal, way},
};

/// Whether no vertex is in front of the plane of a face.
pub(super) const fn is_convex(vertices: &[[i16; 3]], faces: &[[u16; 3]]) -> bool {
    let mut rest = faces;
    while let [[a, b, c], others @ ..] = rest {
        let corners = [position(vertices, *a), position(vertices, *b), position(vertices, *c)];
        if !is_behind(vertices, corners) {
            return false;
        }
        rest = others;
    }
    true
}

/// Whether no vertex is in front of the plane through three corners.
const fn is_behind(vertices: &[[i16; 3]], corners: [[i16; 3]; 3]) -> bool {
    let ([corner, _, _], outwards) = (corners, normal(corners));
    let mut rest = vertices;
    while let [vertex, others @ ..] = rest {
        if dot(outwards, way(corner, *vertex)) > 0 {
            return false;
        }
        rest = others;
    }
    true
}

/// The position of a vertex; the origin where it is not there.
pub(super) const fn position(vertices: &[[i16; 3]], index: u16) -> [i16; 3] {
    match element(vertices, index as usize) {
        Some(position) => position,
        None => [0; 3],
    }
}
