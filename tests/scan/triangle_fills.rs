//! All ways to fill a triangle against winding numbers in `i128`, and so against each other.

use embedded_graphics::prelude::*;
use fixed::types::{I12F4, I24F8};
use proptest::prelude::*;
use zrow::{
    band::Span,
    geometry::{Sub4, Sub8, SubPixel, SubPoint, Window},
    scan::FillRule,
};

use crate::{
    common::{by_depth, cases, config, outlines::star},
    every_fill::{Pixels, Snapped, check_triangle, triangle_fills, window},
    reference::winding_numbers::{Units, filled_pixels},
};

fn triangle(low: i32, high: i32) -> impl Strategy<Value = [Units; 3]> {
    let vertex = || (low..=high, low..=high);
    [vertex(), vertex(), vertex()]
}

/// Three vertices nearly on a line.
fn sliver(side: i32) -> impl Strategy<Value = [Units; 3]> {
    let end = || (-side / 4..side * 5 / 4, -side / 4..side * 5 / 4);
    (end(), end(), 0..=16i32, (-2..=2i32, -2..=2i32)).prop_map(|(a, b, part, (x, y))| {
        let between = |from: i32, to: i32| from + (to - from) * part / 16;
        [a, b, (between(a.0, b.0) + x, between(a.1, b.1) + y)]
    })
}

proptest! {
    #![proptest_config(config(cases(75, 700)))]

    #[test]
    fn triangles_of_sixteenths_are_the_same(vertices in prop_oneof![triangle(-200, 900), triangle(-100, 100), sliver(700)]) {
        check_triangle::<Sub4>(vertices, window());
    }

    #[test]
    fn triangles_of_256ths_are_the_same(vertices in prop_oneof![triangle(-3000, 14_000), triangle(0, 3000), sliver(11_000)]) {
        check_triangle::<Sub8>(vertices, window());
    }

    #[test]
    fn triangles_with_vertices_on_pixel_centres_are_the_same(vertices in prop_oneof![triangle(-4, 48), triangle(4, 16)]) {
        check_triangle::<Sub4>(vertices.map(|(x, y)| (x * 16, y * 16)), window());
        check_triangle::<Sub8>(vertices.map(|(x, y)| (x * 256, y * 256)), window());
    }

    #[test]
    fn triangles_to_the_ends_of_the_domain_are_the_same(fine in triangle(Sub8::MIN_UNITS, Sub8::MAX_UNITS), coarse in triangle(Sub4::MIN_UNITS, Sub4::MAX_UNITS)) {
        check_triangle::<Sub8>(fine, window());
        check_triangle::<Sub4>(coarse, window());
    }
}

/// The corners of the domain, and what lies between them, in windows where an edge function takes more than 32 bits.
#[test]
fn the_largest_triangles_are_the_same() {
    let ends = [Sub8::MIN_UNITS, Sub8::MIN_UNITS + 1, 77, Sub8::MAX_UNITS];
    let corners: Vec<Units> = ends.iter().flat_map(|&x| ends.iter().map(move |&y| (x, y))).collect();
    let rows = |top, height| Window {
        left: -8200,
        top,
        right: 8200,
        bottom: top + height,
    };
    let column = Window {
        left: -3,
        top: -8200,
        right: 5,
        bottom: 8200,
    };
    for (index, &a) in corners.iter().enumerate().step_by(by_depth(3, 1, 1)) {
        for &b in &corners[index + 1..] {
            for &c in corners.iter().step_by(by_depth(11, 3, 1)) {
                for window in [rows(-8192, 2), rows(-1, 3), column] {
                    // The scan line is checked above, also for large ones.
                    let fills = triangle_fills::<Sub8>([a, b, c].map(SubPoint::of), &window);
                    let expected = &fills[0].1;
                    for (name, pixels) in &fills[1..] {
                        assert!(pixels == expected, "{name}: {:?} in {window:?}", [a, b, c]);
                    }
                }
            }
        }
    }
}

/// Coordinates that no constructor makes: any pixels or none, in the window, and no panic.
#[test]
fn triangles_beyond_the_domain_end() {
    let ends = [i32::MIN, -1, i32::MAX];
    let everything = Window {
        left: i32::MIN,
        top: i32::MIN,
        right: i32::MAX,
        bottom: i32::MAX,
    };
    for index in 0..729usize {
        let end = |digit: u32| ends[index / 3usize.pow(digit) % 3];
        let fine = |digit| SubPoint::<Sub8> {
            x: I24F8::from_bits(end(digit)),
            y: I24F8::from_bits(end(digit + 1)),
        };
        let coarse = |digit| SubPoint::<Sub4> {
            x: I12F4::from_bits(end(digit) as i16),
            y: I12F4::from_bits((end(digit + 1) >> 16) as i16),
        };
        for window in [everything, window(), Window::EMPTY] {
            let (fine, coarse) = ([fine(0), fine(2), fine(4)], [coarse(0), coarse(2), coarse(4)]);
            macro_rules! fill {
                ($([$name:ident] [$($fill:tt)+])+) => {
                    $(
                        let _ = $($fill)+(fine, &window, |span| first_only(span, &window));
                        let _ = $($fill)+(coarse, &window, |span| first_only(span, &window));
                    )+
                };
            }
            zrow_methods::triangles!(fill);
        }
    }
}

/// Stops at the first span.
fn first_only(span: Span, window: &Window) -> Result<(), ()> {
    assert!(window.contains(Point::new(span.start, span.y)));
    Err(())
}

/// Each pixel of a fan belongs to one triangle: no gaps, and none twice.
#[test]
fn triangles_of_a_fan_share_no_pixel() {
    let rim = star(11, 1);
    let hub = (5301, 6250);
    let whole = filled_pixels(std::slice::from_ref(&rim), 8, FillRule::NonZero, &window());
    for way in 0..5 {
        let mut drawn = Pixels::new();
        for (index, &corner) in rim.iter().enumerate() {
            let mut face = [hub, corner, rim[(index + 1) % rim.len()]];
            face.rotate_left(index % 3);
            if index % 2 == 0 {
                face.reverse();
            }
            let fills = triangle_fills::<Sub8>(face.map(SubPoint::of), &window());
            let (_, pixels) = &fills[way];
            drawn.extend(pixels);
        }
        drawn.sort_unstable();
        assert_eq!(drawn, whole);
    }
}
