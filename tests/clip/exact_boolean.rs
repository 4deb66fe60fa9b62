//! The exact result of clipping a polygon against another one, in `i128`: its area, parts and holes.
//!
//! The plane is cut into slabs at every corner and crossing. Contours are not followed: what a result hangs together by is
//! read off the trapezoids that share more than a point.

use std::{cmp::Ordering, collections::BTreeSet};

use zrow::clip::Operation;

pub type Position = (i32, i32);
pub type Contour = Vec<Position>;
pub type Shape = Vec<Contour>;

/// A number `numerator / denominator`, the denominator above 0.
#[derive(Clone, Copy, Debug)]
pub struct Rational(pub i128, pub i128);

impl Rational {
    pub fn new(numerator: i128, denominator: i128) -> Self {
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

pub struct Expected {
    pub area: f64,
    pub parts: usize,
    pub holes: usize,
}

pub fn keeps(operation: Operation, subject: bool, clip: bool) -> bool {
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

pub fn expected(subject: &Shape, clip: &Shape, operation: Operation) -> Expected {
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
