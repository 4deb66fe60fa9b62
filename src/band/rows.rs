//! The words of a band as the fillers of symmetric shapes take them.

use crate::geometry::Window;

/// The words of a band, one a pixel in rows of `stride` words, and the window of the picture that they stand for.
pub(super) struct BandRows<'a, W> {
    pub words: &'a mut [W],
    pub window: Window,
    pub stride: usize,
}
