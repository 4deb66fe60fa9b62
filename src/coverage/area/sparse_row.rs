//! The area of the shape in each pixel of a row, from segments in order of their left ends.
//!
//! ```text
//!      \         /\  /      |
//!   ----o-------o--o-o------o---     segment A is disjoint from the others: its cells are swept as they are made
//!    A   \     / B  \ C   D |        B and C overlap: their cells go into the buffer, which is swept from left to right
//!        ^ ^^^ ^     ^ ^^^^ ^        between them one span has the cover so far
//! ```
//!
//! One cell is always current: that of the last pixel reached, which waits because the next segment may begin in the same one.
//!
//! Source: the sweep over sorted cells (FreeType's smooth rasterizer, Turner 2000), cells being sorted by the order of the edges.

use core::{num::Wrapping, ops::Range};

use crate::coverage::{
    Coverage, Emit,
    area::{
        accumulation_buffer::{AREA_ONE, AccumulationBuffer},
        cell::{COVER_SHIFT, Cell, for_each},
    },
    edges::{RowSegment, X_BITS, X_ONE},
    sweep::sweep,
};

/// Which segments of a row a coverage method counts, and how; they come from left to right.
pub(super) trait CountedEdges {
    /// Whether a segment that begins at `next` can be counted by itself after one that ends at `right`, in 1/8192 pixel.
    fn is_disjoint(&self, right: i32, next: i32) -> bool;

    /// The height that a disjoint segment counts with, in 1/16384 pixel, negative where the inside ends at it; `None` where it
    /// counts for nothing.
    fn height(&mut self, segment: &RowSegment) -> Option<i32>;

    /// Whether no segment of an overlapping cluster counts for anything; then the whole cluster is passed.
    fn skips(&mut self, cluster: &[RowSegment]) -> bool;

    /// Adds the cells of an overlapping cluster to the buffer.
    fn add_cluster(&mut self, cluster: &mut [RowSegment], buffer: &mut AccumulationBuffer<'_>);

    /// Whether a sum of cells is that of a whole pixel, and all sums further from 0 are, too; `false` where that is not known.
    #[inline(always)]
    fn is_saturated(&self, _sum: Wrapping<i32>) -> bool {
        false
    }
}

/// Emits the spans of a row whose segments come from left to right. `columns` are no more than there are `cells`, less one.
///
/// # Errors
/// The first error that `emit` returns.
#[inline(always)]
pub(super) fn cover<E, C: CountedEdges>(
    mut segments: &mut [RowSegment],
    columns: &Range<i32>,
    cells: &mut [i32],
    counted: &mut C,
    coverage: impl Fn(i32) -> Coverage,
    emit: &mut impl Emit<E>,
) -> Result<(), E> {
    let sides = ColumnSides::of(columns);
    let mut current = CurrentCell::NOTHING;
    while let [segment, others @ ..] = &*segments {
        let (start, end) = segment.ends();
        let cover = current.0.cover;
        // Two more at least end the inside in which the hidden ones lie.
        if others.len() > 1 && counted.is_saturated(cover) && counted.is_saturated(cover + cover_of(segment)) {
            let (count, cover) = hidden(segments, current.0.x, cover);
            if count != 0 {
                current.pass_hidden(cover);
                segments = segments.get_mut(count..).unwrap_or_default();
                continue;
            }
        }
        let is_alone = others
            .first()
            .is_none_or(|next| counted.is_disjoint(end, next.ends().0));
        if is_alone && sides.are_around([start, end]) {
            if let Some(height) = counted.height(segment) {
                current.go_to(start >> X_BITS, &coverage, emit)?;
                current.pass([start, end], height, &coverage, emit)?;
            }
            segments = segments.get_mut(1..).unwrap_or_default();
        } else {
            seldom();
            let mut buffer = AccumulationBuffer::of(columns.clone(), cells);
            let (count, ends) = add_cluster(segments, counted, &mut buffer);
            if let Some(ends) = ends {
                let swept = sweep_cluster(ends, &mut buffer, current, &coverage, emit);
                if swept.is_err() {
                    buffer.clear();
                }
                current = swept?;
            }
            segments = segments.get_mut(count..).unwrap_or_default();
        }
    }
    // Contours are closed: there is nothing right of the last segment.
    current.emit_pixel(coverage, emit)
}

/// Emits the spans of a row between two edges that lie in it, in no pixel together, and pass it from top to bottom: each by its
/// left and its right end in 1/8192 pixel, and the height that it counts with, in 1/16384 pixel.
///
/// # Errors
/// The first error that `emit` returns.
#[inline(always)]
pub(super) fn cover_between<E>(
    left: ([i32; 2], i32),
    right: ([i32; 2], i32),
    coverage: impl Fn(i32) -> Coverage,
    emit: &mut impl Emit<E>,
) -> Result<(), E> {
    let (mut current, (ends, height)) = (CurrentCell::NOTHING, left);
    current.0.x = ends[0] >> X_BITS;
    current.pass(ends, height, &coverage, emit)?;
    // The last pixel of the left edge waits for the first one of the right edge.
    let mut waiting = Some((current.0.x, current.coverage(&coverage)));
    current.0.area = Wrapping(0);
    let mut pixel = |current: &CurrentCell, emit: &mut _| {
        let (x, coverage) = (current.0.x, current.coverage(&coverage));
        match waiting.take() {
            Some((start, first)) => Emit::between(emit, start..x + 1, first, coverage),
            None if coverage != 0 => Emit::pixel(emit, x, coverage),
            None => Ok(()),
        }
    };
    let (ends, height) = right;
    let last = for_each(ends, height, |cell| {
        current.add(cell);
        pixel(&current, emit)?;
        current.0.area = Wrapping(0);
        Ok(())
    })?;
    current.add(last);
    pixel(&current, emit)
}

/// The left and the right side of the columns that are drawn, in 1/8192 pixel.
#[derive(Copy, Clone)]
pub(super) struct ColumnSides {
    left: i32,
    right: i32,
}

impl ColumnSides {
    pub(super) fn of(columns: &Range<i32>) -> Self {
        let side = |column: i32| column.clamp(-MOST_COLUMNS, MOST_COLUMNS) * X_ONE;
        Self {
            left: side(columns.start),
            right: side(columns.end),
        }
    }

    /// Whether an edge lies between the sides, from its left to its right end in 1/8192 pixel.
    #[inline(always)]
    pub(super) fn are_around(self, [start, end]: [i32; 2]) -> bool {
        self.left <= start && end < self.right
    }
}

/// The most columns from 0 to a side whose x in 1/8192 pixel fits 32 bits. Edges beyond it are drawn as those that cross a
/// side, which takes longer.
const MOST_COLUMNS: i32 = i32::MAX >> X_BITS;

/// Whether two edges, each given by its left and its right end, are in no pixel together, and the first one left of the other.
#[inline(always)]
pub(super) fn are_disjoint([_, left_end]: [i32; 2], [right_start, _]: [i32; 2]) -> bool {
    left_end >> X_BITS < right_start >> X_BITS
}

/// The cell of the last pixel that was reached, with the covers of all cells before it added to its own.
pub(super) struct CurrentCell(pub(super) Cell);

impl CurrentCell {
    /// The state before the first segment of a row, when no pixel was reached: nothing is emitted for it.
    pub(super) const NOTHING: Self = Self(Cell {
        x: i32::MAX,
        cover: Wrapping(0),
        area: Wrapping(0),
    });

    /// How much of the pixel is covered.
    #[inline(always)]
    pub(super) fn coverage(&self, coverage: impl Fn(i32) -> Coverage) -> Coverage {
        coverage((self.0.cover - self.0.area).0)
    }

    /// Emits the pixel of the cell.
    #[inline(always)]
    pub(super) fn emit_pixel<E>(&self, coverage: impl Fn(i32) -> Coverage, emit: &mut impl Emit<E>) -> Result<(), E> {
        let coverage = self.coverage(coverage);
        if coverage != 0 {
            emit.pixel(self.0.x, coverage)?;
        }
        Ok(())
    }

    /// Emits the pixel of the cell and the span after it, up to the column in which the next segment begins.
    #[inline(always)]
    pub(super) fn go_to<E>(
        &mut self,
        column: i32,
        coverage: impl Fn(i32) -> Coverage,
        emit: &mut impl Emit<E>,
    ) -> Result<(), E> {
        if self.0.x < column {
            self.emit_pixel(&coverage, emit)?;
            self.0.area = Wrapping(0);
            let (start, coverage) = (self.0.x + 1, coverage(self.0.cover.0));
            if coverage != 0 && start < column {
                emit.span(start..column, coverage)?;
            }
        }
        Ok(())
    }

    /// Sweeps the cells of a disjoint segment, which begins in the column that was gone to. The last one is current then.
    #[inline(always)]
    pub(super) fn pass<E>(
        &mut self,
        ends: [i32; 2],
        height: i32,
        coverage: impl Fn(i32) -> Coverage,
        emit: &mut impl Emit<E>,
    ) -> Result<(), E> {
        let last = for_each(ends, height, |cell| {
            self.add(cell);
            self.emit_pixel(&coverage, emit)?;
            self.0.area = Wrapping(0);
            Ok(())
        })?;
        self.add(last);
        Ok(())
    }

    /// Goes on with the cover right of hidden segments, which leave the pixel of the cell as it is.
    #[inline(always)]
    fn pass_hidden(&mut self, cover: Wrapping<i32>) {
        self.0.area += cover - self.0.cover;
        self.0.cover = cover;
    }

    /// Makes a cell the current one, in the same pixel or further right; the cover so far goes on in it.
    #[inline(always)]
    fn add(&mut self, cell: Cell) {
        self.0.x = cell.x;
        self.0.cover += cell.cover;
        self.0.area += cell.area;
    }
}

/// The cover of a segment: the signed height that it adds to the sum of each pixel right of it, as an area.
#[inline(always)]
fn cover_of(segment: &RowSegment) -> Wrapping<i32> {
    Wrapping(segment.signed_height() << COVER_SHIFT)
}

/// Counts the first segments of a row that change no pixel: they begin right of column `x`, and all pixels that they and their
/// neighbours pass are wholly covered without them. Returns their number and the cover right of them.
///
/// In each pixel an edge adds a number from 0 to its cover. So, where all edges of a cluster that make the sum smaller leave
/// that of a whole pixel, each pixel is covered wholly, wherever in the cluster it lies.
// Not inlined: outlines that lie in no other one keep the registers.
#[inline(never)]
fn hidden(segments: &[RowSegment], x: i32, cover: Wrapping<i32>) -> (usize, Wrapping<i32>) {
    // All ones where the sums are below 0: then they are turned round.
    let negative = cover >> 31;
    let size = |cover: Wrapping<i32>| (cover ^ negative) - negative;
    let (mut right, mut cover) = (x, size(cover));
    let (mut count, mut hidden_cover, mut least) = (0, cover, cover);
    for (index, segment) in segments.iter().enumerate() {
        let (start, end) = segment.ends();
        if start >> X_BITS > right {
            // No segment of the cluster before is in a pixel of this one.
            (count, hidden_cover, least) = (index, cover, cover);
        } else if index == 0 {
            break;
        }
        let added = size(cover_of(segment));
        least += added & (added >> 31);
        if least.0 < AREA_ONE {
            break;
        }
        cover += added;
        right = right.max(end >> X_BITS);
    }
    (count, size(hidden_cover))
}

/// Adds the cells of the first overlapping cluster of the segments to the buffer. Returns how many segments it has, and the
/// columns of its left and its right end, unless the whole cluster counts for nothing.
// Not inlined, so that disjoint segments keep the registers: a triangle takes 3 % fewer instructions (InsideArea, Cortex-M4).
#[inline(never)]
fn add_cluster<C: CountedEdges>(
    segments: &mut [RowSegment],
    counted: &mut C,
    buffer: &mut AccumulationBuffer<'_>,
) -> (usize, Option<[i32; 2]>) {
    let (count, right) = overlapping(counted, segments);
    let cluster = segments.get_mut(..count).unwrap_or_default();
    let left = cluster.first().map_or(right, |segment| segment.ends().0);
    if counted.skips(cluster) {
        return (count, None);
    }
    counted.add_cluster(cluster, buffer);
    (count, Some([left >> X_BITS, right >> X_BITS]))
}

/// How many segments, from the first one on, overlap each other or lie so near that they cannot be counted by themselves; and
/// where the last one of them ends.
fn overlapping<C: CountedEdges>(counted: &C, segments: &[RowSegment]) -> (usize, i32) {
    let mut right = segments.first().map_or(0, |segment| segment.ends().1);
    let others = segments.iter().skip(1);
    let is_in_cluster = |segment: &&RowSegment| {
        let (start, end) = segment.ends();
        let is_disjoint = counted.is_disjoint(right, start);
        if !is_disjoint {
            right = right.max(end);
        }
        !is_disjoint
    };
    let count = others.take_while(is_in_cluster).count() + 1;
    (count, right)
}

/// Emits what comes before a cluster of cells in the buffer, from column `first` to `last`, and the cluster but for its last
/// pixel, whose cell is current then.
///
/// # Errors
/// The first error that `emit` returns.
#[inline(always)]
pub(super) fn sweep_cluster<E>(
    [first, last]: [i32; 2],
    buffer: &mut AccumulationBuffer<'_>,
    mut current: CurrentCell,
    coverage: &impl Fn(i32) -> Coverage,
    emit: &mut impl Emit<E>,
) -> Result<CurrentCell, E> {
    let columns = buffer.visible(first)..buffer.visible(last);
    current.go_to(columns.start, coverage, emit)?;
    let differences = buffer.differences(&columns);
    if let [here, next, ..] = differences {
        // Where the cluster begins in the current cell's pixel, that is not emitted yet.
        *here = (Wrapping(*here) - current.0.area).0;
        *next = (Wrapping(*next) + current.0.area).0;
    }
    let count = (columns.end - columns.start) as usize;
    let (differences, after) = differences.split_at_mut_checked(count).unwrap_or_default();
    let mut cover = sweep(differences, columns.start, current.0.cover, coverage, emit)?;
    let mut pixel = cover;
    if let Some((difference, rest)) = after.split_first_mut() {
        pixel = cover + Wrapping(core::mem::take(difference));
        cover = pixel + Wrapping(rest.first_mut().map_or(0, core::mem::take));
    }
    let visible = buffer.columns.clone();
    Ok(if last >= visible.end {
        // Nothing right of the row is emitted.
        CurrentCell::NOTHING
    } else if last < visible.start {
        // Left of the row there is only cover.
        CurrentCell(Cell {
            x: visible.start - 1,
            cover,
            area: cover,
        })
    } else {
        CurrentCell(Cell {
            x: last,
            cover,
            area: cover - pixel,
        })
    })
}

/// Marks a branch as seldom taken.
// Without the mark, disjoint segments take 2 % to 6 % more instructions (SignedArea, Cortex-M4). A cluster that is covered in a
// function of its own takes up to 64 % more (Cortex-M0), because what `emit` computes alike for each span stays in there.
#[cold]
fn seldom() {}
