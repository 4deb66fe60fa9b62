//! The sides of a face at its top corner, from which its edges and its depth plane are set up.

use crate::{
    view::{DepthWidth, Position, ScreenPrecision, ScreenVertex},
    visible::edge::row_after,
};

/// The top corner, in columns of the row, and where the next one clockwise (right) and the last one (left) are from there.
#[derive(Debug, Copy, Clone)]
pub(super) struct Sides {
    pub(super) top: Position,
    pub(super) right: Position,
    pub(super) left: Position,
}

impl Sides {
    /// The sides between corners in the order of [`from_top`](super::active_face::from_top), for rows that begin at a
    /// column.
    #[inline]
    pub(super) fn of<S: ScreenPrecision, D: DepthWidth>(corners: [&ScreenVertex<S, D>; 3], first_column: i32) -> Self {
        // Written out, here and elsewhere: `map` is a loop through memory when the compiler minds the size.
        let [top, right, left] = corners;
        let (top, right, left) = (top.position(), right.position(), left.position());
        Self {
            top: Position {
                x: top.x - (first_column << S::FRACTION_BITS),
                y: top.y,
            },
            right: right.minus(top),
            left: left.minus(top),
        }
    }

    /// The first row of the face.
    #[inline]
    pub(super) fn first_row<S: ScreenPrecision>(&self) -> i32 {
        row_after::<S>(self.top.y)
    }
}

/// Where in each pixel a face is seen.
pub(super) trait SamplePosition: Copy {
    /// The sides of a face as they are seen from there.
    fn see(self, sides: Sides) -> Sides;
}

/// At the centres of pixels.
impl SamplePosition for () {
    #[inline(always)]
    fn see(self, sides: Sides) -> Sides {
        sides
    }
}

/// Beside the centres of pixels, so far to the right and down in units.
impl SamplePosition for Position {
    #[inline(always)]
    fn see(self, sides: Sides) -> Sides {
        Sides {
            top: sides.top.minus(self),
            ..sides
        }
    }
}
