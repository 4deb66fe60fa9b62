//! Holes: what is behind is seen through them, as if they were no part of the face, however a picture is drawn.

use embedded_graphics::{pixelcolor::Rgb888, prelude::*, primitives::Rectangle};
use proptest::prelude::*;
use zrow::{
    band::Band,
    scene::{Camera, Deep, DepthWidth, Fine, Look, Memory, Model, Pose, Prepared},
    shade::{CutOut, Indexed, IndexedImage, Shading, Textured, TexturedSkin},
    visible::DepthSort,
};

use crate::common::meshes::Mesh;
use crate::common::{cases, config};
use crate::numbered_scene::area;
use crate::random_faces::{faces, pose};
use crate::reference::nearest_faces::Depth;
use crate::shaded_scene::unit;
use crate::snapped_faces::{camera, snapped};

pub const WIDTH: usize = 48;
pub const HEIGHT: usize = 40;
/// What nothing is drawn to.
pub const UNTOUCHED: u32 = 0xff00_00ff;

/// A pattern of holes.
pub type Pattern = [[u8; 2]; 4];
pub type Holed = Textured<CutOut<Indexed<Rgb888, 2, 4, 4>>>;

/// A shading that varies evenly on the screen, with stripes of holes.
#[derive(Debug)]
pub struct EvenHoles;

impl Shading for EvenHoles {
    type Color = Rgb888;
    /// Numbers of the vertices, and a colour.
    type Skin<'a> = (&'a [[i16; 2]], u32);
    type Uniforms = ();
    type Attributes = [i16; 1];

    fn uniforms(_: &Self::Skin<'_>, _: &Pose, _: &Camera) {}

    fn vertex((numbers, _): &Self::Skin<'_>, (): &(), vertex: usize, _: [i32; 3]) -> [i16; 1] {
        [numbers[vertex][0]]
    }

    fn fragment((_, color): &Self::Skin<'_>, _: u32, [number]: &[i32; 1]) -> Option<u32> {
        (number & 1 << 25 != 0).then_some(color ^ (*number as u32 >> 16 & 0xff))
    }
}

/// What is drawn in an area, in bands of some rows, the lower ones first where there are many.
pub fn drawn<L: Look<Color = Rgb888>>(
    prepared: &mut Prepared<'_, '_, L>,
    whole: Rectangle,
    rows: u32,
    always: bool,
) -> Vec<u32> {
    let mut picture = vec![UNTOUCHED; WIDTH * HEIGHT];
    let bands: Vec<_> = picture.chunks_mut(WIDTH * rows as usize).enumerate().collect();
    for (index, words) in bands.into_iter().rev() {
        let top = Point::new(0, index as i32 * rows as i32);
        let window = Rectangle::new(top, Size::new(WIDTH as u32, rows)).intersection(&whole);
        let mut band = Band::<Rgb888>::new(window, words).unwrap();
        if always {
            prepared.draw_with(&mut band, |_| {});
        } else {
            prepared.draw(&mut band);
        }
    }
    picture
}

/// The painter's algorithm draws a picture that the depth row has drawn: with room for all parts of faces, for few, and for none.
pub fn check_painted<L: Look<Color = Rgb888>>(prepared: &mut Prepared<'_, '_, L>, expected: &[u32]) {
    let [mut none, mut few, mut all] = [const { [UNTOUCHED; WIDTH * HEIGHT] }; 3];
    for rows in [3, HEIGHT] {
        for top in (0..HEIGHT).step_by(rows) {
            let rows = rows.min(HEIGHT - top);
            let window = Rectangle::new(Point::new(0, top as i32), Size::new(WIDTH as u32, rows as u32));
            let range = top * WIDTH..(top + rows) * WIDTH;
            let [mut none, mut few, mut all] = [&mut none, &mut few, &mut all].map(|words| {
                words[range.clone()].fill(UNTOUCHED);
                Band::<Rgb888>::new(window, &mut words[range.clone()]).unwrap()
            });
            prepared.draw_by(&mut DepthSort::<900, 0>::new(), &mut none).unwrap();
            prepared.draw_by(&mut DepthSort::<900, 9>::new(), &mut few).unwrap();
            prepared.draw_by(&mut DepthSort::<900, 900>::new(), &mut all).unwrap();
        }
        for (words, parts) in [(&none, "no"), (&few, "few"), (&all, "all")] {
            let differing = words.iter().zip(expected).position(|(word, expected)| word != expected);
            assert_eq!(differing, None, "painted in bands of {rows} rows, {parts} parts");
        }
    }
}

/// A model of each single face, in the order of models and faces.
pub fn single(meshes: &[Mesh]) -> Vec<(usize, Mesh)> {
    let each = |(index, mesh): (usize, &Mesh)| {
        let alone = |face: &[u16; 3]| (index, Mesh::new(mesh.vertices.clone(), vec![*face]));
        mesh.faces.iter().map(alone).collect::<Vec<_>>()
    };
    meshes.iter().enumerate().flat_map(each).collect()
}

/// Draws models, and each of their faces alone: in each pixel the nearest fragment that is no hole is seen, and of equally near
/// ones the first.
fn check<L: Look<Color = Rgb888>>(
    meshes: &[Mesh],
    skin: impl Fn(usize) -> <L::Shading as Shading>::Skin<'static>,
    pose: Pose,
) -> usize {
    let meshes = leak(meshes.to_vec());
    let whole = area(WIDTH as u32, HEIGHT as u32);
    let camera = camera(whole);
    let mut many = Box::new(Memory::<L, 400, 64, WIDTH, HEIGHT, 64>::new());
    let mut one = Box::new(Memory::<L, 400, 64, WIDTH, HEIGHT, 1>::new());
    let depth = if L::Depth::FRACTION_BITS == 16 {
        Depth::Bits16
    } else {
        Depth::Bits32
    };
    let mut nearest = vec![(0, UNTOUCHED); WIDTH * HEIGHT];
    let mut unsure = vec![false; WIDTH * HEIGHT];
    let mut holes = 0;
    for (index, mesh) in single(meshes) {
        let mesh = leak(mesh);
        let models = [Model::<L::Shading>::with_skin(mesh.face_set(), skin(index))
            .unwrap()
            .with_pose(pose)];
        let mut prepared = many.prepare(&camera, &models).unwrap();
        let faces = snapped(&prepared);
        let alone = drawn(&mut prepared, whole, HEIGHT as u32, true);
        for face in faces {
            for (at, point) in whole.points().enumerate() {
                let [x, y] = [point.x, point.y].map(|pixels| i128::from(pixels) * unit::<L>());
                if !face.covers(x, y) {
                    continue;
                }
                let stored = face.stored(x, y, depth);
                if alone[at] == UNTOUCHED {
                    holes += 1;
                    continue;
                }
                // Depths are interpolated with an error; coplanar faces have the same.
                let (before, _) = nearest[at];
                let most = if matches!(depth, Depth::Bits16) { 2 } else { 200 };
                let differ: i128 = stored - before;
                unsure[at] = (unsure[at] && differ <= most) || (differ != 0 && differ.abs() <= most);
                if stored > before {
                    nearest[at] = (stored, alone[at]);
                }
            }
        }
    }
    let models: Vec<_> = (0..meshes.len())
        .map(|index| {
            Model::<L::Shading>::with_skin(meshes[index].face_set(), skin(index))
                .unwrap()
                .with_pose(pose)
        })
        .collect();
    let picture = drawn(&mut many.prepare(&camera, &models).unwrap(), whole, HEIGHT as u32, true);
    for (at, word) in picture.iter().enumerate() {
        let (x, y) = (at % WIDTH, at / WIDTH);
        assert!(
            unsure[at] || *word == nearest[at].1,
            "{x}, {y}: {word:x}, not {:x?}",
            nearest[at]
        );
    }
    for rows in [1, 3, 17, HEIGHT as u32] {
        for always in [true, false] {
            let of_many = drawn(&mut many.prepare(&camera, &models).unwrap(), whole, rows, always);
            assert!(of_many == picture, "in bands of {rows} rows, {always}");
            let of_one = drawn(&mut one.prepare(&camera, &models).unwrap(), whole, rows, always);
            assert!(of_one == picture, "with one slot, in bands of {rows} rows, {always}");
        }
    }
    check_painted(&mut many.prepare(&camera, &models).unwrap(), &picture);
    holes
}

/// Something that lives as long as the test.
pub fn leak<T>(value: T) -> &'static T {
    Box::leak(Box::new(value))
}

/// Skins of models: patterns, and coordinates of vertices.
pub fn skins(
    patterns: &[Pattern],
    coordinates: &[Vec<[i16; 2]>],
) -> Vec<TexturedSkin<'static, CutOut<Indexed<Rgb888, 2, 4, 4>>>> {
    let palettes = [
        [1, 0x20_0000, 0x20_0040, 0x20_0080],
        [1, 0x90_0000, 0x90_0040, 0x90_0080],
    ];
    let each = |((pattern, coordinates), palette): ((&Pattern, &Vec<[i16; 2]>), [u32; 4])| TexturedSkin {
        image: IndexedImage {
            indices: leak(*pattern),
            palette: leak(palette),
        },
        coordinates: leak(coordinates.clone()),
    };
    patterns.iter().zip(coordinates).zip(palettes).map(each).collect()
}

/// A mesh, and its faces in another order, in the same place.
pub fn twice(mesh: &Mesh, slid: usize) -> [Mesh; 2] {
    let mut faces = mesh.faces.clone();
    let count = faces.len();
    faces.rotate_left(slid % count);
    [mesh.clone(), Mesh::new(mesh.vertices.clone(), faces)]
}

fn check_all(meshes: &[Mesh; 2], patterns: [Pattern; 2], coordinates: &[Vec<[i16; 2]>; 2], pose: Pose) {
    let skins = skins(&patterns, coordinates);
    check::<Holed>(meshes, |index| skins[index], pose);
    check::<Fine<Deep<Holed>>>(meshes, |index| skins[index], pose);
    let numbers = coordinates.clone().map(|coordinates| &**leak(coordinates));
    let even = |index: usize| (numbers[index], 0x50_0000 + 0x50_0000 * index as u32);
    check::<EvenHoles>(meshes, even, pose);
}

pub fn any_coordinates(count: usize) -> BoxedStrategy<Vec<[i16; 2]>> {
    prop::collection::vec(prop::array::uniform2(-8_000i16..8_000), count).boxed()
}

proptest! {
    #![proptest_config(config(cases(12, 300)))]

    /// Two models in one place, with different holes.
    #[test]
    fn ties_are_not_won_by_holes(
        mesh in faces(1_500, 4),
        patterns in any::<[Pattern; 2]>(),
        coordinates in [any_coordinates(12), any_coordinates(12)],
        pose in pose(1300..2500),
        slid in 0usize..4,
    ) {
        check_all(&twice(&mesh, slid), patterns, &coordinates, pose);
    }

    /// Faces that go through each other.
    #[test]
    fn what_is_behind_holes_is_seen(
        meshes in [faces(900, 5), faces(900, 5)],
        patterns in any::<[Pattern; 2]>(),
        coordinates in [any_coordinates(15), any_coordinates(15)],
        pose in pose(1300..2500),
    ) {
        check_all(&meshes, patterns, &coordinates, pose);
    }
}

/// Two squares in one place, of which one has holes or the other: both orders, and where both have holes nothing is drawn.
#[test]
fn of_equally_near_faces_the_first_that_is_no_hole_is_seen() {
    let square = Mesh::new(
        vec![
            [-900, -900, 1_500],
            [-900, 900, 1_500],
            [900, 900, 1_500],
            [900, -900, 1_500],
        ],
        vec![[0, 1, 2], [0, 2, 3]],
    );
    let coordinates = vec![[0, 4_096], [0, 0], [4_096, 0], [4_096, 4_096]];
    let [full, holed]: [Pattern; 2] = [[[0x55; 2]; 4], [[0x0f, 0xa5], [0, 0xff], [0xff, 0], [0x30, 0x0c]]];
    for patterns in [[full, holed], [holed, full], [holed, holed]] {
        let skins = skins(&patterns, &[coordinates.clone(), coordinates.clone()]);
        let holes = check::<Holed>(&[square.clone(), square.clone()], |index| skins[index], Pose::IDENTITY);
        assert!(holes > 100, "{holes}");
    }
}

/// Where no span overlaps another, rows are drawn without depths, and have the same holes.
#[test]
fn rows_without_depths_have_holes() {
    let triangle = Mesh::new(
        vec![[-700, -700, 1_000], [0, 700, 1_000], [700, -700, 1_000]],
        vec![[0, 1, 2]],
    );
    let numbers = [[0, 0], [2_000, 0], [4_000, 0]];
    let models = [Model::<EvenHoles>::with_skin(triangle.face_set(), (&numbers[..], 0x10_0000)).unwrap()];
    let whole = area(WIDTH as u32, HEIGHT as u32);
    let mut memory = Box::new(Memory::<EvenHoles, 3, 1, WIDTH, HEIGHT, 1>::new());
    let (camera, mut pictures) = (camera(whole), vec![]);
    for always in [true, false] {
        let mut prepared = memory.prepare(&camera, &models).unwrap();
        pictures.push(drawn(&mut prepared, whole, HEIGHT as u32, always));
        assert_eq!(prepared.rows_without_depth() > 0, !always);
    }
    assert!(pictures[0] == pictures[1]);
    let seen = pictures[0].iter().filter(|&&word| word != UNTOUCHED).count();
    let covered = pictures[0].len();
    assert!((100..covered / 2).contains(&seen), "{seen}");
}
