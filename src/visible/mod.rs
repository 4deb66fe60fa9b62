//! Hidden surfaces: the row loop with the depth row.
//!
//! A depth buffer one row wide is enough, because every face that crosses a row is drawn while that row is: faces wait
//! in a table by their first row, and an active list carries those that have begun.

// Why seldom taken functions are marked as cold in these files and in those of `scene`: without the marks, a frame of the torus
// and cube takes 0.4 % more instructions on a Cortex-M3 and 1.6 % more on a Cortex-M0+, preparing it 1.5 % and 0.7 %. They cost
// 100 bytes of flash.
//
// Why small functions are `inline(always)` in `active_face`: with `inline` alone, a frame of the torus and cube takes 2.3 %
// more instructions on a Cortex-M3, the icosphere 1.3 %.

mod active_face;
mod active_faces;
mod at_depth;
mod attribute_planes;
mod blended_row;
mod count;
mod depth_plane;
mod depth_row;
mod divided_runs;
mod edge;
mod face_edges;
mod face_table;
mod passes;
mod row_in_passes;
mod row_of_samples;
mod shaded_span;
mod sides;
mod silhouette_edge;
mod silhouette_pixels;
mod silhouette_row;
mod touched_columns;

pub use depth_row::DepthRow;

pub(crate) use active_face::ActiveFace;
pub(crate) use active_faces::{ActiveFaces, ActiveList, DepthUse};
pub(crate) use count::Count;
pub(crate) use face_edges::FaceEdges;
pub(crate) use face_table::{ColoredFace, FaceTable, NONE};
pub(crate) use silhouette_edge::ActiveEdge;
pub(crate) use silhouette_row::{ByArea, EdgeRow, Entry, RowEdges, Silhouettes};
