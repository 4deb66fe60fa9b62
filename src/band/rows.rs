//! The words of a band as the fillers of symmetric shapes take them.

use crate::geometry::Window;

/// The words of a band and where they lie.
pub(super) struct BandRows<'a, W> {
    pub words: &'a mut [W],
    pub window: Window,
    pub stride: usize,
}
