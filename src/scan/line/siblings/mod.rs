//! Lines that are kept to compare them with the default one.

mod dda;
mod dda_fixed;
mod double_step;
mod midpoint;
mod slope_intercept;
mod supercover;

pub use {
    dda::dda, dda_fixed::dda_fixed, double_step::double_step, midpoint::midpoint, slope_intercept::slope_intercept,
    supercover::supercover,
};
