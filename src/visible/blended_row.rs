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
//! Guarantees: exact, each fragment is mixed once. Memory: 384 bytes of stack for depths of 16 bits, 512 for 32. Cost: two
//! walks over the fragments of translucent faces for each layer of some 64 columns.
//!
//! Source: depth peeling (Mammen 1989; Everitt 2001), from the back, one row at a time; `over` of Porter and Duff 1984.

use embedded_graphics::geometry::Point;

use crate::{
    shade::{Planes, Shading},
    surface::Order,
    view::{DepthWidth, ScreenPrecision},
    visible::{
        DepthRow,
        active_face::ActiveFace,
        active_faces::ActiveList,
        count::Count,
        divided_runs::DividedRuns,
        face_table::FaceTable,
        shaded_span::{are_even, run},
    },
};

/// Columns whose layers are found together: with 16, a row of 65 translucent faces took three times as long.
const COLUMNS: usize = 64;

/// A pixel's layers: which fragment is the next one, and which was the last.
#[derive(Debug, Copy, Clone)]
struct Layer<D> {
    /// The face that was mixed with the pixel last, whose depth is stored. Of others at the same depth only those before it in
    /// the order of the models are still to come: before the first face none.
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

    /// Whether a fragment is in front of the last layer, whose depth is stored.
    #[inline]
    fn is_in_front(&self, stored: D, depth: D, order: u16) -> bool {
        depth > stored || (depth == stored && order < self.last)
    }

    /// Takes a fragment in front of the last layer, if it is behind what is the next layer up to now.
    #[inline]
    fn offer(&mut self, depth: D, order: u16) -> Found {
        if self.depth == D::FARTHEST {
            (self.next, self.depth) = (order, depth);
            return LAST;
        }
        if depth < self.depth || (depth == self.depth && order > self.next) {
            (self.next, self.depth) = (order, depth);
        }
        MORE
    }
}

/// What there is in front of the last layers of some columns: bits, because they are returned in a register.
type Found = u32;
const NOTHING: Found = 0;
/// One layer.
const LAST: Found = 1;
/// Another layer in front of that.
const MORE: Found = 2;

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
        self.take_all_down(row.y);
    }
}

/// Mixes those of some faces that are translucent with what is behind them in a row.
pub(super) fn blend_faces<S: ScreenPrecision, O: Order, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    row: &mut DepthRow<'_, H::Color, O, D>,
    for_each: ForEach<'_, S, H>,
) {
    let width = row.words.len() as i32;
    let (mut left, mut last) = (width, 0);
    for_each_within([0, width], for_each, |_, [start, end]| {
        (left, last) = (left.min(start), last.max(end));
    });
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
    let mut found = MORE;
    while found & MORE != 0 {
        found = NOTHING;
        for_each_within(columns, for_each, |face, within| {
            found |= walk::<_, _, _, _, _, false>(faces, row, face, columns[0], within, &mut layers);
        });
        if found != NOTHING {
            for_each_within(columns, for_each, |face, within| {
                walk::<_, _, _, _, _, true>(faces, row, face, columns[0], within, &mut layers);
            });
        }
    }
}

/// Hands over the translucent ones of some faces that have pixels in some columns, and in which.
#[inline]
fn for_each_within<S: ScreenPrecision, H: Shading>(
    [left, right]: [i32; 2],
    for_each: ForEach<'_, S, H>,
    mut visit: impl FnMut(&ActiveFace<S, H>, [i32; 2]),
) {
    for_each(&mut |face| {
        let [start, end] = face.span();
        let (start, end) = (start.max(left), end.min(right));
        if start < end && face.is_translucent() {
            visit(face, [start, end]);
        }
    });
}

/// Mixes a span of a translucent face with what the row has, without depths. Columns count from the first of the row.
pub(super) fn blend_span<S, O, D, H, F>(
    faces: &F,
    row: &mut DepthRow<'_, H::Color, O, D>,
    face: &ActiveFace<S, H>,
    [mut column, last]: [i32; 2],
) where
    S: ScreenPrecision,
    O: Order,
    D: DepthWidth,
    H: Shading,
    F: FaceTable<S, D, H>,
{
    let Some(skin) = faces.skin(face.node).copied() else {
        return;
    };
    let span = face.span();
    while column < last {
        let run = run::<S, D, H, F>(face, span, [column, row.y], row.left);
        let end = run.end.min(last);
        let words = row.words.get_mut(column as usize..end as usize).unwrap_or_default();
        let mut values = run.values;
        for (word, x) in words.iter_mut().zip(column..) {
            if let Some(fragment) = F::fragment(&skin, face.word, &values) {
                let position = Point::new(x + row.left, row.y);
                *word = O::reorder(F::blend(&skin, fragment, O::reorder(*word), position));
                faces.count().blended();
            }
            H::Attributes::step(&mut values, &run.per_column);
        }
        column = end;
    }
}

/// Goes over the fragments of a face in some columns. Finds those that come next, or mixes them. Layers count from a column.
#[inline(never)]
fn walk<S, O, D, H, F, const MIX: bool>(
    faces: &F,
    row: &mut DepthRow<'_, H::Color, O, D>,
    face: &ActiveFace<S, H>,
    left: i32,
    [mut column, last]: [i32; 2],
    layers: &mut [Layer<D>],
) -> Found
where
    S: ScreenPrecision,
    O: Order,
    D: DepthWidth,
    H: Shading,
    F: FaceTable<S, D, H>,
{
    let Some(skin) = faces.skin(face.node).copied() else {
        return NOTHING;
    };
    let (span, order) = (face.span(), faces.order(face.node));
    let mut runs = None;
    if !are_even::<S, D, H, F>(face) {
        runs = Some(DividedRuns::new::<S, D, H>(face, span, [column, row.y], row.left));
    }
    let mut found = NOTHING;
    while column < last {
        let run = match &mut runs {
            Some(runs) => runs.next_run(column),
            None => H::Attributes::even_run(&face.attributes, column, last, row.y),
        };
        let end = run.end.min(last);
        let (words, depths) = (
            row.words.get_mut(column as usize..),
            row.depths.get_mut(column as usize..),
        );
        let layers = layers.get_mut((column - left) as usize..(end - left) as usize);
        let (Some(words), Some(depths), Some(layers)) = (words, depths, layers) else {
            return found;
        };
        let (mut values, mut depth) = (run.values, face.plane.at(column, row.y));
        for (((layer, word), stored), x) in layers.iter_mut().zip(words).zip(depths).zip(column..) {
            let stored_depth = D::from_interpolated(depth.0);
            let fragment = || F::fragment(&skin, face.word, &values);
            if MIX {
                if layer.depth == stored_depth && layer.next == order {
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
            } else if layer.is_in_front(*stored, stored_depth, order) && (!H::Attributes::VARY || fragment().is_some())
            {
                found |= layer.offer(stored_depth, order);
            }
            H::Attributes::step(&mut values, &run.per_column);
            depth += face.plane.per_column;
        }
        column = end;
    }
    found
}
