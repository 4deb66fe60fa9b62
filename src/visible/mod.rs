//! Hidden surfaces, and hidden lines: which face is seen in each pixel, found by one of several methods that all draw the same
//! picture, and which parts of edges are hidden.
//!
//! The default is the depth row, which [`Prepared::draw`](crate::scene::Prepared::draw) draws with: a depth buffer one row wide
//! is enough, because every face that crosses a row is drawn while that row is. Faces wait in a table by their first row (the y
//! table), and an active list carries those that have begun (Myers 1975).
//!
//! [`Prepared::draw_by`](crate::scene::Prepared::draw_by) takes another [`Visibility`]:
//!
//! - [`DepthBuffer`]: a depth and a face for each pixel (Catmull 1974). Where memory is plenty.
//! - [`DepthSort`]: faces sorted by depth and painted from back to front, with splits (Newell, Newell and Sancha 1972). Where
//!   few faces overlap.
//! - [`OneDepth`]: one depth, pixel by pixel (Rogers 1985). Where no memory is left.
//! - [`RayCasting`]: a ray for each pixel through a tree of boxes (Appel 1968; Rubin and Whitted 1980). For huge scenes in few
//!   pixels.
//! - [`SpanScanLine`]: depths compared at the ends of intervals (Watkins 1970). For few large faces that take long to shade.
//! - [`TileBins`]: lists of faces for tiles of 16 x 16 pixels, and a depth buffer of one tile (Fuchs and others 1989). For wide
//!   panels, and for several cores.
//! - [`Warnock`]: quarters of the window until one face is seen in them (Warnock 1969). Where faces are large.
//!
//! Hidden lines: which parts of the edges of models are hidden. [`Prepared::visible_parts`](crate::scene::Prepared::visible_parts)
//! takes one of the methods ([`HiddenLines`]) and hands over each edge in [parts](LinePart):
//!
//! - [`FaceAgainstSegment`]: each edge compared with each face (Galimberti and Montanari 1969). For solids of any shape, also
//!   where they penetrate each other.

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
mod hidden_lines;
mod hidden_surfaces;
mod painter;
mod passes;
mod reporting_painter;
mod row_in_passes;
mod row_of_samples;
mod shaded_span;
mod sides;
mod silhouette_edge;
mod silhouette_pixels;
mod silhouette_row;
mod touched_columns;
mod visibility;
mod work;

pub use hidden_lines::{FaceAgainstSegment, HiddenLines, LinePart, PartKind};
pub use hidden_surfaces::{
    DepthBuffer, DepthSort, DepthSortCounters, OneDepth, RayCasting, SpanScanLine, TileBins, Warnock,
};
pub use visibility::Visibility;
pub use work::Work;

pub(crate) use active_face::ActiveFace;
pub(crate) use active_faces::{ActiveFaces, ActiveList, DepthUse};
pub(crate) use count::Count;
pub(crate) use depth_row::DepthRow;
pub(crate) use face_edges::FaceEdges;
pub(crate) use face_table::{ColoredFace, FaceTable, NONE};
pub(crate) use hidden_lines::{LineEdge, LineFace, LinePoint, LineTable};
pub(crate) use hidden_surfaces::face_at;
pub(crate) use painter::BandPainter;
pub(crate) use reporting_painter::ReportingPainter;
pub(crate) use silhouette_edge::ActiveEdge;
pub(crate) use silhouette_row::{ByArea, EdgeRow, Entry, RowEdges, Silhouettes};
