//! The cockpit of a small vehicle: everything on it is antialiased and an item of one [`Picture`], the texts in real fonts.
//!
//! ```text
//!   zrow       10:24      >  ))     name, clock, icons
//!   <   .-""" 80 """-.    >         turn signals; a scale with its lit arc, ticks and a needle
//!      / 60        100\
//!     | 40   87    120 |            the speed in digits of equal widths
//!      \ 20  km/h  140/
//!   21 C `-.      .-'  186 km       what is outside, the range
//!   +-----+ +-------------+
//!   |( 79)| | POWER   9 kW|         the battery as a ring, the last seconds as a plot
//!   +-----+ +-------------+
//! ```

use embedded_graphics::{
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Rectangle, RoundedRectangle, Styled},
    text::{Alignment, Baseline, Text, TextStyleBuilder},
};
use fixed::types::{U0F16, U24F8};
use zrow::{
    draw::{
        Antialiased, FillRule, MaskFont, MaskTextStyle, Picture, PrimitiveStyle, SubArc, SubEllipse, SubLine,
        SubOutline,
    },
    geometry::{Sub8, SubPoint},
};

use crate::{
    PictureCapacities, PrepareError, Scene,
    fonts::{DEJAVU_SANS_12, DEJAVU_SANS_16, DEJAVU_SANS_BOLD_36},
    paint::rgb,
    picture_memory::PictureMemory,
    sine::{TURN, around_sub8 as around, sine},
};

const BACKGROUND: Rgb565 = rgb(8, 11, 18);
const CARD: Rgb565 = rgb(20, 27, 41);
const UNLIT: Rgb565 = rgb(42, 53, 75);
const DIM: Rgb565 = rgb(140, 156, 186);
const BRIGHT: Rgb565 = rgb(240, 245, 255);
const ACCENT: Rgb565 = rgb(64, 196, 255);
const NEEDLE: Rgb565 = rgb(255, 96, 64);
const LIMIT: Rgb565 = rgb(140, 40, 52);
const GREEN: Rgb565 = rgb(40, 210, 130);
const SHADE: Rgb565 = rgb(16, 70, 62);

const WIDTH: usize = 240;
const FRAMES: u32 = 64;

/// Items: 35 outlines, 3 filled rectangles with round corners and 24 texts.
const ITEMS: usize = 62;
/// Words of the pool in any frame.
const WORDS: usize = 1_337;
/// The most edges that one outline has in one row.
const SEGMENTS: usize = 15;
/// Chains of edges in one row, of all outlines together.
const CHAINS: usize = 27;

type Memory = PictureMemory<Rgb565, ITEMS, WORDS, 320, { WIDTH + 1 }, SEGMENTS, CHAINS>;

/// The scene's storage.
#[derive(Debug, Default)]
pub struct Cockpit(Memory);

impl Cockpit {
    /// Memory without a picture.
    pub const fn new() -> Self {
        Self(PictureMemory::new())
    }
}

impl Scene for Cockpit {
    type Color = Rgb565;
    type Prepared<'s> = Picture<'s, 'static, Rgb565>;
    const NAME: &'static str = "cockpit";
    const TITLE: &'static str = "cockpit";
    const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(WIDTH as u32, 320));
    const BACKGROUND: Rgb565 = BACKGROUND;
    const FRAMES: u32 = FRAMES;
    const PORTRAIT: u32 = 3;
    const PICTURE: Option<PictureCapacities> = Some(Memory::capacities(0));

    fn prepare(&mut self, frame: u32) -> Result<Picture<'_, 'static, Rgb565>, PrepareError> {
        let mut picture = self.0.picture(Self::AREA);
        add_items(&mut picture, frame % FRAMES)?;
        Ok(picture)
    }
}

/// Adds the items of a frame to a picture.
fn add_items(picture: &mut Picture<'_, 'static, Rgb565>, frame: u32) -> Result<(), PrepareError> {
    let mut panel = Panel(picture);
    panel.header()?;
    panel.scale(frame)?;
    panel.speed(frame)?;
    panel.turn_signals(frame)?;
    panel.corners()?;
    panel.battery(frame)?;
    panel.power(frame)
}

/// The centre of the scale, in pixels.
const CENTER: (i32, i32) = (120, 132);
/// The angle at which the scale begins, in 1/65,536 turn from the upper end on, clockwise.
const FIRST: u32 = 0x1_0000 * 5 / 8;
/// The angle that the scale spans: three quarters of a turn.
const SWEEP: u32 = 0x1_0000 * 3 / 4;
const TOP_SPEED: u32 = 180;

/// Swings between 20 and 160.
fn speed(frame: u32) -> u32 {
    (90 + ((70 * sine(frame * TURN / FRAMES)) >> 14)) as u32
}

/// The angle of a speed, from the beginning of the scale on.
fn reach(speed: u32) -> u32 {
    SWEEP * speed / TOP_SPEED
}

/// The power in 1/256 kW, `age` samples before a frame.
fn power(frame: u32, age: u32) -> i32 {
    let angle = (frame * TURN / FRAMES).wrapping_sub(age * 14);
    9 * 256 + ((sine(angle) * 5 + sine(angle.wrapping_mul(3)) * 2) >> 6)
}

/// A length or a position in 1/256 pixel, from one in 1/8 pixel.
const fn eighths(number: i32) -> i32 {
    number * 32
}

fn length(eighths: i32) -> U24F8 {
    U24F8::from_bits(self::eighths(eighths) as u32)
}

/// A point in 1/8 pixel; pixels have their centres at whole ones.
fn point(x: i32, y: i32) -> Result<SubPoint<Sub8>, PrepareError> {
    SubPoint::from_units(eighths(x), eighths(y))
}

/// A part of a ring: the radii in 1/8 pixel, and angles in 1/65,536 turn from the upper end on, clockwise.
fn arc(center: (i32, i32), radii: [i32; 2], first: u32, sweep: u32) -> Result<SubArc, PrepareError> {
    // Arcs count from the x axis.
    let start = U0F16::from_bits(first.wrapping_sub(0x4000) as u16);
    let center = point(center.0 * 8, center.1 * 8)?;
    SubArc::new(center, radii.map(length), start, U0F16::from_bits(sweep as u16))
}

/// The picture of the cockpit while its items are added, in painter's order.
struct Panel<'p, 'm>(&'p mut Picture<'m, 'static, Rgb565>);

impl Panel<'_, '_> {
    fn outline(&mut self, outline: &dyn SubOutline, color: Rgb565) -> Result<(), PrepareError> {
        self.0.add_outline(outline, FillRule::NonZero, color).map(drop)
    }

    /// The inside of a contour, whose corners are in 1/8 pixel.
    fn polygon<const CORNERS: usize>(
        &mut self,
        corners: [(i32, i32); CORNERS],
        color: Rgb565,
    ) -> Result<(), PrepareError> {
        let mut contour = [SubPoint::<Sub8>::default(); CORNERS];
        for (corner, (x, y)) in contour.iter_mut().zip(corners) {
            *corner = point(x, y)?;
        }
        self.outline(&[contour.as_slice()], color)
    }

    /// A text whose letters stand on row `at.y`.
    fn text(
        &mut self,
        text: &str,
        at: (i32, i32),
        alignment: Alignment,
        font: &'static MaskFont,
        color: Rgb565,
    ) -> Result<(), PrepareError> {
        let style = TextStyleBuilder::new()
            .alignment(alignment)
            .baseline(Baseline::Alphabetic)
            .build();
        let text = Text::with_text_style(text, Point::new(at.0, at.1), MaskTextStyle::new(font, color), style);
        self.0.add(&text).map(drop)
    }

    /// A filled rectangle with round corners.
    fn card(&mut self, area: Rectangle, radius: u32, color: Rgb565) -> Result<(), PrepareError> {
        let card: Styled<_, Antialiased<_>> = RoundedRectangle::with_equal_corners(area, Size::new_equal(radius))
            .into_styled(PrimitiveStyle::with_fill(color).antialiased());
        self.0.add(&card).map(drop)
    }

    /// The name, the clock, and icons.
    fn header(&mut self) -> Result<(), PrepareError> {
        self.text("zrow", (9, 16), Alignment::Left, &DEJAVU_SANS_16, ACCENT)?;
        self.text("10:24", (120, 16), Alignment::Center, &DEJAVU_SANS_16, BRIGHT)?;
        // An arrow head for where one is, and arcs around a dot for how well one is heard.
        self.polygon([(1496, 52), (1600, 32), (1560, 132), (1544, 84)], BRIGHT)?;
        let mast = (222, 16);
        self.outline(&SubEllipse::circle(point(mast.0 * 8, mast.1 * 8)?, length(13))?, BRIGHT)?;
        for (radius, color) in [(38, BRIGHT), (64, BRIGHT), (90, UNLIT)] {
            self.outline(&arc(mast, [radius - 7, radius + 7], 0xe000, 0x4000)?, color)?;
        }
        Ok(())
    }

    /// The scale with its numbers, its lit part and the needle.
    fn scale(&mut self, frame: u32) -> Result<(), PrepareError> {
        const RADII: [i32; 2] = [97 * 8, 106 * 8];
        let limit = reach(150);
        self.outline(&arc(CENTER, RADII, FIRST, limit)?, UNLIT)?;
        self.outline(&arc(CENTER, RADII, FIRST + limit, SWEEP - limit)?, LIMIT)?;
        self.outline(&arc(CENTER, RADII, FIRST, reach(speed(frame)))?, ACCENT)?;
        for tick in 0..19 {
            let angle = FIRST + SWEEP * tick / 18;
            let (inner, width, color) = if tick.is_multiple_of(2) {
                (85, 15, BRIGHT)
            } else {
                (88, 10, DIM)
            };
            let (from, to) = (around(CENTER, inner * 256, angle)?, around(CENTER, 93 * 256, angle)?);
            self.outline(&SubLine::new(from, to, length(width))?, color)?;
        }
        for (number, name) in (0..).zip(["0", "20", "40", "60", "80", "100", "120", "140", "160", "180"]) {
            let angle = FIRST + SWEEP * number / 9;
            // Numbers are wider than they are high.
            let (x, y) = (around(CENTER, 69 * 256, angle)?, around(CENTER, 74 * 256, angle)?);
            // A digit is nine rows high.
            let at = ((x.x_units() + 128) >> 8, ((y.y_units() + 128) >> 8) + 4);
            self.text(name, at, Alignment::Center, &DEJAVU_SANS_12, DIM)?;
        }
        let angle = FIRST + reach(speed(frame));
        let needle = [
            around(CENTER, 95 * 256, angle)?,
            around(CENTER, 53 * 256, angle + 0x0300)?,
            around(CENTER, 53 * 256, angle - 0x0300)?,
        ];
        self.outline(&[needle.as_slice()], NEEDLE)
    }

    /// The speed in digits, and the mode in which one drives.
    fn speed(&mut self, frame: u32) -> Result<(), PrepareError> {
        let speed = speed(frame);
        let digits = [speed / 100, speed / 10 % 10, speed % 10].map(|digit| b'0' + digit as u8);
        let shown = digits.get(usize::from(speed < 100)..).unwrap_or_default();
        let shown = core::str::from_utf8(shown).unwrap_or_default();
        let ring = SubArc::ring(point(CENTER.0 * 8, CENTER.1 * 8)?, [length(49 * 8), length(50 * 8 + 4)])?;
        self.outline(&ring, UNLIT)?;
        self.text(shown, (120, 141), Alignment::Center, &DEJAVU_SANS_BOLD_36, BRIGHT)?;
        self.text("km/h", (120, 161), Alignment::Center, &DEJAVU_SANS_12, DIM)?;
        self.card(Rectangle::new(Point::new(92, 209), Size::new(57, 20)), 10, GREEN)?;
        self.text("ECO", (120, 223), Alignment::Center, &DEJAVU_SANS_12, BACKGROUND)
    }

    /// An arrow to either side.
    fn turn_signals(&mut self, frame: u32) -> Result<(), PrepareError> {
        let is_lit = (frame / 4).is_multiple_of(2);
        for (tip, side, color) in [(10 * 8, 8, UNLIT), (229 * 8, -8, if is_lit { GREEN } else { UNLIT })] {
            let y = 40 * 8;
            self.polygon(
                [
                    (tip, y),
                    (tip + 10 * side, y - 8 * 8),
                    (tip + 10 * side, y - 3 * 8),
                    (tip + 19 * side, y - 3 * 8),
                    (tip + 19 * side, y + 3 * 8),
                    (tip + 10 * side, y + 3 * 8),
                    (tip + 10 * side, y + 8 * 8),
                ],
                color,
            )?;
        }
        Ok(())
    }

    /// The temperature and the range, below the ends of the scale.
    fn corners(&mut self) -> Result<(), PrepareError> {
        self.text("21 °C", (9, 226), Alignment::Left, &DEJAVU_SANS_16, BRIGHT)?;
        self.text("outside", (9, 240), Alignment::Left, &DEJAVU_SANS_12, DIM)?;
        self.text("186 km", (231, 226), Alignment::Right, &DEJAVU_SANS_16, BRIGHT)?;
        self.text("range", (231, 240), Alignment::Right, &DEJAVU_SANS_12, DIM)
    }

    /// Adds the battery's card: its charge in percent as an arc of a ring, and as a number inside the ring.
    fn battery(&mut self, frame: u32) -> Result<(), PrepareError> {
        self.card(Rectangle::new(Point::new(8, 249), Size::new(64, 64)), 10, CARD)?;
        let center = (40, 281);
        let radii = [21 * 8, 26 * 8];
        let percent = 79 - frame / 16;
        let ring = SubArc::ring(point(center.0 * 8, center.1 * 8)?, radii.map(length))?;
        self.outline(&ring, UNLIT)?;
        self.outline(&arc(center, radii, 0, percent * 0x1_0000 / 100)?, GREEN)?;
        let digits = [percent / 10, percent % 10].map(|digit| b'0' + digit as u8);
        let digits = core::str::from_utf8(&digits).unwrap_or_default();
        self.text(
            digits,
            (center.0, center.1 + 3),
            Alignment::Center,
            &DEJAVU_SANS_16,
            BRIGHT,
        )?;
        self.text("%", (center.0, center.1 + 15), Alignment::Center, &DEJAVU_SANS_12, DIM)
    }

    /// Adds the card of the engine's power over the last seconds: a curve and the area below it, and the power now as a number.
    fn power(&mut self, frame: u32) -> Result<(), PrepareError> {
        self.card(Rectangle::new(Point::new(80, 249), Size::new(152, 64)), 10, CARD)?;
        let now = (power(frame, 0) + 128) >> 8;
        let digits = [now / 10, now % 10].map(|digit| b'0' + digit as u8);
        let digits = digits.get(usize::from(now < 10)..).unwrap_or_default();
        let digits = core::str::from_utf8(digits).unwrap_or_default();
        self.text("power", (90, 264), Alignment::Left, &DEJAVU_SANS_12, DIM)?;
        self.text("kW", (222, 264), Alignment::Right, &DEJAVU_SANS_12, DIM)?;
        self.text(digits, (200, 264), Alignment::Right, &DEJAVU_SANS_16, BRIGHT)?;
        self.plot(frame)
    }

    fn plot(&mut self, frame: u32) -> Result<(), PrepareError> {
        const SAMPLES: usize = 34;
        const BOTTOM: i32 = 304 * 256 + 128;
        let mut line = [SubPoint::<Sub8>::default(); 2 * SAMPLES];
        let mut below = [SubPoint::<Sub8>::default(); SAMPLES + 2];
        for index in 0..SAMPLES {
            let x = (90 + 4 * index as i32) * 256;
            let y = BOTTOM - power(frame, (SAMPLES - 1 - index) as u32) * 2;
            let (above, under) = line.split_at_mut(SAMPLES);
            for (corner, y) in [
                (above.get_mut(index), y - 200),
                (under.get_mut(SAMPLES - 1 - index), y + 200),
                (below.get_mut(index), y),
            ] {
                if let Some(corner) = corner {
                    *corner = SubPoint::from_units(x, y)?;
                }
            }
        }
        let ends = [222, 90].map(|x| SubPoint::from_units(x * 256, BOTTOM));
        for (corner, end) in below.iter_mut().skip(SAMPLES).zip(ends) {
            *corner = end?;
        }
        self.outline(&[below.as_slice()], SHADE)?;
        self.outline(&[line.as_slice()], GREEN)
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use zrow::geometry::{InputError, TooSmall};

    use super::*;

    /// Slots, words and segments are no more than the frames need.
    #[test]
    fn the_memory_is_what_the_frames_need() {
        let mut cockpit = Cockpit::new();
        let (mut items, mut words) = (0, 0);
        for frame in 0..FRAMES {
            let picture = cockpit.prepare(frame).unwrap();
            items = items.max(picture.slots_used());
            words = words.max(picture.words_used());
        }
        assert_eq!((items, words), (ITEMS, WORDS));

        let mut memory = PictureMemory::<Rgb565, ITEMS, WORDS, 320, { WIDTH + 1 }, { SEGMENTS - 1 }, CHAINS>::new();
        let needed = (0..FRAMES).filter_map(|frame| match add_items(&mut memory.picture(Cockpit::AREA), frame) {
            Err(InputError::TooSmall(TooSmall::Segments(needed))) => Some(needed),
            _ => None,
        });
        assert_eq!(needed.max(), Some(SEGMENTS));
    }
}
