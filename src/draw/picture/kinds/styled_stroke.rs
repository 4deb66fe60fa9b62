//! Strokes with caps, joins and dashes, by copy: the style and the vertices are words, the pixels are generated anew in each band that
//! meets the stroke.
//!
//! ```text
//!     colour | width | cap, join, fraction bits | offset of dashes | lengths of dashes | a length | .. | contours
//! ```

use core::convert::Infallible;

use bytemuck::TransparentWrapper;
use embedded_graphics::{geometry::Point, primitives::Styled};
use fixed::types::{I16F16, U8F8, U16F16};

use crate::{
    band::Band,
    draw::{
        LineCap, LineJoin, StrokeStyle, StrokedShape,
        payload::{Payload, Reader},
        picture::{
            item::{Extent, PictureItem, PictureSlot},
            kinds::{
                contours::{self, Contours},
                replayed::translate_point,
            },
            pool::Pool,
            prepare::{Draft, Prepare, not_used},
        },
    },
    geometry::{InputError, Window},
    scan::stroke::wide_stroke::{FRACTION_BITS, Path},
    surface::{BandColor, Order},
};

/// The index of the word of a stroke that says how many lengths of dashes follow it.
const DASHES: usize = 4;

/// The lowest bits of the join, of the number of fraction bits and of the miter limit in the third word of a stroke; the cap takes the
/// bits below.
const JOIN_SHIFT: u32 = 2;
const BITS_SHIFT: u32 = 4;
const LIMIT_SHIFT: u32 = 16;

impl<'a, S: StrokedShape, C: BandColor, O: Order> Prepare<'a, C, O> for Styled<S, StrokeStyle<'_, C>> {
    fn prepare(&self, payload: &mut Payload<'_>) -> Draft<'a, C, O> {
        let Self { primitive, style } = self;
        let Some(color) = style.color.filter(|_| style.width > 0) else {
            return Draft::nothing();
        };
        let bits = match fraction_bits(primitive) {
            Ok(bits) => bits,
            Err(error) => {
                return Draft {
                    segments: Err(error),
                    ..Draft::nothing()
                };
            }
        };
        payload.push_pixel(color.to_word());
        write_style(style, bits, payload);
        write_paths(primitive, bits, payload);
        let bounds = Window::from(style.bounds(primitive)).around(&style.out_of_reach(primitive));
        Draft::new(Extent::of(&bounds), not_used::<C>(), &StyledStroke)
    }
}

/// The number of fractional bits with which the vertices of a stroked shape are kept: the fewest with which all of them are exact.
///
/// # Errors
/// [`InputError::OutOfDomain`] where a vertex does not fit a word then.
fn fraction_bits(shape: &dyn StrokedShape) -> Result<u32, InputError> {
    let (mut fraction, mut least, mut most) = (1i64 << FRACTION_BITS, 0i64, 0i64);
    shape.paths(0, &mut |path| {
        for (x, y) in (0..path.count).map(path.vertex) {
            fraction |= x | y;
            least = least.min(x).min(y);
            most = most.max(x).max(y);
        }
    });
    let zeros = fraction.trailing_zeros();
    let bits = FRACTION_BITS - zeros;
    if least >> zeros < i64::from(i32::MIN) || most >> zeros > i64::from(i32::MAX) {
        return Err(InputError::OutOfDomain {
            min: i32::MIN >> bits,
            max: i32::MAX >> bits,
        });
    }
    Ok(bits)
}

/// Writes a style but for its colour.
fn write_style<C: BandColor>(style: &StrokeStyle<'_, C>, fraction_bits: u32, payload: &mut Payload<'_>) {
    let cap = match style.cap {
        LineCap::WholePixel => 0,
        LineCap::Butt => 1,
        LineCap::Square => 2,
        LineCap::Round => 3,
    };
    let (join, limit) = match style.join {
        LineJoin::Miter { limit } => (0, limit.to_bits()),
        LineJoin::Bevel => (1, 0),
        LineJoin::Round => (2, 0),
    };
    let dashes = style.dashes.unwrap_or_default();
    payload.push_all(&[
        style.width,
        cap | join << JOIN_SHIFT | fraction_bits << BITS_SHIFT | u32::from(limit) << LIMIT_SHIFT,
        style.dash_offset.to_bits() as u32,
        dashes.len() as u32,
    ]);
    payload.push_all(U16F16::peel_slice(dashes));
}

/// Writes the paths of a shape.
fn write_paths(shape: &dyn StrokedShape, fraction_bits: u32, payload: &mut Payload<'_>) {
    let write = |writer: &mut contours::ContourWriter<'_, '_>| {
        shape.paths(0, &mut |path| {
            writer.begin();
            for (x, y) in (0..path.count).map(path.vertex) {
                // Fits: there are as many fractional bits as that takes.
                writer.push([x, y].map(|units| (units >> (FRACTION_BITS - fraction_bits)) as i32));
            }
            writer.end(path.closed, false);
        });
    };
    contours::write(&write, Point::zero(), fraction_bits, payload);
}

/// A style and its paths, read from words.
fn read<C: BandColor>(words: &[u32]) -> (StrokeStyle<'_, C>, StoredPaths<'_>) {
    let mut reader = Reader::new(words);
    let color = C::from_word(reader.next_pixel());
    let [width, ends, dash_offset, dashes] = [(); 4].map(|()| reader.next());
    let (lengths, behind) = reader.rest().split_at_checked(dashes as usize).unwrap_or_default();
    let style = StrokeStyle {
        cap: match ends & 3 {
            0 => LineCap::WholePixel,
            1 => LineCap::Butt,
            2 => LineCap::Square,
            _ => LineCap::Round,
        },
        join: match ends >> JOIN_SHIFT & 3 {
            0 => LineJoin::Miter {
                limit: U8F8::from_bits((ends >> LIMIT_SHIFT) as u16),
            },
            1 => LineJoin::Bevel,
            _ => LineJoin::Round,
        },
        dashes: Some(U16F16::wrap_slice(lengths)).filter(|lengths| !lengths.is_empty()),
        dash_offset: I16F16::from_bits(dash_offset as i32),
        ..StrokeStyle::new(color, width)
    };
    let fraction_bits = ends >> BITS_SHIFT & 31;
    (style, StoredPaths(Contours::read(Reader::new(behind), fraction_bits)))
}

/// The paths of a stroke, as contours of words.
struct StoredPaths<'w>(Contours<'w>);

impl StrokedShape for StoredPaths<'_> {
    fn paths(&self, width_in_halves: u64, call: &mut dyn FnMut(&Path<'_>)) {
        let Ok(()) = self.0.each(|vertices, is_closed| {
            let vertex = |number: usize| self.0.position(vertices, number);
            call(&Path::new(&vertex, vertices.len() / 2, is_closed, width_in_halves));
            Ok::<(), Infallible>(())
        });
    }

    fn is_one_path(&self) -> bool {
        let mut paths = 0;
        self.paths(0, &mut |_| paths += 1);
        paths == 1
    }
}

/// How a stroke with caps, joins and dashes is drawn.
struct StyledStroke;

impl<C: BandColor, O: Order> PictureItem<C, O> for StyledStroke {
    fn bounds(&self) -> Window {
        Window::EMPTY
    }

    fn draw(&self, _: &mut Band<'_, C, O>) {}

    fn translate(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, by: Point) {
        let words = pool.slice_mut(slot.at, slot.words);
        let dashes = words.get(DASHES).copied().unwrap_or_default() as usize;
        if let Some(offset) = words.get_mut(DASHES + 1..).and_then(|words| words.get_mut(dashes..)) {
            translate_point(offset, by);
        }
    }

    fn draw_row(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        let (style, paths) = read::<C>(pool.slice(slot.at, slot.words));
        let Ok(()) = style.draw_on(&paths, band);
    }
}
