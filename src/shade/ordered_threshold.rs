//! Blending, and means, where there is nothing between two colours: a pixel becomes the one or the other, by its position.
//!
//! Guarantees: of every 8 x 8 pixels, `alpha * 64 / 255` of them, rounded to the nearest, take the colour; a larger alpha
//! takes those of a smaller one and more; the same position always decides the same way, in whatever band it is drawn. Adding
//! two shapes that share an edge does not close it: both take their pixels by the same thresholds. A mean counts as an
//! alpha that is not rounded before.
//!
//! Source: Bayer 1973. 128 bytes.

use embedded_graphics::geometry::Point;

use crate::coverage::Coverage;

/// Blends over the words of a row, the first of which stands for the pixel at `position`.
pub fn blend(words: &mut [u8], position: Point, color: u8, alpha: Coverage) {
    let count = pixels_of_64(alpha);
    for (word, column) in words.iter_mut().zip(position.x as usize & 7..) {
        if takes(column, position.y, count) {
            *word = color;
        }
    }
}

/// A pixel of two colours, 1 or 0, whose mean is `sum / 2^bits`: the threshold at `position` decides. `bits` is at most
/// 24.
pub fn mean(sum: u32, bits: u32, position: Point) -> u8 {
    let half = (1u32 << bits) >> 1;
    let count = (sum * 64 + half) >> bits;
    takes(position.x as usize, position.y, count as u8).into()
}

/// Whether a pixel is one of the `count` of 64 that take the colour.
fn takes(column: usize, y: i32, count: u8) -> bool {
    let row = THRESHOLDS.get((y & 7) as usize);
    row.and_then(|row| row.get(column & 7))
        .is_some_and(|&threshold| threshold < count)
}

/// The thresholds of eight pixels side by side, 0 to 63, beginning at a position of the picture.
pub(super) fn thresholds_at(left: i32, y: i32) -> &'static [u8; BLOCK] {
    let row = THRESHOLDS.get((y & 7) as usize);
    let block = row.and_then(|row| row.get(left as usize & 7..)?.first_chunk());
    block.unwrap_or(&[0; BLOCK])
}

/// An alpha as a number of 64 pixels, rounded to the nearest: the division by 255 of Blinn 1994.
const fn pixels_of_64(alpha: Coverage) -> u8 {
    let sum = (alpha as u32) * 64 + 128;
    ((sum + (sum >> 8)) >> 8) as u8
}

/// Columns, and rows, after which the thresholds repeat.
pub(super) const BLOCK: usize = 8;

/// Bayer's threshold matrix: every number below 64 once, neighbours far apart. Each row twice, so that eight columns from any
/// one of the first eight on lie side by side.
static THRESHOLDS: [[u8; 2 * BLOCK]; BLOCK] = thresholds();

const fn thresholds() -> [[u8; 2 * BLOCK]; BLOCK] {
    let mut rows = [[0; 2 * BLOCK]; BLOCK];
    let mut position = 0;
    while position < BLOCK * BLOCK {
        let (x, y) = (position % BLOCK, position / BLOCK);
        let (mut threshold, mut bit) = (0, 0);
        while bit < 3 {
            threshold |= ((((x ^ y) >> bit & 1) << 1 | (y >> bit & 1)) << (4 - 2 * bit)) as u8;
            bit += 1;
        }
        #[expect(clippy::indexing_slicing, reason = "evaluated by the compiler")]
        {
            rows[y][x] = threshold;
            rows[y][x + BLOCK] = threshold;
        }
        position += 1;
    }
    rows
}
