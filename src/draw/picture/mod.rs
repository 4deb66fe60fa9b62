//! Pictures that are prepared once and drawn row by row: a display list with a cursor for each of its items.
//!
//! A closure that draws shapes into each band sets every shape up again in every band, even where the band shows nothing of
//! it. A [`Picture`] keeps its items from row to row and from frame to frame, as the scan-line algorithm keeps the edges of a
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
//! An item is linked into the active list when the bands reach its first row. For each of its rows it draws the pixels that its
//! cursor stands for, and moves the cursor to the next row; after its last row it is taken out of the list. So the cost of a
//! row depends on the items that have pixels in it, and not on the number of items in the picture.
//!
//! Source: the y-bucket table and the active list of scan-line algorithms (Wylie, Romney, Evans and Erdahl 1967), for
//! everything that a picture holds.

mod active_list;
mod buckets;
mod changes;
mod damage;
mod drawable_item;
mod group;
mod item;
mod kinds;
#[expect(clippy::module_inception, reason = "the picture beside its parts")]
mod picture;
mod pool;
mod prepare;
mod translate;

pub use drawable_item::DrawableItem;
pub use group::Group;
pub use item::{ItemId, PictureItem, PictureSlot};
pub use picture::Picture;
