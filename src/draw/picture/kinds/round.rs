//! Circles and ellipses in a picture: the columns of a row are computed from those of the row above, in both halves.
//!
//! With doubled distances x and y from the middle, a pixel is inside while `b x^2 + a y^2 < limit`. The error term of a row
//! is the least number by which the sum would have to be smaller for one more column on each side to be inside. In the next
//! row nearer to the middle, the sum is smaller by the row's increment: that pays for new columns, each of which raises the
//! sum by its own. In the next row further away the sum is larger by the row's increment, and columns are given up:
//!
//! ```text
//!   upper half:  error term -= row's;  while some of that is left over: one column more, error term = the column's
//!   lower half:  error term += row's;  while it exceeds the last column's: one column less
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
            item::{Extent, ItemKind, PictureItem, PictureSlot, fill_span, kind_of},
            kinds::{
                circle_outline::{self, CircleOutline},
                rectangle::Border,
                replayed::{Words, replayed},
                sides::fill_sides,
            },
            pool::Pool,
            prepare::{CopiedShape, Draft, not_used},
        },
    },
    scan::round::{ForwardDifference, circle, ellipse},
    surface::{BandColor, Order, PixelWord, Target},
};

/// A row of a curve: the columns that are inside, and the error term for the columns beside them.
#[derive(Clone, Copy)]
struct CurveRow {
    /// First column.
    start: i32,
    /// The column after the last one.
    end: i32,
    /// By how much the sum of squares would have to be smaller for one more column on each side to be inside.
    error_term: u32,
}

impl CurveRow {
    /// The row as two words: the first one has both columns, 16 bits each.
    #[inline]
    const fn words(self) -> [u32; 2] {
        [(self.start as u32 & 0xffff) | (self.end as u32) << 16, self.error_term]
    }

    #[inline]
    const fn of([columns, error_term]: [u32; 2]) -> Self {
        Self {
            start: columns as i16 as i32,
            end: columns as i32 >> 16,
            error_term,
        }
    }

    /// First column, and the one after the last.
    #[inline]
    const fn columns(self) -> (i32, i32) {
        (self.start, self.end)
    }

    /// The row below this one, which is half of `below_middle` rows below the middle.
    #[inline(always)]
    fn next(self, below_middle: i32, units: (u32, u32)) -> Self {
        if below_middle < 0 {
            self.next_wider((-1 - below_middle) as u32, units)
        } else {
            self.next_narrower((below_middle + 1) as u32, units)
        }
    }

    /// The row below this one in the upper half. `above_middle` is twice the distance of this row from the middle, less one.
    #[inline]
    fn next_wider(self, above_middle: u32, (column_unit, row_unit): (u32, u32)) -> Self {
        let mut column_increment = (self.end - self.start) as u32 * column_unit;
        let mut row_increment = above_middle * row_unit;
        let (mut error_term, mut added) = (self.error_term, 0);
        while row_increment >= error_term {
            row_increment -= error_term;
            added += 1;
            column_increment += 2 * column_unit;
            error_term = column_increment;
            // Keeps the compiler from unrolling this loop, which mostly runs once.
            black_box(());
        }
        Self {
            start: self.start - added,
            end: self.end + added,
            error_term: error_term - row_increment,
        }
    }

    /// The row below this one in the lower half. `below_middle` is twice the distance of this row from the middle, plus one.
    #[inline]
    fn next_narrower(self, below_middle: u32, (column_unit, row_unit): (u32, u32)) -> Self {
        // After the last row no column may be left to give up. The increment then wraps around below 0 to a number larger than the
        // error term, which ends the loop.
        let mut column_increment = Wrapping((self.end - self.start) as u32 * column_unit);
        let column_step = Wrapping(2 * column_unit);
        let mut error_term = self.error_term + below_middle * row_unit;
        let mut removed = 0;
        while error_term > column_increment.0 {
            error_term -= column_increment.0;
            column_increment -= column_step;
            removed += 1;
            black_box(());
        }
        Self {
            start: self.start + removed,
            end: self.end - removed,
            error_term,
        }
    }
}

/// A shape whose rows this file steps through: a circle or an ellipse.
trait Round: 'static {
    /// Whether every row of the curve has pixels and its error terms fit 32 bits. Both sides are below 2^16.
    fn fits(size: Size) -> bool;

    /// Columns of the box before the first pixel in a row of the upper half, and the error term.
    fn enter(size: Size, row: u32) -> (u32, u32);

    /// The kind of an outline of one pixel and without a fill, where the shape has one of its own.
    fn outline<C: BandColor, O: Order>(_: Size) -> Option<&'static dyn PictureItem<C, O>> {
        None
    }

    /// The factors b and a: the increments of a column and of a row are their products with a doubled distance.
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

    fn outline<C: BandColor, O: Order>(size: Size) -> Option<&'static dyn PictureItem<C, O>> {
        (size.width <= circle_outline::MOST).then(kind_of::<C, O, CircleOutline>)
    }

    #[inline]
    fn units(_: i32, _: i32) -> (u32, u32) {
        (1, 1)
    }
}

/// The widest ellipse that is stepped through: in a flat one, a row may have half of the columns more than the row above, and
/// the loop runs once for each of them.
const MOST_COLUMNS: u64 = 2_048;
/// The highest ellipse that is stepped through: the square of its height is below 2^31, so that the increment of a column, at
/// most twice that, is below 2^32.
const MOST_ROWS: u64 = 46_340;

impl Round for Ellipse {
    fn fits(size: Size) -> bool {
        let (width, height) = (u64::from(size.width), u64::from(size.height));
        // The product bounds the sum of a column's and a row's increment.
        width <= MOST_COLUMNS
            && height <= MOST_ROWS
            && width * height * (width + height) <= u64::from(u32::MAX)
            && ellipse::first_row(size) == 0
    }

    fn enter(size: Size, row: u32) -> (u32, u32) {
        let ForwardDifference { inset, error_term, .. } = ellipse::enter_narrow(size, row);
        // For equal sides, `ellipse` returns the error term of a circle, which is in units of the squared side.
        let unit = if size.width == size.height {
            size.width * size.width
        } else {
            1
        };
        (inset, error_term * unit)
    }

    #[inline]
    fn units(width: i32, height: i32) -> (u32, u32) {
        ((height * height) as u32, (width * width) as u32)
    }
}

/// A curve filled with one colour. The item's cursor is its next [`CurveRow`].
struct Filled<S>(PhantomData<S>);

/// A stroke between an outer and an inner curve, with or without a fill. The item's cursor is the next [`CurveRow`] of the outer
/// curve. Its four words are the number of the inner curve's last row, the next row of the inner curve (two words), and the
/// fill's colour.
struct Stroked<S, const HAS_FILL: bool>(PhantomData<S>);

/// The item of a circle or an ellipse.
fn prepare<'a, S: Round + Words + StyledShape, C: BandColor, O: Order>(
    shape: &S,
    areas: &Areas<C>,
    style: &PrimitiveStyle<C>,
    payload: &mut Payload<'_>,
) -> Draft<'a, C, O> {
    let is_filled = areas.inner.is_empty();
    // Both sides of an extent are below 2^16, and the inner area is not larger than the outer one.
    let fits = || S::fits(areas.outer.size) && (is_filled || S::fits(areas.inner.size));
    let Some(extent) = Extent::of_box(&areas.outer).filter(|_| fits()) else {
        return replayed(shape, style, areas.outer.to_window(), payload);
    };
    let kind: &dyn PictureItem<C, O> = if is_filled {
        kind_of::<C, O, Filled<S>>()
    } else {
        let Some(border) = Border::of(areas) else {
            return replayed(shape, style, areas.outer.to_window(), payload);
        };
        if let (1, false, Some(kind)) = (border.width(), border.is_filled(), S::outline::<C, O>(areas.outer.size)) {
            return Draft::new(extent, Band::<C, O>::word(areas.color), kind);
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
        impl CopiedShape for $shape {
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

/// A row of the curve whose box lies inside of an extent by `border` pixels on each side. For a row above or below that box, it
/// is the curve's first or last row.
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
    #[inline]
    fn enter(slot: &mut PictureSlot<'_, C, O>, _: &mut Pool<'_>, row: i32) {
        slot.cursor = enter::<S>(slot.extent, 0, row).words();
    }

    #[inline(always)]
    fn draw_row(slot: &mut PictureSlot<'_, C, O>, _: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        let extent = slot.extent;
        let row = CurveRow::of(slot.cursor);
        let units = S::units(extent.width(), extent.height());
        let below_middle = extent.below_middle(band.window().top);
        slot.cursor = row.next(below_middle, units).words();
        // Filled last: while pixels are written, no other number has to be kept in a register.
        fill_span(band, row.columns(), slot.word);
    }
}

impl<S: Round, C: BandColor, O: Order, const HAS_FILL: bool> ItemKind<C, O> for Stroked<S, HAS_FILL> {
    #[inline]
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
        slot.cursor = outer.next(below_middle, S::units(width, height)).words();
        // The number of the inner curve's last row is also twice its distance from the middle.
        if below_middle.unsigned_abs() > *last_inner {
            fill_span(band, outer.columns(), slot.word);
            return;
        }
        let border = height - 1 - *last_inner as i32;
        let inner = CurveRow::of([*columns, *error_term]);
        let next_inner = inner.next(below_middle, S::units(width - border, height - border));
        [*columns, *error_term] = next_inner.words();
        if HAS_FILL {
            fill_span(band, inner.columns(), C::Word::from_repeated(*fill));
        }
        fill_sides(band, outer.columns(), inner.start - outer.start, slot.word);
    }
}
