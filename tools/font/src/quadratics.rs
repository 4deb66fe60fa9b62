//! Outlines of glyphs as quadratic curves between whole font units, as `zrow::draw::OutlineFont` takes them.
//!
//! Quadratic curves stay what they are. A cubic one is cut into equal parts of its parameter, and each becomes the quadratic
//! curve through its ends whose control point is the mean of what either end's tangent asks for (Sederberg 1984; levien/kurbo).
//! Point by point the two are no further from each other than `sqrt(3) / 36 * |third difference| / parts^3`.

use anyhow::ensure;
use skrifa::outline::OutlinePen;

/// How far a quadratic curve may be from its cubic one, in units, before points are rounded to whole units.
const TOLERANCE: f64 = 0.25;

/// Quadratic parts of a cubic curve at most.
const MOST_PARTS: f64 = 64.0;

/// How far a point on the contour may be from the middle between its control points to be implied, in units.
const IMPLIED: f64 = 1.0 / 64.0;

/// A point of a contour, in units, y upwards.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct Point {
    /// Units to the right of the pen.
    pub x: i16,
    /// Units above the baseline.
    pub y: i16,
    /// Whether the contour passes through the point; or else it is a control point.
    pub is_on_contour: bool,
}

/// A point before it is rounded.
#[derive(Debug, Copy, Clone, PartialEq)]
struct Exact {
    at: [f64; 2],
    is_on_contour: bool,
}

/// Takes an outline in font units, y upwards, and scales it.
pub struct QuadraticPen {
    /// Units of the result for each font unit.
    scale: f64,
    contours: Vec<Vec<Exact>>,
}

impl QuadraticPen {
    /// Without contours.
    pub fn new(scale: f64) -> Self {
        Self {
            scale,
            contours: Vec::new(),
        }
    }

    fn scaled(&self, x: f32, y: f32) -> [f64; 2] {
        [f64::from(x) * self.scale, f64::from(y) * self.scale]
    }

    fn at(&self) -> [f64; 2] {
        let last = self.contours.last().and_then(|contour| contour.last());
        last.map_or([0.0; 2], |point| point.at)
    }

    fn add(&mut self, at: [f64; 2], is_on_contour: bool) {
        if let Some(contour) = self.contours.last_mut() {
            contour.push(Exact { at, is_on_contour });
        }
    }

    /// The contours in whole units, each beginning with a point on it.
    ///
    /// # Errors
    /// A point that is not in the range of 16-bit numbers.
    pub fn contours(self) -> anyhow::Result<Vec<Vec<Point>>> {
        let rounded: Vec<Vec<Point>> = self.contours.into_iter().map(rounded).collect::<anyhow::Result<_>>()?;
        Ok(rounded.into_iter().filter(|contour| contour.len() > 2).collect())
    }
}

/// Whether a point of a contour lies in the middle between two control points.
fn is_implied(contour: &[Exact], index: usize) -> bool {
    let (Some(before), Some(after)) = (contour.get(index.wrapping_sub(1)), contour.get(index + 1)) else {
        return false;
    };
    let off = |axis: usize| (before.at[axis] + after.at[axis]) / 2.0 - contour[index].at[axis];
    let is_between = contour[index].is_on_contour && !before.is_on_contour && !after.is_on_contour;
    is_between && off(0).abs() <= IMPLIED && off(1).abs() <= IMPLIED
}

/// A contour in whole units, without its first point once more at its end, lines and curves that have no length, and points
/// that lie in the middle between two control points. The first point stays.
///
/// A control point at an end of its curve makes a line of the curve: both become one point, which the contour passes through.
/// So the other end of that line is between two control points no longer, and stays.
fn rounded(mut contour: Vec<Exact>) -> anyhow::Result<Vec<Point>> {
    while contour.len() > 1 && contour.last() == contour.first() {
        contour.pop();
    }
    // Each with whether it is implied.
    let mut points: Vec<(Point, bool)> = Vec::new();
    for (index, point) in contour.iter().enumerate() {
        let [x, y] = point.at.map(f64::round);
        let range = f64::from(i16::MIN)..=f64::from(i16::MAX);
        ensure!(
            range.contains(&x) && range.contains(&y),
            "it has a point at {x}, {y} units, and a font takes {} to {}: choose fewer --units",
            i16::MIN,
            i16::MAX
        );
        let point = Point {
            x: x as i16,
            y: y as i16,
            is_on_contour: point.is_on_contour,
        };
        match points.last_mut() {
            Some((last, is_implied)) if (last.x, last.y) == (point.x, point.y) => {
                last.is_on_contour |= point.is_on_contour;
                *is_implied = false;
            }
            _ => points.push((point, is_implied(&contour, index))),
        }
    }
    if let [(first, _), .., (last, _)] = points[..]
        && (first.x, first.y) == (last.x, last.y)
    {
        points.pop();
    }
    let is_control = |index: usize| points.get(index).is_some_and(|(point, _)| !point.is_on_contour);
    let is_left_out = |index: usize| points[index].1 && is_control(index.wrapping_sub(1)) && is_control(index + 1);
    let kept = (0..points.len()).filter(|&index| !is_left_out(index));
    Ok(kept.map(|index| points[index].0).collect())
}

/// The point of a curve between two others.
fn between(from: [f64; 2], to: [f64; 2], t: f64) -> [f64; 2] {
    [0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * t)
}

/// The control points of the part of a cubic curve from one parameter to another one, by its polar form.
fn part([a, b, c, d]: [[f64; 2]; 4], start: f64, end: f64) -> [[f64; 2]; 4] {
    let polar = |t: f64, u: f64, v: f64| {
        let (ab, bc, cd) = (between(a, b, t), between(b, c, t), between(c, d, t));
        between(between(ab, bc, u), between(bc, cd, u), v)
    };
    [
        polar(start, start, start),
        polar(start, start, end),
        polar(start, end, end),
        polar(end, end, end),
    ]
}

impl OutlinePen for QuadraticPen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.contours.push(Vec::new());
        self.add(self.scaled(x, y), true);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.add(self.scaled(x, y), true);
    }

    fn quad_to(&mut self, cx0: f32, cy0: f32, x: f32, y: f32) {
        self.add(self.scaled(cx0, cy0), false);
        self.add(self.scaled(x, y), true);
    }

    fn curve_to(&mut self, cx0: f32, cy0: f32, cx1: f32, cy1: f32, x: f32, y: f32) {
        let curve = [
            self.at(),
            self.scaled(cx0, cy0),
            self.scaled(cx1, cy1),
            self.scaled(x, y),
        ];
        let [a, b, c, d] = curve;
        let third = |axis: usize| d[axis] - 3.0 * c[axis] + 3.0 * b[axis] - a[axis];
        let off = 3f64.sqrt() / 36.0 * third(0).hypot(third(1));
        // A number that is none takes one part.
        let parts = ((off / TOLERANCE).cbrt().ceil().clamp(1.0, MOST_PARTS) as u32).max(1);
        for number in 0..parts {
            let at = |number: u32| f64::from(number) / f64::from(parts);
            let [a, b, c, d] = part(curve, at(number), at(number + 1));
            let control = [0, 1].map(|axis| (3.0 * (b[axis] + c[axis]) - a[axis] - d[axis]) / 4.0);
            self.add(control, false);
            self.add(d, true);
        }
    }

    fn close(&mut self) {}
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(x: i16, y: i16, is_on_contour: bool) -> Point {
        Point { x, y, is_on_contour }
    }

    #[test]
    fn implied_points_and_the_closing_one_are_left_out() {
        let mut pen = QuadraticPen::new(0.5);
        pen.move_to(0.0, 100.0);
        pen.quad_to(0.0, 200.0, 100.0, 200.0);
        pen.quad_to(200.0, 200.0, 200.0, 100.0);
        pen.line_to(200.0, 100.2);
        pen.line_to(100.0, 0.0);
        pen.line_to(0.0, 100.0);
        pen.close();
        let contour = [
            (0, 50, true),
            (0, 100, false),
            (100, 100, false),
            (100, 50, true),
            (50, 0, true),
        ];
        let contour = contour.map(|(x, y, is_on_contour)| point(x, y, is_on_contour)).to_vec();
        assert_eq!(pen.contours().unwrap(), [contour]);
    }

    /// Two control points at one place make a corner there, which one control point does not.
    #[test]
    fn control_points_that_coincide_keep_their_corner() {
        let mut pen = QuadraticPen::new(1.0);
        // The point between both control points is where they are.
        pen.move_to(0.0, 0.0);
        pen.quad_to(0.0, 1_000.0, 0.0, 1_000.0);
        pen.quad_to(0.0, 1_000.0, 1_000.0, 1_000.0);
        pen.line_to(1_000.0, 0.0);
        // A line up to the point between the control points, the first of which is where the contour begins.
        pen.move_to(0.0, 0.0);
        pen.quad_to(0.0, 0.0, 0.0, 500.0);
        pen.quad_to(0.0, 1_000.0, 1_000.0, 1_000.0);
        // The same at the end of a contour.
        pen.move_to(0.0, 0.0);
        pen.line_to(1_000.0, 1_000.0);
        pen.quad_to(0.0, 1_000.0, 0.0, 500.0);
        pen.quad_to(0.0, 0.0, 0.0, 0.0);
        // Control points become equal only when they are rounded.
        pen.move_to(0.0, 0.0);
        pen.quad_to(0.0, 999.7, 0.1, 999.9);
        pen.quad_to(0.2, 1_000.1, 1_000.0, 1_000.0);
        pen.line_to(1_000.0, 0.0);
        let corner = [(0, 0, true), (0, 1_000, true), (1_000, 1_000, true), (1_000, 0, true)];
        let first = [(0, 0, true), (0, 500, true), (0, 1_000, false), (1_000, 1_000, true)];
        let last = [(0, 0, true), (1_000, 1_000, true), (0, 1_000, false), (0, 500, true)];
        let contours = [corner, first, last, corner];
        let contours = contours.map(|contour| contour.map(|(x, y, is_on_contour)| point(x, y, is_on_contour)).to_vec());
        assert_eq!(pen.contours().unwrap(), contours);
    }

    /// Quadratic parts of a cubic quarter circle, each looked at in many points, lie within the tolerance and the rounding.
    #[test]
    fn cubics_are_followed() {
        for radius in [20.0f32, 300.0, 4_000.0] {
            let control = radius * 0.552_284_8;
            let mut pen = QuadraticPen::new(1.0);
            pen.move_to(0.0, 0.0);
            pen.line_to(radius, 0.0);
            pen.curve_to(radius, control, control, radius, 0.0, radius);
            let contours = pen.contours().unwrap();
            let mut at = [f64::from(radius), 0.0];
            let mut control = None;
            for point in &contours[0][2..] {
                let next = [f64::from(point.x), f64::from(point.y)];
                // Between two control points lies the middle.
                let (end, next_control) = match (control, point.is_on_contour) {
                    (None, _) => {
                        control = Some(next);
                        continue;
                    }
                    (Some(_), true) => (next, None),
                    (Some(control), false) => (between(control, next, 0.5), Some(next)),
                };
                let middle = control.unwrap();
                for t in (0..=32).map(|t| f64::from(t) / 32.0) {
                    let [x, y] = between(between(at, middle, t), between(middle, end, t), t);
                    // A cubic is 0.03 % outside of its circle at most.
                    let off = x.hypot(y) - f64::from(radius);
                    let bound = TOLERANCE + std::f64::consts::FRAC_1_SQRT_2 + IMPLIED;
                    assert!(
                        (-bound..=bound + 0.000_3 * f64::from(radius)).contains(&off),
                        "{radius}: {off}"
                    );
                }
                (at, control) = (end, next_control);
            }
            assert_eq!((at, control), ([0.0, f64::from(radius)], None));
        }
    }

    #[test]
    fn points_beyond_16_bits_and_no_numbers_are_errors() {
        for x in [40_000.0, f32::NAN, f32::INFINITY] {
            let mut pen = QuadraticPen::new(1.0);
            pen.move_to(0.0, 0.0);
            pen.curve_to(x, 1.0, 2.0, -x, 1.0, 1.0);
            pen.line_to(x, 3.0);
            let error = pen.contours().unwrap_err().to_string();
            assert!(error.contains("choose fewer --units"), "{error}");
        }
    }
}
