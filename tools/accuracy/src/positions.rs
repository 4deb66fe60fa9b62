//! Sub-pixel precision in 3D: what rounding projected corners does to them, and to the area of faces.

use zrow_methods::{
    Rule, SIZE, Shape,
    space::{POSITION_GROUPS, POSITIONS, SPACE_SIZE, SpaceGroup, SpaceInput, SpaceMethod, SpaceRun, SpaceStage},
};

use super::{
    axis::{Axis, Chapter, Context, Entry},
    errors::{Errors, FULL},
    exact_space, reference,
    space::{self, Runs},
};

/// What the corners of the true faces are in: so many are a pixel.
const FINEST: i32 = 1 << 16;

/// Snapped corners.
pub struct Positions;

macro_rules! runs {
    ($([$variant:ident] [$look:ty] $name:literal, $near:literal;)+) => {
        vec![$(Box::new(SpaceStage::<$look>::new())),+]
    };
}

fn runs() -> Runs {
    zrow_methods::positions!(runs)
}

impl Axis for Positions {
    fn name(&self) -> &'static str {
        "positions"
    }

    fn counts(&self) -> Vec<String> {
        let flash = POSITIONS.iter().map(|method| flash(method).to_owned());
        space::counts(POSITION_GROUPS, POSITIONS).chain(flash).collect()
    }

    fn run(&self, context: &Context<'_>) -> anyhow::Result<Chapter> {
        let mut entries = Vec::new();
        for group in POSITION_GROUPS {
            entries.extend(group_entries(group, context)?);
        }
        Ok(Chapter {
            name: self.name(),
            title: "Sub-pixel precision in 3D",
            about: vec![
                format!(
                    "Scenes of ten random triangles of a turned model, whose vertices are near its origin, in a quarter of \
                     {SPACE_SIZE} x {SPACE_SIZE} pixels. The error of a corner is its distance from where f64 projects the \
                     vertex. That of coverage compares the exact area of the snapped face with that of the projected one, \
                     over the edge pixels of the latter, in 1/255, a face by itself."
                ),
                "With 1/16 px and 16-bit depths the reciprocal of the distance has 16 bits, otherwise 32. Cost: a frame, \
                 prepared and drawn. RAM is that of the scene but for its pixels; flash that of the program that draws the \
                 teapot in such a look for a Cortex-M3 at opt-level \"s\", without the model."
                    .to_owned(),
            ],
            operation: "one frame",
            memory: Some("bytes of RAM"),
            figures: vec![
                "rms error of a corner in 1/256 px",
                "largest error of a corner in 1/256 px",
                "rms error of coverage in 1/255",
                "largest error of coverage in 1/255",
            ],
            diagrams: Vec::new(),
            summaries: Vec::new(),
            entries,
        })
    }
}

/// The program of the teapot in such a look.
fn flash(method: &SpaceMethod) -> &'static str {
    match method.variant {
        "sub8" => "effect.fine.flash",
        "sub4_wide" => "effect.deep.flash",
        _ => "effect.nothing.flash",
    }
}

fn group_entries(group: &SpaceGroup, context: &Context<'_>) -> anyhow::Result<Vec<Entry>> {
    let mut runs = runs();
    let inputs: Vec<_> = POSITIONS
        .iter()
        .map(|method| space::inputs(group, method.near, context))
        .collect();
    let times = space::times(&mut runs, &inputs, context, |run, input| run.draw(input, 0).map(|_| ()));
    let methods = POSITIONS.iter().zip(&mut runs).zip(inputs.iter().zip(times));
    let entries = methods.map(|((method, run), (inputs, time))| {
        let corners = corner_errors(run.as_mut(), inputs)?;
        let coverage = coverage_errors(run.as_mut(), inputs)?;
        Ok(Entry {
            group: group.name.to_owned(),
            method: method.name.to_owned(),
            figures: vec![corners.rms(), corners.max(), coverage.rms(), coverage.max()],
            memory_bytes: run.memory_bytes(),
            time: Some(time),
            chip: context.counted.with_flash(&space::count(group, method), flash(method)),
            picture: None,
        })
    });
    entries.collect()
}

/// Distances of all corners from the exact ones, in 1/256 px.
pub fn corner_errors(run: &mut dyn SpaceRun, inputs: &[SpaceInput]) -> anyhow::Result<Errors> {
    let mut errors = Errors::default();
    for_each_face(run, inputs, |exact, snapped| {
        for ([x, y], [snapped_x, snapped_y]) in exact.into_iter().zip(snapped) {
            errors.add((x - snapped_x).hypot(y - snapped_y) * 256.0);
        }
    })?;
    Ok(errors)
}

/// Hands over the corners of each face, exact and as snapped, in pixels.
fn for_each_face(
    run: &mut dyn SpaceRun,
    inputs: &[SpaceInput],
    mut check: impl FnMut([[f64; 2]; 3], [[f64; 2]; 3]),
) -> anyhow::Result<()> {
    for input in inputs {
        let faces = exact_space::faces(input);
        let mut hand_over = |order: usize, corners: [[f64; 3]; 3]| {
            check(
                faces[order].map(exact_space::projected),
                corners.map(|[x, y, _]| [x, y]),
            );
        };
        run.faces(input, &mut hand_over).map_err(space::refused)?;
    }
    Ok(())
}

fn coverage_errors(run: &mut dyn SpaceRun, inputs: &[SpaceInput]) -> anyhow::Result<Errors> {
    let mut errors = Errors::default();
    for_each_face(run, inputs, |exact, snapped| {
        let [exact, snapped] = [exact, snapped].map(|corners| reference::exact(&shape(corners), SIZE));
        for (right, covered) in exact
            .iter()
            .zip(&snapped)
            .filter(|(right, _)| 0.0 < **right && **right < 1.0)
        {
            errors.add((covered - right) * FULL);
        }
    })?;
    Ok(errors)
}

fn shape(corners: [[f64; 2]; 3]) -> Shape {
    let units = |pixels: f64| (pixels * f64::from(FINEST)).round() as i32;
    let contour = corners.into_iter().map(|[x, y]| (units(x), units(y))).collect();
    Shape {
        contours: [contour].into_iter().collect(),
        rule: Rule::NonZero,
        units: FINEST,
    }
}
