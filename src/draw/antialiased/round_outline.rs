//! Outlines of elliptical arcs and straight lines, kept as parameters: any corner is computed by its index.
//!
//! A contour is a ring of arcs, each joined to the next one by a straight line; a corner without a curve is an arc with
//! radii of 0:
//!
//! ```text
//!     arc 0      arc 1            circle            1 arc of a whole turn
//!     .-------------.             sector            1 arc, and the point at its tip
//!    /               \            band of an arc    1 arc, and a shorter one backwards
//!   |                 |           rounded corners   4 arcs
//!    \               /            ring              2 contours, the inner one backwards
//!     '-------------'
//!     arc 3      arc 2
//! ```

use crate::{
    draw::antialiased::{
        outline_arc::{Corner, OutlineArc, TOP, WidePosition},
        turn::TURN,
    },
    geometry::InputError,
};

/// A closed contour of up to four arcs.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RoundContour {
    arcs: [OutlineArc; 4],
    /// How many of the arcs there are.
    count: usize,
}

impl RoundContour {
    /// A contour of these arcs, each joined to the next one by a straight line; those after the fourth are left out.
    pub(crate) fn new(arcs: &[OutlineArc]) -> Self {
        let mut contour = Self::default();
        for (slot, arc) in contour.arcs.iter_mut().zip(arcs) {
            *slot = *arc;
            contour.count += 1;
        }
        contour
    }

    /// The ellipse in a box.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where it leaves the domain of [`Sub8`].
    pub(crate) fn ellipse(center: WidePosition, radii: [i64; 2]) -> Result<Self, InputError> {
        // From the top on, so that the contour has two chains in y.
        Ok(Self::new(&[OutlineArc::new(center, radii, (TOP, TURN))?]))
    }

    /// Calls `edge` with the edges of an ellipse, computed faster than corner by corner, with `left_half` only those left of
    /// its centre. Returns `false`, and does nothing, for other contours, and for large ellipses.
    pub(super) fn mirrored_edges(&self, left_half: bool, edge: &mut dyn FnMut(Corner, Corner)) -> bool {
        matches!(self.arcs(), [ellipse] if ellipse.mirrored_edges(left_half, edge))
    }

    /// The contour in the opposite direction, for a hole.
    #[must_use]
    pub(crate) fn reversed(self) -> Self {
        let mut contour = Self {
            arcs: self.arcs.map(OutlineArc::reversed),
            ..self
        };
        contour.arcs.get_mut(..self.count).unwrap_or_default().reverse();
        contour
    }

    pub(crate) fn arcs(&self) -> &[OutlineArc] {
        self.arcs.get(..self.count).unwrap_or_default()
    }

    pub(crate) fn corners(&self) -> u16 {
        self.arcs().iter().map(OutlineArc::corners).sum()
    }

    pub(super) fn corner(&self, index: u16) -> Corner {
        let mut rest = index;
        for arc in self.arcs() {
            let corners = arc.corners();
            if rest < corners {
                return arc.corner(rest);
            }
            rest -= corners;
        }
        Corner::default()
    }
}

/// One contour of arcs, or an outer one and an inner one in the opposite direction.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RoundOutline {
    outer: RoundContour,
    inner: Option<RoundContour>,
}

impl RoundOutline {
    /// The inside of a contour.
    pub(crate) const fn new(outer: RoundContour) -> Self {
        Self { outer, inner: None }
    }

    /// What lies between two contours, the inner one inside the outer one.
    pub(crate) fn ring(outer: RoundContour, inner: Option<RoundContour>) -> Self {
        Self {
            outer,
            inner: inner.map(RoundContour::reversed),
        }
    }

    /// The sum of a column and its mirror image about the vertical axis of an ellipse without a hole, where the axis lies in
    /// the middle or at a side of pixels.
    pub(super) fn mirror_of_ellipse(&self) -> Option<i32> {
        match (self.outer.arcs(), &self.inner) {
            ([ellipse], None) => ellipse.mirror(),
            _ => None,
        }
    }

    /// The number of contours.
    pub(crate) const fn contours(&self) -> usize {
        if self.inner.is_some() { 2 } else { 1 }
    }

    /// The number of corners of a contour.
    pub(crate) fn corners(&self, contour: usize) -> u16 {
        self.contour(contour).map_or(0, RoundContour::corners)
    }

    /// A corner of a contour by its index, in 1/256 pixel. Those in the order of their indices are the contour.
    pub(crate) fn corner(&self, contour: usize, index: u16) -> Corner {
        self.contour(contour)
            .map_or(Corner::default(), |contour| contour.corner(index))
    }

    pub(crate) fn contour(&self, contour: usize) -> Option<&RoundContour> {
        match contour {
            0 => Some(&self.outer),
            1 => self.inner.as_ref(),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::vec::Vec;

    use super::*;

    #[test]
    fn a_hole_has_the_corners_of_its_contour_in_the_opposite_order() {
        let arc = |center: WidePosition, start: i32| OutlineArc::new(center, [900, 500], (start, TURN / 4)).unwrap();
        let contour = RoundContour::new(&[arc([0, 0], 0), arc([-70, 0], TURN / 4), arc([5, -900], TURN / 2)]);
        let outline = RoundOutline::ring(contour, Some(contour));
        let corners = |number: usize| (0..outline.corners(number)).map(move |index| (number, index));
        let [outer, inner] =
            [0, 1].map(|number| corners(number).map(|(c, i)| outline.corner(c, i)).collect::<Vec<_>>());
        assert!(
            outer.iter().eq(inner.iter().rev()) && outer.len() == 30,
            "{outer:?}, {inner:?}"
        );
    }
}
