//! Helpers for shapes with wide strokes: drawing fill and stroke in one pass, and finding their bounds.
//!
//! The edges of the fill and of the stroke's polygons go through one scan conversion with two winding numbers, so that
//! each pixel is drawn once, as fill or as stroke.

use embedded_graphics::{geometry::Point, pixelcolor::PixelColor, primitives::StrokeAlignment};

use crate::{
    draw::PrimitiveStyle,
    geometry::Bounds,
    scan::{
        polygon::{
            Edge, Part,
            banded_polygon::{self, EdgeSource},
            bounding_box::{MOST_LINE_TESTS, PolygonPixels},
            scanline_polygon::{FillRule, PartRule},
        },
        stroke::wide_stroke::{self, Corner, Path, Position},
    },
    surface::Target,
};

/// Fills the edges of a shape and of its stroke, each pixel once, in the fill colour and the stroke colour of the
/// style.
pub(crate) fn draw<T: Target>(
    target: &mut T,
    style: &PrimitiveStyle<T::Color>,
    rule: PartRule,
    source: &EdgeSource<'_, Edge>,
) -> Result<(), T::Error> {
    if style.is_transparent() {
        return Ok(());
    }
    let stroke = style.effective_stroke_color().map(|color| target.raw(color));
    let fill = style.fill_color.map(|color| target.raw(color));
    let window = target.window();
    banded_polygon::scan(source, rule, &window, |span, part| {
        let raw = match part {
            Part::Fill => fill,
            Part::Stroke => stroke,
        };
        raw.map_or(Ok(()), |raw| target.fill_clipped_span(span, raw))
    })
}

/// An upper bound for the distance in pixels between a stroke and the pixels that it follows. The tip of a miter is at
/// most two widths from its corner, and a stroke inside or outside is generated twice as wide.
#[inline(always)]
pub(crate) const fn reach(stroke_width: u32) -> u32 {
    if stroke_width > 1 {
        stroke_width.saturating_mul(4).saturating_add(4)
    } else {
        stroke_width
    }
}

/// The width of the stroke that is generated for a polygon, in half pixels. A stroke inside or outside is generated twice as wide
/// and centred on the contour; [`PartRule`] then drops the other half.
pub(crate) fn width_in_halves<C: PixelColor>(style: &PrimitiveStyle<C>) -> u64 {
    let width = u64::from(style.stroke_width);
    match style.stroke_alignment {
        StrokeAlignment::Center => width * 2,
        StrokeAlignment::Inside | StrokeAlignment::Outside => width * 4,
    }
}

/// Whether the pixels that are drawn depend on the inside of the shape: where it is filled, or the stroke is not
/// centred.
pub(crate) fn needs_inside<C: PixelColor>(style: &PrimitiveStyle<C>) -> bool {
    style.fill_color.is_some() || style.stroke_alignment != StrokeAlignment::Center
}

/// Draws the centred stroke of a path, without a fill.
pub(crate) fn draw_path<T: Target>(
    target: &mut T,
    style: &PrimitiveStyle<T::Color>,
    path: &Path<'_>,
) -> Result<(), T::Error> {
    let without_fill = PrimitiveStyle {
        fill_color: None,
        ..*style
    };
    draw(
        target,
        &without_fill,
        PartRule::fill(FillRule::NonZero),
        &|window, sink| {
            path.edges(window, sink);
        },
    )
}

/// The centre of a pixel, moved by `offset` pixels, as a position of a path.
pub(crate) fn position(pixel: Point, offset: Point) -> Position {
    moved(pixel, (i64::from(offset.x), i64::from(offset.y)))
}

/// The centre of a pixel, moved by so many pixels to the right and down, as a position of a path.
pub(crate) fn moved(pixel: Point, (right, down): (i64, i64)) -> Position {
    let coordinate = |pixel: i32, offset: i64| (i64::from(pixel) + offset) << wide_stroke::FRACTION_BITS;
    (coordinate(pixel.x, right), coordinate(pixel.y, down))
}

/// The smallest box around the pixels of a stroke.
///
/// Cost: a square root for each segment, and some divisions for each polygon of the stroke that exceeds the box of the
/// polygons before it (see [`bounding_box`](crate::scan::polygon::bounding_box)).
pub(crate) fn bounds(path: &Path<'_>) -> Bounds {
    let (mut bounds, mut tests_left) = (Bounds::EMPTY, MOST_LINE_TESTS);
    path.polygons(None, &mut |corners| {
        bounds = with_polygon(bounds, corners, &mut tests_left);
    });
    bounds
}

/// Grows bounds to the pixels of a convex polygon of a stroke. `tests_left` is the number of rows and columns that may
/// still be tested; once it is 0, the box around the pixel centres between the polygon's corners is taken.
pub(crate) fn with_polygon(bounds: Bounds, corners: &[Corner], tests_left: &mut u32) -> Bounds {
    let sides = |sink: &mut dyn FnMut([i64; 2], [i64; 2])| {
        let Some(&last) = corners.last() else { return };
        let units = |(x, y): Corner| [i64::from(x), i64::from(y)];
        let mut from = units(last);
        for &corner in corners {
            let to = units(corner);
            sink(from, to);
            from = to;
        }
    };
    let pixels = PolygonPixels {
        sides: &sides,
        fill_rule: FillRule::NonZero,
        fraction_bits: wide_stroke::FRACTION_BITS,
    };
    pixels.grow(bounds, tests_left)
}
