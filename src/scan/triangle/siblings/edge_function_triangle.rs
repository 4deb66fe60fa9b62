//! A triangle by its three edge functions over the bounding box (Pineda 1988), each computed anew at each pixel.
//!
//! Guarantees: the pixels of [`Polygons::scanline`](crate::scan::Polygons::scanline), any order of the vertices; exact
//! for all vertices in the domain of `S` and any window, in 32 bits a pixel at either precision. A vertex beyond the
//! domain, which no constructor makes, gives a triangle without pixels.
//!
//! Take it where pixels are asked for out of order, as hardware does: each answer stands alone. In order, a compiler may
//! turn the products into the additions of [`Polygons::incremental_edge_triangle`](crate::scan::Polygons::incremental_edge_triangle).

use crate::{
    geometry::{SubPixel, SubPoint, Window},
    scan::{
        polygon::Polygons,
        triangle::siblings::edge_function::{self, EdgeFunctions, LocalEdge},
    },
    surface::Span,
};

impl Polygons {
    /// Hands over the visible spans of a triangle, top to bottom, by its three edge functions, each computed anew at
    /// each pixel. A row is one span, but for bands of a triangle thousands of pixels wide.
    ///
    /// The pixels are those of [`Polygons::scanline`](crate::scan::Polygons::scanline), in any order of the vertices.
    ///
    /// Cost: up to six products a pixel of the bounding box, up to the right end of each row's span.
    /// Source: Pineda 1988.
    ///
    /// # Errors
    /// The first error that `emit` returns.
    pub fn edge_function_triangle<S: SubPixel, E>(
        vertices: [SubPoint<S>; 3],
        window: &Window,
        mut emit: impl FnMut(Span) -> Result<(), E>,
    ) -> Result<(), E> {
        let Some(triangle) = EdgeFunctions::visible(vertices, window) else {
            return Ok(());
        };
        triangle.bands::<S, E>(|band, edges| {
            for y in band.top..band.bottom {
                if let Some(span) = row(y, band, &edges) {
                    emit(span)?;
                }
            }
            Ok(())
        })
    }
}

/// The span of a row. One copy for all types of `emit`.
#[inline(never)]
fn row(y: i32, band: &Window, edges: &[LocalEdge; 3]) -> Option<Span> {
    edge_function::row_span(y, band.left..band.right, |x| {
        let (columns, rows) = (x - band.left, y - band.top);
        edges.iter().all(|edge| edge.moved(columns, rows).value >= 0)
    })
}
