//! Edges as segments: where two of them meet, decided exactly, and the meeting point, rounded once.

use core::cmp::Ordering;

use crate::{
    clip::greiner_hormann::direction::Direction,
    geometry::{SubPixel, SubPoint},
};

/// An edge from one corner to the next; its ends differ.
#[derive(Debug, Copy, Clone)]
pub(super) struct Segment<S: SubPixel> {
    pub(super) start: SubPoint<S>,
    pub(super) end: SubPoint<S>,
}

/// A closed rectangle, in units.
#[derive(Debug, Copy, Clone)]
pub(super) struct Extent {
    left: i32,
    top: i32,
    right: i32,
    bottom: i32,
}

impl Extent {
    /// Around nothing: meets nothing.
    const EMPTY: Self = Self {
        left: i32::MAX,
        top: i32::MAX,
        right: i32::MIN,
        bottom: i32::MIN,
    };

    pub(super) fn of<S: SubPixel>(points: impl IntoIterator<Item = SubPoint<S>>) -> Self {
        points.into_iter().fold(Self::EMPTY, |extent, point| Self {
            left: extent.left.min(point.x_units()),
            top: extent.top.min(point.y_units()),
            right: extent.right.max(point.x_units()),
            bottom: extent.bottom.max(point.y_units()),
        })
    }

    pub(super) const fn meets(&self, other: &Self) -> bool {
        self.left <= other.right && other.left <= self.right && self.top <= other.bottom && other.top <= self.bottom
    }
}

/// How two edges meet. Foster, Hormann and Popa's kinds of intersection: X is `crossing`, T is one of the two touches, V
/// is `same_start`, and edges on one line that overlap have two of these at the ends of what they share.
///
/// Where an edge ends is where the next one starts, so only starts are asked for: each corner comes up once.
#[derive(Debug, Copy, Clone, Default)]
pub(super) struct Meeting {
    /// They cross at a point inside both.
    pub(super) crossing: bool,
    /// Both start at the same point.
    pub(super) same_start: bool,
    /// The first one starts inside the second one.
    pub(super) first_touches: bool,
    /// The second one starts inside the first one.
    pub(super) second_touches: bool,
}

impl Meeting {
    pub(super) fn of<S: SubPixel>(first: &Segment<S>, second: &Segment<S>) -> Self {
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
    pub(super) fn vertices(self) -> usize {
        2 * usize::from(self.crossing) + usize::from(self.first_touches) + usize::from(self.second_touches)
    }
}

const fn are_opposite((one, other): (i64, i64)) -> bool {
    one < 0 && other > 0 || one > 0 && other < 0
}

/// How far along an edge a point is: `part / whole` of the way.
///
/// Both are below 2^47: `whole` is at most the sum of two orientations.
#[derive(Debug, Copy, Clone)]
pub(super) struct Fraction {
    part: u64,
    whole: u64,
}

impl Fraction {
    /// Exact. The products have up to 93 bits; multiplying once is the only use of 128-bit numbers.
    pub(super) fn order(self, other: Self) -> Ordering {
        let product = |one: u64, other: u64| u128::from(one) * u128::from(other);
        product(self.part, other.whole).cmp(&product(other.part, self.whole))
    }
}

impl<S: SubPixel> Segment<S> {
    pub(super) fn direction(&self) -> Direction {
        Direction::between(self.start, self.end)
    }

    pub(super) fn extent(&self) -> Extent {
        Extent::of([self.start, self.end])
    }

    /// Twice the area of the triangle with a point; above 0 where that lies on the positive side. Below 2^46 in size.
    pub(super) fn side(&self, point: SubPoint<S>) -> i64 {
        self.direction().cross(Direction::between(self.start, point))
    }

    /// Whether a point of its line lies between its ends.
    fn has_inside(&self, point: SubPoint<S>) -> bool {
        point != self.start && point != self.end && self.extent().meets(&Extent::of([point]))
    }

    /// Whether it is crossed by the ray against the x axis that starts a little beside a point, at less x and, by much
    /// less, at less y: so no corner lies on the ray.
    pub(super) fn crosses_ray_to(&self, point: SubPoint<S>) -> bool {
        let (starts, ends) = (self.start.y < point.y, self.end.y < point.y);
        starts != ends
            && if starts {
                self.side(point) < 0
            } else {
                self.side(point) > 0
            }
    }

    /// How far along it one of its points is.
    pub(super) fn fraction_of_point(&self, point: SubPoint<S>) -> Fraction {
        let (x, y) = (
            self.start.x_units().abs_diff(self.end.x_units()),
            self.start.y_units().abs_diff(self.end.y_units()),
        );
        let (part, whole) = if x >= y {
            (self.start.x_units().abs_diff(point.x_units()), x)
        } else {
            (self.start.y_units().abs_diff(point.y_units()), y)
        };
        Fraction {
            part: part.into(),
            whole: whole.into(),
        }
    }

    /// How far along it another one crosses it.
    pub(super) fn fraction_of_crossing(&self, other: &Self) -> Fraction {
        let part = other.side(self.start).unsigned_abs();
        Fraction {
            part,
            whole: part + other.side(self.end).unsigned_abs(),
        }
    }

    /// The nearest point to the place at a fraction, ties to larger coordinates; never outside its extent.
    ///
    /// The exact place is the same from both ends and from the edge that crosses, so the rounded one is too.
    pub(super) fn point_at(&self, fraction: Fraction) -> SubPoint<S> {
        let nearest = |start: i32, end: i32| {
            // From the smaller coordinate to the larger one.
            if start <= end {
                start.wrapping_add_unsigned(nearest_part(start.abs_diff(end), fraction.part, fraction.whole))
            } else {
                let rest = fraction.whole - fraction.part;
                end.wrapping_add_unsigned(nearest_part(start.abs_diff(end), rest, fraction.whole))
            }
        };
        let x = nearest(self.start.x_units(), self.end.x_units());
        let y = nearest(self.start.y_units(), self.end.y_units());
        // Between its ends, so in the domain.
        SubPoint::from_units(x, y).unwrap_or(self.start)
    }
}

/// `length * part / whole` to the nearest integer, half up.
///
/// A length has 22 bits and a part 46: the product of the two is taken in two halves of the length, as in long division.
fn nearest_part(length: u32, part: u64, whole: u64) -> u32 {
    const HALF: u32 = 11;
    let divide = |dividend: u64| {
        let quotient = dividend.checked_div(whole).unwrap_or(0);
        (quotient, dividend - quotient * whole)
    };
    let (high, rest) = divide(u64::from(length >> HALF) * part);
    let (low, rest) = divide((rest << HALF) + u64::from(length & ((1 << HALF) - 1)) * part);
    let rounds_up = rest >= whole - rest;
    // At most the length.
    ((high << HALF) + low) as u32 + u32::from(rounds_up)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Sub8;

    #[test]
    fn the_largest_products_are_divided_exactly() {
        let whole = (1 << 46) - 3;
        for length in [0, 1, 2047, 2048, 4_193_792] {
            for part in [0, 1, 5, whole / 2, whole / 2 + 1, whole - 1, whole] {
                let product = 2 * u128::from(length) * u128::from(part) + u128::from(whole);
                let nearest = (product / (2 * u128::from(whole))) as u32;
                assert_eq!(nearest_part(length, part, whole), nearest);
            }
        }
    }

    #[test]
    fn a_half_goes_to_the_larger_coordinate_from_either_end() {
        let point = |x, y| SubPoint::<Sub8>::from_units(x, y).unwrap();
        let fall = Segment {
            start: point(0, 5),
            end: point(5, 0),
        };
        let rise = Segment {
            start: point(0, 0),
            end: point(5, 5),
        };
        assert!(Meeting::of(&fall, &rise).crossing);
        for (one, other) in [(fall, rise), (rise, fall)] {
            assert_eq!(one.point_at(one.fraction_of_crossing(&other)), point(3, 3));
            let back = Segment {
                start: one.end,
                end: one.start,
            };
            assert_eq!(back.point_at(back.fraction_of_crossing(&other)), point(3, 3));
        }
    }
}
