//! Pictures of what shapes draw, for the tests beside the shapes.
//!
//! A test draws into an embedded-graphics `MockDisplay`, which fails where a pixel is drawn twice or outside, and compares it
//! with a pattern that a reader can see: a blank is a pixel that nothing was drawn on, `#` is `BinaryColor::On`, letters are
//! `Rgb565` colours (`R` red, `G` green), hexadecimal digits are `Gray4` levels.

use embedded_graphics::{
    geometry::{Point, Size},
    mock_display::{ColorMapping, MockDisplay},
    pixelcolor::{BinaryColor, Gray4, GrayColor, PixelColor, Rgb565, RgbColor},
    primitives::{self, PointsIter, Rectangle, StrokeAlignment, StyledDrawable},
};

use crate::{
    band::Band,
    draw::{PrimitiveStyle, PrimitiveStyleBuilder, StyledShape},
    geometry::{Sub8, SubPoint},
    surface::Generic,
};

/// A fill without a stroke.
pub(crate) const FILL: PrimitiveStyle<BinaryColor> = PrimitiveStyle::with_fill(BinaryColor::On);

/// A centred stroke without a fill.
pub(crate) const fn stroke(width: u32) -> PrimitiveStyle<BinaryColor> {
    PrimitiveStyle::with_stroke(BinaryColor::On, width)
}

/// A green fill with a red stroke.
pub(crate) fn green_in_red(stroke_width: u32, alignment: StrokeAlignment) -> PrimitiveStyle<Rgb565> {
    PrimitiveStyleBuilder::new()
        .fill_color(Rgb565::GREEN)
        .stroke_color(Rgb565::RED)
        .stroke_width(stroke_width)
        .stroke_alignment(alignment)
        .build()
}

/// Draws a shape in a style: on a target, and once more by `Drawable::draw`, which must give the same picture.
pub(crate) fn drawn<S, C>(shape: &S, style: PrimitiveStyle<C>) -> MockDisplay<C>
where
    S: StyledShape + StyledDrawable<PrimitiveStyle<C>, Color = C, Output = ()>,
    C: PixelColor + ColorMapping,
{
    let mut on_target = MockDisplay::new();
    let Ok(()) = shape.draw_styled_on(&style, &mut Generic(&mut on_target));
    let mut on_display = MockDisplay::new();
    let Ok(()) = shape.draw_styled(&style, &mut on_display);
    on_display.assert_eq(&on_target);
    on_target
}

/// Draws a shape in a style as [`drawn`] does, and with embedded-graphics, which must give the same picture.
pub(crate) fn drawn_by_both<S, C>(shape: &S, style: PrimitiveStyle<C>) -> MockDisplay<C>
where
    S: StyledShape
        + StyledDrawable<PrimitiveStyle<C>, Color = C, Output = ()>
        + StyledDrawable<primitives::PrimitiveStyle<C>, Color = C, Output = ()>,
    C: PixelColor + ColorMapping,
{
    let display = drawn(shape, style);
    let mut theirs = MockDisplay::new();
    // embedded-graphics leaves what is outside to the display, and paints some pixels of wide strokes again.
    theirs.set_allow_out_of_bounds_drawing(true);
    theirs.set_allow_overdraw(true);
    let Ok(()) = shape.draw_styled(&primitives::PrimitiveStyle::from(style), &mut theirs);
    display.assert_eq(&theirs);
    display
}

/// The point at a column and a row, in pixels.
pub(crate) fn at(x: f32, y: f32) -> SubPoint<Sub8> {
    SubPoint::from_units((x * 256.0) as i32, (y * 256.0) as i32).unwrap()
}

/// Draws white over black on 16 x 16 pixels: a digit is a pixel's coverage in fifteenths, `F` a pixel that is covered
/// wholly, a blank one that stayed black.
pub(crate) fn blended(draw: impl FnOnce(&mut Band<'_, Gray4>)) -> MockDisplay<Gray4> {
    let mut words = [0; 16 * 16];
    let area = Rectangle::new(Point::zero(), Size::new(16, 16));
    let mut band = Band::new(area, &mut words).unwrap();
    draw(&mut band);
    let mut display = MockDisplay::new();
    for (point, level) in area.points().zip(band.colors()) {
        display.set_pixel(point, (level != Gray4::BLACK).then_some(level));
    }
    display
}
