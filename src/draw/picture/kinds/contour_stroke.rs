//! Strokes along contours as items of a picture, alone or over a fill. A fill that leaves out the pixels of a stroke without a colour
//! is kept here, as its style and its vertices: its pixels are generated anew in each band that it meets.
//!
//! ```text
//!     style | fill rule, fraction bits | contours          a fill without its stroke
//! ```
//!
//! Over a fill: how many words those of the stroke are, these words, and the chains of the fill, which is drawn first.

use core::{convert::Infallible, marker::PhantomData, ops::Range};

use embedded_graphics::geometry::Point;

use crate::{
    band::Band,
    draw::{
        FillRule, PrimitiveStyle,
        chains::{self, ContourEdges},
        payload::{Payload, Reader},
        picture::{
            item::{Extent, PictureItem, PictureSlot},
            kinds::{
                contours::{self, ContourWriter, Contours},
                filled_chains,
                replayed::{read_style, translate_point, write_style},
            },
            pool::Pool,
            prepare::{Draft, not_used},
        },
        style::stroke,
    },
    geometry::Window,
    scan::{polygon::scanline_polygon::PartRule, stroke::wide_stroke},
    surface::{BandColor, Order, Target},
};

/// The number of words before the offset of what is generated anew.
const STYLE_WORDS: usize = 7;

const EVEN_ODD: u32 = 1;
const BITS_SHIFT: u32 = 1;

/// Calls with each contour as the path of a stroke.
pub(super) type Paths<'s> = dyn Fn(&mut dyn FnMut(&wide_stroke::Path<'_>)) + 's;

/// A stroke along contours.
pub(super) struct ContourStroke<'s> {
    /// Writes the contours.
    pub(super) write: &'s dyn Fn(&mut ContourWriter<'_, '_>),
    /// The contours again, in the same order.
    pub(super) paths: &'s Paths<'s>,
    /// How many pixels the contours are moved by.
    pub(super) offset: Point,
    pub(super) fraction_bits: u32,
    pub(super) fill_rule: FillRule,
}

impl ContourStroke<'_> {
    /// The item of what a stroke without a colour leaves of the fill.
    pub(super) fn left_out<'a, C: BandColor, O: Order>(
        &self,
        style: &PrimitiveStyle<C>,
        payload: &mut Payload<'_>,
    ) -> Draft<'a, C, O> {
        write_style(style, payload);
        let even_odd = if self.fill_rule == FillRule::EvenOdd {
            EVEN_ODD
        } else {
            0
        };
        payload.push(even_odd | self.fraction_bits << BITS_SHIFT);
        let bounds = contours::write(self.write, self.offset, self.fraction_bits, payload);
        Draft::new(
            Extent::of(&bounds.to_rectangle().into()),
            not_used::<C>(),
            const { &Stroke::<LeftOutStroke>(PhantomData) },
        )
    }
}

/// The item of a stroke over a fill, of which the stroke is written already, behind a first word.
pub(super) fn over_fill<'a, C: BandColor, O: Order, S: StrokeWords>(
    start: usize,
    stroke_bounds: Window,
    (fill_color, edges): (C, &ContourEdges<'_>),
    payload: &mut Payload<'_>,
) -> Draft<'a, C, O> {
    payload.set(start, (payload.needed() - start) as u32);
    let bounds = chains::store(edges, payload).around(&stroke_bounds);
    Draft::new(
        Extent::of(&bounds),
        Band::<C, O>::word(fill_color),
        const { &OverFill::<S>(PhantomData) },
    )
}

/// How a stroke is kept in words.
pub(super) trait StrokeWords: 'static {
    /// Words before the offset.
    const OFFSET: usize;

    /// Sets its cursor to a row.
    fn enter(_words: &mut [u32], _row: i32) {}

    /// Draws a band of one row, that of the cursor.
    fn draw_row<C: BandColor, O: Order>(words: &mut [u32], extent: Extent, band: &mut Band<'_, C, O>);

    /// Draws the rows that a band has, from the cursor's row on.
    fn draw_rows<C: BandColor, O: Order>(words: &mut [u32], extent: Extent, band: &mut Band<'_, C, O>) {
        Self::draw_row(words, extent, band);
    }

    /// Moves it by so many columns and rows.
    fn translate(words: &mut [u32], by: Point) {
        if let Some(offset) = words.get_mut(Self::OFFSET..Self::OFFSET + 2) {
            translate_point(offset, by);
        }
    }
}

/// A fill and a stroke that is left out of it, as polygons that are generated anew.
struct LeftOutStroke;

impl StrokeWords for LeftOutStroke {
    const OFFSET: usize = STYLE_WORDS;

    fn draw_row<C: BandColor, O: Order>(words: &mut [u32], _: Extent, band: &mut Band<'_, C, O>) {
        let mut reader = Reader::new(words);
        let style = read_style::<C>(&mut reader);
        let flags = reader.next();
        let contours = Contours::read(reader, flags >> BITS_SHIFT);
        let rule = PartRule {
            fill_rule: if flags & EVEN_ODD == 0 {
                FillRule::NonZero
            } else {
                FillRule::EvenOdd
            },
            stroke_alignment: style.stroke_alignment,
        };
        let width_in_halves = stroke::width_in_halves(&style);
        let Ok(()) = stroke::draw(band, &style, rule, &|window, sink| {
            let Ok(()) = contours.each(|vertices, is_closed| {
                if stroke::needs_inside(&style) {
                    contours.inside_edges(vertices, sink);
                }
                let vertex = |number: usize| contours.position(vertices, number);
                let path = wide_stroke::Path::new(&vertex, vertices.len() / 2, is_closed, width_in_halves);
                path.edges(window, sink);
                Ok::<(), Infallible>(())
            });
        });
    }
}

/// How a stroke is drawn that has no fill below it.
pub(super) struct Stroke<S>(pub(super) PhantomData<S>);

impl<S: StrokeWords, C: BandColor, O: Order> PictureItem<C, O> for Stroke<S> {
    fn bounds(&self) -> Window {
        Window::EMPTY
    }

    fn draw(&self, _: &mut Band<'_, C, O>) {}

    fn translate(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, by: Point) {
        S::translate(pool.slice_mut(slot.at, slot.words), by);
    }

    fn enter(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, row: i32) {
        S::enter(pool.slice_mut(slot.at, slot.words), row);
    }

    fn draw_row(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        S::draw_row(pool.slice_mut(slot.at, slot.words), slot.extent, band);
    }

    fn draw_rows(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        S::draw_rows(pool.slice_mut(slot.at, slot.words), slot.extent, band);
    }
}

/// How a stroke is drawn over a fill: the first word is how many words lie before the chains of the fill.
struct OverFill<S>(PhantomData<S>);

/// The words of the stroke, and those of the fill.
fn split<'p>(
    slot: &PictureSlot<'_, impl BandColor, impl Order>,
    pool: &'p mut Pool<'_>,
) -> (&'p mut [u32], &'p mut [u32]) {
    let words = pool.slice_mut(slot.at, slot.words);
    let before = words.first().copied().unwrap_or(0) as usize;
    let (stroke, fill) = words.split_at_mut_checked(before).unwrap_or_default();
    (stroke.get_mut(1..).unwrap_or_default(), fill)
}

impl<S: StrokeWords, C: BandColor, O: Order> PictureItem<C, O> for OverFill<S> {
    fn bounds(&self) -> Window {
        Window::EMPTY
    }

    fn draw(&self, _: &mut Band<'_, C, O>) {}

    fn enter(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, row: i32) {
        let (stroke, fill) = split(slot, pool);
        S::enter(stroke, row);
        filled_chains::enter(slot, fill, row);
    }

    fn columns_in(&self, slot: &PictureSlot<'_, C, O>, _: &Pool<'_>, _: Range<i32>) -> (i32, i32) {
        slot.extent.columns()
    }

    fn translate(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, by: Point) {
        let (stroke, fill) = split(slot, pool);
        S::translate(stroke, by);
        chains::translate(fill, by);
    }

    fn draw_row(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        let (stroke, fill) = split(slot, pool);
        filled_chains::draw_row(slot, fill, band);
        S::draw_row(stroke, slot.extent, band);
    }

    fn draw_rows(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        for row in slot.extent.rows(&band.window()) {
            if let Some(mut band) = band.one_row(row) {
                self.draw_row(slot, pool, &mut band);
            }
        }
    }
}
