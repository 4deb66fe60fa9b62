//! A triangle by its three edge functions over the bounding box (Pineda 1988), each computed anew at each pixel.
//!
//! Promises: the pixels of [`scanline_polygon`](crate::scan::scanline_polygon), any order of the vertices; exact for all
//! vertices in the domain of `S` and any window, in 32 bits a pixel at either precision. A vertex beyond the domain, which
//! no constructor makes, gives a triangle without pixels.
//!
//! Take it where pixels are asked for out of order, as hardware does: each answer stands alone.
//! [`incremental_edge_triangle`](crate::scan::incremental_edge_triangle) walks with additions instead.

use crate::{
    geometry::{SubPixel, SubPoint, Window},
    scan::edge_function::{self, LocalEdge, Triangle},
    target::Span,
};

/// Hands over the visible spans, top to bottom. A row is one span, but for bands of a triangle thousands of pixels wide.
///
/// Cost: up to six products a pixel of the bounding box, up to the right end of each row's span.
///
/// # Errors
/// The first of `emit`.
pub fn fill<S: SubPixel, E>(
    vertices: [SubPoint<S>; 3],
    window: &Window,
    mut emit: impl FnMut(Span) -> Result<(), E>,
) -> Result<(), E> {
    let Some(triangle) = Triangle::visible(vertices, window) else {
        return Ok(());
    };
    triangle.bands::<S, E>(|band, edges| {
        let Window {
            left,
            top,
            right,
            bottom,
        } = *band;
        for y in top..bottom {
            let is_inside = |x: i32| {
                let at = |edge: &LocalEdge| {
                    let along = edge.x_step.wrapping_mul(x.wrapping_sub(left));
                    let down = edge.y_step.wrapping_mul(y.wrapping_sub(top));
                    // Fits: the sum does, whatever wraps on the way.
                    edge.value.wrapping_add(along).wrapping_add(down)
                };
                edges.iter().all(|edge| at(edge) >= 0)
            };
            if let Some(span) = edge_function::row_span(y, left..right, is_inside) {
                emit(span)?;
            }
        }
        Ok(())
    })
}
