//! An instrument panel of antialiased shapes, and its twin without antialiasing: the same outlines in another method.

use core::marker::PhantomData;

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
use heapless::Vec;
use zrow::{
    band::{Band, Order},
    coverage::{AnyCoverage, CoverageMethod},
    draw::{
        AntialiasedPolygon, AntialiasingMemory, DrawOn, FillRule, ItemId, Path, PathCommand, Picture, PictureSlot,
        PrimitiveStyle, SubArc, SubEllipse, SubLine, SubOutline,
    },
    geometry::{Sub8, SubPoint, Window},
};

use crate::{
    PrepareError, Prepared, Scene,
    paint::{hanging, rgb, shape},
    sine::{TURN, around_sub8 as around, sine},
};

const BACKGROUND: Rgb565 = rgb(8, 11, 18);
const BRIGHT: Rgb565 = rgb(240, 245, 255);
const DIM: Rgb565 = rgb(132, 148, 178);
const UNLIT: Rgb565 = rgb(36, 45, 62);
const ACCENT: Rgb565 = rgb(64, 196, 255);
const NEEDLE: Rgb565 = rgb(255, 82, 82);
const HUB: Rgb565 = rgb(70, 84, 112);
const GREEN: Rgb565 = rgb(0, 200, 120);
const YELLOW: Rgb565 = rgb(240, 200, 40);

const WIDTH: usize = 240;
/// Frames of the animation.
const FRAMES: u32 = 64;
/// Edges of an outline with long curves, and of any other.
const CURVED: usize = 272;
const STRAIGHT: usize = 64;
/// Edges of an outline in one row.
const ACTIVE: usize = 32;
/// Outlines of either kind.
const CURVES: usize = 4;
const OTHERS: usize = 24;

/// What decides how the edges look.
pub trait Look: core::fmt::Debug {
    /// See [`Scene::NAME`].
    const NAME: &'static str;
    /// See [`Scene::TITLE`].
    const TITLE: &'static str;
    /// The method for an outline that is set up.
    fn method<const EDGES: usize>(
        outline: &(impl SubOutline + ?Sized),
        polygon: &AntialiasedPolygon<EDGES, ACTIVE>,
    ) -> AnyCoverage;
}

/// Each shape in the cheapest method that is exact for it.
#[derive(Debug)]
pub struct Smooth;

impl Look for Smooth {
    const NAME: &'static str = "instruments";
    const TITLE: &'static str = "instruments";

    fn method<const EDGES: usize>(
        outline: &(impl SubOutline + ?Sized),
        polygon: &AntialiasedPolygon<EDGES, ACTIVE>,
    ) -> AnyCoverage {
        polygon.exact_method(outline)
    }
}

/// Each shape by the centres of pixels.
#[derive(Debug)]
pub struct Jagged;

impl Look for Jagged {
    const NAME: &'static str = "instruments-aliased";
    const TITLE: &'static str = "instruments, aliased";

    fn method<const EDGES: usize>(
        _outline: &(impl SubOutline + ?Sized),
        _polygon: &AntialiasedPolygon<EDGES, ACTIVE>,
    ) -> AnyCoverage {
        AnyCoverage::CentreSample
    }
}

/// The scene's storage: the outlines of a frame, and the memory of one row.
#[derive(Debug)]
pub struct Instruments<L: Look> {
    curves: Vec<Painted<CURVED>, CURVES>,
    others: Vec<Painted<STRAIGHT>, OTHERS>,
    row_memory: [i32; WIDTH + 1],
    look: PhantomData<L>,
}

/// An outline that is set up, its method and its colour.
#[derive(Debug)]
struct Painted<const EDGES: usize> {
    polygon: AntialiasedPolygon<EDGES, ACTIVE>,
    method: AnyCoverage,
    color: Rgb565,
}

impl<const EDGES: usize> Painted<EDGES> {
    fn new<L: Look>(outline: &(impl SubOutline + ?Sized), color: Rgb565) -> Result<Self, PrepareError> {
        let polygon = AntialiasedPolygon::prepare(outline, FillRule::NonZero)?;
        let method = L::method(outline, &polygon);
        Ok(Self { polygon, method, color })
    }
}

/// A frame of the scene.
#[derive(Debug)]
pub struct Ready<'s> {
    curves: &'s [Painted<CURVED>],
    others: &'s [Painted<STRAIGHT>],
    row_memory: &'s mut [i32],
    frame: u32,
}

impl<L: Look> Default for Instruments<L> {
    fn default() -> Self {
        Self {
            curves: Vec::new(),
            others: Vec::new(),
            row_memory: [0; WIDTH + 1],
            look: PhantomData,
        }
    }
}

impl<L: Look> Scene for Instruments<L> {
    type Color = Rgb565;
    type Prepared<'s>
        = Ready<'s>
    where
        Self: 's;
    const NAME: &'static str = L::NAME;
    const TITLE: &'static str = L::TITLE;
    const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(WIDTH as u32, 320));
    const BACKGROUND: Rgb565 = BACKGROUND;
    const FRAMES: u32 = FRAMES;
    const PORTRAIT: u32 = 9;
    const DEPTH_ROW_BYTES: usize = 0;

    fn prepare(&mut self, frame: u32) -> Result<Ready<'_>, PrepareError> {
        let frame = frame % FRAMES;
        self.curves.clear();
        self.others.clear();
        let (curves, others) = (&mut self.curves, &mut self.others);
        draw_outlines(frame, &mut |outline, color, part| {
            let is_full = match part {
                Part::LitArc | Part::Curve => curves.push(Painted::new::<L>(outline, color)?).is_err(),
                Part::Needle | Part::Other => others.push(Painted::new::<L>(outline, color)?).is_err(),
            };
            debug_assert!(!is_full, "there is room for every outline");
            Ok(())
        })?;
        Ok(Ready {
            curves: &self.curves,
            others: &self.others,
            row_memory: &mut self.row_memory,
            frame,
        })
    }
}

impl Prepared for Ready<'_> {
    type Color = Rgb565;

    fn draw<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>) {
        paint(self.curves, band, self.row_memory);
        paint(self.others, band, self.row_memory);
        let digits = digits(self.frame);
        for text in texts(&digits) {
            let Ok(()) = text.draw_on(band);
        }
        shape(band, &rule());
    }
}

/// The digits of the speed.
fn digits(frame: u32) -> [u8; 3] {
    let speed = speed(frame);
    [speed / 100, speed / 10 % 10, speed % 10].map(|digit| b'0' + digit as u8)
}

/// All texts of the panel.
fn texts(digits: &[u8; 3]) -> [Text<'_, MonoTextStyle<'static, Rgb565>>; 6] {
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
fn rule() -> Styled<Line, PrimitiveStyle<Rgb565>> {
    Line::new(Point::new(8, 19), Point::new(231, 19)).into_styled(PrimitiveStyle::with_stroke(UNLIT, 1))
}

/// Items of the panel: 27 outlines, 6 texts and a line.
const ITEMS: usize = 34;
/// Words of its pool: those of the outlines, and for each text one a character and one more; 596 in any frame, and 26 for an
/// arc that is compared with the one that it replaces.
const WORDS: usize = 622;
/// The most edges that one outline has in one row.
const SEGMENTS: usize = 23;
/// Chains of edges in one row, of all outlines together.
const CHAINS: usize = 22;

/// All memory of the panel as a picture.
#[derive(Debug)]
pub struct Panel {
    slots: [PictureSlot<'static, Rgb565>; ITEMS],
    pool: [u32; WORDS],
    buckets: [u16; 320],
    antialiasing: AntialiasingMemory<{ WIDTH + 1 }, SEGMENTS, CHAINS>,
}

impl Panel {
    /// Memory without a picture.
    pub const fn new() -> Self {
        Self {
            slots: [PictureSlot::EMPTY; ITEMS],
            pool: [0; WORDS],
            buckets: [0; 320],
            antialiasing: AntialiasingMemory::new(),
        }
    }

    /// The picture of a frame, everything prepared anew.
    ///
    /// # Errors
    /// [`PrepareError`] where an outline is out of its domain or memory is too small.
    pub fn prepare(&mut self, frame: u32) -> Result<Picture<'_, 'static, Rgb565>, PrepareError> {
        let mut picture = self.empty();
        Changing::add(&mut picture, frame)?;
        Ok(picture)
    }

    /// The picture of a frame, which tells what changes in it from then on, and its items that change.
    ///
    /// # Errors
    /// [`PrepareError`] where an outline is out of its domain or memory is too small.
    pub fn prepare_with_damage<'m>(
        &'m mut self,
        areas: &'m mut [Window],
        frame: u32,
    ) -> Result<(Picture<'m, 'static, Rgb565>, Changing), PrepareError> {
        let mut picture = self.empty().with_damage(areas, (1, 1));
        let changing = Changing::add(&mut picture, frame)?;
        Ok((picture, changing))
    }

    /// The picture without items.
    fn empty(&mut self) -> Picture<'_, 'static, Rgb565> {
        let area = Instruments::<Smooth>::AREA;
        Picture::new(area, &mut self.slots, &mut self.pool, &mut self.buckets).with_antialiasing(&mut self.antialiasing)
    }
}

impl Default for Panel {
    fn default() -> Self {
        Self::new()
    }
}

/// The items of the panel that show its speed: the lit arc, the needle and the digits.
#[derive(Debug)]
pub struct Changing {
    arc: ItemId,
    needle: ItemId,
    digits: ItemId,
}

impl Changing {
    /// Adds everything to a picture, in the order in which it is drawn without one.
    fn add(picture: &mut Picture<'_, 'static, Rgb565>, frame: u32) -> Result<Self, PrepareError> {
        let frame = frame % FRAMES;
        let (mut arc, mut needle) = (None, None);
        draw_outlines(frame, &mut |outline, color, part| {
            let id = picture.add_outline(outline, FillRule::NonZero, color)?;
            match part {
                Part::LitArc => arc = Some(id),
                Part::Needle => needle = Some(id),
                Part::Curve | Part::Other => {}
            }
            Ok(())
        })?;
        let digits = digits(frame);
        let [value, names @ ..] = texts(&digits);
        let digits = picture.add(&value)?;
        for text in names {
            picture.add(&text)?;
        }
        picture.add(&rule())?;
        Ok(Self {
            // Every frame has both.
            arc: arc.unwrap_or(digits),
            needle: needle.unwrap_or(digits),
            digits,
        })
    }

    /// Moves the arc, the needle and the digits to where they are in another frame.
    ///
    /// # Errors
    /// [`PrepareError`] where the memory is too small.
    pub fn show(&self, picture: &mut Picture<'_, 'static, Rgb565>, frame: u32) -> Result<(), PrepareError> {
        let frame = frame % FRAMES;
        let (arc, needle) = (lit_arc(frame)?, needle(frame)?);
        picture.replace_outline(self.arc, &arc, FillRule::NonZero, ACCENT)?;
        let needle = [needle.as_slice()];
        picture.replace_outline(self.needle, &needle, FillRule::NonZero, NEEDLE)?;
        let digits = digits(frame);
        let [value, ..] = texts(&digits);
        picture.replace(self.digits, &value)
    }
}

/// Draws outlines in order.
fn paint<O: Order, const EDGES: usize>(
    outlines: &[Painted<EDGES>],
    band: &mut Band<'_, Rgb565, O>,
    row_memory: &mut [i32],
) {
    for Painted { polygon, method, color } in outlines {
        let drawn = polygon.draw(method, *color, band, row_memory);
        debug_assert!(
            drawn.is_ok(),
            "the row memory is as wide as the panel: {}",
            AnyCoverage::cells(WIDTH)
        );
    }
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
enum Part {
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
fn draw_outlines(frame: u32, fill: &mut Fill<'_>) -> Result<(), PrepareError> {
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
fn lit_arc(frame: u32) -> Result<SubArc, PrepareError> {
    gauge_arc(reach(frame))
}

/// The corners of the needle.
fn needle(frame: u32) -> Result<[SubPoint<Sub8>; 4], PrepareError> {
    let angle = FIRST + reach(frame);
    Ok([
        around(CENTER, 64 * 256, angle)?,
        around(CENTER, 4 * 256, angle + 0x4000)?,
        around(CENTER, 14 * 256, angle + 0x8000)?,
        around(CENTER, 4 * 256, angle + 0xc000)?,
    ])
}

/// Where outlines go.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shown::{Display, drawn};

    const AREA: Rectangle = Instruments::<Smooth>::AREA;

    #[test]
    fn the_picture_shows_what_is_drawn_without_one() {
        let (mut scene, mut panel) = (Instruments::<Smooth>::default(), Panel::new());
        for frame in 0..FRAMES {
            let mut prepared = scene.prepare(frame).unwrap();
            let expected = drawn(AREA, BACKGROUND, 1, |band| prepared.draw(band));
            for rows in [1, 7] {
                let mut picture = panel.prepare(frame).unwrap();
                assert!(
                    drawn(AREA, BACKGROUND, rows, |band| picture.draw(band)) == expected,
                    "frame {frame}, bands of {rows}"
                );
            }
        }
    }

    /// A display on which only what changes is drawn shows what a whole picture does, and takes less.
    #[test]
    fn what_changes_is_all_that_has_to_be_sent() {
        let (mut panel, mut whole, mut areas) = (Panel::new(), Panel::new(), [Window::EMPTY; 16]);
        let (mut picture, changing) = panel.prepare_with_damage(&mut areas, 0).unwrap();
        let mut display = Display::new(AREA, BACKGROUND);
        for frame in 0..FRAMES {
            changing.show(&mut picture, frame).unwrap();
            let sent = display.send_changes(&mut picture);
            let (mut expected, changing) = whole.prepare_with_damage(&mut [], 0).unwrap();
            changing.show(&mut expected, frame).unwrap();
            let expected = drawn(AREA, BACKGROUND, 1, |band| expected.draw(band));
            assert!(expected == display.words(), "frame {frame}");
            // The first frame is drawn whole.
            assert!(frame == 0 || sent <= 2_392, "frame {frame} sends {sent} pixels");
        }
    }
}
