//! A refresh of the display: the loop that walks a band down the picture, and what takes each band.

mod asynchronous;
mod asynchronous_pages;
mod dithered;
mod overlapping;
mod pages;
mod panel_rotation;
#[expect(clippy::module_inception, reason = "the loop without its variants")]
mod picture_loop;
mod sink;
mod supersampling;

pub use dithered::Dithered;
pub use overlapping::OverlappingSink;
pub use pages::{Page, PagesSink};
pub use panel_rotation::PanelRotation;
pub use picture_loop::{LoopError, PictureLoop, SceneResult};
pub use sink::{BytesSink, DisplaySink, Sink};
pub use supersampling::Supersampling;
