//! What many samples of a pixel become: one colour.

pub(crate) mod mean;
mod sample_filter;
mod sample_target;

pub use mean::ChannelColor;
pub use sample_filter::{ConeFilter, SampleFilter, SampleSum, SampleWeights};
pub use sample_target::SampleTarget;
