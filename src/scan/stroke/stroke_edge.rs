//! The edges of a stroke: straight ones, and those of discs.

use crate::scan::{
    polygon::{Crossing, Edge, ScanEdge},
    stroke::DiscSide,
};

/// An edge of a stroke.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum StrokeEdge {
    /// A side of a rectangle or of a wedge.
    Straight(Edge),
    /// A side of a disc.
    Disc(DiscSide),
}

/// Asks whichever edge it is.
macro_rules! either {
    ($edge:expr, $side:ident => $answer:expr) => {
        match $edge {
            StrokeEdge::Straight($side) => $answer,
            StrokeEdge::Disc($side) => $answer,
        }
    };
}

impl ScanEdge for StrokeEdge {
    fn first_row(&self) -> i32 {
        either!(self, side => side.first_row())
    }

    fn end_row(&self) -> i32 {
        either!(self, side => side.end_row())
    }

    fn crossing_at(&self, row: i32) -> Crossing {
        either!(self, side => side.crossing_at(row))
    }

    fn next_crossing(&self, before: Crossing, row: i32) -> Crossing {
        either!(self, side => ScanEdge::next_crossing(side, before, row))
    }

    fn windings(&self) -> (i8, i8) {
        either!(self, side => side.windings())
    }
}
