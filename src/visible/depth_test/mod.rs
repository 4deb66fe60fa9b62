//! The depth test as a value: what is drawn into the rows of a scene beside the scene itself is tested against its depths by a
//! [`DepthState`], as OpenGL's fragments are.
//!
//! ```text
//!     depth of the pixel -> mapped to a range -> + factor * slope + units -> kept in the range -> compared -> drawn -> written
//!                           glDepthRange         glPolygonOffset                                  glDepthFunc          glDepthMask
//!
//!     larger     |  stored   __________                        Nearer is larger. The line is drawn with an offset: it is seen
//!     = nearer   |      ____/          \       line + offset   over the face that it belongs to, and not over what is nearer
//!                |  ___/  . . . . . . . .\. . . . . . . . .    by more than the offset.
//!                |                        \______
//!                +----------------------------------> column
//! ```
//!
//! Four things are drawn so: shapes and texts at a constant depth (`row.at_depth_with(depth, &state)`), lines between two depths
//! (`row.draw_line(&line, color, &state)`), planar polygons of any shape (`row.draw_polygon(&mut polygon, color, &state)`) and the
//! faces of another scene ([`Prepared::draw_in`](crate::scene::Prepared::draw_in)), which come in the order of models and faces.
//!
//! Guarantees: each pixel is what a depth buffer of the whole picture would have after the same things in the same order, in
//! bands of any height and in any order of rows. Nothing wraps. Where none of it is used, nothing is linked or slower.
//!
//! Source: Catmull 1974; Segal and Akeley 1997, "The OpenGL Graphics System, Version 1.1", sections 3.5.5 and 4.1.6.

mod comparison;
mod faces;
mod line;
mod polygon;
mod state;

pub use comparison::Comparison;
pub use line::DepthLine;
pub use polygon::DepthPolygon;
pub use state::{DepthState, PolygonOffset};

pub(crate) use polygon::twice_the_area;
pub(crate) use state::slope_of_face;
pub(super) use state::{DepthTest, Nearer, Test};
