//! Flattening of curves: how far the lines are from the curve, by tolerance.

use fixed::types::U8F8;
use zrow_methods::{CURVE_SCREEN, CURVE_SIBLINGS, CURVES, CurveInput, CurveSibling, TOLERANCES, Tolerance, curves};

use super::{
    axis::{Axis, Chapter, Context, Entry},
    counted::Chip,
    errors::Errors,
    picture::Picture,
    timing::{Spread, Work, interleaved},
};

/// Points of a curve at which the distance is measured.
const SAMPLES: usize = 256;

/// Lines instead of curves.
pub struct Curves;

/// A sibling with a tolerance.
#[derive(Clone, Copy)]
struct Method {
    sibling: &'static CurveSibling,
    tolerance: &'static Tolerance,
}

fn methods() -> impl Iterator<Item = Method> {
    let methods = |tolerance| CURVE_SIBLINGS.iter().map(move |sibling| Method { sibling, tolerance });
    TOLERANCES.iter().flat_map(methods)
}

impl Axis for Curves {
    fn name(&self) -> &'static str {
        "curves"
    }

    fn counts(&self) -> Vec<String> {
        methods().map(Method::count_name).collect()
    }

    fn run(&self, context: &Context<'_>) -> anyhow::Result<Chapter> {
        let inputs: Vec<CurveInput> = curves().take(context.plan.inputs(CURVES)).collect::<Result<_, _>>()?;
        let works = methods().map(|method| {
            Work::on_each(&inputs, move |input: &CurveInput| {
                (method.sibling.walk)(&input.curve, method.tolerance());
            })
        });
        let times = interleaved(works.collect(), context.plan);
        let entries = methods().zip(times).map(|(method, time)| {
            let chip = context.counted.get(&method.count_name());
            method.entry(&inputs, time, chip)
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
                "The cost is that of every line's end handed over; the emulated chip flattens the same curves."
                    .to_owned(),
            ],
            operation: "one curve",
            memory: None,
            figures: vec![
                "largest distance in 1/256 px",
                "rms distance in 1/256 px",
                "lines a curve",
            ],
            diagrams: Vec::new(),
            summaries: Vec::new(),
            entries: entries.collect(),
        })
    }
}

impl Method {
    fn count_name(self) -> String {
        format!("{}.{}", self.tolerance.count, self.sibling.name)
    }

    fn tolerance(self) -> U8F8 {
        U8F8::from_bits(self.tolerance.units)
    }

    fn entry(self, inputs: &[CurveInput], time: Spread, chip: Chip) -> Entry {
        let mut distances = Errors::default();
        let mut lines = 0;
        for input in inputs {
            let polyline = self.polyline(input);
            lines += polyline.len() - 1;
            for sample in 0..=SAMPLES {
                let point = point_at(&input.controls, sample as f64 / SAMPLES as f64);
                let sides = polyline.windows(2).map(|pair| distance(point, pair[0], pair[1]));
                distances.add(sides.fold(f64::INFINITY, f64::min));
            }
        }
        Entry {
            group: "cubic on screen".to_owned(),
            method: format!("{} {}", self.sibling.name, self.tolerance.name),
            figures: vec![distances.max(), distances.rms(), lines as f64 / inputs.len() as f64],
            memory_bytes: 0,
            time: Some(time),
            chip,
            picture: inputs.first().map(|input| self.picture(input)),
        }
    }

    /// The ends of the lines, the start included, in 1/256 pixel.
    fn polyline(self, input: &CurveInput) -> Vec<(f64, f64)> {
        let mut points = vec![wide(input.controls[0])];
        (self.sibling.ends)(&input.curve, self.tolerance(), &mut |end| {
            points.push(wide((end.x_units(), end.y_units())));
        });
        points
    }

    /// The curve in blue, the lines in red.
    fn picture(self, input: &CurveInput) -> Picture {
        let points = |points: &[(f64, f64)]| -> String {
            let texts = points.iter().map(|(x, y)| format!("{:.1},{:.1}", x / 256.0, y / 256.0));
            texts.collect::<Vec<_>>().join(" ")
        };
        let lines = self.polyline(input);
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
        Picture::of_drawing(&format!("0 0 {} {}", CURVE_SCREEN.0, CURVE_SCREEN.1), &markup, caption)
    }
}

fn wide((x, y): (i32, i32)) -> (f64, f64) {
    (f64::from(x), f64::from(y))
}

fn point_at(controls: &[(i32, i32); 4], at: f64) -> (f64, f64) {
    let rest = 1.0 - at;
    let weights = [
        rest * rest * rest,
        3.0 * rest * rest * at,
        3.0 * rest * at * at,
        at * at * at,
    ];
    let sum = |axis: fn(&(i32, i32)) -> i32| {
        let controls = controls.iter().map(|point| f64::from(axis(point)));
        controls.zip(weights).map(|(control, weight)| control * weight).sum()
    };
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_sibling_is_further_than_its_tolerance() {
        let inputs: Vec<CurveInput> = curves().take(10).map(Result::unwrap).collect();
        for (input, method) in inputs
            .iter()
            .flat_map(|input| methods().map(move |method| (input, method)))
        {
            let lines = method.polyline(input);
            for sample in 0..=64 {
                let point = point_at(&input.controls, f64::from(sample) / 64.0);
                let sides = lines.windows(2).map(|pair| distance(point, pair[0], pair[1]));
                let nearest = sides.fold(f64::INFINITY, f64::min);
                let (name, tolerance) = (method.sibling.name, method.tolerance.units);
                assert!(nearest <= f64::from(tolerance) + 0.01, "{name} {tolerance}: {nearest}");
            }
        }
    }
}
