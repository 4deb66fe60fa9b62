//! Known polygons clipped against each other: published failures of other clippers, degenerate contours, and limits.

use fixed::types::{I12F4, I24F8};
use proptest::prelude::*;
use zrow::{
    clip::Operation,
    geometry::{InputError, Sub4, Sub8, SubPixel, SubPoint, TooSmall},
};

use crate::common::{cases, config};
use crate::exact_boolean::{Contour, Position, Rational, Shape, expected};
use crate::polygon_booleans::{
    OPERATIONS, Outline, algorithms, any_shape, check, check_all, check_scaled, clip_by, clipped, doubled_area,
};

fn shape(contours: &[&[Position]]) -> Shape {
    contours.iter().map(|contour| contour.to_vec()).collect()
}

fn square(from: i32, to: i32) -> Contour {
    vec![(from, from), (to, from), (to, to), (from, to)]
}

fn counts(outlines: &[Outline]) -> (usize, usize) {
    let holes = outlines.iter().filter(|outline| outline.is_hole).count();
    (outlines.len() - holes, holes)
}

#[test]
fn a_polygon_with_itself() {
    let polygons = [
        vec![square(0, 4)],
        vec![square(0, 9), square(2, 5)],
        vec![square(0, 9), square(0, 5)],
        shape(&[&[(0, 0), (9, 1), (5, 4), (9, 9), (1, 8)]]),
    ];
    for polygon in &polygons {
        check_all::<Sub4>(polygon, polygon);
        check_all::<Sub8>(polygon, polygon);
        let both = clipped::<Sub8>(polygon, polygon, Operation::Intersection, 1);
        assert_eq!(clipped::<Sub8>(polygon, polygon, Operation::Union, 1), both);
        assert_eq!(clipped::<Sub8>(polygon, &vec![], Operation::Union, 1), both);
        assert_eq!(clipped::<Sub8>(polygon, polygon, Operation::Difference, 1), []);
    }
}

#[test]
fn a_concave_subject_gives_several_parts() {
    let comb = shape(&[&[
        (0, 9),
        (0, 0),
        (1, 0),
        (1, 6),
        (2, 6),
        (2, 0),
        (3, 0),
        (3, 6),
        (4, 6),
        (4, 0),
        (5, 0),
        (5, 9),
    ]]);
    let bar = shape(&[&[(-1, 2), (6, 3), (6, 5), (-1, 4)]]);
    check_all::<Sub8>(&comb, &bar);
    assert_eq!(counts(&check::<Sub8>(&comb, &bar, Operation::Intersection)), (3, 0));
    assert_eq!(counts(&check::<Sub8>(&comb, &bar, Operation::Union)), (1, 2));
    assert_eq!(counts(&check::<Sub8>(&comb, &bar, Operation::Difference)), (4, 0));
}

#[test]
fn a_window_inside_a_hole() {
    let ring = vec![square(0, 9), square(2, 7)];
    for window in [square(3, 5), square(2, 7), vec![(2, 2), (7, 4), (4, 7)]] {
        let window = vec![window];
        check_all::<Sub4>(&ring, &window);
        check_all::<Sub8>(&ring, &window);
        assert_eq!(clipped::<Sub8>(&ring, &window, Operation::Intersection, 1), []);
        assert_eq!(
            counts(&clipped::<Sub8>(&ring, &window, Operation::Difference, 1)),
            (1, 1)
        );
    }
    assert_eq!(
        counts(&clipped::<Sub8>(&ring, &vec![square(3, 5)], Operation::Union, 1)),
        (2, 1)
    );
    assert_eq!(
        counts(&clipped::<Sub8>(&ring, &vec![square(2, 7)], Operation::Union, 1)),
        (1, 0)
    );
    assert_eq!(
        counts(&clipped::<Sub8>(
            &ring,
            &vec![vec![(2, 2), (7, 4), (4, 7)]],
            Operation::Union,
            1
        )),
        (2, 1)
    );
}

#[test]
fn touching_holes() {
    let clip = vec![vec![(-1, 4), (12, 5), (6, 11)], vec![(4, 6), (6, 6), (5, 8)]];
    let touching: [&[Contour]; 7] = [
        // At a corner of the outer contour, on one of its edges, along one, across a whole side.
        &[square(0, 9), square(0, 3)],
        &[square(0, 9), vec![(0, 4), (3, 3), (3, 6)]],
        &[square(0, 9), vec![(0, 3), (4, 3), (4, 6), (0, 6)]],
        &[square(0, 9), vec![(0, 3), (9, 3), (9, 6), (0, 6)]],
        // Each other: at a corner, along an edge.
        &[square(0, 9), square(2, 4), square(4, 6)],
        &[square(0, 9), square(2, 4), vec![(4, 2), (6, 2), (6, 4), (4, 4)]],
        // The outer contour at two points.
        &[square(0, 9), vec![(0, 4), (5, 0), (5, 5)]],
    ];
    for subject in touching {
        let subject = subject.to_vec();
        check_all::<Sub4>(&subject, &clip);
        check_all::<Sub8>(&subject, &clip);
        check_all::<Sub8>(&subject, &vec![]);
    }
    let alone = |contours: &[Contour]| counts(&clipped::<Sub8>(&contours.to_vec(), &vec![], Operation::Union, 1));
    assert_eq!(
        touching.map(alone),
        [(1, 0), (1, 1), (1, 0), (2, 0), (1, 2), (1, 1), (2, 0)]
    );
}

#[test]
fn contours_without_area() {
    let polygon = vec![square(0, 6)];
    let odd: [&[Contour]; 8] = [
        &[],
        &[vec![]],
        &[vec![(3, 3)]],
        &[vec![(3, 3), (3, 3), (3, 3)]],
        &[vec![(1, 1), (8, 4)]],
        &[vec![(0, 0), (6, 0), (3, 0)]],
        &[square(1, 4), square(1, 4)],
        // A spike along an edge, and one across.
        &[
            vec![(0, 0), (9, 0), (6, 0), (6, 6), (6, 3), (2, 3), (6, 3), (6, 6), (0, 6)],
            square(0, 6),
        ],
    ];
    for nothing in odd {
        let nothing = nothing.to_vec();
        check_all::<Sub8>(&polygon, &nothing);
        assert_eq!(clipped::<Sub8>(&polygon, &nothing, Operation::Intersection, 1), []);
        let all = clipped::<Sub8>(&polygon, &nothing, Operation::Union, 1);
        assert_eq!(all, clipped::<Sub8>(&polygon, &nothing, Operation::Difference, 1));
        assert_eq!(
            all,
            [Outline {
                is_hole: false,
                corners: square(0, 6)
            }]
        );
    }
    let doubled = shape(&[&[(0, 0), (0, 0), (3, 0), (6, 0), (6, 6), (6, 6), (6, 6), (0, 6), (0, 3)]]);
    assert_eq!(
        clipped::<Sub8>(&doubled, &polygon, Operation::Intersection, 1),
        [Outline {
            is_hole: false,
            corners: square(0, 6)
        }]
    );
}

#[test]
fn polygons_apart_are_told_by_their_extents() {
    let (near, far) = (vec![square(0, 4), square(1, 2)], vec![square(5, 9), square(6, 7)]);
    assert_eq!(clipped::<Sub4>(&near, &far, Operation::Intersection, 1), []);
    assert_eq!(counts(&clipped::<Sub4>(&near, &far, Operation::Union, 1)), (2, 2));
    assert_eq!(counts(&clipped::<Sub4>(&near, &far, Operation::Difference, 1)), (1, 1));
    // No vertex is needed where nothing can be left, nor any of what cannot take away.
    assert_eq!(clip_by::<Sub4, 0>(&near, &far, Operation::Intersection, 1), Ok(vec![]));
    assert!(clip_by::<Sub4, 8>(&near, &far, Operation::Difference, 1).is_ok());
    let full = TooSmall::ContourVertices(16);
    assert_eq!(
        clip_by::<Sub4, 8>(&near, &far, Operation::Union, 1),
        Err(InputError::TooSmall(full))
    );
}

/// A case on which another library failed, from its tracker.
struct Published {
    name: &'static str,
    subject: &'static [Position],
    clip: &'static [Position],
    /// Parts, holes and corners of each operation.
    right: [(usize, usize, usize); 3],
    /// Where whole numbers.
    areas: Option<[i32; 3]>,
}

const PUBLISHED: [Published; 11] = [
    // A corner on an edge: the intersection came out empty.
    Published {
        name: "Clipper2 282",
        subject: &[(4, 1), (9, 5), (0, 5)],
        clip: &[(1, 4), (7, 6), (3, 6)],
        right: [(1, 0, 3), (1, 0, 7), (2, 0, 7)],
        areas: Some([1, 21, 17]),
    },
    // The larger rectangle had no intersection where the smaller one had. The other polygon hangs together by a point.
    Published {
        name: "Clipper2 923, small",
        subject: &[(26, 10), (26, 15), (30, 15), (30, 10)],
        clip: &[(31, 16), (22, 12), (7, 12), (7, 17), (8, 17), (8, 12), (31, 16)],
        right: [(1, 0, 3), (2, 0, 12), (1, 0, 5)],
        areas: None,
    },
    Published {
        name: "Clipper2 923, large",
        subject: &[(25, 9), (25, 16), (31, 16), (31, 9)],
        clip: &[(31, 16), (22, 12), (7, 12), (7, 17), (8, 17), (8, 12), (31, 16)],
        right: [(1, 0, 3), (2, 0, 12), (2, 0, 7)],
        areas: None,
    },
    // The difference came out as both polygons. 1/100,000 of the published coordinates, rounded down.
    Published {
        name: "Clipper2 948",
        subject: &[(14_000, -7_661), (15_732, -6_661), (10_732, 1_999), (9_000, 1_000)],
        clip: &[(10_000, 1_577), (9_000, 1_000), (9_577, 0), (10_000, 0)],
        right: [(1, 0, 4), (1, 0, 8), (1, 0, 6)],
        areas: None,
    },
    // Identical polygons: null.
    Published {
        name: "GreinerHormann 7",
        subject: &[(0, 0), (100, 0), (100, 100), (0, 100)],
        clip: &[(0, 0), (100, 0), (100, 100), (0, 100)],
        right: [(1, 0, 4), (1, 0, 4), (0, 0, 0)],
        areas: Some([10_000, 10_000, 0]),
    },
    // A corner on an edge. Seven times the published coordinates, which are sevenths.
    Published {
        name: "GreinerHormann 14",
        subject: &[(1225, 735), (910, 420), (1470, 315), (1505, 455)],
        clip: &[(1792, 742), (1450, 400), (1505, 0), (1792, 0)],
        right: [(1, 0, 4), (1, 0, 7), (1, 0, 5)],
        areas: None,
    },
    // An edge on an edge.
    Published {
        name: "GreinerHormann 17",
        subject: &[(0, 0), (10, 10), (15, 5), (20, 10), (25, 0)],
        clip: &[(6, 6), (8, 8), (25, 8), (25, 6)],
        right: [(2, 0, 8), (1, 1, 13), (3, 0, 13)],
        areas: Some([21, 165, 129]),
    },
    // Touching along an edge.
    Published {
        name: "martinez 10",
        subject: &[(0, 0), (3, 0), (3, 3), (0, 3)],
        clip: &[(3, 1), (4, 1), (4, 2), (3, 2)],
        right: [(0, 0, 0), (1, 0, 8), (1, 0, 4)],
        areas: Some([0, 10, 9]),
    },
    // Edges on edges.
    Published {
        name: "martinez 81",
        subject: &[(10, 10), (80, 10), (80, 80), (10, 80)],
        clip: &[(20, 10), (30, 10), (30, 80), (20, 80)],
        right: [(1, 0, 4), (1, 0, 4), (2, 0, 8)],
        areas: Some([700, 4_900, 4_200]),
    },
    Published {
        name: "martinez 81, comment",
        subject: &[(0, 0), (2, 2), (4, 2), (2, 0)],
        clip: &[(1, 0), (2, 1), (3, 1), (2, 0)],
        right: [(1, 0, 4), (1, 0, 4), (1, 0, 6)],
        areas: Some([1, 4, 3]),
    },
    Published {
        name: "martinez 141",
        subject: &[(0, 0), (4, 0), (4, 4), (0, 4)],
        clip: &[(2, 2), (2, 0), (6, 0), (6, -2), (-2, -2), (-2, 0)],
        right: [(1, 0, 4), (1, 0, 8), (1, 0, 6)],
        areas: Some([3, 33, 13]),
    },
];

#[test]
fn published_failures() {
    for case in PUBLISHED {
        let (subject, clip) = (shape(&[case.subject]), shape(&[case.clip]));
        for (index, operation) in OPERATIONS.into_iter().enumerate() {
            for scale in [1, 100] {
                let outlines = check_scaled::<Sub8>(&subject, &clip, operation, scale);
                let (parts, holes) = counts(&outlines);
                let corners = outlines.iter().map(|outline| outline.corners.len()).sum();
                let context = format!("{} {operation:?}: {outlines:?}", case.name);
                assert_eq!((parts, holes, corners), case.right[index], "{context}");
            }
            let exact = expected(&subject, &clip, operation).area;
            let area = case.areas.map_or(exact, |areas| areas[index].into());
            assert!((area - exact).abs() < 1e-9, "{} {operation:?}: {exact}", case.name);
        }
    }
}

/// Rounding may turn the contour of a part or of a hole that is thinner than a unit around: it is still known which of both it is.
#[test]
fn rounding_turns_a_sliver_around() {
    let signs = |subject: &[Position], clip: &[Position], operation| {
        let outlines = clipped::<Sub8>(&shape(&[subject]), &shape(&[clip]), operation, 1);
        assert_eq!(
            clipped::<Sub4>(&shape(&[subject]), &shape(&[clip]), operation, 1),
            outlines
        );
        let sign = |outline: &Outline| (outline.is_hole, doubled_area(&outline.corners).signum());
        outlines.iter().map(sign).collect::<Vec<_>>()
    };
    let (subject, clip) = ([(0, 1), (1, 3), (2, 1)], [(3, 1), (0, 3), (2, 2)]);
    assert_eq!(signs(&subject, &clip, Operation::Intersection), [(false, -1)]);
    let (subject, clip) = ([(6, 1), (0, 5), (5, 0), (2, 5)], [(4, 2), (2, 1), (6, 2), (1, 3)]);
    let of_union = signs(&subject, &clip, Operation::Union);
    assert!(of_union.contains(&(true, 1)), "{of_union:?}");
}

#[test]
fn the_largest_crossing_is_the_nearest_point() {
    let most = Sub8::MAX_UNITS;
    let subject = shape(&[&[(-most, -most), (most, most - 1), (-most, most)]]);
    let clip = shape(&[&[(-most, most), (most - 3, -most), (most, most)]]);
    let outlines = clipped::<Sub8>(&subject, &clip, Operation::Intersection, 1);
    assert_eq!(counts(&outlines), (1, 0));
    // The crossing of the first edges, by Cramer's rule.
    let (ax, ay) = (2 * i128::from(most), 2 * i128::from(most) - 1);
    let (bx, by) = (2 * i128::from(most) - 3, -2 * i128::from(most));
    let (cross, along) = (ax * by - ay * bx, -2 * i128::from(most) * bx);
    let nearest = |start: i128, change: i128| {
        let exact = Rational::new(2 * (start * cross + change * along) + cross, 2 * cross);
        exact.0.div_euclid(exact.1) as i32
    };
    let least = -i128::from(most);
    let crossing = (nearest(least, ax), nearest(least, ay));
    assert!(outlines[0].corners.contains(&crossing), "{crossing:?}: {outlines:?}");
    // A corner of the subject just leaves the other one.
    let parts = OPERATIONS.map(|operation| counts(&clipped::<Sub8>(&subject, &clip, operation, 1)));
    assert_eq!(parts, [(1, 0), (1, 0), (2, 0)]);
}

#[test]
fn corners_outside_the_domain_are_refused() {
    let inside = SubPoint::<Sub8>::default();
    let outside = SubPoint::<Sub8> {
        x: I24F8::MIN,
        y: I24F8::MAX,
    };
    let error = InputError::OutOfDomain { min: -8191, max: 8191 };
    let (good, bad): ([_; 3], _) = ([inside; 3], [inside, outside, inside]);
    for (name, clip) in algorithms::<Sub8, 16>() {
        for operation in OPERATIONS {
            assert_eq!(clip(&[&good], &[&bad], operation), Err(error), "{name}");
            assert_eq!(clip(&[&bad], &[], operation), Err(error), "{name}");
        }
    }
    let outside = SubPoint::<Sub4> {
        x: I12F4::MAX,
        y: I12F4::MIN,
    };
    let error = InputError::OutOfDomain { min: -1024, max: 1023 };
    for (name, clip) in algorithms::<Sub4, 16>() {
        assert_eq!(clip(&[&[outside]], &[], Operation::Union), Err(error), "{name}");
    }
}

proptest! {
    #![proptest_config(config(cases(50, 500)))]

    #[test]
    fn a_full_table_says_what_would_do(subject in any_shape(5), clip in any_shape(5)) {
        fn needed<const N: usize>(subject: &Shape, clip: &Shape) -> Option<usize> {
            match clip_by::<Sub8, N>(subject, clip, Operation::Union, 100) {
                Ok(_) => None,
                Err(InputError::TooSmall(full)) => {
                    assert!(matches!(full, TooSmall::ContourVertices(needed) if needed > N));
                    Some(full.needed())
                }
                Err(error) => panic!("{error}"),
            }
        }
        macro_rules! for_sizes {
            ($($size:literal)+) => {
                [$(($size, needed::<$size>(&subject, &clip))),+]
            };
        }
        let sizes = for_sizes!(0 4 8 12 16 20 24 28 32 36 40 48 56 64 80 96 128 160 256 512 1024);
        let said = sizes[0].1.unwrap_or(0);
        for (size, needed) in sizes {
            prop_assert!(needed.is_none_or(|needed| needed == said));
            prop_assert!(size < said || needed.is_none());
        }
    }
}
