//! The format of the matrix to eye space: what its bits do to corners far from the origin of their model.

use zrow_methods::space::{MATRIX_FORMATS, MATRIX_GROUPS, SpaceGroup, SpaceStage};

use super::{
    axis::{Axis, Chapter, Context, Entry},
    positions::corner_errors,
    space::{self, Runs},
};

/// Rows of the matrix to eye space.
pub struct MatrixFormat;

macro_rules! runs {
    ($([$variant:ident] [$look:ty] $name:literal, $near:literal;)+) => {
        vec![$(Box::new(SpaceStage::<$look>::new())),+]
    };
}

fn runs() -> Runs {
    zrow_methods::matrix_formats!(runs)
}

impl Axis for MatrixFormat {
    fn name(&self) -> &'static str {
        "matrix_format"
    }

    fn counts(&self) -> Vec<String> {
        space::counts(MATRIX_GROUPS, MATRIX_FORMATS).collect()
    }

    fn run(&self, context: &Context<'_>) -> anyhow::Result<Chapter> {
        let mut entries = Vec::new();
        for group in MATRIX_GROUPS {
            entries.extend(group_entries(group, context)?);
        }
        Ok(Chapter {
            name: self.name(),
            title: "The matrix to eye space: its format",
            about: vec![
                "Scenes of ten random triangles whose vertices are 2,000 or 20,000 units from the origin of a turned \
                 model, and 600 or 150 in front of the camera, focal length 96 pixels. The error of a corner is its \
                 distance from where f64 projects the vertex, rounding to the pixel's fractions included."
                    .to_owned(),
                "An element of a row that is half of 2^-14 off moves a vertex 20,000 units away by 0.6 units. Rows of 2.14 \
                 multiply in 32 bits, those of 2.30 in 64; rows of 8.24 are those of models with an affine map \
                 (`Transformed`), here the identity. Cost: preparing a frame of 30 vertices and ten faces, the projection \
                 included."
                    .to_owned(),
            ],
            operation: "preparing one frame",
            memory: Some("bytes of RAM"),
            figures: vec![
                "largest error of a corner in 1/256 px",
                "rms error of a corner in 1/256 px",
            ],
            diagrams: Vec::new(),
            summaries: Vec::new(),
            entries,
        })
    }
}

fn group_entries(group: &SpaceGroup, context: &Context<'_>) -> anyhow::Result<Vec<Entry>> {
    let mut runs = runs();
    let inputs: Vec<_> = MATRIX_FORMATS
        .iter()
        .map(|method| space::inputs(group, method.near, context))
        .collect();
    let times = space::times(&mut runs, &inputs, context, |run, input| run.prepare(input));
    let methods = MATRIX_FORMATS.iter().zip(&mut runs).zip(inputs.iter().zip(times));
    let entries = methods.map(|((method, run), (inputs, time))| {
        let errors = corner_errors(run.as_mut(), inputs)?;
        Ok(Entry {
            group: group.name.to_owned(),
            method: method.name.to_owned(),
            figures: vec![errors.max(), errors.rms()],
            memory_bytes: run.memory_bytes(),
            time: Some(time),
            chip: context.counted.get(&space::count(group, method)),
            picture: None,
        })
    });
    entries.collect()
}
