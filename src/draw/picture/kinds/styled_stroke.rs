//! Strokes with caps, joins and dashes, by copy. Those that cannot be kept in a list of their shapes are drawn anew in each band that
//! meets the stroke, from a colour, the style and the vertices.

use embedded_graphics::{geometry::Point, primitives::Styled};

use crate::{
    band::Band,
    draw::{
        StrokeStyle, StrokedShape,
        payload::Payload,
        picture::{
            item::{Extent, PictureItem, PictureSlot},
            kinds::{
                stored_style::{self, StoredStyle},
                walked_style::{self, WalkedStyle},
            },
            pool::Pool,
            prepare::{Draft, Prepare, not_used},
        },
    },
    geometry::Window,
    surface::{BandColor, Order, PixelWord},
};

impl<'a, S: StrokedShape, C: BandColor, O: Order> Prepare<'a, C, O> for Styled<S, StrokeStyle<'_, C>> {
    fn prepare(&self, payload: &mut Payload<'_>) -> Draft<'a, C, O> {
        let Self { primitive, style } = self;
        let Some(color) = style.color.filter(|_| style.width > 0) else {
            return Draft::nothing();
        };
        let bits = match stored_style::fraction_bits(primitive) {
            Ok(bits) => bits,
            Err(error) => {
                return Draft {
                    segments: Err(error),
                    ..Draft::nothing()
                };
            }
        };
        let stored = StoredStyle::of(style);
        let kind: &dyn PictureItem<C, O> = if walked_style::is_kept(&stored, primitive) {
            payload.push_pixel(Band::<C, O>::word(color));
            walked_style::store(&stored, bits, primitive, payload);
            &WalkedStyle
        } else {
            payload.push_pixel(color.to_word());
            stored.write(bits, payload);
            stored_style::write_paths(primitive, bits, payload);
            &StyledStroke
        };
        let bounds = Window::from(style.bounds(primitive)).around(&style.out_of_reach(primitive));
        Draft::new(Extent::of(&bounds), not_used::<C>(), kind)
    }
}

/// How a stroke with caps, joins and dashes is drawn anew.
struct StyledStroke;

impl<C: BandColor, O: Order> PictureItem<C, O> for StyledStroke {
    fn bounds(&self) -> Window {
        Window::EMPTY
    }

    fn draw(&self, _: &mut Band<'_, C, O>) {}

    fn translate(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, by: Point) {
        stored_style::translate(pool.slice_mut(slot.at, slot.words).get_mut(1..).unwrap_or_default(), by);
    }

    fn draw_row(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        if let Some((color, words)) = pool.slice(slot.at, slot.words).split_first() {
            let (style, paths) = stored_style::read(words);
            let color = C::from_word(C::Word::from_repeated(*color));
            let Ok(()) = style.in_color(color).draw_on(&paths, band);
        }
    }
}
