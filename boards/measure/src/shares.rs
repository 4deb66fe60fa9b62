//! Shares into a mask of 8 bits a pixel, as a user would write them.

/// Eight pixels at a time: most spans are too short for a call of `memset`.
#[inline(always)]
pub fn fill(pixels: &mut [u8], share: u8) {
    let (eights, rest) = pixels.as_chunks_mut::<8>();
    for eight in eights {
        *eight = [share; 8];
        core::hint::black_box(());
    }
    for pixel in rest {
        *pixel = share;
        core::hint::black_box(());
    }
}
