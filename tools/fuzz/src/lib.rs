//! Fuzzing zrow: inputs are decoded from bytes, so that a plain loop on stable Rust and libFuzzer drive the same targets.
//!
//! A [`Case`] is the input of a [`Target`] and says what has to hold for it; the [`registry`] has a line for each.
//! [`values`] are what inputs are made of, [`picture`] draws one picture in all ways, [`exact`] has references in wide
//! integers, and the [`runner`] is the loop.

pub mod exact;
mod families;
pub mod picture;
pub mod registry;
pub mod runner;
mod series;
mod target;
pub mod values;

pub use series::INPUT_BYTES;
pub use target::{Case, Target, Verdict};

/// Checks the input of a target that bytes stand for, and panics where a property does not hold: the body of a libFuzzer
/// target.
///
/// # Panics
/// There is no such target, or a property does not hold.
pub fn check_or_panic(target: &str, bytes: &[u8]) {
    let Some(target) = registry::named(target) else {
        panic!("no target is called {target}");
    };
    if let Err(error) = target.check(bytes) {
        panic!("{error:#}\n{}", target.show(bytes));
    }
}
