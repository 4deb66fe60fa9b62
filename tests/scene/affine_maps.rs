//! Affine maps: composition, inverse and normals in exact integers, models and lights against `f64`, mirrored models bit for
//! bit.

use std::array;

use embedded_graphics::{
    pixelcolor::{Gray8, Rgb888, RgbColor},
    primitives::Rectangle,
};
use fixed::types::{I8F24, I16F16, U0F16};
use proptest::prelude::*;
use zrow::{
    geometry::{InputError, SubPixel},
    scene::{Affine, Camera, Deep, DepthWidth, FaceSet, Fine, Look, Memory, Model, Pose, Rotation},
    shade::{
        DirectionalLight, FlatLit, FlatLitSkin, Gouraud, GouraudSkin, Lambert, LitTextured, LitTexturedSkin, Shading,
        Texels, Transformed,
    },
};

use crate::common::meshes::{self, Mesh};
use crate::common::{cases, config};
use crate::numbered_scene::area;
use crate::shaded_scene::{TEXELS, words};
use crate::snapped_faces::{at, camera, standard_pose};

type Coarse = Transformed<Rgb888>;
type Finest = Fine<Deep<Transformed<Rgb888>>>;

type Numbers = [[i128; 3]; 3];

fn numbers(map: &Affine) -> Numbers {
    map.matrix.map(|row| row.map(|element| element.to_bits().into()))
}

fn affine(matrix: [[i32; 3]; 3], translation: [i32; 3]) -> Affine {
    Affine {
        matrix: matrix.map(|row| row.map(I8F24::from_bits)),
        translation: translation.map(I16F16::from_bits),
    }
}

/// The cofactors with 48 fractional bits.
fn cofactors(m: &Numbers) -> Numbers {
    array::from_fn(|row| {
        array::from_fn(|column| {
            let (r1, r2, c1, c2) = ((row + 1) % 3, (row + 2) % 3, (column + 1) % 3, (column + 2) % 3);
            m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1]
        })
    })
}

/// The determinant with 72 fractional bits.
fn determinant(m: &Numbers) -> i128 {
    let cofactors = cofactors(m);
    (0..3).map(|at| m[0][at] * cofactors[0][at]).sum()
}

/// A matrix of elements of about as many bits, of any sizes, or of the greatest there are.
fn any_matrix() -> impl Strategy<Value = [[i32; 3]; 3]> {
    let element = |bits: u32| {
        prop_oneof![
            6 => any::<i32>().prop_map(move |value| value >> (31 - bits)),
            1 => Just(0),
            1 => Just(1i32 << bits.min(30)),
        ]
    };
    let of_size = (0u32..31).prop_flat_map(move |bits| prop::array::uniform3(prop::array::uniform3(element(bits))));
    let each = (0u32..32, any::<i32>()).prop_map(|(bits, value)| value >> (31 - bits.min(31)));
    let greatest = prop::sample::select(vec![i32::MIN, i32::MIN + 1, i32::MAX, 0, 1, -1]);
    prop_oneof![
        3 => of_size,
        1 => prop::array::uniform3(prop::array::uniform3(each)),
        1 => prop::array::uniform3(prop::array::uniform3(greatest)),
        // Nearly flat: rows that are nearly multiples of each other.
        1 => (prop::array::uniform3(-1i32 << 26..1 << 26), prop::array::uniform3(prop::array::uniform3(-3i32..4)), prop::array::uniform3(-8i32..8))
            .prop_map(|(row, aside, factors)| array::from_fn(|r| array::from_fn(|c| row[c] * factors[r] + aside[r][c]))),
    ]
}

fn any_map() -> impl Strategy<Value = Affine> {
    (any_matrix(), any::<[i32; 3]>(), 0u32..20)
        .prop_map(|(matrix, translation, shift)| affine(matrix, translation.map(|part| part >> shift)))
}

proptest! {
    #![proptest_config(config(cases(2_000, 300_000)))]

    #[test]
    fn composition_is_that_of_exact_integers(first in any_map(), next in any_map()) {
        let (m, n) = (numbers(&first), numbers(&next));
        let exact: Numbers = array::from_fn(|row| {
            array::from_fn(|column| (0..3).map(|at| n[row][at] * m[at][column]).sum())
        });
        let vector = first.translation.map(|part| i128::from(part.to_bits()));
        // With 40 fractional bits.
        let moved: [i128; 3] = array::from_fn(|row| {
            (0..3).map(|at| n[row][at] * vector[at]).sum::<i128>() + (i128::from(next.translation[row].to_bits()) << 24)
        });
        // Within a unit: where the exact number is nearer to the end, either is right.
        let one = 1 << 24;
        let fits = |exact: i128, room: i128| (-(1 << 55) - room..(1 << 55) + room).contains(&exact);
        match first.then(&next) {
            Ok(found) => {
                for (found, exact) in numbers(&found).into_iter().flatten().zip(exact.into_iter().flatten()) {
                    prop_assert!(((found << 24) - exact).abs() <= one, "{} for {}", found, exact);
                }
                for (found, exact) in found.translation.into_iter().zip(moved) {
                    prop_assert!(((i128::from(found.to_bits()) << 24) - exact).abs() <= one, "{} for {}", found, exact);
                }
            }
            Err(InputError::ScaleOutOfDomain) => prop_assert!(!exact.iter().flatten().all(|&exact| fits(exact, -one))),
            Err(error) => {
                prop_assert_eq!(error, InputError::PositionOutOfDomain);
                prop_assert!(!moved.iter().all(|&exact| fits(exact, -one)));
            }
        }
    }

    #[test]
    fn the_inverse_is_that_of_exact_rationals(map in any_map()) {
        let m = numbers(&map);
        let (cofactors, determinant) = (cofactors(&m), determinant(&m));
        let found = map.inverse();
        if determinant == 0 {
            prop_assert_eq!(found, Err(InputError::ScaleOutOfDomain));
            return Ok(());
        }
        // Transposed cofactor * 2^48 / determinant, in f64 of 53 bits: far below the 2^-30 that is promised.
        let exact: [[f64; 3]; 3] = array::from_fn(|row| {
            array::from_fn(|column| cofactors[column][row] as f64 / determinant as f64 * 0.5f64.powi(-48))
        });
        let bound = |exact: f64| 0.5 + exact.abs() * (0.5f64.powi(30) + 0.5f64.powi(50));
        let greatest = exact.iter().flatten().fold(0f64, |greatest, exact| greatest.max(exact.abs()));
        match found {
            Ok(found) => {
                for (found, exact) in numbers(&found).into_iter().flatten().zip(exact.into_iter().flatten()) {
                    prop_assert!((found as f64 - exact).abs() <= bound(exact), "{} for {}", found, exact);
                }
                for (row, translation) in numbers(&found).into_iter().zip(found.translation) {
                    let moved: i128 = (0..3).map(|at| row[at] * i128::from(map.translation[at].to_bits())).sum();
                    let sum = (i128::from(translation.to_bits()) << 24) + moved;
                    prop_assert!(sum.abs() <= 1 << 24, "{}", sum);
                }
            }
            Err(InputError::ScaleOutOfDomain) => prop_assert!(greatest > 2f64.powi(31) - 4.0, "{}", greatest),
            Err(error) => {
                prop_assert_eq!(error, InputError::PositionOutOfDomain);
                let reach = (0..3).map(|row| {
                    let moved = (0..3).map(|at| exact[row][at] * f64::from(map.translation[at].to_bits()));
                    moved.sum::<f64>().abs() * 0.5f64.powi(24)
                });
                // 32,768 units, but for what the error of the elements moves.
                prop_assert!(reach.fold(0.0, f64::max) > 2f64.powi(31) - 1e6);
            }
        }
    }

    /// The inverse transpose but for a power of two and rounding: of a map and its determinant's sign.
    #[test]
    fn normals_go_by_the_inverse_transpose(map in any_map()) {
        let m = numbers(&map);
        let sign = determinant(&m).signum();
        let sign = if sign == 0 { 1 } else { sign };
        let exact = cofactors(&m).map(|row| row.map(|cofactor| cofactor * sign));
        let greatest = exact.iter().flatten().map(|cofactor| cofactor.unsigned_abs()).max().unwrap();
        let found = map.normals();
        prop_assert_eq!(found.translation, [I16F16::ZERO; 3]);
        let bits = 128 - greatest.leading_zeros() as i32;
        let shift = bits - 30;
        for (found, exact) in numbers(&found).into_iter().flatten().zip(exact.into_iter().flatten()) {
            if shift <= 0 {
                prop_assert_eq!(found, exact << -shift);
            } else {
                prop_assert!(2 * ((found << shift) - exact).abs() <= 1 << shift, "{} for {}", found, exact);
            }
        }
    }
}

fn real(map: &Affine) -> [[f64; 3]; 3] {
    map.matrix.map(|row| row.map(|element| element.to_num()))
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn unit(vector: [f64; 3]) -> [f64; 3] {
    let length = dot(vector, vector).sqrt();
    vector.map(|value| value / length)
}

fn transposed(m: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    array::from_fn(|row| array::from_fn(|column| m[column][row]))
}

fn turned(rotation: &Rotation) -> [[f64; 3]; 3] {
    rotation.matrix().map(|row| row.map(|element| element.to_num()))
}

fn any_rotation() -> impl Strategy<Value = Rotation> {
    any::<[u16; 3]>().prop_map(|angles| {
        let [a, b, c] = angles.map(U0F16::from_bits);
        Rotation::about_z(a)
            .then(&Rotation::about_x(b))
            .then(&Rotation::about_y(c))
    })
}

/// The corner of a face of one vertex, where it is on the screen: units of x, y and depth.
fn projected<L: Look<Color = Rgb888, Shading = Transformed<Rgb888>>>(
    vertex: [i16; 3],
    map: Affine,
    pose: Pose,
    camera: &Camera,
) -> Result<Option<[f64; 3]>, InputError> {
    let mesh = Mesh::new(vec![vertex], vec![[0, 0, 0]]);
    let model = Model::<Transformed<Rgb888>>::with_skin(mesh.face_set(), (&[Rgb888::RED], map)).unwrap();
    let models = [model.with_pose(pose)];
    let mut memory = Memory::<L, 1, 1, 320, 240, 0>::new();
    let prepared = memory.prepare(camera, &models)?;
    let face = prepared.faces().next();
    Ok(face.map(|face| {
        let [corner, ..] = face.corners;
        [corner.point.x_units(), corner.point.y_units(), corner.depth.units()].map(f64::from)
    }))
}

/// Checks a vertex against `f64`; `relative` is the error of the reciprocal. Returns whether it was on the screen.
fn check_vertex<L: Look<Color = Rgb888, Shading = Transformed<Rgb888>>>(
    vertex: [i16; 3],
    map: Affine,
    pose: Pose,
    camera: &Camera,
    relative: f64,
) -> bool {
    let (m, r, c) = (real(&map), turned(&pose.rotation), turned(&camera.pose().rotation));
    let point = vertex.map(f64::from);
    let mapped: [f64; 3] = array::from_fn(|row| dot(m[row], point) + map.translation[row].to_num::<f64>());
    let placed: [f64; 3] = array::from_fn(|row| {
        let (to, from) = (pose.translation[row], camera.pose().translation[row]);
        dot(r[row], mapped) + (to.to_num::<f64>() - from.to_num::<f64>())
    });
    let [x, y, z] = transposed(c).map(|row| dot(row, placed));
    let size: f64 = point.iter().map(|part| part.abs()).sum();
    // The documented bound, and what the products of rotations are rounded by for what the map and the pose move.
    let reach = mapped.iter().map(|part| part.abs()).sum::<f64>() + 200_000.0;
    let eye_error = 0.5f64.powi(12) + size * 0.5f64.powi(25) + reach * 2.0 * 0.5f64.powi(30);
    let drawn = match projected::<L>(vertex, map, pose, camera) {
        Ok(drawn) => drawn,
        Err(error) => {
            assert_eq!(error, InputError::ModelOutOfDomain { model: 0 });
            // A box around the vertex and its mirror images does not fit, or an axis is stretched too far.
            let a: [[f64; 3]; 3] = array::from_fn(|row| {
                array::from_fn(|column| {
                    dot(
                        transposed(c)[row],
                        array::from_fn(|at| dot(r[at], transposed(m)[column])),
                    )
                })
            });
            let offset: [f64; 3] =
                array::from_fn(|at| placed[at] - dot(array::from_fn(|k| dot(r[at], transposed(m)[k])), point));
            let offset = transposed(c).map(|row| dot(row, offset));
            let most = |row: usize| (0..3).map(|at| (a[row][at] * point[at]).abs()).sum::<f64>() + offset[row].abs();
            let too_large =
                (0..3).any(|row| most(row) > 262_143.99) || a.iter().flatten().any(|part| part.abs() > 127.999);
            assert!(too_large, "{vertex:?} {map:?} {pose:?}");
            return false;
        }
    };
    let near: f64 = camera.near().to_num();
    if z < near + eye_error {
        assert!(z > near - eye_error || drawn.is_none());
        return false;
    }
    let unit = f64::from(1 << L::Precision::FRACTION_BITS);
    let focal = camera.focal_length().to_num::<f64>() * unit;
    let exact = [159.5 * unit + x / z * focal, 119.5 * unit - y / z * focal];
    let error = |offset: f64| {
        let ratio = (offset / z).abs();
        focal * (eye_error / z * (1.0 + ratio) + ratio * relative + relative) + 0.51
    };
    let errors = [error(x), error(y)];
    let reach = [
        f64::from(L::Precision::MAX_UNITS) - 159.5 * unit,
        f64::from(L::Precision::MAX_UNITS) - 119.5 * unit,
        -f64::from(L::Precision::MIN_UNITS),
    ];
    let reach = reach.into_iter().fold(f64::MAX, f64::min);
    if (x / z * focal).abs() > reach - errors[0] - 2.0 || (y / z * focal).abs() > reach - errors[1] - 2.0 {
        return false;
    }
    let drawn = drawn.expect("inside the guard band");
    for at in 0..2 {
        assert!(
            (drawn[at] - exact[at]).abs() <= errors[at],
            "{} for {} +- {}",
            drawn[at],
            exact[at],
            errors[at]
        );
    }
    true
}

#[test]
fn every_vertex_is_where_its_map_and_its_pose_put_it() {
    let mut seen = 0;
    let strategy = (
        prop::array::uniform3(any::<i16>()),
        0u32..12,
        any_map(),
        any_rotation(),
        any_rotation(),
        prop::array::uniform3(-3_000i32..3_000),
        -2_000i32..30_000,
    );
    let mut runner = proptest::test_runner::TestRunner::new(config(cases(4_000, 200_000)));
    let cell = std::cell::Cell::new(0);
    runner
        .run(&strategy, |(vertex, shift, map, rotation, eye, position, distance)| {
            let vertex = vertex.map(|part| part >> shift);
            // As far from the camera as it is large, more often than not.
            let pose = Pose::new(rotation, at(position[0], position[1], distance));
            for eye in [Pose::IDENTITY, Pose::new(eye, at(100, -7, 40))] {
                let area = area(320, 240);
                let camera = Camera::new(area, I16F16::from_num(128)).unwrap().with_pose(eye);
                let drawn = check_vertex::<Coarse>(vertex, map, pose, &camera, 4.0 / 65_536.0);
                check_vertex::<Finest>(vertex, map, pose, &camera, 1.0 / 16_777_216.0);
                cell.set(cell.get() + usize::from(drawn));
            }
            Ok(())
        })
        .unwrap();
    seen += cell.get();
    assert!(seen > cases(800, 800) as usize, "{seen} vertices are on the screen");
}

/// A map that stretches as far as it goes is right, and a little farther refused: nothing wraps between.
#[test]
fn what_does_not_fit_is_refused() {
    let camera = Camera::new(area(320, 240), I16F16::from_num(128)).unwrap();
    let found = |map: Affine, vertex: [i16; 3]| projected::<Finest>(vertex, map, Pose::IDENTITY, &camera);
    let refused = Err(InputError::ModelOutOfDomain { model: 0 });
    let scaled = |factor: i32| Affine::scaled([I8F24::from_num(factor); 3]);
    assert!(matches!(found(scaled(7), [0, 0, i16::MAX]), Ok(Some(_))));
    assert_eq!(found(scaled(8), [0, 0, i16::MIN]), refused);
    assert!(matches!(found(scaled(8), [0, 0, i16::MAX]), Ok(Some(_))));
    assert!(matches!(found(scaled(100), [0, 0, 2_621]), Ok(Some(_))));
    assert_eq!(found(scaled(100), [0, 0, 2_622]), refused);
    // The box around a model, not its corner alone, and both sides of its origin.
    assert_eq!(found(scaled(100), [-2_622, 0, 2_000]), refused);
    // A row of 128 and more once it is turned.
    let wide = affine([[i32::MAX; 3], [i32::MAX; 3], [1 << 24; 3]], [0; 3]);
    let pose = Pose::new(Rotation::about_z(U0F16::from_num(0.125)), at(0, 0, 0));
    assert_eq!(projected::<Coarse>([1, 0, 500], wide, pose, &camera), refused);
    assert!(projected::<Coarse>([1, 0, 500], wide, Pose::IDENTITY, &camera).is_ok());
}

/// The normal that two bytes stand for on an octahedron.
fn normal([a, b]: [i8; 2]) -> [f64; 3] {
    let (x, y) = (f64::from(a), f64::from(b));
    let z = 127.0 - x.abs() - y.abs();
    let folded = |one: f64, other: f64| (127.0 - other.abs()) * if one < 0.0 { -1.0 } else { 1.0 };
    unit(if z < 0.0 {
        [folded(x, y), folded(y, x), z]
    } else {
        [x, y, z]
    })
}

/// xorshift64* (Marsaglia 2003, Vigna 2016).
fn generator(mut state: u64) -> impl FnMut() -> u64 {
    move || {
        state ^= state >> 12;
        state ^= state << 25;
        state ^= state >> 27;
        state.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 16
    }
}

/// Light on a surface under any map: a level of 255 is rounded by 1/2, and light is within 10/32,768.
#[test]
fn light_under_any_map_is_that_of_floating_point() {
    let mut next = generator(0x1234_5678_9abc_def1);
    let (mut least, mut greatest) = (255u8, 0u8);
    for round in 0..cases(20_000, 1_000_000) {
        let bits = next() as u32 % 10;
        let mut number = |bits: u32| (next() as i32) >> (31 - bits);
        // From tiny to large, of all shapes; every tenth one is a scale of each axis.
        let mut matrix: [[i32; 3]; 3] = array::from_fn(|_| array::from_fn(|_| number(20 + bits)));
        if round % 10 == 0 {
            matrix = array::from_fn(|row| array::from_fn(|column| if row == column { matrix[row][column] } else { 0 }));
        }
        let map = affine(matrix, [0; 3]);
        let m = numbers(&map);
        let determinant = determinant(&m);
        if determinant == 0 {
            continue;
        }
        let angles: [U0F16; 3] = array::from_fn(|_| U0F16::from_bits(number(31) as u16));
        let rotation = Rotation::about_z(angles[0])
            .then(&Rotation::about_x(angles[1]))
            .then(&Rotation::about_y(angles[2]));
        let towards: [i32; 3] = array::from_fn(|_| number(20));
        let bytes = [number(31) as i8, number(31) as i8];
        let light = Lambert {
            ambient: U0F16::from_bits(3_000),
            lights: [DirectionalLight::from_direction(towards.map(I16F16::from_bits), U0F16::MAX).unwrap()],
            points: [],
        };
        let (colors, normals) = ([Gray8::new(255)], [bytes]);
        let flat = FlatLitSkin {
            colors: &colors,
            normals: &normals,
            lights: light,
        };
        let pose = Pose::new(rotation, at(1, 2, 3));
        let (camera, mesh) = (camera(area(64, 64)), FaceSet::new(&[], &[]).unwrap());
        type Flat = Transformed<FlatLit<Gray8>>;
        let skin = (flat, map);
        let level = Flat::face(&skin, &Flat::uniforms(&skin, &pose, &camera), &mesh, 0).unwrap();
        // The exact normal, from the exact cofactors.
        let cofactors = cofactors(&m).map(|row| row.map(|part| (part * determinant.signum()) as f64));
        let in_world = turned(&rotation).map(|row| dot(row, unit(cofactors.map(|row| dot(row, normal(bytes))))));
        let cosine = dot(in_world, unit(towards.map(f64::from))).max(0.0) * 65_535.0 / 65_536.0;
        let exact = 255.0 * (cosine + 3_000.0 / 65_536.0).min(1.0);
        let bound = 0.5 + 255.0 * 10.0 / 32_768.0;
        assert!(
            (f64::from(level) - exact).abs() <= bound,
            "{level} for {exact}: {map:?} {bytes:?}"
        );
        (least, greatest) = (least.min(level), greatest.max(level));
        // The same light at a vertex, in 1/4,096 and half a level above.
        let smooth = GouraudSkin {
            colors: &colors,
            normals: &normals,
            lights: light,
        };
        type Smooth = Transformed<Gouraud<Gray8>>;
        let skin = (smooth, map);
        let channels = Smooth::vertex(&skin, &Smooth::uniforms(&skin, &pose, &camera), 0, [0; 3]);
        let exact = exact / 255.0 * 4_080.0 + 8.0;
        let found = channels.map(f64::from).into_iter().fold(0.0, f64::max);
        assert!(
            (found - exact).abs() <= 1.0 + 4_096.0 * 10.0 / 32_768.0,
            "{channels:?} for {exact}: {map:?}"
        );
    }
    assert!(least < 20 && greatest > 250, "{least} {greatest}");
}

/// A mirrored model is the model of mirrored vertices, normals and windings, bit for bit: whole, cut, and in each shading with
/// lights.
#[test]
fn a_mirrored_model_is_that_of_mirrored_vertices() {
    fn picture<L: Look<Color = Rgb888>>(
        models: &[Model<'_, L::Shading>],
        camera: &Camera,
        area: Rectangle,
    ) -> Vec<u32> {
        let mut memory = Box::new(Memory::<L, 4_000, 1_200, 128, 64, 40>::new());
        words(&mut memory.prepare(camera, models).unwrap(), area)
    }
    fn check<'a, H: Shading<Color = Rgb888>>(
        skins: [<Transformed<H> as Shading>::Skin<'a>; 2],
        meshes: [&'a Mesh; 2],
        both: bool,
    ) {
        let area = area(128, 64);
        let camera = camera(area);
        let mut covered = 0;
        for (number, distance) in [(1, 1_400), (2, 500), (3, 300), (4, 900), (5, 120)] {
            let pose = Pose::new(standard_pose(number).rotation, at(20, -10, distance));
            let beside = Pose::new(standard_pose(number + 3).rotation, at(-300, 40, distance + 200));
            let [one, other] = [0, 1].map(|which| {
                let model = Model::<Transformed<H>>::with_skin(meshes[which].face_set(), skins[which]).unwrap();
                let mut models = vec![model.with_pose(pose)];
                // A second model is found another way.
                if both {
                    models.push(model.with_pose(beside));
                }
                picture::<Transformed<H>>(&models, &camera, area)
            });
            covered += one
                .iter()
                .filter(|&&word| word != crate::shaded_scene::UNTOUCHED)
                .count();
            assert!(one == other, "{number}");
        }
        assert!(covered > 8_000, "{covered}");
    }
    let mesh = meshes::torus();
    let mut mirrored = mesh.clone();
    for vertex in &mut mirrored.vertices {
        vertex[0] = -vertex[0];
    }
    for face in &mut mirrored.faces {
        face.swap(1, 2);
    }
    let meshes = [&mesh, &mirrored];
    let maps = [[-1, 1, 1], [1, 1, 1]]
        .map(|factors| Affine::scaled(factors.map(|factor: i32| I8F24::from_num(factor) * I8F24::from_num(0.75))));
    let bytes = |number: usize| [(number * 37 % 255) as i8, (number * 91 % 255) as i8];
    // On the octahedron x changes its sign with its byte, but for bytes of -128 and where x is 0.
    let normals: Vec<[i8; 2]> = (0..700)
        .map(bytes)
        .map(|[a, b]| [if a == 0 { 1 } else { a.max(-127) }, b])
        .collect();
    let opposite: Vec<[i8; 2]> = normals.iter().map(|&[a, b]| [-a, b]).collect();
    let colors: Vec<Rgb888> = (0..700u32)
        .map(|number| Rgb888::new((number * 7) as u8, (number * 13) as u8, 200))
        .collect();
    let lights = Lambert {
        ambient: U0F16::from_num(0.2),
        lights: [DirectionalLight::from_direction(at(-3, 4, -5), U0F16::from_num(0.7)).unwrap()],
        points: [],
    };
    for both in [false, true] {
        check::<Rgb888>([0, 1].map(|which| (&colors[..], maps[which])), meshes, both);
        let normals = [&normals, &opposite];
        let flat = |which: usize| FlatLitSkin {
            colors: &colors[..],
            normals: &normals[which][..],
            lights,
        };
        check::<FlatLit<Rgb888>>([0, 1].map(|which| (flat(which), maps[which])), meshes, both);
        let smooth = |which: usize| GouraudSkin {
            colors: &colors[..],
            normals: &normals[which][..],
            lights,
        };
        check::<Gouraud<Rgb888>>([0, 1].map(|which| (smooth(which), maps[which])), meshes, both);
        let texels = TEXELS.map(|row| row.map(u32::from));
        let coordinates: Vec<[i16; 2]> = (0..700)
            .map(|number| [number * 17 % 4_096, number * 29 % 4_096])
            .collect();
        let skin = |which: usize| LitTexturedSkin {
            image: &texels,
            coordinates: &coordinates[..],
            normals: &normals[which][..],
            lights,
        };
        check::<LitTextured<Texels<Rgb888, 16, 16>>>([0, 1].map(|which| (skin(which), maps[which])), meshes, both);
    }
}

/// A pose as a map turns and moves as it does, and the inverse of both is the other way.
#[test]
fn a_pose_is_a_map() {
    for number in 0..1_000u16 {
        let pose = Pose::new(
            standard_pose(number).rotation,
            at(number.into(), -7, 3 * i32::from(number)),
        );
        let map = Affine::from(pose);
        for (found, exact) in real(&map)
            .into_iter()
            .flatten()
            .zip(turned(&pose.rotation).into_iter().flatten())
        {
            assert!((found - exact).abs() <= 0.5f64.powi(25));
        }
        assert_eq!(map.translation, pose.translation);
        let there_and_back = map.then(&map.inverse().unwrap()).unwrap();
        for (found, exact) in real(&there_and_back)
            .into_iter()
            .flatten()
            .zip(real(&Affine::IDENTITY).into_iter().flatten())
        {
            assert!((found - exact).abs() <= 4.0 * 0.5f64.powi(24), "{there_and_back:?}");
        }
    }
}

/// A coordinate of 2^18 units is one too many, also where it is negative.
#[test]
fn the_least_coordinate_of_a_stretched_model_is_that_beside_the_greatest() {
    let vertices = [[i16::MIN, 0, 0]];
    let mesh = FaceSet::new(&vertices, &[[0; 3]]).unwrap();
    let prepare = |x: i32| {
        let map = Affine {
            translation: at(x, 0, 0),
            ..Affine::scaled([7, 1, 1].map(I8F24::from_num::<i32>))
        };
        let models = [Model::<Coarse>::with_skin(mesh, (&[Rgb888::RED][..], map))
            .unwrap()
            .with_pose(Pose::new(Rotation::IDENTITY, at(0, 0, 100)))];
        let camera = Camera::new(area(64, 64), I16F16::from_num(8)).unwrap();
        let mut memory = Memory::<Coarse, 3, 1, 64, 64>::new();
        memory
            .prepare(&camera, &models)
            .map(|prepared| prepared.faces().count())
    };
    assert_eq!(prepare(-32_768), Err(InputError::ModelOutOfDomain { model: 0 }));
    assert_eq!(prepare(-32_767), Ok(0));
}
