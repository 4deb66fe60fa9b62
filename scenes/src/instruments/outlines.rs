//! The shapes of the instrument panel in painter's order: its antialiased outlines, its texts and its line.

use embedded_graphics::{
    mono_font::{
        MonoTextStyle,
        ascii::{FONT_6X10, FONT_6X13_BOLD},
        iso_8859_1::FONT_10X20,
    },
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Line, Rectangle, Styled},
    text::{Alignment, Text},
};
use fixed::types::{U0F16, U24F8};
use zrow::{
    draw::{FillRule, Path, PathCommand, PrimitiveStyle, SubArc, SubEllipse, SubLine, SubOutline},
    geometry::{Sub8, SubPoint},
};

use crate::{
    PrepareError,
    paint::{hanging, rgb},
    sine::{TURN, around_sub8 as around, sine},
};

pub(super) const BACKGROUND: Rgb565 = rgb(8, 11, 18);
const BRIGHT: Rgb565 = rgb(240, 245, 255);
const DIM: Rgb565 = rgb(132, 148, 178);
const UNLIT: Rgb565 = rgb(36, 45, 62);
pub(super) const ACCENT: Rgb565 = rgb(64, 196, 255);
pub(super) const NEEDLE: Rgb565 = rgb(255, 82, 82);
const HUB: Rgb565 = rgb(70, 84, 112);
const GREEN: Rgb565 = rgb(0, 200, 120);
const YELLOW: Rgb565 = rgb(240, 200, 40);

pub(super) const WIDTH: usize = 240;
pub(super) const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(WIDTH as u32, 320));
/// Frames of the animation, and the one that shows the panel best.
pub(super) const FRAMES: u32 = 64;
pub(super) const PORTRAIT: u32 = 9;
/// The digits of the speed.
pub(super) fn digits(frame: u32) -> [u8; 3] {
    let speed = speed(frame);
    [speed / 100, speed / 10 % 10, speed % 10].map(|digit| b'0' + digit as u8)
}

/// All texts of the panel.
pub(super) fn texts(digits: &[u8; 3]) -> [Text<'_, MonoTextStyle<'static, Rgb565>>; 6] {
    let value = core::str::from_utf8(digits).unwrap_or_default();
    let name = |name, x| hanging(name, Point::new(x, 199), Alignment::Center, &FONT_6X10, BACKGROUND);
    [
        hanging(value, Point::new(120, 140), Alignment::Center, &FONT_10X20, BRIGHT),
        hanging("km/h", Point::new(120, 160), Alignment::Center, &FONT_6X10, DIM),
        hanging("zrow", Point::new(8, 4), Alignment::Left, &FONT_6X13_BOLD, ACCENT),
        name("ECO", 46),
        name("CITY", 120),
        name("SPORT", 194),
    ]
}

/// The line below the title.
pub(super) fn rule() -> Styled<Line, PrimitiveStyle<Rgb565>> {
    Line::new(Point::new(8, 19), Point::new(231, 19)).into_styled(PrimitiveStyle::with_stroke(UNLIT, 1))
}

/// Swings between 20 and 160.
fn speed(frame: u32) -> u32 {
    (90 + ((70 * sine(frame * TURN / FRAMES)) >> 14)) as u32
}

/// A length in 1/256 pixel.
fn length(units: u32) -> U24F8 {
    U24F8::from_bits(units)
}

/// The part of the panel that an outline belongs to.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(super) enum Part {
    /// The arc that shows the speed.
    LitArc,
    Needle,
    /// Any other outline with many edges.
    Curve,
    Other,
}

/// Takes an outline, its colour, and what it is a part of.
type Fill<'f> = dyn FnMut(&dyn SubOutline, Rgb565, Part) -> Result<(), PrepareError> + 'f;

/// Hands over all outlines of a frame, in the order in which they are drawn.
pub(super) fn draw_outlines(frame: u32, fill: &mut Fill<'_>) -> Result<(), PrepareError> {
    let mut outlines = Outlines { fill };
    outlines.gauge(frame)?;
    outlines.buttons(frame)?;
    outlines.plot(frame)?;
    outlines.turning_shapes(frame)
}

/// The centre of the gauge, in pixels.
const CENTER: (i32, i32) = (120, 108);
/// The angle at which the gauge's arc begins, in 1/65,536 turn from the upper end on, clockwise.
const FIRST: u32 = 0x1_0000 * 5 / 8;
/// The angle that the gauge's arc spans, in 1/65,536 turn: three quarters.
const SWEEP: u32 = 0x1_0000 * 3 / 4;

/// The angle of the gauge's lit arc, which shows the speed, in 1/65,536 turn.
fn reach(frame: u32) -> u32 {
    SWEEP * speed(frame) / 180
}

fn center() -> Result<SubPoint<Sub8>, PrepareError> {
    SubPoint::from_units(CENTER.0 * 256, CENTER.1 * 256)
}

/// The gauge's arc over an angle from its beginning.
fn gauge_arc(sweep: u32) -> Result<SubArc, PrepareError> {
    let radii = [length(70 * 256 + 64), length(80 * 256)];
    // Arcs count from the x axis.
    let start = U0F16::from_bits((FIRST - 0x4000) as u16);
    SubArc::new(center()?, radii, start, U0F16::from_bits(sweep as u16))
}

/// The arc that shows the speed.
pub(super) fn lit_arc(frame: u32) -> Result<SubArc, PrepareError> {
    gauge_arc(reach(frame))
}

/// The corners of the needle.
pub(super) fn needle(frame: u32) -> Result<[SubPoint<Sub8>; 4], PrepareError> {
    let angle = FIRST + reach(frame);
    Ok([
        around(CENTER, 64 * 256, angle)?,
        around(CENTER, 4 * 256, angle + 0x4000)?,
        around(CENTER, 14 * 256, angle + 0x8000)?,
        around(CENTER, 4 * 256, angle + 0xc000)?,
    ])
}

/// Hands each outline of the panel with its colour to a closure, which draws it or adds it to a picture.
///
/// No group is inlined, so that its corners are on the stack only while it is handed over.
struct Outlines<'s, 'f> {
    fill: &'s mut Fill<'f>,
}

impl Outlines<'_, '_> {
    fn curve(&mut self, outline: &dyn SubOutline, color: Rgb565) -> Result<(), PrepareError> {
        (self.fill)(outline, color, Part::Curve)
    }

    fn other(&mut self, outline: &dyn SubOutline, color: Rgb565) -> Result<(), PrepareError> {
        (self.fill)(outline, color, Part::Other)
    }

    /// Two arcs, ticks, and a needle on its hub.
    #[inline(never)]
    fn gauge(&mut self, frame: u32) -> Result<(), PrepareError> {
        self.curve(&gauge_arc(SWEEP)?, UNLIT)?;
        (self.fill)(&lit_arc(frame)?, ACCENT, Part::LitArc)?;
        for tick in 0..10 {
            let angle = FIRST + SWEEP * tick / 9;
            let (from, to) = (around(CENTER, 60 * 256, angle)?, around(CENTER, 66 * 256, angle)?);
            self.other(&SubLine::new(from, to, length(384))?, DIM)?;
        }
        (self.fill)(&[needle(frame)?.as_slice()], NEEDLE, Part::Needle)?;
        let center = center()?;
        self.other(&SubEllipse::circle(center, length(8 * 256 + 128))?, HUB)?;
        self.other(&SubEllipse::circle(center, length(3 * 256))?, NEEDLE)
    }

    /// Three buttons with round corners, one of them pressed.
    #[inline(never)]
    fn buttons(&mut self, frame: u32) -> Result<(), PrepareError> {
        let pressed = frame * 3 / FRAMES;
        for (index, color) in (0..).zip([GREEN, YELLOW, NEEDLE]) {
            let left = (14 + 74 * index as i32) * 256;
            let color = if index == pressed { color } else { DIM };
            let commands = rounded_box(left, 192 * 256 - 96, left + 64 * 256 + 77, 216 * 256 + 40, 9 * 256)?;
            self.other(&Path::new(&commands, FillRule::NonZero)?, color)?;
        }
        Ok(())
    }

    /// A curve of measured values, a ribbon between what is above it and below it.
    #[inline(never)]
    fn plot(&mut self, frame: u32) -> Result<(), PrepareError> {
        const POINTS: usize = 30;
        let value = |index: usize| {
            let angle = index as u32 * 23 + frame * TURN / FRAMES;
            (sine(angle) * 18 + sine(angle * 3) * 5) >> 6
        };
        let mut ribbon = [SubPoint::<Sub8>::default(); 2 * POINTS];
        for (number, corner) in ribbon.iter_mut().enumerate() {
            let (index, below) = if number < POINTS {
                (number, -192)
            } else {
                (2 * POINTS - 1 - number, 240)
            };
            *corner = SubPoint::from_units((12 + index as i32 * 4) * 256, 268 * 256 + value(index) + below)?;
        }
        self.other(&[ribbon.as_slice()], GREEN)
    }

    /// A star and a hexagon that turn.
    #[inline(never)]
    fn turning_shapes(&mut self, frame: u32) -> Result<(), PrepareError> {
        let turn = frame * 0x1_0000 / FRAMES / 7;
        let mut star = [SubPoint::<Sub8>::default(); 7];
        for (index, corner) in (0u32..).zip(&mut star) {
            *corner = around((205, 244), 26 * 256, turn + index * 3 * 0x1_0000 / 7)?;
        }
        self.other(&[star.as_slice()], YELLOW)?;
        let mut hexagon = [SubPoint::<Sub8>::default(); 6];
        for (index, corner) in (0u32..).zip(&mut hexagon) {
            *corner = around((165, 292), 17 * 256, (index * 0x1_0000 / 6).wrapping_sub(turn))?;
        }
        self.other(&[hexagon.as_slice()], ACCENT)
    }
}

/// A box whose corners are quarter circles, as cubic curves.
fn rounded_box(
    left: i32,
    top: i32,
    right: i32,
    bottom: i32,
    radius: i32,
) -> Result<[PathCommand<Sub8>; 9], PrepareError> {
    // How far the control points of a quarter circle are from its ends: 0.5523 of the radius.
    let near = radius - radius * 5523 / 10_000;
    let point = |x, y| SubPoint::from_units(x, y);
    let corner = |from: (i32, i32), to: (i32, i32), end: (i32, i32)| -> Result<_, PrepareError> {
        Ok(PathCommand::CubicTo(
            point(from.0, from.1)?,
            point(to.0, to.1)?,
            point(end.0, end.1)?,
        ))
    };
    Ok([
        PathCommand::MoveTo(point(left + radius, top)?),
        PathCommand::LineTo(point(right - radius, top)?),
        corner((right - near, top), (right, top + near), (right, top + radius))?,
        PathCommand::LineTo(point(right, bottom - radius)?),
        corner((right, bottom - near), (right - near, bottom), (right - radius, bottom))?,
        PathCommand::LineTo(point(left + radius, bottom)?),
        corner((left + near, bottom), (left, bottom - near), (left, bottom - radius))?,
        PathCommand::LineTo(point(left, top + radius)?),
        corner((left, top + near), (left + near, top), (left + radius, top))?,
    ])
}
