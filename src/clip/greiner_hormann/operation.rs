//! What to make of two polygons, as a question about each place: is it kept?

use crate::clip::greiner_hormann::vertices::Polygons;

/// What to make of the two polygons.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Operation {
    /// What is inside both.
    Intersection,
    /// What is inside either.
    Union,
    /// What is inside the subject and outside the other one.
    Difference,
}

impl Operation {
    pub(super) const fn keeps(self, inside: Polygons) -> bool {
        let (subject, clip) = (inside.contains(Polygons::SUBJECT), inside.contains(Polygons::CLIP));
        match self {
            Self::Intersection => subject && clip,
            Self::Union => subject || clip,
            Self::Difference => subject && !clip,
        }
    }
}
