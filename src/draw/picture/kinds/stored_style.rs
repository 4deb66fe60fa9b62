//! The style of a stroke with caps, joins and dashes and its paths as words.
//!
//! ```text
//!     width | cap, join, fraction bits | offset of dashes | lengths of dashes | a length | .. | contours
//! ```

use core::convert::Infallible;

use bytemuck::TransparentWrapper;
use embedded_graphics::geometry::Point;
use fixed::types::{I16F16, U8F8, U16F16};

use crate::{
    draw::{
        LineCap, LineJoin, StrokeStyle, StrokedShape,
        payload::{Payload, Reader},
        picture::kinds::{
            contours::{self, Contours},
            replayed::translate_point,
        },
    },
    geometry::InputError,
    scan::stroke::{
        DashPattern,
        styled_stroke::StyledStroke,
        wide_stroke::{FRACTION_BITS, Path},
    },
    surface::BandColor,
};

/// The index of the word of a style that says how many lengths of dashes follow it.
const DASHES: usize = 3;

/// The lowest bits of the join, of the number of fraction bits and of the miter limit in the second word of a style; the cap takes the
/// bits below.
const JOIN_SHIFT: u32 = 2;
const BITS_SHIFT: u32 = 4;
const LIMIT_SHIFT: u32 = 16;

/// The number of fractional bits with which the vertices of a stroked shape are kept: the fewest with which all of them are exact.
///
/// # Errors
/// [`InputError::OutOfDomain`] where a vertex does not fit a word then.
pub(super) fn fraction_bits(shape: &dyn StrokedShape) -> Result<u32, InputError> {
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

/// The style of a stroke without its colour: width, caps, joins and dashes.
#[derive(Copy, Clone)]
pub(super) struct StoredStyle<'w> {
    width: u32,
    cap: LineCap,
    join: LineJoin,
    dashes: &'w [U16F16],
    dash_offset: I16F16,
}

impl<'w> StoredStyle<'w> {
    pub(super) fn of<C: BandColor>(style: &StrokeStyle<'w, C>) -> Self {
        Self {
            width: style.width,
            cap: style.cap,
            join: style.join,
            dashes: style.dashes.unwrap_or_default(),
            dash_offset: style.dash_offset,
        }
    }

    /// The style in a colour.
    pub(super) fn in_color<C: BandColor>(&self, color: C) -> StrokeStyle<'w, C> {
        StrokeStyle {
            cap: self.cap,
            join: self.join,
            dashes: Some(self.dashes).filter(|dashes| !dashes.is_empty()),
            dash_offset: self.dash_offset,
            ..StrokeStyle::new(color, self.width)
        }
    }

    pub(super) fn width_in_halves(&self) -> u64 {
        2 * u64::from(self.width)
    }

    pub(super) const fn has_dashes(&self) -> bool {
        !self.dashes.is_empty()
    }

    fn dash_pattern(&self) -> Option<DashPattern<'w>> {
        self.has_dashes()
            .then(|| DashPattern::new(self.dashes).offset(self.dash_offset))
    }

    /// Half the width of the stroke, in units.
    pub(super) fn radius(&self) -> i32 {
        let no_vertex = |_| (0, 0);
        // Not more than 2,048 pixels.
        Path::new(&no_vertex, 0, false, self.width_in_halves()).half_width as i32
    }

    /// The stroke of a path.
    pub(super) fn stroke<'p>(&self, path: &Path<'p>) -> StyledStroke<'p>
    where
        'w: 'p,
    {
        StyledStroke::new(path, self.cap, self.join, self.dash_pattern())
    }

    /// The stroke of a path, for segments and corners one by one.
    pub(super) fn part<'p>(&self, path: &Path<'p>) -> StyledStroke<'p>
    where
        'w: 'p,
    {
        StyledStroke::without_first_corner(path, self.cap, self.join, self.dash_pattern())
    }

    /// Writes a style.
    pub(super) fn write(&self, fraction_bits: u32, payload: &mut Payload<'_>) {
        let cap = match self.cap {
            LineCap::WholePixel => 0,
            LineCap::Butt => 1,
            LineCap::Square => 2,
            LineCap::Round => 3,
        };
        let (join, limit) = match self.join {
            LineJoin::Miter { limit } => (0, limit.to_bits()),
            LineJoin::Bevel => (1, 0),
            LineJoin::Round => (2, 0),
        };
        payload.push_all(&[
            self.width,
            cap | join << JOIN_SHIFT | fraction_bits << BITS_SHIFT | u32::from(limit) << LIMIT_SHIFT,
            self.dash_offset.to_bits() as u32,
            self.dashes.len() as u32,
        ]);
        payload.push_all(U16F16::peel_slice(self.dashes));
    }
}

/// Writes the paths of a shape.
pub(super) fn write_paths(shape: &dyn StrokedShape, fraction_bits: u32, payload: &mut Payload<'_>) {
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
pub(super) fn read(words: &[u32]) -> (StoredStyle<'_>, StoredPaths<'_>) {
    let mut reader = Reader::new(words);
    let [width, ends, dash_offset, dashes] = [(); 4].map(|()| reader.next());
    let (lengths, behind) = reader.rest().split_at_checked(dashes as usize).unwrap_or_default();
    let style = StoredStyle {
        width,
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
        dashes: U16F16::wrap_slice(lengths),
        dash_offset: I16F16::from_bits(dash_offset as i32),
    };
    let fraction_bits = ends >> BITS_SHIFT & 31;
    (style, StoredPaths(Contours::read(Reader::new(behind), fraction_bits)))
}

/// Moves the paths behind a style by so many columns and rows.
pub(super) fn translate(words: &mut [u32], by: Point) {
    let dashes = words.get(DASHES).copied().unwrap_or_default() as usize;
    if let Some(offset) = words.get_mut(DASHES + 1..).and_then(|words| words.get_mut(dashes..)) {
        translate_point(offset, by);
    }
}

/// The paths of a stroke, as contours of words.
pub(super) struct StoredPaths<'w>(pub(super) Contours<'w>);

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
