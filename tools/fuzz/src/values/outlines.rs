//! Contours of whole pixels, and fill rules.

use arbitrary::Arbitrary;
use embedded_graphics::geometry::Point;
use zrow::draw::FillRule;

use super::{List, Spot, Stage};

/// Up to `CONTOURS` contours of up to `POINTS` pixels: some empty, some with repeated pixels.
#[derive(Debug, Clone, PartialEq, Eq, Arbitrary)]
pub struct Contours<const CONTOURS: usize, const POINTS: usize>(List<List<Spot, POINTS>, CONTOURS>);

impl<const CONTOURS: usize, const POINTS: usize> Contours<CONTOURS, POINTS> {
    /// The pixels.
    pub fn get(&self, stage: &Stage) -> Vec<Vec<Point>> {
        let contours = self.0.0.iter();
        contours
            .map(|contour| contour.0.iter().map(|spot| stage.point(*spot)).collect())
            .collect()
    }
}

/// Which winding numbers are inside.
#[derive(Debug, Copy, Clone, PartialEq, Eq, Arbitrary)]
pub enum Rule {
    /// Odd ones.
    EvenOdd,
    /// All but 0.
    NonZero,
}

impl Rule {
    /// As zrow takes it.
    pub const fn get(self) -> FillRule {
        match self {
            Self::EvenOdd => FillRule::EvenOdd,
            Self::NonZero => FillRule::NonZero,
        }
    }
}
