//! How many random cases a test tries, and which: shared with the tests within the library.

use proptest::test_runner::{Config, RngSeed};

/// The share of the deep cases that the environment variable `ZROW_DEEP` asks for: 0 where it is not set, 1 for all of them.
fn depth() -> f64 {
    let Ok(value) = std::env::var("ZROW_DEEP") else {
        return 0.0;
    };
    let share = value.parse().ok().filter(|share| (0.0..=1.0).contains(share));
    share.unwrap_or_else(|| panic!("ZROW_DEEP={value}: take a number from 0 to 1, such as 1 for all deep cases"))
}

/// Whether a test tries few cases: in a debug build, where tests are compiled without optimization, and the environment variable
/// `ZROW_DEEP` does not ask for more.
pub fn is_quick() -> bool {
    cfg!(debug_assertions) && depth() == 0.0
}

/// Whether the environment variable `ZROW_DEEP` is above 0, as it is in `.ci/run`: for what takes a second or two and has no cases of
/// which a share could be taken.
pub fn is_deep() -> bool {
    depth() > 0.0
}

/// The number of cases to try: `default`, or `deep` where the environment variable `ZROW_DEEP` is 1, or a number between them
/// where it is a share of 1; an eighth of `default` where [`is_quick`]. With the fixed seed of [`config`] the cases of a run are the
/// first ones of a deeper run. A sum that a test expects of all its cases is taken from it as well.
pub fn cases(default: u32, deep: u32) -> u32 {
    if is_quick() {
        return default.div_ceil(8);
    }
    default + (f64::from(deep.saturating_sub(default)) * depth()) as u32
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
