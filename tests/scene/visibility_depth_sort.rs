//! The painter's algorithm in the cases that are hard for it: cycles, faces that penetrate, faces on one plane, slivers.

use embedded_graphics::{pixelcolor::Rgb888, prelude::*, primitives::Rectangle};
use zrow::{
    band::Band,
    geometry::{Sub4, TooSmall},
    scene::{Memory, Pose, Rotation},
    visible::{DepthSort, DepthSortCounters},
};

use crate::common::cases;
use crate::common::meshes::{self, Mesh};
use crate::numbered_scene::{LookIn, Scene, area};
use crate::snapped_faces::{at, camera, standard_pose};
use crate::visibility::{HEIGHT, MemoryOf, WIDTH, check, check_formats, in_bands};

const FRAME: [u32; 2] = [WIDTH, HEIGHT];

/// Compares the picture of meshes with that of the depth row; returns what a method did for it in one band.
fn counters<const FACES: usize, const SPLITS: usize>(meshes: Vec<Mesh>, pose: Pose) -> DepthSortCounters {
    let (scene, camera) = (Scene::new(meshes), camera(area(WIDTH, HEIGHT)));
    let models = scene.models(pose);
    let mut memory = Box::new(MemoryOf::<Sub4, u16>::new());
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    let expected = in_bands(FRAME, false, &mut |band| prepared.draw(band));
    let name = format!("{FACES} faces, {SPLITS} conditions");
    check(&mut prepared, &expected, &name, &mut DepthSort::<FACES, SPLITS>::new());
    let mut method = DepthSort::<FACES, SPLITS>::new();
    in_bands(FRAME, false, &mut |band| prepared.draw_by(&mut method, band).unwrap());
    *method.counters()
}

fn ahead(distance: i32) -> Pose {
    Pose::new(Rotation::IDENTITY, at(0, 0, distance))
}

/// Quads, two faces each, seen from both sides.
fn quads(corners: &[[[i16; 3]; 4]]) -> Mesh {
    let faces =
        (0..corners.len() as u16).flat_map(|quad| [[0, 1, 2], [0, 2, 3]].map(|face| face.map(|c| 4 * quad + c)));
    let faces = faces.collect();
    Mesh::new(corners.concat(), faces).two_sided()
}

/// Three long faces along the sides of a triangle: each ends in front of the next one, and begins behind the one before.
pub fn cycle() -> Mesh {
    let corners = [0.0f64, 120.0, 240.0].map(|degrees| {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        [(-500.0, 70.0), (500.0, 150.0), (-500.0, 230.0)].map(|(along, across): (f64, f64)| {
            let position = [
                along * cosine - across * sine,
                along * sine + across * cosine,
                -0.4 * along,
            ];
            position.map(|coordinate| coordinate.round() as i16)
        })
    });
    Mesh::new(corners.concat(), vec![[0, 1, 2], [3, 4, 5], [6, 7, 8]]).two_sided()
}

/// Two quads that go through each other, upright and level.
pub fn penetrating() -> Mesh {
    quads(&[
        [[-400, -300, -200], [400, -300, 230], [400, 310, 230], [-400, 310, -200]],
        [[-410, -290, 210], [390, -290, -190], [390, 300, -190], [-410, 300, 210]],
    ])
}

#[test]
fn a_convex_solid_is_painted_without_a_sort() {
    let octahedron = Mesh::new(
        [
            [0, 500, 0],
            [500, 0, 0],
            [0, 0, 500],
            [-500, 0, 0],
            [0, 0, -500],
            [0, -500, 0],
        ]
        .into(),
        [1, 2, 3, 4]
            .into_iter()
            .flat_map(|side| {
                let next = side % 4 + 1;
                [[0, side, next], [5, next, side]]
            })
            .collect(),
    );
    let solid = counters_of_a_picture(octahedron.clone(), standard_pose(7));
    assert_eq!((solid.disjoint_rows, solid.pairs), (HEIGHT, 0));
    // Seen from both sides each pixel has two faces, from the first rows of the solid on.
    let sides = counters_of_a_picture(octahedron.two_sided(), standard_pose(7));
    assert!(sides.disjoint_rows < HEIGHT && sides.pairs > 0, "{sides:?}");
}

/// What the method did for one picture of a frame in one band.
fn counters_of_a_picture(mesh: Mesh, pose: Pose) -> DepthSortCounters {
    let (scene, camera) = (Scene::new(vec![mesh]), camera(area(WIDTH, HEIGHT)));
    let models = scene.models(pose);
    let mut memory = Box::new(MemoryOf::<Sub4, u16>::new());
    let mut method = DepthSort::<16, 0>::new();
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    let found = in_bands(FRAME, false, &mut |band| prepared.draw_by(&mut method, band).unwrap());
    assert_eq!(found, in_bands(FRAME, false, &mut |band| prepared.draw(band)));
    *method.counters()
}

#[test]
fn faces_in_a_cycle_are_split() {
    let with_parts = counters::<16, 16>(vec![cycle()], ahead(1200));
    assert!(with_parts.moves > 0 && with_parts.splits > 0, "{with_parts:?}");
    assert_eq!(with_parts.in_cycles, 0);
    let without = counters::<16, 0>(vec![cycle()], ahead(1200));
    assert!(without.splits == 0 && without.in_cycles >= 3, "{without:?}");
    assert_eq!([with_parts.pixels_compared, without.pixels_compared], [0, 0]);
    check_formats(vec![cycle()], ahead(1200));
}

#[test]
fn faces_that_penetrate_are_split() {
    let with_parts = counters::<16, 16>(vec![penetrating()], ahead(1400));
    assert!(with_parts.splits > 0, "{with_parts:?}");
    assert_eq!(with_parts.in_cycles, 0, "{with_parts:?}");
    // In each row they are less than a unit apart in a column or two, whenever they are compared.
    assert!(with_parts.pixels_compared < 8 * HEIGHT, "{with_parts:?}");
    let without = counters::<16, 0>(vec![penetrating()], ahead(1400));
    assert!(without.splits == 0 && without.in_cycles >= 2, "{without:?}");
    for frame in 0..cases(6, 12) as u16 {
        check_formats(vec![penetrating(), cycle()], standard_pose(frame));
    }
}

/// A solid has few pairs of faces whose depths overlap and that are near each other, and nothing to move or to split.
#[test]
fn convex_solids_take_little_more_than_the_sort() {
    for frame in 0..8 {
        for (mesh, pairs) in [(meshes::cube(1.0), 16), (meshes::icosphere(1.4), 20 * 160)] {
            let counters = counters::<320, 0>(vec![mesh], standard_pose(frame));
            assert!(counters.pairs <= pairs, "{counters:?}");
            let DepthSortCounters {
                compared_in_rows,
                moves,
                in_cycles,
                pixels_compared,
                ..
            } = counters;
            assert_eq!(
                [compared_in_rows, moves, in_cycles, pixels_compared],
                [0; 4],
                "{counters:?}"
            );
        }
    }
}

/// Each pair is decided by one test: what is left are the pairs whose first face has to wait.
#[test]
fn pairs_are_decided_by_the_cheapest_test() {
    let counters = counters::<600, 64>(vec![meshes::torus(), meshes::cube(0.5)], standard_pose(1));
    let decided = counters.extents_apart + counters.ordered_by_planes + counters.projections_apart;
    assert!(decided + counters.compared_in_rows <= counters.pairs, "{counters:?}");
    assert!(counters.extents_apart > 20 * counters.projections_apart, "{counters:?}");
    assert!(
        counters.projections_apart > 5 * counters.compared_in_rows,
        "{counters:?}"
    );
    assert!(
        counters.ordered_by_planes > 0 && counters.pixels_compared == 0,
        "{counters:?}"
    );
}

/// Faces parallel to the screen, a unit or less apart, wait in the right order: depths or the order of models decide alone.
#[test]
fn layers_are_not_moved() {
    let layers: Vec<_> = (0..12)
        .map(|layer: i16| {
            let (x, y, z) = (37 * layer - 500, 400 - 23 * layer, layer / 3);
            [[x, y - 300, z], [x + 400, y - 310, z], [x + 420, y, z], [x, y, z]]
        })
        .collect();
    let counters = counters::<24, 0>(vec![quads(&layers)], ahead(1400));
    assert_eq!(
        [counters.moves, counters.in_cycles, counters.pixels_compared],
        [0; 3],
        "{counters:?}"
    );
    check_formats(vec![quads(&layers)], ahead(1400));
}

/// Quads on one slanted plane that overlap: their stored depths differ by a unit here and there.
#[test]
fn faces_on_one_slanted_plane() {
    let slanted: Vec<_> = (0..5)
        .map(|number: i16| {
            let (x, y) = (61 * number - 400, 47 * number - 350);
            [(0, 0), (307, 40), (290, 330), (-20, 301)].map(|(right, down)| {
                let (x, y) = (x + right, y + down);
                [x, y, x / 2 + y / 4]
            })
        })
        .collect();
    for frame in 0..3 {
        let pose = standard_pose(frame * 3);
        check_formats(vec![quads(&slanted)], pose);
        counters::<10, 4>(vec![quads(&slanted)], pose);
    }
}

/// Slivers that reach from the nearest to the farthest depth, and faces seen from the side.
#[test]
fn slivers_whose_depths_overlap_all_others() {
    let slivers: Vec<_> = (0..16)
        .map(|number: i16| {
            let across = 50 * number - 400;
            let far = if number % 2 == 0 { 700 } else { -700 };
            [
                [across, -500, -far],
                [3 - across, 500, far],
                [12 - across, 500, far],
                [across + 9, -500, -far],
            ]
        })
        .collect();
    let mesh = || vec![quads(&slivers), meshes::cube(0.6)];
    for frame in 0..cases(4, 12) as u16 {
        check_formats(mesh(), standard_pose(frame));
    }
    let counters = counters::<64, 64>(mesh(), ahead(1500));
    assert!(counters.pairs > 200, "{counters:?}");
    // Seen from the side they have no pixels, and meet nothing.
    let level = quads(&[[[-300, 0, -300], [300, 0, -300], [300, 0, 300], [-300, 0, 300]]]);
    check_formats(vec![level, meshes::cube(0.4)], ahead(1500));
}

/// With too few faces the band is as it was, and the error says how many would do; with as many, the picture is the same for
/// any number of conditions.
#[test]
fn all_capacities() {
    fn with<const FACES: usize, const SPLITS: usize>() {
        let (scene, camera) = (Scene::new(vec![cycle(), penetrating()]), camera(area(WIDTH, HEIGHT)));
        let models = scene.models(ahead(1300));
        let mut memory = Box::new(MemoryOf::<Sub4, u16>::new());
        let mut prepared = memory.prepare(&camera, &models).unwrap();
        let expected = in_bands(FRAME, false, &mut |band| prepared.draw(band));
        let mut method = DepthSort::<FACES, SPLITS>::new();
        if FACES >= 7 {
            check(&mut prepared, &expected, &format!("{FACES}, {SPLITS}"), &mut method);
            return;
        }
        let mut words = vec![7; (WIDTH * HEIGHT) as usize];
        let mut band = Band::<Rgb888>::new(area(WIDTH, HEIGHT), &mut words).unwrap();
        assert_eq!(prepared.draw_by(&mut method, &mut band), Err(TooSmall::Faces(7)));
        assert!(words.iter().all(|word| *word == 7));
        // The corner of the picture has no faces.
        let corner = Rectangle::new(Point::zero(), Size::new(2, 2));
        let mut band = Band::<Rgb888>::new(corner, &mut words).unwrap();
        assert_eq!(prepared.draw_by(&mut method, &mut band), Ok(()));
    }
    macro_rules! with_conditions {
        ($($faces:literal)*) => {
            $(
                with::<$faces, 0>();
                with::<$faces, 1>();
                with::<$faces, 2>();
                with::<$faces, 3>();
                with::<$faces, 4>();
                with::<$faces, 5>();
                with::<$faces, 9>();
                with::<$faces, 20>();
            )*
        };
    }
    with_conditions!(0 1 6 7 8 9 10 20);
}

/// Faces that the near plane cuts take two places each: with fewer the band is as it was, also where the method has as many
/// places as there are faces.
#[test]
fn fragments_of_cut_faces_count() {
    type Tight = Memory<LookIn<Sub4, u16>, { 9 + 6 * 4 }, 3, { WIDTH as usize }, { HEIGHT as usize }, 9>;
    let Mesh { vertices, faces, .. } = cycle();
    let cut = Mesh::new(vertices, faces[3..].to_vec());
    let (scene, camera) = (Scene::new(vec![cut]), camera(area(WIDTH, HEIGHT)));
    let models = scene.models(ahead(200));
    let mut memory = Tight::new();
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    let expected = in_bands(FRAME, false, &mut |band| prepared.draw(band));
    let mut words = vec![7; (WIDTH * HEIGHT) as usize];
    let mut band = Band::<Rgb888>::new(area(WIDTH, HEIGHT), &mut words).unwrap();
    let error = prepared.draw_by(&mut DepthSort::<3, 9>::new(), &mut band);
    assert_eq!(error, Err(TooSmall::Faces(6)));
    assert!(words.iter().all(|word| *word == 7));
    check(
        &mut prepared,
        &expected,
        "as many as are needed",
        &mut DepthSort::<6, 9>::new(),
    );
    check(
        &mut prepared,
        &expected,
        "as many as could be",
        &mut DepthSort::<9, 9>::new(),
    );
}
