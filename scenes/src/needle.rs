//! The gauge of the README's first program as a scene: a disc, a needle 5 pixels wide, and a text of 7 characters.

use embedded_graphics::{
    mono_font::{MonoTextStyle, ascii::FONT_10X20},
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Circle, Line, Rectangle},
    text::Text,
};
use zrow::draw::{Picture, PictureSlot, PrimitiveStyle};

use crate::{
    PrepareError, Scene,
    sine::{TURN, around, sine},
};

const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(240, 240));
const CENTER: Point = Point::new(120, 120);
const FRAMES: u32 = 64;
/// In pixels, from the centre to the tip.
const NEEDLE_LENGTH: i32 = 96;

/// All memory of the gauge but for a row of colours: 3 items of a picture, 20 words for what they need, a bucket a row.
#[derive(Debug)]
pub struct Needle {
    slots: [PictureSlot<'static, Rgb565>; 3],
    pool: [u32; 20],
    buckets: [u16; AREA.size.height as usize],
}

impl Default for Needle {
    fn default() -> Self {
        Self {
            slots: [PictureSlot::EMPTY; 3],
            pool: [0; 20],
            buckets: [0; AREA.size.height as usize],
        }
    }
}

impl Scene for Needle {
    type Color = Rgb565;
    type Prepared<'s> = Picture<'s, 'static, Rgb565>;
    const NAME: &'static str = "gauge";
    const TITLE: &'static str = "the README's gauge";
    const AREA: Rectangle = AREA;
    const BACKGROUND: Rgb565 = Rgb565::BLACK;
    const FRAMES: u32 = FRAMES;

    fn prepare(&mut self, frame: u32) -> Result<Picture<'_, 'static, Rgb565>, PrepareError> {
        let mut picture = Picture::new(AREA, &mut self.slots, &mut self.pool, &mut self.buckets);
        let disc = PrimitiveStyle::with_fill(Rgb565::CSS_DARK_SLATE_GRAY);
        picture.add(&Circle::with_center(CENTER, 201).into_styled(disc))?;
        let needle = PrimitiveStyle::with_stroke(Rgb565::RED, 5);
        picture.add(&Line::new(CENTER, tip(frame)).into_styled(needle))?;
        let white = MonoTextStyle::new(&FONT_10X20, Rgb565::WHITE);
        picture.add(&Text::new("42 km/h", Point::new(85, 180), white))?;
        Ok(picture)
    }
}

/// The tip of the gauge's needle in a frame. The needle swings from upright by 3/8 of a turn to both sides.
fn tip(frame: u32) -> Point {
    let swing = (sine(frame % FRAMES * TURN / FRAMES) * (TURN as i32 * 3 / 8)) >> 14;
    around(CENTER, NEEDLE_LENGTH, (TURN as i32 + swing) as u32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Prepared as _, shown::drawn};

    /// Every frame finds room for its items, and is drawn the same in bands of any height.
    #[test]
    fn the_memory_is_enough_for_every_frame() {
        let mut needle = Needle::default();
        for frame in 0..FRAMES {
            let [one, seven] = [1, 7].map(|rows| {
                let mut picture = needle.prepare(frame).unwrap();
                drawn(AREA, Needle::BACKGROUND, rows, |band| Picture::draw(&mut picture, band))
            });
            assert!(one == seven, "frame {frame}");
            let used = needle.prepare(frame).unwrap().capacities_used().unwrap();
            assert_eq!(used.slots, 3);
        }
    }
}
