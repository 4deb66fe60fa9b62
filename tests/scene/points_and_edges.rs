//! Points and edges of prepared frames: of whole faces against a plain search, of cut ones against `f64`.

use std::collections::HashMap;

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use fixed::types::{I2F14, I8F24, I16F16};
use proptest::prelude::*;
use zrow::{
    geometry::SubPixel,
    scene::{
        Affine, BoundingBox, Camera, Counted, Deep, DepthWidth, DoubleSided, Edge, EdgeKind, FaceSet, Fine, Look,
        Memory, Model, Orthographic, Pose, Rotation, Whole,
    },
    shade::{Bounded, Transformed},
};

use crate::common::meshes::{self, Mesh};
use crate::common::{cases, config};
use crate::numbered_scene::area;
use crate::snapped_faces::{at, camera, standard_pose};

/// The edges of a mesh of so many faces, creases at 30 degrees.
fn table<const FACES: usize>(mesh: &Mesh) -> Vec<Edge> {
    let faces: &[_; FACES] = mesh.faces[..].try_into().unwrap();
    let count = FaceSet::count_edges(&mesh.vertices, faces);
    let edges = FaceSet::find_edges::<FACES, 900>(&mesh.vertices, faces, I2F14::lit("0.866")).unwrap();
    edges[..count].to_vec()
}

/// Twice the area of a triangle; positive where its corners run clockwise.
fn clockwise([a, b, c]: [[i64; 2]; 3]) -> i64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
}

/// Which edges are drawn, by the signs of the faces beside them as they are seen, and whether they are silhouettes.
fn drawn(edge: &Edge, draws_backs: bool, sign: impl Fn(u16) -> i64) -> Option<bool> {
    let sides: Vec<i64> = edge
        .faces()
        .into_iter()
        .filter(|face| *face != FaceSet::NO_NEIGHBOUR)
        .map(sign)
        .collect();
    let seen = sides
        .iter()
        .filter(|side| **side > 0 || draws_backs && **side < 0)
        .count();
    let fronts = sides.iter().filter(|side| **side > 0).count();
    match edge.kind() {
        EdgeKind::Boundary => (seen > 0).then_some(true),
        EdgeKind::Crease => (seen > 0).then_some(fronts == 1),
        EdgeKind::Smooth => (fronts == 1).then_some(true),
    }
}

/// Compares the points and edges of models whose faces are all on the screen with what follows from the faces. Returns how many
/// edges of each kind were drawn.
fn check_whole<L: Look<Color = Rgb888>>(
    models: &[Model<'_, L::Shading>],
    tables: &[Vec<Edge>],
    camera: &Camera,
    (draws_backs, is_mirrored): (bool, bool),
) -> [usize; 3] {
    let mut memory = Box::new(Memory::<L, 500, 900, 96, 80>::new());
    let scene = memory.prepare(camera, models).unwrap();
    let points: HashMap<_, _> = scene
        .points()
        .map(|point| ((point.model, point.vertex), point.corner))
        .collect();
    assert_eq!(
        points.len(),
        models.iter().map(|model| model.mesh().vertices().len()).sum::<usize>()
    );

    let mut signs = Vec::new();
    let mut faces = scene.faces();
    for (number, model) in models.iter().enumerate() {
        signs.push(Vec::new());
        for corners in model.mesh().faces() {
            let corners = corners.map(|vertex| points[&(number, usize::from(vertex))]);
            let face = faces.next().unwrap().corners;
            assert!(corners.iter().all(|corner| face.contains(corner)));
            let area = clockwise(corners.map(|corner| [corner.point.x_units(), corner.point.y_units()].map(i64::from)));
            signs[number].push(if is_mirrored { -area } else { area });
        }
    }
    let mut kinds = [0; 3];
    for (number, table) in tables.iter().enumerate() {
        let expected = table.iter().enumerate().filter_map(|(index, edge)| {
            let is_silhouette = drawn(edge, draws_backs, |face| signs[number][usize::from(face)])?;
            let ends = edge.vertices().map(|vertex| points[&(number, usize::from(vertex))]);
            Some((index, ends, edge.kind(), is_silhouette))
        });
        let found: Vec<_> = scene
            .edges(number, table)
            .map(|edge| (edge.index, edge.ends, edge.kind, edge.is_silhouette))
            .collect();
        assert_eq!(found, expected.collect::<Vec<_>>(), "{number}");
        for (_, _, kind, _) in found {
            kinds[kind as usize] += 1;
        }
    }
    assert_eq!(scene.edges(models.len(), &tables[0]).count(), 0);
    let beyond = [
        Edge::boundary([0, 9_999], 0),
        Edge::smooth([0, 1], [9_999, 9_998]),
        Edge::boundary([0, 1], 65_535),
    ];
    assert_eq!(scene.edges(0, &beyond).count(), 0);
    kinds
}

/// A cube, a ball without some faces, and a torus.
fn solids() -> ([Mesh; 3], [Vec<Edge>; 3]) {
    let ball = meshes::icosphere(0.7);
    let meshes = [
        meshes::cube(0.6),
        Mesh::new(ball.vertices, ball.faces[..200].to_vec()),
        meshes::torus(),
    ];
    let tables = [
        table::<12>(&meshes[0]),
        table::<200>(&meshes[1]),
        table::<576>(&meshes[2]),
    ];
    (meshes, tables)
}

fn check_whole_look<L: Look<Color = Rgb888, Shading = Rgb888>>(camera: &Camera, draws_backs: bool) {
    let (meshes, tables) = solids();
    let colors = [Rgb888::RED; 576];
    let mut kinds = [0; 3];
    for frame in 0..16 {
        let models: Vec<_> = (0..)
            .zip(&meshes[..2])
            .map(|(number, mesh)| {
                Model::new(mesh.face_set(), &colors)
                    .unwrap()
                    .with_pose(standard_pose(frame * 21 + 99 * number))
            })
            .collect();
        let counted = check_whole::<L>(&models, &tables[..2], camera, (draws_backs, false));
        let torus = Model::new(meshes[2].face_set(), &colors)
            .unwrap()
            .with_pose(standard_pose(frame * 21));
        let of_torus = check_whole::<L>(&[torus], &tables[2..], camera, (draws_backs, false));
        kinds = [0, 1, 2].map(|kind| kinds[kind] + counted[kind] + of_torus[kind]);
    }
    assert!(kinds.iter().all(|count| *count > 100), "{kinds:?}");
}

#[test]
fn edges_are_drawn_as_faces_are_seen() {
    let camera = camera(area(96, 80));
    check_whole_look::<Rgb888>(&camera, false);
    check_whole_look::<Whole<Rgb888>>(&camera, false);
    check_whole_look::<Fine<Deep<Rgb888>>>(&camera, false);
    check_whole_look::<DoubleSided<Rgb888>>(&camera, true);
    let parallel = camera
        .with_far(I16F16::from_num(4_000))
        .and_then(|camera| camera.with_scale(I8F24::from_num(0.05)))
        .unwrap();
    check_whole_look::<Orthographic<Rgb888>>(&parallel, false);
}

#[test]
fn mirrored_models_and_those_that_are_left_out_have_their_edges() {
    let ([cube, ..], [table, ..]) = solids();
    let (colors, camera) = ([Rgb888::RED; 12], camera(area(96, 80)));
    let map = Affine::scaled([-1, 1, 1].map(I8F24::from_num));
    for frame in 0..16 {
        let mirrored = Model::with_skin(cube.face_set(), (&colors[..], map));
        let models = [mirrored.unwrap().with_pose(standard_pose(frame * 21 + 4))];
        check_whole::<Transformed<Rgb888>>(&models, std::slice::from_ref(&table), &camera, (false, true));
    }
    let bounds = BoundingBox::around(&cube.vertices);
    let skin = (&colors[..], bounds);
    let model = Model::with_skin(cube.face_set(), skin).unwrap();
    let models = [
        model.with_pose(Pose::new(Rotation::IDENTITY, at(0, 0, -3_000))),
        model.with_pose(standard_pose(3)),
    ];
    let mut memory = Box::new(Memory::<Counted<Bounded<Rgb888>>, 16, 24, 96, 80>::new());
    let scene = memory.prepare(&camera, &models).unwrap();
    assert_eq!(
        scene
            .points()
            .map(|point| (point.model, point.vertex))
            .collect::<Vec<_>>(),
        [0, 1, 2, 3, 4, 5, 6, 7].map(|vertex| (1, vertex))
    );
    assert_eq!(scene.edges(0, &table).count(), 0);
    assert_eq!(scene.edges(1, &table).count(), 9);
}

/// The distance of a point from a segment, and how far along it is.
fn distance(point: [f64; 2], [a, b]: [[f64; 2]; 2]) -> (f64, f64) {
    let (way, offset) = ([b[0] - a[0], b[1] - a[1]], [point[0] - a[0], point[1] - a[1]]);
    let square = (way[0] * way[0] + way[1] * way[1]).max(1e-12);
    let along = ((way[0] * offset[0] + way[1] * offset[1]) / square).clamp(0.0, 1.0);
    ((offset[0] - along * way[0]).hypot(offset[1] - along * way[1]), along)
}

const NEAR: f64 = 128.0;
const FAR: f64 = 900.0;

/// Compares the edges of a tetrahedron that reaches beyond the near plane, the far plane and the guard band with those
/// that are projected in `f64`. Returns how many of them were cut and seen.
fn check_cut<L: Look<Color = Rgb888, Shading = Rgb888>>(
    vertices: [[i16; 3]; 4],
    cosine: I2F14,
    project: impl Fn([f64; 3]) -> [f64; 2],
    is_parallel: bool,
) -> Result<usize, TestCaseError> {
    let size = [48, 40];
    let camera = camera(area(size[0], size[1]))
        .with_far(I16F16::from_num(FAR))
        .and_then(|camera| camera.with_scale(I8F24::from_num(0.25)))
        .unwrap();
    let faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
    let edges: [Edge; 6] = FaceSet::find_edges(&vertices, &faces, cosine).unwrap();
    let models = [Model::new(FaceSet::new(&vertices, &faces).unwrap(), &[Rgb888::RED; 4]).unwrap()];
    let mut memory = Memory::<L, 200, 4, 48, 40, 8>::new();
    let scene = memory.prepare(&camera, &models).unwrap();
    let unit = f64::from(1 << L::Precision::FRACTION_BITS);
    let nearest = camera.depth_at::<L::Precision, L::Depth>(camera.near()).units();

    let points: HashMap<_, _> = scene.points().map(|point| (point.vertex, point.corner)).collect();
    // Eye space is the space of the vertices here, so that this is exact.
    let sign = |face: u16| {
        let corners = faces[usize::from(face)].map(usize::from);
        let on_screen = |vertex: &usize| {
            points
                .get(vertex)
                .map(|corner| [corner.point.x_units(), corner.point.y_units()].map(i64::from))
        };
        if let [Some(a), Some(b), Some(c)] = corners.each_ref().map(on_screen) {
            return clockwise([a, b, c]).signum();
        }
        let [a, b, c] = corners.map(|vertex| vertices[vertex].map(i64::from));
        if is_parallel {
            return -clockwise([a, b, c].map(|[x, y, _]| [x, y])).signum();
        }
        let normal = [
            a[1] * b[2] - a[2] * b[1],
            a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0],
        ];
        -(normal[0] * c[0] + normal[1] * c[1] + normal[2] * c[2]).signum()
    };
    let mut found: HashMap<usize, _> = scene.edges(0, &edges).map(|edge| (edge.index, edge)).collect();
    let mut cut = 0;
    for (index, edge) in edges.iter().enumerate() {
        let found = found.remove(&index);
        let Some(is_silhouette) = (edge.faces() != [u16::MAX; 2])
            .then(|| drawn(edge, false, sign))
            .flatten()
        else {
            prop_assert!(found.is_none(), "{} is drawn", index);
            continue;
        };
        // What is between the planes.
        let [a, b] = edge
            .vertices()
            .map(|vertex| vertices[usize::from(vertex)].map(f64::from));
        let on_way = |part: f64| [0, 1, 2].map(|axis| a[axis] + part * (b[axis] - a[axis]));
        let at_plane = |z: f64| ((z - a[2]) / (b[2] - a[2])).clamp(0.0, 1.0);
        if a[2].max(b[2]) < NEAR || a[2].min(b[2]) > FAR {
            prop_assert!(found.is_none());
            continue;
        }
        let mut parts = [0.0, 1.0];
        if a[2] != b[2] {
            let [near, far] = [NEAR, FAR].map(at_plane);
            parts = if a[2] < b[2] { [near, far] } else { [far, near] };
        }
        let ends = parts.map(on_way);
        let exact = ends.map(&project);
        let seen = found.map(|edge| {
            edge.ends
                .map(|end| [end.point.x_units(), end.point.y_units()].map(|units| f64::from(units) / unit))
        });
        for step in 0..=200 {
            let part = parts[0] + f64::from(step) / 200.0 * (parts[1] - parts[0]);
            let [x, y] = project(on_way(part));
            if (0.0..f64::from(size[0])).contains(&x) && (0.0..f64::from(size[1])).contains(&y) {
                let Some(seen) = seen else {
                    return Err(TestCaseError::fail(format!("edge {index} is missing at {x} {y}")));
                };
                let (off, _) = distance([x, y], seen);
                prop_assert!(off < 0.2, "edge {} is off by {} at {} {}", index, off, x, y);
            }
        }
        let (Some(edge), Some(seen)) = (found, seen) else {
            continue;
        };
        prop_assert_eq!(edge.is_silhouette, is_silhouette);
        let length = (exact[1][0] - exact[0][0]).hypot(exact[1][1] - exact[0][1]);
        let mut ways = [0.0; 2];
        for ((corner, end), way) in edge.ends.iter().zip(seen).zip(&mut ways) {
            let off;
            (off, *way) = distance(end, exact);
            prop_assert!(off < 0.2, "an end of edge {} is off by {}", index, off);
            if !is_parallel && length > 1.0 {
                // 1/z varies evenly on the screen.
                let [from, to] = ends.map(|end| f64::from(nearest) * NEAR / end[2]);
                let depth = from + *way * (to - from);
                let tolerance = 2.0 + f64::from(nearest) * 2e-4 + (to - from).abs() * 0.2 / length;
                prop_assert!(
                    (f64::from(corner.depth.units()) - depth).abs() < tolerance,
                    "{} for {}",
                    corner.depth.units(),
                    depth
                );
            }
        }
        prop_assert!(
            ways[0] <= ways[1] || length < 1.0,
            "the ends of edge {} are exchanged",
            index
        );
        cut += usize::from(edge.ends.iter().any(|end| points.values().all(|point| point != end)));
    }
    prop_assert!(found.is_empty());
    Ok(cut)
}

/// A coordinate near the view, or anywhere.
fn sideways() -> impl Strategy<Value = i16> {
    prop_oneof![3 => -500i16..500, 1 => any::<i16>()]
}

/// A distance before, at or behind the near and the far plane, or any.
fn distance_ahead() -> impl Strategy<Value = i16> {
    let at_planes = prop::sample::select(vec![127i16, 128, 129, 899, 900, 901]);
    prop_oneof![3 => -300i16..1_300, 1 => any::<i16>(), 1 => at_planes]
}

proptest! {
    #![proptest_config(config(cases(1_000, 40_000)))]

    #[test]
    fn edges_are_cut_where_faces_are(
        positions in prop::array::uniform4((sideways(), sideways())),
        distances in prop::array::uniform4(distance_ahead()),
        bits in prop::sample::select(vec![-0x4000i16, 0, 0x4000]),
    ) {
        let vertices = [0, 1, 2, 3].map(|at| [positions[at].0, positions[at].1, distances[at]]);
        let cosine = I2F14::from_bits(bits);
        let perspective = |[x, y, z]: [f64; 3]| [23.5 + 24.0 * x / z, 19.5 - 24.0 * y / z];
        check_cut::<Rgb888>(vertices, cosine, perspective, false)?;
        check_cut::<Fine<Deep<Rgb888>>>(vertices, cosine, perspective, false)?;
        let parallel = |[x, y, _]: [f64; 3]| [23.5 + 0.25 * x, 19.5 - 0.25 * y];
        check_cut::<Orthographic<Rgb888>>(vertices, cosine, parallel, true)?;
    }
}

/// That the cases above have what they are about.
#[test]
fn cut_edges_are_seen() {
    let perspective = |[x, y, z]: [f64; 3]| [23.5 + 24.0 * x / z, 19.5 - 24.0 * y / z];
    let mut cut = 0;
    for z in [-200, 20, 100, 600, 800] {
        let vertices = [[-90, -80, z], [0, 100, z + 30], [80, -70, z], [5, 3, z + 300]];
        for cosine in [-0x4000, 0x4000] {
            cut += check_cut::<Rgb888>(vertices, I2F14::from_bits(cosine), perspective, false).unwrap();
        }
    }
    assert!(cut >= 12, "{cut}");
}
