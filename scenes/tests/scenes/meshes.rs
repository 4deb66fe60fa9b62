//! The standard meshes have the vertices and faces they are known for, closed and facing outwards.

use std::collections::HashSet;

use zrow::scene::FaceSet;
use zrow_scenes::meshes::{CUBE, CUBE_COLORS, ICOSPHERE, ICOSPHERE_COLORS, TORUS_AND_CUBE, TORUS_AND_CUBE_COLORS};

type Vector = [i64; 3];

/// Vertices 0 to 287 are the torus; the cube follows.
const TORUS_VERTICES: u16 = 24 * 12;

fn corners(mesh: &FaceSet, face: &[u16; 3]) -> [Vector; 3] {
    face.map(|index| mesh.vertices()[usize::from(index)].map(i64::from))
}

fn difference(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: Vector, b: Vector) -> i64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn normal([a, b, c]: [Vector; 3]) -> Vector {
    let (u, v) = (difference(b, a), difference(c, a));
    [
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
    ]
}

#[test]
fn counts() {
    let counts = |mesh: &FaceSet| (mesh.vertices().len(), mesh.faces().len());
    assert_eq!(counts(&TORUS_AND_CUBE), (296, 588));
    assert_eq!(counts(&ICOSPHERE), (162, 320));
    assert_eq!(counts(&CUBE), (8, 12));
    assert_eq!(TORUS_AND_CUBE_COLORS.len(), 588);
    assert_eq!(ICOSPHERE_COLORS.len(), 320);
    assert_eq!(CUBE_COLORS.len(), 12);
}

/// Each edge of a face is passed once in each direction: no holes, no face turned over among its neighbours.
#[test]
fn closed() {
    for mesh in [&TORUS_AND_CUBE, &ICOSPHERE, &CUBE] {
        let mut edges = HashSet::new();
        for &[a, b, c] in mesh.faces() {
            for edge in [(a, b), (b, c), (c, a)] {
                assert!(edges.insert(edge), "{edge:?} twice");
            }
        }
        assert!(edges.iter().all(|&(a, b)| edges.contains(&(b, a))));
    }
}

#[test]
fn faces_look_outwards() {
    for mesh in [&ICOSPHERE, &CUBE] {
        for face in mesh.faces() {
            let corners = corners(mesh, face);
            assert!(dot(normal(corners), corners[0]) > 0, "{face:?}");
        }
    }
    for face in TORUS_AND_CUBE.faces() {
        let corners = corners(&TORUS_AND_CUBE, face);
        let middle = [0, 1, 2].map(|axis| corners.iter().map(|corner| corner[axis]).sum::<i64>());
        let inside = if face[0] < TORUS_VERTICES {
            // Three times the nearest point of the circle in the middle of the tube.
            let length = ((middle[0] * middle[0] + middle[1] * middle[1]) as f64).sqrt();
            let on_circle = |coordinate: i64| (coordinate as f64 / length * 3.0 * 512.0).round() as i64;
            [on_circle(middle[0]), on_circle(middle[1]), 0]
        } else {
            [0; 3]
        };
        assert!(dot(normal(corners), difference(middle, inside)) > 0, "{face:?}");
    }
}

/// A few vertices computed by hand: half units go away from zero.
#[test]
fn positions() {
    let torus = TORUS_AND_CUBE.vertices();
    assert_eq!(torus[0], [742, 0, 0]);
    assert_eq!(torus[3], [512, 0, 230]);
    assert_eq!(torus[6 * 12], [0, 742, 0]);
    assert_eq!(torus[288], [-256, -256, -256]);
    assert_eq!(torus[295], [256, 256, 256]);
    assert_eq!(CUBE.vertices()[1], [512, -512, -512]);
    assert_eq!(TORUS_AND_CUBE.faces()[0], [0, 12, 13]);
    assert_eq!(TORUS_AND_CUBE.faces()[1], [0, 13, 1]);
    assert_eq!(CUBE.faces()[0], [0, 2, 3]);
    // 1.4 units of 512 are 716.8, and rounding moves a vertex by less than one unit.
    for vertex in ICOSPHERE.vertices() {
        let vertex = vertex.map(i64::from);
        let length = (dot(vertex, vertex) as f64).sqrt();
        assert!((length - 716.8).abs() < 0.87, "{vertex:?}");
    }
}
