//! How the chains of a polygon lie in words, and how their edges are read.

use core::ops::Range;

use embedded_graphics::geometry::Point;

use crate::{
    draw::FillRule,
    scan::polygon::{Edge, Part, ceil_pixel},
};

/// A corner: x and y in units of `1 / (1 << fraction_bits)` pixel.
pub(super) type Corner = [i32; 2];

/// The position of no chain.
pub(super) const NONE: u16 = u16::MAX;

/// Words before the first chain: fraction bits, flags and the chain that begins first; column and row of the pixel from which near
/// corners count.
pub(super) const HEADER_WORDS: usize = 3;

/// The most edges that a chain's word can tell.
pub(super) const MOST_EDGES: u32 = (1 << 15) - 1;

const EVEN_ODD: u32 = 1 << 5;
const WIDE: u32 = 1 << 6;

/// The first words of a stored polygon: the format of its corners, its fill rule, and which of its chains begins first.
#[derive(Debug, Copy, Clone)]
pub(super) struct Header {
    pub(super) fraction_bits: u32,
    pub(super) fill_rule: FillRule,
    /// Whether a corner takes two words.
    pub(super) is_wide: bool,
    pub(super) first_chain: u16,
    /// The pixel from which near corners count.
    pub(super) origin: Corner,
}

impl Header {
    pub(super) fn to_words(self) -> [u32; HEADER_WORDS] {
        let even_odd = if self.fill_rule == FillRule::EvenOdd {
            EVEN_ODD
        } else {
            0
        };
        let wide = if self.is_wide { WIDE } else { 0 };
        let [left, top] = self.origin;
        [
            self.fraction_bits | even_odd | wide | u32::from(self.first_chain) << 16,
            left as u32,
            top as u32,
        ]
    }
}

/// The chains of a polygon, read from their words.
#[derive(Debug, Copy, Clone)]
pub(crate) struct StoredChains<'w> {
    words: &'w [u32],
}

/// A y-monotone chain of edges, or what is left of one.
#[derive(Debug, Copy, Clone)]
pub(super) struct Chain {
    /// The index of its uppermost corner.
    pub(super) top: u16,
    /// How many edges it has.
    pub(super) edges: u16,
    /// Whether the contour goes up along it.
    pub(super) runs_up: bool,
}

impl Chain {
    /// The chain as a word: where it begins, how many edges it has, and its direction in the lowest bit.
    pub(super) fn to_word(self) -> u32 {
        u32::from(self.top) << 16 | u32::from(self.edges) << 1 | u32::from(self.runs_up)
    }

    /// The chain that [`to_word`](Self::to_word) wrote.
    pub(super) const fn of_word(word: u32) -> Self {
        Self {
            top: (word >> 16) as u16,
            edges: word as u16 >> 1,
            runs_up: word & 1 != 0,
        }
    }
}

impl<'w> StoredChains<'w> {
    /// The polygon that begins with these words. Others behind it do no harm.
    #[inline(always)]
    pub(crate) const fn new(words: &'w [u32]) -> Self {
        Self { words }
    }

    #[inline(always)]
    fn word(&self, index: u16) -> u32 {
        self.words.get(usize::from(index)).copied().unwrap_or(0)
    }

    /// The bits of a winding number that are not all 0 inside.
    #[inline(always)]
    pub(super) fn fill_mask(&self) -> i32 {
        if self.word(0) & EVEN_ODD == 0 { -1 } else { 1 }
    }

    fn fraction_bits(&self) -> u32 {
        self.word(0) & (EVEN_ODD - 1)
    }

    /// Words of a corner.
    fn corner_words(&self) -> u16 {
        if self.word(0) & WIDE == 0 { 1 } else { 2 }
    }

    /// The position of the chain that begins first.
    pub(super) fn first_chain(&self) -> u16 {
        (self.word(0) >> 16) as u16
    }

    fn corner(&self, index: u16) -> Corner {
        if self.word(0) & WIDE != 0 {
            return [self.word(index) as i32, self.word(index.wrapping_add(1)) as i32];
        }
        let (near, bits) = (self.word(index), self.fraction_bits());
        [
            ((self.word(1) as i32) << bits) + i32::from(near as i16),
            ((self.word(2) as i32) << bits) + (near as i32 >> 16),
        ]
    }

    /// The first row of pixel centres at a corner or below it.
    pub(super) fn row_of(&self, corner: u16) -> i32 {
        let [_, y] = self.corner(corner);
        ceil_pixel(y, self.fraction_bits())
    }

    /// The chain at a position, and the position of the one that begins next; `None` behind the last one.
    pub(super) fn chain(&self, position: u16) -> Option<(Chain, u16)> {
        if position == NONE {
            return None;
        }
        let word = self.word(position);
        let chain = Chain {
            top: position.wrapping_add(1),
            edges: (word >> 17) as u16,
            runs_up: word >> 16 & 1 != 0,
        };
        Some((chain, word as u16))
    }

    /// The first edge of a chain that does not end above a row, and what is left of the chain below it.
    pub(super) fn edge_below(&self, mut chain: Chain, row: i32) -> Option<(Edge, Chain)> {
        while chain.edges > 0 {
            let upper = chain.top;
            chain.top = upper.wrapping_add(self.corner_words());
            chain.edges -= 1;
            if self.row_of(chain.top) > row {
                let [from, to] = [upper, chain.top].map(|corner| self.corner(corner).into());
                // Between two edges that meet nowhere but in a row, there is one that crosses no row.
                if let Some(edge) = Edge::from_units(from, to, self.fraction_bits(), Part::Fill) {
                    return Some((edge, chain));
                }
            }
        }
        None
    }

    /// The columns of the polygon in some rows; `None` where it has no pixel.
    pub(crate) fn columns_in(&self, rows: &Range<i32>) -> Option<(i32, i32)> {
        let (mut left, mut right) = (i32::MAX, i32::MIN);
        let mut position = self.first_chain();
        while let Some((mut chain, next)) = self.chain(position) {
            position = next;
            while let Some((edge, rest)) = self.edge_below(chain, rows.start) {
                if edge.first_row >= rows.end {
                    break;
                }
                // An edge is straight: it goes farthest at its ends.
                for row in [edge.first_row.max(rows.start), edge.end_row.min(rows.end) - 1] {
                    let column = edge.crossing_at(row).x;
                    (left, right) = (column.min(left), column.max(right));
                }
                chain = rest;
            }
        }
        (left < right).then_some((left, right))
    }
}

/// Moves a polygon by so many columns and rows, the words of which may be followed by others. Its corners have to stay in the number
/// range.
pub(crate) fn translate(words: &mut [u32], by: Point) {
    let chains = StoredChains::new(words);
    let (bits, is_wide, mut position) = (chains.fraction_bits(), chains.corner_words() > 1, chains.first_chain());
    if !is_wide {
        // The origin is a pixel.
        translate_corners(words.get_mut(1..HEADER_WORDS).unwrap_or_default(), by, 0);
        return;
    }
    while let Some((chain, next)) = StoredChains::new(words).chain(position) {
        position = next;
        let first = usize::from(chain.top);
        let corners = words.get_mut(first..first + 2 * (usize::from(chain.edges) + 1));
        translate_corners(corners.unwrap_or_default(), by, bits);
    }
}

/// Moves corners of two words each, in units of `1 / (1 << fraction_bits)` pixel, by whole pixels. What would leave the number range
/// ends there.
fn translate_corners(words: &mut [u32], by: Point, fraction_bits: u32) {
    for corner in words.chunks_exact_mut(2) {
        for (word, by) in corner.iter_mut().zip([by.x, by.y]) {
            let moved = i64::from(*word as i32) + (i64::from(by) << fraction_bits);
            *word = moved.clamp(i32::MIN.into(), i32::MAX.into()) as u32;
        }
    }
}
