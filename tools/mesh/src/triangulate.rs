//! Cuts a polygon into triangles by ear clipping (Meisters 1975; O'Rourke, "Computational Geometry in C", 1998), exactly, in
//! integers.
//!
//! An ear is a corner whose triangle with its two neighbours lies within the polygon. Every simple polygon with more than three
//! corners has two of them; what is left when one is cut off is simple again.
//!
//! ```text
//!   a-------b
//!    \     /     b is an ear: nothing lies in the triangle a, b, c.
//!     d---c      d is none: the polygon turns the other way there.
//! ```
//!
//! Each corner of the polygon is a corner of a triangle, also in the middle of a straight side: the crates for this leave such
//! corners out, and a neighbour that has a vertex there would show a gap.

/// The triangles of a polygon, as indices of its corners in their order.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Triangulated {
    /// The triangles. None is without area.
    pub triangles: Vec<[usize; 3]>,
    /// Whether they cover the polygon once: not where its outline crosses itself.
    pub is_exact: bool,
}

/// A corner as seen along the axis that shows most of the polygon.
type Flat = [i64; 2];

/// Cuts a polygon into triangles; a polygon without area has none.
///
/// Of all ears, that with the shortest diagonal is cut off. Takes a time in the square of the corners.
pub fn triangulate(corners: &[[i16; 3]]) -> Triangulated {
    let indices = without_repetition(corners);
    let views = [[1, 2], [2, 0], [0, 1]].map(|axes| view(corners, &indices, axes));
    let Some(flat) = largest(&views) else {
        return Triangulated {
            triangles: Vec::new(),
            is_exact: views.iter().all(|view| is_straight(view)),
        };
    };
    let solid: Vec<[i16; 3]> = indices.iter().map(|&index| corners[index]).collect();
    let (ears, is_exact) = Ring::new(&flat, &solid).clip_ears();
    Triangulated {
        triangles: ears
            .into_iter()
            .map(|ear| ordered(ear).map(|index| indices[index]))
            .collect(),
        is_exact,
    }
}

/// A triangle that begins with its first corner.
fn ordered([a, b, c]: [usize; 3]) -> [usize; 3] {
    if a < b && a < c {
        [a, b, c]
    } else if b < c {
        [b, c, a]
    } else {
        [c, a, b]
    }
}

/// The indices of corners that differ from the one before them.
fn without_repetition(corners: &[[i16; 3]]) -> Vec<usize> {
    let before = |index: usize| if index == 0 { corners.len() - 1 } else { index - 1 };
    (0..corners.len())
        .filter(|&index| corners[index] != corners[before(index)])
        .collect()
}

/// The corners in two dimensions.
fn view(corners: &[[i16; 3]], indices: &[usize], axes: [usize; 2]) -> Vec<Flat> {
    let flat = |&index: &usize| axes.map(|axis| i64::from(corners[index][axis]));
    indices.iter().map(flat).collect()
}

/// That view of a polygon in which it is largest, counter-clockwise.
fn largest(views: &[Vec<Flat>; 3]) -> Option<Vec<Flat>> {
    let view = views.iter().max_by_key(|view| twice_area(view).abs())?;
    let mut view = view.clone();
    let area = twice_area(&view);
    if area < 0 {
        for point in &mut view {
            point.swap(0, 1);
        }
    }
    (area != 0).then_some(view)
}

/// Whether all corners lie on a line.
fn is_straight(view: &[Flat]) -> bool {
    let Some(&first) = view.first() else {
        return true;
    };
    let second = view.iter().copied().find(|&point| point != first);
    second.is_none_or(|second| view.iter().all(|&point| turn(first, second, point) == 0))
}

/// Twice the area of a polygon by the shoelace formula, positive if it is counter-clockwise.
fn twice_area(points: &[Flat]) -> i64 {
    let next = points.iter().cycle().skip(1);
    points
        .iter()
        .zip(next)
        .map(|(one, other)| one[0] * other[1] - one[1] * other[0])
        .sum()
}

/// Positive where a way from `a` over `b` to `c` turns to the left: twice the area of the triangle.
fn turn(a: Flat, b: Flat, c: Flat) -> i64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// The corners that are left, linked in a ring.
struct Ring<'a> {
    points: &'a [Flat],
    solid: &'a [[i16; 3]],
    next: Vec<usize>,
    previous: Vec<usize>,
    /// Whether each corner is an ear; that changes only when a neighbour is cut off.
    is_ear: Vec<bool>,
    first: usize,
    count: usize,
}

impl<'a> Ring<'a> {
    fn new(points: &'a [Flat], solid: &'a [[i16; 3]]) -> Self {
        let count = points.len();
        let mut ring = Self {
            points,
            solid,
            next: (0..count).map(|index| (index + 1) % count).collect(),
            previous: (0..count).map(|index| (index + count - 1) % count).collect(),
            is_ear: vec![false; count],
            first: 0,
            count,
        };
        for corner in 0..count {
            ring.is_ear[corner] = ring.finds_ear(corner);
        }
        ring
    }

    /// The triangles, and whether all of them are ears.
    fn clip_ears(mut self) -> (Vec<[usize; 3]>, bool) {
        let mut triangles = Vec::with_capacity(self.count.saturating_sub(2));
        let mut is_exact = true;
        while self.count >= 3 {
            let corner = self.choose();
            let triangle = self.triangle(corner);
            if self.turn_of(triangle) > 0 {
                triangles.push(triangle);
            }
            is_exact &= self.class(corner) <= 1;
            self.cut_off(corner);
        }
        (triangles, is_exact)
    }

    /// The ear with the shortest diagonal. Where the outline crosses itself there may be none.
    fn choose(&self) -> usize {
        let rank = |&corner: &usize| (self.class(corner), self.diagonal(corner), corner);
        self.corners().min_by_key(rank).unwrap_or(self.first)
    }

    /// How little is wrong where a corner is cut off: an ear, a corner that covers nothing, a convex one, any.
    fn class(&self, corner: usize) -> u32 {
        match (self.is_ear[corner], self.turn_of(self.triangle(corner))) {
            (true, _) => 0,
            (false, 0) => 1,
            (false, 1..) => 2,
            (false, _) => 3,
        }
    }

    fn corners(&self) -> impl Iterator<Item = usize> + '_ {
        let following = |&corner: &usize| Some(self.next[corner]);
        std::iter::successors(Some(self.first), following).take(self.count)
    }

    fn triangle(&self, corner: usize) -> [usize; 3] {
        [self.previous[corner], corner, self.next[corner]]
    }

    fn turn_of(&self, [a, b, c]: [usize; 3]) -> i64 {
        turn(self.points[a], self.points[b], self.points[c])
    }

    /// The square of the length of the side that a triangle gets within the polygon.
    fn diagonal(&self, corner: usize) -> i64 {
        let (one, other) = (self.solid[self.previous[corner]], self.solid[self.next[corner]]);
        let squares = one
            .iter()
            .zip(other)
            .map(|(&one, other)| (i64::from(one) - i64::from(other)).pow(2));
        squares.sum()
    }

    fn cut_off(&mut self, corner: usize) {
        let [before, _, behind] = self.triangle(corner);
        self.next[before] = behind;
        self.previous[behind] = before;
        self.first = behind;
        self.count -= 1;
        self.is_ear[before] = self.finds_ear(before);
        self.is_ear[behind] = self.finds_ear(behind);
    }

    fn finds_ear(&self, corner: usize) -> bool {
        let triangle = self.triangle(corner);
        self.turn_of(triangle) > 0 && !self.corners().any(|other| self.blocks(triangle, other))
    }

    /// Whether a corner lies in a triangle or on its sides. One that lies on a corner of the triangle, as where an outline
    /// goes to a hole and back, blocks if the outline runs into the triangle there.
    fn blocks(&self, triangle: [usize; 3], other: usize) -> bool {
        if triangle.contains(&other) {
            return false;
        }
        let [a, b, c] = triangle.map(|corner| self.points[corner]);
        let point = self.points[other];
        let is_within = turn(a, b, point) >= 0 && turn(b, c, point) >= 0 && turn(c, a, point) >= 0;
        if !is_within {
            return false;
        }
        let neighbours = [self.previous[other], self.next[other]].map(|corner| self.points[corner]);
        let runs_between = |right: Flat, left: Flat| {
            neighbours
                .iter()
                .any(|&end| turn(point, right, end) > 0 && turn(point, end, left) > 0)
        };
        match point {
            point if point == a => runs_between(b, c),
            point if point == b => runs_between(c, a),
            point if point == c => runs_between(a, b),
            _ => true,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A polygon in a plane that lies askew.
    fn solid(points: &[[i16; 2]]) -> Vec<[i16; 3]> {
        points.iter().map(|&[x, y]| [x, y, 3 * x - 2 * y]).collect()
    }

    /// Cuts a polygon, and checks that the triangles have its area, its orientation and all its corners.
    fn check(points: &[[i16; 2]]) -> Triangulated {
        let found = triangulate(&solid(points));
        let flat: Vec<Flat> = points.iter().map(|point| point.map(i64::from)).collect();
        let areas = found.triangles.iter().map(|&[a, b, c]| turn(flat[a], flat[b], flat[c]));
        let areas: Vec<i64> = areas.collect();
        assert_eq!(areas.iter().sum::<i64>(), twice_area(&flat), "{points:?}");
        assert!(
            areas.iter().all(|&area| area.signum() == twice_area(&flat).signum()),
            "{points:?}"
        );
        assert_eq!(found.triangles.len(), points.len() - 2, "{points:?}");
        assert!(found.is_exact);
        assert!((0..points.len()).all(|corner| found.triangles.iter().flatten().any(|&index| index == corner)));
        found
    }

    /// xorshift32.
    fn random(state: &mut u32, below: u32) -> u32 {
        *state ^= *state << 13;
        *state ^= *state >> 17;
        *state ^= *state << 5;
        *state % below
    }

    #[test]
    fn concave_polygons_have_their_area() {
        let arrow = [[0, 0], [40, 0], [10, 10], [0, 40]];
        // The shorter one of its two diagonals.
        assert_eq!(check(&arrow).triangles, [[0, 1, 2], [0, 2, 3]]);
        check(&[
            [0, 0],
            [50, 0],
            [50, 10],
            [40, 10],
            [40, 5],
            [30, 5],
            [30, 10],
            [20, 10],
            [20, 5],
            [0, 5],
        ]);
        let mut spiral = vec![
            [0, 0],
            [90, 0],
            [90, 90],
            [10, 90],
            [10, 20],
            [70, 20],
            [70, 70],
            [30, 70],
            [30, 40],
            [50, 40],
        ];
        spiral.extend([
            [50, 50],
            [40, 50],
            [40, 60],
            [60, 60],
            [60, 30],
            [20, 30],
            [20, 80],
            [80, 80],
            [80, 10],
            [0, 10],
        ]);
        check(&spiral);
        spiral.reverse();
        check(&spiral);
    }

    /// Corners in the middle of straight sides are kept: neighbours have vertices there.
    #[test]
    fn straight_corners_are_kept() {
        check(&[[0, 0], [1, 0], [2, 0], [3, 0], [3, 3], [2, 3], [0, 3], [0, 2], [0, 1]]);
        check(&[[0, 0], [9, 0], [0, 9], [0, 5], [0, 4]]);
    }

    /// The outline of a square goes to a square hole in it, around that, and back.
    #[test]
    fn a_hole_is_left_out() {
        check(&[
            [0, 0],
            [90, 0],
            [90, 90],
            [0, 90],
            [0, 0],
            [30, 30],
            [30, 60],
            [60, 60],
            [60, 30],
            [30, 30],
        ]);
        let two = [
            [0, 0],
            [20, 20],
            [20, 30],
            [30, 20],
            [20, 20],
            [0, 0],
            [90, 0],
            [90, 90],
            [80, 80],
            [80, 70],
            [70, 80],
            [80, 80],
            [90, 90],
            [0, 90],
        ];
        check(&two);
    }

    /// Stars around a point, with random distances: simple, mostly concave, some corners in line.
    #[test]
    fn random_polygons_have_their_area() {
        let mut state = 0x9e37_79b9;
        for _ in 0..400 {
            let count = 3 + random(&mut state, 40) as usize;
            let corner = |(index, distance): (usize, u32)| {
                let angle = index as f64 / count as f64 * std::f64::consts::TAU;
                [angle.cos(), angle.sin()].map(|part| (part * f64::from(distance)).round() as i16)
            };
            let distances: Vec<u32> = (0..count).map(|_| 500 + random(&mut state, 2_500)).collect();
            let mut points: Vec<[i16; 2]> = distances.into_iter().enumerate().map(corner).collect();
            if random(&mut state, 2) == 0 {
                points.reverse();
            }
            check(&points);
        }
    }

    #[test]
    fn what_has_no_area_has_no_triangles() {
        for points in [
            &[][..],
            &[[1, 1]],
            &[[1, 1], [1, 1], [1, 1]],
            &[[0, 0], [5, 5], [9, 9]],
            &[[0, 0], [5, 5], [9, 9], [5, 5]],
        ] {
            let found = triangulate(&solid(points));
            assert!(found.triangles.is_empty() && found.is_exact, "{points:?}");
        }
        let twice = triangulate(&solid(&[[0, 0], [0, 0], [9, 0], [9, 9], [9, 9]]));
        assert_eq!(twice.triangles.len(), 1);
    }

    #[test]
    fn an_outline_that_crosses_itself_is_found() {
        let bow = [[0, 0], [30, 0], [10, 20], [30, 30]];
        let bow_without_area = [[0, 0], [30, 0], [0, 30], [30, 30]];
        let pentagram = [[0, 100], [59, -81], [-95, 31], [95, 31], [-59, -81]];
        for points in [&bow[..], &bow_without_area, &pentagram] {
            assert!(!triangulate(&solid(points)).is_exact, "{points:?}");
        }
    }

    /// A zigzag has as many reflex corners as convex ones.
    #[test]
    fn many_corners_take_a_moment() {
        let upper = (0..512)
            .rev()
            .map(|index| [20 * index, if index % 2 == 0 { 900 } else { 100 }]);
        let lower = (0..512).map(|index| [20 * index, if index % 2 == 0 { 0 } else { -800 }]);
        let points: Vec<[i16; 2]> = lower.chain(upper).collect();
        let start = std::time::Instant::now();
        let flat: Vec<[i16; 3]> = points.iter().map(|&[x, y]| [x, y, 0]).collect();
        assert!(triangulate(&flat).is_exact);
        assert!(start.elapsed().as_secs() < 5);
    }
}
