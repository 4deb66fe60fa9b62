//! Flood fill and boundary fill on a small picture, magnified; shapes in patterns and gradients.

use embedded_graphics::{
    mono_font::{MonoTextStyle, ascii::FONT_6X10, ascii::FONT_10X20},
    pixelcolor::{Rgb565, Rgb888, raw::RawU16},
    prelude::*,
    primitives::{Circle, Ellipse, Line, Rectangle, Triangle},
    text::{Alignment, Text},
};
use zrow::{
    band::{Band, Order, Target},
    draw::{DrawOn, PrimitiveStyle, SeedFill},
    shade::{LinearGradient, Paint, Pattern, RadialGradient, Ramp},
};

use crate::{
    PrepareError, Prepared, Scene,
    paint::{label, rgb, shape},
};

const TITLE_COLOR: Rgb565 = rgb(255, 255, 255);
const PAPER: Rgb565 = rgb(34, 40, 52);
const WALL: Rgb565 = rgb(255, 213, 79);
const WATER: Rgb565 = rgb(64, 156, 255);
const OLD: Rgb565 = rgb(150, 70, 60);
const SEED: Rgb565 = rgb(255, 255, 255);

/// Columns and rows of a small picture.
const SIDE: i32 = 32;
/// Its pixels on the panel.
const SCALE: u32 = 3;
const PIXELS: usize = (SIDE * SIDE) as usize;
const SMALL: Rectangle = Rectangle::new(Point::zero(), Size::new(SIDE as u32, SIDE as u32));
const START: Point = Point::new(15, 14);

/// The fills that are shown: where, and what they are called.
const TOPS: [(Point, &str); 3] = [
    (Point::new(6, 18), "4-connected"),
    (Point::new(112, 18), "8-connected"),
    (Point::new(218, 18), "to a boundary"),
];

/// The scene: three small pictures that outlive a row, because a fill has to read back what was drawn.
#[derive(Debug)]
pub struct Paints {
    pictures: [[u16; PIXELS]; 3],
}

impl Default for Paints {
    fn default() -> Self {
        Self {
            pictures: [[0; PIXELS]; 3],
        }
    }
}

impl Scene for Paints {
    type Color = Rgb565;
    type Prepared<'s> = &'s mut Self;
    const NAME: &'static str = "paints";
    const TITLE: &'static str = "flood fill, patterns and gradients";
    const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(320, 240));
    const BACKGROUND: Rgb565 = rgb(16, 20, 28);

    fn prepare(&mut self, _frame: u32) -> Result<&mut Self, PrepareError> {
        let fills = [
            |band: &Band<'_, Rgb565>| SeedFill::<_, 64>::flood(band, START, WATER),
            |band: &Band<'_, Rgb565>| SeedFill::<_, 64>::flood(band, START, WATER).eight_connected(true),
            |_: &Band<'_, Rgb565>| SeedFill::<_, 64>::boundary(START, WALL, WATER),
        ];
        for (words, begin) in self.pictures.iter_mut().zip(fills) {
            // The picture has as many words as its area has pixels.
            let Ok(mut band) = Band::new(SMALL, words) else {
                continue;
            };
            draw_walls(&mut band);
            let mut fill = begin(&band);
            if let Err(zrow::geometry::DrawError::TooSmall(error)) = fill.run(&mut band) {
                return Err(error.into());
            }
            let Ok(()) = Pixel(START, SEED).draw(&mut band);
        }
        Ok(self)
    }
}

/// Two rooms, joined at a corner only, with a spot of another colour.
fn draw_walls(band: &mut Band<'_, Rgb565>) {
    band.fill(PAPER);
    let wall = PrimitiveStyle::with_stroke(WALL, 1);
    shape(
        band,
        &Ellipse::new(Point::new(1, 1), Size::new(30, 30)).into_styled(wall),
    );
    shape(band, &Line::new(Point::new(3, 22), Point::new(22, 3)).into_styled(wall));
    shape(
        band,
        &Line::new(Point::new(10, 27), Point::new(28, 27)).into_styled(wall),
    );
    shape(
        band,
        &Circle::new(Point::new(17, 14), 9).into_styled(PrimitiveStyle::with_fill(OLD)),
    );
    shape(
        band,
        &Rectangle::new(Point::new(7, 18), Size::new(4, 5)).into_styled(wall),
    );
}

impl Prepared for Paints {
    type Color = Rgb565;

    fn draw<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>) {
        for (picture, (position, name)) in self.pictures.iter().zip(TOPS) {
            draw_magnified(band, picture, position);
            let middle = position + Point::new(SIDE * SCALE as i32 / 2, -12);
            label(band, name, middle, Alignment::Center, &FONT_6X10, TITLE_COLOR);
        }
        draw_paints(band);
    }
}

fn draw_magnified<O: Order>(band: &mut Band<'_, Rgb565, O>, picture: &[u16; PIXELS], position: Point) {
    for (pixel, &word) in SMALL.points().zip(picture) {
        let square = Rectangle::new(position + pixel * SCALE as i32, Size::new_equal(SCALE));
        let style = PrimitiveStyle::with_fill(Rgb565::from(RawU16::new(word)));
        let _ = band.draw(&square.into_styled(style));
    }
}

fn draw_paints<O: Order>(band: &mut Band<'_, Rgb565, O>) {
    let fill = PrimitiveStyle::with_fill(Rgb565::WHITE);
    let sunset = [
        (0, Rgb888::new(40, 20, 90)),
        (120, Rgb888::new(230, 60, 80)),
        (255, Rgb888::new(255, 230, 120)),
    ];
    let Ok(sunset) = Ramp::new(sunset) else { return };
    if let Ok(linear) = LinearGradient::new(Point::new(10, 132), Point::new(90, 196), sunset) {
        shape(
            &mut band.painted(&linear),
            &Rectangle::new(Point::new(8, 132), Size::new(84, 66)).into_styled(fill),
        );
        let outline = PrimitiveStyle::with_stroke(Rgb565::WHITE, 9);
        shape(
            &mut band.painted(&linear),
            &Line::new(Point::new(20, 212), Point::new(84, 206)).into_styled(outline),
        );
    }
    let ball = Ramp::between(Rgb888::new(255, 255, 255), Rgb888::new(10, 30, 70));
    if let Ok(radial) = RadialGradient::new(Point::new(126, 152), 52, ball) {
        shape(
            &mut band.painted(&radial),
            &Circle::new(Point::new(106, 130), 70).into_styled(fill),
        );
    }
    let checks = [WALL, OLD, OLD, WALL].map(Rgb565::from);
    if let Ok(checks) = Pattern::new(2, &checks) {
        paint_triangle(band, Point::new(188, 130), checks);
    }
    const HATCH: [Rgb565; 16] = {
        let mut hatch = [PAPER; 16];
        let mut diagonal = 0;
        while diagonal < 4 {
            hatch[diagonal * 5] = WATER;
            diagonal += 1;
        }
        hatch
    };
    if let Ok(hatch) = Pattern::new(4, &HATCH) {
        paint_triangle(band, Point::new(252, 130), hatch);
    }
    let sky = Ramp::between(Rgb888::new(80, 255, 160), Rgb888::new(255, 80, 220));
    if let Ok(linear) = LinearGradient::new(Point::new(190, 0), Point::new(310, 0), sky) {
        let text = Text::new(
            "any drawable",
            Point::new(190, 224),
            MonoTextStyle::new(&FONT_10X20, Rgb565::WHITE),
        );
        let Ok(()) = text.draw_on(&mut band.painted(&linear));
    }
    for (name, middle) in [("linear", 50), ("radial", 140), ("patterns", 248)] {
        label(
            band,
            name,
            Point::new(middle, 118),
            Alignment::Center,
            &FONT_6X10,
            TITLE_COLOR,
        );
    }
}

fn paint_triangle<T: Target<Color = Rgb565>>(target: &mut T, position: Point, paint: impl Paint<Color = Rgb565>) {
    let triangle = Triangle::new(
        position + Point::new(28, 2),
        position + Point::new(0, 70),
        position + Point::new(56, 56),
    );
    let _ = triangle
        .into_styled(PrimitiveStyle::with_fill(Rgb565::WHITE))
        .draw_on(&mut target.painted(paint));
}
