//! One picture drawn whole, and the same picture through windows.

use core::convert::Infallible;

use embedded_graphics::{
    mono_font::{
        MonoTextStyle,
        ascii::{FONT_6X10, FONT_9X15_BOLD},
    },
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Circle, Ellipse, Line, PrimitiveStyleBuilder, Rectangle, Styled, Triangle},
    text::{Alignment, Text},
};
use zrow::{
    band::{Band, Generic, Order, Target},
    draw::{DrawOn, PrimitiveStyle, StrokeAlignment},
};

use crate::{
    PrepareError, Prepared, Scene,
    paint::{label, rgb, shape},
};

const TITLE_COLOR: Rgb565 = rgb(255, 255, 255);
const FRAME: Rgb565 = rgb(255, 213, 79);
const MARK: Rgb565 = rgb(96, 100, 90);

/// Where the whole picture lies.
const WHOLE: Rectangle = Rectangle::new(Point::new(8, 24), Size::new(148, 208));
/// From the whole picture to the one seen through windows.
const ASIDE: Point = Point::new(156, 0);
/// The windows, as they lie on the whole picture.
const WINDOWS: [Rectangle; 5] = [
    Rectangle::new(Point::new(16, 34), Size::new(56, 44)),
    Rectangle::new(Point::new(86, 40), Size::new(60, 66)),
    Rectangle::new(Point::new(18, 92), Size::new(50, 80)),
    Rectangle::new(Point::new(82, 124), Size::new(66, 34)),
    Rectangle::new(Point::new(64, 188), Size::new(82, 36)),
];

/// The scene; nothing outlives a row.
#[derive(Debug, Default)]
pub struct Clipping;

impl Scene for Clipping {
    type Color = Rgb565;
    type Prepared<'s> = &'s mut Self;
    const NAME: &'static str = "clipping";
    const TITLE: &'static str = "the whole picture, and through windows";
    const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(320, 240));
    const BACKGROUND: Rgb565 = rgb(16, 20, 28);

    fn prepare(&mut self, _frame: u32) -> Result<&mut Self, PrepareError> {
        Ok(self)
    }
}

impl Prepared for Clipping {
    type Color = Rgb565;

    fn draw<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>) {
        label(
            band,
            "whole",
            Point::new(82, 8),
            Alignment::Center,
            &FONT_6X10,
            TITLE_COLOR,
        );
        label(
            band,
            "through windows",
            Point::new(238, 8),
            Alignment::Center,
            &FONT_6X10,
            TITLE_COLOR,
        );
        draw_through(band, WHOLE, Point::zero());
        shape(band, &frame_around(WHOLE, FRAME));
        for window in WINDOWS {
            shape(band, &frame_around(window, MARK));
            let window = window.translate(ASIDE);
            draw_through(band, window, ASIDE);
            shape(band, &frame_around(window, FRAME));
        }
    }
}

fn frame_around(window: Rectangle, color: Rgb565) -> Styled<Rectangle, PrimitiveStyle<Rgb565>> {
    window.offset(1).into_styled(
        PrimitiveStyleBuilder::new()
            .stroke_color(color)
            .stroke_width(1)
            .stroke_alignment(StrokeAlignment::Inside)
            .build()
            .into(),
    )
}

/// Draws the part of the picture that a window shows.
fn draw_through<O: Order>(band: &mut Band<'_, Rgb565, O>, window: Rectangle, offset: Point) {
    draw_picture(&mut Generic(&mut band.clipped(&window)), offset);
}

/// The picture. It knows nothing of windows: lines, ellipse and beam run out of all of them.
fn draw_picture<T: Target<Color = Rgb565, Error = Infallible>>(target: &mut T, offset: Point) {
    let at = |x: i32, y: i32| Point::new(x, y) + offset;
    for (index, color) in RAINBOW.into_iter().enumerate() {
        let step = 26 * index as i32;
        let line = Line::new(at(-40, 20 + step), at(220, 100 + step));
        shape(target, &line.into_styled(PrimitiveStyle::with_stroke(color, 1)));
    }
    let disc: PrimitiveStyle<_> = PrimitiveStyleBuilder::new()
        .fill_color(rgb(38, 70, 120))
        .stroke_color(rgb(90, 200, 250))
        .stroke_width(4)
        .build()
        .into();
    shape(target, &Circle::with_center(at(58, 86), 84).into_styled(disc));
    let ring = PrimitiveStyle::with_stroke(rgb(129, 230, 150), 6);
    shape(
        target,
        &Ellipse::with_center(at(106, 140), Size::new(120, 70)).into_styled(ring),
    );
    let triangle = Triangle::new(at(20, 227), at(84, 112), at(138, 222));
    shape(
        target,
        &triangle.into_styled(PrimitiveStyle::with_fill(rgb(255, 112, 67))),
    );
    let beam = Rectangle::new(at(-60, 176), Size::new(400, 8));
    shape(target, &beam.into_styled(PrimitiveStyle::with_fill(rgb(186, 104, 200))));
    let style = MonoTextStyle::new(&FONT_9X15_BOLD, TITLE_COLOR);
    let Ok(()) = Text::new("embedded\ngraphics", at(46, 200), style).draw_on(target);
}

const RAINBOW: [Rgb565; 6] = [
    rgb(244, 67, 54),
    rgb(255, 152, 0),
    rgb(255, 235, 59),
    rgb(76, 175, 80),
    rgb(66, 165, 245),
    rgb(171, 71, 188),
];
