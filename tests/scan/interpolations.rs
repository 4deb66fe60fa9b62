//! All ways to interpolate attributes over triangles and convex polygons, by the registry, against exact rationals.

use std::convert::Infallible;

use proptest::prelude::*;
use zrow::{
    geometry::{Sub4, Sub8, SubPixel, SubPoint, Window},
    scan::FillRule,
};

use crate::{
    common::{cases, config},
    every_fill::{Snapped, window},
    reference::winding_numbers::{Units, filled_pixels},
};

/// A corner in units, and its attributes.
type Corner = (Units, [i16; 2]);
/// Row and column of a pixel, and its attributes.
type Pixel = ((i32, i32), [i16; 2]);

/// The pixels of a polygon with their attributes, row by row, by each algorithm of the registry.
fn by_each<S: SubPixel>(corners: &[Corner], window: &Window) -> Vec<(&'static str, Vec<Pixel>)>
where
    SubPoint<S>: Snapped,
{
    let corners: Vec<_> = corners
        .iter()
        .map(|(units, attributes)| (SubPoint::<S>::of(*units), *attributes))
        .collect();
    macro_rules! interpolate {
        ($([$name:ident] [$($interpolate:tt)+])+) => {
            vec![$({
                let mut pixels = Vec::new();
                let Ok(()) = $($interpolate)+(&corners, window, |pixel, attributes| {
                    pixels.push(((pixel.y, pixel.x), attributes));
                    Ok::<(), Infallible>(())
                });
                pixels.sort_unstable();
                (stringify!($name), pixels)
            }),+]
        };
    }
    zrow_methods::interpolations!(interpolate)
}

/// An attribute at a pixel as a rational with a positive denominator, by edges and spans, and its slope along the row over the
/// same denominator, in attributes a unit.
struct Exact {
    numerator: i128,
    denominator: i128,
    slope: i128,
    /// The attributes where the row meets both edges: numerators and denominators.
    ends: [(i128, i128); 2],
}

/// The exact attribute at a point of a convex polygon, in units.
fn exact(corners: &[Corner], attribute: usize, (x, y): Units) -> Exact {
    let (x, y) = (i128::from(x), i128::from(y));
    let wide = |((x, y), attributes): Corner| (i128::from(x), i128::from(y), i128::from(attributes[attribute]));
    let mut edges: Vec<_> = (0..corners.len())
        .filter_map(|index| {
            let (from, to) = (wide(corners[index]), wide(corners[(index + 1) % corners.len()]));
            let (top, bottom) = if from.1 < to.1 { (from, to) } else { (to, from) };
            let height = bottom.1 - top.1;
            let at = |top: i128, bottom_value: i128, top_y: i128| top * (bottom.1 - y) + bottom_value * (y - top_y);
            // Where the row crosses it, its attribute there, each over the height.
            (top.1 <= y && y < bottom.1).then(|| (at(top.0, bottom.0, top.1), at(top.2, bottom.2, top.1), height))
        })
        .collect();
    assert_eq!(edges.len(), 2, "{corners:?} {x} {y}");
    edges.sort_by(|one, other| (one.0 * other.2).cmp(&(other.0 * one.2)));
    let [(left_x, left, left_height), (right_x, right, right_height)] = edges[..] else {
        unreachable!()
    };
    Exact {
        numerator: left * (right_x - x * right_height) + right * (x * left_height - left_x),
        denominator: right_x * left_height - left_x * right_height,
        slope: right * left_height - left * right_height,
        ends: [(left, left_height), (right, right_height)],
    }
}

/// The exact attribute at a point of a triangle as a rational with a positive denominator: by areas.
fn exact_in_triangle(corners: &[Corner], attribute: usize, point: Units) -> (i128, i128) {
    let area = |a: Units, b: Units, c: Units| {
        let way = |from: i32, to: i32| i128::from(to) - i128::from(from);
        way(a.0, b.0) * way(a.1, c.1) - way(a.1, b.1) * way(a.0, c.0)
    };
    let [(a, of_a), (b, of_b), (c, of_c)] = corners[..] else {
        unreachable!()
    };
    let of = |attributes: [i16; 2]| i128::from(attributes[attribute]);
    let sum = area(point, b, c) * of(of_a) + area(a, point, c) * of(of_b) + area(a, b, point) * of(of_c);
    let whole = area(a, b, c);
    (sum * whole.signum(), whole.abs())
}

/// Holds attributes by edges and spans against exact ones; returns how many were too steep for one unit.
fn check_edges_and_spans(corners: &[Corner], pixels: &[Pixel], bits: u32) -> usize {
    let mut steep = 0;
    for ((y, x), attributes) in pixels {
        for (index, &found) in attributes.iter().enumerate() {
            let exact = exact(corners, index, (x << bits, y << bits));
            let found = i128::from(found);
            let case = || format!("{corners:?} {x} {y} {found} {}/{}", exact.numerator, exact.denominator);
            // A row may end where it begins.
            if exact.denominator > 0 && exact.slope.abs() <= exact.denominator << 15 {
                assert!(
                    (found * exact.denominator - exact.numerator).abs() < exact.denominator,
                    "{}",
                    case()
                );
            } else {
                steep += 1;
                assert!(
                    exact.ends.iter().any(|(end, height)| found * height > end - height),
                    "{}",
                    case()
                );
                assert!(
                    exact.ends.iter().any(|(end, height)| found * height < end + height),
                    "{}",
                    case()
                );
            }
        }
    }
    steep
}

/// Holds a triangle against exact rationals.
fn check_triangle<S: SubPixel>(corners: [Corner; 3], window: &Window) -> usize
where
    SubPoint<S>: Snapped,
{
    let bits = S::FRACTION_BITS;
    let contours = [corners.map(|(units, _)| units).to_vec()];
    let expected = filled_pixels(&contours, bits, FillRule::NonZero, window);
    let all = by_each::<S>(&corners, window);
    assert_eq!(all.len(), 3);
    for (name, pixels) in &all {
        let found: Vec<_> = pixels.iter().map(|(pixel, _)| *pixel).collect();
        assert!(found == expected, "{name} {corners:?}");
        // How far an attribute may be from the exact one, in quarters of a unit.
        let most = match *name {
            "plane_interpolation" => 3,
            "barycentric_interpolation" => 2,
            "edge_and_span_interpolation" => continue,
            _ => panic!("{name} has no bound"),
        };
        for ((y, x), attributes) in pixels {
            for (index, &found) in attributes.iter().enumerate() {
                let (numerator, denominator) = exact_in_triangle(&corners, index, (x << bits, y << bits));
                let error = (i128::from(found) * denominator - numerator).abs();
                assert!(4 * error <= most * denominator, "{name} {corners:?} {x} {y} {found}");
            }
        }
    }
    let (_, by_edges) = all
        .iter()
        .find(|(name, _)| *name == "edge_and_span_interpolation")
        .unwrap();
    check_edges_and_spans(&corners, by_edges, bits)
}

fn attributes() -> impl Strategy<Value = [i16; 2]> {
    let one = || prop_oneof![any::<i16>(), Just(i16::MIN), Just(i16::MAX), -3i16..300];
    [one(), one()]
}

fn triangle(low: i32, high: i32) -> impl Strategy<Value = [Corner; 3]> {
    let corner = || ((low..=high, low..=high), attributes());
    [corner(), corner(), corner()]
}

/// Three vertices nearly on a line.
fn sliver(side: i32) -> impl Strategy<Value = [Corner; 3]> {
    let end = || (-side / 4..side * 5 / 4, -side / 4..side * 5 / 4);
    let of_corners = [attributes(), attributes(), attributes()];
    (end(), end(), 0..=16i32, (-2..=2i32, -2..=2i32), of_corners).prop_map(
        |(a, b, part, (x, y), [of_a, of_b, of_c])| {
            let between = |from: i32, to: i32| from + (to - from) * part / 16;
            [
                (a, of_a),
                (b, of_b),
                ((between(a.0, b.0) + x, between(a.1, b.1) + y), of_c),
            ]
        },
    )
}

/// A polygon of 4 to 7 corners around a point, in either order; convex but for what rounding does.
fn convex(unit: i32) -> impl Strategy<Value = Vec<Corner>> {
    let corners = prop::collection::vec((any::<u16>(), attributes()), 4..=7);
    let radii = (unit..30 * unit, unit..30 * unit);
    (corners, radii, (0..40 * unit, 0..40 * unit), any::<bool>()).prop_map(|(mut corners, radii, middle, reversed)| {
        corners.sort_unstable();
        let mut corners: Vec<_> = corners
            .into_iter()
            .map(|(angle, attributes)| {
                let angle = f64::from(angle) / 65_536.0 * std::f64::consts::TAU;
                let at = |middle: i32, radius: i32, part: f64| middle + (f64::from(radius) * part).round() as i32;
                (
                    (at(middle.0, radii.0, angle.cos()), at(middle.1, radii.1, angle.sin())),
                    attributes,
                )
            })
            .collect();
        if reversed {
            corners.reverse();
        }
        corners
    })
}

fn is_convex(corners: &[Corner]) -> bool {
    let at = |index: usize| corners[index % corners.len()].0;
    let turns = (0..corners.len()).map(|index| {
        let (a, b, c) = (at(index), at(index + 1), at(index + 2));
        (i64::from(b.0 - a.0) * i64::from(c.1 - b.1) - i64::from(b.1 - a.1) * i64::from(c.0 - b.0)).signum()
    });
    let turns: Vec<_> = turns.collect();
    turns.iter().all(|turn| *turn == 1) || turns.iter().all(|turn| *turn == -1)
}

proptest! {
    #![proptest_config(config(cases(300, 6_000)))]

    #[test]
    fn triangles_of_sixteenths_are_those_of_rationals(
        corners in prop_oneof![triangle(-200, 900), triangle(-100, 100), sliver(700)],
    ) {
        check_triangle::<Sub4>(corners, &window());
    }

    #[test]
    fn triangles_of_256ths_are_those_of_rationals(
        corners in prop_oneof![triangle(-3000, 14_000), triangle(0, 3000), sliver(11_000)],
    ) {
        check_triangle::<Sub8>(corners, &window());
    }

    /// Ends of the domain, where every number is as large as it gets; and windows anywhere.
    #[test]
    fn triangles_to_the_ends_of_the_domain_are_those_of_rationals(
        fine in triangle(Sub8::MIN_UNITS, Sub8::MAX_UNITS),
        coarse in triangle(Sub4::MIN_UNITS, Sub4::MAX_UNITS),
        ends in prop::array::uniform3((0usize..3, 0usize..3)),
        corner in (-8_192i32..8_150, -8_192i32..8_150),
    ) {
        let window = Window { left: corner.0, top: corner.1, right: corner.0 + 40, bottom: corner.1 + 30 };
        check_triangle::<Sub8>(fine, &window);
        check_triangle::<Sub4>(coarse, &self::window());
        let extreme = [Sub8::MIN_UNITS, 77, Sub8::MAX_UNITS];
        let mut index = 0;
        let corners = fine.map(|(_, attributes)| {
            let (x, y) = ends[index];
            index += 1;
            ((extreme[x], extreme[y]), attributes)
        });
        check_triangle::<Sub8>(corners, &window);
    }

    /// Convex polygons: the same pixels, and between edges and along spans the exact attributes.
    #[test]
    fn convex_polygons_are_those_of_rationals(fine in convex(256), coarse in convex(16)) {
        fn check<S: SubPixel>(corners: &[Corner]) where SubPoint<S>: Snapped {
            let contours = [corners.iter().map(|(units, _)| *units).collect()];
            let expected = filled_pixels(&contours, S::FRACTION_BITS, FillRule::NonZero, &window());
            for (name, pixels) in by_each::<S>(corners, &window()) {
                let found: Vec<_> = pixels.iter().map(|(pixel, _)| *pixel).collect();
                assert!(found == expected, "{name} {corners:?}");
                if name == "edge_and_span_interpolation" {
                    check_edges_and_spans(corners, &pixels, S::FRACTION_BITS);
                }
            }
        }
        if is_convex(&fine) { check::<Sub8>(&fine); }
        if is_convex(&coarse) { check::<Sub4>(&coarse); }
    }

    /// Any corners, convex or not, and beyond the domain: pixels in the window, and an end.
    #[test]
    fn any_corners_end(
        corners in prop::collection::vec(((any::<i32>(), any::<i32>()), attributes()), 0..6),
        shift in 0u32..32,
    ) {
        let corners: Vec<_> = corners.into_iter().map(|((x, y), attributes)| {
            let [x, y] = [x, y].map(|units| fixed::types::I24F8::from_bits(units >> shift));
            let point = SubPoint::<Sub8> { x, y };
            (point, attributes)
        }).collect();
        let window = window();
        macro_rules! interpolate {
            ($([$name:ident] [$($interpolate:tt)+])+) => {$(
                let _ = $($interpolate)+(&corners, &window, |pixel, _| {
                    assert!(window.contains(pixel));
                    Ok::<(), ()>(())
                });
            )+};
        }
        zrow_methods::interpolations!(interpolate);
    }
}

/// Slivers so steep that only the wider bound holds for edges and spans are among the cases.
#[test]
fn the_steepest_triangles_stay_between_their_edges() {
    let mut steep = 0;
    for right in 1..40 {
        for bottom in [2_560, 25_601, 250_000] {
            let corners = [
                ((-1, -200), [i16::MIN, 0]),
                ((right, 1_280), [i16::MAX, 9]),
                ((0, bottom), [-32_000, 5]),
            ];
            steep += check_triangle::<Sub8>(corners, &window());
        }
    }
    assert!(steep > 20, "{steep}");
}

/// A square with one bright corner, level and turned by 45 degrees: its middle stays as it is where it is divided along the
/// same diagonal, and does not where attributes are interpolated along level rows.
#[test]
fn a_turned_square_changes_by_edges_and_spans_alone() {
    let square = [(-160, -160), (160, -160), (160, 160), (-160, 160)];
    let diamond = [(0, -224), (224, 0), (0, 224), (-224, 0)];
    let window = Window {
        left: -20,
        top: -20,
        right: 20,
        bottom: 20,
    };
    let middle = |corners: [Units; 4], bright: usize| {
        let mut number = 0;
        let corners = corners.map(|units| {
            number += 1;
            (units, [if number == bright + 1 { 1_000 } else { 0 }, 0])
        });
        by_each::<Sub4>(&corners, &window)
            .into_iter()
            .map(|(name, pixels)| (name, pixels.iter().find(|(pixel, _)| *pixel == (0, 0)).unwrap().1[0]))
            .collect::<Vec<_>>()
    };
    for bright in 0..4 {
        let (level, turned) = (middle(square, bright), middle(diamond, bright));
        for ((name, level), (_, turned)) in level.into_iter().zip(turned) {
            // The diagonal between the first and the third corner goes through the middle.
            let on_diagonal = if bright % 2 == 0 { 500 } else { 0 };
            let expected = match name {
                // The mean of all corners; of those to the left and the right.
                "edge_and_span_interpolation" => (250, if bright % 2 == 0 { 0 } else { 500 }),
                _ => (on_diagonal, on_diagonal),
            };
            assert_eq!((level, turned), expected, "{name} {bright}");
        }
    }
}
