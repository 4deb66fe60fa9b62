//! Frames with fewer slots than faces in a row: drawn in passes, they are the pictures of frames with room for all.

use embedded_graphics::{
    pixelcolor::{Rgb565, Rgb888},
    prelude::*,
    primitives::Rectangle,
};
use fixed::types::I16F16;
use proptest::prelude::*;
use zrow::{
    band::Band,
    geometry::{InputError, Sub4, Sub8, TooSmall},
    scene::{Camera, DepthWidth, FaceSet, Look, Memory, Model, Pose, Prepared},
};

use crate::common::meshes::{self, Mesh};
use crate::common::{cases, config};
use crate::numbered_scene::{Format, LookIn, Scene, area, picture};
use crate::random_faces::{faces, pose};
use crate::snapped_faces::{camera, standard_pose};

type MemoryOf<S, D, const ACTIVE: usize> = Memory<LookIn<S, D>, 600, 128, 128, 64, ACTIVE>;

/// The faces of a picture drawn in bands of this height and width, from below or from above.
fn in_bands<L: Look<Color = Rgb888>>(
    prepared: &mut Prepared<'_, '_, L>,
    whole: Rectangle,
    [width, height]: [u32; 2],
    upwards: bool,
) -> Vec<Rgb888> {
    let mut picture = vec![Rgb888::default(); (whole.size.width * whole.size.height) as usize];
    let mut tops: Vec<u32> = (0..whole.size.height).step_by(height as usize).collect();
    if upwards {
        tops.reverse();
    }
    for top in tops {
        for left in (0..whole.size.width).step_by(width as usize) {
            let size = [(left, width, whole.size.width), (top, height, whole.size.height)]
                .map(|(start, length, end)| length.min(end - start));
            let band_area = Rectangle::new(whole.top_left + Size::new(left, top), size.into());
            let mut words = vec![0; (size[0] * size[1]) as usize];
            let mut band = Band::<Rgb888>::new(band_area, &mut words).unwrap();
            prepared.draw(&mut band);
            for (point, color) in band_area.points().zip(band.colors()) {
                let at = point - whole.top_left;
                picture[(at.y as u32 * whole.size.width + at.x as u32) as usize] = color;
            }
        }
    }
    picture
}

/// Draws models with so few slots in bands of several sizes and orders, and compares each picture.
fn check_slots<S: Format<D>, D: DepthWidth, const ACTIVE: usize>(
    models: &[Model<'_, Rgb888>],
    camera: &Camera,
    expected: &[Rgb888],
) -> u32 {
    let area = camera.viewport().to_rectangle();
    let mut memory = Box::new(MemoryOf::<S, D, ACTIVE>::new());
    let mut rows = 0;
    for (size, upwards) in [
        ([100, 100], false),
        ([100, 1], false),
        ([17, 3], false),
        ([100, 2], true),
    ] {
        let mut prepared = memory.prepare(camera, models).unwrap();
        let drawn = in_bands(&mut prepared, area, size, upwards);
        assert!(
            drawn == expected,
            "{ACTIVE} slots, bands of {size:?}, upwards: {upwards}"
        );
        rows = prepared.rows_in_passes();
        if size == [100, 1] {
            assert_eq!(rows > 0, prepared.active_needed() > ACTIVE, "{ACTIVE} slots");
        }
    }
    rows
}

/// One, two, three and seven slots against room for all.
fn check<S: Format<D>, D: DepthWidth>(models: &[Model<'_, Rgb888>], camera: &Camera) {
    let area = camera.viewport().to_rectangle();
    let mut memory = Box::new(MemoryOf::<S, D, 128>::new());
    let mut prepared = memory.prepare(camera, models).unwrap();
    let expected = in_bands(&mut prepared, area, [100, 100], false);
    assert_eq!(prepared.rows_in_passes(), 0);
    check_slots::<S, D, 1>(models, camera, &expected);
    check_slots::<S, D, 2>(models, camera, &expected);
    check_slots::<S, D, 3>(models, camera, &expected);
    check_slots::<S, D, 7>(models, camera, &expected);
}

fn check_all(meshes: Vec<Mesh>, pose: Pose, camera: &Camera) {
    let scene = Scene::new(meshes);
    let models = scene.models(pose);
    check::<Sub4, u16>(&models, camera);
    check::<Sub4, u32>(&models, camera);
    check::<Sub8, u16>(&models, camera);
    check::<Sub8, u32>(&models, camera);
}

proptest! {
    #![proptest_config(config(cases(8, 64)))]

    /// Faces that go through each other.
    #[test]
    fn interpenetrating_faces(mesh in faces(600, 16), pose in pose(1300..2500)) {
        check_all(vec![mesh], pose, &camera(area(48, 40)));
    }

    /// Faces that the near plane and the guard band cut: their parts are in the table behind all faces.
    #[test]
    fn faces_around_the_camera(mesh in faces(4000, 8), pose in pose(-500..800)) {
        check_all(vec![mesh], pose, &camera(area(48, 40)));
    }

    /// Models in one place: of equally near faces the first one is drawn, in whichever pass it comes.
    #[test]
    fn models_in_one_place(mesh in faces(600, 5), pose in pose(1300..2500), slid in 0usize..5) {
        // The same faces in another order begin at other places of the table.
        let mut faces = mesh.faces.clone();
        let count = faces.len();
        faces.rotate_left(slid % count);
        let other = Mesh::new(mesh.vertices.clone(), faces);
        check_all(vec![mesh, other], pose, &camera(area(48, 40)));
    }
}

/// Rows of coplanar faces whose first rows run against the order of the models: the later a face comes in the table, the
/// earlier it is in the order.
#[test]
fn equally_near_faces_whose_order_is_not_that_of_the_table() {
    let count = 9i16;
    let vertices = (0..count)
        .flat_map(|face| {
            let top = 100 * (face - count / 2);
            [[-700, top + 400, 900], [700, top + 400, 900], [0, -900, 900]]
        })
        .collect();
    let faces = (0..count as u16)
        .map(|face| [3 * face, 3 * face + 1, 3 * face + 2])
        .collect();
    let mesh = Mesh::new(vertices, faces).two_sided();
    let scene = Scene::new(vec![mesh]);
    let models = scene.models(Pose::IDENTITY);
    let camera = camera(area(64, 60));
    check::<Sub4, u16>(&models, &camera);
    let mut memory = Box::new(MemoryOf::<Sub4, u16, 1>::new());
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    let mut seen = picture(&mut prepared, area(64, 60));
    seen.sort();
    seen.dedup();
    assert!(seen.len() > 4, "{seen:?}");
}

/// The standard scenes at one frame in eight, with a quarter of the slots that they need: rows that fit go on from row to row
/// between those in passes.
#[test]
fn standard_scenes_with_a_quarter_of_the_slots() {
    let scene = Scene::new(vec![meshes::torus(), meshes::cube(0.5)]);
    let area = area(128, 64);
    let mut large = Box::new(Memory::<Rgb888, 296, 588, 128, 64, 60>::new());
    let mut small = Box::new(Memory::<Rgb888, 296, 588, 128, 64, 14>::new());
    for number in (0..64).step_by(8) {
        let models = scene.models(standard_pose(number));
        let expected = picture(&mut large.prepare(&camera(area), &models).unwrap(), area);
        let camera = camera(area);
        let mut prepared = small.prepare(&camera, &models).unwrap();
        assert!(picture(&mut prepared, area) == expected, "frame {number}");
        let rows = prepared.rows_in_passes();
        assert!((1..64).contains(&rows), "{rows} rows in passes");
        // The next frame that fits takes none.
        let cube = Scene::new(vec![meshes::cube(0.2)]);
        let models = cube.models(standard_pose(number));
        let mut prepared = small.prepare(&camera, &models).unwrap();
        picture(&mut prepared, area);
        assert_eq!(prepared.rows_in_passes(), 0);
    }
}

/// A frame without slots has room for no face, and says so.
#[test]
fn without_slots_faces_are_an_error() {
    let scene = Scene::new(vec![meshes::cube(0.5)]);
    let models = scene.models(standard_pose(0));
    let mut memory = Memory::<Rgb888, 8, 12, 128, 64, 0>::new();
    let error = memory.prepare(&camera(area(128, 64)), &models).err();
    assert_eq!(error, Some(InputError::TooSmall(TooSmall::ActiveFaces(1))));
    assert!(memory.prepare(&camera(area(128, 64)), &[]).is_ok());
}

/// As many faces as a table holds, and one of them in two fragments: more than a signed number of 16 bits counts.
#[test]
fn a_row_with_more_nodes_than_faces_fit_a_table() {
    const FACES: usize = 32_767;
    let area = area(4, 4);
    let camera = Camera::new(area, I16F16::from_num(128)).unwrap();
    let vertices = [
        [-4000, -2000, 1000],
        [0, 4000, 1000],
        [4000, -2000, 1000],
        // Nearer, and the near plane cuts it above the picture.
        [-600, -400, 300],
        [0, 900, 100],
        [600, -400, 300],
    ];
    let mut faces = vec![[0, 1, 2]; FACES];
    let mut colors = vec![Rgb565::BLUE; FACES];
    (faces[FACES - 1], colors[FACES - 1]) = ([3, 4, 5], Rgb565::RED);
    let models = [Model::new(FaceSet::new(&vertices, &faces).unwrap(), &colors).unwrap()];
    let mut memory = Box::new(Memory::<Rgb565, 14, FACES, 4, 4>::new());
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    assert_eq!(prepared.vertices_needed(), 14);
    assert_eq!(prepared.active_needed(), FACES + 1);
    let mut words = [0; 16];
    prepared.draw(&mut Band::<Rgb565>::new(area, &mut words).unwrap());
    assert_eq!(words, [Rgb565::RED.into_storage(); 16]);
    assert_eq!(prepared.rows_in_passes(), 4);
}
