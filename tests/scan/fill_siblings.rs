//! All ways to fill a polygon against winding numbers in `i128`, and so against each other.

use std::convert::Infallible;

use embedded_graphics::prelude::*;
use proptest::{prelude::*, sample::select};
use zrow::{
    band::Span,
    geometry::{DrawError, Sub4, Sub8, SubPixel, SubPoint, TooSmall, Window},
    scan::{FillRule, Polygons},
};

use crate::{
    common::{cases, config, outlines::star},
    every_fill::{Snapped, check, check_locations, collected, window},
    reference::winding_numbers::{Units, filled_pixels},
};

/// Vertices at rising angles around a centre: simple, seldom convex.
fn simple(side: i32) -> impl Strategy<Value = Vec<Vec<Units>>> {
    let centre = (0..side, 0..side);
    let radii = prop::collection::vec(0.05..0.6f64, 3..14);
    (centre, radii, any::<bool>()).prop_map(move |((x, y), radii, reversed)| {
        let contour = radii.iter().enumerate().map(|(index, radius)| {
            let angle = std::f64::consts::TAU * index as f64 / radii.len() as f64;
            let radius = radius * f64::from(side);
            (x + (radius * angle.cos()) as i32, y + (radius * angle.sin()) as i32)
        });
        let mut contour: Vec<Units> = contour.collect();
        if reversed {
            contour.reverse();
        }
        vec![contour]
    })
}

fn self_crossing(side: i32) -> impl Strategy<Value = Vec<Vec<Units>>> {
    let vertex = (-side / 4..side * 5 / 4, -side / 4..side * 5 / 4);
    prop::collection::vec(prop::collection::vec(vertex, 0..12), 0..3)
}

/// A ring around one or two smaller ones, each in either direction; they may touch, cross or leave it.
fn with_holes(side: i32) -> impl Strategy<Value = Vec<Vec<Units>>> {
    (simple(side), prop::collection::vec(simple(side / 3), 1..3), 0..side / 2).prop_map(|(mut outer, holes, offset)| {
        let moved = |(x, y): Units| (x + offset, y + offset);
        outer.extend(
            holes
                .into_iter()
                .flatten()
                .map(|hole| hole.into_iter().map(moved).collect()),
        );
        outer
    })
}

/// Few coordinates, so that vertices meet vertices, edges and pixel centres.
fn coarse(side: i32) -> impl Strategy<Value = Vec<Vec<Units>>> {
    let coordinate = move || (0..8).prop_map(move |eighth| eighth * (side / 8));
    prop::collection::vec(prop::collection::vec((coordinate(), coordinate()), 0..9), 1..4)
}

fn polygon(side: i32) -> impl Strategy<Value = Vec<Vec<Units>>> {
    prop_oneof![simple(side), self_crossing(side), with_holes(side), coarse(side)]
}

proptest! {
    #![proptest_config(config(cases(100, 1_000)))]

    #[test]
    fn random_polygons_of_pixels_are_the_same(contours in polygon(48)) {
        check::<Point>(&contours, window());
    }
}

proptest! {
    #![proptest_config(config(cases(50, 500)))]

    #[test]
    fn random_polygons_of_sixteenths_are_the_same(contours in polygon(48 * 16)) {
        check::<SubPoint<Sub4>>(&contours, window());
    }

    #[test]
    fn random_polygons_of_256ths_are_the_same(contours in polygon(48 * 256)) {
        check::<SubPoint<Sub8>>(&contours, window());
    }

    #[test]
    fn random_points_are_where_they_are(contours in polygon(16), far in prop::collection::vec((any::<i32>(), any::<i32>()), 8)) {
        let near = (-2..18).flat_map(|y| (-2..18).map(move |x| (x, y)));
        check_locations::<Point>(&contours, near.chain(far));
    }
}

/// Numbers at the ends of the range and around the window.
fn coordinate() -> impl Strategy<Value = i32> {
    prop_oneof![
        3 => -10..60i32,
        2 => any::<i32>(),
        2 => select(vec![i32::MIN, i32::MIN + 1, i32::MAX, i32::MAX - 1, 0, -8191, 8191, -4, -3, 41, 42, 4, 5]),
    ]
}

proptest! {
    #![proptest_config(config(cases(50, 400)))]

    #[test]
    fn polygons_beyond_everything_are_the_same(contours in prop::collection::vec(prop::collection::vec((coordinate(), coordinate()), 0..7), 0..3)) {
        check::<Point>(&contours, window());
        check_locations::<Point>(&contours, [(i32::MIN, i32::MAX), (i32::MIN, 0), (0, i32::MAX), (7, 9)].into_iter());
    }

    #[test]
    fn a_window_at_the_end_of_the_numbers_is_as_good(contours in prop::collection::vec(prop::collection::vec((0..40i32, 0..40i32), 3..7), 1..3), low in any::<bool>()) {
        let moved = |(x, y): Units| if low { (i32::MIN + x, i32::MIN + y) } else { (i32::MAX - x, i32::MAX - y) };
        let contours: Vec<Vec<Units>> = contours.into_iter().map(|contour| contour.into_iter().map(moved).collect()).collect();
        let corner = if low { i32::MIN } else { i32::MAX - 38 };
        check::<Point>(&contours, Window { left: corner, top: corner, right: corner + 38, bottom: corner + 38 });
    }

    #[test]
    fn polygons_to_the_ends_of_the_domain_are_the_same(contours in prop::collection::vec(prop::collection::vec((Sub8::MIN_UNITS..=Sub8::MAX_UNITS, Sub8::MIN_UNITS..=Sub8::MAX_UNITS), 3..7), 0..3)) {
        check::<SubPoint<Sub8>>(&contours, window());
    }
}

/// As pixels, in sixteenths and in 256ths.
fn check_all(contours: &[Vec<Units>]) {
    let times = |factor: i32| -> Vec<Vec<Units>> {
        let scaled = |&(x, y): &Units| (x * factor, y * factor);
        contours
            .iter()
            .map(|contour| contour.iter().map(scaled).collect())
            .collect()
    };
    check::<Point>(contours, window());
    check::<SubPoint<Sub4>>(&times(16), window());
    check::<SubPoint<Sub8>>(&times(256), window());
    let everywhere = (-6..46).flat_map(|y| (-6..46).map(move |x| (x, y)));
    check_locations::<Point>(contours, everywhere);
}

#[test]
fn bow_ties_and_stars_are_the_same() {
    check_all(&[vec![(1, 6), (8, 6), (1, 13), (8, 13)]]);
    check_all(&[vec![(1, 6), (38, 6), (1, 39), (38, 39)]]);
    for stars in [vec![star(5, 2)], vec![star(7, 3)], vec![star(7, 2), star(5, 2)]] {
        check::<SubPoint<Sub8>>(&stars, window());
        let pixels: Vec<Vec<Units>> = stars
            .iter()
            .map(|star| star.iter().map(|&(x, y)| (x >> 8, y >> 8)).collect())
            .collect();
        check_all(&pixels);
    }
}

#[test]
fn holes_that_touch_are_the_same() {
    let outer = vec![(2, 8), (30, 8), (30, 36), (2, 36)];
    let at_a_vertex = vec![(2, 8), (12, 14), (9, 20)];
    let along_an_edge = vec![(30, 12), (30, 22), (20, 22), (20, 12)];
    let reversed: Vec<Units> = outer.iter().rev().copied().collect();
    for inner in [at_a_vertex, along_an_edge, outer.clone(), reversed] {
        check_all(&[outer.clone(), inner.clone()]);
        check_all(&[inner.into_iter().rev().collect(), outer.clone()]);
    }
}

#[test]
fn degenerate_contours_are_the_same() {
    check_all(&[]);
    check_all(&[vec![]]);
    check_all(&[vec![(5, 9)]]);
    check_all(&[vec![(5, 9), (5, 9)], vec![], vec![(6, 9), (20, 9), (12, 9)]]);
    check_all(&[vec![(5, 9), (20, 30)]]);
    // Collinear and repeated vertices.
    check_all(&[vec![
        (5, 9),
        (5, 9),
        (15, 9),
        (25, 9),
        (25, 9),
        (25, 20),
        (25, 31),
        (15, 20),
    ]]);
    // Spikes without width, up, to the side and down, and one along a row and back.
    check_all(&[vec![
        (5, 20),
        (15, 20),
        (15, 8),
        (15, 20),
        (25, 20),
        (25, 30),
        (40, 30),
        (25, 30),
        (12, 30),
        (12, 38),
        (12, 30),
        (5, 30),
        (-2, 30),
        (5, 30),
    ]]);
    // Vertices that pass the row, return from it, and run along it on both sides.
    check_all(&[vec![
        (0, 20),
        (5, 20),
        (10, 10),
        (15, 20),
        (20, 20),
        (25, 30),
        (30, 20),
        (35, 20),
        (35, 10),
        (40, 20),
        (38, 35),
        (2, 35),
    ]]);
}

#[test]
fn combs_with_the_finest_teeth_are_the_same() {
    for spacing in [40, 256] {
        let mut comb = vec![(200, 2500)];
        for tooth in 0..10_000 / spacing {
            comb.push((200 + spacing * tooth, 9000));
            comb.push((201 + spacing * tooth, 9000));
            comb.push((201 + spacing * tooth, 2600));
        }
        comb.push((10_300, 2500));
        check::<SubPoint<Sub8>>(&[comb.clone()], window());
        let upright: Vec<Units> = comb.into_iter().map(|(x, y)| (y, x)).collect();
        check::<SubPoint<Sub8>>(&[upright], window());
    }
}

#[test]
fn overlapping_windings_are_the_same() {
    let ring = vec![(1, 7), (40, 9), (38, 40), (3, 37)];
    for times in [63, 64, 128, 255] {
        check::<Point>(&vec![ring.clone(); times], window());
    }
    let mut both_ways = vec![ring.clone(); 64];
    both_ways.extend(vec![ring.into_iter().rev().collect::<Vec<Units>>(); 64]);
    check::<Point>(&both_ways, window());
    let spiral: Vec<Units> = (0..64 * 4)
        .map(|corner| {
            let reach = 2 + corner / 16;
            let (x, y) = [(-1, -1), (1, -1), (1, 1), (-1, 1)][corner as usize % 4];
            (20 + x * reach, 24 + y * reach)
        })
        .collect();
    check::<Point>(&[spiral], window());
}

#[test]
fn nearly_level_edges_are_the_same() {
    for rise in [-64, -3, -1, 0, 1, 2, 63] {
        let contour = vec![(20, 5000), (9000, 5000 + rise), (9500, 5100 + rise), (100, 5090)];
        check::<SubPoint<Sub8>>(&[contour], window());
    }
}

#[test]
fn a_full_table_of_crossings_says_how_much_would_do() {
    let square = [(1, 1), (5, 1), (5, 5), (1, 5)].map(|(x, y)| Point::new(x, y));
    let contours: [&[Point]; 3] = [&square, &square, &square];
    let window = Window {
        left: -10,
        top: -10,
        right: 10,
        bottom: 10,
    };
    let mut spans = 0;
    let mut count = |_: Span| {
        spans += 1;
        Ok::<(), Infallible>(())
    };
    let full = TooSmall::Crossings(6);
    assert_eq!(
        Polygons::naive_scanline::<_, _, 5>(&contours, FillRule::NonZero, &window, &mut count),
        Err(DrawError::TooSmall(full))
    );
    assert_eq!(
        full.to_string(),
        "the table of crossings is too small: 6 are needed, raise its capacity"
    );
    // Nothing visible takes no slot.
    for elsewhere in [
        Window::EMPTY,
        Window { bottom: 1, ..window },
        Window { left: 6, ..window },
    ] {
        let filled = Polygons::naive_scanline::<_, _, 0>(&contours, FillRule::NonZero, &elsewhere, &mut count);
        assert_eq!(filled, Ok(()));
    }
    assert_eq!(spans, 0);
    let pixels = collected(&window, |emit| {
        Polygons::naive_scanline::<_, _, 6>(&contours, FillRule::NonZero, &window, emit).unwrap();
    });
    assert_eq!(pixels.len(), 16);
}

/// Two of the six sides are level and take no edge.
#[test]
fn a_scanline_fill_says_how_many_edges_it_needs() {
    let corners = [(0, 0), (9, 0), (9, 9), (6, 9), (5, 4), (0, 9)].map(|(x, y)| Point::new(x, y));
    let window = window();
    let nothing = |_: Span| Err("handed over");
    assert_eq!(
        Polygons::scanline::<_, _, 3>(&[&corners], FillRule::NonZero, &window, nothing),
        Err(DrawError::TooSmall(TooSmall::Edges(4)))
    );
    let pixels = collected(&window, |emit| {
        Polygons::scanline::<_, _, 4>(&[&corners], FillRule::NonZero, &window, emit).unwrap();
    });
    let units = vec![corners.map(|corner| (corner.x, corner.y)).to_vec()];
    assert_eq!(pixels, filled_pixels(&units, 0, FillRule::NonZero, &window));
}

type Emit<'a> = dyn FnMut(Span) -> Result<(), u8> + 'a;

#[test]
fn the_first_error_of_emit_ends_a_fill() {
    let vertices = [(0, 8 * 16), (30 * 16, 8 * 16), (0, 38 * 16)].map(SubPoint::<Sub4>::of);
    let contours: [&[SubPoint<Sub4>]; 1] = [&vertices];
    let window = window();
    let third = |fill: &dyn Fn(&mut Emit<'_>) -> bool| {
        let mut calls = 0;
        let ended = fill(&mut |_| {
            calls += 1;
            if calls == 3 { Err(7) } else { Ok(()) }
        });
        assert!(ended);
        assert_eq!(calls, 3);
    };
    let rule = FillRule::NonZero;
    macro_rules! by_table {
        ($([$name:ident] [$($fill:tt)+])+) => {
            $(third(&|emit| $($fill)+::<_, _, 4>(&contours, rule, &window, emit) == Err(DrawError::Target(7)));)+
        };
    }
    macro_rules! by_test {
        ($([$name:ident] [$($test:tt)+])+) => {
            $(third(&|emit| Polygons::brute_force(&contours, rule, &window, $($test)+, emit) == Err(7));)+
        };
    }
    macro_rules! triangles {
        ($([$name:ident] [$($fill:tt)+])+) => {
            $(third(&|emit| $($fill)+(vertices, &window, emit) == Err(7));)+
        };
    }
    zrow_methods::polygon_fills!(by_table);
    zrow_methods::point_tests!(by_test);
    zrow_methods::triangles!(triangles);
}
