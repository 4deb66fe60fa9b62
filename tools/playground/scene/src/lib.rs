//! What the playground draws, for the page (as WebAssembly) and for the desktop alike: a text that names a state, as it
//! stands behind the `#` in the address of the page, becomes a picture.
//!
//! A [`State`] is read from the text; [`Playground`] prepares its items and draws it band by band in the colour of a panel.
#![no_std]
#![forbid(unsafe_code)]

mod address;
mod coverage;
mod letters;
mod outline;
mod panel_color;
mod playground;
#[cfg(test)]
mod playground_tests;
mod pot;
#[cfg(test)]
mod pot_tests;
mod presets;
mod state;

pub use coverage::bytes_per_row;
pub use panel_color::PanelColor;
pub use playground::{AREA, BACKGROUND, EDGES, Footprint, HEIGHT, POT_EDGES, Playground, WIDTH};
pub use presets::{COUNTED_ROWS, EMPTY_COUNT, POT_COUNT, PRESETS, Preset};
pub use state::{Depth, ITEMS, Item, Kind, Method, POINTS, Pot, Precision, State};
