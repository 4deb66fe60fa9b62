//! What an effect costs the teapot, from all its figures.

use anyhow::Context;

use crate::{
    case::{Figure, V6M, V7EM, V7M},
    docs::page::figure,
    effects::Effect,
};

/// What an effect costs, all in all.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Cost {
    pub what: String,
    /// Instructions and estimated cycles on a Cortex-M4 and on a Cortex-M0+.
    pub m4: [u64; 2],
    pub m0plus: [u64; 2],
    /// Bytes.
    pub flash: u64,
    pub ram: u64,
}

/// What an effect costs, as it was measured.
pub fn measured(effect: &Effect, figures: &[Figure]) -> anyhow::Result<Cost> {
    let count = |target: &str| -> anyhow::Result<[u64; 2]> {
        let figure = figure(figures, effect.name, target)?;
        let cycles = figure
            .cycles
            .with_context(|| format!("{} has no cycles: leave out --no-cycles", effect.name))?;
        Ok([figure.zrow, cycles].map(|number| number.round() as u64))
    };
    let [flash, ram, stack] = effect.memory_names();
    let bytes = |name: &str| figure(figures, name, V7M).map(|figure| figure.zrow as u64);
    Ok(Cost {
        what: effect.what.to_owned(),
        m4: count(V7EM)?,
        m0plus: count(V6M)?,
        flash: bytes(&flash)?,
        ram: bytes(&ram)? + bytes(&stack)?,
    })
}
