//! Random polygons clipped against each other: area, parts and holes against exact rationals in `i128`.

use proptest::prelude::*;
use zrow::{
    clip::{Clipper, Operation},
    geometry::{ConvexWindow, InputError, Sub4, Sub8, SubPixel, SubPoint},
};

use crate::common::{cases, config};
use crate::exact_boolean::{Contour, Position, Shape, expected, keeps};

pub const OPERATIONS: [Operation; 3] = [Operation::Intersection, Operation::Union, Operation::Difference];

/// A precision whose coordinates can be made from any number of units, also outside the domain.
pub trait Precision: SubPixel {
    /// Units that a step of the reference's coordinates becomes: the reference does not have to be large.
    const SCALE: i32;
}

impl Precision for Sub4 {
    const SCALE: i32 = 1_301;
}

impl Precision for Sub8 {
    const SCALE: i32 = 131_101;
}

/// A contour of a result.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Outline {
    pub is_hole: bool,
    /// The smallest corner first.
    pub corners: Contour,
}

fn points<S: SubPixel>(shape: &Shape, scale: i32) -> Vec<Vec<SubPoint<S>>> {
    let point = |&(x, y): &Position| SubPoint::from_units(x * scale, y * scale).unwrap();
    shape
        .iter()
        .map(|contour| contour.iter().map(point).collect())
        .collect()
}

/// The contours of a result in an order of their own, or the error.
type Clip<S> = fn(&[&[SubPoint<S>]], &[&[SubPoint<S>]], Operation) -> Result<Vec<Outline>, InputError>;

/// Every algorithm, with room for `N` vertices. All tests here are for each of them.
pub fn algorithms<S: SubPixel, const N: usize>() -> Vec<(&'static str, Clip<S>)> {
    macro_rules! algorithms {
        ($([$name:ident] [$($algorithm:tt)+])+) => {
            vec![$((
                stringify!($name),
                (|subject, clip, operation| {
                    let mut clipper = Box::new(Clipper::<S, N>::new());
                    let clipped = $($algorithm)+(&mut *clipper, subject, clip, operation)?;
                    Ok(canonical(clipped.map(|contour| (contour.is_hole(), contour.points().collect()))))
                }) as Clip<S>,
            )),+]
        };
    }
    zrow_methods::booleans!(algorithms)
}

fn canonical<S: SubPixel>(contours: impl Iterator<Item = (bool, Vec<SubPoint<S>>)>) -> Vec<Outline> {
    let mut outlines: Vec<_> = contours
        .map(|(is_hole, points)| {
            let corners: Contour = points.iter().map(|point| (point.x_units(), point.y_units())).collect();
            // Where crossings are rounded to the same point, it may come twice: so all corners are compared.
            let from = |index: usize| [&corners[index..], &corners[..index]].concat();
            let corners = (0..corners.len()).map(from).min().unwrap_or_default();
            Outline { is_hole, corners }
        })
        .collect();
    outlines.sort();
    outlines
}

/// What every algorithm gives.
pub fn clip_by<S: SubPixel, const N: usize>(
    subject: &Shape,
    clip: &Shape,
    operation: Operation,
    scale: i32,
) -> Result<Vec<Outline>, InputError> {
    let (subject_points, clip_points) = (points::<S>(subject, scale), points::<S>(clip, scale));
    let subject_points: Vec<_> = subject_points.iter().map(Vec::as_slice).collect();
    let clip_points: Vec<_> = clip_points.iter().map(Vec::as_slice).collect();
    let algorithms = algorithms::<S, N>();
    let result = algorithms[0].1(&subject_points, &clip_points, operation);
    for (name, algorithm) in &algorithms[1..] {
        assert_eq!(
            algorithm(&subject_points, &clip_points, operation),
            result,
            "{name}: {operation:?} of {subject:?} and {clip:?}, {scale}"
        );
    }
    result
}

pub fn clipped<S: SubPixel>(subject: &Shape, clip: &Shape, operation: Operation, scale: i32) -> Vec<Outline> {
    clip_by::<S, 4096>(subject, clip, operation, scale).unwrap()
}

fn sides(corners: &Contour) -> impl Iterator<Item = (Position, Position)> + '_ {
    (0..corners.len()).map(|index| (corners[index], corners[(index + 1) % corners.len()]))
}

/// Of an outer contour above 0, of a hole below.
pub fn doubled_area(corners: &Contour) -> i64 {
    sides(corners)
        .map(|(from, to)| i64::from(from.0) * i64::from(to.1) - i64::from(from.1) * i64::from(to.0))
        .sum()
}

/// What the documentation promises: half a unit an axis and crossing.
fn area_bound(outlines: &[Outline]) -> f64 {
    let sides = outlines.iter().flat_map(|outline| sides(&outline.corners));
    sides
        .map(|(from, to)| f64::from(from.0.abs_diff(to.0)) / 2.0 + f64::from(from.1.abs_diff(to.1)) / 2.0 + 0.25)
        .sum()
}

/// Even-odd.
fn contains<'a>(contours: impl IntoIterator<Item = &'a Contour>, (x, y): Position) -> bool {
    let crosses = |(from, to): &(Position, Position)| {
        let ((x0, y0), (x1, y1)) = (*from, *to);
        let side = (i64::from(x1) - i64::from(x0)) * (i64::from(y) - i64::from(y0))
            - (i64::from(y1) - i64::from(y0)) * (i64::from(x) - i64::from(x0));
        (y0 < y) != (y1 < y) && (side > 0) == (y1 < y0)
    };
    contours.into_iter().flat_map(sides).filter(crosses).count() % 2 == 1
}

/// Whether a point is so close to an edge that rounding may move the edge across it.
fn is_close(shape: &Shape, (x, y): Position) -> bool {
    shape.iter().flat_map(sides).any(|(from, to)| {
        let (dx, dy) = (f64::from(to.0 - from.0), f64::from(to.1 - from.1));
        let (px, py) = (f64::from(x - from.0), f64::from(y - from.1));
        (dx * py - dy * px).abs() <= 2.0 * dx.hypot(dy)
    })
}

fn scaled(shape: &Shape, scale: i32) -> Shape {
    let scaled = |&(x, y): &Position| (x * scale, y * scale);
    shape
        .iter()
        .map(|contour| contour.iter().map(scaled).collect())
        .collect()
}

/// Checks one operation against the reference and returns its result.
pub fn check<S: Precision>(subject: &Shape, clip: &Shape, operation: Operation) -> Vec<Outline> {
    check_scaled::<S>(subject, clip, operation, S::SCALE)
}

pub fn check_scaled<S: SubPixel>(subject: &Shape, clip: &Shape, operation: Operation, scale: i32) -> Vec<Outline> {
    let outlines = clipped::<S>(subject, clip, operation, scale);
    let context = format!("{operation:?} of {subject:?} and {clip:?}: {outlines:?}");
    let expected = expected(subject, clip, operation);

    let holes = outlines.iter().filter(|outline| outline.is_hole).count();
    assert_eq!(outlines.len() - holes, expected.parts, "parts, {context}");
    assert_eq!(holes, expected.holes, "holes, {context}");

    let area = outlines
        .iter()
        .map(|outline| doubled_area(&outline.corners))
        .sum::<i64>() as f64
        / 2.0;
    let exact = expected.area * f64::from(scale).powi(2);
    let bound = area_bound(&outlines) + exact * 1e-12;
    assert!((area - exact).abs() <= bound, "area {area} for {exact}, {context}");

    for outline in &outlines {
        assert!(outline.corners.len() >= 3, "{context}");
        let area = doubled_area(&outline.corners);
        assert!(
            if outline.is_hole { area <= 0 } else { area >= 0 },
            "orientation, {context}"
        );
    }
    let (subject, clip) = (scaled(subject, scale), scaled(clip, scale));
    let lattice = (0..13).flat_map(|x| (0..13).map(move |y| (x * 5 + 3, y * 5 + 2)));
    for (x, y) in lattice.map(|(x, y)| (x * scale / 6, y * scale / 6)) {
        if !is_close(&subject, (x, y)) && !is_close(&clip, (x, y)) {
            let contours = outlines.iter().map(|outline| &outline.corners);
            let exact = keeps(operation, contains(&subject, (x, y)), contains(&clip, (x, y)));
            assert_eq!(contains(contours, (x, y)), exact, "at {x}, {y}, {context}");
        }
    }
    outlines
}

pub fn check_all<S: Precision>(subject: &Shape, clip: &Shape) {
    for operation in OPERATIONS {
        check::<S>(subject, clip, operation);
        check::<S>(clip, subject, operation);
    }
}

/// Removes crossings by turning what lies between them around: mostly a simple contour is left.
fn untangled(mut contour: Contour) -> Contour {
    let side = |a: Position, b: Position, c: Position| ((b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0)).signum();
    let count = contour.len();
    for _ in 0..60 {
        let crossing = (0..count).find_map(|one| {
            (one + 2..count).find_map(|other| {
                let (a, b) = (contour[one], contour[one + 1]);
                let (c, d) = (contour[other], contour[(other + 1) % count]);
                let crosses = side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
                crosses.then_some((one, other))
            })
        });
        match crossing {
            Some((one, other)) => contour[one + 1..=other].reverse(),
            None => break,
        }
    }
    contour
}

fn any_contour(low: i32, high: i32, corners: usize) -> impl Strategy<Value = Contour> {
    proptest::collection::vec((low..=high, low..=high), 3..=corners)
}

fn simple_contour(low: i32, high: i32, corners: usize) -> impl Strategy<Value = Contour> {
    any_contour(low, high, corners).prop_map(untangled)
}

/// A contour, and up to two more in the middle: mostly holes, which touch or cut the outer contour and each other.
fn with_holes(size: i32, corners: usize) -> impl Strategy<Value = Shape> {
    let outer = simple_contour(0, size, corners);
    let holes = proptest::collection::vec(simple_contour(1, size - 1, 5), 0..=2);
    (outer, holes).prop_map(|(outer, mut contours)| {
        contours.push(outer);
        contours
    })
}

/// A frame around holes that touch it and each other.
fn frame(size: i32) -> impl Strategy<Value = Shape> {
    let holes = proptest::collection::vec(simple_contour(0, size, 6), 1..=3);
    holes.prop_map(move |mut contours| {
        contours.push(vec![(0, 0), (size, 0), (size, size), (0, size)]);
        contours
    })
}

/// The outlines of random cells of a grid: shared edges and shared corners everywhere.
fn cells(size: i32) -> impl Strategy<Value = Shape> {
    proptest::collection::vec((0..size, 0..size), 1..8).prop_map(|cells| {
        let square = |(x, y): Position| vec![(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)];
        cells.into_iter().map(square).collect()
    })
}

/// Rectangles and diamonds: all crossings are at half steps.
fn octilinear(size: i32) -> impl Strategy<Value = Shape> {
    let rectangle = |((x, y), (width, height)): (Position, Position)| {
        vec![(x, y), (x + width, y), (x + width, y + height), (x, y + height)]
    };
    let diamond =
        |((x, y), (size, _)): (Position, Position)| vec![(x - size, y), (x, y - size), (x + size, y), (x, y + size)];
    let position = move || ((0..size, 0..size), (1..size / 2, 1..size / 2));
    let contour = prop_oneof![position().prop_map(rectangle), position().prop_map(diamond)];
    proptest::collection::vec(contour, 1..5)
}

pub fn any_shape(size: i32) -> impl Strategy<Value = Shape> {
    prop_oneof![
        3 => with_holes(size, 10),
        2 => simple_contour(0, size, 12).prop_map(|contour| vec![contour]),
        1 => any_contour(0, size, 9).prop_map(|contour| vec![contour]),
        1 => frame(size),
        1 => cells(size),
    ]
}

proptest! {
    #![proptest_config(config(cases(200, 2_000)))]

    #[test]
    fn area_parts_and_holes_are_those_of_the_exact_result(subject in any_shape(10), clip in any_shape(10)) {
        for operation in OPERATIONS {
            check::<Sub8>(&subject, &clip, operation);
        }
    }

    #[test]
    fn small_grids_where_nearly_everything_is_degenerate(subject in any_shape(4), clip in any_shape(4)) {
        for operation in OPERATIONS {
            check::<Sub4>(&subject, &clip, operation);
            check::<Sub8>(&subject, &clip, operation);
        }
    }
}

proptest! {
    #![proptest_config(config(cases(100, 1_000)))]

    /// Crossings round to the same points from either polygon, and whichever way and from where contours run.
    #[test]
    fn the_order_of_polygons_contours_and_corners_does_not_matter(
        subject in any_shape(7),
        clip in any_shape(7),
        shift in 0usize..9,
    ) {
        let turned = |shape: &Shape| {
            let mut shape = shape.clone();
            shape.reverse();
            for contour in &mut shape {
                contour.reverse();
                let count = contour.len();
                contour.rotate_left(shift % count);
            }
            shape
        };
        for operation in OPERATIONS {
            let outlines = clipped::<Sub8>(&subject, &clip, operation, 977);
            prop_assert_eq!(&clipped::<Sub8>(&turned(&subject), &turned(&clip), operation, 977), &outlines);
            if operation != Operation::Difference {
                prop_assert_eq!(&clipped::<Sub8>(&clip, &subject, operation, 977), &outlines);
            }
        }
    }

    /// Where every crossing is a whole unit, the result is its own union and its own intersection.
    #[test]
    fn clipping_a_result_by_itself_changes_nothing(subject in octilinear(8), clip in octilinear(8)) {
        for operation in OPERATIONS {
            let outlines = check_scaled::<Sub8>(&subject, &clip, operation, 2);
            let result: Shape = outlines.iter().map(|outline| outline.corners.clone()).collect();
            prop_assert_eq!(&clipped::<Sub8>(&result, &result, Operation::Union, 1), &outlines);
            prop_assert_eq!(&clipped::<Sub8>(&result, &result, Operation::Intersection, 1), &outlines);
            prop_assert_eq!(clipped::<Sub8>(&result, &result, Operation::Difference, 1), []);
            let exact = expected(&subject, &clip, operation).area * 8.0;
            prop_assert_eq!(outlines.iter().map(|outline| doubled_area(&outline.corners)).sum::<i64>() as f64, exact);
        }
    }

    /// Two convex polygons: the same area to the last unit as the clipper against convex windows gives.
    #[test]
    fn convex_polygons_agree_with_sutherland_and_hodgman(
        subject in any_contour(0, 12, 3),
        clip in any_contour(0, 12, 3),
        scale in 1..1000,
    ) {
        let shapes = [vec![subject], vec![clip]];
        let [subject, clip] = shapes.each_ref().map(|shape| points::<Sub8>(shape, scale).remove(0));
        if let Ok(window) = ConvexWindow::new(&clip) {
            let part = window.sutherland_hodgman_2d::<8, 4>(&subject).unwrap();
            let part: Contour = part.iter().map(|point| (point.x_units(), point.y_units())).collect();
            let outlines = clipped::<Sub8>(&shapes[0], &shapes[1], Operation::Intersection, scale);
            let area: i64 = outlines.iter().map(|outline| doubled_area(&outline.corners)).sum();
            prop_assert_eq!(area, doubled_area(&part).abs(), "{:?} {:?}", part, outlines);
        }
    }

    /// Results so small that crossings fall on each other: the number of parts and holes stays exact.
    #[test]
    fn parts_and_holes_are_exact_even_where_rounding_flattens_them(subject in any_shape(10), clip in any_shape(10)) {
        for operation in OPERATIONS {
            let outlines = clipped::<Sub4>(&subject, &clip, operation, 1);
            let expected = expected(&subject, &clip, operation);
            let holes = outlines.iter().filter(|outline| outline.is_hole).count();
            prop_assert_eq!((outlines.len() - holes, holes), (expected.parts, expected.holes));
            let area = outlines.iter().map(|outline| doubled_area(&outline.corners)).sum::<i64>() as f64 / 2.0;
            prop_assert!((area - expected.area).abs() <= area_bound(&outlines) + 1e-9);
        }
    }
}
