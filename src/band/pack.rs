//! Packs the words of a band into the bytes that a display takes.

use core::cell::Cell;

use bytemuck::{cast_slice_mut, try_cast_slice_mut};
use embedded_graphics::pixelcolor::{PixelColor, raw::RawData};

use crate::{
    band::Band,
    geometry::HAS_DIVIDER,
    surface::{BandColor, Order, PixelWord},
};

impl<'a, C: BandColor, O: Order> Band<'a, C, O> {
    /// The band as bytes for the display, packed in place: the words are used up.
    ///
    /// - colours below 8 bits: several pixels a byte, the first in the highest bits, each row from a new byte;
    /// - 8 bits: as they are;
    /// - 16 bits: big-endian; only a cast in a band of [`BigEndian`](crate::surface::BigEndian) order;
    /// - 18 and 24 bits: three bytes a pixel, one a channel; six bits lie at the top of their byte;
    /// - 32 bits, in colours that are not embedded-graphics' own: big-endian.
    pub fn into_bytes(self) -> &'a [u8] {
        let bits = <C as PixelColor>::Raw::BITS_PER_PIXEL;
        for word in self.words.iter_mut() {
            // Back to the machine's order and on to big-endian: the compiler drops the loop where that changes nothing.
            *word = O::reorder(*word).to_big_endian();
        }
        let bytes: &mut [u8] = cast_slice_mut(self.words);
        match bits {
            0..8 => pack_bits(bytes, self.stride, bits),
            17..=24 => drop_first_of_four(bytes),
            _ => bytes,
        }
    }
}

/// Packs several pixels into a byte: the first one into the highest bits, each row of `width` pixels from a new byte on.
fn pack_bits(bytes: &mut [u8], width: usize, bits: usize) -> &[u8] {
    // Written and read at once: a packed row is never longer than the row, so a byte is read before it is written.
    let packed_length = match bits {
        1 => pack_rows::<8>(cells(bytes), width),
        2 => pack_rows::<4>(cells(bytes), width),
        // Smaller processors load pixel by pixel anyway. The cast does not fail: rows of whole eights are whole fours.
        _ if HAS_DIVIDER && width.is_multiple_of(8) => try_cast_slice_mut(bytes).map_or(0, pack_eights),
        _ => pack_rows::<2>(cells(bytes), width),
    };
    bytes.get(..packed_length).unwrap_or(&[])
}

/// Bytes that are written while others of them are read.
fn cells(bytes: &mut [u8]) -> &[Cell<u8>] {
    Cell::from_mut(bytes).as_slice_of_cells()
}

/// Packs `PER_BYTE` pixels into a byte, at the begin of the same memory. Returns how many bytes that are.
fn pack_rows<const PER_BYTE: usize>(pixels: &[Cell<u8>], width: usize) -> usize {
    let bits = u8::BITS as usize / PER_BYTE;
    let mask = u8::MAX >> (u8::BITS as usize - bits);
    let pack = |group: &[Cell<u8>]| {
        let pixels = group.iter().map(|pixel| pixel.get() & mask);
        pixels.fold(0, |packed: u8, pixel| packed << bits | pixel)
    };
    let mut packed = pixels.iter();
    for row in pixels.chunks_exact(width.max(1)) {
        let groups = row.chunks_exact(PER_BYTE);
        let rest = groups.remainder();
        for (group, byte) in groups.zip(&mut packed) {
            byte.set(pack(group));
        }
        if !rest.is_empty() {
            if let Some(byte) = packed.next() {
                // The pixels that the last byte of a row lacks are 0.
                byte.set(pack(rest) << ((PER_BYTE - rest.len()) * bits));
            }
        }
    }
    pixels.len() - packed.len()
}

/// Packs pixels of 4 bits, eight into four bytes at once; rows are whole eights. Returns how many bytes that are.
// Not inlined: where a buffer's address is a constant on a large stack frame, the loop is unrolled, and each store computes it.
#[inline(never)]
fn pack_eights(pixels: &mut [[u8; 4]]) -> usize {
    let fours = Cell::from_mut(pixels).as_slice_of_cells();
    for (eight, packed) in fours.chunks_exact(2).zip(fours) {
        if let [left, right] = eight {
            let [left, right] = [left, right].map(|four| pairs(four.get()));
            packed.set([left as u8, (left >> 16) as u8, right as u8, (right >> 16) as u8]);
        }
    }
    fours.len() * 2
}

/// Packs four pixels of 4 bits: the first two into the lowest byte, the others into the third.
#[inline(always)]
const fn pairs(four: [u8; 4]) -> u32 {
    let four = u32::from_le_bytes(four) & 0x0f0f_0f0f;
    four << 4 | four >> 8
}

/// Packs words of four bytes into three bytes a pixel: the first byte of each word is left out.
fn drop_first_of_four(bytes: &mut [u8]) -> &[u8] {
    let packed_length = bytes.len() / 4 * 3;
    let cells = cells(bytes);
    for (pixel, packed) in cells.chunks_exact(4).zip(cells.chunks_exact(3)) {
        for (kept, byte) in pixel.iter().skip(1).zip(packed) {
            byte.set(kept.get());
        }
    }
    bytes.get(..packed_length).unwrap_or(&[])
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::vec::Vec;

    use super::*;
    use crate::surface::{BigEndian, LittleEndian};
    use embedded_graphics::{
        pixelcolor::{Bgr666, BinaryColor, Gray4, Rgb565, Rgb666, Rgb888},
        prelude::*,
        primitives::Rectangle,
    };

    fn area(width: u32, height: u32) -> Rectangle {
        Rectangle::new(Point::new(0, 0), Size::new(width, height))
    }

    #[test]
    fn both_orders_give_big_endian_bytes() {
        let mut words = [0u16; 2];
        let mut band = Band::<Rgb565, LittleEndian>::new(area(2, 1), &mut words).unwrap();
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

    /// Rows of whole eights are packed in a way of their own, also where words have bits that no grey has.
    #[test]
    fn grey4_is_packed_in_pairs_at_any_width() {
        for (width, height) in (1..40).flat_map(|width| (1..4).map(move |height| (width, height))) {
            let mut words: Vec<u8> = (0..width * height).map(|index| (index * 73 + 41) as u8).collect();
            let grey = |x: u32, y: u32| {
                if x < width {
                    words[(y * width + x) as usize] & 15
                } else {
                    0
                }
            };
            let pairs = (0..height).flat_map(|y| (0..width).step_by(2).map(move |x| (x, y)));
            let expected: Vec<u8> = pairs.map(|(x, y)| grey(x, y) << 4 | grey(x + 1, y)).collect();
            let band = Band::<Gray4>::new(area(width, height), &mut words).unwrap();
            assert_eq!(band.into_bytes(), expected, "{width} x {height}");
        }
    }

    #[test]
    fn six_bits_lie_at_the_top_of_their_byte() {
        let mut words = [0u32; 2];
        let colors = [Rgb666::new(1, 32, 63), Rgb666::new(63, 2, 0)];
        let mut band = Band::<Rgb666, BigEndian>::new(area(2, 1), &mut words).unwrap();
        let Ok(()) = band.fill_contiguous(&area(2, 1), colors);
        assert!(band.colors().eq(colors));
        assert_eq!(band.into_bytes(), [4, 128, 252, 252, 8, 0]);
        let mut band = Band::<Bgr666>::new(area(1, 1), &mut words).unwrap();
        band.fill(Bgr666::new(1, 2, 3));
        assert_eq!(band.into_bytes(), [12, 8, 4]);
    }

    #[test]
    fn true_colour_takes_three_bytes() {
        let mut words = [0u32; 2];
        let mut band = Band::<Rgb888>::new(area(2, 1), &mut words).unwrap();
        band.fill(Rgb888::new(1, 2, 3));
        assert_eq!(band.into_bytes(), [1, 2, 3, 1, 2, 3]);
    }
}
