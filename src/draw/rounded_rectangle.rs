//! embedded-graphics' `RoundedRectangle`, at any size, position and radii.

use embedded_graphics::{
    geometry::{Dimensions, Size},
    pixelcolor::PixelColor,
    primitives::{CornerRadii, Rectangle, RoundedRectangle, StyledDimensions},
};

use crate::{
    draw::{
        PrimitiveStyle, StyledShape,
        areas::{Areas, styled_box},
        drawable_through_generic,
    },
    scan::{
        CurveNumber, ForwardDifference, ellipse,
        rounded_corners::{self, RoundedOutline, RoundedRows},
    },
    target::{MirroredBox, Span, Target},
};

/// The radii of a rectangle that became larger or smaller.
fn moved(corners: &CornerRadii, by: impl Fn(u32) -> u32) -> CornerRadii {
    let radius = |radius: Size| Size::new(by(radius.width), by(radius.height));
    CornerRadii {
        top_left: radius(corners.top_left),
        top_right: radius(corners.top_right),
        bottom_right: radius(corners.bottom_right),
        bottom_left: radius(corners.bottom_left),
    }
}

/// An area and a hole in it, with rounded corners.
struct RoundedAreas {
    outer: RoundedOutline,
    inner: RoundedOutline,
}

impl RoundedAreas {
    fn new<C: PixelColor>(shape: &RoundedRectangle, style: &PrimitiveStyle<C>, areas: &Areas<C>) -> Self {
        let inner_corners = moved(&shape.corners, |length| {
            length.saturating_sub(style.inside_stroke_width())
        });
        let outer_corners = if style.effective_stroke_color().is_some() {
            moved(&shape.corners, |length| {
                length.saturating_add(style.outside_stroke_width())
            })
        } else {
            inner_corners
        };
        Self {
            outer: RoundedOutline::new(areas.outer, outer_corners),
            inner: RoundedOutline::new(areas.inner, inner_corners),
        }
    }

    /// Not inlined: its walks would be on the stack of a caller that draws several shapes.
    #[inline(never)]
    fn draw_equal_corners<N, T>(
        &self,
        enter: fn(Size, u32) -> ForwardDifference<N>,
        shape: &MirroredBox,
        target: &mut T,
        ink: T::Ink,
        inner_ink: Option<T::Ink>,
    ) -> Result<(), T::Error>
    where
        N: CurveNumber,
        T: Target,
    {
        match RoundedRows::new(&self.outer, &self.inner, enter, shape) {
            Some(mut rows) => target.fill_mirrored(shape, &mut rows, ink, inner_ink),
            None => Ok(()),
        }
    }

    /// Row by row: each corner is another one.
    fn draw_rows<T: Target>(
        &self,
        shape: &MirroredBox,
        target: &mut T,
        ink: T::Ink,
        inner_ink: Option<T::Ink>,
    ) -> Result<(), T::Error> {
        let Size { width, height } = self.outer.outline.size;
        let inner_size = self.inner.outline.size;
        // In the middle of the outer one; where it is empty, no row is in it.
        let left = (self.inner.outline.left - self.outer.outline.left) as u32;
        let top = (self.inner.outline.top - self.outer.outline.top) as u32;
        let has_hole = |row: u32| !self.inner.outline.is_empty() && row.wrapping_sub(top) < inner_size.height;
        for upper in shape.rows.clone() {
            let lower = MirroredBox::mirrored(upper, height);
            for (row, y) in [upper, lower].into_iter().zip(shape.lines(upper)) {
                let Some(y) = y else { continue };
                let (before, after) = self.outer.insets(row);
                let start = shape.x(before);
                // Radii that overlap leave nothing.
                let end = shape.x(width.saturating_sub(after)).max(start);
                let (hole_start, hole_end) = if has_hole(row) {
                    let (before, after) = self.inner.insets(row.wrapping_sub(top));
                    let first = left.wrapping_add(before);
                    (
                        shape.x(first),
                        shape.x(left.wrapping_add(inner_size.width).wrapping_sub(after)),
                    )
                } else {
                    (end, end)
                };
                // Radii that were confined differently can make the inner corner cut less than the outer one does.
                let (hole_start, hole_end) = (hole_start.clamp(start, end), hole_end.clamp(start, end));
                fill(target, Span::new(y, start, hole_start), Some(ink))?;
                fill(target, Span::new(y, hole_start, hole_end), inner_ink)?;
                fill(target, Span::new(y, hole_end.max(hole_start), end), Some(ink))?;
            }
        }
        Ok(())
    }
}

fn fill<T: Target>(target: &mut T, span: Span, ink: Option<T::Ink>) -> Result<(), T::Error> {
    match ink {
        Some(ink) if !span.is_empty() => target.fill_span(span, ink),
        _ => Ok(()),
    }
}

impl StyledShape for RoundedRectangle {
    fn draw_styled_on<T: Target>(&self, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error> {
        let Some(areas) = Areas::new(self.bounding_box(), style) else {
            return Ok(());
        };
        let Some(shape) = MirroredBox::new(areas.outer, &target.window()) else {
            return Ok(());
        };
        let ink = target.ink(areas.color);
        let inner_ink = areas.inner_color.map(|color| target.ink(color));
        let rounded = RoundedAreas::new(self, style, &areas);
        match (rounded.outer.equal_radius(), rounded.inner.equal_radius()) {
            (Some(outer), Some(inner)) if rounded_corners::is_narrow(outer) && rounded_corners::is_narrow(inner) => {
                rounded.draw_equal_corners(ellipse::enter_narrow, &shape, target, ink, inner_ink)
            }
            (Some(_), Some(_)) => rounded.draw_equal_corners(ellipse::enter_wide, &shape, target, ink, inner_ink),
            _ => rounded.draw_rows(&shape, target, ink, inner_ink),
        }
    }
}

drawable_through_generic!(RoundedRectangle);

impl<C: PixelColor> StyledDimensions<PrimitiveStyle<C>> for RoundedRectangle {
    fn styled_bounding_box(&self, style: &PrimitiveStyle<C>) -> Rectangle {
        styled_box(self.bounding_box(), style)
    }
}
