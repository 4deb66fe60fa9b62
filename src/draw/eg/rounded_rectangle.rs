//! embedded-graphics' `RoundedRectangle`, at any size, position and radii.
//!
//! Each row is an outer run of columns and an inner run, from the insets that the corners give the two rounded
//! rectangles. Where all corners of each rectangle are alike, the rows of one quarter are walked once, and drawn in
//! both halves and on both sides; otherwise each corner is walked by itself.

use core::ops::Range;

use embedded_graphics::{
    geometry::{Dimensions, Size},
    pixelcolor::PixelColor,
    primitives::{CornerRadii, Rectangle, RoundedRectangle, StyledDimensions},
};

use crate::{
    draw::{
        PrimitiveStyle, StyledShape, drawable_through_generic,
        eg::areas::{Areas, may_meet},
    },
    geometry::WideRectangle,
    scan::{
        polygon::shrunk_box::shrunk_by_rows,
        round::{
            Curve, CurveNumber,
            rounded_corners::{self, HalfRows, RoundedRows, WideRoundedRectangle},
        },
    },
    surface::{Span, SymmetricBox, Target},
};

/// The corner radii with `by` applied to each length, for a rectangle whose sides move outwards or inwards.
fn moved(corners: &CornerRadii, by: impl Fn(u32) -> u32) -> CornerRadii {
    let radius = |radius: Size| Size::new(by(radius.width), by(radius.height));
    CornerRadii {
        top_left: radius(corners.top_left),
        top_right: radius(corners.top_right),
        bottom_right: radius(corners.bottom_right),
        bottom_left: radius(corners.bottom_left),
    }
}

/// An outer rounded rectangle and an inner one, which is its hole.
///
/// The stroke's colour is for the pixels of the outer shape that are not in the inner one, the fill's colour for the
/// pixels of both. The inner shape is part of the outer one, except where radii are scaled down by different factors,
/// which can make its corners cut off less.
struct RoundedAreas {
    outer: WideRoundedRectangle,
    inner: WideRoundedRectangle,
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
            outer: WideRoundedRectangle::new(areas.outer, outer_corners),
            inner: WideRoundedRectangle::new(areas.inner, inner_corners),
        }
    }

    /// The radii of the outer and the inner corners, if [`draw_symmetric`](Self::draw_symmetric) can draw the shape:
    /// where the four corners of each rectangle are alike and share no columns.
    fn symmetric_radii(&self) -> Option<[Size; 2]> {
        Some([self.outer.symmetric_radius()?, self.inner.symmetric_radius()?])
    }

    /// Draws a shape whose corners are alike: each walked row gives both halves and both sides. Not inlined, so that
    /// the walks are not on the stack of a caller that draws several shapes.
    #[inline(never)]
    fn draw_symmetric<N, T>(
        &self,
        radii: [Size; 2],
        curve: Curve<N>,
        shape: &SymmetricBox,
        target: &mut T,
        raw: T::Raw,
        inner_raw: Option<T::Raw>,
    ) -> Result<(), T::Error>
    where
        N: CurveNumber,
        T: Target,
    {
        let mut rows = RoundedRows::new([&self.outer.rectangle, &self.inner.rectangle], radii, curve, shape);
        target.fill_symmetric(shape, &mut rows, raw, inner_raw)
    }

    /// Draws a shape whose corners may differ, row by row: first the upper half, then the lower one, each from the
    /// outside to the middle.
    fn draw_rows<T: Target>(
        &self,
        shape: &SymmetricBox,
        target: &mut T,
        raw: T::Raw,
        inner_raw: Option<T::Raw>,
    ) -> Result<(), T::Error> {
        let Self { outer, inner } = self;
        // Not negative: the inner box lies inside the outer one.
        let above = (inner.rectangle.top - outer.rectangle.top) as u32;
        let below = shape.size.height - above - inner.rectangle.size.height;
        let (upper, lower) = (shape.upper.clone(), shape.lower.clone());
        for (is_lower, rows) in [(false, upper), (true, lower)] {
            let (mut outer_rows, mut inner_rows, outside) = if is_lower {
                (outer.lower_half(), inner.lower_half(), below)
            } else {
                (outer.upper_half(), inner.upper_half(), above)
            };
            for row in rows {
                let y = if is_lower {
                    shape.y(SymmetricBox::mirrored(row, shape.size.height))
                } else {
                    shape.y(row)
                };
                let columns = outer_rows.columns(row);
                let span = |columns: Range<u32>| Span::new(y, shape.x(columns.start), shape.x(columns.end));
                let inner_row = row.checked_sub(outside);
                let Some(inner_row) = inner_row.filter(|&row| row < inner.rectangle.size.height) else {
                    target.fill_clipped_span(span(columns), raw)?;
                    continue;
                };
                let hole = self.hole(&mut inner_rows, inner_row, &columns);
                target.fill_clipped_span(span(columns.start..hole.start), raw)?;
                if let Some(raw) = inner_raw {
                    target.fill_clipped_span(span(hole.clone()), raw)?;
                }
                target.fill_clipped_span(span(hole.end..columns.end), raw)?;
            }
        }
        Ok(())
    }

    /// The columns of a row that both shapes have, counted from the left side of the outer shape. `row` is a row of the
    /// inner shape's half, and `columns` are those of the outer shape.
    // Not inlined: the caller's loop then keeps its numbers in registers (11,500 instead of 13,000 instructions for 60
    // rows, filled).
    #[inline(never)]
    fn hole(&self, rows: &mut HalfRows, row: u32, columns: &Range<u32>) -> Range<u32> {
        let hole = rows.columns(row);
        // Not negative: the inner box lies inside the outer one.
        let left = (self.inner.rectangle.left - self.outer.rectangle.left) as u32;
        let start = (left + hole.start).max(columns.start).min(columns.end);
        start..(left + hole.end).max(start).min(columns.end)
    }
}

impl StyledShape for RoundedRectangle {
    fn draw_styled_on<T: Target>(&self, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error> {
        let bounding_box = self.bounding_box();
        if !may_meet(&bounding_box, style, &target.window()) {
            return Ok(());
        }
        let Some(areas) = Areas::new(bounding_box, style) else {
            return Ok(());
        };
        let Some(shape) = SymmetricBox::new(areas.outer, &target.window()) else {
            return Ok(());
        };
        let raw = target.raw(areas.color);
        let inner_raw = areas.inner_color.map(|color| target.raw(color));
        let rounded = RoundedAreas::new(self, style, &areas);
        match rounded.symmetric_radii() {
            Some(radii) if radii.into_iter().all(rounded_corners::is_narrow) => {
                rounded.draw_symmetric(radii, rounded_corners::NARROW, &shape, target, raw, inner_raw)
            }
            Some(radii) => rounded.draw_symmetric(radii, rounded_corners::WIDE, &shape, target, raw, inner_raw),
            None => rounded.draw_rows(&shape, target, raw, inner_raw),
        }
    }
}

drawable_through_generic!(RoundedRectangle);

/// The smallest box around the pixels of fill and stroke, whichever of them have a colour.
///
/// Cost: that of a few rows where two corners together are at least as long as a side, otherwise that of a comparison
/// for each side.
impl<C: PixelColor> StyledDimensions<PrimitiveStyle<C>> for RoundedRectangle {
    fn styled_bounding_box(&self, style: &PrimitiveStyle<C>) -> Rectangle {
        let width = style.outside_stroke_width();
        let grown = WideRectangle::from(self.bounding_box()).outset(width);
        let rounded = WideRoundedRectangle::new(grown, moved(&self.corners, |length| length.saturating_add(width)));
        if grown.is_empty() || rounded.has_straight_sides() {
            return grown.to_rectangle();
        }
        let window = grown.to_window();
        let smallest = shrunk_by_rows(window, &rounded, &rounded.transposed(), WideRoundedRectangle::has_pixel);
        smallest.to_rectangle()
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::{
        geometry::Point,
        primitives::{CornerRadiiBuilder, StrokeAlignment},
    };

    use super::*;
    use crate::draw::pictures::{FILL, drawn_by_both, green_in_red, stroke};

    #[test]
    fn four_corners_of_3_pixels() {
        let rectangle = Rectangle::new(Point::zero(), Size::new(13, 8));
        let rounded = RoundedRectangle::with_equal_corners(rectangle, Size::new(3, 3));
        drawn_by_both(&rounded, FILL).assert_pattern(&[
            " ########### ",
            "#############",
            "#############",
            "#############",
            "#############",
            "#############",
            "#############",
            " ########### ",
        ]);
    }

    #[test]
    fn a_green_inside_in_a_red_stroke_2_pixels_wide() {
        let rectangle = Rectangle::new(Point::zero(), Size::new(14, 9));
        let rounded = RoundedRectangle::with_equal_corners(rectangle, Size::new(4, 4));
        let display = drawn_by_both(&rounded, green_in_red(2, StrokeAlignment::Inside));
        display.assert_pattern(&[
            "  RRRRRRRRRR  ",
            " RRRRRRRRRRRR ",
            "RRRGGGGGGGGRRR",
            "RRGGGGGGGGGGRR",
            "RRGGGGGGGGGGRR",
            "RRGGGGGGGGGGRR",
            "RRRGGGGGGGGRRR",
            " RRRRRRRRRRRR ",
            "  RRRRRRRRRR  ",
        ]);
    }

    #[test]
    fn each_corner_may_be_another_one() {
        let rectangle = Rectangle::new(Point::zero(), Size::new(14, 10));
        let corners = CornerRadiiBuilder::new()
            .top_left(Size::new(7, 3))
            .top_right(Size::new(2, 2))
            .bottom_right(Size::new(4, 7))
            .build();
        drawn_by_both(&RoundedRectangle::new(rectangle, corners), FILL).assert_pattern(&[
            "   ########## ",
            " #############",
            "##############",
            "##############",
            "##############",
            "##############",
            "############# ",
            "############# ",
            "############  ",
            "###########   ",
        ]);
    }

    #[test]
    fn a_thin_outline_cut_by_the_left_edge() {
        let rectangle = Rectangle::new(Point::new(-4, 0), Size::new(14, 8));
        let rounded = RoundedRectangle::with_equal_corners(rectangle, Size::new(4, 4));
        drawn_by_both(&rounded, stroke(1)).assert_pattern(&[
            "########  ",
            "        # ",
            "         #",
            "         #",
            "         #",
            "         #",
            "        # ",
            "########  ",
        ]);
    }
}
