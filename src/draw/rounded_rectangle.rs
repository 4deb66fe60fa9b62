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

    /// Row by row, each half from the outside to the middle: each corner is another one.
    fn draw_rows<T: Target>(
        &self,
        shape: &MirroredBox,
        target: &mut T,
        ink: T::Ink,
        inner_ink: Option<T::Ink>,
    ) -> Result<(), T::Error> {
        let Self { outer, inner } = self;
        // In the middle of the outer one; where it is empty, no row is in it.
        let top = (inner.outline.top - outer.outline.top) as u32;
        let bottom = shape
            .size
            .height
            .wrapping_sub(top)
            .wrapping_sub(inner.outline.size.height);
        let (upper, lower) = (shape.upper.clone(), shape.lower.clone());
        for (is_lower, rows) in [(false, upper), (true, lower)] {
            let (mut outer_rows, mut inner_rows, outside) = if is_lower {
                (outer.lower_half(), inner.lower_half(), bottom)
            } else {
                (outer.upper_half(), inner.upper_half(), top)
            };
            for row in rows {
                let y = if is_lower {
                    shape.y(MirroredBox::mirrored(row, shape.size.height))
                } else {
                    shape.y(row)
                };
                let (before, after) = outer_rows.insets(row);
                let start = shape.x(before);
                // Radii that overlap leave nothing.
                let end = shape.x(shape.size.width.saturating_sub(after)).max(start);
                let inner_row = row.wrapping_sub(outside);
                if inner.outline.is_empty() || inner_row >= inner.outline.size.height {
                    target.fill_span(Span::new(y, start, end), ink)?;
                    continue;
                }
                let [hole_start, hole_end] = self.hole(shape, inner_rows.insets(inner_row));
                // Radii that were confined differently can make the inner corner cut less than the outer one does.
                let hole_start = hole_start.clamp(start, end);
                let hole_end = hole_end.clamp(hole_start, end);
                target.fill_span(Span::new(y, start, hole_start), ink)?;
                if let Some(ink) = inner_ink {
                    target.fill_span(Span::new(y, hole_start, hole_end), ink)?;
                }
                target.fill_span(Span::new(y, hole_end, end), ink)?;
            }
        }
        Ok(())
    }

    /// The columns where a row of the hole begins and where it ends.
    fn hole(&self, shape: &MirroredBox, (before, after): (u32, u32)) -> [i32; 2] {
        let left = (self.inner.outline.left - self.outer.outline.left) as u32;
        let width = self.inner.outline.size.width;
        [
            shape.x(left.wrapping_add(before)),
            shape.x(left.wrapping_add(width).wrapping_sub(after)),
        ]
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
