//! Warnock's algorithm: what it counts, with lists of any length, on scenes whose windows are hard to decide.
//!
//! That it draws the pictures of the other methods is tested together with them, in `visibility`.

use embedded_graphics::{pixelcolor::Rgb888, prelude::*, primitives::Rectangle};
use fixed::types::{I16F16, U0F16};
use zrow::{
    band::Band,
    geometry::{Sub4, Sub8},
    scene::{Camera, Deep, DepthWidth, Fine, Look, Memory, Model, Pose, Prepared},
    shade::{Gouraud, GouraudSkin, Lambert, Shading, Texels, Textured, TexturedSkin},
    visible::{Visibility, Warnock},
};

use crate::common::meshes::{self, Mesh};
use crate::numbered_scene::{Format, LookIn, Scene, area, color_of, picture};
use crate::snapped_faces::{camera, standard_pose};

type MemoryOf<S, D> = Memory<LookIn<S, D>, 600, 600, 128, 64, 100>;

/// Windows, blocks and pixels that were compared.
type Counts = [u32; 3];

fn counts<const FACES: usize, T>(method: &Warnock<FACES, T>) -> Counts {
    [method.windows(), method.blocks(), method.pixels_compared()]
}

/// Draws a prepared frame by the method into one band, and checks it against the depth row.
fn draw<L: Look<Color = Rgb888>>(
    prepared: &mut Prepared<'_, '_, L>,
    area: Rectangle,
    method: &mut impl Visibility<L::Depth>,
) {
    let pixels = (area.size.width * area.size.height) as usize;
    let (mut expected, mut drawn) = (vec![7; pixels], vec![7; pixels]);
    prepared.draw(&mut Band::<Rgb888>::new(area, &mut expected).unwrap());
    prepared
        .draw_by(method, &mut Band::<Rgb888>::new(area, &mut drawn).unwrap())
        .unwrap();
    let differing = drawn
        .iter()
        .zip(&expected)
        .filter(|(drawn, expected)| drawn != expected);
    assert_eq!(differing.count(), 0);
}

/// What the method counts that has room for so many faces.
fn counted<S: Format<D>, D: DepthWidth, const FACES: usize>(models: &[Model<'_, Rgb888>], camera: &Camera) -> Counts {
    let mut memory = Box::new(MemoryOf::<S, D>::new());
    let mut prepared = memory.prepare(camera, models).unwrap();
    let mut method = Warnock::<FACES>::new();
    draw(&mut prepared, camera.viewport().to_rectangle(), &mut method);
    counts(&method)
}

/// What is counted of a mesh before the camera with every precision and width of depths.
fn in_all_formats<const FACES: usize>(mesh: &Mesh) -> [Counts; 4] {
    let scene = Scene::new(vec![mesh.clone().two_sided()]);
    let (models, camera) = (scene.models(Pose::IDENTITY), camera(area(64, 64)));
    [
        counted::<Sub4, u16, FACES>(&models, &camera),
        counted::<Sub4, u32, FACES>(&models, &camera),
        counted::<Sub8, u16, FACES>(&models, &camera),
        counted::<Sub8, u32, FACES>(&models, &camera),
    ]
}

/// A face that covers the picture, with these depths of its corners.
fn wall(depths: [i16; 3]) -> [[i16; 3]; 3] {
    let [first, second, third] = depths;
    [[-9000, -9000, first], [0, 9000, second], [9000, -9000, third]]
}

/// A mesh of faces that share no corner.
fn mesh(faces: &[[[i16; 3]; 3]]) -> Mesh {
    let numbers = (0..faces.len() as u16).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]);
    Mesh::new(faces.concat(), numbers.collect())
}

/// Nothing is one window, and so is a face that covers the picture, whatever is behind it.
#[test]
fn what_is_obvious_is_one_window() {
    let small = [[-100, -100, 1800], [0, 100, 1900], [100, -100, 2000]];
    let beside = [[3000, -100, 1500], [3100, 100, 1500], [3200, -100, 1500]];
    assert_eq!(in_all_formats::<8>(&mesh(&[beside])), [[1, 0, 0]; 4]);
    assert_eq!(in_all_formats::<8>(&mesh(&[small])), [[1, 1, 0]; 4]);
    let near = wall([1000, 1200, 1100]);
    assert_eq!(in_all_formats::<8>(&mesh(&[near])), [[1, 1, 0]; 4]);
    let far = wall([1300, 1500, 1400]);
    assert_eq!(in_all_formats::<8>(&mesh(&[far, near])), [[1, 1, 0]; 4]);
    assert_eq!(in_all_formats::<8>(&mesh(&[far, small, near, beside])), [[1, 1, 0]; 4]);
    // Before the wall at one end, behind it at the other, and not in the picture where it is before.
    let oblique = [[-5000, 0, 700], [5000, 10, 2400], [5000, -10, 2400]];
    for [windows, _, compared] in in_all_formats::<8>(&mesh(&[near, oblique])) {
        assert!(windows < 500 && compared < 64, "{windows} {compared}");
    }
}

/// Without room for its list, a window is divided down to pixels.
#[test]
fn a_list_without_room_compares_pixels() {
    let (near, far) = (wall([1000, 1200, 1100]), wall([1300, 1500, 1400]));
    // A quaternary tree of 64 x 64 leaves has a third as many windows above them.
    let [pixels, windows] = [64 * 64, (4 * 64 * 64 - 1) / 3];
    assert_eq!(in_all_formats::<1>(&mesh(&[far, near])), [[windows, 0, pixels]; 4]);
    assert_eq!(in_all_formats::<0>(&mesh(&[far, near])), [[windows, 0, pixels]; 4]);
    assert_eq!(in_all_formats::<0>(&mesh(&[near])), [[windows, 0, 0]; 4]);
    assert_eq!(in_all_formats::<2>(&mesh(&[near, far])), [[1, 1, 0]; 4]);
}

/// Of two walls on one plane the first is seen, and is known to be if their planes are the same integers.
#[test]
fn walls_on_one_plane() {
    let level = wall([1000; 3]);
    assert_eq!(in_all_formats::<8>(&mesh(&[level; 3])), [[1, 1, 0]; 4]);
    let other = [[-8000, -9500, 1000], [-100, 9000, 1000], [9000, -8000, 1000]];
    assert_eq!(in_all_formats::<8>(&mesh(&[level, other, level])), [[1, 1, 0]; 4]);
    // Of a face that covers a part, the plane is known but for its error.
    let part = [[-100, -100, 1000], [0, 100, 1000], [100, -100, 1000]];
    let [with_16_bits, with_32_bits, ..] = in_all_formats::<8>(&mesh(&[level, part]));
    assert!(
        with_16_bits[2] < 300 && with_32_bits[2] < 300,
        "{with_16_bits:?} {with_32_bits:?}"
    );
}

/// Two walls go through each other, in a line from top to bottom: pixels are compared along it.
#[test]
fn penetrating_walls_are_compared_along_a_line() {
    let walls = mesh(&[
        [[-4000, -4000, 900], [-4000, 4000, 900], [4000, 4000, 1700]],
        [[-4000, -4000, 900], [4000, 4000, 1700], [4000, -4000, 1700]],
        [[-4000, -4000, 1700], [-4000, 4000, 1700], [4000, 4000, 900]],
        [[-4000, -4000, 1700], [4000, 4000, 900], [4000, -4000, 900]],
    ]);
    for [windows, blocks, compared] in in_all_formats::<8>(&walls) {
        assert!((64..=64 * 3).contains(&compared), "{windows} {blocks} {compared}");
        assert!(blocks > 40 && windows < 64 * 8, "{windows} {blocks} {compared}");
    }
}

/// Three bars, each of which hides the one before it where they cross: no order of faces draws them.
#[test]
fn a_cycle_of_bars() {
    // Where they cross, at a distance of 1000.
    let crossings = [[0, 350], [-350, -250], [350, -250]];
    let bar = |number: usize| {
        let (from, to) = (crossings[number], crossings[(number + 1) % 3]);
        // From a quarter before the first crossing to a quarter behind the second one: near, then far.
        let along = |quarters: i16, z: i16, [x, y]: [i16; 2]| {
            let at = |axis: usize| from[axis] + (to[axis] - from[axis]) / 4 * quarters;
            let scaled = |value: i16| (i32::from(value) * i32::from(z) / 1000) as i16;
            [scaled(at(0)) + x, scaled(at(1)) + y, z]
        };
        let [x, y] = if number == 1 { [0, 120] } else { [120, 0] };
        [along(-1, 900, [x, y]), along(-1, 900, [-x, -y]), along(6, 1700, [0, 0])]
    };
    let bars = mesh(&[bar(0), bar(1), bar(2)]);
    let (scene, camera) = (Scene::new(vec![bars.clone().two_sided()]), camera(area(64, 64)));
    let models = scene.models(Pose::IDENTITY);
    let mut memory = Box::new(MemoryOf::<Sub4, u16>::new());
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    let picture = picture(&mut prepared, area(64, 64));
    let focal_length = camera.focal_length().to_num::<i32>();
    for (number, crossing) in crossings.into_iter().enumerate() {
        let [x, y] = crossing.map(i32::from);
        let pixel = [32 + x * focal_length / 1000, 32 - y * focal_length / 1000];
        let shown = picture[(pixel[1] * 64 + pixel[0]) as usize];
        // Face and back have two numbers.
        assert_eq!(shown.map(|face| face % 3), Some(number), "{pixel:?}");
    }
    for [windows, blocks, compared] in in_all_formats::<8>(&bars) {
        assert!(
            blocks > 60 && windows < 1_000 && compared < 50,
            "{windows} {blocks} {compared}"
        );
    }
}

/// The standard scenes at 128 x 64 pixels: a part of their pixels is compared, fewer where faces are larger.
#[test]
fn standard_scenes_compare_a_part_of_their_pixels() {
    let scenes = [
        (vec![meshes::torus(), meshes::cube(0.5)], 200),
        (vec![meshes::icosphere(1.4)], 20),
        (vec![meshes::cube(1.0)], 10),
    ];
    for (meshes, most) in scenes {
        let scene = Scene::new(meshes);
        for frame in [1, 22, 43] {
            let (models, camera) = (scene.models(standard_pose(frame)), camera(area(128, 64)));
            let all = [
                counted::<Sub4, u16, 600>(&models, &camera),
                counted::<Sub8, u32, 600>(&models, &camera),
            ];
            for [windows, blocks, compared] in all {
                assert!(compared <= most, "{frame}: {windows} {blocks} {compared}");
                assert!(
                    blocks > windows / 3 && windows < 128 * 64 / 2,
                    "{frame}: {windows} {blocks} {compared}"
                );
            }
        }
    }
}

/// Attributes that vary evenly on the screen, and in space, which are divided at every 16th column: windows begin in between.
#[test]
fn attributes_are_those_of_the_depth_row() {
    fn check<'a, L: Look<Color = Rgb888>>(mesh: &'a Mesh, skin: <L::Shading as Shading>::Skin<'a>) {
        let model = Model::with_skin(mesh.face_set(), skin).unwrap();
        let (models, camera) = ([model.with_pose(standard_pose(9))], camera(area(128, 64)));
        let mut memory = Box::new(Memory::<L, 600, 600, 128, 64, 100>::new());
        let mut prepared = memory.prepare(&camera, &models).unwrap();
        let mut method = Warnock::<600>::new();
        draw(&mut prepared, area(128, 64), &mut method);
        assert!(method.blocks() > 60, "{:?}", counts(&method));
    }
    let mesh = meshes::cube(0.9);
    let normals = vec![[0; 2]; mesh.vertices.len()];
    let colors: Vec<_> = (0..mesh.vertices.len())
        .map(|vertex| color_of(0x12_3457 * vertex))
        .collect();
    let (ambient, lights, points) = (U0F16::MAX, [], []);
    let lit = || GouraudSkin {
        colors: &colors,
        normals: &normals,
        lights: Lambert {
            ambient,
            lights,
            points,
        },
    };
    check::<Gouraud<Rgb888, Lambert<0>>>(&mesh, lit());
    check::<Fine<Deep<Gouraud<Rgb888, Lambert<0>>>>>(&mesh, lit());
    let texel = |row: u32| std::array::from_fn(|column| 0x1_2345 * (16 * row + column as u32));
    let image: [[u32; 16]; 16] = std::array::from_fn(|row| texel(row as u32));
    let coordinates: Vec<_> = mesh
        .vertices
        .iter()
        .map(|[x, y, z]| [8 * (x + z), 8 * (y - z)])
        .collect();
    let textured = || TexturedSkin {
        image: &image,
        coordinates: &coordinates,
    };
    check::<Textured<Texels<Rgb888, 16, 16>>>(&mesh, textured());
    check::<Fine<Deep<Textured<Texels<Rgb888, 16, 16>>>>>(&mesh, textured());
}

/// A picture of 9,000 rows has 14 levels, all of which its stack holds.
#[test]
fn the_largest_pictures_have_levels_enough() {
    let area = Rectangle::new(Point::new(-1, -4500), Size::new(2, 9000));
    let faces = [
        [[-10, -9000, 300], [900, 0, 300], [-10, 9000, 300]],
        [[10, -9000, 320], [20, 9000, 290], [-20, 9000, 290]],
    ];
    let scene = Scene::new(vec![mesh(&faces).two_sided()]);
    let models = scene.models(Pose::IDENTITY);
    let camera = camera(area).with_focal_length(I16F16::from_num(64)).unwrap();
    let mut memory = Box::new(Memory::<LookIn<Sub8, u32>, 20, 30, 2, 9000>::new());
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    let mut method = Warnock::<1>::new();
    draw(&mut prepared, area, &mut method);
    assert!(method.pixels_compared() > 0, "{:?}", counts(&method));
}
