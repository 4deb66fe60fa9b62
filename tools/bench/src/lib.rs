//! Times on this host: rounds in which every competitor has its turn, so that whatever disturbs, disturbs all.
//!
//! Other rasterizers are in the benchmarks: `cargo bench -p zrow-bench`.

use std::{
    hint::black_box,
    time::{Duration, Instant},
};

/// Nanoseconds of one operation over the rounds.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Spread {
    /// Half of the rounds took less.
    pub median: f64,
    /// A quarter of the rounds took less.
    pub low: f64,
    /// A quarter of the rounds took more.
    pub high: f64,
    /// How many there were.
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
    /// How many a run performs.
    pub operations: usize,
    /// Performs them.
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

/// Times all of them, one after the other in each round, for about a turn each.
pub fn interleaved(mut works: Vec<Work<'_>>, rounds: usize, turn: Duration) -> Vec<Spread> {
    let runs: Vec<u32> = works.iter_mut().map(|work| work.runs(turn)).collect();
    let mut times = vec![Vec::new(); works.len()];
    for _ in 0..rounds {
        for ((work, runs), times) in works.iter_mut().zip(&runs).zip(&mut times) {
            let operations = f64::from(*runs) * work.operations as f64;
            times.push(work.time(*runs).as_nanos() as f64 / operations);
        }
    }
    times.into_iter().map(Spread::of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spread_is_the_middle_half() {
        let spread = Spread::of(vec![9.0, 1.0, 5.0, 3.0, 100.0]);
        assert_eq!((spread.low, spread.median, spread.high), (3.0, 5.0, 9.0));
    }

    #[test]
    fn every_competitor_has_every_round() {
        let work = |milliseconds| Work {
            operations: 2,
            run: Box::new(move || std::thread::sleep(Duration::from_millis(milliseconds))),
        };
        let spreads = interleaved(vec![work(2), work(8)], 3, Duration::from_millis(1));
        assert_eq!(spreads.iter().map(|spread| spread.rounds).collect::<Vec<_>>(), [3, 3]);
        // Two operations a run, and sleep never ends early.
        assert!(spreads[0].low >= 1e6 && spreads[1].low >= 4e6);
    }
}
