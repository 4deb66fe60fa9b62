//! Flattening of curves: how far the lines are from the curve, by tolerance.

use std::hint::black_box;

use fixed::types::U8F8;
use zrow::{
    geometry::{OutOfDomain, Sub8, SubPoint},
    scan::{Cubic, adaptive_forward_difference, de_casteljau, uniform_subdivision},
};
use zrow_shapes::Random;

use super::{
    axis::{Axis, Chapter, Context, Entry},
    errors::Errors,
    picture::Picture,
    timing::{Spread, Work, interleaved},
};

/// Curves of a whole run.
const CURVES: usize = 50;
/// Points of a curve at which the distance is measured.
const SAMPLES: usize = 256;
const SCREEN: (i32, i32) = (240, 320);

/// Tolerances in 1/256 pixel, and what `measure` counts with them.
const TOLERANCES: &[(u16, &str, Option<&str>)] = &[
    (2, "1/128", Some("curve.cubic.fine")),
    (8, "1/32", None),
    (16, "1/16", None),
    (32, "1/8", Some("curve.cubic")),
    (64, "1/4", None),
    (128, "1/2", None),
    (256, "1", None),
    (512, "2", None),
];

/// Lines instead of curves.
pub struct Curves;

type Points = [(f64, f64); 4];

/// A curve as the library takes it, and its control points in 1/256 pixel.
struct Input {
    curve: Cubic,
    controls: Points,
}

struct Sibling {
    name: &'static str,
    lines: fn(&Cubic, U8F8) -> Vec<SubPoint<Sub8>>,
    walk: fn(&Cubic, U8F8),
}

macro_rules! siblings {
    ($($name:ident),+) => {
        [$(Sibling {
            name: stringify!($name),
            lines: |curve, tolerance| $name::flatten(curve, tolerance).collect(),
            walk: |curve, tolerance| {
                for end in $name::flatten(curve, tolerance) {
                    black_box(end);
                }
            },
        }),+]
    };
}

const SIBLINGS: &[Sibling] = &siblings![adaptive_forward_difference, de_casteljau, uniform_subdivision];

impl Axis for Curves {
    fn name(&self) -> &'static str {
        "curves"
    }

    fn counts(&self) -> Vec<String> {
        let counts = TOLERANCES.iter().filter_map(|(_, _, count)| *count);
        let names = counts.flat_map(|count| SIBLINGS.iter().map(move |sibling| format!("{count}.{}", sibling.name)));
        names.collect()
    }

    fn run(&self, context: &Context<'_>) -> anyhow::Result<Chapter> {
        let inputs = inputs(context.plan.inputs(CURVES))?;
        let methods: Vec<_> = TOLERANCES
            .iter()
            .flat_map(|tolerance| SIBLINGS.iter().map(move |sibling| (tolerance, sibling)))
            .collect();
        let works = methods.iter().map(|((units, _, _), sibling)| {
            let (tolerance, walk) = (U8F8::from_bits(*units), sibling.walk);
            Work::on_each(&inputs, move |input: &Input| walk(&input.curve, tolerance))
        });
        let times = interleaved(works.collect(), context.plan);
        let entries = methods.iter().zip(times);
        let entries = entries.map(|(((units, tolerance, count), sibling), time)| {
            let count = count.map(|count| format!("{count}.{}", sibling.name));
            let instructions = count.and_then(|count| context.counted.get(&count));
            let name = format!("{} {tolerance}", sibling.name);
            entry(name, sibling, U8F8::from_bits(*units), &inputs, time, instructions)
        });
        Ok(Chapter {
            name: self.name(),
            title: "Curves: the tolerance of flattening",
            about: vec![
                format!(
                    "{} cubic Bezier curves with random control points on 240 x 320 pixels, flattened to lines between points \
                     in 1/256 pixel; the number beside a method is the tolerance in pixels. Distances are from {SAMPLES} \
                     points of each curve to the lines, in f64.",
                    inputs.len()
                ),
                "On the emulated chip other random curves of the same kind are flattened, at two of the tolerances."
                    .to_owned(),
            ],
            operation: "one curve",
            memory: None,
            figures: vec![
                "largest distance in 1/256 px",
                "rms distance in 1/256 px",
                "lines a curve",
            ],
            entries: entries.collect(),
        })
    }
}

fn inputs(count: usize) -> Result<Vec<Input>, OutOfDomain> {
    let mut random = Random::new(0x6375_7276_6573);
    let mut input = || {
        let controls: [(i32, i32); 4] =
            std::array::from_fn(|_| (random.number(0, SCREEN.0 * 256), random.number(0, SCREEN.1 * 256)));
        let mut points = [SubPoint::<Sub8>::default(); 4];
        for (point, (x, y)) in points.iter_mut().zip(controls) {
            *point = SubPoint::from_units(x, y)?;
        }
        Ok(Input {
            curve: Cubic::new(points)?,
            controls: controls.map(|(x, y)| (f64::from(x), f64::from(y))),
        })
    };
    (0..count).map(|_| input()).collect()
}

fn entry(
    method: String,
    sibling: &Sibling,
    tolerance: U8F8,
    inputs: &[Input],
    time: Spread,
    instructions: Option<f64>,
) -> Entry {
    let mut distances = Errors::default();
    let mut lines = 0;
    for input in inputs {
        let polyline = polyline(sibling, tolerance, input);
        lines += polyline.len() - 1;
        for sample in 0..=SAMPLES {
            let point = point_at(&input.controls, sample as f64 / SAMPLES as f64);
            let sides = polyline.windows(2).map(|pair| distance(point, pair[0], pair[1]));
            distances.add(sides.fold(f64::INFINITY, f64::min));
        }
    }
    Entry {
        group: "cubic on screen".to_owned(),
        method,
        figures: vec![distances.max(), distances.rms(), lines as f64 / inputs.len() as f64],
        memory_bytes: 0,
        time: Some(time),
        instructions,
        picture: inputs.first().map(|input| picture(sibling, tolerance, input)),
    }
}

/// The ends of the lines, the start included, in 1/256 pixel.
fn polyline(sibling: &Sibling, tolerance: U8F8, input: &Input) -> Vec<(f64, f64)> {
    let ends = (sibling.lines)(&input.curve, tolerance);
    let ends = ends
        .iter()
        .map(|end| (f64::from(end.x_units()), f64::from(end.y_units())));
    [input.controls[0]].into_iter().chain(ends).collect()
}

fn point_at(controls: &Points, at: f64) -> (f64, f64) {
    let rest = 1.0 - at;
    let weights = [
        rest * rest * rest,
        3.0 * rest * rest * at,
        3.0 * rest * at * at,
        at * at * at,
    ];
    let sum = |axis: fn(&(f64, f64)) -> f64| controls.iter().map(axis).zip(weights).map(|(c, w)| c * w).sum();
    (sum(|point| point.0), sum(|point| point.1))
}

/// From a point to the segment between two others.
fn distance(point: (f64, f64), from: (f64, f64), to: (f64, f64)) -> f64 {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let squared = dx * dx + dy * dy;
    let along = if squared > 0.0 {
        (((point.0 - from.0) * dx + (point.1 - from.1) * dy) / squared).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (point.0 - from.0 - along * dx).hypot(point.1 - from.1 - along * dy)
}

/// The curve in blue, the lines in red.
fn picture(sibling: &Sibling, tolerance: U8F8, input: &Input) -> Picture {
    let points = |points: &[(f64, f64)]| -> String {
        let texts = points.iter().map(|(x, y)| format!("{:.1},{:.1}", x / 256.0, y / 256.0));
        texts.collect::<Vec<_>>().join(" ")
    };
    let lines = polyline(sibling, tolerance, input);
    let curve: Vec<_> = (0..=64)
        .map(|sample| point_at(&input.controls, f64::from(sample) / 64.0))
        .collect();
    let dots = lines
        .iter()
        .map(|(x, y)| format!("<circle cx=\"{:.1}\" cy=\"{:.1}\" r=\"2\"/>", x / 256.0, y / 256.0));
    let markup = format!(
        "<g fill=\"none\"><polyline stroke=\"#1e64e6\" points=\"{}\"/><polyline stroke=\"#dc281e\" points=\"{}\"/></g>{}",
        points(&curve),
        points(&lines),
        dots.collect::<String>()
    );
    let caption = format!("the first curve (blue) as {} lines (red)", lines.len() - 1);
    Picture::of_drawing(&format!("0 0 {} {}", SCREEN.0, SCREEN.1), &markup, caption)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_sibling_is_further_than_its_tolerance() {
        for input in inputs(10).unwrap() {
            for (sibling, (units, ..)) in SIBLINGS
                .iter()
                .flat_map(|sibling| TOLERANCES.iter().map(move |t| (sibling, t)))
            {
                let lines = polyline(sibling, U8F8::from_bits(*units), &input);
                for sample in 0..=64 {
                    let point = point_at(&input.controls, f64::from(sample) / 64.0);
                    let sides = lines.windows(2).map(|pair| distance(point, pair[0], pair[1]));
                    let nearest = sides.fold(f64::INFINITY, f64::min);
                    assert!(
                        nearest <= f64::from(*units) + 0.01,
                        "{} {units}: {nearest}",
                        sibling.name
                    );
                }
            }
        }
    }
}
