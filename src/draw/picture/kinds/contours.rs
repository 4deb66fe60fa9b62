//! Contours as words: how many pixels they are moved by, and the vertices of each.
//!
//! ```text
//!     offset x | offset y | vertices, closed | x | y | x | y | .. | vertices, closed | x | y | ..
//! ```

use embedded_graphics::geometry::Point;

use crate::{
    draw::{
        payload::{Payload, Reader},
        picture::kinds::replayed::Words,
    },
    geometry::Bounds,
    scan::{
        polygon::{Edge, Part, ceil_pixel},
        stroke::wide_stroke,
    },
};

/// Contours as they are written, one vertex after the other, in units of `1 / (1 << fraction_bits)` pixel.
pub(super) struct ContourWriter<'p, 'm> {
    payload: &'p mut Payload<'m>,
    fraction_bits: u32,
    offset: Point,
    /// The index of the open contour's first word.
    start: usize,
    count: u32,
    /// The first vertex of the open contour, and the last one.
    ends: [[i32; 2]; 2],
    /// Is called with both ends of each segment.
    segment: &'p mut dyn FnMut([i32; 2], [i32; 2]),
    /// A box around the vertices of the open contour.
    open_bounds: Bounds,
    /// A box around the vertices of all others.
    bounds: Bounds,
}

impl ContourWriter<'_, '_> {
    /// Begins a contour.
    pub(super) fn begin(&mut self) {
        (self.start, self.count, self.open_bounds) = (self.payload.needed(), 0, Bounds::EMPTY);
        self.payload.push(0);
    }

    /// Adds a vertex to the contour.
    pub(super) fn push(&mut self, [x, y]: [i32; 2]) {
        self.payload.push_signed(x);
        self.payload.push_signed(y);
        let [first, before] = self.ends;
        if self.count == 0 {
            self.ends = [[x, y]; 2];
        } else {
            (self.segment)(before, [x, y]);
            self.ends = [first, [x, y]];
        }
        self.count += 1;
        let pixel = |units: i32, offset: i32| i64::from(ceil_pixel(units, self.fraction_bits)) + i64::from(offset);
        let (x, y) = (pixel(x, self.offset.x), pixel(y, self.offset.y));
        self.open_bounds = self.open_bounds.with(x, y);
    }

    /// Ends the contour, or drops it.
    pub(super) fn end(&mut self, is_closed: bool, is_dropped: bool) {
        if is_dropped {
            self.payload.truncate(self.start);
            return;
        }
        if is_closed && self.count > 0 {
            let [first, last] = self.ends;
            (self.segment)(last, first);
        }
        self.payload.set(self.start, self.count << 1 | u32::from(is_closed));
        self.bounds = self.bounds.around(&self.open_bounds);
    }
}

/// Writes an offset and contours, and returns a box around the vertices.
pub(super) fn write(
    contours: &dyn Fn(&mut ContourWriter<'_, '_>),
    offset: Point,
    fraction_bits: u32,
    payload: &mut Payload<'_>,
) -> Bounds {
    write_segments(contours, offset, fraction_bits, payload, &mut |_, _| {})
}

/// Writes an offset and contours, and calls with both ends of each segment. Returns a box around the vertices.
pub(super) fn write_segments(
    contours: &dyn Fn(&mut ContourWriter<'_, '_>),
    offset: Point,
    fraction_bits: u32,
    payload: &mut Payload<'_>,
    segment: &mut dyn FnMut([i32; 2], [i32; 2]),
) -> Bounds {
    payload.push_signed(offset.x);
    payload.push_signed(offset.y);
    let mut writer = ContourWriter {
        start: payload.needed(),
        payload,
        fraction_bits,
        offset,
        count: 0,
        ends: [[0; 2]; 2],
        segment,
        open_bounds: Bounds::EMPTY,
        bounds: Bounds::EMPTY,
    };
    contours(&mut writer);
    writer.bounds
}

/// Contours that are read from words.
#[derive(Debug, Copy, Clone)]
pub(super) struct Contours<'w> {
    words: &'w [u32],
    fraction_bits: u32,
    /// How many pixels the vertices are moved by.
    offset: Point,
}

impl<'w> Contours<'w> {
    /// Reads what [`write`] wrote, up to the end of the words.
    pub(super) fn read(mut reader: Reader<'w>, fraction_bits: u32) -> Self {
        let offset = Point::read(&mut reader);
        Self {
            words: reader.rest(),
            fraction_bits,
            offset,
        }
    }

    /// How many pixels the vertices are moved by.
    pub(super) const fn offset(&self) -> Point {
        self.offset
    }

    /// Calls with the vertices of each contour, two words each, and whether it is closed.
    pub(super) fn each<E>(&self, mut call: impl FnMut(&[u32], bool) -> Result<(), E>) -> Result<(), E> {
        let mut words = self.words;
        while let Some((count, rest)) = words.split_first() {
            let (vertices, behind) = rest.split_at_checked(2 * (*count >> 1) as usize).unwrap_or((rest, &[]));
            call(vertices, count & 1 != 0)?;
            words = behind;
        }
        Ok(())
    }

    /// The contour with the vertex that has a number among those of all contours: its vertices, whether it is closed, and the
    /// number that the vertex has in it. Cost: a step for each contour before.
    pub(super) fn with_vertex(&self, number: usize) -> Option<(&'w [u32], bool, usize)> {
        let (mut words, mut number) = (self.words, number);
        loop {
            let (head, rest) = words.split_first()?;
            let count = (*head >> 1) as usize;
            let (vertices, behind) = rest.split_at_checked(2 * count)?;
            if number < count {
                return Some((vertices, head & 1 != 0, number));
            }
            (words, number) = (behind, number - count);
        }
    }

    /// The vertex with a number as a position of a stroke.
    pub(super) fn position(&self, vertices: &[u32], number: usize) -> wide_stroke::Position {
        let shift = wide_stroke::FRACTION_BITS.saturating_sub(self.fraction_bits);
        let position =
            |units: i32, offset: i32| (i64::from(units) << shift) + (i64::from(offset) << wide_stroke::FRACTION_BITS);
        let (x, y) = vertex_of(vertices, number);
        (position(x, self.offset.x), position(y, self.offset.y))
    }

    /// Calls `sink` with the edges of a contour's inside.
    pub(super) fn inside_edges(&self, vertices: &[u32], sink: &mut dyn FnMut(Edge)) {
        let moved = |units: i32, offset: i32| {
            let moved = i64::from(units) + (i64::from(offset) << self.fraction_bits);
            // What was moved stays within 16 bits of pixels.
            moved.clamp(i32::MIN.into(), i32::MAX.into()) as i32
        };
        let corner = |number: usize| {
            let (x, y) = vertex_of(vertices, number);
            (moved(x, self.offset.x), moved(y, self.offset.y))
        };
        let count = vertices.len() / 2;
        let mut from = corner(count.saturating_sub(1));
        for to in (0..count).map(corner) {
            if let Some(edge) = Edge::from_units(from, to, self.fraction_bits, Part::Fill) {
                sink(edge);
            }
            from = to;
        }
    }
}

/// The vertex with a number.
pub(super) fn vertex_of(vertices: &[u32], number: usize) -> (i32, i32) {
    match vertices.get(2 * number..).and_then(<[u32]>::first_chunk) {
        Some([x, y]) => (*x as i32, *y as i32),
        None => (0, 0),
    }
}
