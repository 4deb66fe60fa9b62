//! Pictures that are prepared once and drawn row by row: a display list with a cursor for each of its items.
//!
//! A closure that draws shapes into each band begins every shape anew in every band, also those that do not meet it. A
//! [`Picture`] keeps its items from row to row and from frame to frame, as the scan-line algorithm keeps the edges of a
//! polygon:
//!
//! ```text
//!  buckets by first row        active list, in painter's order
//!  row 0   -> item 3           row 7:  item 0 -> item 3 -> item 4
//!  row 1                                 |         |         |
//!  ...                                 cursor    cursor    cursor     where the item is in this row
//!  row 7   -> item 0 -> item 4
//! ```
//!
//! An item is linked into the active list when the bands reach its first row, draws its rows from its cursor, and is
//! taken out after its last row. A row costs what is shown in it; items that wait or are done cost nothing.
//!
//! Source: the y-bucket table and the active list of scan-line algorithms (Wylie, Romney, Evans and Erdahl 1967), for
//! everything that a picture holds.

mod buckets;
mod damage;
mod item;
mod kinds;
#[expect(clippy::module_inception, reason = "the picture beside its parts")]
mod picture;
mod pool;
mod prepare;

pub use item::{ItemId, PictureItem, PictureSlot};
pub use picture::Picture;
