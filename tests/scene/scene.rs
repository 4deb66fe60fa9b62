//! Scenes in bands, in any order of rows and faces, with text, and in tables that are too small.

use embedded_graphics::{
    mono_font::{MonoTextStyle, ascii::FONT_6X10},
    pixelcolor::{Rgb565, Rgb888},
    prelude::*,
    primitives::Rectangle,
    text::Text,
};
use fixed::types::{I16F16, U0F16};
use zrow::{
    band::{Band, BigEndian, PictureLoop},
    draw::DrawOn,
    geometry::{InputError, Sub4, Sub8, TooSmall},
    scene::{Camera, DepthWidth, FaceSet, Fine, Memory, Model, OnePass, Pose, Rotation},
};

use crate::common::meshes::{self, Mesh};
use crate::numbered_scene::{Format, LookIn, Scene, area, color_of, picture};
use crate::reference::nearest_faces;
use crate::snapped_faces::{at, camera, snapped, standard_pose};

fn sc1() -> Scene {
    Scene::new(vec![meshes::torus(), meshes::cube(0.5)])
}

type Sc1Memory = Memory<Rgb888, 296, 588, 128, 64, 128>;

/// Faces around the camera: some are cut by the near plane, some by the guard band.
fn around() -> Scene {
    let mut mesh = meshes::icosphere(1.4);
    for vertex in &mut mesh.vertices {
        *vertex = vertex.map(|coordinate| coordinate / 2);
    }
    Scene::new(vec![mesh.two_sided()])
}

#[test]
fn every_height_of_band_draws_the_same() {
    let scene = sc1();
    let area = area(128, 64);
    let mut memory = Box::new(Sc1Memory::new());
    for number in [0, 5, 23, 40] {
        let models = scene.models(standard_pose(number));
        let mut prepared = memory.prepare(&camera(area), &models).unwrap();
        let whole = picture(&mut prepared, area);
        for rows in [1, 2, 7, 16, 64] {
            let mut drawn = Vec::new();
            let mut words = vec![0; 128 * 64];
            let mut sink = |band: Band<'_, Rgb888>| -> Result<(), ()> {
                drawn.extend(band.colors());
                Ok(())
            };
            PictureLoop::new(area, Rgb888::BLACK)
                .rows(rows)
                .draw(&mut words, &mut sink, |band: &mut Band<Rgb888>| {
                    prepared.draw(band);
                })
                .unwrap();
            let whole: Vec<_> = whole.iter().map(|face| face.map_or(Rgb888::BLACK, color_of)).collect();
            assert_eq!(drawn, whole, "{rows} rows");
        }
    }
}

#[test]
fn rows_in_any_order_and_parts_of_rows_draw_the_same() {
    let whole_area = area(128, 64);
    for (scene, pose) in [
        (sc1(), standard_pose(9)),
        (
            around(),
            Pose::new(Rotation::about_x(U0F16::from_bits(5000)), at(20, 30, 100)),
        ),
    ] {
        let models = scene.models(pose);
        let mut memory = Box::new(Memory::<Rgb888, 4000, 700, 128, 64, 700>::new());
        let mut prepared = memory.prepare(&camera(whole_area), &models).unwrap();
        let whole = picture(&mut prepared, whole_area);
        assert!(whole.iter().flatten().count() > 500);
        let seen = |point: Point| whole[(point.y * 128 + point.x) as usize];
        let rows = (0..64).map(|row| row * 37 % 64).chain((0..64).rev());
        for row in rows {
            for (left, width) in [(0, 128), (13, 50), (127, 1)] {
                let part = Rectangle::new(Point::new(left, row), Size::new(width, 1));
                let expected: Vec<_> = part.points().map(seen).collect();
                assert_eq!(picture(&mut prepared, part), expected, "{part:?}");
            }
        }
        // One row after the other, but each of them from another column on.
        for row in 0..64 {
            let part = Rectangle::new(Point::new(row * 11 % 50, row), Size::new(78, 1));
            let expected: Vec<_> = part.points().map(seen).collect();
            assert_eq!(picture(&mut prepared, part), expected, "{part:?}");
        }
        // A band that reaches beyond the viewport on all sides.
        let larger = Rectangle::new(Point::new(-5, -3), Size::new(140, 70));
        for (point, drawn) in larger.points().zip(picture(&mut prepared, larger)) {
            let expected = whole_area.contains(point).then(|| seen(point)).flatten();
            assert_eq!(drawn, expected, "{point:?}");
        }
    }
}

#[test]
fn a_viewport_anywhere_shows_the_same_picture() {
    let scene = sc1();
    let models = scene.models(standard_pose(30));
    let mut memory = Box::new(Sc1Memory::new());
    let here = picture(
        &mut memory.prepare(&camera(area(128, 64)), &models).unwrap(),
        area(128, 64),
    );
    let there = Rectangle::new(Point::new(-70, 300), Size::new(128, 64));
    assert_eq!(
        picture(&mut memory.prepare(&camera(there), &models).unwrap(), there),
        here
    );
}

#[test]
fn both_byte_orders_show_the_same_colours() {
    let mesh = meshes::cube(1.0);
    let colors = [Rgb565::new(3, 40, 21); 12];
    let models = [Model::new(mesh.face_set(), &colors)
        .unwrap()
        .with_pose(standard_pose(3))];
    let mut memory = Memory::<Rgb565, 8, 12, 128, 64, 12>::new();
    let mut prepared = memory.prepare(&camera(area(128, 64)), &models).unwrap();
    let (mut native, mut big_endian) = (vec![0; 128 * 64], vec![0; 128 * 64]);
    prepared.draw(&mut Band::<Rgb565>::new(area(128, 64), &mut native).unwrap());
    prepared.draw(&mut Band::<Rgb565, BigEndian>::new(area(128, 64), &mut big_endian).unwrap());
    assert!(native.iter().any(|&word| word != 0));
    assert!(
        native
            .iter()
            .zip(&big_endian)
            .all(|(&native, &big_endian)| native == u16::from_be(big_endian))
    );
}

/// Where the faces of a mesh come in another order, pixels differ only where two faces have exactly the same stored depth.
#[test]
fn the_order_of_faces_matters_only_on_ties() {
    let torus = meshes::torus();
    let shuffled: Vec<_> = (0..torus.faces.len())
        .map(|face| face * 251 % torus.faces.len())
        .collect();
    let faces = shuffled.iter().map(|&face| torus.faces[face]).collect();
    let other = Mesh::new(torus.vertices.clone(), faces);
    let (scene, other) = (
        Scene::new(vec![torus, meshes::cube(0.5)]),
        Scene::new(vec![other, meshes::cube(0.5)]),
    );
    let area = area(128, 64);
    let (mut ties, mut pixels) = (0, 0);
    let mut memory = Box::new(Sc1Memory::new());
    for number in 0..16 {
        let models = scene.models(standard_pose(number));
        let mut prepared = memory.prepare(&camera(area), &models).unwrap();
        let first = picture(&mut prepared, area);
        let faces = snapped(&prepared);
        let models = other.models(standard_pose(number));
        let second = picture(&mut memory.prepare(&camera(area), &models).unwrap(), area);
        for ((point, first), second) in area.points().zip(first).zip(second) {
            let second = second.map(|face| shuffled.get(face).copied().unwrap_or(face));
            pixels += usize::from(first.is_some());
            if first != second {
                ties += 1;
                let stored = |face: Option<usize>| {
                    let (x, y) = (i128::from(point.x) * 16, i128::from(point.y) * 16);
                    faces[face.unwrap()].stored(x, y, nearest_faces::Depth::Bits16)
                };
                assert_eq!(stored(first), stored(second), "{point:?}");
            }
        }
    }
    assert!(ties * 100 < pixels, "{ties} ties in {pixels} pixels");
}

#[test]
fn text_before_behind_in_front_and_after() {
    let vertices = vec![[-400, -300, 0], [-400, 300, 0], [400, 300, 0], [400, -300, 0]];
    let mesh = Mesh::new(vertices, vec![[0, 1, 2], [0, 2, 3]]);
    let models = [Model::new(mesh.face_set(), &[Rgb565::BLUE; 2])
        .unwrap()
        .with_pose(Pose::new(Rotation::IDENTITY, at(0, 0, 500)))];
    let area = area(96, 64);
    let camera = camera(area);
    let mut memory = Memory::<Rgb565, 4, 2, 128, 64, 2>::new();
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    let depth = |distance: i32| camera.depth_at::<Sub4, u16>(I16F16::from_num(distance));
    let text = |color, y| {
        Text::new(
            "MMMMMMMMMMMMMMMM",
            Point::new(0, y),
            MonoTextStyle::new(&FONT_6X10, color),
        )
    };

    let mut drawn = Vec::new();
    let mut sink = |band: Band<'_, Rgb565>| -> Result<(), ()> {
        drawn.extend(band.colors());
        Ok(())
    };
    PictureLoop::new(area, Rgb565::BLACK)
        .draw(&mut [0; 96], &mut sink, |band: &mut Band<Rgb565>| {
            band.draw(&text(Rgb565::RED, 22));
            prepared.draw_with(band, |row| {
                text(Rgb565::YELLOW, 32).draw_on(&mut row.at_depth(depth(501))).unwrap();
                text(Rgb565::GREEN, 42).draw(&mut row.at_depth(depth(499))).unwrap();
            });
            band.draw(&text(Rgb565::WHITE, 52));
        })
        .unwrap();

    // The face covers 38.4 pixels to both sides of the middle, and 28.8 up and down.
    let face = Rectangle::new(Point::new(9, 3), Size::new(77, 58));
    let edge = |point: Point| !face.contains(point) || face.offset(-1).contains(point);
    let count = |color, inside: bool| {
        let pixels = area.points().zip(&drawn).filter(|&(point, _)| edge(point));
        pixels
            .filter(|&(point, &pixel)| pixel == color && face.contains(point) == inside)
            .count()
    };
    for (color, in_front) in [
        (Rgb565::RED, false),
        (Rgb565::YELLOW, false),
        (Rgb565::GREEN, true),
        (Rgb565::WHITE, true),
    ] {
        assert!(count(color, false) > 30, "{color:?} beside the face");
        assert_eq!(count(color, true) > 30, in_front, "{color:?} on the face");
        assert!(in_front || count(color, true) == 0, "{color:?} on the face");
    }
}

#[test]
fn a_full_table_says_exactly_what_is_needed() {
    let scene = sc1();
    let models = scene.models(standard_pose(0));
    let camera = camera(area(128, 64));
    let error = Memory::<Rgb888, 295, 588, 128, 64, 128>::new()
        .prepare(&camera, &models)
        .err();
    assert_eq!(error, Some(InputError::TooSmall(TooSmall::Vertices(296))));
    let error = Memory::<Rgb888, 296, 587, 128, 64, 128>::new()
        .prepare(&camera, &models)
        .err();
    assert_eq!(error, Some(InputError::TooSmall(TooSmall::Faces(588))));
    let error = Memory::<Rgb888, 296, 588, 128, 63, 128>::new()
        .prepare(&camera, &models)
        .err();
    assert_eq!(error, Some(InputError::TooSmall(TooSmall::Rows(64))));
}

/// Active faces: counted here from the snapped corners, row by row.
#[test]
fn active_faces_are_counted_exactly() {
    let scene = sc1();
    let mut memory = Box::new(Memory::<OnePass<Rgb888>, 296, 588, 128, 64, 10>::new());
    let mut large = Box::new(Sc1Memory::new());
    let mut most = 0;
    for number in 0..64 {
        let models = scene.models(standard_pose(number));
        let camera = camera(area(128, 64));
        let prepared = large.prepare(&camera, &models).unwrap();
        let mut active = [0; 64];
        for face in snapped(&prepared) {
            let pixels = |axis: usize, size: i128| {
                let coordinates = face.corners.map(|corner| -(-corner[axis]).div_euclid(16));
                let [first, last] = [coordinates.iter().min().unwrap(), coordinates.iter().max().unwrap()];
                (*first).max(0)..(*last).min(size)
            };
            let [a, b, c] = face.corners;
            let front = (b[0] - a[0]) * (c[1] - a[1]) > (c[0] - a[0]) * (b[1] - a[1]);
            if front && !pixels(0, 128).is_empty() {
                for row in pixels(1, 64) {
                    active[row as usize] += 1;
                }
            }
        }
        let needed = *active.iter().max().unwrap();
        assert_eq!(prepared.active_needed(), needed);
        assert_eq!(
            memory.prepare(&camera, &models).err(),
            Some(InputError::TooSmall(TooSmall::ActiveFaces(needed)))
        );
        most = most.max(needed);
    }
    assert_eq!(most, 56);
    let mut exact = Box::new(Memory::<OnePass<Rgb888>, 296, 588, 128, 64, 56>::new());
    for number in 0..64 {
        assert!(
            exact
                .prepare(&camera(area(128, 64)), &scene.models(standard_pose(number)))
                .is_ok()
        );
    }
}

/// The picture with the depth row in use everywhere.
fn with_depths<const ACTIVE: usize, S: Format<u16>>(scene: &Scene) -> Vec<Rgb888> {
    let models = scene.models(Pose::new(Rotation::about_x(U0F16::ZERO), at(0, 0, 1024)));
    let mut memory = Memory::<LookIn<S>, 48, 16, 128, 64, ACTIVE>::new();
    let mut prepared = memory.prepare(&camera(area(128, 64)), &models).unwrap();
    let mut words = vec![0; 128 * 64];
    let mut band = Band::<Rgb888>::new(area(128, 64), &mut words).unwrap();
    prepared.draw_with(&mut band, |_| {});
    band.colors().collect()
}

/// Faces one below the other, two of which cross a row, in a table for two: long ones, whose edges are stepped otherwise
/// than those of short ones, and whose longer side is the left one or the right one.
#[test]
fn faces_that_have_ended_leave_room() {
    for rows in [8, 21] {
        let mut mesh = Mesh::new(Vec::new(), Vec::new());
        for number in 0..64 / rows {
            // 16 units are a pixel at the distance of the scene.
            let corner = |x: i16, y: i16| [x * 16, (32 - number * rows - y) * 16, 0];
            for [a, b, c] in [
                [corner(-60, 0), corner(-20, rows / 2), corner(-50, rows)],
                [corner(20, 0), corner(60, rows), corner(10, rows / 2)],
            ] {
                let first = mesh.vertices.len() as u16;
                mesh.vertices.extend([a, b, c]);
                mesh.faces.push([first, first + 1, first + 2]);
            }
        }
        let (count, scene) = (mesh.faces.len(), Scene::new(vec![mesh]));
        let small = with_depths::<2, Sub4>(&scene);
        for face in 0..count {
            assert!(small.contains(&color_of(face)), "{rows} rows, face {face}");
        }
        assert!(small == with_depths::<8, Sub4>(&scene), "{rows} rows");
        assert!(
            with_depths::<2, Sub8>(&scene) == with_depths::<8, Sub8>(&scene),
            "{rows} rows"
        );
    }
}

/// Pieces of cut faces take vertices: as many as asked for are enough, one less is not, and afterwards the storage serves
/// another scene.
#[test]
fn cut_faces_need_what_the_error_says() {
    let scene = Scene::new(vec![meshes::cube(1.0).two_sided()]);
    let models = scene.models(Pose::new(Rotation::about_y(U0F16::from_bits(3000)), at(10, 40, 30)));
    let camera = camera(area(128, 64));
    let mut small = Memory::<Rgb888, 12, 24, 128, 64, 24>::new();
    let Err(InputError::TooSmall(TooSmall::Vertices(needed))) = small.prepare(&camera, &models) else {
        panic!("8 vertices and one piece do not do");
    };
    assert_eq!(needed, 20, "8 vertices and 3 pieces");
    assert!(
        Memory::<Rgb888, 20, 24, 128, 64, 24>::new()
            .prepare(&camera, &models)
            .is_ok()
    );
    let error = Memory::<Rgb888, 19, 24, 128, 64, 24>::new()
        .prepare(&camera, &models)
        .err();
    assert_eq!(error, Some(InputError::TooSmall(TooSmall::Vertices(20))));

    let models = scene.models(standard_pose(0));
    let drawn = picture(&mut small.prepare(&camera, &models).unwrap(), area(128, 64));
    let mut fresh = Memory::<Rgb888, 12, 24, 128, 64, 24>::new();
    assert_eq!(
        drawn,
        picture(&mut fresh.prepare(&camera, &models).unwrap(), area(128, 64))
    );
}

#[test]
fn a_viewport_wider_or_higher_than_the_memory_is_an_error() {
    let mesh = meshes::cube(1.0);
    let models = [Model::new(mesh.face_set(), &[Rgb565::RED; 12])
        .unwrap()
        .with_pose(standard_pose(0))];
    let mut memory = Memory::<Rgb565, 8, 12, 127, 64, 12>::new();
    let error = memory.prepare(&camera(area(128, 64)), &models).err();
    assert_eq!(error, Some(InputError::TooSmall(TooSmall::Columns(128))));
    let error = memory.prepare(&camera(area(127, 65)), &models).err();
    assert_eq!(error, Some(InputError::TooSmall(TooSmall::Rows(65))));
    // Where the viewport is does not matter.
    let right = Rectangle::new(Point::new(300, -20), Size::new(127, 64));
    let mut prepared = memory.prepare(&camera(right), &models).unwrap();
    let mut words = vec![0; 127 * 64];
    prepared.draw(&mut Band::<Rgb565>::new(right, &mut words).unwrap());
    assert!(words.iter().filter(|&&word| word != 0).count() > 500);
}

#[test]
fn what_cannot_be_is_an_error() {
    assert_eq!(
        FaceSet::new(&[[0; 3]; 3], &[[0, 1, 2], [0, 3, 1]]),
        Err(InputError::IndexOutOfRange { face: 1, vertex: 3 })
    );
    let mesh = meshes::cube(1.0);
    assert_eq!(
        Model::new(mesh.face_set(), &[Rgb565::RED; 11]).err(),
        Some(TooSmall::Colors(12))
    );
    let near = I16F16::from_num(8);
    assert_eq!(
        Camera::new(area(9, 9), near - I16F16::DELTA),
        Err(InputError::NearTooClose)
    );
    assert_eq!(Camera::new(area(0, 9), near), Err(InputError::ViewportOutOfDomain));
    assert_eq!(Camera::new(area(8192, 9), near), Err(InputError::ViewportOutOfDomain));
    assert_eq!(
        Camera::new(area(8191, 9), near),
        Err(InputError::FocalLengthOutOfDomain)
    );
    assert_eq!(
        Camera::new(area(9, 9), near).unwrap().with_focal_length(I16F16::ZERO),
        Err(InputError::FocalLengthOutOfDomain)
    );
    // Within 24.8, beyond 12.4.
    let far = Camera::new(Rectangle::new(Point::new(1000, 0), Size::new(24, 2)), near).unwrap();
    let error = Memory::<Rgb888, 0, 0, 128, 2, 0>::new().prepare(&far, &[]).err();
    assert_eq!(error, Some(InputError::OutOfDomain { min: -1024, max: 1023 }));
    assert!(
        Memory::<Fine<Rgb888>, 0, 0, 128, 2, 0>::new()
            .prepare(&far, &[])
            .is_ok()
    );
}

/// The picture and the number of rows without depths, through `draw` and with the depth row in use everywhere.
fn with_and_without_depths<S: Format<D>, D: DepthWidth>(models: &[Model<'_, Rgb888>], camera: &Camera) -> (bool, u32) {
    let area = area(128, 64);
    let mut memory = Box::new(Memory::<LookIn<S, D>, 400, 600, 128, 64, 128>::new());
    let mut prepared = memory.prepare(camera, models).unwrap();
    let drawn = picture(&mut prepared, area);
    let rows = prepared.rows_without_depth();
    let mut words = vec![0; 128 * 64];
    let mut band = Band::<Rgb888>::new(area, &mut words).unwrap();
    // Nearer than everything: what is not cleared, or is read where it was not written, changes the picture.
    prepared.draw_with(&mut band, |row| {
        let Ok(()) = row.at_depth(D::from_units(0xffff)).fill_solid(&area, Rgb888::BLACK);
    });
    prepared.draw_with(&mut band, |_| {});
    assert_eq!(prepared.rows_without_depth(), rows, "draw_with always uses the depths");
    let everything_on: Vec<_> = band.colors().collect();
    let auto: Vec<_> = drawn.iter().map(|face| face.map_or(Rgb888::BLACK, color_of)).collect();
    assert!(auto.iter().any(|&color| color != Rgb888::BLACK));
    (auto == everything_on, rows)
}

#[test]
fn rows_where_no_faces_overlap_need_no_depths() {
    let cube = Scene::new(vec![meshes::cube(1.0)]);
    let two_cubes = Scene::new(vec![meshes::cube(1.0), meshes::cube(0.5)]);
    let camera = camera(area(128, 64));
    let (mut cube_rows, mut torus_rows) = (0, 0);
    for number in 0..64 {
        let pose = standard_pose(number);
        for scene in [&cube, &two_cubes, &sc1()] {
            let models = scene.models(pose);
            let (same, rows) = with_and_without_depths::<Sub4, u16>(&models, &camera);
            assert!(same, "frame {number}");
            assert!(
                with_and_without_depths::<Sub8, u32>(&models, &camera).0,
                "frame {number}"
            );
            match models.len() {
                1 => cube_rows += rows,
                _ => torus_rows += rows,
            }
        }
    }
    // Every row of a convex solid, and only such rows of a torus as hardly meet it.
    assert_eq!(cube_rows, 64 * 64);
    assert!(torus_rows < 2 * 64 * 64 - 1000, "{torus_rows}");
}

/// Nothing overlaps on a convex solid, however many faces cross a row. Rounding alone may let thin faces change places.
#[test]
fn many_faces_that_do_not_overlap_need_no_depths() {
    let sphere = Scene::new(vec![meshes::icosphere(1.4)]);
    let camera = camera(area(128, 64));
    for number in 0..64 {
        let models = sphere.models(standard_pose(number));
        let drawn = with_and_without_depths::<Sub4, u16>(&models, &camera);
        assert_eq!(drawn, (true, 64), "frame {number}");
        let (same, rows) = with_and_without_depths::<Sub8, u32>(&models, &camera);
        assert!(same && rows > 0, "frame {number}");
    }
}

/// After a frame with overlaps the next ones use depths at once; then it is tried again.
#[test]
fn frames_after_one_with_overlaps_use_depths() {
    let (cube, overlapping) = (Scene::new(vec![meshes::cube(1.0)]), sc1());
    let area = area(128, 64);
    let mut memory = Box::new(Sc1Memory::new());
    for round in 0..3 {
        let models = overlapping.models(standard_pose(5));
        picture(&mut memory.prepare(&camera(area), &models).unwrap(), area);
        for number in 0..20 {
            let models = cube.models(standard_pose(number));
            let mut prepared = memory.prepare(&camera(area), &models).unwrap();
            let drawn = picture(&mut prepared, area);
            let rows = prepared.rows_without_depth() as usize;
            let empty = drawn.chunks(128).filter(|row| row.iter().all(Option::is_none)).count();
            // Rows that no face crosses need none in any case.
            let expected = if number < 16 { rows <= empty } else { rows == 64 };
            assert!(expected, "{rows} rows of frame {number} of round {round}");
            let mut fresh = Box::new(Sc1Memory::new());
            assert_eq!(
                drawn,
                picture(&mut fresh.prepare(&camera(area), &models).unwrap(), area)
            );
        }
    }
}

/// Some rows with depths, some without, in one frame.
#[test]
fn depths_may_be_asked_for_in_any_row() {
    let sphere = Scene::new(vec![meshes::icosphere(1.4)]);
    let models = sphere.models(standard_pose(11));
    let area = area(128, 64);
    let mut memory = Box::new(Sc1Memory::new());
    let mut prepared = memory.prepare(&camera(area), &models).unwrap();
    let whole = picture(&mut prepared, area);
    let mut prepared = memory.prepare(&camera(area), &models).unwrap();
    let mut words = vec![0; 128 * 64];
    for (y, words) in words.chunks_mut(128).enumerate() {
        let row = Rectangle::new(Point::new(0, y as i32), Size::new(128, 1));
        let mut band = Band::<Rgb888>::new(row, words).unwrap();
        if y % 24 < 12 {
            prepared.draw(&mut band);
        } else {
            prepared.draw_with(&mut band, |_| {});
        }
    }
    assert_eq!(prepared.rows_without_depth(), 12);
    let expected: Vec<_> = whole.iter().map(|face| face.map_or(Rgb888::BLACK, color_of)).collect();
    let band = Band::<Rgb888>::new(area, &mut words).unwrap();
    assert_eq!(band.colors().collect::<Vec<_>>(), expected);
}

/// The farthest face is still nearer than nothing, or it would be drawn without depths and not with them.
#[test]
fn the_farthest_face_is_drawn_with_and_without_depths() {
    let vertices = vec![[-30_000, -30_000, 0], [30_000, -30_000, 0], [0, 30_000, 0]];
    let mesh = Mesh::new(vertices, vec![[0, 1, 2]]).two_sided();
    let scene = Scene::new(vec![mesh]);
    let camera = Camera::new(area(128, 64), I16F16::lit("8")).unwrap();
    let models = scene.models(Pose::new(Rotation::IDENTITY, at(0, 0, 32_767)));
    assert!(with_and_without_depths::<Sub4, u16>(&models, &camera).0);
    assert!(with_and_without_depths::<Sub8, u32>(&models, &camera).0);
}
