//! Polygons and their triangles: against a plain test of all pairs of sides and corners in `i128`.

use std::f64::consts::TAU;

use proptest::{collection::vec, prelude::*};
use zrow::{geometry::InputError, scene::FaceSet};

use crate::{
    common::{cases, config},
    reference::wide_product::product,
};

fn way(from: [i16; 3], to: [i16; 3]) -> [i128; 3] {
    [0, 1, 2].map(|axis| i128::from(to[axis]) - i128::from(from[axis]))
}

fn cross([x, y, z]: [i128; 3], [u, v, w]: [i128; 3]) -> [i128; 3] {
    [y * w - z * v, z * u - x * w, x * v - y * u]
}

fn dot(one: [i128; 3], other: [i128; 3]) -> i128 {
    one.into_iter().zip(other).map(|(one, other)| one * other).sum()
}

/// The sum of the triangles of a fan, as vectors.
fn sum_of(triangles: impl Iterator<Item = [[i16; 3]; 3]>) -> [i128; 3] {
    triangles
        .map(|[a, b, c]| cross(way(a, b), way(a, c)))
        .fold([0; 3], |sum, part| [0, 1, 2].map(|axis| sum[axis] + part[axis]))
}

/// What is wrong with a polygon of three corners or more.
fn searched(corners: &[[i16; 3]]) -> Result<(), InputError> {
    let next = |index: usize| corners[(index + 1) % corners.len()];
    let normal = sum_of((1..corners.len()).map(|index| [corners[0], corners[index], next(index)]));
    if normal == [0; 3] {
        return Err(InputError::NotConvex { polygon: 0 });
    }
    // All pairs of corners, and not the highest and the lowest one.
    for from in corners {
        for to in corners {
            let height = dot(normal, way(*from, *to)).unsigned_abs();
            if product(height, height) > (0, dot(normal, normal).unsigned_abs()) {
                return Err(InputError::NotPlanar { polygon: 0 });
            }
        }
    }
    // All corners on the inner side of all sides: those that are not their ends.
    for side in 0..corners.len() {
        let (from, to) = (corners[side], next(side));
        for (index, corner) in corners.iter().enumerate() {
            let is_end = index == side || index == (side + 1) % corners.len();
            if !is_end && dot(cross(way(from, to), way(from, *corner)), normal) <= 0 {
                return Err(InputError::NotConvex { polygon: 0 });
            }
        }
    }
    Ok(())
}

/// Triangulates one polygon of up to nine corners, which are all vertices there are.
fn triangles(corners: &[[i16; 3]]) -> Result<Vec<[u16; 3]>, InputError> {
    let indices: Vec<u16> = (0..).take(corners.len()).collect();
    let polygons = [&indices[..]];
    Ok(match FaceSet::count_triangles(&polygons) {
        0 => FaceSet::triangulate::<0>(corners, &polygons)?.to_vec(),
        1 => FaceSet::triangulate::<1>(corners, &polygons)?.to_vec(),
        2 => FaceSet::triangulate::<2>(corners, &polygons)?.to_vec(),
        3 => FaceSet::triangulate::<3>(corners, &polygons)?.to_vec(),
        4 => FaceSet::triangulate::<4>(corners, &polygons)?.to_vec(),
        5 => FaceSet::triangulate::<5>(corners, &polygons)?.to_vec(),
        6 => FaceSet::triangulate::<6>(corners, &polygons)?.to_vec(),
        7 => FaceSet::triangulate::<7>(corners, &polygons)?.to_vec(),
        8 => FaceSet::triangulate::<8>(corners, &polygons)?.to_vec(),
        count => panic!("{count}"),
    })
}

/// Compares a polygon with the plain test. Returns whether it is one.
fn check(corners: &[[i16; 3]]) -> Result<bool, TestCaseError> {
    let found = triangles(corners);
    prop_assert_eq!(found.clone().map(|_| ()), searched(corners), "{:?}", corners);
    let Ok(found) = found else { return Ok(false) };
    let expected: Vec<[u16; 3]> = (1..)
        .take(corners.len() - 2)
        .map(|index| [0, index, index + 1])
        .collect();
    prop_assert_eq!(found, expected);
    Ok(true)
}

/// Positions on an ellipse in any plane, at ascending angles or not, rounded.
fn around(turns: &[f64], size: [f64; 2], tilt: [f64; 2]) -> Vec<[i16; 3]> {
    let point = |turn: &f64| {
        let (sine, cosine) = (turn * TAU).sin_cos();
        let [x, y] = [size[0] * cosine, size[1] * sine];
        [x, y, tilt[0] * x + tilt[1] * y].map(|part| part.round() as i16)
    };
    turns.iter().map(point).collect()
}

proptest! {
    #![proptest_config(config(cases(4_000, 200_000)))]

    /// Of corners on a small grid every few are a polygon.
    #[test]
    fn polygons_are_checked_exactly(
        corners in vec((-2i16..3, -2i16..3, 0i16..2), 3..6),
        steps in (1i16..4, 1i16..4, 1i16..3),
        is_flat in any::<bool>(),
    ) {
        let z = |z: i16| if is_flat { 0 } else { z * (steps.2 - 1) };
        let stretched = |corner: &(i16, i16, i16)| [corner.0 * steps.0, corner.1 * steps.1, z(corner.2)];
        let corners: Vec<[i16; 3]> = corners.iter().map(stretched).collect();
        check(&corners)?;
    }

    #[test]
    fn polygons_of_any_size_are_checked_exactly(
        mut turns in vec(0.0..1.0f64, 3..9),
        sizes in (1.0..15.0f64, 1.0..15.0f64),
        tilt in (-1.0..1.0f64, -1.0..1.0f64),
        moved in prop::option::of((0usize..9, -3i16..=3)),
        is_sorted in prop::bool::weighted(0.8),
    ) {
        if is_sorted {
            turns.sort_by(f64::total_cmp);
        }
        let mut corners = around(&turns, [2f64.powf(sizes.0), 2f64.powf(sizes.1)], [tilt.0, tilt.1]);
        if let Some((corner, by)) = moved {
            let corner = corner % corners.len();
            corners[corner][2] = corners[corner][2].saturating_add(by);
        }
        check(&corners)?;
    }

    #[test]
    fn corners_anywhere_are_checked_exactly(corners in vec(any::<[i16; 3]>(), 3..7)) {
        check(&corners)?;
    }
}

#[test]
fn polygons_of_the_greatest_size_are_some() {
    const LEAST: i16 = i16::MIN;
    const MOST: i16 = i16::MAX;
    let square = [
        [LEAST, LEAST, MOST],
        [LEAST, MOST, MOST],
        [MOST, MOST, LEAST],
        [MOST, LEAST, LEAST],
    ];
    assert!(check(&square).unwrap());
    let turns: Vec<f64> = (0..9).map(|corner| f64::from(corner) / 9.0).collect();
    assert!(check(&around(&turns, [32_000.0; 2], [0.3, -0.7])).unwrap());
}

#[test]
fn what_is_not_convex_is_named() {
    let at = |points: &[[i16; 2]]| points.iter().map(|&[x, y]| [x, y, 7]).collect::<Vec<_>>();
    let star: Vec<f64> = (0..5).map(|corner| f64::from(2 * corner) / 5.0).collect();
    let twice: Vec<f64> = (0..6).map(|corner| f64::from(corner % 3) / 3.0).collect();
    // Each corner turns the same way, and each triangle of the fan has the same sense, but it goes around twice.
    let mut spiral: Vec<f64> = (0..8).map(|corner| f64::from(corner) * 1.4 / 8.0).collect();
    spiral.insert(0, 0.7);
    let mut spiral = around(&spiral, [900.0; 2], [0.0; 2]);
    spiral[0] = [0, 0, 0];
    for corners in [
        around(&star, [900.0; 2], [0.2, 0.1]),
        around(&twice, [900.0; 2], [0.0; 2]),
        spiral,
        at(&[[0, 0], [9, 9], [9, 0], [0, 9]]),
        at(&[[0, 0], [0, 9], [3, 3], [9, 0]]),
        at(&[[0, 0], [0, 9], [0, 18], [9, 0]]),
        at(&[[0, 0], [0, 9], [0, 9], [9, 0]]),
        at(&[[0, 0], [0, 9], [0, 18]]),
        at(&[[4, 4], [4, 4], [4, 4]]),
    ] {
        assert_eq!(
            triangles(&corners),
            Err(InputError::NotConvex { polygon: 0 }),
            "{corners:?}"
        );
        assert!(!check(&corners).unwrap());
    }
    for corners in [&[][..], &[[0; 3]], &[[0, 0, 0], [5, 0, 0]]] {
        assert_eq!(triangles(corners), Err(InputError::NotConvex { polygon: 0 }));
    }
}

/// Of a square with one corner lifted the plane lifts a quarter, so that all are beside it by a quarter of that.
#[test]
fn corners_may_be_half_a_unit_beside_the_plane() {
    for size in [5, 100, 32_000] {
        let lifted = |by| triangles(&[[0, 0, 0], [0, size, 0], [size, size, by], [size, 0, 0]]);
        assert!([0, 1, 2].iter().all(|by| lifted(*by).is_ok()), "{size}");
        assert_eq!(lifted(3), Err(InputError::NotPlanar { polygon: 0 }), "{size}");
    }
}

#[test]
fn errors_name_the_polygon_and_the_number() {
    const VERTICES: [[i16; 3]; 5] = [[0, 0, 0], [0, 9, 0], [9, 9, 0], [9, 0, 0], [4, 4, 9]];
    let first: &[u16] = &[0, 1, 2, 3];
    let of = |second| FaceSet::triangulate::<3>(&VERTICES, &[first, second]);
    assert_eq!(of(&[3, 2, 4]), Ok([[0, 1, 2], [0, 2, 3], [3, 2, 4]]));
    assert_eq!(
        of(&[3, 5, 9, 6]),
        Err(InputError::IndexOutOfRange { face: 1, vertex: 9 })
    );
    assert_eq!(of(&[3, 1, 3]), Err(InputError::NotConvex { polygon: 1 }));
    assert_eq!(of(&[3, 2, 4, 0]), Err(InputError::NotPlanar { polygon: 1 }));
    assert_eq!(of(&[0, 1, 2, 3]), Err(InputError::NumberOfFaces { needed: 4 }));
    let none = FaceSet::triangulate::<3>(&VERTICES, &[first]);
    assert_eq!(none, Err(InputError::NumberOfFaces { needed: 2 }));
    // The errors of polygons come first.
    let none = FaceSet::triangulate::<0>(&VERTICES, &[first, &[1, 1, 1]]);
    assert_eq!(none, Err(InputError::NotConvex { polygon: 1 }));
    assert_eq!(FaceSet::triangulate::<0>(&[], &[]), Ok([]));
    assert_eq!(FaceSet::count_triangles(&[first, &[], &[1], &[1, 2], first]), 4);
}
