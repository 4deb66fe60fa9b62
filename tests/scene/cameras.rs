//! Cameras that look at another point than the middle of the viewport, and near planes for models.

use embedded_graphics::{pixelcolor::Rgb888, prelude::*, primitives::Rectangle};
use fixed::types::{I8F24, I16F16, U0F16};
use proptest::prelude::*;
use zrow::{
    band::Band,
    geometry::{InputError, SubPixel},
    scene::{Affine, Camera, Deep, FaceSet, Fine, Look, Memory, Model, Pose, Rotation, Whole},
    shade::Transformed,
};

use crate::common::meshes::{self, Mesh};
use crate::common::{cases, config};
use crate::numbered_scene::{Scene, area, color_of, picture};
use crate::snapped_faces::{at, camera, standard_pose};

type Finest = Fine<Deep<Rgb888>>;

fn pixels(centre: [f64; 2]) -> [I16F16; 2] {
    centre.map(I16F16::from_num)
}

/// A picture of four parts, drawn by a camera each, is the picture of one camera, bit for bit.
#[test]
fn parts_of_a_picture_are_those_of_the_whole() {
    fn check<L: Look<Color = Rgb888, Shading = Rgb888>>() {
        let scene = Scene::new(vec![meshes::torus(), meshes::cube(0.5)]);
        let whole = camera(area(128, 64));
        for frame in 0..12 {
            let pose = Pose::new(
                standard_pose(frame * 5).rotation,
                at(0, 0, [700, 1_536][usize::from(frame) % 2]),
            );
            let models = scene.models(pose);
            let mut memory = Box::new(Memory::<L, 3_000, 600, 128, 64, 128>::new());
            let expected = picture(&mut memory.prepare(&whole, &models).unwrap(), area(128, 64));
            for (corner, size) in [
                ((0, 0), (60, 25)),
                ((60, 0), (68, 25)),
                ((0, 25), (60, 39)),
                ((60, 25), (68, 39)),
            ] {
                let part = Rectangle::new(Point::new(corner.0, corner.1), Size::new(size.0, size.1));
                let camera = camera(part)
                    .with_focal_length(whole.focal_length())
                    .and_then(|camera| camera.with_centre([64 - corner.0, 32 - corner.1].map(I16F16::from_num)))
                    .unwrap();
                let drawn = picture(&mut memory.prepare(&camera, &models).unwrap(), part);
                for (point, drawn) in part.points().zip(drawn) {
                    assert_eq!(drawn, expected[(point.y * 128 + point.x) as usize], "{frame} {point:?}");
                }
            }
        }
    }
    check::<Rgb888>();
    check::<Finest>();
}

/// A mirror over a picture: scenes in two viewports of it, drawn row by row one after the other, are both as they are alone.
#[test]
fn viewports_over_each_other_are_as_they_are_alone() {
    let (whole, mirror) = (area(96, 64), Rectangle::new(Point::new(37, 9), Size::new(41, 23)));
    let (world, behind) = (Scene::new(vec![meshes::torus()]), Scene::new(vec![meshes::cube(0.5)]));
    let mut in_mirror = 0;
    for frame in 0..8 {
        let (world, behind) = (
            world.models(standard_pose(frame * 11)),
            behind.models(standard_pose(frame * 7 + 3)),
        );
        let mut memory = Box::new(Memory::<Rgb888, 3_000, 600, 96, 64, 128>::new());
        let mut small = Box::new(Memory::<Rgb888, 100, 40, 41, 23>::new());
        let mut world = memory.prepare(&camera(whole), &world).unwrap();
        let mut behind = small.prepare(&camera(mirror), &behind).unwrap();
        let (of_world, of_mirror) = (picture(&mut world, whole), picture(&mut behind, mirror));
        let mut words = vec![0; 96 * 64];
        for (y, row) in words.chunks_mut(96).enumerate() {
            let place = Rectangle::new(Point::new(0, y as i32), Size::new(96, 1));
            let mut band = Band::<Rgb888>::new(place, row).unwrap();
            world.draw(&mut band);
            behind.draw(&mut band);
        }
        for (point, word) in whole.points().zip(words) {
            let from_corner = point - mirror.top_left;
            let in_front = if mirror.contains(point) {
                of_mirror[(from_corner.y * 41 + from_corner.x) as usize]
            } else {
                None
            };
            in_mirror += u32::from(in_front.is_some());
            let face = in_front.or(of_world[(point.y * 96 + point.x) as usize]);
            let expected = face.map_or(0, |face| color_of(face).into_storage());
            assert_eq!(word, expected, "{frame} {point:?}");
        }
    }
    assert!(in_mirror > 400, "{in_mirror}");
}

proptest! {
    #![proptest_config(config(cases(2_000, 50_000)))]

    /// Any centre, with fractions of a pixel, against `f64`.
    #[test]
    fn points_are_seen_from_any_centre(
        corner in prop::array::uniform2(-300i32..300),
        centre in prop::array::uniform2(-500i32 << 16..700 << 16),
        vertex in (-700i16..700, -700i16..700, 500i16..3_000),
    ) {
        fn check<L: Look<Color = Rgb888, Shading = Rgb888>>(camera: &Camera, (x, y, z): (i16, i16, i16)) -> Result<(), TestCaseError> {
            let vertices = [[x, y, z]];
            let mesh = FaceSet::new(&vertices, &[[0, 0, 0]]).unwrap();
            let models = [Model::new(mesh, &[Rgb888::RED]).unwrap()];
            let mut memory = Memory::<L, 1, 1, 320, 240, 0>::new();
            let prepared = memory.prepare(camera, &models).unwrap();
            let [x, y, z] = [x, y, z].map(f64::from);
            let unit = f64::from(1 << L::Precision::FRACTION_BITS);
            let ([left, top], [u, v]) = ([camera.viewport().left, camera.viewport().top].map(f64::from), camera.centre().map(|c| c.to_num::<f64>()));
            let exact = [(left + u - 0.5 + 160.0 * x / z) * unit, (top + v - 0.5 - 160.0 * y / z) * unit];
            let reach = f64::from(L::Precision::MAX_UNITS).min(-f64::from(L::Precision::MIN_UNITS));
            let Some(face) = prepared.faces().next() else {
                // The guard band reaches as far as its nearest side.
                let centres = [(left + u) * unit, (top + v) * unit];
                let room = centres.iter().map(|centre| reach - centre.abs()).fold(f64::MAX, f64::min) - 2.0 * unit;
                let beyond = exact.iter().zip(centres).any(|(exact, centre)| (exact - centre).abs() > room);
                prop_assert!(beyond, "{:?}", exact);
                return Ok(());
            };
            let point = face.corners[0].point;
            // Two roundings to a unit, those of the centre and the position, and 2^-14 of the way from the centre.
            for (found, (exact, way)) in [point.x_units(), point.y_units()].into_iter().zip(exact.into_iter().zip([x / z, y / z])) {
                let bound = 1.02 + (way.abs() + 1.0) * 160.0 * unit * if unit > 16.0 { 1e-6 } else { 0.5f64.powi(13) };
                prop_assert!((f64::from(found) - exact).abs() <= bound, "{} for {}", found, exact);
            }
            Ok(())
        }
        let viewport = Rectangle::new(Point::new(corner[0], corner[1]), Size::new(320, 240));
        let camera = camera(viewport).with_centre(centre.map(I16F16::from_bits)).unwrap();
        check::<Rgb888>(&camera, vertex)?;
        check::<Finest>(&camera, vertex)?;
    }

    /// The near plane for models is in front of all vertices at each precision, and as near to the nearest one as promised.
    #[test]
    fn near_planes_cut_nothing_and_are_far_away(
        vertices in prop::collection::vec(prop::array::uniform3(any::<i16>()), 1..12),
        shift in 0u32..8,
        angles in any::<[u16; 3]>(),
        eye in any::<[u16; 3]>(),
        distance in 10i32..20_000,
    ) {
        let rotation = |[a, b, c]: [u16; 3]| {
            let [a, b, c] = [a, b, c].map(U0F16::from_bits);
            Rotation::about_x(a).then(&Rotation::about_y(b)).then(&Rotation::about_z(c))
        };
        let vertices: Vec<_> = vertices.into_iter().map(|vertex| vertex.map(|part| part >> shift)).collect();
        let faces: Vec<[u16; 3]> = (0..vertices.len() as u16).map(|number| [number; 3]).collect();
        let mesh = Mesh::new(vertices, faces);
        let colors = vec![Rgb888::RED; mesh.faces.len()];
        let turned = rotation(angles);
        let eye = Pose::new(rotation(eye), at(5, -7, 11));
        let ahead = eye.rotation.matrix().map(|row| row[2].to_num::<f64>() * f64::from(distance));
        let pose = Pose::new(turned, ahead.map(I16F16::from_num));
        let camera = Camera::new(area(32, 24), I16F16::from_num(8)).unwrap().with_pose(eye);
        let models = [Model::new(mesh.face_set(), &colors).unwrap().with_pose(pose)];
        let map = Affine::scaled([I8F24::ONE; 3]);
        let mapped = [Model::<Transformed<Rgb888>>::with_skin(mesh.face_set(), (&colors, map)).unwrap().with_pose(pose)];
        // Distances from the matrices as they are, less what is promised.
        let matrix = |rotation: &Rotation| rotation.matrix().map(|row| row.map(|part| part.to_num::<f64>()));
        let (m, e) = (matrix(&pose.rotation), matrix(&eye.rotation));
        let depth = |vertex: &[i16; 3]| {
            (0..3).map(|at| {
                let turned: f64 = (0..3).map(|k| m[at][k] * f64::from(vertex[k])).sum();
                e[at][2] * (turned + pose.translation[at].to_num::<f64>() - eye.translation[at].to_num::<f64>())
            }).sum::<f64>()
        };
        let size = |vertex: &[i16; 3]| vertex.iter().map(|&part| f64::from(part).abs()).sum::<f64>();
        let promised = mesh.vertices.iter().map(|vertex| depth(vertex) - size(vertex) / 32_768.0).fold(f64::MAX, f64::min) - 1.0 / 256.0;
        let slack = 0.002;
        let (found, other) = (camera.near_for(&models), camera.near_for(&mapped));
        prop_assert_eq!(found.is_ok(), other.is_ok());
        let Ok(found) = found else {
            prop_assert_eq!(found, Err(InputError::NearTooClose));
            prop_assert!(promised < 8.0 + slack);
            return Ok(());
        };
        let near: f64 = found.near().to_num();
        if promised > 32_767.9 {
            prop_assert!(near == 8.0 || promised < 32_768.1);
            return Ok(());
        }
        prop_assert!((near - promised).abs() <= slack, "{} for {}", near, promised);
        prop_assert!((other.unwrap().near().to_num::<f64>() - promised).abs() <= slack + 0.003 * f64::from(1 << (8 - shift)));
        // A vertex may be beside the guard band, but none in front of the near plane.
        fn cuts<L: Look>(camera: &Camera, models: &[Model<'_, L::Shading>]) -> bool {
            let mut memory = Memory::<L, 12, 12, 32, 24, 0>::new();
            matches!(memory.prepare(camera, models).err(), Some(InputError::BeforeNearPlane { .. }))
        }
        prop_assert!(!cuts::<Whole<Rgb888>>(&found, &models));
        prop_assert!(!cuts::<Whole<Finest>>(&found, &models));
        prop_assert!(!cuts::<Whole<Transformed<Rgb888>>>(&found, &mapped));
    }
}

#[test]
fn centres_are_pixels_of_the_domain() {
    let camera = camera(Rectangle::new(Point::new(100, -50), Size::new(32, 24)));
    let found = |x: f64, y: f64| camera.with_centre(pixels([x, y])).err();
    let outside = Some(InputError::OutOfDomain {
        min: -1_024,
        max: 1_023,
    });
    for (x, y) in [(-1_124.0, -974.0), (923.9, 1_073.9), (16.0, 12.0)] {
        assert_eq!(found(x, y), None, "{x} {y}");
        assert_eq!(camera.with_centre(pixels([x, y])).unwrap().centre(), pixels([x, y]));
    }
    for (x, y) in [
        (-1_124.1, 0.0),
        (0.0, -974.1),
        (924.0, 0.0),
        (0.0, 1_074.0),
        (32_767.0, 0.0),
        (0.0, -32_768.0),
    ] {
        assert_eq!(found(x, y), outside, "{x} {y}");
    }
    // Anywhere inside a viewport that positions of 12.4 have no room for.
    let wide = Camera::new(
        Rectangle::new(Point::new(-100, 0), Size::new(4_000, 40)),
        I16F16::from_num(8),
    )
    .unwrap();
    assert!(wide.with_centre(pixels([3_999.9, 39.0])).is_ok());
    assert_eq!(wide.with_centre(pixels([4_000.0, 39.0])).err(), outside);
    // Both precisions draw with any of them.
    let mesh = meshes::cube(0.5);
    let colors: Vec<_> = (0..12).map(color_of).collect();
    let models = [Model::new(mesh.face_set(), &colors)
        .unwrap()
        .with_pose(standard_pose(1))];
    for x in [923.9, -1_124.0] {
        let camera = camera.with_centre(pixels([x, 0.0])).unwrap();
        let mut coarse = Memory::<Rgb888, 80, 12, 32, 24, 8>::new();
        let mut fine = Memory::<Fine<Rgb888>, 80, 12, 32, 24, 8>::new();
        assert!(coarse.prepare(&camera, &models).is_ok(), "{x}");
        assert!(fine.prepare(&camera, &models).is_ok(), "{x}");
    }
}

#[test]
fn a_near_plane_for_nothing_stays() {
    let camera = camera(area(32, 24)).with_far(I16F16::from_num(500)).unwrap();
    assert_eq!(camera.near_for::<Rgb888>(&[]), Ok(camera));
    let mesh = FaceSet::new(&[[0, 0, 501]], &[]).unwrap();
    let behind = [Model::new(mesh, &[]).unwrap()];
    assert_eq!(camera.near_for::<Rgb888>(&behind), Ok(camera));
    let wide = Affine::scaled([I8F24::from_num(127); 3]);
    let mesh = FaceSet::new(&[[0, 0, 9_000]], &[]).unwrap();
    let large = [Model::<Transformed<Rgb888>>::with_skin(mesh, (&[][..], wide)).unwrap()];
    assert_eq!(camera.near_for(&large), Err(InputError::ModelOutOfDomain { model: 0 }));
}

/// Sheets a few units apart, 2,000 units away: the share of pixels in which a farther one is drawn, by the distance of the near
/// plane.
#[test]
fn near_planes_for_models_put_sheets_in_order() {
    const SHEETS: usize = 24;
    // Each is turned a little, so that they penetrate: corners (x, y) at distances that change by a few units.
    let tilt = |sheet: usize, factor: usize| ((sheet * factor) % 13) as f64 - 6.0;
    let distance = |sheet: usize, x: f64, y: f64| {
        2_000.0 + tilt(sheet, 5) * x / 1_500.0 + tilt(sheet, 7) * y / 1_500.0 + (sheet % 4) as f64 * 0.5
    };
    let corner = |sheet: usize, x: i16, y: i16| {
        // Half a unit is the finest step of a vertex here: the models are placed twice as near.
        [x, y, (distance(sheet, x.into(), y.into()) - 2_000.0).round() as i16]
    };
    let mesh = |sheet: usize| {
        let corners =
            [(-1_500, -1_500), (-1_500, 1_500), (1_500, 1_500), (1_500, -1_500)].map(|(x, y)| corner(sheet, x, y));
        // A triangle is a plane: half a sheet.
        Mesh::new(corners.to_vec(), vec![[0, 1, 2]])
    };
    let scene = Scene::new((0..SHEETS).map(mesh).collect());
    let models = scene.models(Pose::new(Rotation::IDENTITY, at(0, 0, 2_000)));
    let area = area(96, 96);
    let plane = |sheet: usize| {
        let [a, b, c] = [0, 1, 2].map(|at| mesh(sheet).vertices[at].map(f64::from));
        (a, b, c)
    };
    // Where the ray through a pixel meets a sheet.
    let depth_of = |sheet: usize, point: Point| {
        let (a, b, c) = plane(sheet);
        let [u, v] = [0, 1].map(|at| [b[at] - a[at], c[at] - a[at]]);
        let [w0, w1] = [b[2] - a[2], c[2] - a[2]];
        let determinant = u[0] * v[1] - u[1] * v[0];
        let (slope_x, slope_y) = (
            (w0 * v[1] - w1 * v[0]) / determinant,
            (u[0] * w1 - u[1] * w0) / determinant,
        );
        let ray = [(f64::from(point.x) - 47.5) / 48.0, (47.5 - f64::from(point.y)) / 48.0];
        let at_origin = 2_000.0 + a[2] - slope_x * a[0] - slope_y * a[1];
        at_origin / (1.0 - slope_x * ray[0] - slope_y * ray[1])
    };
    let misordered = |camera: &Camera| {
        let mut memory = Box::new(Memory::<Rgb888, 100, 24, 96, 96, 64>::new());
        let drawn = picture(&mut memory.prepare(camera, &models).unwrap(), area);
        let (mut wrong, mut covered) = (0u32, 0u32);
        for (point, sheet) in area.points().zip(drawn) {
            let Some(sheet) = sheet else { continue };
            let nearest = (0..SHEETS).map(|sheet| depth_of(sheet, point)).fold(f64::MAX, f64::min);
            covered += 1;
            wrong += u32::from(depth_of(sheet, point) > nearest + 1e-9);
        }
        assert!(covered > 2_000, "{covered}");
        f64::from(wrong) / f64::from(covered)
    };
    let with_near = |near: i32| Camera::new(area, I16F16::from_num(near)).unwrap();
    let shares = [8, 64, 128].map(|near| misordered(&with_near(near)));
    let found = with_near(8).near_for(&models).unwrap();
    assert!(
        (1_980..2_000).contains(&found.near().to_num::<i32>()),
        "{}",
        found.near()
    );
    let best = misordered(&found);
    println!(
        "misordered with near 8, 64, 128 and {}: {shares:?} {best}",
        found.near()
    );
    assert!(shares[0] > shares[1] && shares[1] > shares[2], "{shares:?}");
    assert!(best * 8.0 < shares[2] && best < 0.01, "{best} {shares:?}");
}
