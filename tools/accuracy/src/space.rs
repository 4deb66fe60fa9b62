//! What the chapters about small scenes in 3D share: their inputs, their times, the names of their counts.

use anyhow::anyhow;
use zrow::geometry::InputError;
use zrow_methods::space::{SPACE_SCENES, ScreenCorner, SpaceGroup, SpaceInput, SpaceMethod, SpaceRun};

use super::{
    axis::Context,
    timing::{Spread, Work, interleaved},
};

/// A way to draw for each method of a list.
pub type Runs = Vec<Box<dyn SpaceRun>>;

/// What the chips report the count of a method on a group as.
pub fn count(group: &SpaceGroup, method: &SpaceMethod) -> String {
    format!("{}.{}", group.count, method.variant)
}

/// The counts of all methods on all groups.
pub fn counts<'a>(groups: &'a [SpaceGroup], methods: &'a [SpaceMethod]) -> impl Iterator<Item = String> + 'a {
    let of_group = move |group| methods.iter().map(move |method| count(group, method));
    groups.iter().flat_map(of_group)
}

/// The scenes of a group.
pub fn inputs(group: &SpaceGroup, near: i32, context: &Context<'_>) -> Vec<SpaceInput> {
    let scenes = context.plan.inputs(SPACE_SCENES) as u32;
    (0..scenes).map(|number| group.input(number, near)).collect()
}

/// Times an operation of each method on its inputs.
pub fn times(
    runs: &mut Runs,
    inputs: &[Vec<SpaceInput>],
    context: &Context<'_>,
    operation: fn(&mut dyn SpaceRun, &SpaceInput) -> Result<(), InputError>,
) -> Vec<Spread> {
    let works = runs.iter_mut().zip(inputs).map(|(run, inputs)| {
        // What refuses its input is found where errors are measured.
        Work::on_each(inputs, move |input| _ = operation(run.as_mut(), input))
    });
    interleaved(works.collect(), context.plan)
}

/// Twice the areas between a point and each side of a face, that of the first corner's opposite side first: barycentric
/// coordinates but for their sum. Nothing where the point is not inside.
pub fn weights([a, b, c]: &[ScreenCorner; 3], [x, y]: [f64; 2]) -> Option<[f64; 3]> {
    let side =
        |from: &ScreenCorner, to: &ScreenCorner| (to[0] - from[0]) * (y - from[1]) - (to[1] - from[1]) * (x - from[0]);
    let sides = [side(b, c), side(c, a), side(a, b)];
    sides.iter().all(|side| *side > 0.0).then_some(sides)
}

/// Why a scene was not drawn.
pub fn refused(error: InputError) -> anyhow::Error {
    anyhow!("a small scene is refused: {error:?}")
}
