//! Ways to flatten a curve that are kept to compare them with the default one.

mod de_casteljau;
mod uniform_subdivision;
