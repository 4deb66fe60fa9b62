//! Cuts an edge into parts at parameters, and hands them over.

use crate::{
    geometry::SubPoint,
    view::ScreenPrecision,
    visible::hidden_lines::{
        line_part::{LinePart, PartKind},
        line_table::{LineEdge, LinePoint},
    },
};

/// Fractional bits of a parameter along an edge.
pub(super) const PARAMETER_BITS: u32 = 30;

/// The parameter of the second end of an edge; that of the first end is 0. An edge is less than 2^23 units long, so that a
/// rounded parameter is less than 1/128 unit off.
pub(super) const END: u32 = 1 << PARAMETER_BITS;

/// A line that is handed over in parts.
#[derive(Debug, Copy, Clone)]
pub(super) struct PartedLine {
    pub(super) model: usize,
    /// Index in the table of edges of the model; `None` for an intersection.
    pub(super) edge: Option<usize>,
    pub(super) ends: [LinePoint; 2],
    pub(super) kind: PartKind,
}

impl PartedLine {
    /// The line of an edge.
    pub(super) const fn of(edge: &LineEdge) -> Self {
        Self {
            model: edge.model,
            edge: Some(edge.edge),
            ends: edge.ends,
            kind: edge.part_kind(),
        }
    }
}

/// The parts of a line as they are found from its first to its second end. Neighbours of which both are hidden or both visible
/// are joined, and so is a part with its neighbour that is too short to have two ends on the screen.
#[derive(Debug)]
pub(super) struct Parts<'p, S: ScreenPrecision, F: FnMut(LinePart<S>)> {
    line: PartedLine,
    /// Where the part begins that was not handed over yet.
    start: SubPoint<S>,
    /// The end of what is known.
    end: SubPoint<S>,
    /// Whether the part that was not handed over yet is hidden.
    is_hidden: bool,
    part: &'p mut F,
}

impl<'p, S: ScreenPrecision, F: FnMut(LinePart<S>)> Parts<'p, S, F> {
    /// No part of a line is known.
    pub(super) fn new(line: PartedLine, part: &'p mut F) -> Self {
        let start = point_at(&line.ends, 0);
        Self {
            line,
            start,
            end: start,
            is_hidden: false,
            part,
        }
    }

    /// Says of the line up to a parameter, from where the last call ended, whether it is hidden. The last call has to be for
    /// [`END`].
    pub(super) fn until(&mut self, parameter: u32, is_hidden: bool) {
        let end = point_at(&self.line.ends, parameter);
        if end == self.end {
            return;
        }
        if is_hidden != self.is_hidden {
            self.hand_over();
            (self.start, self.is_hidden) = (self.end, is_hidden);
        }
        self.end = end;
    }

    /// Hands over the last part.
    pub(super) fn finish(mut self) {
        self.hand_over();
    }

    fn hand_over(&mut self) {
        if self.start == self.end {
            return;
        }
        let PartedLine { model, edge, kind, .. } = self.line;
        (self.part)(LinePart {
            model,
            edge,
            ends: [self.start, self.end],
            kind,
            is_hidden: self.is_hidden,
        });
    }
}

/// The point of a line at a parameter from 0 to [`END`] on the screen, to the nearest unit.
fn point_at<S: ScreenPrecision>(ends: &[LinePoint; 2], parameter: u32) -> SubPoint<S> {
    let LinePoint { x, y, .. } = at(ends, parameter);
    // Between two points of the domain.
    SubPoint::from_units(x, y).unwrap_or_default()
}

/// The point of a line at a parameter from 0 to [`END`], to the nearest units.
pub(super) fn at([from, to]: &[LinePoint; 2], parameter: u32) -> LinePoint {
    let between = |from: i32, to: i32| {
        // Differences below 2^25.
        let way = i64::from(to - from) * i64::from(parameter);
        from + ((way + i64::from(END / 2)) >> PARAMETER_BITS) as i32
    };
    LinePoint {
        x: between(from.x, to.x),
        y: between(from.y, to.y),
        depth: between(from.depth, to.depth),
    }
}
