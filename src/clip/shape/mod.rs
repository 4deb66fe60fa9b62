//! Whole shapes against a window: whether they are inside, outside, or neither, `fn(shape, window)`.

mod circle_against_window;
mod rectangle_against_window;

pub use circle_against_window::circle_against_window;
pub(crate) use circle_against_window::circle_limit;
pub use rectangle_against_window::{clip_rectangle, rectangle_against_window};
