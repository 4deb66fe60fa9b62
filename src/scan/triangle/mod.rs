//! Triangles at sub-pixel corners, filled by edge functions or barycentric coordinates: kept to compare them with
//! [`scanline_polygon`](crate::scan::polygon::scanline_polygon()), whose pixels they have.
//!
//! All functions have one signature, `fn(vertices, window, emit)`. embedded-graphics' `Triangle` of whole pixels has other
//! pixels; it is drawn by a walk along Bresenham's lines of its sides.
//!
//! | algorithm | take it when |
//! |---|---|
//! | [`incremental_edge_triangle()`] | pixels are asked for in order, and nothing divides |
//! | [`hierarchical_triangle()`] | triangles are large, and blocks are skipped for another reason too |
//! | [`edge_function_triangle()`] | pixels are asked for out of order |
//! | [`barycentric_triangle()`] | something else needs the coordinates of single pixels too |

// Why small functions are `inline(always)` in these files: with `inline` alone, on a Cortex-M4, small triangles take 3.1 % more
// instructions and large ones 1.2 % fewer, by incremental edges 2.5 % more.

pub(crate) mod bresenham_triangle;
mod siblings;
mod small_triangle;
pub(crate) mod vertex_order;

pub use siblings::*;
