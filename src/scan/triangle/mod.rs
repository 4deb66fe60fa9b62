//! Triangles: the fill of whole pixels that draws, and the family of fills at sub-pixel corners.

// Why small functions are `inline(always)` in these files: with `inline` alone, on a Cortex-M4, small triangles take 3.1 % more
// instructions, by incremental edges 2.7 % more.

pub(crate) mod bresenham_triangle;
mod siblings;
pub(crate) mod small_triangle;
pub(crate) mod vertex_order;
