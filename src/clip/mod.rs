//! Clipping: outcodes decide what can be skipped, one file per algorithm cuts the rest.
//!
//! Which drawing path calls which: shapes of whole pixels (lines, polylines, circles, ...) are never cut. Their
//! outcodes or bounding boxes say whether they are visible, and the scan conversion then enters the window with an
//! exact error term, so clipping moves no pixel. The clippers here serve sub-pixel segments and polygons, and whoever
//! needs the visible part of one. Faces of a scene are cut where they cross the near plane or leave the guard band.
//!
//! | what | against | | take it when |
//! |---|---|---|---|
//! | segment | upright window | [`liang_barsky`](Segments::liang_barsky) | by default |
//! | | | [`cohen_sutherland`](Segments::cohen_sutherland) | flash counts |
//! | | | [`nicholl_lee_nicholl`](Segments::nicholl_lee_nicholl) | to see how areas of the plane decide |
//! | | | [`midpoint_subdivision`](Segments::midpoint_subdivision) | nothing multiplies or divides |
//! | | convex window | [`cyrus_beck`](Segments::cyrus_beck) | the window is not upright, or there are several |
//! | segment in space | what a camera sees | [`homogeneous_liang_barsky`](Segments::homogeneous_liang_barsky) | by default |
//! | | | [`homogeneous_cohen_sutherland`](Segments::homogeneous_cohen_sutherland) | most segments are inside or on one side |
//! | | | [`eye_space`](Segments::eye_space) | to see that homogeneous clipping is clipping in space |
//! | | convex volume | [`cyrus_beck_in_space`](Segments::cyrus_beck_in_space) | planes bound something else: a room, a portal |
//! | polygon | convex window | [`sutherland_hodgman_2d`](crate::geometry::ConvexWindow::sutherland_hodgman_2d) | the window is convex |
//! | | polygon | [`greiner_hormann`](Clipper::greiner_hormann) | it is not, has holes, or is to be joined or subtracted |
//! | | | [`weiler_atherton`](Clipper::weiler_atherton) | to see the same result found by walks along both outlines |
//! | face in space | what a camera sees | [`sutherland_hodgman`](ClipMatrix::sutherland_hodgman) | with its attributes, before the division |
//! | | | [`sutherland_hodgman_in_eye_space`](ClipMatrix::sutherland_hodgman_in_eye_space) | distances are wanted in space |
//! | circle | pixels | [`circle_against_window`](Classification::circle_against_window) | many circles are off the screen, or larger than it |
//! | rectangle | pixels | [`rectangle_against_window`](Classification::rectangle_against_window) | what is in the box is dearer than the box: text, images |
//!
//! In space, [`ClipMatrix`] takes vertices to homogeneous clip coordinates, and [`ClipPoint::on_screen`] divides them: the
//! textbook's way to the screen, which scenes shorten. What a triangle looks like that is not clipped at all,
//! [`Polygons::homogeneous_triangle`](crate::scan::Polygons::homogeneous_triangle) shows.
//!
//! All clippers of segments give the same integers in an upright window, and in space the same exact parts.

mod boolean;
mod classification;
pub(crate) mod convex;
mod outcode;
pub(crate) mod segment;
pub(crate) mod shape;
mod space;

pub use boolean::{Clipper, Contour, Operation};
pub use classification::Classification;
pub use convex::ParametricSegment;
pub(crate) use outcode::Outcode;
pub use segment::Segments;
pub use space::{ClipMatrix, ClipPlane, ClipPoint, SpaceSegment};
