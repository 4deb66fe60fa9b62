//! Levels of detail: coarser meshes out of the vertices of the finest one, each with about half of the faces of the one before.
//!
//! Vertices are put in the order in which levels need them, so that a level takes the first ones of the one table, with their
//! normals and texture coordinates, and adds its faces and their colours alone.
//!
//! An application picks a level by the distance: an error of `e` units at a distance of `d` is `e f / d` pixels, for a focal
//! length of `f` pixels ([`pick_from`](crate::level::pick_from)). The head of a written module shows it with the module's own
//! numbers.
//!
//! ```
//! use zrow::scene::FaceSet;
//! use zrow_mesh::level::pick_from;
//!
//! // As a module has them, which was written with `--levels 2`.
//! static VERTICES: [[i16; 3]; 4] = [[0, 0, -90], [80, 0, 40], [-80, 0, 40], [0, 90, 0]];
//! static FACES: [[u16; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
//! let levels: [FaceSet; 3] = [0; 3].map(|_| FaceSet::new(&VERTICES, &FACES).unwrap());
//! // Errors of levels 1 and 2 of 1.25 and 6.5 units, a focal length of 160 pixels, half a pixel.
//! assert_eq!([1.25, 6.5].map(|error| pick_from(error, 160)), [400, 2_080]);
//! let mesh = |distance: i32| match distance {
//!     ..400 => &levels[0],
//!     400..2_080 => &levels[1],
//!     _ => &levels[2],
//! };
//! assert!(std::ptr::eq(mesh(1_000), &levels[1]));
//! ```

use std::cmp::Reverse;

use crate::{
    level::Level,
    mesh::Mesh,
    module_parts::grouped,
    simplify::{Simplifier, distance},
    vector::{Vector, difference, dot, length},
};

/// Levels at most.
pub const MOST_LEVELS: u8 = 8;
/// Vertices of the finest mesh whose distance from a level is measured, at most.
const MEASURED: usize = 1_000;

/// Adds coarser levels to a mesh, and puts its vertices in their order. Where a mesh cannot become much coarser, there are
/// fewer.
pub fn add(mesh: &mut Mesh, levels: u8) {
    let mut simplifier = Simplifier::new(&mesh.vertices, &mesh.faces, &mesh.colors);
    let mut before = mesh.faces.len();
    let mut found = Vec::new();
    for number in 1..=levels {
        simplifier.reduce(before / 2);
        let (indices, faces): (Vec<usize>, Vec<[u16; 3]>) = simplifier.faces().unzip();
        // Less than a tenth is no level of its own.
        if faces.len() * 10 > before * 9 || faces.is_empty() {
            mesh.notes.push(format!(
                "level {number} and coarser ones are left out: no more than {} of {} faces can go without a hole, a torn seam \
                 or a face turned over",
                grouped(before - faces.len()),
                grouped(before)
            ));
            break;
        }
        before = faces.len();
        found.push((indices, faces));
    }
    order_vertices(mesh, &mut found);
    for (indices, faces) in found {
        let (greatest_error, mean_error) = errors(mesh, &faces);
        let vertices = faces
            .iter()
            .flatten()
            .max()
            .map_or(0, |&vertex| usize::from(vertex) + 1);
        let colors = indices.iter().map(|&face| mesh.colors[face]).collect();
        mesh.levels.push(Level {
            vertices,
            faces,
            colors,
            greatest_error,
            mean_error,
        });
    }
}

/// Puts vertices first that coarser levels have, which are some of those of finer ones.
fn order_vertices(mesh: &mut Mesh, levels: &mut [(Vec<usize>, Vec<[u16; 3]>)]) {
    let mut coarsest = vec![0; mesh.vertices.len()];
    for (number, (_, faces)) in (1..).zip(levels.iter()) {
        for &vertex in faces.iter().flatten() {
            coarsest[usize::from(vertex)] = number;
        }
    }
    let mut order: Vec<usize> = (0..mesh.vertices.len()).collect();
    order.sort_by_key(|&vertex| Reverse(coarsest[vertex]));
    let mut place = vec![0; order.len()];
    for (index, &vertex) in order.iter().enumerate() {
        // There are at most 65,536.
        place[vertex] = index as u16;
    }
    let moved = |faces: &mut Vec<[u16; 3]>| {
        for vertex in faces.as_flattened_mut() {
            *vertex = place[usize::from(*vertex)];
        }
    };
    moved(&mut mesh.faces);
    levels.iter_mut().for_each(|(_, faces)| moved(faces));
    mesh.vertices = order.iter().map(|&vertex| mesh.vertices[vertex]).collect();
    if !mesh.normals.is_empty() {
        mesh.normals = order.iter().map(|&vertex| mesh.normals[vertex]).collect();
    }
    if !mesh.coordinates.is_empty() {
        mesh.coordinates = order.iter().map(|&vertex| mesh.coordinates[vertex]).collect();
    }
}

/// The greatest and the mean distance of the finest mesh's vertices from faces: of as many as are measured, evenly chosen.
fn errors(mesh: &Mesh, faces: &[[u16; 3]]) -> (f64, f64) {
    let position = |vertex: u16| mesh.vertices[usize::from(vertex)].map(f64::from);
    // Each with its reach from the first corner, so that those too far away are passed over.
    let triangle = |face: &[u16; 3]| {
        let [a, b, c] = face.map(position);
        let reach = length(difference(b, a)).max(length(difference(c, a)));
        ([a, b, c], reach)
    };
    let triangles: Vec<_> = faces.iter().map(triangle).collect();
    let step = mesh.vertices.len().div_ceil(MEASURED).max(1);
    let distances = mesh.vertices.iter().step_by(step).map(|vertex| {
        let vertex = vertex.map(f64::from);
        let nearer = |least: f64, &(triangle, reach): &([Vector; 3], f64)| {
            let away = difference(vertex, triangle[0]);
            let limit = least + reach;
            if dot(away, away) < limit * limit {
                least.min(distance(vertex, triangle))
            } else {
                least
            }
        };
        triangles.iter().fold(f64::INFINITY, nearer)
    });
    let distances: Vec<f64> = distances.collect();
    let greatest = distances.iter().copied().fold(0.0, f64::max);
    (greatest, distances.iter().sum::<f64>() / distances.len().max(1) as f64)
}
