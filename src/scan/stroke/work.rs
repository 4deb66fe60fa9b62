//! Counts what a stroke costs, for tests of bounds: without a clock, so that the figures repeat. Not compiled otherwise.

extern crate std;

use std::{cell::Cell, thread_local};

thread_local! {
    static STEPS: Cell<u64> = const { Cell::new(0) };
}

/// The steps that drawing a stroke takes at most for each vertex, and for each pixel that it has without gaps or row of
/// the window, times the number of lengths and eight more.
pub(crate) const MOST_STEPS: u64 = 24;

/// Adds a step: a dash of a pattern passed or looked at, a pixel looked at, an edge generated.
pub(crate) fn step() {
    STEPS.with(|steps| steps.set(steps.get() + 1));
}

/// The number of steps that `work` takes.
pub(crate) fn of(work: impl FnOnce()) -> u64 {
    let before = STEPS.with(Cell::get);
    work();
    STEPS.with(Cell::get) - before
}
