//! Edges that cross inside a pixel, by the method that resolves them, against the exact area.

use proptest::prelude::*;
use zrow::{
    coverage::{InsideArea, SignedArea},
    draw::FillRule,
    geometry::Window,
};

use crate::{
    common::{cases, config},
    measured::{coverages, furthest, window},
    reference::exact_area::{Contour, exact},
};

/// Muratori's bow tie: its edges cross in the middle of a pixel.
#[test]
fn the_crossing_of_a_bow_tie_is_half_covered() {
    let contour: Contour = [(1, 1), (8, 1), (1, 8), (8, 8)]
        .map(|(x, y)| (x * 256 - 128, y * 256 - 128))
        .to_vec();
    let window = window(0, 10);
    for rule in [FillRule::EvenOdd, FillRule::NonZero] {
        let middle = 4 * 10 + 4;
        let areas = exact(std::slice::from_ref(&contour), rule, &window);
        assert!((areas[middle] - 0.5).abs() < 1e-9);
        let coverage = coverages(&InsideArea, std::slice::from_ref(&contour), rule, &window)[middle];
        assert!(coverage == 127 || coverage == 128, "{coverage}");
        // Exact area alone is known not to see it.
        assert_eq!(
            coverages(&SignedArea, std::slice::from_ref(&contour), rule, &window)[middle],
            0
        );
    }
}

/// Two edges as long as the domain cross within one row: no product of their distance wraps.
#[test]
fn the_longest_edges_cross_where_they_do() {
    for (left, right) in [(-2_000_000, 2_000_000), (-300_000, 1_900_000), (-1_000, 500_000)] {
        for height in [60, 100] {
            let bow_tie = [vec![(left, -height), (right, height), (right, -height), (left, height)]];
            let middle = (left + right) / 512;
            let window = Window {
                bottom: 1,
                ..window(middle - 300, middle + 300)
            };
            let areas = exact(&bow_tie, FillRule::NonZero, &window);
            let found = coverages(&InsideArea, &bow_tie, FillRule::NonZero, &window);
            // The crossing is rounded to 1/256 pixel, downwards.
            let (error, pixel) = furthest(&found, &areas);
            assert!(error <= 1.5, "{left} {height}: {error} in pixel {pixel}");
        }
    }
}

/// The outline of nine edges in which all cross: more crossings in a row of pixels than rows of 1/16 pixel can tell.
#[test]
fn any_number_of_crossings_in_a_row_is_measured() {
    let corners = [
        (5700, 3831),
        (342, 3391),
        (5655, 3345),
        (337, 3790),
        (5887, 3733),
        (468, 3584),
        (5687, 3701),
        (329, 3864),
        (5685, 3733),
    ];
    let contours = [corners.to_vec()];
    for rule in [FillRule::EvenOdd, FillRule::NonZero] {
        let window = window(0, 30);
        let (error, pixel) = furthest(
            &coverages(&InsideArea, &contours, rule, &window),
            &exact(&contours, rule, &window),
        );
        assert!(error < 1.0, "{rule:?}: {error} in pixel {pixel}");
    }
}

proptest! {
    #![proptest_config(config(cases(150, 1_500)))]

    /// Outlines of up to 60 corners in boxes of any height, down to a few 1/256 pixel: wherever edges cross, and however
    /// many of them, the area of the inside is right.
    #[test]
    fn crossings_are_measured_to_four_255ths(
        corners in prop::collection::vec((0..1 << 16, 0..1 << 16), 3..60),
        width_bits in 8..13u32, height_bits in 3..13u32, shear in -3..=3i32, even_odd: bool,
    ) {
        let rule = if even_odd { FillRule::EvenOdd } else { FillRule::NonZero };
        let corner = |(x, y): (i32, i32)| {
            let (x, y) = (x >> (16 - width_bits), y >> (16 - height_bits));
            (x + shear * y, y + 300)
        };
        let contours = [corners.into_iter().map(corner).collect::<Contour>()];
        let window = Window { left: 0, top: 0, right: 32, bottom: 20 };
        let areas = exact(&contours, rule, &window);
        let found = coverages(&InsideArea, &contours, rule, &window);
        let (error, pixel) = furthest(&found, &areas);
        prop_assert!(error < 4.0, "{} in pixel {}", error, pixel);
    }
}

/// Edges that cross in one point, and edges that cross one after the other 1/256 pixel further down each: nearly level ones,
/// so that each crossing is as wide as a pixel.
#[test]
fn nearly_level_edges_that_cross_in_one_pixel_are_measured() {
    let window = Window {
        left: -2,
        top: 0,
        right: 3,
        bottom: 2,
    };
    for reach in [200, 5_000, 300_000, 2_000_000] {
        let fan: Vec<Contour> = (0..40)
            .map(|turn| vec![(-reach, turn), (reach, 60 - turn), (reach, 61 - turn)])
            .collect();
        let stack: Vec<Contour> = (0..100)
            .map(|row| {
                vec![
                    (-reach, row),
                    (reach + 7 * row, row + 1),
                    (reach, row),
                    (-reach, row + 1),
                ]
            })
            .collect();
        for contours in [fan, stack] {
            for rule in [FillRule::EvenOdd, FillRule::NonZero] {
                let areas = exact(&contours, rule, &window);
                let found = coverages(&InsideArea, &contours, rule, &window);
                let (error, pixel) = furthest(&found, &areas);
                assert!(error < 4.0, "{reach} {rule:?}: {error} in pixel {pixel}");
            }
        }
    }
}
