//! Instructions on the emulated Cortex-M4, from `measure`; or why there are none.

use std::collections::HashMap;

/// Counts by the name that `measure` prints.
pub struct Counted {
    counts: HashMap<String, f64>,
    /// Why there are none.
    missing: Option<String>,
}

impl Counted {
    /// None, and why.
    pub fn none(why: impl Into<String>) -> Self {
        Self {
            counts: HashMap::new(),
            missing: Some(why.into()),
        }
    }

    /// Builds the bench firmware and counts in QEMU; what fails is a reason to say, not to fail.
    pub fn count(names: &[String]) -> Self {
        match zrow_measure::instructions(names) {
            Ok(counts) => Self { counts, missing: None },
            Err(error) => Self::none(format!("{error:#}")),
        }
    }

    /// Instructions per operation.
    pub fn get(&self, name: &str) -> Option<f64> {
        self.counts.get(name).copied()
    }

    /// Why there are none.
    pub fn missing(&self) -> Option<&str> {
        self.missing.as_deref()
    }
}
