//! What the emulated chips take, from `measure`; or why nothing was counted.

use std::collections::HashMap;

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
}

impl Counted {
    /// None, and why.
    pub fn none(why: impl Into<String>) -> Self {
        Self {
            figures: HashMap::new(),
            missing: Some(why.into()),
        }
    }

    /// Builds the bench firmware and counts in QEMU; what fails is a reason to say, not to fail.
    pub fn count(names: &[String]) -> Self {
        if names.is_empty() {
            return Self {
                figures: HashMap::new(),
                missing: None,
            };
        }
        match zrow_measure::figures(names) {
            Ok(figures) => Self { figures, missing: None },
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
