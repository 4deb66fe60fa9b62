//! Filled polygons by winding numbers in `i128`: which pixels and points are inside.

use zrow::{
    geometry::Window,
    scan::{FillRule, Location},
};

/// Coordinates in the units of a polygon.
pub type Units = (i32, i32);
type Pixels = Vec<(i32, i32)>;

fn wide((x, y): Units) -> (i128, i128) {
    (i128::from(x), i128::from(y))
}

/// The edges of contours, each of which is closed.
pub fn edges(contours: &[Vec<Units>]) -> impl Iterator<Item = ((i128, i128), (i128, i128))> {
    contours.iter().flat_map(|contour| {
        (0..contour.len()).map(|index| (wide(contour[index]), wide(contour[(index + 1) % contour.len()])))
    })
}

/// Edges at or left of a point, with their direction; an edge has its upper end and not its lower one.
fn winding(contours: &[Vec<Units>], (x, y): (i128, i128)) -> i128 {
    let mut winding = 0;
    for (from, to) in edges(contours) {
        let (direction, (x0, y0), (x1, y1)) = if from.1 < to.1 { (1, from, to) } else { (-1, to, from) };
        if y0 <= y && y < y1 && (x - x0) * (y1 - y0) >= (y - y0) * (x1 - x0) {
            winding += direction;
        }
    }
    winding
}

fn is_inside(winding: i128, rule: FillRule) -> bool {
    match rule {
        FillRule::EvenOdd => winding % 2 != 0,
        FillRule::NonZero => winding != 0,
    }
}

/// The pixels whose centres are inside of contours of units, of which `1 << fraction_bits` are a pixel: row by row.
pub fn filled_pixels(contours: &[Vec<Units>], fraction_bits: u32, rule: FillRule, window: &Window) -> Vec<(i32, i32)> {
    let mut pixels = Vec::new();
    for y in window.top..window.bottom {
        for x in window.left..window.right {
            let centre = (i128::from(x) << fraction_bits, i128::from(y) << fraction_bits);
            if is_inside(winding(contours, centre), rule) {
                pixels.push((y, x));
            }
        }
    }
    pixels
}

/// Where a point lies, by its winding number and by every edge.
pub fn location(contours: &[Vec<Units>], rule: FillRule, point: Units) -> Location {
    let (x, y) = wide(point);
    let is_on = |(from, to): ((i128, i128), (i128, i128))| {
        (to.0 - from.0) * (y - from.1) == (to.1 - from.1) * (x - from.0)
            && from.0.min(to.0) <= x
            && x <= from.0.max(to.0)
            && from.1.min(to.1) <= y
            && y <= from.1.max(to.1)
    };
    if edges(contours).any(is_on) {
        Location::OnBoundary
    } else if is_inside(winding(contours, (x, y)), rule) {
        Location::Inside
    } else {
        Location::Outside
    }
}
