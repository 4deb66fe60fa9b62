//! The polygons of a wide stroke one by one, each by a number: for strokes of which a part is needed at a time.
//!
//! ```text
//!         number 2 * 1 + 1: the join at vertex 1
//!        1
//!       / \   number 2 * 1: the rectangle along the segment that begins at vertex 1
//!      0   2
//! ```
//!
//! Of vertices at one position that follow each other, the last one counts. A path whose vertices all lie at one position is a
//! dot: the rectangle with number 0.
//!
//! Guarantees: the polygons of [`wide_stroke`](crate::scan::stroke::wide_stroke), the same corners. Cost: a look at the
//! neighbours of a vertex, and what the polygon costs by itself: square roots are not shared.

use core::ops::Range;

use crate::scan::stroke::wide_stroke::{
    Corner, Direction, FRACTION_BITS, Offsets, Path, Position, Segment, UNIT, beyond_limit, wedge,
};

/// The number of the rectangle along the segment that begins at a vertex.
const fn rectangle_at(vertex: usize) -> usize {
    2 * vertex
}

/// The number of the join at a vertex.
const fn join_at(vertex: usize) -> usize {
    2 * vertex + 1
}

/// The vertex of the primitive with a number, and whether it is the join there.
pub(crate) const fn parts_of(primitive: usize) -> (usize, bool) {
    (primitive / 2, primitive % 2 == 1)
}

/// The number of a primitive from the number of its vertex, and whether it is the join there.
pub(crate) const fn number_of(vertex: usize, is_join: bool) -> usize {
    if is_join { join_at(vertex) } else { rectangle_at(vertex) }
}

/// How many numbers a path of so many vertices has for its primitives, some of which it may not use.
pub(crate) const fn count(vertices: usize) -> usize {
    2 * vertices
}

impl Path<'_> {
    /// Calls with each primitive of the stroke, by its number, and the rows in which it may have pixels, which may be more than
    /// it has; rows beyond 16 bits count as the last ones that there are. Asks for the vertices in order.
    // Not inlined: 1,600 bytes of flash less, of two callers in a picture.
    #[inline(never)]
    pub(crate) fn each_primitive(&self, call: &mut dyn FnMut(usize, Range<i32>)) {
        let (mut before, mut first) = (None, None);
        for (number, from, to) in self.segments() {
            match before {
                Some(before) => call(join_at(number), self.rows_of_join([before, from, to])),
                None => first = Some((number, from, to)),
            }
            call(rectangle_at(number), self.rows_of_rectangle(from, to));
            before = Some(from);
        }
        match (before, first) {
            (Some(before), Some((number, from, to))) if self.closed => {
                call(join_at(number), self.rows_of_join([before, from, to]));
            }
            (None, _) if self.count > 0 => {
                let dot = (self.vertex)(0);
                call(rectangle_at(0), self.rows_of_rectangle(dot, dot));
            }
            _ => {}
        }
    }

    /// The rows in which a primitive may have pixels, which may be more than it has, as
    /// [`each_primitive`](Self::each_primitive) gives them.
    // Not inlined: with `polygon_of`, 900 bytes of flash less in a picture.
    #[inline(never)]
    pub(crate) fn rows_of(&self, primitive: usize) -> Range<i32> {
        let (number, is_join) = parts_of(primitive);
        let (from, to) = self.segment(number);
        match self.before(number) {
            Some(before) if is_join => self.rows_of_join([before, from, to]),
            _ => self.rows_of_rectangle(from, to),
        }
    }

    /// Generates the polygon that a primitive is, if it has one. Its edges run down on the left and up on the right.
    // Not inlined: with `rows_of`, 900 bytes of flash less in a picture.
    #[inline(never)]
    pub(crate) fn polygon_of(&self, primitive: usize, sink: &mut dyn FnMut(&[Corner])) {
        let (number, is_join) = parts_of(primitive);
        let (from, to) = self.segment(number);
        if is_join {
            if let Some(before) = self.before(number).filter(|_| !beyond_limit(from)) {
                let normals = (self.normal(before, from), self.normal(from, to));
                wedge(from, normals, self.half_width, sink);
            }
            return;
        }
        let mut segment = if from == to {
            Segment::dot(from, self.half_width)
        } else {
            Segment::new(from, to)
        };
        let ends_path = from == to || !self.closed && self.after(number, to).is_none();
        segment.begins_path = from == to || !self.closed && self.before(number).is_none();
        if !segment.begins_path && !ends_path {
            segment.offsets = Some(Offsets {
                normal: self.normal(from, to),
                half_pixel: (0, 0),
            });
        }
        segment.rectangle(self.half_width, ends_path, sink);
    }

    /// Both ends of the segment that begins at a vertex; one position where there is none.
    pub(crate) fn segment(&self, number: usize) -> (Position, Position) {
        let from = (self.vertex)(number);
        let to = match number + 1 {
            next if next < self.count => (self.vertex)(next),
            _ if self.closed => (self.vertex)(0),
            _ => from,
        };
        (from, to)
    }

    /// Where the segment begins that ends at a vertex.
    pub(crate) fn before(&self, number: usize) -> Option<Position> {
        let vertex = (self.vertex)(number);
        let behind = if self.closed { number + 1..self.count } else { 0..0 };
        let mut others = (0..number).rev().chain(behind.rev()).map(self.vertex);
        others.find(|other| *other != vertex)
    }

    /// Where the segment after another one ends in an open path, of which the number of the first vertex and the end are given.
    pub(crate) fn after(&self, number: usize, end: Position) -> Option<Position> {
        let mut others = (number + 2..self.count).map(self.vertex);
        others.find(|other| *other != end)
    }

    /// The vector from the middle of the stroke to a side of a segment.
    // Not inlined: 640 bytes of flash, three times in `polygon_of`.
    #[inline(never)]
    fn normal(&self, from: Position, to: Position) -> Position {
        Direction::of((to.0 - from.0, to.1 - from.1)).normal(self.half_width)
    }

    /// How far a side of the stroke is from its middle, with half a pixel at the ends of a path, and what rounding takes.
    const fn side(&self) -> i64 {
        self.half_width + UNIT
    }

    fn rows_of_rectangle(&self, (_, from): Position, (_, to): Position) -> Range<i32> {
        rows(from.min(to) - self.side(), from.max(to) + self.side())
    }

    /// A tip points the way that the corner points. Where the path goes on up or down, that is to the left or right, and the
    /// tip is no further up or down than a side.
    fn rows_of_join(&self, [(_, before), (_, corner), (_, after)]: [Position; 3]) -> Range<i32> {
        let (side, tip) = (self.side(), 4 * self.half_width + UNIT);
        let reach = |is_peak| if is_peak { tip } else { side };
        let up = reach(corner < before && corner < after);
        let down = reach(corner > before && corner > after);
        rows(corner - up, corner + down)
    }
}

/// The rows between two ordinates, of those that 16 bits can tell.
fn rows(top: i64, bottom: i64) -> Range<i32> {
    let near = |y: i64| (y >> FRACTION_BITS).clamp(i16::MIN.into(), i16::MAX.into()) as i32;
    near(top)..near(bottom) + 1
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::vec::Vec;

    use super::*;
    use crate::scan::polygon::ceil_pixel;

    const WIDTHS_IN_HALVES: [u64; 5] = [1, 2, 3, 8, 41];

    /// Checks open and closed strokes along some vertices in several widths: each primitive has its rows also by its number, no
    /// pixels in others, and all polygons together are those of the stroke.
    fn check(vertices: &[Position]) {
        let vertex = |number: usize| vertices.get(number).copied().unwrap_or_default();
        for (width, closed) in WIDTHS_IN_HALVES
            .into_iter()
            .flat_map(|width| [(width, false), (width, true)])
        {
            let path = Path::new(&vertex, vertices.len(), closed, width);
            let (mut one_by_one, mut whole) = (Vec::new(), Vec::new());
            path.each_primitive(&mut |number, rows| {
                assert_eq!(path.rows_of(number), rows, "{number} of {vertices:?}");
                assert!(number < count(vertices.len()), "{number} of {vertices:?}");
                path.polygon_of(number, &mut |corners| {
                    let ends = corners.iter().map(|&(_, y)| ceil_pixel(y, FRACTION_BITS));
                    let (first, end) = (ends.clone().min().unwrap_or(0), ends.max().unwrap_or(0));
                    assert!(
                        rows.start <= first && end <= rows.end,
                        "{rows:?}: {corners:?} of {vertices:?}"
                    );
                    one_by_one.push(corners.to_vec());
                });
            });
            path.polygons(None, &mut |corners| whole.push(corners.to_vec()));
            one_by_one.sort();
            whole.sort();
            assert_eq!(one_by_one, whole, "{vertices:?}");
        }
    }

    /// Paths of three vertices, in steps that include level and upright ones, sharp turns and returns.
    #[test]
    fn corners_of_all_kinds() {
        let steps = || (-2..3).flat_map(|x| (-2..3).map(move |y| (x * 90_000 + y, y * 70_001 - x)));
        let add = |(x, y): Position, (right, down): Position| (x + right, y + down);
        for (one, other) in steps().flat_map(|one| steps().map(move |other| (one, other))) {
            check(&[(3, 5), add((3, 5), one), add(add((3, 5), one), other)]);
        }
    }

    /// Paths of up to six vertices of which many are equal to the ones before them, or far away.
    #[test]
    fn repeated_and_far_vertices() {
        let few = [(0, 0), (5 * UNIT, 3 * UNIT), (-40_000 * UNIT, 7 * UNIT)];
        for length in 0..7u32 {
            for path in 0..few.len().pow(length) {
                let vertices: Vec<_> = (0..length).map(|number| few[path / 3usize.pow(number) % 3]).collect();
                check(&vertices);
            }
        }
    }
}
