//! Triangles in homogeneous coordinates without clipping: the pixels whose rays meet them, which are those of what clipping
//! leaves.

use core::convert::Infallible;
use std::collections::BTreeSet;

use embedded_graphics::{prelude::*, primitives::Rectangle};
use fixed::types::I16F16;
use proptest::prelude::*;
use zrow::{
    clip::{ClipMatrix, ClipPoint},
    geometry::Window,
    scan::Polygons,
    scene::{Camera, Pose},
};

use crate::{
    common::{cases, config},
    reference::seen_pixels::Eye,
};

type Triangle = [[i16; 3]; 3];
type Pixels = BTreeSet<[i32; 2]>;

const EYE: Eye = Eye {
    size: [40, 24],
    focal_length: 20,
    depths: [8, 4_000],
};

fn camera(eye: &Eye) -> Camera {
    let viewport = Rectangle::new(Point::zero(), Size::new(eye.size[0] as u32, eye.size[1] as u32));
    let camera = Camera::new(viewport, I16F16::from_num(eye.depths[0])).unwrap();
    camera.with_focal_length(I16F16::from_num(eye.focal_length)).unwrap()
}

fn pixels_in(corners: [ClipPoint; 3], camera: &Camera, window: &Window) -> Pixels {
    let mut pixels = BTreeSet::new();
    let mut last = i32::MIN;
    let Ok(()) = Polygons::homogeneous_triangle(corners, camera, window, |span| {
        assert!(span.y > last && span.start < span.end, "{span:?} after row {last}");
        last = span.y;
        pixels.extend((span.start..span.end).map(|x| [x, span.y]));
        Ok::<(), Infallible>(())
    });
    pixels
}

fn corners(triangle: Triangle, eye: &Eye) -> [ClipPoint; 3] {
    let matrix = ClipMatrix::new(&camera(eye), &Pose::IDENTITY, I16F16::from_num(eye.depths[1])).unwrap();
    triangle.map(|vertex| matrix.apply(vertex))
}

fn pixels(triangle: Triangle, eye: &Eye) -> Pixels {
    let camera = camera(eye);
    pixels_in(corners(triangle, eye), &camera, &camera.viewport())
}

/// Checks every pixel whose ray is clear about it; returns how many see the triangle.
fn check(triangle: Triangle, eye: &Eye) -> usize {
    let pixels = pixels(triangle, eye);
    let [a, b, c] = triangle;
    for order in [[b, c, a], [c, b, a]] {
        assert_eq!(self::pixels(order, eye), pixels, "{triangle:?} in the order {order:?}");
    }
    let mut seen = 0;
    for y in 0..eye.size[1] {
        for x in 0..eye.size[0] {
            if let Some(sees) = eye.sees(triangle, [x, y]) {
                assert_eq!(pixels.contains(&[x, y]), sees, "{triangle:?} at {x}, {y}");
                seen += usize::from(sees);
            }
        }
    }
    seen
}

proptest! {
    #![proptest_config(config(cases(150, 2_000)))]

    #[test]
    fn triangles_around_the_eye(triangle in prop::array::uniform3(prop::array::uniform3(-40i16..=40))) {
        check(triangle, &EYE);
    }

    #[test]
    fn triangles_anywhere(triangle in prop::array::uniform3(prop::array::uniform3(any::<i16>()))) {
        check(triangle, &EYE);
    }

    /// The two halves of a parallelogram, wherever it lies: no pixel twice. In front of the near plane the other diagonal gives
    /// the same pixels, so that none is left out.
    #[test]
    fn halves_of_a_parallelogram_fit(
        a in prop::array::uniform3(-60i16..=60),
        b in prop::array::uniform3(-60i16..=60),
        c in prop::array::uniform3(-60i16..=60),
        away in prop::sample::select(vec![0i16, 200]),
    ) {
        let [a, b, c] = [a, b, c].map(|[x, y, z]| [x, y, z + away]);
        let d = [0, 1, 2].map(|axis: usize| a[axis] + c[axis] - b[axis]);
        let both = |one, other| {
            let (one, other) = (pixels(one, &EYE), pixels(other, &EYE));
            assert!(one.is_disjoint(&other), "{one:?} {other:?}");
            &one | &other
        };
        let this = both([a, b, c], [a, c, d]);
        let that = both([a, b, d], [b, c, d]);
        if away != 0 {
            prop_assert_eq!(this, that);
        }
    }

    #[test]
    fn any_numbers_do_not_wrap(
        numbers in prop::array::uniform12(prop_oneof![any::<i64>(), -3i64..=3, Just(i64::MIN), Just(i64::MAX)]),
        size in (1u32..=4_094, 1u32..=16_000),
        left in -8_191i32..0,
    ) {
        let camera = Camera::new(Rectangle::new(Point::new(left, -8_000), Size::new(size.0, size.1)), I16F16::from_num(8)).unwrap();
        let [x, y, z, w] = [0, 1, 2, 3];
        let corner = |first: usize| ClipPoint {
            x: numbers[first + x],
            y: numbers[first + y],
            z: numbers[first + z],
            w: numbers[first + w],
        };
        // The first and the last pixel: a window of all of it would take too long.
        let Window { left, top, right, bottom } = camera.viewport();
        for window in [
            Window { left, top, right: left + 1, bottom: top + 1 },
            Window { left: right - 1, top: bottom - 1, right, bottom },
            Window { left: i32::MIN, top, right: i32::MAX, bottom: top + 1 },
        ] {
            pixels_in([corner(0), corner(4), corner(8)], &camera, &window);
        }
    }
}

#[test]
fn hard_triangles() {
    let seen = [
        [[-3_000, -5, -3_000], [3_000, -5, -3_000], [0, -5, 3_900]],
        [[-30, -10, 40], [30, -10, 40], [0, 20, -40]],
        [[-30, -10, -40], [30, -10, -40], [0, 2, 40]],
        [[-30, 10, 0], [30, 10, 60], [0, -20, 60]],
        [[-30_000, -30_000, 100], [30_000, -30_000, 100], [0, 30_000, 100]],
        [[-300, -300, 3_000], [300, -300, 3_000], [0, 300, 9_000]],
        [[0, 0, 8], [10, 0, 20], [0, 10, 20]],
        [[-4, -4, 8], [4, -4, 8], [0, 10, 30]],
    ];
    for triangle in seen {
        assert!(check(triangle, &EYE) > 0, "{triangle:?}");
    }
    let unseen = [
        [[-30, -10, -40], [30, -10, -40], [0, 20, -10]],
        [[-30, -10, 0], [30, -10, 0], [0, 20, 0]],
        [[-2, -2, 4], [2, -2, 4], [0, 2, 7]],
        [[-5_000, -5_000, 4_001], [5_000, -5_000, 4_001], [0, 9_000, 4_001]],
        [[0, 0, 0], [0, 0, 0], [0, 0, 0]],
        [[-30, 0, -40], [30, 0, 40], [30, 0, 90]],
    ];
    for triangle in unseen {
        assert_eq!(check(triangle, &EYE), 0, "{triangle:?}");
    }
}

/// A viewport with other sides, and the largest one with the coarsest corners, in a few rows.
#[test]
fn windows_show_their_part() {
    let eye = Eye {
        size: [33, 50],
        focal_length: 61,
        depths: [9, 300],
    };
    let triangle = [[-90, -40, -20], [100, 3, 250], [-50, 99, 120]];
    assert!(check(triangle, &eye) > 0);
    let all = pixels(triangle, &eye);
    let window = Window {
        left: -7,
        top: 20,
        right: 21,
        bottom: 24,
    };
    let part = pixels_in(corners(triangle, &eye), &camera(&eye), &window);
    let expected: Pixels = all
        .into_iter()
        .filter(|[x, y]| *x < 21 && (20..24).contains(y))
        .collect();
    assert_eq!(part, expected);
    assert!(pixels_in(corners(triangle, &eye), &camera(&eye), &Window::EMPTY).is_empty());
}
