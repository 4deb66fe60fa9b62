//! The planes of a convex solid on the screen: of its faces, and through the eye and its silhouette edges.

use crate::{
    view::DepthWidth,
    visible::hidden_lines::{hiding::tolerance, line_table::LinePoint},
};

/// Bits of the coefficients of a plane.
const BITS: u32 = 30;

/// A half-space: a linear function of x, y and depth that is not below 0 at its points.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Plane {
    /// Of x, y and depth: at most 2^30 in size.
    coefficients: [i32; 3],
    /// Below 2^57.
    constant: i64,
}

impl Plane {
    pub(super) const ZERO: Self = Self {
        coefficients: [0; 3],
        constant: 0,
    };

    /// All that lies behind a face whose corners run clockwise on the screen; `None` where they do not.
    pub(super) fn behind([a, b, c]: [LinePoint; 3]) -> Option<Self> {
        let way = |to: LinePoint| [to.x - a.x, to.y - a.y, to.depth - a.depth].map(i64::from);
        let ([x, y, z], [u, v, w]) = (way(b), way(c));
        // Differences of positions are below 2^22, of depths below 2^24: below 2^47.
        let (across, down, area) = (z * v - w * y, x * w - u * z, x * v - u * y);
        if area <= 0 {
            return None;
        }
        let greatest = across.unsigned_abs().max(down.unsigned_abs()).max(area.unsigned_abs());
        let shift = (u64::BITS - greatest.leading_zeros()).saturating_sub(BITS);
        let half = (1i64 << shift) / 2;
        let coefficients = [across, down, -area].map(|coefficient| ((coefficient + half) >> shift) as i32);
        Some(Self::through(a, coefficients))
    }

    /// All that lies, as seen, to the right of a line on which one walks clockwise around a solid.
    pub(super) fn beside([from, to]: [LinePoint; 2]) -> Self {
        Self::through(from, [from.y - to.y, to.x - from.x, 0])
    }

    fn through(point: LinePoint, coefficients: [i32; 3]) -> Self {
        let through_origin = Self {
            coefficients,
            constant: 0,
        };
        Self {
            coefficients,
            constant: -through_origin.at(point),
        }
    }

    /// How far inside a point is, in units times coefficients: below 2^57 in size, below 0 outside.
    pub(super) fn at(&self, point: LinePoint) -> i64 {
        let ([a, b, c], [x, y, z]) = (
            self.coefficients.map(i64::from),
            [point.x, point.y, point.depth].map(i64::from),
        );
        a * x + b * y + c * z + self.constant
    }

    /// What a move by one unit of position along both axes, and by the units of depth of the tolerance that faces hide with,
    /// changes at most.
    pub(super) fn tolerance<D: DepthWidth>(&self) -> i64 {
        let [a, b, c] = self.coefficients.map(|coefficient| i64::from(coefficient).abs());
        a + b + c * tolerance::<D>()
    }

    /// The half-space of what lies farther behind the plane than by the tolerance.
    pub(super) fn set_back<D: DepthWidth>(self) -> Self {
        Self {
            // By one more at least.
            constant: self.constant - self.tolerance::<D>() - 1,
            ..self
        }
    }
}
