//! Strokes of any shape of line: caps, joins, dashes.

use embedded_graphics::{
    pixelcolor::PixelColor,
    primitives::{self, Rectangle, Styled},
};

use crate::{
    draw::{DashPattern, DrawOn, FillRule, LineCap, LineJoin, PrimitiveStyle, stroke},
    geometry::{Bounds, Window},
    scan::{
        banded_polygon::{self, EdgeSource},
        grouped_pieces::{self, EdgedPiece},
        scanline_polygon::PartRule,
        styled_stroke::{StrokeEdge, StyledStroke},
        wide_stroke::{FRACTION_BITS, Path},
    },
    target::{Clipped, Target},
};

/// A stroke with caps, joins and dashes: a style beside [`PrimitiveStyle`], for `Line`, `Polyline`, `Triangle`, `Rectangle`,
/// [`Polygon`](crate::draw::Polygon) and [`Path`](crate::draw::Path).
///
/// The stroke is the exact union of its segments, joins and caps, each pixel once, at every width from 1 on: one pixel wide,
/// too, it is a polygon and not Bresenham's line. It is centred on the path. That of a `Rectangle` goes through the centres
/// of its outermost pixels. With the default cap and join it has the pixels of the [wide strokes](crate::draw#wide-strokes)
/// of a [`PrimitiveStyle`].
///
/// Cost: as wide strokes, with a square root for every segment where there are dashes, seen or not. The path is generated
/// anew for each part of a band that 14 sides of rectangles, wedges and discs cross. Dashes, and what joins them around
/// corners, are drawn one after the other and not from top to bottom, but for those that may overlap, which are drawn
/// together: the path is generated twice for each band that up to 32 of these pieces reach, and again for crowds of them.
/// Memory: none that grows with vertices or dashes; with dashes some 3 KB of stack. Flash: what this style takes is linked
/// only where it is used.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*, primitives::Line};
/// use fixed::types::U16F16;
/// use zrow::draw::{DashPattern, LineCap, StrokeStyle};
///
/// const DASHES: [U16F16; 2] = [U16F16::lit("3"), U16F16::lit("2")];
/// let style = StrokeStyle::new(BinaryColor::On, 2)
///     .cap(LineCap::Butt)
///     .dashes(DashPattern::new(&DASHES));
/// let mut display = MockDisplay::new();
/// Line::new(Point::new(0, 1), Point::new(10, 1))
///     .into_styled(style)
///     .draw(&mut display)?;
/// display.assert_pattern(&["###  ###", "###  ###"]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct StrokeStyle<'dashes, C: PixelColor> {
    /// Colour of the stroke; `None` draws nothing.
    pub color: Option<C>,
    /// Width of the stroke in pixels; 0 draws nothing.
    pub width: u32,
    /// The ends of the stroke, and of each dash.
    pub cap: LineCap,
    /// Its corners.
    pub join: LineJoin,
    /// Where along the path it is on; `None` is everywhere.
    pub dashes: Option<DashPattern<'dashes>>,
}

impl<'dashes, C: PixelColor> StrokeStyle<'dashes, C> {
    /// A solid stroke of this colour and width, with the caps and joins of a [`PrimitiveStyle`].
    pub const fn new(color: C, width: u32) -> Self {
        Self {
            color: Some(color),
            width,
            cap: LineCap::WholePixel,
            join: LineJoin::MITER,
            dashes: None,
        }
    }

    /// Sets the cap.
    #[must_use]
    pub const fn cap(self, cap: LineCap) -> Self {
        Self { cap, ..self }
    }

    /// Sets the join.
    #[must_use]
    pub const fn join(self, join: LineJoin) -> Self {
        Self { join, ..self }
    }

    /// Sets the dashes.
    #[must_use]
    pub const fn dashes(self, dashes: DashPattern<'dashes>) -> Self {
        Self {
            dashes: Some(dashes),
            ..self
        }
    }

    pub(super) fn draw_on<T: Target<Color = C>>(
        &self,
        shape: &dyn StrokedShape,
        target: &mut T,
    ) -> Result<(), T::Error> {
        let Some(color) = self.color.filter(|_| self.width > 0) else {
            return Ok(());
        };
        let ink = target.ink(color);
        let window = target.window();
        let mut result = Ok(());
        let mut fill = |source: &EdgeSource<'_, StrokeEdge>, window: &Window| {
            let rule = PartRule::fill(FillRule::NonZero);
            if result.is_ok() {
                result = banded_polygon::scan(source, rule, window, |span, _| {
                    target.fill_clipped_span(Clipped(span), ink)
                });
            }
        };
        if self.dashes.is_some() && shape.is_one_path() {
            let mut is_apart = false;
            self.strokes(shape, &mut |stroke| {
                is_apart = stroke.is_apart();
                if is_apart {
                    stroke.each_piece(0, &window, &mut |piece| fill(piece.edges, &window));
                }
            });
            if is_apart {
                return result;
            }
        }
        if self.dashes.is_some() {
            let pieces = |window: &Window, call: &mut dyn FnMut(&EdgedPiece<'_>)| {
                let mut path = 0usize;
                self.strokes(shape, &mut |stroke| {
                    stroke.each_piece(path, window, call);
                    path = path.wrapping_add(1);
                });
            };
            grouped_pieces::each_group(&pieces, &window, &mut fill);
        } else {
            let edges = |window: &Window, sink: &mut dyn FnMut(StrokeEdge)| {
                self.strokes(shape, &mut |stroke| stroke.edges(window, sink));
            };
            fill(&edges, &window);
        }
        result
    }

    /// Around the pixels of a stroke; a dashed one may need less.
    pub(super) fn bounds(&self, shape: &dyn StrokedShape) -> Rectangle {
        let mut bounds = Bounds::EMPTY;
        if self.width > 0 {
            self.strokes(shape, &mut |stroke| {
                stroke.boxes(&mut |corners| {
                    bounds = bounds.around(&stroke::bounds_of_area(corners.into_iter(), FRACTION_BITS));
                });
            });
        }
        bounds.to_rectangle()
    }

    fn strokes(&self, shape: &dyn StrokedShape, call: &mut dyn FnMut(&StyledStroke<'_>)) {
        shape.paths(u64::from(self.width) * 2, &mut |path| {
            call(&StyledStroke::new(path, self.cap, self.join, self.dashes));
        });
    }
}

impl<C: PixelColor> From<PrimitiveStyle<C>> for StrokeStyle<'_, C> {
    /// The stroke of that style, centred.
    fn from(style: PrimitiveStyle<C>) -> Self {
        Self {
            color: style.stroke_color,
            width: style.stroke_width,
            cap: LineCap::default(),
            join: LineJoin::default(),
            dashes: None,
        }
    }
}

impl<C: PixelColor> From<primitives::PrimitiveStyle<C>> for StrokeStyle<'_, C> {
    /// The stroke of that style, centred.
    fn from(style: primitives::PrimitiveStyle<C>) -> Self {
        PrimitiveStyle::from(style).into()
    }
}

/// A shape that has paths to stroke. Those of this crate are all: own shapes are strokes of a
/// [`Path`](crate::draw::Path) or of a [`Polygon`](crate::draw::Polygon).
pub trait StrokedShape {
    /// Calls with each path of the shape; the width of the stroke is in half pixels.
    #[doc(hidden)]
    fn paths(&self, width_in_halves: u64, call: &mut dyn FnMut(&Path<'_>));

    /// Whether it has one path, whatever its vertices are.
    #[doc(hidden)]
    fn is_one_path(&self) -> bool {
        false
    }
}

impl<S: StrokedShape, C: PixelColor> DrawOn for Styled<S, StrokeStyle<'_, C>> {
    type Color = C;

    fn draw_on<T: Target<Color = C>>(&self, target: &mut T) -> Result<(), T::Error> {
        self.style.draw_on(&self.primitive, target)
    }
}
