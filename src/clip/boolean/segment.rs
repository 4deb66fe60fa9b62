//! Edges as segments: where two of them meet, decided exactly, and the meeting point, rounded once.

use crate::{
    clip::{boolean::direction::Direction, convex::convex_crossing::Fraction},
    geometry::{SubPixel, SubPoint},
};

/// An edge from one corner to the next; its ends differ.
#[derive(Debug, Copy, Clone)]
pub(crate) struct ExactSegment<S: SubPixel> {
    pub(crate) start: SubPoint<S>,
    pub(crate) end: SubPoint<S>,
}

/// A closed rectangle, in units.
#[derive(Debug, Copy, Clone)]
pub(crate) struct Extent {
    left: i32,
    top: i32,
    right: i32,
    bottom: i32,
}

impl Extent {
    /// A box around nothing, which meets no other.
    const EMPTY: Self = Self {
        left: i32::MAX,
        top: i32::MAX,
        right: i32::MIN,
        bottom: i32::MIN,
    };

    pub(crate) fn of<S: SubPixel>(points: impl IntoIterator<Item = SubPoint<S>>) -> Self {
        points.into_iter().fold(Self::EMPTY, |extent, point| Self {
            left: extent.left.min(point.x_units()),
            top: extent.top.min(point.y_units()),
            right: extent.right.max(point.x_units()),
            bottom: extent.bottom.max(point.y_units()),
        })
    }

    pub(crate) const fn meets(&self, other: &Self) -> bool {
        self.left <= other.right && other.left <= self.right && self.top <= other.bottom && other.top <= self.bottom
    }
}

/// How two edges meet. Foster, Hormann and Popa's kinds of intersection: X is `crossing`, T is one of the two touches, V
/// is `same_start`, and edges on one line that overlap have two of these at the ends of what they share.
///
/// Where an edge ends is where the next one starts, so only starts are asked for: each corner comes up once.
#[derive(Debug, Copy, Clone, Default)]
pub(crate) struct Meeting {
    /// The two edges cross at a point inside both.
    pub(crate) crossing: bool,
    /// Both edges start at the same point.
    pub(crate) same_start: bool,
    /// The first one starts inside the second one.
    pub(crate) first_touches: bool,
    /// The second one starts inside the first one.
    pub(crate) second_touches: bool,
}

impl Meeting {
    pub(crate) fn of<S: SubPixel>(first: &ExactSegment<S>, second: &ExactSegment<S>) -> Self {
        let first_sides = (second.side(first.start), second.side(first.end));
        let second_sides = (first.side(second.start), first.side(second.end));
        Self {
            crossing: are_opposite(first_sides) && are_opposite(second_sides),
            same_start: first.start == second.start,
            first_touches: first_sides.0 == 0 && second.has_inside(first.start),
            second_touches: second_sides.0 == 0 && first.has_inside(second.start),
        }
    }

    /// How many vertices it adds at most.
    pub(crate) fn vertices(self) -> usize {
        2 * usize::from(self.crossing) + usize::from(self.first_touches) + usize::from(self.second_touches)
    }
}

const fn are_opposite((one, other): (i64, i64)) -> bool {
    one < 0 && other > 0 || one > 0 && other < 0
}

impl<S: SubPixel> ExactSegment<S> {
    pub(crate) fn direction(&self) -> Direction {
        Direction::between(self.start, self.end)
    }

    pub(crate) fn extent(&self) -> Extent {
        Extent::of([self.start, self.end])
    }

    /// Twice the area of the triangle with a point; above 0 where that lies on the positive side. Below 2^46 in size.
    pub(crate) fn side(&self, point: SubPoint<S>) -> i64 {
        self.direction().cross(Direction::between(self.start, point))
    }

    /// Whether a point of its line lies between its ends.
    fn has_inside(&self, point: SubPoint<S>) -> bool {
        point != self.start && point != self.end && self.extent().meets(&Extent::of([point]))
    }

    /// Whether it is crossed by the ray against the x axis that starts a little beside a point, at less x and, by much
    /// less, at less y: so no corner lies on the ray.
    pub(crate) fn crosses_ray_to(&self, point: SubPoint<S>) -> bool {
        let (starts, ends) = (self.start.y < point.y, self.end.y < point.y);
        starts != ends
            && if starts {
                self.side(point) < 0
            } else {
                self.side(point) > 0
            }
    }

    /// How far along it one of its points is.
    pub(crate) fn fraction_of_point(&self, point: SubPoint<S>) -> Fraction {
        let (start, end) = (
            Direction::between(point, self.start),
            Direction::between(point, self.end),
        );
        let (from, to) = self.direction().longer_axis(start, end);
        Fraction::of_crossing(from.into(), to.into())
    }

    /// How far along it another one crosses it.
    pub(crate) fn fraction_of_crossing(&self, other: &Self) -> Fraction {
        Fraction::of_crossing(other.side(self.start), other.side(self.end))
    }

    /// The nearest unit to the point at a fraction, ties to larger coordinates.
    ///
    /// The exact point is alike from both ends and from the edge that crosses, so the rounded one is too.
    pub(crate) fn point_at(&self, fraction: Fraction) -> SubPoint<S> {
        // Between its ends, so in the domain.
        fraction.point(self.start, self.end).unwrap_or(self.start)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Sub8;

    #[test]
    fn a_half_goes_to_the_larger_coordinate_from_either_end() {
        let point = |x, y| SubPoint::<Sub8>::from_units(x, y).unwrap();
        let fall = ExactSegment {
            start: point(0, 5),
            end: point(5, 0),
        };
        let rise = ExactSegment {
            start: point(0, 0),
            end: point(5, 5),
        };
        assert!(Meeting::of(&fall, &rise).crossing);
        for (one, other) in [(fall, rise), (rise, fall)] {
            assert_eq!(one.point_at(one.fraction_of_crossing(&other)), point(3, 3));
            let back = ExactSegment {
                start: one.end,
                end: one.start,
            };
            assert_eq!(back.point_at(back.fraction_of_crossing(&other)), point(3, 3));
        }
    }
}
