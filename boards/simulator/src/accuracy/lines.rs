//! Line siblings: which pixels they draw, against the exact line.

use std::hint::black_box;

use embedded_graphics::geometry::Point;
use zrow::{
    geometry::Window,
    scan::{bresenham, dda, dda_fixed, midpoint, slope_intercept, supercover},
};
use zrow_shapes::Random;

use super::{
    axis::{Axis, Chapter, Context, Entry},
    errors::Errors,
    exact_line::{ExactLine, differing},
    picture::Picture,
    timing::{Spread, Work, interleaved},
};

/// Lines of a whole run.
const LINES: usize = 500;
/// That of `measure`.
const SCREEN: Window = Window {
    left: 0,
    top: 0,
    right: 240,
    bottom: 320,
};

/// Lines of one pixel.
pub struct Lines;

type Line = (Point, Point);

struct Sibling {
    name: &'static str,
    pixels: fn(&Line) -> Vec<(i32, i32)>,
    walk: fn(&Line),
}

macro_rules! siblings {
    ($($name:ident),+) => {
        [$(Sibling {
            name: stringify!($name),
            pixels: |(from, to)| {
                let pixels = $name::line(*from, *to, &SCREEN).into_iter().flatten();
                pixels.map(|point| (point.x, point.y)).collect()
            },
            walk: |(from, to)| {
                for point in $name::line(*from, *to, &SCREEN).into_iter().flatten() {
                    black_box(point);
                }
            },
        }),+]
    };
}

const SIBLINGS: &[Sibling] = &siblings![bresenham, midpoint, dda_fixed, dda, slope_intercept, supercover];

/// How far off the screen ends are.
struct Group {
    name: &'static str,
    margin: i32,
    count: Option<&'static str>,
}

const GROUPS: &[Group] = &[
    Group {
        name: "on screen",
        margin: 0,
        count: Some("walk.on_screen"),
    },
    Group {
        name: "ends up to 3,000 px off",
        margin: 3000,
        count: Some("walk.off_screen"),
    },
    Group {
        name: "ends up to 1,000,000 px off",
        margin: 1_000_000,
        count: None,
    },
];

impl Axis for Lines {
    fn name(&self) -> &'static str {
        "lines"
    }

    fn counts(&self) -> Vec<String> {
        let names = |group: &'static Group| SIBLINGS.iter().filter_map(|sibling| group.count_name(sibling));
        GROUPS.iter().flat_map(names).collect()
    }

    fn run(&self, context: &Context<'_>) -> anyhow::Result<Chapter> {
        let entries = GROUPS.iter().flat_map(|group| {
            (context.progress)(group.name);
            group.entries(context)
        });
        Ok(Chapter {
            name: self.name(),
            title: "Lines of one pixel: the siblings",
            about: vec![
                format!(
                    "{} random visible lines a group between whole pixels on 240 x 320 pixels. A pixel differs if it is drawn \
                     and not the nearest to the line in its step, or the other way round. A displacement is along the minor \
                     axis, in 1/256 pixel: even the nearest pixels are up to 128 away, and 74 in the root mean square.",
                    context.plan.inputs(LINES)
                ),
                "The supercover is not a thin line: it has every cell that the line touches. The cost is that of every pixel \
                 handed over one by one; on the emulated chip it draws them, on other random lines of the same group, not \
                 all of them visible."
                    .to_owned(),
            ],
            operation: "one line",
            memory: None,
            figures: vec![
                "differing pixels in %",
                "rms displacement in 1/256 px",
                "largest displacement in 1/256 px",
            ],
            entries: entries.collect(),
        })
    }
}

impl Group {
    fn count_name(&self, sibling: &Sibling) -> Option<String> {
        self.count.map(|count| format!("{count}.{}", sibling.name))
    }

    fn lines(&self, count: usize) -> Vec<Line> {
        let mut random = Random::new(0x6C69_6E65_7300 ^ self.margin as u64);
        let mut point = || {
            let x = random.number(SCREEN.left - self.margin, SCREEN.right + self.margin);
            Point::new(x, random.number(SCREEN.top - self.margin, SCREEN.bottom + self.margin))
        };
        let mut line = || {
            let (from, end) = (point(), point());
            let on_screen = Point::new(end.x.rem_euclid(SCREEN.right), end.y.rem_euclid(SCREEN.bottom));
            // Far ends seldom make visible lines: these pass by a pixel of the screen within 25 others.
            let by_screen = on_screen * 2 - from + Point::new(end.x % 50, end.y % 50);
            (from, if self.margin > 10_000 { by_screen } else { end })
        };
        let lines = std::iter::repeat_with(&mut line);
        let visible = |line: &Line| !ExactLine::between(line.0, line.1).pixels(&SCREEN).is_empty();
        lines.filter(visible).take(count).collect()
    }

    fn entries(&self, context: &Context<'_>) -> Vec<Entry> {
        let lines = self.lines(context.plan.inputs(LINES));
        let works = SIBLINGS.iter().map(|sibling| Work::on_each(&lines, sibling.walk));
        let times = interleaved(works.collect(), context.plan);
        let entries = SIBLINGS.iter().zip(times);
        entries
            .map(|(sibling, time)| self.entry(sibling, &lines, time, context))
            .collect()
    }

    fn entry(&self, sibling: &Sibling, lines: &[Line], time: Spread, context: &Context<'_>) -> Entry {
        let (mut all, mut wrong) = (0, 0);
        let mut displacements = Errors::default();
        for line in lines {
            let exact = ExactLine::between(line.0, line.1);
            let right = exact.pixels(&SCREEN);
            let drawn = (sibling.pixels)(line);
            all += right.len();
            wrong += differing(&drawn, &right);
            for pixel in drawn {
                displacements.add(exact.displacement(pixel) * 256.0);
            }
        }
        Entry {
            group: self.name.to_owned(),
            method: sibling.name.to_owned(),
            figures: vec![
                100.0 * wrong as f64 / all.max(1) as f64,
                displacements.rms(),
                displacements.max(),
            ],
            memory_bytes: 0,
            time: Some(time),
            instructions: self.count_name(sibling).and_then(|name| context.counted.get(&name)),
            picture: Some(picture(sibling, lines)),
        }
    }
}

/// The line that shows most of what is wrong.
fn picture(sibling: &Sibling, lines: &[Line]) -> Picture {
    let both = |line: &Line| {
        let right = ExactLine::between(line.0, line.1).pixels(&SCREEN);
        ((sibling.pixels)(line), right)
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
        for group in GROUPS {
            for line in group.lines(50) {
                let right = ExactLine::between(line.0, line.1).pixels(&SCREEN);
                let drawn = (SIBLINGS[0].pixels)(&line);
                assert_eq!(differing(&drawn, &right), 0, "{line:?}");
            }
        }
    }
}
