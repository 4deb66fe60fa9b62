//! The families of polygon fills, of triangle fills and of tests for single points, which each algorithm's file adds a function
//! to.

/// Polygons of any contours: fills, and tests of single points; and fills of triangles.
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
/// # Fills of triangles
///
/// A function for each algorithm, all with the signature `fn(vertices, window, emit)`: triangles at sub-pixel corners, by edge
/// functions or barycentric coordinates. They are kept to compare them with [`scanline`](Self::scanline), whose pixels they
/// have. embedded-graphics' `Triangle` of whole pixels has other pixels; it is drawn by a walk along Bresenham's lines of its
/// sides.
///
/// | algorithm | take it when |
/// |---|---|
/// | [`incremental_edge_triangle`](Self::incremental_edge_triangle) | pixels are asked for in order, and nothing divides |
/// | [`hierarchical_triangle`](Self::hierarchical_triangle) | triangles are large, and blocks are skipped for another reason too |
/// | [`edge_function_triangle`](Self::edge_function_triangle) | pixels are asked for out of order |
/// | [`barycentric_triangle`](Self::barycentric_triangle) | something else needs the coordinates of single pixels too |
///
/// # Attributes of triangles
///
/// A function for each algorithm, all with the signature `fn(corners, window, emit)`: what the corners of a triangle or of a
/// convex polygon have, such as colours or texture coordinates, interpolated for each pixel evenly on the screen. The pixels
/// are those of the fills.
///
/// | algorithm | exact to | a polygon of more than three corners |
/// |---|---|---|
/// | [`plane_interpolation`](Self::plane_interpolation) | 3/4 of a unit | is divided into triangles |
/// | [`barycentric_interpolation`](Self::barycentric_interpolation) | 1/2 of a unit | is divided into triangles |
/// | [`edge_and_span_interpolation`](Self::edge_and_span_interpolation) | one unit, but for steep slivers | depends on how it is turned |
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
