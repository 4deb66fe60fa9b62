//! Shaded, translucent and holed faces by a state of the depth test: as scenes draw them, and one over the other in their order.

use embedded_graphics::pixelcolor::Rgb888;
use proptest::prelude::*;
use zrow::{
    band::Band,
    scene::{Deep, Fine, Look, Memory, Model, Pose, Prepared},
    shade::{Shading, Translucent},
    visible::{Comparison, DepthState},
};

use crate::common::meshes::Mesh;
use crate::common::{cases, config};
use crate::holes::{EvenHoles, HEIGHT, Holed, Pattern, UNTOUCHED, WIDTH, any_coordinates, leak, single, skins};
use crate::numbered_scene::{area, color_of};
use crate::random_faces::{faces, pose};
use crate::snapped_faces::camera;

type MemoryOf<L, const ACTIVE: usize = 64> = Memory<L, 400, 64, WIDTH, HEIGHT, ACTIVE>;

fn words(draw: impl FnOnce(&mut Band<'_, Rgb888>)) -> Vec<u32> {
    let mut words = vec![UNTOUCHED; WIDTH * HEIGHT];
    draw(&mut Band::new(area(WIDTH as u32, HEIGHT as u32), &mut words).unwrap());
    words
}

/// A scene drawn by a state into the rows of one without models.
fn by_state<L: Look<Color = Rgb888>>(scene: &mut Prepared<'_, '_, L>, state: &DepthState<L::Depth>) -> Vec<u32> {
    let mut memory = Box::new(MemoryOf::<L, 1>::new());
    let mut empty = memory.prepare(&camera(area(WIDTH as u32, HEIGHT as u32)), &[]).unwrap();
    words(|band| empty.draw_with(band, |row| scene.draw_in(row, state)))
}

/// Draws a mesh by two states, whose skin is asked for with its first face; `is_opaque` says whether scenes draw the same.
fn check<L: Look<Color = Rgb888>>(
    mesh: &Mesh,
    skin: impl Fn(usize) -> <L::Shading as Shading>::Skin<'static>,
    pose: Pose,
    is_opaque: bool,
) {
    let camera = camera(area(WIDTH as u32, HEIGHT as u32));
    let model = |mesh: &Mesh, face| {
        let mesh = leak(mesh.clone());
        let model = Model::<L::Shading>::with_skin(mesh.face_set(), skin(face)).unwrap();
        [model.with_pose(pose)]
    };
    let models = model(mesh, 0);
    let (mut many, mut one) = (Box::new(MemoryOf::<L>::new()), Box::new(MemoryOf::<L, 1>::new()));
    let (mut many, mut one) = (
        many.prepare(&camera, &models).unwrap(),
        one.prepare(&camera, &models).unwrap(),
    );
    if is_opaque {
        let expected = words(|band| many.draw(band));
        assert!(by_state(&mut many, &DepthState::NEARER) == expected);
        assert!(by_state(&mut one, &DepthState::NEARER) == expected);
    }
    // Each face alone, over what is there.
    let expected = words(|band| {
        for (face, (_, alone)) in single(std::slice::from_ref(mesh)).into_iter().enumerate() {
            let models = model(&alone, face);
            let mut memory = Box::new(MemoryOf::<L>::new());
            memory.prepare(&camera, &models).unwrap().draw(band);
        }
    });
    for (comparison, writes) in [(Comparison::Always, true), (Comparison::Greater, false)] {
        let state = DepthState {
            comparison,
            writes,
            ..DepthState::NEARER
        };
        assert!(by_state(&mut many, &state) == expected, "{comparison:?}");
        assert!(by_state(&mut one, &state) == expected, "{comparison:?}, one slot");
    }
}

proptest! {
    #![proptest_config(config(cases(12, 100)))]

    #[test]
    fn shaded_faces_by_states(
        mesh in faces(1_200, 6),
        coordinates in any_coordinates(18),
        pattern in any::<Pattern>(),
        alpha in any::<u8>(),
        pose in pose(1300..2500),
    ) {
        let colors: &[Rgb888] = leak((0..12).map(|face| color_of(face * 5_003)).collect::<Vec<_>>());
        let patterns = [pattern; 2];
        let holed = skins(&patterns, &[coordinates.clone(), coordinates.clone()])[0];
        let numbers: &[_] = leak(coordinates.clone());
        check::<Rgb888>(&mesh, |face| &colors[face..], pose, true);
        check::<Translucent<Rgb888>>(&mesh, |face| (&colors[face..], alpha), pose, false);
        check::<Holed>(&mesh, |_| holed, pose, true);
        check::<Fine<Deep<EvenHoles>>>(&mesh, |_| (numbers, 0x50_0000), pose, true);
        check::<Translucent<EvenHoles>>(&mesh, |_| ((numbers, 0x50_0000), alpha), pose, false);
        check::<Fine<Deep<Translucent<Holed>>>>(&mesh, |_| (holed, alpha), pose, false);
    }
}
