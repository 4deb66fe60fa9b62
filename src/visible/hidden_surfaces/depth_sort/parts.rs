//! Paints faces and parts of faces.

use core::ops::Range;

use crate::{
    shade::Shading,
    view::{DepthWidth, ScreenPrecision},
    visible::{face_table::FaceTable, hidden_surfaces::placed::face_from_row, painter::Painter},
};

use super::{
    others::{InRow, Others},
    pairs::Relation,
    sort::Sort,
    waiting::PartConditions,
};

/// Entries of the list, and how many of them are in front of those that are painted.
type Layer<'e> = (&'e Range<usize>, usize);

impl<S, D, H, F> Sort<'_, S, D, H, F>
where
    S: ScreenPrecision,
    D: DepthWidth,
    H: Shading,
    F: FaceTable<S, D, H>,
{
    /// Paints entries that begin with the first one, each where it is not behind another one of them, and takes them out of
    /// the list. Where something may be seen through them or beside their silhouettes, those behind others are painted before.
    pub(super) fn paint(&mut self, entries: Range<usize>, painter: &mut impl Painter<S, H>) {
        let is_seen_through = H::BLENDS || H::HAS_HOLES || F::ANTIALIASES;
        let layers = if is_seen_through { entries.len() } else { 1 };
        for layer in (0..layers).rev() {
            for entry in entries.clone() {
                if entries.len() == 1 && !self.waiting.is_part(entry) {
                    self.paint_whole(entry, painter);
                } else {
                    self.paint_part(entry, (&entries, layer), painter);
                }
            }
        }
        self.waiting.remove(entries);
    }

    /// Paints a whole face.
    fn paint_whole(&mut self, entry: usize, painter: &mut impl Painter<S, H>) {
        self.for_each_row(entry, |_, (face, [start, end], row)| {
            if start < end {
                painter.span(face, row, [start, end]);
            }
        });
    }

    /// Paints an entry where its conditions hold and it is in a layer of some entries: that many other ones are in front of it.
    fn paint_part(&mut self, entry: usize, layer: Layer<'_>, painter: &mut impl Painter<S, H>) {
        let (mut others, conditions) = (Others::new(), self.waiting.conditions(entry));
        self.for_each_row(entry, |this, (face, [mut column, end], row)| {
            let mut start = column;
            while column < end {
                let (is_painted, until) = this.run((&conditions, layer), &mut others, (face, [column, end], row));
                if !is_painted {
                    if start < column {
                        painter.span(face, row, [start, column]);
                    }
                    start = until;
                }
                column = until;
            }
            if start < end {
                painter.span(face, row, [start, end]);
            }
        });
    }

    /// Visits the rows of a face that lie in the window, with the columns that do.
    fn for_each_row(&mut self, entry: usize, mut visit: impl FnMut(&mut Self, InRow<'_, S, H>)) {
        let window = self.window;
        let node = self.waiting.node(entry);
        let placed = node.and_then(|node| face_from_row(self.faces, node, [window.left, window.top]));
        let Some((mut face, first_row)) = placed else {
            return;
        };
        for row in first_row..window.bottom {
            let columns = face.span().map(|column| column.max(0).min(window.width() as i32));
            visit(self, (&face, columns, row));
            face.next_span();
            if !face.leave_row(row) {
                return;
            }
        }
    }

    /// Whether a face with conditions is painted at the first of some columns, in a layer of some entries, and the first column
    /// after it where that may be different.
    fn run(
        &mut self,
        (conditions, (entries, layer)): (&PartConditions, Layer<'_>),
        others: &mut Others,
        (face, [column, end], row): InRow<'_, S, H>,
    ) -> (bool, i32) {
        let (faces, window, waiting) = (self.faces, self.window, &self.waiting);
        let pixels = &mut self.counters.pixels_compared;
        let (holds, mut until) = others.conditions_hold(faces, window, conditions, (face, [column, end], row), pixels);
        if !holds {
            return (false, until);
        }
        let nodes = entries.clone().filter_map(|entry| waiting.node(entry));
        let mut in_front = 0;
        for node in nodes.filter(|node| *node != face.node) {
            let (relation, end) = others.relation(faces, window, node, (face, [column, end], row), pixels);
            if relation == Some(Relation::Behind) {
                in_front += 1;
                if in_front > layer {
                    // Of more than one, the first to end decides.
                    return (false, if layer == 0 { end } else { until.min(end) });
                }
            }
            until = until.min(end);
        }
        (in_front == layer, until)
    }
}
