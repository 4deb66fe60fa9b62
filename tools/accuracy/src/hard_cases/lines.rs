//! Lines of one pixel that end far away, touch the screen in a corner, or lie between two pixels.

use std::collections::HashSet;

use embedded_graphics::{
    geometry::Point,
    primitives::{self, PointsIter as _},
};
use zrow::scan;
use zrow_methods::{Line, UPRIGHT_SCREEN};

use super::peers::quietly;
use crate::{
    axis::{Cell, Summary},
    clipping,
    digits::digits,
    exact_line::ExactLine,
};

/// Lines, and what is hard in them.
struct HardCase {
    title: &'static str,
    lines: Vec<Line>,
}

/// Gives the visible pixels of a line; `None` where it does not end.
type Walk = fn(&Line) -> Option<Vec<(i32, i32)>>;

/// A peer that walks all of a line is given up after so many pixels.
const MOST_STEPS: usize = 1_000_000;

fn line(from: (i32, i32), to: (i32, i32)) -> Line {
    (Point::new(from.0, from.1), Point::new(to.0, to.1))
}

/// Lines and the same from their other end.
fn both_ways(lines: impl IntoIterator<Item = Line>) -> Vec<Line> {
    lines
        .into_iter()
        .flat_map(|(from, to)| [(from, to), (to, from)])
        .collect()
}

fn cases() -> Vec<HardCase> {
    let around = |radius: i32, center: (i32, i32)| {
        let steps = [(5, 2), (2, 5), (-2, 5), (-5, 2), (-5, -2), (-2, -5), (2, -5), (5, -2)];
        steps.map(|(x, y)| line(center, (center.0 + radius * x, center.1 + radius * y)))
    };
    let far = i32::MAX / 2;
    vec![
        HardCase {
            title: "a point, and two pixels",
            lines: both_ways([line((7, 7), (7, 7)), line((7, 7), (8, 7)), line((7, 7), (8, 8))]),
        },
        HardCase {
            title: "all octants, both ways",
            lines: both_ways(around(20, (120, 160))),
        },
        HardCase {
            title: "between two pixels at each second step",
            lines: both_ways([
                line((0, 0), (200, 100)),
                line((200, 0), (0, 100)),
                line((10, 0), (110, 200)),
            ]),
        },
        HardCase {
            title: "from corner to corner",
            lines: both_ways([
                line((0, 0), (239, 319)),
                line((239, 0), (0, 319)),
                line((0, 0), (239, 0)),
            ]),
        },
        HardCase {
            title: "a corner of the screen, and no more",
            lines: both_ways([line((-100, 100), (100, -100)), line((139, 419), (339, 219))]),
        },
        HardCase {
            title: "half a pixel outside, and back inside",
            lines: both_ways([
                line((-1000, -1), (1200, 0)),
                line((-1, -900), (0, 1100)),
                line((-3000, 319), (3000, 320)),
            ]),
        },
        HardCase {
            title: "a rise of 1 pixel in 8,191",
            lines: both_ways([line((-4000, 100), (4191, 101)), line((100, -4000), (101, 4191))]),
        },
        HardCase {
            title: "ends 8,191 pixels away",
            lines: both_ways([
                line((-8191, -8190), (8191, 8000)),
                line((8191, -8000), (-8100, 8191)),
                line((30, -8191), (210, 8191)),
            ]),
        },
        HardCase {
            title: "ends 1,073,741,823 pixels away",
            lines: both_ways([
                line((-far, -far + 5), (far, far)),
                line((-far, 40), (far, 280)),
                line((10, far), (220, -far)),
            ]),
        },
    ]
}

impl HardCase {
    /// Pixels of all lines that are seen, and how many of them a walk gets wrong; `None` where it panics or does not end.
    fn wrong(&self, walk: Walk) -> Option<usize> {
        let wrong = self.lines.iter().map(|line| {
            let drawn = quietly(|| walk(line))??;
            Some(wrong_pixels(line, &drawn))
        });
        wrong.sum()
    }

    fn seen(&self) -> usize {
        let pixels = |line: &Line| ExactLine::between(line.0, line.1).pixels(&UPRIGHT_SCREEN).len();
        self.lines.iter().map(pixels).sum()
    }
}

/// Drawn pixels that are no nearest ones, and steps that have none. Of two equally near ones either is right.
fn wrong_pixels(line: &Line, drawn: &[(i32, i32)]) -> usize {
    let exact = ExactLine::between(line.0, line.1);
    let step = |&(x, y): &(i32, i32)| if exact.is_x_major() { x } else { y };
    let steps: HashSet<i32> = drawn.iter().map(step).collect();
    // Cross products of such lines are far below 2^53, so that a half is exact.
    let is_far = |pixel: &&(i32, i32)| exact.displacement(**pixel) > 0.5;
    let missing = exact.pixels(&UPRIGHT_SCREEN);
    let missing = missing
        .iter()
        .filter(|pixel| !steps.contains(&step(pixel)) && exact.displacement(**pixel) < 0.5);
    drawn.iter().filter(is_far).count() + missing.count()
}

fn zrow(&(from, to): &Line) -> Option<Vec<(i32, i32)>> {
    let line = scan::Lines::bresenham(from, to, &UPRIGHT_SCREEN);
    Some(line.map(|point| (point.x, point.y)).collect())
}

fn embedded_graphics(&(from, to): &Line) -> Option<Vec<(i32, i32)>> {
    let points: Vec<Point> = primitives::Line::new(from, to).points().take(MOST_STEPS).collect();
    let is_whole = points.len() < MOST_STEPS;
    let seen = points.into_iter().filter(|point| UPRIGHT_SCREEN.contains(*point));
    is_whole.then(|| seen.map(|point| (point.x, point.y)).collect())
}

/// A row for each kind of line.
pub fn summary() -> anyhow::Result<Summary> {
    let walks: [(_, Walk); 3] = [
        ("zrow", zrow),
        ("embedded-graphics", embedded_graphics),
        ("lines cut at whole pixels", clipping::cut_at_whole_pixels),
    ];
    let rows = cases().into_iter().map(|case| {
        let wrong = walks.map(|(_, walk)| match case.wrong(walk) {
            Some(wrong) => digits(wrong as f64),
            None => "panics, or walks a million pixels".to_owned(),
        });
        let first = [case.title.to_owned(), digits(case.seen() as f64)];
        first.into_iter().chain(wrong).map(Cell::from).collect()
    });
    let columns = ["lines".to_owned(), "visible pixels".to_owned()];
    let walks = walks.map(|(name, _)| format!("wrong pixels of {name}"));
    Ok(Summary {
        title: "Far, flat and tied lines".to_owned(),
        columns: columns.into_iter().chain(walks).collect(),
        rows: rows.collect(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zrow_draws_the_nearest_pixels_of_all() {
        for case in cases() {
            assert_eq!(case.wrong(zrow), Some(0), "{}", case.title);
            assert!(case.seen() > 0, "{}", case.title);
        }
    }

    #[test]
    fn a_pixel_too_far_and_a_gap_are_found() {
        let line = line((0, 0), (10, 4));
        let mut drawn = zrow(&line).unwrap();
        drawn[3].1 += 1;
        assert_eq!(wrong_pixels(&line, &drawn), 1);
        drawn.remove(3);
        assert_eq!(wrong_pixels(&line, &drawn), 1);
    }
}
