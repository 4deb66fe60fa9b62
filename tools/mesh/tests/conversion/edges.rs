//! Tables of edges: of known solids, and against a plain search of all pairs of faces.

use zrow_mesh::{
    edges::{Edges, edges},
    mesh::Options,
    module::{self, Origin},
};

use crate::common::{CUBE, OPTIONS, Random, convert, corners, cross, obj};

/// The edges of the cube that stands in the tests, with so many degrees at a crease.
fn of_cube(crease: u8) -> Edges {
    let edges = Some(crease);
    convert(CUBE.as_bytes(), "cube.obj", &[], Options { edges, ..OPTIONS })
        .unwrap()
        .edges
        .unwrap()
}

#[test]
fn a_cube_has_twelve_creases_and_a_diagonal_on_each_side() {
    for (crease, sharp) in [(0, 12), (30, 12), (89, 12), (90, 0), (180, 0)] {
        let edges = of_cube(crease);
        assert_eq!((edges.table.len(), edges.sharp), (18, sharp), "{crease}");
        assert!(edges.table.iter().all(|[a, b, one, other]| a != b && one != other));
    }
}

#[test]
fn sides_that_nothing_is_beside_are_boundaries() {
    // A box without a lid: four sides and the bottom.
    let open = CUBE.lines().take(8 + 5).collect::<Vec<_>>().join("\n");
    let edges = Some(90);
    let mesh = convert(open.as_bytes(), "model.obj", &[], Options { edges, ..OPTIONS }).unwrap();
    let edges = mesh.edges.unwrap();
    assert_eq!((edges.table.len(), edges.sharp), (17, 4));
    for [.., one, other] in &edges.table[..4] {
        assert_eq!(one, other);
    }
    assert!(obj(CUBE, &[]).unwrap().edges.is_none());
}

/// Faces between random vertices of a small grid, so that positions are often the same and edges have any number of faces.
#[test]
fn edges_are_those_of_all_pairs_of_faces() {
    let mut random = Random(17);
    let mut of_many = 0;
    for case in 0..300 {
        let count = 4 + random.below(20);
        let vertices: Vec<[i16; 3]> = (0..count)
            .map(|_| [0; 3].map(|_| random.below(3) as i16 * 50))
            .collect();
        let faces: Vec<[u16; 3]> = (0..random.below(30))
            .map(|_| [0; 3].map(|_| random.below(count) as u16))
            .collect();
        let mesh = zrow_mesh::mesh::Mesh {
            vertices,
            ..Default::default()
        };
        let faces: Vec<_> = faces
            .into_iter()
            .filter(|face| cross(corners(&mesh, *face)) != [0; 3])
            .collect();
        let vertices = &mesh.vertices;
        let crease = [0, 30, 44, 60, 91, 180][case % 6];
        let found = edges(vertices, &faces, crease).unwrap();

        let ends = |pair: [u16; 2]| {
            let mut ends = pair.map(|vertex| vertices[usize::from(vertex)]);
            ends.sort_unstable();
            ends
        };
        let sides = |[a, b, c]: [u16; 3]| [[a, b], [b, c], [c, a]].map(ends);
        let mut expected: Vec<_> = faces.iter().flat_map(|face| sides(*face)).collect();
        expected.sort_unstable();
        expected.dedup();
        let mut all: Vec<_> = found.table.iter().map(|&[a, b, ..]| ends([a, b])).collect();
        all.sort_unstable();
        assert_eq!(all, expected, "{case}");
        for (index, &[a, b, one, other]) in found.table.iter().enumerate() {
            let beside: Vec<_> = (0..faces.len())
                .filter(|face| sides(faces[*face]).contains(&ends([a, b])))
                .collect();
            of_many += usize::from(beside.len() > 2);
            assert_eq!(usize::from(one), beside[0]);
            assert_eq!(usize::from(other), *beside.get(1).unwrap_or(&beside[0]));
            let is_sharp = beside.len() != 2 || {
                let [one, other] =
                    [one, other].map(|face| cross(corners(&mesh, faces[usize::from(face)])).map(|part| part as f64));
                let dot = |a: [f64; 3], b: [f64; 3]| (0..3).map(|axis| a[axis] * b[axis]).sum::<f64>();
                let cosine = (dot(one, other) / (dot(one, one) * dot(other, other)).sqrt()).clamp(-1.0, 1.0);
                cosine.acos().to_degrees() > f64::from(crease) + 1e-4
            };
            assert_eq!(index < found.sharp, is_sharp, "{case} {index}");
        }
    }
    assert!(of_many > 100, "{of_many}");
}

#[test]
fn a_module_holds_its_edges() {
    let options = Options {
        edges: Some(30),
        ..OPTIONS
    };
    let mesh = convert(CUBE.as_bytes(), "cube.obj", &[], options).unwrap();
    let module = module::write(
        &mesh,
        options,
        "CUBE",
        Origin {
            file: "cube.obj",
            name: None,
        },
    );
    let plain = module::write(
        &obj(CUBE, &[]).unwrap(),
        OPTIONS,
        "CUBE",
        Origin {
            file: "cube.obj",
            name: None,
        },
    );
    assert_eq!(module.bytes, plain.bytes + 18 * 8);
    for part in [
        "--size 100 --edges 30\n",
        "pub const CUBE_SHARP_EDGES: usize = 12;",
        "pub static CUBE_EDGES: [[u16; 4]; 18] = [",
    ] {
        assert!(module.source.contains(part), "{part}");
    }
    let [a, b, one, other] = mesh.edges.unwrap().table[17];
    assert!(module.source.contains(&format!("[{a}, {b}, {one}, {other}],")));
    assert!(!plain.source.contains("EDGES"));
}
