//! Frames that cut no faces: the same pictures where none has to be cut, an error where one might have to be.

use fixed::types::I16F16;
use proptest::prelude::*;
use zrow::{
    geometry::{InputError, Sub4, Sub8, SubPixel, TooSmall},
    scene::{DepthWidth, Memory, Pose, Rotation},
};

use crate::common::meshes::{self, Mesh};
use crate::common::{cases, config};
use crate::numbered_scene::{Format, LookIn, Scene, WholeLookIn, area, picture};
use crate::snapped_faces::{at, camera, standard_pose};

const WIDTH: u32 = 48;
const HEIGHT: u32 = 40;
const NEAR: i32 = 128;

type Clipping<S, D> = Memory<LookIn<S, D>, 400, 600, 128, 64, 128>;
type Whole<S, D> = Memory<WholeLookIn<S, D>, 400, 600, 128, 64, 128>;

/// What a vertex is beyond that is off the screen.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
enum OutsideOf {
    NearPlane,
    GuardBand,
}

fn off_screen(model: usize, beyond: OutsideOf) -> InputError {
    match beyond {
        OutsideOf::NearPlane => InputError::BeforeNearPlane { model },
        OutsideOf::GuardBand => InputError::BeyondGuardBand { model },
    }
}

#[test]
fn the_standard_scenes_look_the_same() {
    fn check<S: Format<D>, D: DepthWidth>() {
        let scenes = meshes::standard_scenes();
        let (mut cutting, mut whole) = (Box::new(Clipping::<S, D>::new()), Box::new(Whole::<S, D>::new()));
        let area = area(128, 64);
        for scene in scenes.map(Scene::new) {
            for number in 0..64 {
                let models = scene.models(standard_pose(number));
                let mut expected = cutting.prepare(&camera(area), &models).unwrap();
                let mut drawn = whole.prepare(&camera(area), &models).unwrap();
                assert!(drawn.faces().eq(expected.faces()), "frame {number}");
                assert_eq!(
                    picture(&mut drawn, area),
                    picture(&mut expected, area),
                    "frame {number}"
                );
                assert_eq!(drawn.rows_without_depth(), expected.rows_without_depth());
            }
        }
    }
    check::<Sub4, u16>();
    check::<Sub8, u32>();
}

/// What a corner is beyond, in `f64`; `None` within 6 pixels of the end of the guard band.
fn expected<S: SubPixel, D: DepthWidth>([x, y, z]: [i16; 3]) -> Option<Result<(), OutsideOf>> {
    if i32::from(z) < NEAR {
        return Some(Err(OutsideOf::NearPlane));
    }
    let half = f64::from(WIDTH) / 2.0;
    let from_center = |coordinate: i16| half * f64::from(coordinate) / f64::from(z);
    // 12.4 and 16-bit depths take the nearest end on all sides: the right one.
    let (least, most) = if S::FRACTION_BITS == 4 && D::FRACTION_BITS == 16 {
        (-1023.0 + half, 1023.0 - half)
    } else {
        let [least, most] = [S::MIN_UNITS, S::MAX_UNITS].map(|end| f64::from(end >> S::FRACTION_BITS));
        (least - half, most - half)
    };
    let positions = [from_center(x), -from_center(y)];
    // The ends are as far away above and below, but for 4 pixels.
    if positions
        .iter()
        .any(|position| *position < least - 6.0 || *position > most + 6.0)
    {
        Some(Err(OutsideOf::GuardBand))
    } else if positions
        .iter()
        .all(|position| *position > least + 6.0 && *position < most - 6.0)
    {
        Some(Ok(()))
    } else {
        None
    }
}

/// Prepares a face alone: the error is that of its first corner that is beyond something, the picture is that of a
/// frame that cuts.
fn check<S: Format<D>, D: DepthWidth>(corners: [[i16; 3]; 3]) {
    let corner_by_corner = corners.map(expected::<S, D>);
    let first = corner_by_corner.into_iter().find(|corner| *corner != Some(Ok(())));
    let Some(expected) = first.unwrap_or(Some(Ok(()))) else {
        return;
    };
    let scene = Scene::new(vec![
        Mesh::new(corners.to_vec(), vec![[0, 1, 2], [0, 2, 1]]),
        // Never in the way.
        Mesh::new(vec![[0, 0, 200], [1, 1, 200], [2, 0, 200]], vec![[0, 1, 2]]),
    ]);
    let models: Vec<_> = scene.models(Pose::IDENTITY).into_iter().rev().collect();
    let area = area(WIDTH, HEIGHT);
    let (mut whole, mut cutting) = (Box::new(Whole::<S, D>::new()), Box::new(Clipping::<S, D>::new()));
    let camera = camera(area);
    match expected {
        Ok(()) => {
            let drawn = picture(&mut whole.prepare(&camera, &models).unwrap(), area);
            assert_eq!(drawn, picture(&mut cutting.prepare(&camera, &models).unwrap(), area));
        }
        Err(beyond) => {
            let error = whole.prepare(&camera, &models).err();
            assert_eq!(error, Some(off_screen(1, beyond)), "{corners:?}");
        }
    }
}

proptest! {
    #![proptest_config(config(cases(300, 300)))]

    #[test]
    fn a_vertex_in_front_of_the_near_plane_is_an_error(
        positions in prop::array::uniform3((-300i16..300, -250i16..250)),
        distances in prop::array::uniform3(100i16..400),
    ) {
        let corners = [0, 1, 2].map(|i| [positions[i].0, positions[i].1, distances[i]]);
        check::<Sub4, u16>(corners);
        check::<Sub8, u32>(corners);
    }

    #[test]
    fn a_vertex_beyond_the_guard_band_is_an_error(
        positions in prop::array::uniform3((any::<i16>(), any::<i16>())),
        distances in prop::array::uniform3(prop::sample::select(vec![130i16, 300, 700, 2000])),
    ) {
        let corners = [0, 1, 2].map(|i| [positions[i].0, positions[i].1, distances[i]]);
        check::<Sub4, u16>(corners);
        check::<Sub4, u32>(corners);
        check::<Sub8, u32>(corners);
    }
}

/// On the near plane, and 1/4096 unit, which is the finest there is, behind and in front of it.
#[test]
fn the_near_plane_itself_is_no_error() {
    fn check<S: Format<D>, D: DepthWidth>() {
        let scene = Scene::new(vec![Mesh::new(
            vec![[-50, -40, 0], [-50, 40, 300], [60, 0, 300]],
            vec![[0, 1, 2]],
        )]);
        let unit = I16F16::from_bits(1 << 4);
        for (behind, error) in [
            (I16F16::ZERO, None),
            (unit, None),
            (-unit, Some(off_screen(0, OutsideOf::NearPlane))),
        ] {
            let position = [I16F16::ZERO, I16F16::ZERO, I16F16::from_num(NEAR) + behind];
            let models = scene.models(Pose::new(Rotation::IDENTITY, position));
            let mut memory = Memory::<WholeLookIn<S, D>, 3, 1, 128, 40, 1>::new();
            assert_eq!(memory.prepare(&camera(area(WIDTH, HEIGHT)), &models).err(), error);
        }
    }
    check::<Sub4, u16>();
    check::<Sub4, u32>();
    check::<Sub8, u16>();
    check::<Sub8, u32>();
}

/// A vertex as far beside the viewport's centre as it may be, and 0.2 pixels farther.
#[test]
fn the_guard_band_ends_where_it_says() {
    // 24 pixels of focal length at a distance of 240: a tenth of a pixel for each unit. From the centre, which is 23.5, to
    // the nearest end, which is 1023, it is 999.5 pixels.
    for (position, error) in [(9_994, None), (9_996, Some(off_screen(0, OutsideOf::GuardBand)))] {
        for [x, y] in [[position, 0], [-position, 0], [0, position], [0, -position]] {
            let scene = Scene::new(vec![Mesh::new(
                vec![[x, y, 240], [-50, 40, 240], [60, 0, 240]],
                vec![[0, 1, 2]],
            )]);
            let mut memory = Memory::<WholeLookIn<Sub4>, 3, 1, 128, 40, 1>::new();
            let prepared = memory
                .prepare(&camera(area(WIDTH, HEIGHT)), &scene.models(Pose::IDENTITY))
                .err();
            assert_eq!(prepared, error, "{x} {y}");
        }
    }
}

/// After an error the storage holds another scene, or the same one elsewhere, as if nothing had been.
#[test]
fn an_error_leaves_the_storage_usable() {
    let scene = Scene::new(vec![meshes::torus(), meshes::cube(0.5)]);
    let area = area(128, 64);
    let camera = camera(area);
    let mut memory = Box::new(Whole::<Sub4, u16>::new());
    let near = Pose::new(Rotation::IDENTITY, at(0, 0, 300));
    let beside = Pose::new(Rotation::IDENTITY, at(12_000, 0, 800));
    for number in 0..8 {
        let models = scene.models(standard_pose(number));
        let before = picture(&mut memory.prepare(&camera, &models).unwrap(), area);
        assert!(before.iter().flatten().count() > 500);
        let wrong = scene.models(if number % 2 == 0 { near } else { beside });
        let beyond = if number % 2 == 0 {
            OutsideOf::NearPlane
        } else {
            OutsideOf::GuardBand
        };
        assert_eq!(memory.prepare(&camera, &wrong).err(), Some(off_screen(0, beyond)));
        assert_eq!(picture(&mut memory.prepare(&camera, &models).unwrap(), area), before);
    }
    // Of several things that are wrong, the tables come first: they say what would do.
    let mut small = Memory::<WholeLookIn<Sub4>, 295, 588, 128, 64, 128>::new();
    let full = InputError::TooSmall(TooSmall::Vertices(296));
    assert_eq!(small.prepare(&camera, &scene.models(near)).err(), Some(full));
}

#[test]
fn the_error_says_what_to_do() {
    assert_eq!(
        off_screen(2, OutsideOf::NearPlane).to_string(),
        "a vertex of model 2 is in front of the near plane: keep the model away from there, or let the frame cut faces \
         (Look::CLIPS)"
    );
    assert_eq!(
        off_screen(0, OutsideOf::GuardBand).to_string(),
        "a vertex of model 0 is too far beside the viewport: keep the model away from there, or let the frame cut faces \
         (Look::CLIPS)"
    );
}
