//! Depths of 16 and 32 bits, and how near the near plane is: how many pixels show a face that is not the nearest.

use zrow_methods::space::{
    DEPTH_GROUPS, DEPTH_WIDTHS, SPACE_SIZE, SpaceGroup, SpaceInput, SpaceMethod, SpaceRun, SpaceStage, face_of,
};

use super::{
    axis::{Axis, Chapter, Context, Entry},
    exact_space,
    picture::Picture,
    space::{self, Runs},
};

/// Stored depths.
pub struct DepthWidth;

macro_rules! runs {
    ($([$variant:ident] [$look:ty] $name:literal, $near:literal;)+) => {
        vec![$(Box::new(SpaceStage::<$look>::new())),+]
    };
}

fn runs() -> Runs {
    zrow_methods::depth_widths!(runs)
}

impl Axis for DepthWidth {
    fn name(&self) -> &'static str {
        "depth_width"
    }

    fn counts(&self) -> Vec<String> {
        let flash = ["effect.nothing.flash", "effect.deep.flash"].map(str::to_owned);
        space::counts(DEPTH_GROUPS, DEPTH_WIDTHS).chain(flash).collect()
    }

    fn run(&self, context: &Context<'_>) -> anyhow::Result<Chapter> {
        let mut entries = Vec::new();
        for group in DEPTH_GROUPS {
            entries.extend(group_entries(group, context)?);
        }
        Ok(Chapter {
            name: self.name(),
            title: "Depth: its width, and the near plane",
            about: vec![
                format!(
                    "Scenes of ten random triangles at 150 to 6,300 units on {SPACE_SIZE} x {SPACE_SIZE} pixels: some \
                     through each other, others in pairs of which one lies 2 to 16 units behind the other. The nearest \
                     face at the centre of a pixel is found in f64 from the vertices, out of those that also cover it as \
                     they were snapped. A pixel is misordered where another one of them is drawn; in percent of the pixels \
                     that have two of them. How far the face that is drawn lies behind the nearest one is in percent of \
                     the distance of the nearest."
                ),
                "A stored depth is near / z: with 16 bits a unit at a distance z is z * z / (65,535 near) of space. \
                 Corners are at 1/16 pixel, which moves the planes of steep faces as well, but where 1/256 px is said."
                    .to_owned(),
                "Cost: a frame, prepared and drawn into words. RAM is that of the scene but for its pixels. Flash is that \
                 of the program that draws the teapot in such a look for a Cortex-M3 at opt-level \"s\", without the \
                 model."
                    .to_owned(),
            ],
            operation: "one frame",
            memory: Some("bytes of RAM"),
            figures: vec!["misordered pixels in %", "largest distance behind the nearest in %"],
            diagrams: Vec::new(),
            summaries: Vec::new(),
            entries,
        })
    }
}

fn group_entries(group: &SpaceGroup, context: &Context<'_>) -> anyhow::Result<Vec<Entry>> {
    let inputs: Vec<_> = DEPTH_WIDTHS
        .iter()
        .map(|method| space::inputs(group, method.near, context))
        .collect();
    let mut runs = runs();
    let times = space::times(&mut runs, &inputs, context, |run, input| run.draw(input, 0).map(|_| ()));
    let methods = DEPTH_WIDTHS.iter().zip(&mut runs).zip(inputs.iter().zip(times));
    let entries = methods.map(|((method, run), (inputs, time))| {
        let order = Order::of(run.as_mut(), inputs)?;
        Ok(Entry {
            group: group.name.to_owned(),
            method: method.name.to_owned(),
            figures: vec![
                100.0 * order.wrong as f64 / order.all.max(1) as f64,
                100.0 * order.behind,
            ],
            memory_bytes: run.memory_bytes(),
            time: Some(time),
            chip: context.counted.with_flash(&space::count(group, method), flash(method)),
            picture: Some(order.picture()),
        })
    });
    entries.collect()
}

/// The program of the teapot in such a look.
fn flash(method: &SpaceMethod) -> &'static str {
    match method.variant {
        variant if variant.starts_with("u16") => "effect.nothing.flash",
        variant if variant.starts_with("u32") => "effect.deep.flash",
        _ => "",
    }
}

/// Which faces are drawn, and which are the nearest.
#[derive(Default)]
struct Order {
    /// Pixels that several faces cover.
    all: usize,
    /// Those that show another face than the nearest.
    wrong: usize,
    /// The largest distance behind the nearest, as a part of its own distance.
    behind: f64,
    /// Pixels of the first scene that several faces cover.
    first: Vec<(i32, i32)>,
    /// Those of them that show another face than the nearest.
    first_wrong: Vec<(i32, i32)>,
}

impl Order {
    fn of(run: &mut dyn SpaceRun, inputs: &[SpaceInput]) -> anyhow::Result<Self> {
        let mut order = Self::default();
        for (number, input) in inputs.iter().enumerate() {
            let faces = exact_space::faces(input);
            let mut snapped = vec![None; faces.len()];
            run.faces(input, &mut |face, corners| snapped[face] = Some(corners))
                .map_err(space::refused)?;
            let words = run.draw(input, 0).map_err(space::refused)?;
            for (index, word) in words.iter().enumerate() {
                let (column, row) = (index % SPACE_SIZE, index / SPACE_SIZE);
                let distances = faces.iter().zip(&snapped).map(|(face, snapped)| {
                    let covers = space::weights(snapped.as_ref()?, [column as f64, row as f64]).is_some();
                    exact_space::distance(face, column, row).filter(|_| covers)
                });
                let distances: Vec<_> = distances.collect();
                let drawn = face_of(*word).and_then(|face| distances[face]);
                let nearest = distances.iter().flatten().copied().fold(f64::INFINITY, f64::min);
                let Some(drawn) = drawn.filter(|_| distances.iter().flatten().count() > 1) else {
                    continue;
                };
                let pixel = (column as i32, row as i32);
                let is_wrong = drawn > nearest;
                order.all += 1;
                order.wrong += usize::from(is_wrong);
                order.behind = order.behind.max(drawn / nearest - 1.0);
                if number == 0 {
                    order.first.push(pixel);
                    order.first_wrong.extend(is_wrong.then_some(pixel));
                }
            }
        }
        Ok(order)
    }

    /// The misordered pixels of the first scene in red.
    fn picture(&self) -> Picture {
        let (covered, wrong) = (&self.first, &self.first_wrong);
        let right: Vec<_> = covered.iter().filter(|pixel| !wrong.contains(pixel)).copied().collect();
        let size = SPACE_SIZE as u32;
        let caption = format!("first scene: covered twice in grey, {} misordered in red", wrong.len());
        Picture::of_pixels(covered, &right, (size, size), caption)
    }
}
