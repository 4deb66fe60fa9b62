//! Roberts' hidden lines: against samples of each edge, taken by depth in `f64`, and against face against segment; intersections
//! against which model is nearest in each pixel.

use embedded_graphics::pixelcolor::Rgb888;
use proptest::prelude::*;
use zrow::{
    geometry::{Sub4, Sub8, SubPixel, SubPoint, TooSmall},
    scene::{Camera, DepthWidth, DoubleSided, Edge, Look, Memory, Model, Pose, Prepared, ScreenPrecision},
    visible::{FaceAgainstSegment, HiddenLines, LinePart, PartKind, Roberts},
};

use crate::common::meshes::{self, Mesh};
use crate::common::{by_depth, cases, config, is_quick};
use crate::hidden_lines;
use crate::numbered_scene::{LookIn, area, color_of};
use crate::random_faces::pose;
use crate::snapped_faces::{at, camera, standard_pose};

const WIDTH: u32 = 96;
const HEIGHT: u32 = 80;

type MemoryOf<L> = Memory<L, 8_000, 2_500, { WIDTH as usize }, { HEIGHT as usize }, 100>;

type Point3 = [f64; 3];

/// Edges of a mesh between faces that do not lie in one plane; each is a crease where the normals turn by 30 degrees.
fn edges(mesh: &Mesh) -> Vec<Edge> {
    let normal = |face: [u16; 3]| {
        let [a, b, c] = face.map(|vertex| mesh.vertices[usize::from(vertex)].map(f64::from));
        cross(minus(b, a), minus(c, a))
    };
    let sides = |[a, b, c]: [u16; 3]| [[a, b], [b, c], [c, a]];
    let mut found = Vec::new();
    for (one, face) in mesh.faces.iter().enumerate() {
        for [from, to] in sides(*face) {
            let other = mesh.faces.iter().position(|other| sides(*other).contains(&[to, from]));
            match other {
                None => found.push(Edge::boundary([from, to], one as u16)),
                Some(other) if one < other => {
                    let (first, second) = (normal(*face), normal(mesh.faces[other]));
                    let cosine = dot(first, second) / (dot(first, first) * dot(second, second)).sqrt();
                    let faces = [one, other].map(|face| face as u16);
                    if cosine < 0.866 {
                        found.push(Edge::crease([from, to], faces));
                    } else if cosine < 1.0 - 1e-9 {
                        found.push(Edge::smooth([from, to], faces));
                    }
                }
                Some(_) => (),
            }
        }
    }
    found
}

fn minus(a: Point3, b: Point3) -> Point3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: Point3, b: Point3) -> Point3 {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn dot(a: Point3, b: Point3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The surface of the smallest convex solid around points, no four of which may lie in one plane of it; `None` otherwise.
fn hull(points: &[[i16; 3]]) -> Option<Mesh> {
    let count = points.len();
    let exact = |index: usize| points[index].map(f64::from);
    let mut faces = Vec::new();
    for a in 0..count {
        for b in 0..count {
            for c in 0..count {
                if b <= a || c <= a || b == c {
                    continue;
                }
                let outwards = cross(minus(exact(b), exact(a)), minus(exact(c), exact(a)));
                let others = (0..count).filter(|index| ![a, b, c].contains(index));
                let heights: Vec<f64> = others
                    .map(|index| dot(outwards, minus(exact(index), exact(a))))
                    .collect();
                if heights.iter().all(|height| *height < 0.0) {
                    faces.push([a, b, c].map(|index| index as u16));
                } else if heights.iter().all(|height| *height <= 0.0) {
                    return None;
                }
            }
        }
    }
    (faces.len() >= 4).then(|| Mesh::new(points.to_vec(), faces))
}

/// A face on the screen, in units: of position and of depth.
#[derive(Clone)]
struct Face {
    model: usize,
    corners: [Point3; 3],
    /// What depth changes over one unit of x and one of y.
    slope: [f64; 2],
}

impl Face {
    fn new(model: usize, [a, b, c]: [Point3; 3]) -> Option<Self> {
        let [_, _, area] = cross(minus(b, a), minus(c, a));
        if area <= 0.0 {
            return None;
        }
        let [x, y, z] = cross(minus(b, a), minus(c, a));
        Some(Self {
            model,
            corners: [a, b, c],
            slope: [-x / z, -y / z],
        })
    }

    /// The depth of the plane at a position.
    fn depth(&self, [x, y, _]: Point3) -> f64 {
        let [a, ..] = self.corners;
        a[2] + (x - a[0]) * self.slope[0] + (y - a[1]) * self.slope[1]
    }

    /// Whether a position is within the face, or outside by at most a margin.
    fn contains(&self, [x, y, _]: Point3, margin: f64) -> bool {
        let [a, b, c] = self.corners;
        [[a, b], [b, c], [c, a]].into_iter().all(|[from, to]| {
            let (width, height) = (to[0] - from[0], to[1] - from[1]);
            width * (y - from[1]) - height * (x - from[0]) >= -margin * width.hypot(height)
        })
    }
}

/// What the reference says of a point of an edge.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
enum Truth {
    Hidden,
    Visible,
    /// Either, by less than the tolerances.
    Either,
}

/// Units of depth by which lines have to be behind a face, besides its slope.
fn tolerance<D: DepthWidth>() -> f64 {
    if D::FRACTION_BITS == 16 { 2.0 } else { 8.0 }
}

/// Hidden are points that are so after a move by three units in any direction, and visible those that no face is near to, or that
/// are behind none by the tolerance.
fn truth<D: DepthWidth>(faces: &[Face], ends: [Point3; 2], point: Point3) -> Truth {
    let tolerance = tolerance::<D>();
    let moves = [-3.0, 0.0, 3.0].map(|x| [-3.0, 0.0, 3.0].map(|y| [x, y]));
    let is_hidden = moves.concat().into_iter().all(|[x, y]| {
        let moved = [point[0] + x, point[1] + y, point[2]];
        let mut covering = faces.iter().filter(|face| face.contains(moved, 0.0));
        covering.any(|face| face.depth(moved) - moved[2] > 3.0 * tolerance)
    });
    if is_hidden {
        return Truth::Hidden;
    }
    let is_near = |face: &&Face| {
        // Faces that the edge begins in hide it as soon as it is behind them.
        let touches = ends.iter().any(|end| face.corners.contains(end));
        let least = if touches {
            0.001
        } else {
            0.9 * (tolerance + face.slope[0].abs() + face.slope[1].abs())
        };
        face.contains(point, 1.5) && face.depth(point) - point[2] > least
    };
    match faces.iter().find(is_near) {
        None => Truth::Visible,
        Some(_) => Truth::Either,
    }
}

fn units<S: SubPixel>(point: SubPoint<S>) -> [f64; 2] {
    [f64::from(point.x_units()), f64::from(point.y_units())]
}

fn point<S: SubPixel, D: DepthWidth>(position: SubPoint<S>, depth: D) -> Point3 {
    let [x, y] = units(position);
    [x, y, f64::from(depth.units())]
}

/// The parts of a method.
fn parts<L: Look>(
    prepared: &Prepared<'_, '_, L>,
    method: &mut impl HiddenLines<L::Depth>,
    tables: &[&[Edge]],
) -> Vec<LinePart<L::Precision>> {
    let mut parts = Vec::new();
    prepared.visible_parts(method, tables, |part| parts.push(part)).unwrap();
    parts
}

/// Whether a point at a distance from the first end of an edge is in a hidden part; `None` within a pixel of an end of one.
fn is_hidden<S: ScreenPrecision>(parts: &[&LinePart<S>], start: [f64; 2], distance: f64, slack: f64) -> Option<bool> {
    let from_start = |point: SubPoint<S>| {
        let [x, y] = units(point);
        (x - start[0]).hypot(y - start[1])
    };
    for part in parts {
        let ends = part.ends.map(from_start);
        if ends.iter().any(|end| (distance - end).abs() <= slack) {
            return None;
        }
        let [_, second] = ends;
        if distance <= second + slack {
            return Some(part.is_hidden);
        }
    }
    panic!("a gap at the end")
}

/// What was compared.
#[derive(Debug, Default)]
struct Compared {
    hidden: usize,
    visible: usize,
    either: usize,
    intersections: usize,
}

/// Compares a scene's parts with the reference.
fn check<L: Look<Color = Rgb888, Shading = Rgb888>>(
    models: &[Model<'_, Rgb888>],
    meshes: &[Mesh],
    camera: &Camera,
) -> Compared {
    let mut memory = Box::new(MemoryOf::<L>::new());
    let prepared = memory.prepare(camera, models).unwrap();
    let tables: Vec<Vec<Edge>> = meshes.iter().map(edges).collect();
    let tables: Vec<&[Edge]> = tables.iter().map(|table| &table[..]).collect();
    let mut method = Box::new(Roberts::<8, 2_000>::new());
    let roberts = parts(&prepared, &mut *method, &tables);
    let viewport = [0, 0, WIDTH as i32, HEIGHT as i32];
    hidden_lines::check(&prepared, &tables, viewport, "Roberts", &mut *method);
    let segments = parts(
        &prepared,
        &mut *Box::new(FaceAgainstSegment::<2_500, 32>::new()),
        &tables,
    );

    let model_of = |order: usize| {
        let mut end = 0;
        let of = |mesh: &Mesh| {
            end += mesh.faces.len();
            order < end
        };
        meshes.iter().position(of).unwrap()
    };
    let faces: Vec<Face> = prepared
        .faces()
        .filter_map(|face| {
            Face::new(
                model_of(face.order),
                face.corners.map(|corner| point(corner.point, corner.depth)),
            )
        })
        .collect();
    let unit = f64::from(1 << L::Precision::FRACTION_BITS);
    let mut compared = Compared::default();
    let (mut differing, mut all) = (0, 0);
    for (model, table) in tables.iter().enumerate() {
        for edge in prepared.edges(model, table) {
            let of_edge = |parts: &[LinePart<L::Precision>]| -> Vec<LinePart<L::Precision>> {
                let mine = |part: &&LinePart<_>| (part.model, part.edge) == (model, Some(edge.index));
                parts.iter().filter(mine).copied().collect()
            };
            let [from, to] = edge.ends.map(|end| point(end.point, end.depth));
            let length = (to[0] - from[0]).hypot(to[1] - from[1]);
            let (mine, theirs) = (of_edge(&roberts), of_edge(&segments));
            assert_eq!(mine.is_empty(), length == 0.0);
            if mine.is_empty() {
                continue;
            }
            assert_eq!(
                [mine[0].ends[0], mine[mine.len() - 1].ends[1]],
                edge.ends.map(|end| end.point)
            );
            assert!(
                mine.windows(2)
                    .all(|two| two[0].ends[1] == two[1].ends[0] && two[0].is_hidden != two[1].is_hidden)
            );
            let (mine, theirs): (Vec<_>, Vec<_>) = (mine.iter().collect(), theirs.iter().collect());
            let samples = ((2.0 * length / unit).ceil() as usize).clamp(4, 300);
            for sample in 0..=samples {
                let part = sample as f64 / samples as f64;
                let way = minus(to, from);
                let point = [0, 1, 2].map(|axis| from[axis] + way[axis] * part);
                let truth = truth::<L::Depth>(&faces, [from, to], point);
                let distance = part * length;
                let (one, other) = (
                    is_hidden(&mine, [from[0], from[1]], distance, unit),
                    is_hidden(&theirs, [from[0], from[1]], distance, unit),
                );
                if let (Some(one), Some(other)) = (one, other) {
                    all += 1;
                    differing += usize::from(one != other);
                }
                match truth {
                    Truth::Hidden => compared.hidden += 1,
                    Truth::Visible => compared.visible += 1,
                    Truth::Either => compared.either += 1,
                }
                let is_wrong = match (truth, one) {
                    (Truth::Either, _) | (_, None) => false,
                    (Truth::Hidden, Some(is_hidden)) => !is_hidden,
                    (Truth::Visible, Some(is_hidden)) => is_hidden,
                };
                assert!(
                    !is_wrong,
                    "{truth:?} at {point:?} ({part}) of edge {} of {model}, {from:?} to {to:?}: {mine:?}",
                    edge.index
                );
            }
        }
    }
    assert!(
        differing * 50 <= all,
        "{differing} of {all} differ from face against segment"
    );
    if std::env::var("SHOW").is_ok() {
        println!(
            "{compared:?} differing {differing} of {all}, planes {}, faces {}, inequalities {} pairs {} apart {}",
            planes_needed(&prepared),
            faces.len(),
            method.inequalities(),
            method.pairs(),
            method.boxes_apart()
        );
    }
    compared.intersections = check_intersections(&faces, &roberts, unit, tolerance::<L::Depth>());
    compared
}

/// Where two models penetrate each other, as seen: between two pixels of which one shows a face and the other one another, although
/// both faces are in both pixels, there is a visible part of an intersection. And where there is a part, faces of two models are
/// as near. Returns how many such pairs of pixels there are.
fn check_intersections<S: ScreenPrecision>(faces: &[Face], parts: &[LinePart<S>], unit: f64, tolerance: f64) -> usize {
    let lines = parts.iter().filter(|part| part.kind == PartKind::Intersection);
    let lines: Vec<_> = lines.map(|part| (part.ends.map(units), part.is_hidden)).collect();
    for ([from, to], is_hidden) in &lines {
        for sample in 0..=4 {
            let part = f64::from(sample) / 4.0;
            let point = [0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * part);
            let here: Vec<&Face> = faces
                .iter()
                .filter(|face| face.contains([point[0], point[1], 0.0], 1.5))
                .collect();
            let are_as_near = |one: &Face, other: &Face| {
                let slope = [0, 1].map(|axis| one.slope[axis].abs() + other.slope[axis].abs());
                let apart = (one.depth([point[0], point[1], 0.0]) - other.depth([point[0], point[1], 0.0])).abs();
                one.model != other.model && apart <= tolerance + 1.5 * (slope[0] + slope[1])
            };
            let found = here.iter().any(|one| here.iter().any(|other| are_as_near(one, other)));
            assert!(found, "no two faces at {point:?}, {is_hidden}");
        }
    }
    // The faces in a pixel, the nearest one first.
    let faces_at = |x: i32, y: i32| {
        let at = [f64::from(x) * unit, f64::from(y) * unit, 0.0];
        let mut here: Vec<&Face> = faces.iter().filter(|face| face.contains(at, 0.0)).collect();
        here.sort_by(|one, other| other.depth(at).total_cmp(&one.depth(at)));
        here
    };
    let row = |y: i32| (0..WIDTH as i32).map(|x| faces_at(x, y)).collect();
    let pixels: Vec<Vec<Vec<&Face>>> = (0..HEIGHT as i32).map(row).collect();
    let has = |pixel: &[&Face], face: &Face| pixel.iter().any(|other| std::ptr::eq(*other, face));
    let mut crossings = 0;
    for (x, y) in (1..WIDTH as usize).flat_map(|x| (1..HEIGHT as usize).map(move |y| (x, y))) {
        for (before_x, before_y) in [(x - 1, y), (x, y - 1)] {
            let (here, before) = (&pixels[y][x], &pixels[before_y][before_x]);
            let (Some(one), Some(other)) = (here.first(), before.first()) else {
                continue;
            };
            if one.model == other.model || !has(here, other) || !has(before, one) {
                continue;
            }
            crossings += 1;
            let middle = [(x + before_x) as f64, (y + before_y) as f64].map(|sum| sum * unit / 2.0);
            let is_near = |(ends, is_hidden): &([[f64; 2]; 2], bool)| !is_hidden && distance(*ends, middle) <= unit;
            assert!(lines.iter().any(is_near), "no line at {middle:?}");
        }
    }
    crossings
}

/// How far a point is from a line.
fn distance([from, to]: [[f64; 2]; 2], point: [f64; 2]) -> f64 {
    let (way, to_point) = (
        [to[0] - from[0], to[1] - from[1]],
        [point[0] - from[0], point[1] - from[1]],
    );
    let square = way[0] * way[0] + way[1] * way[1];
    let part = ((way[0] * to_point[0] + way[1] * to_point[1]) / square).clamp(0.0, 1.0);
    (to_point[0] - part * way[0]).hypot(to_point[1] - part * way[1])
}

/// Models of meshes, each in its own pose; colours say which face is which.
fn with_models<R>(meshes: &[Mesh], poses: &[Pose], draw: impl FnOnce(&[Model<'_, Rgb888>]) -> R) -> R {
    let most = meshes.iter().map(|mesh| mesh.faces.len()).max().unwrap_or(0);
    let colors: Vec<Rgb888> = (0..most).map(color_of).collect();
    let models: Vec<_> = meshes
        .iter()
        .zip(poses)
        .map(|(mesh, pose)| Model::new(mesh.face_set(), &colors).unwrap().with_pose(*pose))
        .collect();
    draw(&models)
}

fn check_formats(meshes: &[Mesh], poses: &[Pose]) -> Compared {
    let camera = camera(area(WIDTH, HEIGHT));
    with_models(meshes, poses, |models| {
        if !is_quick() {
            check::<LookIn<Sub8, u16>>(models, meshes, &camera);
        }
        check::<LookIn<Sub8, u32>>(models, meshes, &camera);
        check::<LookIn<Sub4, u16>>(models, meshes, &camera)
    })
}

fn turned(frame: u16, [x, y, z]: [i32; 3]) -> Pose {
    let Pose { rotation, .. } = standard_pose(frame);
    Pose::new(rotation, at(x, y, z))
}

fn tetrahedron() -> Mesh {
    Mesh::new(
        vec![[-300, -250, -280], [320, -240, -200], [0, -220, 350], [20, 380, 0]],
        vec![[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]],
    )
}

#[test]
fn penetrating_cubes_show_their_intersection() {
    for frame in [3, 21, 40, 77] {
        let meshes = [meshes::cube(0.6), meshes::cube(0.5)];
        let poses = [turned(frame, [-100, 0, 1500]), turned(frame + 30, [200, 120, 1400])];
        let compared = check_formats(&meshes, &poses);
        assert!(compared.intersections > 10, "{compared:?}");
        assert!(compared.hidden > 20 && compared.visible > 200, "{compared:?}");
    }
}

#[test]
fn convex_solids_in_front_of_each_other() {
    for frame in [1, 9, 33].into_iter().take(cases(1, 3) as usize) {
        let meshes = [
            meshes::icosphere(0.8),
            meshes::cube(0.6),
            tetrahedron(),
            meshes::icosphere(0.4),
        ];
        let poses = [
            turned(frame, [0, 0, 1800]),
            turned(frame + 7, [300, -200, 2600]),
            turned(frame + 50, [-200, 100, 1200]),
            turned(frame, [250, 300, 1300]),
        ];
        let compared = check_formats(&meshes, &poses);
        assert!(compared.hidden > 100 && compared.visible > 200, "{compared:?}");
    }
}

/// How many planes a scene takes.
fn planes_needed<L: Look>(prepared: &Prepared<'_, '_, L>) -> usize {
    let mut handed_over = 0;
    match prepared.visible_parts(&mut Roberts::<8, 0>::new(), &[], |_| handed_over += 1) {
        Err(TooSmall::Planes(needed)) => needed,
        result => {
            assert_eq!(result, Ok(()));
            0
        }
    }
}

/// A method that has too little memory says how much would do, and hands nothing over.
fn check_error(
    prepared: &Prepared<'_, '_, Rgb888>,
    tables: &[&[Edge]],
    method: &mut impl HiddenLines<u16>,
    error: TooSmall,
) {
    let mut handed_over = 0;
    assert_eq!(prepared.visible_parts(method, tables, |_| handed_over += 1), Err(error));
    assert_eq!(handed_over, 0);
}

#[test]
fn too_little_memory_is_an_error_that_says_how_much_would_do() {
    let meshes = [meshes::cube(0.6), meshes::icosphere(0.8)];
    let poses = [turned(5, [-100, 0, 1300]), turned(9, [200, 120, 1500])];
    let camera = camera(area(WIDTH, HEIGHT));
    with_models(&meshes, &poses, |models| {
        let mut memory = Box::new(MemoryOf::<Rgb888>::new());
        let prepared = memory.prepare(&camera, models).unwrap();
        let tables: Vec<Vec<Edge>> = meshes.iter().map(edges).collect();
        let tables: Vec<&[Edge]> = tables.iter().map(|table| &table[..]).collect();
        check_error(&prepared, &tables, &mut Roberts::<0, 0>::new(), TooSmall::Solids(2));
        check_error(&prepared, &tables, &mut Roberts::<1, 900>::new(), TooSmall::Solids(2));

        // The faces that are seen from the front, and silhouette edges.
        let fronts = |order: std::ops::Range<usize>| {
            let faces = prepared.faces().filter(|face| order.contains(&face.order));
            let faces = faces.filter_map(|face| Face::new(0, face.corners.map(|at| point(at.point, at.depth))));
            faces.count()
        };
        let (cube, ball) = (12, 320);
        let silhouettes = |model: usize| {
            prepared
                .edges(model, tables[model])
                .filter(|edge| edge.is_silhouette)
                .count()
        };
        let needed = fronts(0..cube) + silhouettes(0) + fronts(cube..cube + ball) + silhouettes(1);
        assert!(fronts(0..cube) >= 4 && silhouettes(0) == 6);
        assert_eq!(planes_needed(&prepared), needed);
        check_error(
            &prepared,
            &tables,
            &mut Roberts::<2, 100>::new(),
            TooSmall::Planes(needed),
        );
        let mut enough = Box::new(Roberts::<2, { 2 * (12 + 320) }>::new());
        assert!(parts(&prepared, &mut *enough, &tables).len() > 30);
        // Models without tables have no edges, and there may be more tables than models.
        assert!(
            parts(&prepared, &mut *enough, &[])
                .iter()
                .all(|part| part.kind == PartKind::Intersection)
        );
        assert_eq!(
            parts(&prepared, &mut *enough, &[tables[0], tables[1], tables[0]]),
            parts(&prepared, &mut *enough, &tables)
        );
        assert!(enough.pairs() > enough.boxes_apart() && enough.inequalities() > 0);
    });
    with_models(&[], &[], |models| {
        let mut memory = Box::new(MemoryOf::<Rgb888>::new());
        let prepared = memory.prepare(&camera, models).unwrap();
        assert_eq!(parts(&prepared, &mut Roberts::<0, 0>::new(), &[]), []);
    });
}

/// Two cubes with a side in common: nothing of the edges of that side is hidden by the other cube, which they only touch.
#[test]
fn solids_that_touch_do_not_hide_each_other() {
    let meshes = [meshes::cube(0.4), meshes::cube(0.4)];
    for frame in [2, 13, 28, 44] {
        let Pose { rotation, .. } = standard_pose(frame);
        // A width of 410 units along the x axis of both.
        let [x, y, z] = rotation.matrix().map(|row| row[0].to_num::<f64>() * 410.0);
        let place = |[x, y, z]: [f64; 3]| {
            let at = [x, y, z].map(fixed::types::I16F16::from_num);
            Pose::new(rotation, at)
        };
        let poses = [place([0.0, 0.0, 1500.0]), place([x, y, 1500.0 + z])];
        check_formats(&meshes, &poses);
    }
}

#[test]
fn models_that_are_not_convex_are_taken_face_by_face() {
    let meshes = [meshes::torus(), meshes::cube(0.5)];
    let mut intersections = 0;
    for frame in [3, 17] {
        let poses = [turned(frame, [0, 0, 1500]), turned(frame, [150, 40, 1500])];
        let compared = check_formats(&meshes, &poses);
        assert!(compared.hidden > 200, "{compared:?}");
        intersections += compared.intersections;
        assert!(!meshes[0].face_set().is_convex() && meshes[1].face_set().is_convex());
        with_models(&meshes[..1], &poses, |models| {
            let mut memory = Box::new(MemoryOf::<Rgb888>::new());
            let prepared = memory.prepare(&camera(area(WIDTH, HEIGHT)), models).unwrap();
            assert_eq!(planes_needed(&prepared), 0);
        });
    }
    assert!(intersections > 2, "{intersections}");
}

/// Solids that the near plane or the guard band cuts, and such as the eye is in.
#[test]
fn solids_that_are_cut_are_taken_face_by_face() {
    let meshes = [meshes::cube(0.7), meshes::icosphere(0.5), tetrahedron()];
    for (frame, distance) in [(3, 300), (9, 420), (30, 0), (12, -100), (41, 250)]
        .into_iter()
        .step_by(by_depth(2, 1, 1))
    {
        let poses = [
            turned(frame, [100, 50, distance]),
            turned(frame, [0, 0, 1200]),
            turned(frame + 20, [200, -80, 900]),
        ];
        check_formats(&meshes, &poses);
    }
}

/// Backs that are drawn hide nothing that the fronts of a closed convex solid do not, but those of an open one do.
#[test]
fn backs_are_taken_where_they_are_drawn() {
    let mut open = meshes::cube(0.6);
    open.faces.truncate(10);
    let meshes = [open, meshes::cube(0.3), tetrahedron()];
    for frame in [4, 18, 52] {
        let poses = [
            turned(frame, [0, 0, 1500]),
            turned(frame + 7, [50, 20, 1480]),
            turned(frame, [-150, 100, 1900]),
        ];
        with_models(&meshes, &poses, |models| {
            check::<DoubleSided<Rgb888>>(models, &meshes, &camera(area(WIDTH, HEIGHT)));
        });
    }
}

fn solid() -> BoxedStrategy<Mesh> {
    let points = prop::collection::vec(prop::array::uniform3(-400i16..400), 4..10);
    prop_oneof![
        (0.1..0.8f64).prop_map(meshes::cube),
        (0.1..0.8f64).prop_map(meshes::icosphere),
        Just(tetrahedron()),
        points.prop_filter_map("points in one plane", |points| hull(&points)),
    ]
    .boxed()
}

proptest! {
    #![proptest_config(config(cases(12, 50)))]

    #[test]
    fn convex_solids_at_random(
        solids in prop::collection::vec((solid(), pose(900..2500)), 1..6),
    ) {
        let (meshes, poses): (Vec<_>, Vec<_>) = solids.into_iter().unzip();
        check_formats(&meshes, &poses);
    }
}
