//! Faces over which attributes vary look the same by every method of visibility, also where only parts of a span are seen.

use embedded_graphics::{pixelcolor::Rgb888, prelude::*, primitives::Rectangle};
use proptest::prelude::*;
use zrow::{
    band::Band,
    scan::Polygons,
    scene::{Camera, Deep, Fine, Look, Memory, Model, Pose, Prepared},
    shade::{Indexed, IndexedImage, Shading, Textured, TexturedSkin},
    visible::{DepthBuffer, DepthSort, OneDepth, RayCasting, SpanScanLine, TileBins, Visibility, Warnock},
};

use crate::common::meshes::Mesh;
use crate::common::{cases, config};
use crate::holes::{HEIGHT, UNTOUCHED, WIDTH, any_coordinates, leak};
use crate::numbered_scene::area;
use crate::random_faces::{faces, pose};
use crate::snapped_faces::camera;

type Image = Indexed<Rgb888, 2, 4, 4>;

/// A shading that varies evenly on the screen.
#[derive(Debug)]
pub struct Even;

impl Shading for Even {
    type Color = Rgb888;
    type Skin<'a> = TexturedSkin<'a, Image>;
    type Uniforms = ();
    type Attributes = [i16; 2];
    const HAS_HOLES: bool = false;

    fn uniforms(_: &Self::Skin<'_>, _: &Pose, _: &Camera) {}

    fn vertex(skin: &Self::Skin<'_>, (): &(), vertex: usize, _: [i32; 3]) -> [i16; 2] {
        skin.coordinates[vertex]
    }

    fn fragment(_: &Self::Skin<'_>, _: u32, [one, other]: &[i32; 2]) -> Option<u32> {
        Some((*one as u32 >> 20 & 0xff) | (*other as u32 >> 12 & 0xff00))
    }
}

/// The words of a part of the picture.
fn words<L: Look<Color = Rgb888>>(
    prepared: &mut Prepared<'_, '_, L>,
    part: Rectangle,
    draw: impl FnOnce(&mut Prepared<'_, '_, L>, &mut Band<'_, Rgb888>),
) -> Vec<u32> {
    let mut words = vec![UNTOUCHED; (part.size.width * part.size.height) as usize];
    draw(prepared, &mut Band::new(part, &mut words).unwrap());
    words
}

/// Compares a method with the depth row, in the whole picture and in a part of some of its rows.
fn check_method<L: Look<Color = Rgb888>>(
    prepared: &mut Prepared<'_, '_, L>,
    name: &str,
    method: &mut impl Visibility<L::Depth>,
) {
    let part = Rectangle::new(Point::new(13, 9), Size::new(29, 7));
    for part in [area(WIDTH as u32, HEIGHT as u32), part] {
        let expected = words(prepared, part, |prepared, band| prepared.draw(band));
        let drawn = words(prepared, part, |prepared, band| prepared.draw_by(method, band).unwrap());
        assert!(drawn == expected, "{name}, {part:?}");
    }
}

/// Draws a mesh in a look by all methods; returns how many pixels show a face.
fn check<L>(mesh: &'static Mesh, skin: TexturedSkin<'static, Image>, pose: Pose) -> usize
where
    L: Look<Color = Rgb888>,
    L::Shading: Shading<Skin<'static> = TexturedSkin<'static, Image>>,
{
    let model = Model::<L::Shading>::with_skin(mesh.face_set(), skin).unwrap();
    let models = [model.with_pose(pose)];
    let mut memory = Box::new(Memory::<L, 400, 64, WIDTH, HEIGHT, 64>::new());
    let whole = area(WIDTH as u32, HEIGHT as u32);
    let mut prepared = memory.prepare(&camera(whole), &models).unwrap();
    check_method(
        &mut prepared,
        "depth buffer",
        &mut DepthBuffer::<L::Depth, { WIDTH * HEIGHT }>::new(),
    );
    check_method(&mut prepared, "depth sort", &mut DepthSort::<400, 40>::new());
    check_method(&mut prepared, "one depth", &mut OneDepth::new(Polygons::winding_number));
    check_method(&mut prepared, "ray casting", &mut RayCasting::<400>::new());
    check_method(&mut prepared, "spans", &mut SpanScanLine::<64>::new());
    check_method(&mut prepared, "tile bins", &mut TileBins::<L::Depth, 9, 4_000>::new());
    check_method(&mut prepared, "Warnock", &mut Warnock::<400>::new());
    let picture = words(&mut prepared, whole, |prepared, band| prepared.draw(band));
    picture.iter().filter(|word| **word != UNTOUCHED).count()
}

/// Draws a mesh with attributes that are even and such that are divided, in two precisions.
fn check_looks(mesh: Mesh, coordinates: Vec<[i16; 2]>, pose: Pose) -> usize {
    let (mesh, coordinates): (_, &[_]) = (leak(mesh), leak(coordinates));
    let skin = TexturedSkin {
        image: IndexedImage {
            indices: leak([[0x1b, 0xe4], [0x72, 0x8d], [0xc9, 0x36], [0x93, 0x6c]]),
            palette: leak([1, 2, 3, 4]),
        },
        coordinates,
    };
    check::<Even>(mesh, skin, pose);
    check::<Fine<Deep<Even>>>(mesh, skin, pose);
    check::<Fine<Deep<Textured<Image>>>>(mesh, skin, pose);
    check::<Textured<Image>>(mesh, skin, pose)
}

proptest! {
    #![proptest_config(config(cases(12, 200)))]

    /// Faces that go through each other, and beyond the picture.
    #[test]
    fn shaded_faces_by_all_methods(
        mesh in faces(2_500, 8),
        coordinates in any_coordinates(24),
        pose in pose(1300..2500),
    ) {
        check_looks(mesh, coordinates, pose);
    }
}

/// A floor that goes far back, seen through a face in front of it: attributes are divided every 16 pixels, also where the face
/// in front ends between them.
#[test]
fn a_floor_behind_a_face_by_all_methods() {
    let mesh = Mesh::new(
        vec![
            [-3_000, -300, 300],
            [0, -200, 9_000],
            [3_000, -300, 300],
            [-90, -400, 800],
            [-20, 200, 1_000],
            [130, -400, 800],
        ],
        vec![[0, 1, 2], [3, 4, 5]],
    );
    let coordinates = [[0, 0], [9_000, 12_000], [18_000, 0], [0, 0], [5_000, 9_000], [9_000, 0]];
    let seen = check_looks(mesh, coordinates.to_vec(), Pose::IDENTITY);
    assert!(seen > 500, "{seen}");
}
