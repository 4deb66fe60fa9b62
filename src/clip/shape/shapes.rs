//! The family of tests of whole shapes, which each shape's file adds a function to.

/// Whole shapes against a window of pixels: whether they are inside, outside, or neither.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Shapes;
