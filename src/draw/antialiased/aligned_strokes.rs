//! Strokes that lie inside or outside of a shape, cut off along its outline, and the fill beside them.
//!
//! ```text
//!     +-------------+     a centred stroke, twice as wide as the one that is drawn
//!     | +---------+ |
//!     | |.........| |     the shape: what of the wide stroke lies in it is the stroke inside (dots), the rest of it the
//!     | |.+-----+.| |     stroke outside
//!     | |.|     |.| |
//! ```
//!
//! A fill below the stroke reaches to the middle of the stroke, as the fill of every antialiased shape does. Below a stroke inside,
//! the fill is the shape without a centred stroke of the drawn width; below a stroke outside, it is the shape and that centred
//! stroke together. So no fill shows through the side of the stroke that lies along the shape's outline.
//!
//! The outlines of the shape and of the stroke are handed over one after the other, as one with two winding numbers, for
//! [`CombinedArea`](crate::coverage::CombinedArea) to count. Where the stroke's corners are moved to the sides of pixels, so are
//! the shape's: along rows and columns, pixels are those of a stroke that is not antialiased.

use embedded_graphics::{pixelcolor::PixelColor, primitives::StrokeAlignment};

use crate::{
    coverage::Combination,
    draw::{
        FillRule, PrimitiveStyle, StrokedShape, SubOutline,
        antialiased::{
            layers::{AlignedLayer, AlignedSink, edges_with_height},
            strokes::{StrokeForm, StrokeOutline},
            sub_outline::Corner,
        },
    },
    geometry::InputError,
};

/// The outline of a shape, and then that of its stroke.
struct ShapeAndStroke<'a> {
    shape: &'a dyn SubOutline,
    stroke: StrokeOutline<'a>,
}

impl ShapeAndStroke<'_> {
    /// Calls `edge` with the edges of the shape, on the pixels where the stroke is.
    fn shape_edges(&self, edge: &mut dyn FnMut(Corner, Corner)) {
        self.shape
            .edges(&mut |from, to| edge(self.stroke.on_pixels(from), self.stroke.on_pixels(to)));
    }
}

impl SubOutline for ShapeAndStroke<'_> {
    fn edges(&self, edge: &mut dyn FnMut(Corner, Corner)) {
        self.shape_edges(edge);
        self.stroke.edges(edge);
    }
}

/// Hands over the fill of a shape by a rule, and over it the stroke inside or outside of it.
pub(crate) fn aligned_layers<C: PixelColor, S: SubOutline + StrokedShape>(
    shape: &S,
    fill_rule: FillRule,
    style: &PrimitiveStyle<C>,
    layer: &mut AlignedSink<'_, C>,
) -> Result<(), InputError> {
    let (fill, stroke) = match style.stroke_alignment {
        StrokeAlignment::Inside => (Combination::ShapeAlone, Combination::Both),
        _ => (Combination::Either, Combination::StrokeAlone),
    };
    let width = u64::from(style.stroke_width);
    // The widths of the centred strokes in half pixels: up to the middle of the stroke, and up to its other side.
    let layers = [
        (style.fill_color, fill, 2 * width),
        (style.stroke_color, stroke, 4 * width),
    ];
    for (color, combination, width_in_halves) in layers {
        let Some(color) = color else { continue };
        let stroke = StrokeOutline::new(shape, StrokeForm::solid(width_in_halves))?;
        let outline = ShapeAndStroke { shape, stroke };
        let edges_of_shape = edges_with_height(|edge| outline.shape_edges(edge));
        layer(&AlignedLayer {
            outline: &outline,
            edges_of_shape,
            fill_rule,
            combination,
            color,
        })?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use embedded_graphics::{
        geometry::Point,
        mock_display::MockDisplay,
        pixelcolor::{Gray4, GrayColor},
        primitives::Primitive,
    };

    use super::*;
    use crate::draw::{
        DrawAntialiased, Path, PathCommand, Polygon,
        pictures::{at, blended},
    };

    const STAR: [(i32, i32); 5] = [(8, 0), (13, 15), (0, 5), (15, 5), (3, 15)];

    fn drawn(shape: &impl DrawAntialiased<Color = Gray4>) -> MockDisplay<Gray4> {
        blended(|band| {
            let mut row = [0; 17];
            shape.draw_on(&mut band.antialiased::<512, 64>(&mut row)).unwrap();
        })
    }

    fn style(width: u32, alignment: StrokeAlignment) -> PrimitiveStyle<Gray4> {
        PrimitiveStyle {
            stroke_alignment: alignment,
            ..PrimitiveStyle::with_stroke(Gray4::WHITE, width)
        }
    }

    #[test]
    fn a_stroke_inside_of_a_star_leaves_its_hole() {
        let star = STAR.map(|(x, y)| Point::new(x, y));
        let contours = [star.as_slice()];
        let star = Polygon::new(&contours, FillRule::EvenOdd);
        drawn(&star.into_styled(style(1, StrokeAlignment::Inside).antialiased())).assert_pattern(&[
            "        1       ",
            "        A       ",
            "       3F3      ",
            "       8E8      ",
            "       CCC      ",
            "1788886888688872",
            " 4ED8C8   8CCE5 ",
            "  2CAD3   3ED3  ",
            "    9C     92   ",
            "     61   57    ",
            "     CD2 7EC    ",
            "    3D9E7F3D3   ",
            "    8ED3 6EC8   ",
            "    CC2   3DC   ",
            "   3A1     1B3  ",
            "   2         2  ",
        ]);
    }

    #[test]
    fn a_stroke_outside_of_a_triangle_over_its_fill() {
        let triangle = [(4, 4), (11, 5), (7, 11)].map(|(x, y)| Point::new(x, y));
        let contours = [triangle.as_slice()];
        let triangle = Polygon::new(&contours, FillRule::NonZero);
        let style = PrimitiveStyle {
            fill_color: Some(Gray4::new(6)),
            ..style(2, StrokeAlignment::Outside)
        };
        drawn(&triangle.into_styled(style.antialiased())).assert_pattern(&[
            "               ",
            "               ",
            " 7CA8641       ",
            " 2FFFFFFECA8641",
            "  AFDCDEFFFFFF9",
            "  4FE666789DFD1",
            "   CF966668FF4 ",
            "   6FD6666DF9  ",
            "   1EF866BFD1  ",
            "    8FC68FF4   ",
            "    2FF7DF9    ",
            "     AFEFD1    ",
            "     4FFF4     ",
            "      CF9      ",
            "      6D1      ",
            "      13       ",
        ]);
    }

    #[test]
    fn an_open_path_has_no_stroke_along_the_line_that_closes_it() {
        let half_moon = [
            PathCommand::MoveTo(at(3.0, 2.5)),
            PathCommand::CubicTo(at(15.0, 2.5), at(15.0, 12.5), at(3.0, 12.5)),
        ];
        let half_moon = Path::new(&half_moon, FillRule::NonZero).unwrap();
        drawn(&half_moon.into_styled(style(2, StrokeAlignment::Inside).antialiased())).assert_pattern(&[
            "             ",
            "             ",
            "             ",
            "   7FDB84    ",
            "   8FFFFFC4  ",
            "    1248DFF6 ",
            "         7FF2",
            "          AF7",
            "          AF7",
            "         7FF2",
            "    1248DFF6 ",
            "   8FFFFFC4  ",
            "   7FDB84    ",
        ]);
    }
}
