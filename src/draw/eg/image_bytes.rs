//! The bytes of an embedded-graphics image, which are private to it.

use core::hash::{Hash, Hasher};

use embedded_graphics::{
    geometry::OriginDimensions,
    image::ImageRaw,
    pixelcolor::{
        PixelColor,
        raw::{ByteOrder, RawData},
    },
};

/// The bytes of a row of an image of so many columns: pixels of less than a byte are packed, and rows begin with a byte.
pub(in crate::draw) const fn bytes_per_row<C: PixelColor>(width: u32) -> usize {
    // Below 2^32 * 32 bits: exact in 64 bits, and as many bytes as a slice can have.
    (width as u64 * C::Raw::BITS_PER_PIXEL as u64).div_ceil(8) as usize
}

/// Calls `call` with the bytes of an image. They are private, but the image's `Hash` passes them to the hasher in one
/// slice. `None` where no slice of the expected length is passed, as for an image whose last row is not complete.
pub(in crate::draw) fn with_bytes<C, BO, R>(image: &ImageRaw<'_, C, BO>, call: impl FnOnce(&[u8]) -> R) -> Option<R>
where
    C: PixelColor + From<C::Raw> + Hash,
    BO: ByteOrder + Hash,
{
    let size = image.size();
    let mut bytes = Bytes {
        length: bytes_per_row::<C>(size.width).checked_mul(size.height as usize)?,
        call: Some(call),
        result: None,
    };
    image.hash(&mut bytes);
    bytes.result
}

/// A hasher that calls `call` with the slice of the given length, and ignores everything else that is hashed.
struct Bytes<F, R> {
    length: usize,
    call: Option<F>,
    result: Option<R>,
}

impl<R, F: FnOnce(&[u8]) -> R> Hasher for Bytes<F, R> {
    fn write(&mut self, bytes: &[u8]) {
        if bytes.len() == self.length {
            self.result = self.call.take().map(|call| call(bytes));
        }
    }

    fn write_u32(&mut self, _: u32) {}

    fn write_usize(&mut self, _: usize) {}

    fn finish(&self) -> u64 {
        0
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::{
        image::{ImageRaw, ImageRawLE},
        pixelcolor::{BinaryColor, Gray4, Rgb888},
    };

    use super::with_bytes;

    #[test]
    fn the_bytes_of_an_image_are_seen() {
        for (bytes, width) in [(&[1u8, 2, 3, 4][..], 16), (&[5, 6, 7, 8, 9, 10, 11, 12], 8), (&[], 3)] {
            let image = ImageRaw::<BinaryColor>::new(bytes, width);
            assert_eq!(with_bytes(&image, |found| found == bytes), Some(true));
        }
        let bytes = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12];
        assert_eq!(
            with_bytes(&ImageRaw::<Gray4>::new(&bytes, 5), |found| found == bytes),
            Some(true)
        );
        assert_eq!(
            with_bytes(&ImageRawLE::<Rgb888>::new(&bytes, 2), |found| found == bytes),
            Some(true)
        );
    }

    #[test]
    fn an_image_with_bytes_behind_its_last_row_is_not_seen() {
        assert_eq!(with_bytes(&ImageRaw::<Gray4>::new(&[1, 2, 3, 4], 6), |_| ()), None);
    }
}
