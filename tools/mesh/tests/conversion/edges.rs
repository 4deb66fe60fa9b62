//! Tables of edges: of known solids, and against those that the library finds.

use zrow::{
    fixed::types::I2F14,
    scene::{self, EdgeKind, FaceSet},
};
use zrow_mesh::{
    edges::{Beside, Edge, cosine, edges},
    mesh::Options,
    module::{self, Origin},
};

use crate::common::{CUBE, OPTIONS, Random, convert, obj};

/// The edges of a model that stands in the tests, with so many degrees at a crease.
fn of(model: &str, crease: u8) -> Vec<Edge> {
    let edges = Some(crease);
    convert(model.as_bytes(), "model.obj", &[], Options { edges, ..OPTIONS })
        .unwrap()
        .edges
        .unwrap()
}

/// An edge as a module has it.
fn written(edge: &Edge) -> scene::Edge {
    match edge.beside {
        Beside::Boundary(face) => scene::Edge::boundary(edge.vertices, face),
        Beside::Crease(faces) => scene::Edge::crease(edge.vertices, faces),
        Beside::Smooth(faces) => scene::Edge::smooth(edge.vertices, faces),
    }
}

#[test]
fn a_cube_has_twelve_creases_and_no_diagonal() {
    for (crease, kind) in [
        (0, EdgeKind::Crease),
        (30, EdgeKind::Crease),
        (89, EdgeKind::Crease),
        (90, EdgeKind::Smooth),
        (180, EdgeKind::Smooth),
    ] {
        let edges = of(CUBE, crease);
        assert_eq!(edges.len(), 12, "{crease}");
        assert!(edges.iter().all(|edge| written(edge).kind() == kind), "{crease}");
    }
}

#[test]
fn sides_that_nothing_is_beside_are_boundaries() {
    // A box without a lid: four sides and the bottom.
    let open = CUBE.lines().take(8 + 5).collect::<Vec<_>>().join("\n");
    let edges = of(&open, 90);
    let boundaries = edges.iter().filter(|edge| matches!(edge.beside, Beside::Boundary(_)));
    assert_eq!((edges.len(), boundaries.count()), (12, 4));
    assert!(obj(CUBE, &[]).unwrap().edges.is_none());
}

/// Faces between random vertices of a small grid, so that positions are often the same and edges have any number of faces.
#[test]
fn edges_are_those_that_the_library_finds() {
    const FACES: usize = 30;
    let mut random = Random(17);
    let mut of_many = 0;
    for case in 0..2_000 {
        let count = 4 + random.below(20);
        let vertices: Vec<[i16; 3]> = (0..count)
            .map(|_| [0; 3].map(|_| random.below(3) as i16 * 50))
            .collect();
        let faces = [[0; 3]; FACES].map(|face| face.map(|_: i32| random.below(count) as u16));
        let crease = [0, 30, 44, 60, 91, 180][case % 6];
        let found = edges(&vertices, &faces, crease).unwrap();
        let cosine = I2F14::from_bits(cosine(crease));
        let expected = FaceSet::find_edges::<FACES, { 3 * FACES }>(&vertices, &faces, cosine).unwrap();
        let expected = &expected[..FaceSet::count_edges(&vertices, &faces)];
        assert_eq!(found.iter().map(written).collect::<Vec<_>>(), expected, "{case}");
        of_many += found
            .iter()
            .filter(|edge| matches!(edge.beside, Beside::Crease([one, other]) if one == other))
            .count();
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
    assert_eq!(module.bytes, plain.bytes + 12 * 8);
    for part in [
        "--size 100 --edges 30\n",
        "use zrow::scene::{Edge, FaceSet};\n",
        "pub static CUBE_EDGES: [Edge; 12] = [",
    ] {
        assert!(module.source.contains(part), "{part}");
    }
    let Edge {
        vertices: [a, b],
        beside: Beside::Crease([one, other]),
    } = mesh.edges.unwrap()[11]
    else {
        panic!("a cube has creases alone");
    };
    assert!(
        module
            .source
            .contains(&format!("Edge::crease([{a}, {b}], [{one}, {other}]),"))
    );
    assert!(!plain.source.contains("Edge"));
}
