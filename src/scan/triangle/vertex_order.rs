//! The vertices of a triangle in the order in which rows meet them.

use core::mem::swap;

use embedded_graphics::geometry::Point;

/// Sorts the vertices from top to bottom; those in one row from left to right.
#[inline]
pub(crate) fn from_top_to_bottom([mut top, mut middle, mut bottom]: [Point; 3]) -> [Point; 3] {
    if is_after(&top, &middle) {
        swap(&mut top, &mut middle);
    }
    if is_after(&middle, &bottom) {
        swap(&mut middle, &mut bottom);
        if is_after(&top, &middle) {
            swap(&mut top, &mut middle);
        }
    }
    [top, middle, bottom]
}

/// The order of vertices: top to bottom, then left to right.
fn is_after(a: &Point, b: &Point) -> bool {
    a.y > b.y || (a.y == b.y && a.x > b.x)
}
