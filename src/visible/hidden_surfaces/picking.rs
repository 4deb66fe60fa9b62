//! Which face is seen in one pixel: a ray that is asked about all faces.
//!
//! Guarantees: the face that every method draws there. Cost: a look at each face that begins in the pixel's row or above it, a test
//! of the sides of each that crosses the row, and the plane of each that covers the pixel. No memory.

use crate::{
    shade::Shading,
    view::{DepthWidth, ScreenPrecision},
    visible::{
        face_table::{FaceTable, NONE, covers},
        hidden_surfaces::placed::nearest_of_all,
    },
};

/// The face that is seen in a pixel, by its index in the order of models and faces.
pub(crate) fn face_at<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    [column, row]: [i32; 2],
) -> Option<usize> {
    let node = nearest_of_all(faces, ([column, row], 0), |node| covers(faces, node, column, row));
    (node != NONE).then(|| usize::from(faces.order(node)))
}
