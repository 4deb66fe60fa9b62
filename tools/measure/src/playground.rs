//! The items of the playground's scenes: a frame with one of them, by each method of antialiasing, in bands of some heights.

use zrow_playground_scene::{COUNTED_ROWS, EMPTY_COUNT, Method, POT_COUNT, PRESETS, Pot};

use crate::case::{Case, V7EM};

/// All items, the looks of the teapot, and an empty frame.
pub fn cases() -> impl Iterator<Item = Case> {
    let items = PRESETS.iter().flat_map(|preset| preset.counts);
    let items = items.flat_map(|count| Method::ALL.iter().map(|method| (*count, method.name())));
    let pots = Pot::ALL.iter().filter(|pot| **pot != Pot::None);
    let pots = pots.map(|pot| (POT_COUNT, pot.name()));
    let frames = items.chain(pots).chain([(EMPTY_COUNT, "draw")]);
    frames.flat_map(|(count, name)| COUNTED_ROWS.iter().map(move |rows| case(count, name, *rows)))
}

fn case(count: &'static str, name: &str, rows: u32) -> Case {
    let title = format!("playground, 240 x 320 px, {rows} rows a band (0: all): {count}, {name}");
    // Names live as long as the program.
    let variant = format!("{name}.{rows}").leak();
    Case::sibling("playground", count, &title, V7EM, variant, None)
}
