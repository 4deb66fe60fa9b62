//! Ideal shapes in `f64`: distances and angles of points, and coverage, sampled at 32 x 32 points of each pixel.

use embedded_graphics::{
    prelude::*,
    primitives::{Line, Rectangle},
};

/// The coverage of each pixel of an area by the points that `is_inside`.
pub fn ideal(area: &Rectangle, is_inside: impl Fn(f64, f64) -> bool) -> Vec<f64> {
    const SAMPLES: i32 = 32;
    let offsets = || (0..SAMPLES).map(|index| (f64::from(index) + 0.5) / f64::from(SAMPLES) - 0.5);
    area.points()
        .map(|pixel| {
            let (x, y) = (f64::from(pixel.x), f64::from(pixel.y));
            let inside = offsets().flat_map(|right| offsets().map(move |down| (right, down)));
            let inside = inside.filter(|(right, down)| is_inside(x + right, y + down)).count();
            inside as f64 / f64::from(SAMPLES * SAMPLES)
        })
        .collect()
}

/// Whether a point is in the ellipse of a box.
pub fn in_ellipse(around: &Rectangle, beyond: f64, x: f64, y: f64) -> bool {
    let axis = |start: i32, length: u32, at: f64| {
        let radius = f64::from(length) / 2.0 + beyond;
        (at - f64::from(start) - (f64::from(length) - 1.0) / 2.0, radius)
    };
    let (right, across) = axis(around.top_left.x, around.size.width, x);
    let (below, down) = axis(around.top_left.y, around.size.height, y);
    across > 0.0 && down > 0.0 && (right / across).powi(2) + (below / down).powi(2) < 1.0
}

/// How far a point is along a line from its start, how far across it, and the length of the line.
pub fn along(line: &Line, x: f64, y: f64) -> (f64, f64, f64) {
    let (right, down) = (
        f64::from(line.end.x - line.start.x),
        f64::from(line.end.y - line.start.y),
    );
    let length = right.hypot(down);
    let (x, y) = (x - f64::from(line.start.x), y - f64::from(line.start.y));
    ((x * right + y * down) / length, (y * right - x * down) / length, length)
}

/// The distance of a point from a path.
pub fn distance(vertices: &[Point], x: f64, y: f64) -> f64 {
    let segments = vertices.windows(2).filter(|pair| pair[0] != pair[1]);
    let distances = segments.map(|pair| {
        let (along, across, length) = along(&Line::new(pair[0], pair[1]), x, y);
        across.hypot((-along).max(along - length).max(0.0))
    });
    distances.fold(f64::MAX, f64::min)
}

/// Degrees from one angle to the direction of a point, clockwise.
pub fn degrees_from(start: f64, x: f64, y: f64) -> f64 {
    (y.atan2(x).to_degrees() - start).rem_euclid(360.0)
}
