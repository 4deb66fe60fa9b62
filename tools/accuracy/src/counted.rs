//! What the emulated chips take, from `measure`; or why nothing was counted.

use std::{
    collections::{BTreeMap, HashMap},
    fs,
    path::Path,
};

use anyhow::Context;
use serde::{Deserialize, Serialize};
use time::OffsetDateTime;
use zrow_measure::Measured;

/// What an entry takes on the chips; nothing where it was not counted.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Chip {
    /// Instructions of an operation on a Cortex-M4.
    pub instructions: Option<f64>,
    /// Estimated cycles of them.
    pub cycles: Option<f64>,
    /// Bytes of a program's code and constants.
    pub flash_bytes: Option<f64>,
}

impl Chip {
    /// The mean over groups of inputs, of what was counted on all of them.
    pub fn mean(chips: &[Self]) -> Self {
        let mean = |figure: fn(&Self) -> Option<f64>| {
            let figures: Option<Vec<f64>> = chips.iter().map(figure).collect();
            figures.map(|figures| figures.iter().sum::<f64>() / figures.len() as f64)
        };
        Self {
            instructions: mean(|chip| chip.instructions),
            cycles: mean(|chip| chip.cycles),
            flash_bytes: mean(|chip| chip.flash_bytes),
        }
    }
}

/// Figures by the name that `measure` prints.
pub struct Counted {
    figures: HashMap<String, Measured>,
    /// Why there are none.
    missing: Option<String>,
    /// When they were counted; nothing where that was in this run.
    recorded: Option<String>,
}

/// Counts as they are kept in the repository, for runs without QEMU.
#[derive(Debug, Serialize, Deserialize)]
struct Record {
    /// The day, as year, month and day.
    counted: String,
    /// Instructions, or bytes of a program, and estimated cycles.
    figures: BTreeMap<String, (f64, Option<f64>)>,
}

/// Where they are kept.
const RECORD: &str = "recorded.json";

impl Counted {
    /// None, and why.
    pub fn none(why: impl Into<String>) -> Self {
        Self {
            figures: HashMap::new(),
            missing: Some(why.into()),
            recorded: None,
        }
    }

    /// Those that were recorded.
    ///
    /// # Errors
    /// The record cannot be read.
    pub fn from_record() -> anyhow::Result<Self> {
        let record: Record = serde_json::from_str(include_str!("../recorded.json")).context(RECORD)?;
        let measured = |(figure, cycles)| Measured { figure, cycles };
        Ok(Self {
            figures: record
                .figures
                .into_iter()
                .map(|(name, figures)| (name, measured(figures)))
                .collect(),
            missing: None,
            recorded: Some(format!("on {}", record.counted)),
        })
    }

    /// Counts in QEMU, and records that.
    ///
    /// # Errors
    /// A tool is missing, a firmware does not build or run, a count is void, or the record cannot be written.
    pub fn record(names: &[String]) -> anyhow::Result<()> {
        let figures = zrow_measure::figures(names)?;
        let record = Record {
            counted: OffsetDateTime::now_utc().date().to_string(),
            figures: figures
                .into_iter()
                .map(|(name, measured)| (name, (measured.figure, measured.cycles)))
                .collect(),
        };
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(RECORD);
        let text = serde_json::to_string_pretty(&record)? + "\n";
        fs::write(&path, text).with_context(|| format!("cannot write {}", path.display()))
    }

    /// Builds the bench firmware and counts in QEMU; what fails is a reason to say, not to fail.
    pub fn count(names: &[String]) -> Self {
        if names.is_empty() {
            return Self {
                figures: HashMap::new(),
                missing: None,
                recorded: None,
            };
        }
        match zrow_measure::figures(names) {
            Ok(figures) => Self {
                figures,
                missing: None,
                recorded: None,
            },
            Err(error) => Self::none(format!("{error:#}")),
        }
    }

    /// Instructions and cycles of an operation.
    pub fn get(&self, name: &str) -> Chip {
        let measured = self.figures.get(name);
        Chip {
            instructions: measured.map(|measured| measured.figure),
            cycles: measured.and_then(|measured| measured.cycles),
            flash_bytes: None,
        }
    }

    /// Instructions and cycles of an operation, and the flash of a program that does it.
    pub fn with_flash(&self, name: &str, program: &str) -> Chip {
        Chip {
            flash_bytes: self.figures.get(program).map(|measured| measured.figure),
            ..self.get(name)
        }
    }

    /// When they were counted, if that was not in this run.
    pub fn recorded(&self) -> Option<&str> {
        self.recorded.as_deref()
    }

    /// Why there are none.
    pub fn missing(&self) -> Option<&str> {
        self.missing.as_deref()
    }
}

#[cfg(test)]
mod tests {
    use super::Chip;

    #[test]
    fn a_mean_is_that_of_what_was_counted_everywhere() {
        let chip = |instructions, cycles| Chip {
            instructions,
            cycles,
            flash_bytes: None,
        };
        let mean = Chip::mean(&[chip(Some(2.0), Some(3.0)), chip(Some(4.0), None)]);
        assert_eq!(mean, chip(Some(3.0), None));
    }
}
