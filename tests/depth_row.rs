//! The depth row against a full-frame reference in exact arithmetic.

#[path = "common/depth_reference.rs"]
mod depth_reference;
#[path = "common/meshes.rs"]
mod meshes;

use depth_reference::{Depth, Face, owners};
use embedded_graphics::{pixelcolor::Rgb888, prelude::*, primitives::Rectangle};
use fixed::types::{I16F16, U0F16};
use meshes::Mesh;
use zrow::{
    band::Band,
    geometry::{Sub4, Sub8},
    scene::{Frame, Model, Prepared},
    view::{Camera, DepthWidth, Pose, Rotation, ScreenPrecision},
};

/// A colour that names a face; black is no face.
fn color_of(order: usize) -> Rgb888 {
    let number = order as u32 + 1;
    Rgb888::new((number >> 16) as u8, (number >> 8) as u8, number as u8)
}

fn face_of(color: Rgb888) -> Option<usize> {
    let number = u32::from(color.r()) << 16 | u32::from(color.g()) << 8 | u32::from(color.b());
    (number > 0).then(|| number as usize - 1)
}

/// Models whose faces are numbered through.
struct Scene {
    meshes: Vec<Mesh>,
    colors: Vec<Vec<Rgb888>>,
}

impl Scene {
    fn new(meshes: Vec<Mesh>) -> Self {
        let mut order = 0;
        let colors = meshes
            .iter()
            .map(|mesh| {
                mesh.faces
                    .iter()
                    .map(|_| {
                        order += 1;
                        color_of(order - 1)
                    })
                    .collect()
            })
            .collect();
        Self { meshes, colors }
    }

    fn models(&self, pose: Pose) -> Vec<Model<'_, Rgb888>> {
        self.meshes
            .iter()
            .zip(&self.colors)
            .map(|(mesh, colors)| Model::new(mesh.face_set(), colors).unwrap().with_pose(pose))
            .collect()
    }
}

/// The pose of the standard scenes in a frame: 512 steps are a turn.
fn standard_pose(frame: u16) -> Pose {
    let steps = |steps: u16| U0F16::from_bits((steps % 512) * 128);
    let rotation = Rotation::about_x(steps(frame * 8)).then(&Rotation::about_y(steps(frame * 16)));
    Pose::new(rotation, [I16F16::ZERO, I16F16::ZERO, I16F16::from_num(3 * 512)])
}

fn camera(width: u32, height: u32) -> Camera {
    Camera::new(
        Rectangle::new(Point::zero(), Size::new(width, height)),
        I16F16::from_num(128),
    )
    .unwrap()
}

fn snapped<const V: usize, const F: usize, const A: usize, const R: usize, S: ScreenPrecision, D: DepthWidth>(
    prepared: &Prepared<'_, Rgb888, V, F, A, R, S, D>,
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

/// Draws into one band of the whole viewport.
fn picture<const V: usize, const F: usize, const A: usize, const R: usize, S: ScreenPrecision, D: DepthWidth>(
    prepared: &mut Prepared<'_, Rgb888, V, F, A, R, S, D>,
    area: Rectangle,
) -> Vec<Option<usize>> {
    let mut words = vec![0; (area.size.width * area.size.height) as usize];
    let mut depths = vec![D::default(); area.size.width as usize];
    let mut band = Band::<Rgb888>::new(area, &mut words).unwrap();
    prepared.draw(&mut band, &mut depths).unwrap();
    band.colors().map(face_of).collect()
}

fn standard<S: ScreenPrecision, D: DepthWidth>(meshes: Vec<Mesh>, unit: i128, depth: Depth) {
    let scene = Scene::new(meshes);
    let camera = camera(128, 64);
    let area = camera.viewport().to_rectangle();
    let mut frame = Box::new(Frame::<Rgb888, 296, 588, 120, 64, S, D>::new());
    for number in 0..64 {
        let models = scene.models(standard_pose(number));
        let mut prepared = frame.prepare(&camera, &models).unwrap();
        let expected = owners(&snapped(&prepared), area, unit, depth);
        let drawn = picture(&mut prepared, area);
        let differing = expected.iter().zip(&drawn).filter(|(a, b)| a != b).count();
        assert!(drawn.iter().flatten().count() > 500, "frame {number} shows something");
        assert_eq!(differing, 0, "frame {number}");
    }
}

#[test]
fn sc1_is_exact() {
    standard::<Sub4, u16>(vec![meshes::torus(), meshes::cube(0.5)], 16, Depth::Bits16);
}

#[test]
fn sc2_is_exact() {
    standard::<Sub4, u16>(vec![meshes::icosphere(1.4)], 16, Depth::Bits16);
}

#[test]
fn sc3_is_exact() {
    standard::<Sub4, u16>(vec![meshes::cube(1.0)], 16, Depth::Bits16);
}

#[test]
fn sc1_sub8() {
    standard::<Sub8, u16>(vec![meshes::torus(), meshes::cube(0.5)], 256, Depth::Bits16);
    standard::<Sub4, u32>(vec![meshes::torus(), meshes::cube(0.5)], 16, Depth::Bits32);
    standard::<Sub8, u32>(vec![meshes::torus(), meshes::cube(0.5)], 256, Depth::Bits32);
}
