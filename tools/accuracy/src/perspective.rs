//! Perspective of textures: how often coordinates are divided by the depth, and how far the texels are off.

use zrow_methods::space::{
    PERSPECTIVE_GROUPS, PERSPECTIVES, SPACE_SIZE, ScreenCorner, SpaceGroup, SpaceInput, SpaceMethod, SpaceRun,
    SpaceStage,
};

use super::{
    axis::{Axis, Chapter, Context, Entry},
    errors::{Errors, FULL},
    picture::Picture,
    space::{self, Runs},
};

/// Texels along a side of the texture.
const TEXELS: f64 = 64.0;

/// Divided texture coordinates.
pub struct Perspective;

macro_rules! runs {
    ($([$variant:ident] [$look:ty] $name:literal, $near:literal;)+) => {
        vec![$(Box::new(SpaceStage::<$look>::new())),+]
    };
}

fn runs() -> Runs {
    zrow_methods::perspectives!(runs)
}

impl Axis for Perspective {
    fn name(&self) -> &'static str {
        "perspective"
    }

    fn counts(&self) -> Vec<String> {
        let flash = PERSPECTIVES.iter().map(flash).filter(|name| !name.is_empty());
        let counts = space::counts(PERSPECTIVE_GROUPS, PERSPECTIVES);
        counts.chain(flash.map(str::to_owned)).collect()
    }

    fn run(&self, context: &Context<'_>) -> anyhow::Result<Chapter> {
        let mut entries = Vec::new();
        for group in PERSPECTIVE_GROUPS {
            entries.extend(group_entries(group, context)?);
        }
        Ok(Chapter {
            name: self.name(),
            title: "Perspective: texture coordinates between divisions",
            about: vec![
                format!(
                    "Tilted quadrangles over most of {SPACE_SIZE} x {SPACE_SIZE} pixels, with the whole of a texture of \
                     {TEXELS} x {TEXELS} texels; one side is 1.01, 2 or 8 times as far away as the other. The error is that \
                     of both coordinates together, in texels, from the exact quotient at the centre of each pixel: in f64, \
                     from the snapped corners and their stored depths, so that neither counts here."
                ),
                "Every 16, 8 or 1 px: divided at both ends of a span and at each column that is a multiple of that, evenly in \
                 between. The library's textures do that only where a face's coordinates, taken evenly over the screen, \
                 would be 3/8 texel off somewhere. Every fragment: a shading of the report's own divides both coordinates of \
                 each fragment that is seen, from planes of 16 bits, to 1/64 texel; it takes models that are moved along z \
                 alone."
                    .to_owned(),
                "Cost: a frame, prepared and drawn: the coordinates are the words. RAM is that of the scene but for its \
                 pixels; flash that of the program that draws the textured teapot for a Cortex-M3 at opt-level \"s\", \
                 without the model and texture."
                    .to_owned(),
            ],
            operation: "one frame",
            memory: Some("bytes of RAM"),
            figures: vec!["largest error in texels", "rms error in texels"],
            diagrams: Vec::new(),
            summaries: Vec::new(),
            entries,
        })
    }
}

/// The program of the textured teapot, which divides where it is 3/8 texel off.
fn flash(method: &SpaceMethod) -> &'static str {
    if method.variant == "by_texel_error" {
        "effect.texture.flash"
    } else {
        ""
    }
}

fn group_entries(group: &SpaceGroup, context: &Context<'_>) -> anyhow::Result<Vec<Entry>> {
    let mut runs = runs();
    let inputs: Vec<_> = PERSPECTIVES
        .iter()
        .map(|method| space::inputs(group, method.near, context))
        .collect();
    let times = space::times(&mut runs, &inputs, context, |run, input| run.draw(input, 0).map(|_| ()));
    let methods = PERSPECTIVES.iter().zip(&mut runs).zip(inputs.iter().zip(times));
    let entries = methods.map(|((method, run), (inputs, time))| {
        let (errors, picture) = texel_errors(run.as_mut(), inputs)?;
        Ok(Entry {
            group: group.name.to_owned(),
            method: method.name.to_owned(),
            figures: vec![errors.max(), errors.rms()],
            memory_bytes: run.memory_bytes(),
            time: Some(time),
            chip: context.counted.with_flash(&space::count(group, method), flash(method)),
            picture: Some(picture),
        })
    });
    entries.collect()
}

/// The errors of all pixels, and a picture of those of the first scene.
fn texel_errors(run: &mut dyn SpaceRun, inputs: &[SpaceInput]) -> anyhow::Result<(Errors, Picture)> {
    let mut errors = Errors::default();
    let mut first = Vec::new();
    for (number, input) in inputs.iter().enumerate() {
        let mut faces = Vec::new();
        run.faces(input, &mut |order, corners| faces.push((order, corners)))
            .map_err(space::refused)?;
        let mut drawn = Vec::new();
        for shown in 0..2 {
            drawn.push(run.draw(input, shown).map_err(space::refused)?.to_vec());
        }
        for (index, (u, v)) in drawn[0].iter().zip(&drawn[1]).enumerate() {
            let (column, row) = ((index % SPACE_SIZE) as f64, (index / SPACE_SIZE) as f64);
            let exact = faces.iter().find_map(|(order, corners)| {
                let numbers = input.faces[*order].map(|vertex| input.coordinates[usize::from(vertex)]);
                in_space(corners, numbers, [column, row])
            });
            let error = exact.map(|[exact_u, exact_v]| {
                let coordinate = |word: u32| f64::from(word as i32) / 65_536.0;
                (coordinate(*u) - exact_u).hypot(coordinate(*v) - exact_v) * TEXELS / 4_096.0
            });
            if let Some(error) = error {
                errors.add(error);
            }
            if number == 0 {
                first.push(error.unwrap_or_default());
            }
        }
    }
    Ok((errors, picture(&first)))
}

/// Both coordinates at a point inside a face: sums of those of the corners, weighed by barycentric coordinates and depths.
fn in_space(corners: &[ScreenCorner; 3], numbers: [[i16; 2]; 3], point: [f64; 2]) -> Option<[f64; 2]> {
    let sides = space::weights(corners, point)?;
    let weights: Vec<f64> = sides
        .iter()
        .zip(corners)
        .map(|(side, [.., depth])| side * depth)
        .collect();
    let sum = |shown: usize| {
        let numbers = numbers.map(|numbers| f64::from(numbers[shown]));
        let sum: f64 = weights
            .iter()
            .zip(numbers)
            .map(|(weight, number)| weight * number)
            .sum();
        sum / weights.iter().sum::<f64>()
    };
    Some([sum(0), sum(1)])
}

/// Errors from white to the first scene's largest in red.
fn picture(errors: &[f64]) -> Picture {
    let largest = errors.iter().copied().fold(0.0, f64::max);
    let scaled = errors.iter().map(|error| error / largest.max(1e-9) * FULL);
    Picture::of_errors(
        &scaled.collect::<Vec<_>>(),
        SPACE_SIZE,
        format!("errors of the first scene, at most {largest:.2} texels"),
    )
}
