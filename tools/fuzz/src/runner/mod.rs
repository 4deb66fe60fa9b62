//! The plain loop: divides its time among targets, and reports what went wrong so that it can be done again.

mod attempt;
mod hex;
mod report;
mod shrink;
pub mod worker;
mod worker_process;

pub use attempt::{Wrong, attempt, note_panics};
pub use worker_process::{Failure, Outcome};

use std::{
    sync::{Mutex, PoisonError},
    thread,
    time::{Duration, Instant},
};

use anyhow::{Context, bail, ensure};
use indicatif::{ProgressBar, ProgressStyle};

use crate::{registry, series, target::Target};
use worker::Task;

/// Options of the loop.
#[derive(Debug, Clone, clap::Parser)]
pub struct Options {
    /// How long to go on, all targets together
    #[arg(long, default_value_t = 60)]
    seconds: u64,
    /// Seed of all inputs: the same one gives the same inputs
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Only targets with this text in their name; may be repeated
    #[arg(long, value_name = "TEXT")]
    target: Vec<String>,
    /// Checks one input again: its bytes as the report has them. Takes one target
    #[arg(long, value_name = "HEX", conflicts_with = "iteration")]
    replay: Option<String>,
    /// Checks one input again: its number, with the seed. Takes one target
    #[arg(long, value_name = "NUMBER")]
    iteration: Option<u64>,
    /// Goes on with a target after a failure, for failures of other kinds
    #[arg(long)]
    keep_going: bool,
    /// Milliseconds that an input may take
    #[arg(long, default_value_t = 2_000)]
    limit_ms: u64,
    /// Targets at a time; otherwise as many as the machine has processors
    #[arg(long)]
    jobs: Option<usize>,
    /// Lists the targets
    #[arg(long)]
    list: bool,
}

/// Runs the loop, or checks one input.
///
/// # Errors
/// An input went wrong, or there is no such target.
pub fn run(options: &Options) -> anyhow::Result<()> {
    let targets = registry::find(&options.target);
    ensure!(
        !targets.is_empty(),
        "no target has such a name; there are: {}",
        registry::names().join(", ")
    );
    if options.list {
        for target in targets {
            println!("{}: {}", target.name, target.modules.join(", "));
        }
        return Ok(());
    }
    if options.replay.is_some() || options.iteration.is_some() {
        return replay(&targets, options);
    }
    let outcomes = check_all(&targets, options)?;
    report::print_table(&targets, &outcomes);
    let failures = outcomes
        .iter()
        .map(|(outcome, _)| outcome.failures.len())
        .sum::<usize>();
    for (target, (outcome, _)) in targets.iter().zip(&outcomes) {
        for failure in &outcome.failures {
            report::print_failure(target, failure, options.seed);
        }
    }
    ensure!(failures == 0, "{failures} inputs went wrong");
    Ok(())
}

fn replay(targets: &[Target], options: &Options) -> anyhow::Result<()> {
    // A whole name is one target, also where it is part of another name.
    let exact = targets
        .iter()
        .find(|target| options.target.iter().any(|name| name == target.name));
    let target = match (exact, targets) {
        (Some(target), _) => target,
        (None, [target]) => target,
        _ => bail!("one target, by --target NAME"),
    };
    let bytes = match (&options.replay, options.iteration) {
        (Some(text), _) => hex::decode(text).context("--replay")?,
        (None, Some(iteration)) => series::bytes(options.seed, target.name, iteration),
        (None, None) => bail!("which input? By --replay or --iteration"),
    };
    println!("{}\n{}", target.name, target.show(&bytes));
    let started = Instant::now();
    // Panics print where they come from, with RUST_BACKTRACE=1 by which way.
    let result = attempt(target, &bytes);
    println!("{:?}", started.elapsed());
    match result {
        Ok(()) => Ok(()),
        Err(wrong) => bail!("{wrong}"),
    }
}

/// What came of a target, and how long it ran.
type Timed = (Outcome, Duration);

/// Checks inputs of all targets, each for its part of the time.
fn check_all(targets: &[Target], options: &Options) -> anyhow::Result<Vec<Timed>> {
    let processors = thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let jobs = options.jobs.unwrap_or(processors).clamp(1, targets.len());
    let progress = ProgressBar::new(targets.len() as u64).with_style(ProgressStyle::with_template(
        "{bar:24} {pos}/{len} targets, {elapsed} {wide_msg}",
    )?);
    progress.enable_steady_tick(Duration::from_millis(200));
    let end = Instant::now() + Duration::from_secs(options.seconds);
    let waiting = Mutex::new(0);
    let results = Mutex::new(vec![None; targets.len()]);
    let failed = thread::scope(|scope| {
        let worker = || -> anyhow::Result<()> {
            loop {
                let index = {
                    let mut waiting = waiting.lock().unwrap_or_else(PoisonError::into_inner);
                    *waiting += 1;
                    *waiting - 1
                };
                let Some(target) = targets.get(index) else {
                    return Ok(());
                };
                progress.set_message(target.name);
                let left = end.saturating_duration_since(Instant::now()) * jobs as u32;
                let coverage = left / (targets.len() - index).max(jobs) as u32;
                let started = Instant::now();
                let outcome = check(target, options, coverage)?;
                let timed = (outcome, started.elapsed());
                for failure in &timed.0.failures {
                    progress.suspend(|| eprintln!("{}: {}", target.name, failure.wrong));
                }
                if let Some(result) = results.lock().unwrap_or_else(PoisonError::into_inner).get_mut(index) {
                    *result = Some(timed);
                }
                progress.inc(1);
            }
        };
        let workers: Vec<_> = (0..jobs).map(|_| scope.spawn(worker)).collect();
        let mut results = workers.into_iter().map(|worker| match worker.join() {
            Ok(result) => result,
            Err(_) => bail!("the loop itself panicked"),
        });
        results.find(Result::is_err)
    });
    progress.finish_and_clear();
    failed.transpose()?;
    let results = results.into_inner().unwrap_or_else(PoisonError::into_inner);
    Ok(results.into_iter().map(Option::unwrap_or_default).collect())
}

/// Checks inputs of a target for that long.
fn check(target: &Target, options: &Options, time: Duration) -> anyhow::Result<Outcome> {
    let end = Instant::now() + time;
    let mut all = Outcome::default();
    loop {
        let left = end.saturating_duration_since(Instant::now());
        let task = Task {
            seed: options.seed,
            first: all.next,
            time: left.as_millis() as u64,
            most: u64::MAX,
            limit: options.limit_ms,
            keep_going: options.keep_going,
            announce: false,
        };
        let outcome = worker_process::run(target, &task)?;
        all.next = outcome.next;
        all.slowest = all.slowest.max(outcome.slowest);
        for failure in outcome.failures {
            let is_known = all
                .failures
                .iter()
                .any(|known| known.wrong.kind() == failure.wrong.kind());
            if !is_known {
                all.failures.push(failure);
            }
        }
        let is_done = !all.failures.is_empty() && !options.keep_going;
        if is_done || all.failures.len() >= worker::MOST_FAILURES || Instant::now() >= end {
            return Ok(all);
        }
    }
}
