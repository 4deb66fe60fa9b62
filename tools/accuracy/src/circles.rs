//! Circles: which pixels the ways to draw one take, against the round one.

use zrow_methods::{CIRCLE_CENTER, CIRCLE_SIZE, CircleMethod, DISCS, OUTLINES, TIMED_RADIUS};

use super::{
    axis::{Axis, Chapter, Context, Entry},
    counted::Chip,
    errors::Errors,
    picture::Picture,
    timing::{Spread, Work, interleaved},
};

/// Radii from the centre of a pixel to the centres of others; the costs are those of one.
const RADII: std::ops::RangeInclusive<u32> = 3..=50;

/// Thin circles and discs.
pub struct Circles;

/// Methods that draw the same.
struct Group {
    name: &'static str,
    count: &'static str,
    methods: &'static [CircleMethod],
    errors: fn(u32, &[u8]) -> Errors,
}

const OUTLINE: Group = Group {
    name: "outline of 1 px",
    count: "circles.outline",
    methods: OUTLINES,
    errors: outline_errors,
};

const DISC: Group = Group {
    name: "disc",
    count: "circles.disc",
    methods: DISCS,
    errors: disc_errors,
};

impl Axis for Circles {
    fn name(&self) -> &'static str {
        "circles"
    }

    fn counts(&self) -> Vec<String> {
        let names = |group: Group| group.methods.iter().map(move |method| group.count_name(method));
        [OUTLINE, DISC].into_iter().flat_map(names).collect()
    }

    fn run(&self, context: &Context<'_>) -> anyhow::Result<Chapter> {
        let entries = [OUTLINE, DISC].iter().flat_map(|group| group.entries(context));
        let entries = entries.collect();
        Ok(Chapter {
            name: self.name(),
            title: "Circles: the methods",
            about: vec![
                format!(
                    "Circles about the centre of a pixel with all radii of {} to {} pixels. The displacement of an outline's \
                     pixel is its distance from the round line; even the nearest pixels have one. That of a disc is the \
                     distance of each pixel that is wrongly in or out from the round line of radius r + 1/2, over as many \
                     pixels as that line is long.",
                    RADII.start(),
                    RADII.end()
                ),
                format!(
                    "Cost: the circle of radius {TIMED_RADIUS} into a square of {CIRCLE_SIZE} x {CIRCLE_SIZE} bytes, from centre \
                     and radius, corners or control points on; the same on the emulated chip."
                ),
            ],
            operation: "one circle",
            memory: None,
            figures: vec![
                "rms displacement in 1/256 px",
                "largest displacement in 1/256 px",
                "pixels",
            ],
            diagrams: Vec::new(),
            summaries: Vec::new(),
            entries,
        })
    }
}

impl Group {
    fn count_name(&self, method: &CircleMethod) -> String {
        format!("{}.{}", self.count, method.variant)
    }

    fn entries(&self, context: &Context<'_>) -> Vec<Entry> {
        let works = self.methods.iter().map(|method| {
            let circle = method.input(TIMED_RADIUS);
            let mut greys = vec![0; CIRCLE_SIZE * CIRCLE_SIZE];
            Work {
                operations: 1,
                run: Box::new(move || method.draw(&circle, &mut greys)),
            }
        });
        let times = interleaved(works.collect(), context.plan);
        let entries = self.methods.iter().zip(times).map(|(method, time)| {
            let chip = context.counted.get(&self.count_name(method));
            self.entry(method, time, chip)
        });
        entries.collect()
    }

    fn entry(&self, method: &CircleMethod, time: Spread, chip: Chip) -> Entry {
        let mut errors = Errors::default();
        for radius in RADII {
            errors.add_all(&(self.errors)(radius, &greys(method, radius)));
        }
        Entry {
            group: self.name.to_owned(),
            method: method.name.to_owned(),
            figures: vec![errors.rms(), errors.max(), errors.count() as f64],
            memory_bytes: 0,
            time: Some(time),
            chip,
            picture: Some(self.picture(method)),
        }
    }

    /// A small one, because pixels have to be seen; what is right is the disc, or Bresenham's circle.
    fn picture(&self, method: &CircleMethod) -> Picture {
        let radius = 12;
        let position = |(x, y): (i32, i32)| (x + 16, y + 16);
        let drawn: Vec<_> = offsets(&greys(method, radius))
            .filter(|(_, is_drawn)| *is_drawn)
            .map(|(offset, _)| position(offset))
            .collect();
        let right: Vec<_> = if self.name == DISC.name {
            let all = offsets(&[0; CIRCLE_SIZE * CIRCLE_SIZE])
                .map(|(offset, _)| offset)
                .collect::<Vec<_>>();
            let inside = all
                .into_iter()
                .filter(|offset| distance(*offset) < f64::from(radius) + 0.5);
            inside.map(position).collect()
        } else {
            let greys = greys(&OUTLINES[0], radius);
            offsets(&greys)
                .filter(|(_, is_drawn)| *is_drawn)
                .map(|(offset, _)| position(offset))
                .collect()
        };
        let caption = format!(
            "radius {radius}: red drawn, blue {}, grey both",
            if self.name == DISC.name { "right" } else { "Bresenham's" }
        );
        Picture::of_pixels(&drawn, &right, (33, 33), caption)
    }
}

fn greys(method: &CircleMethod, radius: u32) -> Vec<u8> {
    let mut greys = vec![0; CIRCLE_SIZE * CIRCLE_SIZE];
    method.draw(&method.input(radius), &mut greys);
    greys
}

/// Every pixel as seen from the centre, and whether it is drawn.
fn offsets(greys: &[u8]) -> impl Iterator<Item = ((i32, i32), bool)> {
    greys.iter().enumerate().map(|(index, grey)| {
        let (x, y) = ((index % CIRCLE_SIZE) as i32, (index / CIRCLE_SIZE) as i32);
        ((x - CIRCLE_CENTER, y - CIRCLE_CENTER), *grey != 0)
    })
}

fn distance((x, y): (i32, i32)) -> f64 {
    f64::from(x).hypot(f64::from(y))
}

fn outline_errors(radius: u32, greys: &[u8]) -> Errors {
    let mut errors = Errors::default();
    for (offset, _) in offsets(greys).filter(|(_, is_drawn)| *is_drawn) {
        errors.add((distance(offset) - f64::from(radius)) * 256.0);
    }
    errors
}

fn disc_errors(radius: u32, greys: &[u8]) -> Errors {
    let boundary = f64::from(radius) + 0.5;
    let mut errors = Errors::default();
    let mut wrong = 0;
    for (offset, is_drawn) in offsets(greys) {
        if is_drawn != (distance(offset) < boundary) {
            errors.add((distance(offset) - boundary) * 256.0);
            wrong += 1;
        }
    }
    let length = (std::f64::consts::TAU * boundary) as u64;
    for _ in wrong..length {
        errors.add(0.0);
    }
    errors
}
