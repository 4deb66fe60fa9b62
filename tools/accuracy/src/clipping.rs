//! Segment clipping: what rounding the clipped end does to the line that is drawn from it.

use std::hint::black_box;

use embedded_graphics::geometry::Point;
use zrow::{clip::Segments, geometry::SubPoint, scan::Lines};
use zrow_methods::{Fraction, Line, SCREEN, UPRIGHT_SCREEN, clip_window, cut_lines};

use super::{
    axis::{Axis, Chapter, Context, Entry},
    errors::Errors,
    exact_line::{ExactLine, differing},
    picture::Picture,
    timing::{Spread, Work, interleaved},
};

/// Lines of a whole run.
const LINES: usize = 1000;
const UNITS: f64 = 256.0;

/// Where the end of a clipped line is kept.
pub struct Clipping;

/// What is drawn, and how far the ends that were cut are off, in pixels.
type Drawn = (Vec<(i32, i32)>, Vec<f64>);

struct Method {
    name: &'static str,
    variant: &'static str,
    draw: fn(Line) -> anyhow::Result<Drawn>,
    /// Finds the end, and draws nothing.
    clip: fn(&Line),
}

const METHODS: &[Method] = &[
    Method {
        name: "whole pixel",
        variant: "whole_pixel",
        draw: draw::<0, false>,
        clip: clip::<0, false>,
    },
    Method {
        name: "1/16 px",
        variant: "1_16",
        draw: draw::<4, false>,
        clip: clip::<4, false>,
    },
    Method {
        name: "1/256 px",
        variant: "1_256",
        draw: draw::<8, false>,
        clip: clip::<8, false>,
    },
    Method {
        name: "1/65536 px",
        variant: "1_65536",
        draw: draw::<16, false>,
        clip: clip::<16, false>,
    },
    Method {
        name: "1/256 px, grown window",
        variant: "1_256_grown",
        draw: draw::<8, true>,
        clip: clip::<8, true>,
    },
    Method {
        name: "1/65536 px, grown window",
        variant: "1_65536_grown",
        draw: draw::<16, true>,
        clip: clip::<16, true>,
    },
    Method {
        name: "error term kept",
        variant: "error_term_kept",
        draw: draw_with_error_term,
        clip: |&(from, to)| {
            black_box(Lines::bresenham(from, to, &SCREEN).next());
        },
    },
];

impl Axis for Clipping {
    fn name(&self) -> &'static str {
        "clipping"
    }

    fn counts(&self) -> Vec<String> {
        METHODS.iter().map(Method::count_name).collect()
    }

    fn run(&self, context: &Context<'_>) -> anyhow::Result<Chapter> {
        let lines: Vec<Line> = cut_lines().take(context.plan.inputs(LINES)).collect();
        let works = METHODS.iter().map(|method| Work::on_each(&lines, method.clip));
        let times = interleaved(works.collect(), context.plan);
        let entries = METHODS.iter().zip(times);
        let entries = entries.map(|(method, time)| method.entry(&lines, time, context));
        Ok(Chapter {
            name: self.name(),
            title: "Clipped lines: how exact an end has to be",
            about: vec![
                format!(
                    "{} random lines between whole pixels, ends up to 7,000 pixels off a screen of 320 x 240, visible and \
                     with at least one end off it. The end is where Liang and Barsky's algorithm, in the library's code, \
                     meets the rectangle of pixel centres, rounded; the line between such ends is drawn exactly. A grown \
                     window is half a pixel larger on the minor axis. With the error term kept nothing is rounded (Kuzmin \
                     1995).",
                    lines.len()
                ),
                "A pixel has moved if it is drawn and not of the unclipped line, or the other way round; in percent of the \
                 line's pixels. The error of an end is along the side that it is cut at, against the rational crossing. The \
                 cost is that of finding the ends, without drawing; the emulated chip clips the first 200 of the lines."
                    .to_owned(),
            ],
            operation: "one clipped line",
            memory: None,
            figures: vec![
                "moved pixels in %",
                "lines with moved pixels in %",
                "rms error of an end in 1/256 px",
                "largest error of an end in 1/256 px",
            ],
            diagrams: Vec::new(),
            summaries: Vec::new(),
            entries: entries.collect::<anyhow::Result<_>>()?,
        })
    }
}

impl Method {
    fn count_name(&self) -> String {
        format!("clip.precision.{}", self.variant)
    }

    fn entry(&self, lines: &[Line], time: Spread, context: &Context<'_>) -> anyhow::Result<Entry> {
        let (mut all, mut moved, mut wrong_lines) = (0, 0, 0);
        let mut ends = Errors::default();
        let mut worst = (Vec::new(), Vec::new());
        let mut most = None;
        for line in lines {
            let right = ExactLine::between(line.0, line.1).pixels(&SCREEN);
            let (drawn, cuts) = (self.draw)(*line)?;
            let moved_here = differing(&drawn, &right);
            all += right.len();
            moved += moved_here;
            wrong_lines += usize::from(moved_here > 0);
            cuts.into_iter().for_each(|cut| ends.add(cut * UNITS));
            if most < Some(moved_here) {
                most = Some(moved_here);
                worst = (drawn, right);
            }
        }
        let caption = format!(
            "{} pixels of the worst line moved: red drawn, blue right, grey both",
            most.unwrap_or_default()
        );
        let percent = |part: usize, whole: usize| 100.0 * part as f64 / whole.max(1) as f64;
        Ok(Entry {
            group: "lines of 7,000 px".to_owned(),
            method: self.name.to_owned(),
            figures: vec![
                percent(moved, all),
                percent(wrong_lines, lines.len()),
                ends.rms(),
                ends.max(),
            ],
            memory_bytes: 0,
            time: Some(time),
            chip: context.counted.get(&self.count_name()),
            picture: Some(Picture::of_difference(&worst.0, &worst.1, caption)),
        })
    }
}

fn ends<const BITS: u32>((from, to): Line) -> (SubPoint<Fraction<BITS>>, SubPoint<Fraction<BITS>>) {
    let point = |point: Point| SubPoint {
        x: point.x << BITS,
        y: point.y << BITS,
    };
    (point(from), point(to))
}

fn clip<const BITS: u32, const GROWN: bool>(line: &Line) {
    let (from, to) = ends::<BITS>(*line);
    if let Ok(window) = clip_window::<BITS>(&SCREEN, grown::<GROWN>(line)) {
        black_box(Segments::liang_barsky(from, to, &window));
    }
}

/// Whether the window is larger beside the screen, and above it: on the minor axis, where it grows at all.
fn grown<const GROWN: bool>((from, to): &Line) -> (bool, bool) {
    let delta = *to - *from;
    let is_x_major = delta.x.abs() >= delta.y.abs();
    (GROWN && !is_x_major, GROWN && is_x_major)
}

fn draw<const BITS: u32, const GROWN: bool>(line: Line) -> anyhow::Result<Drawn> {
    let (from, to) = ends::<BITS>(line);
    let exact = ExactLine::between(line.0, line.1);
    let window = clip_window::<BITS>(&SCREEN, grown::<GROWN>(&line))?;
    let Some((first, last)) = Segments::liang_barsky(from, to, &window) else {
        return Ok((Vec::new(), Vec::new()));
    };
    let (top_left, bottom_right) = (window.top_left(), window.bottom_right());
    let sides = [top_left.x, bottom_right.x, top_left.y, bottom_right.y];
    let cuts = [(from, first), (to, last)]
        .into_iter()
        .filter(|(whole, cut)| whole != cut);
    let cuts = cuts.map(|(_, cut)| exact.cut_error((cut.x, cut.y), sides, BITS));
    let pixels = ExactLine::in_units((first.x, first.y), (last.x, last.y), BITS).pixels(&SCREEN);
    Ok((pixels, cuts.collect()))
}

/// The pixels of a line whose ends were cut at the border of the upright screen and rounded to whole pixels, as textbooks have it;
/// `None` where its numbers do not fit.
pub fn cut_at_whole_pixels(&(from, to): &Line) -> Option<Vec<(i32, i32)>> {
    let window = clip_window::<0>(&UPRIGHT_SCREEN, (false, false)).ok()?;
    let (from, to) = ends::<0>((from, to));
    let Some((first, last)) = Segments::liang_barsky(from, to, &window) else {
        return Some(Vec::new());
    };
    Some(ExactLine::in_units((first.x, first.y), (last.x, last.y), 0).pixels(&UPRIGHT_SCREEN))
}

fn draw_with_error_term((from, to): Line) -> anyhow::Result<Drawn> {
    let line = Lines::bresenham(from, to, &SCREEN);
    Ok((line.map(|point| (point.x, point.y)).collect(), vec![0.0; 2]))
}
