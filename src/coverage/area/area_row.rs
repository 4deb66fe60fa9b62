//! The area of the shape in each pixel of a row, from the areas right of its edges.
//!
//! Segments that are apart from each other go straight out, pixel by pixel; what lies between two of them is one span.
//! The last pixel of each waits, because the next one may begin in it. Those that crowd in the same columns add their
//! areas up in the row memory first, as differences.

use core::{convert::Infallible, ops::Range};

use crate::{
    coverage::{
        Coverage,
        area::piece::{AREA_BITS, Part, each_pixel, three_parts, two_parts},
        edges::{FINE, FINE_BITS, RowSegment},
        sweep::{sweep, sweep_pixels},
        with_room,
    },
    geometry::divide_long,
};

/// The area of a pixel.
pub(crate) const WHOLE: i32 = 1 << AREA_BITS;

/// How a tier counts the segments of a row, which come from left to right.
pub(crate) trait Heights {
    /// Whether what begins at `next` can be counted by itself after what ends at `right`, both in fine units.
    fn is_apart(right: i32, next: i32) -> bool;

    /// The height of a segment, negative where the inside ends at it, in 1/64 unit; `None` where it is no side of the
    /// inside.
    fn height(&mut self, segment: &RowSegment) -> Option<i32>;

    /// Whether no segment of a crowd is a side of the inside; then all of them are counted.
    fn skips(&mut self, crowd: &[RowSegment]) -> bool;

    /// Adds segments that are not apart to the row.
    fn add_crowd(&mut self, crowd: &mut [RowSegment], row: &mut AreaRow<'_>);
}

/// Hands over the spans of a row whose segments come from left to right.
///
/// # Errors
/// The first of `emit`.
#[inline(always)]
pub(crate) fn cover<E, H: Heights>(
    mut segments: &mut [RowSegment],
    columns: Range<i32>,
    cells: &mut [i32],
    heights: &mut H,
    coverage: impl Fn(i32) -> Coverage,
    mut emit: impl FnMut(Range<i32>, Coverage) -> Result<(), E>,
) -> Result<(), E> {
    let columns = with_room(&columns, cells.len().saturating_sub(1));
    let left = columns.start.wrapping_mul(FINE);
    let width = columns.end.wrapping_mul(FINE).wrapping_sub(left) as u32;
    // Left of the row is far right of it for a number without sign.
    let is_inside = |x: i32| (x.wrapping_sub(left) as u32) < width;
    let mut reached = Reached::NOTHING;
    while let [segment, others @ ..] = &*segments {
        let (start, end) = segment.ends();
        let is_alone = others.first().is_none_or(|next| H::is_apart(end, next.ends().0));
        if is_alone && is_inside(start) && is_inside(end) {
            if let Some(height) = heights.height(segment) {
                reached.go_to(start >> FINE_BITS, &coverage, &mut emit)?;
                reached.pass([start, end], height, &coverage, &mut emit)?;
            }
            segments = segments.get_mut(1..).unwrap_or_default();
        } else {
            let row = AreaRow::new(&columns, cells);
            (segments, reached) = cover_crowd(segments, row, heights, reached, &coverage, &mut emit)?;
        }
    }
    // Contours are closed: there is nothing right of the last segment.
    reached.hand_over_pixel(coverage, emit)
}

/// How far a row is handed over.
struct Reached {
    /// All columns before this one are; the next segment may begin in its pixel.
    column: i32,
    /// The area of each pixel right of it, so far.
    sum: i32,
    /// What its own pixel has less.
    missing: i32,
}

impl Reached {
    /// Left of all segments.
    const NOTHING: Self = Self {
        column: i32::MAX,
        sum: 0,
        missing: 0,
    };

    #[inline(always)]
    fn hand_over_pixel<E>(
        &self,
        coverage: impl Fn(i32) -> Coverage,
        mut emit: impl FnMut(Range<i32>, Coverage) -> Result<(), E>,
    ) -> Result<(), E> {
        let coverage = coverage(self.sum.wrapping_sub(self.missing));
        if coverage != 0 {
            emit(self.column..self.column.wrapping_add(1), coverage)?;
        }
        Ok(())
    }

    /// Hands over what comes before the column of the next segment.
    #[inline(always)]
    fn go_to<E>(
        &mut self,
        column: i32,
        coverage: impl Fn(i32) -> Coverage,
        mut emit: impl FnMut(Range<i32>, Coverage) -> Result<(), E>,
    ) -> Result<(), E> {
        if self.column < column {
            self.hand_over_pixel(&coverage, &mut emit)?;
            self.missing = 0;
            let (start, coverage) = (self.column.wrapping_add(1), coverage(self.sum));
            if coverage != 0 && start < column {
                emit(start..column, coverage)?;
            }
        }
        Ok(())
    }

    /// Hands over the pixels of a piece but the last, which begins in the column that was gone to.
    #[inline(always)]
    fn pass<E>(
        &mut self,
        ends: [i32; 2],
        height: i32,
        coverage: impl Fn(i32) -> Coverage,
        mut emit: impl FnMut(Range<i32>, Coverage) -> Result<(), E>,
    ) -> Result<(), E> {
        let last = each_pixel(ends, height, |part| {
            self.add(part);
            self.hand_over_pixel(&coverage, &mut emit)?;
            self.missing = 0;
            Ok(())
        })?;
        self.add(last);
        Ok(())
    }

    #[inline(always)]
    fn add(&mut self, part: Part) {
        self.column = part.column;
        self.sum = self.sum.wrapping_add(part.whole);
        self.missing = self.missing.wrapping_add(part.left);
    }
}

/// The differences of a row.
pub(crate) struct AreaRow<'c> {
    cells: &'c mut [i32],
    columns: Range<i32>,
}

impl<'c> AreaRow<'c> {
    /// A row over the columns, or over as many of the first ones as there are cells for.
    #[inline(always)]
    pub(crate) fn new(columns: &Range<i32>, cells: &'c mut [i32]) -> Self {
        Self {
            columns: with_room(columns, cells.len().saturating_sub(1)),
            cells,
        }
    }

    /// A row over the columns between two x in 1/8192 pixel and the column after them, or over as many of the first ones as
    /// there are cells for.
    #[inline(always)]
    pub(crate) fn between([start, end]: [i32; 2], columns: &Range<i32>, cells: &'c mut [i32]) -> Self {
        let columns = with_room(columns, cells.len().saturating_sub(1));
        let visible = |column: i32| column.max(columns.start).min(columns.end);
        let (first, last) = (visible(start >> FINE_BITS), visible((end >> FINE_BITS).wrapping_add(1)));
        // Two cells more than columns, for what lies right of them; one where the row ends there.
        let count = last.wrapping_sub(first).wrapping_add(2) as usize;
        let (cells, _) = cells.split_at_mut(count.min(cells.len()));
        Self {
            cells,
            columns: first..last,
        }
    }

    /// Hands over the spans of what was added for some segments.
    ///
    /// # Errors
    /// The first of `emit`.
    #[inline(always)]
    pub(crate) fn cover<E>(
        mut self,
        segments: &[RowSegment],
        coverage: impl Fn(i32) -> Coverage,
        emit: impl FnMut(Range<i32>, Coverage) -> Result<(), E>,
    ) -> Result<(), E> {
        let ends = segments.iter().map(RowSegment::ends);
        let ends = ends.fold((i32::MAX, i32::MIN), |one, other| {
            (one.0.min(other.0), one.1.max(other.1))
        });
        let (first, last) = (ends.0 >> FINE_BITS, ends.1 >> FINE_BITS);
        let columns = self.visible(first)..self.visible(last.wrapping_add(1));
        sweep(columns, self.touched(first, last), coverage, emit)
    }

    /// Adds the area right of a straight piece of an edge from `x_top` to `x_bottom`, in fine units. `height` is in 1/64
    /// unit, negative where the winding number falls.
    #[inline(always)]
    pub(crate) fn add(&mut self, x_top: i32, x_bottom: i32, height: i32) {
        let left = self.columns.start.wrapping_mul(FINE);
        let (one, other) = (x_top.wrapping_sub(left), x_bottom.wrapping_sub(left));
        // Which end is the upper one does not matter to an area.
        self.add_between([one.min(other), one.max(other)], height);
    }

    /// Adds the area right of a part of an edge that is `height` high and reaches from one x to a larger one, in 1/8192
    /// pixel from the left side of the row.
    #[inline(always)]
    fn add_between(&mut self, [start, end]: [i32; 2], height: i32) {
        let columns = self.columns.end.wrapping_sub(self.columns.start);
        let width = columns.wrapping_mul(FINE);
        // One question for both ends: a negative number is a large one here.
        if (start | width.wrapping_sub(end)) < 0 {
            self.add_cut(width, [start, end], height);
        } else {
            self.add_inside([start, end], height);
        }
    }

    #[inline(never)]
    fn add_inside(&mut self, ends: [i32; 2], height: i32) {
        let mut add = |part: Part| {
            let first = part.column as usize;
            if let Some([here, next]) = self.cells.get_mut(first..first.wrapping_add(2)) {
                part.put(here, next);
            }
            // On the right end nothing reads it.
            Ok::<_, Infallible>(())
        };
        let Ok(()) = each_pixel(ends, height, &mut add).and_then(&mut add);
    }

    /// Where a piece leaves the row it is cut: what is left of the row counts as if it were on its left end.
    #[cold]
    #[inline(never)]
    fn add_cut(&mut self, width: i32, [start, end]: [i32; 2], height: i32) {
        if end <= 0 {
            self.add_inside([0, 0], height);
        } else if start < width {
            let height_to = |x: i32| {
                let part = x.wrapping_sub(start);
                divide_long(i64::from(height) * i64::from(part), end.wrapping_sub(start)).0
            };
            let left = if start < 0 { height_to(0) } else { 0 };
            let visible = if end > width { height_to(width) } else { height };
            self.add_inside([0, 0], left);
            self.add_inside([start.max(0), end.min(width)], visible.wrapping_sub(left));
        }
    }

    /// A column within the row.
    #[inline(always)]
    fn visible(&self, column: i32) -> i32 {
        column.max(self.columns.start).min(self.columns.end)
    }

    /// The cells that what lies in columns was added to; one or two more than those.
    #[inline(always)]
    fn touched(&mut self, first: i32, last: i32) -> &mut [i32] {
        // What lies left of the row counts at its left end.
        let from_start = |column: i32| column.wrapping_sub(self.columns.start).max(0) as usize;
        let end = from_start(last).wrapping_add(2).min(self.cells.len());
        self.cells.get_mut(from_start(first)..end).unwrap_or_default()
    }

    /// Hands over what was added between two columns, pixel by pixel, and what is due before them. The pixel of the last
    /// column waits.
    ///
    /// # Errors
    /// The first of `emit`.
    #[inline(always)]
    fn hand_over<E>(
        mut self,
        [first, last]: [i32; 2],
        mut reached: Reached,
        coverage: &impl Fn(i32) -> Coverage,
        emit: &mut impl FnMut(Range<i32>, Coverage) -> Result<(), E>,
    ) -> Result<Reached, E> {
        let Range { start, end } = self.columns;
        let columns = self.visible(first)..self.visible(last);
        let mut emitted = reached.go_to(columns.start, coverage, &mut *emit);
        let cells = self.touched(first, last);
        if let [here, next, ..] = cells {
            *here = here.wrapping_sub(reached.missing);
            *next = next.wrapping_add(reached.missing);
        }
        let mut sum = reached.sum;
        let mut areas = cells.iter_mut().map(|cell| {
            sum = sum.wrapping_add(core::mem::take(cell));
            sum
        });
        for (column, area) in columns.zip(&mut areas) {
            let coverage = coverage(area);
            // Goes on after an error, so that no difference stays.
            if coverage != 0 && emitted.is_ok() {
                emitted = emit(column..column.wrapping_add(1), coverage);
            }
        }
        let area = areas.next().unwrap_or(0);
        let sum = areas.last().unwrap_or(area);
        let reached = if last >= end {
            Reached::NOTHING
        } else if last < start {
            // Nothing waits in the column left of the row.
            Reached {
                column: start.wrapping_sub(1),
                sum,
                missing: sum,
            }
        } else {
            Reached {
                column: last,
                sum,
                missing: sum.wrapping_sub(area),
            }
        };
        emitted.map(|()| reached)
    }
}

/// The differences of a row where a shape may lie in it: for many pieces in no order.
pub(crate) struct CrowdedRow<'c> {
    row: AreaRow<'c>,
    /// The left side of the row, in 1/8192 pixel.
    left: i32,
}

impl<'c> CrowdedRow<'c> {
    #[inline(always)]
    pub(crate) fn new(row: AreaRow<'c>) -> Self {
        Self {
            left: row.columns.start.wrapping_mul(FINE),
            row,
        }
    }

    /// Adds the area right of a straight piece, as [`AreaRow::add`]. Cost: a division where it is in two pixels, none
    /// where it is in one.
    #[inline(always)]
    pub(crate) fn add(&mut self, x_top: i32, x_bottom: i32, height: i32) {
        let (one, other) = (x_top.wrapping_sub(self.left), x_bottom.wrapping_sub(self.left));
        let (start, end) = (one.min(other), one.max(other));
        // Left of the row is far right of it for a number without sign.
        let [first, last] = [start, end].map(|x| (x as u32 >> FINE_BITS) as usize);
        match self.row.cells.get_mut(first..last.wrapping_add(2)) {
            Some([here, next]) => Part::within([start, end], height).put(here, next),
            Some([here, next, after]) => {
                let [part, rest] = two_parts([start, end], height);
                part.put(here, next);
                rest.put(next, after);
            }
            _ => self.add_longer([start, end], height, first..last),
        }
    }

    /// Adds a part of an edge that lies in three pixels or more, or leaves the row. Cost: two divisions.
    #[inline(never)]
    fn add_longer(&mut self, [start, end]: [i32; 2], height: i32, pixels: Range<usize>) {
        match self.row.cells.get_mut(pixels.start..pixels.end.wrapping_add(2)) {
            Some([here, next, after, last]) => {
                let [part, middle, rest] = three_parts([start, end], height);
                part.put(here, next);
                middle.put(next, after);
                rest.put(after, last);
            }
            _ => self.row.add_between([start, end], height),
        }
    }

    /// Hands over the spans of what was added: pixel by pixel where there are edges, and what lies between them.
    ///
    /// # Errors
    /// The first of `emit`.
    #[inline(always)]
    pub(crate) fn hand_over<E>(
        &mut self,
        coverage: impl Fn(i32) -> Coverage,
        emit: impl FnMut(Range<i32>, Coverage) -> Result<(), E>,
    ) -> Result<(), E> {
        let Range { start, end } = self.row.columns;
        let width = end.wrapping_sub(start) as usize;
        let visible = self.row.cells.get_mut(..width).unwrap_or_default();
        sweep_pixels(start, visible, coverage, emit)
    }

    /// Leaves nothing of what was added: neither after an error nor right of the columns, where nobody reads it.
    pub(crate) fn clear(&mut self) {
        self.row.cells.fill(0);
    }
}

/// Counts the segments that are not apart, from the first one on, and returns the others.
///
/// # Errors
/// The first of `emit`.
// Cold, so that the others keep the registers.
#[cold]
#[inline(never)]
fn cover_crowd<'s, E, H: Heights>(
    segments: &'s mut [RowSegment],
    mut row: AreaRow<'_>,
    heights: &mut H,
    mut reached: Reached,
    coverage: &impl Fn(i32) -> Coverage,
    emit: &mut impl FnMut(Range<i32>, Coverage) -> Result<(), E>,
) -> Result<(&'s mut [RowSegment], Reached), E> {
    let (count, right) = crowded::<H>(segments);
    let (crowd, others) = segments.split_at_mut_checked(count).unwrap_or_default();
    let left = crowd.first().map_or(right, |segment| segment.ends().0);
    if !heights.skips(crowd) {
        heights.add_crowd(crowd, &mut row);
        reached = row.hand_over([left >> FINE_BITS, right >> FINE_BITS], reached, coverage, emit)?;
    }
    Ok((others, reached))
}

/// How many of the segments are not apart, from the first one on, and where the last one of them ends.
fn crowded<H: Heights>(segments: &[RowSegment]) -> (usize, i32) {
    let mut right = segments.first().map_or(0, |segment| segment.ends().1);
    let others = segments.iter().skip(1);
    let in_crowd = |segment: &&RowSegment| {
        let (start, end) = segment.ends();
        let is_apart = H::is_apart(right, start);
        if !is_apart {
            right = right.max(end);
        }
        !is_apart
    };
    let count = others.take_while(in_crowd).count().wrapping_add(1);
    (count, right)
}

/// Rounded to the nearest: as many 255ths of a pixel, the whole at most.
#[inline(always)]
pub(crate) fn coverage_of(area: i32) -> Coverage {
    // A power of two, for which some processors have an instruction. One less than the whole is the same coverage.
    rounded(area.clamp(0, WHOLE - 1) as u32)
}

/// The coverage of an area that is less than a pixel: as many 255ths of it, rounded to the nearest.
#[inline(always)]
pub(crate) fn rounded(area: u32) -> Coverage {
    (area.wrapping_mul(255).wrapping_add(WHOLE as u32 / 2) >> WHOLE.trailing_zeros()) as Coverage
}
