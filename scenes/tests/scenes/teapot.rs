//! The teapots are Newell's patches: against de Casteljau's algorithm in whole numbers, and its derivatives.

use std::{
    collections::{HashMap, HashSet},
    f64::consts::PI,
};

use embedded_graphics::{pixelcolor::Rgb565, prelude::RgbColor};
use zrow::scene::FaceSet;
use zrow_scenes::teapot::{
    SMALL_TEAPOT, SMALL_TEAPOT_COLORS, SMALL_TEAPOT_COORDINATES, SMALL_TEAPOT_FACE_NORMALS, SMALL_TEAPOT_NORMALS,
    TEAPOT, TEAPOT_COLORS, TEAPOT_COORDINATES, TEAPOT_FACE_NORMALS, TEAPOT_NORMALS,
    parts::{PARTS, Part},
    patches::{CONTROL_POINTS, Patch, UNITS},
};

type Position = [i16; 3];

/// Units of the mesh to one of Newell's.
const SCALE: i128 = 160;
/// The middle of the box in units of the control points, x to the right, y up and z away.
const MIDDLE: [i128; 3] = [856, 6300, 0];

struct Teapot {
    cells: usize,
    mesh: &'static FaceSet<'static>,
    normals: &'static [[i8; 2]],
    face_normals: &'static [[i8; 2]],
    coordinates: &'static [[i16; 2]],
    colors: &'static [Rgb565],
}

fn teapots() -> [Teapot; 2] {
    [
        Teapot {
            cells: 4,
            mesh: &TEAPOT,
            normals: &TEAPOT_NORMALS,
            face_normals: &TEAPOT_FACE_NORMALS,
            coordinates: &TEAPOT_COORDINATES,
            colors: &TEAPOT_COLORS,
        },
        Teapot {
            cells: 2,
            mesh: &SMALL_TEAPOT,
            normals: &SMALL_TEAPOT_NORMALS,
            face_normals: &SMALL_TEAPOT_FACE_NORMALS,
            coordinates: &SMALL_TEAPOT_COORDINATES,
            colors: &SMALL_TEAPOT_COLORS,
        },
    ]
}

#[test]
fn counts() {
    let counts = teapots().map(|teapot| (teapot.mesh.vertices().len(), teapot.mesh.faces().len()));
    assert_eq!(counts, [(560, 992), (156, 240)]);
    for teapot in teapots() {
        let (vertices, faces) = (teapot.mesh.vertices().len(), teapot.mesh.faces().len());
        assert_eq!(
            [teapot.normals.len(), teapot.coordinates.len(), teapot.colors.len()],
            [vertices, vertices, faces]
        );
        let used: HashSet<u16> = teapot.mesh.faces().iter().flatten().copied().collect();
        assert_eq!(used.len(), vertices, "each vertex is a corner of a face");
    }
}

/// The vertices that a mesh without seams has: how many positions a part has, summed over the parts.
#[test]
fn positions_without_seams() {
    let positions = |part: &Part, cells| {
        let patches = part.patches.iter();
        let all: HashSet<Position> = patches.flat_map(|patch| Corners::new(patch, cells).all()).collect();
        all.len()
    };
    for (cells, sum) in [(4, 530), (2, 138)] {
        assert_eq!(PARTS.iter().map(|part| positions(part, cells)).sum::<usize>(), sum);
    }
}

/// The faces are the cells of the patches, cut in two, without those whose corners are at two points; all positions are
/// the nearest.
#[test]
fn faces_are_the_cells_of_the_patches() {
    for teapot in teapots() {
        let mut found: Vec<_> = (0..teapot.mesh.faces().len())
            .map(|face| teapot.corners(face).0)
            .map(turned)
            .collect();
        let mut expected = Vec::new();
        for patch in PARTS.iter().flat_map(|part| part.patches) {
            let corners = Corners::new(patch, teapot.cells);
            expected.extend(corners.faces().map(|face| turned(face.map(|at| corners.position(at)))));
        }
        found.sort_unstable();
        expected.sort_unstable();
        assert!(found == expected);
    }
}

#[test]
fn no_face_is_degenerate() {
    for teapot in teapots() {
        for face in 0..teapot.mesh.faces().len() {
            assert_ne!(area_vector(teapot.corners(face).0), [0; 3], "{face}");
        }
    }
}

/// Two faces at the most share an edge, and they pass it in opposite directions.
#[test]
fn neighbours_look_the_same_way() {
    for teapot in teapots() {
        let mut passes: HashSet<[Position; 2]> = HashSet::new();
        for face in 0..teapot.mesh.faces().len() {
            let [a, b, c] = teapot.corners(face).0;
            for edge in [[a, b], [b, c], [c, a]] {
                assert!(passes.insert(edge), "{edge:?} twice");
            }
        }
        // The borders: rim, lid, both ends of handle and spout, with 4, 4, 2 and 2 patches around.
        let borders = passes.iter().filter(|[a, b]| !passes.contains(&[*b, *a])).count();
        assert_eq!(borders, (4 + 4 + 2 * 2 + 2 * 2) * teapot.cells);
    }
}

/// The signed volume of the cones from the middle of the pot to its faces is about that of its body.
#[test]
fn faces_look_outwards() {
    for teapot in teapots() {
        let six_volumes: i64 = (0..teapot.mesh.faces().len())
            .map(|face| teapot.corners(face).0)
            .map(|corners| dot(area_vector(corners), corners[0].map(i64::from)))
            .sum();
        // The radius of a sphere of that volume, in Newell's units.
        let radius = (six_volumes as f64 / 8.0 / PI).cbrt() / SCALE as f64;
        assert!((1.5..2.0).contains(&radius), "{radius}");
    }
}

#[test]
fn box_and_middle() {
    for teapot in teapots() {
        let extent = |axis: usize| {
            let along = || teapot.mesh.vertices().iter().map(|vertex| vertex[axis]);
            (along().min().unwrap(), along().max().unwrap())
        };
        assert_eq!([0, 1, 2].map(extent), [(-514, 514), (-252, 252), (-320, 320)]);
    }
}

/// The far side is the near side, mirrored.
#[test]
fn sides_mirror_each_other() {
    for teapot in teapots() {
        let positions: HashSet<&Position> = teapot.mesh.vertices().iter().collect();
        assert!(positions.iter().all(|[x, y, z]| positions.contains(&[*x, *y, -z])));
    }
}

/// 8 bits turn a normal by two thirds of a degree at the most, and nothing else does.
#[test]
fn normals_are_those_of_the_surface() {
    let mut worst = 0.0f64;
    for teapot in teapots() {
        teapot.for_each_corner(|vertex, normal, _| {
            let stored = direction(teapot.normals[vertex]);
            if let Some(normal) = normal {
                worst = worst.max(angle(stored, normal));
            } else {
                let pole = f64::from(teapot.mesh.vertices()[vertex][1]).signum();
                assert_eq!(stored, [0.0, pole, 0.0]);
            }
        });
    }
    assert!(worst < 0.67, "{worst} degrees");
}

#[test]
fn face_normals_are_at_right_angles_to_the_faces() {
    let mut worst = 0.0f64;
    for teapot in teapots() {
        for face in 0..teapot.mesh.faces().len() {
            let corners = teapot
                .corners(face)
                .1
                .map(|vertex| teapot.mesh.vertices()[vertex].map(f64::from));
            let side = |corner: usize| [0, 1, 2].map(|axis| corners[corner][axis] - corners[0][axis]);
            let normal = cross(side(1), side(2));
            let length = normal.iter().map(|value| value * value).sum::<f64>().sqrt();
            let stored = direction(teapot.face_normals[face]);
            worst = worst.max(angle(stored, normal.map(|value| value / length)));
        }
    }
    assert!(worst < 0.67, "{worst} degrees");
}

/// The corners of a face are near each other in the texture too: no face spans a seam. All coordinates are in two textures.
#[test]
fn texture_runs_with_the_surface() {
    for teapot in teapots() {
        assert!(teapot.coordinates.iter().flatten().all(|&at| (0..=8192).contains(&at)));
        for face in 0..teapot.mesh.faces().len() {
            let [a, b, c] = teapot
                .corners(face)
                .1
                .map(|vertex| teapot.coordinates[vertex].map(i64::from));
            let span = |axis: usize| [a, b, c].map(|at| at[axis]);
            for axis in [0, 1] {
                let (least, most) = (span(axis).into_iter().min(), span(axis).into_iter().max());
                assert!(
                    most.unwrap() - least.unwrap() <= 2048 / teapot.cells as i64 * 2,
                    "{face}"
                );
            }
            let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
            assert_ne!(area, 0, "{face}: no texture on it");
        }
    }
}

/// No face is near black, and the faces of a part differ.
#[test]
fn colors_show_the_shape() {
    for teapot in teapots() {
        let brightness = |color: &Rgb565| color.r() as u32 * 2 + color.g() as u32 + color.b() as u32 * 2;
        let least = teapot.colors.iter().map(brightness).min().unwrap();
        assert!(least >= 40, "{least} of 187");
        assert!(teapot.colors.iter().collect::<HashSet<_>>().len() > 40);
    }
}

impl Teapot {
    /// The positions of the three corners of a face, and their indices among the vertices.
    fn corners(&self, face: usize) -> ([Position; 3], [usize; 3]) {
        let vertices = self.mesh.faces()[face].map(usize::from);
        (vertices.map(|vertex| self.mesh.vertices()[vertex]), vertices)
    }

    /// Each corner of each cell: the mesh's vertex, the surface's normal, and the patch's place in [`PARTS`].
    fn for_each_corner(&self, mut act: impl FnMut(usize, Option<[f64; 3]>, usize)) {
        let faces: HashMap<_, _> = (0..self.mesh.faces().len())
            .flat_map(|face| {
                let (positions, vertices) = self.corners(face);
                let [a, b, c] = positions;
                let [i, j, k] = vertices;
                [([a, b, c], [i, j, k]), ([b, c, a], [j, k, i]), ([c, a, b], [k, i, j])]
            })
            .collect();
        for (index, part) in PARTS.iter().enumerate() {
            for patch in part.patches {
                let corners = Corners::new(patch, self.cells);
                for face in corners.faces() {
                    let vertices = faces[&face.map(|at| corners.position(at))];
                    for (vertex, at) in vertices.into_iter().zip(face) {
                        act(vertex, corners.normal(at), index);
                    }
                }
            }
        }
    }
}

/// The corners of the cells of a patch, each by de Casteljau's algorithm.
struct Corners {
    controls: [[[i128; 3]; 4]; 4],
    cells: usize,
}

type At = (usize, usize);

impl Corners {
    fn new(patch: &Patch, cells: usize) -> Self {
        let point = |index: usize| {
            let [x, away, up] = CONTROL_POINTS[usize::from(patch[index])].map(i128::from);
            [x, up, away]
        };
        let controls = [0, 4, 8, 12].map(|row| [0, 1, 2, 3].map(|column| point(row + column)));
        Self { controls, cells }
    }

    /// The point times the sixth power of the cells.
    fn point(&self, (row, column): At) -> [i128; 3] {
        let cells = self.cells as i128;
        let across = self.controls.map(|controls| casteljau(controls, column as i128, cells));
        casteljau(across, row as i128, cells)
    }

    fn position(&self, at: At) -> Position {
        let point = self.point(at);
        let whole = (self.cells as i128).pow(6);
        [0, 1, 2].map(|axis| {
            let dividend = (point[axis] - MIDDLE[axis] * whole) * SCALE;
            let divisor = whole * i128::from(UNITS);
            let magnitude = (dividend.abs() + divisor / 2) / divisor;
            (magnitude * dividend.signum()) as i16
        })
    }

    /// From differences of control values, by the rule for derivatives of Bézier curves; none at a pole.
    fn normal(&self, (row, column): At) -> Option<[f64; 3]> {
        let cells = self.cells as i128;
        let transposed = [0, 1, 2, 3].map(|column| self.controls.map(|row| row[column]));
        let across = self.controls.map(|controls| casteljau(controls, column as i128, cells));
        let down = transposed.map(|controls| casteljau(controls, row as i128, cells));
        let one = derivative(across, row as i128, cells).map(|value| value as f64);
        let other = derivative(down, column as i128, cells).map(|value| value as f64);
        let normal = cross(one, other);
        let length = normal.iter().map(|value| value * value).sum::<f64>().sqrt();
        (length > 0.0).then(|| normal.map(|value| value / length))
    }

    fn all(&self) -> Vec<Position> {
        let corners = (0..=self.cells).flat_map(|row| (0..=self.cells).map(move |column| (row, column)));
        corners.map(|at| self.position(at)).collect()
    }

    fn faces(&self) -> impl Iterator<Item = [At; 3]> {
        let cells = (0..self.cells).flat_map(|row| (0..self.cells).map(move |column| (row, column)));
        cells
            .flat_map(|(row, column)| {
                let opposite = (row + 1, column + 1);
                [
                    [(row, column), (row + 1, column), opposite],
                    [(row, column), opposite, (row, column + 1)],
                ]
            })
            .filter(|face| {
                let [a, b, c] = face.map(|at| self.point(at));
                a != b && b != c && c != a
            })
    }
}

/// A point of a curve at `step / steps`, times `steps` once for each time that the points between are taken.
fn casteljau<const N: usize>(mut controls: [[i128; 3]; N], step: i128, steps: i128) -> [i128; 3] {
    for count in (1..N).rev() {
        for index in 0..count {
            let (one, other) = (controls[index], controls[index + 1]);
            controls[index] = [0, 1, 2].map(|axis| (steps - step) * one[axis] + step * other[axis]);
        }
    }
    controls[0]
}

/// In the direction of the derivative.
fn derivative(controls: [[i128; 3]; 4], step: i128, steps: i128) -> [i128; 3] {
    let differences = [0, 1, 2].map(|index| [0, 1, 2].map(|axis| controls[index + 1][axis] - controls[index][axis]));
    casteljau(differences, step, steps)
}

/// The corners from the least one on, in the same order around.
fn turned([a, b, c]: [Position; 3]) -> [Position; 3] {
    [[a, b, c], [b, c, a], [c, a, b]].into_iter().min().unwrap()
}

/// The direction of a point of the octahedron's net, by the formula of who reads it.
fn direction([a, b]: [i8; 2]) -> [f64; 3] {
    let (a, b) = (f64::from(a) / 127.0, f64::from(b) / 127.0);
    let z = 1.0 - a.abs() - b.abs();
    let sign = |value: f64| if value < 0.0 { -1.0 } else { 1.0 };
    let [x, y] = if z < 0.0 {
        [(1.0 - b.abs()) * sign(a), (1.0 - a.abs()) * sign(b)]
    } else {
        [a, b]
    };
    let length = (x * x + y * y + z * z).sqrt();
    [x / length, y / length, z / length]
}

fn angle(one: [f64; 3], other: [f64; 3]) -> f64 {
    let sine = cross(one, other).iter().map(|value| value * value).sum::<f64>().sqrt();
    let cosine: f64 = one.iter().zip(other).map(|(one, other)| one * other).sum();
    sine.atan2(cosine).to_degrees()
}

fn cross(u: [f64; 3], v: [f64; 3]) -> [f64; 3] {
    [
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
    ]
}

/// Twice the area, along the normal.
fn area_vector([a, b, c]: [Position; 3]) -> [i64; 3] {
    let difference = |from: Position, to: Position| [0, 1, 2].map(|axis| f64::from(to[axis]) - f64::from(from[axis]));
    cross(difference(a, b), difference(a, c)).map(|value| value as i64)
}

fn dot(one: [i64; 3], other: [i64; 3]) -> i64 {
    one.iter().zip(other).map(|(one, other)| one * other).sum()
}
