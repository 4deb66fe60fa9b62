//! A shading without holes, whose depths are tested before its fragments are computed, gives the picture of the same one that
//! may have holes, whose fragments are computed pixel by pixel.

use embedded_graphics::pixelcolor::Rgb888;
use proptest::prelude::*;
use zrow::{
    scene::{Camera, Deep, Fine, Look, Memory, Model, Pose},
    shade::{Indexed, IndexedImage, Shading, Textured, TexturedSkin},
};

use crate::common::meshes::Mesh;
use crate::common::{cases, config};
use crate::holes::{HEIGHT, UNTOUCHED, WIDTH, any_coordinates, drawn, leak, twice};
use crate::numbered_scene::area;
use crate::random_faces::{faces, pose};
use crate::snapped_faces::camera;

type Image = Indexed<Rgb888, 2, 4, 4>;

/// A shading that varies evenly on the screen.
#[derive(Debug)]
struct Even<const HOLES: bool>;

impl<const HOLES: bool> Shading for Even<HOLES> {
    type Color = Rgb888;
    /// Numbers of the vertices, and a colour.
    type Skin<'a> = (&'a [[i16; 2]], u32);
    type Uniforms = ();
    type Attributes = [i16; 2];
    const HAS_HOLES: bool = HOLES;

    fn uniforms(_: &Self::Skin<'_>, _: &Pose, _: &Camera) {}

    fn vertex((numbers, _): &Self::Skin<'_>, (): &(), vertex: usize, _: [i32; 3]) -> [i16; 2] {
        numbers[vertex]
    }

    fn fragment((_, color): &Self::Skin<'_>, _: u32, [one, other]: &[i32; 2]) -> Option<u32> {
        Some(color ^ (*one as u32 >> 20 & 0xff) ^ (*other as u32 >> 12 & 0xff00))
    }
}

/// A texture without holes, as one that may have some.
#[derive(Debug)]
struct InPixels;

impl Shading for InPixels {
    type Color = Rgb888;
    type Skin<'a> = TexturedSkin<'a, Image>;
    type Uniforms = ();
    type Attributes = <Textured<Image> as Shading>::Attributes;
    const TOLERANCE: u16 = Textured::<Image>::TOLERANCE;
    const HAS_HOLES: bool = true;

    fn uniforms(_: &Self::Skin<'_>, _: &Pose, _: &Camera) {}

    fn vertex(skin: &Self::Skin<'_>, (): &(), vertex: usize, position: [i32; 3]) -> Self::Attributes {
        Textured::<Image>::vertex(skin, &(), vertex, position)
    }

    fn fragment(skin: &Self::Skin<'_>, face: u32, attributes: &[i32; 2]) -> Option<u32> {
        Textured::<Image>::fragment(skin, face, attributes)
    }
}

/// The pictures of models in bands of several heights, which are one.
fn picture<L: Look<Color = Rgb888>>(
    meshes: &[Mesh],
    skin: impl Fn(usize) -> <L::Shading as Shading>::Skin<'static>,
    pose: Pose,
) -> Vec<u32> {
    let whole = area(WIDTH as u32, HEIGHT as u32);
    let models: Vec<_> = meshes
        .iter()
        .enumerate()
        .map(|(index, mesh)| {
            let mesh = leak(mesh.clone());
            Model::<L::Shading>::with_skin(mesh.face_set(), skin(index))
                .unwrap()
                .with_pose(pose)
        })
        .collect();
    let mut memory = Box::new(Memory::<L, 400, 64, WIDTH, HEIGHT, 64>::new());
    let camera = camera(whole);
    let mut in_bands = |rows, always| drawn(&mut memory.prepare(&camera, &models).unwrap(), whole, rows, always);
    let picture = in_bands(HEIGHT as u32, true);
    for rows in [1, 17] {
        for always in [true, false] {
            assert!(in_bands(rows, always) == picture, "in bands of {rows} rows, {always}");
        }
    }
    picture
}

fn check(meshes: &[Mesh; 2], coordinates: &[Vec<[i16; 2]>; 2], pose: Pose) -> usize {
    let numbers = coordinates.clone().map(|coordinates| &**leak(coordinates));
    let even = |index: usize| (numbers[index], 0x50_0000 + 0x50_0000 * index as u32);
    let pictures = [
        picture::<Even<false>>(meshes, even, pose),
        picture::<Even<true>>(meshes, even, pose),
    ];
    assert!(pictures[0] == pictures[1]);
    let textured = |index: usize| TexturedSkin {
        image: IndexedImage {
            indices: leak([[0x1b, 0xe4], [0x72, 0x8d], [0xc9, 0x36], [0x93, 0x6c]]),
            palette: leak([1, 2, 3, 4].map(|color: u32| color << (8 * index))),
        },
        coordinates: numbers[index],
    };
    let pictures = [
        picture::<Textured<Image>>(meshes, textured, pose),
        picture::<InPixels>(meshes, textured, pose),
    ];
    assert!(pictures[0] == pictures[1]);
    let fine = [
        picture::<Fine<Deep<Textured<Image>>>>(meshes, textured, pose),
        picture::<Fine<Deep<InPixels>>>(meshes, textured, pose),
    ];
    assert!(fine[0] == fine[1]);
    pictures[0].iter().filter(|&&word| word != UNTOUCHED).count()
}

proptest! {
    #![proptest_config(config(cases(24, 600)))]

    /// Two models in one place: their depths are equal.
    #[test]
    fn ties_are_won_alike(
        mesh in faces(1_500, 4),
        coordinates in [any_coordinates(12), any_coordinates(12)],
        pose in pose(1300..2500),
        slid in 0usize..4,
    ) {
        check(&twice(&mesh, slid), &coordinates, pose);
    }

    /// Faces that go through each other, and beyond the picture.
    #[test]
    fn what_is_partly_hidden_is_the_same(
        meshes in [faces(2_500, 5), faces(900, 5)],
        coordinates in [any_coordinates(15), any_coordinates(15)],
        pose in pose(1300..2500),
    ) {
        check(&meshes, &coordinates, pose);
    }
}

/// Two triangles that go through each other, one in front of the other on each side.
#[test]
fn faces_that_cross_are_seen_in_part() {
    let triangle = |[left, right]: [i16; 2]| {
        Mesh::new(
            vec![[-800, -800, left], [0, 800, (left + right) / 2], [800, -800, right]],
            vec![[0, 1, 2]],
        )
    };
    let coordinates = [0, 1].map(|_| vec![[0, 0], [4_000, 0], [0, 8_000]]);
    let seen = check(
        &[triangle([900, 2_500]), triangle([2_500, 900])],
        &coordinates,
        Pose::IDENTITY,
    );
    assert!(seen > 100, "{seen}");
}
