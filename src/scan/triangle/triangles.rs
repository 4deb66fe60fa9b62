//! The family of triangle fills, which each algorithm's file adds a function to.

/// Triangles at sub-pixel corners, filled by edge functions or barycentric coordinates: a function for each algorithm, all
/// with the signature `fn(vertices, window, emit)`.
///
/// They are kept to compare them with [`Polygons::scanline`](crate::scan::Polygons::scanline), whose pixels they have.
/// embedded-graphics' `Triangle` of whole pixels has other pixels; it is drawn by a walk along Bresenham's lines of its sides.
///
/// | algorithm | take it when |
/// |---|---|
/// | [`incremental_edge`](Self::incremental_edge) | pixels are asked for in order, and nothing divides |
/// | [`hierarchical`](Self::hierarchical) | triangles are large, and blocks are skipped for another reason too |
/// | [`edge_function`](Self::edge_function) | pixels are asked for out of order |
/// | [`barycentric`](Self::barycentric) | something else needs the coordinates of single pixels too |
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Triangles;
