//! Shaded pictures do not depend on the bands they are drawn in: on their height, their order, their columns, the
//! number of slots, and whether the scene is an item of a picture.

use embedded_graphics::{
    pixelcolor::{Rgb565, RgbColor},
    prelude::*,
    primitives::Rectangle,
};
use proptest::prelude::*;
use zrow::{
    band::{Band, BandColor},
    draw::{Picture, PictureSlot},
    scene::{Camera, Deep, Fine, Look, Memory, Model, Pose, Prepared, SceneItem},
    shade::{Bilinear, Clamped, CutOut, Foggy, Gouraud, LitTextured, Texels, Textured},
};

use crate::common::meshes::Mesh;
use crate::common::{cases, config, is_quick};
use crate::numbered_scene::area;
use crate::random_faces::{faces, pose};
use crate::shaded_scene::{Even, FourColors, InSpace, Shiny, Skinned, VertexData, vertex_data};
use crate::snapped_faces::camera;

const WIDTH: usize = 48;
const HEIGHT: usize = 40;

type MemoryOf<L, const ACTIVE: usize> = Memory<L, 400, 64, WIDTH, HEIGHT, ACTIVE>;
pub type WordOf<L> = <<L as Look>::Color as BandColor>::Word;

/// How a picture is divided.
#[derive(Debug, Copy, Clone)]
enum Order {
    Down,
    Up,
    /// Every seventh band, and so on around.
    Mixed,
}

/// The bands of an area, of this width and height, in an order.
fn bands(whole: Rectangle, [width, height]: [u32; 2], order: Order) -> Vec<Rectangle> {
    let tops = (0..whole.size.height).step_by(height as usize);
    let mut bands: Vec<_> = tops
        .flat_map(|top| {
            (0..whole.size.width)
                .step_by(width as usize)
                .map(move |left| (left, top))
        })
        .map(|(left, top)| {
            let corner = whole.top_left + Size::new(left, top);
            Rectangle::new(corner, Size::new(width, height)).intersection(&whole)
        })
        .collect();
    match order {
        Order::Down => {}
        Order::Up => bands.reverse(),
        Order::Mixed => {
            let count = bands.len();
            let step = [7, 11, 13].into_iter().find(|step| count % step != 0).unwrap_or(1);
            bands = (0..count).map(|index| bands[index * step % count]).collect();
        }
    }
    bands
}

/// The words of a picture that is drawn in bands, on black.
fn in_bands<C: BandColor + RgbColor>(
    whole: Rectangle,
    bands: &[Rectangle],
    draw: &mut dyn FnMut(&mut Band<'_, C>),
) -> Vec<C::Word> {
    let black = C::BLACK.to_word();
    let mut picture = vec![black; (whole.size.width * whole.size.height) as usize];
    for area in bands {
        let mut words = vec![black; (area.size.width * area.size.height) as usize];
        draw(&mut Band::new(*area, &mut words).unwrap());
        for (point, word) in area.points().zip(words) {
            let at = point - whole.top_left;
            picture[(at.y as u32 * whole.size.width + at.x as u32) as usize] = word;
        }
    }
    picture
}

const SIZES: [([u32; 2], Order); 7] = [
    ([100, 100], Order::Down),
    ([100, 1], Order::Down),
    ([100, 3], Order::Up),
    ([100, 1], Order::Mixed),
    ([17, 5], Order::Down),
    ([5, 1], Order::Mixed),
    ([1, 40], Order::Up),
];

/// Compares a picture that is drawn in bands of a size and an order.
fn compare_in_bands<C: BandColor<Word: PartialEq + std::fmt::Debug> + RgbColor>(
    area: Rectangle,
    size: [u32; 2],
    order: Order,
    expected: &[C::Word],
    how: &str,
    draw: &mut dyn FnMut(&mut Band<'_, C>),
) {
    let drawn = in_bands::<C>(area, &bands(area, size, order), draw);
    let differing = drawn
        .iter()
        .zip(expected)
        .position(|(drawn, expected)| drawn != expected);
    if let Some(index) = differing {
        let (drawn, expected) = (&drawn[index], &expected[index]);
        let (x, y) = (index % WIDTH, index / WIDTH);
        panic!("{how}, bands of {size:?}, {order:?}: pixel {x}, {y} is {drawn:?}, not {expected:?}");
    }
}

/// Draws models with so few slots in bands of all sizes and orders.
fn check_slots<L: Look<Color: RgbColor>, const ACTIVE: usize>(
    models: &[Model<'_, L::Shading>],
    camera: &Camera,
    expected: &[WordOf<L>],
) {
    let area = camera.viewport().to_rectangle();
    let how = format!("{ACTIVE} slots");
    let mut memory = Box::new(MemoryOf::<L, ACTIVE>::new());
    for (size, order) in SIZES {
        let mut prepared = memory.prepare(camera, models).unwrap();
        compare_in_bands::<L::Color>(area, size, order, expected, &how, &mut |band| prepared.draw(band));
    }
}

/// Draws models as an item of a picture.
fn check_item<'m, L: Look<Color: RgbColor>>(
    models: [Model<'m, L::Shading>; 2],
    camera: &Camera,
    expected: &[WordOf<L>],
) {
    let area = camera.viewport().to_rectangle();
    let mut memory = Box::new(MemoryOf::<L, 64>::new());
    let scene = SceneItem::new(memory.frame(), camera, models).unwrap();
    for (size, order) in SIZES {
        let (mut slots, mut buckets) = ([PictureSlot::EMPTY; 1], [0; HEIGHT]);
        let mut picture = Picture::new(area, &mut slots, &mut [], &mut buckets);
        picture.add_item(&scene).unwrap();
        compare_in_bands::<L::Color>(area, size, order, expected, "as an item", &mut |band| {
            picture.draw(band)
        });
    }
}

fn check_look<L: Look<Color: RgbColor>>(models: [Model<'_, L::Shading>; 2], camera: &Camera) {
    let area = camera.viewport().to_rectangle();
    let mut memory = Box::new(MemoryOf::<L, 64>::new());
    let mut prepared: Prepared<'_, '_, L> = memory.prepare(camera, &models).unwrap();
    let expected = in_bands::<L::Color>(area, &[area], &mut |band| prepared.draw_with(band, |_| {}));
    check_slots::<L, 64>(&models, camera, &expected);
    check_slots::<L, 1>(&models, camera, &expected);
    check_slots::<L, 3>(&models, camera, &expected);
    check_item::<L>(models, camera, &expected);
}

fn models<'a, H: Skinned>(meshes: &'a [Mesh; 2], data: &'a [VertexData; 2], pose: Pose) -> [Model<'a, H>; 2] {
    [0, 1].map(|index| H::model(&meshes[index], &data[index]).with_pose(pose))
}

/// Two models with a shading.
fn check<H: Skinned<Color: RgbColor>>(meshes: &[Mesh; 2], data: &[VertexData; 2], pose: Pose, camera: &Camera) {
    let models = models::<H>(meshes, data, pose);
    if !is_quick() {
        check_look::<H>(models, camera);
    }
    check_look::<Fine<Deep<H>>>(models, camera);
}

fn check_all(meshes: &[Mesh; 2], data: &[VertexData; 2], pose: Pose, camera: &Camera) {
    check::<Gouraud<Rgb565>>(meshes, data, pose, camera);
    check::<Textured<Texels<Rgb565, 16, 16>>>(meshes, data, pose, camera);
    check::<LitTextured<Texels<Rgb565, 16, 16>>>(meshes, data, pose, camera);
    check::<Textured<Bilinear<Clamped<CutOut<FourColors>>>>>(meshes, data, pose, camera);
    check::<Foggy<Textured<CutOut<FourColors>>>>(meshes, data, pose, camera);
    check::<Foggy<Gouraud<Rgb565, Shiny>>>(meshes, data, pose, camera);
    check_look::<Even<2>>(models::<Even<2>>(meshes, data, pose), camera);
    check::<InSpace<2>>(meshes, data, pose, camera);
    check::<InSpace<2, 4>>(meshes, data, pose, camera);
    check::<InSpace<2, 0, 8>>(meshes, data, pose, camera);
    check_look::<InSpace<2, 0, 1>>(models::<InSpace<2, 0, 1>>(meshes, data, pose), camera);
}

/// A mesh, and its faces in another order: wherever there is a face there are two, and the first rows of some come
/// later.
fn twice(mesh: &Mesh, slid: usize) -> [Mesh; 2] {
    let mut faces = mesh.faces.clone();
    let count = faces.len();
    faces.rotate_left(slid % count);
    [mesh.clone(), Mesh::new(mesh.vertices.clone(), faces)]
}

proptest! {
    #![proptest_config(config(cases(2, 24)))]

    /// Faces that go through each other.
    #[test]
    fn interpenetrating_faces_are_shaded_alike_in_all_bands(
        meshes in [faces(900, 6), faces(900, 6)],
        data in [vertex_data(18), vertex_data(18)],
        pose in pose(1300..2500),
    ) {
        check_all(&meshes, &data, pose, &camera(area(48, 40)));
    }

    /// Faces that the near plane and the guard band cut.
    #[test]
    fn cut_faces_are_shaded_alike_in_all_bands(
        meshes in [faces(4_000, 4), faces(4_000, 4)],
        data in [vertex_data(12), vertex_data(12)],
        pose in pose(-500..800),
    ) {
        check_all(&meshes, &data, pose, &camera(area(48, 40)));
    }

    /// Two models in one place with skins that differ: of each two pixels as near as each other, that of the first is
    /// drawn.
    #[test]
    fn ties_are_shaded_alike_in_all_bands(
        mesh in faces(1_500, 5),
        data in [vertex_data(15), vertex_data(15)],
        pose in pose(1300..2500),
        slid in 0usize..5,
    ) {
        check_all(&twice(&mesh, slid), &data, pose, &camera(area(48, 40)));
    }

    /// Coplanar faces that reach beyond the picture and begin in rows in another order than that of the faces.
    #[test]
    fn coplanar_faces_are_shaded_alike_in_all_bands(
        corners in prop::collection::vec(prop::array::uniform2(-1_600i16..1_600), 12),
        lean in prop::array::uniform2(-2i16..=2),
        data in [vertex_data(12), vertex_data(12)],
    ) {
        let vertices = corners.iter().map(|&[x, y]| [x, y, 1_500 + lean[0] * x / 4 + lean[1] * y / 4]).collect();
        let faces = (0..4).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect();
        let mesh = Mesh::new(vertices, faces).two_sided();
        check_all(&twice(&mesh, 3), &data, Pose::IDENTITY, &camera(area(48, 40)));
    }
}
