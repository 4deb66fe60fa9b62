//! Diffuse light against floating point.

use std::array;

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use fixed::types::{I16F16, U0F16};
use proptest::prelude::*;
use zrow::{
    geometry::InputError,
    scene::{Model, Pose, Rotation},
    shade::{DirectionalLight, FlatLit, FlatLitSkin, Gouraud, GouraudSkin, Lambert, Shading},
};

use crate::common::meshes::Mesh;
use crate::common::{cases, config};
use crate::shaded_scene::{SmallMemory, UNTOUCHED, camera_in_units, words};
use crate::snapped_faces::at;

/// A direction and an intensity.
type Light = ([i32; 3], u16);

const NONE: Light = ([0, 0, -1], 0);

fn directional(([x, y, z], intensity): Light) -> DirectionalLight {
    let towards = [x, y, z].map(I16F16::from_bits);
    DirectionalLight::from_direction(towards, U0F16::from_bits(intensity)).unwrap()
}

fn lambert<const LIGHTS: usize>(ambient: u16, lights: [Light; LIGHTS]) -> Lambert<LIGHTS> {
    Lambert {
        ambient: U0F16::from_bits(ambient),
        lights: lights.map(directional),
        points: [],
    }
}

fn unit(vector: [f64; 3]) -> [f64; 3] {
    let length = vector.iter().map(|value| value * value).sum::<f64>().sqrt();
    vector.map(|value| value / length)
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

fn matrix(rotation: &Rotation) -> [[f64; 3]; 3] {
    rotation.matrix().map(|row| row.map(|element| element.to_num()))
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The light on a surface of a model that is turned.
fn light<const LIGHTS: usize>(ambient: u16, lights: [Light; LIGHTS], bytes: [i8; 2], rotation: &Rotation) -> f64 {
    let normal = normal(bytes);
    let in_world = matrix(rotation).map(|row| dot(row, normal));
    let of_lights = lights.map(|(towards, intensity)| {
        f64::from(intensity) / 65_536.0 * dot(unit(towards.map(f64::from)), in_world).max(0.0)
    });
    (f64::from(ambient) / 65_536.0 + of_lights.iter().sum::<f64>()).min(1.0)
}

/// A triangle that faces the camera once it is turned.
fn facing(rotation: &Rotation) -> Mesh {
    let rows = matrix(rotation);
    let back = |point: [f64; 3]| {
        array::from_fn(|axis| dot(point, [rows[0][axis], rows[1][axis], rows[2][axis]]).round() as i16)
    };
    let corners = [[-700.0, -500.0, 0.0], [0.0, 500.0, 0.0], [700.0, -500.0, 0.0]];
    Mesh::new(corners.map(back).to_vec(), vec![[0, 1, 2]]).two_sided()
}

/// The levels, of 255, that a white triangle has with a shading.
fn level_of<'a, H: Shading<Color = Rgb888>>(mesh: &'a Mesh, skin: H::Skin<'a>, rotation: Rotation) -> u8 {
    let camera = camera_in_units();
    let pose = Pose::new(rotation, at(0, 0, 1_024));
    let models = [Model::<H>::with_skin(mesh.face_set(), skin).unwrap().with_pose(pose)];
    let mut memory = Box::new(SmallMemory::<H>::new());
    let words = words(
        &mut memory.prepare(&camera, &models).unwrap(),
        camera.viewport().to_rectangle(),
    );
    let mut drawn = words.into_iter().filter(|&word| word != UNTOUCHED);
    let first = drawn.next().expect("the triangle is seen");
    assert!(drawn.all(|word| word == first), "one normal, one light");
    let [_, r, g, b] = first.to_be_bytes();
    assert!(r == g && g == b, "white light");
    r
}

/// The levels of a triangle with one normal, in Gouraud shading and with one brightness a face.
fn levels<const LIGHTS: usize>(lights: Lambert<LIGHTS>, normal: [i8; 2], rotation: Rotation) -> [u8; 2] {
    let mesh = facing(&rotation);
    let (colors, normals) = (&[Rgb888::WHITE], &[normal; 3]);
    let smooth = GouraudSkin {
        colors,
        normals,
        lights,
    };
    let flat = FlatLitSkin {
        colors,
        normals,
        lights,
    };
    [
        level_of::<Gouraud<Rgb888, Lambert<LIGHTS>>>(&mesh, smooth, rotation),
        level_of::<FlatLit<Rgb888, Lambert<LIGHTS>>>(&mesh, flat, rotation),
    ]
}

/// The levels of a triangle with one normal in Gouraud shading.
fn level<const LIGHTS: usize>(lights: Lambert<LIGHTS>, normal: [i8; 2], rotation: Rotation) -> u8 {
    levels(lights, normal, rotation)[0]
}

/// Compares the light with floating point. A level is rounded by 1/2; light is within 8/32,768, where it is doubled and
/// cut off by 1, and what varies over a face by 1.
fn check<const LIGHTS: usize>(ambient: u16, lights: [Light; LIGHTS], normal: [i8; 2], rotation: Rotation) {
    let exact = 255.0 * light(ambient, lights, normal, &rotation);
    let bound = 0.5 + 255.0 * 10.0 / 32_768.0;
    for level in levels(lambert(ambient, lights), normal, rotation).map(f64::from) {
        assert!(
            (level - exact).abs() <= bound,
            "{level}, not {exact}, {ambient}, {lights:?}, {normal:?}"
        );
    }
}

fn any_light() -> impl Strategy<Value = Light> {
    let direction = prop_oneof![
        2 => prop::array::uniform3(-100_000..100_000),
        1 => any::<[i32; 3]>(),
        1 => prop::sample::select(vec![[1, 0, 0], [0, -1, 0], [0, 0, i32::MIN], [i32::MAX; 3]]),
    ];
    let intensity = prop_oneof![any::<u16>(), Just(0), Just(u16::MAX)];
    (
        direction.prop_filter("a direction", |towards| *towards != [0; 3]),
        intensity,
    )
}

fn ambient() -> impl Strategy<Value = u16> {
    prop_oneof![any::<u16>(), Just(0), Just(u16::MAX)]
}

fn rotation() -> impl Strategy<Value = Rotation> {
    any::<[u16; 3]>().prop_map(|angles| {
        let [a, b, c] = angles.map(U0F16::from_bits);
        Rotation::about_z(a)
            .then(&Rotation::about_x(b))
            .then(&Rotation::about_y(c))
    })
}

/// A rotation that changes axes and signs alone.
fn quarters() -> impl Strategy<Value = Rotation> {
    prop::array::uniform3(0u16..4).prop_map(|quarters| {
        let [a, b, c] = quarters.map(|quarters| U0F16::from_bits(quarters << 14));
        Rotation::about_z(a)
            .then(&Rotation::about_x(b))
            .then(&Rotation::about_y(c))
    })
}

proptest! {
    #![proptest_config(config(cases(200, 5_000)))]

    #[test]
    fn light_is_that_of_floating_point(
        ambient in ambient(),
        lights in prop::array::uniform4(any_light()),
        normal in any::<[i8; 2]>(),
        rotation in rotation(),
    ) {
        let [a, b, ..] = lights;
        check(ambient, [], normal, rotation);
        check(ambient, [a], normal, rotation);
        check(ambient / 4, [a, b, NONE, NONE], normal, rotation);
        check(ambient / 8, lights, normal, rotation);
    }

    /// Neither a light behind the surface nor one without intensity changes anything.
    #[test]
    fn light_from_behind_and_without_intensity_adds_nothing(
        ambient in ambient(),
        light in any_light(),
        other in any_light(),
        normal in any::<[i8; 2]>(),
        rotation in rotation(),
    ) {
        let alone = level(lambert(ambient, [light]), normal, rotation);
        let dark = (other.0, 0);
        prop_assert_eq!(level(lambert(ambient, [light, dark, dark, dark]), normal, rotation), alone);
        prop_assert_eq!(level(lambert(ambient, [dark, dark, dark, light]), normal, rotation), alone);
        // By more than the normal's error.
        if self::light(0, [(other.0, u16::MAX)], normal, &rotation) == 0.0
            && self::light(0, [(other.0.map(|towards| towards.saturating_neg()), u16::MAX)], normal, &rotation) > 0.001
        {
            prop_assert_eq!(level(lambert(ambient, [other, other, light, other]), normal, rotation), alone);
        }
    }

    /// A model and its lights that are turned alike by quarters of a turn are as bright as before, exactly.
    #[test]
    fn turned_models_under_turned_lights_are_as_before(
        ambient in 0u16..20_000,
        light in any_light(),
        normal in any::<[i8; 2]>(),
        rotation in quarters(),
    ) {
        let towards = light.0.map(|coordinate| f64::from(coordinate.saturating_add(i32::from(coordinate == i32::MIN))));
        let before = (towards.map(|coordinate| coordinate as i32), light.1);
        let turned = matrix(&rotation).map(|row| dot(row, towards) as i32);
        prop_assert_eq!(
            level(lambert(ambient, [(turned, light.1)]), normal, rotation),
            level(lambert(ambient, [before]), normal, Rotation::IDENTITY)
        );
    }
}

/// No light is black, full ambient light is white under any lights, and half of it in the middle.
#[test]
fn ambient_light_goes_from_none_to_full() {
    let lights = [([0, 0, -65_536], u16::MAX)];
    let towards_light = [127, 127];
    let levels = |ambient| {
        [
            level(lambert(ambient, []), [0, 0], Rotation::IDENTITY),
            level(lambert(ambient, lights), towards_light, Rotation::IDENTITY),
        ]
    };
    assert_eq!(levels(0), [0, 255]);
    assert_eq!(levels(u16::MAX), [255, 255]);
    assert_eq!(level(lambert(1 << 15, []), [0, 0], Rotation::IDENTITY), 128);
}

/// A vector of length 0 has no direction.
#[test]
fn a_light_comes_from_somewhere() {
    let error = DirectionalLight::from_direction([I16F16::ZERO; 3], U0F16::MAX).err();
    assert_eq!(error, Some(InputError::NoDirection));
}
