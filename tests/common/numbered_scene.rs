//! Scenes whose faces are coloured by their number, so that a picture says which face is seen in each pixel.
#![allow(dead_code)]

use embedded_graphics::{pixelcolor::Rgb888, prelude::*, primitives::Rectangle};
use fixed::types::{I16F16, U0F16};
use zrow::{
    band::Band,
    mesh::FaceSet,
    scene::{ClipPolicy, Model, Prepared},
    view::{Camera, DepthWidth, Pose, Rotation, ScreenPrecision},
};

use crate::common::meshes::Mesh;
use crate::reference::nearest_faces::{Depth, Face, owners};

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

impl Mesh {
    pub fn new(vertices: Vec<[i16; 3]>, faces: Vec<[u16; 3]>) -> Self {
        Self { vertices, faces }
    }

    pub fn face_set(&self) -> FaceSet<'_> {
        FaceSet::new(&self.vertices, &self.faces).unwrap()
    }

    /// The same with each face seen from both sides.
    pub fn two_sided(mut self) -> Self {
        let behind: Vec<_> = self.faces.iter().map(|&[a, b, c]| [a, c, b]).collect();
        self.faces.extend(behind);
        self
    }
}

/// The pose of the standard scenes in a frame: 512 steps are a turn.
pub fn standard_pose(frame: u16) -> Pose {
    let steps = |steps: u16| U0F16::from_bits((steps % 512) * 128);
    let rotation = Rotation::about_x(steps(frame * 8)).then(&Rotation::about_y(steps(frame * 16)));
    Pose::new(rotation, at(0, 0, 3 * 512))
}

pub fn at(x: i32, y: i32, z: i32) -> [I16F16; 3] {
    [x, y, z].map(I16F16::from_num)
}

/// A camera at the origin with the near plane 128 units away.
pub fn camera(area: Rectangle) -> Camera {
    Camera::new(area, I16F16::from_num(128)).unwrap()
}

pub fn area(width: u32, height: u32) -> Rectangle {
    Rectangle::new(Point::zero(), Size::new(width, height))
}

/// The faces as they were snapped and cut.
pub fn snapped<
    const V: usize,
    const F: usize,
    const A: usize,
    const R: usize,
    S: ScreenPrecision,
    D: DepthWidth,
    K: ClipPolicy,
>(
    prepared: &Prepared<'_, Rgb888, V, F, A, R, S, D, K>,
) -> Vec<Face> {
    prepared
        .faces()
        .map(|face| Face {
            order: face.order,
            corners: face.corners.map(|corner| {
                [
                    corner.point.x_units().into(),
                    corner.point.y_units().into(),
                    corner.depth.units().into(),
                ]
            }),
        })
        .collect()
}

/// The face in each pixel of an area, drawn in one band.
pub fn picture<
    const V: usize,
    const F: usize,
    const A: usize,
    const R: usize,
    S: ScreenPrecision,
    D: DepthWidth,
    K: ClipPolicy,
>(
    prepared: &mut Prepared<'_, Rgb888, V, F, A, R, S, D, K>,
    area: Rectangle,
) -> Vec<Option<usize>> {
    let mut words = vec![0; (area.size.width * area.size.height) as usize];
    let mut depths = vec![D::default(); area.size.width as usize];
    let mut band = Band::<Rgb888>::new(area, &mut words).unwrap();
    prepared.draw(&mut band, &mut depths).unwrap();
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
pub fn compare<
    const V: usize,
    const F: usize,
    const A: usize,
    const R: usize,
    S: ScreenPrecision,
    D: DepthWidth,
    K: ClipPolicy,
>(
    prepared: &mut Prepared<'_, Rgb888, V, F, A, R, S, D, K>,
    area: Rectangle,
) -> usize {
    let unit = 1 << S::FRACTION_BITS;
    let (depth, tolerance) = depth_and_tolerance::<D>(area);
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
