//! Antialiasing: every method on every class of shapes, against the exact area.

use zrow_methods::{Class, Input, METHODS, Method, SHAPES, SIZE, Shape};

use super::{
    axis::{Axis, Chapter, Context, Entry},
    counted::Chip,
    errors::Errors,
    picture::Picture,
    reference,
    timing::{Spread, Work, interleaved},
};

/// The group of all classes together.
pub const ALL: &str = "all";

/// How much of a pixel a shape covers.
pub struct Coverage;

/// The shapes of a class and their exact coverage.
struct Inputs {
    class: Class,
    shapes: Vec<Shape>,
    inputs: Vec<Input>,
    exact: Vec<Vec<f64>>,
}

/// What a method did on a class.
struct Run {
    errors: Errors,
    time: Spread,
    chip: Chip,
}

impl Axis for Coverage {
    fn name(&self) -> &'static str {
        "coverage"
    }

    fn counts(&self) -> Vec<String> {
        let names = |class: Class| METHODS.iter().map(move |method| count_name(class, method));
        Class::ALL.into_iter().flat_map(names).collect()
    }

    fn run(&self, context: &Context<'_>) -> anyhow::Result<Chapter> {
        let mut entries = Vec::new();
        let mut runs: Vec<Vec<Run>> = METHODS.iter().map(|_| Vec::new()).collect();
        for class in Class::ALL {
            (context.progress)(class.title());
            let inputs = Inputs::new(class, context.plan.inputs(SHAPES as usize))?;
            for ((method, run), runs) in METHODS.iter().zip(inputs.runs(context)).zip(&mut runs) {
                entries.push(run.entry(class.name(), method, Some(inputs.picture(method))));
                runs.push(run);
            }
        }
        let all = METHODS.iter().zip(&runs).filter_map(|(method, runs)| {
            let all = Run::all(runs)?;
            Some(all.entry(ALL, method, None))
        });
        // First, because it says most.
        let all: Vec<_> = all.collect();
        entries.splice(0..0, all);
        Ok(Chapter {
            name: self.name(),
            title: "Coverage: what antialiasing costs",
            about: about(context),
            operation: "one shape",
            memory: Some("bytes a row"),
            figures: vec![
                "rms error in 1/255",
                "largest error in 1/255",
                "edge pixels",
                "wrong pixels off the edges",
            ],
            diagrams: Vec::new(),
            summaries: Vec::new(),
            entries,
        })
    }
}

fn about(context: &Context<'_>) -> Vec<String> {
    vec![
        format!(
            "{} random shapes of each of {} classes on {SIZE} x {SIZE} pixels, corners in 1/256 pixel, circles as polygons \
             of 128 corners, fixed seeds. Time: from the corners to a mask of 8 bits, edges set up anew each time. Memory: \
             of a row of {SIZE} pixels, beside the row itself.",
            context.plan.inputs(SHAPES as usize),
            Class::ALL.len(),
        ),
        "Errors are against the exact area of the polygon in the pixel, in 1/255 of a pixel, over the pixels that are \
         covered in part. The exact area comes from slabs between all corners and crossings, in integers of 2^-32 pixel: \
         its own error is below 2^-22 pixel. \"all\" takes all edge pixels together, and the mean of the costs."
            .to_owned(),
    ]
}

fn count_name(class: Class, method: &Method) -> String {
    format!("{}.{}", class.count_name(), method.name)
}

impl Inputs {
    fn new(class: Class, count: usize) -> anyhow::Result<Self> {
        let shapes: Vec<_> = (0..count as u32).map(|number| class.shape(number)).collect();
        Ok(Self {
            class,
            inputs: shapes.iter().map(Input::new).collect::<Result<_, _>>()?,
            exact: shapes.iter().map(|shape| reference::exact(shape, SIZE)).collect(),
            shapes,
        })
    }

    fn runs(&self, context: &Context<'_>) -> Vec<Run> {
        let works = METHODS.iter().map(|method| {
            let mut mask = vec![0; SIZE * SIZE];
            Work::on_each(&self.inputs, move |shape| {
                mask.fill(0);
                (method.cover)(shape, &mut mask);
            })
        });
        let times = interleaved(works.collect(), context.plan);
        let runs = METHODS.iter().zip(times).map(|(method, time)| Run {
            errors: self.errors(method),
            time,
            chip: context.counted.get(&count_name(self.class, method)),
        });
        runs.collect()
    }

    fn errors(&self, method: &Method) -> Errors {
        let mut errors = Errors::default();
        for (shape, exact) in self.inputs.iter().zip(&self.exact) {
            errors.add_mask(exact, &mask(method, shape));
        }
        errors
    }

    /// The first shape.
    fn picture(&self, method: &Method) -> Picture {
        Picture::of_coverage(&self.shapes[0], &self.exact[0], &mask(method, &self.inputs[0]))
    }
}

fn mask(method: &Method, shape: &Input) -> Vec<u8> {
    let mut mask = vec![0; SIZE * SIZE];
    (method.cover)(shape, &mut mask);
    mask
}

impl Run {
    /// Of all classes together; nothing of none.
    fn all(runs: &[Self]) -> Option<Self> {
        let mut errors = Errors::default();
        runs.iter().for_each(|run| errors.add_all(&run.errors));
        let times: Vec<_> = runs.iter().map(|run| run.time).collect();
        let chips: Vec<_> = runs.iter().map(|run| run.chip).collect();
        Some(Self {
            errors,
            time: Spread::mean(&times)?,
            chip: Chip::mean(&chips),
        })
    }

    fn entry(&self, group: &str, method: &Method, picture: Option<Picture>) -> Entry {
        let errors = &self.errors;
        Entry {
            group: group.to_owned(),
            method: method.name.to_owned(),
            figures: vec![
                errors.rms(),
                errors.max(),
                errors.count() as f64,
                errors.strays() as f64,
            ],
            memory_bytes: (method.bytes_per_row)(SIZE),
            time: Some(self.time),
            chip: self.chip,
            picture,
        }
    }
}
