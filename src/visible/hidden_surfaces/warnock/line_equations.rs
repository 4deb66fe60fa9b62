//! How a face lies to a window, by the line equations of its edges at the corners of the window.
//!
//! ```text
//!        \ edge              Each edge divides the plane; the corner pixels of the window are put into the equations of the three
//!     +---\------+           lines. All corners on the inner side of all edges: the face surrounds the window, because it is convex.
//!     |    \  +  |           All corners on the outer side of one edge: the face is separate. A window beyond a corner of the face
//!     |  -  \    |           is on the outer side of none, but no edge meets it.
//!     +------\---+
//! ```
//!
//! What is inside and outside follows the top-left rule, so that a face which touches outer pixel centres is known, too. Cost: up to
//! twelve line equations of two products, and up to twelve more for windows beyond a corner.
//!
//! Source: Foley, van Dam and others 1990, section 15.7.1; Rogers 1985, section 4-4.

use crate::{
    view::Position,
    visible::hidden_surfaces::warnock::window_test::{CenterRectangle, FaceCorners, Relation, WindowTest, side_of},
};

/// The test by the line equations of edges at the corners of the window.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LineEquations;

impl WindowTest for LineEquations {
    fn relation(face: &FaceCorners, window: &CenterRectangle) -> Relation {
        let points = window.corners();
        let mut surrounds = true;
        for edge in face.edges() {
            let inside = points.iter().filter(|point| is_inside(edge, **point)).count();
            if inside == 0 {
                return Relation::Separate;
            }
            surrounds &= inside == points.len();
        }
        if surrounds {
            Relation::Surrounding
        } else if face.any_edge_meets(window) {
            Relation::Intersecting
        } else {
            Relation::Separate
        }
    }
}

/// Whether a pixel centre is on the inner side of an edge, or on a top or left edge.
fn is_inside(edge: [Position; 2], point: Position) -> bool {
    let [start, end] = edge;
    let side = side_of(edge, point);
    // Up, or level and to the right.
    let is_top_or_left = end.y < start.y || (end.y == start.y && end.x > start.x);
    side > 0 || (side == 0 && is_top_or_left)
}
