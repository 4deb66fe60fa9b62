//! Whether meshes are convex: solids that are known to be or not to be, and random meshes against all faces and vertices in `i128`.

use proptest::{array::uniform3, collection::vec, prelude::*};
use zrow::scene::FaceSet;

use crate::common::{cases, config, meshes};

#[test]
fn known_solids_are_convex_or_not() {
    assert!(meshes::cube(1.0).face_set().is_convex());
    assert!(!meshes::torus().face_set().is_convex());
    assert!(FaceSet::new(&[], &[]).unwrap().is_convex());
    // Inside out.
    let mut cube = meshes::cube(1.0);
    for face in &mut cube.faces {
        face.reverse();
    }
    assert!(!cube.face_set().is_convex());
    // The largest solid there is, with a vertex on one of its sides and one unit in front of it.
    let (low, high) = (i16::MIN, i16::MAX);
    let mut largest = meshes::cube(1.0);
    for coordinate in largest.vertices.as_flattened_mut() {
        *coordinate = if *coordinate < 0 { low } else { high };
    }
    assert!(largest.face_set().is_convex());
    let is_convex_with = |vertex: [i16; 3], [x, y, z]: [i16; 3]| {
        let mut mesh = largest.clone();
        for place in mesh.vertices.iter_mut().filter(|place| place[2] == high) {
            place[2] = z - 1;
        }
        mesh.vertices.push(vertex);
        mesh.vertices.push([x, y, 0]);
        mesh.face_set().is_convex()
    };
    assert!(is_convex_with([5, 7, 99], [low, high, 100]));
    assert!(!is_convex_with([5, 7, 100], [low, high, 100]));
}

proptest! {
    #![proptest_config(config(cases(500, 20_000)))]

    #[test]
    fn convex_is_what_has_no_vertex_in_front_of_a_face(
        size in prop_oneof![Just(2i16), Just(300), Just(i16::MAX)],
        seeds in vec(uniform3(any::<i16>()), 4..7),
        faces in vec(uniform3(0u16..4), 0..5),
    ) {
        let vertices: Vec<[i16; 3]> = seeds.iter().map(|seed| seed.map(|axis| axis % size)).collect();
        let is_behind = |face: &[u16; 3]| {
            let [a, b, c] = face.map(|vertex| vertices[usize::from(vertex)].map(i128::from));
            let way = |to: [i128; 3]| [to[0] - a[0], to[1] - a[1], to[2] - a[2]];
            let ([x, y, z], [u, v, w]) = (way(b), way(c));
            let normal = [y * w - z * v, z * u - x * w, x * v - y * u];
            vertices.iter().all(|vertex| {
                let [x, y, z] = way(vertex.map(i128::from));
                normal[0] * x + normal[1] * y + normal[2] * z <= 0
            })
        };
        let expected = faces.iter().all(is_behind);
        prop_assert_eq!(FaceSet::new(&vertices, &faces).unwrap().is_convex(), expected);
    }
}
