//! A level of detail: a coarser mesh, and from where on it is picked.

/// A coarser mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct Level {
    /// How many vertices of the finest mesh it takes, from the first on.
    pub vertices: usize,
    /// Its faces.
    pub faces: Vec<[u16; 3]>,
    /// Their colours.
    pub colors: Vec<[u8; 3]>,
    /// The greatest distance of a vertex of the finest mesh from its faces, in units.
    pub greatest_error: f64,
    /// The mean distance.
    pub mean_error: f64,
}

/// From which distance on an error in units is at most half a pixel, for a focal length in pixels.
pub fn pick_from(error: f64, focal_length: u16) -> u32 {
    // `as` saturates.
    (2.0 * error * f64::from(focal_length)).ceil() as u32
}
