//! Line siblings: their pixels by definition, through any window.

use anyhow::ensure;
use arbitrary::Arbitrary;
use embedded_graphics::{geometry::Point, primitives::PointsIter};
use zrow::{
    geometry::Window,
    scan::line::{
        bresenham,
        bresenham_runs::{self, LineRuns},
        dda, dda_fixed, double_step, midpoint, slope_intercept, supercover,
    },
    surface::LineSteps,
};

use crate::{
    exact,
    target::{Case, Verdict},
    values::{Count, Int, Length, Spot, Stage},
};

/// A line, moved or not.
#[derive(Debug, Arbitrary)]
pub struct SiblingsCase {
    stage: Stage,
    ends: [Spot; 2],
    offset: [Int; 2],
}

/// The pixels that one of the siblings gives.
type Pixels = Option<Vec<Point>>;

/// More pixels than a line has in such a window.
const TOO_MANY: usize = 1_000;

fn collect(pixels: Option<impl Iterator<Item = Point>>) -> Pixels {
    pixels.map(|pixels| pixels.take(TOO_MANY).collect())
}

/// Pixels in some order that are all inside and all different; `None` is for no pixel.
fn is_within(name: &str, pixels: &Pixels, window: &Window) -> Verdict {
    let Some(pixels) = pixels else { return Ok(()) };
    ensure!(!pixels.is_empty(), "{name}: no pixel, and not None");
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

fn sorted(pixels: &Pixels) -> Vec<(i32, i32)> {
    let mut pixels: Vec<_> = pixels.iter().flatten().map(|pixel| (pixel.y, pixel.x)).collect();
    pixels.sort_unstable();
    pixels
}

/// The siblings with one signature.
type Sibling = fn(Point, Point, &Window) -> Pixels;

const SIBLINGS: [(&str, Sibling); 8] = [
    ("bresenham", |from, to, window| {
        collect(bresenham(from, to, window).map(LineSteps::into_iter))
    }),
    ("bresenham_runs", |from, to, window| {
        collect(bresenham_runs(from, to, window).map(IntoIterator::into_iter))
    }),
    ("midpoint", |from, to, window| collect(midpoint(from, to, window))),
    ("double_step", |from, to, window| collect(double_step(from, to, window))),
    ("dda", |from, to, window| collect(dda(from, to, window))),
    ("dda_fixed", |from, to, window| collect(dda_fixed(from, to, window))),
    ("slope_intercept", |from, to, window| {
        collect(slope_intercept(from, to, window))
    }),
    ("supercover", |from, to, window| collect(supercover(from, to, window))),
];

impl Case for SiblingsCase {
    fn check(&self) -> Verdict {
        let Self { stage, .. } = self;
        let [from, to] = self.ends.map(|end| stage.point(end));
        let ([x0, y0], [x1, y1]) = (exact::wide(from), exact::wide(to));
        let steps = (x1 - x0).abs().max((y1 - y0).abs());
        let farthest = [x0, y0, x1, y1].map(i128::abs).into_iter().max().unwrap_or(0);
        let on_line = |pixel: &Point| exact::line_has([x0, y0], [x1, y1], exact::wide(*pixel));
        let touched = |pixel: &Point| exact::segment_touches([x0, y0], [x1, y1], exact::wide(*pixel));
        let in_order = |pixels: &mut dyn Iterator<Item = Point>| sorted(&Some(pixels.collect()));
        let line = in_order(&mut stage.area().points().filter(on_line));
        let cells = in_order(&mut stage.area().points().filter(touched));
        // A tie is where twice the way along the minor axis is an odd number of steps.
        let has_ties = steps % 2 == 0;
        for (name, sibling) in SIBLINGS {
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
                    sibling(from, to, &empty).is_none(),
                    "{name}: pixels in the empty {empty:?}"
                );
            }
        }
        // A run is a stretch of pixels.
        if let Some(line) = bresenham_runs(from, to, &stage.window) {
            let runs: Vec<Window> = line.runs().take(TOO_MANY).map(|run| run.to_window()).collect();
            ensure!(runs.iter().all(|run| !run.is_empty()), "an empty run in {runs:?}");
            let pixels = runs.iter().flat_map(|run| run.to_rectangle().points());
            ensure!(
                in_order(&mut { pixels }) == line_pixels(&line),
                "{runs:?} are other pixels"
            );
        }
        let offset = Point::new(self.offset[0].0, self.offset[1].0);
        let moved = collect(bresenham::moved_line(from, to, offset, &stage.window).map(LineSteps::into_iter));
        is_within("moved_line", &moved, &stage.window)?;
        let [dx, dy] = exact::wide(offset);
        let on_moved = |pixel: &Point| exact::line_has([x0 + dx, y0 + dy], [x1 + dx, y1 + dy], exact::wide(*pixel));
        let expected = in_order(&mut stage.area().points().filter(on_moved));
        ensure!(
            sorted(&moved) == expected,
            "{:?} moved, by definition {expected:?}",
            sorted(&moved)
        );
        Ok(())
    }
}

fn line_pixels(line: &LineRuns) -> Vec<(i32, i32)> {
    sorted(&Some(line.into_iter().take(TOO_MANY).collect()))
}

/// Runs of steps that may be no line's.
#[derive(Debug, Arbitrary)]
pub struct RunsCase {
    start: [Int; 2],
    count: Length,
    flags: [bool; 2],
    error: Count,
    deltas: [Count; 2],
    is_line: bool,
}

impl Case for RunsCase {
    fn check(&self) -> Verdict {
        let [one, other] = self.deltas.map(|delta| delta.0);
        let (mut minor_delta, mut major_delta, mut error) = (one, other, self.error.0);
        if self.is_line {
            (minor_delta, major_delta) = (one.min(other), one.max(other));
            error = error.checked_rem(major_delta).unwrap_or(0);
        }
        let steps = LineSteps {
            start: Point::new(self.start[0].0 / 2, self.start[1].0 / 2),
            count: self.count.0.max(1),
            x_major: self.flags[0],
            leftwards: self.flags[1],
            error,
            minor_delta,
            major_delta,
        };
        let runs = LineRuns::from(steps);
        let walked: Vec<Point> = runs.into_iter().take(200).collect();
        let _ = runs.runs().take(200).count();
        if self.is_line && steps.count < 200 {
            // The pixels of a run may come in the other order.
            let stepped = sorted(&Some(steps.into_iter().collect()));
            ensure!(
                sorted(&Some(walked)) == stepped,
                "runs have other pixels than {steps:?}"
            );
        }
        Ok(())
    }
}
