//! A frame while it is prepared, and the row from which on a face is drawn.

use crate::{
    geometry::{SubPixel, Window, offset_from},
    scene::{
        Look,
        frame::{RowStart, Tables},
        lens::{ProjectionOf, ScreenVertexOf},
    },
    view::{Position, ScreenPrecision, ScreenVertex},
    visible::NONE,
};

/// The tables of a frame that are being filled, and the projection and viewport of its camera.
pub(super) struct Preparation<'f, L: Look> {
    pub(super) tables: Tables<'f, L>,
    pub(super) projection: ProjectionOf<L>,
    pub(super) viewport: Window,
    /// Vertices of the models and of the fragments so far, whether there was room or not.
    pub(super) vertices_needed: usize,
}

/// The rows of the viewport, from its top, in which a face that is seen from the front may cover pixels, or samples of them in
/// a look with several: the first, and the one after the last, which may lie below the viewport.
#[inline]
pub(super) fn visible_rows<L: Look>(corners: [&ScreenVertexOf<L>; 3], viewport: &Window) -> Option<(usize, usize)> {
    let fraction_bits = L::Precision::FRACTION_BITS;
    let [a, b, c] = corners;
    let (a, b, c) = (a.position(), b.position(), c.position());
    if !is_front::<L::Precision>(a, b, c) {
        return None;
    }
    let unit = 1i32 << fraction_bits;
    // How far samples are right of the centre of their pixel and below it, at most, and how far left of it and above it.
    let [below, above] = if L::IS_MULTISAMPLED {
        [unit / 2 - 1, unit / 2]
    } else {
        [0; 2]
    };
    // From the viewport's edge to the coordinate: rounded down to whole pixels, that is the first row or column whose
    // centre is at the coordinate or after it.
    let from = |edge: i32, units: i32| units + (unit - 1) - (edge << fraction_bits);
    let (first, second, third) = (
        from(viewport.top, a.y),
        from(viewport.top, b.y),
        from(viewport.top, c.y),
    );
    let top = ((first.min(second).min(third) - below) >> fraction_bits).max(0);
    let bottom = (first.max(second).max(third) + above) >> fraction_bits;
    if top >= bottom || top >= viewport.bottom - viewport.top {
        return None;
    }
    let (one, other) = (from(viewport.left, a.x), from(viewport.left, b.x));
    let width = (viewport.right - viewport.left) << fraction_bits;
    // Two corners to either side of a column's centre, and one of them has columns of the viewport on either side.
    if !L::IS_MULTISAMPLED && (one ^ other) as u32 >= unit as u32 && offset_from(unit, one) < offset_from(unit, width) {
        return Some((top as usize, bottom as usize));
    }
    let left = ((one.min(other).min(from(viewport.left, c.x)) - below) >> fraction_bits).max(0);
    let right = (one.max(other).max(from(viewport.left, c.x)) + above).min(width) >> fraction_bits;
    (left < right).then_some((top as usize, bottom as usize))
}

/// The rows of the viewport in which a face of a look may cover pixels, as [`visible_rows`] has them: one that is seen from
/// behind where backs are drawn, too.
#[inline]
pub(super) fn rows_of_face<L: Look>(corners: [&ScreenVertexOf<L>; 3], viewport: &Window) -> Option<(usize, usize)> {
    let [a, b, c] = corners;
    match visible_rows::<L>(corners, viewport) {
        None if L::DRAWS_BACKS => visible_rows::<L>([a, c, b], viewport),
        rows => rows,
    }
}

/// The corners of a face of a look, or what belongs to each of them, as rows are to see them: clockwise, where it is drawn.
#[inline]
pub(super) fn clockwise<L: Look, T>(corners: [&ScreenVertexOf<L>; 3], [a, b, c]: [T; 3]) -> [T; 3] {
    let [first, second, third] = corners.map(ScreenVertex::position);
    if L::DRAWS_BACKS && is_front::<L::Precision>(first, third, second) {
        [a, c, b]
    } else {
        [a, b, c]
    }
}

/// Makes a node the head of the bucket of its first row, and returns the previous head. `rows` are the first row and
/// the one after the last.
#[inline]
pub(super) fn begin(starts: &mut [RowStart], node: u16, rows: (usize, usize)) -> u16 {
    let Some(start) = starts.get_mut(rows.0) else {
        return NONE;
    };
    let previous = start.begin(node);
    if let Some(after) = starts.get_mut(rows.1) {
        after.end();
    }
    previous
}

/// The entry in the table of next nodes for a face that begins in no row, in a look with antialiased silhouettes: the face's
/// own node where it is turned away or has no area, else [`NONE`]; so silhouettes are found without looking at corners again.
#[inline]
pub(super) fn next_outside_rows<L: Look>([a, b, c]: [&ScreenVertexOf<L>; 3], node: u16) -> u16 {
    let [a, b, c] = [a, b, c].map(ScreenVertex::position);
    let is_seen = is_front::<L::Precision>(a, b, c) || (L::DRAWS_BACKS && is_front::<L::Precision>(a, c, b));
    if is_seen { NONE } else { node }
}

/// Whether the corners run clockwise on the screen, in exact arithmetic.
#[inline]
pub(super) fn is_front<S: ScreenPrecision>(a: Position, b: Position, c: Position) -> bool {
    let (x1, y1) = (b.x - a.x, b.y - a.y);
    let (x2, y2) = (c.x - a.x, c.y - a.y);
    if S::FRACTION_BITS <= 4 {
        // Differences are at most 32,752: each product fits.
        x1 * y2 > x2 * y1
    } else {
        i64::from(x1) * i64::from(y2) > i64::from(x2) * i64::from(y1)
    }
}
