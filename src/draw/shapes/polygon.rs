//! Polygons of one or more contours: concave, self-crossing, with holes.
//!
//! [`Polygon::prepare`] collects the edges in a table, sorted by their first row, which a scan-line algorithm fills for
//! each band. A stroke is generated from the contours as polygons, without a table of its own, and is drawn in one pass
//! with the fill.

use embedded_graphics::{
    geometry::Dimensions,
    pixelcolor::PixelColor,
    primitives::{Primitive, Rectangle, StrokeAlignment, StyledDimensions},
};

use crate::{
    draw::{
        PreparedShape, PrimitiveStyle, StrokedShape, StyledShape, filled_edges, stroked_through_generic, style::stroke,
    },
    geometry::{Bounds, TooSmall, Vertex, assert_fraction_bits},
    scan::{
        polygon::{
            Edge, Part,
            bounding_box::{MOST_LINE_TESTS, PolygonPixels},
            scanline_polygon::{FillRule, PartRule},
        },
        stroke::wide_stroke::{self, Path},
    },
    surface::Target,
};

/// A polygon of contours that are closed implicitly, in pixels or in sub-pixel points.
///
/// A pixel belongs to the polygon when its centre is inside by the [`FillRule`]. A pixel whose centre is exactly on an
/// edge belongs to it when the inside is below that edge or to the right of it (the top-left rule). Polygons that share
/// an edge therefore cover each pixel along it exactly once. The right and bottom sides of a polygon with whole
/// coordinates are not part of it, unlike those of embedded-graphics' `Triangle`.
///
/// A stroke inside or outside of the polygon is the part of a centred stroke, twice as wide, that lies inside or outside by the
/// [`FillRule`], of all contours together.
///
/// Drawing a fill needs [`prepare`](Self::prepare), which reports tables that are too small; the prepared polygon can
/// then be drawn any number of times. A [`Picture`](crate::draw::Picture) takes a polygon without that.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
/// use zrow::draw::{FillRule, Polygon, PrimitiveStyle};
///
/// let outside = [Point::new(0, 0), Point::new(9, 0), Point::new(9, 5), Point::new(0, 5)];
/// let hole = [Point::new(3, 1), Point::new(6, 1), Point::new(6, 4), Point::new(3, 4)];
/// let contours: [&[Point]; 2] = [&outside, &hole];
/// let frame = Polygon::new(&contours, FillRule::EvenOdd).prepare::<4, 4>()?;
///
/// let mut display = MockDisplay::new();
/// let Ok(()) = frame
///     .into_styled(PrimitiveStyle::with_fill(BinaryColor::On))
///     .draw(&mut display);
/// display.assert_pattern(&["#########", "###   ###", "###   ###", "###   ###", "#########"]);
/// # Ok::<(), zrow::geometry::TooSmall>(())
/// ```
#[derive(Debug)]
pub struct Polygon<'a, V: Vertex> {
    contours: &'a [&'a [V]],
    fill_rule: FillRule,
}

impl<V: Vertex> Clone for Polygon<'_, V> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<V: Vertex> Copy for Polygon<'_, V> {}

impl<'a, V: Vertex> Polygon<'a, V> {
    /// A polygon of these contours, filled by a rule.
    pub const fn new(contours: &'a [&'a [V]], fill_rule: FillRule) -> Self {
        Self { contours, fill_rule }
    }

    /// Sets up the edges for drawing.
    ///
    /// `EDGES` is the number of edges that cross a row of pixel centres, `ACTIVE` the largest number of them that cross
    /// one row. RAM on a 32-bit machine: `32 * EDGES` bytes in the prepared polygon, `12 * ACTIVE` on the stack while
    /// it is drawn. Cost: one or two divisions for each edge, and a sort.
    ///
    /// # Errors
    /// [`TooSmall`] with the table that was too small and the exact number that is needed. The number of edges is
    /// checked first.
    pub fn prepare<const EDGES: usize, const ACTIVE: usize>(
        &self,
    ) -> Result<PreparedShape<Polygon<'a, V>, EDGES, ACTIVE>, TooSmall> {
        let edges = filled_edges::set_up::<EDGES, ACTIVE>(&|sink| self.edges(sink))?;
        Ok(PreparedShape { shape: *self, edges })
    }

    /// The contours, each closed implicitly.
    pub(crate) const fn contours(&self) -> &'a [&'a [V]] {
        self.contours
    }

    /// The rule by which the inside is filled.
    pub(crate) const fn fill_rule(&self) -> FillRule {
        self.fill_rule
    }

    /// Calls `sink` with the edges of all contours that cross a row of pixel centres.
    fn edges(&self, sink: &mut dyn FnMut(Edge)) {
        for contour in self.contours {
            let Some(mut from) = contour.last() else { continue };
            for to in *contour {
                if let Some(edge) = Edge::new(from, to, Part::Fill) {
                    sink(edge);
                }
                from = to;
            }
        }
    }

    /// Calls `sink` with both ends (x, y) of each side of all contours, in units of the vertices.
    pub(crate) fn sides(&self, sink: &mut dyn FnMut([i32; 2], [i32; 2])) {
        let units = |vertex: &V| [vertex.x_units(), vertex.y_units()];
        for contour in self.contours {
            let Some(mut from) = contour.last() else { continue };
            for to in *contour {
                sink(units(from), units(to));
                from = to;
            }
        }
    }

    /// The smallest box around the pixels of the fill.
    fn bounds(&self) -> Bounds {
        const { assert_fraction_bits::<V>() }
        let sides = |sink: &mut dyn FnMut([i64; 2], [i64; 2])| {
            self.sides(&mut |from, to| sink(from.map(i64::from), to.map(i64::from)));
        };
        let pixels = PolygonPixels {
            sides: &sides,
            fill_rule: self.fill_rule,
            fraction_bits: V::FRACTION_BITS,
        };
        let mut tests_left = MOST_LINE_TESTS;
        pixels.grow(Bounds::EMPTY, &mut tests_left)
    }
}

/// A stroke needs no prepared table: with a [`StrokeStyle`](crate::draw::StrokeStyle), the polygon can be drawn without
/// [`prepare`](Polygon::prepare).
impl<V: Vertex> Primitive for Polygon<'_, V> {}

impl<V: Vertex> Dimensions for Polygon<'_, V> {
    fn bounding_box(&self) -> Rectangle {
        self.bounds().to_rectangle()
    }
}

impl<V: Vertex> StrokedShape for Polygon<'_, V> {
    fn paths(&self, width_in_halves: u64, call: &mut dyn FnMut(&Path<'_>)) {
        let shift = wide_stroke::FRACTION_BITS.saturating_sub(V::FRACTION_BITS);
        for contour in self.contours {
            let vertex = |number: usize| {
                let vertex = contour.get(number);
                vertex.map_or((0, 0), |vertex| {
                    (
                        i64::from(vertex.x_units()) << shift,
                        i64::from(vertex.y_units()) << shift,
                    )
                })
            };
            call(&Path::new(&vertex, contour.len(), true, width_in_halves));
        }
    }

    fn is_sub_pixel(&self) -> bool {
        V::FRACTION_BITS > 0
    }
}

stroked_through_generic!(Polygon<'_, V>, V: Vertex);

impl<V: Vertex, const EDGES: usize, const ACTIVE: usize> Dimensions for PreparedShape<Polygon<'_, V>, EDGES, ACTIVE> {
    fn bounding_box(&self) -> Rectangle {
        self.shape.bounds().to_rectangle()
    }
}

impl<V: Vertex, const EDGES: usize, const ACTIVE: usize> StyledShape for PreparedShape<Polygon<'_, V>, EDGES, ACTIVE> {
    fn draw_styled_on<T: Target>(&self, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error> {
        let fill_rule = self.shape.fill_rule;
        if style.stroke_width == 0 {
            let Some(color) = style.fill_color else { return Ok(()) };
            return filled_edges::draw::<T, ACTIVE>(&self.edges, fill_rule, color, target);
        }
        let rule = PartRule {
            fill_rule,
            stroke_alignment: style.stroke_alignment,
        };
        let width_in_halves = stroke::width_in_halves(style);
        stroke::draw(target, style, rule, &|window, sink| {
            if stroke::needs_inside(style) {
                self.edges.iter().for_each(|edge| sink(*edge));
            }
            self.shape.paths(width_in_halves, &mut |path| path.edges(window, sink));
        })
    }
}

impl<C: PixelColor, V: Vertex, const EDGES: usize, const ACTIVE: usize> StyledDimensions<PrimitiveStyle<C>>
    for PreparedShape<Polygon<'_, V>, EDGES, ACTIVE>
{
    fn styled_bounding_box(&self, style: &PrimitiveStyle<C>) -> Rectangle {
        let mut bounds = self.shape.bounds();
        if style.effective_stroke_color().is_none() || style.stroke_alignment == StrokeAlignment::Inside {
            return bounds.to_rectangle();
        }
        let width_in_halves = stroke::width_in_halves(style);
        self.shape.paths(width_in_halves, &mut |path| {
            bounds = bounds.around(&stroke::bounds(path))
        });
        bounds.to_rectangle()
    }
}

#[cfg(feature = "defmt")]
impl<V: Vertex> defmt::Format for Polygon<'_, V> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(
            formatter,
            "Polygon of {} contours, {}",
            self.contours.len(),
            self.fill_rule
        );
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::{
        Drawable,
        geometry::Point,
        mock_display::MockDisplay,
        pixelcolor::{Rgb565, RgbColor},
    };

    use super::*;
    use crate::draw::pictures::{FILL, at, drawn, green_in_red, stroke};

    #[test]
    fn a_star_is_hollow_by_the_even_odd_rule() {
        let star = [(7, 0), (11, 13), (0, 5), (14, 5), (3, 13)].map(|(x, y)| Point::new(x, y));
        let contours = [star.as_slice()];
        let by_rule = |fill_rule| drawn(&&Polygon::new(&contours, fill_rule).prepare::<5, 6>().unwrap(), FILL);
        by_rule(FillRule::NonZero).assert_pattern(&[
            "              ",
            "       #      ",
            "       #      ",
            "       #      ",
            "      ###     ",
            "##############",
            "  ########### ",
            "   #########  ",
            "     #####    ",
            "     #####    ",
            "    #######   ",
            "    ##   ##   ",
            "    #     #   ",
        ]);
        by_rule(FillRule::EvenOdd).assert_pattern(&[
            "              ",
            "       #      ",
            "       #      ",
            "       #      ",
            "      ###     ",
            "######   #####",
            "  ####   #### ",
            "   ##     ##  ",
            "              ",
            "     #   #    ",
            "    ### ###   ",
            "    ##   ##   ",
            "    #     #   ",
        ]);
    }

    /// A pixel whose centre is on the shared edge belongs to the triangle on its right. The display fails where a pixel
    /// is drawn twice.
    #[test]
    fn neighbours_have_each_pixel_of_a_shared_edge_once() {
        let [upper_left, upper_right, lower_left, lower_right] =
            [(0, 0), (8, 0), (0, 8), (8, 8)].map(|(x, y)| Point::new(x, y));
        let mut display = MockDisplay::new();
        for (last, color) in [(lower_left, Rgb565::RED), (upper_right, Rgb565::GREEN)] {
            let triangle = [upper_left, lower_right, last];
            let contours = [triangle.as_slice()];
            let triangle = Polygon::new(&contours, FillRule::NonZero).prepare::<3, 2>().unwrap();
            let Ok(()) = triangle
                .into_styled(PrimitiveStyle::with_fill(color))
                .draw(&mut display);
        }
        display.assert_pattern(&[
            "GGGGGGGG ",
            "RGGGGGGG ",
            "RRGGGGGG ",
            "RRRGGGGG ",
            "RRRRGGGG ",
            "RRRRRGGG ",
            "RRRRRRGG ",
            "RRRRRRRG ",
        ]);
    }

    #[test]
    fn a_notched_polygon_with_a_stroke_inside() {
        let notched = [(0, 0), (14, 0), (14, 11), (7, 5), (0, 11)].map(|(x, y)| Point::new(x, y));
        let contours = [notched.as_slice()];
        let polygon = Polygon::new(&contours, FillRule::NonZero).prepare::<5, 6>().unwrap();
        drawn(&&polygon, green_in_red(2, StrokeAlignment::Inside)).assert_pattern(&[
            "RRRRRRRRRRRRRR",
            "RRRRRRRRRRRRRR",
            "RRGGGGGGGGGGRR",
            "RRGGGGGRGGGGRR",
            "RRGGGGRRRGGGRR",
            "RRGGRRRRRRRGRR",
            "RRGRRR   RRRRR",
            "RRRRR     RRRR",
            "RRRR       RRR",
            "RRR         RR",
            "RR           R",
        ]);
    }

    /// A pixel belongs to the frame when its centre does: columns begin at 0.75 with column 1 and end at 10.25 with
    /// column 10.
    #[test]
    fn a_frame_in_parts_of_a_pixel_cut_by_the_upper_edge() {
        let outside = [at(0.75, -3.0), at(10.25, -3.0), at(10.25, 4.5), at(0.75, 4.5)];
        let hole = [at(3.5, -1.5), at(3.5, 2.5), at(7.5, 2.5), at(7.5, -1.5)];
        let contours = [outside.as_slice(), hole.as_slice()];
        let polygon = Polygon::new(&contours, FillRule::NonZero).prepare::<4, 4>().unwrap();
        drawn(&&polygon, FILL).assert_pattern(&[
            " ###    ###",
            " ###    ###",
            " ###    ###",
            " ##########",
            " ##########",
        ]);
    }

    #[test]
    fn the_stroke_of_a_triangle_2_pixels_wide() {
        let triangle = [(1, 1), (13, 1), (7, 10)].map(|(x, y)| Point::new(x, y));
        let contours = [triangle.as_slice()];
        let polygon = Polygon::new(&contours, FillRule::NonZero).prepare::<3, 2>().unwrap();
        drawn(&&polygon, stroke(2)).assert_pattern(&[
            "###############",
            "###############",
            " ##         ## ",
            "  ##       ##  ",
            "  ###     ###  ",
            "   ##     ##   ",
            "    ##   ##    ",
            "    ### ###    ",
            "     ## ##     ",
            "      ###      ",
            "      ###      ",
            "       #       ",
        ]);
    }
}
