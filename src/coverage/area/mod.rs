//! The exact area of the shape in each pixel, by cells with `cover` and `area`.

mod accumulation_buffer;
mod cell;
mod combined_area;
mod inside_area;
mod mirrored_rows;
mod row_parts;
mod siblings;
mod signed_area;
mod sparse_row;
mod sparse_rows;
mod unordered_row;

pub(crate) use accumulation_buffer::in_room;
pub(crate) use cell::{AREA_BITS, Cell, for_each_visible as for_each_visible_cell};
pub(crate) use combined_area::{Combination, CombinedArea};
pub use inside_area::InsideArea;
pub(crate) use mirrored_rows::Mirror;
pub(crate) use row_parts::RowParts;
pub use signed_area::SignedArea;
pub(crate) use unordered_row::UnorderedRow;
