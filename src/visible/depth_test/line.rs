//! Lines whose depth varies, drawn into the rows of a scene, one row at a time.

use core::num::NonZeroU64;

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
        let slope = nearest_quotient(gain, line.steps());
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

    /// The depth after some steps.
    fn depth_at(&self, step: u32) -> D {
        let [from, to]: [u32; 2] = self.depths.map(Into::into);
        // At most (2^32 - 1)^2 and half of 2^32 more. The quotient is at most the gain.
        let gained = nearest_quotient(u64::from(self.gain()) * u64::from(step), self.steps()) as u32;
        let depth = if to < from { from - gained } else { from + gained };
        D::from_interpolated(depth << (32 - 8 * size_of::<D>()))
    }
}

/// A quotient to the nearest, halves up; the dividend where the divisor is 0.
fn nearest_quotient(dividend: u64, divisor: u32) -> u64 {
    let dividend = dividend + u64::from(divisor >> 1);
    match (u32::try_from(dividend), core::num::NonZeroU32::new(divisor)) {
        // Most often: 32 bits are divided by an instruction.
        (Ok(dividend), Some(divisor)) => (dividend / divisor).into(),
        _ => dividend / NonZeroU64::new(divisor.into()).unwrap_or(NonZeroU64::MIN),
    }
}

impl<C: BandColor, O: Order, D: DepthWidth> DepthRow<'_, C, O, D> {
    /// Draws the pixels of a line that are in the row and pass the test of their depths, in any order of rows.
    ///
    /// Cost: two comparisons where the line does not cross the row; otherwise a division for where it enters and one for each
    /// pixel.
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
        for pixel in *steps {
            let column = (pixel.x - self.left) as usize;
            let (Some(shown), Some(stored)) = (self.words.get_mut(column), self.depths.get_mut(column)) else {
                return;
            };
            let depth = test.depth(line.depth_at(line.step_of(pixel)));
            if test.passes(depth, *stored) {
                *shown = word;
                if Test::<D>::writes(test) {
                    *stored = depth;
                }
            }
        }
    }
}
