//! How much is run; times themselves are taken as for the other rasterizers.

use std::time::Duration;

pub use zrow_bench::{Spread, Work};

/// How much is run.
#[derive(Debug, Clone)]
pub struct Plan {
    pub quick: bool,
    /// Shapes, lines or curves of a group, out of those that a whole run takes.
    pub inputs_in_percent: usize,
    pub rounds: usize,
    /// The shortest turn.
    pub turn: Duration,
}

impl Plan {
    /// A whole run, or a coarse one.
    pub fn new(quick: bool) -> Self {
        // Turns are short, so that few are disturbed by whatever else runs here.
        if quick {
            Self {
                quick,
                inputs_in_percent: 20,
                rounds: 11,
                turn: Duration::from_micros(150),
            }
        } else {
            Self {
                quick,
                inputs_in_percent: 100,
                rounds: 101,
                turn: Duration::from_micros(250),
            }
        }
    }

    /// That part of so many inputs.
    pub fn inputs(&self, whole: usize) -> usize {
        (whole * self.inputs_in_percent / 100).max(1)
    }
}

/// Times all of them in the rounds of the plan.
pub fn interleaved(works: Vec<Work<'_>>, plan: &Plan) -> Vec<Spread> {
    zrow_bench::interleaved(works, plan.rounds, plan.turn)
}
