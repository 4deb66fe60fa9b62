//! References in exact arithmetic: pixels by their definition, one at a time, in `i128`.

use embedded_graphics::{
    geometry::{Point, Size},
    primitives::Rectangle,
};

/// `floor(numerator / denominator + 1/2)`: the nearest integer, ties upwards.
pub fn nearest(numerator: i128, denominator: i128) -> i128 {
    (2 * numerator + denominator).div_euclid(2 * denominator)
}

/// A pixel, in numbers that have room for whatever is made of them.
pub const fn wide(pixel: Point) -> [i128; 2] {
    [pixel.x as i128, pixel.y as i128]
}

/// Twice the area of a triangle, positive where its corners go clockwise on the display.
pub const fn doubled_area([a, b, c]: [[i128; 2]; 3]) -> i128 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Whether a pixel belongs to the line between two pixels: the nearest one in each step of the major axis, ties to the
/// larger coordinate.
pub fn line_has([x0, y0]: [i128; 2], [x1, y1]: [i128; 2], [x, y]: [i128; 2]) -> bool {
    let (dx, dy) = (x1 - x0, y1 - y0);
    // The major axis first.
    let (major, minor, start, step, across) = if dx.abs() >= dy.abs() {
        (dx, dy, [x0, y0], x, y)
    } else {
        (dy, dx, [y0, x0], y, x)
    };
    let ahead = (step - start[0]) * major.signum();
    if major == 0 {
        return step == start[0] && across == start[1];
    }
    (0..=major.abs()).contains(&ahead) && across == start[1] + nearest(ahead * minor, major.abs())
}

/// The first and the last column, in a row, of the line that is walked from one pixel to another: the nearest pixel in each
/// step of the major axis, ties to where the line begins.
pub fn walked_row([x0, y0]: [i128; 2], [x1, y1]: [i128; 2], y: i128) -> Option<[i128; 2]> {
    let (dx, dy) = (x1 - x0, y1 - y0);
    let rows = (y - y0) * dy.signum();
    if !(0..=dy.abs()).contains(&rows) || dy == 0 && y != y0 {
        return None;
    }
    let steps = if dy == 0 {
        [0, dx.abs()]
    } else if dx.abs() < dy.abs() {
        // ceil(rows |dx| / |dy| - 1/2)
        let step = -(dy.abs() - 2 * rows * dx.abs()).div_euclid(2 * dy.abs());
        [step, step]
    } else {
        // The steps whose distance from the first row, `steps |dy| / |dx|`, is above `rows - 1/2` and at most `rows + 1/2`.
        let last_below = |twice: i128| (twice * dx.abs()).div_euclid(2 * dy.abs());
        [
            (last_below(2 * rows - 1) + 1).max(0),
            last_below(2 * rows + 1).min(dx.abs()),
        ]
    };
    let [one, other] = steps.map(|step| x0 + step * dx.signum());
    Some([one.min(other), one.max(other)])
}

/// Whether a pixel belongs to a triangle: in its row it lies on one of the lines that are walked along its sides, or between
/// two of them.
fn is_between_walks(lines: [([i128; 2], [i128; 2]); 3], [x, y]: [i128; 2]) -> bool {
    let rows = || lines.into_iter().filter_map(|(from, to)| walked_row(from, to, y));
    rows().any(|[first, _]| first <= x) && rows().any(|[_, last]| x <= last)
}

/// Whether a pixel belongs to the fill of a triangle, whose sides are walked from top to bottom.
pub fn filled_triangle_has(corners: [[i128; 2]; 3], pixel: [i128; 2]) -> bool {
    let [a, b, c] = corners;
    let downwards = |one: [i128; 2], other: [i128; 2]| if one[1] <= other[1] { (one, other) } else { (other, one) };
    is_between_walks([downwards(a, b), downwards(b, c), downwards(c, a)], pixel)
}

/// Whether a pixel belongs to the outline of a triangle, or lies inside of it. Its sides are walked clockwise on the display;
/// those of a triangle without an area go down along the middle corner and return.
pub fn outlined_triangle_has(corners: [[i128; 2]; 3], pixel: [i128; 2]) -> bool {
    let [mut a, mut b, mut c] = corners;
    let doubled_area = doubled_area(corners);
    if doubled_area < 0 {
        (a, b) = (b, a);
    } else if doubled_area == 0 {
        let mut sorted = corners;
        sorted.sort_by_key(|[x, y]| (*y, *x));
        [a, b, c] = sorted;
    }
    is_between_walks([(a, b), (b, c), (c, a)], pixel)
}

/// Whether a segment between the centres of two pixels has a point in common with the closed square around a pixel.
pub fn segment_touches([x0, y0]: [i128; 2], [x1, y1]: [i128; 2], [x, y]: [i128; 2]) -> bool {
    let overlaps = |one: i128, other: i128, pixel: i128| {
        2 * one.min(other) <= 2 * pixel + 1 && 2 * pixel - 1 <= 2 * one.max(other)
    };
    let corners = [(-1, -1), (1, -1), (-1, 1), (1, 1)];
    let sides = corners.map(|(right, down)| {
        let (dx, dy) = (2 * (x - x0) + right, 2 * (y - y0) + down);
        ((x1 - x0) * dy - (y1 - y0) * dx).signum()
    });
    // Apart along an axis, or along the segment's normal.
    let is_beside = sides == [1; 4] || sides == [-1; 4];
    overlaps(x0, x1, x) && overlaps(y0, y1, y) && !is_beside
}

/// The winding number of a point that lies a little to the right of and far less below the given one, by edges from vertex
/// to vertex around each contour: what the top-left rule asks for.
pub fn winding(contours: &[Vec<[i128; 2]>], [x, y]: [i128; 2]) -> i32 {
    let mut winding = 0;
    for contour in contours {
        let Some(mut from) = contour.last() else { continue };
        for to in contour {
            if (from[1] <= y) != (to[1] <= y) {
                let (top, bottom, sign) = if from[1] < to[1] { (from, to, 1) } else { (to, from, -1) };
                // Whether the edge crosses the row at the point or left of it.
                let right = (x - top[0]) * (bottom[1] - top[1]) - (y - top[1]) * (bottom[0] - top[0]);
                if right >= 0 {
                    winding += sign;
                }
            }
            from = to;
        }
    }
    winding
}

/// Whether a pixel belongs to the ellipse in a box: embedded-graphics' inequality in doubled coordinates from its middle.
/// Equal sides are a circle, with the correction for those of up to four pixels.
pub fn ellipse_has(area: &Rectangle, pixel: Point) -> bool {
    let Size { width, height } = area.size;
    if width == 0 || height == 0 {
        return false;
    }
    let (w, h) = (i128::from(width), i128::from(height));
    let doubled = |pixel: i32, start: i32, length: i128| 2 * (i128::from(pixel) - i128::from(start)) - (length - 1);
    let dx = doubled(pixel.x, area.top_left.x, w);
    let dy = doubled(pixel.y, area.top_left.y, h);
    if w == h {
        let correction = if w <= 4 { w / 2 } else { 0 };
        return dx * dx + dy * dy < w * w - correction;
    }
    // Below 2^66 each outside of the box, where the products might not fit.
    dx.abs() < w && dy.abs() < h && product_below(h, dx, w, dy)
}

/// Whether `h^2 dx^2 + w^2 dy^2 < w^2 h^2`, all of them below 2^32.
fn product_below(h: i128, dx: i128, w: i128, dy: i128) -> bool {
    // w^2 h^2 - h^2 dx^2 = h^2 (w^2 - dx^2): two products below 2^128, without sign.
    let square = |number: i128| number.unsigned_abs() * number.unsigned_abs();
    let left = square(w) * square(dy);
    let right = square(h) * (square(w) - square(dx));
    left < right
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_longest_diagonal_goes_through_its_ends_and_its_middle() {
        let (from, to) = (Point::new(i32::MIN, i32::MIN), Point::new(i32::MAX, i32::MAX));
        let (from, to) = (wide(from), wide(to));
        for coordinate in [i32::MIN, -1, 0, i32::MAX] {
            assert!(line_has(from, to, wide(Point::new(coordinate, coordinate))));
        }
        assert!(!line_has(from, to, [0, 1]));
        assert!(segment_touches(from, to, [0, 1]) && !segment_touches(from, to, [0, 2]));
    }

    #[test]
    fn a_walk_has_the_pixels_of_the_line_but_for_ties() {
        for (to, expected) in [
            ([6, 3], [[0, 1], [2, 3], [4, 5], [6, 6]]),
            ([-6, 3], [[-1, 0], [-3, -2], [-5, -4], [-6, -6]]),
        ] {
            for (y, expected) in (0..).zip(expected) {
                assert_eq!(walked_row([0, 0], to, y), Some(expected));
            }
        }
        assert_eq!(walked_row([0, 0], [3, 6], 1), Some([0, 0]));
        assert_eq!(walked_row([3, 6], [0, 0], 1), Some([1, 1]));
        assert_eq!(walked_row([4, 7], [9, 7], 7), Some([4, 9]));
        assert_eq!(walked_row([4, 7], [9, 7], 8), None);
    }

    /// Corners (2,0) (4,4) (0,4): in rows 1 and 3 both slanted sides lie in the middle between two pixels.
    #[test]
    fn a_fill_and_an_outline_differ_on_ties() {
        let corners = [[2, 0], [4, 4], [0, 4]];
        let row = |has: fn([[i128; 2]; 3], [i128; 2]) -> bool, y| -> Vec<i128> {
            (-1..6).filter(|x| has(corners, [*x, y])).collect()
        };
        let filled = [
            vec![2],
            vec![2],
            vec![1, 2, 3],
            vec![1, 2, 3],
            vec![0, 1, 2, 3, 4],
            vec![],
        ];
        let outlined = [
            vec![2],
            vec![1, 2],
            vec![1, 2, 3],
            vec![0, 1, 2, 3],
            vec![0, 1, 2, 3, 4],
            vec![],
        ];
        for y in 0..6 {
            assert_eq!(row(filled_triangle_has, y), filled[y as usize], "row {y}");
            assert_eq!(row(outlined_triangle_has, y), outlined[y as usize], "row {y}");
        }
    }

    #[test]
    fn a_square_takes_its_upper_and_left_sides() {
        let square = vec![vec![[0, 0], [4, 0], [4, 4], [0, 4]]];
        let inside = |x, y| winding(&square, [x, y]) != 0;
        assert!(inside(0, 0) && inside(3, 3));
        assert!(!inside(4, 0) && !inside(0, 4) && !inside(-1, 0));
    }

    #[test]
    fn the_largest_ellipse_has_its_middle() {
        let area = Rectangle::new(Point::new(i32::MIN, i32::MIN), Size::new(u32::MAX, u32::MAX - 1));
        assert!(ellipse_has(&area, Point::new(0, 0)));
        assert!(!ellipse_has(&area, Point::new(i32::MIN, i32::MIN)));
    }
}
