//! The exact area of the shape in each pixel.

mod area_chains;
mod area_row;
mod inside_area;
mod piece;
mod signed_area;

pub use inside_area::InsideArea;
pub use signed_area::SignedArea;
