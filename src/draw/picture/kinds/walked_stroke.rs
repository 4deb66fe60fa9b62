//! Strokes along contours that go on from row to row: the vertices are words, and behind them lie a list of the parts of the
//! stroke by their first rows, and the polygons that the row meets.
//!
//! ```text
//!     colour | fraction bits, words of the contours | width, primitives | active polygons, begun primitives | next change
//!         | contours | primitives .. | polygons ..
//!
//!     first row, number                                                a primitive
//! ```
//!
//! The primitives of a stroke are a rectangle along each segment and a join at each corner, in the order of the first rows in
//! which they may have pixels. When that row comes, the primitive's polygon is generated; it is stepped from row to row, and
//! leaves after its last one. All have the stroke's colour, so that each is drawn by itself: their union needs no order and no
//! winding numbers. There is room for as many polygons as one row may meet.
//!
//! Guarantees: the pixels of [`wide_stroke`]. Cost of a row: a run of pixels for each polygon that it meets, and in a row in
//! which one of them has a corner, a look at each. Cost of a jump to a row: a look at each primitive that begins above it.
//! Memory: 4 bytes for each segment and each corner, and 76 for each polygon of a row.

use core::{marker::PhantomData, ops::Range};

use embedded_graphics::geometry::Point;

use crate::{
    band::Band,
    draw::{
        chains::ContourEdges,
        payload::{Payload, Reader},
        picture::{
            item::{Extent, fill_short_span},
            kinds::{
                contour_stroke::{ContourStroke, Paths, Stroke, StrokeWords, over_fill},
                contours::{self, Contours},
                replayed::translate_point,
                strips::Strips,
            },
            prepare::{Draft, not_used},
        },
        style::stroke,
    },
    geometry::{Bounds, Window},
    scan::{
        polygon::{
            bounding_box::MOST_LINE_TESTS,
            convex_walk::{self, ConvexWalk, Corners},
            edge_table::shell_sort,
        },
        stroke::{
            primitive,
            wide_stroke::{self, FRACTION_BITS},
        },
    },
    surface::{BandColor, Order, PixelWord, Target},
};

/// The number of words of a walked stroke before its offset, and the indices of all but the first one, which is the colour.
const HEADER_WORDS: usize = 5;
const FORMAT: usize = 1;
const WIDTH: usize = 2;
const ACTIVE: usize = 3;
const NEXT_CHANGE: usize = 4;

/// In the word of the format: bits of the number of fraction bits, below the number of words that the contours have.
const LENGTH_SHIFT: u32 = 8;

/// A centred stroke in one colour, of two pixels or more or along sub-pixel contours.
pub(super) struct WalkedStroke;

impl ContourStroke<'_> {
    /// The item of a centred stroke without a fill.
    pub(super) fn walked<'a, C: BandColor, O: Order>(
        &self,
        (color, width): (C, u32),
        payload: &mut Payload<'_>,
    ) -> Draft<'a, C, O> {
        payload.push_pixel(Band::<C, O>::word(color));
        let bounds = self.store_walked(width, payload);
        Draft::new(
            Extent::of(&bounds),
            not_used::<C>(),
            const { &Stroke::<WalkedStroke>(PhantomData) },
        )
    }

    /// The item of a centred stroke over a fill.
    pub(super) fn walked_over_fill<'a, C: BandColor, O: Order>(
        &self,
        fill: (C, &ContourEdges<'_>),
        (color, width): (C, u32),
        payload: &mut Payload<'_>,
    ) -> Draft<'a, C, O> {
        let start = payload.needed();
        payload.push(0);
        payload.push_pixel(Band::<C, O>::word(color));
        let bounds = self.store_walked(width, payload);
        over_fill::<C, O, WalkedStroke>(start, bounds, fill, payload)
    }

    /// Writes all but the colour, and room for the active polygons. Returns a box around the pixels.
    #[inline(never)]
    pub(super) fn store_walked(&self, width: u32, payload: &mut Payload<'_>) -> Window {
        let format = payload.needed();
        payload.push_all(&[0; HEADER_WORDS - 1]);
        let start = payload.needed();
        contours::write(self.write, self.offset, self.fraction_bits, payload);
        let primitives = payload.needed();
        let (bounds, polygons) = measure(self.paths);
        let most_active = polygons + store_primitives(self.paths, payload);
        // A pool has no more words than 16 bits tell; wider strokes than that are not generated.
        let (length, count) = ((primitives - start) as u32, (payload.needed() - primitives) as u32);
        payload.set(format, self.fraction_bits | length << LENGTH_SHIFT);
        payload.set(format + 1, width.min(u16::MAX.into()) | count << 16);
        for _ in 0..most_active * convex_walk::WORDS {
            payload.push(0);
        }
        bounds.to_rectangle().into()
    }
}

/// A box around the pixels of a stroke, also around vertices where it is generated only once it is moved, and how many polygons it
/// has at most that are one of several of the same primitive.
fn measure(paths: &Paths<'_>) -> (Bounds, usize) {
    let (mut bounds, mut divided) = (Bounds::EMPTY, 0);
    paths(&mut |path| {
        let (mut of_path, mut tests_left) = (path.out_of_reach(path.reach()), MOST_LINE_TESTS);
        // A join has two parts at most.
        divided += path.far_vertices().count();
        path.polygons(None, &mut |corners| {
            of_path = stroke::with_polygon(of_path, corners, &mut tests_left);
            // One of the parts is counted by its rows.
            let mut parts = 0usize;
            convex_walk::convex_parts(corners, &mut |_| parts += 1);
            divided += parts.saturating_sub(1);
        });
        bounds = bounds.around(&of_path);
    });
    (bounds, divided)
}

/// Writes the primitives of a stroke by their first rows. Returns how many of them may have pixels in one row at most.
fn store_primitives(paths: &Paths<'_>, payload: &mut Payload<'_>) -> usize {
    let (start, mut vertices) = (payload.needed(), 0);
    let (mut first, mut end) = (i32::MAX, i32::MIN);
    paths(&mut |path| {
        path.each_primitive(&mut |number, rows| {
            (first, end) = (first.min(rows.start), end.max(rows.end));
            payload.push(Primitive::begins(rows.start, primitive::count(vertices) + number).0);
        });
        vertices += path.count;
    });
    shell_sort(payload.written_from_mut(start), |word| *word);
    let mut strips = Strips::new(first..end);
    paths(&mut |path| path.each_primitive(&mut |_, rows| strips.push(rows)));
    strips.most()
}

/// A primitive of a stroke, in a word: its first row above its number among those of all contours. The words are in the order
/// of rows.
#[derive(Copy, Clone)]
struct Primitive(u32);

impl Primitive {
    /// The primitive with a number. A pool has room for no more than 16 bits tell.
    const fn begins(row: i32, number: usize) -> Self {
        Self(((row - i16::MIN as i32) as u32) << 16 | number as u32 & 0xffff)
    }

    /// The first row in which it may have pixels.
    const fn first_row(self) -> i32 {
        (self.0 >> 16) as i32 + i16::MIN as i32
    }

    const fn number(self) -> usize {
        self.0 as u16 as usize
    }

    /// The primitive that begins so many rows below this one. A row beyond 16 bits becomes the first one or the last one that
    /// there is: none of these is one of a moved item.
    fn moved(self, down: i32) -> Self {
        let row = self.first_row().saturating_add(down);
        Self::begins(row.clamp(i16::MIN.into(), i16::MAX.into()), self.number())
    }
}

/// The words of a stroke, taken apart.
pub(super) struct Parts<'w> {
    header: &'w mut [u32; HEADER_WORDS],
    contours: &'w [u32],
    primitives: &'w mut [u32],
    polygons: &'w mut [ConvexWalk],
}

impl<'w> Parts<'w> {
    #[inline(always)]
    pub(super) fn of(words: &'w mut [u32]) -> Option<Self> {
        let (header, rest) = words.split_first_chunk_mut::<HEADER_WORDS>()?;
        let (contours, rest) = rest.split_at_mut_checked((header[FORMAT] >> LENGTH_SHIFT) as usize)?;
        let (primitives, polygons) = rest.split_at_mut_checked((header[WIDTH] >> 16) as usize)?;
        Some(Self {
            header,
            contours,
            primitives,
            polygons: bytemuck::try_cast_slice_mut(polygons).ok()?,
        })
    }

    /// The word of the stroke's colour.
    pub(super) const fn color(&self) -> u32 {
        self.header[0]
    }

    /// Fills what the row of the cursor has of the stroke between columns.
    pub(super) fn fill_within<C: BandColor, O: Order>(
        &mut self,
        columns: Range<i32>,
        word: C::Word,
        band: &mut Band<'_, C, O>,
    ) {
        for polygon in self.active() {
            let (start, end) = convex_walk::columns(polygon);
            let (start, end) = (start.max(columns.start), end.min(columns.end));
            if start < end {
                fill_short_span(band, (start, end), word);
            }
        }
    }

    /// Steps all polygons to the next row.
    pub(super) fn step(&mut self) {
        for polygon in self.active() {
            convex_walk::next_row(polygon);
        }
    }

    /// Ends a row of an item, the polygons of which are in the next row already: ends and begins there what does.
    #[inline(always)]
    pub(super) fn end_row(&mut self, row: i32, extent: Extent) {
        if row + 1 == i32::from(extent.end) {
            self.clear();
        } else if row + 1 >= self.header[NEXT_CHANGE] as i32 {
            self.change(row + 1);
        }
    }

    /// The polygons that the row of the cursor may meet.
    #[inline(always)]
    fn active(&mut self) -> &mut [ConvexWalk] {
        let count = usize::from(self.header[ACTIVE] as u16);
        self.polygons.get_mut(..count).unwrap_or_default()
    }

    /// The number of rectangles and joins of the stroke that have begun in the cursor's row or above it.
    fn begun(&self) -> usize {
        (self.header[ACTIVE] >> 16) as usize
    }

    fn set_active(&mut self, count: usize, begun: usize, next_change: i32) {
        // As many as there is room for in the words of an item.
        self.header[ACTIVE] = u32::from(count as u16) | (begun as u32) << 16;
        self.header[NEXT_CHANGE] = next_change as u32;
    }

    /// Drops all active polygons of the stroke, and begins no primitive.
    fn clear(&mut self) {
        self.active().fill(ENDED);
        self.set_active(0, 0, 0);
    }

    /// Lets the polygons go on that have an edge that ends in a row, drops those that have ended, and begins the primitives
    /// that may have pixels in the row.
    #[inline(never)]
    fn change(&mut self, row: i32) {
        let (count, mut next_change) = go_on(self.active(), row);
        let (count, begun, next_begin) = self.begin(count, row, &mut next_change);
        self.set_active(count, begun, next_change.min(next_begin));
    }

    /// Begins the primitives that may have pixels in a row, behind so many active polygons. Returns how many polygons and
    /// primitives there are then, and when the next one begins.
    fn begin(&mut self, mut count: usize, row: i32, next_change: &mut i32) -> (usize, usize, i32) {
        let (contours, mut begun) = (StoredContours::of(self.header, self.contours), self.begun());
        while let Some(primitive) = self.primitives.get(begun).copied().map(Primitive) {
            if primitive.first_row() > row {
                return (count, begun, primitive.first_row());
            }
            begun += 1;
            contours.begin(primitive, row, &mut |corners| {
                let room = self.polygons.get_mut(count);
                debug_assert!(room.is_some(), "there is room for every polygon of a row");
                let Some(room) = room else { return };
                if convex_walk::enter(room, corners, FRACTION_BITS, row) {
                    *next_change = convex_walk::change_row(room).min(*next_change);
                    count += 1;
                } else {
                    *room = ENDED;
                }
            });
        }
        (count, begun, i32::MAX)
    }
}

/// The words in the place of a polygon that has ended: zeros, so that two equal strokes have equal words once both are drawn.
pub(super) const ENDED: ConvexWalk = [0; convex_walk::WORDS];

/// Lets polygons go on that have an edge that ends in a row, and drops those that have ended. Returns how many are left, and when the
/// first of them changes.
#[inline]
pub(super) fn go_on(polygons: &mut [ConvexWalk], row: i32) -> (usize, i32) {
    let mut next_change = i32::MAX;
    let mut have_ended = false;
    for polygon in &mut *polygons {
        let mut change = convex_walk::change_row(polygon);
        if change <= row {
            if !convex_walk::go_on(polygon, FRACTION_BITS, row) {
                have_ended = true;
                continue;
            }
            change = convex_walk::change_row(polygon);
        }
        next_change = next_change.min(change);
    }
    let count = if have_ended {
        take_out_ended(polygons, row)
    } else {
        polygons.len()
    };
    (count, next_change)
}

/// Puts the last polygon in the place of each that has ended above a row. Returns how many are left.
fn take_out_ended(mut polygons: &mut [ConvexWalk], row: i32) -> usize {
    let mut index = 0;
    while let Some(polygon) = polygons.get(index) {
        if convex_walk::change_row(polygon) > row {
            index += 1;
            continue;
        }
        let Some((last, others)) = polygons.split_last_mut() else {
            return 0;
        };
        if let Some(ended) = others.get_mut(index) {
            *ended = *last;
        }
        *last = ENDED;
        polygons = others;
    }
    polygons.len()
}

/// The contours of a stroke, and how wide it is.
struct StoredContours<'w> {
    contours: Contours<'w>,
    width_in_halves: u64,
}

impl<'w> StoredContours<'w> {
    fn of(header: &[u32; HEADER_WORDS], words: &'w [u32]) -> Self {
        let fraction_bits = header[FORMAT] & ((1 << LENGTH_SHIFT) - 1);
        Self {
            contours: Contours::read(Reader::new(words), fraction_bits),
            width_in_halves: 2 * u64::from(header[WIDTH] as u16),
        }
    }

    /// Generates the polygons of a primitive that begins in a row or above it, if it may have pixels in the row.
    fn begin(&self, primitive: Primitive, row: i32, call: &mut dyn FnMut(Corners)) {
        let contours = &self.contours;
        let (number, is_join) = primitive::parts_of(primitive.number());
        let Some((vertices, is_closed, number)) = contours.with_vertex(number) else {
            return;
        };
        let vertex = |number: usize| contours.position(vertices, number);
        let path = wide_stroke::Path::new(&vertex, vertices.len() / 2, is_closed, self.width_in_halves);
        let number = primitive::number_of(number, is_join);
        if primitive.first_row() == row || path.rows_of(number).contains(&row) {
            path.polygon_of(number, &mut |corners| convex_walk::convex_parts(corners, call));
        }
    }
}

impl StrokeWords for WalkedStroke {
    const OFFSET: usize = HEADER_WORDS;

    fn enter(words: &mut [u32], row: i32) {
        let Some(mut stroke) = Parts::of(words) else { return };
        stroke.clear();
        stroke.change(row);
    }

    #[inline(always)]
    fn draw_row<C: BandColor, O: Order>(words: &mut [u32], extent: Extent, band: &mut Band<'_, C, O>) {
        let Some(mut stroke) = Parts::of(words) else { return };
        let word = C::Word::from_repeated(stroke.header[0]);
        // Beyond 16 bits, a run may be anywhere.
        let (left, right) = extent.columns();
        for polygon in stroke.active() {
            let (start, end) = convex_walk::next_row(polygon);
            let (start, end) = (start.max(left), end.min(right));
            if start < end {
                fill_short_span(band, (start, end), word);
            }
        }
        stroke.end_row(band.window().top, extent);
    }

    fn translate(words: &mut [u32], by: Point) {
        let Some(stroke) = Parts::of(words) else { return };
        for primitive in stroke.primitives {
            *primitive = Primitive(*primitive).moved(by.y).0;
        }
        if let Some(offset) = words.get_mut(Self::OFFSET..Self::OFFSET + 2) {
            translate_point(offset, by);
        }
    }

    fn draw_rows<C: BandColor, O: Order>(words: &mut [u32], extent: Extent, band: &mut Band<'_, C, O>) {
        for row in extent.rows(&band.window()) {
            if let Some(mut band) = band.one_row(row) {
                Self::draw_row(words, extent, &mut band);
            }
        }
    }
}
