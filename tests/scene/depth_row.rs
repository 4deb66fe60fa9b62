//! The depth row against a full-frame reference in exact arithmetic, which starts from the snapped and cut faces.

use embedded_graphics::{pixelcolor::Rgb888, prelude::*, primitives::Rectangle};
use fixed::types::I16F16;
use proptest::prelude::*;
use zrow::{
    geometry::{Sub4, Sub8},
    scene::{Camera, DepthWidth, Memory, Model, Pose},
};

use crate::common::meshes::{self, Mesh};
use crate::common::{cases, config};
use crate::numbered_scene::{Format, LookIn, Scene, area, compare, picture};
use crate::random_faces::{faces, pose};
use crate::snapped_faces::{camera, snapped, standard_pose};

type SmallMemory<S, D> = Memory<LookIn<S, D>, 400, 64, 128, 64, 64>;

/// All frames of a standard scene; returns how many pixels differ.
fn standard<S: Format<D>, D: DepthWidth>(meshes: Vec<Mesh>) -> usize {
    let scene = Scene::new(meshes);
    let area = area(128, 64);
    let mut memory = Box::new(Memory::<LookIn<S, D>, 296, 588, 128, 64, 128>::new());
    let mut differing = 0;
    for number in 0..64 {
        let models = scene.models(standard_pose(number));
        let mut prepared = memory.prepare(&camera(area), &models).unwrap();
        differing += compare(&mut prepared, area);
        assert!(picture(&mut prepared, area).iter().flatten().count() > 500);
    }
    differing
}

fn standard_scenes<S: Format<D>, D: DepthWidth>() -> [usize; 3] {
    meshes::standard_scenes().map(standard::<S, D>)
}

#[test]
fn standard_scenes_with_16_bits() {
    assert_eq!(standard_scenes::<Sub4, u16>(), [0, 0, 0]);
    assert_eq!(standard_scenes::<Sub8, u16>(), [0, 0, 0]);
}

#[test]
fn standard_scenes_with_32_bits() {
    assert_eq!(standard_scenes::<Sub4, u32>(), [0, 0, 0]);
    assert_eq!(standard_scenes::<Sub8, u32>(), [0, 0, 0]);
}

/// Draws a mesh with every precision and width; returns how many pixels differ.
fn all_formats(mesh: Mesh, pose: Pose, camera: &Camera) -> [usize; 4] {
    fn one<S: Format<D>, D: DepthWidth>(models: &[Model<'_, Rgb888>], camera: &Camera) -> usize {
        let mut memory = SmallMemory::<S, D>::new();
        let mut prepared = memory.prepare(camera, models).unwrap();
        compare(&mut prepared, camera.viewport().to_rectangle())
    }
    let scene = Scene::new(vec![mesh]);
    let models = scene.models(pose);
    [
        one::<Sub4, u16>(&models, camera),
        one::<Sub4, u32>(&models, camera),
        one::<Sub8, u16>(&models, camera),
        one::<Sub8, u32>(&models, camera),
    ]
}

/// Most pixels that may differ within the tolerance of `compare`: one in a thousand.
const FEW: usize = 48 * 40 / 1000 + 1;

proptest! {
    #![proptest_config(config(cases(12, 48)))]

    /// Faces that go through each other, in front of the near plane.
    #[test]
    fn interpenetrating_faces(mesh in faces(600, 12), pose in pose(1300..2500)) {
        let differing = all_formats(mesh, pose, &camera(area(48, 40)));
        prop_assert!(differing.iter().all(|&pixels| pixels <= FEW), "{differing:?}");
    }

    /// Around the camera: cut by the near plane and the guard band.
    #[test]
    fn faces_around_the_camera(mesh in faces(4000, 6), pose in pose(-500..800)) {
        let differing = all_formats(mesh, pose, &camera(area(48, 40)));
        prop_assert!(differing.iter().all(|&pixels| pixels <= FEW), "{differing:?}");
    }

    /// The largest faces there can be.
    #[test]
    fn huge_faces(mesh in faces(i16::MAX, 5), pose in pose(-30_000..30_000)) {
        let differing = all_formats(mesh, pose, &camera(area(48, 40)));
        prop_assert!(differing.iter().all(|&pixels| pixels <= FEW), "{differing:?}");
    }

    /// Two corners close together and the third far away.
    #[test]
    fn slivers(
        corners in prop::collection::vec((prop::array::uniform3(-700i16..700), prop::array::uniform3(-2i16..=2)), 8),
        pose in pose(1300..2500),
    ) {
        let mut vertices = Vec::new();
        for pair in corners.chunks(2) {
            let (start, thin) = pair[0];
            vertices.push(start);
            vertices.push([start[0] + thin[0], start[1] + thin[1], start[2] + thin[2] * 200]);
            vertices.push(pair[1].0);
        }
        let faces = (0..4).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect();
        let differing = all_formats(Mesh::new(vertices, faces).two_sided(), pose, &camera(area(48, 40)));
        prop_assert!(differing.iter().all(|&pixels| pixels <= FEW), "{differing:?}");
    }

    /// Faces parallel to the screen whose corners lie on pixel centres or 1/16 pixel beside them, at three distances.
    #[test]
    fn corners_on_pixel_centres(
        corners in prop::collection::vec((prop::array::uniform2(-20i16..20), prop::array::uniform2(-1i16..=1)), 18),
        distances in prop::collection::vec(0i16..3, 6),
    ) {
        let mut vertices = Vec::new();
        for (face, corners) in corners.chunks(3).enumerate() {
            for (pixel, beside) in corners {
                let [x, y] = [0, 1].map(|axis| pixel[axis] * 16 + beside[axis]);
                let scale = 1 << distances[face];
                vertices.push([x * scale, y * scale, (1 << 10) * scale]);
            }
        }
        let faces = (0..6).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect();
        // A unit is 1/16 pixel at a distance of 1,024 and 64 pixels of focal length; the centre of an odd viewport is the
        // centre of a pixel.
        let camera = camera(area(41, 39)).with_focal_length(I16F16::from_num(64)).unwrap();
        let differing = all_formats(Mesh::new(vertices, faces).two_sided(), Pose::IDENTITY, &camera);
        prop_assert_eq!(differing, [0; 4]);
    }
}

/// One unit of depth across 320 pixels, crossed by a plane that does not lean.
#[test]
fn a_depth_unit_across_the_picture() {
    // At distance z a depth unit is z² / (128 * 65,536), which is 1 where z is 2,896.
    let vertices = vec![
        [-2896, -2100, 2896],
        [-2896, 2100, 2896],
        [2897, 2100, 2897],
        [2897, -2100, 2897],
        [-2897, -700, 2897],
        [-2897, 700, 2897],
        [2896, 700, 2896],
        [2896, -700, 2896],
    ];
    let faces = vec![[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]];
    let scene = Scene::new(vec![Mesh::new(vertices, faces)]);
    let models = scene.models(Pose::IDENTITY);
    let area = area(320, 240);
    let mut memory = Box::new(Memory::<LookIn<Sub8>, 8, 4, 320, 240, 4>::new());
    let mut prepared = memory.prepare(&camera(area), &models).unwrap();
    assert_eq!(compare(&mut prepared, area), 0);
    let seen = picture(&mut prepared, area);
    for face in 0..4 {
        assert!(seen.contains(&Some(face)), "face {face} is seen");
    }
    let mut memory = Box::new(Memory::<LookIn<Sub8, u32>, 8, 4, 320, 240, 4>::new());
    assert_eq!(compare(&mut memory.prepare(&camera(area), &models).unwrap(), area), 0);
}

/// Of two faces at the same position the first is drawn, in both orders.
#[test]
fn coplanar_faces_draw_the_first() {
    let square = |z| vec![[-500, -400, z], [-500, 400, z], [500, 400, z], [500, -400, z]];
    for faces in [vec![[0u16, 1, 2], [0, 2, 3]], vec![[0, 2, 3], [0, 1, 2]]] {
        let twice = vec![
            Mesh::new(square(900), faces.clone()),
            Mesh::new(square(900), vec![[0, 1, 3], [1, 2, 3]]),
        ];
        let scene = Scene::new(twice);
        let models = scene.models(Pose::IDENTITY);
        let mut memory = SmallMemory::<Sub4, u16>::new();
        let mut prepared = memory.prepare(&camera(area(64, 48)), &models).unwrap();
        let drawn = picture(&mut prepared, area(64, 48));
        assert!(drawn.iter().flatten().all(|&face| face < 2));
        assert!(drawn.contains(&Some(0)) && drawn.contains(&Some(1)));
        assert_eq!(compare(&mut prepared, area(64, 48)), 0);
    }
}

/// Faces seen from the side have no pixels, and no faces that are not there.
#[test]
fn edge_on_faces_draw_nothing() {
    let vertices = vec![
        [-500, 0, 700],
        [500, 0, 900],
        [0, 0, 2000],
        [0, -300, 800],
        [0, 300, 1600],
    ];
    let mesh = Mesh::new(vertices, vec![[0, 1, 2], [2, 3, 4], [3, 3, 4], [0, 0, 0]]).two_sided();
    // The planes y = 0 and x = 0 go through the middle of the viewport, where the camera is.
    assert_eq!(
        all_formats(
            Mesh::new(mesh.vertices.clone(), mesh.faces.clone()),
            Pose::IDENTITY,
            &camera(area(63, 63))
        ),
        [0; 4]
    );
    let scene = Scene::new(vec![mesh]);
    let models = scene.models(Pose::IDENTITY);
    let mut memory = Box::new(Memory::<Rgb888, 5, 8, 128, 63, 0>::new());
    let mut prepared = memory.prepare(&camera(area(63, 63)), &models).unwrap();
    assert!(picture(&mut prepared, area(63, 63)).iter().all(Option::is_none));
}

/// The near plane through a vertex, through two, and just behind and before one.
#[test]
fn near_plane_through_vertices() {
    for (z0, z1, z2) in [
        (128, 300, 300),
        (128, 128, 300),
        (128, 50, 300),
        (127, 300, 300),
        (128, 50, 50),
        (127, 127, 129),
    ] {
        let vertices = vec![[-100, -90, z0], [-20, 150, z1], [140, 10, z2]];
        let mesh = Mesh::new(vertices, vec![[0, 1, 2]]).two_sided();
        assert_eq!(
            all_formats(mesh, Pose::IDENTITY, &camera(area(48, 40))),
            [0; 4],
            "{z0} {z1} {z2}"
        );
    }
}

/// A strip of squares on a plane under the camera, from behind it to far away: every pixel below the horizon is covered
/// by exactly one face, though the near plane and the guard band cut some of them.
#[test]
fn a_floor_under_the_camera_has_no_cracks() {
    fn floor<S: Format<D>, D: DepthWidth>() {
        let mut vertices = Vec::new();
        let mut faces = Vec::new();
        for row in 0..8i16 {
            for column in 0..8i16 {
                // Not quite regular, so that edges cross the pixels anywhere.
                vertices.push([column * 1200 - 4200 + row * 37, -200, row * 700 - 900 + column * 53]);
                if row > 0 && column > 0 {
                    let here = (row * 8 + column) as u16;
                    faces.push([here - 9, here - 1, here]);
                    faces.push([here - 9, here, here - 8]);
                }
            }
        }
        let area = area(96, 80);
        let whole = Scene::new(vec![Mesh::new(vertices.clone(), faces.clone())]);
        let models = whole.models(Pose::IDENTITY);
        let mut memory = Box::new(Memory::<LookIn<S, D>, 600, 98, 128, 80, 98>::new());
        let mut prepared = memory.prepare(&camera(area), &models).unwrap();
        assert!(snapped(&prepared).len() > 20);
        let all = picture(&mut prepared, area);
        let covered = all.iter().flatten().count();
        assert!(covered > 96 * 30, "{covered} pixels");

        let mut times = vec![0; all.len()];
        for face in faces {
            let one = Scene::new(vec![Mesh::new(vertices.clone(), vec![face])]);
            let models = one.models(Pose::IDENTITY);
            let mut prepared = memory.prepare(&camera(area), &models).unwrap();
            for (times, drawn) in times.iter_mut().zip(picture(&mut prepared, area)) {
                *times += usize::from(drawn.is_some());
            }
        }
        for ((point, times), drawn) in area.points().zip(times).zip(all) {
            assert_eq!(times, usize::from(drawn.is_some()), "{point:?}");
            // The floor fills the picture well below the horizon.
            assert!(point.y < 48 || times == 1, "{point:?}");
        }
    }
    floor::<Sub4, u16>();
    floor::<Sub8, u32>();
}

/// Random pictures tile: the faces of a fan cover each pixel once.
#[test]
fn a_fan_covers_each_pixel_once() {
    let area = Rectangle::new(Point::zero(), Size::new(41, 39));
    let camera = camera(area).with_focal_length(I16F16::from_num(64)).unwrap();
    for middle in [[0, 0], [5, -9], [16, 16], [-100, 33], [7, 130]] {
        // The rim is a square of 24 pixels, its corners on pixel centres.
        let rim = [
            [-192, -192],
            [-192, 0],
            [-192, 192],
            [10, 192],
            [192, 192],
            [192, -77],
            [192, -192],
        ];
        let mut vertices: Vec<[i16; 3]> = rim.iter().map(|&[x, y]| [x, y, 1024]).collect();
        vertices.push([middle[0], middle[1], 1024]);
        let mut times = vec![0; 41 * 39];
        for face in 0..7u16 {
            let scene = Scene::new(vec![Mesh::new(vertices.clone(), vec![[face, (face + 1) % 7, 7]])]);
            let models = scene.models(Pose::IDENTITY);
            let mut memory = SmallMemory::<Sub4, u16>::new();
            let mut prepared = memory.prepare(&camera, &models).unwrap();
            for (times, drawn) in times.iter_mut().zip(picture(&mut prepared, area)) {
                *times += usize::from(drawn.is_some());
            }
        }
        for (point, times) in area.points().zip(times) {
            let inside = (8..32).contains(&point.x) && (7..31).contains(&point.y);
            assert_eq!(times, usize::from(inside), "{point:?} with the middle at {middle:?}");
        }
    }
}
