//! What a frame of the dashboard costs in bands of one height.

use anyhow::Context;

use crate::{
    case::{Figure, V7EM},
    docs::page::figure,
};

/// Rows of a band; the last one is as high as the picture.
pub const HEIGHTS: [u32; 7] = [1, 2, 4, 8, 16, 32, 320];
/// Bytes of a row of 240 pixels in RGB565.
pub const ROW_BYTES: u32 = 480;

/// Instructions and estimated cycles of a frame, rounded.
pub type Cost = (u64, u64);

/// A frame in bands of one height.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Bands {
    pub rows: u32,
    pub bytes: u32,
    pub prepared: Cost,
    pub replayed: Cost,
}

impl Bands {
    /// The names of both figures: prepared and replayed.
    pub fn names(rows: u32) -> [String; 2] {
        let prepared = match rows {
            1 => "picture.dashboard".to_owned(),
            rows => format!("picture.dashboard.rows_{rows}"),
        };
        let replayed = format!("{prepared}.replayed");
        [prepared, replayed]
    }

    /// A frame in bands of so many rows, as it was measured.
    ///
    /// # Errors
    ///
    /// A figure was not measured, or has no cycles.
    pub fn measured(rows: u32, figures: &[Figure]) -> anyhow::Result<Self> {
        let cost = |name: &str| -> anyhow::Result<Cost> {
            let figure = figure(figures, name, V7EM)?;
            let cycles = figure
                .cycles
                .with_context(|| format!("{name} has no cycles: leave out --no-cycles"))?;
            Ok((figure.zrow.round() as u64, cycles.round() as u64))
        };
        let [prepared, replayed] = Self::names(rows);
        Ok(Self {
            rows,
            bytes: rows * ROW_BYTES,
            prepared: cost(&prepared)?,
            replayed: cost(&replayed)?,
        })
    }
}
