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
            item::{Extent, ItemKind, PictureItem, PictureSlot, fill_short_span, fill_span, kind_of},
            kinds::{
                rectangle::Border,
                replayed::{Words, replayed},
            },
            pool::Pool,
            prepare::{Draft, PreparedShape},
        },
    },
    scan::round::{circle, ellipse},
    surface::{BandColor, Order, PixelWord, Target},
};

/// Where a curve is in a row.
#[derive(Clone, Copy)]
struct Walk {
    /// Columns of the box before the first pixel.
    inset: i32,
    /// What the row lacks for one column more.
    error_term: u32,
}

impl Walk {
    /// The walk as two words.
    const fn words(self) -> [u32; 2] {
        [self.inset as u32, self.error_term]
    }

    const fn of([inset, error_term]: [u32; 2]) -> Self {
        Self {
            inset: inset as i32,
            error_term,
        }
    }

    /// The walk in the next row, from one so far (doubled) below the middle.
    #[inline(always)]
    fn next(mut self, below_middle: i32, width: i32, (column_unit, row_unit): (u32, u32)) -> Self {
        // Behind the last row, which may be left with no column to give back, it is below 0: larger than any number,
        // which ends the loop.
        let mut cost = Wrapping((width - 2 * self.inset) as u32 * column_unit);
        let cost_step = Wrapping(2 * column_unit);
        if below_middle < 0 {
            let mut gain = (-1 - below_middle) as u32 * row_unit;
            while gain >= self.error_term {
                gain -= self.error_term;
                self.inset -= 1;
                cost += cost_step;
                self.error_term = cost.0;
                // Keeps this loop, of one round mostly, from being unrolled.
                black_box(());
            }
            self.error_term -= gain;
        } else {
            self.error_term += (below_middle + 1) as u32 * row_unit;
            while self.error_term > cost.0 {
                self.error_term -= cost.0;
                cost -= cost_step;
                self.inset += 1;
                black_box(());
            }
        }
        self
    }
}

/// Circles or ellipses.
trait Round: 'static {
    /// Whether each row has pixels, and the numbers of the walk fit, for sides below 2^16.
    fn fits(size: Size) -> bool;

    /// The walk in a row.
    fn enter(size: Size, row: u32) -> Walk;

    /// What a column costs and a row gains, each as a multiple of a doubled distance.
    fn units(width: i32, height: i32) -> (u32, u32);
}

impl Round for Circle {
    fn fits(_: Size) -> bool {
        true
    }

    fn enter(size: Size, row: u32) -> Walk {
        let walk = circle::enter(size.width, row);
        Walk {
            inset: walk.inset as i32,
            error_term: walk.error_term,
        }
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

    fn enter(size: Size, row: u32) -> Walk {
        let walk = ellipse::enter_narrow(size, row);
        Walk {
            inset: walk.inset as i32,
            error_term: walk.error_term,
        }
    }

    #[inline(always)]
    fn units(width: i32, height: i32) -> (u32, u32) {
        // A circle's walk has other units.
        if width == height {
            (1, 1)
        } else {
            ((height * height) as u32, (width * width) as u32)
        }
    }
}

/// One colour within the curve. The cursor is the walk.
struct Filled<S>(PhantomData<S>);

/// A stroke along the curve, with or without a fill. The cursor is the outer walk; the words are the [`Border`], the
/// fill's colour and the inner walk.
struct Stroked<S>(PhantomData<S>);

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
        let Some(border) = Border::of(areas) else {
            return replayed(shape, style, window, payload);
        };
        border.push::<C, O>(areas.inner_color, payload);
        payload.push_all(&[0; 2]);
        kind_of::<C, O, Stroked<S>>()
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

/// The walk in a row of a box within an extent, which is smaller by a border.
fn enter<S: Round>(extent: Extent, border: i32, row: i32) -> Walk {
    let (width, height) = (extent.width() - 2 * border, extent.height() - 2 * border);
    let row = (row - i32::from(extent.first) - border).max(0).min(height - 1);
    // The lower half mirrors the upper one.
    let row = row.min(height - 1 - row);
    S::enter(Size::new(width as u32, height as u32), row as u32)
}

impl<S: Round, C: BandColor, O: Order> ItemKind<C, O> for Filled<S> {
    #[inline(always)]
    fn enter(slot: &mut PictureSlot<'_, C, O>, _: &mut Pool<'_>, row: i32) {
        slot.cursor = enter::<S>(slot.extent, 0, row).words();
    }

    #[inline(always)]
    fn draw_row(slot: &mut PictureSlot<'_, C, O>, _: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        let extent = slot.extent;
        let (left, right) = extent.columns();
        let walk = Walk::of(slot.cursor);
        let units = S::units(extent.width(), extent.height());
        let next = walk.next(extent.below_middle(band.window().top), extent.width(), units);
        slot.cursor = next.words();
        // Last, so that no number has to be kept for later.
        fill_span(band, (left + walk.inset, right - walk.inset), slot.word);
    }
}

impl<S: Round, C: BandColor, O: Order> ItemKind<C, O> for Stroked<S> {
    #[inline(always)]
    fn enter(slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, row: i32) {
        slot.cursor = enter::<S>(slot.extent, 0, row).words();
        if let Some([border, _, inner @ ..]) = pool.array::<4>(slot.at) {
            *inner = enter::<S>(slot.extent, Border(*border).width(), row).words();
        }
    }

    #[inline(always)]
    fn draw_row(slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        let Some([border, fill, inner @ ..]) = pool.array::<4>(slot.at) else {
            return;
        };
        let border = Border(*border);
        let extent = slot.extent;
        let y = band.window().top;
        let below_middle = extent.below_middle(y);
        let (width, height) = (extent.width(), extent.height());
        let (left, right) = extent.columns();

        let walk = Walk::of(slot.cursor);
        let outer = (left + walk.inset, right - walk.inset);
        slot.cursor = walk.next(below_middle, width, S::units(width, height)).words();
        if border.has_row(extent, y) {
            fill_span(band, outer, slot.word);
            return;
        }

        let walk = Walk::of(*inner);
        let (width, height) = (width - 2 * border.width(), height - 2 * border.width());
        let inset = border.width() + walk.inset;
        let hole = (left + inset, right - inset);
        *inner = walk.next(below_middle, width, S::units(width, height)).words();
        if border.is_filled() {
            fill_span(band, hole, C::Word::from_repeated(*fill));
        }
        fill_sides(band, outer, hole, slot.word);
    }
}

/// Fills a row's columns that are in the outer ones and not in the hole.
#[inline(always)]
fn fill_sides<C: BandColor, O: Order>(band: &mut Band<'_, C, O>, outer: (i32, i32), hole: (i32, i32), word: C::Word) {
    /// Sides up to so many pixels take less one by one.
    const SHORT: i32 = 8;
    if hole.0 - outer.0 > SHORT {
        fill_span(band, (outer.0, hole.0), word);
        fill_span(band, (hole.1, outer.1), word);
        return;
    }
    fill_short_span(band, (outer.0, hole.0), word);
    fill_short_span(band, (hole.1, outer.1), word);
}
