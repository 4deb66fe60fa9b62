//! The families of polygon fills and of tests for single points, which each algorithm's file adds a function to.

/// Polygons of any contours: fills, and tests of single points.
///
/// # Fills
///
/// A function for each algorithm, all with the signature `fn(contours, rule, window, emit)`. They hand over the visible spans,
/// from top to bottom and from left to right in each row; all have the same pixels.
///
/// | algorithm | memory | take it when |
/// |---|---|---|
/// | [`scanline`](Self::scanline) | a table of edges | by default: an edge is asked for once a row |
/// | [`naive_scanline`](Self::naive_scanline) | 8 bytes a crossing of one row | RAM counts |
/// | [`brute_force`](Self::brute_force) | none | to check the others: an edge is asked for once a pixel |
///
/// # Where a point lies
///
/// A function for each algorithm, all with the signature `fn(contours, rule, point)`, which gives a
/// [`Location`](crate::scan::Location).
///
/// Guarantees of all four: exact for any contours and any point, also on vertices and edges (a product of two differences of
/// 32 bits is 64 bits long, and is compared by sign and size). **The boundary rule**: a point that lies on an edge or a
/// vertex of any contour is on the boundary, whatever lies on either side of that edge; any other is inside or
/// outside by its winding number. Nothing is stored: memory does not grow with the polygon.
///
/// | algorithm | what it counts | an edge costs |
/// |---|---|---|
/// | [`crossing_number`](Self::crossing_number) | edges left of the point, by a rule for vertices | two products where it crosses the row |
/// | [`merged_crossings`](Self::merged_crossings) | changes of side, coincident crossings merged | two products where it crosses the row |
/// | [`winding_number`](Self::winding_number) | edges right of the point, with their direction | two products where it may lie on either side |
/// | [`quadrant_arc_length`](Self::quadrant_arc_length) | quarter turns around the point | two products where it joins opposite quadrants |
///
/// [`winding_number`](Self::winding_number) is the one to take: the fewest products. A fill by rows
/// ([`scanline`](Self::scanline)) asks once an edge and row instead of once an edge and pixel.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Polygons;
