//! The rows of a stored outline, one call at a time.

use core::ops::Range;

use crate::{
    coverage::{
        CoverageMethod, Emit, Mirror, RowParts, SignedArea,
        edges::{
            ActiveEdge, AntialiasedEdge, RowSegment, X_BITS, Y_ONE,
            chain_walk::{PartSink, signed},
        },
        in_room,
    },
    draw::{
        antialiased::DOMAIN,
        outline::{
            memory::{self, RowMemory},
            stored::{Chain, ChainEdge, NONE, StoredOutline},
        },
    },
    scan::polygon::edge_table::insertion_sort,
};

/// How far an outline is drawn: its edges that go on in the next row, and the chain that begins next.
#[derive(Debug, Copy, Clone)]
pub(crate) struct Progress {
    /// Where its edges are in the memory that all outlines share; [`NONE`] where there was no room.
    first_edge: u16,
    /// How many of them are in use.
    edges: u16,
    /// The chain that begins next.
    next_chain: u16,
    /// The row in which it begins.
    next_row: i16,
}

/// The row in which no chain begins.
const NEVER: i16 = i16::MAX;

impl Progress {
    /// Two words of a cursor.
    #[inline(always)]
    pub(crate) const fn to_words(self) -> [u32; 2] {
        [
            self.first_edge as u32 | (self.edges as u32) << 16,
            self.next_chain as u32 | (self.next_row as u32) << 16,
        ]
    }

    #[inline(always)]
    pub(crate) const fn of([edges, next]: [u32; 2]) -> Self {
        Self {
            first_edge: edges as u16,
            edges: (edges >> 16) as u16,
            next_chain: next as u16,
            next_row: (next >> 16) as i16,
        }
    }

    /// Begins an outline, in whatever row is drawn first.
    pub(crate) fn begin(outline: StoredOutline<'_>, memory: &mut RowMemory<'_>) -> Self {
        let mut progress = Self {
            first_edge: memory.reserve(outline.most_chains()).unwrap_or(NONE),
            edges: 0,
            next_chain: NONE,
            next_row: NEVER,
        };
        progress.wait_for(outline, outline.first_chain());
        progress
    }

    /// Gives the memory back, after the outline's last row.
    pub(crate) fn end(self, outline: StoredOutline<'_>, memory: &mut RowMemory<'_>) {
        if self.first_edge != NONE {
            memory.free(self.first_edge, outline.most_chains());
        }
    }

    fn wait_for(&mut self, outline: StoredOutline<'_>, chain: u16) {
        self.next_chain = chain;
        // Rows of the domain fit.
        self.next_row = outline
            .chain(chain)
            .map_or(NEVER, |chain| outline.first_row(chain) as i16);
    }

    /// Hands over the covered pixels of a row, in spans from left to right. Rows come one after the other, from any row on.
    /// `is_cut` says that the outline is wider than the columns: then it may have nothing in them.
    #[inline(always)]
    pub(crate) fn draw_row<E>(
        &mut self,
        outline: StoredOutline<'_>,
        memory: &mut RowMemory<'_>,
        row: i32,
        columns: Range<i32>,
        is_cut: bool,
        emit: &mut impl Emit<E>,
    ) -> Result<(), E> {
        if is_cut && self.passes_by(outline, memory, row, &columns) {
            return Ok(());
        }
        if let Some(mirror) = outline.mirror() {
            return self.draw_mirrored_row(outline, memory, row, columns, mirror, emit);
        }
        if outline.is_signed() {
            if let Some(mut parts) = RowMemory::parts_in(memory.cells, &columns) {
                self.go_to(outline, memory.edges, row, &mut parts);
                return SignedArea::cover_parts(&mut parts, emit);
            }
        }
        let count = self.make_segments(outline, memory, row);
        memory.cover_columns(count, &outline.method(), outline.fill_rule(), columns, emit)
    }

    /// Hands over the covered pixels of a row of an outline whose right half is the mirror image of its left half. `mirror` is
    /// the sum of a column and its mirror image.
    #[inline(never)]
    fn draw_mirrored_row<E>(
        &mut self,
        outline: StoredOutline<'_>,
        memory: &mut RowMemory<'_>,
        row: i32,
        columns: Range<i32>,
        mirror: i32,
        emit: &mut impl Emit<E>,
    ) -> Result<(), E> {
        // Columns that are drawn at once.
        let step = i32::try_from(memory.cells.len().saturating_sub(1))
            .unwrap_or(i32::MAX)
            .max(1);
        // Columns outside the domain are cut off: their position in 1/8192 pixel could overflow.
        let (mut start, end) = (columns.start.max(DOMAIN.start), columns.end.min(DOMAIN.end));
        let (before, edge) = (*self, memory.edges_at(self.first_edge, 1).first().copied());
        loop {
            let strip = start..end.min(start.saturating_add(step)).max(start);
            if start > columns.start {
                // Back to the top of the row.
                *self = before;
                if let (Some(edge), [room]) = (edge, memory.edges_at(self.first_edge, 1)) {
                    *room = edge;
                }
            }
            start = strip.end;
            let mirror = Mirror::of(mirror, &strip);
            let (half, cells) = in_room(&mirror.left_half(), memory.cells);
            let mut parts = RowParts::new(&half, cells);
            self.go_to(outline, memory.edges, row, &mut parts);
            SignedArea::cover_mirrored(&mut parts, mirror, emit)?;
            if start >= end {
                return Ok(());
            }
        }
    }

    /// Hands over the covered pixels of a row as [`draw_row`](Self::draw_row) does, by a method that tells edges apart: whether
    /// edges cancel each other out beside the columns is not known then.
    pub(crate) fn draw_row_by<E>(
        &mut self,
        method: &impl CoverageMethod<Cell = i32>,
        outline: StoredOutline<'_>,
        memory: &mut RowMemory<'_>,
        row: i32,
        columns: Range<i32>,
        emit: &mut impl Emit<E>,
    ) -> Result<(), E> {
        let count = self.make_segments(outline, memory, row);
        memory.cover_columns(count, method, outline.fill_rule(), columns, emit)
    }

    /// Goes on to the bottom of a row in which all edges pass beside some columns, and those on their left cancel each other
    /// out: the row shows nothing of the outline. Returns `false`, and changes nothing, in any other row.
    #[inline(never)]
    fn passes_by(
        &mut self,
        outline: StoredOutline<'_>,
        memory: &mut RowMemory<'_>,
        row: i32,
        columns: &Range<i32>,
    ) -> bool {
        if self.first_edge == NONE || i32::from(self.next_row) <= row {
            return false;
        }
        let (left, right) = (
            columns.start.max(DOMAIN.start) << X_BITS,
            columns.end.min(DOMAIN.end) << X_BITS,
        );
        let edges = memory.edges_at(self.first_edge, outline.most_chains());
        let edges = edges.get_mut(..usize::from(self.edges)).unwrap_or_default();
        let row_bottom = (row + 1) * Y_ONE;
        let mut winding = 0;
        for edge in edges.iter() {
            let [_, end] = edge.bottom();
            let (from, to) = (edge.x(), edge.next_x());
            if end <= row_bottom || (from.max(to) > left && from.min(to) < right) {
                return false;
            }
            if from.max(to) <= left {
                winding += if edge.runs_up() { -1 } else { 1 };
            }
        }
        if winding != 0 {
            return false;
        }
        edges.iter_mut().for_each(ActiveEdge::step);
        true
    }

    /// Makes the segments of a row, from left to right, and returns how many they are.
    #[inline(always)]
    fn make_segments(&mut self, outline: StoredOutline<'_>, memory: &mut RowMemory<'_>, row: i32) -> usize {
        let mut segments = Segments::new(memory.segments);
        self.go_to(outline, memory.edges, row, &mut segments);
        let (were_sorted, count) = (!segments.sort(), segments.count);
        if !were_sorted && self.first_edge != NONE {
            let edges = memory.edges_at(self.first_edge, self.edges);
            insertion_sort(edges, 1, ActiveEdge::x);
        }
        count
    }

    /// Goes on to the bottom of a row, and adds the parts of edges in it.
    #[inline(never)]
    fn go_to(&mut self, outline: StoredOutline<'_>, edges: &mut [ActiveEdge], row: i32, parts: &mut impl EdgeParts) {
        if self.first_edge == NONE {
            begin_all(outline, row, parts);
            return;
        }
        let first = usize::from(self.first_edge);
        let most = usize::from(outline.most_chains());
        let edges = edges.get_mut(first..first + most).unwrap_or_default();
        let mut kept = 0;
        let row_bottom = (row + 1) * Y_ONE;
        for index in 0..usize::from(self.edges) {
            let Some(edge) = edges.get_mut(index) else { break };
            let [_, end] = edge.bottom();
            if end > row_bottom {
                parts.add_next(edge, row_bottom);
            } else {
                match go_on(outline, *edge, row, parts) {
                    Some(next) => *edge = next,
                    None => continue,
                }
            }
            if kept != index {
                let edge = *edge;
                if let Some(room) = edges.get_mut(kept) {
                    *room = edge;
                }
            }
            kept += 1;
        }
        while i32::from(self.next_row) <= row {
            let Some(chain) = outline.chain(self.next_chain) else {
                break;
            };
            if let Some(edge) = begin(outline, chain, row, parts) {
                insert(edges, kept, edge);
                kept += 1;
            }
            self.wait_for(outline, chain.next);
        }
        self.edges = kept as u16;
    }
}

/// Takes the parts of edges that lie in a row.
trait EdgeParts {
    /// Moves an edge to the bottom of the next row, in which it must lie, and adds its part there.
    fn add_next(&mut self, edge: &mut ActiveEdge, row_bottom: i32);

    /// Adds the part of an edge that begins in a row or above, and passes its bottom. Returns the edge as it is there.
    fn begin(&mut self, ends: &AntialiasedEdge, index: u32, row: i32) -> ActiveEdge;

    /// Adds the part of an edge that begins in a row or above, and ends in the row.
    fn add_to_end(&mut self, ends: &AntialiasedEdge, index: u32, row: i32);
}

impl EdgeParts for Segments<'_> {
    #[inline(always)]
    fn add_next(&mut self, edge: &mut ActiveEdge, row_bottom: i32) {
        self.push(edge.next_segment(row_bottom));
    }

    #[inline(always)]
    fn begin(&mut self, ends: &AntialiasedEdge, index: u32, row: i32) -> ActiveEdge {
        let segment = ends.begin_at(index, row);
        self.push(segment);
        ActiveEdge::below(&segment, ends)
    }

    #[inline(always)]
    fn add_to_end(&mut self, ends: &AntialiasedEdge, index: u32, row: i32) {
        self.push(ends.begin_at(index, row));
    }
}

impl EdgeParts for RowParts<'_> {
    #[inline(always)]
    fn add_next(&mut self, edge: &mut ActiveEdge, row_bottom: i32) {
        edge.add_next_part(row_bottom, self);
    }

    #[inline(always)]
    fn begin(&mut self, ends: &AntialiasedEdge, index: u32, row: i32) -> ActiveEdge {
        let [[_, top], _] = ends.ends();
        if top < row * Y_ONE {
            let segment = ends.begin_at(index, row);
            self.add_part((segment.x_top, segment.x_bottom), segment.signed_height());
            return ActiveEdge::below(&segment, ends);
        }
        let height = (row + 1) * Y_ONE - top;
        let edge = ActiveEdge::begin(ends, index, height);
        let [top, _] = ends.ends_x();
        self.add_part((top, edge.x()), signed(height, ends.winding()));
        edge
    }

    #[inline(always)]
    fn add_to_end(&mut self, ends: &AntialiasedEdge, index: u32, row: i32) {
        let [[_, top], [_, bottom]] = ends.ends();
        let ([mut from, to], mut height) = (ends.ends_x(), bottom - top);
        if top < row * Y_ONE {
            from = ends.begin_at(index, row).x_top;
            height = bottom - row * Y_ONE;
        }
        self.add_part((from, to), signed(height, ends.winding()));
    }
}

/// The segments of a row.
struct Segments<'m> {
    room: &'m mut [RowSegment],
    count: usize,
    /// The left end of the last one.
    last: i32,
    are_sorted: bool,
}

impl<'m> Segments<'m> {
    fn new(room: &'m mut [RowSegment]) -> Self {
        Self {
            room,
            count: 0,
            last: i32::MIN,
            are_sorted: true,
        }
    }

    #[inline(always)]
    fn push(&mut self, segment: RowSegment) {
        let (left, _) = segment.ends();
        self.are_sorted &= self.last <= left;
        self.last = left;
        let room = self.room.get_mut(self.count);
        debug_assert!(room.is_some(), "there is room for the segments of a row");
        if let Some(room) = room {
            *room = segment;
            self.count += 1;
        }
    }

    /// Sorts the segments by their left ends; whether they had to be.
    fn sort(&mut self) -> bool {
        if !self.are_sorted {
            memory::sort_by_left(self.room.get_mut(..self.count).unwrap_or_default());
        }
        !self.are_sorted
    }
}

/// Puts an edge between so many others, by x.
fn insert(edges: &mut [ActiveEdge], count: usize, mut edge: ActiveEdge) {
    debug_assert!(count < edges.len(), "there is room for every chain");
    let before = edges.iter().take(count).filter(|other| other.x() <= edge.x()).count();
    // Each of the others behind it moves on by one.
    for room in edges.iter_mut().take(count + 1).skip(before) {
        core::mem::swap(room, &mut edge);
    }
}

/// Adds the parts that a row has of all chains, none of which goes on.
fn begin_all(outline: StoredOutline<'_>, row: i32, parts: &mut impl EdgeParts) {
    for chain in outline.chains().take_while(|&chain| outline.first_row(chain) <= row) {
        begin(outline, chain, row, parts);
    }
}

/// Adds the parts that a row has of a chain which begins in the row or above. Returns the edge that goes on below.
fn begin(outline: StoredOutline<'_>, chain: Chain, row: i32, parts: &mut impl EdgeParts) -> Option<ActiveEdge> {
    let (edge, ends) = outline.edge_at(chain, row)?;
    add_from(outline, edge, ends, row, parts)
}

/// Adds the parts that a row has of an edge which goes on in it and ends there, or ended above it, and of those below. Returns
/// the edge that goes on below the row.
#[inline(never)]
fn go_on(outline: StoredOutline<'_>, mut edge: ActiveEdge, row: i32, parts: &mut impl EdgeParts) -> Option<ActiveEdge> {
    let row_bottom = (row + 1) * Y_ONE;
    let bottom = edge.bottom();
    if bottom[1] > row * Y_ONE {
        parts.add_next(&mut edge, row_bottom);
    }
    let this = ChainEdge::of(edge.index(), edge.runs_up());
    this.successor()?;
    if bottom[1] == row_bottom {
        return Some(edge);
    }
    let (successor, ends) = outline.next_edge(this, bottom)?;
    add_from(outline, successor, ends, row, parts)
}

/// Adds the parts that a row has of an edge and those below it in its chain. Returns the edge that goes on below the row.
fn add_from(
    outline: StoredOutline<'_>,
    mut edge: ChainEdge,
    mut ends: AntialiasedEdge,
    row: i32,
    parts: &mut impl EdgeParts,
) -> Option<ActiveEdge> {
    let row_bottom = (row + 1) * Y_ONE;
    loop {
        let [_, bottom] = ends.ends();
        if bottom[1] > row_bottom {
            return Some(parts.begin(&ends, edge.index(), row));
        }
        parts.add_to_end(&ends, edge.index(), row);
        if bottom[1] == row_bottom {
            // The successor begins in the next row.
            return edge.successor().map(|_| ActiveEdge::ended(&ends, edge.index()));
        }
        (edge, ends) = outline.next_edge(edge, bottom)?;
    }
}
