//! Circles, ellipses and arcs at 1/256 pixel, as polygons whose corners lie on the curve.
//!
//! The number of edges grows with the square root of the larger radius, so that no edge is further than 1/64 pixel from
//! the curve (a chord over the angle 2 pi / n is at most `r (1 - cos(pi / n))` off). Corners are rounded to 1/256
//! pixel; where they lie does not depend on the end of an arc, so that one that grows changes nothing but its end. An arc is the outer curve followed by the inner one in the opposite direction:
//!
//! ```text
//!      .-->--.       outer curve, clockwise
//!    .' .-<-. '.     inner curve, counterclockwise
//!   /  /     \  \
//!  +--+       +--+   butt ends
//! ```

use core::ops::Range;

use embedded_graphics::{
    geometry::Dimensions,
    pixelcolor::PixelColor,
    primitives::{Primitive, Rectangle},
};
use fixed::types::{U0F16, U24F8};

use crate::{
    draw::{
        FillRule, PrimitiveStyle, StrokedShape, SubOutline,
        antialiased::{
            closed_shapes::{self, OutlineBox, Reaches},
            layers::{LayerSink, OutlinedShape},
            outline_arc::OutlineArc,
            round_outline::{RoundContour, RoundOutline},
            strokes, sub_outline,
            turn::TURN_BITS,
        },
    },
    geometry::{InputError, Sub8, SubPoint},
    scan::stroke::wide_stroke::Path,
};

/// A filled circle or ellipse with a centre and radii in 1/256 pixel.
///
/// A dot moves by less than a pixel:
///
/// ```
/// use embedded_graphics::{pixelcolor::Gray8, prelude::*, primitives::Rectangle};
/// use zrow::{
///     band::Band,
///     draw::{DrawAntialiased, PrimitiveStyle, SubEllipse},
///     fixed::types::U24F8,
///     geometry::{Sub8, SubPoint},
/// };
///
/// let white = PrimitiveStyle::with_fill(Gray8::WHITE).antialiased();
/// let area = Rectangle::new(Point::zero(), Size::new(7, 1));
/// let mut row_memory = [0; 8];
/// for (quarters, expected) in [(0, [0, 184, 255, 255, 255, 184, 0]), (1, [0, 121, 255, 255, 255, 248, 0])] {
///     let mut row = [0; 7];
///     let centre = SubPoint::<Sub8>::from_units(3 * 256 + 64 * quarters, 0)?;
///     SubEllipse::circle(centre, U24F8::from_num(2.25))?
///         .into_styled(white)
///         .draw_on(&mut Band::<Gray8>::new(area, &mut row)?.antialiased::<32, 32>(&mut row_memory))?;
///     assert_eq!(row, expected);
/// }
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SubEllipse {
    center: SubPoint<Sub8>,
    radii: [u32; 2],
}

impl SubEllipse {
    /// An ellipse with these horizontal and vertical radii, in pixels.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where the square around the centre with the larger radius leaves the domain of [`Sub8`].
    pub fn new(center: SubPoint<Sub8>, radii: [U24F8; 2]) -> Result<Self, InputError> {
        let radii = radii.map(U24F8::to_bits);
        let [across, down] = radii;
        sub_outline::check_extent(center, across.max(down))?;
        Ok(Self { center, radii })
    }

    /// A circle with a radius in pixels.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where the circle leaves the domain of [`Sub8`].
    pub fn circle(center: SubPoint<Sub8>, radius: U24F8) -> Result<Self, InputError> {
        Self::new(center, [radius; 2])
    }

    /// The number of edges of the outline, level ones included: an upper bound for the `EDGES` of an
    /// [`AntialiasedPolygon`](crate::draw::AntialiasedPolygon).
    pub fn edge_count(&self) -> usize {
        self.outline().corners(0).into()
    }

    fn outline(&self) -> RoundOutline {
        let [x, y] = [self.center.x_units(), self.center.y_units()].map(i64::from);
        // The constructors refuse what is outside the domain.
        RoundOutline::new(RoundContour::ellipse([x, y], self.radii.map(i64::from)).unwrap_or_default())
    }
}

impl SubOutline for SubEllipse {
    fn edges(&self, edge: &mut dyn FnMut([i32; 2], [i32; 2])) {
        self.outline().edges(edge);
    }

    fn edges_in_rows(&self, rows: &Range<i32>, edge: &mut dyn FnMut([i32; 2], [i32; 2])) {
        self.outline().edges_in_rows(rows, edge);
    }

    fn mirror(&self) -> Option<i32> {
        self.outline().mirror()
    }

    fn left_edges_in_rows(&self, rows: &Range<i32>, edge: &mut dyn FnMut([i32; 2], [i32; 2])) {
        self.outline().left_edges_in_rows(rows, edge);
    }

    fn round(&self) -> Option<RoundOutline> {
        Some(self.outline())
    }

    fn anchor(&self) -> Option<[i32; 2]> {
        Some([self.center.x_units(), self.center.y_units()])
    }

    fn is_simple(&self) -> bool {
        true
    }
}

impl Dimensions for SubEllipse {
    /// The pixels that the ellipse may cover.
    fn bounding_box(&self) -> Rectangle {
        pixels_around(self.center, self.radii)
    }
}

impl Primitive for SubEllipse {}

impl OutlinedShape for SubEllipse {
    const MAY_BE_MIRRORED: bool = true;

    fn layers<C: PixelColor>(&self, style: &PrimitiveStyle<C>, layer: &mut LayerSink<'_, C>) -> Result<(), InputError> {
        let around = OutlineBox {
            center: [self.center.x_units(), self.center.y_units()].map(i64::from),
            radii: self.radii.map(i64::from),
        };
        let ellipse = |around: OutlineBox| RoundContour::ellipse(around.center, around.radii);
        let contour = |reach: i64| around.outset(reach).map(ellipse).transpose();
        closed_shapes::layers(style, &Reaches::centred(style), false, &contour, layer)
    }
}

/// The pixels around an ellipse.
fn pixels_around(center: SubPoint<Sub8>, radii: [u32; 2]) -> Rectangle {
    let ([x, y], [across, down]) = ([center.x_units(), center.y_units()], radii.map(|radius| radius as i32));
    sub_outline::pixels_between([x - across, y - down], [x + across, y + down])
}

/// An arc with a width and butt ends, such as a gauge, or a [ring](Self::ring).
///
/// ```
/// use embedded_graphics::{pixelcolor::Gray8, prelude::*, primitives::Rectangle};
/// use zrow::{
///     band::Band,
///     draw::{AntialiasingMemory, Picture, PictureSlot, PrimitiveStyle, SubArc},
///     fixed::types::{U0F16, U24F8},
///     geometry::{InputError, Sub8, SubPoint},
/// };
///
/// /// The lit part of a gauge that runs from the lower left over the top to the lower right.
/// fn lit(percent: u16) -> Result<SubArc, InputError> {
///     let centre = SubPoint::<Sub8>::from_pixel(Point::new(32, 32))?;
///     // Three eighths of a turn from the x axis, clockwise, and three quarters at most from there.
///     let (start, sweep) = (U0F16::from_num(0.375), U0F16::from_num(0.75) / 100 * percent);
///     SubArc::new(centre, [U24F8::from_num(24), U24F8::from_num(30.5)], start, sweep)
/// }
///
/// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
/// let (mut slots, mut pool, mut buckets) = ([PictureSlot::EMPTY; 1], [0; 128], [0; 64]);
/// let mut memory = AntialiasingMemory::<65, 32, 8>::new();
/// let mut picture = Picture::new(area, &mut slots, &mut pool, &mut buckets).with_antialiasing(&mut memory);
/// let style = PrimitiveStyle::with_fill(Gray8::WHITE).antialiased();
/// let gauge = picture.add(&lit(20)?.into_styled(style))?;
/// picture.replace(gauge, &lit(60)?.into_styled(style))?;
///
/// let mut row = [0; 64];
/// picture.draw(&mut Band::<Gray8>::new(Rectangle::new(Point::new(0, 32), Size::new(64, 1)), &mut row)?);
/// // Lit on the left side, and not yet on the right one.
/// assert_eq!((row[5], row[59]), (255, 0));
/// # Ok::<(), InputError>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SubArc {
    center: SubPoint<Sub8>,
    outer: u32,
    inner: u32,
    start: u32,
    sweep: u32,
}

/// Units of an angle in a whole turn.
const TURN: u32 = 1 << 16;

/// Bits that the angles of outlines have more.
const ANGLE_SHIFT: u32 = TURN_BITS - 16;

impl SubArc {
    /// An arc between two radii in pixels, in either order. `start` and `sweep` are parts of a turn, measured clockwise
    /// on the screen; `start` is measured from the x axis. A sweep is less than a turn: a whole one is a [`ring`](Self::ring).
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where the circle of the outer radius leaves the domain of [`Sub8`].
    pub fn new(
        center: SubPoint<Sub8>,
        [inner, outer]: [U24F8; 2],
        start: U0F16,
        sweep: U0F16,
    ) -> Result<Self, InputError> {
        let (inner, outer) = (inner.min(outer).to_bits(), inner.max(outer).to_bits());
        sub_outline::check_extent(center, outer)?;
        Ok(Self {
            center,
            outer,
            inner,
            start: start.to_bits().into(),
            sweep: sweep.to_bits().into(),
        })
    }

    /// The whole ring between two radii in pixels, in either order.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where the circle of the outer radius leaves the domain of [`Sub8`].
    pub fn ring(center: SubPoint<Sub8>, radii: [U24F8; 2]) -> Result<Self, InputError> {
        let arc = Self::new(center, radii, U0F16::ZERO, U0F16::ZERO)?;
        Ok(Self { sweep: TURN, ..arc })
    }

    /// The contours: an arc has one, along the outer radius and back along the inner one; a ring has two.
    fn outline(&self) -> RoundOutline {
        let center = [self.center.x_units(), self.center.y_units()].map(i64::from);
        let arc = |radius: u32, start: u32, sweep: i32| {
            // Angles in 1/65,536 turn.
            let angles = ((start << ANGLE_SHIFT) as i32, sweep << ANGLE_SHIFT);
            // The constructors refuse what is outside the domain.
            OutlineArc::new(center, [radius.into(); 2], angles).unwrap_or_default()
        };
        let ellipse = |radius: u32| RoundContour::ellipse(center, [radius.into(); 2]).unwrap_or_default();
        if self.sweep == TURN {
            let inner = (self.inner > 0).then(|| ellipse(self.inner));
            return RoundOutline::ring(ellipse(self.outer), inner);
        }
        let (end, sweep) = (self.start + self.sweep, self.sweep as i32);
        RoundOutline::new(RoundContour::new(&[
            arc(self.outer, self.start, sweep),
            arc(self.inner, end, -sweep),
        ]))
    }
}

impl SubOutline for SubArc {
    fn edges(&self, edge: &mut dyn FnMut([i32; 2], [i32; 2])) {
        self.outline().edges(edge);
    }

    fn edges_in_rows(&self, rows: &Range<i32>, edge: &mut dyn FnMut([i32; 2], [i32; 2])) {
        self.outline().edges_in_rows(rows, edge);
    }

    fn round(&self) -> Option<RoundOutline> {
        Some(self.outline())
    }

    fn anchor(&self) -> Option<[i32; 2]> {
        Some([self.center.x_units(), self.center.y_units()])
    }

    fn is_simple(&self) -> bool {
        true
    }
}

impl Dimensions for SubArc {
    /// The pixels around the whole ring.
    fn bounding_box(&self) -> Rectangle {
        pixels_around(self.center, [self.outer; 2])
    }
}

impl Primitive for SubArc {}

/// The stroke of a style runs around the arc, which is what the fill fills.
impl StrokedShape for SubArc {
    fn paths(&self, width_in_halves: u64, call: &mut dyn FnMut(&Path<'_>)) {
        let outline = self.outline();
        for contour in 0..outline.contours() {
            let corners = outline.corners(contour);
            let vertex = |index: usize| strokes::position(outline.corner(contour, index as u16));
            call(&Path::new(&vertex, corners.into(), true, width_in_halves));
        }
    }

    fn is_sub_pixel(&self) -> bool {
        true
    }
}

impl OutlinedShape for SubArc {
    // A whole turn.
    const MAY_BE_MIRRORED: bool = true;

    fn layers<C: PixelColor>(&self, style: &PrimitiveStyle<C>, layer: &mut LayerSink<'_, C>) -> Result<(), InputError> {
        strokes::fill_and_stroke(self, FillRule::NonZero, style, layer)
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::{
        mock_display::MockDisplay,
        pixelcolor::{Gray4, GrayColor},
    };

    use super::*;
    use crate::{
        coverage::SignedArea,
        draw::{
            AntialiasedPolygon,
            pictures::{at, blended},
        },
    };

    fn drawn(outline: &impl SubOutline) -> MockDisplay<Gray4> {
        let polygon = AntialiasedPolygon::<128, 32>::prepare(outline, FillRule::NonZero).unwrap();
        blended(|band| polygon.draw(&SignedArea, Gray4::WHITE, band, &mut [0; 17]).unwrap())
    }

    fn pixels(number: f32) -> U24F8 {
        U24F8::from_num(number)
    }

    #[test]
    fn a_circle_about_the_centre_of_a_pixel() {
        let circle = SubEllipse::circle(at(4.0, 4.0), pixels(4.5)).unwrap();
        drawn(&circle).assert_pattern(&[
            " 18DFD81 ",
            "1CFFFFFC1",
            "8FFFFFFF8",
            "DFFFFFFFD",
            "FFFFFFFFF",
            "DFFFFFFFD",
            "8FFFFFFF8",
            "1CFFFFFC1",
            " 18DFD81 ",
        ]);
    }

    /// A circle with a radius of half a pixel covers a sixteenth of pi, 0.196, of each of the four pixels: 3
    /// fifteenths.
    #[test]
    fn a_circle_about_the_corner_of_a_pixel_smaller_than_that() {
        let circle = SubEllipse::circle(at(1.5, 1.5), pixels(0.5)).unwrap();
        drawn(&circle).assert_pattern(&[
            "         ", //
            " 33      ",
            " 33      ",
        ]);
    }

    #[test]
    fn an_ellipse_cut_by_the_upper_edge() {
        let ellipse = SubEllipse::new(at(6.5, 1.5), [pixels(6.5), pixels(4.0)]).unwrap();
        drawn(&ellipse).assert_pattern(&[
            "1EFFFFFFFFFFE1",
            "6FFFFFFFFFFFF6",
            "6FFFFFFFFFFFF6",
            "1EFFFFFFFFFFE1",
            " 3DFFFFFFFFD3 ",
            "   5ADFFDA5   ",
        ]);
    }

    #[test]
    fn an_arc_over_three_quarters_begins_to_the_right_and_runs_downwards() {
        let gauge = SubArc::new(
            at(6.5, 6.5),
            [pixels(4.0), pixels(7.0)],
            U0F16::ZERO,
            U0F16::from_num(0.75),
        )
        .unwrap();
        drawn(&gauge).assert_pattern(&[
            "   18CF       ",
            "  5EFFF       ",
            " 5FFFFF       ",
            "1EFFD51       ",
            "8FFD1         ",
            "CFF5          ",
            "FFF1          ",
            "FFF1      1FFF",
            "CFF5      5FFC",
            "8FFD1    1DFF8",
            "1EFFD5115DFFE1",
            " 5FFFFFFFFFF5 ",
            "  5EFFFFFFE5  ",
            "   18CFFC81   ",
        ]);
    }
}
