//! The adapter that lends a target the memory of antialiasing, and drawing on it.

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::Dimensions,
    pixelcolor::PixelColor,
    primitives::{Rectangle, Styled},
};
use heapless::Vec;

use crate::{
    band::{Band, InLinearLight},
    coverage::{AnyCoverage, CombinedArea, CoverageMethod},
    draw::{
        Antialiased, PrimitiveStyle, StrokeStyle, StrokedShape,
        antialiased::{
            layers::{AlignedSink, LayerSink, OutlinedShape},
            polygon::AntialiasedPolygon,
            strokes::stroke_layer,
        },
    },
    geometry::{DrawError, InputError, Sub8, TooSmall, Window, pixel_domain},
    shade::{BlendTarget, ChannelColor},
    surface::{BatchTarget, LineSteps, Order, Span, SymmetricBox, SymmetricCurve, Target, Trapezoids},
};

// Not re-exported: `Band::antialiased` makes one of a band, and says what it is.
/// A target with the memory that antialiased shapes take.
#[derive(Debug)]
pub struct AntialiasedTarget<'a, T, const EDGES: usize, const ACTIVE: usize> {
    pub(in crate::draw) target: &'a mut T,
    pub(in crate::draw) row_memory: &'a mut [i32],
}

impl<'a, T: BlendTarget, const EDGES: usize, const ACTIVE: usize> AntialiasedTarget<'a, T, EDGES, ACTIVE> {
    /// A target with lent memory: one cell more than its window has columns, all of them 0, as they are again after each
    /// shape.
    pub(in crate::draw) const fn new(target: &'a mut T, row_memory: &'a mut [i32]) -> Self {
        Self { target, row_memory }
    }
}

impl<C: ChannelColor, O: Order> Band<'_, C, O> {
    /// The band with memory for shapes in an [`Antialiased`] style, and a target like the band itself.
    ///
    /// Shapes in an [`Antialiased`] style are drawn on it by [`DrawAntialiased::draw_on`], each set up for every band that it
    /// may meet; all other shapes by [`DrawOn::draw_on`](crate::draw::DrawOn::draw_on), as on the band.
    ///
    /// `row_memory` has one cell more than the band has columns, all of them 0, as they are again after each shape.
    ///
    /// `EDGES` is the number of edges that an outline has, those that are level left out, and `ACTIVE` the most of them in one
    /// row of pixels. Of circles, ellipses, arcs, sectors and rounded corners only the edges in the rows of the band count, and
    /// of the fill of an ellipse about an axis in the middle or at a side of pixels only those of the left half, which is
    /// mirrored. A stroke inside or outside of a [`Polygon`](crate::draw::Polygon) or a [`Path`](crate::draw::Path), and the
    /// fill below it, each have the edges of the shape and those of a centred stroke; where radii of a rounded rectangle exceed
    /// its sides and the inner side of its stroke leaves the outer one, each has the edges of both, in all rows. RAM on a 32-bit machine, on the stack
    /// while a shape is drawn: `20 * EDGES` bytes for its fill and as many for its stroke, and `64 * ACTIVE`.
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::{Circle, Rectangle}};
    /// use zrow::{band::Band, draw::{DrawAntialiased, PrimitiveStyle}};
    ///
    /// let mut words = [0; 64 * 8];
    /// let mut band = Band::<Rgb565>::new(Rectangle::new(Point::zero(), Size::new(64, 8)), &mut words)?;
    /// let mut row_memory = [0; 65];
    /// Circle::new(Point::new(3, 2), 50)
    ///     .into_styled(PrimitiveStyle::with_stroke(Rgb565::RED, 3).antialiased())
    ///     .draw_on(&mut band.antialiased::<192, 32>(&mut row_memory))?;
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    ///
    /// A target that cannot be read back does not compile, because nothing can be blended over what it shows:
    ///
    /// ```compile_fail,E0308
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*, primitives::Circle};
    /// use zrow::draw::{DrawAntialiased, PrimitiveStyle};
    ///
    /// let mut display = MockDisplay::<Rgb565>::new();
    /// let result = Circle::new(Point::new(3, 2), 50)
    ///     .into_styled(PrimitiveStyle::with_fill(Rgb565::RED).antialiased())
    ///     .draw_on::<MockDisplay<Rgb565>, 192, 32>(&mut display);
    /// ```
    pub const fn antialiased<'a, const EDGES: usize, const ACTIVE: usize>(
        &'a mut self,
        row_memory: &'a mut [i32],
    ) -> AntialiasedTarget<'a, Self, EDGES, ACTIVE> {
        AntialiasedTarget::new(self, row_memory)
    }
}

impl<C: ChannelColor, O: Order, const TENTHS: u32> InLinearLight<'_, '_, C, O, TENTHS> {
    /// The band with memory for shapes in an [`Antialiased`] style, which are blended in linear light; of what sizes,
    /// [`Band::antialiased`] says.
    pub const fn antialiased<'a, const EDGES: usize, const ACTIVE: usize>(
        &'a mut self,
        row_memory: &'a mut [i32],
    ) -> AntialiasedTarget<'a, Self, EDGES, ACTIVE> {
        AntialiasedTarget::new(self, row_memory)
    }
}

/// The most layers of a shape: its fill and its stroke.
const MOST_LAYERS: usize = 2;

/// Draws a shape in an [`Antialiased`] style, on [`Band::antialiased`].
///
/// Memory that is too small is an error that says how much would do:
///
/// ```
/// use embedded_graphics::{pixelcolor::Gray8, prelude::*, primitives::{Line, Rectangle}};
/// use zrow::{
///     band::Band,
///     draw::{DrawAntialiased, PrimitiveStyle},
///     geometry::{DrawError, TooSmall},
/// };
///
/// let mut words = [0; 8 * 3];
/// let mut band = Band::<Gray8>::new(Rectangle::new(Point::zero(), Size::new(8, 3)), &mut words)?;
/// let style = PrimitiveStyle::with_stroke(Gray8::WHITE, 2).antialiased();
/// let needle = Line::new(Point::new(0, 0), Point::new(7, 2)).into_styled(style);
/// let mut row_memory = [0; 9];
/// let too_small = needle.draw_on(&mut band.antialiased::<2, 4>(&mut row_memory));
/// assert_eq!(too_small, Err(DrawError::TooSmall(TooSmall::Edges(4))));
///
/// needle.draw_on(&mut band.antialiased::<4, 4>(&mut row_memory))?;
/// // The row in the middle.
/// assert_eq!(words[8..16], [138, 210, 255, 255, 255, 255, 210, 138]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
pub trait DrawAntialiased {
    /// The colour type of the target.
    type Color: PixelColor;

    /// Calls `layer` with each outline of the shape and its colour, from the lowest one on.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where the shape leaves the domain of [`Sub8`]. The first error that `layer` returns.
    #[doc(hidden)]
    fn layers(&self, layer: &mut LayerSink<'_, Self::Color>) -> Result<(), InputError>;

    /// Whether [`aligned_layers`](Self::aligned_layers) has the layers of the shape: they are what one outline cuts off from
    /// another one.
    #[doc(hidden)]
    fn is_cut_off(&self) -> bool {
        false
    }

    /// Whether an outline of the shape may be its own [mirror image](SubOutline::mirror).
    #[doc(hidden)]
    fn may_be_mirrored(&self) -> bool {
        false
    }

    /// Calls `layer` with each combination of the shape and its stroke, from the lowest one on.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where the shape leaves the domain of [`Sub8`]. The first error that `layer` returns.
    #[doc(hidden)]
    fn aligned_layers(&self, _layer: &mut AlignedSink<'_, Self::Color>) -> Result<(), InputError> {
        Ok(())
    }

    /// Whether a window may show the shape; `true` where finding out would take longer than drawing.
    #[doc(hidden)]
    fn may_meet(&self, _window: &Window) -> bool {
        true
    }

    /// Draws the part of the shape that lies inside the target's window, blended over what is there: the fill and then
    /// the stroke, each by the cheapest coverage method that is exact for it ([`AntialiasedPolygon::exact_method`]).
    ///
    /// # Errors
    /// [`DrawError::TooSmall`] with the memory that is too small and how much would do, and [`DrawError::OutOfDomain`]
    /// for a shape further than 8,191 pixels from the origin (with a stroke inside a polygon
    /// or a path, one that reaches outside as far as inside); nothing is drawn then, but of a text what comes before the glyph
    /// that fails. A window that the shape does not meet may go without these errors. [`DrawError::Target`] with the target's own error.
    fn draw_on<T: BlendTarget<Color = Self::Color>, const EDGES: usize, const ACTIVE: usize>(
        &self,
        target: &mut AntialiasedTarget<'_, T, EDGES, ACTIVE>,
    ) -> Result<(), DrawError<T::Error>> {
        let AntialiasedTarget { target, row_memory } = target;
        let window = target.window();
        if !self.may_meet(&window) {
            return Ok(());
        }
        if self.is_cut_off() {
            return draw_aligned::<_, _, EDGES, ACTIVE>(self, *target, row_memory);
        }
        let mut polygons = free_polygons::<EDGES, ACTIVE>();
        let mut free = polygons.iter_mut();
        let mut layers = Vec::<(&AntialiasedPolygon<EDGES, ACTIVE>, AnyCoverage, T::Color), MOST_LAYERS>::new();
        let prepared = self.layers(&mut |layer| {
            let polygon = next_polygon(&mut free)?;
            let rows = window.top..window.bottom;
            match layer.outline.mirror().filter(|_| self.may_be_mirrored()) {
                Some(mirror) => polygon.set_up_left_half(&rows, layer.outline, mirror)?,
                None => polygon.set_up_for(&rows, layer.outline, layer.fill_rule)?,
            }
            let method = polygon.exact_method(layer.outline);
            let pushed = layers.push((polygon, method, layer.color));
            debug_assert!(pushed.is_ok(), "there is a place for each polygon");
            Ok(())
        });
        prepared.map_err(draw_error)?;
        let needed = AnyCoverage::cells(window.width() as usize);
        if row_memory.len() < needed {
            return Err(DrawError::TooSmall(TooSmall::Cells(needed)));
        }
        layers.iter().try_for_each(|(polygon, method, color)| {
            if self.may_be_mirrored() && polygon.is_mirrored() {
                polygon.draw_mirrored(*color, *target, row_memory)
            } else {
                polygon.draw(method, *color, *target, row_memory)
            }
        })
    }
}

/// Draws a shape whose fill and stroke are cut off along an outline: the fill and then the stroke, each a combination of two
/// outlines.
#[inline(never)]
fn draw_aligned<
    S: DrawAntialiased + ?Sized,
    T: BlendTarget<Color = S::Color>,
    const EDGES: usize,
    const ACTIVE: usize,
>(
    shape: &S,
    target: &mut T,
    row_memory: &mut [i32],
) -> Result<(), DrawError<T::Error>> {
    let mut polygons = free_polygons::<EDGES, ACTIVE>();
    let mut free = polygons.iter_mut();
    let mut layers = Vec::<(&AntialiasedPolygon<EDGES, ACTIVE>, CombinedArea, T::Color), MOST_LAYERS>::new();
    let prepared = shape.aligned_layers(&mut |layer| {
        let polygon = next_polygon(&mut free)?;
        polygon.set_up(layer.outline, layer.fill_rule)?;
        let area = CombinedArea {
            combination: layer.combination,
            first_of_stroke: layer.edges_of_shape,
        };
        let pushed = layers.push((polygon, area, layer.color));
        debug_assert!(pushed.is_ok(), "there is a place for each polygon");
        Ok(())
    });
    prepared.map_err(draw_error)?;
    // Nothing is drawn where the row memory is too small: the first layer says so.
    layers
        .iter()
        .try_for_each(|(polygon, area, color)| polygon.draw(area, *color, target, row_memory))
}

/// A polygon without edges for each layer of a shape, which is set up where it is: moving polygons of 256 edges took 16,800
/// instructions a shape (Cortex-M4).
#[inline(always)]
fn free_polygons<const EDGES: usize, const ACTIVE: usize>() -> [AntialiasedPolygon<EDGES, ACTIVE>; MOST_LAYERS] {
    core::array::from_fn(|_| AntialiasedPolygon::empty())
}

/// The next free polygon.
#[inline]
fn next_polygon<'p, const EDGES: usize, const ACTIVE: usize>(
    free: &mut core::slice::IterMut<'p, AntialiasedPolygon<EDGES, ACTIVE>>,
) -> Result<&'p mut AntialiasedPolygon<EDGES, ACTIVE>, InputError> {
    let polygon = free.next();
    debug_assert!(polygon.is_some(), "no shape has more layers");
    polygon.ok_or(InputError::TooSmall(TooSmall::Edges(EDGES)))
}

/// The error of drawing where a shape cannot be set up.
pub(crate) fn draw_error<E>(error: InputError) -> DrawError<E> {
    match error {
        InputError::TooSmall(error) => DrawError::TooSmall(error),
        // Outlines have no other errors, and all are in the domain of this precision.
        _ => {
            let (min, max) = pixel_domain::<Sub8>();
            DrawError::OutOfDomain { min, max }
        }
    }
}

impl<S: OutlinedShape, C: PixelColor> DrawAntialiased for Styled<S, Antialiased<PrimitiveStyle<C>>> {
    type Color = C;

    fn layers(&self, layer: &mut LayerSink<'_, C>) -> Result<(), InputError> {
        self.primitive.layers(&self.style.0, layer)
    }

    fn is_cut_off(&self) -> bool {
        S::IS_CUT_OFF && self.primitive.is_cut_off(&self.style.0)
    }

    fn may_be_mirrored(&self) -> bool {
        S::MAY_BE_MIRRORED
    }

    fn aligned_layers(&self, layer: &mut AlignedSink<'_, C>) -> Result<(), InputError> {
        self.primitive.aligned_layers(&self.style.0, layer)
    }

    fn may_meet(&self, window: &Window) -> bool {
        self.primitive.may_meet(window, self.style.0.stroke_width)
    }
}

impl<S: StrokedShape, C: PixelColor> DrawAntialiased for Styled<S, Antialiased<StrokeStyle<'_, C>>> {
    type Color = C;

    fn layers(&self, layer: &mut LayerSink<'_, C>) -> Result<(), InputError> {
        let Antialiased(style) = &self.style;
        stroke_layer(&self.primitive, style.into(), style.color, layer)
    }
}

impl<T: Dimensions, const EDGES: usize, const ACTIVE: usize> Dimensions for AntialiasedTarget<'_, T, EDGES, ACTIVE> {
    fn bounding_box(&self) -> Rectangle {
        self.target.bounding_box()
    }
}

impl<T: DrawTarget, const EDGES: usize, const ACTIVE: usize> DrawTarget for AntialiasedTarget<'_, T, EDGES, ACTIVE> {
    type Color = T::Color;
    type Error = T::Error;

    fn draw_iter<I: IntoIterator<Item = Pixel<T::Color>>>(&mut self, pixels: I) -> Result<(), T::Error> {
        self.target.draw_iter(pixels)
    }

    fn fill_contiguous<I: IntoIterator<Item = T::Color>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), T::Error> {
        self.target.fill_contiguous(area, colors)
    }

    fn fill_solid(&mut self, area: &Rectangle, color: T::Color) -> Result<(), T::Error> {
        self.target.fill_solid(area, color)
    }

    fn clear(&mut self, color: T::Color) -> Result<(), T::Error> {
        self.target.clear(color)
    }
}

impl<T: Target, const EDGES: usize, const ACTIVE: usize> Target for AntialiasedTarget<'_, T, EDGES, ACTIVE> {
    fn window(&self) -> Window {
        self.target.window()
    }

    fn raw(&self, color: T::Color) -> T::Raw {
        self.target.raw(color)
    }

    fn fill_span(&mut self, span: Span, raw: T::Raw) -> Result<(), T::Error> {
        self.target.fill_span(span, raw)
    }
}

impl<T: Target, const EDGES: usize, const ACTIVE: usize> BatchTarget for AntialiasedTarget<'_, T, EDGES, ACTIVE> {
    type Raw = T::Raw;

    fn fill_clipped_span(&mut self, span: Span, raw: T::Raw) -> Result<(), T::Error> {
        self.target.fill_clipped_span(span, raw)
    }

    fn fill_clipped_window(&mut self, window: Window, raw: T::Raw) -> Result<(), T::Error> {
        self.target.fill_clipped_window(window, raw)
    }

    fn fill_trapezoids(&mut self, trapezoids: &Trapezoids, raw: T::Raw) -> Result<(), T::Error> {
        self.target.fill_trapezoids(trapezoids, raw)
    }

    fn draw_steps(&mut self, steps: &LineSteps, raw: T::Raw) -> Result<(), T::Error> {
        self.target.draw_steps(steps, raw)
    }

    fn fill_symmetric(
        &mut self,
        shape: &SymmetricBox,
        curve: &mut dyn SymmetricCurve,
        raw: T::Raw,
        inner_raw: Option<T::Raw>,
    ) -> Result<(), T::Error> {
        self.target.fill_symmetric(shape, curve, raw, inner_raw)
    }
}

#[cfg(feature = "defmt")]
impl<T, const EDGES: usize, const ACTIVE: usize> defmt::Format for AntialiasedTarget<'_, T, EDGES, ACTIVE> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "AntialiasedTarget with {} cells", self.row_memory.len());
    }
}
