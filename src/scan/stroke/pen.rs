//! What a stroke draws along a part of a segment: a rectangle as wide as the stroke, with caps at its ends.

use crate::{
    geometry::Window,
    scan::{
        polygon::ScanEdge,
        stroke::{
            DiscSide, LineCap,
            segment_dashes::StrokeEnds,
            stroke_edge::StrokeEdge,
            wide_stroke::{Corner, Offsets, Position, UNIT, each_side, narrow, negated},
        },
    },
};

/// Width and caps of a stroke.
#[derive(Copy, Clone)]
pub(crate) struct Pen {
    pub cap: LineCap,
    /// The distance from the middle of the stroke to a side, in units.
    pub half_width: i64,
}

impl Pen {
    /// Generates the edges of a polygon and of discs that reach the rows of a window: one after the other, so that those
    /// that cross a row are two of each.
    pub(crate) fn shape_edges(
        &self,
        corners: &[Corner],
        discs: [Option<Corner>; 2],
        window: &Window,
        sink: &mut dyn FnMut(StrokeEdge),
    ) {
        #[cfg(test)]
        let sink = &mut |edge| {
            crate::scan::stroke::work::step();
            sink(edge);
        };
        each_side(corners, window, &mut |side| sink(StrokeEdge::Straight(side)));
        for center in discs.into_iter().flatten() {
            for side in DiscSide::both(center, self.half_width as i32) {
                if side.first_row() < side.end_row() {
                    sink(StrokeEdge::Disc(side));
                }
            }
        }
    }

    /// The corners of the rectangle along a part of a segment, and the centres of its round caps.
    pub(crate) fn shape_of_part(
        &self,
        offsets: &Offsets,
        (from, to): (Position, Position),
        ends: StrokeEnds,
    ) -> ([Corner; 4], [Option<Corner>; 2]) {
        let (right, down) = self.cap.extension(offsets);
        let moved = |(x, y): Position, (right, down): Position| (x + right, y + down);
        let first = if ends.begins {
            moved(from, (-right, -down))
        } else {
            from
        };
        let last = if ends.ends { moved(to, (right, down)) } else { to };
        let normal = offsets.normal;
        let opposite = negated(normal);
        let disc = |center: Position, is_there: bool| {
            let is_there = is_there && self.cap == LineCap::Round;
            is_there.then(|| narrow(center))
        };
        let corners = [
            narrow(moved(first, normal)),
            narrow(moved(last, normal)),
            narrow(moved(last, opposite)),
            narrow(moved(first, opposite)),
        ];
        let discs = [
            disc(from, ends.begins),
            disc(to, ends.ends && !(ends.begins && from == to)),
        ];
        (corners, discs)
    }

    /// A distance from the path that no point of a rectangle or a cap reaches, in units.
    pub(crate) fn reach(&self) -> i64 {
        2 * self.half_width + UNIT
    }

    /// The distance from the end of a dash to the outermost point of its cap along the segment, in units.
    pub(crate) fn cap_reach(&self) -> i64 {
        self.cap.reach(self.half_width)
    }

    pub(crate) fn has_round_caps(&self) -> bool {
        self.cap == LineCap::Round
    }
}
