//! Appel's algorithm against exact depths along each edge, and against face against segment.
//!
//! The reference takes points of an edge as rationals and looks at all faces as they were snapped.

use std::collections::BTreeMap;

use embedded_graphics::pixelcolor::Rgb888;
use proptest::prelude::*;
use zrow::{
    geometry::{Sub4, Sub8, SubPixel, SubPoint},
    scene::{Camera, DepthWidth, Edge, Look, Memory, Model, Pose, Prepared, Rotation, ScreenPrecision},
    visible::{Appel, FaceAgainstSegment, LinePart, PartKind},
};

use crate::common::meshes::{self, Mesh};
use crate::common::{by_depth, cases, config, is_quick};
use crate::hidden_lines::{check as check_by_search, parts_by};
use crate::numbered_scene::{Format, LookIn, Scene, area};
use crate::random_faces::{faces, pose};
use crate::reference::nearest_faces::Face;
use crate::snapped_faces::{at, camera, snapped, standard_pose};

/// An edge of its vertices and faces.
type EdgeOf = fn([u16; 2], [u16; 2]) -> Edge;

/// Points of an edge that are compared, at least, where it has so many units.
const SAMPLES: i128 = 24;

type MemoryOf<S, D> = Memory<LookIn<S, D>, 6_000, 1_000, 64, 48, 200>;

/// All sides of the faces of a mesh, in the order of faces: boundaries, or edges that are made of vertices and faces.
fn edges(mesh: &Mesh, edge: EdgeOf) -> Vec<Edge> {
    let mut sides = BTreeMap::<[u16; 2], Vec<u16>>::new();
    let mut order = Vec::new();
    for (index, [a, b, c]) in (0..).zip(&mesh.faces) {
        for [from, to] in [[*a, *b], [*b, *c], [*c, *a]] {
            let side = [from.min(to), from.max(to)];
            if !sides.contains_key(&side) {
                order.push(side);
            }
            sides.entry(side).or_default().push(index);
        }
    }
    let of_side = |side: [u16; 2]| match sides[&side][..] {
        [face] => Edge::boundary(side, face),
        [one, other, ..] => edge(side, [one, other]),
        [] => unreachable!(),
    };
    order.into_iter().map(of_side).collect()
}

/// How far an edge has to be behind a face to be hidden.
fn tolerance<D: DepthWidth>() -> i128 {
    if D::FRACTION_BITS == 16 { 2 } else { 8 }
}

/// A point of an edge as a rational: x, y and depth, times the denominator.
fn along([from, to]: [[i128; 3]; 2], (step, steps): (i128, i128)) -> [i128; 3] {
    [0, 1, 2].map(|axis| from[axis] * steps + (to[axis] - from[axis]) * step)
}

/// Whether faces hide a point whose coordinates have a denominator: for certain, and whether they may, where it is on a side.
fn is_hidden(faces: &[Face], point: [i128; 3], denominator: i128, tolerance: i128) -> [bool; 2] {
    let [x, y, depth] = point;
    let mut hidden = [false; 2];
    for face in faces {
        let beyond = |axis: usize| {
            face.corners
                .iter()
                .all(|corner| corner[axis] * denominator < point[axis])
                || face
                    .corners
                    .iter()
                    .all(|corner| corner[axis] * denominator > point[axis])
        };
        if beyond(0) || beyond(1) {
            continue;
        }
        let [a, b, c] = face.corners.map(|corner| corner.map(|part| part * denominator));
        let right = |a: [i128; 3], b: [i128; 3]| (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
        let sides = [right(b, c), right(c, a), right(a, b)];
        let whole: i128 = sides.iter().sum();
        if whole <= 0 || sides.iter().any(|side| *side < 0) {
            continue;
        }
        let of_face: i128 = sides.iter().zip([a, b, c]).map(|(side, corner)| side * corner[2]).sum();
        if of_face > (depth + tolerance * denominator) * whole {
            hidden = [hidden[0] || sides.iter().all(|side| *side > 0), true];
        }
    }
    hidden
}

/// Whether the part of an edge is hidden that has a point; `None` where that part is not longer than two units.
fn part_at<S: ScreenPrecision>(
    parts: &[LinePart<S>],
    ends: [[i128; 3]; 2],
    (step, steps): (i128, i128),
) -> Option<bool> {
    let [from, to] = ends;
    let axis = longer_axis(ends);
    let sign = (to[axis] - from[axis]).signum();
    let at = along(ends, (step, steps))[axis] * sign;
    let ends = |part: &LinePart<S>| part.ends.map(|end| i128::from([end.x_units(), end.y_units()][axis]));
    let part = parts.iter().find(|part| at <= ends(part)[1] * sign * steps).unwrap();
    let [start, end] = ends(part);
    ((end - start).abs() > 2).then_some(part.is_hidden)
}

/// The axis along which an edge has its length.
fn longer_axis([from, to]: [[i128; 3]; 2]) -> usize {
    usize::from((to[1] - from[1]).abs() > (to[0] - from[0]).abs())
}

/// Compares the parts of all edges with depths along them. Returns how many samples were hidden and visible.
fn check_depths<L: Look>(
    prepared: &Prepared<'_, '_, L>,
    tables: &[&[Edge]],
    parts: &[LinePart<L::Precision>],
) -> [usize; 2] {
    let faces = snapped(prepared);
    let mut rest = parts;
    let mut samples = [0; 2];
    for (model, table) in tables.iter().enumerate() {
        for edge in prepared.edges(model, table) {
            let ends = edge
                .ends
                .map(|end| [end.point.x_units(), end.point.y_units(), end.depth.units()].map(i128::from));
            let count = rest
                .iter()
                .take_while(|part| (part.model, part.edge) == (model, Some(edge.index)))
                .count();
            let (of_edge, others) = rest.split_at(count);
            rest = others;
            let [from, to] = edge.ends.map(|end| end.point);
            if from == to {
                assert_eq!(of_edge, []);
                continue;
            }
            assert_eq!((of_edge[0].ends[0], of_edge[count - 1].ends[1]), (from, to));
            for pair in of_edge.windows(2) {
                assert_eq!(pair[0].ends[1], pair[1].ends[0]);
                assert_ne!(pair[0].is_hidden, pair[1].is_hidden);
            }
            // Points one unit apart.
            let axis = longer_axis(ends);
            let steps = (ends[1][axis] - ends[0][axis]).abs();
            for step in (0..=steps).step_by((steps / SAMPLES).max(1) as usize) {
                let Some(found) = part_at(of_edge, ends, (step, steps)) else {
                    continue;
                };
                // The ends of parts are rounded, and a part that is too short is left out.
                let near = [0, -1, 1, -2, 2].map(|way| (step + way).max(0).min(steps));
                let agrees = near.into_iter().any(|step| {
                    let [is_certain, may_be] =
                        is_hidden(&faces, along(ends, (step, steps)), steps, tolerance::<L::Depth>());
                    if found { may_be } else { !is_certain }
                });
                assert!(
                    agrees,
                    "model {model}, {edge:?} at {step} of {steps}: {found}, {of_edge:?}"
                );
                samples[usize::from(!found)] += 1;
            }
        }
    }
    // Edges that are turned away.
    assert!(rest.iter().all(|part| part.is_hidden));
    samples
}

/// Draws models with memory for all and with less; returns how many samples are hidden and visible.
fn check<S: Format<D>, D: DepthWidth>(models: &[Model<'_, Rgb888>], tables: &[&[Edge]], camera: &Camera) -> [usize; 2] {
    let mut memory = Box::new(MemoryOf::<S, D>::new());
    let prepared = memory.prepare(camera, models).unwrap();
    let mut by_rays = Appel::<0, 0, 0>::new();
    let found = parts_by(&prepared, tables, &mut by_rays);
    assert_eq!(by_rays.rays(), by_rays.edges());
    let mut carried = Appel::<2_000, 40, 4_000>::new();
    assert_eq!(parts_by(&prepared, tables, &mut carried), found);
    assert!(carried.rays() <= carried.edges() && carried.edges() == by_rays.edges());
    assert_eq!(parts_by(&prepared, tables, &mut Appel::<40, 1, 30>::new()), found);
    assert_eq!(parts_by(&prepared, tables, &mut Appel::<3, 2, 1>::new()), found);
    check_intersections(&prepared, tables, &found);
    check_depths(&prepared, tables, &found)
}

/// Intersections follow the edges, whatever room there is, and are those that face against segment hands over.
fn check_intersections<L: Look>(
    prepared: &Prepared<'_, '_, L>,
    tables: &[&[Edge]],
    of_edges: &[LinePart<L::Precision>],
) {
    let mut by_rays = Appel::<0, 0, 0, true>::new();
    let parts = parts_by(prepared, tables, &mut by_rays);
    assert_eq!(by_rays.rays(), by_rays.edges());
    let mut carried = Appel::<2_000, 40, 4_000, true>::new();
    assert_eq!(parts_by(prepared, tables, &mut carried), parts);
    let (intersections, edges): (Vec<_>, Vec<_>) =
        parts.into_iter().partition(|part| part.kind == PartKind::Intersection);
    assert_eq!(edges, of_edges);
    let mut by_segments = FaceAgainstSegment::<1_000, 8, true>::new();
    let expected = parts_by(prepared, tables, &mut by_segments);
    let expected: Vec<_> = expected
        .into_iter()
        .filter(|part| part.kind == PartKind::Intersection)
        .collect();
    let whole = |parts: &[LinePart<L::Precision>]| parts.iter().map(length).sum::<f64>();
    let (length, of_segments) = (whole(&intersections), whole(&expected));
    // Ends of parts are rounded.
    let rounding = 1.5 * (intersections.len() + expected.len()) as f64;
    assert!((length - of_segments).abs() <= rounding, "{length}, {of_segments}");
    assert!(intersections.iter().all(|part| part.edge.is_none()));
}

/// The length of a part in units.
fn length<S: ScreenPrecision>(part: &LinePart<S>) -> f64 {
    let [from, to] = part.ends.map(|end| [end.x_units(), end.y_units()].map(f64::from));
    (to[0] - from[0]).hypot(to[1] - from[1])
}

/// Draws meshes with every precision and width of depths.
fn check_formats(meshes: Vec<Mesh>, pose: Pose, edge: EdgeOf) -> [usize; 2] {
    let tables: Vec<_> = meshes.iter().map(|mesh| edges(mesh, edge)).collect();
    let tables: Vec<_> = tables.iter().map(Vec::as_slice).collect();
    let (scene, camera) = (Scene::new(meshes), camera(area(64, 48)));
    let models = scene.models(pose);
    if !is_quick() {
        check::<Sub4, u32>(&models, &tables, &camera);
        check::<Sub8, u16>(&models, &tables, &camera);
    }
    check::<Sub8, u32>(&models, &tables, &camera);
    check::<Sub4, u16>(&models, &tables, &camera)
}

/// How much of each edge is hidden, in pixels, by the model and the index of the edge.
fn hidden_lengths(parts: &[LinePart<Sub4>]) -> BTreeMap<(usize, Option<usize>), f64> {
    let mut lengths = BTreeMap::new();
    for part in parts {
        let length = length(part) / 16.0;
        *lengths.entry((part.model, part.edge)).or_default() += if part.is_hidden { length } else { 0.0 };
    }
    lengths
}

fn is_clockwise<S: SubPixel>([a, b, c]: [SubPoint<S>; 3]) -> bool {
    let side = |from: SubPoint<S>, to: SubPoint<S>| [to.x_units() - from.x_units(), to.y_units() - from.y_units()];
    let ([x1, y1], [x2, y2]) = (side(a, b), side(a, c));
    i64::from(x1) * i64::from(y2) > i64::from(x2) * i64::from(y1)
}

/// The hidden part of no edge differs by as much as a pixel from what face against segment finds. Returns how many edges were
/// walked, and how many rays were cast.
fn check_with_face_against_segment(meshes: Vec<Mesh>, pose: Pose, edge: EdgeOf) -> [u32; 2] {
    let tables: Vec<_> = meshes.iter().map(|mesh| edges(mesh, edge)).collect();
    let tables: Vec<_> = tables.iter().map(Vec::as_slice).collect();
    let (scene, camera) = (Scene::new(meshes), camera(area(64, 48)));
    let models = scene.models(pose);
    let mut memory = Box::new(MemoryOf::<Sub4, u16>::new());
    let prepared = memory.prepare(&camera, &models).unwrap();
    let mut method = Appel::<300, 8, 2_000>::new();
    check_by_search(&prepared, &tables, [0, 0, 64, 48], "Appel", &mut method);
    // Behind a solid: few of the sides of its faces are contours.
    let seen = prepared
        .faces()
        .filter(|face| is_clockwise(face.corners.map(|corner| corner.point)))
        .count();
    assert!(
        method.contours() > 3 && method.contours() < seen.max(7),
        "{} of {seen}",
        method.contours()
    );
    let lengths = hidden_lengths(&parts_by(&prepared, &tables, &mut method));
    let mut other = FaceAgainstSegment::<1_000, 8>::new();
    let expected = hidden_lengths(&parts_by(&prepared, &tables, &mut other));
    assert!(lengths.keys().eq(expected.keys()));
    for ((edge, length), expected) in lengths.iter().zip(expected.values()) {
        assert!((length - expected).abs() < 1.0, "{edge:?}: {length}, {expected}");
    }
    [method.edges(), method.rays()]
}

#[test]
fn standard_scenes() {
    let (mut samples, mut edges, mut rays) = ([0; 2], 0, 0);
    for frame in 0..cases(1, 16) as u16 {
        let pose = standard_pose(frame * 5 + 1);
        let scenes: [(_, EdgeOf); 5] = [
            (vec![meshes::torus(), meshes::cube(0.5)], Edge::crease),
            (vec![meshes::torus(), meshes::cube(1.2)], Edge::smooth),
            (vec![meshes::icosphere(1.2), meshes::cube(0.9)], Edge::crease),
            (vec![meshes::icosphere(1.2)], Edge::smooth),
            (vec![meshes::cube(1.0)], Edge::crease),
        ];
        for (meshes, edge) in scenes.into_iter().step_by(by_depth(3, 1, 1)) {
            let [hidden, visible] = check_formats(meshes.clone(), pose, edge);
            samples = [samples[0] + hidden, samples[1] + visible];
            let [of_scene, cast] = check_with_face_against_segment(meshes, pose, edge);
            (edges, rays) = (edges + of_scene, rays + cast);
        }
    }
    assert!(
        samples.into_iter().all(|samples| samples > 5_000 / by_depth(3, 1, 1)),
        "{samples:?}"
    );
    // Nearly all edges begin where another one ends.
    assert!(20 * rays < edges, "{rays} rays for {edges} edges");
}

/// An edge table is not needed for a model to hide what is behind it.
#[test]
fn faces_without_edges_hide_as_well() {
    let (torus, cube) = (meshes::torus(), meshes::cube(0.5));
    let table = edges(&cube, Edge::crease);
    let meshes = vec![torus, cube];
    let (scene, camera) = (Scene::new(meshes), camera(area(64, 48)));
    let models = scene.models(standard_pose(1));
    let hidden = check::<Sub4, u16>(&models, &[&[], &table], &camera)[0];
    assert!(hidden > 10, "{hidden}");
}

/// The numbers of an open scene whose sides all coincide with others on the screen: layers of the same quad.
#[test]
fn layers_hide_all_but_the_first() {
    let mut mesh = Mesh::new(vec![], vec![]);
    for layer in 0..6 {
        let first = mesh.vertices.len() as u16;
        let z = 40 * layer;
        // Farther and larger, in the same rays.
        let side = |at: i16| at * (1400 + z) / 10;
        mesh.vertices
            .extend([[-1, -1], [-1, 1], [1, 1], [1, -1]].map(|[x, y]| [side(3 * x), side(2 * y), z]));
        mesh.faces
            .extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
    }
    let pose = Pose::new(Rotation::IDENTITY, at(0, 0, 1400));
    let samples = check_formats(vec![mesh], pose, Edge::crease);
    assert!(samples.into_iter().all(|samples| samples > 50), "{samples:?}");
}

proptest! {
    #![proptest_config(config(cases(12, 125)))]

    /// Faces that go through each other.
    #[test]
    fn interpenetrating_faces(mesh in faces(700, 14), pose in pose(1300..2500)) {
        check_formats(vec![mesh], pose, Edge::crease);
    }

    /// Around the camera: cut by the near plane and the guard band.
    #[test]
    fn faces_around_the_camera(mesh in faces(4000, 6), pose in pose(-500..800)) {
        check_formats(vec![mesh], pose, Edge::crease);
    }

    /// Small faces, slivers and those seen from the side.
    #[test]
    fn small_faces(mesh in faces(90, 30), pose in pose(200..900)) {
        check_formats(vec![mesh], pose, Edge::crease);
    }

    /// Few different corners, so that much coincides on the screen.
    #[test]
    fn faces_with_corners_on_a_grid(
        corners in prop::collection::vec(prop::array::uniform3((-2i16..=2, -2i16..=2, -1i16..=1)), 1..16),
    ) {
        let vertices = corners.iter().flat_map(|face| face.map(|(x, y, z)| [300 * x, 300 * y, 100 * z])).collect();
        let faces = (0..corners.len() as u16).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect();
        let pose = Pose::new(Rotation::IDENTITY, at(0, 0, 1400));
        check_formats(vec![Mesh::new(vertices, faces).two_sided()], pose, Edge::crease);
    }
}
