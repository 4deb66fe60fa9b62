//! embedded-graphics' `Rectangle`, at any size and position.
//!
//! The fill is one window; the stroke is four: above the fill, left of it, right of it, and below. Each pixel is drawn
//! once.

use embedded_graphics::{
    pixelcolor::PixelColor,
    primitives::{Rectangle, StyledDimensions},
};

use crate::{
    draw::{
        PrimitiveStyle, StrokedShape, StyledShape, drawable_through_generic,
        eg::areas::{Areas, may_meet, styled_box},
        stroked_through_generic,
        style::stroke,
    },
    geometry::Window,
    scan::stroke::wide_stroke::Path,
    surface::Target,
};

impl StyledShape for Rectangle {
    fn draw_styled_on<T: Target>(&self, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error> {
        if !may_meet(self, style, &target.window()) {
            return Ok(());
        }
        match Areas::new(*self, style) {
            Some(areas) => draw(&areas, target),
            None => Ok(()),
        }
    }
}

/// Paints the areas of a styled rectangle, inside the target's window.
// Not inlined: its windows would be on the stack of a caller that draws several shapes.
#[inline(never)]
pub(crate) fn draw<T: Target>(areas: &Areas<T::Color>, target: &mut T) -> Result<(), T::Error> {
    let window = target.window();
    let outer = areas.outer.to_window().intersection(&window);
    let raw = target.raw(areas.color);
    let inner = areas.inner.to_window().intersection(&window);
    if inner.is_empty() {
        return target.fill_clipped_window(outer, raw);
    }
    for side in frame(outer, inner) {
        target.fill_clipped_window(side, raw)?;
    }
    match areas.inner_color {
        Some(color) => target.fill_clipped_window(inner, target.raw(color)),
        None => Ok(()),
    }
}

/// The windows that the outer window is divided into around the inner one, which lies inside it: above, left, right and
/// below.
fn frame(outer: Window, inner: Window) -> [Window; 4] {
    let beside = Window {
        top: inner.top,
        bottom: inner.bottom,
        ..outer
    };
    [
        Window {
            bottom: inner.top,
            ..outer
        },
        Window {
            right: inner.left,
            ..beside
        },
        Window {
            left: inner.right,
            ..beside
        },
        Window {
            top: inner.bottom,
            ..outer
        },
    ]
}

/// The path of a rectangle goes through the centres of its outermost pixels. A rectangle without pixels has no path.
impl StrokedShape for Rectangle {
    fn paths(&self, width_in_halves: u64, call: &mut dyn FnMut(&Path<'_>)) {
        let Rectangle { top_left, size } = *self;
        if size.width == 0 || size.height == 0 {
            return;
        }
        let (right, down) = (i64::from(size.width) - 1, i64::from(size.height) - 1);
        let vertex = |number: usize| {
            let (x, y) = match number {
                0 => (0, 0),
                1 => (right, 0),
                2 => (right, down),
                _ => (0, down),
            };
            stroke::moved(top_left, (x, y))
        };
        call(&Path::new(&vertex, 4, true, width_in_halves));
    }
}

drawable_through_generic!(Rectangle);
stroked_through_generic!(Rectangle);

impl<C: PixelColor> StyledDimensions<PrimitiveStyle<C>> for Rectangle {
    fn styled_bounding_box(&self, style: &PrimitiveStyle<C>) -> Rectangle {
        styled_box(*self, style)
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::{
        geometry::{Point, Size},
        primitives::StrokeAlignment,
    };

    use super::*;
    use crate::draw::pictures::{FILL, drawn_by_both, green_in_red, stroke};

    #[test]
    fn a_rectangle_of_8_by_3_pixels() {
        let rectangle = Rectangle::new(Point::new(1, 1), Size::new(8, 3));
        drawn_by_both(&rectangle, FILL).assert_pattern(&[
            "         ", //
            " ########",
            " ########",
            " ########",
        ]);
    }

    #[test]
    fn a_centred_stroke_3_pixels_wide_has_one_pixel_outside() {
        let rectangle = Rectangle::new(Point::new(1, 1), Size::new(10, 6));
        let display = drawn_by_both(&rectangle, green_in_red(3, StrokeAlignment::Center));
        display.assert_pattern(&[
            "RRRRRRRRRRRR",
            "RRRRRRRRRRRR",
            "RRRRRRRRRRRR",
            "RRRGGGGGGRRR",
            "RRRGGGGGGRRR",
            "RRRRRRRRRRRR",
            "RRRRRRRRRRRR",
            "RRRRRRRRRRRR",
        ]);
    }

    #[test]
    fn a_frame_cut_by_the_upper_left_corner() {
        let rectangle = Rectangle::new(Point::new(-3, -1), Size::new(10, 6));
        drawn_by_both(&rectangle, stroke(1)).assert_pattern(&[
            "      #  ",
            "      #  ",
            "      #  ",
            "      #  ",
            "#######  ",
        ]);
    }

    #[test]
    fn a_stroke_inside_that_is_too_wide_leaves_no_fill() {
        let rectangle = Rectangle::new(Point::zero(), Size::new(7, 4));
        let display = drawn_by_both(&rectangle, green_in_red(2, StrokeAlignment::Inside));
        display.assert_pattern(&[
            "RRRRRRR  ", //
            "RRRRRRR  ",
            "RRRRRRR  ",
            "RRRRRRR  ",
        ]);
    }
}
