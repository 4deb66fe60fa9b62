//! Outlines of glyphs: scaled, flattened and rounded to 1/256 pixel.

use skrifa::outline::OutlinePen;
use zrow::draw::SubOutline;

/// How far a chord may be from its curve, in pixels: half a unit of the positions.
const TOLERANCE: f64 = 1.0 / 512.0;

/// Chords of a curve at most, whatever its size.
const MOST_CHORDS: f64 = 256.0;

/// Contours of straight edges: corners in 1/256 pixel from the centre of the pixel whose left side the pen is at and whose
/// lower side is the baseline's, y downwards.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Contours(pub Vec<Vec<(i32, i32)>>);

impl SubOutline for Contours {
    fn edges(&self, edge: &mut dyn FnMut([i32; 2], [i32; 2])) {
        for contour in &self.0 {
            let corner = |(x, y): (i32, i32)| [x, y];
            for (from, to) in contour.iter().zip(contour.iter().cycle().skip(1)) {
                edge(corner(*from), corner(*to));
            }
        }
    }
}

/// Takes an outline in font units or in pixels, y upwards, and flattens it.
pub struct Flattener {
    /// Pixels of a unit of the outline.
    scale: f64,
    contours: Contours,
    /// Where the outline is, in pixels, y downwards.
    at: [f64; 2],
}

impl Flattener {
    /// Without contours; a unit of the outline is `scale` pixels.
    pub fn new(scale: f64) -> Self {
        Self {
            scale,
            contours: Contours::default(),
            at: [0.0; 2],
        }
    }

    /// What was drawn.
    pub fn contours(mut self) -> Contours {
        self.contours.0.retain(|contour| contour.len() > 2);
        self.contours
    }

    fn pixels(&self, x: f32, y: f32) -> [f64; 2] {
        [f64::from(x) * self.scale, -f64::from(y) * self.scale]
    }

    fn add(&mut self, point: [f64; 2]) {
        self.at = point;
        // Sides of pixels have whole coordinates here, their centres have them there.
        let [x, y] = point.map(|pixels| (pixels * 256.0).round() as i32 - 128);
        if let Some(contour) = self.contours.0.last_mut()
            && contour.last() != Some(&(x, y))
        {
            contour.push((x, y));
        }
    }

    /// Adds the chords of a curve, which deviates from a single chord by `deviation` pixels at most.
    fn add_curve(&mut self, deviation: f64, point: impl Fn(f64) -> [f64; 2]) {
        // A number that is none takes one chord.
        let chords = ((deviation / TOLERANCE).sqrt().ceil().min(MOST_CHORDS) as u32).max(1);
        for chord in 1..=chords {
            self.add(point(f64::from(chord) / f64::from(chords)));
        }
    }
}

/// The distance between the middle of a chord and its control point, doubled: what bends a curve.
fn bend(from: [f64; 2], control: [f64; 2], to: [f64; 2]) -> f64 {
    let axis = |axis: usize| from[axis] - 2.0 * control[axis] + to[axis];
    axis(0).hypot(axis(1))
}

impl OutlinePen for Flattener {
    fn move_to(&mut self, x: f32, y: f32) {
        self.contours.0.push(Vec::new());
        self.add(self.pixels(x, y));
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.add(self.pixels(x, y));
    }

    fn quad_to(&mut self, cx0: f32, cy0: f32, x: f32, y: f32) {
        let (from, control, to) = (self.at, self.pixels(cx0, cy0), self.pixels(x, y));
        self.add_curve(bend(from, control, to) / 4.0, |t| {
            let s = 1.0 - t;
            [0, 1].map(|axis| s * s * from[axis] + 2.0 * s * t * control[axis] + t * t * to[axis])
        });
    }

    fn curve_to(&mut self, cx0: f32, cy0: f32, cx1: f32, cy1: f32, x: f32, y: f32) {
        let (from, first, second, to) = (self.at, self.pixels(cx0, cy0), self.pixels(cx1, cy1), self.pixels(x, y));
        // The second derivative is at most 6 times the larger bend, and the deviation an eighth of that.
        let deviation = 0.75 * bend(from, first, second).max(bend(first, second, to));
        self.add_curve(deviation, |t| {
            let s = 1.0 - t;
            [0, 1].map(|axis| {
                s * s * s * from[axis]
                    + 3.0 * s * s * t * first[axis]
                    + 3.0 * s * t * t * second[axis]
                    + t * t * t * to[axis]
            })
        });
    }

    fn close(&mut self) {}
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Corners of a flattened quarter circle, as a cubic and as two quadratics, lie within a unit of the circle.
    #[test]
    fn curves_are_followed_to_a_256th_of_a_pixel() {
        let mut pen = Flattener::new(0.5);
        pen.move_to(200.0, 0.0);
        pen.quad_to(200.0, 82.842, 141.421, 141.421);
        pen.quad_to(82.842, 200.0, 0.0, 200.0);
        pen.close();
        let contours = pen.contours();
        let [contour] = &contours.0[..] else {
            panic!("{contours:?}")
        };
        assert!(contour.len() > 20);
        let edge = |&(x, y): &(i32, i32)| (f64::from(x + 128) / 256.0, -f64::from(y + 128) / 256.0);
        // Two quadratics lie up to 0.4 % outside of the circle.
        for (x, y) in contour.iter().map(edge) {
            assert!((-0.01..0.5).contains(&(x.hypot(y) - 100.0)), "{x}, {y}");
        }
        for pair in contour.windows(2) {
            let (a, b) = (edge(&pair[0]), edge(&pair[1]));
            let middle = ((a.0 + b.0) / 2.0).hypot((a.1 + b.1) / 2.0);
            let ends = (a.0.hypot(a.1) + b.0.hypot(b.1)) / 2.0;
            assert!((ends - middle).abs() < 1.0 / 128.0, "{a:?} {b:?}");
        }
    }

    #[test]
    fn what_is_no_number_ends() {
        let mut pen = Flattener::new(f64::INFINITY);
        pen.move_to(0.0, 0.0);
        pen.quad_to(f32::NAN, 1.0, 2.0, f32::MAX);
        pen.curve_to(f32::MAX, 1.0, 2.0, f32::MIN, 1.0, 1.0);
        assert!(pen.contours().0.len() <= 1);
    }
}
