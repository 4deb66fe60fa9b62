//! A display that shows pictures: in bands of any heights, or only what has changed in them.

use embedded_graphics::{prelude::*, primitives::Rectangle};
use zrow::{
    band::{Band, BandColor},
    draw::Picture,
};

/// What a picture shows in an area over a colour, in bands of these heights, from the top down, again and again.
pub fn in_bands_over<C: BandColor>(
    background: C,
    picture: &mut Picture<'_, '_, C>,
    area: Rectangle,
    heights: &[u32],
) -> Vec<C::Word> {
    let mut words = vec![background.to_word(); (area.size.width * area.size.height) as usize];
    let mut rest = words.as_mut_slice();
    let mut y = 0;
    for height in heights.iter().cycle() {
        let size = Size::new(area.size.width, (*height).min(area.size.height - y));
        if size.height == 0 {
            break;
        }
        let (here, below) = rest.split_at_mut((size.width * size.height) as usize);
        let top_left = area.top_left + Point::new(0, y as i32);
        picture.draw(&mut Band::new(Rectangle::new(top_left, size), here).unwrap());
        rest = below;
        y += size.height;
    }
    words
}

/// What a picture shows in an area over black, in bands of these heights.
pub fn in_bands<C: BandColor + RgbColor>(
    picture: &mut Picture<'_, '_, C>,
    area: Rectangle,
    heights: &[u32],
) -> Vec<C::Word> {
    in_bands_over(C::BLACK, picture, area, heights)
}

/// A display whose pixels stay until they are drawn again.
pub struct Display<C: BandColor> {
    pub area: Rectangle,
    /// What is behind the items of a picture.
    pub background: C,
    /// The sides of what has changed are multiples of these columns and rows, and so may lie outside of the area; 1 and 0 are any.
    pub grid: (u32, u32),
    pub words: Vec<C::Word>,
}

impl<C: BandColor + RgbColor> Display<C> {
    /// A black display, for pictures whose changes have sides anywhere.
    pub fn new(area: Rectangle) -> Self {
        Self {
            area,
            background: C::BLACK,
            grid: (1, 1),
            words: vec![C::BLACK.to_word(); (area.size.width * area.size.height) as usize],
        }
    }
}

impl<C: BandColor> Display<C> {
    /// Draws the rectangles that have changed in a picture, in bands of these heights, and takes no pixel twice.
    pub fn draw_damage(&mut self, picture: &mut Picture<'_, '_, C>, heights: &[u32]) {
        let mut drawn = vec![false; self.words.len()];
        while let Some(damage) = picture.next_damage() {
            let area = damage.intersection(&self.area);
            assert!(area == damage || self.is_aligned(), "{damage:?} is not on the display");
            let words = in_bands_over(self.background, picture, area, heights);
            for (point, word) in area.points().zip(words) {
                let Point { x, y } = point - self.area.top_left;
                let index = y as usize * self.area.size.width as usize + x as usize;
                assert!(!drawn[index], "{point} was drawn twice");
                (self.words[index], drawn[index]) = (word, true);
            }
        }
    }

    fn is_aligned(&self) -> bool {
        self.grid.0 > 1 || self.grid.1 > 1
    }
}
