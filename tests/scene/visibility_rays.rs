//! Ray casting through a grid draws the picture of the depth row, with any camera and any memory; solids that are combined along
//! rays are those of a walk from crossing to crossing in exact arithmetic.

use std::ops::Range;

use embedded_graphics::{pixelcolor::Rgb888, prelude::*, primitives::Rectangle};
use fixed::types::{I8F24, I16F16, U0F16};
use zrow::{
    band::Band,
    geometry::{SubPixel, TooSmall},
    scene::{Camera, Deep, DoubleSided, Fine, Look, Memory, Model, Orthographic, Pose, Prepared, Rotation},
    visible::{GridRayCasting, RayCasting, SolidCombination, SolidNode, Visibility},
};

use crate::common::cases;
use crate::common::meshes::{self, Mesh};
use crate::numbered_scene::{Scene, area, color_of, depth_and_tolerance};
use crate::snapped_faces::{at, camera, snapped, standard_pose};

const WIDTH: u32 = 48;
const HEIGHT: u32 = 36;
const PIXELS: usize = (WIDTH * HEIGHT) as usize;

type MemoryOf<L> = Memory<L, 6_000, 1_400, { WIDTH as usize }, { HEIGHT as usize }, 200>;

/// The pixels of an area, drawn by the closure in one band.
fn pixels(area: Rectangle, draw: impl FnOnce(&mut Band<'_, Rgb888>)) -> Vec<u32> {
    let mut words = vec![0; (area.size.width * area.size.height) as usize];
    draw(&mut Band::new(area, &mut words).unwrap());
    words
}

fn by<L: Look<Color = Rgb888>>(
    prepared: &mut Prepared<'_, '_, L>,
    method: &mut impl Visibility<L::Depth>,
    area: Rectangle,
) -> Vec<u32> {
    pixels(area, |band| prepared.draw_by(method, band).unwrap())
}

/// xorshift64 (Marsaglia 2003), below a bound.
fn numbers(seed: u64) -> impl FnMut(i32) -> i32 {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    move |bound| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state % bound as u64) as i32
    }
}

fn random_pose(next: &mut impl FnMut(i32) -> i32, size: i32, distances: Range<i32>) -> Pose {
    let rotation = Rotation::about_x(U0F16::from_bits(next(1 << 16) as u16))
        .then(&Rotation::about_y(U0F16::from_bits(next(1 << 16) as u16)));
    let [x, y] = [0; 2].map(|_| next(2 * size + 1) - size);
    let z = distances.start + next(distances.end - distances.start);
    Pose::new(rotation, at(x, y, z))
}

/// Faces anywhere within a box.
fn random_faces(next: &mut impl FnMut(i32) -> i32, size: i32, count: u16) -> Mesh {
    let vertices = (0..3 * count)
        .map(|_| [0; 3].map(|_| (next(2 * size + 1) - size) as i16))
        .collect();
    Mesh::new(
        vertices,
        (0..count).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect(),
    )
}

/// Draws faces by rays through a grid and by the depth row, in the viewport of a camera.
fn check_grid<L: Look<Color = Rgb888, Shading = Rgb888>>(scene: &Scene, pose: Pose, camera: &Camera) {
    let models = scene.models(pose);
    let mut memory = Box::new(MemoryOf::<L>::new());
    let mut prepared = memory.prepare(camera, &models).unwrap();
    let area = camera.viewport().to_rectangle();
    let expected = pixels(area, |band| prepared.draw(band));
    let mut grid = GridRayCasting::<2_000, 4_096, 40_000>::new();
    assert!(by(&mut prepared, &mut grid, area) == expected, "{camera:?}");
    let mut coarse = GridRayCasting::<2_000, 100, 3_000>::new();
    assert!(by(&mut prepared, &mut coarse, area) == expected, "{camera:?}");
    let mut tree = RayCasting::<2_000>::new();
    assert!(by(&mut prepared, &mut tree, area) == expected, "{camera:?}");
    let mut grid = GridRayCasting::<2_000, 4_096, 40_000>::new();
    let mut face_at = prepared.picking(&mut grid).unwrap();
    for point in area.points() {
        assert_eq!(face_at(point), prepared.face_at(point), "{point:?} {camera:?}");
    }
}

/// Lenses of all lengths, that look beside the middle, in a viewport anywhere.
fn cameras(next: &mut impl FnMut(i32) -> i32) -> Camera {
    let corner = Point::new(next(900) - 450, next(900) - 450);
    let viewport = Rectangle::new(corner, Size::new(1 + next(48) as u32, 1 + next(36) as u32));
    let focal_length = I16F16::from_num([2, 20, 60, 300][next(4) as usize]);
    let centre = [next(60) - 10, next(60) - 10].map(I16F16::from_num);
    Camera::new(viewport, I16F16::from_num([8, 64, 300][next(3) as usize]))
        .and_then(|camera| camera.with_focal_length(focal_length))
        .and_then(|camera| camera.with_centre(centre))
        .and_then(|camera| camera.with_scale(I8F24::from_num(f64::from(next(99) + 1) / 1000.0)))
        .unwrap()
}

#[test]
fn rays_march_through_grids_of_any_camera() {
    for seed in 1..=u64::from(cases(24, 399)) {
        let mut next = numbers(seed);
        let size = [60, 700, 5_000, 30_000][next(4) as usize];
        let count = 4 + next(60) as u16;
        let faces = random_faces(&mut next, size, count);
        let scene = Scene::new(vec![faces.two_sided()]);
        let pose = random_pose(&mut next, 400, -200..3_000);
        let camera = cameras(&mut next);
        check_grid::<Rgb888>(&scene, pose, &camera);
        check_grid::<Fine<Deep<Rgb888>>>(&scene, pose, &camera);
        check_grid::<Orthographic<Rgb888>>(&scene, pose, &camera);
        check_grid::<Orthographic<Fine<Deep<Rgb888>>>>(&scene, pose, &camera);
    }
}

fn check_capacity<const FACES: usize, const CELLS: usize, const ENTRIES: usize>(
    prepared: &mut Prepared<'_, '_, Rgb888>,
    expected: &[u32],
) {
    let mut rays = GridRayCasting::<FACES, CELLS, ENTRIES>::new();
    let drawn = by(prepared, &mut rays, area(WIDTH, HEIGHT));
    assert!(drawn == expected, "{CELLS} cells, {ENTRIES} entries");
}

#[test]
fn grids_of_any_capacity() {
    let scene = Scene::new(vec![meshes::torus(), meshes::cube(0.5)]);
    let models = scene.models(standard_pose(3));
    let camera = camera(area(WIDTH, HEIGHT));
    let mut memory = Box::new(MemoryOf::<Rgb888>::new());
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    let expected = pixels(area(WIDTH, HEIGHT), |band| prepared.draw(band));
    check_capacity::<600, 0, 0>(&mut prepared, &expected);
    check_capacity::<600, 0, 9>(&mut prepared, &expected);
    check_capacity::<600, 1, 0>(&mut prepared, &expected);
    check_capacity::<600, 2, 300>(&mut prepared, &expected);
    check_capacity::<600, 3, 900>(&mut prepared, &expected);
    check_capacity::<600, 500, 300>(&mut prepared, &expected);
    check_capacity::<600, 500, 400>(&mut prepared, &expected);
    check_capacity::<600, 500, 700>(&mut prepared, &expected);
    check_capacity::<600, 4096, 20_000>(&mut prepared, &expected);
    check_capacity::<600, 100_000, 70_000>(&mut prepared, &expected);

    let mut words = [7; PIXELS];
    let mut band = Band::<Rgb888>::new(area(WIDTH, HEIGHT), &mut words).unwrap();
    let Err(TooSmall::Faces(needed)) = prepared.draw_by(&mut GridRayCasting::<0, 9, 9>::new(), &mut band) else {
        panic!("no face fits");
    };
    assert!(words.iter().all(|word| *word == 7));
    assert!((100..588).contains(&needed), "{needed}");
    let mut small = GridRayCasting::<9, 9, 9>::new();
    assert_eq!(prepared.picking(&mut small).err(), Some(TooSmall::Faces(needed)));
}

/// Counted for the torus and the cube, in the pixels that show a face: how many faces are asked through a grid, and without.
#[test]
fn picking_through_a_grid_asks_few_faces() {
    let scene = Scene::new(vec![meshes::torus(), meshes::cube(0.5)]);
    let models = scene.models(standard_pose(3));
    let camera = camera(area(WIDTH, HEIGHT));
    let mut memory = Box::new(MemoryOf::<Rgb888>::new());
    let prepared = memory.prepare(&camera, &models).unwrap();
    let shown: Vec<Point> = area(WIDTH, HEIGHT)
        .points()
        .filter(|point| prepared.face_at(*point).is_some())
        .collect();
    let mut grid = GridRayCasting::<600, 4_096, 20_000>::new();
    let mut face_at = prepared.picking(&mut grid).unwrap();
    for point in &shown {
        face_at(*point).unwrap();
    }
    drop(face_at);
    let through_grid = f64::from(grid.faces_tested()) / shown.len() as f64;
    // Without it: all faces that begin in the row of the pixel or above it.
    let is_seen = |[a, b, c]: [[i128; 3]; 3]| (b[0] - a[0]) * (c[1] - a[1]) > (b[1] - a[1]) * (c[0] - a[0]);
    let rows: Vec<i32> = snapped(&prepared)
        .iter()
        .filter(|face| is_seen(face.corners))
        .map(|face| face.corners.iter().map(|corner| corner[1] as i32).min().unwrap())
        .collect();
    let looked_at = shown
        .iter()
        .map(|point| rows.iter().filter(|row| **row <= 16 * point.y).count())
        .sum::<usize>();
    let without = looked_at as f64 / shown.len() as f64;
    assert!(
        through_grid < 12.0 && without > 10.0 * through_grid,
        "{through_grid} {without}"
    );
}

/// Counted for the torus and the cube: a ray tests few of 588 faces, and none twice.
#[test]
fn a_ray_through_a_grid_tests_few_faces_and_none_twice() {
    let scene = Scene::new(vec![meshes::torus(), meshes::cube(0.5)]);
    let models = scene.models(standard_pose(3));
    let camera = camera(area(WIDTH, HEIGHT));
    let mut memory = Box::new(MemoryOf::<Rgb888>::new());
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    let rays = PIXELS as f64;
    let mut fine = GridRayCasting::<600, 4_096, 20_000>::new();
    by(&mut prepared, &mut fine, area(WIDTH, HEIGHT));
    let mut all = GridRayCasting::<600, 0, 0>::new();
    by(&mut prepared, &mut all, area(WIDTH, HEIGHT));
    let per_ray = [
        fine.faces_tested(),
        fine.cells_visited(),
        fine.mailbox_hits(),
        all.faces_tested(),
    ]
    .map(|count| f64::from(count) / rays);
    let [tested, visited, hits, of_all] = per_ray;
    assert!(tested < 12.0 && visited < 16.0 && hits > 0.2, "{per_ray:?}");
    assert!(of_all > 10.0 * tested && all.mailbox_hits() == 0, "{per_ray:?}");
}

/// A tree of solids, each of them faces by their index in the order of models and faces.
#[derive(Debug, Clone)]
enum Solid {
    Faces(Range<u16>),
    Union(Box<[Solid; 2]>),
    Intersection(Box<[Solid; 2]>),
    Difference(Box<[Solid; 2]>),
}

impl Solid {
    fn union(self, other: &Self) -> Self {
        Self::Union(Box::new([self, other.clone()]))
    }

    fn intersection(self, other: &Self) -> Self {
        Self::Intersection(Box::new([self, other.clone()]))
    }

    fn minus(self, other: &Self) -> Self {
        Self::Difference(Box::new([self, other.clone()]))
    }

    fn postorder(&self) -> Vec<SolidNode> {
        let (operands, node) = match self {
            Self::Faces(faces) => return vec![SolidNode::Primitive(faces.clone())],
            Self::Union(operands) => (operands, SolidNode::Union),
            Self::Intersection(operands) => (operands, SolidNode::Intersection),
            Self::Difference(operands) => (operands, SolidNode::Difference),
        };
        let mut nodes: Vec<_> = operands.iter().flat_map(Self::postorder).collect();
        nodes.push(node);
        nodes
    }

    /// Whether a point is inside, from which a ray to infinity meets these faces.
    fn contains(&self, met: &[u16]) -> bool {
        let [left, right] = match self {
            Self::Faces(faces) => return met.iter().filter(|face| faces.contains(*face)).count() % 2 == 1,
            Self::Union(operands) | Self::Intersection(operands) | Self::Difference(operands) => {
                operands.each_ref().map(|operand| operand.contains(met))
            }
        };
        match self {
            Self::Intersection(_) => left && right,
            Self::Difference(_) => left && !right,
            _ => left || right,
        }
    }

    fn bounds(&self, face: u16) -> bool {
        match self {
            Self::Faces(faces) => faces.contains(&face),
            Self::Union(operands) | Self::Intersection(operands) | Self::Difference(operands) => {
                operands.iter().any(|operand| operand.bounds(face))
            }
        }
    }

    /// The face that is seen in a pixel, given the faces that cover it, the nearest first, each with its exact depth; none if two
    /// depths are too close to say which is nearer.
    fn owner(&self, covering: &[(i128, u16)], tolerance: i128) -> Option<Option<u16>> {
        let met: Vec<_> = covering.iter().filter(|(_, face)| self.bounds(*face)).collect();
        if met.windows(2).any(|pair| pair[0].0 - pair[1].0 <= tolerance) {
            return None;
        }
        let orders: Vec<u16> = met.iter().map(|(_, order)| *order).collect();
        let first = self.contains(&orders);
        let changes = (1..=orders.len()).find(|passed| self.contains(&orders[*passed..]) != first);
        Some(changes.map(|passed| orders[passed - 1]))
    }
}

/// The faces that cover each pixel, the nearest first, each with its exact depth.
fn covering_faces<L: Look>(prepared: &Prepared<'_, '_, L>) -> Vec<Vec<(i128, u16)>> {
    let (depth, _) = depth_and_tolerance::<L::Depth>(area(WIDTH, HEIGHT));
    let unit = 1 << L::Precision::FRACTION_BITS;
    let faces = snapped(prepared);
    let covering = |point: Point| {
        let [x, y] = [point.x, point.y].map(|pixel| i128::from(pixel) * unit);
        let covering = faces.iter().filter(|face| face.covers(x, y));
        let mut met: Vec<_> = covering
            .map(|face| (face.hundredths(x, y, depth), face.order as u16))
            .collect();
        met.sort();
        met.reverse();
        met
    };
    area(WIDTH, HEIGHT).points().map(covering).collect()
}

/// The picture of a combination, with room for any number of crossings.
fn combined<L: Look<Color = Rgb888>>(prepared: &mut Prepared<'_, '_, L>, solid: &Solid) -> Vec<u32> {
    let nodes = solid.postorder();
    let whole = area(WIDTH, HEIGHT);
    let mut plenty = SolidCombination::<1_800, 40>::new(&nodes);
    let expected = by(prepared, &mut plenty, whole);
    assert_eq!(plenty.passes(), PIXELS as u32);
    let mut none = SolidCombination::<1_800, 0>::new(&nodes);
    assert!(by(prepared, &mut none, whole) == expected, "no room for crossings");
    let mut one = SolidCombination::<1_800, 1>::new(&nodes);
    assert!(by(prepared, &mut one, whole) == expected, "room for one crossing");
    assert_eq!(one.passes(), none.passes());
    let mut three = SolidCombination::<1_800, 3>::new(&nodes);
    assert!(by(prepared, &mut three, whole) == expected, "room for three crossings");
    assert!((PIXELS as u32..=one.passes()).contains(&three.passes()));
    expected
}

/// Compares the picture of a combination with exact arithmetic; returns how many pixels were compared that show a face.
fn check_combination<L: Look<Color = Rgb888, Shading = Rgb888>>(
    prepared: &mut Prepared<'_, '_, L>,
    solid: &Solid,
    covering: &[Vec<(i128, u16)>],
) -> usize {
    let whole = area(WIDTH, HEIGHT);
    let (_, tolerance) = depth_and_tolerance::<L::Depth>(whole);
    let drawn = combined(prepared, solid);
    let mut compared = 0;
    for ((point, drawn), covering) in whole.points().zip(drawn).zip(covering) {
        if let Some(owner) = solid.owner(covering, tolerance) {
            let expected = owner.map_or(0, |order| color_of(order.into()).into_storage());
            assert_eq!(drawn, expected, "{point:?} {solid:?}");
            compared += usize::from(owner.is_some());
        }
    }
    compared
}

/// Three solids that overlap, and where their faces are.
fn three_solids(next: &mut impl FnMut(i32) -> i32) -> (Scene, [Solid; 3]) {
    let meshes = [0; 3].map(|_| match next(3) {
        0 => meshes::cube(0.4 + f64::from(next(5)) / 10.0),
        1 => meshes::icosphere(0.6 + f64::from(next(5)) / 10.0),
        _ => meshes::torus(),
    });
    let mut first = 0;
    let solids = meshes.each_ref().map(|mesh| {
        let start = first;
        first += mesh.faces.len() as u16;
        Solid::Faces(start..first)
    });
    (Scene::new(meshes.into()), solids)
}

fn random_models<'m>(
    scene: &'m Scene,
    next: &mut impl FnMut(i32) -> i32,
    distances: Range<i32>,
) -> Vec<Model<'m, Rgb888>> {
    let models = scene.models(Pose::IDENTITY).into_iter();
    models
        .map(|model| model.with_pose(random_pose(next, 300, distances.clone())))
        .collect()
}

fn combinations_of<L: Look<Color = Rgb888, Shading = Rgb888>>(seed: u64, distances: Range<i32>) -> usize {
    let mut next = numbers(seed);
    let (scene, [a, b, c]) = three_solids(&mut next);
    let models = random_models(&scene, &mut next, distances);
    let camera = camera(area(WIDTH, HEIGHT)).with_scale(I8F24::from_num(0.03)).unwrap();
    let mut memory = Box::new(Memory::<L, 9_000, 1_800, { WIDTH as usize }, { HEIGHT as usize }, 400>::new());
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    let solids = [
        a.clone(),
        a.clone().union(&b),
        a.clone().intersection(&b),
        a.clone().minus(&b),
        a.clone().minus(&b.clone().minus(&c)),
        a.clone().union(&b).intersection(&c),
        c.minus(&a.union(&b)),
    ];
    let covering = covering_faces(&prepared);
    let check = |solid| check_combination(&mut prepared, solid, &covering);
    solids.iter().map(check).sum()
}

#[test]
fn combinations_are_those_of_exact_arithmetic() {
    let mut compared = 0;
    for seed in 1..=u64::from(cases(4, 29)) {
        compared += combinations_of::<DoubleSided<Rgb888>>(seed, 1_400..1_900);
        compared += combinations_of::<DoubleSided<Fine<Deep<Rgb888>>>>(seed, 1_400..1_900);
        compared += combinations_of::<Orthographic<DoubleSided<Deep<Rgb888>>>>(seed, 1_400..1_900);
    }
    assert!(compared > cases(20_000, 20_000) as usize, "{compared}");
}

/// Solids that the near plane cuts open: a ray begins inside, and what is seen is where that changes.
#[test]
fn combinations_cut_open_by_the_near_plane() {
    let mut compared = 0;
    for seed in 1..=u64::from(cases(4, 29)) {
        compared += combinations_of::<DoubleSided<Fine<Deep<Rgb888>>>>(seed, 0..500);
    }
    assert!(compared > 5_000, "{compared}");
}

#[test]
fn combinations_obey_the_laws_of_sets() {
    for seed in 1..=u64::from(cases(3, 19)) {
        let mut next = numbers(seed);
        let (scene, [a, b, c]) = three_solids(&mut next);
        let models = random_models(&scene, &mut next, 1_300..1_700);
        let mut memory = Box::new(Memory::<
            DoubleSided<Rgb888>,
            9_000,
            1_800,
            { WIDTH as usize },
            { HEIGHT as usize },
            400,
        >::new());
        let camera = camera(area(WIDTH, HEIGHT));
        let mut prepared = memory.prepare(&camera, &models).unwrap();
        let mut draw = |solid: Solid| combined(&mut prepared, &solid);
        assert_eq!(draw(a.clone().union(&a)), draw(a.clone()));
        assert_eq!(draw(a.clone().intersection(&a)), draw(a.clone()));
        assert!(draw(a.clone().minus(&a)).iter().all(|word| *word == 0));
        assert_eq!(draw(a.clone().intersection(&b)), draw(b.clone().intersection(&a)));
        assert_eq!(draw(a.clone().union(&b)), draw(b.clone().union(&a)));
        // De Morgan: A without (B or C), (A without B) without C.
        assert_eq!(
            draw(a.clone().minus(&b.clone().union(&c))),
            draw(a.clone().minus(&b).minus(&c))
        );
        assert_eq!(
            draw(a.clone().intersection(&b).intersection(&c)),
            draw(a.intersection(&b.intersection(&c)))
        );
    }
}

/// The union of solids that do not touch is the picture of the depth row.
#[test]
fn a_union_of_disjoint_solids_is_the_picture_of_the_depth_row() {
    let scene = Scene::new(vec![meshes::torus(), meshes::cube(0.3), meshes::icosphere(0.4)]);
    let [a, b, c] = [0..576, 576..588, 588..908].map(Solid::Faces);
    for frame in 0..cases(6, 30) as u16 {
        let mut models = scene.models(standard_pose(frame));
        models[1].pose.translation[0] = I16F16::from_num(1_100);
        models[2].pose.translation[2] = I16F16::from_num(3_000);
        let mut memory = Box::new(MemoryOf::<DoubleSided<Rgb888>>::new());
        let camera = camera(area(WIDTH, HEIGHT));
        let mut prepared = memory.prepare(&camera, &models).unwrap();
        let expected = pixels(area(WIDTH, HEIGHT), |band| prepared.draw(band));
        assert!(
            combined(&mut prepared, &a.clone().union(&b).union(&c)) == expected,
            "frame {frame}"
        );
    }
}

/// Trees that are none: operations without operands, several trees, more solids than there is room for.
#[test]
fn trees_of_any_nodes() {
    let scene = Scene::new(vec![meshes::cube(0.6)]);
    let models = scene.models(standard_pose(3));
    let camera = camera(area(WIDTH, HEIGHT));
    let mut memory = Box::new(MemoryOf::<DoubleSided<Rgb888>>::new());
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    let mut shows = |nodes: &[SolidNode]| {
        let mut solids = SolidCombination::<12, 4>::new(nodes);
        by(&mut prepared, &mut solids, area(WIDTH, HEIGHT))
            .iter()
            .any(|word| *word != 0)
    };
    let cube = || SolidNode::Primitive(0..12);
    assert!(!shows(&[]));
    assert!(!shows(&[SolidNode::Union, SolidNode::Difference]));
    assert!(shows(&[cube()]));
    assert!(shows(&[cube(), SolidNode::Union]));
    assert!(!shows(&[cube(), SolidNode::Difference]));
    assert!(!shows(&[cube(), SolidNode::Primitive(40..50)]));
    assert!(shows(&[SolidNode::Primitive(40..50), cube()]));
    assert!(!shows(&vec![SolidNode::Union; 100]));
    let mut forty = vec![cube(); 40];
    // The last eight are empty.
    assert!(!shows(&forty));
    forty.extend(vec![SolidNode::Union; 39]);
    assert!(shows(&forty));
    let mut words = [7; PIXELS];
    let mut band = Band::<Rgb888>::new(area(WIDTH, HEIGHT), &mut words).unwrap();
    let nodes = [cube()];
    let mut few = SolidCombination::<11, 4>::new(&nodes);
    assert_eq!(prepared.draw_by(&mut few, &mut band), Err(TooSmall::Faces(12)));
    assert!(words.iter().all(|word| *word == 7));
}
