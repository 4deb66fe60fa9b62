//! Starts a worker in a process of its own, and makes sense of what it says and how it ends.

use std::{
    io::{BufRead, BufReader},
    process::{Command, Stdio},
};

use anyhow::Context;

use crate::{
    runner::{
        attempt::Wrong,
        worker::{Message, Slowest, Task},
    },
    target::Target,
};

/// An input that goes wrong.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Failure {
    /// Which one.
    pub iteration: u64,
    /// What goes wrong.
    pub wrong: Wrong,
    /// A small input that goes wrong in the same way.
    pub smallest: Option<String>,
}

/// What came of some inputs of a target.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Outcome {
    /// The input after the last one that was checked.
    pub next: u64,
    /// The input that took longest.
    pub slowest: Slowest,
    /// The inputs that went wrong, each in another way.
    pub failures: Vec<Failure>,
}

/// Runs a worker to its end. Where its process ends by itself, a second one finds out at which input.
///
/// # Errors
/// The process cannot be started.
pub fn run(target: &Target, task: &Task) -> anyhow::Result<Outcome> {
    let mut end = start(target, task)?;
    let Some(how) = end.ended else {
        // The process of an input that is too slow ends with it.
        let slow = end
            .outcome
            .failures
            .iter()
            .find(|failure| matches!(failure.wrong, Wrong::Slow(_)));
        end.outcome.next = slow.map_or(end.outcome.next, |slow| slow.iteration + 1);
        return Ok(end.outcome);
    };
    let again = Task {
        first: end.outcome.next,
        announce: true,
        ..task.clone()
    };
    let again = start(target, &again)?;
    if again.ended.is_some() {
        let iteration = again.begun.unwrap_or(end.outcome.next);
        end.outcome.next = iteration + 1;
        end.outcome.failures.push(Failure {
            iteration,
            wrong: Wrong::Ended(how),
            smallest: None,
        });
    }
    Ok(end.outcome)
}

/// What a process said and how it ended.
struct End {
    outcome: Outcome,
    /// The last input that it said it would check.
    begun: Option<u64>,
    /// How it ended, where it did not end as it should.
    ended: Option<String>,
}

fn start(target: &Target, task: &Task) -> anyhow::Result<End> {
    let program = std::env::current_exe().context("where this program lies")?;
    let mut process = Command::new(program)
        .args(["worker", "--name", target.name])
        .args(arguments(task))
        // Errors are no events here: finding out where each of them came from takes longer than an input.
        .env("RUST_BACKTRACE", "0")
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        // What the runtime says of a stack overflow; how the process ended says that, too.
        .stderr(Stdio::null())
        .spawn()
        .context("cannot start a worker")?;
    let mut outcome = Outcome {
        next: task.first,
        ..Outcome::default()
    };
    let mut begun = None;
    let lines = process.stdout.take().map(BufReader::new).into_iter();
    for line in lines.flat_map(BufRead::lines) {
        // A line that was cut off when the process ended says nothing.
        let Ok(message) = serde_json::from_str(&line?) else {
            continue;
        };
        match message {
            Message::Begins(iteration) => begun = Some(iteration),
            Message::Checked { next, slowest } => {
                outcome.next = next;
                outcome.slowest = outcome.slowest.max(slowest);
            }
            Message::Failed {
                iteration,
                wrong,
                smallest,
            } => {
                outcome.failures.retain(|failure| failure.iteration != iteration);
                outcome.failures.push(Failure {
                    iteration,
                    wrong,
                    smallest,
                });
            }
        }
    }
    let status = process.wait().context("a worker")?;
    let ended = (!status.success()).then(|| status.to_string());
    Ok(End { outcome, begun, ended })
}

fn arguments(task: &Task) -> Vec<String> {
    let numbers = [
        ("--seed", task.seed),
        ("--first", task.first),
        ("--time", task.time),
        ("--most", task.most),
        ("--limit", task.limit),
    ];
    let numbers = numbers.into_iter();
    let mut arguments: Vec<_> = numbers
        .flat_map(|(name, number)| [name.to_owned(), number.to_string()])
        .collect();
    let flags = [("--keep-going", task.keep_going), ("--announce", task.announce)];
    arguments.extend(
        flags
            .into_iter()
            .filter(|(_, is_set)| *is_set)
            .map(|(name, _)| name.to_owned()),
    );
    arguments
}
