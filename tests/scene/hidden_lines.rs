//! Hidden lines against a search in `f64`: along each edge, a point is hidden where a face covers it and is nearer.

use embedded_graphics::pixelcolor::Rgb888;
use fixed::types::I2F14;
use proptest::prelude::*;
use zrow::{
    geometry::{Sub4, Sub8, SubPixel, TooSmall},
    scene::{Camera, DepthWidth, Edge, EdgeKind, FaceSet, Look, Model, Pose, Prepared, Rotation, ScreenPrecision},
    visible::{Appel, FaceAgainstSegment, HiddenLines, LinePart, PartKind, Roberts},
};

use crate::common::meshes::{self, Mesh};
use crate::common::{by_depth, cases, config};
use crate::numbered_scene::{Format, Scene, area, picture};
use crate::random_faces::{faces, pose};
use crate::snapped_faces::{at, camera, standard_pose};
use crate::visibility::{HEIGHT, MemoryOf, WIDTH};

/// A point in units of the precision, and its depth in units.
type Point3 = [f64; 3];

/// What the reference says of a point of an edge.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
enum Truth {
    Hidden,
    Visible,
    /// It is as near as a face, within the tolerance, or on the border of a face.
    Either,
}

/// Lengths in pixels, of all edges in the viewport.
#[derive(Debug, Default, Copy, Clone, PartialEq)]
pub struct Lengths {
    pub hidden: f64,
    pub visible: f64,
    /// Where the reference allows either.
    pub either: f64,
    /// Of the intersections that are visible.
    pub intersections: f64,
}

impl Lengths {
    pub fn plus(self, other: Self) -> Self {
        Self {
            hidden: self.hidden + other.hidden,
            visible: self.visible + other.visible,
            either: self.either + other.either,
            intersections: self.intersections + other.intersections,
        }
    }
}

/// The faces of a frame that are seen from the front, in floating point.
struct Reference {
    faces: Vec<[Point3; 3]>,
    /// Units of depth by which what lies in one plane may seem to be apart, besides what a unit of position makes.
    units: f64,
    viewport: [f64; 4],
    unit: f64,
}

fn point_of<S: SubPixel>(point: &zrow::geometry::SubPoint<S>) -> [f64; 2] {
    [f64::from(point.x_units()), f64::from(point.y_units())]
}

/// Twice the area of a triangle; positive where its corners run clockwise.
fn cross(a: Point3, b: Point3, c: Point3) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

fn length(from: Point3, to: Point3) -> f64 {
    (to[0] - from[0]).hypot(to[1] - from[1])
}

fn between(from: Point3, to: Point3, t: f64) -> Point3 {
    [0, 1, 2].map(|axis| from[axis] + t * (to[axis] - from[axis]))
}

impl Reference {
    fn new<L: Look>(prepared: &Prepared<'_, '_, L>, viewport: [i32; 4]) -> Self {
        let unit = f64::from(1 << L::Precision::FRACTION_BITS);
        let corners = prepared.faces().map(|face| {
            face.corners.map(|corner| {
                let [x, y] = point_of(&corner.point);
                [x, y, f64::from(corner.depth.units())]
            })
        });
        Self {
            faces: corners.filter(|[a, b, c]| cross(*a, *b, *c) > 0.0).collect(),
            units: if L::Depth::FRACTION_BITS == 16 { 2.0 } else { 8.0 },
            viewport: viewport.map(|side| f64::from(side) * unit),
            unit,
        }
    }

    fn is_on_screen(&self, [x, y, _]: Point3) -> bool {
        let [left, top, right, bottom] = self.viewport;
        (left..right).contains(&x) && (top..bottom).contains(&y)
    }

    /// How much nearer a face is at a point than the point, what of that is within the tolerance, and how far the point is
    /// within the border.
    fn before(&self, [a, b, c]: [Point3; 3], point: Point3) -> [f64; 3] {
        let area = cross(a, b, c);
        let weights = [cross(b, c, point), cross(c, a, point), cross(a, b, point)];
        let depth = (weights[0] * a[2] + weights[1] * b[2] + weights[2] * c[2]) / area;
        let slope = |axis: usize| {
            let part = |from: Point3, to: Point3, depth: f64| (to[axis] - from[axis]) * depth;
            (part(b, c, a[2]) + part(c, a, b[2]) + part(a, b, c[2])).abs() / area
        };
        let within = weights[0] / length(b, c);
        let within = within.min(weights[1] / length(c, a)).min(weights[2] / length(a, b));
        [depth - point[2], self.units + slope(0) + slope(1), within]
    }

    fn truth(&self, ends: [Point3; 2], point: Point3) -> Truth {
        if !self.is_on_screen(point) {
            return Truth::Either;
        }
        let mut truth = Truth::Visible;
        for face in &self.faces {
            if ends.iter().all(|end| face.contains(end)) {
                continue;
            }
            let [nearer, tolerance, within] = self.before(*face, point);
            if within > 0.01 && nearer > tolerance * 1.000_001 {
                return Truth::Hidden;
            }
            if within > -0.01 && nearer > -0.001 {
                truth = Truth::Either;
            }
        }
        truth
    }

    /// Compares the parts of a line with the search; adds up the lengths.
    fn compare<S: ScreenPrecision>(&self, ends: [Point3; 2], parts: &[LinePart<S>], name: &str) -> Lengths {
        let [from, to] = ends;
        let whole = length(from, to);
        let steps = (4.0 * whole / self.unit).ceil().max(1.0);
        let step = whole / self.unit / steps;
        let (mut lengths, mut wrong) = (Lengths::default(), 0);
        for number in 0..=steps as u32 {
            let point = between(from, to, f64::from(number) / steps);
            let way = f64::from(number) / steps * whole;
            let part = parts
                .iter()
                .find(|part| length(from, flat(point_of(&part.ends[1]))) >= way - 0.8)
                .unwrap_or_else(|| panic!("{name}: no part at {way} of {whole}: {parts:?}"));
            let truth = self.truth(ends, point);
            if self.is_on_screen(point) {
                match truth {
                    Truth::Either => lengths.either += step,
                    Truth::Hidden => lengths.hidden += step,
                    Truth::Visible => lengths.visible += step,
                }
                if part.kind == PartKind::Intersection && !part.is_hidden {
                    lengths.intersections += step;
                }
            }
            let is_wrong = match truth {
                Truth::Either => false,
                Truth::Hidden => !part.is_hidden,
                Truth::Visible => part.is_hidden,
            };
            wrong = if is_wrong { wrong + 1 } else { 0 };
            let run = f64::from(wrong - 1) * step;
            assert!(
                run <= 1.0,
                "{name}: {run} pixels should be {truth:?} at {point:?} of {ends:?} in {parts:?}"
            );
        }
        lengths
    }
}

fn flat([x, y]: [f64; 2]) -> Point3 {
    [x, y, 0.0]
}

/// The ends of parts that follow each other lie on a line, and hidden and visible ones take turns.
fn check_chain<S: ScreenPrecision>([from, to]: [Point3; 2], parts: &[LinePart<S>], name: &str) {
    let (first, last) = (parts.first().unwrap(), parts.last().unwrap());
    assert_eq!(point_of(&first.ends[0]), [from[0], from[1]], "{name}");
    assert_eq!(point_of(&last.ends[1]), [to[0], to[1]], "{name}");
    for pair in parts.windows(2) {
        assert_eq!(pair[0].ends[1], pair[1].ends[0], "{name}");
        assert_ne!(pair[0].is_hidden, pair[1].is_hidden, "{name}");
    }
    for part in parts {
        assert_ne!(part.ends[0], part.ends[1], "{name}");
        for end in part.ends.map(|end| point_of(&end)) {
            // Each coordinate is rounded by half a unit.
            assert!(cross(from, to, flat(end)).abs() / length(from, to) < 0.72, "{name}");
        }
    }
}

/// The parts of all edges by a method.
pub fn parts_by<L: Look>(
    prepared: &Prepared<'_, '_, L>,
    tables: &[&[Edge]],
    method: &mut impl HiddenLines<L::Depth>,
) -> Vec<LinePart<L::Precision>> {
    let mut parts = Vec::new();
    prepared.visible_parts(method, tables, |part| parts.push(part)).unwrap();
    parts
}

/// Compares the parts of a method with a search along each edge. `viewport` has the left, upper, right and lower side.
pub fn check<L: Look>(
    prepared: &Prepared<'_, '_, L>,
    tables: &[&[Edge]],
    viewport: [i32; 4],
    name: &str,
    method: &mut impl HiddenLines<L::Depth>,
) -> Lengths {
    let parts = parts_by(prepared, tables, method);
    let reference = Reference::new(prepared, viewport);
    let mut lengths = Lengths::default();
    let mut drawn = Vec::new();
    for (model, table) in tables.iter().enumerate() {
        for edge in prepared.edges(model, table) {
            let ends = edge.ends.map(|end| {
                let [x, y] = point_of(&end.point);
                [x, y, f64::from(end.depth.units())]
            });
            let key = (model, Some(edge.index));
            let start = parts.iter().position(|part| (part.model, part.edge) == key);
            if length(ends[0], ends[1]) == 0.0 {
                assert_eq!(start, None, "{name}");
                continue;
            }
            let start = start.unwrap_or_else(|| panic!("{name}: edge {key:?} is missing"));
            let of_edge = parts[start..]
                .split(|part| (part.model, part.edge) != key)
                .next()
                .unwrap();
            let count = parts.iter().filter(|part| (part.model, part.edge) == key).count();
            assert_eq!(of_edge.len(), count, "{name}: the parts of an edge follow each other");
            let kind = match (edge.kind, edge.is_silhouette) {
                (EdgeKind::Boundary, _) => PartKind::Boundary,
                (_, true) => PartKind::Silhouette,
                (_, false) => PartKind::Crease,
            };
            assert!(of_edge.iter().all(|part| part.kind == kind), "{name}");
            check_chain(ends, of_edge, name);
            lengths = lengths.plus(reference.compare(ends, of_edge, name));
            drawn.push(key);
        }
    }
    for part in parts.iter().filter(|part| part.kind != PartKind::Intersection) {
        let key = (part.model, part.edge);
        assert!(
            part.is_hidden || drawn.contains(&key),
            "{name}: {part:?} is turned away"
        );
    }
    lengths.plus(check_intersections(&reference, &parts, name))
}

/// Intersections lie on two faces, and are hidden as any edge.
fn check_intersections<S: ScreenPrecision>(reference: &Reference, parts: &[LinePart<S>], name: &str) -> Lengths {
    let mut lengths = Lengths::default();
    for part in parts.iter().filter(|part| part.kind == PartKind::Intersection) {
        assert_eq!(part.edge, None);
        let [from, to] = part.ends.map(|end| flat(point_of(&end)));
        let middle = between(from, to, 0.5);
        // Two faces have about the same depth there.
        let near = reference.faces.iter().filter_map(|face| {
            let [depth, tolerance, within] = reference.before(*face, middle);
            (within > -1.0).then_some([depth, tolerance])
        });
        let near: Vec<_> = near.collect();
        let pairs = near.iter().enumerate().flat_map(|(number, one)| {
            let others = near[number + 1..].iter();
            let meeting = others.filter(|other| (one[0] - other[0]).abs() < one[1] + other[1]);
            meeting.flat_map(|other| [one[0], other[0]])
        });
        let truths: Vec<_> = pairs
            .map(|depth| {
                let on_face = [middle[0], middle[1], depth];
                reference.truth([on_face; 2], on_face)
            })
            .collect();
        assert!(!truths.is_empty(), "{name}: no faces meet at {middle:?}");
        let wrong = if part.is_hidden { Truth::Visible } else { Truth::Hidden };
        // A part that is shorter than a pixel may lie beside what hides it.
        let is_short = length(from, to) <= reference.unit;
        let is_right = is_short || truths.iter().any(|truth| *truth != wrong);
        assert!(is_right, "{name}: {truths:?}, {part:?}");
        if !part.is_hidden && reference.is_on_screen(middle) {
            lengths.intersections += length(from, to) / reference.unit;
        }
    }
    lengths
}

/// The edges of a mesh of so many faces, creases at 30 degrees.
pub fn table<const FACES: usize>(mesh: &Mesh) -> Vec<Edge> {
    let faces: &[_; FACES] = mesh.faces[..].try_into().unwrap();
    let count = FaceSet::count_edges(&mesh.vertices, faces);
    let edges = FaceSet::find_edges::<FACES, 900>(&mesh.vertices, faces, I2F14::lit("0.866")).unwrap();
    edges[..count].to_vec()
}

/// The sides of all faces, each as a boundary.
pub fn sides(mesh: &Mesh) -> Vec<Edge> {
    let sides = (0..)
        .zip(&mesh.faces)
        .flat_map(|(face, &[a, b, c])| [[a, b], [b, c], [c, a]].map(|ends| Edge::boundary(ends, face)));
    sides.collect()
}

/// Compares face against segment with stacks of several sizes with the search.
fn check_stacks<S: Format<D>, D: DepthWidth>(
    models: &[Model<'_, Rgb888>],
    tables: &[&[Edge]],
    camera: &Camera,
) -> (Lengths, u32) {
    let mut memory = Box::new(MemoryOf::<S, D>::new());
    let prepared = memory.prepare(camera, models).unwrap();
    let viewport = [0, 0, WIDTH as i32, HEIGHT as i32];
    let mut method = FaceAgainstSegment::<2_000, 32, true>::new();
    let lengths = check(&prepared, tables, viewport, "stack of 32", &mut method);
    assert_eq!(method.segments_repeated(), 0);
    let parts = parts_by(&prepared, tables, &mut method);
    let mut without = FaceAgainstSegment::<2_000, 0, true>::new();
    assert_eq!(parts_by(&prepared, tables, &mut without), parts, "no stack");
    assert_eq!(
        parts_by(&prepared, tables, &mut FaceAgainstSegment::<2_000, 1, true>::new()),
        parts,
        "stack of 1"
    );
    assert_eq!(
        parts_by(&prepared, tables, &mut FaceAgainstSegment::<2_000, 2, true>::new()),
        parts,
        "stack of 2"
    );
    let edges: Vec<_> = parts
        .into_iter()
        .filter(|part| part.kind != PartKind::Intersection)
        .collect();
    assert_eq!(
        parts_by(&prepared, tables, &mut FaceAgainstSegment::<2_000, 3>::new()),
        edges,
        "no intersections"
    );
    (lengths, without.segments_repeated())
}

/// Compares the parts of meshes with the search, with every precision and width of depths.
fn check_formats(meshes: Vec<Mesh>, tables: &[&[Edge]], pose: Pose) -> (Lengths, u32) {
    let (scene, camera) = (Scene::new(meshes), camera(area(WIDTH, HEIGHT)));
    let models = scene.models(pose);
    check_stacks::<Sub8, u32>(&models, tables, &camera);
    check_stacks::<Sub4, u32>(&models, tables, &camera);
    check_stacks::<Sub8, u16>(&models, tables, &camera);
    check_stacks::<Sub4, u16>(&models, tables, &camera)
}

#[test]
fn hidden_lines_of_standard_scenes() {
    let (torus, ball, cube) = (meshes::torus(), meshes::icosphere(1.4), meshes::cube(0.5));
    let (of_torus, of_ball, of_cube) = (table::<576>(&torus), table::<320>(&ball), table::<12>(&cube));
    let (mut lengths, mut repeated) = (Lengths::default(), 0);
    let frames = cases(4, 16) as u16;
    for frame in 0..frames {
        let pose = standard_pose(frame * 5 + 1);
        for (meshes, tables) in [
            (vec![torus.clone(), cube.clone()], &[&of_torus[..], &of_cube][..]),
            (vec![ball.clone()], &[&of_ball[..]]),
            (vec![meshes::cube(1.0)], &[&of_cube]),
        ] {
            let (found, again) = check_formats(meshes, tables, pose);
            assert!(found.visible > 20.0, "{found:?}");
            (lengths, repeated) = (lengths.plus(found), repeated + again);
        }
    }
    assert!(
        lengths.hidden > 25.0 * f64::from(frames) && repeated > 0,
        "{lengths:?} {repeated}"
    );
    assert!(lengths.either < 0.1 * (lengths.hidden + lengths.visible), "{lengths:?}");
}

/// Where the picture of two solids goes from one to the other by a penetration, there is a visible part of an intersection.
fn check_penetration(meshes: Vec<Mesh>, tables: &[&[Edge]], poses: &[Pose]) -> usize {
    let of_first = meshes[0].faces.len();
    let (scene, camera) = (Scene::new(meshes), camera(area(WIDTH, HEIGHT)));
    let mut models = scene.models(poses[0]);
    for (model, pose) in models.iter_mut().zip(poses) {
        model.pose = *pose;
    }
    let mut memory = Box::new(MemoryOf::<Sub4, u16>::new());
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    let viewport = [0, 0, WIDTH as i32, HEIGHT as i32];
    let mut by_segments = FaceAgainstSegment::<1_000, 8, true>::new();
    let of_segments = check(&prepared, tables, viewport, "by segments", &mut by_segments);
    let mut by_numbers = Appel::<2_000, 40, 4_000, true>::new();
    let of_numbers = check(&prepared, tables, viewport, "by numbers", &mut by_numbers);
    let mut by_solids = Roberts::<2, 1_200>::new();
    let of_solids = check(&prepared, tables, viewport, "by solids", &mut by_solids);
    // In pixels, as seen.
    let [one, two, three] = [of_segments, of_numbers, of_solids].map(|lengths| lengths.intersections);
    assert!(
        (one - two).abs() < 1.0 + 0.02 * one && (two - three).abs() < 1.0 + 0.02 * two,
        "{one} {two} {three}"
    );
    let all_parts = [
        parts_by(&prepared, tables, &mut by_segments),
        parts_by(&prepared, tables, &mut by_numbers),
        parts_by(&prepared, tables, &mut by_solids),
    ];
    let owners = picture(&mut prepared, area(WIDTH, HEIGHT));
    let reference = Reference::new(&prepared, viewport);
    let faces: Vec<_> = prepared.faces().collect();
    let corners = |order: usize| {
        let face = faces.iter().find(|face| face.order == order).unwrap();
        face.corners.map(|corner| {
            let [x, y] = point_of(&corner.point);
            [x, y, f64::from(corner.depth.units())]
        })
    };
    let mut found = 0;
    for (index, pair) in owners.windows(2).enumerate() {
        let (x, y) = (index % WIDTH as usize, index / WIDTH as usize);
        let (&[Some(one), Some(other)], true) = (pair, x + 1 < WIDTH as usize) else {
            continue;
        };
        if (one < of_first) == (other < of_first) {
            continue;
        }
        // Both faces cover both pixels, and in each the other one is nearer.
        let pixels = [x, x + 1].map(|x| [16.0 * x as f64, 16.0 * y as f64, 0.0]);
        let depths = pixels.map(|pixel| [one, other].map(|order| reference.before(corners(order), pixel)));
        let crosses = (depths[0][0][0] > depths[0][1][0]) != (depths[1][0][0] > depths[1][1][0]);
        if !crosses || depths.as_flattened().iter().any(|[.., within]| *within < 0.0) {
            continue;
        }
        found += 1;
        let middle = between(pixels[0], pixels[1], 0.5);
        for parts in &all_parts {
            let nearest = nearest_intersection(parts, middle);
            assert!(
                nearest <= 16.0,
                "the solids meet at {middle:?}, {nearest} units from any intersection"
            );
        }
    }
    found
}

/// How far a point is from the nearest visible part of an intersection, in units.
fn nearest_intersection<S: ScreenPrecision>(parts: &[LinePart<S>], point: Point3) -> f64 {
    let visible = parts
        .iter()
        .filter(|part| part.kind == PartKind::Intersection && !part.is_hidden);
    let distances = visible.map(|part| {
        let [from, to] = part.ends.map(|end| flat(point_of(&end)));
        let square = length(from, to).powi(2);
        let way = (point[0] - from[0]) * (to[0] - from[0]) + (point[1] - from[1]) * (to[1] - from[1]);
        length(point, between(from, to, (way / square).clamp(0.0, 1.0)))
    });
    distances.fold(f64::MAX, f64::min)
}

#[test]
fn penetrating_solids_show_their_intersection() {
    let cube = meshes::cube(0.8);
    let of_cube = table::<12>(&cube);
    let mut found = 0;
    let apart = by_depth(3, 1, 1);
    for frame in (0..8).step_by(apart) {
        let (one, mut other) = (standard_pose(frame * 7 + 2), standard_pose(frame * 11 + 40));
        other.translation = at(250, 150, 3 * 512 - 100);
        found += check_penetration(vec![cube.clone(), cube.clone()], &[&of_cube, &of_cube], &[one, other]);
    }
    assert!(found > 40 / apart, "{found}");
    let torus = meshes::torus();
    let (of_torus, mut of_both) = (table::<576>(&torus), 0);
    for frame in (0..6).step_by(by_depth(2, 1, 1)) {
        let mut turned = standard_pose(3 + frame);
        turned.translation = at(450, 100, 3 * 512 - 200);
        let tables = [&of_torus[..], &of_cube];
        let poses = [standard_pose(10 * frame), turned];
        of_both += check_penetration(vec![torus.clone(), cube.clone()], &tables, &poses);
    }
    assert!(of_both > 20 / by_depth(3, 1, 1), "{of_both}");
}

/// A cube that stands on a table hides nothing of the table's plane, and the table nothing of the cube's lower edges.
#[test]
fn edges_in_the_plane_of_a_face_are_visible() {
    let cube = meshes::cube(0.5);
    let table_top = Mesh::new(
        vec![
            [-900, -256, -700],
            [900, -256, -700],
            [900, -256, 900],
            [-900, -256, 900],
            [77, -256, 100],
        ],
        vec![[0, 4, 1], [1, 4, 2], [2, 4, 3], [3, 4, 0]],
    )
    .two_sided();
    let of_cube = table::<12>(&cube);
    let scene = Scene::new(vec![cube.clone(), table_top]);
    let (mut checked, camera) = (0, camera(area(WIDTH, HEIGHT)));
    for turn in 0..32u16 {
        let rotation = Rotation::about_y(fixed::types::U0F16::from_bits(turn * 2_011));
        let rotation = rotation.then(&Rotation::about_x(fixed::types::U0F16::from_bits(
            0u16.wrapping_sub(2_000 + turn * 300),
        )));
        let models = scene.models(Pose::new(rotation, at(0, 100, 1800)));
        checked += check_lower_edges::<Sub4, u16>(&models, &camera, &cube, &of_cube);
        checked += check_lower_edges::<Sub8, u16>(&models, &camera, &cube, &of_cube);
        checked += check_lower_edges::<Sub4, u32>(&models, &camera, &cube, &of_cube);
        checked += check_lower_edges::<Sub8, u32>(&models, &camera, &cube, &of_cube);
    }
    assert!(checked >= 32 * 4, "{checked}");
}

/// Returns how many lower edges of a cube have a visible part; each of them is visible as a whole.
fn check_lower_edges<S: Format<D>, D: DepthWidth>(
    models: &[Model<'_, Rgb888>],
    camera: &Camera,
    cube: &Mesh,
    edges: &[Edge],
) -> usize {
    let mut memory = Box::new(MemoryOf::<S, D>::new());
    let prepared = memory.prepare(camera, models).unwrap();
    let parts = parts_by(&prepared, &[edges], &mut FaceAgainstSegment::<20, 4>::new());
    // The normals of the cube's sides point away, those of edges that are seen from the front are silhouettes or creases of
    // the front; a lower edge is drawn where its upright side is seen.
    let lower = prepared.edges(0, edges).filter(|edge| {
        let vertices = edges[edge.index].vertices();
        vertices.iter().all(|vertex| cube.vertices[usize::from(*vertex)][1] < 0)
    });
    let mut count = 0;
    for edge in lower {
        count += 1;
        let of_edge: Vec<_> = parts.iter().filter(|part| part.edge == Some(edge.index)).collect();
        assert!(of_edge.iter().all(|part| !part.is_hidden), "{of_edge:?}");
    }
    count
}

#[test]
fn scenes_without_edges_or_faces_have_no_parts() {
    let (scene, camera) = (Scene::new(vec![meshes::cube(1.0)]), camera(area(WIDTH, HEIGHT)));
    let models = scene.models(standard_pose(3));
    let of_cube = table::<12>(&meshes::cube(1.0));
    let mut memory = Box::new(MemoryOf::<Sub4, u16>::new());
    let mut method = FaceAgainstSegment::<4, 0, true>::new();
    assert!(parts_by(&memory.prepare(&camera, &[]).unwrap(), &[&of_cube], &mut method).is_empty());
    let prepared = memory.prepare(&camera, &models).unwrap();
    assert!(parts_by(&prepared, &[], &mut method).is_empty());
    assert!(parts_by(&prepared, &[&[]], &mut method).is_empty());
    assert!(parts_by(&prepared, &[&[], &of_cube], &mut method).is_empty());
    // Vertices and faces that are not there.
    let wrong = [
        Edge::boundary([0, 99], 0),
        Edge::crease([0, 1], [98, 99]),
        Edge::smooth([70, 80], [0, 99]),
    ];
    assert!(parts_by(&prepared, &[&wrong], &mut method).is_empty());

    // The cube shows four of its faces' triangles in this pose.
    let mut small = FaceAgainstSegment::<3, 9>::new();
    let error = prepared.visible_parts(&mut small, &[&of_cube], |part| panic!("{part:?}"));
    assert_eq!(error, Err(TooSmall::Faces(4)));
    assert!(!parts_by(&prepared, &[&of_cube], &mut method).is_empty());
}

/// The faces of a model without a table of edges hide those of others.
#[test]
fn a_model_without_edges_hides_others() {
    let cube = meshes::cube(0.3);
    let of_cube = table::<12>(&cube);
    let scene = Scene::new(vec![cube, meshes::cube(1.0)]);
    let models = scene.models(standard_pose(3));
    let mut memory = Box::new(MemoryOf::<Sub4, u16>::new());
    let prepared = memory.prepare(&camera(area(WIDTH, HEIGHT)), &models).unwrap();
    let parts = parts_by(&prepared, &[&of_cube], &mut FaceAgainstSegment::<24, 2>::new());
    assert_eq!(parts.len(), 12);
    assert!(parts.iter().all(|part| part.is_hidden && part.model == 0));
}

proptest! {
    #![proptest_config(config(cases(10, 125)))]

    /// Faces that go through each other, some of them hidden in cycles.
    #[test]
    fn hidden_lines_of_interpenetrating_faces(mesh in faces(700, 14), pose in pose(1300..2500)) {
        let sides = sides(&mesh);
        check_formats(vec![mesh], &[&sides], pose);
    }

    /// Around the camera: cut by the near plane and the guard band.
    #[test]
    fn hidden_lines_of_faces_around_the_camera(mesh in faces(4000, 6), pose in pose(-500..800)) {
        let sides = sides(&mesh);
        check_formats(vec![mesh], &[&sides], pose);
    }

    /// Small faces, slivers and those seen from the side.
    #[test]
    fn hidden_lines_of_small_faces(mesh in faces(90, 30), pose in pose(200..900)) {
        let sides = sides(&mesh);
        check_formats(vec![mesh], &[&sides], pose);
    }

    /// Faces parallel to the screen, a unit of depth or none apart.
    #[test]
    fn hidden_lines_of_layers(
        corners in prop::collection::vec(prop::array::uniform3((-700i16..700, -700i16..700)), 1..16),
    ) {
        let vertices = (0..).zip(&corners).flat_map(|(layer, face)| face.map(|(x, y)| [x, y, layer / 3]));
        let vertices: Vec<_> = vertices.collect();
        let faces = (0..corners.len() as u16).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect();
        let mesh = Mesh::new(vertices, faces).two_sided();
        let sides = sides(&mesh);
        check_formats(vec![mesh], &[&sides], Pose::new(Rotation::IDENTITY, at(0, 0, 1400)));
    }
}
