//! The volume of a cone over a line one pixel wide: the filtered ideal, in closed form, and by counting to check that.

use std::f64::consts::PI;

use crate::common::by_depth;

/// In 1/256 pixel.
pub type Units = (i32, i32);

/// What the documentation guarantees where the cone reaches no end, one end, or both, and rounding, in 1/255.
pub const BOUNDS: [f64; 3] = [0.5 + 0.2, 0.5 + 0.4, 0.5 + 0.55];

/// A line as a start, a direction, and a length.
pub struct Ideal {
    start: (f64, f64),
    pub direction: (f64, f64),
    pub length: f64,
}

impl Ideal {
    pub fn new(start: Units, end: Units) -> Self {
        let pixel = |units: i32| f64::from(units) / 256.0;
        let (dx, dy) = (pixel(end.0 - start.0), pixel(end.1 - start.1));
        let length = dx.hypot(dy);
        Self {
            start: (pixel(start.0), pixel(start.1)),
            direction: (dx / length, dy / length),
            length,
        }
    }

    /// Distance of a pixel from the start, along the line, and from the line.
    pub fn distances(&self, (x, y): (i32, i32)) -> (f64, f64) {
        let (dx, dy) = (f64::from(x) - self.start.0, f64::from(y) - self.start.1);
        let (ux, uy) = self.direction;
        (dx * ux + dy * uy, dx * uy - dy * ux)
    }

    /// The volume that a cone of radius 1 and volume 1 around a pixel has over the rectangle of width 1 around the line.
    pub fn volume(&self, pixel: (i32, i32)) -> f64 {
        let (along, across) = self.distances(pixel);
        over_rectangle([-along, self.length - along], [across - 0.5, across + 0.5])
    }

    /// How many ends the cone around a pixel may reach.
    pub fn ends_near(&self, pixel: (i32, i32)) -> usize {
        let (along, _) = self.distances(pixel);
        usize::from(along < 1.0) + usize::from(along > self.length - 1.0)
    }
}

/// Volume of the cone over a rectangle, from the first to the second coordinate, seen from its axis.
fn over_rectangle([left, right]: [f64; 2], [top, bottom]: [f64; 2]) -> f64 {
    let column = |x: f64| over_corner(x, bottom) - over_corner(x, top);
    column(right) - column(left)
}

/// Volume of the cone over the rectangle between its axis and a corner; negative where one coordinate is.
fn over_corner(x: f64, y: f64) -> f64 {
    if x == 0.0 || y == 0.0 {
        return 0.0;
    }
    let sign = x.signum() * y.signum();
    let (x, y) = (x.abs().min(1.0), y.abs().min(1.0));
    let radius = x.hypot(y);
    // The integral of the distance from the corner of a rectangle is known; where the corner is beyond the cone, what
    // lies beyond either side is left out of a quarter, and they have nothing in common.
    let volume = if radius <= 1.0 {
        let distances = x * y * radius / 3.0 + (x.powi(3) * (y / x).asinh() + y.powi(3) * (x / y).asinh()) / 6.0;
        3.0 / PI * (x * y - distances)
    } else {
        (within(x) + within(y)) / 2.0 - 0.25
    };
    sign * volume
}

/// Volume of the cone between its middle and a distance, on both sides of the other axis: the integral of its section.
fn within(distance: f64) -> f64 {
    let u = distance;
    (2.0 * u * (1.0 - u * u).max(0.0).sqrt() + u.asin() - u.powi(3) * (1.0 / u).acosh()) / PI
}

/// Volume of the cone over a rectangle from its height at so many points along each side of 2: Riemann's sum.
fn counted([left, right]: [f64; 2], [top, bottom]: [f64; 2], points: u32) -> f64 {
    let side = |index: u32| (f64::from(index) + 0.5) * 2.0 / f64::from(points) - 1.0;
    let mut sum = 0.0;
    for v in (0..points).map(side).filter(|v| (top..bottom).contains(v)) {
        for u in (0..points).map(side).filter(|u| (left..right).contains(u)) {
            sum += (1.0 - (u * u + v * v).sqrt()).max(0.0);
        }
    }
    sum * 3.0 / PI * (2.0 / f64::from(points)).powi(2)
}

#[test]
fn the_closed_form_is_what_is_counted() {
    // Sides that lie between the points, so that the sum is as good as the number of points.
    const POINTS: u32 = 400;
    let sides = [-200, -183, -80, 0, 15, 66, 133, 178, 200].map(|side| f64::from(side) / 200.0);
    let mut largest = 0f64;
    for (left, right) in pairs(&sides).step_by(by_depth(5, 1, 1)) {
        for (top, bottom) in pairs(&sides) {
            let exact = over_rectangle([left, right], [top, bottom]);
            let difference = exact - counted([left, right], [top, bottom], POINTS);
            largest = largest.max(difference.abs() * 255.0);
        }
    }
    assert!(largest < 0.01, "{largest}");
    assert!((over_rectangle([-2.0, 3.0], [-1.5, 1.0]) - 1.0).abs() < 1e-12);
}

fn pairs(sides: &[f64]) -> impl Iterator<Item = (f64, f64)> {
    let pairs = sides.iter().enumerate();
    pairs.flat_map(|(index, &first)| sides[index + 1..].iter().map(move |&second| (first, second)))
}
