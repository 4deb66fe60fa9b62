//! Pages of `docs/` with figures that were measured: the algorithms, how tall a band should be, what effects cost, and what
//! methods of visibility and the depth test do.
//!
//! A table lies between the comments `<!-- NAME -->` and `<!-- end -->`; everything else of a page is written by hand.

mod algorithms;
mod band_height;
mod bands;
mod depth_test;
mod effect_cost;
mod effect_plot;
mod effects;
mod page;
mod plot;
mod scene_looks;
mod visibility;
mod visibility_plot;

use anyhow::bail;

use crate::case::Figure;

pub use visibility::{RecordedChart, RecordedTable, RecordedVisibility, recorded_visibility};

/// Writes the tables and the plot of every page anew of which some figure was measured.
///
/// # Errors
///
/// A table is not in its page; only some of a page's figures were measured, or none of any page.
pub fn refill(figures: &[Figure]) -> anyhow::Result<()> {
    let has_any = |names: &[String]| figures.iter().any(|figure| names.contains(&figure.case.name));
    let (of_algorithms, of_bands) = (has_any(&algorithms::names()), has_any(&band_height::names()));
    let of_effects = has_any(&effects::names());
    let of_visibility = has_any(&visibility::names());
    let of_depth_test = has_any(&depth_test::names());
    if of_algorithms {
        algorithms::refill(figures)?;
    }
    if of_bands {
        band_height::refill(figures)?;
    }
    if of_effects {
        effects::refill(figures)?;
    }
    if of_visibility {
        visibility::refill(figures)?;
    }
    if of_depth_test {
        depth_test::refill(figures)?;
    }
    if !(of_algorithms || of_bands || of_effects || of_visibility || of_depth_test) {
        bail!("docs/ has none of these figures: leave out --only, or take --only picture.dashboard");
    }
    Ok(())
}
