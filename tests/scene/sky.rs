//! What is behind a scene and in front of it: a sky that turns with the camera, as in the documentation of `Prepared`, against
//! projected vertices; scenes over each other against the pictures of each alone.

use embedded_graphics::{pixelcolor::Rgb888, prelude::*, primitives::Rectangle};
use fixed::types::{I16F16, U0F16};
use proptest::prelude::*;
use zrow::{
    band::{Band, Target},
    draw::{DrawOn, PrimitiveStyle},
    scene::{Camera, Deep, FaceSet, Fine, Look, Memory, Model, Pose, Prepared, Rotation},
    shade::Paint,
};

use crate::common::meshes;
use crate::common::{cases, config};
use crate::numbered_scene::{Scene, area, picture};
use crate::snapped_faces::{at, camera, standard_pose};

const SKY: Rgb888 = Rgb888::new(0, 0, 255);
const GROUND: Rgb888 = Rgb888::new(0, 255, 0);

/// Sky where the ray of a pixel rises, and ground where it falls.
struct Horizon(Camera);

impl Paint for Horizon {
    type Color = Rgb888;

    fn colors_from(&self, start: Point) -> impl Iterator<Item = Rgb888> {
        let camera = &self.0;
        let (viewport, [x, y]) = (camera.viewport(), camera.centre());
        let right = 2 * (start.x - viewport.left) + 1 - (x.to_bits() >> 15);
        let up = (y.to_bits() >> 15) - 2 * (start.y - viewport.top) - 1;
        let ahead = camera.focal_length().to_bits() >> 15;
        let [_, [rise_right, rise_up, rise_ahead], _] = camera
            .pose()
            .rotation
            .matrix()
            .map(|row| row.map(|part| part.to_bits() >> 16));
        let mut rise = right * rise_right + up * rise_up + ahead * rise_ahead;
        core::iter::repeat_with(move || {
            let color = if rise > 0 { SKY } else { GROUND };
            rise += 2 * rise_right;
            color
        })
    }
}

/// Fills a target in a paint.
fn fill<T: Target<Color = Rgb888, Error = core::convert::Infallible>>(target: &mut T, area: Rectangle, camera: Camera) {
    let Ok(()) = area
        .into_styled(PrimitiveStyle::with_fill(Rgb888::BLACK))
        .draw_on(&mut target.painted(&Horizon(camera)));
}

proptest! {
    #![proptest_config(config(cases(2_000, 50_000)))]

    /// A vertex as high as the camera is on the horizon, wherever the camera looks; one that is higher is in the sky.
    #[test]
    fn the_horizon_is_where_level_directions_are_projected_to(
        angles in any::<[u16; 3]>(),
        corner in prop::array::uniform2(-300i32..300),
        // Whole and half pixels.
        centre in prop::array::uniform2(-100i32..250),
        focal_length in 30i32..300,
        direction in any::<u16>(),
        height in 400i32..8_000,
        position in prop::array::uniform3(-2_000i32..2_000),
    ) {
        let [roll, pitch, yaw] = angles.map(U0F16::from_bits);
        let rotation = Rotation::about_z(roll).then(&Rotation::about_x(pitch)).then(&Rotation::about_y(yaw));
        let [x, y, z] = position;
        let viewport = Rectangle::new(Point::new(corner[0], corner[1]), Size::new(64, 48));
        let camera = Camera::new(viewport, I16F16::from_num(8))
            .and_then(|camera| camera.with_focal_length(I16F16::from_num(focal_length)))
            .and_then(|camera| camera.with_centre(centre.map(|half| I16F16::from_bits(half << 15))))
            .unwrap()
            .with_pose(Pose::new(rotation, at(x, y, z)));
        let direction = f64::from(direction) / 65_536.0 * core::f64::consts::TAU;
        let [x, z] = [direction.cos(), direction.sin()].map(|part| (part * 16_000.0).round() as i16);
        let vertices = [0, height as i16, -height as i16].map(|y| [x, y, z]);
        // Faces of a point each: what is cut of them has no corners.
        let mesh = FaceSet::new(&vertices, &[[0; 3], [1; 3], [2; 3]]).unwrap();
        // The model moves with the camera.
        let model = Model::new(mesh, &[Rgb888::RED; 3]).unwrap();
        let models = [model.with_pose(Pose::new(Rotation::IDENTITY, camera.pose().translation))];
        let mut memory = Memory::<Fine<Deep<Rgb888>>, 3, 3, 64, 48, 0>::new();
        let prepared = memory.prepare(&camera, &models).unwrap();
        let mut words = vec![0; 64 * 48];
        let mut band = Band::<Rgb888>::new(viewport, &mut words).unwrap();
        fill(&mut band, viewport, camera);
        let colors: Vec<_> = band.colors().collect();
        let color_at = |x: i32, y: i32| {
            let (column, row) = (x - corner[0], y - corner[1]);
            ((0..64).contains(&column) && (0..48).contains(&row)).then(|| colors[(64 * row + column) as usize])
        };
        for face in prepared.faces() {
            let point = face.corners[0].point;
            let (x, y) = ((point.x_units() + 128) >> 8, (point.y_units() + 128) >> 8);
            if face.order > 0 {
                // At least 1.4 degrees away from the horizon: more than half a pixel.
                let expected = [SKY, GROUND][face.order - 1];
                prop_assert!(color_at(x, y).is_none_or(|color| color == expected), "{:?}", point);
                continue;
            }
            let around = (-1..=1).flat_map(|row| (-1..=1).map(move |column| (x + column, y + row)));
            if let Some(around) = around.map(|(x, y)| color_at(x, y)).collect::<Option<Vec<_>>>() {
                prop_assert!(around.contains(&SKY) && around.contains(&GROUND), "{:?}", point);
            }
        }
    }
}

/// A sky before the scene, or behind it where it has no face: the same picture, that of the faces and elsewhere that of the
/// sky, in one band and row by row.
#[test]
fn a_sky_is_where_no_face_is() {
    fn check<L: Look<Color = Rgb888, Shading = Rgb888>>(least: L::Depth) {
        let area = area(96, 64);
        let scene = Scene::new(vec![meshes::torus(), meshes::cube(0.5)]);
        for frame in 0..8 {
            let models = scene.models(standard_pose(frame * 11));
            let turn = Rotation::about_x(U0F16::from_num(0.99)).then(&Rotation::about_z(U0F16::from_num(0.07)));
            let camera = camera(area).with_pose(Pose::new(turn, at(0, 0, 0)));
            let mut memory = Box::new(Memory::<L, 3_000, 600, 96, 64, 128>::new());
            let mut prepared = memory.prepare(&camera, &models).unwrap();
            let faces = picture(&mut prepared, area);
            let mut words = vec![0; 96 * 64];
            fill(&mut Band::<Rgb888>::new(area, &mut words).unwrap(), area, camera);
            let sky = words.clone();
            prepared.draw(&mut Band::<Rgb888>::new(area, &mut words).unwrap());
            let mut scene_alone = vec![0; 96 * 64];
            prepared.draw(&mut Band::<Rgb888>::new(area, &mut scene_alone).unwrap());
            let counts = faces.iter().filter(|face| face.is_some()).count();
            assert!((200..5_000).contains(&counts), "{counts}");
            for (index, face) in faces.iter().enumerate() {
                let expected = if face.is_some() { &scene_alone } else { &sky };
                assert_eq!(words[index], expected[index], "{frame} {index}");
            }
            let mut rows = vec![0; 96 * 64];
            for (y, row) in rows.chunks_mut(96).enumerate() {
                let place = Rectangle::new(Point::new(0, y as i32), Size::new(96, 1));
                let mut band = Band::<Rgb888>::new(place, row).unwrap();
                fill(&mut band, area, camera);
                prepared.draw(&mut band);
            }
            assert!(rows == words, "{frame}");
            let mut behind = vec![0; 96 * 64];
            let mut band = Band::<Rgb888>::new(area, &mut behind).unwrap();
            prepared.draw_with(&mut band, |row| fill(&mut row.at_depth(least), area, camera));
            assert!(behind == words, "{frame}");
        }
    }
    check::<Rgb888>(1);
    check::<Fine<Deep<Rgb888>>>(1);
}

/// A scene that is drawn after another one is in front of it, also where it is farther away.
#[test]
fn a_scene_drawn_last_is_in_front() {
    let area = area(96, 64);
    let (world, held) = (Scene::new(vec![meshes::torus()]), Scene::new(vec![meshes::cube(0.5)]));
    let mut hidden = 0;
    for frame in 0..8 {
        let far = Pose::new(standard_pose(frame * 7).rotation, at(0, 0, 2_600));
        let (models, held) = (world.models(standard_pose(frame * 11)), held.models(far));
        let mut memory = Box::new(Memory::<Rgb888, 3_000, 600, 96, 64, 128>::new());
        let mut in_front = Box::new(Memory::<Rgb888, 8, 12, 96, 64>::new());
        let mut world = memory.prepare(&camera(area), &models).unwrap();
        let mut held = in_front.prepare(&camera(area), &held).unwrap();
        let draw = |scenes: &mut [&mut Prepared<'_, '_, Rgb888>]| {
            let mut words = vec![0; 96 * 64];
            for (y, row) in words.chunks_mut(96).enumerate() {
                let place = Rectangle::new(Point::new(0, y as i32), Size::new(96, 1));
                let mut band = Band::<Rgb888>::new(place, row).unwrap();
                scenes.iter_mut().for_each(|scene| scene.draw(&mut band));
            }
            words
        };
        let (behind, before) = (draw(&mut [&mut world]), draw(&mut [&mut held]));
        let both = draw(&mut [&mut world, &mut held]);
        for (both, (behind, before)) in both.into_iter().zip(behind.into_iter().zip(before)) {
            assert_eq!(both, if before == 0 { behind } else { before });
            hidden += u32::from(behind != 0 && before != 0);
        }
    }
    assert!(hidden > 100, "{hidden}");
}
