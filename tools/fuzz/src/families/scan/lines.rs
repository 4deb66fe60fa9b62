//! Line siblings: their pixels by definition, through any window.

use anyhow::ensure;
use arbitrary::Arbitrary;
use embedded_graphics::{geometry::Point, primitives::PointsIter};
use zrow::{geometry::Window, scan::Lines};

use crate::{
    exact,
    target::{Case, Verdict},
    values::{Int, Spot, Stage},
};

/// A line.
#[derive(Debug, Arbitrary)]
pub struct SiblingsCase {
    stage: Stage,
    ends: [Spot; 2],
}

/// More pixels than a line has in such a window.
const TOO_MANY: usize = 1_000;

fn collect(pixels: impl Iterator<Item = Point>) -> Vec<Point> {
    pixels.take(TOO_MANY).collect()
}

/// Pixels in some order that are all inside, and no more of them than a line has.
fn is_within(name: &str, pixels: &[Point], window: &Window) -> Verdict {
    let most = if name == "supercover" {
        (window.width() * window.height()) as usize
    } else {
        window.width().max(window.height()) as usize
    };
    ensure!(pixels.len() <= most, "{name}: {} pixels in {window:?}", pixels.len());
    ensure!(
        pixels.iter().all(|pixel| window.contains(*pixel)),
        "{name}: a pixel outside of {window:?}"
    );
    Ok(())
}

fn sorted(pixels: &[Point]) -> Vec<(i32, i32)> {
    let mut pixels: Vec<_> = pixels.iter().map(|pixel| (pixel.y, pixel.x)).collect();
    pixels.sort_unstable();
    pixels
}

/// The siblings with one signature.
type Sibling = fn(Point, Point, &Window) -> Vec<Point>;

macro_rules! siblings {
    ($([$name:ident] [$($line:tt)+])+) => {
        &[$((
            stringify!($name),
            (|from, to, window| collect($($line)+(from, to, window))) as Sibling,
        )),+]
    };
}

const SIBLINGS: &[(&str, Sibling)] = zrow_methods::lines!(siblings);

impl Case for SiblingsCase {
    fn check(&self) -> Verdict {
        let Self { stage, .. } = self;
        let [from, to] = self.ends.map(|end| stage.point(end));
        let ([x0, y0], [x1, y1]) = (exact::wide(from), exact::wide(to));
        let steps = (x1 - x0).abs().max((y1 - y0).abs());
        let farthest = [x0, y0, x1, y1].map(i128::abs).into_iter().max().unwrap_or(0);
        let on_line = |pixel: &Point| exact::line_has([x0, y0], [x1, y1], exact::wide(*pixel));
        let touched = |pixel: &Point| exact::segment_touches([x0, y0], [x1, y1], exact::wide(*pixel));
        let in_order = |pixels: &mut dyn Iterator<Item = Point>| sorted(&pixels.collect::<Vec<_>>());
        let line = in_order(&mut stage.area().points().filter(on_line));
        let cells = in_order(&mut stage.area().points().filter(touched));
        // A tie is where twice the way along the minor axis is an odd number of steps.
        let has_ties = steps % 2 == 0;
        for &(name, sibling) in SIBLINGS {
            let pixels = sibling(from, to, &stage.window);
            is_within(name, &pixels, &stage.window)?;
            let found = sorted(&pixels);
            let is_exact = match name {
                "dda" => steps <= 1_365,
                "dda_fixed" => steps <= 181,
                "slope_intercept" => farthest <= 1_023 && !has_ties,
                _ => true,
            };
            let expected = if name == "supercover" { &cells } else { &line };
            ensure!(
                !is_exact || found == *expected,
                "{name}: {found:?}, by definition {expected:?}"
            );
            let reversed = sorted(&sibling(to, from, &stage.window));
            ensure!(reversed == found, "{name}: {found:?}, from the other end {reversed:?}");
            let part = sorted(&sibling(from, to, &stage.part));
            let inside = |&&(y, x): &&(i32, i32)| stage.part.contains(Point::new(x, y));
            ensure!(
                part.iter().eq(found.iter().filter(inside)),
                "{name}: {part:?} in {:?}, {found:?} in the whole",
                stage.part
            );
            let Window { left, top, .. } = stage.window;
            let reversed = Window {
                right: left,
                left: left.saturating_add(1),
                ..stage.window
            };
            let without_rows = Window {
                bottom: top,
                ..stage.window
            };
            for empty in [reversed, without_rows] {
                ensure!(
                    sibling(from, to, &empty).is_empty(),
                    "{name}: pixels in the empty {empty:?}"
                );
            }
        }
        let runs: Vec<Window> = Lines::runs(from, to, &stage.window).take(TOO_MANY).collect();
        ensure!(runs.iter().all(|run| !run.is_empty()), "an empty run in {runs:?}");
        let found = in_order(&mut runs.iter().flat_map(|run| run.to_rectangle().points()));
        ensure!(found == line, "{runs:?} are {found:?}, by definition {line:?}");
        Ok(())
    }
}

/// Runs of a line between any two pixels, through any window: most of them far too long to be walked.
#[derive(Debug, Arbitrary)]
pub struct RunsCase {
    ends: [[Int; 2]; 2],
    window: [Int; 4],
}

/// Runs that are looked at.
const RUNS: usize = 64;

/// The first and the last pixel of a run.
fn run_ends(run: &Window) -> [[i128; 2]; 2] {
    [[run.left, run.top], [run.right - 1, run.bottom - 1]].map(|pixel| pixel.map(i128::from))
}

impl Case for RunsCase {
    fn check(&self) -> Verdict {
        let [from, to] = self.ends.map(|[x, y]| Point::new(x.0, y.0));
        let [left, top, right, bottom] = self.window.map(|side| side.0);
        let window = Window {
            left,
            top,
            right,
            bottom,
        };
        let (start, end) = (exact::wide(from), exact::wide(to));
        let [dx, dy] = [end[0] - start[0], end[1] - start[1]];
        let [first_column, end_column, first_row, end_row] = [left, right, top, bottom].map(i128::from);
        let is_inside =
            |[x, y]: [i128; 2]| (first_column..end_column).contains(&x) && (first_row..end_row).contains(&y);
        // Whether a pixel is one of the line that the window shows.
        let is_visible = |pixel: [i128; 2]| is_inside(pixel) && exact::line_has(start, end, pixel);
        let runs: Vec<Window> = Lines::runs(from, to, &window).take(RUNS).collect();
        ensure!(
            !runs.is_empty() || !is_visible(start) && !is_visible(end),
            "no run of {from:?} to {to:?} in {window:?}"
        );
        // Downwards, and then to the same side from run to run.
        let sideways = if dx.signum() * dy.signum() < 0 { -1 } else { 1 };
        let in_rows = dx.abs() >= dy.abs();
        for (index, run) in runs.iter().enumerate() {
            ensure!(!run.is_empty(), "{run:?} is empty");
            let thickness = if in_rows { run.height() } else { run.width() };
            ensure!(thickness == 1, "{run:?} is across the line");
            let [first, last] = run_ends(run);
            ensure!(
                is_visible(first) && is_visible(last),
                "{run:?} ends beside the line from {from:?} to {to:?}, or outside of {window:?}"
            );
            // What continues it to either side is another run.
            let [before, behind] = if in_rows {
                [[first[0] - 1, first[1]], [last[0] + 1, last[1]]]
            } else {
                [[first[0], first[1] - 1], [last[0], last[1] + 1]]
            };
            ensure!(
                !is_visible(before) && !is_visible(behind),
                "{run:?} ends too early in {window:?}"
            );
            // The pixels diagonally above its upper end and below its lower end.
            let (upper, lower) = if in_rows && sideways < 0 {
                (last, first)
            } else {
                (first, last)
            };
            let above = [upper[0] - sideways, upper[1] - 1];
            let below = [lower[0] + sideways, lower[1] + 1];
            if index == 0 {
                ensure!(!is_visible(above), "a run before {run:?} is missing");
            }
            match runs.get(index + 1) {
                Some(next) => {
                    ensure!(run_ends(next).contains(&below), "{next:?} does not follow {run:?}");
                }
                None if index + 1 < RUNS => ensure!(!is_visible(below), "a run behind {run:?} is missing"),
                None => {}
            }
        }
        Ok(())
    }
}
