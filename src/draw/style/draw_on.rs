//! The traits for drawing on a [`Target`]: [`DrawOn`] for a shape with its style, [`StyledShape`] for shapes that
//! implement drawing in a [`PrimitiveStyle`], [`BlendOn`] for what is blended over what is there.

use embedded_graphics::{
    pixelcolor::PixelColor,
    primitives::{self, Styled},
};

use crate::{draw::PrimitiveStyle, shade::BlendTarget, surface::Target};

/// Draws on a [`Target`] directly, which is faster than `Drawable::draw` on a `DrawTarget`.
///
/// A widget draws the shapes that it consists of:
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*, primitives::Rectangle};
/// use zrow::{
///     band::{Generic, Target},
///     draw::{DrawOn, PrimitiveStyle},
/// };
///
/// /// A battery and how full it is, from 0 to 6.
/// struct Battery {
///     top_left: Point,
///     level: u32,
/// }
///
/// impl DrawOn for Battery {
///     type Color = BinaryColor;
///
///     fn draw_on<T: Target<Color = BinaryColor>>(&self, target: &mut T) -> Result<(), T::Error> {
///         let fill = PrimitiveStyle::with_fill(BinaryColor::On);
///         let part = |x, y, width, height| Rectangle::new(self.top_left + Point::new(x, y), Size::new(width, height));
///         part(0, 0, 8, 4).into_styled(PrimitiveStyle::with_stroke(BinaryColor::On, 1)).draw_on(target)?;
///         part(8, 1, 1, 2).into_styled(fill).draw_on(target)?;
///         part(1, 1, self.level, 2).into_styled(fill).draw_on(target)
///     }
/// }
///
/// let mut display = MockDisplay::new();
/// Battery { top_left: Point::zero(), level: 4 }.draw_on(&mut Generic(&mut display))?;
/// display.assert_pattern(&["######## ", "#####  ##", "#####  ##", "######## "]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be drawn on a target as it is",
    note = "a shape in an antialiased style is drawn on `&mut band.antialiased::<EDGES, ACTIVE>(&mut cells)`, or by a `Picture`",
    note = "a `Polygon` or a `Path` is filled in its prepared form, `polygon.prepare::<EDGES, ACTIVE>()?`, or by a `Picture`"
)]
pub trait DrawOn {
    /// The colour type of the target.
    type Color: PixelColor;

    /// Draws the part that lies inside the target's window.
    ///
    /// # Errors
    /// The target's own error.
    fn draw_on<T: Target<Color = Self::Color>>(&self, target: &mut T) -> Result<(), T::Error>;
}

/// Draws on a [`BlendTarget`], such as a band: what is drawn is mixed with what is there. Texts in a
/// [`MaskTextStyle`](crate::draw::MaskTextStyle) do.
///
/// ```
/// # use embedded_graphics::mono_font::DecorationDimensions;
/// # use zrow::draw::{MaskFont, MaskGlyph};
/// # static FONT: MaskFont = MaskFont {
/// #     ranges: &[('-', 1, 0)],
/// #     glyphs: &[MaskGlyph { offset: 0, left: 0, top: 0, width: 2, height: 1, advance: 2 * 16 }],
/// #     coverage: &[0xf5], kerning: &[], height: 1, baseline: 0, line_height: 1,
/// #     underline: DecorationDimensions::new(1, 1), strikethrough: DecorationDimensions::new(0, 1), replacement: None,
/// # };
/// use embedded_graphics::{pixelcolor::Gray8, prelude::*, primitives::Rectangle, text::Text};
/// use zrow::{band::Band, draw::{BlendOn, MaskTextStyle}};
///
/// let mut words = [60, 60, 0, 0];
/// let mut band = Band::<Gray8>::new(Rectangle::new(Point::zero(), Size::new(4, 1)), &mut words)?;
/// // The dash of this font covers its second pixel to a third.
/// let Ok(()) = Text::new("--", Point::zero(), MaskTextStyle::new(&FONT, Gray8::WHITE)).draw_on(&mut band);
/// assert_eq!(words, [255, 125, 255, 85]);
/// # Ok::<(), zrow::geometry::TooSmall>(())
/// ```
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
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be drawn in a `PrimitiveStyle` as it is",
    note = "a `Polygon` is drawn in its prepared form, `polygon.prepare::<EDGES, ACTIVE>()?`, or by a `Picture`",
    note = "a shape of sub-pixels, such as a `SubArc`, takes an antialiased style, `PrimitiveStyle::with_fill(color).antialiased()`"
)]
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
