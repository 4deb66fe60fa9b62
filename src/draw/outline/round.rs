//! Writing an outline of arcs into words: their parameters instead of their corners.
//!
//! ```text
//!     header | 2 arcs, 7 words each | chain: 9 corners, down | from corner 0 | chain: .. | from corner ..
//! ```
//!
//! The corners between two turns of an arc, top or bottom of its ellipse or its ends, are in monotone order in y: chains are
//! found from the turns alone, and no other corner is computed before the row comes in which its edge begins. Corners side by
//! side may have the same y; edges without a height are passed over when the chain is drawn.
//!
//! Guarantees: the edges are those of the outline. Cost: about ten corners for each arc.

use crate::{
    coverage::{
        AnyCoverage,
        edges::{Y_BITS, Y_ONE},
    },
    draw::{
        FillRule,
        antialiased::{ARC_WORDS, Axis, OutlineArc, RoundContour, RoundOutline},
        outline::{
            chain_rows::ChainRows,
            links::{Stored, bounds, neighbours, set_header, set_next},
            stored::{Corner, Corners, HEADER_WORDS, Header, NONE},
        },
        payload::Payload,
    },
};

/// Words of a chain.
const CHAIN_WORDS: usize = 2;

/// Whether an outline is kept as arcs: where that takes less memory than its corners, and the largest arc has a radius of 12
/// pixels or more. Smaller ones pass so many corners in a row that computing them would take longer than the rest.
pub(super) fn is_kept_as_arcs(outline: &RoundOutline) -> bool {
    /// The chords that a quarter of a turn has with that radius.
    const LEAST_CHORDS: u16 = 16;
    let arcs = || {
        let contours = (0..outline.contours()).filter_map(|number| outline.contour(number));
        contours.flat_map(RoundContour::arcs)
    };
    let corners: usize = arcs().map(|arc| usize::from(arc.corners())).sum();
    let takes_less = arcs().count() * (ARC_WORDS + CHAIN_WORDS) < corners;
    takes_less && arcs().any(|arc| arc.chords_of_quarter() >= LEAST_CHORDS)
}

/// Writes an outline of arcs into words, with a fill rule. Of an ellipse that is mirrored only the left half is written.
pub(super) fn store(
    outline: &RoundOutline,
    is_mirrored: bool,
    fill_rule: FillRule,
    payload: &mut Payload<'_>,
) -> Stored {
    let start = payload.needed();
    for _ in 0..HEADER_WORDS {
        payload.push(0);
    }
    let mut first = 0;
    let mut counts = [0; 2];
    for (number, count) in counts.iter_mut().enumerate() {
        let Some(contour) = outline.contour(number) else { break };
        *count = contour.arcs().len() as i32;
        let mut position = first;
        for arc in contour.arcs() {
            payload.push_all(&arc.to_words(position));
            position += arc.corners();
        }
        first += contour.corners() + 1;
    }
    let mut writer = Writer {
        payload,
        start,
        header: Header {
            words: 0,
            corners: Corners::Round,
            fill_rule,
            method: AnyCoverage::SignedArea,
            is_mirrored,
            first_chain: NONE,
            most_chains: 0,
            origin: counts,
        },
        rows: ChainRows::NONE,
        open: None,
    };
    let (mut first, mut least, mut most) = (0, [i32::MAX; 2], [i32::MIN; 2]);
    for contour in (0..outline.contours()).filter_map(|number| outline.contour(number)) {
        writer.add_contour(contour, first);
        first += contour.corners() + 1;
        for axis in [Axis::X, Axis::Y] {
            turns_of(contour, axis, &mut |_, [x, y], _| {
                (least, most) = ([x.min(least[0]), y.min(least[1])], [x.max(most[0]), y.max(most[1])]);
            });
        }
    }
    writer.header.words = writer.payload.needed() - start;
    let [most_chains, most_edges] = writer.rows.most();
    writer.header.most_chains = u16::try_from(most_chains).unwrap_or(u16::MAX);
    set_header(writer.payload, start, writer.header);
    Stored {
        bounds: bounds(least, most),
        // A mirrored row is made from the parts of edges themselves.
        segments: if is_mirrored { 0 } else { most_edges },
    }
}

/// Calls with the index of each corner of a contour at which it may turn back along an axis, with that corner, and with the
/// arc that has it and the corner before it, if that is one arc.
fn turns_of(contour: &RoundContour, axis: Axis, call: &mut dyn FnMut(u16, Corner, Option<&OutlineArc>)) {
    let mut first = 0;
    for arc in contour.arcs() {
        arc.turns(axis, &mut |index| {
            call(first + index, arc.corner(index), (index > 0).then_some(arc));
        });
        first += arc.corners();
    }
    // Once more the first corner, which ends the last edge.
    if let Some(arc) = contour.arcs().first() {
        let whole = Some(arc).filter(|arc| arc.corners() > 1 && contour.arcs().len() == 1);
        call(first, arc.corner(0), whole);
    }
}

/// A chain whose last corner is not known yet.
struct OpenChain {
    /// The positions of its first corner in the outline's order, and of the last one so far.
    positions: [u16; 2],
    /// The y of these two.
    ends: [i32; 2],
}

struct Writer<'p, 'm> {
    payload: &'p mut Payload<'m>,
    /// Where the outline's words begin.
    start: usize,
    header: Header,
    rows: ChainRows,
    open: Option<OpenChain>,
}

impl Writer<'_, '_> {
    /// Writes the chains of a contour whose first corner has that position.
    fn add_contour(&mut self, contour: &RoundContour, first: u16) {
        let mut before: Option<(u16, i32)> = None;
        turns_of(contour, Axis::Y, &mut |index, [_, y], arc| {
            if let Some((start, start_y)) = before {
                self.add_part([first + start, first + index], [start_y, y], arc);
            }
            before = Some((index, y));
        });
        self.close_chain();
    }

    /// Adds a part that is monotone in y, from one position to another, to the open chain or to one of its own.
    fn add_part(&mut self, [from, to]: [u16; 2], [from_y, to_y]: [i32; 2], arc: Option<&OutlineArc>) {
        // An ellipse runs down along its right half.
        let is_right_half = self.header.is_mirrored && from_y < to_y;
        if from_y == to_y || is_right_half {
            self.close_chain();
            return;
        }
        self.count_edges(to - from, [from_y, to_y], arc);
        match &mut self.open {
            Some(OpenChain { positions, ends }) if (ends[0] < ends[1]) == (from_y < to_y) => {
                (positions[1], ends[1]) = (to, to_y);
            }
            _ => {
                self.close_chain();
                self.open = Some(OpenChain {
                    positions: [from, to],
                    ends: [from_y, to_y],
                });
            }
        }
    }

    /// Counts the edges that the rows of a part have at most: more near the top and the bottom of its ellipse.
    fn count_edges(&mut self, edges: u16, ends: [i32; 2], arc: Option<&OutlineArc>) {
        let rows = rows_between(ends);
        let (Some(arc), true) = (arc, edges > 1) else {
            return self.rows.push(rows, 0, edges.into());
        };
        let [near, elsewhere] = arc.most_edges_in_a_row(edges);
        let whole = rows_between(arc.ends_in_y());
        // Two pixels and the row in which they end.
        let (top, bottom) = (whole.start + 3, whole.end - 3);
        for (part, most) in [
            (rows.start..rows.end.min(top), near),
            (rows.start.max(top)..rows.end.min(bottom), elsewhere),
            (rows.start.max(top).max(bottom)..rows.end, near),
        ] {
            if !part.is_empty() {
                self.rows.push(part, 0, most.into());
            }
        }
    }

    /// Writes the open chain, and links it.
    fn close_chain(&mut self) {
        let Some(OpenChain {
            positions: [from, to],
            ends,
        }) = self.open.take()
        else {
            return;
        };
        self.rows.push(rows_between(ends), 1, 0);
        let position = self.payload.needed() - self.start;
        let runs_up = ends[1] < ends[0];
        let length = u32::from(to - from + 1) << 17 | u32::from(runs_up) << 16;
        self.payload.push(length | u32::from(NONE));
        self.payload.push(from.into());
        // What finds no room is only counted.
        if !self.payload.is_complete() {
            return;
        }
        set_header(self.payload, self.start, self.header);
        let position = position as u16;
        let (before, next) = neighbours(self.payload, self.start, position, self.header.first_chain);
        let word = self.start + usize::from(position);
        self.payload.set(word, length | u32::from(next));
        match before {
            NONE => self.header.first_chain = position,
            before => set_next(self.payload, self.start + usize::from(before), position),
        }
    }
}

/// The rows of pixels in which edges between two y lie, in 1/256 pixel from the centre of pixel (0, 0).
fn rows_between([one, other]: [i32; 2]) -> core::ops::Range<i32> {
    let (top, bottom) = (one.min(other) + Y_ONE / 2, one.max(other) + Y_ONE / 2);
    top >> Y_BITS..(bottom + Y_ONE - 1) >> Y_BITS
}
