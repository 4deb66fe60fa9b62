//! A line that is tested, and how far it is hidden from a point on.

use crate::visible::hidden_lines::{
    line_part::PartKind,
    line_table::{LineFace, LinePoint},
    parts::PartedLine,
};

/// A line that is tested against all solids: an edge, or a new one where two faces penetrate.
pub(super) struct TestedLine {
    pub(super) line: PartedLine,
    /// The models on whose surface the line is, so that they do not hide it if they are convex.
    pub(super) models: [usize; 2],
    /// The indices of the faces that the line lies in, which do not hide it.
    pub(super) faces: [usize; 2],
}

impl TestedLine {
    /// A new edge where two faces penetrate each other.
    pub(super) fn between(faces: [&LineFace; 2], ends: [LinePoint; 2]) -> Self {
        let [first, _] = faces;
        Self {
            line: PartedLine {
                model: first.model,
                edge: None,
                ends,
                kind: PartKind::Intersection,
            },
            models: faces.map(|face| face.model),
            faces: faces.map(|face| face.index),
        }
    }
}

/// How far a line is hidden from a parameter on.
pub(super) struct Covered {
    /// Where what hides the line at the parameter ends; the parameter itself where nothing does.
    pub(super) until: u32,
    /// Where the first interval begins that does so after the parameter.
    pub(super) next: u32,
}

impl Covered {
    /// Takes in one more interval that is hidden.
    pub(super) fn with(&mut self, [start, end]: [u32; 2], at: u32) {
        if start > at {
            self.next = self.next.min(start);
        } else {
            self.until = self.until.max(end);
        }
    }
}
