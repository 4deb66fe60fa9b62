//! Sub-pixel precision: what rounding the corners costs in accuracy, and finer ones in time.

use zrow_methods::{Class, PRECISIONS, Precision, Rounded, SHAPES, SIZE, Shape};

use super::{
    axis::{Axis, Chapter, Context, Entry},
    errors::{Errors, FULL},
    picture::Picture,
    reference,
    timing::{Work, interleaved},
};

/// What the corners of the true shapes are in: so many are a pixel.
const FINEST: i32 = 1 << 16;

/// Corners in fewer or more bits.
pub struct SubPixels;

impl Axis for SubPixels {
    fn name(&self) -> &'static str {
        "sub_pixel"
    }

    fn counts(&self) -> Vec<String> {
        let names = |class| PRECISIONS.iter().map(move |precision| count_name(class, precision));
        Class::ALL.into_iter().flat_map(names).collect()
    }

    fn run(&self, context: &Context<'_>) -> anyhow::Result<Chapter> {
        let mut entries = Vec::new();
        for class in Class::ALL {
            (context.progress)(class.title());
            entries.extend(class_entries(class, context)?);
        }
        Ok(Chapter {
            name: self.name(),
            title: "Sub-pixel precision of corners",
            about: vec![
                format!(
                    "The shape classes of the coverage chapter, with corners in 1/{FINEST} pixel, then rounded to 1/16 \
                     (`Sub4`), 1/256 (`Sub8`) or whole pixels. Errors compare the exact area of the rounded shape with that \
                     of the true one, over the true one's edge pixels, in 1/255: what no antialiasing makes good again."
                ),
                "Cost: the fill without antialiasing, from corners to a mask of 48 x 48 bytes. The pictures show the exact \
                 coverage of the rounded shape."
                    .to_owned(),
            ],
            operation: "one shape",
            memory: None,
            figures: vec!["rms error in 1/255", "largest error in 1/255"],
            diagrams: Vec::new(),
            summaries: Vec::new(),
            entries,
        })
    }
}

fn count_name(class: Class, precision: &Precision) -> String {
    format!("{}.{}", class.corners_count_name(), precision.variant)
}

fn class_entries(class: Class, context: &Context<'_>) -> anyhow::Result<Vec<Entry>> {
    let numbers = || 0..context.plan.inputs(SHAPES as usize) as u32;
    let shapes = |units| -> Vec<Shape> { numbers().map(|number| class.shape_in(number, units)).collect() };
    let areas =
        |shapes: &[Shape]| -> Vec<Vec<f64>> { shapes.iter().map(|shape| reference::exact(shape, SIZE)).collect() };
    let right = areas(&shapes(FINEST));
    let rounded: Vec<Vec<Shape>> = PRECISIONS.iter().map(|precision| shapes(precision.units)).collect();
    let inputs = rounded.iter().map(|shapes| shapes.iter().map(Rounded::new).collect());
    let inputs: Vec<Vec<Rounded>> = inputs.collect::<Result<_, _>>()?;
    let works = inputs.iter().map(|shapes| {
        let mut mask = vec![0; SIZE * SIZE];
        Work::on_each(shapes, move |shape: &Rounded| {
            mask.fill(0);
            shape.fill(&mut mask);
        })
    });
    let times = interleaved(works.collect(), context.plan);
    let entries = PRECISIONS.iter().zip(&rounded).zip(times);
    let entries = entries.map(|((precision, shapes), time)| {
        let areas = areas(shapes);
        let errors = errors(&right, &areas);
        Entry {
            group: class.name().to_owned(),
            method: precision.name.to_owned(),
            figures: vec![errors.rms(), errors.max()],
            memory_bytes: 0,
            time: Some(time),
            chip: context.counted.get(&count_name(class, precision)),
            picture: Some(picture(&shapes[0], &right[0], &areas[0])),
        }
    });
    Ok(entries.collect())
}

/// The first shape.
fn picture(rounded: &Shape, right: &[f64], coverages: &[f64]) -> Picture {
    let mask: Vec<u8> = coverages
        .iter()
        .map(|coverage| (coverage * FULL).round() as u8)
        .collect();
    Picture::of_coverage(rounded, right, &mask)
}

fn errors(right: &[Vec<f64>], rounded: &[Vec<f64>]) -> Errors {
    let mut errors = Errors::default();
    for (right, rounded) in right.iter().flatten().zip(rounded.iter().flatten()) {
        if 0.0 < *right && *right < 1.0 {
            errors.add((rounded - right) * FULL);
        }
    }
    errors
}
