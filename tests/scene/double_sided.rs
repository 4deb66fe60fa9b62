//! Faces that are seen from both sides, against meshes in which each face is followed by itself the other way round, and
//! against exact owners.

use embedded_graphics::{
    pixelcolor::{Rgb888, RgbColor},
    prelude::*,
    primitives::Rectangle,
};
use fixed::types::{I8F24, I16F16, U0F16};
use proptest::prelude::*;
use std::cell::Cell;
use zrow::{
    band::Band,
    scene::{
        Affine, Camera, Counted, Counters, Deep, DoubleSided, Fine, Look, Memory, Model, OnePass, Orthographic, Pose,
        Rotation, Unhurried, Whole,
    },
    shade::{
        Bounded, DirectionalLight, FlatLit, FlatLitSkin, Gouraud, GouraudSkin, Lambert, Shading, Transformed, TwoSided,
    },
};

use crate::common::meshes::{self, Mesh};
use crate::common::{cases, config};
use crate::numbered_scene::{Scene, area, color_of, compare, picture};
use crate::reference::nearest_faces::{Depth, owners};
use crate::rotations::rotation;
use crate::shaded_scene::{Even, InSpace, Numbers, UNTOUCHED};
use crate::snapped_faces::{at, camera, snapped, standard_pose};

/// Each face of a mesh, and after it the same face the other way round.
fn doubled(mesh: &Mesh) -> Mesh {
    let faces = mesh.faces.iter().flat_map(|&[a, b, c]| [[a, b, c], [a, c, b]]);
    Mesh::new(mesh.vertices.clone(), faces.collect())
}

/// What is drawn, how many vertices that takes, and the faces that are seen from the front: the number of each in the mesh with
/// single ones, and its corners.
type Drawn = (Vec<u32>, usize, Vec<(usize, [[i128; 3]; 3])>);

/// Whether corners run clockwise.
fn is_front([a, b, c]: [[i128; 3]; 3]) -> bool {
    (b[0] - a[0]) * (c[1] - a[1]) > (c[0] - a[0]) * (b[1] - a[1])
}

fn drawn<L: Look<Color = Rgb888>, const ACTIVE: usize>(
    models: &[Model<'_, L::Shading>],
    camera: &Camera,
    copies: usize,
) -> Drawn {
    let mut memory = Box::new(Memory::<L, 1_200, 64, 64, 64, ACTIVE>::new());
    let mut prepared = memory.prepare(camera, models).unwrap();
    let area = camera.viewport().to_rectangle();
    let mut words = vec![UNTOUCHED; (area.size.width * area.size.height) as usize];
    prepared.draw(&mut Band::<Rgb888>::new(area, &mut words).unwrap());
    let faces = snapped(&prepared).into_iter();
    let front = faces.filter(|face| is_front(face.corners));
    let front = front.map(|face| (face.order / copies, face.corners)).collect();
    (words, prepared.vertices_needed(), front)
}

/// Compares models in a look whose faces have two sides with models of doubled meshes in one whose faces have one. Returns how
/// many faces are seen from behind.
fn check<L, D>(single: &[Model<'_, L::Shading>], double: &[Model<'_, L::Shading>], camera: &Camera) -> usize
where
    L: Look<Color = Rgb888>,
    D: Look<Color = Rgb888, Shading = L::Shading>,
{
    let mut memory = Box::new(Memory::<L, 1_200, 64, 64, 64>::new());
    if memory.prepare(camera, double).is_err() {
        let mut memory = Box::new(Memory::<D, 1_200, 64, 64, 64>::new());
        assert!(memory.prepare(camera, single).is_err());
        return 0;
    }
    let expected = drawn::<L, 64>(double, camera, 2);
    assert!(drawn::<D, 64>(single, camera, 1) == expected, "in one pass");
    if L::DRAWS_IN_PASSES {
        assert!(drawn::<D, 2>(single, camera, 1) == expected, "in passes");
    }
    expected.2.len() - drawn::<L, 64>(single, camera, 1).2.len()
}

/// Two meshes and where they are.
#[derive(Debug, Clone)]
struct Pair {
    meshes: [Mesh; 2],
    poses: [Pose; 2],
}

/// Meshes of some faces that share vertices, before the camera, around it, or so large that they leave the guard band.
fn pair() -> impl Strategy<Value = Pair> {
    let mesh = (
        2u32..6,
        prop::collection::vec(prop::array::uniform3(any::<i16>()), 4..8),
    )
        .prop_flat_map(|(shift, vertices)| {
            let count = vertices.len() as u16;
            let vertices: Vec<_> = vertices
                .into_iter()
                .map(|vertex| vertex.map(|part| part >> shift))
                .collect();
            let face = prop::array::uniform3(0..count);
            prop::collection::vec(face, 1..6).prop_map(move |faces| Mesh::new(vertices.clone(), faces))
        });
    let pose = (rotation(), -400i32..400, -300i32..300, -300i32..2_500)
        .prop_map(|(rotation, x, y, z)| Pose::new(rotation, at(x, y, z)));
    (prop::array::uniform2(mesh), prop::array::uniform2(pose)).prop_map(|(meshes, poses)| Pair { meshes, poses })
}

/// The models of meshes, with a skin each.
fn models<'a, H: Shading>(meshes: &'a [Mesh; 2], poses: [Pose; 2], skins: [H::Skin<'a>; 2]) -> Vec<Model<'a, H>> {
    let parts = meshes.iter().zip(poses).zip(skins);
    parts
        .map(|((mesh, pose), skin)| Model::<H>::with_skin(mesh.face_set(), skin).unwrap().with_pose(pose))
        .collect()
}

/// A colour for each face, as often as it is there.
fn colors(pair: &Pair, copies: usize) -> [Vec<Rgb888>; 2] {
    let mut number = 0;
    pair.meshes.each_ref().map(|mesh| {
        let faces = mesh.faces.iter().flat_map(|_| {
            number += 1;
            vec![color_of(number); copies]
        });
        faces.collect()
    })
}

fn test_camera() -> Camera {
    camera(Rectangle::new(Point::zero(), Size::new(48, 40)))
        .with_scale(I8F24::from_num(0.0625))
        .unwrap()
}

/// Two sides in each look. In which order the wrappers are changes no item of a look, as `looks` shows.
macro_rules! check_looks {
    ($single:expr, $double:expr, $camera:expr; $($single_sided:ty, $double_sided:ty;)+) => {
        [$(check::<$single_sided, $double_sided>($single, $double, $camera)),+]
    };
}

type Mapped = Transformed<Rgb888>;

#[test]
fn two_sides_are_two_faces() {
    let backs = Cell::new(0);
    let mut runner = proptest::test_runner::TestRunner::new(config(cases(250, 10_000)));
    let element = || prop_oneof![-2i32 << 24..2 << 24];
    let map = || prop::array::uniform3(prop::array::uniform3(element()));
    runner
        .run(&(pair(), map(), map()), |(pair, map, other)| {
            let camera = &test_camera();
            let (once, twice) = (colors(&pair, 1), colors(&pair, 2));
            let doubled = pair.meshes.each_ref().map(doubled);
            let single = models::<Rgb888>(&pair.meshes, pair.poses, once.each_ref().map(|colors| &colors[..]));
            let double = models::<Rgb888>(&doubled, pair.poses, twice.each_ref().map(|colors| &colors[..]));
            let counts = check_looks!(&single, &double, camera;
                Rgb888, DoubleSided<Rgb888>;
                Fine<Rgb888>, DoubleSided<Fine<Rgb888>>;
                Deep<Rgb888>, DoubleSided<Deep<Rgb888>>;
                Whole<Rgb888>, DoubleSided<Whole<Rgb888>>;
                OnePass<Rgb888>, DoubleSided<OnePass<Rgb888>>;
                Orthographic<Rgb888>, DoubleSided<Orthographic<Rgb888>>;
                Unhurried<Counted<Rgb888>>, DoubleSided<Unhurried<Counted<Rgb888>>>;
                Orthographic<Fine<Deep<Rgb888>>>, Fine<DoubleSided<Deep<Orthographic<Rgb888>>>>;
            );
            backs.set(backs.get() + counts.iter().sum::<usize>());

            // Maps, of which half mirror.
            let maps = [map, other].map(|matrix| Affine {
                matrix: matrix.map(|row| row.map(I8F24::from_bits)),
                translation: [I16F16::ZERO; 3],
            });
            let [first, second] = &once;
            let single = models::<Mapped>(&pair.meshes, pair.poses, [(first, maps[0]), (second, maps[1])]);
            let [first, second] = &twice;
            let double = models::<Mapped>(&doubled, pair.poses, [(first, maps[0]), (second, maps[1])]);
            check::<Mapped, DoubleSided<Mapped>>(&single, &double, camera);
            check::<Fine<Deep<Mapped>>, DoubleSided<Fine<Deep<Mapped>>>>(&single, &double, camera);

            // Models that are left out as a whole have no backs either.
            let [first, second] = &once;
            let bounds = pair.meshes.each_ref().map(|mesh| mesh.face_set().bounds());
            type Boxed = Bounded<Rgb888>;
            let single = models::<Boxed>(&pair.meshes, pair.poses, [(first, bounds[0]), (second, bounds[1])]);
            let [first, second] = &twice;
            let double = models::<Boxed>(&doubled, pair.poses, [(first, bounds[0]), (second, bounds[1])]);
            check::<Counted<Boxed>, DoubleSided<Counted<Boxed>>>(&single, &double, camera);
            Ok(())
        })
        .unwrap();
    assert!(backs.get() > cases(2_400, 2_400) as usize, "{}", backs.get());
}

proptest! {
    #![proptest_config(config(cases(200, 4_000)))]

    /// What varies over a face does so over its back: each corner has its own attributes.
    #[test]
    fn attributes_stay_with_their_corners(
        pair in pair(),
        numbers in prop::array::uniform2(prop::collection::vec(prop::array::uniform1(-12_000i16..12_000), 8)),
    ) {
        let doubled = pair.meshes.each_ref().map(doubled);
        let skins = numbers.each_ref().map(|numbers| Numbers { of_vertices: &numbers[..], shown: 0 });
        macro_rules! check_attributes {
            ($($shading:ty, $parallel:ty;)+) => {$(
                let single = models::<$shading>(&pair.meshes, pair.poses, skins);
                let double = models::<$shading>(&doubled, pair.poses, skins);
                let camera = &test_camera();
                check::<$shading, DoubleSided<$shading>>(&single, &double, camera);
                let single = models::<<$parallel as Look>::Shading>(&pair.meshes, pair.poses, skins);
                let double = models::<<$parallel as Look>::Shading>(&doubled, pair.poses, skins);
                check::<$parallel, DoubleSided<$parallel>>(&single, &double, camera);
            )+};
        }
        check_attributes! {
            Even<1>, Orthographic<Fine<Deep<Even<1>>>>;
            InSpace<1, 4>, Fine<Orthographic<Deep<InSpace<1>>>>;
        }
    }
}

/// A wavy sheet of squares, which hides itself from the front and from behind.
fn sheet() -> Mesh {
    let index = |x: u16, y: u16| y * 9 + x;
    let squares = (0..8).flat_map(|y| (0..8).map(move |x| (x, y)));
    let faces = squares.flat_map(|(x, y)| {
        let [a, b, c, d] = [index(x, y), index(x, y + 1), index(x + 1, y + 1), index(x + 1, y)];
        [[a, b, c], [a, c, d]]
    });
    let vertices = (0..81).map(|number| {
        let (x, y) = (f64::from(number % 9) - 4.0, f64::from(number / 9) - 4.0);
        [x * 120.0, y * 100.0, (x * 1.3 + y * 0.4).sin() * 150.0].map(|part| part.round() as i16)
    });
    Mesh::new(vertices.collect(), faces.collect())
}

/// Turned once around itself, a sheet shows both sides, and each pixel the nearest of all its faces, whichever way they run.
#[test]
fn a_sheet_is_seen_from_both_sides() {
    let (area, scene) = (area(64, 48), Scene::new(vec![sheet()]));
    let (mut seen, mut backs) = (0, 0);
    for frame in 0..32 {
        let models = scene.models(standard_pose(frame * 16 + 3));
        let mut one_sided = Box::new(Memory::<Rgb888, 81, 128, 64, 48>::new());
        let mut faces = snapped(&one_sided.prepare(&camera(area), &models).unwrap());
        for face in &mut faces {
            if !is_front(face.corners) {
                face.corners.swap(0, 1);
                backs += 1;
            }
        }
        let mut memory = Box::new(Memory::<DoubleSided<Rgb888>, 81, 128, 64, 48>::new());
        let mut prepared = memory.prepare(&camera(area), &models).unwrap();
        let found = picture(&mut prepared, area);
        // The same pixels, and the nearest face in each of them, up to depths that are rounded.
        let expected = owners(&faces, area, 16, Depth::Bits16);
        for (found, expected) in found.iter().zip(&expected) {
            assert_eq!(found.is_some(), expected.is_some());
            seen += usize::from(found.is_some());
        }
        let differing = found
            .iter()
            .zip(&expected)
            .filter(|(found, expected)| found != expected)
            .count();
        assert!(differing <= 2, "{differing} in frame {frame}");
        compare(&mut prepared, area);
    }
    assert!(seen > 5_000 && (1_500..2_600).contains(&backs), "{seen} {backs}");
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The level of the first drawn pixel of a square, which is turned about y, with its one normal towards -z.
fn level_of_square<'a, H: Shading<Color = Rgb888>>(mesh: &'a Mesh, skin: H::Skin<'a>, pose: Pose) -> u8 {
    let camera = test_camera();
    let models = [Model::<H>::with_skin(mesh.face_set(), skin).unwrap().with_pose(pose)];
    let (words, ..) = drawn::<DoubleSided<H>, 8>(&models, &camera, 1);
    let levels: Vec<u8> = words
        .into_iter()
        .filter(|&word| word != UNTOUCHED)
        .map(|word| word as u8)
        .collect();
    let range = levels.iter().max().unwrap() - levels.iter().min().unwrap();
    assert!(range <= 1, "one normal");
    levels[0]
}

proptest! {
    #![proptest_config(config(cases(300, 10_000)))]

    /// Two-sided light against floating point: that on the side which the camera sees.
    #[test]
    fn light_falls_on_the_side_that_is_seen(
        turn in any::<u16>(),
        towards in prop::array::uniform3(-100i32..100),
        ambient in 0u16..20_000,
        intensity in 0u16..40_000,
        x in -200i32..200,
    ) {
        prop_assume!(towards != [0; 3]);
        let corners = [[-300, -300, 0], [-300, 300, 0], [300, 300, 0], [300, -300, 0]];
        let square = Mesh::new(corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]]);
        let pose = Pose::new(Rotation::about_y(U0F16::from_bits(turn)), at(x, 0, 1_200));
        let normal = pose.rotation.matrix().map(|row| -row[2].to_num::<f64>());
        let to_eye = [-f64::from(x), 0.0, -1_200.0];
        let side = dot(normal, to_eye) / dot(to_eye, to_eye).sqrt();
        // On edge there is nothing to be seen.
        prop_assume!(side.abs() > 0.1);
        let direction = towards.map(I16F16::from_num::<i32>);
        let light = DirectionalLight::from_direction(direction, U0F16::from_bits(intensity)).unwrap();
        let lights = TwoSided(Lambert { ambient: U0F16::from_bits(ambient), lights: [light], points: [] });
        let towards = towards.map(f64::from);
        let cosine = dot(normal, towards) / dot(towards, towards).sqrt() * side.signum();
        let exact = 255.0 * (f64::from(ambient) + f64::from(intensity) * cosine.max(0.0)) / 65_536.0;
        let (colors, normals) = (&[Rgb888::WHITE], &[[127, 127]; 4]);
        let flat = FlatLitSkin { colors, normals, lights };
        let smooth = GouraudSkin { colors, normals, lights };
        type Sided = TwoSided<Lambert<1>>;
        let upside_down = Affine::scaled([1, -1, 1].map(I8F24::from_num::<i32>));
        for level in [
            level_of_square::<FlatLit<Rgb888, Sided>>(&square, flat, pose),
            level_of_square::<Gouraud<Rgb888, Sided>>(&square, smooth, pose),
            level_of_square::<Transformed<FlatLit<Rgb888, Sided>>>(&square, (flat, upside_down), pose),
        ] {
            prop_assert!((f64::from(level) - exact.min(255.0)).abs() <= 1.6, "{} for {}", level, exact);
        }
    }
}

/// Faces that are seen from behind count as drawn.
#[test]
fn backs_are_not_culled() {
    let mesh = meshes::cube(0.5);
    let colors: Vec<Rgb888> = (0..12).map(color_of).collect();
    let pose = Pose::new(standard_pose(5).rotation, at(0, 0, 1_500));
    let models = [Model::new(mesh.face_set(), &colors).unwrap().with_pose(pose)];
    fn culled<L: Look<Color = Rgb888, Shading = Rgb888, Counting = Cell<Counters>>>(
        models: &[Model<'_, Rgb888>],
    ) -> u32 {
        let mut memory = Box::new(Memory::<L, 8, 12, 64, 48>::new());
        memory
            .prepare(&camera(area(64, 48)), models)
            .unwrap()
            .counters()
            .faces_culled
    }
    assert_eq!(culled::<Counted<Rgb888>>(&models), 6);
    assert_eq!(culled::<DoubleSided<Unhurried<Counted<Rgb888>>>>(&models), 0);
}
