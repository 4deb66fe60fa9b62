//! Polylines by copy: their vertices, and how far they are moved.

use core::marker::PhantomData;

use embedded_graphics::primitives::Polyline;

use crate::{
    draw::{
        FillRule, PrimitiveStyle, StrokedShape,
        payload::Payload,
        picture::{
            item::Extent,
            kinds::{
                contour_stroke::{ContourStroke, Stroke},
                contours::ContourWriter,
                thin_stroke::{self, ThinStroke},
            },
            prepare::{CopiedShape, Draft, not_used},
        },
    },
    surface::{BandColor, Order},
};

impl CopiedShape for Polyline<'_> {
    fn prepare<'a, C: BandColor, O: Order>(
        &self,
        style: &PrimitiveStyle<C>,
        payload: &mut Payload<'_>,
    ) -> Draft<'a, C, O> {
        // A polyline with one vertex draws nothing, as in embedded-graphics.
        let (Some(color), true) = (style.effective_stroke_color(), self.vertices.len() > 1) else {
            return Draft::nothing();
        };
        let write = |writer: &mut ContourWriter<'_, '_>| {
            writer.begin();
            for vertex in self.vertices {
                writer.push((*vertex).into());
            }
            writer.end(false, false);
        };
        if style.stroke_width > 1 {
            let stroke = ContourStroke {
                write: &write,
                paths: &|call| self.paths(u64::from(style.stroke_width) * 2, call),
                offset: self.translate,
                fraction_bits: 0,
                fill_rule: FillRule::NonZero,
            };
            return stroke.walked((color, style.stroke_width), payload);
        }
        let bounds = thin_stroke::store::<C, O>(color, &write, self.translate, payload);
        Draft::new(
            Extent::of(&bounds),
            not_used::<C>(),
            const { &Stroke::<ThinStroke>(PhantomData) },
        )
    }
}
