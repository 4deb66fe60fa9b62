//! A colour blended into the rows of a band: the words of a row are found once, and its pixels are taken one by one.

use core::{convert::Infallible, marker::PhantomData, ops::Range};

use embedded_graphics::geometry::Point;

use crate::{
    band::Band,
    coverage::{Coverage, Emit, EmitRows},
    geometry::offset_from,
    shade::{ChannelColor, TransferFunction},
    surface::{Order, PixelWord},
};

/// Blends a colour into the rows of a band.
#[derive(Debug)]
pub struct BandBlender<'b, C: ChannelColor, O: Order, T> {
    words: &'b mut [C::Word],
    left: i32,
    top: i32,
    stride: usize,
    color: C,
    how: PhantomData<(O, T)>,
}

impl<'b, C: ChannelColor, O: Order, T: TransferFunction> BandBlender<'b, C, O, T> {
    #[inline(always)]
    pub(super) fn new(band: &'b mut Band<'_, C, O>, color: C) -> Self {
        Self {
            left: band.window.left,
            top: band.window.top,
            stride: band.stride,
            words: band.words,
            color,
            how: PhantomData,
        }
    }
}

impl<C: ChannelColor, O: Order, T: TransferFunction> EmitRows<Infallible> for BandBlender<'_, C, O, T> {
    type Row<'r>
        = RowBlender<'r, C, O, T>
    where
        Self: 'r;

    #[inline(always)]
    fn row(&mut self, y: i32) -> RowBlender<'_, C, O, T> {
        // Below the height, so the product is at most the number of words.
        let start = offset_from(self.top, y) as usize * self.stride;
        let rest = self.words.get_mut(start..).unwrap_or_default();
        RowBlender {
            words: rest.get_mut(..self.stride).unwrap_or_default(),
            left: self.left,
            color: self.color,
            y,
            how: PhantomData,
        }
    }
}

/// Blends a colour into a row of a band.
#[derive(Debug)]
pub struct RowBlender<'b, C: ChannelColor, O: Order, T> {
    words: &'b mut [C::Word],
    left: i32,
    color: C,
    y: i32,
    how: PhantomData<(O, T)>,
}

impl<C: ChannelColor, O: Order, T: TransferFunction> Emit<Infallible> for RowBlender<'_, C, O, T> {
    // Not inlined: a coverage method emits in several places, and keeps its registers across the call.
    #[inline(never)]
    fn pixel(&mut self, x: i32, coverage: Coverage) -> Result<(), Infallible> {
        if let Some(word) = self.words.get_mut(offset_from(self.left, x) as usize) {
            let word = core::slice::from_mut(word);
            C::blend_run::<T, O>(word, Point::new(x, self.y), self.color, coverage);
        }
        Ok(())
    }

    #[inline(never)]
    fn two_pixels(&mut self, columns: [i32; 2], coverage: Coverage) -> Result<(), Infallible> {
        for x in columns {
            if let Some(word) = self.words.get_mut(offset_from(self.left, x) as usize) {
                let word = core::slice::from_mut(word);
                C::blend_run::<T, O>(word, Point::new(x, self.y), self.color, coverage);
            }
        }
        Ok(())
    }

    #[inline(never)]
    fn between(&mut self, columns: Range<i32>, first: Coverage, last: Coverage) -> Result<(), Infallible> {
        let [start, end] = [columns.start, columns.end].map(|x| offset_from(self.left, x) as usize);
        if let Some([left, inside @ .., right]) = self.words.get_mut(start..end) {
            for (word, x, coverage) in [(left, columns.start, first), (right, columns.end - 1, last)] {
                if coverage != 0 {
                    C::blend_run::<T, O>(core::slice::from_mut(word), Point::new(x, self.y), self.color, coverage);
                }
            }
            C::Word::fill(inside, O::reorder(self.color.to_word()));
        }
        Ok(())
    }

    #[inline(never)]
    fn span(&mut self, columns: Range<i32>, coverage: Coverage) -> Result<(), Infallible> {
        let [start, end] = [columns.start, columns.end].map(|x| offset_from(self.left, x) as usize);
        if let Some(words) = self.words.get_mut(start..end) {
            if coverage == Coverage::MAX {
                C::Word::fill(words, O::reorder(self.color.to_word()));
            } else {
                let position = Point::new(columns.start, self.y);
                blend_run::<C, O, T>(words, position, self.color, coverage);
            }
        }
        Ok(())
    }
}

/// Blends a colour over a run of words, the first of which stands for the pixel at `position`.
// Not inlined: most spans are the inside of a shape and only filled, which takes fewer registers.
#[inline(never)]
fn blend_run<C: ChannelColor, O: Order, T: TransferFunction>(
    words: &mut [C::Word],
    position: Point,
    color: C,
    coverage: Coverage,
) {
    C::blend_run::<T, O>(words, position, color, coverage);
}

#[cfg(feature = "defmt")]
impl<C: ChannelColor, O: Order, T> defmt::Format for BandBlender<'_, C, O, T> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "BandBlender, {} words", self.words.len());
    }
}

#[cfg(feature = "defmt")]
impl<C: ChannelColor, O: Order, T> defmt::Format for RowBlender<'_, C, O, T> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "RowBlender of row {}, {} words", self.y, self.words.len());
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::vec::Vec;

    use embedded_graphics::{
        geometry::Size,
        pixelcolor::{BinaryColor, Gray4, Rgb565, Rgb888, RgbColor},
        primitives::Rectangle,
    };

    use super::*;
    use crate::{
        shade::{BatchBlend, BlendTarget},
        surface::{BigEndian, LittleEndian, Span},
    };

    /// A band of three rows in colours of its own.
    fn words<C: ChannelColor>() -> Vec<C::Word> {
        (0..3 * 9u32)
            .map(|index| C::Word::from_repeated(index * 0x0523_4567))
            .collect()
    }

    /// Blends a colour into some columns of a row of a band, as a span of the band, as a span of the row and pixel by pixel: all
    /// three give the same words, also where columns lie outside of the band.
    fn check<C: ChannelColor + core::fmt::Debug, O: Order>(color: C, columns: Range<i32>, coverage: Coverage) {
        let area = Rectangle::new(Point::new(-3, 5), Size::new(9, 3));
        let (mut by_span, mut by_row, mut by_pixel) = (words::<C>(), words::<C>(), words::<C>());
        let mut band = Band::<C, O>::new(area, &mut by_span).unwrap();
        let Ok(()) = band.blend_span(Span::new(6, columns.start, columns.end), color, coverage);
        let mut band = Band::<C, O>::new(area, &mut by_row).unwrap();
        let visible = columns.start.max(-3)..columns.end.min(6);
        let Ok(()) = band.blender(color).row(6).span(visible, coverage);
        let mut band = Band::<C, O>::new(area, &mut by_pixel).unwrap();
        for x in columns.clone() {
            let Ok(()) = band.blender(color).row(6).pixel(x, coverage);
        }
        assert!(by_span == by_row, "{columns:?} to {coverage} of {color:?}");
        assert!(
            by_span == by_pixel,
            "{columns:?} to {coverage} of {color:?}, pixel by pixel"
        );
    }

    #[test]
    fn a_row_is_blended_as_a_span_of_the_band() {
        // Pixels without coverage are not handed over.
        for coverage in 1..=255 {
            for columns in [-3..6, 0..1, 2..5, 5..6] {
                check::<_, LittleEndian>(Rgb565::new(3, 60, 17), columns.clone(), coverage);
                check::<_, BigEndian>(Rgb565::new(30, 1, 9), columns.clone(), coverage);
                check::<_, LittleEndian>(Gray4::new(11), columns.clone(), coverage);
                check::<_, LittleEndian>(Rgb888::CYAN, columns.clone(), coverage);
                check::<_, LittleEndian>(BinaryColor::On, columns, coverage);
            }
        }
    }

    /// Pixels between two edges are the same drawn together, and as a pixel, a span and a pixel.
    fn check_between<C: ChannelColor + core::fmt::Debug, O: Order>(
        color: C,
        columns: Range<i32>,
        [first, last]: [Coverage; 2],
    ) {
        let area = Rectangle::new(Point::new(-3, 5), Size::new(9, 3));
        let (mut at_once, mut one_by_one) = (words::<C>(), words::<C>());
        let mut band = Band::<C, O>::new(area, &mut at_once).unwrap();
        let Ok(()) = band.blender(color).row(6).between(columns.clone(), first, last);
        let mut band = Band::<C, O>::new(area, &mut one_by_one).unwrap();
        let mut blender = band.blender(color);
        for x in columns.clone() {
            let coverage = match x {
                _ if x == columns.start => first,
                _ if x == columns.end - 1 => last,
                _ => Coverage::MAX,
            };
            if coverage > 0 {
                let Ok(()) = blender.row(6).pixel(x, coverage);
            }
        }
        assert!(at_once == one_by_one, "{columns:?}, {first} to {last} of {color:?}");
    }

    #[test]
    fn pixels_between_two_edges_are_blended_together() {
        for coverages in [[0, 0], [0, 255], [1, 0], [255, 7], [99, 200], [255, 255]] {
            for columns in [-3..6, 0..2, 2..5, -3..-1] {
                check_between::<_, LittleEndian>(Rgb565::new(3, 60, 17), columns.clone(), coverages);
                check_between::<_, BigEndian>(Rgb565::new(30, 1, 9), columns.clone(), coverages);
                check_between::<_, LittleEndian>(Gray4::new(11), columns.clone(), coverages);
                check_between::<_, LittleEndian>(BinaryColor::On, columns, coverages);
            }
        }
    }

    #[test]
    fn pixels_outside_of_the_row_are_not_drawn() {
        check::<_, LittleEndian>(Rgb565::RED, -9..12, 200);
        check::<_, LittleEndian>(Rgb565::RED, i32::MAX - 3..i32::MAX, 255);
        check::<_, LittleEndian>(Rgb565::RED, i32::MIN..i32::MIN + 3, 1);
    }
}
