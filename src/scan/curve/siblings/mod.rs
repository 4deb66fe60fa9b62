//! Ways to flatten a curve that are kept to compare them with the default one.

pub mod de_casteljau;
pub mod uniform_subdivision;
