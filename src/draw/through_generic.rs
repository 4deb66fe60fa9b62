//! Macros that implement embedded-graphics' drawing traits, for any `DrawTarget`, on shapes that implement zrow's.
//!
//! Each implementation wraps the `DrawTarget` in a [`Generic`](crate::surface::Generic), which is a
//! [`Target`](crate::surface::Target), and draws on that.

/// Implements `StyledDrawable` with a [`PrimitiveStyle`](crate::draw::PrimitiveStyle) for shapes that are
/// [`StyledShape`](crate::draw::StyledShape)s, so that `Drawable::draw` takes any `DrawTarget`.
macro_rules! drawable_through_generic {
    ($($shape:ty),+) => {$(
        impl<C: embedded_graphics::pixelcolor::PixelColor>
            embedded_graphics::primitives::StyledDrawable<crate::draw::PrimitiveStyle<C>> for $shape
        {
            type Color = C;
            type Output = ();

            fn draw_styled<D>(&self, style: &crate::draw::PrimitiveStyle<C>, target: &mut D) -> Result<(), D::Error>
            where
                D: embedded_graphics::draw_target::DrawTarget<Color = C>,
            {
                crate::draw::StyledShape::draw_styled_on(self, style, &mut crate::surface::Generic(target))
            }
        }
    )+};
}
pub(super) use drawable_through_generic;

/// Implements `StyledDrawable` and `StyledDimensions` with a [`StrokeStyle`](crate::draw::StrokeStyle) for a shape that
/// is a [`StrokedShape`](crate::draw::StrokedShape), so that `Drawable::draw` takes any `DrawTarget`.
macro_rules! stroked_through_generic {
    ($shape:ty $(, $vertex:ident: $bound:ident)?) => {
        impl<'dashes, C: embedded_graphics::pixelcolor::PixelColor $(, $vertex: $bound)?>
            embedded_graphics::primitives::StyledDrawable<crate::draw::StrokeStyle<'dashes, C>> for $shape
        {
            type Color = C;
            type Output = ();

            fn draw_styled<D>(
                &self,
                style: &crate::draw::StrokeStyle<'dashes, C>,
                target: &mut D,
            ) -> Result<(), D::Error>
            where
                D: embedded_graphics::draw_target::DrawTarget<Color = C>,
            {
                style.draw_on(self, &mut crate::surface::Generic(target))
            }
        }

        impl<'dashes, C: embedded_graphics::pixelcolor::PixelColor $(, $vertex: $bound)?>
            embedded_graphics::primitives::StyledDimensions<crate::draw::StrokeStyle<'dashes, C>> for $shape
        {
            fn styled_bounding_box(
                &self,
                style: &crate::draw::StrokeStyle<'dashes, C>,
            ) -> embedded_graphics::primitives::Rectangle {
                style.bounds(self)
            }
        }
    };
}
pub(super) use stroked_through_generic;
