//! The table of edges of an antialiased polygon: how much room it needs, and used for one outline after the other.

use proptest::prelude::*;
use zrow::{
    coverage::SignedArea,
    draw::{AntialiasedPolygon, FillRule},
    geometry::{InputError, TooSmall},
};

use crate::{
    common::{cases, config},
    measured::{sub_contours, window},
};

proptest! {
    #![proptest_config(config(cases(256, 256)))]

    /// The number that a table needs is counted here row by row.
    #[test]
    fn too_few_active_edges_are_reported_with_the_number_needed(
        contour in proptest::collection::vec((0..9_000i32, prop_oneof![0..6_000i32, (0..20i32).prop_map(|row| row * 256 - 128)]), 3..40),
    ) {
        let rows = |a: i32, b: i32| (a.min(b) + 128).div_euclid(256)..(a.max(b) + 128 + 255).div_euclid(256);
        let edges: Vec<_> = contour
            .iter()
            .zip(contour.iter().cycle().skip(1))
            .filter(|(a, b)| a.1 != b.1)
            .map(|(a, b)| rows(a.1, b.1))
            .collect();
        let in_row = |row: i32| edges.iter().filter(|rows| rows.contains(&row)).count();
        let needed = (-1..30).map(in_row).max().unwrap();
        let points = sub_contours(&[contour]);
        let prepared = AntialiasedPolygon::<40, 2>::prepare(&[points[0].as_slice()], FillRule::NonZero);
        let full = TooSmall::ActiveEdges(needed);
        let expected = (needed > 2).then_some(InputError::TooSmall(full));
        prop_assert_eq!(prepared.err(), expected);
    }

    /// A table that is used again, after outlines that it had no room for, too, holds what a new one would.
    #[test]
    fn a_polygon_is_set_up_again_in_place(
        contours in proptest::collection::vec(proptest::collection::vec((0..4_000i32, 0..4_000i32), 0..20), 1..8),
    ) {
        let mask = |polygon: &AntialiasedPolygon<12, 8>| {
            let mut mask = Vec::new();
            let mut memory = [0; 17];
            polygon.cover(&SignedArea, &window(0, 16), &mut memory, |span, coverage| {
                mask.push((span, coverage));
                Ok::<_, TooSmall>(())
            })?;
            Ok::<_, TooSmall>(mask)
        };
        let mut again = AntialiasedPolygon::<12, 8>::empty();
        for (number, contour) in contours.into_iter().enumerate() {
            let rule = if number % 2 == 0 { FillRule::NonZero } else { FillRule::EvenOdd };
            let points = sub_contours(&[contour]);
            let outline = [points[0].as_slice()];
            let anew = AntialiasedPolygon::prepare(&outline, rule);
            prop_assert_eq!(again.set_up(&outline, rule).err(), anew.as_ref().err().copied());
            let anew = anew.unwrap_or(AntialiasedPolygon::empty());
            prop_assert_eq!(again.bounds(), anew.bounds());
            prop_assert_eq!(mask(&again), mask(&anew));
        }
    }
}
