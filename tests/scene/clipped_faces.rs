//! Faces that the near plane and the guard band cut, against rays through the pixels in `f64`.

use std::f64::consts::TAU;

use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
use fixed::types::I16F16;
use proptest::prelude::*;
use zrow::{
    geometry::{InputError, Sub4, Sub8, TooSmall},
    scene::{Camera, DepthWidth, Memory, Pose, Rotation},
};

use crate::common::meshes::Mesh;
use crate::common::{cases, config};
use crate::numbered_scene::{Format, LookIn, Scene, WholeLookIn, area, picture};
use crate::snapped_faces::camera;

const WIDTH: u32 = 48;
const HEIGHT: u32 = 40;
const NEAR: f64 = 128.0;

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Whether the ray through a point of the screen meets the front of a face between the near plane and one at a distance.
fn is_seen(face: [[f64; 3]; 3], far: f64, x: f64, y: f64) -> bool {
    let focal = f64::from(WIDTH) / 2.0;
    let (center_x, center_y) = (f64::from(WIDTH - 1) / 2.0, f64::from(HEIGHT - 1) / 2.0);
    let ray = [(x - center_x) / focal, (center_y - y) / focal, 1.0];
    let [a, b, c] = face;
    // The ray is inside where it is on the same side of the three planes through the eye and an edge.
    let volume = dot(a, cross(b, c));
    let sides = [cross(b, c), cross(c, a), cross(a, b)].map(|normal| dot(normal, ray));
    let inside = volume < 0.0 && sides.iter().all(|&side| side < 0.0);
    let distance = volume / sides.iter().sum::<f64>();
    inside && distance > NEAR - 1e-6 && distance < far + 1e-6
}

/// Compares all pixels at whose centre and 0.2 pixels around it the rays agree; returns how many were seen.
fn check<S: Format<D>, D: DepthWidth>(corners: [[i16; 3]; 3]) -> usize {
    let area = area(WIDTH, HEIGHT);
    check_with::<S, D>(corners, &camera(area), f64::INFINITY)
}

/// Compares the pixels of a camera with a far plane.
fn check_with<S: Format<D>, D: DepthWidth>(corners: [[i16; 3]; 3], camera: &Camera, far: f64) -> usize {
    let scene = Scene::new(vec![Mesh::new(corners.to_vec(), vec![[0, 1, 2]])]);
    let models = scene.models(Pose::IDENTITY);
    let area = area(WIDTH, HEIGHT);
    let mut memory = Memory::<LookIn<S, D>, 40, 1, 128, 40, 8>::new();
    let mut prepared = memory.prepare(camera, &models).unwrap();
    let face = corners.map(|corner| corner.map(f64::from));
    let mut seen = 0;
    for (point, drawn) in area.points().zip(picture(&mut prepared, area)) {
        let (x, y) = (f64::from(point.x), f64::from(point.y));
        // Thin corners pass between few rays.
        let around = (0..48).map(|ray| {
            let (sine, cosine) = (f64::from(ray) * TAU / 24.0).sin_cos();
            let radius = if ray < 24 { 0.1 } else { 0.2 };
            is_seen(face, far, x + radius * cosine, y + radius * sine)
        });
        let rays: Vec<_> = around.chain([is_seen(face, far, x, y)]).collect();
        if rays.iter().all(|&ray| ray == rays[0]) {
            assert_eq!(drawn.is_some(), rays[0], "{point:?} of {corners:?}");
            seen += usize::from(rays[0]);
        }
    }
    seen
}

proptest! {
    #![proptest_config(config(cases(20, 200)))]

    /// Corners before, at and behind the near plane.
    #[test]
    fn the_near_plane_cuts_where_it_is(
        positions in prop::array::uniform3((-600i16..600, -500i16..500)),
        distances in prop::array::uniform3(-300i16..700),
    ) {
        let corners = [0, 1, 2].map(|i| [positions[i].0, positions[i].1, distances[i]]);
        for corners in [corners, [corners[0], corners[2], corners[1]]] {
            check::<Sub4, u16>(corners);
            check::<Sub8, u32>(corners);
        }
    }

    /// Corners before, at and behind the near and the far plane.
    #[test]
    fn the_far_plane_cuts_where_it_is(
        positions in prop::array::uniform3((-1_000i16..1_000, -900i16..900)),
        distances in prop::array::uniform3(prop_oneof![-300i16..1_500, 390i16..410, Just(400), Just(128)]),
    ) {
        let corners = [0, 1, 2].map(|i| [positions[i].0, positions[i].1, distances[i]]);
        let camera = camera(area(WIDTH, HEIGHT)).with_far(I16F16::from_num(400)).unwrap();
        for corners in [corners, [corners[0], corners[2], corners[1]]] {
            check_with::<Sub4, u16>(corners, &camera, 400.0);
            check_with::<Sub8, u32>(corners, &camera, 400.0);
        }
    }

    /// Faces that reach far beyond the guard band of 12.4 positions, and some beyond that of 24.8.
    #[test]
    fn the_guard_band_keeps_edges_where_they_are(
        positions in prop::array::uniform3((any::<i16>(), any::<i16>())),
        distances in prop::array::uniform3(prop::sample::select(vec![130i16, 150, 300, 2000])),
    ) {
        let corners = [0, 1, 2].map(|i| [positions[i].0, positions[i].1, distances[i]]);
        for corners in [corners, [corners[0], corners[2], corners[1]]] {
            check::<Sub4, u16>(corners);
            check::<Sub8, u32>(corners);
        }
    }
}

/// A corner on the near plane, and 1/4096 unit, which is the finest there is, behind and in front of it: only the last
/// one is cut, and its pieces take room.
#[test]
fn the_near_plane_cuts_to_the_unit() {
    fn prepared<S: Format<D>, D: DepthWidth>(behind: I16F16) -> Result<D, InputError> {
        let scene = Scene::new(vec![Mesh::new(
            vec![[-50, -40, 0], [-50, 40, 300], [60, 0, 300]],
            vec![[0, 1, 2]],
        )]);
        let near = I16F16::from_num(NEAR);
        let models = scene.models(Pose::new(
            Rotation::IDENTITY,
            [I16F16::ZERO, I16F16::ZERO, near + behind],
        ));
        let mut memory = Memory::<LookIn<S, D>, 3, 1, 128, 40, 1>::new();
        let prepared = memory.prepare(&camera(area(WIDTH, HEIGHT)), &models)?;
        let face = prepared.faces().next().expect("a whole face");
        Ok(face.corners[0].depth)
    }
    fn check<S: Format<D>, D: DepthWidth>() {
        let unit = I16F16::from_bits(1 << 4);
        let nearest = camera(area(WIDTH, HEIGHT)).depth_at::<S, D>(I16F16::from_num(NEAR));
        assert_eq!(prepared::<S, D>(I16F16::ZERO), Ok(nearest));
        assert!(prepared::<S, D>(unit).is_ok_and(|depth| depth <= nearest));
        let Err(InputError::TooSmall(TooSmall::Vertices(needed))) = prepared::<S, D>(-unit) else {
            panic!("a whole face reaches in front of the near plane");
        };
        assert!(needed > 3);
    }
    check::<Sub4, u16>();
    check::<Sub4, u32>();
    check::<Sub8, u16>();
    check::<Sub8, u32>();
}

#[test]
fn a_wall_that_begins_at_the_near_plane() {
    // Corners just behind and just before it: half a unit decides nothing, two units do.
    for z in [126, 127, 128, 129, 130] {
        let seen = check::<Sub4, u16>([[-90, -80, z], [-90, 80, z], [90, 0, 600]]);
        assert!(seen > 100, "{seen} pixels with corners at {z}");
        assert_eq!(check::<Sub4, u16>([[-90, -80, z], [90, 0, z], [-90, 80, z]]), 0);
        let flat = check::<Sub8, u16>([[-90, -80, z], [-90, 80, z], [90, 0, z]]);
        assert_eq!(flat > 0, z >= 128);
    }
}

/// A corner on the far plane, and 1/4096 unit in front of it and behind it: only the last one is cut. Where no
/// face is cut, the face stays whole.
#[test]
fn the_far_plane_cuts_to_the_unit() {
    fn check<S: Format<D>, D: DepthWidth>() {
        let far = I16F16::from_num(600);
        let camera = camera(area(WIDTH, HEIGHT)).with_far(far).unwrap();
        let unit = I16F16::from_bits(1 << 4);
        for (behind, is_cut) in [(-unit, false), (I16F16::ZERO, false), (unit, true)] {
            let scene = Scene::new(vec![Mesh::new(
                vec![[-50, -40, 0], [-50, 40, -300], [60, 0, -300]],
                vec![[0, 1, 2]],
            )]);
            let position = [I16F16::ZERO, I16F16::ZERO, far + behind];
            let models = scene.models(Pose::new(Rotation::IDENTITY, position));
            let mut memory = Memory::<LookIn<S, D>, 11, 1, 128, 40, 1>::new();
            let prepared = memory.prepare(&camera, &models).unwrap();
            assert_eq!(prepared.vertices_needed() > 3, is_cut, "{behind}");
            assert!(prepared.faces().count() > 0);
            let mut whole = Memory::<WholeLookIn<S, D>, 3, 1, 128, 40, 1>::new();
            assert_eq!(whole.prepare(&camera, &models).err(), None, "{behind}");
        }
    }
    check::<Sub4, u16>();
    check::<Sub4, u32>();
    check::<Sub8, u16>();
    check::<Sub8, u32>();
}

/// What lies behind the far plane altogether takes no fragments; the most corners that a polygon gets are nine.
#[test]
fn far_faces_are_left_out_and_large_ones_cut_at_each_plane() {
    let camera = camera(area(WIDTH, HEIGHT)).with_far(I16F16::from_num(1_000)).unwrap();
    let scene = |corners: [[i16; 3]; 3]| Scene::new(vec![Mesh::new(corners.to_vec(), vec![[0, 1, 2], [0, 2, 1]])]);
    let needed = |corners| {
        let scene = scene(corners);
        let mut memory = Memory::<Rgb888, 80, 2, 128, 40, 8>::new();
        let models = scene.models(Pose::IDENTITY);
        memory.prepare(&camera, &models).unwrap().vertices_needed()
    };
    assert_eq!(needed([[-900, -900, 1_001], [0, 900, 3_000], [900, -900, 2_000]]), 3);
    assert_eq!(needed([[-900, -900, 1_001], [0, 900, 999], [900, -900, 2_000]]), 7);
    let mut most = 0;
    for round in 0..30_000i32 {
        let number = |factor: i32, size: i32| (round.wrapping_mul(factor) % size) as i16;
        let corner = |k: i32| {
            [
                number(7_919 + k, 32_000),
                number(104_729 * k + 13, 32_000),
                number(1_299_709 + 7 * k, 2_500),
            ]
        };
        most = most.max(needed([corner(1), corner(12), corner(123)]));
    }
    assert!(most >= 3 + 4 * 4, "{most}");
    assert_eq!(
        camera.with_far(I16F16::from_num(128)).err(),
        Some(InputError::FarTooClose)
    );
}
