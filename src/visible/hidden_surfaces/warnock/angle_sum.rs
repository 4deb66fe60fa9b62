//! How a face lies to a window, by the sum of the angles in which its edges are seen from a corner of the window.
//!
//! ```text
//!      2 | 3            No edge of the face meets the window. Someone in its first pixel who looks along the outline of the face turns
//!     ---+---           by a whole turn if the face is around, and by none if it is not. Turns are counted in quadrants: an edge
//!      1 | 0            goes on to the next quadrant, stays, goes back, or crosses to the opposite one, on the side that the
//!                       line equation tells.
//! ```
//!
//! The sum is exact: quadrants are whole numbers, and no angle is computed. Cost: up to twelve line equations of two products to
//! find that no edge meets the window, and one for each edge between opposite quadrants.
//!
//! Source: the angle test, Rogers 1985, section 4-4; by quadrants, Weiler 1994, "An Incremental Angle Point in Polygon Test".

use crate::{
    view::Position,
    visible::hidden_surfaces::warnock::window_test::{CenterRectangle, FaceCorners, Relation, WindowTest, side_of},
};

/// The test by the sum of angles.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AngleSum;

impl WindowTest for AngleSum {
    fn relation(face: &FaceCorners, window: &CenterRectangle) -> Relation {
        if face.any_edge_meets(window) {
            return Relation::Intersecting;
        }
        let viewer = window.first();
        let sum: i32 = face.edges().into_iter().map(|edge| turn(edge, viewer)).sum();
        if sum == 0 {
            Relation::Separate
        } else {
            Relation::Surrounding
        }
    }
}

/// By how many quadrants a viewer turns who follows an edge: positive clockwise on the screen, at most two.
fn turn(edge: [Position; 2], viewer: Position) -> i32 {
    let [from, to] = edge.map(|corner| quadrant(corner, viewer));
    match (to - from) & 3 {
        2 if side_of(edge, viewer) < 0 => -2,
        3 => -1,
        quadrants => quadrants,
    }
}

/// The quadrant in which a corner is seen, clockwise on the screen from right and below.
fn quadrant(corner: Position, viewer: Position) -> i32 {
    match (corner.x >= viewer.x, corner.y >= viewer.y) {
        (true, true) => 0,
        (false, true) => 1,
        (false, false) => 2,
        (true, false) => 3,
    }
}
