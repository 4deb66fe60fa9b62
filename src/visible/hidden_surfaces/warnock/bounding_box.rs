//! How a face lies to a window, by its bounding box first.
//!
//! ```text
//!     +------+   +------+         +-------------+             Boxes that do not meet: the face is separate. A box in the window:
//!     | .  . |   |  /\  |         | .  .  .  .  |             the face is contained. Only for what is left, the equations of
//!     | .  . |   | /__\ |         | . +----+ .  |             the edges are asked.
//!     +------+   +------+         | . |_/\_| .  |
//!      window       face          +-------------+
//! ```
//!
//! Cost: four comparisons for most faces of a window's list, because most of them are separate from three of its quarters; else
//! that of the line equations.
//!
//! Source: Warnock 1969; Rogers 1985, section 4-4.

use crate::visible::hidden_surfaces::warnock::{
    line_equations::LineEquations,
    window_test::{CenterRectangle, FaceCorners, Relation, WindowTest},
};

/// The test by bounding boxes, then by line equations.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BoundingBox;

impl WindowTest for BoundingBox {
    #[inline]
    fn relation(face: &FaceCorners, window: &CenterRectangle) -> Relation {
        let [a, b, c] = face.0;
        let (left, right) = (a.x.min(b.x).min(c.x), a.x.max(b.x).max(c.x));
        let (top, bottom) = (a.y.min(b.y).min(c.y), a.y.max(b.y).max(c.y));
        if right < window.left || left > window.right || bottom < window.top || top > window.bottom {
            return Relation::Separate;
        }
        let is_contained = window.left <= left && right <= window.right && window.top <= top && bottom <= window.bottom;
        if is_contained {
            return Relation::Intersecting;
        }
        LineEquations::relation(face, window)
    }
}
