//! The translucent faces of a row, over the others: of each pixel's fragments the farthest first, whatever the order of faces.
//!
//! ```text
//!     nearest   ----------            3rd    The depth row has the depths of the opaque faces. Of the fragments in front of
//!                    -----------      2nd    those the farthest of each pixel is found, mixed with the pixel, and its depth
//!                ------               1st    stored: a layer. That goes on until nothing is in front of the stored depths.
//!     opaque    =================
//! ```
//!
//! Faces that go through each other need no splitting, and it does not matter in what order models and bands come. Where two
//! translucent fragments are equally near, the one that comes first in the order of the models is drawn over the other; one
//! that is as near as an opaque face is behind it.
//!
//! Guarantees: exact, each fragment is mixed once. Memory: 128 bytes of stack for depths of 16 bits, 192 for 32. Cost: two walks
//! over the fragments of translucent faces for each layer of some 16 columns, and one that finds nothing more.
//!
//! Source: depth peeling (Mammen 1989; Everitt 2001), from the back, one row at a time; `over` of Porter and Duff 1984.

use embedded_graphics::geometry::Point;

use crate::{
    shade::{Planes, Shading},
    surface::Order,
    view::{DepthWidth, ScreenPrecision},
    visible::{
        DepthRow, active_face::ActiveFace, active_faces::ActiveList, count::Count, face_table::FaceTable,
        shaded_span::run,
    },
};

/// Columns whose layers are found together.
const COLUMNS: usize = 16;

/// A pixel's layers: which fragment is the next one, and which was the last.
#[derive(Debug, Copy, Clone)]
struct Layer<D> {
    /// The face that was mixed with the pixel last, whose depth is stored. Of others at the same depth only those before it in the
    /// order of the models are still to come: before the first face none.
    last: u16,
    /// The face of the next layer and its depth, [`FARTHEST`](DepthWidth::FARTHEST) where none is in front of the last.
    next: u16,
    depth: D,
}

impl<D: DepthWidth> Layer<D> {
    const NONE: Self = Self {
        last: 0,
        next: 0,
        depth: D::FARTHEST,
    };

    /// Whether a fragment is in front of the stored depth, and behind what is the next layer up to now.
    #[inline]
    fn comes_next(&self, stored: D, depth: D, order: u16) -> bool {
        let is_in_front = depth > stored || (depth == stored && order < self.last);
        let is_behind = depth < self.depth || (depth == self.depth && order > self.next);
        is_in_front && (is_behind || self.depth == D::FARTHEST)
    }
}

/// Hands over the faces of a row.
type ForEach<'f, S, H> = &'f dyn Fn(&mut dyn FnMut(&ActiveFace<S, H>));

impl<S: ScreenPrecision, H: Shading> ActiveList<S, H> {
    /// Mixes the translucent faces of a row with what is behind them. Takes all faces to the next row, and gives the slots of
    /// those free that have ended.
    #[inline(never)]
    pub(super) fn blend_row<O: Order, D: DepthWidth>(
        &mut self,
        faces: &impl FaceTable<S, D, H>,
        row: &mut DepthRow<'_, H::Color, O, D>,
    ) {
        let active = self.slots.get_mut(..usize::from(self.used)).unwrap_or_default();
        blend_faces(faces, row, &|visit| active.iter().for_each(visit));
        for (slot, face) in (0..).zip(active) {
            face.next_span();
            if !face.begin_row_seldom(row.y + 1) {
                face.set_next_free(self.free);
                self.free = slot;
            }
        }
    }
}

/// Mixes those of some faces that are translucent with what is behind them in a row.
pub(super) fn blend_faces<S: ScreenPrecision, O: Order, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    row: &mut DepthRow<'_, H::Color, O, D>,
    for_each: ForEach<'_, S, H>,
) {
    let (mut first, mut last) = (row.words.len() as i32, 0);
    for_each(&mut |face| {
        let [start, end] = face.span();
        if face.is_translucent() && start < end {
            (first, last) = (first.min(start), last.max(end));
        }
    });
    let mut left = first.max(0);
    last = last.min(row.words.len() as i32);
    while left < last {
        let columns = [left, last.min(left + COLUMNS as i32)];
        blend_columns(faces, row, for_each, columns);
        left = columns[1];
    }
}

/// Mixes all layers of some columns.
fn blend_columns<S: ScreenPrecision, O: Order, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    row: &mut DepthRow<'_, H::Color, O, D>,
    for_each: ForEach<'_, S, H>,
    columns: [i32; 2],
) {
    let mut layers = [Layer::NONE; COLUMNS];
    loop {
        let mut any = false;
        for_each(&mut |face| any |= walk::<_, _, _, _, _, false>(faces, row, face, columns, &mut layers));
        if !any {
            return;
        }
        for_each(&mut |face| {
            walk::<_, _, _, _, _, true>(faces, row, face, columns, &mut layers);
        });
    }
}

/// Goes over the fragments of a face in some columns. Finds those that come next, or mixes them. Returns whether there is one.
fn walk<S, O, D, H, F, const MIX: bool>(
    faces: &F,
    row: &mut DepthRow<'_, H::Color, O, D>,
    face: &ActiveFace<S, H>,
    [left, right]: [i32; 2],
    layers: &mut [Layer<D>],
) -> bool
where
    S: ScreenPrecision,
    O: Order,
    D: DepthWidth,
    H: Shading,
    F: FaceTable<S, D, H>,
{
    let span = face.span();
    let (mut column, last) = (span[0].max(left), span[1].min(right));
    if column >= last || !face.is_translucent() {
        return false;
    }
    let Some(skin) = faces.skin(face.node).copied() else {
        return false;
    };
    let order = faces.order(face.node);
    let (mut known, mut any) = (None, false);
    while column < last {
        let run = run::<S, D, H, F>(face, span, [column, row.y], row.left, known);
        let end = run.end.min(last);
        known = run.at_end;
        let (words, depths) = (
            row.words.get_mut(column as usize..),
            row.depths.get_mut(column as usize..),
        );
        let layers = layers.get_mut((column - left) as usize..(end - left) as usize);
        let (Some(words), Some(depths), Some(layers)) = (words, depths, layers) else {
            return any;
        };
        let (mut values, mut depth) = (run.values, face.plane.at(column, row.y));
        for (((layer, word), stored), x) in layers.iter_mut().zip(words).zip(depths).zip(column..) {
            let stored_depth = D::from_interpolated(depth.0);
            let fragment = || F::fragment(&skin, face.word, &values);
            if MIX {
                if layer.depth == stored_depth && layer.next == order && layer.depth != D::FARTHEST {
                    if let Some(fragment) = fragment() {
                        let position = Point::new(x + row.left, row.y);
                        *word = O::reorder(F::blend(&skin, fragment, O::reorder(*word), position));
                        faces.count().blended();
                    }
                    *stored = stored_depth;
                    *layer = Layer {
                        last: order,
                        ..Layer::NONE
                    };
                }
            } else if layer.comes_next(*stored, stored_depth, order) && (!H::Attributes::VARY || fragment().is_some()) {
                (layer.next, layer.depth, any) = (order, stored_depth, true);
            }
            H::Attributes::step(&mut values, &run.per_column);
            depth += face.plane.per_column;
        }
        column = end;
    }
    any
}
