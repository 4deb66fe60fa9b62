//! The interval scan-line algorithm: what it counts, textures, frames that end before their last row, and any number of slots.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use zrow::{
    band::{Band, BandColor},
    geometry::Sub4,
    scene::{Camera, Look, Memory, Model, Pose, Prepared, Rotation},
    shade::{Texels, Textured, TexturedSkin},
    visible::{SpanScanLine, Visibility},
};

use crate::common::meshes::{self, Mesh};
use crate::numbered_scene::{LookIn, Scene, area};
use crate::snapped_faces::{at, camera, standard_pose};

const WIDTH: u32 = 64;
const HEIGHT: u32 = 48;

type MemoryOf<const ACTIVE: usize> =
    Memory<LookIn<Sub4, u16>, 6_000, 1_000, { WIDTH as usize }, { HEIGHT as usize }, ACTIVE>;

/// The words of a picture, drawn in bands of so many rows.
fn words<L: Look>(
    prepared: &mut Prepared<'_, '_, L>,
    rows: u32,
    mut draw: impl FnMut(&mut Prepared<'_, '_, L>, &mut Band<'_, L::Color>),
) -> Vec<<L::Color as BandColor>::Word>
where
    <L::Color as BandColor>::Word: Default,
{
    let mut picture = Vec::new();
    for top in (0..HEIGHT).step_by(rows as usize) {
        let mut words = vec![Default::default(); (WIDTH * rows) as usize];
        let mut part = area(WIDTH, rows);
        part.top_left.y = top as i32;
        draw(prepared, &mut Band::new(part, &mut words).unwrap());
        picture.extend(words);
    }
    picture
}

/// Compares a picture by intervals with that of the depth row.
fn check<L: Look>(prepared: &mut Prepared<'_, '_, L>, method: &mut impl Visibility<L::Depth>)
where
    <L::Color as BandColor>::Word: Default + PartialEq,
{
    for rows in [1, 6, HEIGHT] {
        let expected = words(prepared, rows, |prepared, band| prepared.draw(band));
        let drawn = words(prepared, rows, |prepared, band| prepared.draw_by(method, band).unwrap());
        assert!(drawn == expected, "bands of {rows} rows");
    }
}

fn upright(distance: i32) -> Pose {
    Pose::new(Rotation::IDENTITY, at(0, 0, distance))
}

/// Draws numbered faces once in bands of one row; returns intervals, splits, comparisons and columns that were compared one by one.
fn counted(meshes: Vec<Mesh>, pose: Pose) -> [u32; 4] {
    let (scene, camera) = (Scene::new(meshes), camera(area(WIDTH, HEIGHT)));
    let models = scene.models(pose);
    let mut memory = Box::new(MemoryOf::<200>::new());
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    let mut method = SpanScanLine::<200>::new();
    let drawn = words(&mut prepared, 1, |prepared, band| {
        prepared.draw_by(&mut method, band).unwrap()
    });
    assert!(drawn == words(&mut prepared, 1, |prepared, band| prepared.draw(band)));
    [
        method.intervals(),
        method.splits(),
        method.comparisons(),
        method.pixels_compared(),
    ]
}

/// Faces of one solid that are seen from the front hide others only where it is not convex: few depths are compared, all of them
/// at the ends of intervals.
#[test]
fn depths_are_compared_at_the_ends_of_intervals() {
    let mut torus = [0; 4];
    for frame in 0..16 {
        let pose = standard_pose(frame * 4);
        let of_torus = counted(vec![meshes::torus(), meshes::cube(0.5)], pose);
        torus = std::array::from_fn(|index| torus[index] + of_torus[index]);
        for convex in [meshes::icosphere(1.4), meshes::cube(1.0)] {
            let [intervals, splits, comparisons, pixels_compared] = counted(vec![convex], pose);
            assert!(intervals > 0);
            assert_eq!([splits, comparisons, pixels_compared], [0; 3]);
        }
    }
    let [intervals, splits, comparisons, pixels_compared] = torus;
    assert!(comparisons > 0 && comparisons < 2 * intervals, "{torus:?}");
    assert!(
        splits < intervals / 100 && pixels_compared < comparisons / 100,
        "{torus:?}"
    );
}

/// Two squares that turn so far out of each other, with the second one first in the order of models.
fn crossing_squares(turned: i16) -> Vec<Mesh> {
    let square = |depth: i16| {
        let vertices = vec![
            [-600, -500, depth],
            [-600, 500, depth],
            [600, 500, -depth],
            [600, -500, -depth],
        ];
        Mesh::new(vertices, vec![[0, 1, 2], [0, 2, 3]])
    };
    vec![square(turned), square(-turned)]
}

/// Two squares that go through each other in one column of each row.
#[test]
fn faces_that_go_through_each_other_are_split_once_a_row() {
    let [intervals, splits, comparisons, pixels_compared] = counted(crossing_squares(300), upright(1500));
    assert!(splits > 10 && splits <= HEIGHT, "{splits} splits");
    assert!(
        intervals <= 4 * HEIGHT && comparisons <= 20 * HEIGHT,
        "{intervals} {comparisons}"
    );
    assert_eq!(pixels_compared, 0);
}

/// Two squares that are less than a unit of depth apart in most columns: those are compared one by one.
#[test]
fn faces_that_are_almost_as_near_are_compared_column_by_column() {
    let [_, _, _, pixels_compared] = counted(crossing_squares(1), upright(1500));
    assert!(
        pixels_compared > 0 && pixels_compared < WIDTH * HEIGHT,
        "{pixels_compared}"
    );
}

/// The runs of a texture in perspective begin where they do in the picture of the depth row.
#[test]
fn textures_are_the_same_by_intervals() {
    let image: [[u16; 16]; 16] =
        std::array::from_fn(|row| std::array::from_fn(|column| (row * 2048 + column * 63) as u16));
    let mesh = meshes::torus();
    let coordinates: Vec<[i16; 2]> = mesh.vertices.iter().map(|[x, y, z]| [x * 4 + z, y * 5 - z]).collect();
    let skin = TexturedSkin {
        image: &image,
        coordinates: &coordinates,
    };
    let camera = camera(area(WIDTH, HEIGHT));
    let mut memory = Box::new(Memory::<Textured<Texels<Rgb565, 16, 16>>, 1_000, 1_000, 64, 48, 200>::new());
    for frame in 0..6 {
        let model = Model::with_skin(mesh.face_set(), skin)
            .unwrap()
            .with_pose(standard_pose(frame * 7));
        let models = [model];
        let mut prepared = memory.prepare(&camera, &models).unwrap();
        check(&mut prepared, &mut SpanScanLine::<200>::new());
        check(&mut prepared, &mut SpanScanLine::<0>::new());
    }
}

fn check_slots<const ACTIVE: usize>(models: &[Model<'_, Rgb888>], camera: &Camera) {
    let mut memory = Box::new(MemoryOf::<ACTIVE>::new());
    let mut prepared = memory.prepare(camera, models).unwrap();
    check(&mut prepared, &mut SpanScanLine::<200>::new());
    check(&mut prepared, &mut SpanScanLine::<3>::new());
}

/// Frames with fewer slots than faces in a row.
#[test]
fn faces_without_slots_are_set_up_for_each_interval() {
    let (scene, camera) = (
        Scene::new(vec![meshes::cube(0.7), meshes::icosphere(1.2)]),
        camera(area(WIDTH, HEIGHT)),
    );
    let models = scene.models(standard_pose(3));
    check_slots::<1>(&models, &camera);
    check_slots::<7>(&models, &camera);
    check_slots::<16>(&models, &camera);
    check_slots::<40>(&models, &camera);
}

/// Of two faces that begin in the same row one goes on where the other one has ended: below, the only slot is room enough.
#[test]
fn faces_that_end_above_a_row_take_no_slot() {
    let vertices = [
        [-500, 300],
        [-100, 300],
        [-300, 200],
        [100, 300],
        [500, 300],
        [300, -300],
    ]
    .map(|[x, y]| [x, y, 0]);
    let scene = Scene::new(vec![Mesh::new(vertices.to_vec(), vec![[0, 1, 2], [3, 4, 5]])]);
    let models = scene.models(upright(1_000));
    check_slots::<1>(&models, &camera(area(WIDTH, HEIGHT)));
}

/// A method that was left in the middle of a frame goes on in another frame, or after rows that the depth row drew.
#[test]
fn a_frame_may_be_left_at_any_row() {
    let camera = camera(area(WIDTH, HEIGHT));
    let scenes = [
        Scene::new(vec![meshes::torus()]),
        Scene::new(vec![meshes::cube(0.9), meshes::icosphere(1.2)]),
    ];
    let mut memories = [Box::new(MemoryOf::<200>::new()), Box::new(MemoryOf::<200>::new())];
    let mut method = SpanScanLine::<40>::new();
    for row in 1..HEIGHT as i32 {
        for (scene, memory) in scenes.iter().zip(&mut memories) {
            let models = scene.models(standard_pose(row as u16));
            let mut prepared = memory.prepare(&camera, &models).unwrap();
            let expected = words(&mut prepared, HEIGHT, |prepared, band| prepared.draw(band));
            for (row, by_method) in [(row - 1, true), (row, true), (row + 1, false), (row + 2, true)] {
                let mut words = [0; WIDTH as usize];
                let mut part = area(WIDTH, 1);
                part.top_left.y = row;
                let mut band = Band::<Rgb888>::new(part, &mut words).unwrap();
                if by_method {
                    prepared.draw_by(&mut method, &mut band).unwrap();
                } else {
                    prepared.draw(&mut band);
                }
                let expected = expected.iter().skip(row as usize * WIDTH as usize);
                assert!(
                    row >= HEIGHT as i32 || words.iter().eq(expected.take(WIDTH as usize)),
                    "row {row}"
                );
            }
        }
    }
}
