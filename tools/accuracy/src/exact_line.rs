//! The line between two points by rational numbers, a pixel at a time; nothing here is zrow's but the types.

use std::collections::HashSet;

use embedded_graphics::geometry::Point;
use zrow::geometry::Window;

/// A line between two points in units of which so many are a pixel.
#[derive(Debug, Clone, Copy)]
pub struct ExactLine {
    from: (i128, i128),
    to: (i128, i128),
    pixel: i128,
}

impl ExactLine {
    /// The line between two pixels.
    pub fn between(from: Point, to: Point) -> Self {
        Self::in_units((from.x, from.y), (to.x, to.y), 0)
    }

    /// The line between two points with so many fractional bits.
    pub fn in_units(from: (i32, i32), to: (i32, i32), bits: u32) -> Self {
        let wide = |(x, y): (i32, i32)| (i128::from(x), i128::from(y));
        Self {
            from: wide(from),
            to: wide(to),
            pixel: 1 << bits,
        }
    }

    /// Whether it goes further in columns than in rows, or as far.
    pub fn is_x_major(&self) -> bool {
        let (dx, dy) = self.deltas();
        dx.abs() >= dy.abs()
    }

    fn deltas(&self) -> (i128, i128) {
        (self.to.0 - self.from.0, self.to.1 - self.from.1)
    }

    /// Major coordinate first.
    fn turned(&self, (x, y): (i128, i128)) -> (i128, i128) {
        if self.is_x_major() { (x, y) } else { (y, x) }
    }

    /// Its pixels in the window, by growing major coordinate: in each step the nearest one, of two the larger coordinate.
    ///
    /// A step belongs where it is within half a pixel of the line's ends.
    pub fn pixels(&self, window: &Window) -> Vec<(i32, i32)> {
        let (start, end) = (self.turned(self.from), self.turned(self.to));
        let (low, high) = (start.0.min(end.0), start.0.max(end.0));
        let columns = (i128::from(window.left), i128::from(window.right));
        let rows = (i128::from(window.top), i128::from(window.bottom));
        let (major, minor) = if self.is_x_major() {
            (columns, rows)
        } else {
            (rows, columns)
        };
        let (dx, dy) = (end.0 - start.0, end.1 - start.1);
        // Of the nearest pixels of both ends, those in the window.
        let first = (2 * low + self.pixel).div_euclid(2 * self.pixel).max(major.0);
        let last = (2 * high + self.pixel).div_euclid(2 * self.pixel).min(major.1 - 1);
        let mut pixels = Vec::new();
        for step in first..=last {
            // start.1 + (step - start.0) * dy / dx, in pixels and rounded.
            let (dividend, divisor) = if dx == 0 {
                (start.1, self.pixel)
            } else {
                let dividend = start.1 * dx + (step * self.pixel - start.0) * dy;
                (dividend * dx.signum(), dx.abs() * self.pixel)
            };
            let aside = (2 * dividend + divisor).div_euclid(2 * divisor);
            if minor.0 <= aside && aside < minor.1 {
                let (x, y) = self.turned((step, aside));
                pixels.push((x as i32, y as i32));
            }
        }
        pixels
    }

    /// How far a pixel is from it along the minor axis, in pixels.
    pub fn displacement(&self, (x, y): (i32, i32)) -> f64 {
        let (major, _) = self.turned(self.deltas());
        self.cross((i128::from(x) * self.pixel, i128::from(y) * self.pixel)) / (major.abs().max(1) * self.pixel) as f64
    }

    /// How far a point that was cut off at one of these sides is from where the line meets that side, in pixels.
    ///
    /// `sides` are left, right, top and bottom; the point and they have so many fractional bits.
    pub fn cut_error(&self, (x, y): (i32, i32), sides: [i32; 4], bits: u32) -> f64 {
        let (dx, dy) = self.deltas();
        let fine = 1i128 << bits;
        // This line has whole units.
        let (from_x, from_y) = (self.from.0 * fine, self.from.1 * fine);
        let cross = (dx * (i128::from(y) - from_y) - dy * (i128::from(x) - from_x)).abs() as f64;
        let along = |delta: i128| cross / (delta.abs().max(1) * fine) as f64;
        let [left, right, top, bottom] = sides;
        let on_column = (x == left || x == right) && dx != 0;
        let on_row = (y == top || y == bottom) && dy != 0;
        match (on_column, on_row) {
            (true, true) => along(dx).min(along(dy)),
            (true, false) => along(dx),
            (false, true) => along(dy),
            (false, false) => 0.0,
        }
    }

    fn cross(&self, (x, y): (i128, i128)) -> f64 {
        let (dx, dy) = self.deltas();
        (dx * (y - self.from.1) - dy * (x - self.from.0)).abs() as f64
    }
}

/// Pixels that are in one and not in the other.
pub fn differing(drawn: &[(i32, i32)], right: &[(i32, i32)]) -> usize {
    let drawn: HashSet<_> = drawn.iter().collect();
    let right: HashSet<_> = right.iter().collect();
    drawn.symmetric_difference(&right).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    const WINDOW: Window = Window {
        left: 0,
        top: 0,
        right: 10,
        bottom: 10,
    };

    #[test]
    fn a_line_takes_the_nearest_pixels() {
        let line = ExactLine::between(Point::new(-2, 0), Point::new(4, 2));
        // 2/3 in column 0, 1 in column 1, 4/3, 5/3, 2.
        assert_eq!(line.pixels(&WINDOW), [(0, 1), (1, 1), (2, 1), (3, 2), (4, 2)]);
        assert!((line.displacement((0, 1)) - 1.0 / 3.0).abs() < 1e-9);
    }

    #[test]
    fn ties_go_to_the_larger_coordinate_in_both_directions() {
        let (from, to) = (Point::new(0, 0), Point::new(2, 1));
        for line in [ExactLine::between(from, to), ExactLine::between(to, from)] {
            assert_eq!(line.pixels(&WINDOW), [(0, 0), (1, 1), (2, 1)]);
        }
    }

    #[test]
    fn the_error_of_a_cut_is_measured_along_the_side() {
        let line = ExactLine::between(Point::new(-3, 0), Point::new(6, 3));
        // It meets column 0 in row 1.
        assert_eq!(line.cut_error((0, 256), [0, 2304, 0, 2304], 8), 0.0);
        assert!((line.cut_error((0, 264), [0, 2304, 0, 2304], 8) - 8.0 / 256.0).abs() < 1e-9);
    }
}
