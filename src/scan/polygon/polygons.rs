//! The family of polygon fills, which each algorithm's file adds a function to.

/// Polygon fills: a function for each algorithm, all with the signature `fn(contours, rule, window, emit)`.
///
/// They hand over the visible spans, from top to bottom and from left to right in each row; all have the same pixels.
///
/// | algorithm | memory | take it when |
/// |---|---|---|
/// | [`scanline`](Self::scanline) | a table of edges | by default: an edge is asked for once a row |
/// | [`naive_scanline`](Self::naive_scanline) | 8 bytes a crossing of one row | RAM counts |
/// | [`brute_force`](Self::brute_force) | none | to check the others: an edge is asked for once a pixel |
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Polygons;
