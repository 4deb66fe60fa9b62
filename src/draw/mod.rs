//! 2D drawing: styles, and embedded-graphics' shapes through scan conversion into a target.
//!
//! Changing over is the `use` line: with this module's [`PrimitiveStyle`] instead of embedded-graphics' own,
//! `shape.into_styled(style).draw(&mut display)` is drawn by zrow. On a [`Target`](crate::surface::Target),
//! [`DrawOn::draw_on`] is the faster way.
//!
//! ```
//! use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*, primitives::Circle};
//! // Before: use embedded_graphics::primitives::PrimitiveStyle;
//! use zrow::draw::PrimitiveStyle;
//!
//! let mut display = MockDisplay::new();
//! Circle::new(Point::new(1, 0), 5)
//!     .into_styled(PrimitiveStyle::with_stroke(BinaryColor::On, 1))
//!     .draw(&mut display)?;
//! display.assert_pattern(&[
//!     "  ### ",
//!     " ## ##",
//!     " #   #",
//!     " ## ##",
//!     "  ### ",
//! ]);
//! # Ok::<(), core::convert::Infallible>(())
//! ```
//!
//! # Rectangles, circles, ellipses
//!
//! `Rectangle`, `Circle` and `Ellipse` have embedded-graphics' pixels for every style: a circle or an ellipse the pixels of
//! its inequality in doubled coordinates, a stroke what its outer shape has more than its inner one. Each pixel is drawn
//! once. Any position and size is drawn, and costs what is visible of it. The exceptions are where embedded-graphics'
//! numbers overflow (ellipses from about 217 x 216, circles from 32,769), and ellipses without a pixel in the first row
//! of their box (2 x 8, 4 x 32), of which it draws none. [`ThinCircle`] is Bresenham's circle, a shape of its own.
//!
//! # Arcs, sectors, rounded rectangles
//!
//! `Arc`, `Sector` and `RoundedRectangle` have embedded-graphics' pixels for every style, too. Angles are decided by
//! micromath's sines on every machine; embedded-graphics takes them from there on a microcontroller, but from the standard
//! library where another crate of the program links that, and some pixels along the sides of a sector differ there. An
//! angle of 2^22 turns and more, an infinite one and one that is not a number have no direction, and every pixel counts as
//! lying on the line along it; so it is in embedded-graphics, until its numbers overflow from 2^31 turns on.
//!
//! A `RoundedRectangle` is what its corners leave of the rectangle. A corner's box is as large as its radius, and the
//! corner cuts off the pixels of that box which are outside the ellipse about the box's innermost corner. The stroke is
//! what the outer shape has and the inner one has not, the fill is what both have. Radii that take more than a side are
//! scaled down by embedded-graphics' rule. Where boxes of corners overlap even then (1 x 12 pixels with radii of 7 x 13),
//! every corner cuts off its pixels, which may leave nothing of a row. The exceptions from embedded-graphics' pixels are
//! there (it may draw one corner of two), where it draws a corner square (rows in which a quarter ellipse has no pixel,
//! such as 1 x 4: here they are cut off), and where it loses the stroke (around an area without columns).
//!
//! # Wide strokes
//!
//! Wider than a pixel, the stroke of a `Line`, a `Polyline`, a `Triangle` or a [`Polygon`] is the union of
//! - for each segment the rectangle of the stroke's width along it, with its corners rounded to 1/65,536 pixel. At the ends
//!   of an open path it is half a pixel longer, so that a line reaches to the outer sides of the pixels of its end points;
//! - for each corner the wedge between the outer corners of both rectangles: up to the tip where their outer sides meet
//!   (miter join) or, where the tip is further from the corner than twice the width, up to the straight line between them
//!   (bevel join), as in embedded-graphics.
//!
//! It takes the pixels whose centres are inside, on a tie by the top-left rule, each once. Upright and level lines so have
//! embedded-graphics' pixels. The exception are even widths: the odd row or column out is the one above or to the left
//! here, for either order of the end points; embedded-graphics has it below or to the right where a line runs to the left
//! or downwards. The alignment counts for closed shapes. Memory: none that grows with the number of vertices. Segments that
//! end beyond 16,384 pixels are first cut there, at 1/65,536 pixel; within 8,192 pixels nothing else moves. Widths beyond
//! 4,096 pixels count as 4,096.
//!
//! A [`StrokeStyle`] has other ends, other corners and dashes.
//!
//! # Bounding boxes
//!
//! The bounding box of a styled shape is the smallest one around the pixels of its fill and its stroke, whichever of the two
//! have a colour, and empty where there are none. embedded-graphics' box is larger for arcs and sectors (around the whole
//! circle), for wide strokes with corners, and for narrow ellipses. Finding it costs less than drawing the shape, but for
//! dashed strokes, whose dashes are followed one by one, and for polygons some of whose corners end between pixel centres:
//! there, up to 1,024 rows or columns a side are looked at.

mod antialiased;
mod eg;
mod filled_edges;
mod painted;
mod picture;
#[cfg(test)]
mod pictures;
mod shapes;
mod style;
mod through_generic;

#[doc(no_inline)]
pub use crate::scan::polygon::scanline_polygon::FillRule;
pub use crate::scan::stroke::{DashPattern, LineCap, LineJoin};
pub use antialiased::{
    AntialiasedPolygon, AutoCoverage, CoverageChoice, FilteredLine, SubArc, SubEllipse, SubLine, SubOutline,
};
pub use eg::{StyledAreas, StyledPixels};
#[doc(no_inline)]
pub use embedded_graphics::primitives::StrokeAlignment;
pub use painted::Painted;
pub use picture::{AntialiasedItem, ItemId, Picture, PictureItem, PictureSlot, Prepare};
pub use shapes::{
    Connectivity, Path, PathCommand, Points, Polygon, PreparedPath, PreparedPolygon, SeedFill, ThinCircle,
};
pub use style::{DrawOn, PrimitiveStyle, PrimitiveStyleBuilder, StrokeStyle, StrokedShape, StyledShape};

use through_generic::{drawable_through_generic, stroked_through_generic, styled_by_reference};
