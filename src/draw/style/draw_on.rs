//! The traits for drawing on a [`Target`]: [`DrawOn`] for a shape with its style, [`StyledShape`] for shapes that
//! implement drawing in a [`PrimitiveStyle`], [`BlendOn`] for what is blended over what is there.

use embedded_graphics::{
    pixelcolor::PixelColor,
    primitives::{self, Styled},
};

use crate::{draw::PrimitiveStyle, shade::BlendTarget, surface::Target};

/// Draws on a [`Target`] directly, which is faster than `Drawable::draw` on a `DrawTarget`.
pub trait DrawOn {
    /// The colour type of the target.
    type Color: PixelColor;

    /// Draws the part that lies inside the target's window.
    ///
    /// # Errors
    /// The target's own error.
    fn draw_on<T: Target<Color = Self::Color>>(&self, target: &mut T) -> Result<(), T::Error>;
}

/// Draws on a [`BlendTarget`], such as a band: what is drawn is mixed with what is there.
pub trait BlendOn {
    /// The colour type of the target.
    type Color: PixelColor;

    /// Blends the part that lies inside the target's window over what is there.
    ///
    /// # Errors
    /// The target's own error.
    fn draw_on<B: BlendTarget<Color = Self::Color>>(&self, target: &mut B) -> Result<(), B::Error>;
}

// Not re-exported: users draw a shape with its style.
/// A shape that can be drawn in a [`PrimitiveStyle`].
pub trait StyledShape {
    /// Draws the part of the styled shape that lies inside the target's window.
    ///
    /// # Errors
    /// The target's own error.
    fn draw_styled_on<T: Target>(&self, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error>;
}

impl<S: StyledShape> StyledShape for &S {
    fn draw_styled_on<T: Target>(&self, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error> {
        S::draw_styled_on(self, style, target)
    }
}

impl<S: StyledShape, C: PixelColor> DrawOn for Styled<S, PrimitiveStyle<C>> {
    type Color = C;

    fn draw_on<T: Target<Color = C>>(&self, target: &mut T) -> Result<(), T::Error> {
        self.primitive.draw_styled_on(&self.style, target)
    }
}

/// Draws a shape in embedded-graphics' own style with zrow. `Drawable::draw` of such a shape is still
/// embedded-graphics'.
impl<S: StyledShape, C: PixelColor> DrawOn for Styled<S, primitives::PrimitiveStyle<C>> {
    type Color = C;

    fn draw_on<T: Target<Color = C>>(&self, target: &mut T) -> Result<(), T::Error> {
        self.primitive.draw_styled_on(&self.style.into(), target)
    }
}
