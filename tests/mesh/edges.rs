//! Edges of meshes: of known solids, and against a search of all sides of all faces with exact angles.

use proptest::{collection::vec, prelude::*};
use zrow::{
    fixed::types::I2F14,
    geometry::{InputError, TooSmall},
    scene::{Edge, EdgeKind, FaceSet},
};

use crate::{
    common::{cases, config, meshes},
    reference::wide_product::product,
};

/// A side of a face between two positions, the lesser one first.
type Ends = [[i16; 3]; 2];

fn sides([a, b, c]: [u16; 3]) -> [[u16; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

fn ends(vertices: &[[i16; 3]], side: [u16; 2]) -> Ends {
    let mut ends = side.map(|vertex| vertices[usize::from(vertex)]);
    ends.sort_unstable();
    ends
}

fn normal(vertices: &[[i16; 3]], face: [u16; 3]) -> [i128; 3] {
    let [a, b, c] = face.map(|vertex| vertices[usize::from(vertex)].map(i128::from));
    let way = |to: [i128; 3]| [to[0] - a[0], to[1] - a[1], to[2] - a[2]];
    let ([x, y, z], [u, v, w]) = (way(b), way(c));
    [y * w - z * v, z * u - x * w, x * v - y * u]
}

fn dot(one: [i128; 3], other: [i128; 3]) -> i128 {
    one.into_iter().zip(other).map(|(one, other)| one * other).sum()
}

/// The sign of a number, and the 256 bits of its square times a square.
fn signed_square(number: i128, scale: u128) -> (i128, (u128, u128)) {
    let scaled = number.unsigned_abs() * scale;
    (number.signum(), product(scaled, scaled))
}

/// The kind of an edge between two faces; `None` where they lie in one plane.
fn kind(one: [i128; 3], other: [i128; 3], cosine: I2F14) -> Option<EdgeKind> {
    let (sign, square) = signed_square(dot(one, other), 1 << 14);
    let is_below = |cosine: i16| {
        let lengths = dot(one, one).unsigned_abs();
        let size = u128::from(cosine.unsigned_abs());
        let limit = product(lengths * size, dot(other, other).unsigned_abs() * size);
        match (sign, i128::from(cosine.signum())) {
            (sign, limit) if sign != limit => sign < limit,
            (1, _) => square < limit,
            (-1, _) => square > limit,
            _ => false,
        }
    };
    match (is_below(1 << 14), is_below(cosine.to_bits())) {
        (false, _) => None,
        (true, true) => Some(EdgeKind::Crease),
        (true, false) => Some(EdgeKind::Smooth),
    }
}

/// All edges by a plain search, in the order of faces.
fn searched(vertices: &[[i16; 3]], faces: &[[u16; 3]], cosine: I2F14) -> Vec<Edge> {
    let all: Vec<(u16, [u16; 2])> = (0..)
        .zip(faces)
        .filter(|(_, face)| normal(vertices, **face) != [0; 3])
        .flat_map(|(number, face)| sides(*face).map(|side| (number, side)))
        .collect();
    let mut edges = Vec::new();
    for (index, (face, side)) in all.iter().enumerate() {
        let is_same = |(_, other): &&(u16, [u16; 2])| ends(vertices, *other) == ends(vertices, *side);
        let before = all[..index].iter().filter(is_same).count();
        let after: Vec<u16> = all[index + 1..].iter().filter(is_same).map(|(face, _)| *face).collect();
        if before % 2 == 1 {
            continue;
        }
        edges.extend(match (before, &after[..]) {
            (0, []) => Some(Edge::boundary(*side, *face)),
            (0, [other]) => {
                let [one, two] = [*face, *other].map(|face| normal(vertices, faces[usize::from(face)]));
                kind(one, two, cosine).map(|kind| match kind {
                    EdgeKind::Smooth => Edge::smooth(*side, [*face, *other]),
                    _ => Edge::crease(*side, [*face, *other]),
                })
            }
            (_, []) => Some(Edge::crease(*side, [*face; 2])),
            (_, [other, ..]) => Some(Edge::crease(*side, [*face, *other])),
        });
    }
    edges
}

/// The edges as the library finds them, of up to 24 faces, which are filled up with faces that have no area.
fn found(vertices: &[[i16; 3]], faces: &[[u16; 3]], cosine: I2F14) -> Vec<Edge> {
    let mut all = [[0; 3]; 24];
    all[..faces.len()].copy_from_slice(faces);
    let mut edges = FaceSet::find_edges::<24, 72>(vertices, &all, cosine).unwrap().to_vec();
    let count = FaceSet::count_edges(vertices, &all);
    assert!(
        edges
            .drain(count..)
            .all(|edge| edge.faces() == [FaceSet::NO_NEIGHBOUR; 2])
    );
    edges
}

/// Vertices of a small grid, so that positions are often the same, edges have any number of faces and faces lie in one plane;
/// or anywhere.
fn vertices() -> impl Strategy<Value = Vec<[i16; 3]>> {
    let on_grid =
        |size: i16| (-1..=1i16, -1..=1i16, 0..=1i16).prop_map(move |(x, y, z)| [x * size, y * size, z * size]);
    prop_oneof![
        vec(on_grid(50), 3..9),
        vec(on_grid(32_767), 3..9),
        vec(any::<[i16; 3]>(), 3..9),
    ]
}

proptest! {
    #![proptest_config(config(cases(2_000, 40_000)))]

    #[test]
    fn edges_are_those_of_a_plain_search(
        vertices in vertices(),
        faces in vec(any::<[u16; 3]>(), 0..24),
        cosine in prop_oneof![any::<i16>(), Just(0), Just(0x2000), Just(0x4000), Just(-0x4000)],
    ) {
        let faces: Vec<_> = faces.iter().map(|face| face.map(|vertex| vertex % vertices.len() as u16)).collect();
        let cosine = I2F14::from_bits(cosine);
        prop_assert_eq!(found(&vertices, &faces, cosine), searched(&vertices, &faces, cosine));
    }

    /// Two faces, one of which turns about the edge by a unit more or less than an angle: 160 bits decide.
    #[test]
    fn angles_are_compared_exactly(
        tilt in any::<[i16; 3]>(),
        shift in -3..=3i16,
    ) {
        let vertices = [[-32_768, -32_768, 32_767], [32_767, 32_767, -32_768], [-32_768, 32_767, 0], tilt];
        let faces = [[0, 1, 2], [1, 0, 3]];
        let [one, other] = faces.map(|face| normal(&vertices, face).map(|part| part as f64));
        let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let cosine = dot(one, other) / (dot(one, one) * dot(other, other)).sqrt();
        prop_assume!(!cosine.is_nan());
        let near = I2F14::from_bits((cosine * 16_384.0).round() as i16 + shift);
        prop_assert_eq!(found(&vertices, &faces, near), searched(&vertices, &faces, near));
    }
}

#[test]
fn a_turn_by_exactly_the_angle_is_no_crease() {
    // Normals along (1, 1, 0) and (1, 0, 1): 60 degrees.
    for size in [1, 2, 9_000] {
        let vertices = [
            [0, 0, 0],
            [size, -size, -size],
            [size, -size, 2 * size],
            [size, 2 * size, -size],
        ];
        let faces = [[1, 0, 2], [0, 1, 3]];
        assert_eq!(normal(&vertices, faces[0]).map(i128::signum), [1, 1, 0]);
        let kind = |bits| {
            let edges = FaceSet::find_edges::<2, 5>(&vertices, &faces, I2F14::from_bits(bits)).unwrap();
            edges[0].kind()
        };
        assert_eq!(
            [0x1fff, 0x2000, 0x2001].map(kind),
            [EdgeKind::Smooth, EdgeKind::Smooth, EdgeKind::Crease]
        );
    }
}

#[test]
fn solids_have_the_edges_that_they_are_known_for() {
    let cube = meshes::cube(1.0);
    for (cosine, kind) in [
        ("0.866", EdgeKind::Crease),
        ("0", EdgeKind::Smooth),
        ("-1", EdgeKind::Smooth),
    ] {
        let edges = found_all::<12, 12>(&cube, cosine);
        assert!(edges.iter().all(|edge| edge.kind() == kind), "{cosine}");
    }
    // Euler: 162 vertices and 320 faces have 480 edges.
    let ball = meshes::icosphere(1.0);
    let edges = found_all::<320, 480>(&ball, "0.9");
    assert!(edges.iter().all(|edge| edge.kind() == EdgeKind::Smooth));
    // Without a face: three boundaries more.
    let open = meshes::Mesh::new(ball.vertices, ball.faces[1..].to_vec());
    let edges = found_all::<319, 480>(&open, "0.9");
    assert_eq!(edges.iter().filter(|edge| edge.kind() == EdgeKind::Boundary).count(), 3);
}

/// The edges of a mesh with exactly so many of them.
fn found_all<const FACES: usize, const EDGES: usize>(mesh: &meshes::Mesh, cosine: &str) -> [Edge; EDGES] {
    let faces = mesh.faces[..].try_into().unwrap();
    assert_eq!(FaceSet::count_edges::<FACES>(&mesh.vertices, faces), EDGES);
    FaceSet::find_edges(&mesh.vertices, faces, cosine.parse().unwrap()).unwrap()
}

#[test]
fn errors_say_what_is_wrong() {
    const VERTICES: [[i16; 3]; 3] = [[0, 0, 0], [9, 0, 0], [0, 9, 0]];
    let find = |faces| FaceSet::find_edges::<2, 2>(&VERTICES, faces, I2F14::ZERO);
    assert_eq!(
        find(&[[0, 1, 2], [0, 3, 1]]),
        Err(InputError::IndexOutOfRange { face: 1, vertex: 3 })
    );
    assert_eq!(find(&[[0, 1, 2], [1, 1, 1]]), Err(TooSmall::Edges(3).into()));
    assert_eq!(
        find(&[[0, 1, 1], [1, 1, 1]]).map(|edges| edges[0].faces()),
        Ok([u16::MAX; 2])
    );
    assert_eq!(FaceSet::count_edges::<0>(&[], &[]), 0);
}
