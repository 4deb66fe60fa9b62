//! Sub-pixel precision: what rounding the corners costs in accuracy, and finer ones in time.

use embedded_graphics::{
    geometry::{Point, Size},
    pixelcolor::{Gray8, GrayColor},
    primitives::{Primitive, Rectangle},
};
use zrow::{
    band::Band,
    draw::{DrawOn, FillRule, Polygon, PrimitiveStyle},
    geometry::{Sub4, Sub8, SubPoint, Vertex},
};
use zrow_shapes::{Class, Rule, SHAPES, SIZE, Shape};

use super::{
    axis::{Axis, Chapter, Context, Entry},
    errors::{Errors, FULL},
    reference,
    timing::{Work, interleaved},
};

/// What the corners of the true shapes are in: so many are a pixel.
const FINEST: i32 = 1 << 16;

/// Corners in fewer or more bits.
pub struct SubPixels;

/// A precision of corners.
struct Precision {
    name: &'static str,
    units: i32,
    /// Fills a shape with such corners.
    work: for<'a> fn(&'a [Shape]) -> anyhow::Result<Work<'a>>,
    /// On the emulated chip, for triangles.
    count: Option<&'static str>,
}

const PRECISIONS: &[Precision] = &[
    Precision {
        name: "whole pixel",
        units: 1,
        work: |shapes| work(shapes, |x, y| Ok(Point::new(x, y))),
        count: None,
    },
    Precision {
        name: "Sub4",
        units: 16,
        work: |shapes| work(shapes, |x, y| Ok(SubPoint::<Sub4>::from_units(x, y)?)),
        count: Some("fill.triangle.large.sub4.scanline_polygon"),
    },
    Precision {
        name: "Sub8",
        units: 256,
        work: |shapes| work(shapes, |x, y| Ok(SubPoint::<Sub8>::from_units(x, y)?)),
        count: Some("fill.triangle.large.sub8.scanline_polygon"),
    },
];

impl Axis for SubPixels {
    fn name(&self) -> &'static str {
        "sub_pixel"
    }

    fn counts(&self) -> Vec<String> {
        PRECISIONS
            .iter()
            .filter_map(|precision| precision.count.map(str::to_owned))
            .collect()
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
                "Cost: the fill without antialiasing, from corners to a mask of 48 x 48 bytes. On the emulated chip: random \
                 triangles on 240 x 320 pixels."
                    .to_owned(),
            ],
            operation: "one shape",
            memory: None,
            figures: vec!["rms error in 1/255", "largest error in 1/255"],
            entries,
        })
    }
}

fn class_entries(class: Class, context: &Context<'_>) -> anyhow::Result<Vec<Entry>> {
    let numbers = || 0..context.plan.inputs(SHAPES as usize) as u32;
    let shapes = |units| -> Vec<Shape> { numbers().map(|number| class.shape_in(number, units)).collect() };
    let areas =
        |shapes: &[Shape]| -> Vec<Vec<f64>> { shapes.iter().map(|shape| reference::exact(shape, SIZE)).collect() };
    let right = areas(&shapes(FINEST));
    let rounded: Vec<_> = PRECISIONS.iter().map(|precision| shapes(precision.units)).collect();
    let works = PRECISIONS
        .iter()
        .zip(&rounded)
        .map(|(precision, shapes)| (precision.work)(shapes));
    let times = interleaved(works.collect::<anyhow::Result<_>>()?, context.plan);
    let entries = PRECISIONS
        .iter()
        .zip(&rounded)
        .zip(times)
        .map(|((precision, shapes), time)| {
            let errors = errors(&right, &areas(shapes));
            let count = precision.count.filter(|_| class == Class::Triangle);
            Entry {
                group: class.name().to_owned(),
                method: precision.name.to_owned(),
                figures: vec![errors.rms(), errors.max()],
                memory_bytes: 0,
                time: Some(time),
                instructions: count.and_then(|count| context.counted.get(count)),
                picture: None,
            }
        });
    Ok(entries.collect())
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

fn work<V: Vertex + 'static>(shapes: &[Shape], vertex: fn(i32, i32) -> anyhow::Result<V>) -> anyhow::Result<Work<'_>> {
    let contours = |shape: &Shape| {
        let contours = shape.contours.iter();
        let contours = contours.map(|contour| contour.iter().map(|&(x, y)| vertex(x, y)).collect());
        contours.collect::<anyhow::Result<Vec<Vec<V>>>>()
    };
    let shapes = shapes.iter().map(|shape| Ok((contours(shape)?, shape.rule)));
    let shapes: Vec<_> = shapes.collect::<anyhow::Result<_>>()?;
    let mut mask = vec![0; SIZE * SIZE];
    Ok(Work {
        operations: shapes.len(),
        run: Box::new(move || {
            shapes
                .iter()
                .for_each(|(contours, rule)| fill(contours, *rule, &mut mask))
        }),
    })
}

fn fill<V: Vertex>(contours: &[Vec<V>], rule: Rule, mask: &mut [u8]) {
    mask.fill(0);
    let area = Rectangle::new(Point::zero(), Size::new_equal(SIZE as u32));
    let contours: Vec<&[V]> = contours.iter().map(Vec::as_slice).collect();
    let rule = match rule {
        Rule::EvenOdd => FillRule::EvenOdd,
        Rule::NonZero => FillRule::NonZero,
    };
    let polygon = Polygon::new(&contours, rule).prepare::<256, 16>();
    if let (Ok(mut band), Ok(polygon)) = (Band::<Gray8>::new(area, mask), polygon) {
        let Ok(()) = polygon
            .into_styled(PrimitiveStyle::with_fill(Gray8::WHITE))
            .draw_on(&mut band);
    }
}
