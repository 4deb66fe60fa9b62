//! The exact area of a polygon in each pixel, in integers, by slabs; nothing here is zrow's.
//!
//! A slab lies between two neighbouring ordinates out of: the boundaries of rows, the corners, the crossings of two edges,
//! the crossings of an edge with a boundary of columns. In it no edge crosses another or leaves its column, so the area
//! that an edge leaves to its right in a pixel is that of one trapezoid, which its middle decides.
//!
//! Error: ordinates and the abscissas at them are rounded to 2^-32 pixel, everything else is exact. Each slab so adds at
//! most 2^-31 square pixel to a pixel, and there are fewer than 2^9 slabs in a row of the shapes here: below 2^-22, where
//! the report's unit is 2^-8.

use zrow_methods::{Rule, Shape};

/// Fractional bits of a pixel.
const BITS: u32 = 32;
const PIXEL: i128 = 1 << BITS;
/// Coverage nearer to nothing or all than this may be rounding, and is taken for it: below 1/1,000 of the report's unit.
const ROUNDING: f64 = 1.0 / (1 << 20) as f64;

/// A side of the polygon from top to bottom, with the corner of the top left pixel at the origin.
#[derive(Clone, Copy)]
struct Edge {
    /// In half units of the shape: so products of three fit after a shift by [`BITS`].
    top: (i128, i128),
    bottom: (i128, i128),
    winding: i32,
    /// Half units of a pixel.
    pixel: i128,
}

impl Edge {
    fn new(from: (i32, i32), to: (i32, i32), units: i32) -> Option<Self> {
        let units = i128::from(units);
        // From pixel centres to corners.
        let corner = |(x, y): (i32, i32)| (2 * i128::from(x) + units, 2 * i128::from(y) + units);
        let (from, to) = (corner(from), corner(to));
        let (top, bottom, winding) = if from.1 < to.1 { (from, to, 1) } else { (to, from, -1) };
        (top.1 != bottom.1).then_some(Self {
            top,
            bottom,
            winding,
            pixel: 2 * units,
        })
    }

    /// From half units to 2^-32 pixel, which is exact: units are a power of two.
    fn fine(&self, half_units: i128) -> i128 {
        half_units * PIXEL / self.pixel
    }

    fn delta(&self) -> (i128, i128) {
        (self.bottom.0 - self.top.0, self.bottom.1 - self.top.1)
    }

    /// Its abscissa, both in 2^-32 pixel.
    fn x_at(&self, y: i128) -> i128 {
        let (dx, dy) = self.delta();
        self.fine(self.top.0) + rounded(dx * (y - self.fine(self.top.1)), dy)
    }

    /// Where it crosses boundaries of columns, in 2^-32 pixel.
    fn column_crossings(&self) -> impl Iterator<Item = i128> {
        let (dx, dy) = self.delta();
        let (low, high) = (self.top.0.min(self.bottom.0), self.top.0.max(self.bottom.0));
        // Those at its ends are ordinates anyway.
        let columns = low.div_euclid(self.pixel)..=high.div_euclid(self.pixel);
        let boundaries = columns.map(|column| column * self.pixel);
        let (top, first) = (self.top, self.fine(self.top.1));
        boundaries
            .filter(move |boundary| low < *boundary && *boundary < high)
            .map(move |boundary| first + rounded(self.fine((boundary - top.0) * dy), dx))
    }

    /// The ordinate where the lines through both edges cross, in 2^-32 pixel.
    fn crossing(&self, other: &Self) -> Option<i128> {
        let ((dx, dy), (other_dx, other_dy)) = (self.delta(), other.delta());
        let divisor = dx * other_dy - other_dx * dy;
        let dividend =
            (other.top.0 - self.top.0) * dy * other_dy + self.top.1 * dx * other_dy - other.top.1 * other_dx * dy;
        (divisor != 0).then(|| rounded(self.fine(dividend), divisor))
    }

    fn spans(&self, top: i128, bottom: i128) -> bool {
        self.fine(self.top.1) <= top && bottom <= self.fine(self.bottom.1)
    }
}

fn rounded(dividend: i128, divisor: i128) -> i128 {
    let (dividend, divisor) = (dividend * divisor.signum(), divisor.abs());
    (dividend + divisor / 2).div_euclid(divisor)
}

/// The coverage of each of `size` x `size` pixels that the shape covers, row by row: 0 is nothing, 1 all of it.
pub fn exact(shape: &Shape, size: usize) -> Vec<f64> {
    let edges = edges(shape);
    let ordinates = ordinates(&edges, size);
    let mut areas = vec![0; size * size];
    for slab in ordinates.windows(2) {
        let (top, bottom) = (slab[0], slab[1]);
        if let Some(row) = areas.chunks_mut(size).nth((top / PIXEL) as usize) {
            add_slab(&edges, shape.rule, top, bottom, row);
        }
    }
    areas.into_iter().map(coverage).collect()
}

fn coverage(area: i128) -> f64 {
    // Heights in 2^-32 pixel times doubled widths.
    let coverage = area as f64 / (2 * PIXEL * PIXEL) as f64;
    if coverage < ROUNDING {
        0.0
    } else if coverage > 1.0 - ROUNDING {
        1.0
    } else {
        coverage
    }
}

fn edges(shape: &Shape) -> Vec<Edge> {
    let sides = shape.contours.iter().flat_map(|contour| {
        let nexts = contour.iter().cycle().skip(1);
        contour.iter().zip(nexts)
    });
    sides
        .filter_map(|(&from, &to)| Edge::new(from, to, shape.units))
        .collect()
}

fn ordinates(edges: &[Edge], size: usize) -> Vec<i128> {
    let mut ordinates: Vec<i128> = (0..=size as i128).map(|row| row * PIXEL).collect();
    for (index, edge) in edges.iter().enumerate() {
        ordinates.extend([edge.fine(edge.top.1), edge.fine(edge.bottom.1)]);
        ordinates.extend(edge.column_crossings());
        let meets = |other: &&Edge| other.top.1.max(edge.top.1) < other.bottom.1.min(edge.bottom.1);
        ordinates.extend(
            edges[..index]
                .iter()
                .filter(meets)
                .filter_map(|other| edge.crossing(other)),
        );
    }
    ordinates.retain(|ordinate| (0..=size as i128 * PIXEL).contains(ordinate));
    ordinates.sort_unstable();
    ordinates.dedup();
    ordinates
}

fn add_slab(edges: &[Edge], rule: Rule, top: i128, bottom: i128, row: &mut [i128]) {
    // Twice the abscissa in the middle.
    let middle = |edge: &Edge| edge.x_at(top) + edge.x_at(bottom);
    let mut crossed: Vec<(i128, i32)> = edges
        .iter()
        .filter(|edge| edge.spans(top, bottom))
        .map(|edge| (middle(edge), edge.winding))
        .collect();
    crossed.sort_unstable();
    let mut winding = 0;
    for pair in crossed.windows(2) {
        winding += match rule {
            Rule::NonZero => pair[0].1,
            Rule::EvenOdd => 1,
        };
        let inside = match rule {
            Rule::NonZero => winding != 0,
            Rule::EvenOdd => winding % 2 != 0,
        };
        if inside {
            add_interval(pair[0].0, pair[1].0, bottom - top, row);
        }
    }
}

fn add_interval(left: i128, right: i128, height: i128, row: &mut [i128]) {
    for (column, area) in row.iter_mut().enumerate() {
        let start = column as i128 * 2 * PIXEL;
        let within = |x: i128| x.clamp(start, start + 2 * PIXEL);
        *area += (within(right) - within(left)) * height;
    }
}

#[cfg(test)]
mod tests {
    use zrow_methods::{Class, SHAPES, SIZE, UNITS};

    use super::*;

    /// A polygon with corners in pixels, whose pixel (0, 0) begins at (0, 0).
    fn polygon(corners: &[(f64, f64)], rule: Rule) -> Shape {
        let units = |pixels: f64| (pixels * 256.0) as i32 - 128;
        let contour = corners.iter().map(|&(x, y)| (units(x), units(y))).collect();
        Shape {
            contours: [contour].into_iter().collect(),
            rule,
            units: UNITS,
        }
    }

    #[test]
    fn a_square_between_pixels_covers_quarters() {
        let square = polygon(&[(0.5, 0.5), (2.5, 0.5), (2.5, 2.5), (0.5, 2.5)], Rule::NonZero);
        let expected = [0.25, 0.5, 0.25, 0.5, 1.0, 0.5, 0.25, 0.5, 0.25];
        assert_eq!(exact(&square, 3), expected);
    }

    #[test]
    fn half_a_pixel_under_a_diagonal() {
        let triangle = polygon(&[(1.0, 1.0), (2.0, 2.0), (1.0, 2.0)], Rule::EvenOdd);
        let mut expected = [0.0; 9];
        expected[4] = 0.5;
        assert_eq!(exact(&triangle, 3), expected);
    }

    #[test]
    fn the_bow_tie_covers_half_of_its_middle_by_both_rules() {
        for rule in [Rule::EvenOdd, Rule::NonZero] {
            let bow_tie = polygon(&[(1.0, 1.0), (8.0, 1.0), (1.0, 8.0), (8.0, 8.0)], rule);
            let coverages = exact(&bow_tie, 9);
            assert_eq!(coverages[4 * 9 + 4] * 255.0, 127.5);
            // Two triangles of 7 by 3.5.
            assert!((coverages.iter().sum::<f64>() - 24.5).abs() < 1e-6);
        }
    }

    #[test]
    fn the_rules_differ_where_a_contour_winds_twice() {
        let twice = [(0.0, 0.0), (3.0, 0.0), (3.0, 3.0), (0.0, 3.0)].repeat(2);
        assert_eq!(exact(&polygon(&twice, Rule::NonZero), 3), [1.0; 9]);
        assert_eq!(exact(&polygon(&twice, Rule::EvenOdd), 3), [0.0; 9]);
    }

    /// The area by the shoelace formula, in square pixels.
    fn area(shape: &Shape) -> f64 {
        let doubled = |contour: &[(i32, i32)]| -> i64 {
            let nexts = contour.iter().cycle().skip(1);
            let cross = |((x, y), (next_x, next_y)): (&(i32, i32), &(i32, i32))| {
                i64::from(*x) * i64::from(*next_y) - i64::from(*y) * i64::from(*next_x)
            };
            contour.iter().zip(nexts).map(cross).sum()
        };
        let sum: i64 = shape.contours.iter().map(|contour| doubled(contour)).sum();
        sum.abs() as f64 / 2.0 / f64::from(UNITS * UNITS)
    }

    #[test]
    fn shares_add_up_to_the_area() {
        // A star winds about its middle more than once.
        for class in Class::ALL.into_iter().filter(|class| *class != Class::Star) {
            for number in 0..SHAPES {
                let shape = class.shape(number);
                let sum: f64 = exact(&shape, SIZE).iter().sum();
                assert!(
                    (sum - area(&shape)).abs() < 1e-4,
                    "{class:?} {number}: {sum}, not {}",
                    area(&shape)
                );
            }
        }
    }

    #[test]
    fn a_star_is_what_dense_samples_say() {
        let shape = Class::Star.shape(0);
        let coverages = exact(&shape, SIZE);
        let edges = edges(&shape);
        let samples = 32;
        for (pixel, coverage) in coverages.iter().enumerate() {
            let (column, row) = ((pixel % SIZE) as i128, (pixel / SIZE) as i128);
            let mut inside = 0;
            for sample in 0..samples * samples {
                let at = |whole: i128, part: i128| whole * PIXEL + (2 * part + 1) * PIXEL / (2 * samples);
                let (x, y) = (at(column, sample % samples), at(row, sample / samples));
                let crossed = edges.iter().filter(|edge| edge.spans(y, y) && edge.x_at(y) < x);
                inside += i32::from(crossed.map(|edge| edge.winding).sum::<i32>() != 0);
            }
            let sampled = f64::from(inside) / (samples * samples) as f64;
            assert!(
                (sampled - coverage).abs() < 0.06,
                "{column} {row}: {sampled}, not {coverage}"
            );
        }
    }
}
