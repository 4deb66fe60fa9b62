//! Coverage by samples and by sub-scanlines.

mod centre_sample;
mod rooks;
mod sample_pattern;
mod scanline;
mod siblings;
mod sub_scanlines;
mod weights;

pub use centre_sample::CentreSample;
pub use rooks::Rooks;
pub use sample_pattern::SamplePattern;
pub use siblings::Grid;
pub use sub_scanlines::SubScanlines;
pub use weights::{Bartlett, BoxFilter, Gaussian, Weights};
