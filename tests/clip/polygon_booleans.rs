//! Polygons clipped against polygons: area, parts and holes against exact rationals in `i128`.
//!
//! The reference cuts the plane into slabs at every corner and crossing and knows nothing of contours: what a result
//! hangs together by is read off the trapezoids that share more than a point.

use std::{cmp::Ordering, collections::BTreeSet};

use fixed::types::{I12F4, I24F8};
use proptest::prelude::*;
use zrow::{
    clip::{Clipped, Clipper, Operation, sutherland_hodgman_2d},
    geometry::{ConvexWindow, InputError, OutOfDomain, Sub4, Sub8, SubPixel, SubPoint, Table, TooSmall},
};

use crate::common::{cases, config};

type Place = (i32, i32);
type Contour = Vec<Place>;
type Shape = Vec<Contour>;

const OPERATIONS: [Operation; 3] = [Operation::Intersection, Operation::Union, Operation::Difference];

// ---- The reference ----

/// A number `numerator / denominator`, the denominator above 0.
#[derive(Clone, Copy, Debug)]
struct Rational(i128, i128);

impl Rational {
    fn new(numerator: i128, denominator: i128) -> Self {
        let divisor = common_divisor(numerator.abs(), denominator.abs()).max(1) * denominator.signum();
        Self(numerator / divisor, denominator / divisor)
    }

    fn minus(self, other: Self) -> Self {
        Self::new(self.0 * other.1 - other.0 * self.1, self.1 * other.1)
    }

    fn to_f64(self) -> f64 {
        self.0 as f64 / self.1 as f64
    }
}

fn common_divisor(mut one: i128, mut other: i128) -> i128 {
    while other != 0 {
        (one, other) = (other, one % other);
    }
    one
}

impl PartialEq for Rational {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Rational {}

impl PartialOrd for Rational {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Rational {
    fn cmp(&self, other: &Self) -> Ordering {
        (self.0 * other.1).cmp(&(other.0 * self.1))
    }
}

/// An edge that is not horizontal, upper end first.
#[derive(Clone, Copy)]
struct Edge {
    x: i128,
    y: i128,
    dx: i128,
    dy: i128,
    is_clip: bool,
}

impl Edge {
    fn x_at(&self, y: Rational) -> Rational {
        Rational::new(self.x * y.1 * self.dy + self.dx * (y.0 - self.y * y.1), y.1 * self.dy)
    }
}

/// A trapezoid between two edges; `None` is infinitely far away.
struct Cell {
    top: [Option<Rational>; 2],
    bottom: [Option<Rational>; 2],
    is_inside: bool,
}

struct Expected {
    area: f64,
    parts: usize,
    holes: usize,
}

fn keeps(operation: Operation, subject: bool, clip: bool) -> bool {
    match operation {
        Operation::Intersection => subject && clip,
        Operation::Union => subject || clip,
        Operation::Difference => subject && !clip,
    }
}

fn edges(shape: &Shape, is_clip: bool) -> impl Iterator<Item = Edge> + '_ {
    let sides = shape
        .iter()
        .flat_map(|contour| (0..contour.len()).map(|index| (contour[index], contour[(index + 1) % contour.len()])));
    sides.filter(|(from, to)| from.1 != to.1).map(move |(from, to)| {
        let (upper, lower) = if from.1 < to.1 { (from, to) } else { (to, from) };
        Edge {
            x: upper.0.into(),
            y: upper.1.into(),
            dx: i128::from(lower.0) - i128::from(upper.0),
            dy: i128::from(lower.1) - i128::from(upper.1),
            is_clip,
        }
    })
}

/// Where edges start, end and cross.
fn levels(edges: &[Edge]) -> Vec<Rational> {
    let mut levels = BTreeSet::new();
    for (index, one) in edges.iter().enumerate() {
        levels.extend([Rational(one.y, 1), Rational(one.y + one.dy, 1)]);
        for other in &edges[..index] {
            let cross = one.dx * other.dy - one.dy * other.dx;
            if cross != 0 {
                let along = (other.x - one.x) * other.dy - (other.y - one.y) * other.dx;
                levels.insert(Rational::new(one.y * cross + along * one.dy, cross));
            }
        }
    }
    levels.into_iter().collect()
}

/// The cells of every slab, left to right; those of the half planes above and below come first and last.
fn slabs(edges: &[Edge], operation: Operation) -> Vec<Vec<Cell>> {
    let everything = || Cell {
        top: [None, None],
        bottom: [None, None],
        is_inside: false,
    };
    let levels = levels(edges);
    let mut slabs = vec![vec![everything()]];
    for level in levels.windows(2) {
        let (top, bottom) = (level[0], level[1]);
        let mut crossing: Vec<_> = edges
            .iter()
            .filter(|edge| Rational(edge.y, 1) <= top && Rational(edge.y + edge.dy, 1) >= bottom)
            .map(|edge| ((edge.x_at(top), edge.x_at(bottom)), edge.is_clip))
            .collect();
        crossing.sort();
        let mut cells = Vec::new();
        let (mut left, mut inside) = ((None, None), [false, false]);
        for ((x_top, x_bottom), is_clip) in crossing {
            let right = (Some(x_top), Some(x_bottom));
            if left != right {
                cells.push(Cell {
                    top: [left.0, right.0],
                    bottom: [left.1, right.1],
                    is_inside: keeps(operation, inside[0], inside[1]),
                });
            }
            left = right;
            inside[usize::from(is_clip)] ^= true;
        }
        assert_eq!(inside, [false, false]);
        cells.push(Cell {
            top: [left.0, None],
            bottom: [left.1, None],
            is_inside: false,
        });
        slabs.push(cells);
    }
    slabs.push(vec![everything()]);
    slabs
}

/// Pairs of cells that share more than a point, by their numbers.
fn adjacent(slabs: &[Vec<Cell>]) -> Vec<(usize, usize)> {
    let mut pairs = Vec::new();
    let mut first = 0;
    for (index, cells) in slabs.iter().enumerate() {
        let next = first + cells.len();
        pairs.extend((first + 1..next).map(|cell| (cell - 1, cell)));
        for (above, cell) in cells.iter().enumerate() {
            for (below, other) in slabs.get(index + 1).into_iter().flatten().enumerate() {
                let ends_before = |right: Option<Rational>, left: Option<Rational>| {
                    right.is_some_and(|right| left.is_some_and(|left| right <= left))
                };
                let is_a_point = |[left, right]: [Option<Rational>; 2]| left.is_some() && left == right;
                if !ends_before(cell.bottom[1], other.top[0])
                    && !ends_before(other.top[1], cell.bottom[0])
                    && !is_a_point(cell.bottom)
                    && !is_a_point(other.top)
                {
                    pairs.push((first + above, next + below));
                }
            }
        }
        first = next;
    }
    pairs
}

/// The component of each cell, named by one of its cells, where only neighbours that belong together are connected.
fn components(count: usize, pairs: &[(usize, usize)], together: impl Fn(usize, usize) -> bool) -> Vec<usize> {
    let mut parents: Vec<usize> = (0..count).collect();
    fn root(parents: &mut [usize], mut cell: usize) -> usize {
        while parents[cell] != cell {
            parents[cell] = parents[parents[cell]];
            cell = parents[cell];
        }
        cell
    }
    for &(one, other) in pairs {
        if together(one, other) {
            let (one, other) = (root(&mut parents, one), root(&mut parents, other));
            parents[one] = other;
        }
    }
    (0..count).map(|cell| root(&mut parents, cell)).collect()
}

fn expected(subject: &Shape, clip: &Shape, operation: Operation) -> Expected {
    let edges: Vec<_> = edges(subject, false).chain(edges(clip, true)).collect();
    let levels = levels(&edges);
    let slabs = slabs(&edges, operation);
    let cells: Vec<_> = slabs.iter().flatten().collect();
    let pairs = adjacent(&slabs);
    let inside = |cell: usize| cells[cell].is_inside;
    let parts = components(cells.len(), &pairs, |one, other| inside(one) && inside(other));
    let names: BTreeSet<_> = (0..cells.len())
        .filter(|&cell| inside(cell))
        .map(|cell| parts[cell])
        .collect();
    // The holes of a part are what it keeps apart from the first cell, which is infinite.
    let holes = names.iter().map(|&part| {
        let is_part = |cell: usize| inside(cell) && parts[cell] == part;
        let around = components(cells.len(), &pairs, |one, other| !is_part(one) && !is_part(other));
        let names: BTreeSet<_> = (0..cells.len())
            .filter(|&cell| !is_part(cell))
            .map(|cell| around[cell])
            .collect();
        // Cells at either side reach to infinity too.
        let infinite: BTreeSet<_> = (0..cells.len())
            .filter(|&cell| cells[cell].top.contains(&None))
            .map(|cell| around[cell])
            .collect();
        names.difference(&infinite).count()
    });
    let holes = holes.sum();
    let mut area = 0.0;
    for (level, cells) in levels.windows(2).zip(slabs.iter().skip(1)) {
        let height = level[1].minus(level[0]).to_f64();
        for cell in cells.iter().filter(|cell| cell.is_inside) {
            let width = |[left, right]: [Option<Rational>; 2]| right.unwrap().minus(left.unwrap()).to_f64();
            area += (width(cell.top) + width(cell.bottom)) / 2.0 * height;
        }
    }
    Expected {
        area,
        parts: names.len(),
        holes,
    }
}

// ---- What is tested ----

/// A precision whose coordinates can be made from any number of units, also outside the domain.
trait Precision: SubPixel {
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
struct Outline {
    is_hole: bool,
    /// The smallest corner first.
    corners: Contour,
}

fn points<S: SubPixel>(shape: &Shape, scale: i32) -> Vec<Vec<SubPoint<S>>> {
    let point = |&(x, y): &Place| SubPoint::from_units(x * scale, y * scale).unwrap();
    shape
        .iter()
        .map(|contour| contour.iter().map(point).collect())
        .collect()
}

/// The contours of a result in an order of their own, or the error.
type Clip<S> = fn(&[&[SubPoint<S>]], &[&[SubPoint<S>]], Operation) -> Result<Vec<Outline>, InputError>;

fn outlines<S: SubPixel>(clipped: &Clipped<'_, S>) -> Vec<Outline> {
    let contours = clipped.contours();
    canonical(contours.map(|contour| (contour.is_hole(), contour.points().collect())))
}

/// Every algorithm, with room for `N` vertices. All tests here are for each of them.
fn algorithms<S: SubPixel, const N: usize>() -> Vec<(&'static str, Clip<S>)> {
    macro_rules! algorithms {
        ($([$name:ident] [$($algorithm:tt)+])+) => {
            vec![$((
                stringify!($name),
                (|subject, clip, operation| {
                    let mut clipper = Box::new(Clipper::<S, N>::new());
                    let clipped = $($algorithm)+(&mut *clipper, subject, clip, operation)?;
                    Ok(outlines(&clipped))
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
fn clip_by<S: SubPixel, const N: usize>(
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

fn clipped<S: SubPixel>(subject: &Shape, clip: &Shape, operation: Operation, scale: i32) -> Vec<Outline> {
    clip_by::<S, 4096>(subject, clip, operation, scale).unwrap()
}

fn sides(corners: &Contour) -> impl Iterator<Item = (Place, Place)> + '_ {
    (0..corners.len()).map(|index| (corners[index], corners[(index + 1) % corners.len()]))
}

/// Of an outer contour above 0, of a hole below.
fn doubled_area(corners: &Contour) -> i64 {
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
fn contains<'a>(contours: impl IntoIterator<Item = &'a Contour>, (x, y): Place) -> bool {
    let crosses = |(from, to): &(Place, Place)| {
        let ((x0, y0), (x1, y1)) = (*from, *to);
        let side = (i64::from(x1) - i64::from(x0)) * (i64::from(y) - i64::from(y0))
            - (i64::from(y1) - i64::from(y0)) * (i64::from(x) - i64::from(x0));
        (y0 < y) != (y1 < y) && (side > 0) == (y1 < y0)
    };
    contours.into_iter().flat_map(sides).filter(crosses).count() % 2 == 1
}

/// Whether a point is so close to an edge that rounding may move the edge across it.
fn is_close(shape: &Shape, (x, y): Place) -> bool {
    shape.iter().flat_map(sides).any(|(from, to)| {
        let (dx, dy) = (f64::from(to.0 - from.0), f64::from(to.1 - from.1));
        let (px, py) = (f64::from(x - from.0), f64::from(y - from.1));
        (dx * py - dy * px).abs() <= 2.0 * dx.hypot(dy)
    })
}

fn scaled(shape: &Shape, scale: i32) -> Shape {
    let scaled = |&(x, y): &Place| (x * scale, y * scale);
    shape
        .iter()
        .map(|contour| contour.iter().map(scaled).collect())
        .collect()
}

/// Checks one operation against the reference and returns its result.
fn check<S: Precision>(subject: &Shape, clip: &Shape, operation: Operation) -> Vec<Outline> {
    check_scaled::<S>(subject, clip, operation, S::SCALE)
}

fn check_scaled<S: SubPixel>(subject: &Shape, clip: &Shape, operation: Operation, scale: i32) -> Vec<Outline> {
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

fn check_all<S: Precision>(subject: &Shape, clip: &Shape) {
    for operation in OPERATIONS {
        check::<S>(subject, clip, operation);
        check::<S>(clip, subject, operation);
    }
}

// ---- Random pairs ----

/// Removes crossings by turning what lies between them around: mostly a simple contour is left.
fn untangled(mut contour: Contour) -> Contour {
    let side = |a: Place, b: Place, c: Place| ((b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0)).signum();
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
        let square = |(x, y): Place| vec![(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)];
        cells.into_iter().map(square).collect()
    })
}

/// Rectangles and diamonds: all crossings are at half steps.
fn octilinear(size: i32) -> impl Strategy<Value = Shape> {
    let rectangle = |((x, y), (width, height)): (Place, Place)| {
        vec![(x, y), (x + width, y), (x + width, y + height), (x, y + height)]
    };
    let diamond =
        |((x, y), (size, _)): (Place, Place)| vec![(x - size, y), (x, y - size), (x + size, y), (x, y + size)];
    let place = move || ((0..size, 0..size), (1..size / 2, 1..size / 2));
    let contour = prop_oneof![place().prop_map(rectangle), place().prop_map(diamond)];
    proptest::collection::vec(contour, 1..5)
}

fn any_shape(size: i32) -> impl Strategy<Value = Shape> {
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
            let part = sutherland_hodgman_2d::<_, 8, 4>(&subject, &window).unwrap();
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

// ---- Known cases ----

fn shape(contours: &[&[Place]]) -> Shape {
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
    let full = TooSmall {
        table: Table::ContourVertices,
        needed: 16,
    };
    assert_eq!(
        clip_by::<Sub4, 8>(&near, &far, Operation::Union, 1),
        Err(InputError::TooSmall(full))
    );
}

/// A case on which another library failed, from its tracker.
struct Published {
    name: &'static str,
    subject: &'static [Place],
    clip: &'static [Place],
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

// ---- Limits ----

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
    let error = InputError::OutOfDomain(OutOfDomain { min: -8191, max: 8191 });
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
    let error = InputError::OutOfDomain(OutOfDomain { min: -1024, max: 1023 });
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
                    assert_eq!(full.table, Table::ContourVertices);
                    assert!(full.needed > N);
                    Some(full.needed)
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
