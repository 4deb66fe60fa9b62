//! All methods of visibility draw the picture of the depth row, pixel for pixel, in bands of any size and order.
//!
//! Faces are coloured by their number, so that pictures say which face is seen in each pixel.

use embedded_graphics::{pixelcolor::Rgb888, prelude::*, primitives::Rectangle};
use proptest::prelude::*;
use zrow::{
    band::Band,
    geometry::{Sub4, Sub8, TooSmall},
    scan::{FillRule, Location, Polygons},
    scene::{Camera, DepthWidth, Look, Memory, Model, Prepared},
    visible::{
        DepthBuffer, DepthSort, GridRayCasting, OneDepth, RayCasting, SpanScanLine, TileBins, Visibility, Warnock,
    },
};

use crate::common::meshes::{self, Mesh};
use crate::common::{cases, config, is_quick};
use crate::numbered_scene::{Format, LookIn, Scene, area, color_of};
use crate::random_faces::{faces, pose};
use crate::snapped_faces::{camera, snapped, standard_pose};

pub const WIDTH: u32 = 64;
pub const HEIGHT: u32 = 48;
const PIXELS: usize = (WIDTH * HEIGHT) as usize;

pub type MemoryOf<S, D> = Memory<LookIn<S, D>, 6_000, 1_000, { WIDTH as usize }, { HEIGHT as usize }, 200>;

/// The colour behind all faces.
const BEHIND: Rgb888 = Rgb888::new(0xff, 0xff, 0xff);

/// A test of where a point lies with respect to a polygon.
type PointTest = fn(&[&[Point]], FillRule, &Point) -> Location;

/// The picture in bands of this size, from below or from above, each drawn by the closure. Not generic, because each method in each
/// look has a closure of its own, for which it would be compiled anew.
pub fn in_bands([width, height]: [u32; 2], upwards: bool, draw: &mut dyn FnMut(&mut Band<'_, Rgb888>)) -> Vec<u32> {
    let mut drawn = vec![0; PIXELS];
    let mut tops: Vec<u32> = (0..HEIGHT).step_by(height as usize).collect();
    if upwards {
        tops.reverse();
    }
    for top in tops {
        for left in (0..WIDTH).step_by(width as usize) {
            let size = Size::new(width.min(WIDTH - left), height.min(HEIGHT - top));
            let part = Rectangle::new(Point::new(left as i32, top as i32), size);
            let mut words = vec![BEHIND.into_storage(); (size.width * size.height) as usize];
            draw(&mut Band::new(part, &mut words).unwrap());
            for (point, word) in part.points().zip(words) {
                drawn[point.y as usize * WIDTH as usize + point.x as usize] = word;
            }
        }
    }
    drawn
}

/// Compares the pictures of a method with that of the depth row.
pub fn check<L: Look<Color = Rgb888, Shading = Rgb888>>(
    prepared: &mut Prepared<'_, '_, L>,
    expected: &[u32],
    name: &str,
    method: &mut impl Visibility<L::Depth>,
) {
    for bands in [([WIDTH, HEIGHT], false), ([WIDTH, 1], false), ([23, 11], true)] {
        check_in_bands(prepared, expected, name, method, bands);
    }
}

/// Compares the picture of a method with that of the depth row, in bands of one size, from below or from above.
fn check_in_bands<L: Look<Color = Rgb888, Shading = Rgb888>>(
    prepared: &mut Prepared<'_, '_, L>,
    expected: &[u32],
    name: &str,
    method: &mut impl Visibility<L::Depth>,
    (size, upwards): ([u32; 2], bool),
) {
    let drawn = in_bands(size, upwards, &mut |band| prepared.draw_by(method, band).unwrap());
    assert_eq!(differing(&drawn, expected), 0, "{name}, bands of {size:?}");
}

/// The number of words that differ between two pictures.
pub fn differing(one: &[u32], other: &[u32]) -> usize {
    one.iter().zip(other).filter(|(one, other)| one != other).count()
}

/// Warnock's algorithm with room for all faces, for some and for none, and with each test of windows.
fn check_warnock<L: Look<Color = Rgb888, Shading = Rgb888>>(prepared: &mut Prepared<'_, '_, L>, expected: &[u32]) {
    check(prepared, expected, "Warnock", &mut Warnock::<1_000>::new());
    check(prepared, expected, "Warnock, 10 faces", &mut Warnock::<10>::new());
    check(prepared, expected, "Warnock, no face", &mut Warnock::<0>::new());
    check(
        prepared,
        expected,
        "line equations",
        &mut Warnock::<500, _>::by_line_equations(),
    );
    check(
        prepared,
        expected,
        "ray crossings",
        &mut Warnock::<500, _>::by_ray_crossings(),
    );
    check(prepared, expected, "angle sum", &mut Warnock::<500, _>::by_angle_sum());
    check(
        prepared,
        expected,
        "region codes",
        &mut Warnock::<500, _>::by_region_codes(),
    );
}

/// Rays through grids with room for many cells, for some and for none.
fn check_grids<L: Look<Color = Rgb888, Shading = Rgb888>>(
    prepared: &mut Prepared<'_, '_, L>,
    expected: &[u32],
    shown: usize,
) {
    let mut grid = GridRayCasting::<2_000, 4_096, 40_000>::new();
    check(prepared, expected, "grid", &mut grid);
    assert!(shown == 0 || grid.faces_tested().min(grid.cells_visited()) > 0);
    let mut coarse = GridRayCasting::<2_000, 64, 2_500>::new();
    check(prepared, expected, "64 cells", &mut coarse);
    let mut without_cells = GridRayCasting::<2_000, 0, 0>::new();
    check_in_bands(prepared, expected, "no cell", &mut without_cells, ([23, 11], true));
    assert_eq!(without_cells.mailbox_hits(), 0);
}

/// Which face is seen in a pixel is known through grids of any capacity as without: in each pixel, and beside the viewport.
fn check_picking<L: Look>(prepared: &Prepared<'_, '_, L>, camera: &Camera) {
    let (mut fine, mut coarse) = (
        GridRayCasting::<2_000, 4_096, 40_000>::new(),
        GridRayCasting::<2_000, 0, 0>::new(),
    );
    let mut faces_at = [
        Box::new(prepared.picking(&mut fine).unwrap()) as Box<dyn FnMut(Point) -> Option<usize>>,
        Box::new(prepared.picking(&mut coarse).unwrap()),
    ];
    let beside = camera.viewport().to_rectangle().offset(1);
    for (number, point) in beside.points().enumerate() {
        let expected = prepared.face_at(point);
        assert_eq!(faces_at[0](point), expected, "{point:?}");
        if number % 7 == 0 {
            assert_eq!(faces_at[1](point), expected, "{point:?}, without cells");
        }
    }
}

/// Draws models by all methods; returns how many pixels show a face.
fn check_all<S: Format<D>, D: DepthWidth>(models: &[Model<'_, Rgb888>], camera: &Camera) -> usize {
    let mut memory = Box::new(MemoryOf::<S, D>::new());
    let mut prepared = memory.prepare(camera, models).unwrap();
    let expected = in_bands([WIDTH, HEIGHT], false, &mut |band| prepared.draw(band));
    let shown = expected.iter().filter(|word| **word != BEHIND.into_storage()).count();
    check(
        &mut prepared,
        &expected,
        "depth buffer",
        &mut DepthBuffer::<D, PIXELS>::new(),
    );
    check(
        &mut prepared,
        &expected,
        "tile bins",
        &mut TileBins::<D, 12, 10_000>::new(),
    );
    let mut rays = RayCasting::<2_000>::new();
    check(&mut prepared, &expected, "ray casting", &mut rays);
    assert!(shown == 0 || rays.faces_tested() > 0);
    check_grids(&mut prepared, &expected, shown);
    check_picking(&prepared, camera);
    for (point, word) in camera.viewport().to_rectangle().points().zip(&expected).step_by(7) {
        let face = prepared.face_at(point);
        assert_eq!(*word, face.map_or(BEHIND, color_of).into_storage(), "{point:?}");
    }
    let tests: [PointTest; 4] = [
        Polygons::crossing_number,
        Polygons::merged_crossings,
        Polygons::winding_number,
        Polygons::quadrant_arc_length,
    ];
    for test in tests {
        let mut method = OneDepth::new(test);
        check_in_bands(&mut prepared, &expected, "one depth", &mut method, ([23, 11], true));
        assert!(shown == 0 || method.points_tested() > 0);
    }
    check_warnock(&mut prepared, &expected);
    let mut without_parts = DepthSort::<1_200, 0>::new();
    check(&mut prepared, &expected, "depth sort without parts", &mut without_parts);
    assert_eq!(without_parts.counters().splits, 0);
    let mut with_seven = DepthSort::<1_200, 7>::new();
    check(&mut prepared, &expected, "depth sort, 7 conditions", &mut with_seven);
    let mut sort = DepthSort::<1_200, 2_000>::new();
    check(&mut prepared, &expected, "depth sort", &mut sort);
    check(&mut prepared, &expected, "spans", &mut SpanScanLine::<200>::new());
    check(
        &mut prepared,
        &expected,
        "8 spans sorted",
        &mut SpanScanLine::<8>::new(),
    );
    check(
        &mut prepared,
        &expected,
        "no span sorted",
        &mut SpanScanLine::<0>::new(),
    );
    shown
}

/// Draws meshes in one pose by all methods, with every precision and width of depths; returns how many pixels show a face.
pub fn check_formats(meshes: Vec<Mesh>, pose: zrow::scene::Pose) -> usize {
    check_models(&Scene::new(meshes).models(pose))
}

/// Draws models by all methods, with every precision and width of depths, or with the least and the most of both where
/// [`is_quick`]; returns how many pixels show a face.
pub fn check_models(models: &[Model<'_, Rgb888>]) -> usize {
    let camera = camera(area(WIDTH, HEIGHT));
    if !is_quick() {
        check_all::<Sub4, u32>(models, &camera);
        check_all::<Sub8, u16>(models, &camera);
    }
    check_all::<Sub8, u32>(models, &camera);
    check_all::<Sub4, u16>(models, &camera)
}

#[test]
fn standard_scenes_by_all_methods() {
    let frames = cases(2, 16) as u16;
    for frame in 0..frames {
        let pose = standard_pose(frame * 5 + 1);
        for meshes in meshes::standard_scenes() {
            assert!(check_formats(meshes, pose) > 250, "frame {frame}");
        }
    }
}

/// Faces on one plane: in each pixel that both cover they are as near, and the first one is seen.
#[test]
fn the_first_of_equally_near_faces_is_seen_by_all_methods() {
    let back_to_back = Mesh::new(
        vec![
            [-600, -600, 0],
            [-600, 600, 0],
            [600, 600, 0],
            [600, -600, 0],
            [0, 500, 0],
            [500, -300, 0],
        ],
        vec![[0, 4, 5], [0, 1, 2], [0, 2, 3], [1, 4, 3]],
    );
    for frame in 0..cases(4, 4) as u16 {
        let meshes = vec![
            back_to_back.clone().two_sided(),
            meshes::cube(0.4),
            back_to_back.clone(),
        ];
        assert!(check_formats(meshes, standard_pose(frame)) > 250);
    }
}

/// A method that has too little memory says how much would do, and leaves the band alone.
fn check_error(
    prepared: &mut Prepared<'_, '_, Rgb888>,
    method: &mut impl Visibility<u16>,
    rows: u32,
    error: Result<(), TooSmall>,
) {
    let mut words = [7; PIXELS];
    let part = Rectangle::new(Point::new(0, 20), Size::new(WIDTH, rows));
    let mut band = Band::<Rgb888>::new(part, &mut words[..(WIDTH * rows) as usize]).unwrap();
    assert_eq!(prepared.draw_by(method, &mut band), error);
    assert_eq!(words.iter().any(|word| *word != 7), error.is_ok());
}

/// How often the box of a face that is seen from the front meets a tile of 16 columns, in some rows of the picture.
fn faces_in_tiles(prepared: &Prepared<'_, '_, Rgb888>, rows: std::ops::Range<i128>) -> usize {
    let tiles = (0..WIDTH.into()).step_by(16).map(|left| left..left + 16);
    let meets = |corners: [[i128; 3]; 3], axis: usize, pixels: &std::ops::Range<i128>| {
        let pixel = corners.map(|corner| corner[axis].div_euclid(16));
        pixel.iter().any(|pixel| *pixel >= pixels.start) && pixel.iter().any(|pixel| *pixel < pixels.end)
    };
    let is_front = |[a, b, c]: [[i128; 3]; 3]| (b[0] - a[0]) * (c[1] - a[1]) > (c[0] - a[0]) * (b[1] - a[1]);
    let faces = snapped(prepared).into_iter().map(|face| face.corners);
    faces
        .filter(|corners| is_front(*corners) && meets(*corners, 1, &rows))
        .map(|corners| tiles.clone().filter(|columns| meets(corners, 0, columns)).count())
        .sum()
}

#[test]
fn too_little_memory_is_an_error_that_says_how_much_would_do() {
    let (scene, camera) = (Scene::new(vec![meshes::cube(1.0)]), camera(area(WIDTH, HEIGHT)));
    let models = scene.models(standard_pose(3));
    let mut memory = Box::new(MemoryOf::<Sub4, u16>::new());
    let mut prepared = memory.prepare(&camera, &models).unwrap();

    let mut buffer = DepthBuffer::<u16, 100>::new();
    check_error(&mut prepared, &mut buffer, 2, Err(TooSmall::Pixels(128)));
    // Usable afterwards.
    check_error(&mut prepared, &mut buffer, 1, Ok(()));

    check_error(
        &mut prepared,
        &mut TileBins::<u16, 3, 0>::new(),
        8,
        Err(TooSmall::Tiles(4)),
    );
    let needed = faces_in_tiles(&prepared, 20..28);
    assert_eq!(needed, 8);
    let too_small = Err(TooSmall::TileFaces(needed));
    check_error(&mut prepared, &mut TileBins::<u16, 4, 0>::new(), 8, too_small);
    check_error(&mut prepared, &mut TileBins::<u16, 4, 7>::new(), 8, too_small);
    check_error(&mut prepared, &mut TileBins::<u16, 4, 8>::new(), 8, Ok(()));

    // All four faces that are seen begin above row 28.
    check_error(&mut prepared, &mut RayCasting::<3>::new(), 8, Err(TooSmall::Faces(4)));
    check_error(&mut prepared, &mut RayCasting::<4>::new(), 8, Ok(()));
}

/// A ray looks at few of many faces: in a picture of 1,000 small ones that lie beside each other and behind each other.
#[test]
fn a_ray_is_asked_about_few_faces() {
    let (scene, camera) = (
        Scene::new(vec![meshes::icosphere(1.4), meshes::torus()]),
        camera(area(WIDTH, HEIGHT)),
    );
    let models = scene.models(standard_pose(7));
    let mut memory = Box::new(MemoryOf::<Sub4, u16>::new());
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    let mut words = [0; PIXELS];
    let mut rays = RayCasting::<1_000>::new();
    prepared
        .draw_by(
            &mut rays,
            &mut Band::<Rgb888>::new(area(WIDTH, HEIGHT), &mut words).unwrap(),
        )
        .unwrap();
    let per_ray = f64::from(rays.faces_tested()) / PIXELS as f64;
    assert!((0.5..12.0).contains(&per_ray), "{per_ray}");
}

proptest! {
    #![proptest_config(config(cases(12, 125)))]

    /// Faces that go through each other, some of them hidden in cycles.
    #[test]
    fn interpenetrating_faces_by_all_methods(mesh in faces(700, 14), pose in pose(1300..2500)) {
        check_formats(vec![mesh], pose);
    }

    /// Around the camera: cut by the near plane and the guard band.
    #[test]
    fn faces_around_the_camera_by_all_methods(mesh in faces(4000, 6), pose in pose(-500..800)) {
        check_formats(vec![mesh], pose);
    }

    /// Small faces, slivers and those seen from the side.
    #[test]
    fn small_faces_by_all_methods(mesh in faces(90, 30), pose in pose(200..900)) {
        check_formats(vec![mesh], pose);
    }

    /// Faces parallel to the screen, a unit of depth or none apart.
    #[test]
    fn layers_by_all_methods(
        corners in prop::collection::vec(prop::array::uniform3((-700i16..700, -700i16..700)), 1..16),
    ) {
        let vertices = (0..).zip(&corners).flat_map(|(layer, face)| face.map(|(x, y)| [x, y, layer / 3]));
        let vertices: Vec<_> = vertices.collect();
        let faces = (0..corners.len() as u16).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect();
        let pose = zrow::scene::Pose::new(zrow::scene::Rotation::IDENTITY, crate::snapped_faces::at(0, 0, 1400));
        check_formats(vec![Mesh::new(vertices, faces).two_sided()], pose);
    }
}
