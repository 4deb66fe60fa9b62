//! Lights from points and highlights, against floating point, for models and cameras anywhere.

use embedded_graphics::{
    pixelcolor::{Rgb888, raw::RawU24},
    prelude::*,
};
use fixed::types::{I16F16, U0F16};
use zrow::{
    band::Band,
    scene::{Camera, FaceSet, Memory, Model, Pose, Rotation},
    shade::{
        Blinn, DirectionalLight, FlatLit, FlatLitSkin, Gouraud, GouraudSkin, Lambert, Lighting, LitTextured,
        LitTexturedSkin, Perspective, PointLight, ReflectedLight, Shading, Texels,
    },
};

use crate::common::cases;
use crate::numbered_scene::area;
use crate::snapped_faces::at;

/// Full light.
const FULL: f64 = 32_768.0;

/// Numbers that look random: xorshift64 (Marsaglia 2003).
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 24) as u32
    }

    fn below(&mut self, end: u32) -> u32 {
        self.bits() % end
    }

    /// A number up to a size in both directions, as often small as large.
    fn number(&mut self, size: i32) -> i32 {
        let shift = self.below(12);
        (self.below(2 * size as u32 + 1) as i32 - size) >> shift
    }

    fn fraction(&mut self) -> U0F16 {
        match self.below(8) {
            0 => U0F16::MAX,
            1 => U0F16::ZERO,
            _ => U0F16::from_bits(self.bits() as u16),
        }
    }

    fn position(&mut self) -> [I16F16; 3] {
        [(); 3].map(|()| {
            let whole = self.number(32_767);
            I16F16::from_bits(whole << 16 | self.bits() as i32 & 0xffff)
        })
    }

    fn vertex(&mut self) -> [i16; 3] {
        [(); 3].map(|()| self.number(32_767) as i16)
    }

    fn rotation(&mut self) -> Rotation {
        let [a, b, c] = [(); 3].map(|()| U0F16::from_bits(self.bits() as u16));
        Rotation::about_z(a)
            .then(&Rotation::about_x(b))
            .then(&Rotation::about_y(c))
    }

    /// A direction of length 1 with 14 fractional bits.
    fn normal(&mut self) -> [i32; 3] {
        loop {
            let vector = [(); 3].map(|()| f64::from(self.number(10_000)));
            if length(vector) > 0.0 {
                return vector.map(|axis| (axis / length(vector) * 16_384.0).round() as i32);
            }
        }
    }

    fn point(&mut self) -> PointLight {
        PointLight {
            position: self.position(),
            intensity: self.fraction(),
            half_distance: match self.below(8) {
                0 => 0,
                1 => u16::MAX,
                _ => (self.bits() as u16) >> self.below(14),
            },
        }
    }

    fn direction(&mut self) -> DirectionalLight {
        let (towards, intensity) = (self.position(), self.fraction());
        DirectionalLight::from_direction(towards, intensity).unwrap_or(DirectionalLight::NONE)
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn length(vector: [f64; 3]) -> f64 {
    dot(vector, vector).sqrt()
}

fn unit(vector: [f64; 3]) -> [f64; 3] {
    let length = length(vector);
    vector.map(|axis| if length > 0.0 { axis / length } else { 0.0 })
}

/// From a vertex of a model to a position of the world, in the axes of the model.
fn way(pose: &Pose, vertex: [i16; 3], position: [I16F16; 3]) -> [f64; 3] {
    let matrix = pose
        .rotation
        .matrix()
        .map(|row| row.map(|element| element.to_num::<f64>()));
    let from_model = [0, 1, 2].map(|axis| position[axis].to_num::<f64>() - pose.translation[axis].to_num::<f64>());
    // The inverse of a rotation is its transpose.
    [0, 1, 2].map(|axis| dot(from_model, [0, 1, 2].map(|row| matrix[row][axis])) - f64::from(vertex[axis]))
}

/// How bright a light from a point is at the end of a way.
fn brightness(light: &PointLight, way: [f64; 3]) -> f64 {
    let (half, square) = (f64::from(light.half_distance).powi(2), dot(way, way));
    let left = if half + square > 0.0 {
        half / (half + square)
    } else {
        1.0
    };
    light.intensity.to_num::<f64>() * left
}

fn diffuse(light: &PointLight, way: [f64; 3], normal: [f64; 3]) -> f64 {
    brightness(light, way) * dot(normal, unit(way)).max(0.0)
}

/// What is mirrored into the eye of a light of brightness 1.
fn mirrored(to_light: [f64; 3], to_eye: [f64; 3], normal: [f64; 3], sharpness: u8) -> f64 {
    let [light, eye] = [unit(to_light), unit(to_eye)];
    let half = unit([0, 1, 2].map(|axis| light[axis] + eye[axis]));
    if dot(normal, light) <= 0.0 {
        return 0.0;
    }
    dot(normal, half).clamp(0.0, 1.0).powi(1 << sharpness.min(8))
}

fn real(normal: [i32; 3]) -> [f64; 3] {
    normal.map(|axis| f64::from(axis) / 16_384.0)
}

fn camera() -> Camera {
    Camera::new(area(64, 64), I16F16::from_num(128)).unwrap()
}

fn reflected<L: Lighting>(
    lights: &L,
    pose: &Pose,
    camera: &Camera,
    normal: [i32; 3],
    vertex: [i16; 3],
) -> ReflectedLight {
    let light = L::reflected(&lights.seen_from(pose, camera), normal, vertex.map(i32::from));
    for part in [light.diffuse, light.specular] {
        assert!((0..=32_768).contains(&part), "{light:?}");
    }
    light
}

fn lambert<const POINTS: usize>(points: [PointLight; POINTS]) -> Lambert<0, POINTS> {
    Lambert {
        ambient: U0F16::ZERO,
        lights: [],
        points,
    }
}

/// A light, mostly not far from a vertex of a model.
fn near(random: &mut Random, pose: &Pose, vertex: [i16; 3]) -> PointLight {
    let mut light = random.point();
    let size = 1 << random.below(12);
    if random.below(4) > 0 {
        let matrix = pose.rotation.matrix();
        light.position = [0, 1, 2].map(|axis| {
            let row = matrix[axis].map(|element| element.to_num::<f64>());
            let position = dot(row, vertex.map(f64::from)) + pose.translation[axis].to_num::<f64>();
            let beside = f64::from(random.number(1_000)) / 1_000.0 * f64::from(size);
            I16F16::saturating_from_num(position + beside)
        });
    }
    light
}

/// One light from a point on one vertex: within 10 units, and 3,000 divided by the distance, because positions in a model are
/// rounded to 1/16.
#[test]
fn lights_from_points_are_those_of_floating_point() {
    let (mut random, camera) = (Random(0x0123_4567), camera());
    for _ in 0..cases(50_000, 1_000_000) {
        let pose = Pose::new(random.rotation(), random.position());
        let (vertex, normal) = (random.vertex(), random.normal());
        let point = near(&mut random, &pose, vertex);
        let way = way(&pose, vertex, point.position);
        let exact = FULL * diffuse(&point, way, real(normal));
        let light = reflected(&lambert([point]), &pose, &camera, normal, vertex);
        assert_eq!(light.specular, 0);
        let error = (f64::from(light.diffuse) - exact).abs();
        assert!(
            error <= 10.0 + 3_000.0 / length(way),
            "{light:?}, not {exact}, {way:?}, {normal:?}, {point:?}"
        );
    }
}

/// All lights together, and ambient light: the sum of them, and never more than full light.
#[test]
fn lights_add_up() {
    let (mut random, camera) = (Random(0x2468_ace1), camera());
    for _ in 0..cases(50_000, 1_000_000) / 4 {
        let pose = Pose::new(random.rotation(), random.position());
        let (vertex, normal) = (random.vertex(), random.normal());
        let points = [(); 3].map(|()| near(&mut random, &pose, vertex));
        let (ambient, sun) = (random.fraction(), random.direction());
        let of = |lights: Lambert<0, 1>| reflected(&lights, &pose, &camera, normal, vertex).diffuse;
        let of_sun = Lambert {
            ambient: U0F16::ZERO,
            lights: [sun],
            points: [],
        };
        let sum = points.iter().map(|point| of(lambert([*point]))).sum::<i32>()
            + reflected(&of_sun, &pose, &camera, normal, vertex).diffuse
            + i32::from(ambient.to_bits() >> 1);
        let all = Lambert {
            ambient,
            lights: [sun],
            points,
        };
        let light = reflected(&all, &pose, &camera, normal, vertex);
        assert_eq!(light.diffuse, sum.min(32_768), "{all:?}");
        // A highlight changes nothing of what is diffuse.
        let blinn = Blinn {
            diffuse: all,
            strength: random.fraction(),
            sharpness: random.bits() as u8,
        };
        assert_eq!(reflected(&blinn, &pose, &camera, normal, vertex).diffuse, light.diffuse);
    }
}

/// What the ends of distances and intensities are: at the light itself, behind it, and as far away as can be.
#[test]
fn lights_from_points_end_somewhere() {
    let camera = camera();
    let on = |position: [i32; 3], half_distance: u16, vertex: [i16; 3]| {
        let light = PointLight {
            position: at(position[0], position[1], position[2]),
            intensity: U0F16::MAX,
            half_distance,
        };
        reflected(&lambert([light]), &Pose::IDENTITY, &camera, [0, 0, -16_384], vertex).diffuse
    };
    for half_distance in [0, 1, 100, u16::MAX] {
        assert_eq!(on([5, 6, 7], half_distance, [5, 6, 7]), 0, "no direction");
        assert_eq!(on([5, 6, 8], half_distance, [5, 6, 7]), 0, "behind");
        assert_eq!(on([5, 60, 7], half_distance, [5, 6, 7]), 0, "along the surface");
    }
    assert_eq!(on([0, 0, -1], 0, [0, 0, 0]), 0, "no light anywhere");
    assert_eq!(on([0, 0, -32_768], 0, [0, 0, 32_767]), 0);
    let half = |light: i32| (16_384 - 20..=16_384).contains(&light);
    assert!(half(on([0, 0, -1_000], 1_000, [0, 0, 0])));
    assert!(half(on([0, 0, -1], 1, [0, 0, 0])));
    assert!(half(on([0, 0, -32_768], u16::MAX, [0, 0, 32_767])));
    // 1/(1 + 2^2), and hardly less than all of it.
    assert!((6_553i32 - 20..=6_554).contains(&on([0, 0, -2_000], 1_000, [0, 0, 0])));
    assert!((32_740..=32_768).contains(&on([0, 0, -100], u16::MAX, [0, 0, 0])));
    assert!(on([0, 0, -32_768], 1, [0, 0, 32_767]) <= 1);
}

/// A highlight is within 16 units, and 4 times the exponent of the cosine, where light and eye are 256 units away and not nearly
/// opposite to each other.
#[test]
fn highlights_are_those_of_floating_point() {
    let (mut random, camera) = (Random(0x89ab_cdef), camera());
    for case in 0..cases(50_000, 1_000_000) {
        let pose = Pose::new(random.rotation(), random.position());
        let vertex = random.vertex();
        let point = near(&mut random, &pose, vertex);
        let camera = camera.with_pose(Pose::new(random.rotation(), random.position()));
        let (sharpness, strength) = (random.below(10) as u8, random.fraction());
        // From a point, or from a direction: as far away as can be, and as bright everywhere.
        let (to_light, brightness, blinn) = if case % 3 > 0 {
            let to_light = way(&pose, vertex, point.position);
            (to_light, brightness(&point, to_light), (DirectionalLight::NONE, point))
        } else {
            let sun = DirectionalLight::from_direction(point.position, point.intensity);
            let to_light = way(
                &pose,
                [0; 3],
                [0, 1, 2].map(|axis| {
                    I16F16::saturating_from_num(
                        point.position[axis].to_num::<f64>() / 2.0 + pose.translation[axis].to_num::<f64>(),
                    )
                }),
            );
            let outside = pose
                .translation
                .iter()
                .any(|axis| axis.to_num::<f64>().abs() > 16_000.0);
            let Ok(sun) = sun else { continue };
            if outside {
                continue;
            }
            let dark = PointLight {
                intensity: U0F16::ZERO,
                ..point
            };
            (to_light, point.intensity.to_num(), (sun, dark))
        };
        let blinn = Blinn {
            diffuse: Lambert {
                ambient: U0F16::ZERO,
                lights: [blinn.0],
                points: [blinn.1],
            },
            strength,
            sharpness,
        };
        let to_eye = way(&pose, vertex, camera.pose().translation);
        // Near the mirror's normal mostly, where there is a highlight.
        let sum = [0, 1, 2].map(|axis| unit(to_light)[axis] + unit(to_eye)[axis]);
        let beside = (f64::from(random.below(100)) / 100.0).powi(2);
        let other = real(random.normal());
        let normal = unit([0, 1, 2].map(|axis| unit(sum)[axis] + other[axis] * beside));
        let normal = normal.map(|axis| (axis * 16_384.0).round() as i32);
        let is_far = length(to_light) >= 256.0 && length(to_eye) >= 256.0;
        let light = reflected(&blinn, &pose, &camera, normal, vertex);
        if !is_far || length(sum) < 0.5 || dot(real(normal), unit(to_light)) < 0.01 {
            continue;
        }
        let exact = FULL * strength.to_num::<f64>() * brightness * mirrored(to_light, to_eye, real(normal), sharpness);
        let bound = 16.0 + 4.0 * f64::from(1 << sharpness.min(8));
        let error = (f64::from(light.specular) - exact).abs();
        assert!(
            error <= bound,
            "{light:?}, not {exact}, {to_light:?}, {to_eye:?}, {normal:?}, {blinn:?}"
        );
    }
}

/// A surface that faces the middle between light and eye mirrors all of the light; turned by a sixteenth of a turn, nothing.
#[test]
fn a_highlight_is_where_the_light_is_mirrored() {
    // The eye is to the left of the light by a quarter of a turn, in front of the surface.
    let camera = camera().with_pose(Pose::new(Rotation::IDENTITY, at(-1_000, 0, -1_000)));
    let light = PointLight {
        position: at(1_000, 0, -1_000),
        intensity: U0F16::MAX,
        half_distance: u16::MAX,
    };
    let blinn = Blinn {
        diffuse: lambert([light]),
        strength: U0F16::MAX,
        sharpness: 8,
    };
    let highlight = |turns: f64| {
        let angle = turns * std::f64::consts::TAU;
        let normal = [angle.sin(), 0.0, -angle.cos()].map(|axis| (axis * 16_384.0).round() as i32);
        reflected(&blinn, &Pose::IDENTITY, &camera, normal, [0; 3]).specular
    };
    assert!(highlight(0.0) > 31_500, "{}", highlight(0.0));
    for turns in [1.0 / 16.0, -1.0 / 16.0, 0.5, 0.25, -0.25] {
        assert!(highlight(turns) < 10, "{}", highlight(turns));
    }
    let (left, right) = (highlight(-0.01), highlight(0.01));
    assert!(left.abs_diff(right) < 300 && left < highlight(0.0), "{left}, {right}");
    let dull = Blinn {
        strength: U0F16::ZERO,
        ..blinn
    };
    assert_eq!(
        reflected(&dull, &Pose::IDENTITY, &camera, [0, 0, -16_384], [0; 3]).specular,
        0
    );
}

/// Light that is what a test says.
#[derive(Debug, Copy, Clone)]
struct Given(ReflectedLight);

impl Lighting for Given {
    type OfModel = ReflectedLight;

    fn seen_from(&self, _: &Pose, _: &Camera) -> ReflectedLight {
        self.0
    }

    fn reflected(light: &ReflectedLight, _: [i32; 3], _: [i32; 3]) -> ReflectedLight {
        *light
    }
}

const VERTICES: [[i16; 3]; 3] = [[-3_000, -3_000, 0], [0, 3_000, 0], [3_000, -3_000, 0]];

/// The word that a face of one colour has in the middle of a picture.
fn word_of<H: Shading<Color = Rgb888>>(skin: H::Skin<'_>) -> Rgb888 {
    let mesh = FaceSet::new(&VERTICES, &[[0, 1, 2]]).unwrap();
    let models = [Model::<H>::with_skin(mesh, skin)
        .unwrap()
        .with_pose(Pose::new(Rotation::IDENTITY, at(0, 0, 1_000)))];
    let mut memory = Box::new(Memory::<H, 8, 1, 64, 64, 2>::new());
    let (window, mut words) = (area(2, 2), [0; 4]);
    let mut band = Band::<Rgb888>::new(window, &mut words).unwrap();
    memory.prepare(&camera(), &models).unwrap().draw(&mut band);
    band.colors().next().unwrap()
}

/// Highlights are white on any colour, and brighten texels up to their own; nothing is brighter than full light.
#[test]
fn highlights_are_white_and_never_above_full_light() {
    let color = Rgb888::new(200, 100, 0);
    let texels = [[color.into_storage()]];
    let (colors, normals, coordinates) = (&[color], &[[0; 2]; 3], &[[0; 2]; 3]);
    let mesh = FaceSet::new(&VERTICES, &[[0, 1, 2]]).unwrap();
    let color_of = |word: Option<u32>| Rgb888::from(RawU24::new(word.expect("no hole")));
    for (diffuse, specular) in (0..=32).flat_map(|one| (0..=32).map(move |other| (one << 10, other << 10))) {
        let lights = Given(ReflectedLight { diffuse, specular });
        let smooth = word_of::<Gouraud<Rgb888, Given>>(GouraudSkin {
            colors,
            normals,
            lights,
        });
        let skin = FlatLitSkin {
            colors,
            normals,
            lights,
        };
        type Flat = FlatLit<Rgb888, Given>;
        let face = Flat::face(&skin, &lights.0, &mesh, 0).unwrap();
        let flat = color_of(Flat::fragment(&skin, face, &()));
        let skin = LitTexturedSkin {
            image: &texels,
            coordinates,
            normals,
            lights,
        };
        type Lit = LitTextured<Texels<Rgb888, 1, 1>, Given>;
        let Perspective(attributes) = Lit::vertex(&skin, &lights.0, 0, [0; 3]).0;
        let textured = color_of(Lit::fragment(
            &skin,
            0,
            &attributes.map(|attribute| i32::from(attribute) << 16),
        ));
        let [exact, of_texel] = [
            [200, 100, 0].map(|level| f64::from(level * diffuse + 255 * specular) / FULL),
            [200, 100, 0].map(|level| f64::from(level * (diffuse + specular).min(32_768)) / FULL),
        ];
        let channels = |color: Rgb888| [color.r(), color.g(), color.b()].map(f64::from);
        for channel in 0..3 {
            let exact = exact[channel].min(255.0);
            for drawn in [smooth, flat] {
                let error = (channels(drawn)[channel] - exact).abs();
                assert!(error <= 1.0, "{drawn:?}, not {exact}, {lights:?}");
            }
            // Light has 32 steps there, and is rounded to the nearest; levels are rounded down.
            let error = (channels(textured)[channel] - of_texel[channel]).abs();
            assert!(
                error <= 1.0 + 200.0 / 32.0,
                "{textured:?}, not {of_texel:?}, {lights:?}"
            );
        }
        if specular == 32_768 {
            assert_eq!([smooth, flat, textured], [Rgb888::WHITE, Rgb888::WHITE, color]);
        }
    }
}
