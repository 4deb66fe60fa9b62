//! Lines that are kept to compare them with the default one.

mod dda;
mod dda_fixed;
mod double_step;
mod midpoint;
mod slope_intercept;
mod supercover;
