//! What is left of a segment in space: exact fractions of it, rounded once when its ends are asked for.

use crate::clip::space::{clip_matrix::ClipMatrix, clip_point::ClipPoint, fraction::Fraction};

/// A part of a segment between two vertices of a model: the vertices, and between which exact fractions of the way.
///
/// Nothing is rounded until the ends are asked for, so that a part can be clipped again, and an attribute of the vertices can
/// be cut by the same fraction. It equals another part where it is the same part of the same segment.
///
/// RAM: 64 bytes.
#[derive(Debug, Copy, Clone)]
pub struct SpaceSegment {
    pub(super) from: [i16; 3],
    pub(super) to: [i16; 3],
    pub(super) entry: Option<Fraction>,
    pub(super) exit: Option<Fraction>,
}

impl SpaceSegment {
    /// The whole segment.
    pub(super) const fn whole(from: [i16; 3], to: [i16; 3]) -> Self {
        Self {
            from,
            to,
            entry: None,
            exit: None,
        }
    }

    /// The two ends in clip coordinates: each coordinate is the exact one, rounded once to the nearest unit, ties to the larger
    /// number. The segment in the other direction has the same ends. What is divided by w has to be in front of the eye.
    ///
    /// Cost: for each coordinate of an end that is cut a division, by a step for each bit.
    pub fn ends(&self, matrix: &ClipMatrix) -> (ClipPoint, ClipPoint) {
        let (from, to) = (matrix.apply(self.from), matrix.apply(self.to));
        let end = |cut: Option<Fraction>, whole: ClipPoint| {
            cut.map_or(whole, |cut| ClipPoint {
                x: cut.between(from.x, to.x),
                y: cut.between(from.y, to.y),
                z: cut.between(from.z, to.z),
                w: cut.between(from.w, to.w),
            })
        };
        (end(self.entry, from), end(self.exit, to))
    }

    /// An attribute at the two ends, such as a brightness, that changes evenly between the vertices from one number to the
    /// other: cut by the same fraction as the positions, rounded once to the nearest, ties to the larger number.
    pub fn attribute(&self, from: i32, to: i32) -> (i32, i32) {
        let end = |cut: Option<Fraction>, whole: i32| {
            // Between two numbers of 32 bits.
            cut.map_or(whole, |cut| cut.between(from.into(), to.into()) as i32)
        };
        (end(self.entry, from), end(self.exit, to))
    }

    /// The two ends in the space of the vertices, in whole units of it, as [`attribute`](Self::attribute) rounds.
    pub fn vertices(&self) -> ([i16; 3], [i16; 3]) {
        let ([x0, y0, z0], [x1, y1, z1]) = (self.from, self.to);
        let axes = [(x0, x1), (y0, y1), (z0, z1)].map(|(from, to)| self.attribute(from.into(), to.into()));
        // Between two vertices.
        (axes.map(|(from, _)| from as i16), axes.map(|(_, to)| to as i16))
    }
}

impl PartialEq for SpaceSegment {
    fn eq(&self, other: &Self) -> bool {
        let is_same = |one: &Option<Fraction>, other: &Option<Fraction>| match (one, other) {
            (Some(one), Some(other)) => one.compare(other).is_eq(),
            (None, None) => true,
            _ => false,
        };
        let has_same_ends = self.from == other.from && self.to == other.to;
        has_same_ends && is_same(&self.entry, &other.entry) && is_same(&self.exit, &other.exit)
    }
}

impl Eq for SpaceSegment {}

#[cfg(feature = "defmt")]
impl defmt::Format for SpaceSegment {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        let (from, to) = self.vertices();
        defmt::write!(formatter, "SpaceSegment {} to {}", from, to);
    }
}
