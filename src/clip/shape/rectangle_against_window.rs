//! How much of a rectangle a window shows, from the outcodes of its first and its last pixel: where they share a side,
//! nothing is visible; where neither is beyond a side, all of it is.
//!
//! Guarantees: exact for every embedded-graphics rectangle, also one that reaches beyond `i32::MAX`.
//!
//! Cost: eight comparisons, no product. Take it with the bounding box of what costs more to draw than this test, as a text,
//! an image or a path: what is not visible is left out, and words can be shown only where all of them is visible.

use embedded_graphics::{geometry::Point, primitives::Rectangle};

use crate::{
    clip::{Classification, Outcode},
    geometry::Window,
};

impl Classification {
    /// How much of a rectangle the window shows: exact, by the outcodes of two corners.
    ///
    /// Cost: eight comparisons, no product.
    ///
    /// ```
    /// use embedded_graphics::{mono_font::{MonoTextStyle, ascii::FONT_6X10}, pixelcolor::BinaryColor, prelude::*, text::Text};
    /// use zrow::{clip::Classification, geometry::Window};
    ///
    /// let panel = Window { left: 0, top: 0, right: 128, bottom: 64 };
    /// let style = MonoTextStyle::new(&FONT_6X10, BinaryColor::On);
    /// let at = |x, y| Text::new("zrow", Point::new(x, y), style).bounding_box();
    /// assert_eq!(Classification::rectangle_against_window(&at(10, 20), &panel), Classification::Whole);
    /// assert_eq!(Classification::rectangle_against_window(&at(120, 20), &panel), Classification::Part);
    /// assert_eq!(Classification::rectangle_against_window(&at(10, 80), &panel), Classification::Nothing);
    /// ```
    pub fn rectangle_against_window(rectangle: &Rectangle, window: &Window) -> Classification {
        let Some((first, last)) = corners(rectangle).filter(|_| !window.is_empty()) else {
            return Classification::Nothing;
        };
        let (first_code, last_code) = (Outcode::of(first, window), Outcode::of(last, window));
        if !first_code.shared(last_code).is_inside() {
            return Classification::Nothing;
        }
        if first_code.either(last_code).is_inside() {
            return Classification::Whole;
        }
        let fills = first.x <= window.left
            && first.y <= window.top
            && last.x >= window.right - 1
            && last.y >= window.bottom - 1;
        if fills {
            Classification::Fills
        } else {
            Classification::Part
        }
    }
}

impl Window {
    /// The part of a rectangle that the window shows; `None` where that is no pixel.
    ///
    /// Clipping the result again changes nothing.
    pub fn clip_rectangle(&self, rectangle: &Rectangle) -> Option<Rectangle> {
        let visible = Window::from(*rectangle).intersection(self);
        (!visible.is_empty()).then(|| visible.to_rectangle())
    }
}

/// The first and the last pixel of a rectangle; `None` where it has no pixels.
///
/// A coordinate of the last pixel beyond `i32::MAX` is returned as `i32::MAX`. That is beyond every window too, since no window
/// contains a pixel at `i32::MAX`.
pub(crate) fn corners(rectangle: &Rectangle) -> Option<(Point, Point)> {
    let first = rectangle.top_left;
    let last = Point::new(
        first.x.saturating_add_unsigned(rectangle.size.width.checked_sub(1)?),
        first.y.saturating_add_unsigned(rectangle.size.height.checked_sub(1)?),
    );
    Some((first, last))
}
