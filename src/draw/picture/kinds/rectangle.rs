//! Rectangles: the same columns in every row, and no cursor.

use embedded_graphics::primitives::Rectangle;

use crate::{
    band::Band,
    draw::{
        PrimitiveStyle,
        eg::areas::Areas,
        payload::Payload,
        picture::{
            item::{Extent, ItemKind, PictureItem, PictureSlot, fill_span, kind_of},
            kinds::replayed::replayed,
            pool::Pool,
            prepare::{CopiedShape, Draft, not_used},
        },
    },
    geometry::WideRectangle,
    surface::{BandColor, Order, PixelWord, Target},
};

/// A rectangle in one colour.
struct FilledRectangle;

/// A stroke around a rectangle, with or without a fill. Its words: the stroke's [`Border`], and the fill's colour.
struct StrokedRectangle;

impl CopiedShape for Rectangle {
    fn prepare<'a, C: BandColor, O: Order>(
        &self,
        style: &PrimitiveStyle<C>,
        payload: &mut Payload<'_>,
    ) -> Draft<'a, C, O> {
        let Some(areas) = Areas::new(*self, style) else {
            return Draft::nothing();
        };
        let kind: &dyn PictureItem<C, O> = if areas.inner.is_empty() {
            kind_of::<C, O, FilledRectangle>()
        } else {
            let Some(border) = Border::of(&areas) else {
                return replayed(self, style, areas.outer.to_window(), payload);
            };
            border.push::<C, O>(areas.inner_color, payload);
            kind_of::<C, O, StrokedRectangle>()
        };
        let extent = Extent::of_box(&areas.outer).unwrap_or_else(|| Extent::of(&areas.outer.to_window()));
        Draft::new(extent, Band::<C, O>::word(areas.color), kind)
    }
}

impl<C: BandColor, O: Order> ItemKind<C, O> for FilledRectangle {
    #[inline(always)]
    fn draw_row(slot: &mut PictureSlot<'_, C, O>, _: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        fill_span(band, slot.extent.columns(), slot.word);
    }
}

impl<C: BandColor, O: Order> ItemKind<C, O> for StrokedRectangle {
    #[inline(always)]
    fn draw_row(slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        let Some([border, fill]) = pool.array(slot.at) else {
            return;
        };
        let border = Border(*border);
        let fill: Option<C::Word> = border.is_filled().then(|| C::Word::from_repeated(*fill));
        let (left, right) = slot.extent.columns();
        let inner = (left + border.width(), right - border.width());
        if border.has_row(slot.extent, band.window().top) {
            fill_span(band, (left, right), slot.word);
            return;
        }
        fill_span(band, (left, inner.0), slot.word);
        if let Some(fill) = fill {
            fill_span(band, inner, fill);
        }
        fill_span(band, (inner.1, right), slot.word);
    }
}

/// The width of a stroke that lies within an extent, on all sides the same, and whether there is a fill in it.
#[derive(Clone, Copy)]
pub(super) struct Border(pub(super) u32);

impl Border {
    const FILLED: u32 = 1 << 31;

    /// The stroke between two areas, of which the inner one is not empty; `None` where an extent cannot hold the outer
    /// one.
    pub(super) fn of<C: Copy>(areas: &Areas<C>) -> Option<Self> {
        let Areas { outer, inner, .. } = areas;
        Extent::of_box(outer)?;
        let width = i64::from(outer.size.width - inner.size.width) / 2;
        let is_centred = |outer: &WideRectangle, inner: &WideRectangle| {
            inner.left - outer.left == width
                && inner.top - outer.top == width
                && outer.size.height - inner.size.height == outer.size.width - inner.size.width
        };
        if !is_centred(outer, inner) {
            return None;
        }
        let filled = if areas.inner_color.is_some() { Self::FILLED } else { 0 };
        Some(Self(width as u32 | filled))
    }

    /// Writes the stroke's and the fill's word.
    pub(super) fn push<C: BandColor, O: Order>(self, fill: Option<C>, payload: &mut Payload<'_>) {
        payload.push(self.0);
        payload.push_pixel(fill.map_or(not_used::<C>(), Band::<C, O>::word));
    }

    #[inline]
    pub(super) const fn width(self) -> i32 {
        (self.0 & !Self::FILLED) as i32
    }

    #[inline]
    pub(super) const fn is_filled(self) -> bool {
        self.0 & Self::FILLED != 0
    }

    /// Whether a row is above or below what is in the stroke.
    #[inline]
    pub(super) fn has_row(self, extent: Extent, row: i32) -> bool {
        row < i32::from(extent.first) + self.width() || row >= i32::from(extent.end) - self.width()
    }
}
