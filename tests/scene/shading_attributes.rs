//! Attributes that vary evenly on the screen, against exact planes through the snapped corners.

use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
use proptest::prelude::*;
use zrow::scene::{Camera, Deep, Fine, Look, Pose};

use crate::common::meshes::Mesh;
use crate::common::{cases, config};
use crate::random_faces::pose;
use crate::reference::nearest_faces::Face;
use crate::shaded_scene::{
    Even, SmallMemory, UNTOUCHED, camera_in_units, covered, flat_corners, model, number, triangle, unit, words,
};
use crate::snapped_faces::snapped;

/// An attribute and its fractional bits.
const ONE: i128 = 1 << 16;

/// The plane of an attribute at a point: numerator and positive denominator.
pub fn plane(face: &Face, numbers: [i16; 3], [x, y]: [i128; 2]) -> (i128, i128) {
    let mut corners = face.corners;
    for (corner, number) in corners.iter_mut().zip(numbers) {
        corner[2] = number.into();
    }
    Face { corners, ..*face }.depth(x, y)
}

/// How far a value is from a quotient, half a unit above it, in 1/65,536 unit and rounded up.
fn error(value: u32, (numerator, denominator): (i128, i128)) -> i128 {
    let exact = numerator * ONE + denominator * ONE / 2;
    ((i128::from(value as i32) * denominator - exact).abs() + denominator - 1) / denominator
}

/// Draws a model of one face and compares all pixels; returns how many there are, and the greatest error in 1/65,536
/// unit.
fn compare<L>(mesh: &Mesh, numbers: &[[i16; 3]], pose: Pose, camera: &Camera) -> (usize, i128)
where
    L: Look<Color = Rgb888, Shading = Even<3>>,
{
    let area = camera.viewport().to_rectangle();
    let mut memory = Box::new(SmallMemory::<L>::new());
    let (mut count, mut worst) = (0, 0);
    for shown in 0..3 {
        let models = [model::<Even<3>, 3>(mesh, numbers, shown).with_pose(pose)];
        let mut prepared = memory.prepare(camera, &models).unwrap();
        let faces = snapped(&prepared);
        let words = words(&mut prepared, area);
        let mut drawn = 0;
        for face in &faces {
            let numbers = mesh.faces[face.order].map(|vertex| numbers[usize::from(vertex)][shown]);
            for (_, position, index) in covered(face, area, unit::<L>()) {
                worst = worst.max(error(words[index], plane(face, numbers, position)));
                drawn += 1;
            }
        }
        assert_eq!(words.iter().filter(|&&word| word != UNTOUCHED).count(), drawn);
        count += drawn;
    }
    (count, worst)
}

fn all_formats(mesh: &Mesh, numbers: &[[i16; 3]], pose: Pose, camera: &Camera) -> [(usize, i128); 4] {
    [
        compare::<Even<3>>(mesh, numbers, pose, camera),
        compare::<Fine<Even<3>>>(mesh, numbers, pose, camera),
        compare::<Deep<Even<3>>>(mesh, numbers, pose, camera),
        compare::<Fine<Deep<Even<3>>>>(mesh, numbers, pose, camera),
    ]
}

/// At 1/16 pixel a gradient is wrong by 5/65,536 unit at most, and the viewport has 200 columns and rows: 1/64 unit. At
/// 1/256 pixel it is rounded once: 1/512 unit. So the upper half of a value is the number rounded to the nearest, but
/// for those so close to a tie.
fn check(found: [(usize, i128); 4]) {
    let bounds = [1_024, 128, 1_024, 128];
    for ((_, worst), bound) in found.into_iter().zip(bounds) {
        assert!(worst <= bound, "{found:?}");
    }
}

/// A corner that a face may have once it is cut: its position on the screen, and its numbers.
type CutCorner = ([f64; 2], [i16; 3]);

/// Where a vertex that is not before the near plane is on the screen of [`camera_in_units`], in units.
fn projected([x, y, z]: [f64; 3], unit: f64) -> [f64; 2] {
    [(60.0 + 64.0 * x / z) * unit, (39.0 - 64.0 * y / z) * unit]
}

/// The corners behind the near plane at 128, and those where edges cross it.
fn near_corners(corners: [[i16; 3]; 3], numbers: &[[i16; 3]; 3], unit: f64) -> Vec<CutCorner> {
    let vertices = corners.into_iter().zip(*numbers);
    let mut found: Vec<_> = vertices
        .filter(|([_, _, z], _)| *z >= 128)
        .map(|(corner, numbers)| (projected(corner.map(f64::from), unit), numbers))
        .collect();
    for (from, to) in [(0, 1), (1, 2), (2, 0)] {
        let (from, to) = if corners[from][2] < corners[to][2] {
            (to, from)
        } else {
            (from, to)
        };
        let [part, beyond] = [corners[from][2], 2 * 128 - corners[to][2]].map(|z| i64::from(z) - 128);
        if part < 0 || beyond <= 0 {
            continue;
        }
        let between = |from: f64, to: f64| from + (to - from) * part as f64 / (part + beyond) as f64;
        let [x, y] = [0, 1].map(|axis| between(corners[from][axis].into(), corners[to][axis].into()));
        let number = |index: usize| {
            let (from, to) = (i64::from(numbers[from][index]), i64::from(numbers[to][index]));
            let (change, whole) = ((to - from) * part, part + beyond);
            // Halves away from the end behind the plane.
            (from + change.signum() * ((2 * change.abs() + whole) / (2 * whole))) as i16
        };
        found.push((projected([x, y, 128.0], unit), [number(0), number(1), number(2)]));
    }
    found
}

/// The numbers of the candidate that a snapped corner is; `None` where it may be one of two.
fn numbers_of(candidates: &[CutCorner], [x, y, _]: [i128; 3]) -> Option<[i16; 3]> {
    let near = |within: f64| {
        candidates
            .iter()
            .filter(move |([a, b], _)| (a - x as f64).abs().max((b - y as f64).abs()) < within)
    };
    assert!(near(2.0).next().is_some(), "{x}, {y} is none of {candidates:?}");
    let mut numbers = near(8.0).map(|(_, numbers)| *numbers);
    let first = numbers.next()?;
    numbers.all(|other| other == first).then_some(first)
}

/// Compares the fragments of a face that the near plane cuts with planes through their own corners.
fn compare_cut<L: Look<Color = Rgb888, Shading = Even<3>>>(
    corners: [[i16; 3]; 3],
    numbers: &[[i16; 3]; 3],
    bound: i128,
) {
    let (camera, mesh) = (camera_in_units(), triangle(corners));
    let area = camera.viewport().to_rectangle();
    let candidates = near_corners(corners, numbers, unit::<L>() as f64);
    let mut memory = Box::new(SmallMemory::<L>::new());
    for shown in 0..3 {
        let models = [model::<Even<3>, 3>(&mesh, numbers, shown)];
        let mut prepared = memory.prepare(&camera, &models).unwrap();
        let faces = snapped(&prepared);
        let words = words(&mut prepared, area);
        for face in &faces {
            let [a, b, c] = face.corners.map(|corner| numbers_of(&candidates, corner));
            let (Some(a), Some(b), Some(c)) = (a, b, c) else {
                continue;
            };
            for (point, position, index) in covered(face, area, unit::<L>()) {
                let error = error(words[index], plane(face, [a[shown], b[shown], c[shown]], position));
                assert!(error <= bound, "{point:?} of {face:?}: {error}/65,536");
            }
        }
    }
}

/// A face as it would be on the screen of [`camera_in_units`] without a guard band: all corners at distances of powers
/// of two.
fn unclipped(corners: [[i16; 3]; 3]) -> Face {
    Face {
        order: 0,
        corners: corners.map(|[x, y, z]| {
            let units = |coordinate: i16| i128::from(coordinate) * 1_024 / i128::from(z);
            [60 * 16 + units(x), 39 * 16 - units(y), 0]
        }),
    }
}

/// How much an attribute changes in both directions together for a unit, in 1/65,536 unit.
fn slope(face: &Face, numbers: [i16; 3]) -> i128 {
    let at = |position| {
        let (numerator, denominator) = plane(face, numbers, position);
        numerator * ONE / denominator
    };
    (at([1, 0]) - at([0, 0])).abs() + (at([0, 1]) - at([0, 0])).abs() + 2
}

/// Compares a face that the guard band cuts with the plane of the whole face.
fn compare_with_whole(corners: [[i16; 3]; 3], numbers: &[[i16; 3]; 3]) {
    let (camera, mesh) = (camera_in_units(), triangle(corners));
    let area = camera.viewport().to_rectangle();
    let (front, order) = (unclipped(corners), [[0, 1, 2], [0, 2, 1]]);
    let mut memory = Box::new(SmallMemory::<Even<3>>::new());
    for shown in 0..3 {
        let models = [model::<Even<3>, 3>(&mesh, numbers, shown)];
        let words = words(&mut memory.prepare(&camera, &models).unwrap(), area);
        for order in order {
            let face = Face {
                order: 0,
                corners: order.map(|index| front.corners[index]),
            };
            let numbers = order.map(|index: usize| numbers[index][shown]);
            for (point, position, index) in covered(&face, area, 16) {
                // A cut at a corner of the band rounds twice: numbers by half a unit, positions by a unit.
                let bound = 1_024 + ONE + 2 * slope(&face, numbers);
                let error = error(words[index], plane(&face, numbers, position));
                // An edge that moved leaves the pixel beside it out.
                assert!(
                    words[index] == UNTOUCHED || error <= bound,
                    "{point:?}: {error} > {bound} /65,536"
                );
            }
        }
    }
}

/// Draws the two faces of a quadrangle over which a number is one function of the position, and compares each pixel
/// with it.
fn check_seam<L: Look<Color = Rgb888, Shading = Even<3>>>(corners: [[i16; 2]; 4], [a, b]: [i16; 2], bound: i128) {
    let camera = camera_in_units();
    let area = camera.viewport().to_rectangle();
    let vertices = corners.map(|[x, y]| [x, y, 1_024]).to_vec();
    let mesh = Mesh::new(vertices, vec![[0, 1, 2], [0, 2, 3]]).two_sided();
    let numbers = corners.map(|[x, y]| [a * x + b * y; 3]);
    let models = [model::<Even<3>, 3>(&mesh, &numbers, 0)];
    let mut memory = Box::new(SmallMemory::<L>::new());
    let words = words(&mut memory.prepare(&camera, &models).unwrap(), area);
    for (point, word) in area.points().zip(words).filter(|&(_, word)| word != UNTOUCHED) {
        let exact = i128::from(a) * i128::from(16 * (point.x - 60)) - i128::from(b) * i128::from(16 * (point.y - 39));
        let error = error(word, (exact, 1));
        assert!(error <= bound, "{point:?}: {error}/65,536");
    }
}

/// A coordinate beyond the guard band, or between its sides.
fn far() -> impl Strategy<Value = i16> {
    prop::sample::select(vec![-32_000, -17_000, -500, 600, 16_500, 32_000])
}

proptest! {
    #![proptest_config(config(cases(60, 1_000)))]

    /// Faces of any size, and slivers.
    #[test]
    fn attributes_are_planes_through_the_corners(
        corners in flat_corners(),
        numbers in prop::array::uniform3(prop::array::uniform3(number())),
    ) {
        let found = all_formats(&triangle(corners), &numbers, Pose::IDENTITY, &camera_in_units());
        check(found);
    }

    /// Faces in space, whose corners are anywhere between the pixels.
    #[test]
    fn attributes_of_turned_faces_are_planes(
        corners in prop::array::uniform3(prop::array::uniform3(-600i16..=600)),
        numbers in prop::array::uniform3(prop::array::uniform3(number())),
        pose in pose(1300..2500),
    ) {
        let found = all_formats(&triangle(corners), &numbers, pose, &camera_in_units());
        check(found);
    }

    /// The near plane cuts in space, where a cut corner gets the nearest number to that of the edge; its fragments then
    /// are planes through their own corners.
    #[test]
    fn attributes_at_the_near_plane_are_those_of_the_edges(
        positions in prop::array::uniform3((-400i16..400, -300i16..300)),
        distances in prop::array::uniform3(-300i16..700),
        numbers in prop::array::uniform3(prop::array::uniform3(number())),
    ) {
        let corners = [0, 1, 2].map(|i| [positions[i].0, positions[i].1, distances[i]]);
        compare_cut::<Even<3>>(corners, &numbers, 1_024);
        compare_cut::<Fine<Deep<Even<3>>>>(corners, &numbers, 128);
    }

    /// The guard band cuts on the screen, where attributes are one plane: to the position and the number that a cut
    /// corner is rounded to.
    #[test]
    fn attributes_at_the_guard_band_stay_in_their_plane(
        positions in prop::array::uniform3((-16_000i16..16_000, -16_000i16..16_000)),
        distances in prop::array::uniform3(prop::sample::select(vec![256i16, 512, 1_024, 2_048])),
        numbers in prop::array::uniform3(prop::array::uniform3(number())),
    ) {
        let corners = [0, 1, 2].map(|i| [positions[i].0 * 2, positions[i].1 * 2, distances[i]]);
        compare_with_whole(corners, &numbers);
    }

    /// Two faces of one plane that share an edge have one function of the position on both sides of it.
    #[test]
    fn no_seam_where_faces_of_one_plane_meet(
        corners in prop::array::uniform4(prop::array::uniform2(-1_000i16..=1_000)),
        slopes in prop::array::uniform2(-16i16..=16),
    ) {
        check_seam::<Even<3>>(corners, slopes, 1_024);
        check_seam::<Deep<Even<3>>>(corners, slopes, 1_024);
    }

    /// One of the two faces reaches beyond the guard band, or both do; an attribute changes by 16 units a pixel.
    #[test]
    fn no_seam_where_a_face_is_cut(
        edge in prop::array::uniform2(prop::array::uniform2(-900i16..=900)),
        far in prop::array::uniform2(prop::array::uniform2(far())),
        slopes in prop::sample::select(vec![[1i16, 0], [0, 1], [-1, 0], [0, -1]]),
    ) {
        check_seam::<Even<3>>([edge[0], far[0], edge[1], far[1]], slopes, ONE);
    }
}
