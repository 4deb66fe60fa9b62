//! Attributes that vary evenly in space, against quotients of exact planes through the snapped corners and their stored
//! depths.

use embedded_graphics::pixelcolor::Rgb888;
use proptest::prelude::*;
use zrow::scene::{Deep, Fine, Look, Pose};

use crate::common::meshes::Mesh;
use crate::common::{cases, config};
use crate::random_faces::pose;
use crate::reference::nearest_faces::Face;
use crate::shaded_scene::{
    Even, InSpace, SIZE, SmallMemory, UNTOUCHED, camera_in_units, flat_corners, model, number, triangle, unit, words,
};
use crate::snapped_faces::snapped;

/// An attribute of a face in space at a point: the sum of those of the corners, weighed by barycentric coordinates and
/// depths.
pub fn in_space(face: &Face, numbers: [i16; 3], [x, y]: [i128; 2]) -> f64 {
    let [a, b, c] = face.corners;
    let side = |[ax, ay, _]: [i128; 3], [bx, by, _]: [i128; 3]| (bx - ax) * (y - ay) - (by - ay) * (x - ax);
    let weights = [side(b, c) * a[2], side(c, a) * b[2], side(a, b) * c[2]];
    let sum: i128 = weights
        .iter()
        .zip(numbers)
        .map(|(weight, number)| weight * i128::from(number))
        .sum();
    sum as f64 / weights.iter().sum::<i128>() as f64
}

/// The columns of a row that a face covers, also outside the picture.
pub fn span(face: &Face, row: i32, unit: i128) -> Option<[i32; 2]> {
    let columns = face.corners.map(|[x, ..]| x.div_euclid(unit) as i32);
    let all = *columns.iter().min()?..columns.iter().max()? + 2;
    let mut inside = all.filter(|column| face.covers(i128::from(*column) * unit, i128::from(row) * unit));
    let first = inside.next()?;
    Some([first, inside.next_back().unwrap_or(first)])
}

/// The greatest errors of the numbers of a picture, in units.
#[derive(Debug, Default, Copy, Clone)]
struct Errors {
    /// From the exact number where it is divided, at both ends of a span and every 1 to 16 columns, and from a line in
    /// between.
    from_line: f64,
    from_exact: f64,
}

impl Errors {
    /// Adds the pixels of one row of a face that are in the picture.
    fn add_row(&mut self, step: i32, words: &[u32], [first, last]: [i32; 2], exact: impl Fn(i32) -> f64) {
        for (column, word) in (0..).zip(words).filter(|(column, _)| (first..=last).contains(column)) {
            let before = (column & -step).max(first);
            let after = ((column & -step) + step).min(last);
            let line = match f64::from(after - before) {
                0.0 => exact(column),
                length => exact(before) + (exact(after) - exact(before)) * f64::from(column - before) / length,
            };
            let drawn = f64::from(*word as i32) / 65_536.0;
            self.from_line = self.from_line.max((drawn - line).abs());
            self.from_exact = self.from_exact.max((drawn - exact(column)).abs());
        }
    }
}

/// The greatest range of the numbers of a face.
fn range(numbers: &[[i16; 2]; 3]) -> i128 {
    let of = |shown: usize| spread(numbers.map(|numbers| numbers[shown].into()));
    of(0).max(of(1))
}

fn spread(values: [i128; 3]) -> i128 {
    values.iter().max().unwrap() - values.iter().min().unwrap()
}

/// How far a number may be wrong where it is divided, and from a line in between, in units. A product of a number and a
/// depth has 15 bits, and is divided by the depth of another corner; the planes of depth and product are wrong by 1/65
/// unit; a pixel's part of a line is wrong by 1/131,072.
fn bound(face: &Face, numbers: &[[i16; 2]; 3]) -> f64 {
    let depths = face.corners.map(|[.., depth]| depth);
    let (least, greatest) = (
        *depths.iter().min().unwrap() as f64,
        *depths.iter().max().unwrap() as f64,
    );
    range(numbers) as f64 * ((greatest / 32_768.0 + 1.0 / 65.0) / least + 15.0 / 131_072.0) + 1.0 / 65.0
}

/// Whether a face is drawn without divisions.
fn is_even(face: &Face, numbers: &[[i16; 2]; 3], tolerance: u16) -> bool {
    let depths = face.corners.map(|[.., depth]| depth);
    let most = 4 * i128::from(tolerance) * depths.iter().min().unwrap();
    let corners = [0, 1, 2]
        .into_iter()
        .flat_map(|one| (0..one).map(move |other| [one, other]));
    corners.into_iter().all(|[one, other]| {
        let depth = (depths[one] - depths[other]).abs();
        (0..2).all(|shown| depth * i128::from(numbers[one][shown].abs_diff(numbers[other][shown])) <= most)
    })
}

/// Draws a model of one face and hands each face on the screen that is not cut over, with its numbers and errors.
fn for_each_face<L, const TOLERANCE: u16, const STEP: i32>(
    mesh: &Mesh,
    numbers: &[[i16; 2]],
    pose: Pose,
    check: impl Fn(&Face, &[[i16; 2]; 3], Errors),
) where
    L: Look<Color = Rgb888, Shading = InSpace<2, TOLERANCE, STEP>>,
{
    let camera = camera_in_units();
    let area = camera.viewport().to_rectangle();
    let mut memory = Box::new(SmallMemory::<L>::new());
    for shown in 0..2 {
        let models = [model::<L::Shading, 2>(mesh, numbers, shown).with_pose(pose)];
        let mut prepared = memory.prepare(&camera, &models).unwrap();
        if prepared.vertices_needed() > mesh.vertices.len() {
            return;
        }
        let faces = snapped(&prepared);
        let words = words(&mut prepared, area);
        for face in &faces {
            let numbers = mesh.faces[face.order].map(|vertex| numbers[usize::from(vertex)]);
            let shown = numbers.map(|numbers| numbers[shown]);
            let mut errors = Errors::default();
            for (row, words) in (0..).zip(words.chunks(SIZE[0] as usize)) {
                let unit = unit::<L>();
                let exact = |column: i32| in_space(face, shown, [column, row].map(|pixels| i128::from(pixels) * unit));
                if let Some(span) = span(face, row, unit) {
                    errors.add_row(STEP, words, span, exact);
                }
            }
            check(face, &numbers, errors);
        }
    }
}

/// Checks that a face of one mesh is drawn by divisions, without tolerance.
fn check_divided<L: Look<Color = Rgb888, Shading = InSpace<2, 0, STEP>>, const STEP: i32>(
    mesh: &Mesh,
    numbers: &[[i16; 2]],
    pose: Pose,
    most: f64,
) {
    for_each_face::<L, 0, STEP>(mesh, numbers, pose, |face, numbers, errors| {
        let bound = if is_even(face, numbers, 0) {
            1.0 / 64.0
        } else {
            bound(face, numbers).min(most)
        };
        assert!(
            errors.from_line <= bound,
            "{errors:?}, {bound} of {face:?}, {numbers:?}"
        );
    });
}

/// Checks that a face is drawn within a tolerance, or by divisions.
fn check_tolerance<const TOLERANCE: u16>(mesh: &Mesh, numbers: &[[i16; 2]]) {
    for_each_face::<InSpace<2, TOLERANCE>, TOLERANCE, 16>(mesh, numbers, Pose::IDENTITY, |face, numbers, errors| {
        if is_even(face, numbers, TOLERANCE) {
            assert!(
                errors.from_exact <= f64::from(TOLERANCE) + 1.0 / 64.0,
                "{errors:?} of {face:?}, {numbers:?}"
            );
        } else {
            assert!(
                errors.from_line <= bound(face, numbers),
                "{errors:?} of {face:?}, {numbers:?}"
            );
        }
    });
}

/// A quadrangle in space: a corner, and two sides.
type Quad = [[i16; 3]; 3];

/// The numbers, from 0 to 4,096 along both sides, where the ray through a pixel meets the plane of a quadrangle; `None`
/// beside it.
fn along_ray([corner, a, b]: Quad, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
    let [corner, a, b] = [corner, a, b].map(|vector| vector.map(f64::from));
    let ray = [(x - 60.0) / 64.0, (39.0 - y) / 64.0, 1.0];
    let cross = |u: [f64; 3], v: [f64; 3]| {
        [
            u[1] * v[2] - u[2] * v[1],
            u[2] * v[0] - u[0] * v[2],
            u[0] * v[1] - u[1] * v[0],
        ]
    };
    let dot = |u: [f64; 3], v: [f64; 3]| u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    // corner + s a + t b = distance * ray, by Cramer's rule.
    let volume = dot(ray, cross(a, b));
    let distance = dot(corner, cross(a, b)) / volume;
    let [s, t] = [dot(ray, cross(b, corner)) / volume, dot(ray, cross(corner, a)) / volume];
    let inside = distance > 128.0 && [s, t].iter().all(|part| (0.0..=1.0).contains(part));
    inside.then_some([4_096.0 * s, 4_096.0 * t])
}

/// Compares 64 pixels where numbers are divided with the plane in space; returns how many are in the middle of the
/// quadrangle.
fn check_quad<L: Look<Color = Rgb888, Shading = InSpace<2>>>(quad: Quad) -> usize {
    let [corner, a, b] = quad;
    let plus = |u: [i16; 3], v: [i16; 3]| [u[0] + v[0], u[1] + v[1], u[2] + v[2]];
    let vertices = vec![corner, plus(corner, a), plus(plus(corner, a), b), plus(corner, b)];
    let numbers = [[0, 0], [4_096, 0], [4_096, 4_096], [0, 4_096]];
    let mesh = Mesh::new(vertices, vec![[0, 1, 2], [0, 2, 3]]).two_sided();
    let camera = camera_in_units();
    let mut memory = Box::new(SmallMemory::<L>::new());
    let mut compared = 0;
    for shown in 0..2 {
        let models = [model::<InSpace<2>, 2>(&mesh, &numbers, shown)];
        let words = words(
            &mut memory.prepare(&camera, &models).unwrap(),
            camera.viewport().to_rectangle(),
        );
        for (x, y) in (0..8).flat_map(|column| (0..8).map(move |row| (16 * column, 10 * row))) {
            let at = |right: f64, down: f64| along_ray(quad, [f64::from(x) + right, f64::from(y) + down]);
            // Corners are snapped to 1/16 pixel, and those of cuts once more.
            let around = [at(0.25, 0.0), at(-0.25, 0.0), at(0.0, 0.25), at(0.0, -0.25)];
            let (Some(exact), [Some(a), Some(b), Some(c), Some(d)]) = (at(0.0, 0.0), around) else {
                continue;
            };
            let change = [a, b, c, d].map(|numbers| (numbers[shown] - exact[shown]).abs());
            let drawn = f64::from(words[(y * SIZE[0] + x) as usize] as i32) / 65_536.0;
            // And 1/32 of 4,096 for depths of 16 bits and products of 15.
            let bound = change.into_iter().fold(16.0, f64::max);
            assert!(
                (drawn - exact[shown]).abs() <= bound,
                "{x}, {y}: {drawn}, not {exact:?}[{shown}], within {bound} of {quad:?}"
            );
            compared += 1;
        }
    }
    compared
}

proptest! {
    #![proptest_config(config(cases(60, 1_000)))]

    /// Textures over faces from the near plane to more than a hundred times as far away: within one unit of 4,096.
    #[test]
    fn attributes_are_divided_by_the_depth(
        corners in prop::array::uniform3(prop::array::uniform2(-1000i16..1000)),
        distances in prop::array::uniform3(prop_oneof![Just(128i16), Just(12_800), 128i16..1000, 128..i16::MAX / 2]),
        numbers in prop::array::uniform3(prop::array::uniform2(0i16..=4096)),
    ) {
        let corners = [0, 1, 2].map(|i| {
            // Anywhere on the screen.
            let [x, y] = corners[i].map(|c| (i32::from(c) * i32::from(distances[i]) / 1_024) as i16);
            [x, y, distances[i]]
        });
        let mesh = triangle(corners);
        check_divided::<InSpace<2>, 16>(&mesh, &numbers, Pose::IDENTITY, 1.0);
        check_divided::<Fine<Deep<InSpace<2>>>, 16>(&mesh, &numbers, Pose::IDENTITY, 1.0);
        check_divided::<InSpace<2, 0, 8>, 8>(&mesh, &numbers, Pose::IDENTITY, 1.0);
        check_divided::<Fine<InSpace<2, 0, 4>>, 4>(&mesh, &numbers, Pose::IDENTITY, 1.0);
        check_divided::<Deep<InSpace<2, 0, 2>>, 2>(&mesh, &numbers, Pose::IDENTITY, 1.0);
        check_divided::<InSpace<2, 0, 1>, 1>(&mesh, &numbers, Pose::IDENTITY, 1.0);
    }

    /// Two corners with one number at the near plane: along the edge between them the error of a gradient takes no number past
    /// the end of the digits that it is kept in.
    #[test]
    fn attributes_along_an_edge_do_not_wrap(
        corners in prop::array::uniform3(prop::array::uniform2(-60i16..60)),
        distance in 200i16..2000,
        size in 10u32..15,
    ) {
        let [a, b, c] = corners;
        let mesh = triangle([[a[0], a[1], distance], [b[0], b[1], 128], [c[0], c[1], 128]]);
        let number = -(1i16 << size);
        let numbers = [[0; 2], [number; 2], [number; 2]];
        check_divided::<InSpace<2>, 16>(&mesh, &numbers, Pose::IDENTITY, f64::MAX);
        check_divided::<Fine<Deep<InSpace<2>>>, 16>(&mesh, &numbers, Pose::IDENTITY, f64::MAX);
    }

    /// Numbers that change by more than half of all there are from one division to the next.
    #[test]
    fn attributes_of_turned_faces_are_divided_by_the_depth(
        corners in prop::array::uniform3(prop::array::uniform3(-600i16..=600)),
        numbers in prop::array::uniform3(prop::array::uniform2(-32_000i16..=32_000)),
        pose in pose(1300..2500),
    ) {
        check_divided::<InSpace<2>, 16>(&triangle(corners), &numbers, pose, f64::MAX);
        check_divided::<Fine<Deep<InSpace<2>>>, 16>(&triangle(corners), &numbers, pose, f64::MAX);
        check_divided::<Fine<Deep<InSpace<2, 0, 8>>>, 8>(&triangle(corners), &numbers, pose, f64::MAX);
        check_divided::<InSpace<2, 0, 1>, 1>(&triangle(corners), &numbers, pose, f64::MAX);
    }

    /// Faces that lean so little that some are drawn without divisions.
    #[test]
    fn a_tolerance_is_kept(
        corners in flat_corners(),
        distances in prop::array::uniform3(-120i16..120),
        numbers in prop::array::uniform3(prop::array::uniform2(0i16..=300)),
    ) {
        let mut corners = corners.map(|[x, y, z]| [x.clamp(-1_100, 1_100), y.clamp(-1_100, 1_100), z]);
        for (corner, distance) in corners.iter_mut().zip(distances) {
            corner[2] += distance;
        }
        check_tolerance::<4>(&triangle(corners), &numbers);
        check_tolerance::<16>(&triangle(corners), &numbers);
    }

    /// Where all depths are equal, what varies evenly in space does so on the screen: the same integers.
    #[test]
    fn equal_depths_give_the_numbers_of_the_screen(
        corners in flat_corners(),
        numbers in prop::array::uniform3(prop::array::uniform2(number())),
        shown in 0usize..2,
    ) {
        let (camera, mesh) = (camera_in_units(), triangle(corners));
        let area = camera.viewport().to_rectangle();
        let mut memory = Box::new(SmallMemory::<Even<2>>::new());
        let models = [model::<Even<2>, 2>(&mesh, &numbers, shown)];
        let expected = words(&mut memory.prepare(&camera, &models).unwrap(), area);
        let mut memory = Box::new(SmallMemory::<InSpace<2>>::new());
        let models = [model::<InSpace<2>, 2>(&mesh, &numbers, shown)];
        let drawn = words(&mut memory.prepare(&camera, &models).unwrap(), area);
        for (drawn, expected) in drawn.into_iter().zip(expected) {
            // They are not half a unit above the numbers.
            let half = if expected == UNTOUCHED { 0 } else { 1 << 15 };
            prop_assert_eq!(drawn, expected.wrapping_sub(half));
        }
    }

    /// The near plane and the guard band cut quadrangles; what is left has the numbers of the whole plane.
    #[test]
    fn cut_quadrangles_keep_their_numbers(
        corner in [-900i16..900, -900i16..900, -600i16..600],
        sides in prop::array::uniform2(prop::array::uniform3(-3_000i16..3_000)),
    ) {
        check_quad::<InSpace<2>>([corner, sides[0], sides[1]]);
        check_quad::<Fine<Deep<InSpace<2>>>>([corner, sides[0], sides[1]]);
    }
}

/// Floors, ceilings and walls from behind the camera to far away.
#[test]
fn the_floor_around_the_camera_keeps_its_numbers() {
    let [right, ahead, up] = [[8_000, 0, 0], [0, 0, 9_000], [0, 3_000, 0]];
    for quad in [
        [[-4_000, -300, -500], right, ahead],
        [[-4_000, 250, -3_000], ahead, right],
        [[-300, -1_000, -700], up, ahead],
        [[200, -1_400, -20], [700, 0, 9_000], up],
    ] {
        let compared = check_quad::<InSpace<2>>(quad) + check_quad::<Fine<Deep<InSpace<2>>>>(quad);
        assert!(compared >= 40, "{compared} pixels of {quad:?}");
    }
}
