//! Times on this host: rounds in which every competitor has its turn, so that whatever disturbs, disturbs all.

use std::{
    hint::black_box,
    time::{Duration, Instant},
};

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
        if quick {
            Self {
                quick,
                inputs_in_percent: 20,
                rounds: 5,
                turn: Duration::from_micros(300),
            }
        } else {
            Self {
                quick,
                inputs_in_percent: 100,
                rounds: 31,
                turn: Duration::from_millis(1),
            }
        }
    }

    /// That part of so many inputs.
    pub fn inputs(&self, whole: usize) -> usize {
        (whole * self.inputs_in_percent / 100).max(1)
    }
}

/// Nanoseconds of one operation over the rounds.
#[derive(Debug, Clone, Copy, Default)]
pub struct Spread {
    pub median: f64,
    /// A quarter of the rounds took less.
    pub low: f64,
    /// A quarter of the rounds took more.
    pub high: f64,
    pub rounds: usize,
}

impl Spread {
    fn of(mut rounds: Vec<f64>) -> Self {
        rounds.sort_by(f64::total_cmp);
        let at = |quarter: usize| rounds[(rounds.len() - 1) * quarter / 4];
        Self {
            median: at(2),
            low: at(1),
            high: at(3),
            rounds: rounds.len(),
        }
    }

    /// The mean over groups of inputs.
    pub fn mean(spreads: &[Self]) -> Option<Self> {
        let count = spreads.len() as f64;
        let mean = |figure: fn(&Self) -> f64| spreads.iter().map(figure).sum::<f64>() / count;
        Some(Self {
            median: mean(|spread| spread.median),
            low: mean(|spread| spread.low),
            high: mean(|spread| spread.high),
            rounds: spreads.first()?.rounds,
        })
    }
}

/// What is timed: it performs so many operations.
pub struct Work<'a> {
    pub operations: usize,
    pub run: Box<dyn FnMut() + 'a>,
}

impl<'a> Work<'a> {
    /// Performs an operation on each input.
    pub fn on_each<T>(inputs: &'a [T], mut operation: impl FnMut(&T) + 'a) -> Self {
        Self {
            operations: inputs.len(),
            run: Box::new(move || black_box(inputs).iter().for_each(&mut operation)),
        }
    }

    /// How long so many runs take.
    fn time(&mut self, runs: u32) -> Duration {
        let start = Instant::now();
        for _ in 0..runs {
            (self.run)();
        }
        start.elapsed()
    }

    /// So many runs take a turn.
    fn runs(&mut self, turn: Duration) -> u32 {
        let mut runs = 1;
        while self.time(runs) < turn && runs < 1 << 20 {
            runs *= 2;
        }
        runs
    }
}

/// Times all of them, one after the other in each round.
pub fn interleaved(mut works: Vec<Work<'_>>, plan: &Plan) -> Vec<Spread> {
    let runs: Vec<u32> = works.iter_mut().map(|work| work.runs(plan.turn)).collect();
    let mut times = vec![Vec::new(); works.len()];
    for _ in 0..plan.rounds {
        for ((work, runs), times) in works.iter_mut().zip(&runs).zip(&mut times) {
            let operations = f64::from(*runs) * work.operations as f64;
            times.push(work.time(*runs).as_nanos() as f64 / operations);
        }
    }
    times.into_iter().map(Spread::of).collect()
}

#[cfg(test)]
mod tests {
    use super::Spread;

    #[test]
    fn a_spread_is_the_middle_half() {
        let spread = Spread::of(vec![9.0, 1.0, 5.0, 3.0, 100.0]);
        assert_eq!((spread.low, spread.median, spread.high), (3.0, 5.0, 9.0));
    }
}
