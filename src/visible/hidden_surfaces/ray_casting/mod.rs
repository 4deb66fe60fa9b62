//! Ray casting: for each pixel a ray from the eye, and the faces that it may meet, found in a structure that holds them.
//!
//! ```text
//!                   ______
//!     eye  .-------|------|---A----B--->         Of the faces that the ray through the centre of a pixel meets, the pixel
//!                  |______|                      shows the nearest one. A structure spares most faces the question: a tree
//!                                                of boxes, or the cells of a grid that the ray marches through.
//! ```
//!
//! A ray that counts in which solids it is draws solids that are combined: their union, intersection and difference.
//!
//! Guarantees: whether a face covers a pixel, and its depth there, are decided as in all methods; structures only leave out what
//! cannot be seen.
//!
//! Source: Appel 1968, "Some techniques for shading machine renderings of solids".

mod box_tree;
mod by_grid;
mod by_tree;
mod eye_space;
mod ray_march;
mod solid_combination;
mod solid_tree;
mod uniform_grid;

pub use by_grid::GridRayCasting;
pub use by_tree::RayCasting;
pub use solid_combination::SolidCombination;
pub use solid_tree::SolidNode;

use crate::geometry::Window;

/// How many units the depth of a face in a pixel may be nearer than all its corners, or nearer than the exact plane through them.
fn depth_margin(viewport: &Window) -> i32 {
    let Window {
        left,
        top,
        right,
        bottom,
    } = *viewport;
    // Gradients are rounded once: a depth is wrong by less than 1/256 unit for each column and row.
    2 + ((right - left + bottom - top) >> 8)
}
