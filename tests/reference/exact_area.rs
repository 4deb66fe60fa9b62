//! The exact area of a shape in each pixel, by slabs between all corners and crossings.

use zrow::{draw::FillRule, geometry::Window};

/// Corners in 1/256 pixel from the centre of pixel (0, 0).
pub type Contour = Vec<(i32, i32)>;

/// The area of the inside in each pixel, in f64 from a sweep over exact slabs: a row is cut at every corner and at every
/// crossing of two edges, and between two cuts everything is a trapezoid. Wrong by rounding of f64 alone, 1e-9 here.
pub fn exact(contours: &[Contour], fill_rule: FillRule, window: &Window) -> Vec<f64> {
    let corner = |&(x, y): &(i32, i32)| (f64::from(x) / 256.0, f64::from(y) / 256.0);
    let contours: Vec<Vec<(f64, f64)>> = contours
        .iter()
        .map(|contour| contour.iter().map(corner).collect())
        .collect();
    exact_where([&contours, &[]], |[windings, _]| fill_rule.includes(windings), window)
}

/// The area in each pixel of what is inside by the winding numbers in two outlines, whose corners are in pixels from the centre
/// of pixel (0, 0); as [`exact`] computes it.
pub fn exact_where(
    outlines: [&[Vec<(f64, f64)>]; 2],
    includes: impl Fn([i32; 2]) -> bool,
    window: &Window,
) -> Vec<f64> {
    let width = (window.right - window.left) as usize;
    let mut areas = vec![0.0; width * (window.bottom - window.top) as usize];
    let edges: Vec<[f64; 6]> = (0..2usize)
        .flat_map(|outline| outlines[outline].iter().map(move |contour| (outline as f64, contour)))
        .flat_map(|(outline, contour)| {
            let pairs = contour.iter().zip(contour.iter().cycle().skip(1));
            pairs.filter(|(a, b)| a.1 != b.1).map(move |(a, b)| {
                let corner = |p: &(f64, f64)| (p.0 + 0.5, p.1 + 0.5);
                let (a, b) = (corner(a), corner(b));
                if a.1 < b.1 {
                    [a.0, a.1, b.0, b.1, 1.0, outline]
                } else {
                    [b.0, b.1, a.0, a.1, -1.0, outline]
                }
            })
        })
        .collect();
    let x_at = |edge: &[f64; 6], y: f64| edge[0] + (edge[2] - edge[0]) * (y - edge[1]) / (edge[3] - edge[1]);
    let mut cuts: Vec<f64> = edges.iter().flat_map(|edge| [edge[1], edge[3]]).collect();
    cuts.extend((window.top..=window.bottom).map(f64::from));
    for (index, one) in edges.iter().enumerate() {
        for other in &edges[..index] {
            let slope = |edge: &[f64; 6]| (edge[2] - edge[0]) / (edge[3] - edge[1]);
            let (s, t) = (slope(one), slope(other));
            let y = (other[0] - one[0] + s * one[1] - t * other[1]) / (s - t);
            if y > one[1].max(other[1]) && y < one[3].min(other[3]) {
                cuts.push(y);
            }
        }
    }
    cuts.sort_by(f64::total_cmp);
    for pair in cuts.windows(2) {
        let (top, bottom) = (pair[0], pair[1]);
        let middle = (top + bottom) / 2.0;
        if bottom - top < 1e-12 || middle < f64::from(window.top) || middle > f64::from(window.bottom) {
            continue;
        }
        let mut sides: Vec<&[f64; 6]> = edges
            .iter()
            .filter(|edge| edge[1] < middle && middle < edge[3])
            .collect();
        sides.sort_by(|a, b| x_at(a, middle).total_cmp(&x_at(b, middle)));
        let mut windings = [0; 2];
        for side in sides {
            let before = includes(windings);
            windings[side[5] as usize] += side[4] as i32;
            let sign = f64::from(i32::from(includes(windings)) - i32::from(before));
            if sign != 0.0 {
                let row = &mut areas[(middle.floor() as i32 - window.top) as usize * width..][..width];
                let (x0, x1) = (x_at(side, top), x_at(side, bottom));
                for (column, area) in row.iter_mut().enumerate() {
                    *area += sign * (bottom - top) * right_of(x0, x1, f64::from(window.left) + column as f64);
                }
            }
        }
    }
    areas
}

/// The part of a unit cell at `left` that lies right of a side from `x0` to `x1`.
fn right_of(x0: f64, x1: f64, left: f64) -> f64 {
    // The mean over the side of how much of the cell lies right of its x: an integral of a clamped line.
    let integral = |x: f64| {
        let x = x - left;
        if x <= 0.0 {
            x
        } else if x <= 1.0 {
            x - x * x / 2.0
        } else {
            0.5
        }
    };
    if (x1 - x0).abs() < 1e-9 {
        (1.0 - (x0 - left)).clamp(0.0, 1.0)
    } else {
        (integral(x1) - integral(x0)) / (x1 - x0)
    }
}
