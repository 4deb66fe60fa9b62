//! Paths of lines and Bézier curves: filled by their contours, or stroked.
//!
//! A pen follows the commands of the path. Curves are flattened to lines by adaptive forward differencing, one line at
//! a time, so that the flattened path takes no memory. Filling collects the lines of all closed contours in an edge
//! table; a wide stroke is generated from the lines of each contour; a thin stroke draws Bresenham's line for each of
//! them.

use embedded_graphics::{
    draw_target::DrawTarget,
    geometry::{Dimensions, Point},
    pixelcolor::PixelColor,
    primitives::{Primitive, Rectangle, StyledDimensions, StyledDrawable},
};
use fixed::types::U8F8;

use crate::{
    draw::{
        PreparedShape, PrimitiveStyle, StrokedShape, StyledShape,
        eg::polyline,
        filled_edges,
        shapes::{
            flat_steps::{FlatContour, FlatPoint, FlatStep, FlatSteps, nearest_pixel},
            path_command::PathCommand,
        },
        stroked_through_generic,
        style::stroke,
    },
    geometry::{Bounds, InputError, Sub8, SubPixel, TooSmall},
    scan::{
        curve::bezier,
        polygon::{
            Edge, Part,
            bounding_box::{MOST_LINE_TESTS, PolygonPixels},
            scanline_polygon::{FillRule, PartRule},
        },
        stroke::wide_stroke,
    },
    surface::{Generic, Target},
};

/// A path: contours of lines and curves.
///
/// Curves are flattened to lines that are nowhere further from them than the [tolerance](Self::with_tolerance), with
/// ends at 1/256 pixel (see [`Curves`](crate::scan::Bezier)). What is drawn depends on how the path is used:
/// - [prepared](Self::prepare), its fill is the polygon inside its contours, each closed by a straight line if it is
///   not, with the pixels of a [`Polygon`](crate::draw::Polygon);
/// - without preparation, only its stroke is drawn, as that of a `Polyline`: one pixel wide, the union of Bresenham's
///   lines between the pixels nearest to the ends of the lines; wider, a [wide stroke](crate::draw#wide-strokes) along
///   each contour, with a join at its beginning where it is closed. Curves are flattened anew for each band;
/// - in an antialiased style, or as an item of a [`Picture`](crate::draw::Picture), both are drawn, without preparation.
///
/// The stroke is centred, whatever the alignment of its style, unless it is antialiased: then a stroke inside or outside is
/// the part of a centred one, twice as wide, that lies inside or outside of the fill. An open contour is closed by a straight
/// line for the fill, and has no stroke along that line.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
/// use zrow::{
///     draw::{FillRule, Path, PathCommand::*, PrimitiveStyle},
///     geometry::{Sub4, SubPoint},
/// };
///
/// // In 1/16 pixel: from the upper side of row 0 to the lower side of row 6.
/// let at = |x, y| SubPoint::<Sub4>::from_units(x, y);
/// let half_moon = [MoveTo(at(-8, -8)?), CubicTo(at(152, -8)?, at(152, 104)?, at(-8, 104)?)];
/// let half_moon = Path::new(&half_moon, FillRule::NonZero)?.prepare::<16, 2>()?;
///
/// let mut display = MockDisplay::new();
/// let Ok(()) = half_moon
///     .into_styled(PrimitiveStyle::with_fill(BinaryColor::On))
///     .draw(&mut display);
/// display.assert_pattern(&[
///     "####   ",
///     "###### ",
///     "#######",
///     "#######",
///     "#######",
///     "###### ",
///     "####   ",
/// ]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Copy, Clone)]
pub struct Path<'a, S: SubPixel> {
    commands: &'a [PathCommand<S>],
    fill_rule: FillRule,
    tolerance: U8F8,
}

impl<'a, S: SubPixel> Path<'a, S> {
    /// The tolerance of a new path, 1/8 pixel.
    pub const DEFAULT_TOLERANCE: U8F8 = U8F8::lit("0.125");

    /// A path of these commands, with the [default tolerance](Self::DEFAULT_TOLERANCE).
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where a point is outside the domain of [`Sub8`], which a point made by
    /// [`SubPoint::from_units`](crate::geometry::SubPoint::from_units) never is.
    pub fn new(commands: &'a [PathCommand<S>], fill_rule: FillRule) -> Result<Self, InputError> {
        for command in commands {
            command
                .points()
                .into_iter()
                .flatten()
                .try_for_each(|point| bezier::to_sub8(&point).map(drop))?;
        }
        Ok(Self {
            commands,
            fill_rule,
            tolerance: Self::DEFAULT_TOLERANCE,
        })
    }

    /// Sets the largest distance between a curve and the lines it is flattened to, in pixels; less than 2/256 counts as
    /// 2/256.
    #[must_use]
    pub const fn with_tolerance(self, tolerance: U8F8) -> Self {
        Self { tolerance, ..self }
    }

    /// Sets up the edges of the contours for filling.
    ///
    /// `EDGES` is the number of lines that cross a row of pixel centres, `ACTIVE` the largest number of them that cross
    /// one row. RAM on a 32-bit machine: `32 * EDGES` bytes in the prepared path, `12 * ACTIVE` on the stack while it
    /// is drawn. Cost: flattening, one or two divisions for each edge, and a sort.
    ///
    /// # Errors
    /// [`TooSmall`] with the table that was too small and the exact number that is needed. The number of edges is
    /// checked first.
    pub fn prepare<const EDGES: usize, const ACTIVE: usize>(
        &self,
    ) -> Result<PreparedShape<Path<'a, S>, EDGES, ACTIVE>, TooSmall> {
        let edges = filled_edges::set_up::<EDGES, ACTIVE>(&|sink| self.edges(sink))?;
        Ok(PreparedShape { shape: *self, edges })
    }

    /// The rule by which the inside is filled.
    pub(crate) const fn fill_rule(&self) -> FillRule {
        self.fill_rule
    }

    /// The pen's steps after flattening, from the first command on.
    pub(crate) fn steps(&self) -> FlatSteps<'a, S> {
        FlatSteps::new(self.commands, self.tolerance)
    }

    /// Calls `sink` with the edges of all contours that cross a row of pixel centres; open contours are closed.
    fn edges(&self, sink: &mut dyn FnMut(Edge)) {
        self.lines(&mut |from, to| {
            if let Some(edge) = Edge::new(from, to, Part::Fill) {
                sink(edge);
            }
        });
    }

    /// Calls `sink` with the edges of the flattened path, level ones too, as their ends (x, y) in 1/256 pixel; open
    /// contours are closed.
    pub(crate) fn sub_edges(&self, sink: &mut dyn FnMut([i32; 2], [i32; 2])) {
        let units = |point: &FlatPoint| [point.x_units(), point.y_units()];
        self.lines(&mut |from, to| sink(units(from), units(to)));
    }

    /// Calls `line` with both ends of each line of all contours; open contours are closed.
    fn lines(&self, line: &mut dyn FnMut(&FlatPoint, &FlatPoint)) {
        let (mut start, mut at) = (FlatPoint::default(), FlatPoint::default());
        for step in self.steps() {
            match step {
                FlatStep::LineTo(to) => {
                    line(&at, &to);
                    at = to;
                }
                FlatStep::MoveTo(to) => {
                    line(&at, &start);
                    (start, at) = (to, to);
                }
                FlatStep::Close => {
                    line(&at, &start);
                    at = start;
                }
            }
        }
        line(&at, &start);
    }

    /// Calls `call` with the pixels at both ends of each line of the thin stroke, and with whether it begins where the
    /// line before ended.
    fn stroke_lines<E>(&self, mut call: impl FnMut(Point, Point, bool) -> Result<(), E>) -> Result<(), E> {
        let (mut start, mut at) = (Point::zero(), Point::zero());
        let mut continues = false;
        for step in self.steps() {
            let to = match step {
                FlatStep::MoveTo(to) => {
                    start = nearest_pixel(&to);
                    at = start;
                    continues = false;
                    continue;
                }
                FlatStep::LineTo(to) => nearest_pixel(&to),
                FlatStep::Close => start,
            };
            call(at, to, continues)?;
            continues = true;
            at = to;
        }
        Ok(())
    }

    /// Calls `call` with each contour that has a line, as the path of a wide stroke of the given width in half pixels.
    fn contours(&self, width_in_halves: u64, call: &mut dyn FnMut(&wide_stroke::Path<'_>)) {
        let mut steps = self.steps();
        let mut first = FlatPoint::default();
        loop {
            let contour = FlatContour {
                first,
                steps: steps.clone(),
            };
            let mut count = 1usize;
            let end = steps.by_ref().find(|step| {
                let is_end = !matches!(step, FlatStep::LineTo(_));
                count = count.saturating_add(usize::from(!is_end));
                is_end
            });
            let closed = end == Some(FlatStep::Close);
            if count > 1 || closed {
                contour.as_wide_stroke(count, closed, width_in_halves, call);
            }
            match end {
                Some(FlatStep::MoveTo(to)) => first = to,
                Some(_) => {}
                None => return,
            }
        }
    }

    /// The smallest box around the pixels of the fill. Cost: curves are flattened once for each row or column that is
    /// examined, and again for edges that cross it, until a pixel is found.
    fn fill_bounds(&self) -> Bounds {
        let sides = |sink: &mut dyn FnMut([i64; 2], [i64; 2])| {
            let units = |point: &FlatPoint| [i64::from(point.x_units()), i64::from(point.y_units())];
            self.lines(&mut |from, to| sink(units(from), units(to)));
        };
        let pixels = PolygonPixels {
            sides: &sides,
            fill_rule: self.fill_rule,
            fraction_bits: Sub8::FRACTION_BITS,
        };
        let mut tests_left = MOST_LINE_TESTS;
        pixels.grow(Bounds::EMPTY, &mut tests_left)
    }

    /// The smallest box around the pixels of a stroke of `width` pixels; a width of 0 counts as 1.
    fn stroke_bounds(&self, width: u32) -> Bounds {
        let mut bounds = Bounds::EMPTY;
        if width > 1 {
            let width_in_halves = u64::from(width) * 2;
            self.contours(width_in_halves, &mut |path| {
                bounds = bounds.around(&stroke::bounds(path))
            });
        } else {
            let Ok(()) = self.stroke_lines(|from, to, _| {
                bounds = bounds.around(&Bounds::of([from, to]));
                Ok::<(), core::convert::Infallible>(())
            });
        }
        bounds
    }
}

impl<S: SubPixel> Dimensions for Path<'_, S> {
    fn bounding_box(&self) -> Rectangle {
        self.stroke_bounds(1).to_rectangle()
    }
}

impl<S: SubPixel> Primitive for Path<'_, S> {}

impl<S: SubPixel> StyledShape for Path<'_, S> {
    fn draw_styled_on<T: Target>(&self, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error> {
        let Some(color) = style.effective_stroke_color() else {
            return Ok(());
        };
        if style.stroke_width > 1 {
            return self.draw_wide(style, target);
        }
        let raw = target.raw(color);
        let window = target.window();
        self.stroke_lines(|from, to, continues| {
            let steps = polyline::segment(from, to, Point::zero(), continues, &window);
            steps.map_or(Ok(()), |steps| target.draw_steps(&steps, raw))
        })
    }
}

impl<S: SubPixel> Path<'_, S> {
    /// Draws a stroke of two pixels or more as polygons. Not inlined, so that thin strokes do not have its stack frame.
    #[inline(never)]
    fn draw_wide<T: Target>(&self, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error> {
        let without_fill = PrimitiveStyle {
            fill_color: None,
            ..*style
        };
        stroke::draw(
            target,
            &without_fill,
            PartRule::fill(FillRule::NonZero),
            &|window, sink| {
                let width_in_halves = u64::from(style.stroke_width) * 2;
                self.contours(width_in_halves, &mut |path| path.edges(window, sink));
            },
        )
    }
}

impl<C: PixelColor, S: SubPixel> StyledDrawable<PrimitiveStyle<C>> for Path<'_, S> {
    type Color = C;
    type Output = ();

    fn draw_styled<D>(&self, style: &PrimitiveStyle<C>, target: &mut D) -> Result<(), D::Error>
    where
        D: DrawTarget<Color = C>,
    {
        self.draw_styled_on(style, &mut Generic(target))
    }
}

impl<C: PixelColor, S: SubPixel> StyledDimensions<PrimitiveStyle<C>> for Path<'_, S> {
    fn styled_bounding_box(&self, style: &PrimitiveStyle<C>) -> Rectangle {
        self.stroke_bounds(style.stroke_width).to_rectangle()
    }
}

impl<S: SubPixel> StrokedShape for Path<'_, S> {
    fn paths(&self, width_in_halves: u64, call: &mut dyn FnMut(&wide_stroke::Path<'_>)) {
        self.contours(width_in_halves, call);
    }

    fn is_sub_pixel(&self) -> bool {
        true
    }
}

stroked_through_generic!(Path<'_, S>, S: SubPixel);

impl<S: SubPixel, const EDGES: usize, const ACTIVE: usize> Dimensions for PreparedShape<Path<'_, S>, EDGES, ACTIVE> {
    fn bounding_box(&self) -> Rectangle {
        self.shape.fill_bounds().to_rectangle()
    }
}

impl<S: SubPixel, const EDGES: usize, const ACTIVE: usize> StyledShape for PreparedShape<Path<'_, S>, EDGES, ACTIVE> {
    fn draw_styled_on<T: Target>(&self, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error> {
        if let Some(color) = style.fill_color {
            filled_edges::draw::<T, ACTIVE>(&self.edges, self.shape.fill_rule, color, target)?;
        }
        self.shape.draw_styled_on(style, target)
    }
}

impl<C: PixelColor, S: SubPixel, const EDGES: usize, const ACTIVE: usize> StyledDimensions<PrimitiveStyle<C>>
    for PreparedShape<Path<'_, S>, EDGES, ACTIVE>
{
    fn styled_bounding_box(&self, style: &PrimitiveStyle<C>) -> Rectangle {
        let fill = self.shape.fill_bounds();
        if style.effective_stroke_color().is_none() {
            return fill.to_rectangle();
        }
        self.shape
            .stroke_bounds(style.stroke_width)
            .around(&fill)
            .to_rectangle()
    }
}

#[cfg(feature = "defmt")]
impl<S: SubPixel> defmt::Format for Path<'_, S> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(
            formatter,
            "Path of {} commands, {}",
            self.commands.len(),
            self.fill_rule
        );
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor};

    use super::{PathCommand::*, *};
    use crate::draw::pictures::{FILL, at, drawn, stroke};

    fn filled(commands: &[PathCommand<Sub8>], fill_rule: FillRule) -> MockDisplay<BinaryColor> {
        let path = Path::new(commands, fill_rule).unwrap();
        drawn(&&path.prepare::<32, 6>().unwrap(), FILL)
    }

    #[test]
    fn a_leaf_of_two_quadratic_curves() {
        let leaf = [
            MoveTo(at(0.0, 8.0)),
            QuadraticTo(at(0.0, 0.0), at(12.0, 0.0)),
            QuadraticTo(at(12.0, 8.0), at(0.0, 8.0)),
        ];
        filled(&leaf, FillRule::NonZero).assert_pattern(&[
            "            ",
            "      ######",
            "   #########",
            "  ##########",
            "  ######### ",
            " ########## ",
            " ########   ",
            " ######     ",
        ]);
    }

    #[test]
    fn a_cubic_curve_one_pixel_wide() {
        let wave = [
            MoveTo(at(0.0, 6.0)),
            CubicTo(at(5.0, -8.0), at(9.0, 20.0), at(14.0, 6.0)),
        ];
        let wave = Path::new(&wave, FillRule::NonZero).unwrap();
        drawn(&wave, stroke(1)).assert_pattern(&[
            "               ",
            "               ",
            "   ##          ",
            "  # #          ",
            " #   #         ",
            "#     #        ",
            "#      #      #",
            "        #     #",
            "         #   # ",
            "          # #  ",
            "          ##   ",
        ]);
    }

    #[test]
    fn a_wide_stroke_has_ends_where_the_path_is_not_closed() {
        let open = [MoveTo(at(1.0, 1.0)), LineTo(at(12.0, 1.0)), LineTo(at(1.0, 9.0))];
        let drawn_wide =
            |commands: &[PathCommand<Sub8>]| drawn(&Path::new(commands, FillRule::NonZero).unwrap(), stroke(2));
        drawn_wide(&open).assert_pattern(&[
            " ###############",
            " #############  ",
            "         ####   ",
            "        ###     ",
            "       ###      ",
            "     ####       ",
            "    ###         ",
            "   ###          ",
            " ####           ",
            " ##             ",
        ]);
        let [first, second, third] = open;
        drawn_wide(&[first, second, third, Close]).assert_pattern(&[
            "################",
            "##############  ",
            "##       ####   ",
            "##      ###     ",
            "##     ###      ",
            "##   ####       ",
            "##  ###         ",
            "## ###          ",
            "#####           ",
            "###             ",
            "##              ",
        ]);
    }

    /// Both contours run clockwise. The second one follows a `Close` of the first, and is closed although it does not
    /// end with `Close`.
    #[test]
    fn the_second_contour_is_a_hole_by_the_even_odd_rule_alone() {
        let contours = [
            MoveTo(at(0.0, 0.0)),
            LineTo(at(12.0, 0.0)),
            LineTo(at(12.0, 7.0)),
            LineTo(at(0.0, 7.0)),
            Close,
            MoveTo(at(4.0, 2.0)),
            LineTo(at(9.0, 2.0)),
            LineTo(at(9.0, 5.0)),
            LineTo(at(4.0, 5.0)),
        ];
        filled(&contours, FillRule::EvenOdd).assert_pattern(&[
            "############",
            "############",
            "####     ###",
            "####     ###",
            "####     ###",
            "############",
            "############",
        ]);
        filled(&contours, FillRule::NonZero).assert_pattern(&[
            "############",
            "############",
            "############",
            "############",
            "############",
            "############",
            "############",
        ]);
    }
}
