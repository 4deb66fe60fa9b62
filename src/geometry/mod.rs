//! Number formats, sub-pixel points and windows: what every later stage agrees on.
//!
//! Pixel centres are at integer coordinates and y grows downwards.

mod bounds;
mod convex_window;
mod division;
mod outline;
mod sub_pixel;
mod sub_window;
mod table_full;
mod vertex;
mod window;

pub use bounds::Bounds;
pub use convex_window::{ConvexWindow, NotConvex};
pub use sub_pixel::{OutOfDomain, Sub4, Sub8, SubPixel, SubPoint};
pub use sub_window::SubWindow;
pub use table_full::{Table, TableFull};
pub use vertex::Vertex;
pub use window::Window;

pub(crate) use convex_window::Side;
pub(crate) use division::{
    HAS_DIVIDER, divide_floor, divide_floor_large, divide_floor_wide, divide_long, divide_wide, leading_zeros,
    multiply_high_16, multiply_shift, reciprocal_16, remainder_floor, scale_floor,
};
pub(crate) use outline::Outline;
pub(crate) use vertex::assert_fraction_bits;
