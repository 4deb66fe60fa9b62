//! Whole scenes by all methods of visibility: many models at once, the teapot, and faces that are seen from the side.

use fixed::types::U0F16;
use zrow::scene::{Pose, Rotation};
use zrow_scenes::teapot::TEAPOT;

use crate::common::meshes::{self, Mesh};
use crate::common::{by_depth, cases};
use crate::numbered_scene::Scene;
use crate::snapped_faces::{at, standard_pose};
use crate::visibility::check_models;

/// The pose of one of thirty models that stand in front of each other and go through each other.
fn place(model: i32) -> Pose {
    let turn = |steps: i32| U0F16::from_bits((steps * 1997 % 65_536) as u16);
    let rotation = Rotation::about_x(turn(model * 3)).then(&Rotation::about_y(turn(model * 5 + 1)));
    let [column, row, layer] = [model % 5 - 2, model / 5 % 3 - 1, model / 15];
    Pose::new(
        rotation,
        at(250 * column + 60 * layer, 240 * row + 50 * layer, 1050 + 350 * layer),
    )
}

#[test]
fn thirty_models_by_all_methods() {
    let mut solids: Vec<Mesh> = (0..28)
        .map(|model| meshes::cube(0.2 + f64::from(model % 6) / 20.0))
        .collect();
    solids.push(meshes::icosphere(0.4));
    solids.push(meshes::cube(0.5).two_sided());
    let scene = Scene::new(solids);
    let mut models = scene.models(standard_pose(0));
    assert_eq!(models.len(), 30);
    for (number, model) in (0..).zip(&mut models) {
        // A step that has no factor in common with 30, so that small and large ones are everywhere.
        model.pose = place(number * 7 % 30);
    }
    let apart = by_depth(3, 1, 1);
    let shown = check_models(&models[..30 / apart]);
    assert!(shown > 1200 / apart, "{shown}");
}

#[test]
fn the_teapot_by_all_methods() {
    let scene = Scene::new(vec![Mesh::new(TEAPOT.vertices().to_vec(), TEAPOT.faces().to_vec())]);
    for frame in [9, 0, 17, 26, 31].into_iter().take(cases(1, 5) as usize) {
        let mut pose = standard_pose(frame);
        pose.translation = at(0, 0, 600);
        let shown = check_models(&scene.models(pose));
        assert!(shown > 500, "frame {frame}: {shown}");
    }
}

/// Faces in planes through the eye or next to it: they cover no pixel or very few, and are cut by a wall and before it.
#[test]
fn faces_seen_from_the_side_by_all_methods() {
    let mut mesh = Mesh::new(
        vec![[-500, -400, 900], [-500, 400, 700], [500, 400, 900], [500, -400, 700]],
        vec![],
    );
    mesh.faces.extend([[0, 1, 2], [0, 2, 3]]);
    for fin in -20i16..20 {
        // x : y : z as fin : 16 : 32 on one edge, and up to a unit beside it on the other two.
        let first = mesh.vertices.len() as u16;
        let [near, far] = [(fin * 10, 160, 320), (fin * 40, 640, 1280)];
        let beside = fin % 2;
        mesh.vertices.extend([
            [near.0, near.1 - 320, near.2],
            [far.0 + beside, far.1 - 800, far.2],
            [far.0, far.1 - 1300, far.2 + beside],
        ]);
        mesh.faces.push([first, first + 1, first + 2]);
    }
    let models = Scene::new(vec![mesh.two_sided()]);
    for (turn, height) in [(0, 0), (0, 1), (37, 0), (16_384, 0), (16_391, 3)] {
        let rotation = Rotation::about_z(U0F16::from_bits(turn));
        assert!(
            check_models(&models.models(Pose::new(rotation, at(0, height, 0)))) > 250,
            "{turn} {height}"
        );
    }
}
