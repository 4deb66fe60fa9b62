//! Rectangles against a window: the outcodes of two corners say it all.
//!
//! Guarantees: exact for every embedded-graphics rectangle, also one that reaches beyond `i32::MAX`. A box around a text is
//! one: text that is whole can be drawn without clipping, text that is not visible costs nothing, and whoever wants all
//! of a word or none draws only what is whole.
//!
//! Cost: eight comparisons, no product. Take it before anything that is dearer than its box: a text, an image, a path.

use embedded_graphics::{geometry::Point, primitives::Rectangle};

use crate::{
    clip::{Outcode, Visibility},
    geometry::Window,
};

impl Visibility {
    /// How much of a rectangle the window shows: exact, by the outcodes of two corners.
    ///
    /// Cost: eight comparisons, no product.
    ///
    /// ```
    /// use embedded_graphics::{mono_font::{MonoTextStyle, ascii::FONT_6X10}, pixelcolor::BinaryColor, prelude::*, text::Text};
    /// use zrow::{clip::Visibility, geometry::Window};
    ///
    /// let panel = Window { left: 0, top: 0, right: 128, bottom: 64 };
    /// let style = MonoTextStyle::new(&FONT_6X10, BinaryColor::On);
    /// let at = |x, y| Text::new("zrow", Point::new(x, y), style).bounding_box();
    /// assert_eq!(Visibility::rectangle_against_window(&at(10, 20), &panel), Visibility::Whole);
    /// assert_eq!(Visibility::rectangle_against_window(&at(120, 20), &panel), Visibility::Part);
    /// assert_eq!(Visibility::rectangle_against_window(&at(10, 80), &panel), Visibility::Nothing);
    /// ```
    pub fn rectangle_against_window(rectangle: &Rectangle, window: &Window) -> Visibility {
        let Some((first, last)) = corners(rectangle).filter(|_| !window.is_empty()) else {
            return Visibility::Nothing;
        };
        let (first_code, last_code) = (Outcode::of(first, window), Outcode::of(last, window));
        if !first_code.shared(last_code).is_inside() {
            return Visibility::Nothing;
        }
        if first_code.either(last_code).is_inside() {
            return Visibility::Whole;
        }
        let fills = first.x <= window.left
            && first.y <= window.top
            && last.x >= window.right - 1
            && last.y >= window.bottom - 1;
        if fills { Visibility::Fills } else { Visibility::Part }
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
/// A last pixel beyond `i32::MAX` is taken to be there, and so beyond every window, which ends before.
pub(crate) fn corners(rectangle: &Rectangle) -> Option<(Point, Point)> {
    let first = rectangle.top_left;
    let last = Point::new(
        first.x.saturating_add_unsigned(rectangle.size.width.checked_sub(1)?),
        first.y.saturating_add_unsigned(rectangle.size.height.checked_sub(1)?),
    );
    Some((first, last))
}
