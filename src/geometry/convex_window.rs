//! A closed convex window at sub-pixel precision: what segments and polygons of any direction are clipped to.

use crate::geometry::{FixedPointWindow, InputError, SubPixel, SubPoint};

/// A closed convex polygon at sub-pixel precision `S`, checked once; corners clockwise or counter-clockwise.
///
/// The window borrows its corners, so it takes the room of its bounds. All of it lies in the domain of `S`: whatever is cut to it
/// does too.
///
/// ```
/// use zrow::geometry::{ConvexWindow, InputError, Sub8, SubPoint};
///
/// let at = SubPoint::<Sub8>::from_units;
/// let diamond = [at(0, -900)?, at(900, 0)?, at(0, 900)?, at(-900, 0)?];
/// assert!(ConvexWindow::new(&diamond).is_ok());
/// let dart = [at(0, -900)?, at(900, 900)?, at(0, 300)?, at(-900, 900)?];
/// assert_eq!(ConvexWindow::new(&dart).err(), Some(InputError::ConcaveCorner { corner: 2 }));
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct ConvexWindow<'a, S: SubPixel> {
    corners: &'a [SubPoint<S>],
    bounds: FixedPointWindow<S>,
    turns_right: bool,
    is_upright: bool,
}

impl<'a, S: SubPixel> ConvexWindow<'a, S> {
    /// The window with these corners, in either orientation; the last one is joined to the first.
    ///
    /// Cost: two products a corner.
    ///
    /// # Errors
    /// [`InputError`] says what is wrong, and where. Repeated corners are refused, and so are corners on a straight line
    /// with their neighbours.
    pub fn new(corners: &'a [SubPoint<S>]) -> Result<Self, InputError> {
        let (Some(&first), Some(&last), true) = (corners.first(), corners.last(), corners.len() >= 3) else {
            return Err(InputError::TooFewCorners);
        };
        let bounds = bounds(corners, first)?;
        let mut turns_right = None;
        let mut reversals = 0u32;
        let mut is_upright = true;
        let mut before = last;
        for (number, &corner) in corners.iter().enumerate() {
            let after = corners.get(number + 1).copied().unwrap_or(first);
            let (arriving, leaving) = (SideLine::new(before, corner), SideLine::new(corner, after));
            let turn = arriving.distance(after);
            if turn == 0 {
                return Err(InputError::StraightCorner { corner: number });
            }
            if *turns_right.get_or_insert(turn > 0) != (turn > 0) {
                return Err(InputError::ConcaveCorner { corner: number });
            }
            reversals += u32::from(arriving.goes_down() != leaving.goes_down());
            is_upright &= leaving.is_upright();
            before = corner;
        }
        // Once around, a direction goes down for one half of the turn and up for the other.
        if reversals != 2 {
            return Err(InputError::CrossingSides);
        }
        Ok(Self {
            corners,
            bounds,
            turns_right: turns_right.unwrap_or_default(),
            is_upright,
        })
    }

    /// The corners, in the order in which they were given.
    pub const fn corners(&self) -> &'a [SubPoint<S>] {
        self.corners
    }

    /// The bounding box of the window, against which outcodes are computed.
    pub const fn bounds(&self) -> &FixedPointWindow<S> {
        &self.bounds
    }

    /// Whether the point is inside or on a side.
    pub fn contains(&self, point: SubPoint<S>) -> bool {
        self.sides().all(|side| side.distance(point) >= 0)
    }

    /// Whether all sides of the window are horizontal or vertical.
    pub(crate) const fn is_upright(&self) -> bool {
        self.is_upright
    }

    /// The sides of the window, with the inside to the right of each; number `n` joins corner `n` to the next one.
    pub(crate) fn sides(&self) -> impl Iterator<Item = SideLine> + use<'_, 'a, S> {
        (0..self.corners.len()).filter_map(|number| self.side(number))
    }

    /// The side from corner `number` to the next one; `None` where there is no such corner.
    pub(crate) fn side(&self, number: usize) -> Option<SideLine> {
        let start = self.corners.get(number)?;
        let end = self.corners.get(number + 1).or(self.corners.first())?;
        Some(if self.turns_right {
            SideLine::new(*start, *end)
        } else {
            SideLine::new(*end, *start)
        })
    }
}

fn bounds<S: SubPixel>(corners: &[SubPoint<S>], first: SubPoint<S>) -> Result<FixedPointWindow<S>, InputError> {
    let (mut top_left, mut bottom_right) = (first, first);
    for corner in corners {
        top_left.x = top_left.x.min(corner.x);
        top_left.y = top_left.y.min(corner.y);
        bottom_right.x = bottom_right.x.max(corner.x);
        bottom_right.y = bottom_right.y.max(corner.y);
    }
    FixedPointWindow::new(top_left, bottom_right)
}

/// The straight line through two corners, in units, with a direction.
#[derive(Debug, Copy, Clone)]
pub(crate) struct SideLine {
    x: i32,
    y: i32,
    dx: i32,
    dy: i32,
}

impl SideLine {
    fn new<S: SubPixel>(start: SubPoint<S>, end: SubPoint<S>) -> Self {
        // Corners are in the domain, so differences fit.
        Self {
            x: start.x_units(),
            y: start.y_units(),
            dx: end.x_units() - start.x_units(),
            dy: end.y_units() - start.y_units(),
        }
    }

    /// How far to the right of the line a point is, in units times the length of the side; negative to the left.
    ///
    /// A side is below 2^22 units along each axis and a point below 2^32 away: below 2^55. With 16-bit coordinates below
    /// 2^15 and 49,152: below 2^32.
    pub(crate) fn distance<S: SubPixel>(&self, point: SubPoint<S>) -> i64 {
        let (x, y) = (i64::from(point.x_units()), i64::from(point.y_units()));
        let (from_start_x, from_start_y) = (x - i64::from(self.x), y - i64::from(self.y));
        i64::from(self.dx) * from_start_y - i64::from(self.dy) * from_start_x
    }

    /// Whether the line is horizontal or vertical.
    pub(crate) const fn is_upright(&self) -> bool {
        self.dx == 0 || self.dy == 0
    }

    /// Whether y grows along the line, or stays while x grows.
    const fn goes_down(&self) -> bool {
        self.dy > 0 || self.dy == 0 && self.dx > 0
    }
}

#[cfg(feature = "defmt")]
impl<S: SubPixel> defmt::Format for ConvexWindow<'_, S> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "ConvexWindow {=[?]}", self.corners);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Sub4;
    use fixed::types::I12F4;

    fn error(corners: &[(i32, i32)]) -> Option<InputError> {
        let corners: heapless::Vec<_, 8> = corners
            .iter()
            .map(|&(x, y)| SubPoint::<Sub4> {
                x: I12F4::from_bits(x as i16),
                y: I12F4::from_bits(y as i16),
            })
            .collect();
        ConvexWindow::new(&corners).err()
    }

    #[test]
    fn both_orientations_are_convex() {
        let mut corners = [(0, 0), (50, -10), (90, 40), (20, 70)];
        assert_eq!(error(&corners), None);
        corners.reverse();
        assert_eq!(error(&corners), None);
    }

    #[test]
    fn the_error_says_what_is_wrong() {
        assert_eq!(error(&[(0, 0), (9, 9)]), Some(InputError::TooFewCorners));
        let repeated = [(0, 0), (9, 0), (9, 0), (0, 9)];
        assert_eq!(error(&repeated), Some(InputError::StraightCorner { corner: 1 }));
        let straight = [(0, 0), (9, 0), (18, 0), (0, 9)];
        assert_eq!(error(&straight), Some(InputError::StraightCorner { corner: 1 }));
        let spike = [(0, 0), (9, 0), (20, 0), (9, 0), (9, 9)];
        assert_eq!(error(&spike), Some(InputError::StraightCorner { corner: 1 }));
        let bow_tie = [(1, 1), (8, 1), (1, 8), (8, 8)];
        assert_eq!(error(&bow_tie), Some(InputError::ConcaveCorner { corner: 2 }));
        let star = [(0, -24), (14, 19), (-23, -7), (23, -7), (-14, 19)];
        assert_eq!(error(&star), Some(InputError::CrossingSides));
        let far = [(0, 0), (0x7fff, 0), (0, 9)];
        assert_eq!(error(&far), Some(InputError::OutOfDomain { min: -1024, max: 1023 }));
    }
}
