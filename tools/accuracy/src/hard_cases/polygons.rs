//! Polygons that are degenerate, cross themselves or reach far outside: their exact area, zrow's, and the errors of others.

use anyhow::Context as _;
use zrow_methods::{Contour, Input, METHODS, Rule, SIZE, Shape, UNITS};

use super::peers::PEERS;
use crate::{
    axis::{Cell, Summary},
    digits::digits,
    errors::FULL,
    reference,
};

/// A polygon, and what others do with it.
struct HardCase {
    title: &'static str,
    rule: Rule,
    /// In 1/256 pixel, closed.
    contours: Vec<Vec<(i32, i32)>>,
    others: &'static str,
}

/// From pixels.
fn pixels(corners: &[(f64, f64)]) -> Vec<(i32, i32)> {
    let units = |pixels: f64| (pixels * f64::from(UNITS)) as i32;
    corners.iter().map(|(x, y)| (units(*x), units(*y))).collect()
}

/// An upright rectangle, clockwise.
fn rectangle([left, top, right, bottom]: [f64; 4]) -> Vec<(i32, i32)> {
    pixels(&[(left, top), (right, top), (right, bottom), (left, bottom)])
}

fn reversed(mut contour: Vec<(i32, i32)>) -> Vec<(i32, i32)> {
    contour.reverse();
    contour
}

fn cases() -> Vec<HardCase> {
    let comb = (0..60).flat_map(|tooth| {
        let x = 20 * 256 + 2 * tooth;
        [(x, 40 * 256), (x, 8 * 256), (x + 1, 8 * 256), (x + 1, 40 * 256)]
    });
    let square = rectangle([10.25, 10.25, 30.75, 30.75]);
    let comb: Vec<_> = comb.take(124).chain([(10 * 256, 44 * 256)]).collect();
    vec![
        HardCase {
            title: "a bow tie: two edges cross in the middle of a pixel",
            rule: Rule::EvenOdd,
            // Pixel centres lie at whole numbers.
            contours: vec![pixels(&[(0.5, 0.5), (7.5, 0.5), (0.5, 7.5), (7.5, 7.5)])],
            others: "FreeType, zeno, ab_glyph and vello_cpu: 0 of 255 in that pixel, where 127.5 is right",
        },
        HardCase {
            title: "a square that is wound around 31 times",
            rule: Rule::NonZero,
            contours: vec![square.repeat(31)],
            others: "counters of 4 bits are full: vello #380",
        },
        HardCase {
            title: "a hole that touches the border in a corner",
            rule: Rule::EvenOdd,
            contours: vec![
                rectangle([5.0, 5.0, 40.0, 40.0]),
                pixels(&[(5.0, 5.0), (20.5, 10.25), (10.25, 20.5)]),
            ],
            others: "-",
        },
        HardCase {
            title: "a hole that has an edge in common with the border",
            rule: Rule::NonZero,
            contours: vec![
                rectangle([5.5, 5.5, 40.5, 40.5]),
                reversed(rectangle([5.5, 12.25, 20.5, 30.75])),
            ],
            others: "-",
        },
        HardCase {
            title: "a hole as large as the shape: nothing is left",
            rule: Rule::NonZero,
            contours: vec![square.clone(), reversed(square)],
            others: "font-rs and ab_glyph #121: what is left of the sums is a shadow",
        },
        HardCase {
            title: "a spike without width",
            rule: Rule::EvenOdd,
            contours: vec![pixels(&[
                (10.5, 30.5),
                (20.5, 30.5),
                (20.5, 2.25),
                (20.5, 30.5),
                (30.5, 30.5),
                (20.5, 40.25),
            ])],
            others: "-",
        },
        HardCase {
            title: "a sliver of 1/256 pixel",
            rule: Rule::NonZero,
            contours: vec![vec![(2 * 256, 3 * 256), (45 * 256, 31 * 256), (45 * 256, 31 * 256 + 1)]],
            others: "-",
        },
        HardCase {
            title: "a comb whose teeth are 1/256 pixel wide and apart",
            rule: Rule::EvenOdd,
            contours: vec![comb],
            others: "sampling finds all of a tooth or nothing",
        },
        HardCase {
            title: "a hairline of 0.15 pixel",
            rule: Rule::NonZero,
            contours: vec![pixels(&[(2.1, 5.2), (45.3, 40.1), (45.2, 40.22), (2.0, 5.32)])],
            others: "Skia: rms error of 19.7 of 255",
        },
        HardCase {
            title: "edges that rise by 1 pixel in 45",
            rule: Rule::NonZero,
            contours: vec![pixels(&[(1.0, 20.1), (46.0, 21.1), (46.0, 23.35), (1.0, 22.35)])],
            others: "4 x 4 samples, as of tiny-skia: rms error of 17.5 of 255",
        },
        HardCase {
            title: "corners 8,000 pixels outside",
            rule: Rule::NonZero,
            contours: vec![pixels(&[(-8_000.0, -7_990.0), (8_000.0, 8_000.0), (-8_000.0, 7_900.0)])],
            others: "ab_glyph #119 and #120, font-rs #45: index out of bounds; zeno panics in debug at 1,000,000 pixels",
        },
        HardCase {
            title: "corners that are there twice, and on a line",
            rule: Rule::NonZero,
            contours: vec![pixels(&[
                (10.0, 10.0),
                (10.0, 10.0),
                (20.0, 10.0),
                (30.0, 10.0),
                (30.0, 10.0),
                (30.0, 35.5),
                (20.0, 22.75),
                (10.0, 10.0),
            ])],
            others: "-",
        },
    ]
}

impl HardCase {
    fn shape(&self) -> anyhow::Result<Shape> {
        let contours = self.contours.iter().map(|corners| Contour::from_slice(corners));
        let contours: Result<Vec<_>, _> = contours.collect();
        let contours = contours.ok().context("too many corners")?;
        Ok(Shape {
            contours: contours.into_iter().collect(),
            rule: self.rule,
            units: UNITS,
        })
    }

    /// The area in pixels, exact and as drawn, and the largest error of a pixel of 255.
    fn drawn(&self, method: &str) -> anyhow::Result<[f64; 3]> {
        let shape = self.shape()?;
        let exact = reference::exact(&shape, SIZE);
        let method = METHODS.iter().find(|known| known.name == method);
        let method = method.context("no such method")?;
        let mut mask = vec![0; SIZE * SIZE];
        (method.cover)(&Input::new(&shape)?, &mut mask);
        let errors = exact.iter().zip(&mask);
        let errors = errors.map(|(coverage, drawn)| (f64::from(*drawn) - coverage * FULL).abs());
        Ok([
            exact.iter().sum(),
            mask.iter().map(|drawn| f64::from(*drawn) / FULL).sum(),
            errors.fold(0.0, f64::max),
        ])
    }
}

/// A row for each polygon.
pub fn summary() -> anyhow::Result<Summary> {
    let rows = cases().into_iter().map(|case| {
        let [exact, drawn, crossings] = case.drawn("inside_area")?;
        let [_, _, signed] = case.drawn("signed_area")?;
        let figures = [exact, drawn, crossings, signed].map(digits);
        let shape = case.shape()?;
        let coverage = reference::exact(&shape, SIZE);
        let peers = PEERS.iter().map(|peer| peer.largest_error(&shape, &coverage));
        let cells = [case.title.to_owned()].into_iter().chain(figures).chain(peers);
        Ok(cells.chain([case.others.to_owned()]).map(Cell::from).collect())
    });
    let columns = [
        "polygon",
        "exact area in pixels",
        "area drawn by zrow",
        "largest error of 255",
        "the same without crossings",
    ];
    let peers = PEERS.iter().map(|peer| format!("the same by {}", peer.name));
    let columns = columns.map(str::to_owned).into_iter().chain(peers);
    Ok(Summary {
        title: "Degenerate, crossing and far polygons".to_owned(),
        columns: columns
            .chain(["others, as their trackers and runs have it".to_owned()])
            .collect(),
        rows: rows.collect::<anyhow::Result<_>>()?,
    })
}

#[cfg(test)]
mod tests {
    use super::cases;

    /// Edges that cross in a pixel, and thousands of teeth in it, leave no more than rounding.
    #[test]
    fn hard_cases_are_drawn_as_they_are() {
        for case in cases() {
            let [exact, drawn, error] = case.drawn("inside_area").unwrap();
            assert!(error <= 3.0, "{}: {error} of 255", case.title);
            assert!(
                (exact - drawn).abs() <= 0.01 * exact.max(10.0),
                "{}: {exact}, {drawn}",
                case.title
            );
        }
    }
}
