//! Regions with borders in common, clipped by each other: the areas of what is left.

use anyhow::Context as _;
use fixed::types::I24F8;
use zrow::{
    clip::{Clipper, Operation},
    geometry::{Sub8, SubPoint},
};

use crate::{
    axis::{Cell, Summary},
    digits::digits,
};

type Corners = &'static [(i32, i32)];

/// Two regions, and the areas of their intersection and union in pixels, by hand.
struct HardCase {
    title: &'static str,
    subject: &'static [Corners],
    clip: &'static [Corners],
    intersection: f64,
    union: f64,
}

const SQUARE: Corners = &[(0, 0), (8, 0), (8, 8), (0, 8)];

const CASES: &[HardCase] = &[
    HardCase {
        title: "a square by itself",
        subject: &[SQUARE],
        clip: &[SQUARE],
        intersection: 64.0,
        union: 64.0,
    },
    HardCase {
        title: "the same square, the other way around",
        subject: &[SQUARE],
        clip: &[&[(0, 0), (0, 8), (8, 8), (8, 0)]],
        intersection: 64.0,
        union: 64.0,
    },
    HardCase {
        title: "neighbours with an edge in common",
        subject: &[SQUARE],
        clip: &[&[(8, 2), (12, 2), (12, 6), (8, 6)]],
        intersection: 0.0,
        union: 80.0,
    },
    HardCase {
        title: "neighbours that touch in a corner",
        subject: &[SQUARE],
        clip: &[&[(8, 8), (12, 8), (12, 12), (8, 12)]],
        intersection: 0.0,
        union: 80.0,
    },
    HardCase {
        title: "a corner on an edge",
        subject: &[SQUARE],
        clip: &[&[(4, 0), (10, 4), (4, 8)]],
        // Beyond column 8 lies a triangle of 2 by 8/3 pixels.
        intersection: 24.0 - 8.0 / 3.0,
        union: 64.0 + 8.0 / 3.0,
    },
    HardCase {
        title: "a slot whose mouth lies on the border",
        subject: &[SQUARE],
        clip: &[&[(3, 0), (5, 0), (5, 4), (3, 4)]],
        intersection: 8.0,
        union: 64.0,
    },
    HardCase {
        title: "a window inside a hole",
        subject: &[
            &[(0, 0), (12, 0), (12, 12), (0, 12)],
            &[(2, 2), (2, 10), (10, 10), (10, 2)],
        ],
        clip: &[&[(4, 4), (8, 4), (8, 8), (4, 8)]],
        intersection: 0.0,
        union: 96.0,
    },
    HardCase {
        title: "a window as large as the hole",
        subject: &[
            &[(0, 0), (12, 0), (12, 12), (0, 12)],
            &[(2, 2), (2, 10), (10, 10), (10, 2)],
        ],
        clip: &[&[(2, 2), (10, 2), (10, 10), (2, 10)]],
        intersection: 0.0,
        union: 144.0,
    },
    HardCase {
        title: "a U, of which two pieces are left",
        subject: &[&[(0, 0), (3, 0), (3, 9), (6, 9), (6, 0), (9, 0), (9, 12), (0, 12)]],
        clip: &[&[(-1, 2), (10, 2), (10, 6), (-1, 6)]],
        intersection: 24.0,
        union: 81.0 + 44.0 - 24.0,
    },
    HardCase {
        title: "a spike that runs along an edge",
        subject: &[&[(0, 0), (8, 0), (12, 0), (8, 0), (8, 8), (0, 8)]],
        clip: &[&[(4, -2), (14, -2), (14, 0), (4, 0)]],
        intersection: 0.0,
        union: 84.0,
    },
];

impl HardCase {
    /// The area that is left, in pixels.
    fn area(&self, operation: Operation) -> anyhow::Result<f64> {
        let [subject, clip] = [points(self.subject)?, points(self.clip)?];
        let [subject, clip] = [slices(&subject), slices(&clip)];
        let mut clipper = Clipper::<Sub8, 128>::new();
        let result = clipper.greiner_hormann(&subject, &clip, operation);
        let result = result.map_err(|error| anyhow::anyhow!("{error}")).context(self.title)?;
        let areas = result.map(|contour| doubled_area(&contour.points().collect::<Vec<_>>()));
        // Contours of holes go around the other way.
        Ok(areas.sum::<i64>().abs() as f64 / f64::from(2 * 256 * 256))
    }
}

fn points(contours: &[Corners]) -> anyhow::Result<Vec<Vec<SubPoint<Sub8>>>> {
    let contour = |corners: &Corners| {
        let points = corners.iter().map(|(x, y)| SubPoint::from_units(x << 8, y << 8));
        points
            .collect::<Result<_, _>>()
            .map_err(|error| anyhow::anyhow!("{error}"))
    };
    contours.iter().map(contour).collect()
}

fn slices(contours: &[Vec<SubPoint<Sub8>>]) -> Vec<&[SubPoint<Sub8>]> {
    contours.iter().map(Vec::as_slice).collect()
}

/// Twice the area in square units, positive one way around and negative the other.
fn doubled_area(points: &[SubPoint<Sub8>]) -> i64 {
    let pairs = points.iter().zip(points.iter().cycle().skip(1));
    let product = |x: I24F8, y: I24F8| i64::from(x.to_bits()) * i64::from(y.to_bits());
    pairs
        .map(|(from, to)| product(from.x, to.y) - product(to.x, from.y))
        .sum()
}

/// A row for each pair of regions.
pub fn summary() -> anyhow::Result<Summary> {
    let rows = CASES.iter().map(|case| {
        let figures = [
            case.intersection,
            case.area(Operation::Intersection)?,
            case.union,
            case.area(Operation::Union)?,
        ];
        let figures = figures.map(digits).into_iter();
        Ok([case.title.to_owned()]
            .into_iter()
            .chain(figures)
            .map(Cell::from)
            .collect())
    });
    let columns = [
        "regions",
        "exact area of the intersection in pixels",
        "that of zrow",
        "exact area of the union",
        "that of zrow",
    ];
    Ok(Summary {
        title: "Regions with borders in common".to_owned(),
        columns: columns.map(str::to_owned).to_vec(),
        rows: rows.collect::<anyhow::Result<_>>()?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Corners on crossings are rounded to 1/256 pixel, which moves less than 1/32 square pixel here.
    #[test]
    fn areas_are_those_by_hand() {
        for case in CASES {
            for (operation, exact) in [
                (Operation::Intersection, case.intersection),
                (Operation::Union, case.union),
            ] {
                let area = case.area(operation).unwrap();
                assert!(
                    (area - exact).abs() < 1.0 / 32.0,
                    "{} {operation:?}: {area}, not {exact}",
                    case.title
                );
            }
        }
    }
}
