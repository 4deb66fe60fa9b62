//! Faces that are cut in space: what is left is what the rays of the pixels see, with its attributes, by both clippers.

use core::convert::Infallible;
use std::collections::BTreeSet;

use embedded_graphics::{prelude::*, primitives::Rectangle};
use fixed::types::I16F16;
use proptest::prelude::*;
use zrow::{
    clip::{ClipMatrix, ClipPoint},
    draw::FillRule,
    geometry::{Sub8, SubPoint, Window},
    scan::Polygons,
    scene::{Camera, Pose},
};

use crate::{
    common::{cases, config},
    reference::seen_pixels::Eye,
};

const EYE: Eye = Eye {
    size: [40, 24],
    focal_length: 20,
    depths: [8, 4_000],
};

const WINDOW: Window = Window {
    left: 0,
    top: 0,
    right: EYE.size[0],
    bottom: EYE.size[1],
};

fn camera() -> Camera {
    let viewport = Rectangle::new(Point::zero(), Size::new(EYE.size[0] as u32, EYE.size[1] as u32));
    let camera = Camera::new(viewport, I16F16::from_num(EYE.depths[0])).unwrap();
    camera.with_focal_length(I16F16::from_num(EYE.focal_length)).unwrap()
}

fn matrix() -> ClipMatrix {
    ClipMatrix::new(&camera(), &Pose::IDENTITY, I16F16::from_num(EYE.depths[1])).unwrap()
}

type Triangle = [[i16; 3]; 3];
/// A polygon with the weight of each vertex in its corners.
type Polygon = Vec<(ClipPoint, [i32; 3])>;

const WHOLE: i32 = 1 << 24;

/// What both clippers leave of a face, with attributes that are weights of its vertices.
fn clipped(triangle: Triangle) -> Vec<(&'static str, Polygon)> {
    let [a, b, c] = triangle;
    let face = [(a, [WHOLE, 0, 0]), (b, [0, WHOLE, 0]), (c, [0, 0, WHOLE])];
    macro_rules! clip_by_each {
        ($([$name:ident] [$($clip:tt)+])+) => {
            vec![$((stringify!($name), $($clip)+::<3>(&matrix(), &face).to_vec())),+]
        };
    }
    zrow_methods::space_polygons!(clip_by_each)
}

/// The corners on the screen.
fn on_screen(polygon: &[(ClipPoint, [i32; 3])]) -> Vec<SubPoint<Sub8>> {
    let corners = polygon.iter();
    corners
        .map(|(point, _)| point.on_screen(&camera()).expect("a visible corner has a position"))
        .collect()
}

fn pixels(corners: &[SubPoint<Sub8>]) -> BTreeSet<[i32; 2]> {
    let mut pixels = BTreeSet::new();
    let done = Polygons::scanline::<_, Infallible, 16>(&[corners], FillRule::NonZero, &WINDOW, |span| {
        pixels.extend((span.start..span.end).map(|x| [x, span.y]));
        Ok(())
    });
    assert!(done.is_ok());
    pixels
}

/// Checks that a polygon has the pixels that see the triangle; returns how many are sure to.
fn check_pixels(triangle: Triangle, pixels: &BTreeSet<[i32; 2]>, name: &str) -> usize {
    let mut seen = 0;
    for y in 0..EYE.size[1] {
        for x in 0..EYE.size[0] {
            if let Some(sees) = EYE.sees(triangle, [x, y]) {
                assert_eq!(pixels.contains(&[x, y]), sees, "{name}: {triangle:?} at {x}, {y}");
                seen += usize::from(sees);
            }
        }
    }
    seen
}

/// Whether a point is visible, but for the rounding of its coordinates in units of the matrix.
fn assert_inside(point: &ClipPoint, most: i64) {
    let ClipPoint { x, y, z, w } = *point;
    assert!(
        x.abs() <= w + most && y.abs() <= w + most && z >= -most && z <= w + most,
        "{point:?}"
    );
}

/// Whether a corner is where its attributes say: the mean of the vertices by their weights, but for the rounding of the
/// weights.
fn assert_weighted(triangle: Triangle, point: &ClipPoint, weights: [i32; 3], most: i64) {
    let sum: i32 = weights.iter().sum();
    assert!(
        (sum - WHOLE).abs() <= 8 && weights.iter().all(|weight| (-4..=WHOLE + 4).contains(weight)),
        "{weights:?}"
    );
    let vertices = triangle.map(|vertex| matrix().apply(vertex));
    let axes: [fn(&ClipPoint) -> i64; 4] = [|point| point.x, |point| point.y, |point| point.z, |point| point.w];
    for axis in axes {
        let terms = vertices.iter().zip(weights);
        let mean: i128 = terms
            .map(|(vertex, weight)| i128::from(axis(vertex)) * i128::from(weight))
            .sum();
        let largest = vertices.iter().map(|vertex| axis(vertex).unsigned_abs()).max().unwrap();
        let off = (mean / i128::from(WHOLE) - i128::from(axis(point))).unsigned_abs();
        assert!(
            off <= u128::from(largest >> 20) + most as u128,
            "{triangle:?} {point:?} {weights:?}"
        );
    }
}

fn check(triangle: Triangle) -> usize {
    let mut seen = Vec::new();
    for (name, polygon) in clipped(triangle) {
        for (point, weights) in &polygon {
            // Rounding to 1/65,536 of the vertices' unit, times a row of the matrix.
            let most = if name == "sutherland_hodgman" { 8 } else { 1 << 26 };
            assert_inside(point, most);
            assert_weighted(triangle, point, *weights, most);
        }
        let corners = on_screen(&polygon);
        seen.push(check_pixels(triangle, &pixels(&corners), name));
        assert!(
            polygon.is_empty() || polygon.len() >= 3 || seen.ends_with(&[0]),
            "{polygon:?}"
        );
    }
    seen[0]
}

proptest! {
    #![proptest_config(config(cases(120, 1_500)))]

    #[test]
    fn faces_around_the_eye(triangle in prop::array::uniform3(prop::array::uniform3(-40i16..=40))) {
        check(triangle);
    }

    #[test]
    fn faces_anywhere(triangle in prop::array::uniform3(prop::array::uniform3(any::<i16>()))) {
        check(triangle);
    }
}

#[test]
fn hard_faces() {
    let faces = [
        // A floor around the eye, to all sides.
        [[-3_000, -5, -3_000], [3_000, -5, -3_000], [0, -5, 3_900]],
        // One vertex behind the eye, two, and one exactly beside it.
        [[-30, -10, 40], [30, -10, 40], [0, 20, -40]],
        [[-30, -10, -40], [30, -10, -40], [0, 2, 40]],
        [[-30, 10, 0], [30, 10, 60], [0, -20, 60]],
        // All of the viewport.
        [[-30_000, -30_000, 100], [30_000, -30_000, 100], [0, 30_000, 100]],
        // Across the far plane.
        [[-300, -300, 3_000], [300, -300, 3_000], [0, 300, 9_000]],
        // A vertex on the near plane, an edge on it.
        [[0, 0, 8], [10, 0, 20], [0, 10, 20]],
        [[-4, -4, 8], [4, -4, 8], [0, 10, 30]],
    ];
    for face in faces {
        assert!(check(face) > 0, "{face:?}");
        assert!(check([face[2], face[1], face[0]]) > 0, "{face:?}");
    }
    let unseen = [
        [[-30, -10, -40], [30, -10, -40], [0, 20, -10]],
        [[-30, -10, 0], [30, -10, 0], [0, 20, 0]],
        [[0, 0, 0], [0, 0, 0], [0, 0, 0]],
        // Through the eye: its plane is seen from the edge.
        [[-30, 0, -40], [30, 0, 40], [30, 0, 90]],
    ];
    for face in unseen {
        assert_eq!(check(face), 0, "{face:?}");
    }
}

/// Two faces with a common edge have the same corners on it, whichever way round they name it.
#[test]
fn faces_that_share_an_edge_are_cut_in_the_same_points() {
    let (a, b) = ([-70, 13, 90], [31, -8, -55]);
    for (name, clip) in [("this way", [a, b, [0, 50, 60]]), ("that way", [b, a, [0, -90, 60]])]
        .map(|(name, face)| (name, clipped(face)))
    {
        for (method, polygon) in clip {
            let points: Vec<ClipPoint> = polygon.iter().map(|(point, _)| *point).collect();
            let shared = clipped([a, b, [7, 60, 70]]);
            let other = &shared.iter().find(|(other, _)| *other == method).unwrap().1;
            let common = other.iter().filter(|(point, _)| points.contains(point)).count();
            assert!(common >= 1, "{method}, {name}");
        }
    }
}

/// Clipping after the division: the corner behind the eye has a picture upside down, and what is filled is another triangle.
///
/// The face's corners are (-20, -4, 20), (20, -4, 20) and (0, -4, -20): a floor below the eye. Divided, they are at x/w = -1, 1
/// and 0, and at y/w = -1/3, -1/3 and 1/3 of a viewport that is 24 of 40 pixels high: the third one is above the horizon, where
/// there is no floor.
#[test]
fn clipping_after_the_division_fails() {
    let triangle = [[-20, -4, 20], [20, -4, 20], [0, -4, -20]];
    let divided = |vertex: [i16; 3]| {
        let ClipPoint { x, y, w, .. } = matrix().apply(vertex);
        [x, y].map(|axis| (axis as f64 / w as f64 * 3.0).round())
    };
    assert_eq!(triangle.map(divided), [[-3.0, -1.0], [3.0, -1.0], [0.0, 1.0]]);
    // Where the three pictures are, in units of the viewport of 40 x 24 pixels: the wrong triangle.
    let position = |x: i32, y: i32| SubPoint::<Sub8>::from_units(x * 256 - 128, y * 256 - 128).unwrap();
    let wrong = pixels(&[position(0, 16), position(40, 16), position(20, 8)]);
    let (_, right) = &clipped(triangle)[0];
    let right = pixels(&on_screen(right));
    assert!(check(triangle) > 0);
    // The floor is below row 16, where it is 20 away: not one pixel is common.
    assert!(right.iter().all(|[_, y]| *y >= 16) && wrong.iter().all(|[_, y]| *y < 16));
    assert!(
        right.len() > 100 && wrong.len() > 100,
        "{} {}",
        right.len(),
        wrong.len()
    );
}
