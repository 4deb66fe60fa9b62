//! Parallel rays: vertices, depths and cuts against `f64`, pictures against the exact faces, attributes that are even on the
//! screen.

use embedded_graphics::{pixelcolor::Rgb888, prelude::*, primitives::Rectangle};
use fixed::types::{I8F24, I16F16, U0F16};
use proptest::prelude::*;
use zrow::{
    geometry::{InputError, SubPixel},
    scene::{Camera, Deep, DepthWidth, FaceSet, Fine, Look, Memory, Model, Orthographic, Pose, Rotation, Whole},
    shade::Shading,
};

use crate::common::meshes::{self, Mesh};
use crate::common::{cases, config};
use crate::numbered_scene::{Scene, area, compare, picture};
use crate::shaded_scene::{Even, InSpace, Numbers, UNTOUCHED, words};
use crate::snapped_faces::{at, standard_pose};

type Coarse = Orthographic<Rgb888>;
type CoarseDeep = Deep<Orthographic<Rgb888>>;
type FineShallow = Orthographic<Fine<Rgb888>>;
type Finest = Orthographic<Fine<Deep<Rgb888>>>;

const NEAR: f64 = 128.0;
const FAR: f64 = 1_000.0;

/// A camera with a quarter of a pixel a unit.
fn camera(area: Rectangle) -> Camera {
    Camera::new(area, I16F16::from_num(NEAR))
        .and_then(|camera| camera.with_far(I16F16::from_num(FAR)))
        .and_then(|camera| camera.with_scale(I8F24::from_num(0.25)))
        .unwrap()
}

fn rotation([a, b, c]: [u16; 3]) -> Rotation {
    let [a, b, c] = [a, b, c].map(U0F16::from_bits);
    Rotation::about_x(a)
        .then(&Rotation::about_y(b))
        .then(&Rotation::about_z(c))
}

/// Depth units of a distance: the way from the far plane, shifted to 31 bits.
fn exact_depth<D: DepthWidth>(z: f64, camera: &Camera) -> f64 {
    let [near, far] = [camera.near(), camera.far()].map(|plane| plane.to_num::<f64>());
    let full = 2f64.powi((far - near).log2().ceil() as i32);
    let (least, span) = if D::FRACTION_BITS == 16 {
        (1.0, 65_536.0)
    } else {
        (16.0, 16_777_183.0)
    };
    least + (far - z) / full * span
}

proptest! {
    #![proptest_config(config(cases(4_000, 250_000)))]

    #[test]
    fn vertices_are_those_of_parallel_rays(
        vertex in prop::array::uniform3(any::<i16>()),
        shift in 0u32..8,
        angles in any::<[u16; 3]>(),
        distance in -200i32..32_000,
        scale in prop_oneof![1i32..1 << 26, Just(1), Just(i32::MAX), Just(1 << 22)],
        far in prop_oneof![129i32..32_767, Just(32_767), Just(129), Just(1_152)],
    ) {
        fn check<L: Look<Color = Rgb888, Shading = Rgb888>>(vertex: [i16; 3], pose: Pose, camera: &Camera) -> Result<(), TestCaseError> {
            let vertices = [vertex];
            let mesh = FaceSet::new(&vertices, &[[0, 0, 0]]).unwrap();
            let models = [Model::new(mesh, &[Rgb888::RED]).unwrap().with_pose(pose)];
            let mut memory = Memory::<L, 1, 1, 320, 240, 0>::new();
            let prepared = memory.prepare(camera, &models).unwrap();
            let m = pose.rotation.matrix().map(|row| row.map(|part| part.to_num::<f64>()));
            let [x, y, z]: [f64; 3] = core::array::from_fn(|row| {
                (0..3).map(|k| m[row][k] * f64::from(vertex[k])).sum::<f64>() + pose.translation[row].to_num::<f64>()
            });
            let size: f64 = vertex.iter().map(|&part| f64::from(part).abs()).sum();
            let eye_error = if L::Precision::FRACTION_BITS == 4 { size / 32_768.0 + 0.004 } else { size * 1e-9 + 0.0003 };
            let unit = f64::from(1 << L::Precision::FRACTION_BITS);
            let scale = camera.scale().to_num::<f64>() * unit;
            let exact = [159.5 * unit + x * scale, 119.5 * unit - y * scale];
            let error = 0.5001 + eye_error * scale;
            let (near, far): (f64, f64) = (camera.near().to_num(), camera.far().to_num());
            let Some(face) = prepared.faces().next() else {
                let is_beside = exact.iter().any(|&exact| {
                    exact > f64::from(L::Precision::MAX_UNITS) - error || exact < f64::from(L::Precision::MIN_UNITS) + error
                });
                prop_assert!(is_beside || z < near + eye_error || z > far - eye_error, "{:?} {}", exact, z);
                return Ok(());
            };
            prop_assert!(z >= near - eye_error && z <= far + eye_error);
            let corner = face.corners[0];
            for (found, exact) in [corner.point.x_units(), corner.point.y_units()].into_iter().zip(exact) {
                prop_assert!((f64::from(found) - exact).abs() <= error, "{} for {} +- {}", found, exact, error);
            }
            let exact = exact_depth::<L::Depth>(z, camera);
            let per_unit = exact_depth::<L::Depth>(z - 1.0, camera) - exact;
            let found = f64::from(corner.depth.units());
            prop_assert!((found - exact).abs() <= 1.01 + eye_error * per_unit, "{} for {}", found, exact);
            Ok(())
        }
        let vertex = vertex.map(|part| part >> shift);
        let pose = Pose::new(rotation(angles), at(3, -4, distance));
        let camera = Camera::new(area(320, 240), I16F16::from_num(NEAR))
            .and_then(|camera| camera.with_far(I16F16::from_num(far)))
            .and_then(|camera| camera.with_scale(I8F24::from_bits(scale)))
            .unwrap();
        check::<Coarse>(vertex, pose, &camera)?;
        check::<CoarseDeep>(vertex, pose, &camera)?;
        check::<FineShallow>(vertex, pose, &camera)?;
        check::<Finest>(vertex, pose, &camera)?;
    }
}

const WIDTH: u32 = 48;
const HEIGHT: u32 = 40;

/// Where in a face, by the weights of its corners, the parallel ray through a point of the screen meets it.
fn weights(corners: [[f64; 3]; 3], x: f64, y: f64) -> Option<[f64; 3]> {
    let (u, v) = ((x - 23.5) * 4.0, (19.5 - y) * 4.0);
    let side = |a: [f64; 3], b: [f64; 3]| (b[0] - a[0]) * (v - a[1]) - (b[1] - a[1]) * (u - a[0]);
    let [a, b, c] = corners;
    let sides = [side(b, c), side(c, a), side(a, b)];
    // Clockwise with y up: all on the right.
    sides.iter().all(|&side| side < 0.0).then(|| {
        let sum: f64 = sides.iter().sum();
        sides.map(|side| side / sum)
    })
}

/// The attribute where a ray meets a face between the planes, or nothing.
fn seen(corners: [[f64; 3]; 3], numbers: [f64; 3], x: f64, y: f64) -> Option<f64> {
    let weights = weights(corners, x, y)?;
    let z: f64 = (0..3).map(|at| weights[at] * corners[at][2]).sum();
    (NEAR - 1e-6..=FAR + 1e-6)
        .contains(&z)
        .then(|| (0..3).map(|at| weights[at] * numbers[at]).sum())
}

/// Draws a face and compares the pixels at whose centre and around it the rays agree: owners, and what varies over it.
fn check<L: Look<Color = Rgb888, Shading = InSpace<1>>, E: Look<Color = Rgb888, Shading = Even<1>>>(
    corners: [[i16; 3]; 3],
    numbers: [[i16; 1]; 3],
) -> usize {
    fn drawn<'a, L: Look<Color = Rgb888>>(mesh: FaceSet<'a>, skin: <L::Shading as Shading>::Skin<'a>) -> Vec<u32> {
        let area = area(WIDTH, HEIGHT);
        let models = [Model::<L::Shading>::with_skin(mesh, skin).unwrap()];
        let mut memory = Memory::<L, 40, 1, 128, 40, 8>::new();
        words(&mut memory.prepare(&camera(area), &models).unwrap(), area)
    }
    let mesh = FaceSet::new(&corners, &[[0, 1, 2]]).unwrap();
    let skin = Numbers {
        of_vertices: &numbers[..],
        shown: 0,
    };
    let (in_space, even) = (drawn::<L>(mesh, skin), drawn::<E>(mesh, skin));
    let face = corners.map(|corner| corner.map(f64::from));
    let values = numbers.map(|[number]| f64::from(number));
    let range = values.iter().fold(f64::MIN, |most, value| most.max(*value))
        - values.iter().fold(f64::MAX, |least, value| least.min(*value));
    let mut count = 0;
    for ((point, word), other) in area(WIDTH, HEIGHT).points().zip(in_space).zip(even) {
        // What varies evenly in space does so on the screen, but for the half that rounds the one.
        let is_drawn = word != UNTOUCHED || other != UNTOUCHED;
        if is_drawn {
            assert_eq!(word.wrapping_add(1 << 15), other, "{point:?} of {corners:?}");
        }
        let (x, y) = (f64::from(point.x), f64::from(point.y));
        let around = (0..48).map(|ray| {
            let (sine, cosine) = (f64::from(ray) * std::f64::consts::TAU / 24.0).sin_cos();
            let radius = if ray < 24 { 0.1 } else { 0.2 };
            seen(face, values, x + radius * cosine, y + radius * sine)
        });
        let rays: Vec<Option<f64>> = around.chain([seen(face, values, x, y)]).collect();
        let here = *rays.last().unwrap();
        if rays.iter().any(|ray| ray.is_some() != here.is_some()) {
            continue;
        }
        assert_eq!(is_drawn, here.is_some(), "{point:?} of {corners:?}");
        let Some(exact) = here else { continue };
        count += 1;
        // A corner is off by half a unit of the screen, where a thin face is steep; a cut by one more.
        let spread = rays
            .iter()
            .flatten()
            .fold(0f64, |most, ray| most.max((ray - exact).abs()));
        let found = f64::from(word as i32) / 65_536.0;
        let bound = 2.0 + spread + range / 4_096.0;
        assert!(
            (found - exact).abs() <= bound,
            "{found} for {exact} +- {bound} at {point:?} of {corners:?} {numbers:?}"
        );
    }
    count
}

fn check_all(corners: [[i16; 3]; 3], numbers: [[i16; 1]; 3]) -> usize {
    let reversed = |[a, b, c]: [[i16; 3]; 3]| [a, c, b];
    let mut count = 0;
    for (corners, numbers) in [
        (corners, numbers),
        (reversed(corners), [numbers[0], numbers[2], numbers[1]]),
    ] {
        count += check::<Orthographic<InSpace<1>>, Orthographic<Even<1>>>(corners, numbers);
        count += check::<Fine<Orthographic<Deep<InSpace<1>>>>, Orthographic<Fine<Deep<Even<1>>>>>(corners, numbers);
    }
    count
}

fn numbers() -> impl Strategy<Value = [[i16; 1]; 3]> {
    prop::array::uniform3(prop::array::uniform1(-12_000i16..12_000))
}

proptest! {
    #![proptest_config(config(cases(50, 1_500)))]

    /// Corners before, at, between and behind the planes.
    #[test]
    fn both_planes_cut_where_they_are(
        positions in prop::array::uniform3((-300i16..300, -250i16..250)),
        distances in prop::array::uniform3(prop_oneof![-300i16..2_000, Just(128), Just(1_000), 120i16..136, 990i16..1_010]),
        numbers in numbers(),
    ) {
        check_all([0, 1, 2].map(|i| [positions[i].0, positions[i].1, distances[i]]), numbers);
    }

    /// Faces that reach beyond the guard band of 12.4 positions, 4,096 units away.
    #[test]
    fn the_guard_band_keeps_edges_and_attributes(
        positions in prop::array::uniform3((any::<i16>(), any::<i16>())),
        distances in prop::array::uniform3(130i16..1_500),
        numbers in numbers(),
    ) {
        check_all([0, 1, 2].map(|i| [positions[i].0, positions[i].1, distances[i]]), numbers);
    }
}

#[test]
fn a_wall_through_both_planes_is_seen() {
    for numbers in [[[-12_000], [0], [12_000]], [[7], [7], [7]]] {
        assert!(check_all([[-90, -70, -500], [-90, 70, 2_000], [90, 0, 600]], numbers) > 400);
        assert!(
            check_all(
                [[-9_000, -7_000, 150], [-9_000, 9_000, 2_000], [30_000, 0, 600]],
                numbers
            ) > 2_000
        );
    }
}

/// Pictures of closed and penetrating meshes are those of the exact faces, and nearer is in front.
#[test]
fn pictures_are_those_of_the_exact_faces() {
    fn check<L: Look<Color = Rgb888, Shading = Rgb888>>() {
        let area = area(128, 64);
        let scene = Scene::new(vec![meshes::torus(), meshes::cube(0.5)]);
        for frame in 0..8 {
            let camera = Camera::new(area, I16F16::from_num(400))
                .and_then(|camera| camera.with_far(I16F16::from_num(2_600)))
                .and_then(|camera| camera.with_scale(I8F24::from_num(0.05)))
                .unwrap();
            // The first ones reach in front of the near plane.
            let pose = Pose::new(
                standard_pose(frame * 7).rotation,
                at(0, 0, 700 + 200 * i32::from(frame)),
            );
            let mut memory = Box::new(Memory::<L, 3_000, 600, 128, 64, 128>::new());
            compare(&mut memory.prepare(&camera, &scene.models(pose)).unwrap(), area);
        }
    }
    check::<Coarse>();
    check::<CoarseDeep>();
    check::<FineShallow>();
    check::<Finest>();
}

/// Things are as large, and lie as they do, wherever they are along the rays.
#[test]
fn distance_changes_no_picture() {
    let area = area(96, 64);
    let scene = Scene::new(vec![meshes::torus()]);
    let camera = Camera::new(area, I16F16::from_num(64))
        .unwrap()
        .with_scale(I8F24::from_num(0.04))
        .unwrap();
    let drawn = |distance: i32| {
        let models = scene.models(Pose::new(standard_pose(9).rotation, at(10, 20, distance)));
        let mut memory = Box::new(Memory::<Deep<Coarse>, 600, 600, 96, 64, 128>::new());
        picture(&mut memory.prepare(&camera, &models).unwrap(), area)
    };
    let first = drawn(1_000);
    assert!(first.iter().flatten().count() > 500);
    for distance in [1_024, 2_000, 9_999, 30_000] {
        assert!(drawn(distance) == first, "{distance}");
    }
}

/// Depths to draw at are those of faces at that distance, and those of the planes beyond them.
#[test]
fn depths_are_those_of_faces() {
    fn check<L: Look<Color = Rgb888, Shading = Rgb888>>() {
        let camera = camera(area(48, 40));
        let mut last = None;
        for z in (128..=1_000i16).step_by(8) {
            let vertices = [[-20, -20, z], [0, 20, z], [20, -20, z]];
            let models = [Model::new(FaceSet::new(&vertices, &[[0, 1, 2]]).unwrap(), &[Rgb888::RED]).unwrap()];
            let mut memory = Memory::<L, 3, 1, 48, 40, 1>::new();
            let corners = memory
                .prepare(&camera, &models)
                .unwrap()
                .faces()
                .next()
                .unwrap()
                .corners;
            let depth = Orthographic::<L>::depth_at(&camera, I16F16::from_num(z));
            assert!(corners.iter().all(|corner| corner.depth == depth), "{z}");
            assert!(
                depth > L::Depth::FARTHEST && last.is_none_or(|last| depth < last),
                "{z}"
            );
            last = Some(depth);
        }
        let at = |z: i32| Orthographic::<L>::depth_at(&camera, I16F16::from_num(z));
        assert_eq!([at(-5), at(128)], [at(127); 2]);
        assert_eq!([at(1_001), at(32_767)], [at(1_000); 2]);
    }
    check::<Coarse>();
    check::<CoarseDeep>();
    check::<FineShallow>();
    check::<Finest>();
}

/// Where no face is cut, a vertex that is not on the screen is an error, which says why.
#[test]
fn whole_faces_are_inside_or_errors() {
    let camera = camera(area(48, 40));
    let found = |vertex: [i16; 3]| {
        let vertices = [[0, 0, 500], vertex];
        let mesh = Mesh::new(vertices.to_vec(), vec![[0, 1, 0]]);
        let models = [Model::new(mesh.face_set(), &[Rgb888::RED]).unwrap()];
        let mut memory = Memory::<Whole<Coarse>, 2, 1, 48, 40, 1>::new();
        memory.prepare(&camera, &models).err()
    };
    let (near, far) = (
        InputError::BeforeNearPlane { model: 0 },
        InputError::BehindFarPlane { model: 0 },
    );
    let beside = InputError::BeyondGuardBand { model: 0 };
    // 1,023 pixels to the right and below the origin, 1,024 to the left and above: from the middle, times 4.
    for (vertex, error) in [
        ([0, 0, 128], None),
        ([0, 0, 127], Some(near)),
        ([0, 0, -30_000], Some(near)),
        ([0, 0, 1_000], None),
        ([0, 0, 1_001], Some(far)),
        ([3_997, 0, 500], None),
        ([4_000, 0, 500], Some(beside)),
        ([-4_189, 0, 500], None),
        ([-4_192, 0, 500], Some(beside)),
        ([0, 4_173, 500], None),
        ([0, 4_176, 500], Some(beside)),
        ([0, -4_013, 500], None),
        ([0, -4_016, 500], Some(beside)),
    ] {
        assert_eq!(found(vertex), error, "{vertex:?}");
    }
    assert_eq!(camera.with_scale(I8F24::ZERO).err(), Some(InputError::ScaleOutOfDomain));
    assert_eq!(
        camera.with_scale(I8F24::from_num(-1)).err(),
        Some(InputError::ScaleOutOfDomain)
    );
    assert!(camera.with_scale(I8F24::DELTA).is_ok() && camera.with_scale(I8F24::MAX).is_ok());
}

/// Of a face that is seen from behind, and whose edge the near plane cuts within a few units of its corner, the corners of the
/// cut are rounded so that a sliver of it would be seen from the front.
#[test]
fn slivers_of_cut_faces_do_not_turn_round() {
    check_all([[-15, -151, 1000], [22, -2, 123], [0, 0, 1003]], [[0]; 3]);
    check_all([[-15, -153, 1000], [22, -2, 125], [-2, 103, 1778]], [[0]; 3]);
}
