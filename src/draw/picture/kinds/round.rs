//! Circles and ellipses: how far the curve is inside its box goes on from row to row, through both halves.
//!
//! With doubled distances x and y from the middle, a pixel is inside while `b x^2 + a y^2 < limit`. A row's error
//! term is what it lacks for one column more on each side, which is between 1 and what that column costs. A row
//! nearer to the middle gains, and each column that is won costs; a row further away loses, and columns are given back:
//!
//! ```text
//!   upper half:  error term -= gain;  while gain is left over: one column more, error term = its cost
//!   lower half:  error term += loss;  while it exceeds the last column's cost: one column less
//! ```
//!
//! Guarantees: the pixels of the shapes' own walk, in additions; no number exceeds 2^32.

use embedded_graphics::{
    geometry::{Dimensions, Size},
    primitives::{Circle, Ellipse},
};

use core::{hint::black_box, marker::PhantomData, num::Wrapping};

use crate::{
    band::Band,
    draw::{
        PrimitiveStyle, StyledShape,
        eg::areas::Areas,
        payload::Payload,
        picture::{
            item::{Extent, ItemKind, PictureItem, PictureSlot, fill_singly, fill_span, kind_of, span_of},
            kinds::{
                rectangle::Border,
                replayed::{Words, replayed},
            },
            pool::Pool,
            prepare::{Draft, PreparedShape, not_used},
        },
    },
    scan::round::{ForwardDifference, circle, ellipse},
    surface::{BandColor, Order, PixelWord, Target},
};

/// A row of a curve: the columns that are inside, and how near the next ones are.
#[derive(Clone, Copy)]
struct CurveRow {
    /// First column.
    start: i32,
    /// The column after the last one.
    end: i32,
    /// What the row lacks for one column more on each side.
    error_term: u32,
}

impl CurveRow {
    /// The row as two words, of which one has both columns.
    #[inline(always)]
    const fn words(self) -> [u32; 2] {
        [(self.start as u32 & 0xffff) | (self.end as u32) << 16, self.error_term]
    }

    #[inline(always)]
    const fn of([columns, error_term]: [u32; 2]) -> Self {
        Self {
            start: columns as i16 as i32,
            end: columns as i32 >> 16,
            error_term,
        }
    }

    /// First column, and the one after the last.
    #[inline(always)]
    const fn columns(self) -> (i32, i32) {
        (self.start, self.end)
    }

    /// The next row of the upper half, from one so far (doubled, less one) above the middle.
    #[inline(always)]
    fn next_wider(self, above_middle: u32, (column_unit, row_unit): (u32, u32)) -> Self {
        let mut cost = (self.end - self.start) as u32 * column_unit;
        let mut gain = above_middle * row_unit;
        let (mut error_term, mut won) = (self.error_term, 0);
        while gain >= error_term {
            gain -= error_term;
            won += 1;
            cost += 2 * column_unit;
            error_term = cost;
            // Keeps this loop, of one round mostly, from being unrolled.
            black_box(());
        }
        Self {
            start: self.start - won,
            end: self.end + won,
            error_term: error_term - gain,
        }
    }

    /// The next row of the lower half, from one so far (doubled, and one) below the middle.
    #[inline(always)]
    fn next_narrower(self, below_middle: u32, (column_unit, row_unit): (u32, u32)) -> Self {
        // Behind the last row, which may be left with no column to give back, it is below 0: larger than any number,
        // which ends the loop.
        let mut cost = Wrapping((self.end - self.start) as u32 * column_unit);
        let cost_step = Wrapping(2 * column_unit);
        let mut error_term = self.error_term + below_middle * row_unit;
        let mut lost = 0;
        while error_term > cost.0 {
            error_term -= cost.0;
            cost -= cost_step;
            lost += 1;
            black_box(());
        }
        Self {
            start: self.start + lost,
            end: self.end - lost,
            error_term,
        }
    }
}

/// Circles or ellipses.
trait Round: 'static {
    /// Whether each row has pixels, and the numbers of the walk fit, for sides below 2^16.
    fn fits(size: Size) -> bool;

    /// Columns of the box before the first pixel in a row of the upper half, and the error term.
    fn enter(size: Size, row: u32) -> (u32, u32);

    /// What a column costs and a row gains, each as a multiple of a doubled distance.
    fn units(width: i32, height: i32) -> (u32, u32);
}

impl Round for Circle {
    fn fits(_: Size) -> bool {
        true
    }

    fn enter(size: Size, row: u32) -> (u32, u32) {
        let ForwardDifference { inset, error_term, .. } = circle::enter(size.width, row);
        (inset, error_term)
    }

    #[inline(always)]
    fn units(_: i32, _: i32) -> (u32, u32) {
        (1, 1)
    }
}

/// Columns of an ellipse: from one row to the next, a flat one may gain half of them.
const MOST_COLUMNS: u64 = 2_048;
/// Rows of an ellipse: their square is below 2^31, and what a column costs, which is twice that, below 2^32.
const MOST_ROWS: u64 = 46_340;

impl Round for Ellipse {
    fn fits(size: Size) -> bool {
        let (width, height) = (u64::from(size.width), u64::from(size.height));
        // What a column costs and what a row gains, together; and the columns that one row may gain.
        width <= MOST_COLUMNS
            && height <= MOST_ROWS
            && width * height * (width + height) <= u64::from(u32::MAX)
            && ellipse::first_row(size) == 0
    }

    fn enter(size: Size, row: u32) -> (u32, u32) {
        let ForwardDifference { inset, error_term, .. } = ellipse::enter_narrow(size, row);
        // That of a circle counts in other units.
        let unit = if size.width == size.height {
            size.width * size.width
        } else {
            1
        };
        (inset, error_term * unit)
    }

    #[inline(always)]
    fn units(width: i32, height: i32) -> (u32, u32) {
        ((height * height) as u32, (width * width) as u32)
    }
}

/// One colour within the curve. The cursor is the row.
struct Filled<S>(PhantomData<S>);

/// A stroke along the curve, with or without a fill. The cursor is the outer curve's row; the words are one less than
/// the rows of the inner curve, its next row, and the fill's colour.
struct Stroked<S, const HAS_FILL: bool>(PhantomData<S>);

/// The item of a circle or an ellipse.
fn prepare<'a, S: Round + Words + StyledShape, C: BandColor, O: Order>(
    shape: &S,
    areas: &Areas<C>,
    style: &PrimitiveStyle<C>,
    payload: &mut Payload<'_>,
) -> Draft<'a, C, O> {
    let window = areas.outer.to_window();
    let is_filled = areas.inner.is_empty();
    // Neither side of an extent is 2^16, and the inner area is not larger.
    let fits = || S::fits(areas.outer.size) && (is_filled || S::fits(areas.inner.size));
    let Some(extent) = Extent::of_whole(&window).filter(|_| fits()) else {
        return replayed(shape, style, window, payload);
    };
    let kind: &dyn PictureItem<C, O> = if is_filled {
        kind_of::<C, O, Filled<S>>()
    } else {
        if Border::of(areas).is_none() {
            return replayed(shape, style, window, payload);
        }
        payload.push_all(&[areas.inner.size.height - 1, 0, 0]);
        payload.push_pixel(areas.inner_color.map_or(not_used::<C>(), Band::<C, O>::word));
        if areas.inner_color.is_some() {
            kind_of::<C, O, Stroked<S, true>>()
        } else {
            kind_of::<C, O, Stroked<S, false>>()
        }
    };
    Draft::new(extent, Band::<C, O>::word(areas.color), kind)
}

macro_rules! prepared_round {
    ($($shape:ty),+) => {$(
        impl PreparedShape for $shape {
            fn prepare<'a, C: BandColor, O: Order>(
                &self,
                style: &PrimitiveStyle<C>,
                payload: &mut Payload<'_>,
            ) -> Draft<'a, C, O> {
                match Areas::new(self.bounding_box(), style) {
                    Some(areas) => prepare(self, &areas, style, payload),
                    None => Draft::nothing(),
                }
            }
        }
    )+};
}
prepared_round!(Circle, Ellipse);

/// The row of a curve whose box is that much smaller than an extent, on all sides; above and below the curve its first
/// or last row.
fn enter<S: Round>(extent: Extent, border: i32, row: i32) -> CurveRow {
    let (width, height) = (extent.width() - 2 * border, extent.height() - 2 * border);
    let row = (row - i32::from(extent.first) - border).max(0).min(height - 1);
    // The lower half mirrors the upper one.
    let row = row.min(height - 1 - row);
    let (inset, error_term) = S::enter(Size::new(width as u32, height as u32), row as u32);
    let (left, right) = extent.columns();
    CurveRow {
        start: left + border + inset as i32,
        end: right - border - inset as i32,
        error_term,
    }
}

impl<S: Round, C: BandColor, O: Order> ItemKind<C, O> for Filled<S> {
    #[inline(always)]
    fn enter(slot: &mut PictureSlot<'_, C, O>, _: &mut Pool<'_>, row: i32) {
        slot.cursor = enter::<S>(slot.extent, 0, row).words();
    }

    #[inline(always)]
    fn draw_row(slot: &mut PictureSlot<'_, C, O>, _: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        let extent = slot.extent;
        let row = CurveRow::of(slot.cursor);
        let units = S::units(extent.width(), extent.height());
        let below_middle = extent.below_middle(band.window().top);
        let next = if below_middle < 0 {
            row.next_wider((-1 - below_middle) as u32, units)
        } else {
            row.next_narrower((below_middle + 1) as u32, units)
        };
        slot.cursor = next.words();
        // Last, so that no number has to be kept for later.
        fill_span(band, row.columns(), slot.word);
    }
}

impl<S: Round, C: BandColor, O: Order, const HAS_FILL: bool> ItemKind<C, O> for Stroked<S, HAS_FILL> {
    #[inline(always)]
    fn enter(slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, row: i32) {
        slot.cursor = enter::<S>(slot.extent, 0, row).words();
        if let Some([last_inner, columns, error_term, _]) = pool.array::<4>(slot.at) {
            let border = (slot.extent.height() - 1 - *last_inner as i32) / 2;
            [*columns, *error_term] = enter::<S>(slot.extent, border, row).words();
        }
    }

    #[inline(always)]
    fn draw_row(slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        let Some([last_inner, columns, error_term, fill]) = pool.array::<4>(slot.at) else {
            return;
        };
        let extent = slot.extent;
        let below_middle = extent.below_middle(band.window().top);
        let (width, height) = (extent.width(), extent.height());
        let outer = CurveRow::of(slot.cursor);
        // How far the last row of the inner curve is below the middle, doubled.
        let last_inner = *last_inner as i32;
        let border = height - 1 - last_inner;
        let units = S::units(width, height);
        let inner_units = S::units(width - border, height - border);
        let inner = CurveRow::of([*columns, *error_term]);
        let next_inner;
        if below_middle < 0 {
            let above_middle = (-1 - below_middle) as u32;
            slot.cursor = outer.next_wider(above_middle, units).words();
            if below_middle < -last_inner {
                fill_span(band, outer.columns(), slot.word);
                return;
            }
            next_inner = inner.next_wider(above_middle, inner_units);
        } else {
            let below_next = (below_middle + 1) as u32;
            slot.cursor = outer.next_narrower(below_next, units).words();
            if below_middle > last_inner {
                fill_span(band, outer.columns(), slot.word);
                return;
            }
            next_inner = inner.next_narrower(below_next, inner_units);
        }
        [*columns, *error_term] = next_inner.words();
        if HAS_FILL {
            fill_span(band, inner.columns(), C::Word::from_repeated(*fill));
        }
        fill_sides(band, outer.columns(), inner.start - outer.start, slot.word);
    }
}

/// Fills so many columns at each end of a row's columns.
#[inline(always)]
fn fill_sides<C: BandColor, O: Order>(
    band: &mut Band<'_, C, O>,
    (start, end): (i32, i32),
    columns: i32,
    word: C::Word,
) {
    /// Sides up to so many pixels take less one by one.
    const SHORT: i32 = 8;
    // As an unsigned number, one less than none is beyond all.
    let more = (columns - 1) as u32;
    if more < SHORT as u32 {
        if let Some([first, run @ .., last]) = span_of(band, (start, end)) {
            (*first, *last) = (word, word);
            if more > 0 {
                let more = more as usize;
                let behind = run.len();
                if let Some(run) = run.get_mut(..more) {
                    fill_singly(run, word);
                }
                if let Some(run) = run.get_mut(behind.max(more) - more..) {
                    fill_singly(run, word);
                }
            }
            return;
        }
    }
    fill_span(band, (start, start + columns), word);
    fill_span(band, (end - columns, end), word);
}
