//! Whole shapes against a window: whether they are inside, outside, or neither.

mod circle_against_window;
mod rectangle_against_window;

pub(crate) use circle_against_window::circle_limit;
