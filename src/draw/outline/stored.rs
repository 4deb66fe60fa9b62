//! How an outline lies in words, and how its corners are read.

use core::ops::{Range, RangeInclusive};

use crate::{
    coverage::{
        AnyCoverage,
        edges::{AntialiasedEdge, Y_BITS, Y_ONE, from_corner},
    },
    draw::{
        FillRule,
        antialiased::{ARC_WORDS, OutlineArc},
    },
    geometry::Window,
};

/// A corner: x and y in 1/256 pixel from the centre of pixel (0, 0).
pub(super) type Corner = [i32; 2];

/// The position of no chain.
pub(super) const NONE: u16 = u16::MAX;

/// Words before the first chain: its size and flags, the chain that begins first with the most chains in a row, and the
/// pixel of the first corner.
pub(super) const HEADER_WORDS: usize = 3;

/// A row above every outline.
const ABOVE_ALL: i32 = i32::MIN / (2 * Y_ONE);

/// Flags in the upper half of the first word.
const WIDE: u32 = 1 << 16;
const EVEN_ODD: u32 = 1 << 17;
const ROUND: u32 = 1 << 18;
const METHOD_SHIFT: u32 = 19;
/// In the place of a method: the signed area of the left half, of which the right half is the mirror image.
const MIRRORED: u32 = 3;

/// How the corners of an outline lie in its words.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(super) enum Corners {
    /// A word for each, relative to the origin.
    Near,
    /// Two words for each.
    Wide,
    /// Computed one by one: before the chains come the parameters of arcs, and each chain says where its corners begin.
    Round,
}

/// An outline, read from its words.
#[derive(Debug, Copy, Clone)]
pub(crate) struct StoredOutline<'w> {
    words: &'w [u32],
}

/// What is written before the chains.
#[derive(Debug, Copy, Clone)]
pub(super) struct Header {
    pub(super) words: usize,
    pub(super) corners: Corners,
    pub(super) fill_rule: FillRule,
    pub(super) method: AnyCoverage,
    /// Whether the chains are those of the left half alone, and the right half is its mirror image.
    pub(super) is_mirrored: bool,
    pub(super) first_chain: u16,
    pub(super) most_chains: u16,
    /// Where the corners count from, in pixels; where they are [`Corners::Round`], how many arcs the outer and the inner
    /// contour have.
    pub(super) origin: Corner,
}

impl Header {
    /// The words of the header.
    pub(super) fn to_words(self) -> [u32; HEADER_WORDS] {
        let method = match self.method {
            AnyCoverage::CentreSample => 0,
            AnyCoverage::SignedArea => 1,
            AnyCoverage::InsideArea => 2,
        };
        let method = if self.is_mirrored { MIRRORED } else { method };
        let flag = |is_set: bool, flag: u32| if is_set { flag } else { 0 };
        let corners = flag(self.corners == Corners::Wide, WIDE) | flag(self.corners == Corners::Round, ROUND);
        let flags = corners | flag(self.fill_rule == FillRule::EvenOdd, EVEN_ODD);
        [
            self.words as u32 & 0xffff | flags | method << METHOD_SHIFT,
            u32::from(self.first_chain) | u32::from(self.most_chains) << 16,
            pair(self.origin),
        ]
    }
}

/// Two numbers of 16 bits in a word.
pub(super) fn pair([x, y]: Corner) -> u32 {
    x as u32 & 0xffff | (y as u32) << 16
}

/// The two numbers of a [`pair`].
#[inline(always)]
pub(super) fn unpaired(word: u32) -> Corner {
    [i32::from(word as i16), word as i32 >> 16]
}

/// A y-monotone chain of edges.
#[derive(Debug, Copy, Clone)]
pub(super) struct Chain {
    /// The position of its uppermost corner.
    top: u16,
    /// How many edges it has.
    edges: u16,
    /// Whether the outline goes up along it: then its corners lie in memory from the bottom to the top.
    runs_up: bool,
    /// The position of the chain that begins next.
    pub(super) next: u16,
}

/// Where a chain is: an edge, and how many are below it. Edges are told apart, and put into the outline's order where they
/// lie over each other, by [`index`](Self::index).
#[derive(Debug, Copy, Clone)]
pub(super) struct ChainEdge {
    /// The position of the edge's upper corner.
    top: u16,
    /// How many edges of the chain are below this one.
    below: u16,
    runs_up: bool,
}

impl ChainEdge {
    /// A number by which the edge is found again: the position of the corner that comes first in memory, which grows along
    /// the outline, and how many edges are below.
    #[inline(always)]
    pub(super) fn index(self) -> u32 {
        let first = if self.runs_up {
            self.top.wrapping_sub(1)
        } else {
            self.top
        };
        u32::from(first) << 16 | u32::from(self.below)
    }

    /// The edge with an [`index`](Self::index).
    #[inline(always)]
    pub(super) fn of(index: u32, runs_up: bool) -> Self {
        let first = (index >> 16) as u16;
        Self {
            top: if runs_up { first.wrapping_add(1) } else { first },
            below: index as u16,
            runs_up,
        }
    }

    /// The position of the edge's lower corner.
    #[inline(always)]
    fn bottom(self) -> u16 {
        self.nth_corner(1)
    }

    /// The position of the corner so many edges below the upper one.
    #[inline(always)]
    fn nth_corner(self, edges: u16) -> u16 {
        if self.runs_up {
            self.top.wrapping_sub(edges)
        } else {
            self.top.wrapping_add(edges)
        }
    }

    /// The edge so many edges further down, which the chain must have.
    #[inline(always)]
    fn nth(self, edges: u16) -> Self {
        Self {
            top: self.nth_corner(edges),
            below: self.below - edges,
            ..self
        }
    }

    /// The next edge of the chain.
    #[inline(always)]
    pub(super) fn successor(self) -> Option<Self> {
        (self.below != 0).then(|| self.nth(1))
    }
}

impl Chain {
    /// How many corners it has.
    pub(super) const fn corners(&self) -> u16 {
        self.edges + 1
    }
}

impl<'w> StoredOutline<'w> {
    /// The outline that begins with these words. Others behind it do no harm.
    #[inline(always)]
    pub(crate) const fn new(words: &'w [u32]) -> Self {
        Self { words }
    }

    #[inline(always)]
    fn word(&self, index: usize) -> u32 {
        self.words.get(index).copied().unwrap_or(0)
    }

    #[inline(always)]
    pub(super) fn fill_rule(&self) -> FillRule {
        if self.word(0) & EVEN_ODD == 0 {
            FillRule::NonZero
        } else {
            FillRule::EvenOdd
        }
    }

    /// The method that is exact for the outline and takes least.
    #[inline(always)]
    pub(super) fn method(&self) -> AnyCoverage {
        match self.word(0) >> METHOD_SHIFT {
            0 => AnyCoverage::CentreSample,
            1 | MIRRORED => AnyCoverage::SignedArea,
            _ => AnyCoverage::InsideArea,
        }
    }

    /// Whether the signed area is exact for the outline and takes least, by the nonzero rule.
    #[inline(always)]
    pub(super) fn is_signed(&self) -> bool {
        self.word(0) & EVEN_ODD == 0 && self.method() == AnyCoverage::SignedArea
    }

    /// The sum of a column and its mirror image, where the chains are those of the left half of an outline alone, and its right
    /// half is the mirror image of that.
    #[inline(always)]
    pub(super) fn mirror(&self) -> Option<i32> {
        // The first word of an ellipse is the x of its axis.
        (self.word(0) >> METHOD_SHIFT == MIRRORED).then(|| self.word(HEADER_WORDS) as i32 >> (Y_BITS - 1))
    }

    /// The position of the chain that begins first.
    #[inline(always)]
    pub(super) fn first_chain(&self) -> u16 {
        self.word(1) as u16
    }

    /// How many words the outline takes.
    pub(crate) fn words(&self) -> u16 {
        self.word(0) as u16
    }

    /// The most chains and the most edges that lie in one of some rows. Cost: a look at each chain for each row.
    pub(super) fn most_in(self, rows: Range<i32>) -> [usize; 2] {
        let (mut most_chains, mut most_edges) = (0, 0);
        for row in rows {
            let (mut chains, mut edges) = (0, 0);
            for chain in self.chains().take_while(|&chain| self.first_row(chain) <= row) {
                let in_row = self.edges_in(chain, row);
                chains += usize::from(in_row > 0);
                edges += in_row;
            }
            (most_chains, most_edges) = (most_chains.max(chains), most_edges.max(edges));
        }
        [most_chains, most_edges]
    }

    /// How many edges of a chain lie in a row.
    fn edges_in(self, chain: Chain, row: i32) -> usize {
        let mut next = self.edge_at(chain, row);
        let mut count = 0;
        while let Some((edge, ends)) = next {
            if ends.first_row() > row {
                break;
            }
            count += 1;
            let [_, bottom] = ends.ends();
            next = self.next_edge(edge, bottom);
        }
        count
    }

    /// The most chains that pass the bottom of one row.
    #[inline(always)]
    pub(crate) fn most_chains(&self) -> u16 {
        (self.word(1) >> 16) as u16
    }

    /// The corner at a position.
    #[inline(always)]
    pub(super) fn corner(&self, position: u16) -> Corner {
        match self.word(0) & (WIDE | ROUND) {
            0 => {
                let ([left, top], [x, y]) = (unpaired(self.word(2)), unpaired(self.word(position.into())));
                [(left << Y_BITS) + x, (top << Y_BITS) + y]
            }
            WIDE => {
                let index = 2 * usize::from(position);
                [self.word(index) as i32, self.word(index + 1) as i32]
            }
            _ => self.round_corner(position),
        }
    }

    /// The y of the corner at a position.
    #[inline(always)]
    fn y_of(&self, position: u16) -> i32 {
        if self.word(0) & ROUND == 0 {
            let [_, y] = self.corner(position);
            return y;
        }
        let (arc, index) = self.arc_with(position);
        arc.y_of(index)
    }

    /// Whether a window lies in the hole of a ring or of an arc with a width; `false` where that is not known at once.
    pub(crate) fn is_around(&self, window: &Window) -> bool {
        let [outer, inner] = unpaired(self.word(2));
        if self.corners() != Corners::Round || outer + inner != 2 {
            return false;
        }
        let (one, other) = (self.arc(0), self.arc(1));
        one.is_opposite(&other) && one.is_around(window) && other.is_around(window)
    }

    /// How the corners lie in the words.
    pub(super) fn corners(&self) -> Corners {
        match self.word(0) & (WIDE | ROUND) {
            0 => Corners::Near,
            WIDE => Corners::Wide,
            _ => Corners::Round,
        }
    }

    /// How many arcs an outline of arcs has in all.
    pub(super) fn arcs(&self) -> u16 {
        let [outer, inner] = unpaired(self.word(2));
        (outer + inner) as u16
    }

    /// How many arcs an outline of arcs has, if it is one contour.
    pub(super) fn arcs_of_one_contour(&self) -> Option<u16> {
        let [outer, inner] = unpaired(self.word(2));
        (inner == 0).then_some(outer as u16)
    }

    /// An arc of an outline of arcs.
    pub(super) fn arc(&self, index: u16) -> OutlineArc {
        self.arc_and_position(index.into()).0
    }

    /// An arc of an outline of arcs, and the position of its first corner.
    #[inline(always)]
    fn arc_and_position(&self, index: i32) -> (OutlineArc, u16) {
        let start = HEADER_WORDS + index as usize * ARC_WORDS;
        let words = self.words.get(start..).and_then(<[u32]>::first_chunk);
        OutlineArc::of_words(words.unwrap_or(&[0; ARC_WORDS]))
    }

    /// The corner of an outline of arcs at a position.
    #[inline(never)]
    fn round_corner(&self, position: u16) -> Corner {
        let (arc, index) = self.arc_with(position);
        arc.corner(index)
    }

    /// The arc that has the corner at a position, and the corner's index in it. A contour has one position more than it has
    /// corners, which is that of its first corner once more.
    // The position of an arc's first corner is read alone, and only the arc that is found is read as a whole.
    #[inline(always)]
    fn arc_with(&self, position: u16) -> (OutlineArc, u16) {
        let [outer, inner] = unpaired(self.word(2));
        let mut index = 0;
        while index + 1 < outer + inner && self.arc_position(index + 1) <= position {
            index += 1;
        }
        let (arc, start) = self.arc_and_position(index);
        if position - start < arc.corners() {
            return (arc, position - start);
        }
        let first = if index < outer { 0 } else { outer };
        (self.arc_and_position(first).0, 0)
    }

    /// The position of an arc's first corner.
    #[inline(always)]
    fn arc_position(&self, index: i32) -> u16 {
        OutlineArc::position_in(self.word(HEADER_WORDS + (index as usize + 1) * ARC_WORDS - 1))
    }

    /// The chain at a position; `None` behind the last one.
    #[inline(always)]
    pub(super) fn chain(&self, position: u16) -> Option<Chain> {
        if position == NONE {
            return None;
        }
        let index = usize::from(position);
        let (word, first) = match self.word(0) & (WIDE | ROUND) {
            0 => (self.word(index), position.wrapping_add(1)),
            WIDE => (self.word(2 * index), position.wrapping_add(1)),
            _ => (self.word(index), self.word(index + 1) as u16),
        };
        let (corners, runs_up) = ((word >> 17) as u16, word >> 16 & 1 != 0);
        let edges = corners.saturating_sub(1);
        Some(Chain {
            top: if runs_up { first.wrapping_add(edges) } else { first },
            edges,
            runs_up,
            next: word as u16,
        })
    }

    /// The first row in which a chain lies.
    pub(super) fn first_row(&self, chain: Chain) -> i32 {
        let [_, top] = self.corner(chain.top);
        (top + Y_ONE / 2) >> Y_BITS
    }

    /// The uppermost and the lowest corner of a chain, in 1/256 pixel from the corner of pixel (0, 0).
    pub(super) fn ends_of(&self, chain: Chain) -> [Corner; 2] {
        let below = |edges: u16| {
            if chain.runs_up {
                chain.top.wrapping_sub(edges)
            } else {
                chain.top.wrapping_add(edges)
            }
        };
        [chain.top, below(chain.edges)].map(|position| from_corner(self.corner(position)))
    }

    /// The chains of an outline whose corners are stored, in the order in which it runs along them.
    pub(super) fn chains_along(self) -> impl Iterator<Item = Chain> + 'w {
        // Chains begin at positions that are multiples of a corner.
        let first = (HEADER_WORDS as u32).div_ceil(self.words_of_corner());
        let mut next = self.chain_along(first);
        core::iter::from_fn(move || {
            let chain = next?;
            next = self.chain_behind(chain);
            Some(chain)
        })
    }

    /// The chain that follows another one in the order of [`chains_along`](Self::chains_along).
    pub(super) fn chain_behind(self, chain: Chain) -> Option<Chain> {
        self.chain_along(u32::from(self.first_corner(chain)) + u32::from(chain.corners()))
    }

    /// The chain at a position, unless the outline ends there.
    fn chain_along(self, position: u32) -> Option<Chain> {
        let end = (self.word(0) & 0xffff) / self.words_of_corner();
        (position < end).then(|| self.chain(position as u16))?
    }

    /// How many words of memory each corner of an outline takes that is not kept as arcs: 2 where they are wide, or else 1.
    fn words_of_corner(&self) -> u32 {
        if self.word(0) & WIDE == 0 { 1 } else { 2 }
    }

    /// From the leftmost x of a chain's corners to the rightmost one, in 1/256 pixel.
    pub(super) fn columns_of(&self, chain: Chain) -> RangeInclusive<i32> {
        let start = self.first_corner(chain);
        let (mut left, mut right) = (i32::MAX, i32::MIN);
        for index in 0..=chain.edges {
            let [x, _] = self.corner(start.wrapping_add(index));
            (left, right) = (left.min(x), right.max(x));
        }
        left..=right
    }

    /// The corner to which the outline runs along a chain, in 1/256 pixel from the corner of pixel (0, 0).
    pub(super) fn last_of(&self, chain: Chain) -> Corner {
        let [top, bottom] = self.ends_of(chain);
        if chain.runs_up { top } else { bottom }
    }

    /// The first edge of a chain that does not end above a row, with its ends; `None` where all do. A binary search.
    pub(super) fn edge_at(&self, chain: Chain, row: i32) -> Option<(ChainEdge, AntialiasedEdge)> {
        let edge = ChainEdge {
            top: chain.top,
            below: chain.edges.checked_sub(1)?,
            runs_up: chain.runs_up,
        };
        let row_top = row * Y_ONE - Y_ONE / 2;
        let ends_above = |index: u16| self.y_of(edge.nth_corner(index + 1)) <= row_top;
        let (mut start, mut end) = (0, chain.edges);
        if ends_above(edge.below) {
            return None;
        }
        if ends_above(0) {
            start = 1;
            while start < end {
                let middle = (start + end) / 2;
                if ends_above(middle) {
                    start = middle + 1;
                } else {
                    end = middle;
                }
            }
        }
        let edge = edge.nth(start);
        let ends = self.edge_below(edge, from_corner(self.corner(edge.top)));
        if ends.is_level() {
            let [_, bottom] = ends.ends();
            return self.next_edge(edge, bottom);
        }
        Some((edge, ends))
    }

    /// The next edge of a chain that is not level, below one that ends at `bottom`, in 1/256 pixel from the corner of
    /// pixel (0, 0).
    #[inline(always)]
    pub(super) fn next_edge(&self, mut edge: ChainEdge, mut bottom: Corner) -> Option<(ChainEdge, AntialiasedEdge)> {
        loop {
            edge = edge.successor()?;
            let ends = self.edge_below(edge, bottom);
            if !ends.is_level() {
                return Some((edge, ends));
            }
            [_, bottom] = ends.ends();
        }
    }

    /// The edge with its ends, of which the upper one is known, in 1/256 pixel from the corner of pixel (0, 0).
    #[inline(always)]
    fn edge_below(&self, edge: ChainEdge, top: Corner) -> AntialiasedEdge {
        AntialiasedEdge::below(top, self.corner(edge.bottom()), edge.runs_up)
    }

    /// The chains in order of their first rows.
    pub(super) fn chains(self) -> impl Iterator<Item = Chain> + 'w {
        let mut position = self.first_chain();
        core::iter::from_fn(move || {
            let chain = self.chain(position)?;
            position = chain.next;
            Some(chain)
        })
    }

    /// The edges of a chain that are not level, from its top on.
    pub(super) fn edges_of(self, chain: Chain) -> impl Iterator<Item = AntialiasedEdge> + 'w {
        let mut next = self.edge_at(chain, ABOVE_ALL);
        core::iter::from_fn(move || {
            let (edge, ends) = next?;
            let [_, bottom] = ends.ends();
            next = self.next_edge(edge, bottom);
            Some(ends)
        })
    }

    /// The edges of an outline whose corners are stored, in the order in which it runs along them.
    pub(super) fn edges_along(self) -> impl Iterator<Item = AntialiasedEdge> + 'w {
        self.chains_along().flat_map(move |chain| {
            let first = self.first_corner(chain);
            (0..chain.edges).filter_map(move |index| {
                let [from, to] = [index, index + 1].map(|index| self.corner(first.wrapping_add(index)));
                AntialiasedEdge::from_units(from, to)
            })
        })
    }

    /// The [`index`](ChainEdge::index) from which on edges come behind the first ones, so many of them, in the order in which
    /// the outline runs along its stored corners.
    pub(crate) fn index_behind(self, mut edges: u32) -> u32 {
        for chain in self.chains_along() {
            let count = u32::from(chain.edges);
            if edges < count {
                return u32::from(self.first_corner(chain).wrapping_add(edges as u16)) << 16;
            }
            edges -= count;
        }
        u32::MAX
    }

    /// The position of a chain's first corner in the order in which the outline runs along it.
    pub(super) fn first_corner(&self, chain: Chain) -> u16 {
        if chain.runs_up {
            chain.top.wrapping_sub(chain.edges)
        } else {
            chain.top
        }
    }

    /// The first column of the edges in some rows and the one after the last; the first is larger where no edge lies in
    /// them.
    pub(crate) fn columns_in(&self, rows: &Range<i32>) -> (i32, i32) {
        let (mut left, mut right) = (i32::MAX, i32::MIN);
        for chain in self.chains() {
            let mut next = self.edge_at(chain, rows.start);
            while let Some((edge, ends)) = next {
                if ends.first_row() >= rows.end {
                    break;
                }
                let [start, end] = ends.columns_in(rows);
                (left, right) = (left.min(start), right.max(end));
                let [_, bottom] = ends.ends();
                next = self.next_edge(edge, bottom);
            }
        }
        match self.mirror() {
            Some(mirror) if left < right => (left, mirror - left + 1),
            _ => (left, right),
        }
    }
}
