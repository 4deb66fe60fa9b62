//! The methods that find out which face is seen in each pixel, one file each.

mod depth_buffer;
mod placed;

pub use depth_buffer::DepthBuffer;
