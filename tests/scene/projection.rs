//! Rotations and the projection against `f64`.

use embedded_graphics::{pixelcolor::Rgb888, prelude::*, primitives::Rectangle};
use fixed::types::{I16F16, U0F16};
use proptest::prelude::*;
use zrow::{
    geometry::{Sub4, Sub8},
    scene::{Camera, DepthWidth, FaceSet, Memory, Model, Pose, Rotation},
};

use crate::common::{cases, config};
use crate::numbered_scene::{Format, LookIn};

type Matrix = [[f64; 3]; 3];

fn matrix(rotation: &Rotation) -> Matrix {
    rotation.matrix().map(|row| row.map(|element| element.to_num()))
}

fn about(axis: usize, angle: U0F16) -> Matrix {
    let (sine, cosine) = (angle.to_num::<f64>() * std::f64::consts::TAU).sin_cos();
    let (next, after) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut matrix = [[0.0; 3]; 3];
    matrix[axis][axis] = 1.0;
    matrix[next][next] = cosine;
    matrix[after][after] = cosine;
    matrix[next][after] = -sine;
    matrix[after][next] = sine;
    matrix
}

fn product(left: &Matrix, right: &Matrix) -> Matrix {
    [0, 1, 2].map(|row| [0, 1, 2].map(|column| (0..3).map(|k| left[row][k] * right[k][column]).sum()))
}

fn largest_difference(left: &Matrix, right: &Matrix) -> f64 {
    let pairs = left.iter().flatten().zip(right.iter().flatten());
    pairs.map(|(left, right)| (left - right).abs()).fold(0.0, f64::max)
}

fn transposed(matrix: &Matrix) -> Matrix {
    [0, 1, 2].map(|row| [0, 1, 2].map(|column| matrix[column][row]))
}

const IDENTITY: Matrix = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// The sine and the cosine that a rotation has in its matrix, in 2.30.
fn sine_and_cosine(bits: u16) -> (i32, i32) {
    let [_, [_, cosine, _], [_, sine, _]] = *Rotation::about_x(U0F16::from_bits(bits)).matrix();
    (sine.to_bits(), cosine.to_bits())
}

#[test]
fn every_rotation_is_near_the_true_one_and_keeps_lengths() {
    let closeness = 0.5f64.powi(27);
    for bits in 0..=u16::MAX {
        let angle = U0F16::from_bits(bits);
        let rotations = [
            Rotation::about_x(angle),
            Rotation::about_y(angle),
            Rotation::about_z(angle),
        ];
        for (axis, rotation) in rotations.iter().map(matrix).enumerate() {
            assert!(
                largest_difference(&rotation, &about(axis, angle)) < closeness,
                "{angle}"
            );
            let unit = product(&rotation, &transposed(&rotation));
            assert!(largest_difference(&unit, &IDENTITY) < 2.0 * closeness, "{angle}");
        }
    }
}

#[test]
fn sines_have_the_symmetries_of_the_circle() {
    const QUARTER: u16 = 1 << 14;
    const ONE: i32 = 1 << 30;
    let quarters = [0, 1, 2, 3].map(|quarter| sine_and_cosine(quarter * QUARTER));
    assert_eq!(quarters, [(0, ONE), (ONE, 0), (0, -ONE), (-ONE, 0)]);
    for bits in 0..=u16::MAX {
        let (sine, cosine) = sine_and_cosine(bits);
        assert_eq!(sine_and_cosine(bits.wrapping_neg()), (-sine, cosine), "{bits}");
        assert_eq!(sine_and_cosine(bits.wrapping_add(QUARTER)), (cosine, -sine), "{bits}");
        let (next, _) = sine_and_cosine(bits.wrapping_add(1));
        let rises = bits.wrapping_add(QUARTER) < 2 * QUARTER;
        assert!(if rises { next >= sine } else { next <= sine }, "{bits}");
    }
}

#[test]
fn quarter_turns_and_composition() {
    for quarters in 0..4u16 {
        let angle = U0F16::from_bits(quarters << 14);
        assert!(largest_difference(&matrix(&Rotation::about_y(angle)), &about(1, angle)) < 1e-15);
    }
    let (a, b) = (
        Rotation::about_x(U0F16::from_bits(9000)),
        Rotation::about_z(U0F16::from_bits(50_000)),
    );
    let both = product(&matrix(&b), &matrix(&a));
    assert!(largest_difference(&matrix(&a.then(&b)), &both) < 1e-8);
    let back = a.then(&b).then(&a.then(&b).inverse());
    assert!(largest_difference(&matrix(&back), &IDENTITY) < 3e-8);
}

/// A point in eye space, exactly, from the matrices as they are.
fn eye(vertex: [i16; 3], model: &Pose, camera: &Pose) -> [f64; 3] {
    let rotated = |matrix: &Matrix, vector: [f64; 3]| {
        [0, 1, 2].map(|row| (0..3).map(|column| matrix[row][column] * vector[column]).sum::<f64>())
    };
    let vertex = rotated(&matrix(&model.rotation), vertex.map(f64::from));
    let moved = [0, 1, 2].map(|axis| {
        vertex[axis] + (model.translation[axis].to_num::<f64>() - camera.translation[axis].to_num::<f64>())
    });
    rotated(&transposed(&matrix(&camera.rotation)), moved)
}

/// Projects a vertex through a face of three of it; returns units of x, y and depth, where it is on the screen.
fn projected<S: Format<D>, D: DepthWidth>(vertex: [i16; 3], model: Pose, camera: &Camera) -> Option<[f64; 3]> {
    let vertices = [vertex];
    let mesh = FaceSet::new(&vertices, &[[0, 0, 0]]).unwrap();
    let models = [Model::new(mesh, &[Rgb888::RED]).unwrap().with_pose(model)];
    let mut memory = Memory::<LookIn<S, D>, 1, 1, 320, 240, 0>::new();
    let prepared = memory.prepare(camera, &models).unwrap();
    let face = prepared.faces().next()?;
    let corner = face.corners[0];
    Some([corner.point.x_units(), corner.point.y_units(), corner.depth.units()].map(f64::from))
}

/// Checks a vertex against `f64`. The eye point is rounded to 1/4096 unit from a matrix of 14 or 30 bits, and `relative` is
/// the error of the reciprocal; half a unit is the snapping.
fn check<S: Format<D>, D: DepthWidth>(vertex: [i16; 3], model: Pose, camera: &Camera, relative: f64) {
    let viewport = camera.viewport();
    let unit = f64::from(1 << S::FRACTION_BITS);
    let focal = camera.focal_length().to_num::<f64>() * unit;
    let near = camera.near().to_num::<f64>();
    let [x, y, z] = eye(vertex, &model, camera.pose());
    let length = vertex.iter().map(|&c| f64::from(c).abs()).sum::<f64>();
    // Of an eye coordinate: the matrix' 14 bits, the translation's rotation, the shift; or the matrix' 30 bits, which products of
    // rotations are rounded to, for the vertex and for a translation of up to 113,600 units, and half of 1/4096.
    let eye_error = if S::FRACTION_BITS == 4 {
        length / 32_768.0 + 0.002
    } else {
        (length + 200_000.0) * 0.5f64.powi(30) + 0.5 / 4096.0
    };
    let drawn = projected::<S, D>(vertex, model, camera);
    if z < near - eye_error {
        assert_eq!(drawn, None, "in front of the near plane");
        return;
    }
    if z < near + eye_error {
        return;
    }
    let center = |start: i32, end: i32| f64::from(start + end - 1) / 2.0 * unit;
    let exact = [
        center(viewport.left, viewport.right) + x / z * focal,
        center(viewport.top, viewport.bottom) - y / z * focal,
    ];
    let error = |offset: f64| {
        let ratio = (offset / z).abs();
        focal * (eye_error / z * (1.0 + ratio) + ratio * relative + relative) + 0.51
    };
    let (error_x, error_y) = (error(x), error(y));
    // As far as the nearest side of the guard band, everything must have a position on the screen.
    let centers = [
        center(viewport.left, viewport.right),
        center(viewport.top, viewport.bottom),
    ];
    let reach = centers
        .iter()
        .flat_map(|center| [f64::from(S::MAX_UNITS) - center, center - f64::from(S::MIN_UNITS)])
        .fold(f64::INFINITY, f64::min);
    let beyond = |axis: usize, error: f64| (exact[axis] - centers[axis]).abs() > reach - error - 2.0;
    if beyond(0, error_x) || beyond(1, error_y) {
        return;
    }
    let [drawn_x, drawn_y, drawn_z] = drawn.expect("inside the guard band");
    assert!(
        (drawn_x - exact[0]).abs() <= error_x,
        "x {drawn_x} for {} +- {error_x}",
        exact[0]
    );
    assert!(
        (drawn_y - exact[1]).abs() <= error_y,
        "y {drawn_y} for {} +- {error_y}",
        exact[1]
    );
    let (least, span) = if D::FRACTION_BITS == 16 {
        (1.0, 65_536.0)
    } else {
        (16.0, 16_777_183.0)
    };
    let exact_z = least + near / z * span;
    let error_z = span * (near / z) * (eye_error / z + 2.0 * relative) + 2.0;
    assert!(
        (drawn_z - exact_z).abs() <= error_z,
        "depth {drawn_z} for {exact_z} +- {error_z}"
    );
}

fn any_pose(reach: i32) -> impl Strategy<Value = Pose> {
    (
        prop::array::uniform3(any::<u16>()),
        prop::array::uniform3(-reach..=reach),
    )
        .prop_map(|(angles, position)| {
            let [a, b, c] = angles.map(U0F16::from_bits);
            let rotation = Rotation::about_x(a)
                .then(&Rotation::about_y(b))
                .then(&Rotation::about_z(c));
            Pose::new(rotation, position.map(I16F16::from_bits))
        })
}

fn camera(near: i32, pose: Pose) -> Camera {
    let area = Rectangle::new(Point::zero(), Size::new(320, 240));
    Camera::new(area, I16F16::from_num(near)).unwrap().with_pose(pose)
}

fn check_all(vertex: [i16; 3], model: Pose, camera: &Camera) {
    // 16-bit reciprocals: two roundings of 2^-16 each, and near/z of 15 bits.
    check::<Sub4, u16>(vertex, model, camera, 4.0 / 65_536.0);
    let relative = 1.0 / 16_777_216.0;
    check::<Sub4, u32>(vertex, model, camera, relative);
    check::<Sub8, u16>(vertex, model, camera, relative);
    check::<Sub8, u32>(vertex, model, camera, relative);
}

proptest! {
    #![proptest_config(config(cases(4_000, 4_000)))]

    /// Every vertex, wherever model and camera are.
    #[test]
    fn every_vertex_is_projected(
        vertex in prop::array::uniform3(any::<i16>()),
        model in any_pose(i32::MAX),
        pose in any_pose(i32::MAX),
        near in prop::sample::select(vec![8, 128, 5000, 32_767]),
    ) {
        check_all(vertex, model, &camera(near, pose));
    }

    /// A model of usual size before the camera.
    #[test]
    fn usual_vertices_are_projected(
        vertex in prop::array::uniform3(-700i16..700),
        model in any_pose(0),
        distance in 800i32..4000,
    ) {
        let model = Pose::new(model.rotation, [I16F16::ZERO, I16F16::ZERO, I16F16::from_num(distance)]);
        check_all(vertex, model, &camera(128, Pose::IDENTITY));
    }
}

#[test]
fn the_farthest_corners_do_not_wrap() {
    let ends = [i16::MIN, -1, 0, i16::MAX];
    let positions = [I16F16::MIN, I16F16::ZERO, I16F16::MAX];
    for x in ends {
        for y in ends {
            for z in ends {
                for position in positions {
                    for turn in [0, 8192, 10_000, 32_768] {
                        let rotation =
                            Rotation::about_x(U0F16::from_bits(turn)).then(&Rotation::about_y(U0F16::from_bits(turn)));
                        let model = Pose::new(rotation, [position; 3]);
                        check_all(
                            [x, y, z],
                            model,
                            &camera(8, Pose::new(Rotation::IDENTITY, [I16F16::MIN; 3])),
                        );
                        check_all([x, y, z], model, &camera(128, Pose::IDENTITY));
                    }
                }
            }
        }
    }
}

/// Of a corner 20,000 units from the origin of its model, how far it is from the exact place on the screen, in pixels: seen at a
/// distance, and from there on turned in steps.
fn largest_error<S: Format<u32>>(distance: i32) -> f64 {
    let camera = camera(128, Pose::IDENTITY)
        .with_focal_length(I16F16::from_num(256))
        .unwrap();
    let mut largest = 0f64;
    for turn in (0..65_536).step_by(97) {
        let rotation = Rotation::about_x(U0F16::from_bits(turn as u16))
            .then(&Rotation::about_y(U0F16::from_bits((turn * 3) as u16)));
        // The corner is brought to the middle of the picture, at that distance, but for a whole unit.
        let vertex = [0, 0, 20_000];
        let [x, y, z] = eye(vertex, &Pose::new(rotation, [I16F16::ZERO; 3]), camera.pose());
        let translation = [-x, -y, f64::from(distance) - z].map(|way| I16F16::from_num(way.round()));
        let model = Pose::new(rotation, translation);
        let Some([drawn_x, drawn_y, _]) = projected::<S, u32>(vertex, model, &camera) else {
            panic!("in the middle of the picture");
        };
        let [x, y, z] = eye(vertex, &model, camera.pose());
        let unit = f64::from(1 << S::FRACTION_BITS);
        let exact = [159.5 + x / z * 256.0, 119.5 - y / z * 256.0];
        for (drawn, exact) in [drawn_x, drawn_y].into_iter().zip(exact) {
            largest = largest.max((drawn / unit - exact).abs());
        }
    }
    largest
}

/// The finer precision is fine far from the origin of a model too, and the coarser one is what it is.
#[test]
fn a_corner_far_from_the_origin_is_in_its_place() {
    for (distance, coarse) in [(600, 0.1..0.4), (150, 0.4..1.2)] {
        let fine = largest_error::<Sub8>(distance);
        assert!(fine < 1.0 / 64.0, "{fine} pixels at {distance}");
        let found = largest_error::<Sub4>(distance);
        assert!(coarse.contains(&found), "{found} pixels at {distance}");
    }
}

/// A point of the world is at the same place through every model at whole units, with the same rotation.
#[test]
fn a_point_through_two_models_lands_on_the_same_unit() {
    let (mut seen, mut differing) = (0, 0);
    for number in 0..2_000i32 {
        let turned = |factor: i32| U0F16::from_bits((number * factor) as u16);
        let rotation = Rotation::about_x(turned(7_919)).then(&Rotation::about_z(turned(104_729)));
        let camera = camera(128, Pose::new(rotation, [3, -7, 11].map(I16F16::from_num)));
        let through = |shift: i32| {
            let position = [number % 61 - 30 + shift, 40 - number % 77 - 2 * shift, 700 + 3 * shift];
            let vertex = [-shift, 2 * shift, -3 * shift].map(|part| part as i16);
            let model = Pose::new(Rotation::IDENTITY, position.map(I16F16::from_num));
            (
                projected::<Sub8, u32>(vertex, model, &camera),
                projected::<Sub4, u32>(vertex, model, &camera),
            )
        };
        let (fine, coarse) = through(0);
        seen += u32::from(fine.is_some());
        for shift in [1, 90, 4_001, 10_000] {
            let (same, other) = through(shift);
            assert_eq!(fine, same, "{number} {shift}");
            differing += u32::from(coarse != other);
        }
    }
    assert!(seen > 200, "{seen} points are in front of the camera");
    assert!(differing > 0, "the coarser precision promises nothing of the kind");
}
