//! embedded-graphics' `Rectangle`, at any size and position.

use embedded_graphics::{
    pixelcolor::PixelColor,
    primitives::{Rectangle, StyledDimensions},
};

use crate::{
    draw::{
        PrimitiveStyle, StyledShape,
        areas::{Areas, styled_box},
        drawable_through_generic,
    },
    geometry::Window,
    target::Target,
};

impl StyledShape for Rectangle {
    fn draw_styled_on<T: Target>(&self, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error> {
        match Areas::new(*self, style) {
            // Most rectangles of a picture are not in a band of it.
            Some(areas) if areas.outer.to_window().meets(&target.window()) => draw(&areas, target),
            _ => Ok(()),
        }
    }
}

/// Paints both areas.
// Not inlined: its windows would be on the stack of a caller that draws several shapes.
#[inline(never)]
fn draw<T: Target>(areas: &Areas<T::Color>, target: &mut T) -> Result<(), T::Error> {
    let window = target.window();
    let outer = areas.outer.to_window().intersection(&window);
    let ink = target.ink(areas.color);
    let inner = areas.inner.to_window().intersection(&window);
    if inner.is_empty() {
        return target.fill_window(outer, ink);
    }
    for side in frame(outer, inner) {
        target.fill_window(side, ink)?;
    }
    match areas.inner_color {
        Some(color) => target.fill_window(inner, target.ink(color)),
        None => Ok(()),
    }
}

/// What is in the outer window and not in the inner one, which lies inside it: above, left, right, below.
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

drawable_through_generic!(Rectangle);

impl<C: PixelColor> StyledDimensions<PrimitiveStyle<C>> for Rectangle {
    fn styled_bounding_box(&self, style: &PrimitiveStyle<C>) -> Rectangle {
        styled_box(*self, style)
    }
}
