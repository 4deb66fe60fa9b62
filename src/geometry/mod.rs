//! Number formats, sub-pixel points and windows: what every later stage agrees on.
//!
//! Pixel centres are at integer coordinates and y grows downwards.

mod bounds;
mod convex_window;
mod division;
mod draw_error;
mod fixed_point_window;
mod input_error;
mod offset;
mod screen_plane;
mod sub_pixel;
mod too_small;
mod vertex;
mod wide_rectangle;
mod window;

pub(crate) use bounds::Bounds;
pub use convex_window::ConvexWindow;
pub use draw_error::DrawError;
pub use fixed_point_window::FixedPointWindow;
pub use input_error::InputError;
pub use sub_pixel::{Sub4, Sub8, SubPixel, SubPoint};
pub use too_small::TooSmall;
pub use vertex::Vertex;
pub use window::Window;

pub(crate) use convex_window::SideLine;
pub(crate) use division::{
    HAS_DIVIDER, divide_floor, divide_floor_cut, divide_floor_large, divide_floor_wide, divide_long, divide_to_zero,
    divide_wide, leading_zeros, multiply_high_16, multiply_shift, quotient_down, quotient_nearest,
    quotient_nearest_long, quotient_up, reciprocal_16, reciprocal_32, remainder_floor, scale_floor,
};
pub(crate) use offset::{coordinate_after, coordinate_before, distance, offset_from};
pub(crate) use screen_plane::ScreenPlane;
pub(crate) use sub_pixel::pixel_domain;
pub(crate) use vertex::assert_fraction_bits;
pub(crate) use wide_rectangle::WideRectangle;
