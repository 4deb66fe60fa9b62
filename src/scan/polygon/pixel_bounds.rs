//! The pixels that a polygon can reach.

use crate::{
    geometry::{Vertex, Window, assert_fraction_bits},
    scan::polygon::edge::ceil_pixel,
};

/// The pixels of a window whose centres are in the bounding box of the contours. Empty without vertices.
///
/// The units of a pixel in it are between those of vertices: they fit 32 bits.
pub(crate) fn visible<V: Vertex>(contours: &[&[V]], window: &Window) -> Window {
    const { assert_fraction_bits::<V>() }
    let mut vertices = contours.iter().flat_map(|contour| contour.iter());
    let Some(first) = vertices.next() else {
        return Window::EMPTY;
    };
    let (mut left, mut top) = (first.x_units(), first.y_units());
    let (mut right, mut bottom) = (left, top);
    for vertex in vertices {
        left = left.min(vertex.x_units());
        top = top.min(vertex.y_units());
        right = right.max(vertex.x_units());
        bottom = bottom.max(vertex.y_units());
    }
    let end = |last: i32| (last >> V::FRACTION_BITS).saturating_add(1);
    window.intersection(&Window {
        left: ceil_pixel(left, V::FRACTION_BITS),
        top: ceil_pixel(top, V::FRACTION_BITS),
        right: end(right),
        bottom: end(bottom),
    })
}
