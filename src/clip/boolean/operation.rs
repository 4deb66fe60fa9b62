//! The boolean operations on two polygons: which regions of the plane each one keeps.

use crate::clip::boolean::vertices::Polygons;

/// A boolean operation on a subject polygon and a clip polygon.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Operation {
    /// Keeps the region inside both polygons.
    Intersection,
    /// Keeps the region inside at least one of the polygons.
    Union,
    /// Keeps the region inside the subject polygon and outside the clip polygon.
    Difference,
}

impl Operation {
    pub(crate) const fn keeps(self, inside: Polygons) -> bool {
        let (subject, clip) = (inside.contains(Polygons::SUBJECT), inside.contains(Polygons::CLIP));
        match self {
            Self::Intersection => subject && clip,
            Self::Union => subject || clip,
            Self::Difference => subject && !clip,
        }
    }
}
