//! An instrument panel of antialiased shapes, a [`Picture`], and its twin without antialiasing: the same outlines in another
//! method.

mod outlines;
mod replayed;

use embedded_graphics::{pixelcolor::Rgb565, primitives::Rectangle};
use zrow::{
    draw::{FillRule, ItemId, Picture},
    geometry::Window,
};

use crate::{PictureCapacities, PrepareError, Scene, picture_memory::PictureMemory};
use outlines::{
    ACCENT, AREA, BACKGROUND, FRAMES, NEEDLE, PORTRAIT, Part, WIDTH, digits, draw_outlines, lit_arc, needle, rule,
    texts,
};

pub use replayed::{Jagged, Look, Replayed, Smooth};

/// Items of the panel: 21 outlines, 6 texts and a line.
const ITEMS: usize = 28;
/// Words of its pool: those of the outlines, and for each text one a character and one more; 512 in any frame, and 26 for an
/// arc that is compared with the one that it replaces.
const WORDS: usize = 538;
/// The most edges that one outline has in one row.
const SEGMENTS: usize = 23;
/// Chains of edges in one row, of all outlines together.
const CHAINS: usize = 22;

/// The rectangles of what changes that a board lends which draws nothing else.
pub const DAMAGE_AREAS: usize = 16;

type Memory = PictureMemory<Rgb565, ITEMS, WORDS, 320, { WIDTH + 1 }, SEGMENTS, CHAINS>;

/// All memory of the panel: a picture.
#[derive(Debug, Default)]
pub struct Instruments(Memory);

impl Instruments {
    /// Memory without a picture.
    pub const fn new() -> Self {
        Self(PictureMemory::new())
    }

    /// A picture without items, which tells what changes in it from then on.
    pub fn picture_with_damage<'m>(&'m mut self, areas: &'m mut [Window]) -> Picture<'m, 'static, Rgb565> {
        self.0.picture(AREA).with_damage(areas, (1, 1))
    }
}

impl Scene for Instruments {
    type Color = Rgb565;
    type Prepared<'s> = Picture<'s, 'static, Rgb565>;
    const NAME: &'static str = "instruments";
    const TITLE: &'static str = "instruments";
    const AREA: Rectangle = AREA;
    const BACKGROUND: Rgb565 = BACKGROUND;
    const FRAMES: u32 = FRAMES;
    const PORTRAIT: u32 = PORTRAIT;
    const PICTURE: Option<PictureCapacities> = Some(Memory::capacities(DAMAGE_AREAS));

    fn prepare(&mut self, frame: u32) -> Result<Picture<'_, 'static, Rgb565>, PrepareError> {
        let mut picture = self.0.picture(AREA);
        Changing::add(&mut picture, frame)?;
        Ok(picture)
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
    /// Adds everything to a picture, in the order in which it is drawn without one, as it is in a frame.
    ///
    /// # Errors
    /// [`PrepareError`] where an outline is out of its domain or memory is too small.
    pub fn add(picture: &mut Picture<'_, 'static, Rgb565>, frame: u32) -> Result<Self, PrepareError> {
        let frame = frame % FRAMES;
        let (arc, needle) = add_outlines(picture, frame)?;
        let digits = add_texts(picture, frame)?;
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
    // Not inlined: what it needs is not on the stack of a caller that draws as well.
    #[inline(never)]
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

/// Adds all outlines, and returns the lit arc and the needle.
// Not inlined, and neither is adding texts: the stack holds the corners of the outlines or the texts.
#[inline(never)]
fn add_outlines(
    picture: &mut Picture<'_, 'static, Rgb565>,
    frame: u32,
) -> Result<(Option<ItemId>, Option<ItemId>), PrepareError> {
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
    Ok((arc, needle))
}

/// Adds all texts, and returns the digits of the speed.
#[inline(never)]
fn add_texts(picture: &mut Picture<'_, 'static, Rgb565>, frame: u32) -> Result<ItemId, PrepareError> {
    let digits = digits(frame);
    let [value, names @ ..] = texts(&digits);
    let digits = picture.add(&value)?;
    for text in names {
        picture.add(&text)?;
    }
    Ok(digits)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        Prepared as _,
        shown::{Display, drawn},
    };

    #[test]
    fn the_picture_shows_what_is_drawn_without_one() {
        let (mut scene, mut panel) = (Replayed::<Smooth>::default(), Instruments::new());
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
        let (mut panel, mut whole, mut areas) = (Instruments::new(), Instruments::new(), [Window::EMPTY; DAMAGE_AREAS]);
        let mut picture = panel.picture_with_damage(&mut areas);
        let changing = Changing::add(&mut picture, 0).unwrap();
        let mut display = Display::new(AREA, BACKGROUND);
        for frame in 0..FRAMES {
            changing.show(&mut picture, frame).unwrap();
            let sent = display.send_changes(&mut picture);
            let mut expected = whole.picture_with_damage(&mut []);
            let changing = Changing::add(&mut expected, 0).unwrap();
            changing.show(&mut expected, frame).unwrap();
            let expected = drawn(AREA, BACKGROUND, 1, |band| expected.draw(band));
            assert!(expected == display.words(), "frame {frame}");
            // The first frame is drawn whole.
            assert!(frame == 0 || sent <= 2_392, "frame {frame} sends {sent} pixels");
        }
    }
}
