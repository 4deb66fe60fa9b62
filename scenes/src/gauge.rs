//! A gauge of 76 antialiased outlines as a picture: the memory that a program needs which draws it row by row.
//!
//! ```text
//!        . | | | .        71 ticks, every tenth of them longer
//!      .' \ | | / '.      2 arcs around them: the scale, and what of it is lit
//!     / -   \ | /  - \    1 needle
//!    |  -    (o)   -  |   2 discs of its hub
//!     \ -         -  /
//! ```

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use fixed::types::{U0F16, U24F8};
use zrow::{
    draw::{FillRule, ItemId, Picture, SubArc, SubEllipse, SubLine, SubOutline},
    geometry::{Sub8, SubPoint, Window},
};

use crate::{
    PrepareError,
    paint::rgb,
    picture_memory::PictureMemory,
    sine::{TURN, around_sub8, sine},
};

/// The pixels of the display.
pub const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(WIDTH as u32, 240));
/// The colour of the picture where no outline of the gauge covers it.
pub const BACKGROUND: Rgb565 = rgb(8, 11, 18);
/// Frames of the animation, which then begins anew.
pub const FRAMES: u32 = 64;

const UNLIT: Rgb565 = rgb(36, 45, 62);
const LIT: Rgb565 = rgb(64, 196, 255);
const TICK: Rgb565 = rgb(132, 148, 178);
const NEEDLE: Rgb565 = rgb(255, 82, 82);
const HUB: Rgb565 = rgb(70, 84, 112);

const WIDTH: usize = 240;
const CENTER: (i32, i32) = (120, 120);
/// The angle at which the scale begins, in 1/65,536 turn from the upper end on, clockwise.
const FIRST: u32 = 0x1_0000 * 5 / 8;
/// The angle of the whole scale: three quarters of a turn.
const SWEEP: u32 = 0x1_0000 * 3 / 4;
const TICKS: u32 = 71;

/// The outlines: ticks, two arcs, a needle and two discs.
const ITEMS: usize = TICKS as usize + 5;
/// Words of the pool: 942 of all outlines in any frame, and 26 for an arc that is compared with the one that it replaces.
const WORDS: usize = 968;
/// The most edges that one outline has in one row.
const SEGMENTS: usize = 10;
/// Chains of edges in one row, of all outlines together.
const CHAINS: usize = 30;

/// All memory of the gauge but for a row of colours and the rectangles of what changes.
#[derive(Debug, Default)]
pub struct Gauge(PictureMemory<Rgb565, ITEMS, WORDS, { AREA.size.height as usize }, { WIDTH + 1 }, SEGMENTS, CHAINS>);

impl Gauge {
    /// Memory without a picture.
    pub const fn new() -> Self {
        Self(PictureMemory::new())
    }

    /// The picture of a frame, which records what changes in these rectangles, and its items that change.
    ///
    /// # Errors
    /// [`PrepareError`] where an outline is out of its domain or memory is too small.
    pub fn prepare<'m>(
        &'m mut self,
        areas: &'m mut [Window],
        frame: u32,
    ) -> Result<(Picture<'m, 'static, Rgb565>, Changing), PrepareError> {
        let mut picture = self.0.picture(AREA).with_damage(areas, (1, 1));
        let (mut arc, mut needle) = (None, None);
        draw_outlines(frame, &mut |outline, color, part| {
            let id = picture.add_outline(outline, FillRule::NonZero, color)?;
            match part {
                Part::LitArc => arc = Some(id),
                Part::Needle => needle = Some(id),
                Part::Fixed => {}
            }
            Ok(())
        })?;
        Ok((picture, Changing { arc, needle }))
    }
}

/// The items of the gauge that show its value; every frame has both.
#[derive(Debug)]
pub struct Changing {
    arc: Option<ItemId>,
    needle: Option<ItemId>,
}

impl Changing {
    /// Moves the lit arc and the needle to where they are in another frame.
    ///
    /// # Errors
    /// [`PrepareError`] where the memory is too small.
    pub fn show(&self, picture: &mut Picture<'_, 'static, Rgb565>, frame: u32) -> Result<(), PrepareError> {
        if let Some(id) = self.arc {
            picture.replace_outline(id, &lit_arc(frame)?, FillRule::NonZero, LIT)?;
        }
        if let Some(id) = self.needle {
            picture.replace_outline(id, &[needle(frame)?.as_slice()], FillRule::NonZero, NEEDLE)?;
        }
        Ok(())
    }
}

/// The part of the gauge that an outline is.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
enum Part {
    /// The arc that shows the value.
    LitArc,
    Needle,
    /// Any other outline, which no frame changes.
    Fixed,
}

/// Takes an outline, its colour, and what part it is.
type Fill<'f> = dyn FnMut(&dyn SubOutline, Rgb565, Part) -> Result<(), PrepareError> + 'f;

/// Hands over all outlines of a frame, in the order in which they are drawn.
fn draw_outlines(frame: u32, fill: &mut Fill<'_>) -> Result<(), PrepareError> {
    fill(&arc(SWEEP)?, UNLIT, Part::Fixed)?;
    fill(&lit_arc(frame)?, LIT, Part::LitArc)?;
    for number in 0..TICKS {
        fill(&tick(number)?, TICK, Part::Fixed)?;
    }
    fill(&[needle(frame)?.as_slice()], NEEDLE, Part::Needle)?;
    let disc = |radius: u32| SubEllipse::circle(SubPoint::from_units(CENTER.0 * 256, CENTER.1 * 256)?, pixels(radius));
    fill(&disc(12)?, HUB, Part::Fixed)?;
    fill(&disc(4)?, NEEDLE, Part::Fixed)
}

/// The arc of the scale over an angle from its beginning.
fn arc(sweep: u32) -> Result<SubArc, PrepareError> {
    let center = SubPoint::<Sub8>::from_units(CENTER.0 * 256, CENTER.1 * 256)?;
    // Arcs count from the x axis.
    let start = U0F16::from_bits((FIRST - 0x4000) as u16);
    SubArc::new(
        center,
        [pixels(104), pixels(112)],
        start,
        U0F16::from_bits(sweep as u16),
    )
}

/// The arc that shows the value.
fn lit_arc(frame: u32) -> Result<SubArc, PrepareError> {
    arc(reach(frame))
}

/// The angle of the value, which swings over almost all of the scale, in 1/65,536 turn.
fn reach(frame: u32) -> u32 {
    let swing = (sine(frame % FRAMES * TURN / FRAMES) * 120) >> 14;
    SWEEP * (128 + swing) as u32 / 256
}

/// One of the ticks, with two ends on circles around the centre.
fn tick(number: u32) -> Result<SubLine, PrepareError> {
    let angle = FIRST + SWEEP * number / (TICKS - 1);
    let (inner, width) = if number.is_multiple_of(10) { (84, 3) } else { (94, 2) };
    SubLine::new(
        around_sub8(CENTER, inner * 256, angle)?,
        around_sub8(CENTER, 100 * 256, angle)?,
        pixels(width),
    )
}

/// The corners of the needle.
fn needle(frame: u32) -> Result<[SubPoint<Sub8>; 4], PrepareError> {
    let angle = FIRST + reach(frame);
    Ok([
        around_sub8(CENTER, 80 * 256, angle)?,
        around_sub8(CENTER, 5 * 256, angle + 0x4000)?,
        around_sub8(CENTER, 20 * 256, angle + 0x8000)?,
        around_sub8(CENTER, 5 * 256, angle + 0xc000)?,
    ])
}

fn pixels(number: u32) -> U24F8 {
    U24F8::from_bits(number << 8)
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::vec::Vec;

    use zrow::draw::AntialiasedPolygon;

    use super::*;
    use crate::{
        PictureCapacities, Prepared as _,
        shown::{Display, drawn},
    };

    /// The words of a frame whose outlines are drawn one by one, without a picture.
    fn drawn_directly(frame: u32) -> Vec<u16> {
        let mut outlines = Vec::new();
        draw_outlines(frame, &mut |outline, color, _| {
            let polygon = AntialiasedPolygon::<512, 16>::prepare(outline, FillRule::NonZero)?;
            let method = polygon.exact_method(outline);
            outlines.push((polygon, method, color));
            Ok(())
        })
        .unwrap();
        assert_eq!(outlines.len(), 76);
        let mut cells = [0; WIDTH + 1];
        drawn(AREA, BACKGROUND, 1, |band| {
            for (polygon, method, color) in &outlines {
                polygon.draw(method, *color, band, &mut cells).unwrap();
            }
        })
    }

    /// Slots, segments and chains are no more than the frames need, and words no more than with an arc that is replaced.
    #[test]
    fn the_memory_is_what_the_frames_need() {
        let mut gauge = Gauge::new();
        let used = (0..FRAMES).filter_map(|frame| {
            let (mut picture, _) = gauge.prepare(&mut [], frame).unwrap();
            drawn(AREA, BACKGROUND, 1, |band| picture.draw(band));
            picture.capacities_used()
        });
        let used = used.reduce(PictureCapacities::max).unwrap();
        let words = WORDS - 26;
        assert_eq!(
            (used.slots, used.words, used.segments, used.edges),
            (ITEMS, words, SEGMENTS, CHAINS)
        );
    }

    #[test]
    fn the_picture_shows_what_is_drawn_without_one() {
        let mut gauge = Gauge::new();
        for frame in 0..FRAMES {
            let expected = drawn_directly(frame);
            for rows in [1, 7] {
                let (mut picture, _) = gauge.prepare(&mut [], frame).unwrap();
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
        let (mut gauge, mut areas) = (Gauge::new(), [Window::EMPTY; 16]);
        let (mut picture, changing) = gauge.prepare(&mut areas, 0).unwrap();
        let mut display = Display::new(AREA, BACKGROUND);
        for frame in 0..FRAMES {
            changing.show(&mut picture, frame).unwrap();
            let sent = display.send_changes(&mut picture);
            assert!(drawn_directly(frame) == display.words(), "frame {frame}");
            // The first frame is drawn whole.
            assert!(frame == 0 || sent <= 2_341, "frame {frame} sends {sent} pixels");
        }
    }
}
