//! The four parts of the pot: a grid of patches each, and what covers it.

use super::patches::{BODY, HANDLE, LID, Patch, SPOUT};

/// A grid of patches that is closed around.
#[derive(Debug)]
pub struct Part {
    /// Row by row, from the top or from the body on.
    pub patches: &'static [Patch],
    /// Patches of a row.
    pub columns: usize,
    /// Which row of vertices is one point.
    pub pole: Pole,
    /// The texture coordinate u a patch further around.
    pub u_step: i16,
    /// Whether u returns to 0 after half of the way around, so that it has no seam.
    pub mirrored: bool,
    /// The texture coordinate v at the borders of the rows of patches.
    pub v: &'static [i16],
    /// Red, green and blue.
    pub color: [i64; 3],
}

/// Which row of a part's grid of vertices, if one, lies in a single point of the surface.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub enum Pole {
    /// In the first row.
    First,
    /// In the last row.
    Last,
    /// No row: the part is open at both ends.
    None,
}

/// Body, lid, handle and spout, in the order in which the meshes have them.
pub const PARTS: [Part; 4] = [
    Part {
        patches: &BODY,
        columns: 4,
        pole: Pole::Last,
        u_step: 2048,
        mirrored: false,
        v: &[0, 170, 1210, 1820, 2830],
        color: [236, 146, 84],
    },
    Part {
        patches: &LID,
        columns: 4,
        pole: Pole::First,
        u_step: 2048,
        mirrored: false,
        v: &[0, 540, 1300],
        color: [240, 200, 104],
    },
    Part {
        patches: &HANDLE,
        columns: 2,
        pole: Pole::None,
        u_step: 512,
        mirrored: true,
        v: &[0, 950, 1900],
        color: [110, 170, 220],
    },
    Part {
        patches: &SPOUT,
        columns: 2,
        pole: Pole::None,
        u_step: 1024,
        mirrored: true,
        v: &[0, 1340, 1540],
        color: [122, 198, 140],
    },
];
