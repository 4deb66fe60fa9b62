//! What methods of hidden lines hand over: parts of edges.

use embedded_graphics::geometry::Point;

use crate::{geometry::SubPoint, view::ScreenPrecision};

/// A part of an edge that is hidden or visible as a whole, on the screen.
///
/// Programs that draw parts row by row keep them in a [`Picture`](crate::draw::Picture) until the models move: it has them in
/// buckets by their first rows, so that a row costs what it shows. Visible parts are antialiased there, hidden ones dashed:
///
/// ```
/// use embedded_graphics::{
///     pixelcolor::Gray8,
///     prelude::*,
///     primitives::{Line, Rectangle},
/// };
/// use zrow::fixed::types::{U16F16, U24F8};
/// use zrow::{
///     band::Band,
///     draw::{AntialiasingMemory, FillRule, LineCap, Picture, PictureSlot, StrokeStyle, SubLine},
///     geometry::{InputError, Sub8, SubPoint},
///     visible::{LinePart, PartKind},
/// };
///
/// const DASHES: [U16F16; 2] = [U16F16::lit("3"), U16F16::lit("2")];
///
/// fn keep(picture: &mut Picture<'_, '_, Gray8>, part: &LinePart<Sub8>) -> Result<(), InputError> {
///     if part.is_hidden {
///         let [start, end] = part.pixels();
///         let style = StrokeStyle::new(Gray8::new(90), 1).cap(LineCap::Butt).dashes(&DASHES);
///         picture.add(&Line::new(start, end).into_styled(style))?;
///     } else {
///         let [start, end] = part.ends;
///         picture.add_outline(&SubLine::new(start, end, U24F8::ONE)?, FillRule::NonZero, Gray8::WHITE)?;
///     }
///     Ok(())
/// }
///
/// let area = Rectangle::new(Point::zero(), Size::new(16, 16));
/// let (mut slots, mut pool, mut buckets) = ([PictureSlot::EMPTY; 2], [0; 96], [0; 16]);
/// let mut memory = AntialiasingMemory::<17, 8, 4>::new();
/// let mut picture = Picture::new(area, &mut slots, &mut pool, &mut buckets).with_antialiasing(&mut memory);
/// // What `Prepared::visible_parts` would hand over.
/// let at = |x, y| SubPoint::from_units(x * 256, y * 256);
/// for (ends, is_hidden) in [([at(1, 4)?, at(9, 4)?], false), ([at(9, 4)?, at(15, 4)?], true)] {
///     let kind = PartKind::Crease;
///     keep(&mut picture, &LinePart { model: 0, edge: Some(0), ends, kind, is_hidden })?;
/// }
/// let mut row = [0; 16];
/// picture.draw(&mut Band::<Gray8>::new(Rectangle::new(Point::new(0, 4), Size::new(16, 1)), &mut row)?);
/// assert_eq!(row, [0, 128, 255, 255, 255, 255, 255, 255, 255, 90, 90, 90, 0, 0, 90, 0]);
/// # Ok::<(), InputError>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LinePart<S: ScreenPrecision> {
    /// Index of the edge's model among the models; of an intersection that of the first of the two.
    pub model: usize,
    /// Index of the edge in the table of edges of its model; `None` for an intersection.
    pub edge: Option<usize>,
    /// The ends on the screen, from the edge's first to its second end.
    pub ends: [SubPoint<S>; 2],
    /// What kind of line the edge is.
    pub kind: PartKind,
    /// Whether faces hide the part. Technical drawings have hidden parts dashed, others leave them out.
    pub is_hidden: bool,
}

impl<S: ScreenPrecision> LinePart<S> {
    /// The pixels that the ends are in: their positions to the nearest pixel, halves to the right and down.
    pub fn pixels(&self) -> [Point; 2] {
        let nearest = |units: i32| (units + (1 << (S::FRACTION_BITS - 1))) >> S::FRACTION_BITS;
        let pixel = |end: &SubPoint<S>| Point::new(nearest(end.x_units()), nearest(end.y_units()));
        let [from, to] = &self.ends;
        [pixel(from), pixel(to)]
    }
}

/// What kind of line a part of an edge is in a line drawing.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum PartKind {
    /// Of the two faces at the edge one is seen from the front: the solid ends there as it is seen.
    Silhouette,
    /// The faces at the edge turn sharply, and both are seen.
    Crease,
    /// Only one face has the edge: the surface ends there.
    Boundary,
    /// Two faces penetrate each other there; no mesh has this edge.
    Intersection,
}
