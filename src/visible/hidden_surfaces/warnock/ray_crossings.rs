//! How a face lies to a window, by a ray from a corner of the window.
//!
//! ```text
//!             /\                 No edge of the face meets the window, so that either all of it is in the face or nothing. A ray from
//!     . .    /  \                its first pixel to the right crosses the outline an odd number of times from inside the face, and
//!     .------|---\---->  2       an even number of times from outside.
//!     . .   /_____\
//! ```
//!
//! An edge is crossed if one of its ends lies above the ray and the other one does not: a corner on the ray is crossed once, or
//! twice at a tip, and a level edge never.
//!
//! Cost: up to twelve line equations of two products to find that no edge meets the window, and two for the ray.
//!
//! Source: Shimrat 1962, "Algorithm 112: Position of Point Relative to Polygon"; for windows, Rogers 1985, section 4-4.

use crate::{
    view::Position,
    visible::hidden_surfaces::warnock::window_test::{CenterRectangle, FaceCorners, Relation, WindowTest, side_of},
};

/// The test by the crossings of a ray.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RayCrossings;

impl WindowTest for RayCrossings {
    fn relation(face: &FaceCorners, window: &CenterRectangle) -> Relation {
        if face.any_edge_meets(window) {
            return Relation::Intersecting;
        }
        let origin = window.first();
        let is_crossed = |edge: &[Position; 2]| {
            let [start, end] = *edge;
            let goes_up = end.y < start.y;
            // Right of the origin is an edge that goes down and has it on the inner side, which is on the left; and the other way
            // round.
            (start.y < origin.y) != (end.y < origin.y) && (side_of(*edge, origin) > 0) != goes_up
        };
        if face.edges().iter().filter(|edge| is_crossed(edge)).count() % 2 == 1 {
            Relation::Surrounding
        } else {
            Relation::Separate
        }
    }
}
