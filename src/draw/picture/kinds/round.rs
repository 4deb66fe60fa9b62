//! Circles and ellipses in a picture: the columns of a row are computed from those of the row above, in both halves.
//!
//! How a row follows from the one above is told at [`CurveRow`].
//!
//! Guarantees: the pixels of the shapes' own walk, in additions; no number exceeds 2^32.

use embedded_graphics::{
    geometry::{Dimensions, Size},
    primitives::{Circle, Ellipse},
};

use core::marker::PhantomData;

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
                curve_row::CurveRow,
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

/// A curve filled with one colour. The item's cursor is the [`CurveRow`] above the row that comes next.
struct Filled<S>(PhantomData<S>);

/// A stroke between an outer and an inner curve, with or without a fill. The item's cursor is the [`CurveRow`] of the outer curve
/// above the row that comes next. Its four words are the number of the inner curve's last row, the row of the inner curve (two
/// words), and the fill's colour.
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

/// What leads to a row of the curve whose box lies inside of an extent by `border` pixels on each side. For a row above or below that
/// box, it leads to the curve's first or last row.
fn enter<S: Round>(extent: Extent, border: i32, row: i32) -> CurveRow {
    let (width, height) = (extent.width() - 2 * border, extent.height() - 2 * border);
    let first = i32::from(extent.first) + border;
    let row = row.min(first + height - 1).max(first);
    // The lower half mirrors the upper one.
    let down = (row - first).min(first + height - 1 - row);
    let (inset, error_term) = S::enter(Size::new(width as u32, height as u32), down as u32);
    let (left, right) = extent.columns();
    let entered = CurveRow {
        start: left + border + inset as i32,
        end: right - border - inset as i32,
        slack: error_term - 1,
    };
    let (_, row_unit) = S::units(width, height);
    entered.above(extent.edge_below_middle(row), row_unit)
}

impl<S: Round, C: BandColor, O: Order> ItemKind<C, O> for Filled<S> {
    #[inline]
    fn enter(slot: &mut PictureSlot<'_, C, O>, _: &mut Pool<'_>, row: i32) {
        slot.cursor = enter::<S>(slot.extent, 0, row).words();
    }

    #[inline(always)]
    fn draw_row(slot: &mut PictureSlot<'_, C, O>, _: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        let extent = slot.extent;
        let units = S::units(extent.width(), extent.height());
        let edge = extent.edge_below_middle(band.window().top);
        let row = CurveRow::of(slot.cursor).next(edge, units);
        slot.cursor = row.words();
        // Filled last: while pixels are written, no other number has to be kept in a register.
        fill_span(band, row.columns(), slot.word);
    }
}

impl<S: Round, C: BandColor, O: Order, const HAS_FILL: bool> ItemKind<C, O> for Stroked<S, HAS_FILL> {
    #[inline]
    fn enter(slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, row: i32) {
        slot.cursor = enter::<S>(slot.extent, 0, row).words();
        if let Some([last_inner, columns, slack, _]) = pool.array::<4>(slot.at) {
            let border = (slot.extent.height() - 1 - *last_inner as i32) / 2;
            [*columns, *slack] = enter::<S>(slot.extent, border, row).words();
        }
    }

    #[inline(always)]
    fn draw_row(slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        let Some([last_inner, columns, slack, fill]) = pool.array::<4>(slot.at) else {
            return;
        };
        let extent = slot.extent;
        let edge = extent.edge_below_middle(band.window().top);
        let (width, height) = (extent.width(), extent.height());
        let outer = CurveRow::of(slot.cursor).next(edge, S::units(width, height));
        slot.cursor = outer.words();
        // The number of the inner curve's last row is also twice its distance from the middle.
        if (edge + 1).unsigned_abs() > *last_inner {
            fill_span(band, outer.columns(), slot.word);
            return;
        }
        let border = height - 1 - *last_inner as i32;
        let inner = CurveRow::of([*columns, *slack]).next(edge, S::units(width - border, height - border));
        [*columns, *slack] = inner.words();
        if HAS_FILL {
            fill_span(band, inner.columns(), C::Word::from_repeated(*fill));
        }
        fill_sides(band, outer.columns(), inner.start - outer.start, slot.word);
    }
}
