//! Blending, and means, where there is nothing between two colours: a pixel becomes the one or the other, by its position.
//!
//! Guarantees: of every 8 x 8 pixels, `alpha * 64 / 255` of them, rounded to the nearest, take the colour; a larger alpha
//! takes those of a smaller one and more; the same position always decides the same way, in whatever band it is drawn. Adding
//! two shapes that share an edge does not close it: both take their pixels by the same thresholds. A mean counts as an
//! alpha that is not rounded before.
//!
//! Source: Bayer 1973. 64 bytes.

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

/// An alpha as a number of 64 pixels, rounded to the nearest: the division by 255 of Blinn 1994.
const fn pixels_of_64(alpha: Coverage) -> u8 {
    let sum = (alpha as u32) * 64 + 128;
    ((sum + (sum >> 8)) >> 8) as u8
}

/// Bayer's threshold matrix: every number below 64 once, neighbours far apart.
const THRESHOLDS: [[u8; 8]; 8] = thresholds();

const fn thresholds() -> [[u8; 8]; 8] {
    let mut rows = [[0; 8]; 8];
    let mut position = 0;
    while position < 64 {
        let (x, y) = (position % 8, position / 8);
        let (mut threshold, mut bit) = (0, 0);
        while bit < 3 {
            threshold |= ((((x ^ y) >> bit & 1) << 1 | (y >> bit & 1)) << (4 - 2 * bit)) as u8;
            bit += 1;
        }
        #[expect(clippy::indexing_slicing, reason = "evaluated by the compiler")]
        {
            rows[y][x] = threshold;
        }
        position += 1;
    }
    rows
}
