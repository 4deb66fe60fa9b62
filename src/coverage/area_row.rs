//! The area of the shape in each pixel of a row, from the areas right of its edges.
//!
//! Segments that share no column of pixels with another go straight out, pixel by pixel; what lies between two of them is
//! one span. Those that crowd in the same columns add their areas up in the row memory first, as differences.

use core::{convert::Infallible, ops::Range};

use crate::{
    coverage::{
        Share,
        piece::each_pixel,
        sweep::{Covered, sweep},
    },
    scan::{RowSegment, UNIT},
};

/// A whole pixel: twice the area, in units.
pub(super) const WHOLE: i32 = 2 * UNIT * UNIT;

/// How a tier counts the segments of a row, which come from left to right.
pub(super) trait Heights {
    /// The height of a segment, negative where the inside ends at it.
    fn height(&mut self, segment: &RowSegment) -> i32;

    /// Adds segments that share columns of pixels to the row.
    fn add_crowd(&mut self, crowd: &mut [RowSegment], row: &mut AreaRow<'_>);
}

/// Hands over the spans of a row whose segments come from left to right.
///
/// # Errors
/// The first of `emit`.
#[inline(always)]
pub(super) fn cover<E>(
    mut segments: &mut [RowSegment],
    columns: Range<i32>,
    cells: &mut [i32],
    heights: &mut impl Heights,
    share: impl Fn(i32) -> Share,
    mut emit: impl FnMut(Range<i32>, Share) -> Result<(), E>,
) -> Result<(), E> {
    let columns = with_room(columns, cells);
    let (left, right) = (columns.start.wrapping_mul(UNIT), columns.end.wrapping_mul(UNIT));
    let mut covered = Covered::new(columns.start);
    while let [segment, others @ ..] = &*segments {
        let (start, end) = segment.ends();
        let is_alone = others.first().is_none_or(|next| next.ends().0 >> 8 > end >> 8);
        if is_alone && start >= left && end < right {
            covered.hand_over(start >> 8, &share, &mut emit)?;
            let mut sum = covered.sum;
            each_pixel([start, end], heights.height(segment), |column, height, places| {
                let whole = height.wrapping_mul(2 * UNIT);
                let share = share(sum.wrapping_add(whole).wrapping_sub(height.wrapping_mul(places)));
                sum = sum.wrapping_add(whole);
                if share != 0 {
                    emit(column..column.wrapping_add(1), share)?;
                }
                Ok(())
            })?;
            covered = Covered {
                end: (end >> 8).wrapping_add(1),
                sum,
            };
            segments = segments.get_mut(1..).unwrap_or_default();
        } else {
            let (crowd, others) = segments.split_at_mut_checked(crowded(segments)).unwrap_or_default();
            let mut row = AreaRow::new(columns.clone(), cells);
            heights.add_crowd(crowd, &mut row);
            covered = row.cover_crowd(covered, &share, &mut emit)?;
            segments = others;
        }
    }
    // Contours are closed: there is nothing right of the last segment.
    Ok(())
}

/// As many of the columns as there are cells for.
#[inline(always)]
fn with_room(columns: Range<i32>, cells: &[i32]) -> Range<i32> {
    let most = cells.len().saturating_sub(1);
    let count = (columns.end.wrapping_sub(columns.start).max(0) as usize).min(most);
    columns.start..columns.start.wrapping_add(count as i32)
}

/// The differences of a row, and which of them are not 0.
pub(super) struct AreaRow<'c> {
    cells: &'c mut [i32],
    columns: Range<i32>,
    /// What the pieces added so far make of all that is right of them.
    sum: i32,
    /// What they lie between, in units from the left column.
    low: i32,
    high: i32,
}

impl<'c> AreaRow<'c> {
    /// Of as many of the columns as there are cells for.
    #[inline(always)]
    pub(super) fn new(columns: Range<i32>, cells: &'c mut [i32]) -> Self {
        Self {
            columns: with_room(columns, cells),
            cells,
            sum: 0,
            low: i32::MAX,
            high: i32::MIN,
        }
    }

    /// Hands over the spans of what was added.
    ///
    /// # Errors
    /// The first of `emit`.
    #[inline(always)]
    pub(super) fn cover<E>(
        mut self,
        share: impl Fn(i32) -> Share,
        mut emit: impl FnMut(Range<i32>, Share) -> Result<(), E>,
    ) -> Result<(), E> {
        let (before, end) = (Covered::new(self.columns.start), self.columns.end);
        let sum = self.sum;
        let (columns, cells) = self.touched();
        let covered = Covered { end: columns.end, sum };
        sweep(before, columns, cells, &share, &mut emit)?;
        covered.hand_over(end, &share, &mut emit)
    }

    /// Adds the area right of a straight piece of an edge from `x_top` to `x_bottom`. `height` is negative where the
    /// winding number falls.
    pub(super) fn add(&mut self, x_top: i32, x_bottom: i32, height: i32) {
        let left = self.columns.start.wrapping_mul(UNIT);
        let width = self.columns.end.wrapping_mul(UNIT).wrapping_sub(left);
        let (one, other) = (x_top.wrapping_sub(left), x_bottom.wrapping_sub(left));
        // Which end is the upper one does not matter to an area.
        let (start, end) = (one.min(other), one.max(other));
        self.low = self.low.min(start);
        self.high = self.high.max(end);
        self.sum = self.sum.wrapping_add(height.wrapping_mul(2 * UNIT));
        // One question for both ends: a negative number is a large one here.
        if (start | width.wrapping_sub(end)) < 0 {
            self.add_cut(width, [start, end], height);
        } else {
            self.add_inside([start, end], height);
        }
    }

    #[inline(always)]
    fn add_inside(&mut self, ends: [i32; 2], height: i32) {
        let added = each_pixel(ends, height, |column, height, places| {
            let first = column as usize;
            let right = height.wrapping_mul(places);
            if let Some([here, next]) = self.cells.get_mut(first..first.wrapping_add(2)) {
                *here = here.wrapping_add(height.wrapping_mul(2 * UNIT)).wrapping_sub(right);
                *next = next.wrapping_add(right);
            }
            // On the right end nothing reads it.
            Ok::<_, Infallible>(())
        });
        let Ok(()) = added;
    }

    /// Where a piece leaves the row it is cut: what is left of the row counts as if it were on its left end.
    #[cold]
    #[inline(never)]
    fn add_cut(&mut self, width: i32, [start, end]: [i32; 2], height: i32) {
        let length = end.wrapping_sub(start);
        // Lengths are below 2^22 units, heights at most 2^8.
        let height_to = |x: i32| {
            let part = x.clamp(start, end).wrapping_sub(start);
            height.wrapping_mul(part).checked_div(length).unwrap_or(0)
        };
        let (left, right) = if length == 0 {
            (if start < 0 { height } else { 0 }, height)
        } else {
            (height_to(0), height_to(width))
        };
        self.add_inside([0, 0], left);
        if start <= width && end >= 0 {
            self.add_inside([start.clamp(0, width), end.clamp(0, width)], right.wrapping_sub(left));
        }
    }

    /// The cells that what was added lies in, and their columns; one or two more cells than columns.
    #[inline(always)]
    fn touched(&mut self) -> (Range<i32>, &mut [i32]) {
        // What lies left of the row counts at its left end.
        let first = self.low.max(0) >> 8;
        let end = (self.high.max(0) >> 8).wrapping_add(1);
        let column_of = |pixel: i32| self.columns.start.wrapping_add(pixel).min(self.columns.end);
        let columns = column_of(first)..column_of(end);
        let end = (end.wrapping_add(1) as usize).min(self.cells.len());
        (columns, self.cells.get_mut(first as usize..end).unwrap_or_default())
    }

    /// Hands over the few columns of a crowd, pixel by pixel, and what is due before them.
    ///
    /// # Errors
    /// The first of `emit`.
    #[inline(never)]
    fn cover_crowd<E>(
        mut self,
        before: Covered,
        share: &impl Fn(i32) -> Share,
        emit: &mut impl FnMut(Range<i32>, Share) -> Result<(), E>,
    ) -> Result<Covered, E> {
        let (sum_after, is_left) = (before.sum.wrapping_add(self.sum), self.high < 0);
        let (columns, cells) = self.touched();
        if is_left {
            cells.fill(0);
            return Ok(Covered {
                sum: sum_after,
                ..before
            });
        }
        let covered = Covered {
            end: columns.end,
            sum: sum_after,
        };
        let mut emitted = before.hand_over(columns.start, share, &mut *emit);
        let mut sum = before.sum;
        let mut column = columns.start;
        for cell in cells {
            // Goes on after an error, so that no difference stays.
            sum = sum.wrapping_add(core::mem::take(cell));
            let share = share(sum);
            let next = column.wrapping_add(1);
            if column < columns.end && share != 0 && emitted.is_ok() {
                emitted = emit(column..next, share);
            }
            column = next;
        }
        emitted.map(|()| covered)
    }
}

/// How many of the segments share columns, from the first on.
fn crowded(segments: &[RowSegment]) -> usize {
    let mut last = i32::MIN;
    let in_crowd = |segment: &&RowSegment| {
        let (start, end) = segment.ends();
        let shares = last == i32::MIN || start >> 8 <= last;
        last = last.max(end >> 8);
        shares
    };
    segments.iter().take_while(in_crowd).count()
}

/// Rounded to the nearest: as many 255ths of a pixel, the whole at most.
#[inline(always)]
pub(super) fn share_of(area: i32) -> Share {
    // 255 / 256 of it, rounded down, and a half.
    let area = area.wrapping_add(area.wrapping_neg() >> 8).wrapping_add(WHOLE / 512);
    (area >> 9).clamp(0, 255) as Share
}
