//! Scenes whose faces are coloured by their number, so that a picture says which face is seen in each pixel.

use embedded_graphics::{pixelcolor::Rgb888, prelude::*, primitives::Rectangle};
use zrow::{
    band::Band,
    geometry::{Sub4, Sub8, SubPixel},
    scene::{Deep, DepthWidth, Fine, Look, Model, Pose, Prepared, ScreenPrecision, Whole},
};

use crate::common::meshes::Mesh;
use crate::reference::nearest_faces::{Depth, owners};
use crate::snapped_faces::snapped;

/// A precision with a width of depths, and the looks of numbered scenes that both name.
pub trait Format<D: DepthWidth>: ScreenPrecision {
    type Look: Look<Color = Rgb888, Shading = Rgb888, Precision = Self, Depth = D>;
    /// The look that cuts no faces.
    type WholeLook: Look<Color = Rgb888, Shading = Rgb888, Precision = Self, Depth = D>;
}

impl Format<u16> for Sub4 {
    type Look = Rgb888;
    type WholeLook = Whole<Rgb888>;
}

impl Format<u32> for Sub4 {
    type Look = Deep<Rgb888>;
    type WholeLook = Deep<Whole<Rgb888>>;
}

impl Format<u16> for Sub8 {
    type Look = Fine<Rgb888>;
    type WholeLook = Fine<Whole<Rgb888>>;
}

impl Format<u32> for Sub8 {
    type Look = Fine<Deep<Rgb888>>;
    type WholeLook = Whole<Fine<Deep<Rgb888>>>;
}

pub type LookIn<S, D = u16> = <S as Format<D>>::Look;
pub type WholeLookIn<S, D = u16> = <S as Format<D>>::WholeLook;

/// A colour that names a face; black is no face.
pub fn color_of(order: usize) -> Rgb888 {
    let number = order as u32 + 1;
    Rgb888::new((number >> 16) as u8, (number >> 8) as u8, number as u8)
}

fn face_of(color: Rgb888) -> Option<usize> {
    let number = u32::from(color.r()) << 16 | u32::from(color.g()) << 8 | u32::from(color.b());
    (number > 0).then(|| number as usize - 1)
}

/// Models whose faces are numbered through.
pub struct Scene {
    meshes: Vec<Mesh>,
    colors: Vec<Vec<Rgb888>>,
}

impl Scene {
    pub fn new(meshes: Vec<Mesh>) -> Self {
        let mut numbers = 0..;
        let colors = meshes
            .iter()
            .map(|mesh| numbers.by_ref().take(mesh.faces.len()).map(color_of).collect())
            .collect();
        Self { meshes, colors }
    }

    pub fn models(&self, pose: Pose) -> Vec<Model<'_, Rgb888>> {
        self.meshes
            .iter()
            .zip(&self.colors)
            .map(|(mesh, colors)| Model::new(mesh.face_set(), colors).unwrap().with_pose(pose))
            .collect()
    }
}

pub fn area(width: u32, height: u32) -> Rectangle {
    Rectangle::new(Point::zero(), Size::new(width, height))
}

/// The face in each pixel of an area, drawn in one band.
pub fn picture<L: Look<Color = Rgb888, Shading = Rgb888>>(
    prepared: &mut Prepared<'_, '_, L>,
    area: Rectangle,
) -> Vec<Option<usize>> {
    let mut words = vec![0; (area.size.width * area.size.height) as usize];
    let mut band = Band::<Rgb888>::new(area, &mut words).unwrap();
    prepared.draw(&mut band);
    band.colors().map(face_of).collect()
}

/// How depth is stored, and how far apart two exact depths may be, in those steps, that are mistaken for each other.
pub fn depth_and_tolerance<D: DepthWidth>(area: Rectangle) -> (Depth, i128) {
    match D::FRACTION_BITS {
        // Each of the two is rounded to a unit and wrong by 1/6 before: 2 * 2/3.
        16 => (Depth::Bits16, 134),
        // Each gradient is wrong by half a step for each column and row of the viewport, and three terms are rounded.
        _ => (
            Depth::Bits32,
            100 * (i128::from(area.size.width + area.size.height) + 4),
        ),
    }
}

/// Compares a picture with the exact reference and returns how many pixels differ. Panics where a pixel differs that is
/// not explained by two depths closer than the tolerance.
pub fn compare<L: Look<Color = Rgb888, Shading = Rgb888>>(
    prepared: &mut Prepared<'_, '_, L>,
    area: Rectangle,
) -> usize {
    let unit = 1 << L::Precision::FRACTION_BITS;
    let (depth, tolerance) = depth_and_tolerance::<L::Depth>(area);
    let faces = snapped(prepared);
    let expected = owners(&faces, area, unit, depth);
    let drawn = picture(prepared, area);
    let mut differing = 0;
    for ((point, expected), drawn) in area.points().zip(expected).zip(drawn) {
        if expected == drawn {
            continue;
        }
        differing += 1;
        let (x, y) = (i128::from(point.x) * unit, i128::from(point.y) * unit);
        let nearest = |owner: Option<usize>| {
            let owner = owner.unwrap_or_else(|| panic!("{point:?}: expected {expected:?}, drawn {drawn:?}"));
            let covering = faces.iter().filter(|face| face.order == owner && face.covers(x, y));
            covering
                .map(|face| face.hundredths(x, y, depth))
                .max()
                .unwrap_or_else(|| panic!("{point:?}: face {owner} does not cover it"))
        };
        let gap = nearest(expected) - nearest(drawn);
        assert!(
            gap <= tolerance,
            "{point:?}: expected {expected:?}, drawn {drawn:?}, {gap}/100 steps apart"
        );
    }
    differing
}
