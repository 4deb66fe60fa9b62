//! 2D drawing: styles, and embedded-graphics' shapes through scan conversion into a target.
//!
//! Changing over is the `use` line: with this module's [`PrimitiveStyle`] instead of embedded-graphics' own,
//! `shape.into_styled(style).draw(&mut display)` is drawn by zrow; `into` makes such a style of what embedded-graphics'
//! `PrimitiveStyleBuilder` builds. On a [`Target`](crate::surface::Target), [`DrawOn::draw_on`] is the faster way.
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
//! `Rectangle`, `Circle` and `Ellipse` have embedded-graphics' pixels for every style. A circle or an ellipse has the
//! pixels whose centres satisfy its inequality in doubled coordinates; a stroke has the pixels of its outer shape that
//! are not in its inner shape. Each pixel is drawn once. Any position and size can be drawn, and the cost depends on
//! the visible part only. The exceptions are sizes for which embedded-graphics' numbers overflow (ellipses from about
//! 217 x 216, circles from 32,769), and ellipses without a pixel in the first row of their box (2 x 8, 4 x 32), of
//! which embedded-graphics draws nothing. [`ThinCircle`] is Bresenham's circle, a shape of its own.
//!
//! # Arcs, sectors, rounded rectangles
//!
//! `Arc`, `Sector` and `RoundedRectangle` have embedded-graphics' pixels for every style, too. Here, angles are turned
//! into directions by micromath's sine and cosine on every machine. embedded-graphics uses micromath on a
//! microcontroller, but the standard library where another crate of the program links that, and some pixels along the
//! sides of a sector then differ. An angle of 2^22 turns or more, an infinite angle and one that is not a number have
//! no direction: every pixel counts as lying on the line along such an angle. embedded-graphics does the same, until
//! its numbers overflow from 2^31 turns on.
//!
//! A `RoundedRectangle` is a rectangle without what its corners cut off. A corner's box is as large as its radius, and
//! the corner cuts off the pixels of that box which are outside the ellipse about the box's innermost corner. The
//! stroke has the pixels of the outer shape that are not in the inner shape; the fill has the pixels of both. Radii
//! that exceed a side are scaled down by embedded-graphics' rule. Where the boxes of corners overlap even then (1 x 12
//! pixels with radii of 7 x 13), every corner still cuts off its pixels, which may leave nothing of a row. The pixels
//! differ from embedded-graphics' in three cases: where boxes overlap (embedded-graphics may draw only one of two
//! corners), where it draws a corner square (rows in which a quarter ellipse has no pixel, such as 1 x 4: here they are
//! cut off), and where it loses the stroke (around an area without columns).
//!
//! # Wide strokes
//!
//! Wider than a pixel, the stroke of a `Line`, a `Polyline`, a `Triangle` or a [`Polygon`] is the union of
//! - for each segment the rectangle of the stroke's width along it, with its corners rounded to 1/65,536 pixel. At each
//!   end of an open path, the rectangle is half a pixel longer, so that a line reaches to the outer sides of the pixels
//!   of its end points;
//! - for each corner the wedge between the outer corners of both rectangles: up to the tip where their outer sides meet
//!   (miter join) or, where the tip is further from the corner than twice the width, up to the straight line between
//!   them (bevel join), as in embedded-graphics.
//!
//! The stroke has the pixels whose centres are inside, each once; a centre exactly on an edge counts by the top-left
//! rule. Upright and level lines therefore have embedded-graphics' pixels, except for even widths: here the additional
//! row or column is the one above or to the left, for either order of the end points; embedded-graphics has it below or
//! to the right where a line runs to the left or downwards. Of these four shapes, the stroke alignment of a style
//! applies to `Triangle` and [`Polygon`] only; the stroke of the others is centred, and so is that of a [`Path`] that is
//! not antialiased. Memory: none that grows with the number of vertices. Segments that end beyond 16,384 pixels are
//! first cut there, at 1/65,536 pixel; within 8,192 pixels nothing else moves. Widths above 4,096 pixels are drawn as
//! 4,096, and those of strokes inside or outside of a [`Polygon`] above 2,048 as 2,048.
//!
//! A [`StrokeStyle`] has other caps, other joins and dashes.
//!
//! # Bounding boxes
//!
//! The bounding box of a styled shape is the smallest one around the pixels of its fill and its stroke, whichever of
//! the two have a colour; it is empty where there are no pixels. In a [`PrimitiveStyle`] with a stroke width of 0, the
//! box of a line, a polyline or a path is that of its stroke of one pixel, and the box of an arc is that of its whole
//! circle. embedded-graphics' box is larger for arcs and sectors (around the whole circle), for wide strokes with
//! corners, and for narrow ellipses.
//!
//! Finding the box costs less than drawing the shape, with two exceptions: dashed strokes, whose dashes are followed
//! one by one, and polygons some of whose corners end between pixel centres, where up to 1,024 rows or columns are
//! examined on each side.

mod antialiased;
mod chains;
pub(crate) mod eg;
mod filled_edges;
mod outline;
mod painted;
mod painted_shape;
mod payload;
mod picture;
#[cfg(test)]
mod pictures;
mod prepared_shape;
mod shapes;
mod style;
mod text;
mod through_generic;

#[doc(no_inline)]
pub use crate::scan::polygon::scanline_polygon::FillRule;
pub use crate::scan::stroke::{LineCap, LineJoin};
pub use antialiased::{AntialiasedPolygon, DrawAntialiased, FilteredLine, SubArc, SubEllipse, SubLine, SubOutline};
#[doc(no_inline)]
pub use embedded_graphics::primitives::StrokeAlignment;
pub use outline::AntialiasingMemory;
pub use painted_shape::PaintedShape;
pub use picture::{DrawableItem, Group, ItemId, Picture, PictureItem, PictureSlot};
pub use prepared_shape::PreparedShape;
pub use shapes::{Path, PathCommand, Points, Polygon, SeedFill, ThinCircle};
pub use style::{Antialiased, BlendOn, DrawOn, PrimitiveStyle, StrokeStyle};
pub(crate) use style::{StrokedShape, StyledShape};
pub use text::{MaskFont, MaskGlyph, MaskTextStyle, OutlineFont, OutlineGlyph, OutlineTextStyle};

use through_generic::{drawable_through_generic, stroked_through_generic};
