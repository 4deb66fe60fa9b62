//! Helpers for the tests beside the shapes: drawing a shape into a picture that is compared with an ASCII pattern.
//!
//! A test draws into an embedded-graphics `MockDisplay`, which fails where a pixel is drawn twice or outside of the
//! display. In a pattern, a blank is a pixel that nothing was drawn on, `#` is `BinaryColor::On`, letters are `Rgb565`
//! colours (`R` red, `G` green), and hexadecimal digits are `Gray4` levels.

use embedded_graphics::{
    geometry::{Point, Size},
    mock_display::{ColorMapping, MockDisplay},
    pixelcolor::{BinaryColor, Gray4, GrayColor, PixelColor, Rgb565, RgbColor},
    primitives::{self, PointsIter, PrimitiveStyleBuilder, Rectangle, StrokeAlignment, StyledDrawable},
};

use crate::{
    band::Band,
    coverage::AnyCoverage,
    draw::{AntialiasedPolygon, PrimitiveStyle, StyledShape, antialiased::OutlinedShape},
    geometry::{Sub8, SubPoint},
    surface::Generic,
};

/// A style with a fill and without a stroke.
pub(crate) const FILL: PrimitiveStyle<BinaryColor> = PrimitiveStyle::with_fill(BinaryColor::On);

/// A style with a centred stroke of `width` pixels and without a fill.
pub(crate) const fn stroke(width: u32) -> PrimitiveStyle<BinaryColor> {
    PrimitiveStyle::with_stroke(BinaryColor::On, width)
}

/// A style with a green fill and a red stroke.
pub(crate) fn green_in_red(stroke_width: u32, alignment: StrokeAlignment) -> PrimitiveStyle<Rgb565> {
    PrimitiveStyleBuilder::new()
        .fill_color(Rgb565::GREEN)
        .stroke_color(Rgb565::RED)
        .stroke_width(stroke_width)
        .stroke_alignment(alignment)
        .build()
        .into()
}

/// A style with a dark grey fill (`6` in a pattern) and a white stroke (`F`).
pub(crate) fn grey_in_white(stroke_width: u32, alignment: StrokeAlignment) -> PrimitiveStyle<Gray4> {
    PrimitiveStyleBuilder::new()
        .fill_color(Gray4::new(6))
        .stroke_color(Gray4::WHITE)
        .stroke_width(stroke_width)
        .stroke_alignment(alignment)
        .build()
        .into()
}

/// Draws a shape in a style with [`StyledShape`], and again with `StyledDrawable`; both must give the same picture,
/// which is returned.
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

/// Draws a shape in a style with zrow as [`drawn`] does, and with embedded-graphics; both must give the same picture,
/// which is returned.
pub(crate) fn drawn_by_both<S, C>(shape: &S, style: PrimitiveStyle<C>) -> MockDisplay<C>
where
    S: StyledShape
        + StyledDrawable<PrimitiveStyle<C>, Color = C, Output = ()>
        + StyledDrawable<primitives::PrimitiveStyle<C>, Color = C, Output = ()>,
    C: PixelColor + ColorMapping,
{
    let display = drawn(shape, style);
    let mut theirs = MockDisplay::new();
    // embedded-graphics draws beyond the display as well, and draws some pixels of wide strokes twice.
    theirs.set_allow_out_of_bounds_drawing(true);
    theirs.set_allow_overdraw(true);
    let Ok(()) = shape.draw_styled(&primitives::PrimitiveStyle::from(style), &mut theirs);
    display.assert_eq(&theirs);
    display
}

/// The sub-pixel point at a column and a row, in pixels, rounded towards 0 to 1/256 pixel.
pub(crate) fn at(x: f32, y: f32) -> SubPoint<Sub8> {
    SubPoint::from_units((x * 256.0) as i32, (y * 256.0) as i32).unwrap()
}

/// Blends the layers of a shape in a style on a black band, as [`blended`] does; at most 512 edges a layer, 64 in a row.
/// Where it says so, a layer has to be drawn exactly by signed areas.
pub(crate) fn antialiased(shape: &impl OutlinedShape, style: PrimitiveStyle<Gray4>) -> MockDisplay<Gray4> {
    blended(|band| {
        let layers = shape.layers(&style, &mut |layer| {
            let polygon = AntialiasedPolygon::<512, 64>::prepare(layer.outline, layer.fill_rule)?;
            let mut row = [0; 17];
            let method = if layer.outline.is_simple() {
                AnyCoverage::SignedArea
            } else {
                AnyCoverage::InsideArea
            };
            let Ok(()) = polygon.draw(&method, layer.color, band, &mut row) else {
                panic!("the row is too short");
            };
            Ok(())
        });
        layers.unwrap();
    })
}

/// Draws on a black band of 16 x 16 pixels, in which `draw` blends white. In the picture a digit is a pixel's coverage
/// in fifteenths, `F` is a pixel that is covered completely, and a blank is one that stayed black.
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
