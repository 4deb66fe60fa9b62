//! The tessellation of the parts, in constant evaluation: an index that is out of bounds does not compile.

use embedded_graphics::pixelcolor::Rgb565;

use super::{
    face_shade::{face_normal, shade},
    grid::Grid,
    octahedral::encode,
    parts::{PARTS, Pole},
    patch_walk::{PatchWalk, RowWalk},
    patches::UNITS,
};

/// Units of the mesh to one of Newell's.
const SCALE: i64 = 160;
/// The middle of the pot's box, in units of the control points, with x to the right, y up and z away.
const MIDDLE: [i64; 3] = [856, 6300, 0];

/// Everything that is known of a mesh's vertices and faces.
pub(super) struct Mesh<const V: usize, const F: usize> {
    pub(super) positions: [[i16; 3]; V],
    pub(super) normals: [[i8; 2]; V],
    pub(super) coordinates: [[i16; 2]; V],
    pub(super) faces: [[u16; 3]; F],
    pub(super) face_normals: [[i8; 2]; F],
    pub(super) colors: [Rgb565; F],
}

/// Vertices of the mesh with so many by so many cells a patch.
pub(super) const fn vertex_count(cells: usize) -> usize {
    let (mut count, mut index) = (0, 0);
    while index < PARTS.len() {
        count = Grid::new(&PARTS[index], cells, count).end();
        index += 1;
    }
    count
}

/// Faces of the mesh with so many by so many cells a patch.
pub(super) const fn face_count(cells: usize) -> usize {
    let (mut count, mut index) = (0, 0);
    while index < PARTS.len() {
        count += Grid::new(&PARTS[index], cells, 0).face_count();
        index += 1;
    }
    count
}

/// Cuts each patch into so many by so many cells.
pub(super) const fn tessellate<const V: usize, const F: usize>(cells: usize) -> Mesh<V, F> {
    let mut mesh = Mesh {
        positions: [[0; 3]; V],
        normals: [[0; 2]; V],
        coordinates: [[0; 2]; V],
        faces: [[0; 3]; F],
        face_normals: [[0; 2]; F],
        colors: [Rgb565::new(0, 0, 0); F],
    };
    let (mut vertices, mut faces, mut index) = (0, 0, 0);
    while index < PARTS.len() {
        let grid = Grid::new(&PARTS[index], cells, vertices);
        mesh.add_vertices(&grid);
        faces = mesh.add_faces(&grid, faces);
        vertices = grid.end();
        index += 1;
    }
    assert!(vertices == V && faces == F);
    mesh
}

impl<const V: usize, const F: usize> Mesh<V, F> {
    /// Walks over each patch. Where two patches meet, they set the same vertex to the same values.
    const fn add_vertices(&mut self, grid: &Grid) {
        let mut patch = 0;
        while patch < grid.part.patches.len() {
            let mut walk = PatchWalk::new(&grid.part.patches[patch], grid.cells as i64);
            let mut row = 0;
            while row <= grid.cells {
                self.add_row(grid, patch, row, walk.row());
                walk.advance();
                row += 1;
            }
            patch += 1;
        }
    }

    const fn add_row(&mut self, grid: &Grid, patch: usize, row: usize, mut walk: RowWalk) {
        let (patch_row, patch_column) = (patch / grid.part.columns, patch % grid.part.columns);
        let row = patch_row * grid.cells + row;
        let mut step = 0;
        while step <= grid.cells {
            let column = patch_column * grid.cells + step;
            let vertex = grid.vertex(patch_column, row, column);
            self.positions[vertex] = rounded(walk.point(), grid.cells as i64);
            self.normals[vertex] = encode(if grid.is_pole(row) {
                upright(&grid.part.pole)
            } else {
                walk.normal()
            });
            self.coordinates[vertex] = grid.coordinates(patch_column, row, column);
            walk.advance();
            step += 1;
        }
    }

    /// Two faces a cell, and one where a side of the cell is a point; returns the number of faces so far.
    const fn add_faces(&mut self, grid: &Grid, mut count: usize) -> usize {
        let mut cell = 0;
        while cell < grid.rows() * grid.columns() {
            let (row, column) = (cell / grid.columns(), cell % grid.columns());
            let patch_column = column / grid.cells;
            let left = [
                grid.vertex(patch_column, row, column),
                grid.vertex(patch_column, row + 1, column),
            ];
            let right = [
                grid.vertex(patch_column, row, column + 1),
                grid.vertex(patch_column, row + 1, column + 1),
            ];
            if !grid.is_pole(row + 1) {
                count = self.add_face([left[0], left[1], right[1]], grid, count);
            }
            if !grid.is_pole(row) {
                count = self.add_face([left[0], right[1], right[0]], grid, count);
            }
            cell += 1;
        }
        count
    }

    const fn add_face(&mut self, [a, b, c]: [usize; 3], grid: &Grid, count: usize) -> usize {
        self.faces[count] = [a as u16, b as u16, c as u16];
        let corners = [self.positions[a], self.positions[b], self.positions[c]];
        self.face_normals[count] = encode(face_normal(corners));
        self.colors[count] = shade(corners, grid.part.color);
        count + 1
    }
}

/// A point of the surface in units of the mesh, from the middle of the pot; halves go away from 0, so that the two sides of
/// the pot mirror each other.
const fn rounded([x, y, z]: [i64; 3], cells: i64) -> [i16; 3] {
    let scale = cells.pow(6);
    let unit = scale * UNITS / SCALE;
    [
        quotient(x - MIDDLE[0] * scale, unit),
        quotient(y - MIDDLE[1] * scale, unit),
        quotient(z - MIDDLE[2] * scale, unit),
    ]
}

const fn quotient(dividend: i64, divisor: i64) -> i16 {
    let magnitude = (2 * dividend.abs() + divisor) / (2 * divisor);
    (magnitude * dividend.signum()) as i16
}

/// The normal at a pole, where no direction is around the pot.
const fn upright(pole: &Pole) -> [i64; 3] {
    match pole {
        Pole::Last => [0, -1, 0],
        Pole::First | Pole::None => [0, 1, 0],
    }
}
