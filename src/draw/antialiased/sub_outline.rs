//! Outlines of shapes at 1/256 pixel, as edges: the input of antialiasing.
//!
//! A shape calls a function with the ends of each edge, one contour after the other, so that no memory for the outline
//! is needed.

use core::ops::Range;

use embedded_graphics::{
    geometry::{Point, Size},
    primitives::Rectangle,
};

use crate::{
    draw::{
        Path,
        antialiased::{
            edges_in_rows::RowSides,
            round_outline::{RoundContour, RoundOutline},
        },
    },
    geometry::{InputError, Sub8, SubPixel, SubPoint},
    scan::stroke::wide_stroke,
};

/// A corner of an outline: x and y in 1/256 pixel.
pub(crate) type Corner = [i32; 2];

/// Fractional bits of a stroke's positions (1/65,536 pixel) beyond those of an outline's corners (1/256 pixel).
pub(crate) const SHIFT: u32 = wide_stroke::FRACTION_BITS - Sub8::FRACTION_BITS;

/// A coordinate in 1/65,536 pixel, rounded to the nearest 1/256 pixel; ties upwards.
pub(crate) const fn rounded(coordinate: i64) -> i64 {
    (coordinate + (1 << (SHIFT - 1))) >> SHIFT
}

/// A shape that has an outline at 1/256 pixel, for
/// [`AntialiasedPolygon::prepare`](crate::draw::AntialiasedPolygon::prepare).
///
/// Implemented for contours of points, [`Path`]s (flattened), [`SubLine`](crate::draw::SubLine),
/// [`SubEllipse`](crate::draw::SubEllipse), [`SubArc`](crate::draw::SubArc) and embedded-graphics' `Text` in an
/// [`OutlineTextStyle`](crate::draw::OutlineTextStyle).
///
/// A program's own shape hands over its edges, without memory for them:
///
/// ```
/// use embedded_graphics::{pixelcolor::Gray8, prelude::*, primitives::Rectangle};
/// use zrow::{
///     band::Band,
///     coverage::SignedArea,
///     draw::{AntialiasedPolygon, FillRule, SubOutline},
/// };
///
/// /// A square on one corner: its middle and half of its diagonal, in 1/256 pixel.
/// struct Diamond([i32; 2], i32);
///
/// impl SubOutline for Diamond {
///     fn edges(&self, edge: &mut dyn FnMut([i32; 2], [i32; 2])) {
///         let Self([x, y], half) = *self;
///         let corners = [[x, y - half], [x + half, y], [x, y + half], [x - half, y]];
///         for (from, to) in corners.into_iter().zip(corners.into_iter().cycle().skip(1)) {
///             edge(from, to);
///         }
///     }
///
///     fn is_simple(&self) -> bool {
///         true
///     }
/// }
///
/// let marker = AntialiasedPolygon::<4, 4>::prepare(&Diamond([512, 512], 384), FillRule::NonZero)?;
/// let mut words = [0; 5 * 3];
/// let mut band = Band::<Gray8>::new(Rectangle::new(Point::new(0, 1), Size::new(5, 3)), &mut words)?;
/// marker.draw(&SignedArea, Gray8::WHITE, &mut band, &mut [0; 6])?;
/// assert_eq!(words, [0, 32, 191, 32, 0, 0, 191, 255, 191, 0, 0, 32, 191, 32, 0]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
pub trait SubOutline {
    /// Calls `edge` with both ends of each edge, as (x, y) in 1/256 pixel. Every contour is closed, and its edges
    /// follow each other. For a corner outside the domain of [`Sub8`](crate::geometry::Sub8),
    /// [`AntialiasedPolygon::prepare`](crate::draw::AntialiasedPolygon::prepare) returns an error.
    fn edges(&self, edge: &mut dyn FnMut([i32; 2], [i32; 2]));

    /// A point near all corners, in 1/256 pixel: corners within 127 pixels of it take half the memory in a picture. `None`
    /// stands for the first corner.
    fn anchor(&self) -> Option<[i32; 2]> {
        None
    }

    /// Whether signed area is known to be exact for the outline by either fill rule: it is one contour that does not
    /// cross itself, or an outer contour and an inner one in the opposite direction. `false` where this is not known.
    fn is_simple(&self) -> bool {
        false
    }

    /// Calls `edge` with the edges that have a part in some rows, and with as many of the others as it takes less to hand over
    /// than to leave out. Those left out must lie in the domain of [`Sub8`](crate::geometry::Sub8).
    #[doc(hidden)]
    fn edges_in_rows(&self, _rows: &Range<i32>, edge: &mut dyn FnMut([i32; 2], [i32; 2])) {
        self.edges(edge);
    }

    /// The sum of a column and its mirror image, where the right half of an outline is the mirror image of its left half: one
    /// y-monotone chain, which is all that antialiasing computes then. Such an outline is [`is_simple`](Self::is_simple).
    #[doc(hidden)]
    fn mirror(&self) -> Option<i32> {
        None
    }

    /// Calls `edge` as [`edges_in_rows`](Self::edges_in_rows) does, with the edges of the left half alone of an outline that is
    /// [mirrored](Self::mirror).
    #[doc(hidden)]
    fn left_edges_in_rows(&self, rows: &Range<i32>, edge: &mut dyn FnMut([i32; 2], [i32; 2])) {
        self.edges_in_rows(rows, edge);
    }

    /// The parameters of an outline whose corners can be computed one by one, in any order.
    #[doc(hidden)]
    fn round(&self) -> Option<RoundOutline> {
        None
    }
}

impl<S: SubPixel> SubOutline for [&[SubPoint<S>]] {
    fn edges(&self, edge: &mut dyn FnMut(Corner, Corner)) {
        let shift = (Sub8::FRACTION_BITS - S::FRACTION_BITS) & 7;
        let corner = |point: &SubPoint<S>| [point.x_units() << shift, point.y_units() << shift];
        for contour in self {
            let Some(last) = contour.last() else { continue };
            let mut from = corner(last);
            for to in contour.iter().map(corner) {
                edge(from, to);
                from = to;
            }
        }
    }
}

impl<S: SubPixel, const CONTOURS: usize> SubOutline for [&[SubPoint<S>]; CONTOURS] {
    fn edges(&self, edge: &mut dyn FnMut(Corner, Corner)) {
        self.as_slice().edges(edge);
    }
}

impl<S: SubPixel> SubOutline for Path<'_, S> {
    fn edges(&self, edge: &mut dyn FnMut(Corner, Corner)) {
        self.sub_edges(edge);
    }
}

impl SubOutline for RoundOutline {
    fn edges(&self, edge: &mut dyn FnMut(Corner, Corner)) {
        for contour in (0..self.contours()).filter_map(|number| self.contour(number)) {
            if !contour.mirrored_edges(false, edge) {
                close((0..contour.corners()).map(|index| contour.corner(index)), edge);
            }
        }
    }

    fn edges_in_rows(&self, rows: &Range<i32>, edge: &mut dyn FnMut(Corner, Corner)) {
        let rows = RowSides::of(rows);
        if self.lies_in(rows) {
            self.edges(edge);
        } else {
            self.edges_between(rows, false, edge);
        }
    }

    fn left_edges_in_rows(&self, rows: &Range<i32>, edge: &mut dyn FnMut(Corner, Corner)) {
        let rows = RowSides::of(rows);
        let are_mirrored = |contour: &RoundContour| contour.mirrored_edges(true, edge);
        if !(self.lies_in(rows) && self.contour(0).is_some_and(are_mirrored)) {
            self.edges_between(rows, true, edge);
        }
    }

    fn is_simple(&self) -> bool {
        true
    }

    fn mirror(&self) -> Option<i32> {
        self.mirror_of_ellipse()
    }

    fn round(&self) -> Option<RoundOutline> {
        Some(*self)
    }
}

/// Calls `edge` with the edges of one closed contour, in the order of its corners.
pub(crate) fn close(corners: impl IntoIterator<Item = Corner>, edge: &mut dyn FnMut(Corner, Corner)) {
    let mut corners = corners.into_iter();
    let Some(first) = corners.next() else { return };
    let mut from = first;
    for to in corners {
        edge(from, to);
        from = to;
    }
    edge(from, first);
}

/// The pixels between two corners, in 1/256 pixel; none where the second one is not right of and below the first one.
pub(crate) fn pixels_between([left, top]: Corner, [right, bottom]: Corner) -> Rectangle {
    let axis = |start: i32, end: i32| {
        // Pixels reach half a pixel beyond their centres.
        let (first, last) = ((start + 128) >> 8, (end + 127) >> 8);
        (first, u32::try_from(last - first + 1).unwrap_or(0))
    };
    let ((x, width), (y, height)) = (axis(left, right), axis(top, bottom));
    Rectangle::new(Point::new(x, y), Size::new(width, height))
}

/// The box around corners of an outline, as its upper left and its lower right corner.
pub(crate) fn around(corners: impl IntoIterator<Item = Corner>) -> [Corner; 2] {
    let ([mut left, mut top], [mut right, mut bottom]) = ([i32::MAX; 2], [i32::MIN; 2]);
    for [x, y] in corners {
        (left, right) = (left.min(x), right.max(x));
        (top, bottom) = (top.min(y), bottom.max(y));
    }
    if left > right {
        [[0; 2]; 2]
    } else {
        [[left, top], [right, bottom]]
    }
}

/// Checks that a square lies in the domain of [`Sub8`]; `extent` is the distance from its centre to each side, in 1/256
/// pixel.
///
/// # Errors
/// [`InputError::OutOfDomain`] where a part of the square is outside.
pub(crate) fn check_extent(center: SubPoint<Sub8>, extent: u32) -> Result<(), InputError> {
    // The domain is symmetric about 0, so that absolute values can be compared.
    const _: () = assert!(Sub8::MIN_UNITS == -Sub8::MAX_UNITS);
    let is_inside = |units: i32| {
        let farthest = units.unsigned_abs().checked_add(extent);
        farthest.is_some_and(|units| units <= Sub8::MAX_UNITS as u32)
    };
    if is_inside(center.x_units()) && is_inside(center.y_units()) {
        Ok(())
    } else {
        Err(InputError::out_of_domain::<Sub8>())
    }
}
