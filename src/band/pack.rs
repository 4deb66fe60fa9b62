//! Packs the words of a band into the bytes that a display takes.

use bytemuck::cast_slice_mut;
use embedded_graphics::{pixelcolor::PixelColor, pixelcolor::raw::RawData};

use crate::{
    band::Band,
    target::{BandColor, Order},
};

impl<'a, C: BandColor, O: Order> Band<'a, C, O> {
    /// The band as bytes for the display, packed in place: the words are used up.
    ///
    /// - colours below 8 bits: several pixels a byte, the first in the highest bits, each row from a new byte;
    /// - 8 bits: as they are;
    /// - 16 bits: big-endian; only a cast in a band of [`BigEndian`](crate::target::BigEndian) order;
    /// - 18 and 24 bits: three bytes a pixel, the lowest 24 bits of the word, big-endian.
    pub fn into_bytes(self) -> &'a [u8] {
        let bits = <C as PixelColor>::Raw::BITS_PER_PIXEL;
        let words = self.words;
        if bits > 8 {
            for word in words.iter_mut() {
                *word = to_big_endian::<C, O>(*word);
            }
        }
        let bytes: &mut [u8] = cast_slice_mut(words);
        match bits {
            0..8 => pack_bits(bytes, self.stride, bits),
            17.. => drop_first_of_four(bytes),
            _ => bytes,
        }
    }
}

/// What is stored big-endian stays; the rest is swapped.
fn to_big_endian<C: BandColor, O: Order>(word: C::Word) -> C::Word {
    use crate::target::{BigEndian, PixelWord};
    if core::any::TypeId::of::<O>() == core::any::TypeId::of::<BigEndian>() {
        word
    } else {
        word.swapped_to_big_endian()
    }
}

/// Several pixels a byte, first pixel in the highest bits, each row of `width` pixels from a new byte.
fn pack_bits(bytes: &mut [u8], width: usize, bits: usize) -> &[u8] {
    let per_byte = 8 / bits.max(1);
    let packed_width = width.div_ceil(per_byte);
    let rows = bytes.len().checked_div(width).unwrap_or(0);
    for row in 0..rows {
        for packed in 0..packed_width {
            let first = row * width + packed * per_byte;
            let in_row = per_byte.min(width - packed * per_byte);
            let byte = (0..in_row).fold(0u8, |byte, pixel| {
                let value = bytes.get(first + pixel).copied().unwrap_or(0);
                byte | value << (8 - bits - pixel * bits)
            });
            // Never beyond what is read next: a packed row is not longer than the row.
            if let Some(place) = bytes.get_mut(row * packed_width + packed) {
                *place = byte;
            }
        }
    }
    bytes.get(..rows * packed_width).unwrap_or(&[])
}

/// Three bytes a pixel out of four.
fn drop_first_of_four(bytes: &mut [u8]) -> &[u8] {
    let pixels = bytes.len() / 4;
    for pixel in 0..pixels {
        bytes.copy_within(pixel * 4 + 1..pixel * 4 + 4, pixel * 3);
    }
    bytes.get(..pixels * 3).unwrap_or(&[])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::target::{BigEndian, Native};
    use embedded_graphics::{
        pixelcolor::{BinaryColor, Gray4, Rgb565, Rgb888},
        prelude::*,
        primitives::Rectangle,
    };

    fn area(width: u32, height: u32) -> Rectangle {
        Rectangle::new(Point::new(0, 0), Size::new(width, height))
    }

    #[test]
    fn both_orders_give_big_endian_bytes() {
        let mut words = [0u16; 2];
        let mut band = Band::<Rgb565, Native>::new(area(2, 1), &mut words).unwrap();
        band.fill(Rgb565::new(1, 2, 3));
        let expected = Rgb565::new(1, 2, 3).to_be_bytes().repeat(2);
        assert_eq!(band.into_bytes(), expected);
        let mut band = Band::<Rgb565, BigEndian>::new(area(2, 1), &mut words).unwrap();
        band.fill(Rgb565::new(1, 2, 3));
        assert_eq!(band.into_bytes(), expected);
    }

    #[test]
    fn grey4_and_binary_rows_start_at_a_byte() {
        let mut words = [1u8, 2, 3, 4, 5, 6];
        let band = Band::<Gray4>::new(area(3, 2), &mut words).unwrap();
        assert_eq!(band.into_bytes(), [0x12, 0x30, 0x45, 0x60]);
        let mut words = [1u8, 0, 1, 1, 0, 0, 0, 0, 1, 0, 1];
        let band = Band::<BinaryColor>::new(area(11, 1), &mut words).unwrap();
        assert_eq!(band.into_bytes(), [0b1011_0000, 0b1010_0000]);
    }

    #[test]
    fn true_colour_takes_three_bytes() {
        let mut words = [0u32; 2];
        let mut band = Band::<Rgb888>::new(area(2, 1), &mut words).unwrap();
        band.fill(Rgb888::new(1, 2, 3));
        assert_eq!(band.into_bytes(), [1, 2, 3, 1, 2, 3]);
    }
}
