//! How a face lies to a window, by the codes of the regions around the window in which its corners are.
//!
//! ```text
//!      5 |   6    | 7        No edge of the face meets the window. Its sides, made longer, divide the plane into eight regions around
//!     ---+--------+---       it. Along the outline of the face, the differences of the codes are added, each taken the short way
//!      4 | window | 0        around: 8 more or less where it is greater than 4 in size. The sum is 0 for a face that is separate,
//!     ---+--------+---       and 8 or -8 for one that surrounds the window.
//!      3 |   2    | 1
//! ```
//!
//! Between opposite regions both ways are as short. The edge passes the window on one side, which its line equation tells; textbooks
//! divide the edge at a side of the window instead.
//!
//! Cost: up to twelve line equations of two products to find that no edge meets the window, and one for each edge between
//! opposite regions.
//!
//! Source: Rogers 1985, section 4-4.

use crate::{
    view::Position,
    visible::hidden_surfaces::warnock::window_test::{CenterRectangle, FaceCorners, Relation, WindowTest, side_of},
};

/// The test by the codes of regions around the window.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RegionCodes;

impl WindowTest for RegionCodes {
    fn relation(face: &FaceCorners, window: &CenterRectangle) -> Relation {
        if face.any_edge_meets(window) {
            return Relation::Intersecting;
        }
        let sum: i32 = face.edges().into_iter().map(|edge| difference(edge, window)).sum();
        if sum == 0 {
            Relation::Separate
        } else {
            Relation::Surrounding
        }
    }
}

/// The difference of the codes of an edge's ends, the short way around the window: positive clockwise on the screen.
fn difference(edge: [Position; 2], window: &CenterRectangle) -> i32 {
    let [start, end] = edge.map(|corner| region_code(corner, window));
    match (end - start) & 7 {
        4 if side_of(edge, window.first()) < 0 => -4,
        regions @ 5..=7 => regions - 8,
        regions => regions,
    }
}

/// The code of the region in which a corner is, clockwise on the screen from the right. No corner is in the window.
fn region_code(corner: Position, window: &CenterRectangle) -> i32 {
    let beyond = |value: i32, first: i32, last: i32| i32::from(value > last) - i32::from(value < first);
    let right = beyond(corner.x, window.left, window.right);
    let below = beyond(corner.y, window.top, window.bottom);
    match (right, below) {
        (1, 0) => 0,
        (1, 1) => 1,
        (0, 1) => 2,
        (-1, 1) => 3,
        (-1, 0) => 4,
        (-1, -1) => 5,
        (0, -1) => 6,
        _ => 7,
    }
}
