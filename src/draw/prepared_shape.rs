//! A polygon or a path whose edges are set up for filling.

use embedded_graphics::{
    draw_target::DrawTarget,
    geometry::Dimensions,
    pixelcolor::PixelColor,
    primitives::{Primitive, Rectangle, Styled, StyledDimensions, StyledDrawable},
};
use heapless::Vec;

use crate::{
    draw::{PrimitiveStyle, StyledShape},
    scan::polygon::Edge,
    surface::Generic,
};

/// A [`Polygon`](crate::draw::Polygon) or a [`Path`](crate::draw::Path) whose edges are set up for filling. Drawing fails with
/// the target's own error only; bands may be drawn in any order.
///
/// The stroke of a polygon, of any width, is that of a closed line around each contour (see [wide
/// strokes](crate::draw#wide-strokes)): centred on the contour, or the part inside or outside the polygon of a stroke
/// twice as wide. It takes no entries of the tables. For an outline of Bresenham lines, draw the contour as a
/// `Polyline`. A path is filled first; then its stroke, centred on the path, is drawn over the fill.
///
/// An arrow is prepared once and drawn band by band; the alias is for a field that keeps it:
///
/// ```
/// use embedded_graphics::{
///     mock_display::MockDisplay, pixelcolor::Gray8, prelude::*, primitives::PrimitiveStyleBuilder,
/// };
/// use zrow::{
///     band::{DisplaySink, PictureLoop},
///     draw::{DrawOn, FillRule, Polygon, PreparedShape, PrimitiveStyle},
/// };
///
/// /// Three edges, of which a row meets two.
/// type Arrow<'a> = PreparedShape<Polygon<'a, Point>, 3, 2>;
///
/// let contours: [&[Point]; 1] = [&[Point::new(4, 4), Point::new(40, 20), Point::new(4, 36)]];
/// let arrow: Arrow<'_> = Polygon::new(&contours, FillRule::NonZero).prepare()?;
/// assert_eq!(arrow.edge_count(), 3);
///
/// let style = PrimitiveStyleBuilder::new().fill_color(Gray8::new(80)).stroke_color(Gray8::WHITE).stroke_width(3);
/// let style = PrimitiveStyle::from(style.build());
/// let mut display = MockDisplay::<Gray8>::new();
/// PictureLoop::new(display.bounding_box(), Gray8::BLACK)
///     .draw(&mut [0; 64], &mut DisplaySink(&mut display), |band| arrow.into_styled(style).draw_on(band))?;
/// assert_eq!(display.get_pixel(Point::new(15, 20)), Some(Gray8::new(80)));
/// assert_eq!(display.get_pixel(Point::new(4, 20)), Some(Gray8::WHITE));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct PreparedShape<S, const EDGES: usize, const ACTIVE: usize> {
    pub(in crate::draw) shape: S,
    pub(in crate::draw) edges: Vec<Edge, EDGES>,
}

impl<S, const EDGES: usize, const ACTIVE: usize> PreparedShape<S, EDGES, ACTIVE> {
    /// The number of edges in the table: the least `EDGES` for this shape.
    pub fn edge_count(&self) -> usize {
        self.edges.len()
    }

    /// Combines a reference to this shape with a style, to be drawn. The shape can be styled and drawn again
    /// afterwards.
    pub const fn into_styled<Style>(&self, style: Style) -> Styled<&Self, Style> {
        Styled::new(self, style)
    }
}

impl<S, const EDGES: usize, const ACTIVE: usize> Dimensions for &PreparedShape<S, EDGES, ACTIVE>
where
    PreparedShape<S, EDGES, ACTIVE>: Dimensions,
{
    fn bounding_box(&self) -> Rectangle {
        (**self).bounding_box()
    }
}

impl<S, const EDGES: usize, const ACTIVE: usize> Primitive for &PreparedShape<S, EDGES, ACTIVE> where
    PreparedShape<S, EDGES, ACTIVE>: Dimensions
{
}

impl<C: PixelColor, S, const EDGES: usize, const ACTIVE: usize> StyledDrawable<PrimitiveStyle<C>>
    for PreparedShape<S, EDGES, ACTIVE>
where
    Self: StyledShape,
{
    type Color = C;
    type Output = ();

    fn draw_styled<D>(&self, style: &PrimitiveStyle<C>, target: &mut D) -> Result<(), D::Error>
    where
        D: DrawTarget<Color = C>,
    {
        self.draw_styled_on(style, &mut Generic(target))
    }
}

impl<C: PixelColor, S, const EDGES: usize, const ACTIVE: usize> StyledDrawable<PrimitiveStyle<C>>
    for &PreparedShape<S, EDGES, ACTIVE>
where
    PreparedShape<S, EDGES, ACTIVE>: StyledShape,
{
    type Color = C;
    type Output = ();

    fn draw_styled<D>(&self, style: &PrimitiveStyle<C>, target: &mut D) -> Result<(), D::Error>
    where
        D: DrawTarget<Color = C>,
    {
        (**self).draw_styled(style, target)
    }
}

impl<C: PixelColor, S, const EDGES: usize, const ACTIVE: usize> StyledDimensions<PrimitiveStyle<C>>
    for &PreparedShape<S, EDGES, ACTIVE>
where
    PreparedShape<S, EDGES, ACTIVE>: StyledDimensions<PrimitiveStyle<C>>,
{
    fn styled_bounding_box(&self, style: &PrimitiveStyle<C>) -> Rectangle {
        (**self).styled_bounding_box(style)
    }
}

#[cfg(feature = "defmt")]
impl<S: defmt::Format, const EDGES: usize, const ACTIVE: usize> defmt::Format for PreparedShape<S, EDGES, ACTIVE> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "{}, {} of {} edges", self.shape, self.edges.len(), EDGES);
    }
}
