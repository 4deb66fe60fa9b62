//! An instrument panel: a gauge with a needle, a 3D object, a picture and text share the rows.

use embedded_graphics::{
    geometry::AnchorPoint,
    image::ImageRaw,
    mono_font::{
        ascii::{FONT_5X8, FONT_6X10, FONT_6X13_BOLD},
        iso_8859_1::{FONT_9X15_BOLD, FONT_10X20},
    },
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Circle, Line, Rectangle},
    text::Alignment,
};
use fixed::types::I16F16;
use zrow::{
    band::{Band, Order},
    draw::{FillRule, Picture, PrimitiveStyle},
    geometry::{Sub8, SubPoint},
    scene::{self, Camera, Model, Pose, Rotation},
};

use crate::{
    PictureCapacities, PrepareError, Prepared, Scene,
    meshes::TORUS_AND_CUBE,
    paint::{hanging, rgb},
    picture_memory::PictureMemory,
    sine::{TURN, around, around_sixteenths, sine},
    standard::{NEAR, TORUS_AND_CUBE_MODEL, angle},
};

const BACKGROUND: Rgb565 = rgb(8, 11, 18);
const CARD: Rgb565 = rgb(24, 32, 48);
const BORDER: Rgb565 = rgb(52, 66, 94);
const BRIGHT: Rgb565 = rgb(240, 245, 255);
const DIM: Rgb565 = rgb(132, 148, 178);
const ACCENT: Rgb565 = rgb(64, 196, 255);
const UNLIT: Rgb565 = rgb(36, 45, 62);
const NEEDLE: Rgb565 = rgb(255, 82, 82);
const HUB: Rgb565 = rgb(70, 84, 112);

const CENTER: Point = Point::new(120, 122);
/// Outer end of the lamps around the dial.
const LAMPS_RADIUS: i32 = 96;
const LAMPS: u32 = 46;
/// The dial begins at this angle and goes three quarters of a turn around.
const FIRST_ANGLE: u32 = TURN * 5 / 8;
const SWEEP: u32 = TURN * 3 / 4;
const TOP_SPEED: u32 = 180;
/// From green to red.
const LAMP_COLORS: [Rgb565; 5] = [
    rgb(0, 200, 120),
    rgb(100, 210, 70),
    rgb(240, 200, 40),
    rgb(255, 140, 30),
    rgb(255, 60, 60),
];

const OBJECT_CARD: Rectangle = Rectangle::new(Point::new(6, 206), Size::new(118, 108));
const WEATHER_CARD: Rectangle = Rectangle::new(Point::new(130, 206), Size::new(104, 54));
const BATTERY_CARD: Rectangle = Rectangle::new(Point::new(130, 266), Size::new(104, 48));
const VIEWPORT: Rectangle = Rectangle::new(Point::new(10, 222), Size::new(110, 90));
const DISTANCE: [I16F16; 3] = [I16F16::ZERO, I16F16::ZERO, I16F16::lit("1660")];
const FOCAL_LENGTH: I16F16 = I16F16::lit("90");

static WEATHER: ImageRaw<Rgb565> = ImageRaw::new(include_bytes!(concat!(env!("OUT_DIR"), "/weather.rgb565")), 48);

type Object = scene::Memory<
    Rgb565,
    { TORUS_AND_CUBE.vertices().len() },
    { TORUS_AND_CUBE.faces().len() },
    { VIEWPORT.size.width as usize },
    { VIEWPORT.size.height as usize },
>;

const WIDTH: usize = 240;
/// Items of the picture: 66 lines, 29 discs, 23 rectangles, 21 texts, the needle and an image.
const ITEMS: usize = 141;
/// Words of its pool in any frame.
const WORDS: usize = 685;
/// The most edges that the needle has in one row.
const SEGMENTS: usize = 4;
/// Chains of its edges in one row.
const CHAINS: usize = 3;

type Memory =
    PictureMemory<Rgb565, ITEMS, WORDS, { Dashboard::AREA.size.height as usize }, { WIDTH + 1 }, SEGMENTS, CHAINS>;
type Panel<'s> = Picture<'s, 'static, Rgb565>;

/// The scene's storage.
#[derive(Debug)]
pub struct Dashboard {
    object: Object,
    models: [Model<'static, Rgb565>; 1],
    memory: Memory,
}

/// A frame of the scene.
#[derive(Debug)]
pub struct Ready<'s> {
    picture: Panel<'s>,
    object: scene::Prepared<'s, 'static, Rgb565>,
}

impl Default for Dashboard {
    fn default() -> Self {
        Self {
            object: Object::new(),
            models: [TORUS_AND_CUBE_MODEL],
            memory: Memory::new(),
        }
    }
}

impl Scene for Dashboard {
    type Color = Rgb565;
    type Prepared<'s> = Ready<'s>;
    const NAME: &'static str = "dashboard";
    const TITLE: &'static str = "dashboard";
    const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(WIDTH as u32, 320));
    const BACKGROUND: Rgb565 = BACKGROUND;
    const FRAMES: u32 = 64;
    const PORTRAIT: u32 = 9;
    const PICTURE: Option<PictureCapacities> = Some(Memory::capacities(0));
    const DEPTH_ROW_BYTES: usize = size_of::<[u16; VIEWPORT.size.width as usize]>();

    fn prepare(&mut self, frame: u32) -> Result<Ready<'_>, PrepareError> {
        let frame = frame % Self::FRAMES;
        let speed = speed(frame);
        let camera = Camera::new(VIEWPORT, NEAR)?.with_focal_length(FOCAL_LENGTH)?;
        let rotation = Rotation::about_x(angle(490 + frame * 8)).then(&Rotation::about_y(angle(470)));
        for model in &mut self.models {
            model.pose = Pose::new(rotation, DISTANCE);
        }
        let mut picture = self.memory.picture(Self::AREA);
        add_header(&mut picture)?;
        add_dial(&mut picture, speed)?;
        add_needle(&mut picture, dial_angle(speed, TOP_SPEED))?;
        add_readout(&mut picture, speed)?;
        add_card(&mut picture, OBJECT_CARD, "ATTITUDE")?;
        add_weather(&mut picture)?;
        add_battery(&mut picture, 79 - frame / 16)?;
        Ok(Ready {
            picture,
            object: self.object.prepare(&camera, &self.models)?,
        })
    }
}

impl Prepared for Ready<'_> {
    type Color = Rgb565;

    fn capacities_used(&self) -> Option<PictureCapacities> {
        self.picture.capacities_used()
    }

    fn draw<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>) {
        Prepared::draw(&mut self.picture, band);
        // Nothing of the picture lies over the object.
        self.object.draw(band);
    }
}

/// Swings between 20 and 160.
fn speed(frame: u32) -> u32 {
    let swing = (70 * sine(frame * TURN / Dashboard::FRAMES)) >> 14;
    (90 + swing) as u32
}

/// The direction of the needle for a value, where the dial ends at `whole`.
fn dial_angle(value: u32, whole: u32) -> u32 {
    FIRST_ANGLE + SWEEP * value / whole
}

fn add_header(picture: &mut Panel<'_>) -> Result<(), PrepareError> {
    picture.add(&hanging(
        "zrow",
        Point::new(8, 4),
        Alignment::Left,
        &FONT_6X13_BOLD,
        ACCENT,
    ))?;
    picture.add(&hanging(
        "10:24",
        Point::new(232, 4),
        Alignment::Right,
        &FONT_6X13_BOLD,
        BRIGHT,
    ))?;
    for bar in 0..4 {
        let height = 3 + 2 * bar;
        let color = if bar < 3 { DIM } else { UNLIT };
        let corner = Point::new(170 + 5 * bar, 14 - height);
        let bar = Rectangle::new(corner, Size::new(3, height as u32));
        picture.add(&bar.into_styled(PrimitiveStyle::with_fill(color)))?;
    }
    let rule = Line::new(Point::new(8, 19), Point::new(231, 19));
    picture.add(&rule.into_styled(PrimitiveStyle::with_stroke(BORDER, 1)))?;
    Ok(())
}

fn add_dial(picture: &mut Panel<'_>, speed: u32) -> Result<(), PrepareError> {
    for lamp in 0..LAMPS {
        let lit = lamp * TOP_SPEED <= speed * (LAMPS - 1);
        let zone = LAMP_COLORS.get((lamp * 5 / LAMPS) as usize).copied();
        let color = zone.filter(|_| lit).unwrap_or(UNLIT);
        let angle = dial_angle(lamp, LAMPS - 1);
        let line = Line::new(around(CENTER, 86, angle), around(CENTER, LAMPS_RADIUS, angle));
        picture.add(&line.into_styled(PrimitiveStyle::with_stroke(color, 4)))?;
    }
    picture.add(&Circle::with_center(CENTER, 161).into_styled(PrimitiveStyle::with_fill(BORDER)))?;
    picture.add(&Circle::with_center(CENTER, 157).into_styled(PrimitiveStyle::with_fill(CARD)))?;
    for (tick, name) in (0..).zip(["0", "20", "40", "60", "80", "100", "120", "140", "160", "180"]) {
        let angle = dial_angle(tick, 9);
        let line = Line::new(around(CENTER, 68, angle), around(CENTER, 75, angle));
        picture.add(&line.into_styled(PrimitiveStyle::with_stroke(BRIGHT, 2)))?;
        let at = around(CENTER, 57, angle) - Point::new(0, 4);
        picture.add(&hanging(name, at, Alignment::Center, &FONT_5X8, DIM))?;
        if tick < 9 {
            let angle = dial_angle(2 * tick + 1, 18);
            let line = Line::new(around(CENTER, 72, angle), around(CENTER, 75, angle));
            picture.add(&line.into_styled(PrimitiveStyle::with_stroke(DIM, 1)))?;
        }
    }
    Ok(())
}

/// Adds the needle as a slim antialiased kite, placed to sixteenths of a pixel, and the hub around its axis.
fn add_needle(picture: &mut Panel<'_>, angle: u32) -> Result<(), PrepareError> {
    let quarter = TURN / 4;
    let corner = |radius, angle| {
        let point = around_sixteenths(CENTER, radius, angle) * 16;
        SubPoint::<Sub8>::from_units(point.x, point.y)
    };
    let needle = [
        corner(70, angle)?,
        corner(6, angle + quarter)?,
        corner(18, angle + 2 * quarter)?,
        corner(6, angle + 3 * quarter)?,
    ];
    picture.add_outline(&[needle.as_slice()], FillRule::NonZero, NEEDLE)?;
    for (diameter, color) in [(21, HUB), (15, CARD), (7, NEEDLE)] {
        picture.add(&Circle::with_center(CENTER, diameter).into_styled(PrimitiveStyle::with_fill(color)))?;
    }
    Ok(())
}

fn add_readout(picture: &mut Panel<'_>, speed: u32) -> Result<(), PrepareError> {
    let digits = Digits::new(speed);
    let at = CENTER + Point::new(0, 26);
    picture.add(&hanging(digits.text(), at, Alignment::Center, &FONT_10X20, BRIGHT))?;
    picture.add(&hanging(
        "km/h",
        at + Point::new(0, 20),
        Alignment::Center,
        &FONT_6X10,
        DIM,
    ))?;
    Ok(())
}

fn add_weather(picture: &mut Panel<'_>) -> Result<(), PrepareError> {
    add_card(picture, WEATHER_CARD, "")?;
    let corner = WEATHER_CARD.top_left;
    picture.add_image(&WEATHER, corner + Point::new(5, 3))?;
    let at = corner + Point::new(98, 12);
    picture.add(&hanging("21\u{b0}C", at, Alignment::Right, &FONT_9X15_BOLD, BRIGHT))?;
    picture.add(&hanging(
        "outside",
        at + Point::new(0, 20),
        Alignment::Right,
        &FONT_6X10,
        DIM,
    ))?;
    Ok(())
}

fn add_battery(picture: &mut Panel<'_>, percent: u32) -> Result<(), PrepareError> {
    add_card(picture, BATTERY_CARD, "BATTERY")?;
    let corner = BATTERY_CARD.top_left + Point::new(8, 18);
    let body = Rectangle::new(corner, Size::new(48, 22));
    let pole = Rectangle::new(corner + Point::new(49, 7), Size::new(3, 8));
    picture.add(&body.into_styled(PrimitiveStyle::with_stroke(DIM, 2)))?;
    picture.add(&pole.into_styled(PrimitiveStyle::with_fill(DIM)))?;
    for cell in 0..5 {
        let color = if percent > 20 * cell { LAMP_COLORS[0] } else { UNLIT };
        let left = corner + Point::new(4 + 8 * cell as i32, 4);
        let cell = Rectangle::new(left, Size::new(7, 14));
        picture.add(&cell.into_styled(PrimitiveStyle::with_fill(color)))?;
    }
    let digits = Digits::new(percent);
    let at = corner + Point::new(80, 4);
    picture.add(&hanging(digits.text(), at, Alignment::Right, &FONT_9X15_BOLD, BRIGHT))?;
    picture.add(&hanging("%", at + Point::new(2, 4), Alignment::Left, &FONT_6X10, DIM))?;
    Ok(())
}

/// A panel with round corners and a name.
fn add_card(picture: &mut Panel<'_>, area: Rectangle, name: &str) -> Result<(), PrepareError> {
    add_rounded(picture, area, 8, BORDER)?;
    add_rounded(picture, area.offset(-1), 7, CARD)?;
    let at = area.top_left + Point::new(8, 6);
    picture.add(&hanging(name, at, Alignment::Left, &FONT_5X8, DIM))?;
    Ok(())
}

fn add_rounded(picture: &mut Panel<'_>, area: Rectangle, radius: u32, color: Rgb565) -> Result<(), PrepareError> {
    let style = PrimitiveStyle::with_fill(color);
    picture.add(&shrunk(area, 0, radius).into_styled(style))?;
    picture.add(&shrunk(area, radius, 0).into_styled(style))?;
    let corner = Size::new_equal(2 * radius);
    for anchor in [
        AnchorPoint::TopLeft,
        AnchorPoint::TopRight,
        AnchorPoint::BottomLeft,
        AnchorPoint::BottomRight,
    ] {
        let square = area.resized(corner, anchor);
        picture.add(&Circle::new(square.top_left, 2 * radius).into_styled(style))?;
    }
    Ok(())
}

fn shrunk(area: Rectangle, x: u32, y: u32) -> Rectangle {
    let by = Size::new(x, y);
    Rectangle::new(area.top_left + by, area.size - by * 2)
}

/// A number up to 999 as text.
struct Digits([u8; 3]);

impl Digits {
    fn new(number: u32) -> Self {
        let digit = |weight: u32| b'0' + (number / weight % 10) as u8;
        Self([digit(100), digit(10), digit(1)])
    }

    /// Without zeros in front.
    fn text(&self) -> &str {
        let digits = core::str::from_utf8(&self.0).unwrap_or_default();
        let trimmed = digits.trim_start_matches('0');
        if trimmed.is_empty() { "0" } else { trimmed }
    }
}
