//! Rotations about any axis, from quaternions and towards directions, and poses one after the other: against `f64`, and lengths and
//! angles in exact integers.

use embedded_graphics::{pixelcolor::Rgb888, prelude::*, primitives::Rectangle};
use fixed::types::{I2F30, I16F16, U0F16};
use proptest::prelude::*;
use zrow::{
    geometry::InputError,
    scene::{Camera, FaceSet, Memory, Model, Pose, Rotation},
};

use crate::common::{cases, config};
use crate::rotations::{deviation, is_right_handed};

/// 2^-30 in 4.60: a unit of what matrices differ from being orthonormal by.
const UNIT: i128 = 1 << 30;

fn numbers<const N: usize>(bits: [i32; N]) -> [f64; N] {
    bits.map(f64::from)
}

fn length(vector: &[f64]) -> f64 {
    vector.iter().map(|value| value * value).sum::<f64>().sqrt()
}

fn unit<const N: usize>(vector: [f64; N]) -> [f64; N] {
    let length = length(&vector);
    vector.map(|value| value / length)
}

fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

fn dot(one: [f64; 3], other: [f64; 3]) -> f64 {
    one.iter().zip(other).map(|(one, other)| one * other).sum()
}

fn matrix(rotation: &Rotation) -> [[f64; 3]; 3] {
    rotation.matrix().map(|row| row.map(|element| element.to_num()))
}

fn column(matrix: &[[f64; 3]; 3], index: usize) -> [f64; 3] {
    matrix.map(|row| row[index])
}

fn largest_difference(left: &[[f64; 3]; 3], right: &[[f64; 3]; 3]) -> f64 {
    let pairs = left.iter().flatten().zip(right.iter().flatten());
    pairs.map(|(left, right)| (left - right).abs()).fold(0.0, f64::max)
}

fn fixed(bits: [i32; 3]) -> [I16F16; 3] {
    bits.map(I16F16::from_bits)
}

/// A coordinate of a vector, in bits: of any size, small ones as often as large ones, and the ends.
fn coordinate() -> impl Strategy<Value = i32> {
    prop_oneof![
        any::<i32>(),
        (any::<i32>(), 0u32..31).prop_map(|(bits, shift)| bits >> shift),
        prop::sample::select(vec![0, 1, -1, i32::MAX, i32::MIN, 65_536, -65_536]),
    ]
}

fn vector() -> impl Strategy<Value = [i32; 3]> {
    [coordinate(), coordinate(), coordinate()]
}

/// Whether two vectors are parallel, in exact integers.
fn are_parallel([a, b, c]: [i32; 3], [x, y, z]: [i32; 3]) -> bool {
    let product = |one: i32, other: i32| i128::from(one) * i128::from(other);
    product(b, z) == product(c, y) && product(c, x) == product(a, z) && product(a, y) == product(b, x)
}

/// Three times `up`, where both have more than the 30 bits that they are rounded to.
#[test]
fn rounding_does_not_tell_parallel_vectors_apart() {
    let up = [644_245_094, 322_122_547, 5];
    let direction = up.map(|coordinate| 3 * coordinate);
    assert_eq!(
        Rotation::look_at(fixed(direction), fixed(up)),
        Err(InputError::NoDirection)
    );
}

proptest! {
    #![proptest_config(config(cases(20_000, 1_000_000)))]

    #[test]
    fn what_looks_in_a_direction_is_a_rotation(direction in vector(), up in vector()) {
        let found = Rotation::look_at(fixed(direction), fixed(up));
        if are_parallel(direction, up) {
            prop_assert_eq!(found, Err(InputError::NoDirection));
            return Ok(());
        }
        let (to, up) = (unit(numbers(direction)), unit(numbers(up)));
        let sine = length(&cross(up, to));
        let Ok(rotation) = found else {
            // The vectors are rounded to 30 bits before they are multiplied.
            prop_assert!(sine < 0.5f64.powi(27), "{}", sine);
            return Ok(());
        };
        prop_assert!(deviation(&rotation) <= 16 * UNIT, "{} of 2^-30", deviation(&rotation) >> 30);
        prop_assert!(is_right_handed(&rotation));
        let matrix = matrix(&rotation);
        let [x, y, z] = [0, 1, 2].map(|index| column(&matrix, index));
        prop_assert!(largest_difference(&[z; 3], &[to; 3]) <= 0.5f64.powi(28));
        if sine > 0.5f64.powi(20) {
            // What is rounded of the vectors is the larger in the direction of x the closer they are.
            prop_assert!(dot(x, up).abs() <= 0.5f64.powi(27));
            prop_assert!(dot(y, up) > 0.0);
            let expected = unit(cross(up, to));
            prop_assert!(largest_difference(&[x; 3], &[expected; 3]) <= 0.5f64.powi(28) / sine);
        }
    }

    /// Of a direction that is a multiple of `up` nothing says where x is, however long both are.
    #[test]
    fn what_looks_along_up_has_no_direction(up in vector(), shift in 0u32..8, factor in -200i32..200) {
        let up = up.map(|coordinate| coordinate >> shift);
        let direction = up.map(|coordinate| coordinate.saturating_mul(factor));
        if are_parallel(direction, up) {
            prop_assert_eq!(Rotation::look_at(fixed(direction), fixed(up)), Err(InputError::NoDirection));
        }
    }

    #[test]
    fn rotations_about_any_axis(axis in vector(), angle in any::<u16>()) {
        let found = Rotation::about(fixed(axis), U0F16::from_bits(angle));
        if axis == [0; 3] {
            prop_assert_eq!(found, Err(InputError::NoDirection));
            return Ok(());
        }
        let rotation = found.unwrap();
        prop_assert!(deviation(&rotation) <= 3 * 16 * UNIT, "{} of 2^-30", deviation(&rotation) >> 30);
        prop_assert!(is_right_handed(&rotation));
        let axis = unit(numbers(axis));
        let (sine, cosine) = (f64::from(angle) / 65_536.0 * std::f64::consts::TAU).sin_cos();
        // Each unit vector, turned by the formula of Rodrigues.
        let turned = |vector: [f64; 3]| {
            let (across, along) = (cross(axis, vector), dot(axis, vector) * (1.0 - cosine));
            [0, 1, 2].map(|at| vector[at] * cosine + across[at] * sine + axis[at] * along)
        };
        let columns = [turned([1.0, 0.0, 0.0]), turned([0.0, 1.0, 0.0]), turned([0.0, 0.0, 1.0])];
        let expected = [0, 1, 2].map(|row| columns.map(|column| column[row]));
        prop_assert!(largest_difference(&matrix(&rotation), &expected) <= 0.5f64.powi(26));
    }

    #[test]
    fn rotations_from_quaternions(parts in [coordinate(), coordinate(), coordinate(), coordinate()]) {
        let quaternion = parts.map(I2F30::from_bits);
        let found = Rotation::from_quaternion(quaternion);
        if parts == [0; 4] {
            prop_assert_eq!(found, Err(InputError::NoDirection));
            return Ok(());
        }
        let rotation = found.unwrap();
        prop_assert!(deviation(&rotation) <= 2 * 16 * UNIT, "{} of 2^-30", deviation(&rotation) >> 30);
        prop_assert!(is_right_handed(&rotation));
        // The product q v q* with each unit vector.
        let [w, x, y, z] = unit(numbers(parts));
        let turned = |vector: [f64; 3]| {
            let across = cross([x, y, z], vector);
            let again = cross([x, y, z], across);
            [0, 1, 2].map(|at| vector[at] + 2.0 * (w * across[at] + again[at]))
        };
        let columns = [turned([1.0, 0.0, 0.0]), turned([0.0, 1.0, 0.0]), turned([0.0, 0.0, 1.0])];
        let expected = [0, 1, 2].map(|row| columns.map(|column| column[row]));
        prop_assert!(largest_difference(&matrix(&rotation), &expected) <= 0.5f64.powi(27));
        if parts.iter().all(|part| *part != i32::MIN) {
            let negative = Rotation::from_quaternion(parts.map(|part| I2F30::from_bits(-part))).unwrap();
            // Each is within 2^-27 of the exact one.
            prop_assert!(largest_difference(&matrix(&rotation), &matrix(&negative)) <= 0.5f64.powi(26));
        }
    }

    /// A point through two poses, one after the other, is the point through both at once; and back.
    #[test]
    fn poses_follow_each_other(first in any_pose(), second in any_pose(), point in [-32_000i16..32_000, -32_000i16..32_000, -32_000i16..32_000]) {
        let expected = moved(&second, moved(&first, point.map(f64::from)));
        let both = first.then(&second);
        let moves = moved(&second, numbers(first.translation.map(|part| part.to_bits())).map(|part| part / 65_536.0));
        if moves.iter().any(|part| part.abs() > 32_767.99) {
            // Beyond the end, or so near to it that rounding decides.
            let is_beyond = moves.iter().any(|part| part.abs() > 32_768.01);
            prop_assert!(!is_beyond || both == Err(InputError::PositionOutOfDomain));
            return Ok(());
        }
        let found = moved(&both.unwrap(), point.map(f64::from));
        // 60,000 units, at 2^-28 in each of nine elements, and a rounded position.
        prop_assert!(largest_difference(&[found; 3], &[expected; 3]) < 0.001, "{:?} {:?}", found, expected);
        if let Ok(back) = first.inverse() {
            let there = moved(&first, point.map(f64::from));
            // The inverse is the transpose: three angles and two compositions are within 56 of 2^-30 of a rotation.
            let bound = length(&point.map(f64::from)) * 56.0 * 0.5f64.powi(30) + 0.5f64.powi(15);
            prop_assert!(largest_difference(&[moved(&back, there); 3], &[point.map(f64::from); 3]) < bound);
        } else {
            prop_assert!(length(&numbers(first.translation.map(|part| part.to_bits()))) > 32_767.0 * 65_536.0);
        }
    }
}

fn any_pose() -> impl Strategy<Value = Pose> {
    (any::<[u16; 3]>(), vector()).prop_map(|([x, y, z], translation)| {
        let [x, y, z] = [x, y, z].map(U0F16::from_bits);
        let rotation = Rotation::about_x(x)
            .then(&Rotation::about_y(y))
            .then(&Rotation::about_z(z));
        Pose::new(rotation, fixed(translation))
    })
}

fn moved(pose: &Pose, point: [f64; 3]) -> [f64; 3] {
    let rows = matrix(&pose.rotation);
    let translation = numbers(pose.translation.map(|part| part.to_bits()));
    [0, 1, 2].map(|at| dot(rows[at], point) + translation[at] / 65_536.0)
}

/// About the axes of space, at every angle, it is the rotation of that axis, bit for bit.
#[test]
fn about_the_axes_it_is_about_x_y_and_z() {
    for size in [1, 3, 65_536, i32::MAX] {
        for bits in 0..=u16::MAX {
            let angle = U0F16::from_bits(bits);
            let about = |axis| Rotation::about(fixed(axis), angle).unwrap();
            assert_eq!(about([size, 0, 0]), Rotation::about_x(angle), "{bits}");
            assert_eq!(about([0, size, 0]), Rotation::about_y(angle), "{bits}");
            assert_eq!(about([0, 0, size]), Rotation::about_z(angle), "{bits}");
            assert_eq!(about([0, 0, -size]), Rotation::about_z(angle).inverse(), "{bits}");
        }
    }
}

#[test]
fn towards_the_axes_nothing_is_rounded() {
    let at = |x, y, z| fixed([x, y, z].map(|part: i32| part << 16));
    let look = |direction, up| Rotation::look_at(direction, up).unwrap();
    assert_eq!(look(at(0, 0, 5), at(0, 3, 0)), Rotation::IDENTITY);
    assert_eq!(
        look(at(7, 0, 0), at(0, 1, 0)),
        Rotation::about_y(U0F16::from_bits(0x4000))
    );
    assert_eq!(
        look(at(0, 0, -1), at(0, 1, 0)),
        Rotation::about_y(U0F16::from_bits(0x8000))
    );
    assert_eq!(
        look(at(0, -9, 0), at(0, 0, 2)),
        Rotation::about_x(U0F16::from_bits(0x4000))
    );
    let parallel = Err(InputError::NoDirection);
    assert_eq!(Rotation::look_at(at(0, 0, 0), at(0, 1, 0)), parallel);
    assert_eq!(Rotation::look_at(at(0, 1, 0), at(0, 0, 0)), parallel);
    assert_eq!(Rotation::look_at(at(3, -9, 6), at(-100, 300, -200)), parallel);
}

#[test]
fn fields_of_view() {
    let camera = Camera::new(Rectangle::new(Point::zero(), Size::new(240, 320)), I16F16::from_num(64)).unwrap();
    let mut seen = 0;
    for bits in 0..=u16::MAX {
        let half = f64::from(bits) / 65_536.0 * std::f64::consts::PI;
        let expected = 120.0 / half.tan();
        let found = camera.with_field_of_view(U0F16::from_bits(bits));
        if bits == 0 || bits >= 0x8000 || !(1.0001..2046.9).contains(&expected) {
            if bits == 0 || bits >= 0x8000 || !(0.999..2047.1).contains(&expected) {
                assert_eq!(found, Err(InputError::FocalLengthOutOfDomain), "{bits}");
            }
            continue;
        }
        let focal_length: f64 = found.unwrap().focal_length().to_num();
        // Sine and cosine are within 2^-27: nearest to half a turn 1 + cos is small.
        let tolerance = 0.5f64.powi(16) + expected * (0.5f64.powi(26) / half.sin().min(half.cos()).powi(2));
        assert!(
            (focal_length - expected).abs() <= tolerance,
            "{bits}: {focal_length} {expected}"
        );
        seen += 1;
    }
    assert!(seen > 31_000, "{seen}");
    let right_angle = camera.with_field_of_view(U0F16::from_bits(0x4000)).unwrap();
    assert_eq!(right_angle.focal_length(), I16F16::from_num(120));
}

/// What a camera looks at is in the middle of the picture, and what is above it is above.
#[test]
fn what_is_looked_at_is_in_the_middle() {
    let at = |x: i32, y: i32, z: i32| [x, y, z].map(I16F16::from_num);
    let area = Rectangle::new(Point::new(10, -4), Size::new(120, 80));
    let camera = Camera::new(area, I16F16::from_num(64)).unwrap();
    for (position, target) in [
        ([0, 300, -1100], [0, 40, 100]),
        ([-9000, 2000, 31_000], [700, -90, 4]),
        ([5, -700, 0], [1, 2, 3]),
    ] {
        let [x, y, z] = target;
        let camera = camera
            .look_at(at(position[0], position[1], position[2]), at(x, y, z), at(0, 1, 0))
            .unwrap();
        let [x, y, z] = target.map(|part| part as i16);
        let vertices = [[x, y, z], [x, y + 400, z]];
        let faces = FaceSet::new(&vertices, &[[0, 1, 0]]).unwrap();
        let models = [Model::new(faces, &[Rgb888::RED]).unwrap()];
        let mut memory = Memory::<Rgb888, 2, 1, 120, 80>::new();
        let prepared = memory.prepare(&camera, &models).unwrap();
        let face = prepared.faces().next().unwrap();
        let [middle, above, _] = face
            .corners
            .map(|corner| [corner.point.x_units(), corner.point.y_units()]);
        // The middle of 120 x 80 pixels from (10, -4) is between pixels 69 and 70, and 35 and 36.
        assert!(
            (middle[0] - (69 * 16 + 8)).abs() <= 1 && (middle[1] - (35 * 16 + 8)).abs() <= 1,
            "{middle:?}"
        );
        assert!(
            (above[0] - middle[0]).abs() <= 1 && above[1] < middle[1] - 1,
            "{above:?}"
        );
    }
    let here = at(3, 4, 5);
    assert_eq!(camera.look_at(here, here, at(0, 1, 0)), Err(InputError::NoDirection));
    // From one end of the world to the other: the direction has more bits than a coordinate.
    let ends = [I16F16::MIN, I16F16::MAX];
    let camera = camera.look_at([ends[0]; 3], [ends[1]; 3], at(0, 1, 0)).unwrap();
    let third = 1.0 / 3.0f64.sqrt();
    let forward = column(&matrix(&camera.pose().rotation), 2);
    assert!(largest_difference(&[forward; 3], &[[third; 3]; 3]) < 0.5f64.powi(28));
}
