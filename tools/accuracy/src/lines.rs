//! Line siblings: which pixels they draw, against the exact line.

use zrow_methods::{LINE_GROUPS, LINE_SIBLINGS, Line, LineGroup, LineSibling, UPRIGHT_SCREEN};

use super::{
    axis::{Axis, Chapter, Context, Entry},
    counted::Chip,
    errors::Errors,
    exact_line::{ExactLine, differing},
    picture::Picture,
    timing::{Spread, Work, interleaved},
};

/// Lines of a whole run.
const LINES: usize = 500;

/// Lines of one pixel.
pub struct Lines;

impl Axis for Lines {
    fn name(&self) -> &'static str {
        "lines"
    }

    fn counts(&self) -> Vec<String> {
        let names = |group| LINE_SIBLINGS.iter().map(move |sibling| count_name(group, sibling));
        LINE_GROUPS.iter().flat_map(names).collect()
    }

    fn run(&self, context: &Context<'_>) -> anyhow::Result<Chapter> {
        let entries = LINE_GROUPS.iter().flat_map(|group| {
            (context.progress)(group.name);
            entries(group, context)
        });
        Ok(Chapter {
            name: self.name(),
            title: "Lines of one pixel: the siblings",
            about: vec![
                format!(
                    "{} random visible lines a group between whole pixels on 240 x 320 pixels. A pixel's displacement is its \
                     distance from the line along the minor axis. Even the nearest pixels are up to half a pixel away, so the \
                     charts show by how much a pixel is further away than the nearest one of its step: 0 where every pixel is \
                     the nearest.",
                    context.plan.inputs(LINES)
                ),
                "A pixel differs if it is drawn and not the nearest to the line in its step, or the other way round. The \
                 supercover is not a thin line: it has every cell that the line touches. The cost is that of every pixel \
                 handed over one by one; the emulated chip walks the first 200 lines of each group."
                    .to_owned(),
            ],
            operation: "one line",
            memory: None,
            figures: vec![
                "rms displacement beyond the nearest pixel in 1/256 px",
                "largest beyond the nearest in 1/256 px",
                "rms displacement in 1/256 px",
                "differing pixels in %",
            ],
            diagrams: Vec::new(),
            summaries: Vec::new(),
            entries: entries.collect(),
        })
    }
}

fn count_name(group: &LineGroup, sibling: &LineSibling) -> String {
    format!("{}.{}", group.count, sibling.name)
}

fn entries(group: &LineGroup, context: &Context<'_>) -> Vec<Entry> {
    let lines: Vec<Line> = group.lines().take(context.plan.inputs(LINES)).collect();
    let works = LINE_SIBLINGS.iter().map(|sibling| Work::on_each(&lines, sibling.walk));
    let times = interleaved(works.collect(), context.plan);
    let entries = LINE_SIBLINGS.iter().zip(times);
    entries
        .map(|(sibling, time)| {
            let chip = context.counted.get(&count_name(group, sibling));
            entry(group, sibling, &lines, time, chip)
        })
        .collect()
}

fn entry(group: &LineGroup, sibling: &LineSibling, lines: &[Line], time: Spread, chip: Chip) -> Entry {
    let (mut all, mut wrong) = (0, 0);
    let (mut displacements, mut beyond_nearest) = (Errors::default(), Errors::default());
    for line in lines {
        let exact = ExactLine::between(line.0, line.1);
        let right = exact.pixels(&UPRIGHT_SCREEN);
        let drawn = drawn(sibling, line);
        all += right.len();
        wrong += differing(&drawn, &right);
        for pixel in drawn {
            let displacement = exact.displacement(pixel) * 256.0;
            displacements.add(displacement);
            // The nearest one is where the fraction brings it.
            let nearest = displacement.rem_euclid(256.0);
            beyond_nearest.add(displacement - nearest.min(256.0 - nearest));
        }
    }
    Entry {
        group: group.name.to_owned(),
        method: sibling.name.to_owned(),
        figures: vec![
            beyond_nearest.rms(),
            beyond_nearest.max(),
            displacements.rms(),
            100.0 * wrong as f64 / all.max(1) as f64,
        ],
        memory_bytes: 0,
        time: Some(time),
        chip,
        picture: Some(picture(sibling, lines)),
    }
}

fn drawn(sibling: &LineSibling, line: &Line) -> Vec<(i32, i32)> {
    let mut pixels = Vec::new();
    (sibling.pixels)(line, &mut |point| pixels.push((point.x, point.y)));
    pixels
}

/// The line that shows most of what is wrong.
fn picture(sibling: &LineSibling, lines: &[Line]) -> Picture {
    let both = |line: &Line| {
        let right = ExactLine::between(line.0, line.1).pixels(&UPRIGHT_SCREEN);
        (drawn(sibling, line), right)
    };
    let worst = lines
        .iter()
        .map(both)
        .max_by_key(|(drawn, right)| differing(drawn, right));
    let (drawn, right) = worst.unwrap_or_default();
    let caption = format!(
        "{} pixels of this line of {} differ: red drawn, blue right, grey both",
        differing(&drawn, &right),
        right.len()
    );
    Picture::of_difference(&drawn, &right, caption)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bresenham_draws_the_exact_line() {
        for group in LINE_GROUPS {
            for line in group.lines().take(50) {
                let right = ExactLine::between(line.0, line.1).pixels(&UPRIGHT_SCREEN);
                let drawn = drawn(&LINE_SIBLINGS[0], &line);
                assert_eq!(differing(&drawn, &right), 0, "{line:?}");
            }
        }
    }

    #[test]
    fn only_pixels_that_are_not_the_nearest_are_displaced_beyond_them() {
        let lines: Vec<Line> = LINE_GROUPS[0].lines().take(50).collect();
        let time = Spread::default();
        let beyond = |name: &str| {
            let sibling = LINE_SIBLINGS.iter().find(|sibling| sibling.name == name).unwrap();
            entry(&LINE_GROUPS[0], sibling, &lines, time, Chip::default()).figures[1]
        };
        assert!(beyond("bresenham") < 1e-6);
        // A cell that the line touches in its corner is a pixel beyond.
        assert!((1.0..=256.0).contains(&beyond("supercover")));
    }
}
