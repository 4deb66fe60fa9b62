//! The 4x4 matrix and the perspective division against exact rationals in `i128`, and against what scenes project.

use embedded_graphics::{pixelcolor::Rgb888, prelude::*, primitives::Rectangle};
use fixed::types::{I16F16, U0F16};
use proptest::prelude::*;
use zrow::{
    clip::{ClipMatrix, ClipPoint},
    geometry::{InputError, Sub4, Sub8, SubPixel},
    scene::{Camera, DepthWidth, FaceSet, Memory, Model, Pose, Rotation, ScreenPrecision},
};
use zrow_methods::LookOf;

use crate::common::{cases, config};

/// A point of eye space, exactly, with 60 fractional bits: below 2^79.
fn exact_eye(vertex: [i16; 3], model: &Pose, camera: &Pose) -> [i128; 3] {
    let element = |pose: &Pose, row: usize, column: usize| i128::from(pose.rotation.matrix()[row][column].to_bits());
    let offset =
        |axis: usize| i128::from(model.translation[axis].to_bits()) - i128::from(camera.translation[axis].to_bits());
    [0, 1, 2].map(|row| {
        (0..3)
            .map(|axis| {
                let turned: i128 = (0..3)
                    .map(|column| element(model, axis, column) * i128::from(vertex[column]))
                    .sum();
                // The inverse of the camera's rotation is its transpose.
                element(camera, axis, row) * (turned + (offset(axis) << 14))
            })
            .sum()
    })
}

/// Position on the screen in units, as numerators of a positive denominator; `None` in front of the near plane or on it.
fn exact_position<S: SubPixel>([x, y, z]: [i128; 3], camera: &Camera) -> Option<([i128; 2], i128)> {
    if z <= 0 || z < i128::from(camera.near().to_bits()) << 44 {
        return None;
    }
    let viewport = camera.viewport();
    let focal_length = i128::from(camera.focal_length().to_bits()) << S::FRACTION_BITS;
    let denominator = z << 16;
    // From the corner of the viewport, less half a pixel to the centre of the first one.
    let [u, v] = camera.centre().map(|centre| i128::from(centre.to_bits()) - (1 << 15));
    let center = |start: i32, from_start: i128| ((i128::from(start) << 16) + from_start) * (z << S::FRACTION_BITS);
    Some((
        [
            center(viewport.left, u) + x * focal_length,
            center(viewport.top, v) - y * focal_length,
        ],
        denominator,
    ))
}

/// How far a position is from the exact one, in units.
fn distance(position: [i32; 2], exact: &([i128; 2], i128)) -> f64 {
    let (numerators, denominator) = exact;
    let off = |axis: usize| (i128::from(position[axis]) * denominator - numerators[axis]) as f64 / *denominator as f64;
    off(0).abs().max(off(1).abs())
}

/// Projects a vertex through a face of three of it; returns units of x and y, where it is on the screen.
fn projected<S: ScreenPrecision, D: DepthWidth>(vertex: [i16; 3], model: Pose, camera: &Camera) -> Option<[i32; 2]> {
    let vertices = [vertex];
    let mesh = FaceSet::new(&vertices, &[[0, 0, 0]]).unwrap();
    let models = [Model::new(mesh, &[Rgb888::RED]).unwrap().with_pose(model)];
    let mut memory = Memory::<LookOf<Rgb888, S, D>, 1, 1, 320, 240, 0>::new();
    let prepared = memory.prepare(camera, &models).unwrap();
    let corner = prepared.faces().next()?.corners[0];
    Some([corner.point.x_units(), corner.point.y_units()])
}

/// How far a scene's vertex may be from the exact position, in units, before it is rounded: eye space is rounded to 1/4096
/// unit, with `Sub4` from a matrix of 14 bits, the reciprocal has 16 or 32 bits, and the focal length whole units.
fn scene_error<S: SubPixel, D: DepthWidth>(vertex: [i16; 3], [x, y, z]: [i128; 3], camera: &Camera) -> f64 {
    let length: f64 = vertex.iter().map(|&coordinate| f64::from(coordinate).abs()).sum();
    let eye_error = if S::FRACTION_BITS == 4 {
        length / 32_768.0 + 0.002
    } else {
        (length + 200_000.0) * 0.5f64.powi(30) + 0.5 / 4096.0
    };
    let relative = if S::FRACTION_BITS == 4 && D::FRACTION_BITS == 16 {
        0.5f64.powi(15)
    } else {
        0.5f64.powi(23)
    };
    let z = z as f64 / 2f64.powi(60);
    let ratio = x.abs().max(y.abs()) as f64 / 2f64.powi(60) / z;
    let focal_length = camera.focal_length().to_num::<f64>() * f64::from(1 << S::FRACTION_BITS);
    // The focal length is rounded down to a unit.
    focal_length * (eye_error / z * (1.0 + ratio) + ratio * relative + relative) + ratio * focal_length.fract()
}

/// Checks the textbook's position of a vertex against the exact one, and the scene's against both; returns the textbook's
/// error.
fn check<S: ScreenPrecision, D: DepthWidth>(vertex: [i16; 3], model: Pose, camera: &Camera) -> f64 {
    let far = camera.near().saturating_mul(I16F16::from_num(3));
    let matrix = ClipMatrix::new(camera, &model, far).unwrap();
    let point = matrix.apply(vertex);
    let eye = exact_eye(vertex, &model, camera.pose());
    let on_screen = point.on_screen::<S>(camera);
    let Some(exact) = exact_position::<S>(eye, camera) else {
        assert!(!point.is_inside() || point.z <= 2 << 20, "in front of the near plane");
        return 0.0;
    };
    let Some(on_screen) = on_screen.map(|point| [point.x_units(), point.y_units()]) else {
        let domain = i128::from(S::MIN_UNITS + 1) * exact.1..=i128::from(S::MAX_UNITS - 1) * exact.1;
        assert!(
            !exact.0.iter().all(|numerator| domain.contains(numerator)),
            "{vertex:?} is lost"
        );
        return 0.0;
    };
    let error = distance(on_screen, &exact);
    if let Some(scene) = projected::<S, D>(vertex, model, camera) {
        let most = scene_error::<S, D>(vertex, eye, camera);
        let apart = scene[0].abs_diff(on_screen[0]).max(scene[1].abs_diff(on_screen[1]));
        assert!(f64::from(apart) <= 1.0 + most, "{scene:?}, {on_screen:?}, {most}");
        assert!(
            apart <= 1 || most > 0.49,
            "{scene:?} is more than a unit from {on_screen:?}"
        );
    }
    error
}

fn check_all(vertex: [i16; 3], model: Pose, camera: &Camera) -> f64 {
    check::<Sub4, u16>(vertex, model, camera);
    check::<Sub4, u32>(vertex, model, camera);
    check::<Sub8, u16>(vertex, model, camera).max(check::<Sub8, u32>(vertex, model, camera))
}

fn camera(size: (u32, u32), near: I16F16) -> Camera {
    Camera::new(Rectangle::new(Point::zero(), Size::new(size.0, size.1)), near).unwrap()
}

fn rotation([x, y, z]: [u16; 3]) -> Rotation {
    let angle = U0F16::from_bits;
    Rotation::about_x(angle(x))
        .then(&Rotation::about_y(angle(y)))
        .then(&Rotation::about_z(angle(z)))
}

fn pose(angles: [u16; 3], translation: [i32; 3]) -> Pose {
    Pose::new(rotation(angles), translation.map(I16F16::from_bits))
}

proptest! {
    #![proptest_config(config(cases(2_000, 100_000)))]

    /// Scenes as they are: a display, models of some hundred units in front of a camera that looks about. Positions are within
    /// one unit of each other where the numbers of a scene are right to half a unit, which they are not near the eye.
    #[test]
    fn scenes_have_the_textbooks_positions(
        vertex in [-400i16..400, -400i16..400, -400i16..400],
        model in prop::array::uniform3(any::<u16>()),
        at in prop::array::uniform3(-1_000i32 << 16..1_000 << 16),
        turn in -3_000i16..3_000,
        back in 2_000i32..4_000,
    ) {
        let angles = [turn as u16, (turn / 2) as u16, 0];
        let camera = camera((320, 240), I16F16::from_num(64)).with_pose(pose(angles, [0, 0, -back << 16]));
        let error = check_all(vertex, pose(model, at), &camera);
        prop_assert!(error < 0.501, "{}", error);
    }

    /// Any camera and any pose: the textbook's position is the nearest unit but for 1/50 unit, on viewports of up to 320 x 240
    /// pixels.
    #[test]
    fn positions_are_exact_in_any_pose(
        vertex in any::<[i16; 3]>(),
        model in prop::array::uniform3(any::<u16>()),
        at in any::<[i32; 3]>(),
        turn in prop::array::uniform3(any::<u16>()),
        from in any::<[i32; 3]>(),
        near in (8i32 << 16..9_000 << 16),
        focal_length in (1i32 << 16..=2_047 << 16),
        size in (16u32..=320, 16u32..=240),
        centre in prop::option::of(prop::array::uniform2(-16_000i32..16_000)),
    ) {
        let camera = camera(size, I16F16::from_bits(near))
            .with_focal_length(I16F16::from_bits(focal_length))
            .unwrap()
            .with_pose(pose(turn, from));
        // In 1/16 pixel, which each precision has.
        let camera = match centre {
            Some(centre) => camera.with_centre(centre.map(|units| I16F16::from_bits(units << 12))).unwrap(),
            None => camera,
        };
        let error = check_all(vertex, pose(model, at), &camera);
        prop_assert!(error < 0.52, "{}", error);
    }
}

#[test]
fn hard_cases_are_within_a_unit() {
    let edges = [-32_768i32, -32_767, -1, 0, 1, 8, 9, 32_767];
    let corners = [i16::MIN, -1, 0, 1, 8, i16::MAX];
    let mut most = 0.0f64;
    for (size, focal_length) in [
        ((320, 240), 160),
        ((320, 240), 2_047),
        ((1, 1), 2_047),
        ((320, 1), 1),
        ((1, 240), 2_047),
    ] {
        for z in edges {
            let camera = camera(size, I16F16::from_num(8))
                .with_focal_length(I16F16::from_num(focal_length))
                .unwrap()
                .with_pose(pose([0; 3], [0, 0, z << 16]));
            for &x in &corners {
                for &z in &corners {
                    let model = pose([0, 0, 0x4000], [0, 0, 0]);
                    most = most.max(check_all([x, 1, z], model, &camera));
                    most = most.max(check_all([x, x, z], Pose::IDENTITY, &camera));
                }
            }
        }
    }
    assert!(most < 0.51, "{most}");
}

#[test]
fn corners_of_the_volume_are_inside_and_beyond_them_is_not() {
    let camera = camera((100, 100), I16F16::from_num(8));
    let far = I16F16::from_num(1_000);
    let matrix = ClipMatrix::new(&camera, &Pose::IDENTITY, far).unwrap();
    let is_inside = |x, y, z| matrix.apply([x, y, z]).is_inside();
    for sign in [-1, 1] {
        assert!(is_inside(8 * sign, 8, 8) && is_inside(8, 8 * sign, 8) && is_inside(999 * sign, 999 * sign, 999));
        assert!(!is_inside(9 * sign, 8, 8) && !is_inside(8, 9 * sign, 8) && !is_inside(0, 1_000 * sign, 999));
    }
    assert!(!is_inside(0, 0, 7) && !is_inside(0, 0, 0) && !is_inside(0, 0, -8) && !is_inside(0, 0, 1_001));
    assert_eq!(matrix.apply([5, -5, 0]).w, 0);
    assert_eq!(matrix.apply([5, -5, 0]).on_screen::<Sub4>(&camera), None);
    // The corners of the viewport are half a pixel outside of the centres of its pixels.
    let units = |x, y, z| {
        let point = matrix.apply([x, y, z]).on_screen::<Sub4>(&camera).unwrap();
        (point.x_units(), point.y_units())
    };
    assert_eq!(units(-9, 9, 9), (-8, -8));
    assert_eq!(units(9, -9, 9), (99 * 16 + 8, 99 * 16 + 8));
}

#[test]
fn points_by_hand_do_not_wrap() {
    let camera = camera((320, 240), I16F16::from_num(8));
    let numbers = [i64::MIN, i64::MIN + 1, -1, 0, 1, i64::MAX - 1, i64::MAX];
    for x in numbers {
        for w in numbers {
            let point = ClipPoint { x, y: w, z: 0, w };
            let is_inside = w >= 0 && i128::from(x).abs() <= i128::from(w);
            assert_eq!(point.is_inside(), is_inside, "{point:?}");
            let on_screen = point.on_screen::<Sub8>(&camera);
            assert!(w > 0 || on_screen.is_none());
            if let Some(on_screen) = on_screen {
                let (x, w) = (i128::from(x), i128::from(w));
                // 319 half pixels, and 160 pixels for a ratio of 1; ties to the larger.
                let exact = (2 * (319 * 128 * w + 320 * 128 * x) + w).div_euclid(2 * w);
                assert_eq!(i128::from(on_screen.x_units()), exact, "{point:?}");
            }
        }
    }
}

#[test]
fn ties_go_to_the_larger_coordinate() {
    let camera = camera((2, 2), I16F16::from_num(8));
    let units = |x, y, w| {
        let point = ClipPoint { x, y, z: 0, w }.on_screen::<Sub4>(&camera).unwrap();
        (point.x_units(), point.y_units())
    };
    // 16 units for a ratio of 1, from 8 on: halves of a unit.
    assert_eq!(units(1, 1, 32), (9, 8));
    assert_eq!(units(-1, -1, 32), (8, 9));
    assert_eq!(units(3, -3, 32), (10, 10));
}

#[test]
fn the_far_plane_is_twice_as_far_away_as_the_near_one() {
    let camera = camera((10, 10), I16F16::from_num(16_384));
    let error = ClipMatrix::new(&camera, &Pose::IDENTITY, I16F16::MAX);
    assert_eq!(error, Err(InputError::FarTooClose));
    let camera = self::camera((10, 10), I16F16::from_num(16));
    assert!(ClipMatrix::new(&camera, &Pose::IDENTITY, I16F16::from_num(32)).is_ok());
    assert!(ClipMatrix::new(&camera, &Pose::IDENTITY, I16F16::from_num(31)).is_err());
    assert!(ClipMatrix::new(&camera, &Pose::IDENTITY, I16F16::MIN).is_err());
}

/// Far behind a near plane that is close to the eye, where little in the matrix tells a little more depth from the far plane.
#[test]
fn the_far_plane_is_where_it_was_set() {
    for near in [8 << 16, (8 << 16) + 1, 600_001] {
        for far in [1_000 << 16, 30_000 << 16, 2_000_000_011, i32::MAX - 1_000] {
            let camera = camera((320, 240), I16F16::from_bits(near));
            let is_inside = |z| {
                let model = pose([0; 3], [0, 0, z]);
                let matrix = ClipMatrix::new(&camera, &model, I16F16::from_bits(far)).unwrap();
                matrix.apply([0; 3]).is_inside()
            };
            // 1/8,192 unit.
            assert!(is_inside(far - 8) && !is_inside(far + 8), "{near} {far}");
        }
    }
}
