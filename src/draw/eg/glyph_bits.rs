//! The pixels of a glyph, as bits of a font's image.

use embedded_graphics::{
    geometry::{OriginDimensions, Point},
    image::{GetPixel, ImageRaw},
    mono_font::MonoFont,
    pixelcolor::BinaryColor,
};

/// The number of columns that are read from a glyph at once: a 32-bit word that begins at any bit of its first byte has
/// at least 25 bits left, of which 24 are used.
pub(in crate::draw) const COLUMNS: i64 = 24;

/// Bits from a row of a font's image to the next one: the columns, rounded up to whole bytes. Rounded down where that is no 32-bit
/// number, as in no font: a single row of its image would take 2^29 bytes.
#[inline]
pub(in crate::draw) fn bits_per_row(font: &MonoFont<'_>) -> u32 {
    font.image.size().width.saturating_add(7) & !7
}

/// The bits of an image from index `bit` on, the first one in the highest bit of the result. At least [`COLUMNS`] of
/// them are valid; bits beyond the last byte are 0.
#[inline]
pub(in crate::draw) fn bits_from(bytes: &[u8], bit: usize) -> u32 {
    let byte = bit / 8;
    let word = match bytes.get(byte..byte + 4) {
        Some(&[a, b, c, d]) => u32::from_be_bytes([a, b, c, d]),
        _ => last_bits(bytes, byte),
    };
    word << (bit % 8)
}

/// The bits of up to three bytes at the end of an image, the first one in the highest bit of the result.
#[cold]
fn last_bits(bytes: &[u8], byte: usize) -> u32 {
    let rest = bytes.get(byte..).unwrap_or_default();
    rest.iter()
        .rev()
        .fold(0, |word, &byte| word >> 8 | u32::from(byte) << 24)
}

/// The bits of [`COLUMNS`] pixels of an image's row from a column on, the first one in the highest bit of the result; 0
/// for pixels beyond the image.
#[inline(never)]
pub(in crate::draw) fn pixels_from(image: &ImageRaw<'_, BinaryColor>, column: usize, row: usize) -> u32 {
    (0..COLUMNS as usize).fold(0, |bits, offset| {
        let pixel = image.pixel(Point::new((column + offset) as i32, row as i32));
        bits | u32::from(pixel == Some(BinaryColor::On)) << (31 - offset)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_are_the_bits_of_the_bytes() {
        let bytes: [u8; 40] = core::array::from_fn(|index| (index * 73 + 41) as u8);
        let image = ImageRaw::<BinaryColor>::new(&bytes, 61);
        for row in 0..5 {
            for column in 0..61 - COLUMNS as usize {
                let expected = bits_from(&bytes, row * 64 + column) & !(u32::MAX >> COLUMNS);
                assert_eq!(pixels_from(&image, column, row), expected, "{column}, {row}");
            }
        }
    }

    #[test]
    fn bits_behind_the_last_byte_are_zeros() {
        assert_eq!(bits_from(&[0xff, 0x0f], 4), 0xf0f0_0000);
        assert_eq!(bits_from(&[0x12, 0x34, 0x56, 0x78, 0x9a], 8), 0x3456_789a);
        assert_eq!(bits_from(&[1], 80), 0);
    }
}
