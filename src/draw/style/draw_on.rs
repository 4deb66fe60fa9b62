//! Drawing on a target: what every shape and every style comes down to.

use embedded_graphics::{
    pixelcolor::PixelColor,
    primitives::{self, Styled},
};

use crate::{draw::PrimitiveStyle, surface::Target};

/// Draws on a [`Target`], the fast entry point.
pub trait DrawOn {
    /// Colour of the target.
    type Color: PixelColor;

    /// Draws what is inside the target's window.
    ///
    /// # Errors
    /// The target's own error.
    fn draw_on<T: Target<Color = Self::Color>>(&self, target: &mut T) -> Result<(), T::Error>;
}

/// A shape that draws itself in a [`PrimitiveStyle`].
pub trait StyledShape {
    /// Draws what is inside the target's window.
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

/// A shape in embedded-graphics' own style is drawn by zrow as well; its `Drawable::draw` is embedded-graphics' own.
impl<S: StyledShape, C: PixelColor> DrawOn for Styled<S, primitives::PrimitiveStyle<C>> {
    type Color = C;

    fn draw_on<T: Target<Color = C>>(&self, target: &mut T) -> Result<(), T::Error> {
        self.primitive.draw_styled_on(&self.style.into(), target)
    }
}
