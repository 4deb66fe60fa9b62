//! A shape of a stroke with caps, joins and dashes, as it stands in the list of shapes by their first rows.

use core::ops::Range;

use crate::scan::stroke::numbered_shapes::JOIN;

/// A shape of a stroke, in two words: its first row above the one behind its last one, and the vertex at which its segment begins
/// above its number there. Vertices are counted through all contours.
#[derive(Copy, Clone)]
pub(super) struct StoredShape(pub(super) ShapeWords);

/// The words of a shape.
pub(super) type ShapeWords = [u32; StoredShape::WORDS];

impl StoredShape {
    pub(super) const WORDS: usize = 2;

    /// The shape with a number. A pool has room for no more vertices than 16 bits tell.
    pub(super) const fn new(rows: &Range<i32>, vertex: usize, number: u16) -> Self {
        Self([rows_word(rows.start, rows.end), (vertex as u32) << 16 | number as u32])
    }

    /// The first row in which it has a polygon or a disc.
    pub(super) const fn first_row(self) -> i32 {
        (self.0[0] >> 16) as i32 + i16::MIN as i32
    }

    /// The row below the last one in which it has a polygon or a disc.
    pub(super) const fn end_row(self) -> i32 {
        (self.0[0] & 0xffff) as i32 + i16::MIN as i32
    }

    /// The word that tells it from the others.
    pub(super) const fn id(self) -> u32 {
        self.0[1]
    }

    /// Whether the shape is the join at the vertex where its segment begins, and no dash or segment.
    pub(super) const fn is_join(self) -> bool {
        self.0[1] as u16 == JOIN
    }

    /// Whether a row has a polygon or a disc of it, or may have one.
    pub(super) const fn has_row(self, row: i32) -> bool {
        self.first_row() <= row && row < self.end_row()
    }

    /// How many of the shapes that stand behind this one in the list are dashes that follow it along its segment, without a gap, and
    /// have pixels in a row.
    pub(super) fn followers(self, behind: &[ShapeWords], row: i32) -> usize {
        // Behind the number of a join comes the next vertex; no dash has the number before it.
        if self.is_join() {
            return 0;
        }
        let follows = |(id, words): &(u32, &ShapeWords)| {
            let other = StoredShape(**words);
            other.id() == *id && other.has_row(row)
        };
        (self.id() + 1..).zip(behind).take_while(follows).count()
    }

    /// The shape so many rows below this one. A row beyond 16 bits becomes the first one or the last one that there is: none of these
    /// has a pixel of a moved item.
    pub(super) fn moved(self, down: i32) -> Self {
        let moved = |row: i32| row.saturating_add(down).clamp(i16::MIN.into(), i16::MAX.into());
        Self([rows_word(moved(self.first_row()), moved(self.end_row())), self.id()])
    }
}

/// Two rows in a word, in the order of the first one.
const fn rows_word(first: i32, end: i32) -> u32 {
    let (first, end) = (first - i16::MIN as i32, end - i16::MIN as i32);
    (first as u32) << 16 | end as u32 & 0xffff
}
