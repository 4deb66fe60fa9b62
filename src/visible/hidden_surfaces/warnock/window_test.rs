//! How a face lies to a window: the question that Warnock's algorithm asks of each window and each face of its list.
//!
//! ```text
//!     separate          surrounding          intersecting, or contained
//!                        ________ A
//!     .  .  .   /\       \ .  . /             .  .\ .             A window is the rectangle of its outer pixel centres: nothing
//!     .  .  .  /_A        \.  ./              .  . \.             but centres is seen. That of one row, one column or one pixel
//!     .  .  .              \  /               .__.__A             has no height, no width or neither.
//! ```
//!
//! Several tests answer it, all of them by exact integers. They agree where no edge of the face meets the rectangle: there, a face
//! that does not surround it is separate. Where an edge does, "intersecting" is always right, and a test may know better.

use crate::{
    geometry::Window,
    view::{Position, ScreenPrecision},
};

/// How a face lies to a window.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Relation {
    /// The face covers no pixel of the window.
    Separate,
    /// The face covers all pixels of the window.
    Surrounding,
    /// The face may cover some pixels of the window: an edge meets it, or the whole face lies in it.
    Intersecting,
}

/// The rectangle of the outer pixel centres of a window, in units of the screen. Its sides belong to it.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CenterRectangle {
    pub(super) left: i32,
    pub(super) top: i32,
    pub(super) right: i32,
    pub(super) bottom: i32,
}

impl CenterRectangle {
    /// The rectangle of a window, which has pixels.
    pub(super) fn of<S: ScreenPrecision>(window: &Window) -> Self {
        Self {
            left: window.left << S::FRACTION_BITS,
            top: window.top << S::FRACTION_BITS,
            right: (window.right - 1) << S::FRACTION_BITS,
            bottom: (window.bottom - 1) << S::FRACTION_BITS,
        }
    }

    /// The centre of the first pixel.
    pub(super) fn first(&self) -> Position {
        Position {
            x: self.left,
            y: self.top,
        }
    }

    /// The centres of the corner pixels.
    pub(super) fn corners(&self) -> [Position; 4] {
        [
            (self.left, self.top),
            (self.right, self.top),
            (self.left, self.bottom),
            (self.right, self.bottom),
        ]
        .map(|(x, y)| Position { x, y })
    }
}

// Not re-exported: nobody but the method calls it.
/// A test of how a face lies to a window.
pub trait WindowTest {
    /// How a face lies to a window: exact where no edge of the face meets it.
    fn relation(face: &FaceCorners, window: &CenterRectangle) -> Relation;
}

/// The corners of a face on the screen, clockwise.
#[derive(Debug, Copy, Clone)]
pub struct FaceCorners(pub(super) [Position; 3]);

#[cfg(feature = "defmt")]
impl defmt::Format for FaceCorners {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "FaceCorners {}", self.0.map(|Position { x, y }| [x, y]));
    }
}

impl FaceCorners {
    /// The edges, each from a corner to the next one clockwise.
    pub(super) fn edges(&self) -> [[Position; 2]; 3] {
        let [a, b, c] = self.0;
        [[a, b], [b, c], [c, a]]
    }

    /// Whether any edge has a point in the rectangle of a window.
    pub(super) fn any_edge_meets(&self, window: &CenterRectangle) -> bool {
        self.edges().into_iter().any(|edge| edge_meets(edge, window))
    }
}

/// On which side of an edge a point is: positive on the inner side of a face, 0 on the line through the edge.
pub(super) fn side_of([start, end]: [Position; 2], point: Position) -> i64 {
    let (width, height) = (end.x - start.x, end.y - start.y);
    // Differences below 2^23.
    i64::from(width) * i64::from(point.y - start.y) - i64::from(height) * i64::from(point.x - start.x)
}

/// Whether an edge has a point in the rectangle of a window: unless both of its ends lie beyond the same side, or all corners of
/// the rectangle lie on the same side of it.
fn edge_meets(edge: [Position; 2], window: &CenterRectangle) -> bool {
    let [start, end] = edge;
    let lies_beyond = start.x.max(end.x) < window.left
        || start.x.min(end.x) > window.right
        || start.y.max(end.y) < window.top
        || start.y.min(end.y) > window.bottom;
    if lies_beyond {
        return false;
    }
    let sides = window.corners().map(|corner| side_of(edge, corner).signum());
    !(sides.iter().all(|side| *side > 0) || sides.iter().all(|side| *side < 0))
}
