//! The scene of the 128 x 64 OLED in 16 greys: a 3D object in a hoop that its tips pierce, and an antialiased gauge.

use core::ops::Range;

use embedded_graphics::{
    mono_font::{MonoFont, MonoTextStyle, ascii::FONT_6X10},
    pixelcolor::Gray4,
    prelude::*,
    primitives::{Circle, Rectangle},
    text::{Alignment, Baseline, Text, TextStyleBuilder},
};
use fixed::types::{I2F30, I16F16, U0F16, U24F8};
use zrow::{
    band::{Band, Order},
    draw::{DrawOn, FillRule, ItemId, Picture, PrimitiveStyle, SubArc, SubEllipse, SubLine, SubOutline},
    geometry::{Sub4, Sub8, SubPoint},
    scene::{self, Camera, FaceSet, Model, Pose, Rotation},
};

use crate::{PictureCapacities, PrepareError, Prepared, Scene, picture_memory::PictureMemory};

/// The whole panel.
pub const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(128, 64));
/// Frames of one turn of the animation.
pub const FRAMES: u32 = 64;

/// A cube, and an octahedron whose tips come out of its sides. 1 is 512 units.
static VERTICES: [[i16; 3]; 14] = [
    [-320, -320, -320],
    [320, -320, -320],
    [-320, 320, -320],
    [320, 320, -320],
    [-320, -320, 320],
    [320, -320, 320],
    [-320, 320, 320],
    [320, 320, 320],
    [-620, 0, 0],
    [620, 0, 0],
    [0, -620, 0],
    [0, 620, 0],
    [0, 0, -620],
    [0, 0, 620],
];
#[rustfmt::skip]
static FACES: [[u16; 3]; 20] = [
    [0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4],
    [2, 6, 7], [2, 7, 3], [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5],
    [9, 11, 13], [11, 8, 13], [8, 10, 13], [10, 9, 13], [11, 9, 12], [8, 11, 12], [10, 8, 12], [9, 10, 12],
];
const OBJECT: FaceSet = match FaceSet::new(&VERTICES, &FACES) {
    Ok(faces) => faces,
    Err(_) => panic!("a face names a vertex that is not there"),
};
/// The cube's sides in dark greys, the octahedron's in light ones.
static COLORS: [Gray4; FACES.len()] = {
    let mut colors = [Gray4::BLACK; FACES.len()];
    let mut face = 0;
    while face < colors.len() {
        let grey = if face < 12 { 2 + face / 2 } else { 8 + (face - 12) % 7 };
        colors[face] = Gray4::new(grey as u8);
        face += 1;
    }
    colors
};

const MODEL: Model<'static, Gray4> = match Model::new(OBJECT, &COLORS) {
    Ok(model) => model,
    Err(_) => panic!("a face has no colour"),
};
/// The font, in which a glyph is found by a subtraction: embedded-graphics' own mapping counts all characters before it, and
/// the name is drawn anew in each of its rows.
static FONT: MonoFont<'static> = MonoFont {
    glyph_mapping: &(ascii_glyph as fn(char) -> usize),
    ..FONT_6X10
};
const WHITE_TEXT: MonoTextStyle<'static, Gray4> = MonoTextStyle::new(&FONT, Gray4::WHITE);

const NEAR: I16F16 = I16F16::lit("128");
const DISTANCE: I16F16 = I16F16::lit("1536");
/// Nearer than the object's middle, farther than the tips and corners that point at the eye.
const HOOP_DISTANCE: I16F16 = I16F16::lit("1300");
/// In pixels: the object's 620 units at that distance are 26.
const FOCAL_LENGTH: I16F16 = I16F16::lit("64");

/// Where the object turns.
const VIEWPORT: Rectangle = Rectangle::new(Point::zero(), Size::new(64, 64));
/// Around the middle of the viewport.
const HOOP: Circle = Circle::new(Point::new(10, 10), 43);
/// The rows of its black edge, of which half lies outside of the circle.
const HOOP_ROWS: Range<i32> = 8..55;
/// White, and edged in black, so that the hoop is seen before every grey: at equal depths, what is drawn first stays.
const HOOP_STYLES: [PrimitiveStyle<Gray4>; 2] = [
    PrimitiveStyle::with_stroke(Gray4::WHITE, 2),
    PrimitiveStyle::with_stroke(Gray4::BLACK, 4),
];
/// The left end of the name's baseline, in a corner that the object never reaches.
const NAME_POSITION: Point = Point::new(1, 62);
const GAUGE_CENTER: Point = Point::new(96, 36);
/// Items of the picture: 16 greys, the gauge's ring, 7 ticks, needle and hub, and a number.
const ITEMS: usize = 27;
/// Words of its pool: 132 in any frame, and 12 for a needle that is written before the one that it replaces is taken out.
const WORDS: usize = 132 + 12;
/// The most edges that one outline has in one row.
const SEGMENTS: usize = 25;
/// Chains of edges in one row, of all outlines together.
const CHAINS: usize = 12;

type Memory = PictureMemory<
    Gray4,
    ITEMS,
    WORDS,
    { AREA.size.height as usize },
    { AREA.size.width as usize + 1 },
    SEGMENTS,
    CHAINS,
>;
type Storage = scene::Memory<
    Gray4,
    { OBJECT.vertices().len() },
    { OBJECT.faces().len() },
    { VIEWPORT.size.width as usize },
    { VIEWPORT.size.height as usize },
    { OBJECT.faces().len() },
>;

/// The scene's storage: the object, and the memory of the picture beside it.
#[derive(Debug, Default)]
pub struct Oled {
    object: Object,
    memory: Memory,
}

impl Oled {
    /// The scene for a display that shows frame after frame: the picture stays, and only what moves is prepared anew.
    ///
    /// # Errors
    /// A table of the scene is too small.
    pub fn animation(&mut self) -> Result<Animation<'_>, PrepareError> {
        let mut picture = self.memory.picture(AREA);
        let changing = Changing::add(&mut picture, 0)?;
        Ok(Animation {
            object: &mut self.object,
            picture,
            changing,
        })
    }
}

/// The scene from frame to frame.
#[derive(Debug)]
pub struct Animation<'s> {
    object: &'s mut Object,
    picture: Picture<'s, 'static, Gray4>,
    changing: Changing,
}

impl<'s> Animation<'s> {
    /// Gets everything ready for a frame. Any number is a frame, and any may follow another one.
    ///
    /// # Errors
    /// A table of the scene is too small for this frame.
    pub fn prepare(&mut self, frame: u32) -> Result<Ready<'_, &mut Picture<'s, 'static, Gray4>>, PrepareError> {
        self.changing.show(&mut self.picture, frame)?;
        Ok(Ready {
            object: self.object.prepare(frame)?,
            picture: &mut self.picture,
        })
    }
}

/// A frame of the scene, with its picture.
#[derive(Debug)]
pub struct Ready<'s, P> {
    object: Turned<'s>,
    picture: P,
}

impl Scene for Oled {
    type Color = Gray4;
    type Prepared<'s> = Ready<'s, Picture<'s, 'static, Gray4>>;
    const NAME: &'static str = "oled";
    const TITLE: &'static str = "OLED in 16 greys";
    const AREA: Rectangle = AREA;
    const BACKGROUND: Gray4 = Gray4::BLACK;
    const FRAMES: u32 = FRAMES;
    const PORTRAIT: u32 = 4;
    const PICTURE: Option<PictureCapacities> = Some(Memory::capacities(0));
    const DEPTH_ROW_BYTES: usize = 2 * VIEWPORT.size.width as usize;

    fn prepare(&mut self, frame: u32) -> Result<Self::Prepared<'_>, PrepareError> {
        let mut picture = self.memory.picture(AREA);
        Changing::add(&mut picture, frame)?;
        Ok(Ready {
            object: self.object.prepare(frame)?,
            picture,
        })
    }
}

impl<P: Prepared<Color = Gray4>> Prepared for Ready<'_, P> {
    type Color = Gray4;

    fn capacities_used(&self) -> Option<PictureCapacities> {
        self.picture.capacities_used()
    }

    fn draw<O: Order>(&mut self, band: &mut Band<'_, Gray4, O>) {
        self.object.draw(band);
        self.picture.draw(band);
    }
}

/// The turning object's storage.
#[derive(Debug)]
struct Object {
    memory: Storage,
    models: [Model<'static, Gray4>; 1],
}

impl Default for Object {
    fn default() -> Self {
        Self {
            memory: Storage::new(),
            models: [MODEL],
        }
    }
}

impl Object {
    /// Turns the object to where it is in a frame.
    fn prepare(&mut self, frame: u32) -> Result<Turned<'_>, PrepareError> {
        let frame = frame % FRAMES;
        let camera = Camera::new(VIEWPORT, NEAR)?.with_focal_length(FOCAL_LENGTH)?;
        // A whole turn about y while it turns three times about x.
        let turn = U0F16::from_bits((frame * (65_536 / FRAMES)) as u16);
        let rotation =
            Rotation::about_x(U0F16::from_bits(turn.to_bits().wrapping_mul(3))).then(&Rotation::about_y(turn));
        for model in &mut self.models {
            model.pose = Pose::new(rotation, [I16F16::ZERO, I16F16::ZERO, DISTANCE]);
        }
        let name = Text::new("zrow", NAME_POSITION, WHITE_TEXT);
        Ok(Turned {
            faces: self.memory.prepare(&camera, &self.models)?,
            hoop_depth: camera.depth_at::<Sub4, u16>(HOOP_DISTANCE),
            name_rows: name.bounding_box().rows(),
            name,
        })
    }
}

/// The object as it is in a frame, the hoop around it, and its name.
#[derive(Debug)]
struct Turned<'s> {
    faces: scene::Prepared<'s, 'static, Gray4>,
    hoop_depth: u16,
    name: Text<'static, MonoTextStyle<'static, Gray4>>,
    name_rows: Range<i32>,
}

impl Turned<'_> {
    fn draw<O: Order>(&mut self, band: &mut Band<'_, Gray4, O>) {
        self.faces.draw_with(band, |row| {
            if HOOP_ROWS.contains(&row.y()) {
                for style in HOOP_STYLES {
                    let Ok(()) = HOOP.into_styled(style).draw_on(&mut row.at_depth(self.hoop_depth));
                }
            }
        });
        let rows = band.bounding_box().rows();
        if rows.start < self.name_rows.end && self.name_rows.start < rows.end {
            let Ok(()) = self.name.draw_on(band);
        }
    }
}

/// The items of the picture that move: the needle of the gauge and the number of the frame.
#[derive(Debug)]
struct Changing {
    needle: ItemId,
    number: ItemId,
}

impl Changing {
    /// Adds everything to a picture, as it is in a frame.
    fn add(picture: &mut Picture<'_, 'static, Gray4>, frame: u32) -> Result<Self, PrepareError> {
        let frame = frame % FRAMES;
        add_greys(picture)?;
        Ok(Self {
            needle: add_gauge(picture, frame)?,
            number: picture.add(&number(&digits(frame)))?,
        })
    }

    /// Moves the needle and counts the number to where they are in another frame.
    fn show(&self, picture: &mut Picture<'_, 'static, Gray4>, frame: u32) -> Result<(), PrepareError> {
        let frame = frame % FRAMES;
        picture.replace_outline(self.needle, &needle(frame)?, FillRule::NonZero, Gray4::WHITE)?;
        picture.replace(self.number, &number(&digits(frame)))
    }
}

/// Adds all greys side by side.
fn add_greys(picture: &mut Picture<'_, 'static, Gray4>) -> Result<(), PrepareError> {
    for (left, grey) in (64..).step_by(4).zip(0..16) {
        let bar = Rectangle::new(Point::new(left, 0), Size::new(4, 6));
        picture.add(&bar.into_styled(PrimitiveStyle::with_fill(Gray4::new(grey))))?;
    }
    Ok(())
}

/// Adds the gauge's ring, its ticks, the needle and the hub. Returns the needle.
fn add_gauge(picture: &mut Picture<'_, 'static, Gray4>, frame: u32) -> Result<ItemId, PrepareError> {
    let mut add = |outline: &dyn SubOutline, grey| picture.add_outline(outline, FillRule::NonZero, Gray4::new(grey));
    let center = around(0, 0)?;
    add(&SubArc::ring(center, [length(5_760), length(6_272)])?, 9)?;
    for tick in 0..7 {
        add(&line(5_120, 5_632, 0x8000u16.wrapping_add(tick * 0x1555), 320)?, 9)?;
    }
    let needle = add(&needle(frame)?, 15)?;
    add(&SubEllipse::circle(center, length(640))?, 15)?;
    Ok(needle)
}

/// The needle, which swings to and fro over the upper half.
fn needle(frame: u32) -> Result<SubLine, PrepareError> {
    let swing = frame.min(FRAMES - 1 - frame) * 0x8000 / (FRAMES / 2 - 1);
    line(0, 4_736, 0x8000u16.wrapping_add(swing as u16), 384)
}

/// A line from one distance to another, in 1/256 pixel, at an angle from the x axis.
fn line(from: i32, to: i32, angle: u16, width: u32) -> Result<SubLine, PrepareError> {
    SubLine::new(around(from, angle)?, around(to, angle)?, length(width))
}

/// A point around the gauge's centre.
fn around(distance: i32, angle: u16) -> Result<SubPoint<Sub8>, PrepareError> {
    let [[x, _, _], [y, _, _], _] = *Rotation::about_z(U0F16::from_bits(angle)).matrix();
    let along = |part: I2F30| ((i64::from(part.to_bits()) * i64::from(distance) + (1 << 29)) >> 30) as i32;
    SubPoint::from_units(GAUGE_CENTER.x * 256 + along(x), GAUGE_CENTER.y * 256 + along(y))
}

/// A length in 1/256 pixel.
fn length(units: u32) -> U24F8 {
    U24F8::from_bits(units)
}

/// The digits of a frame's number.
fn digits(frame: u32) -> [u8; 2] {
    [b'0' + (frame / 10) as u8, b'0' + (frame % 10) as u8]
}

/// The number of a frame, of its digits.
fn number(digits: &[u8; 2]) -> Text<'_, MonoTextStyle<'static, Gray4>> {
    let style = TextStyleBuilder::new()
        .alignment(Alignment::Center)
        .baseline(Baseline::Top)
        .build();
    let number = core::str::from_utf8(digits).unwrap_or_default();
    Text::with_text_style(number, GAUGE_CENTER + Point::new(0, 6), WHITE_TEXT, style)
}

/// The index of an ASCII character's glyph.
fn ascii_glyph(character: char) -> usize {
    (character as usize).wrapping_sub(' ' as usize)
}

#[cfg(test)]
mod tests {
    extern crate std;

    use core::convert::Infallible;
    use std::vec::Vec;

    use super::*;

    /// The words of a frame, drawn row by row.
    fn rows(prepared: &mut impl Prepared<Color = Gray4>) -> Vec<u8> {
        let (mut shown, mut row) = (Vec::new(), [0; AREA.size.width as usize]);
        let mut sink = |band: Band<'_, Gray4>| -> Result<(), Infallible> {
            shown.extend_from_slice(band.words());
            Ok(())
        };
        Oled::picture()
            .draw(&mut row, &mut sink, |band| prepared.draw(band))
            .unwrap();
        shown
    }

    #[test]
    fn a_picture_that_stays_shows_every_frame() {
        let (mut scene, mut animated) = (Oled::default(), Oled::default());
        let mut animation = animated.animation().unwrap();
        let mut most_edges = 0;
        // In order, across the end of the animation, and out of order.
        for frame in (0..FRAMES + 2).chain([40, 7, 7, u32::MAX]) {
            let expected = rows(&mut scene.prepare(frame).unwrap());
            let mut prepared = animation.prepare(frame).unwrap();
            assert!(rows(&mut prepared) == expected, "frame {frame}");
            // The pool has room for the needle and the one that it replaces.
            let used = prepared.capacities_used().unwrap();
            assert_eq!(
                used,
                PictureCapacities {
                    words: used.words,
                    edges: used.edges,
                    ..Oled::PICTURE.unwrap()
                }
            );
            most_edges = used.edges.max(most_edges);
        }
        assert_eq!(most_edges, CHAINS);
    }
}
