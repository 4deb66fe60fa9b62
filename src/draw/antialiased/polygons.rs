//! Outlines of [`Polygon`]s and [`Path`]s in a style: the contours themselves, filled by their rule, and over them the
//! stroke along each of them: centred, or what of a stroke twice as wide lies inside or outside of the filled shape.

use embedded_graphics::pixelcolor::PixelColor;
use fixed::types::U8F8;

use crate::{
    draw::{
        Path, Polygon, PrimitiveStyle, SubOutline,
        antialiased::{
            aligned_strokes::aligned_layers,
            layers::{AlignedSink, LayerSink, OutlinedShape},
            strokes::fill_and_stroke,
            sub_outline::{self, Corner},
        },
    },
    geometry::{InputError, Sub8, SubPixel, Vertex},
};

/// How far the lines of a flattened curve are from it at most: 1/64 pixel.
const TOLERANCE: U8F8 = U8F8::from_bits(4);

impl<V: Vertex> SubOutline for Polygon<'_, V> {
    fn edges(&self, edge: &mut dyn FnMut(Corner, Corner)) {
        // To 1/256 pixel, rounded down; beyond all domains where that does not fit.
        let units = |units: i32| {
            let units = i64::from(units) << Sub8::FRACTION_BITS >> V::FRACTION_BITS;
            units.clamp(i32::MIN.into(), i32::MAX.into()) as i32
        };
        for contour in self.contours() {
            let corners = contour
                .iter()
                .map(|vertex| [units(vertex.x_units()), units(vertex.y_units())]);
            sub_outline::close(corners, edge);
        }
    }
}

impl<V: Vertex> OutlinedShape for Polygon<'_, V> {
    const IS_CUT_OFF: bool = true;

    fn layers<C: PixelColor>(&self, style: &PrimitiveStyle<C>, layer: &mut LayerSink<'_, C>) -> Result<(), InputError> {
        fill_and_stroke(self, self.fill_rule(), style, layer)
    }

    fn aligned_layers<C: PixelColor>(
        &self,
        style: &PrimitiveStyle<C>,
        layer: &mut AlignedSink<'_, C>,
    ) -> Result<(), InputError> {
        aligned_layers(self, self.fill_rule(), style, layer)
    }
}

/// Curves are flattened to lines that are nowhere further from them than 1/64 pixel, whatever the path's tolerance is.
impl<S: SubPixel> OutlinedShape for Path<'_, S> {
    const IS_CUT_OFF: bool = true;

    fn layers<C: PixelColor>(&self, style: &PrimitiveStyle<C>, layer: &mut LayerSink<'_, C>) -> Result<(), InputError> {
        fill_and_stroke(&self.with_tolerance(TOLERANCE), self.fill_rule(), style, layer)
    }

    fn aligned_layers<C: PixelColor>(
        &self,
        style: &PrimitiveStyle<C>,
        layer: &mut AlignedSink<'_, C>,
    ) -> Result<(), InputError> {
        aligned_layers(&self.with_tolerance(TOLERANCE), self.fill_rule(), style, layer)
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::{
        geometry::Point,
        pixelcolor::{Gray4, GrayColor},
    };

    use super::*;
    use crate::draw::{
        FillRule, PathCommand,
        pictures::{antialiased, at},
    };

    #[test]
    fn a_star_with_a_hole() {
        let star = [(8, 0), (13, 15), (0, 5), (15, 5), (3, 15)].map(|(x, y)| Point::new(x, y));
        let polygon = [star.as_slice()];
        let polygon = Polygon::new(&polygon, FillRule::EvenOdd);
        antialiased(&polygon, PrimitiveStyle::with_fill(Gray4::WHITE)).assert_pattern(&[
            "        1       ",
            "        A       ",
            "       3F3      ",
            "       8F8      ",
            "       CFC      ",
            "1788886888688872",
            " 4EFFF8   8FFE5 ",
            "  2CFF3   3FD3  ",
            "    9C     92   ",
            "     61   57    ",
            "     CD2 7FC    ",
            "    3FFE7FFF3   ",
            "    8FD3 6FF8   ",
            "    CC2   3DC   ",
            "   3A1     1B3  ",
            "   2         2  ",
        ]);
    }

    #[test]
    fn a_stroke_lies_over_the_fill() {
        let corners = [(2, 2), (13, 4), (7, 13)].map(|(x, y)| Point::new(x, y));
        let polygon = [corners.as_slice()];
        let polygon = Polygon::new(&polygon, FillRule::NonZero);
        let style = PrimitiveStyle {
            fill_color: Some(Gray4::new(6)),
            ..PrimitiveStyle::with_stroke(Gray4::WHITE, 2)
        };
        antialiased(&polygon, style).assert_pattern(&[
            "               ",
            "1A852          ",
            " 9FFFEC9641    ",
            " 2FFEFFFFFFDA85",
            "  AFB78ABDFFFFB",
            "  4FE666666AFE2",
            "   CFA66667EF6 ",
            "   5FE6666CFB  ",
            "    DF9669FE2  ",
            "    6FD67EF6   ",
            "    1EF8CFB    ",
            "     8FEFE2    ",
            "     1EFF6     ",
            "      9FB      ",
            "      2E2      ",
            "       3       ",
        ]);
    }

    #[test]
    fn the_stroke_of_an_open_path_has_butt_caps() {
        let half_moon = [
            PathCommand::MoveTo(at(3.0, 2.5)),
            PathCommand::CubicTo(at(15.0, 2.5), at(15.0, 12.5), at(3.0, 12.5)),
        ];
        let half_moon = Path::new(&half_moon, FillRule::NonZero).unwrap();
        antialiased(&half_moon, PrimitiveStyle::with_stroke(Gray4::WHITE, 3)).assert_pattern(&[
            "              ",
            "   37641      ",
            "   7FFFFC71   ",
            "   8FFFFFFE6  ",
            "   489CFFFFF8 ",
            "       15DFFF4",
            "         1BFFB",
            "          2FFE",
            "          2FFE",
            "         1BFFB",
            "       15DFFF4",
            "   489CFFFFF8 ",
            "   8FFFFFFE6  ",
            "   7FFFFC71   ",
            "   37641      ",
        ]);
    }
}
