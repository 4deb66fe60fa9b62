//! Visibility: what is seen of a scene, and what is hidden.
//!
//! # Hidden surfaces
//!
//! Which face is seen in each pixel is found by one of several methods, which all draw the same picture, to the bit.
//!
//! The default is the depth row, which [`Prepared::draw`](crate::scene::Prepared::draw) draws with: a depth buffer one row wide
//! is enough, because every face that crosses a row is drawn while that row is. Faces wait in a table by their first row (the y
//! table), and an active list carries those that have begun (Myers 1975).
//!
//! In the drawings, A is a face that is nearer than B. The demo scene `visibility-siblings` draws what each method really does,
//! which [`Prepared::draw_by_with`](crate::scene::Prepared::draw_by_with) reports as [`Work`]; `scan-line` shows the depth row
//! on its way down.
//!
//! ## Depth row
//!
//! A row of depths is cleared to the farthest one. Each face that crosses the row of pixels has a span in it, between its left
//! and its right edge, and is gone through pixel by pixel: where its plane is nearer than the depth that is there, the row of
//! depths takes that of the plane, and the band takes the colour of the face. Then edges and planes step to the next row, by
//! additions. Rows in which no faces overlap are drawn without depths.
//!
//! ```text
//! active list    A     |----------|          depths     0  0  7  7  7  7  5  5  5  0
//!                B            |--------|     seen             A  A  A  A  B  B  B
//! ```
//!
//! ## Depth buffer
//!
//! Each pixel of the picture has a depth and a face, so that faces may come in any order, each with all of its rows before the
//! next one. When all of them have been compared, what is seen is shaded, and nothing else.
//!
//! ```text
//!  .  .  .  .  .          .  .  B  B  B          A  A  A  B  B
//!  .  .  .  .  .   B ->   .  .  B  B  B   A ->   A  A  A  B  B
//!  .  .  .  .  .          .  .  .  .  .          A  A  A  .  .
//! ```
//!
//! ## One depth
//!
//! For each pixel, all faces that may cover it are asked: does it lie in the face, by a test of points in polygons, and is the
//! face nearer than the nearest one up to then? All that is kept is a depth and a face.
//!
//! ```text
//!  A  A  A  B  B
//!  A  A [x] B  B        x lies in B, with depth 5: B is seen. It lies in A, with depth 7: A is seen.
//!  A  A  A  .  .
//! ```
//!
//! ## Intervals of a scan line
//!
//! In a row, each face is a span, and the row is cut into intervals at columns where spans begin and end. Depths change evenly
//! along a row, so that a face which is the nearest at both ends of an interval is the nearest in between; where two faces go
//! through each other, the interval is cut once more. Each interval is shaded as a whole, what is hidden not at all.
//!
//! ```text
//! farther   B          ---------------        the row seen from above, with the eye below
//! nearer    A     ----------
//!                 |         |         |
//!           seen  AAAAAAAAAABBBBBBBBBB
//! ```
//!
//! ## Painter's algorithm
//!
//! Faces are sorted by depth and painted from back to front, over each other. Where the depths of two faces overlap, tests tell
//! which one has to come first: they are apart on the screen, or one of them lies wholly on one side of the plane of the other
//! one. Of faces that go through each other, or hide each other in a cycle, one is split by the plane of another.
//!
//! ```text
//!  . . . . . .        . . B B B B        A A A A B B        faces that go through each other:   B   A
//!  . . . . . .   ->   . . B B B B   ->   A A A A B B        A is split, and painted as              X
//!  . . . . . .        . . . . . .        A A A A . .        A behind B, B, A in front of B      A   B
//! ```
//!
//! What is mixed with what is behind it needs that order: translucent faces, and surfaces with antialiased silhouettes, which end
//! within a pixel. A surface covers a part of the pixel, the sum over all of its faces there, and that part of it is composited
//! over what was painted before. Were each face mixed by itself instead, what is behind would come through along the edges that
//! faces share.
//!
//! ```text
//!  background   B      A B                   3/4 of the pixel lie in A:  3/4 A + 1/4 (what B left there)
//!  ..........   BBBB   AA/BB                 two faces of A, 3/8 each, one by one: 3/8 A + 5/8 (3/8 A + 5/8 B),
//!  ..........   BBBB   AAA/B                 which is 39/64 A, and not 48/64
//! ```
//!
//! ## Warnock's subdivision
//!
//! Look at the whole window: what is seen in it is obvious if it has no face, or one alone, or a face that surrounds it and is
//! nearer than all others. Otherwise look at its four quarters, and at theirs, down to single pixels. So the work lies along
//! the edges that are seen.
//!
//! ```text
//! +---------+----+----+
//! |         |    | /A |        upper left: no face; lower right: A surrounds it, and B behind it is hidden
//! |         +----+/---+        the others: divided, along the edge of A
//! |         |   /| A  |
//! +----+----+----+----+
//! |    |  / |         |
//! +----+-/--+    A    |
//! |   /| A  |         |
//! +----+----+---------+
//! ```
//!
//! ## Ray casting
//!
//! A ray goes through each pixel, and what it meets first is seen. Faces lie in boxes, and boxes in larger ones: a ray asks
//! only for what is in the boxes that it enters, and opens none that is farther away than what it has met.
//!
//! ```text
//!            +--------------------+
//!            | +-----+     +----+ |        the outer box is entered, then that of A, where A is met:
//! eye - - - -|-|- -A |     | B  | |        the box of B lies behind, and is not opened
//!            | +-----+     +----+ |
//!            +--------------------+
//! ```
//!
//! ## Tile bins
//!
//! The picture is cut into tiles, and each tile gets a list of the faces whose boxes meet it. Then tiles are drawn one after
//! the other, or by several cores, with a depth buffer of one tile. Blocks of pixels on the outer side of an edge are rejected
//! as a whole, and those on the inner sides of all edges accepted.
//!
//! ```text
//! +------+------+------+
//! | A    | A B  |   B  |        lists:  A | A B | B
//! +------+------+------+                A | A B | B
//! | A    | A B  |   B  |
//! +------+------+------+
//! ```
//!
//! ## Which one to take
//!
//! A look that is [`VisibleBy`](crate::scene::VisibleBy) another [`Visibility`] draws by it, and
//! [`Prepared::draw_by`](crate::scene::Prepared::draw_by) takes one, to compare them:
//!
//! - [`DepthBuffer`]: a depth and a face for each pixel (Catmull 1974). Where memory is plenty.
//! - [`DepthSort`]: faces sorted by depth and painted from back to front, with splits (Newell, Newell and Sancha 1972), also
//!   translucent ones, those with holes, and those with antialiased silhouettes. Where few faces overlap.
//! - [`GridRayCasting`]: a ray for each pixel that marches through the cells of a grid (Amanatides and Woo 1987). To compare with the
//!   tree of boxes, which most often takes less.
//! - [`OneDepth`]: one depth, pixel by pixel (Rogers 1985). Where no memory is left.
//! - [`RayCasting`]: a ray for each pixel through a tree of boxes (Appel 1968; Rubin and Whitted 1980). For huge scenes in few
//!   pixels.
//! - [`SolidCombination`]: union, intersection and difference of solids, along a ray for each pixel (Roth 1982). The one method
//!   with a picture of its own, which only closed solids have.
//! - [`SpanScanLine`]: depths compared at the ends of intervals (Watkins 1970). For few large faces that take long to shade.
//! - [`TileBins`]: lists of faces for tiles of 16 x 16 pixels, and a depth buffer of one tile (Fuchs and others 1989). For wide
//!   panels, and for several cores.
//! - [`Warnock`]: quarters of the window until one face is seen in them (Warnock 1969). Where faces are large.
//!
//! # Hidden lines
//!
//! Which parts of the edges of models are hidden: [`Prepared::visible_parts`](crate::scene::Prepared::visible_parts) takes one of
//! the methods ([`HiddenLines`]) and hands over each edge in [parts](LinePart):
//!
//! - [`Appel`]: the number of faces in front of an edge, counted once and carried along the edges (Appel 1967). For many edges that
//!   are connected.
//! - [`FaceAgainstSegment`]: each edge compared with each face (Galimberti and Montanari 1969). For solids of any shape, also
//!   where they penetrate each other.
//! - [`Roberts`]: edges against convex solids, with the new edges where solids penetrate each other (Roberts 1963).
//!
//! The demo scene `hidden-lines` draws by all three.
//!
//! ## Face against segment
//!
//! An edge goes through all faces, the nearest first. A face that hides its middle leaves two segments: one goes on with the
//! next face, the other one waits on a stack with the face that it has to go on with. What comes past the last face is visible.
//!
//! ```text
//!  P ------------------------- Q
//!  P ---|  A  |--------------- Q      A hides the middle; the left segment goes on, the right one waits
//!  P ---|  A  |----|  B  |---- Q      left is past all faces: visible. B hides a part of the right one
//! ```
//!
//! ## Roberts
//!
//! A convex solid is what lies behind the planes of all its faces. An edge is hidden by it where rays from its points towards
//! the viewer meet the solid, which is one interval of the edge, whose ends follow from one inequality for each plane. Where an
//! edge pierces a face of another solid, a new edge begins that no mesh has.
//!
//! ```text
//!           +-------+
//!          /         \
//!  P -----+===========+----- Q      hidden between the least and the greatest parameter that all planes allow
//!          \         /
//!           +-------+
//! ```
//!
//! ## Appel
//!
//! The quantitative invisibility of a point is the number of faces in front of it. Along an edge it changes only where that passes
//! behind a contour, a side of a face that is seen without such a face on its other side, or goes through a face. So a ray
//! counts the faces in front of one vertex, and from there the number is carried along all edges that are connected with it.
//! Lines in which faces penetrate each other are walked likewise, without the two faces that they lie in.
//!
//! ```text
//!          +-----------+---+
//!  P ---+=======/=======+--- Q      two faces that share a side: behind the outer sides the number changes, behind the shared
//!    0  |   1  /    1   |  0        one it does not
//! ```
//!
//! # The depth test
//!
//! What is drawn into the rows of a scene is tested against its depths by a [`DepthState`]: shapes and texts at a depth, a
//! [`DepthLine`] for a wireframe, a [`DepthPolygon`] of any shape, and the faces of another scene.

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
mod depth_test;
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
mod silhouette_painter;
mod silhouette_pixels;
mod silhouette_row;
mod touched_columns;
mod visibility;
mod work;

pub use depth_test::{Comparison, DepthLine, DepthPolygon, DepthState, PolygonOffset};
pub use hidden_lines::{Appel, FaceAgainstSegment, HiddenLines, LinePart, PartKind, Roberts};
pub use hidden_surfaces::{
    DepthBuffer, DepthSort, DepthSortCounters, GridRayCasting, OneDepth, RayCasting, SolidCombination, SolidNode,
    SpanScanLine, TileBins, Warnock,
};
pub use visibility::Visibility;
pub(crate) use visibility::{ByMethod, LookVisibility, Method, NewMethod};
pub use work::Work;

pub(crate) use active_face::ActiveFace;
pub(crate) use active_faces::{ActiveFaces, ActiveList, DepthUse, FEW};
pub(crate) use count::Count;
pub(crate) use depth_row::DepthRow;
pub(crate) use depth_test::{slope_of_face, twice_the_area};
pub(crate) use face_edges::FaceEdges;
pub(crate) use face_table::{ColoredFace, FaceTable, NONE};
pub(crate) use hidden_lines::{LineEdge, LineFace, LinePoint, LineTable};
pub(crate) use hidden_surfaces::face_at;
pub(crate) use painter::BandPainter;
pub(crate) use reporting_painter::ReportingPainter;
pub(crate) use silhouette_edge::ActiveEdge;
pub(crate) use silhouette_painter::SilhouettePainter;
pub(crate) use silhouette_row::{ByArea, EdgeRow, Entry, RowEdges, Silhouettes};
