//! Blending a row of a glyph's mask: eight pixels of the mask are one word, in which runs of equal coverage are found by
//! counting leading zeros.

use crate::{geometry::Window, shade::BlendTarget};

/// Pixels of a mask that are read at once.
const AT_ONCE: i32 = 8;

/// Blends the visible part of a mask's row, whose `width` pixels begin `column` columns right of the window's first one.
/// Row `y` must be in the window.
// Always: with `inline` alone "42 km/h" at 24 px takes 12 % more instructions from a picture, 17 % more by itself (Cortex-M4).
#[inline(always)]
pub(in crate::draw) fn blend_mask_row<B: BlendTarget>(
    target: &mut B,
    window: &Window,
    y: i32,
    mut column: i32,
    width: u8,
    mask: &[u8],
    color: B::Color,
) -> Result<(), B::Error> {
    // No band has 2^31 columns.
    let columns = window.width().min(i32::MAX as u32) as i32;
    let end = columns.min(column.saturating_add(width.into()));
    let mut rest = mask;
    while column < end {
        let (mut eight, behind) = next_eight(rest);
        rest = behind;
        let left = end - column;
        if left < AT_ONCE {
            eight &= !(u32::MAX >> (4 * left));
        }
        if column >= 0 {
            target.blend_clipped_fifteenths(y, window.left + column, eight, color)?;
        } else if column > -AT_ONCE {
            target.blend_clipped_fifteenths(y, window.left, eight << (-4 * column), color)?;
        }
        column += AT_ONCE;
    }
    Ok(())
}

/// The first eight pixels of a mask, the leftmost one in the highest bits, and the rest. Pixels behind the last byte are
/// 0.
#[inline]
pub(in crate::draw) fn next_eight(mask: &[u8]) -> (u32, &[u8]) {
    match mask.split_first_chunk() {
        Some((bytes, rest)) => (u32::from_be_bytes(*bytes), rest),
        None => {
            let word = mask
                .iter()
                .rev()
                .fold(0, |word, &byte| word >> 8 | u32::from(byte) << 24);
            (word, &[])
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_behind_the_last_byte_are_not_covered() {
        assert_eq!(next_eight(&[0x12, 0x34, 0x56, 0x78, 0x9a]), (0x1234_5678, &[0x9a][..]));
        assert_eq!(next_eight(&[0x12, 0x34]), (0x1234_0000, &[][..]));
        assert_eq!(next_eight(&[]), (0, &[][..]));
    }
}
