//! How many random cases a test tries, and which: shared with the tests within the library.

use proptest::test_runner::{Config, RngSeed};

/// Whether the environment variable `ZROW_DEEP` is 1, as it is in `.ci/run`: everything is tried, however long it takes.
pub fn is_deep() -> bool {
    std::env::var_os("ZROW_DEEP").is_some_and(|value| value == "1")
}

/// The number of cases that proptest tries: `default`, or `deep` where the environment variable `ZROW_DEEP` is 1. With the fixed
/// seed of [`config`] the cases of a default run are the first ones of a deep run.
pub fn cases(default: u32, deep: u32) -> u32 {
    if is_deep() { deep } else { default }
}

/// proptest with a fixed seed, so that every run tests the same cases.
pub fn config(cases: u32) -> Config {
    Config {
        cases,
        rng_seed: RngSeed::Fixed(0x0123_4567),
        failure_persistence: None,
        ..Config::default()
    }
}
