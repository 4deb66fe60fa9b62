//! Lines whose depth varies, drawn into the rows of a scene, one row at a time.

use core::num::{NonZeroU32, NonZeroU64};

use embedded_graphics::geometry::Point;

use crate::{
    band::Band,
    geometry::Window,
    scan::line::bresenham::line_steps,
    surface::{BandColor, LineSteps, Order},
    view::DepthWidth,
    visible::{
        DepthRow,
        depth_test::state::{DepthState, DepthTest, Test},
    },
};

/// A line between two pixels with a depth each, to be drawn into the rows of a scene: `row.draw_line(&line, color, &state)`.
///
/// Its pixels are those of [`Lines::bresenham`](crate::scan::Lines::bresenham), and in each step along its longer side the depth
/// is the nearest to the one evenly between those of its ends, whatever the order of the ends and of the rows.
///
/// [`Prepared::lines_in_depth`](crate::scene::Prepared::lines_in_depth) hands out the edges of a model as such lines. A program
/// keeps them while the rows of the frame are drawn: one that does not cross a row costs two comparisons there.
///
/// RAM: 24 bytes with depths of 16 bits, 28 with those of 32.
///
/// Source: Bresenham 1965; depths by quotient and remainder: Field 1985, "Incremental linear interpolation".
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DepthLine<D> {
    /// From top to bottom, and in one row from left to right.
    ends: [Point; 2],
    depths: [D; 2],
    /// The greatest slope of what the line lies on, with the fractional bits of interpolated depths.
    slope: u32,
}

impl<D: DepthWidth> DepthLine<D> {
    /// The line between two pixels, both included, with the depths as they are stored. Its slope for a
    /// [`PolygonOffset`](crate::visible::PolygonOffset) is that along the line, from one of its pixels to the next.
    ///
    /// Where both ends are in one pixel, that pixel has the nearer of the two depths.
    pub fn new(ends: [(Point, D); 2]) -> Self {
        let [(a, at_a), (b, at_b)] = ends;
        let is_in_order = if a == b { at_a >= at_b } else { (a.y, a.x) <= (b.y, b.x) };
        let (ends, depths) = if is_in_order {
            ([a, b], [at_a, at_b])
        } else {
            ([b, a], [at_b, at_a])
        };
        let line = Self { ends, depths, slope: 0 };
        let gain = u64::from(line.gain()) << (32 - 8 * size_of::<D>());
        let steps = line.steps();
        let (slope, _) = divided(gain + u64::from(steps >> 1), steps);
        // Not more than the gain, which has 32 bits.
        Self {
            slope: slope as u32,
            ..line
        }
    }

    /// The line on something with a greatest slope, which has the fractional bits of interpolated depths.
    pub(crate) fn with_slope(self, slope: u32) -> Self {
        Self { slope, ..self }
    }

    /// How much the depth changes from end to end.
    fn gain(&self) -> u32 {
        let [from, to]: [u32; 2] = self.depths.map(Into::into);
        from.abs_diff(to)
    }

    /// The steps along the longer side.
    fn steps(&self) -> u32 {
        let [from, to] = self.ends;
        from.x.abs_diff(to.x).max(from.y.abs_diff(to.y))
    }

    /// How many steps a pixel of the line is from the first one.
    fn step_of(&self, pixel: Point) -> u32 {
        let [from, _] = self.ends;
        from.x.abs_diff(pixel.x).max(from.y.abs_diff(pixel.y))
    }

    /// The depth of a line of which so much of the gain is behind.
    fn depth_after(&self, gained: u32) -> D {
        let [from, to]: [u32; 2] = self.depths.map(Into::into);
        let depth = if to < from { from - gained } else { from + gained };
        D::from_interpolated(depth << (32 - 8 * size_of::<D>()))
    }
}

/// How much of the gain of a line in depth is behind after some of its steps, to the nearest, halves up: stepped from pixel to
/// pixel by quotient and remainder (Field 1985).
#[derive(Debug, Copy, Clone)]
struct Gained {
    /// The number of the present pixel, counted from the first one of the line.
    step: u32,
    /// The units of depth gained up to the present pixel, rounded to the nearest.
    gained: u32,
    /// The remainder of the division that `gained` is the quotient of.
    rest: u32,
    /// The units of depth that each step gains, rounded down.
    per_step: u32,
    /// The remainder of the division that `per_step` is the quotient of.
    rest_per_step: u32,
    /// The steps of the whole line, by which is divided.
    steps: u32,
}

impl Gained {
    /// Two divisions.
    fn at<D: DepthWidth>(line: &DepthLine<D>, step: u32) -> Self {
        let (gain, steps) = (line.gain(), line.steps());
        // At most (2^32 - 1)^2 and half of 2^32 more; the quotient is at most the gain.
        let (gained, rest) = divided(u64::from(gain) * u64::from(step) + u64::from(steps >> 1), steps);
        let (per_step, rest_per_step) = divided(gain.into(), steps);
        Self {
            step,
            gained: gained as u32,
            rest,
            per_step: per_step as u32,
            rest_per_step,
            steps,
        }
    }

    /// Goes to the pixel after the present one or before it: additions only.
    #[inline]
    fn go_to(&mut self, step: u32) {
        if step > self.step {
            self.gained += self.per_step;
            // Both are below `steps`, which is at most 2^32 - 1.
            let room = self.steps - self.rest;
            if self.rest_per_step >= room {
                self.gained += 1;
                self.rest = self.rest_per_step - room;
            } else {
                self.rest += self.rest_per_step;
            }
        } else if step < self.step {
            self.gained -= self.per_step;
            if self.rest < self.rest_per_step {
                self.gained -= 1;
                self.rest += self.steps - self.rest_per_step;
            } else {
                self.rest -= self.rest_per_step;
            }
        }
        self.step = step;
    }
}

/// A quotient and its remainder; the dividend and 0 where the divisor is 0.
fn divided(dividend: u64, divisor: u32) -> (u64, u32) {
    match (u32::try_from(dividend), NonZeroU32::new(divisor)) {
        // Most often: 32 bits are divided by an instruction.
        (Ok(dividend), Some(divisor)) => ((dividend / divisor).into(), dividend % divisor),
        _ => {
            let divisor = NonZeroU64::new(divisor.into()).unwrap_or(NonZeroU64::MIN);
            (dividend / divisor, (dividend % divisor) as u32)
        }
    }
}

impl<C: BandColor, O: Order, D: DepthWidth> DepthRow<'_, C, O, D> {
    /// Draws the pixels of a line that are in the row and pass the test of their depths, in any order of rows.
    ///
    /// Cost: two comparisons where the line does not cross the row; otherwise three divisions for where it enters, and additions
    /// for each pixel.
    #[inline]
    pub fn draw_line(&mut self, line: &DepthLine<D>, color: C, state: &DepthState<D>) {
        let [from, to] = line.ends;
        if from.y <= self.y && to.y >= self.y {
            self.draw_crossing_line(line, color, state);
        }
    }

    #[inline(never)]
    fn draw_crossing_line(&mut self, line: &DepthLine<D>, color: C, state: &DepthState<D>) {
        let [from, to] = line.ends;
        let window = Window {
            left: self.left,
            top: self.y,
            right: self.left + self.words.len() as i32,
            bottom: self.y.saturating_add(1),
        };
        if let Some(steps) = line_steps(from, to, &window) {
            self.draw_steps(
                line,
                &steps,
                Band::<C, O>::word(color),
                &DepthTest::new(state, line.slope),
            );
        }
    }

    /// Draws the pixels of a line that are in the row.
    fn draw_steps(&mut self, line: &DepthLine<D>, steps: &LineSteps, word: C::Word, test: &DepthTest) {
        let mut gained: Option<Gained> = None;
        for pixel in *steps {
            let column = (pixel.x - self.left) as usize;
            let (Some(shown), Some(stored)) = (self.words.get_mut(column), self.depths.get_mut(column)) else {
                return;
            };
            let step = line.step_of(pixel);
            let gained = gained.get_or_insert_with(|| Gained::at(line, step));
            gained.go_to(step);
            let depth = test.depth(line.depth_after(gained.gained));
            if test.passes(depth, *stored) {
                *shown = word;
                if Test::<D>::writes(test) {
                    *stored = depth;
                }
            }
        }
    }
}
