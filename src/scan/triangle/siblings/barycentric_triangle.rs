//! A triangle by barycentric coordinates (Möbius 1827): each pixel of the bounding box on its own.
//!
//! Barycentric coordinates times twice the triangle's area are whole numbers: for each edge, its cross product with the
//! vector from its start to the pixel. They are used in this form, without a division. Two are computed; the third is
//! twice the area less the sum of both. All three are positive for a pixel inside. Where one is 0, the pixel lies on an edge
//! and the top-left rule decides: a bias of -1 makes the values of edges negative that do not own their pixels.
//!
//! Guarantees: the pixels of [`Polygons::scanline`](crate::scan::Polygons::scanline), any order of the vertices; exact
//! for all vertices in the domain of `S` and any window, 32-bit products for [`Sub4`](crate::geometry::Sub4), 64-bit ones
//! for [`Sub8`](crate::geometry::Sub8). A vertex beyond the domain, which no constructor makes, gives a triangle without
//! pixels.
//!
//! The baseline of [`Polygons::edge_function_triangle`](crate::scan::Polygons::edge_function_triangle) and its siblings. Take it where
//! something else needs the coordinates of single pixels too.

use crate::{
    geometry::{SubPixel, SubPoint, Window},
    scan::{
        polygon::Polygons,
        triangle::siblings::edge_function::{self, EdgeFunctions},
    },
    surface::Span,
};

impl Polygons {
    /// Hands over the visible spans of a triangle, top to bottom, by barycentric coordinates; at most one a row.
    ///
    /// The pixels are those of [`Polygons::scanline`](crate::scan::Polygons::scanline), in any order of the vertices.
    ///
    /// Cost: four products a pixel of the bounding box, up to the right end of each row's span.
    /// Source: Möbius 1827.
    ///
    /// # Errors
    /// The first error that `emit` returns.
    pub fn barycentric_triangle<S: SubPixel, E>(
        vertices: [SubPoint<S>; 3],
        window: &Window,
        mut emit: impl FnMut(Span) -> Result<(), E>,
    ) -> Result<(), E> {
        let Some(triangle) = EdgeFunctions::visible(vertices, window) else {
            return Ok(());
        };
        let Window {
            left,
            top,
            right,
            bottom,
        } = triangle.visible;
        let [one, other, _] = triangle.edges;
        for y in top..bottom {
            let span = edge_function::row_span(y, left..right, |x| {
                let (first, second) = (one.at::<S>(x, y), other.at::<S>(x, y));
                // No overflow: all three values are below 2^46.
                let third = triangle.whole - first - second;
                (first | second | third) >= 0
            });
            if let Some(span) = span {
                emit(span)?;
            }
        }
        Ok(())
    }
}
