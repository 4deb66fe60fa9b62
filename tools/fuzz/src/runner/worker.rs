//! The plain loop over the inputs of one target, in a process of its own: what hangs or overflows the stack ends that
//! process, and not the run.

use std::{
    collections::BTreeSet,
    fs,
    io::Write,
    sync::{
        Mutex, PoisonError,
        atomic::{AtomicBool, AtomicU64, Ordering},
    },
    thread,
    time::{Duration, Instant},
};

use serde::{Deserialize, Serialize};

use crate::{
    runner::{
        attempt::{Wrong, attempt, note_panics},
        hex,
        shrink::shrink,
    },
    series,
    target::Target,
};

/// A line that a worker writes.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub enum Message {
    /// It is about to check this input.
    Begins(u64),
    /// Inputs before this one are checked.
    Checked {
        /// The next input.
        next: u64,
        /// The slowest of them.
        slowest: Slowest,
    },
    /// An input went wrong.
    Failed {
        /// Which one.
        iteration: u64,
        /// What went wrong.
        wrong: Wrong,
        /// A small input that goes wrong in the same way.
        smallest: Option<String>,
    },
}

/// The input that took longest.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Slowest {
    /// Microseconds.
    pub time: u64,
    /// Which one.
    pub iteration: u64,
}

/// What a worker does.
#[derive(Debug, Clone, PartialEq, clap::Parser)]
pub struct Task {
    /// Seed of all inputs.
    #[arg(long)]
    pub seed: u64,
    /// The first input.
    #[arg(long)]
    pub first: u64,
    /// Milliseconds to go on for.
    #[arg(long)]
    pub time: u64,
    /// Inputs to check at most.
    #[arg(long)]
    pub most: u64,
    /// Milliseconds that an input may take.
    #[arg(long)]
    pub limit: u64,
    /// Goes on after a failure.
    #[arg(long)]
    pub keep_going: bool,
    /// Writes which input comes before it does.
    #[arg(long)]
    pub announce: bool,
}

/// How often a worker says how far it is.
const REPORT: Duration = Duration::from_millis(100);
/// What making an input smaller may take.
const SHRINKING: Duration = Duration::from_secs(3);
/// Failures of different kinds that are worth reporting of one target.
pub(super) const MOST_FAILURES: usize = 8;

/// Checks inputs of a target, and hands over what there is to say. Returns when the time is over, or at the first failure.
///
/// `too_slow` is called from another thread while an input takes longer than the limit, with its number, or making one smaller
/// does; it may end the process.
pub fn work(target: &Target, task: &Task, say: &(dyn Fn(Message) + Sync), too_slow: &(dyn Fn(Option<u64>) + Sync)) {
    let clock = Clock::default();
    thread::scope(|scope| {
        let watch = scope.spawn(|| clock.watch(too_slow));
        check_inputs(target, task, say, &clock);
        clock.stop();
        // The watch does nothing that panics.
        let _ = watch.join();
    });
}

fn check_inputs(target: &Target, task: &Task, say: &(dyn Fn(Message) + Sync), clock: &Clock) {
    let end = Instant::now() + Duration::from_millis(task.time);
    let (mut reported, mut slowest) = (Instant::now(), Slowest::default());
    let mut kinds = BTreeSet::new();
    let mut next = task.first;
    loop {
        if task.announce {
            say(Message::Begins(next));
        }
        clock.begin(Some(next), Duration::from_millis(task.limit));
        let started = Instant::now();
        let bytes = series::bytes(task.seed, target.name, next);
        let result = attempt(target, &bytes);
        let time = started.elapsed().as_micros() as u64;
        if time > slowest.time {
            // Once more, because another process may have had the processor.
            let started = Instant::now();
            let _ = attempt(target, &bytes);
            let time = time.min(started.elapsed().as_micros() as u64);
            let iteration = next;
            slowest = slowest.max(Slowest { time, iteration });
        }
        clock.end();
        let iteration = next;
        next += 1;
        if let Err(wrong) = result {
            let kind = wrong.kind();
            if kinds.insert(kind.clone()) {
                // Making it smaller may take the process with it, so the failure is said before.
                say(Message::Failed {
                    iteration,
                    wrong: wrong.clone(),
                    smallest: None,
                });
                clock.begin(None, SHRINKING + Duration::from_millis(task.limit));
                say(smallest(target, iteration, wrong, &bytes, &kind));
                clock.end();
            }
            if !task.keep_going || kinds.len() >= MOST_FAILURES {
                break;
            }
        }
        let now = Instant::now();
        if now >= end || next - task.first >= task.most {
            break;
        }
        if now - reported >= REPORT {
            say(Message::Checked { next, slowest });
            reported = now;
        }
    }
    say(Message::Checked { next, slowest });
}

/// A failure with a small input.
fn smallest(target: &Target, iteration: u64, wrong: Wrong, bytes: &[u8], kind: &str) -> Message {
    let smallest = shrink(target, bytes, kind, SHRINKING);
    let wrong = attempt(target, &smallest).err().unwrap_or(wrong);
    Message::Failed {
        iteration,
        wrong,
        smallest: Some(hex::encode(&smallest)),
    }
}

/// What is being done, and how long it may take.
#[derive(Debug, Copy, Clone)]
struct Job {
    number: u64,
    /// The input that is being checked; `None` while one is made smaller.
    iteration: Option<u64>,
    start: Instant,
    time: Duration,
}

/// Tells when a job takes too long.
#[derive(Debug, Default)]
struct Clock {
    job: Mutex<Option<Job>>,
    jobs: AtomicU64,
    stopped: AtomicBool,
}

impl Clock {
    fn set(&self, job: Option<Job>) {
        *self.job.lock().unwrap_or_else(PoisonError::into_inner) = job;
    }

    fn begin(&self, iteration: Option<u64>, time: Duration) {
        let number = self.jobs.fetch_add(1, Ordering::Relaxed);
        let start = Instant::now();
        self.set(Some(Job {
            number,
            iteration,
            start,
            time,
        }));
    }

    fn end(&self) {
        self.set(None);
    }

    fn stop(&self) {
        self.stopped.store(true, Ordering::Relaxed);
    }

    /// Says it once of each job.
    fn watch(&self, too_slow: &(dyn Fn(Option<u64>) + Sync)) {
        let (mut seen, mut said) = (None, None);
        while !self.stopped.load(Ordering::Relaxed) {
            let job = *self.job.lock().unwrap_or_else(PoisonError::into_inner);
            if let Some(job) = job {
                // From when on the processor's time counts.
                if seen.is_none_or(|(number, _)| number != job.number) {
                    seen = Some((job.number, processor_time()));
                }
                let is_late = seen.is_some_and(|(_, before)| match processor_time().zip(before) {
                    Some((now, before)) => now.saturating_sub(before) >= job.time,
                    None => job.start.elapsed() >= job.time,
                });
                if is_late && said != Some(job.number) {
                    said = Some(job.number);
                    too_slow(job.iteration);
                }
            }
            thread::sleep(Duration::from_millis(10));
        }
    }
}

/// What this process has had of the processors' time, so that a busy machine makes no input slow. `None` where the system
/// does not say it as Linux does.
fn processor_time() -> Option<Duration> {
    /// Linux counts in these, whatever its own clock.
    const TICKS_PER_SECOND: u64 = 100;
    let text = fs::read_to_string("/proc/self/stat").ok()?;
    // The second field is the program's name in brackets, which may hold anything.
    let (_, fields) = text.rsplit_once(')')?;
    let mut ticks = fields.split_whitespace().skip(11).map(str::parse::<u64>);
    let sum = ticks.next()?.ok()? + ticks.next()?.ok()?;
    Some(Duration::from_millis(sum * 1_000 / TICKS_PER_SECOND))
}

/// The whole process of a worker: messages go to the standard output, one a line, and an input that takes too long ends it.
pub fn run(target: &Target, task: &Task) {
    note_panics();
    let say = |message: Message| {
        let line = serde_json::to_string(&message).unwrap_or_default();
        // Nobody listens any more: then there is nothing to do.
        let _ = writeln!(std::io::stdout().lock(), "{line}");
    };
    work(target, task, &say, &|iteration| {
        if let Some(iteration) = iteration {
            say(Message::Failed {
                iteration,
                wrong: Wrong::Slow(task.limit),
                smallest: None,
            });
        }
        std::process::exit(0);
    });
}
