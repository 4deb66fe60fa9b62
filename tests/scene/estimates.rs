//! What is predicted of a frame, against frames of which it is known which one takes longer, and on scenes that try the
//! numbers. How near predictions are to what chips count is a matter of `measure`.

use embedded_graphics::{
    pixelcolor::{Rgb565, Rgb888},
    prelude::*,
    primitives::Rectangle,
};
use fixed::types::{I16F16, U0F16};
use proptest::prelude::*;
use zrow::{
    band::{Band, BandColor},
    geometry::{InputError, TooSmall},
    scene::{
        Antialiased, Camera, Deep, DoubleSided, Fine, InstructionSet, Look, Memory, Model, Orthographic, Pose, Rotation,
    },
    shade::{
        Bilinear, Fog, Foggy, Lambert, LitTextured, LitTexturedSkin, Shading, Texels, Textured, TexturedSkin,
        Translucent,
    },
};

use crate::common::meshes::{self, Mesh};
use crate::common::{cases, config};
use crate::snapped_faces::{at, camera, standard_pose};

const SETS: [InstructionSet; 2] = [InstructionSet::Armv6M, InstructionSet::Armv7M];

type Room<L, const ACTIVE: usize = 256> = Memory<L, 2_600, 3_000, 128, 64, ACTIVE>;

fn area() -> Rectangle {
    Rectangle::new(Point::zero(), Size::new(128, 64))
}

/// A sphere of so many faces around and from pole to pole: coarser levels of detail have fewer.
fn sphere([around, down]: [u16; 2]) -> Mesh {
    let index = |i: u16, j: u16| j * around + i % around;
    let vertices = (0..=down).flat_map(|j| {
        (0..around).map(move |i| {
            let [turn, tilt] = [f64::from(i) / f64::from(around), f64::from(j) / f64::from(down) / 2.0];
            let [turn, tilt] = [turn, tilt].map(|angle| angle * std::f64::consts::TAU);
            [tilt.sin() * turn.cos(), tilt.cos(), tilt.sin() * turn.sin()].map(|part| (part * 512.0).round() as i16)
        })
    });
    let cells = (0..down).flat_map(|j| (0..around).map(move |i| [i, j]));
    let faces = cells.flat_map(|[i, j]| {
        let [a, b, c, d] = [index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)];
        [[a, b, c], [a, c, d]]
    });
    Mesh::new(vertices.collect(), faces.collect())
}

/// What is predicted for one model in a pose, in memory to which nothing was drawn.
fn estimate<'a, L: Look>(
    mesh: &'a Mesh,
    skin: <L::Shading as Shading>::Skin<'a>,
    pose: Pose,
    set: InstructionSet,
) -> u32 {
    let models = [Model::<L::Shading>::with_skin(mesh.face_set(), skin)
        .unwrap()
        .with_pose(pose)];
    let mut memory = Box::new(Room::<L>::new());
    memory.prepare(&camera(area()), &models).unwrap().estimate(set)
}

fn flat<L: Look<Color = Rgb888, Shading = Rgb888>>(mesh: &Mesh, pose: Pose, set: InstructionSet) -> u32 {
    estimate::<L>(mesh, &vec![Rgb888::RED; mesh.faces.len()], pose, set)
}

const IMAGE: [[u16; 16]; 16] = [[0x1234; 16]; 16];

fn textured(coordinates: &[[i16; 2]]) -> TexturedSkin<'_, Texels<Rgb565, 16, 16>> {
    TexturedSkin {
        image: &IMAGE,
        coordinates,
    }
}

fn lit(coordinates: &[[i16; 2]]) -> LitTexturedSkin<'_, Bilinear<Texels<Rgb565, 16, 16>>, Lambert<0>> {
    LitTexturedSkin {
        image: &IMAGE,
        coordinates,
        normals: &[[0; 2]; 2_600],
        lights: Lambert {
            ambient: U0F16::MAX,
            lights: [],
            points: [],
        },
    }
}

const FOG: Fog<'static, Rgb888> = Fog {
    color: Rgb888::WHITE,
    start: I16F16::lit("500"),
    end: I16F16::lit("3000"),
    curve: Fog::LINEAR,
};

/// Each level has about half of the faces of the one before; each step brings it nearer.
#[test]
fn nearer_and_finer_take_more() {
    for set in SETS {
        let levels = [[48, 24], [34, 17], [24, 12], [12, 6]].map(sphere);
        let of_levels = levels
            .each_ref()
            .map(|level| flat::<Rgb888>(level, standard_pose(5), set));
        assert!(of_levels.windows(2).all(|pair| pair[0] > pair[1]), "{of_levels:?}");
        for level in &levels {
            let at_distances = [1_600, 2_200, 3_000, 8_000, 30_000].map(|z| {
                let pose = Pose::new(standard_pose(3).rotation, at(0, 0, z));
                flat::<Rgb888>(level, pose, set)
            });
            assert!(
                at_distances.windows(2).all(|pair| pair[0] > pair[1]),
                "{at_distances:?}"
            );
        }
    }
}

#[test]
fn each_effect_takes_more() {
    for set in SETS {
        let (mesh, pose) = (sphere([24, 12]), standard_pose(5));
        let colors = vec![Rgb888::RED; mesh.faces.len()];
        let coordinates: Vec<[i16; 2]> = mesh.vertices.iter().map(|&[x, y, _]| [60 * x, 60 * y]).collect();
        let plain = flat::<Rgb888>(&mesh, pose, set);
        for with_effect in [
            flat::<Fine<Rgb888>>(&mesh, pose, set),
            flat::<Deep<Rgb888>>(&mesh, pose, set),
            flat::<DoubleSided<Rgb888>>(&mesh, pose, set),
            flat::<Antialiased<Rgb888>>(&mesh, pose, set),
            estimate::<Foggy<Rgb888>>(&mesh, (&colors, FOG), pose, set),
            estimate::<Translucent<Rgb888>>(&mesh, (&colors, 128), pose, set),
            estimate::<Textured<Texels<Rgb565, 16, 16>>>(&mesh, textured(&coordinates), pose, set),
        ] {
            assert!(with_effect > plain, "{with_effect} is not more than {plain}");
        }
        // An alpha of 255 is none.
        assert_eq!(estimate::<Translucent<Rgb888>>(&mesh, (&colors, 255), pose, set), plain);
        let texture = estimate::<Textured<Texels<Rgb565, 16, 16>>>(&mesh, textured(&coordinates), pose, set);
        let often = estimate::<Textured<Texels<Rgb565, 16, 16>, 1>>(&mesh, textured(&coordinates), pose, set);
        let parallel =
            estimate::<Orthographic<Textured<Texels<Rgb565, 16, 16>>>>(&mesh, textured(&coordinates), pose, set);
        let mixed =
            estimate::<LitTextured<Bilinear<Texels<Rgb565, 16, 16>>, Lambert<0>>>(&mesh, lit(&coordinates), pose, set);
        assert!(
            parallel > plain && often > texture && mixed > texture,
            "{plain} {parallel} {texture} {often} {mixed}"
        );
        // Too few slots.
        let models = [Model::new(mesh.face_set(), &colors).unwrap().with_pose(pose)];
        let mut few = Box::new(Room::<Rgb888, 5>::new());
        assert!(few.prepare(&camera(area()), &models).unwrap().estimate(set) > 2 * plain);
    }
}

/// The heights of bands do not matter, nor what part of the frame was drawn; only whether the frame before needed depths.
#[test]
fn the_same_for_bands_of_any_height() {
    let (overlapping, apart) = ([meshes::torus(), meshes::cube(0.5)], [meshes::icosphere(1.0)]);
    let mut of_frames = Vec::new();
    for meshes in [&overlapping[..], &apart[..]] {
        for height in [1, 7, 64] {
            let mut memory = Box::new(Room::<Rgb888>::new());
            let colors = vec![Rgb888::RED; 600];
            let models = |frame: u16| {
                let model = |mesh| {
                    Model::new(Mesh::face_set(mesh), &colors)
                        .unwrap()
                        .with_pose(standard_pose(frame))
                };
                Vec::from_iter(meshes.iter().map(model))
            };
            let mut estimates = Vec::new();
            for frame in 0..4 {
                let models = models(frame);
                let mut prepared = memory.prepare(&camera(area()), &models).unwrap();
                estimates.push(prepared.estimate(InstructionSet::Armv7M));
                for top in (0..64).step_by(height) {
                    let band = Rectangle::new(Point::new(0, top), Size::new(128, height as u32));
                    prepared.draw(&mut Band::<Rgb888>::new(band, &mut vec![0; 128 * height]).unwrap());
                }
            }
            of_frames.push(estimates);
        }
    }
    let (of_overlapping, of_apart) = of_frames.split_at(3);
    assert!(
        of_overlapping.iter().all(|estimates| *estimates == of_overlapping[0]),
        "{of_overlapping:?}"
    );
    assert!(
        of_apart.iter().all(|estimates| *estimates == of_apart[0]),
        "{of_apart:?}"
    );
    // The first frame is predicted to need depths, and each one after it to be as the one before.
    assert!(
        of_apart[0][1..]
            .iter()
            .all(|estimate| *estimate < of_apart[0][0] * 19 / 20),
        "{of_apart:?}"
    );
    assert!(
        of_overlapping[0][1..]
            .iter()
            .all(|estimate| *estimate > of_overlapping[0][0] * 4 / 5)
    );
}

/// The finest level within a budget is drawn: with more to spend none is coarser.
#[test]
fn a_level_within_a_budget_is_found() {
    let levels = [[48, 24], [34, 17], [24, 12], [12, 6]].map(sphere);
    let costs = levels
        .each_ref()
        .map(|level| flat::<Rgb888>(level, standard_pose(9), InstructionSet::Armv6M));
    let mut picked = Vec::new();
    for budget in (0..2_000_000).step_by(20_000) {
        let level = costs
            .iter()
            .position(|cost| *cost <= budget)
            .unwrap_or(levels.len() - 1);
        assert!(costs[level] <= budget || level == levels.len() - 1);
        picked.push(level);
    }
    assert!(picked.is_sorted_by(|one, other| one >= other));
    picked.dedup();
    assert_eq!(picked, [3, 2, 1, 0]);
}

/// A shading of a program's own that takes forever.
struct Endless;

impl Shading for Endless {
    type Color = Rgb565;
    type Skin<'a> = ();
    type Uniforms = ();
    type Attributes = [i16; 1];

    fn uniforms(_: &(), _: &Pose, _: &Camera) {}

    fn vertex(_: &(), _: &(), _: usize, _: [i32; 3]) -> [i16; 1] {
        [0]
    }

    fn fragment(_: &(), _: u16, _: &[i32; 1]) -> Option<u16> {
        None
    }

    fn instructions(_: InstructionSet) -> [u32; 2] {
        [u32::MAX; 2]
    }
}

/// A triangle that is larger than the picture, and within the guard band.
fn large() -> Mesh {
    let vertices = [[-2_000, -2_000, 0], [0, 2_000, 0], [2_000, -2_000, 0]];
    Mesh::new(vertices.to_vec(), vec![[0, 1, 2]])
}

/// A face as large as the picture, in perspective with a division at every 16th pixel: 19 instructions a pixel are counted on a
/// Cortex-M4 for such a quad, whose rows need no depths (`measure`), of which 15 are predicted for the texel.
#[test]
fn a_pixel_of_a_texture_is_predicted_as_it_is_counted() {
    let set = InstructionSet::Armv7M;
    let mut empty = Memory::<Rgb888, 0, 0, 128, 64>::new();
    let nothing = empty.prepare(&camera(area()), &[]).unwrap().estimate(set);
    let tilted = Pose::new(Rotation::about_x(U0F16::from_num(0.08)), at(0, 0, 300));
    let coordinates = [[0, 0], [4_000, 0], [0, 4_000]];
    let face = estimate::<Textured<Texels<Rgb565, 16, 16>>>(&large(), textured(&coordinates), tilted, set);
    let pixels = area().size.width * area().size.height;
    let counted = 19 * pixels;
    assert!(
        (face - nothing).abs_diff(counted) < counted * 15 / 100,
        "{} of {counted}",
        face - nothing
    );
}

#[test]
fn hostile_scenes_are_predicted() {
    let near = Pose::new(Rotation::IDENTITY, at(0, 0, 200));
    for set in SETS {
        let mut empty = Memory::<Rgb888, 0, 0, 128, 64>::new();
        let nothing = empty.prepare(&camera(area()), &[]).unwrap().estimate(set);
        assert!((1..100_000).contains(&nothing), "{nothing}");
        // 2,000 faces as large as the picture.
        let faces = Mesh::new(large().vertices, vec![[0, 1, 2]; 2_000]);
        let one = flat::<Rgb888>(&large(), near, set);
        let many = [
            flat::<Rgb888>(&faces, near, set),
            flat::<Fine<Rgb888>>(&faces, near, set),
        ];
        for many in many {
            assert!(many > 1_000 * (one - nothing), "{many} and {one} beside {nothing}");
        }
        // 128 x 64 pixels of some ten instructions each.
        assert!((60_000..300_000).contains(&(one - nothing)), "{one} beside {nothing}");
        // More faces than tables can have.
        let too_many = Mesh::new(large().vertices, vec![[0, 1, 2]; 65_535]);
        let models = [Model::new(too_many.face_set(), &[Rgb888::RED; 65_535]).unwrap()];
        let mut memory = Box::new(Memory::<Rgb888, 3, 65_535, 128, 64>::new());
        let prepared = memory.prepare(&camera(area()), &models);
        assert_eq!(prepared.err(), Some(InputError::TooSmall(TooSmall::Faces(65_535))));
        // As many as they can have.
        let most = Mesh::new(
            vec![[-300, -300, 0], [0, 300, 0], [300, -300, 0]],
            vec![[0, 1, 2]; 32_767],
        );
        let models = [Model::<Endless>::with_skin(most.face_set(), ())
            .unwrap()
            .with_pose(near)];
        let mut memory = Box::new(Memory::<Endless, 3, 32_767, 128, 64>::new());
        assert_eq!(
            memory.prepare(&camera(area()), &models).unwrap().estimate(set),
            u32::MAX
        );
    }
}

fn any_vertex() -> impl Strategy<Value = [i16; 3]> {
    let coordinate = prop_oneof![any::<i16>(), -600i16..600, Just(i16::MIN), Just(i16::MAX)];
    prop::array::uniform3(coordinate)
}

fn any_mesh() -> impl Strategy<Value = Mesh> {
    let faces = prop::collection::vec(prop::array::uniform3(0u16..20), 0..150);
    (prop::collection::vec(any_vertex(), 20), faces).prop_map(|(vertices, faces)| Mesh::new(vertices, faces))
}

/// A prediction of any faces in any pose is more than that of none.
fn check<'a, L: Look<Color: RgbColor>>(mesh: &'a Mesh, skin: <L::Shading as Shading>::Skin<'a>, pose: Pose) {
    let models = [Model::<L::Shading>::with_skin(mesh.face_set(), skin)
        .unwrap()
        .with_pose(pose); 2];
    for size in [Size::new(128, 64), Size::new(1, 64)] {
        let area = Rectangle::new(Point::new(-40, 13), size);
        let camera = camera(area);
        let mut memory = Box::new(Memory::<L, 10_000, 400, 128, 64, 100>::new());
        // Scenes that leave the numbers of a precision are errors.
        let Ok(mut prepared) = memory.prepare(&camera, &models) else {
            continue;
        };
        let first = SETS.map(|set| prepared.estimate(set));
        let mut words = vec![L::Color::BLACK.to_word(); 128 * 64];
        prepared.draw(&mut Band::<L::Color>::new(area, &mut words).unwrap());
        let second = SETS.map(|set| prepared.estimate(set));
        assert!(first.into_iter().chain(second).all(|estimate| estimate < u32::MAX));
        let [of_none, of_all] = [size.height, first[1]];
        assert!(of_all >= of_none * 200, "{of_all} for {of_none} rows");
    }
}

proptest! {
    #![proptest_config(config(cases(12, 80)))]

    #[test]
    fn any_scene_is_predicted(mesh in any_mesh(), translation in prop::array::uniform3(-2_000i32..2_000), turn: u16) {
        let pose = Pose::new(Rotation::about_x(U0F16::from_bits(turn)), translation.map(I16F16::from_num));
        let colors = vec![Rgb888::RED; mesh.faces.len()];
        let coordinates: Vec<[i16; 2]> = mesh.vertices.iter().map(|&[x, y, _]| [x, y]).collect();
        check::<Rgb888>(&mesh, &colors, pose);
        check::<DoubleSided<Fine<Rgb888>>>(&mesh, &colors, pose);
        check::<Fine<Deep<Rgb888>>>(&mesh, &colors, pose);
        check::<Antialiased<Rgb888>>(&mesh, &colors, pose);
        check::<Foggy<Translucent<Rgb888>>>(&mesh, ((&colors, 128), FOG), pose);
        check::<Textured<Texels<Rgb565, 16, 16>>>(&mesh, textured(&coordinates), pose);
    }
}
