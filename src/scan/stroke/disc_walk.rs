//! A disc on its way from row to row, as words: where its left and its right side are in a row.
//!
//! Guarantees: the pixels of [`DiscSide`]. Cost of a row: what both sides take to go on by one; an integer square root for each
//! side in the row in which it begins.

use crate::scan::{
    polygon::{Crossing, ScanEdge},
    stroke::{DiscSide, wide_stroke::Corner},
};

/// Words of a disc: its centre, the columns of its sides in the row, and the row in which it begins or ends below that in which it
/// ends.
pub(crate) const WORDS: usize = 5;

/// A disc in a row.
pub(crate) type DiscWalk = [u32; WORDS];

/// The index of the word with the column of the left side.
const LEFT: usize = 2;
const ROWS: usize = 4;

/// The rows of a disc as a word: in the lower half that in which it begins or ends, in the upper one that in which it ends.
const fn rows_word(change: i32, end: i32) -> u32 {
    change as u16 as u32 | (end as u32) << 16
}

/// The centre of a disc.
const fn center_of(words: &DiscWalk) -> Corner {
    (words[0] as i32, words[1] as i32)
}

/// The row in which the disc begins or ends.
#[inline]
pub(crate) const fn change_row(words: &DiscWalk) -> i32 {
    words[ROWS] as i16 as i32
}

/// The row below the last one of the disc.
const fn end_row(words: &DiscWalk) -> i32 {
    (words[ROWS] >> 16) as i16 as i32
}

/// Sets up a disc in a row, whose rows fit 16 bits. Returns `false` where it has ended above. Above its first row it has no pixels.
pub(crate) fn enter(words: &mut DiscWalk, center: Corner, radius: i32, row: i32) -> bool {
    let [left, _] = DiscSide::both(center, radius);
    let (first, end) = (left.first_row(), left.end_row());
    if first >= end {
        return false;
    }
    *words = [center.0 as u32, center.1 as u32, 0, 0, rows_word(first, end)];
    row < first || go_on(words, radius, row)
}

/// Sets up the sides of a disc that begins in a row or above it. Returns `false` where it has ended.
pub(crate) fn go_on(words: &mut DiscWalk, radius: i32, row: i32) -> bool {
    let end = end_row(words);
    if end <= row {
        return false;
    }
    let [left, right] = DiscSide::both(center_of(words), radius).map(|side| side.crossing_at(row).x);
    (words[LEFT], words[LEFT + 1]) = (left as u32, right as u32);
    words[ROWS] = rows_word(end, end);
    true
}

/// The first column of the disc in a row, and the one after the last; goes on to the next row.
pub(crate) fn next_row(words: &mut DiscWalk, radius: i32, row: i32) -> (i32, i32) {
    let columns = (words[LEFT] as i32, words[LEFT + 1] as i32);
    let end = end_row(words);
    if change_row(words) == end && row + 1 < end {
        let [left, right] = DiscSide::both(center_of(words), radius);
        words[LEFT] = left.next_crossing(Crossing::at(columns.0), row + 1).x as u32;
        words[LEFT + 1] = right.next_crossing(Crossing::at(columns.1), row + 1).x as u32;
    }
    columns
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Discs of many radii and positions, entered in each row and walked to from each row above it.
    #[test]
    fn each_row_has_the_columns_between_both_sides() {
        for (x, y, radius) in
            (0..9).flat_map(|x| (0..9).flat_map(move |y| (1..30).map(move |size| (x, y, size * 20_011))))
        {
            let center = (x * 7_919 - 30_000, y * 7_907 - 31_000);
            let sides = DiscSide::both(center, radius);
            let rows = sides[0].first_row()..sides[0].end_row();
            for first in rows.start - 2..rows.end + 2 {
                let mut words = [0; WORDS];
                let mut goes_on = enter(&mut words, center, radius, first);
                for row in first..rows.end + 2 {
                    if goes_on && change_row(&words) <= row {
                        goes_on = go_on(&mut words, radius, row);
                    }
                    let columns = if goes_on {
                        next_row(&mut words, radius, row)
                    } else {
                        (0, 0)
                    };
                    let expected = if rows.contains(&row) {
                        let [left, right] = sides.map(|side| side.crossing_at(row).x);
                        left..right
                    } else {
                        0..0
                    };
                    let shown = columns.0..columns.1;
                    assert!(
                        shown == expected || shown.is_empty() && expected.is_empty(),
                        "{center:?} {radius} {row}"
                    );
                }
            }
        }
    }
}
