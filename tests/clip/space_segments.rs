//! Segments in space: every clipper against exact rationals in `i128`, and so against each other.

use embedded_graphics::{prelude::*, primitives::Rectangle};
use fixed::types::{I16F16, U0F16};
use proptest::prelude::*;
use zrow::{
    clip::{ClipMatrix, ClipPlane, ClipPoint, Segments, SpaceSegment},
    scene::{Camera, Pose, Rotation},
};

use crate::common::{cases, config};

type Vertex = [i16; 3];

/// How far along a segment a point is: `along / whole` of the way, of a positive `whole`.
#[derive(Clone, Copy)]
struct Along {
    along: i128,
    whole: i128,
}

impl Along {
    /// The nearest number between two, ties to the larger one.
    fn between(&self, from: i128, to: i128) -> i128 {
        (2 * (from * (self.whole - self.along) + to * self.along) + self.whole).div_euclid(2 * self.whole)
    }

    /// Whether each distance, which changes evenly, is 0 or more here.
    fn is_inside(&self, distances: &[[i128; 2]]) -> bool {
        let at = |&[from, to]: &[i128; 2]| from * (self.whole - self.along) + to * self.along;
        distances.iter().all(|distance| at(distance) >= 0)
    }
}

/// The first and the last point that is inside of all planes, by trying both ends and every crossing. Distances of both ends.
fn exact_clip(distances: &[[i128; 2]]) -> Option<[Along; 2]> {
    let mut points = vec![Along { along: 0, whole: 1 }, Along { along: 1, whole: 1 }];
    for [from, to] in distances {
        if (*from < 0) != (*to < 0) {
            let (along, whole) = (from.abs(), from.abs() + to.abs());
            points.push(Along { along, whole });
        }
    }
    points.retain(|point| point.is_inside(distances));
    let order = |one: &Along, other: &Along| (one.along * other.whole).cmp(&(other.along * one.whole));
    Some([
        points.iter().copied().min_by(order)?,
        points.iter().copied().max_by(order)?,
    ])
}

fn wide(ClipPoint { x, y, z, w }: ClipPoint) -> [i128; 4] {
    [x, y, z, w].map(i128::from)
}

fn distances_in_clip_space(from: ClipPoint, to: ClipPoint) -> Vec<[i128; 2]> {
    let distances = |point| {
        let [x, y, z, w] = wide(point);
        [w + x, w - x, w + y, w - y, z, w - z]
    };
    let pairs = distances(from).into_iter().zip(distances(to));
    pairs.map(|(from, to)| [from, to]).collect()
}

/// What has to be left of a segment: its ends in clip space, and those of an attribute of any two numbers.
fn check_against(part: Option<SpaceSegment>, distances: &[[i128; 2]], from: Vertex, to: Vertex, matrix: &ClipMatrix) {
    let exact = exact_clip(distances);
    assert_eq!(part.is_some(), exact.is_some(), "{from:?} {to:?}");
    let (Some(part), Some([first, last])) = (part, exact) else {
        return;
    };
    let (start, end) = (wide(matrix.apply(from)), wide(matrix.apply(to)));
    let at = |along: Along| [0, 1, 2, 3].map(|axis: usize| along.between(start[axis], end[axis]));
    let (entry, exit) = part.ends(matrix);
    assert_eq!([wide(entry), wide(exit)], [at(first), at(last)], "{from:?} {to:?}");
    for (one, other) in [(i32::MIN, i32::MAX), (7, -3), (0, 0), (-1_000_000, 2)] {
        let (from, to) = part.attribute(one, other);
        let exact = [first, last].map(|along| along.between(one.into(), other.into()));
        assert_eq!([from, to].map(i128::from), exact);
    }
    let vertices = [first, last].map(|along| [0, 1, 2].map(|axis| along.between(from[axis].into(), to[axis].into())));
    let (from, to) = part.vertices();
    assert_eq!([from, to].map(|vertex| vertex.map(i128::from)), vertices);
}

/// Checks all clippers of what a camera sees, in both directions.
fn check(from: Vertex, to: Vertex, matrix: &ClipMatrix) -> Option<SpaceSegment> {
    let distances = distances_in_clip_space(matrix.apply(from), matrix.apply(to));
    let default = Segments::homogeneous_liang_barsky(from, to, matrix);
    check_against(default, &distances, from, to, matrix);
    macro_rules! clip_by_each {
        ($([$name:ident] [$($clip:tt)+])+) => {
            $(assert_eq!($($clip)+(from, to, matrix), default, "{} {from:?} {to:?}", stringify!($name));)+
        };
    }
    zrow_methods::space_segments!(clip_by_each);
    let planes = matrix.planes();
    macro_rules! clip_to_planes {
        ($([$name:ident] [$($clip:tt)+])+) => {
            $(assert_eq!($($clip)+(from, to, &planes), default, "{} {from:?} {to:?}", stringify!($name));)+
        };
    }
    zrow_methods::volume_segments!(clip_to_planes);
    let ends = |part: Option<SpaceSegment>| part.map(|part| part.ends(matrix));
    let reversed = ends(Segments::homogeneous_liang_barsky(to, from, matrix)).map(|(to, from)| (from, to));
    assert_eq!(reversed, ends(default), "{from:?} {to:?}");
    let again = default.and_then(|part| part.clip(&planes));
    assert_eq!(again, default, "{from:?} {to:?}");
    default
}

fn camera(near: i32) -> Camera {
    Camera::new(Rectangle::new(Point::zero(), Size::new(64, 64)), I16F16::from_num(near)).unwrap()
}

/// -z <= x <= z, -z <= y <= z, 8 <= z <= 16, exactly.
fn small_matrix() -> ClipMatrix {
    ClipMatrix::new(&camera(8), &Pose::IDENTITY, I16F16::from_num(16)).unwrap()
}

fn rotation([x, y, z]: [u16; 3]) -> Rotation {
    let angle = U0F16::from_bits;
    Rotation::about_x(angle(x))
        .then(&Rotation::about_y(angle(y)))
        .then(&Rotation::about_z(angle(z)))
}

fn pose(angles: [u16; 3], translation: [i32; 3]) -> Pose {
    Pose::new(rotation(angles), translation.map(I16F16::from_bits))
}

proptest! {
    #![proptest_config(config(cases(3_000, 300_000)))]

    /// Small numbers: ends on planes, at the eye, beside it and behind it, segments through edges and corners of the volume.
    #[test]
    fn segments_around_the_eye(from in prop::array::uniform3(-20i16..=20), to in prop::array::uniform3(-20i16..=20)) {
        check(from, to, &small_matrix());
    }

    #[test]
    fn segments_of_any_model(
        from in any::<Vertex>(),
        to in any::<Vertex>(),
        model in prop::array::uniform3(any::<u16>()),
        at in any::<[i32; 3]>(),
        turn in prop::array::uniform3(any::<u16>()),
        eye in any::<[i32; 3]>(),
        near in 8i32 << 16..8_000 << 16,
        further in 2i32..=4,
        focal_length in 1i32 << 16..=2_047 << 16,
        size in (1u32..=4_094, 1u32..=8_191),
    ) {
        let viewport = Rectangle::new(Point::zero(), Size::new(size.0, size.1));
        let camera = Camera::new(viewport, I16F16::from_bits(near)).unwrap()
            .with_focal_length(I16F16::from_bits(focal_length)).unwrap()
            .with_pose(pose(turn, eye));
        let matrix = ClipMatrix::new(&camera, &pose(model, at), I16F16::from_bits(near * further)).unwrap();
        check(from, to, &matrix);
        // Through what is surely visible.
        let toward = straight_ahead(&camera, &pose(model, at), near);
        if let Some(toward) = toward {
            check(from, toward, &matrix);
        }
    }

    /// Any planes, also those that leave nothing.
    #[test]
    fn segments_in_any_volume(
        from in prop::array::uniform3(-50i16..=50),
        to in prop::array::uniform3(-50i16..=50),
        planes in prop::collection::vec(
            (prop::array::uniform3(-50i16..=50), prop::array::uniform3(-9i32..=9)),
            0..8,
        ),
        scale in prop::sample::select(vec![1i32, 238_609_294, -238_609_294]),
    ) {
        let distance = |vertex: Vertex, point: Vertex, inwards: [i32; 3]| {
            let products = [0, 1, 2].map(|axis: usize| {
                i128::from(inwards[axis]) * i128::from(scale) * i128::from(vertex[axis] - point[axis])
            });
            products.iter().sum::<i128>()
        };
        let distances: Vec<[i128; 2]> = planes
            .iter()
            .map(|&(point, inwards)| [distance(from, point, inwards), distance(to, point, inwards)])
            .collect();
        let volume: Vec<ClipPlane> = planes
            .iter()
            .map(|&(point, inwards)| ClipPlane::through(point, inwards.map(|axis| axis * scale)))
            .collect();
        let part = Segments::cyrus_beck_in_space(from, to, &volume);
        check_against(part, &distances, from, to, &small_matrix());
        // One plane after the other, in the other order.
        let mut one_by_one = Segments::cyrus_beck_in_space(from, to, &[]);
        for plane in volume.iter().rev() {
            one_by_one = one_by_one.and_then(|part| part.clip(&[*plane]));
        }
        prop_assert_eq!(one_by_one, part);
    }
}

/// A vertex of the model that lies straight ahead, some way behind the near plane, if there is one.
fn straight_ahead(camera: &Camera, model: &Pose, near: i32) -> Option<Vertex> {
    let ahead = Pose::new(
        Rotation::IDENTITY,
        [0, 0, near.checked_add(near / 2)?].map(I16F16::from_bits),
    );
    let place = ahead.then(camera.pose()).ok()?.then(&model.inverse().ok()?).ok()?;
    let [x, y, z] = place.translation.map(|axis| axis.checked_to_num::<i16>());
    Some([x?, y?, z?])
}

/// Every segment between points of a grid around the eye and around the corners of the volume.
#[test]
fn every_segment_between_hard_points() {
    let matrix = small_matrix();
    let (plane, depth) = ([-17, -8, 0, 8, 16], [-16, -8, 0, 7, 8, 12, 16, 17]);
    let mut points = Vec::new();
    for x in plane {
        for y in plane {
            points.extend(depth.map(|z| [x, y, z]));
        }
    }
    let (mut visible, mut rejected) = (0, 0);
    for &from in &points {
        for &to in &points {
            match check(from, to, &matrix) {
                Some(_) => visible += 1,
                None => rejected += 1,
            }
        }
    }
    assert!(visible > 5_000 && rejected > 5_000, "{visible} {rejected}");
}

#[test]
fn segments_through_the_eye_and_beside_it() {
    let matrix = small_matrix();
    let vertices = |from, to| check(from, to, &matrix).map(|part| part.vertices());
    // From behind the eye, through it.
    assert_eq!(vertices([0, 0, -100], [0, 0, 100]), Some(([0, 0, 8], [0, 0, 16])));
    assert_eq!(vertices([-30, 0, -30], [30, 0, 30]), Some(([8, 0, 8], [16, 0, 16])));
    // w = 0 at an end, and at both.
    assert_eq!(vertices([0, 0, 0], [0, 0, 10]), Some(([0, 0, 8], [0, 0, 10])));
    assert_eq!(vertices([3, 0, 0], [3, 0, 12]), Some(([3, 0, 8], [3, 0, 12])));
    assert_eq!(vertices([-9, 5, 0], [9, 5, 0]), None);
    assert_eq!(vertices([0, 0, 0], [0, 0, 0]), None);
    // w < 0 at both ends.
    assert_eq!(vertices([0, 0, -9], [1, 1, -12]), None);
    // Within a plane, along an edge, in a corner alone.
    assert_eq!(vertices([-20, 3, 8], [20, 3, 8]), Some(([-8, 3, 8], [8, 3, 8])));
    assert_eq!(
        vertices([-16, -16, 16], [-16, 99, 16]),
        Some(([-16, -16, 16], [-16, 16, 16]))
    );
    assert_eq!(vertices([16, 16, 16], [17, 17, 16]), Some(([16, 16, 16], [16, 16, 16])));
    assert_eq!(vertices([8, 8, 8], [8, 8, 8]), Some(([8, 8, 8], [8, 8, 8])));
}

/// Clipping after the division by w: what is behind the eye has a picture in front of it. The point (60, 0, -30) is behind the
/// eye, but x / w is -2, to the left of the viewport; the segment to it leaves the viewport to the right.
#[test]
fn clipping_after_the_division_fails() {
    let camera = camera(8);
    let matrix = ClipMatrix::new(&camera, &Pose::IDENTITY, I16F16::from_num(1_000)).unwrap();
    let (from, to) = ([0, 0, 30], [60, 0, -30]);
    let (seen, behind) = (matrix.apply(from), matrix.apply(to));
    let divided = |point: ClipPoint| point.x as f64 / point.w as f64;
    assert_eq!((divided(seen), divided(behind)), (0.0, -2.0));
    // Cut at x / w = -1 after the division, the left half of the row is drawn: from the centre, 0, to the left side, -1.
    let wrong = (divided(seen), divided(behind).clamp(-1.0, 1.0));
    assert_eq!(wrong, (0.0, -1.0));
    // It goes to the right side: the segment meets x = w in (15, 0, 15), which is in front of the near plane at 8.
    let part = check(from, to, &matrix).unwrap();
    assert_eq!(part.vertices(), ([0, 0, 30], [15, 0, 15]));
    let (start, end) = part.ends(&matrix);
    assert_eq!((divided(start), divided(end)), (0.0, 1.0));
    // At w = 0 there is nothing to divide by at all.
    assert_eq!(matrix.apply([30, 0, 0]).w, 0);
    assert_eq!(
        check(from, [30, 0, 0], &matrix).unwrap().vertices(),
        ([0, 0, 30], [15, 0, 15])
    );
}
