//! A refresh of the display: the loop that walks a band down the picture, and what takes each band.

mod asynchronous;
mod dithered;
mod overlapping;
mod pages;
#[expect(clippy::module_inception, reason = "the loop without its variants")]
mod picture_loop;
mod rotated;
mod sink;
mod supersampling;

pub use dithered::Dithered;
pub use overlapping::OverlappingSink;
pub use pages::{Page, PagesSink};
pub use picture_loop::{LoopError, PictureLoop, SceneResult};
pub use rotated::Rotated;
pub use sink::{BytesSink, DisplaySink, Sink};
pub use supersampling::Supersampling;
