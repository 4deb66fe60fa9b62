//! A triangle by edge functions that are stepped (Pineda 1988): three additions from pixel to pixel and from row to row.
//!
//! Guarantees: the pixels of [`Polygons::scanline`](crate::scan::Polygons::scanline), any order of the vertices; exact
//! for all vertices in the domain of `S` and any window, in 32 bits a pixel at either precision. A vertex beyond the
//! domain, which no constructor makes, gives a triangle without pixels.
//!
//! Take it for triangles of a few pixels: no division to set up, no table. A row costs the way from the left side of the
//! bounding box; where that is long, [`Polygons::hierarchical_triangle`](crate::scan::Polygons::hierarchical_triangle) skips it in
//! blocks.

use crate::{
    geometry::{SubPixel, SubPoint, Window},
    scan::{
        polygon::Polygons,
        triangle::siblings::edge_function::{self, EdgeFunctions, LocalEdge},
    },
    surface::Span,
};

impl Polygons {
    /// Hands over the visible spans of a triangle, top to bottom, by its three edge functions, each stepped from pixel
    /// to pixel. A row is one span, unless the triangle is thousands of pixels in size: its window is then divided into
    /// parts in which the values of the edge functions fit 32 bits, and each part of a row is a span.
    ///
    /// The pixels are those of [`Polygons::scanline`](crate::scan::Polygons::scanline), in any order of the vertices.
    ///
    /// Cost: three additions a pixel of the bounding box, up to the right end of each row's span. Source: Pineda 1988.
    ///
    /// ```
    /// use core::convert::Infallible;
    /// use zrow::{geometry::{Sub4, SubPoint, Window}, scan::Polygons};
    ///
    /// let at = |x, y| SubPoint::<Sub4>::from_units(x, y);
    /// let vertices = [at(0, 0)?, at(0, 64)?, at(64, 0)?];
    /// let window = Window { left: 0, top: 0, right: 8, bottom: 8 };
    /// let mut pixels = 0;
    /// let Ok(()) = Polygons::incremental_edge_triangle(vertices, &window, |span| {
    ///     pixels += span.end - span.start;
    ///     Ok::<(), Infallible>(())
    /// });
    /// assert_eq!(pixels, 4 + 3 + 2 + 1);
    /// # Ok::<(), zrow::geometry::InputError>(())
    /// ```
    ///
    /// # Errors
    /// The first error that `emit` returns.
    pub fn incremental_edge_triangle<S: SubPixel, E>(
        vertices: [SubPoint<S>; 3],
        window: &Window,
        mut emit: impl FnMut(Span) -> Result<(), E>,
    ) -> Result<(), E> {
        let Some(triangle) = EdgeFunctions::visible(vertices, window) else {
            return Ok(());
        };
        triangle.bands::<S, E>(|band, mut edges| {
            for y in band.top..band.bottom {
                if let Some(span) = row(y, band, &edges) {
                    emit(span)?;
                }
                edges = edges.map(|edge| edge.moved(0, 1));
            }
            Ok(())
        })
    }
}

/// The span of one row of a band, from the edge functions at the row's first pixel. Not inlined: apart from the caller's
/// `emit`, the three values and their steps stay in registers.
#[inline(never)]
fn row(y: i32, band: &Window, edges: &[LocalEdge; 3]) -> Option<Span> {
    let [mut a, mut b, mut c] = edges.map(|edge| edge.value);
    let [a_step, b_step, c_step] = edges.map(|edge| edge.x_step);
    edge_function::row_span(y, band.left..band.right, |_| {
        let is_inside = a >= 0 && b >= 0 && c >= 0;
        a += a_step;
        b += b_step;
        c += c_step;
        is_inside
    })
}
