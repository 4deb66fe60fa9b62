//! Adaptive flattening by de Casteljau's subdivision (1959; Lane and Riesenfeld 1980): what is not flat is halved.
//!
//! Guarantees: what [the module](crate::scan::curve) says, and every control point of every part is exact, so that
//! no rounding adds up. No recursion: the parts still to come wait in a table of 12, which is the deepest that any curve in
//! the domain goes.
//!
//! Cost: six halved sums a coordinate for each halving of a cubic, three for a quadratic; 768 bytes of stack for a cubic.
//! The lines are those of [`Bezier::adaptive_forward_difference`](crate::scan::Bezier::adaptive_forward_difference), which needs no
//! table. Take it when halves of curves are wanted by themselves, or to see the textbook's way.

use core::fmt::Debug;

use fixed::types::U8F8;
use heapless::Vec;

use crate::{
    geometry::{Sub8, SubPoint},
    scan::curve::{
        bezier::{Bezier, bend, point_of_curve},
        flatten::{Flatness, MOST_HALVINGS, round},
    },
};

impl<const CONTROLS: usize> Bezier<CONTROLS> {
    /// The ends of the lines that a curve becomes, by halving it until its parts are flat.
    ///
    /// Every control point of every part is exact. The [type](Self) says what the tolerance means.
    ///
    /// Cost: six halved sums a coordinate for each halving of a cubic, three for a quadratic; 768 bytes of stack for a cubic.
    /// Source: de Casteljau 1959; Lane and Riesenfeld 1980.
    pub fn de_casteljau(
        &self,
        tolerance: U8F8,
    ) -> impl Iterator<Item = SubPoint<Sub8>> + Clone + Debug + use<CONTROLS> {
        Subdivision {
            part: Some(SubCurve(self.guarded_controls())),
            waiting: Vec::new(),
            flatness: Flatness::new(tolerance),
        }
    }
}

/// The lines of a curve, from its start to its end.
#[derive(Debug, Clone)]
struct Subdivision<const CONTROLS: usize> {
    /// The part of the curve that comes next; `None` after the last one.
    part: Option<SubCurve<CONTROLS>>,
    /// The parts after the next one, in reverse order.
    waiting: Vec<SubCurve<CONTROLS>, { MOST_HALVINGS as usize }>,
    flatness: Flatness,
}

/// The control points of a part of a curve, columns and rows, with guard bits.
#[derive(Debug, Copy, Clone)]
struct SubCurve<const CONTROLS: usize>([[i64; CONTROLS]; 2]);

impl<const CONTROLS: usize> SubCurve<CONTROLS> {
    /// Returns the first half, and leaves the second half in `self`.
    fn halve(&mut self) -> Self {
        Self(self.0.each_mut().map(halve))
    }

    fn is_flat(&self, flatness: Flatness) -> bool {
        flatness.allows(self.0.each_ref().map(bend))
    }

    fn end(&self) -> SubPoint<Sub8> {
        let [x, y] = self.0.map(|axis| round(axis.last().copied().unwrap_or_default()));
        point_of_curve(x, y)
    }
}

/// De Casteljau's triangle of one coordinate: each row has the middles of the row before. The first numbers of the rows
/// are the control points of the first half; the last ones, which stay in place, those of the second.
fn halve<const CONTROLS: usize>(controls: &mut [i64; CONTROLS]) -> [i64; CONTROLS] {
    let mut first_half = [0; CONTROLS];
    for (row, control) in first_half.iter_mut().enumerate() {
        let mut later = controls.iter_mut().take(CONTROLS.saturating_sub(row));
        let Some(mut current) = later.next() else { break };
        *control = *current;
        for next in later {
            // 21 bits, a sign and 36 guard bits, of which 3 more are 0 than halvings are left.
            *current = (*current + *next) >> 1;
            current = next;
        }
    }
    first_half
}

impl<const CONTROLS: usize> Iterator for Subdivision<CONTROLS> {
    type Item = SubPoint<Sub8>;

    fn next(&mut self) -> Option<SubPoint<Sub8>> {
        let mut part = self.part?;
        // The table is never full before a part is flat: as many halvings as it has entries are enough.
        while !part.is_flat(self.flatness) && !self.waiting.is_full() {
            let first_half = part.halve();
            let pushed = self.waiting.push(part);
            debug_assert!(pushed.is_ok(), "a full table ends the loop");
            part = first_half;
        }
        self.part = self.waiting.pop();
        Some(part.end())
    }
}
