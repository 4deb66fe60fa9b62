//! Coverage into a mask of 8 bits a pixel, as a user would write them.

/// Eight pixels at a time: most spans are too short for a call of `memset`.
#[inline(always)]
pub fn fill(pixels: &mut [u8], coverage: u8) {
    let (eights, rest) = pixels.as_chunks_mut::<8>();
    for eight in eights {
        *eight = [coverage; 8];
        core::hint::black_box(());
    }
    for pixel in rest {
        *pixel = coverage;
        core::hint::black_box(());
    }
}
