//! The items of the playground's scenes: a frame with one of them, in bands of one row, by each method of antialiasing.

use zrow_playground_scene::{EMPTY_COUNT, Method, POT_COUNT, PRESETS, Pot};

use crate::case::{Case, V7EM};

/// All items, the looks of the teapot, and an empty frame.
pub fn cases() -> impl Iterator<Item = Case> {
    let case = |count, variant| {
        let title = format!("playground, 240 x 320 px in bands of 1 row: {count}, {variant}");
        Case::sibling("playground", count, &title, V7EM, variant, None)
    };
    let items = PRESETS.iter().flat_map(|preset| preset.counts);
    let items = items.flat_map(move |count| Method::ALL.iter().map(move |method| case(*count, method.name())));
    let pots = Pot::ALL.iter().filter(|pot| **pot != Pot::None);
    let pots = pots.map(move |pot| case(POT_COUNT, pot.name()));
    items.chain(pots).chain([case(EMPTY_COUNT, "draw")])
}
