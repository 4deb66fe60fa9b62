//! Line algorithms that are kept to compare them with the default one.

pub mod dda;
pub mod dda_fixed;
pub mod double_step;
pub mod midpoint;
pub mod slope_intercept;
pub mod supercover;
