//! Polygons by copy: the fill as chains of edges, the stroke as its vertices.

use embedded_graphics::{geometry::Point, primitives::StrokeAlignment};

use crate::{
    band::Band,
    draw::{
        Polygon, PrimitiveStyle, StrokedShape,
        chains::{self, ContourEdges},
        payload::Payload,
        picture::{
            item::Extent,
            kinds::{contour_stroke::ContourStroke, filled_chains::FilledChains},
            prepare::{CopiedShape, Draft},
        },
        style::stroke,
    },
    geometry::{Vertex, assert_fraction_bits},
    surface::{BandColor, Order},
};

impl<V: Vertex> CopiedShape for Polygon<'_, V> {
    fn prepare<'a, C: BandColor, O: Order>(
        &self,
        style: &PrimitiveStyle<C>,
        payload: &mut Payload<'_>,
    ) -> Draft<'a, C, O> {
        const { assert_fraction_bits::<V>() }
        let edges = ContourEdges {
            each: &|sink| self.sides(sink),
            fraction_bits: V::FRACTION_BITS,
            fill_rule: self.fill_rule(),
        };
        let stroke = ContourStroke {
            write: &|writer| {
                for contour in self.contours() {
                    writer.begin();
                    for vertex in *contour {
                        writer.push([vertex.x_units(), vertex.y_units()]);
                    }
                    writer.end(true, false);
                }
            },
            paths: &|call| self.paths(stroke::width_in_halves(style), call),
            offset: Point::zero(),
            fraction_bits: V::FRACTION_BITS,
            fill_rule: self.fill_rule(),
        };
        if style.is_transparent() {
            return Draft::nothing();
        }
        let is_centred = style.stroke_alignment == StrokeAlignment::Center;
        match (style.fill_color, style.effective_stroke_color()) {
            (Some(color), None) if style.stroke_width == 0 => filled(color, &edges, payload),
            (None, Some(color)) if is_centred => stroke.walked((color, style.stroke_width), payload),
            (Some(fill), Some(color)) if is_centred => {
                stroke.walked_over_fill((fill, &edges), (color, style.stroke_width), payload)
            }
            (fill, Some(color)) => {
                let stroke_of = (color, style.stroke_width);
                stroke.walked_aside((fill, &edges), stroke_of, style.stroke_alignment, payload)
            }
            // Without a colour, the stroke's pixels are left out of the fill.
            _ => stroke.left_out(style, payload),
        }
    }
}

/// The item of a fill without a stroke.
pub(super) fn filled<'a, C: BandColor, O: Order>(
    color: C,
    edges: &ContourEdges<'_>,
    payload: &mut Payload<'_>,
) -> Draft<'a, C, O> {
    let bounds = chains::store(edges, payload);
    Draft::new(Extent::of(&bounds), Band::<C, O>::word(color), &FilledChains)
}
