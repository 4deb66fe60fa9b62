//! Paths by copy: curves are flattened once, the fill is chains of edges, the stroke the vertices of its lines.

use core::marker::PhantomData;

use embedded_graphics::geometry::Point;

use crate::{
    draw::{
        FillRule, Path, PrimitiveStyle, StrokedShape,
        chains::ContourEdges,
        payload::Payload,
        picture::{
            item::Extent,
            kinds::{
                contour_stroke::{ContourStroke, Stroke, over_fill},
                contours::ContourWriter,
                polygon::filled,
                thin_stroke::{self, ThinStroke},
            },
            prepare::{CopiedShape, Draft, not_used},
        },
        shapes::{FlatPoint, FlatStep, nearest_pixel},
    },
    geometry::{Sub8, SubPixel},
    surface::{BandColor, Order},
};

impl<S: SubPixel> CopiedShape for Path<'_, S> {
    fn prepare<'a, C: BandColor, O: Order>(
        &self,
        style: &PrimitiveStyle<C>,
        payload: &mut Payload<'_>,
    ) -> Draft<'a, C, O> {
        let edges = ContourEdges {
            each: &|sink| self.sub_edges(sink),
            fraction_bits: Sub8::FRACTION_BITS,
            fill_rule: self.fill_rule(),
        };
        match (style.fill_color, style.effective_stroke_color()) {
            (None, None) => Draft::nothing(),
            (Some(fill), None) => filled(fill, &edges, payload),
            (fill, Some(color)) if style.stroke_width > 1 => {
                wide(self, (fill, &edges), (color, style.stroke_width), payload)
            }
            (fill, Some(color)) => thin(self, (fill, &edges), color, payload),
        }
    }
}

/// The item of a path with a stroke of two pixels or more.
fn wide<'a, C: BandColor, O: Order, S: SubPixel>(
    path: &Path<'_, S>,
    (fill, edges): (Option<C>, &ContourEdges<'_>),
    (color, width): (C, u32),
    payload: &mut Payload<'_>,
) -> Draft<'a, C, O> {
    let stroke = ContourStroke {
        write: &|writer| write(path, writer, |vertex| [vertex.x_units(), vertex.y_units()]),
        paths: &|call| path.paths(u64::from(width) * 2, call),
        offset: Point::zero(),
        fraction_bits: Sub8::FRACTION_BITS,
        fill_rule: FillRule::NonZero,
    };
    match fill {
        Some(fill) => stroke.walked_over_fill((fill, edges), (color, width), payload),
        None => stroke.walked((color, width), payload),
    }
}

/// The item of a path with a stroke of one pixel's width.
fn thin<'a, C: BandColor, O: Order, S: SubPixel>(
    path: &Path<'_, S>,
    (fill, edges): (Option<C>, &ContourEdges<'_>),
    color: C,
    payload: &mut Payload<'_>,
) -> Draft<'a, C, O> {
    let start = payload.needed();
    if fill.is_some() {
        payload.push(0);
    }
    let write = |writer: &mut ContourWriter<'_, '_>| write(path, writer, |vertex| nearest_pixel(&vertex).into());
    let bounds = thin_stroke::store::<C, O>(color, &write, Point::zero(), payload);
    match fill {
        Some(fill) => over_fill::<C, O, ThinStroke>(start, bounds, (fill, edges), payload),
        None => Draft::new(
            Extent::of(&bounds),
            not_used::<C>(),
            const { &Stroke::<ThinStroke>(PhantomData) },
        ),
    }
}

/// Writes the contours of a path that have a line.
fn write<S: SubPixel>(path: &Path<'_, S>, writer: &mut ContourWriter<'_, '_>, vertex: impl Fn(FlatPoint) -> [i32; 2]) {
    let (mut first, mut has_line) = (FlatPoint::default(), false);
    let begin = |writer: &mut ContourWriter<'_, '_>, first: FlatPoint| {
        writer.begin();
        writer.push(vertex(first));
    };
    begin(writer, first);
    for step in path.steps() {
        match step {
            FlatStep::LineTo(to) => {
                writer.push(vertex(to));
                has_line = true;
                continue;
            }
            FlatStep::MoveTo(to) => {
                writer.end(false, !has_line);
                first = to;
            }
            FlatStep::Close => writer.end(true, false),
        }
        has_line = false;
        begin(writer, first);
    }
    writer.end(false, !has_line);
}
