//! Strokes with caps, joins and dashes that go on from row to row: behind the style and the vertices lie a list of the shapes of the
//! stroke by their first rows, and the polygons and discs that the row meets.
//!
//! ```text
//!     header | style, contours | states of segments .. | shapes .. | polygons .. | discs ..
//!
//!     first row, row behind the last one | vertex, number                                      a shape
//! ```
//!
//! A shape is what one dash has, or a segment without dashes, or a join: a polygon and up to two discs. When its first row comes, the
//! shape is generated; it is stepped from row to row, and leaves after its last one. All have the stroke's colour, so that each is
//! drawn by itself. There is room for as many polygons and discs as one row may meet.
//!
//! Guarantees: the pixels of [`StyledStroke`](crate::scan::stroke::styled_stroke::StyledStroke). Cost of a row: a run of pixels for
//! each polygon and disc that it meets, and in a row in which one of them has a corner or ends, a look at each. Cost of a jump to a row: a look at each shape that begins above it. Memory:
//! 8 bytes for each segment of a dashed stroke and for each shape, and 76 for each polygon and 20 for each disc of a row.

use core::ops::Range;

use embedded_graphics::geometry::Point;

use crate::{
    band::Band,
    draw::{
        StrokedShape,
        payload::Payload,
        picture::{
            item::{PictureItem, PictureSlot, fill_short_span},
            kinds::{
                stored_shape::{ShapeWords, StoredShape},
                stored_style::{self, StoredPaths, StoredStyle},
                strips::Strips,
                walked_stroke::{self, ENDED},
            },
            pool::Pool,
        },
    },
    geometry::Window,
    scan::{
        polygon::{
            ScanEdge, ceil_pixel,
            convex_walk::{self, ConvexWalk},
            edge_table::shell_sort,
        },
        stroke::{
            DiscSide,
            disc_walk::{self, DiscWalk},
            numbered_shapes::{SegmentState, Shape},
            wide_stroke::{FRACTION_BITS, Path},
        },
    },
    surface::{BandColor, Order, PixelWord, Target},
};

/// The most dashes of a segment that are kept in a list: each takes a step for each one before it when it begins.
const MOST_DASHES: u16 = 64;

/// The words of a walked style before those of the style, and the indices of all but the first one, which is the colour.
const HEADER_WORDS: usize = 7;
/// Words of the style and the contours, and of the states.
const LENGTHS: usize = 1;
/// Shapes, and polygons that there is room for.
const COUNTS: usize = 2;
const ACTIVE: usize = 3;
const BEGUN: usize = 4;
const NEXT_CHANGE: usize = 5;
/// Half the stroke's width.
const RADIUS: usize = 6;

/// In the word of the radius of a stroke that was moved to where not all of it is generated: it is drawn anew in each row.
const IS_ANEW: u32 = 1 << 31;

/// Whether a stroke is kept in a list: all of it is generated, and no segment has very many dashes.
pub(super) fn is_kept(style: &StoredStyle<'_>, shape: &dyn StrokedShape) -> bool {
    let mut is_kept = true;
    shape.paths(style.width_in_halves(), &mut |path| {
        is_kept &= style.stroke(path).has_at_most(MOST_DASHES)
    });
    is_kept
}

/// Writes a style behind a colour, and all shapes of its stroke.
#[inline(never)]
pub(super) fn store(style: &StoredStyle<'_>, fraction_bits: u32, shape: &dyn StrokedShape, payload: &mut Payload<'_>) {
    let header = payload.needed();
    payload.push_all(&[0; HEADER_WORDS - 1]);
    let start = payload.needed();
    style.write(fraction_bits, payload);
    stored_style::write_paths(shape, fraction_bits, payload);
    let states = payload.needed();
    if style.has_dashes() {
        store_states(style, shape, payload);
    }
    let shapes = payload.needed();
    let rows = store_shapes(style, shape, payload);
    let count = (payload.needed() - shapes) / StoredShape::WORDS;
    let [polygons, discs] = most_active(style, shape, rows);
    // A pool has no more words than 16 bits tell.
    let half = |number: usize| number as u32 & 0xffff;
    payload.set(header, half(states - start) | half(shapes - states) << 16);
    payload.set(header + COUNTS - LENGTHS, half(count) | half(polygons) << 16);
    for _ in 0..polygons * convex_walk::WORDS + discs * disc_walk::WORDS {
        payload.push(0);
    }
    payload.set(header + RADIUS - LENGTHS, style.radius() as u32);
}

/// Writes the state of each segment, in the place of the vertex that it begins at.
fn store_states(style: &StoredStyle<'_>, shape: &dyn StrokedShape, payload: &mut Payload<'_>) {
    shape.paths(style.width_in_halves(), &mut |path| {
        let start = payload.needed();
        for _ in 0..path.count * SegmentState::WORDS {
            payload.push(0);
        }
        style.stroke(path).each_state(&mut |vertex, state| {
            for (index, word) in (start + vertex * SegmentState::WORDS..).zip(state.to_words()) {
                payload.set(index, word);
            }
        });
    });
}

/// Is called with a shape as it is stored, and with the shape itself.
type ShapeSink<'s> = dyn FnMut(StoredShape, Shape<'_>) + 's;

/// Calls with each shape of a stroke that has rows.
fn each_shape(style: &StoredStyle<'_>, shape: &dyn StrokedShape, call: &mut ShapeSink<'_>) {
    let mut vertices = 0;
    shape.paths(style.width_in_halves(), &mut |path| {
        style.stroke(path).each_numbered_shape(&mut |vertex, number, shape| {
            let rows = rows_of(shape, style.radius());
            if !rows.is_empty() {
                call(StoredShape::new(&rows, vertices + vertex, number), shape);
            }
        });
        vertices += path.count;
    });
}

/// The rows of pixel centres in a polygon.
fn rows_of_polygon(corners: &[(i32, i32)]) -> Range<i32> {
    let rows = || corners.iter().map(|&(_, y)| ceil_pixel(y, FRACTION_BITS));
    rows().min().unwrap_or(0)..rows().max().unwrap_or(0)
}

/// The rows of pixel centres in a disc.
fn rows_of_disc(center: (i32, i32), radius: i32) -> Range<i32> {
    let [side, _] = DiscSide::both(center, radius);
    side.first_row()..side.end_row()
}

/// Whether some of these rows are a row or below it: then there is room for what has them.
const fn lasts_to(rows: Range<i32>, row: i32) -> bool {
    rows.start < rows.end && row < rows.end
}

/// The rows around the polygon and the discs of a shape.
fn rows_of((corners, discs): Shape<'_>, radius: i32) -> Range<i32> {
    let discs = discs.into_iter().flatten().map(|center| rows_of_disc(center, radius));
    let parts = discs.chain([rows_of_polygon(corners)]).filter(|rows| !rows.is_empty());
    parts
        .reduce(|one, other| one.start.min(other.start)..one.end.max(other.end))
        .unwrap_or(0..0)
}

/// Writes the shapes of a stroke by their first rows. Returns all rows of the stroke.
fn store_shapes(style: &StoredStyle<'_>, shape: &dyn StrokedShape, payload: &mut Payload<'_>) -> Range<i32> {
    let (start, mut first, mut end) = (payload.needed(), i32::MAX, i32::MIN);
    each_shape(style, shape, &mut |stored, _| {
        (first, end) = (first.min(stored.first_row()), end.max(stored.end_row()));
        payload.push_all(&stored.0);
    });
    if let Ok(shapes) = bytemuck::try_cast_slice_mut::<_, ShapeWords>(payload.written_from_mut(start)) {
        shell_sort(shapes, |&words| {
            (StoredShape(words).first_row(), StoredShape(words).id())
        });
    }
    first..end
}

/// How many polygons and how many discs of a stroke lie in one row at most. A polygon or a disc takes its place in the first row of
/// the shape that it belongs to, even where it has no pixels yet.
fn most_active(style: &StoredStyle<'_>, shape: &dyn StrokedShape, rows: Range<i32>) -> [usize; 2] {
    let (mut polygons, mut discs) = (Strips::new(rows.clone()), Strips::new(rows));
    each_shape(style, shape, &mut |stored, (corners, centers)| {
        let push = |strips: &mut Strips, of_part: Range<i32>| {
            if !of_part.is_empty() {
                strips.push(stored.first_row()..of_part.end);
            }
        };
        convex_walk::convex_parts(corners, &mut |part| push(&mut polygons, rows_of_polygon(&part)));
        for center in centers.into_iter().flatten() {
            push(&mut discs, rows_of_disc(center, style.radius()));
        }
    });
    [polygons.most(), discs.most()]
}

/// The words of a stroke, taken apart.
struct Parts<'w> {
    header: &'w mut [u32; HEADER_WORDS],
    stroke: StoredStroke<'w>,
    shapes: &'w [ShapeWords],
    polygons: &'w mut [ConvexWalk],
    discs: &'w mut [DiscWalk],
}

/// The lower half and the upper one of a word.
const fn halves(word: u32) -> [usize; 2] {
    [word as u16 as usize, (word >> 16) as usize]
}

impl<'w> Parts<'w> {
    #[inline(always)]
    fn of(words: &'w mut [u32]) -> Option<Self> {
        let (header, rest) = words.split_first_chunk_mut::<HEADER_WORDS>()?;
        let [style, states] = halves(header[LENGTHS]);
        let [shapes, polygons] = halves(header[COUNTS]);
        let (style, rest) = rest.split_at_mut_checked(style)?;
        let (states, rest) = rest.split_at_mut_checked(states)?;
        let (shapes, rest) = rest.split_at_mut_checked(shapes * StoredShape::WORDS)?;
        let (polygons, discs) = rest.split_at_mut_checked(polygons * convex_walk::WORDS)?;
        Some(Self {
            header,
            stroke: StoredStroke { style, states },
            shapes: bytemuck::try_cast_slice(shapes).ok()?,
            polygons: bytemuck::try_cast_slice_mut(polygons).ok()?,
            discs: bytemuck::try_cast_slice_mut(discs).ok()?,
        })
    }

    /// The polygons and the discs that the row of the cursor may meet.
    #[inline(always)]
    fn active(&mut self) -> (&mut [ConvexWalk], &mut [DiscWalk]) {
        let [polygons, discs] = halves(self.header[ACTIVE]);
        (
            self.polygons.get_mut(..polygons).unwrap_or_default(),
            self.discs.get_mut(..discs).unwrap_or_default(),
        )
    }

    /// Whether the stroke lies where not all of it is generated, and its shapes may be others than those of the list.
    const fn is_anew(&self) -> bool {
        self.header[RADIUS] & IS_ANEW != 0
    }

    fn set_active(&mut self, polygons: usize, discs: usize) {
        // As many as there is room for in the words of an item.
        self.header[ACTIVE] = u32::from(polygons as u16) | (discs as u32) << 16;
    }

    /// Drops all active polygons and discs, and begins no shape.
    fn clear(&mut self) {
        let (polygons, discs) = self.active();
        polygons.fill(ENDED);
        discs.fill(ENDED_DISC);
        self.set_active(0, 0);
        (self.header[BEGUN], self.header[NEXT_CHANGE]) = (0, 0);
    }

    /// Lets the polygons and discs go on that change in a row, drops those that have ended, and begins the shapes that are in the row.
    #[inline(never)]
    fn change(&mut self, row: i32) {
        let radius = self.header[RADIUS] as i32;
        let (polygons, discs) = self.active();
        let (polygons, of_polygons) = walked_stroke::go_on(polygons, row);
        let (discs, of_discs) = go_on(discs, radius, row);
        self.set_active(polygons, discs);
        let next_change = self.begin(row, of_polygons.min(of_discs));
        self.header[NEXT_CHANGE] = next_change as u32;
    }

    /// Begins the shapes that are in a row. Returns the row of the next change, of which one is known.
    fn begin(&mut self, row: i32, mut next_change: i32) -> i32 {
        let [mut polygons, mut discs] = halves(self.header[ACTIVE]);
        let mut waiting = self.shapes.get(self.header[BEGUN] as usize..).unwrap_or_default();
        while let Some((&words, others)) = waiting.split_first() {
            let shape = StoredShape(words);
            if shape.first_row() > row {
                next_change = next_change.min(shape.first_row());
                break;
            }
            waiting = others;
            if shape.end_row() <= row {
                continue;
            }
            let others = shape.followers(waiting, row);
            waiting = waiting.get(others..).unwrap_or_default();
            self.stroke.generate(shape, others, &mut |(corners, centers)| {
                convex_walk::convex_parts(corners, &mut |corners| {
                    let room = self.polygons.get_mut(polygons);
                    debug_assert!(room.is_some() || !lasts_to(rows_of_polygon(&corners), row));
                    let Some(room) = room else { return };
                    if convex_walk::enter(room, corners, FRACTION_BITS, row) {
                        next_change = next_change.min(convex_walk::change_row(room));
                        polygons += 1;
                    } else {
                        *room = ENDED;
                    }
                });
                for center in centers.into_iter().flatten() {
                    let room = self.discs.get_mut(discs);
                    debug_assert!(room.is_some() || !lasts_to(rows_of_disc(center, self.header[RADIUS] as i32), row));
                    let Some(room) = room else { return };
                    if disc_walk::enter(room, center, self.header[RADIUS] as i32, row) {
                        next_change = next_change.min(disc_walk::change_row(room));
                        discs += 1;
                    } else {
                        *room = ENDED_DISC;
                    }
                }
            });
        }
        self.header[BEGUN] = (self.shapes.len() - waiting.len()) as u32;
        self.set_active(polygons, discs);
        next_change
    }
}

/// The words in the place of a disc that has ended: zeros, so that two equal strokes have equal words once both are drawn.
const ENDED_DISC: DiscWalk = [0; disc_walk::WORDS];

/// Lets discs go on into a row. Returns how many are left, and when the first of them changes.
fn go_on(mut discs: &mut [DiscWalk], radius: i32, row: i32) -> (usize, i32) {
    let (mut index, mut next_change) = (0, i32::MAX);
    while let Some(disc) = discs.get_mut(index) {
        if disc_walk::change_row(disc) > row || disc_walk::go_on(disc, radius, row) {
            next_change = next_change.min(disc_walk::change_row(disc));
            index += 1;
            continue;
        }
        let Some((last, others)) = discs.split_last_mut() else {
            break;
        };
        if let Some(ended) = others.get_mut(index) {
            *ended = *last;
        }
        *last = ENDED_DISC;
        discs = others;
    }
    (index, next_change)
}

/// The style and the contours of a stroke, and the states of its segments.
struct StoredStroke<'w> {
    style: &'w [u32],
    states: &'w [u32],
}

impl StoredStroke<'_> {
    /// Generates a shape, and so many of the same segment that follow it.
    fn generate(&self, shape: StoredShape, others: usize, call: &mut dyn FnMut(Shape<'_>)) {
        let (style, StoredPaths(contours)) = stored_style::read(self.style);
        let [number, vertex_of_all] = halves(shape.id());
        let Some((vertices, is_closed, vertex)) = contours.with_vertex(vertex_of_all) else {
            return;
        };
        let position = |number: usize| contours.position(vertices, number);
        let path = Path::new(&position, vertices.len() / 2, is_closed, style.width_in_halves());
        let stroke = style.part(&path);
        if shape.is_join() {
            return stroke.join_at(vertex, call);
        }
        let state = self.states.get(vertex_of_all * SegmentState::WORDS..);
        let state = match state.and_then(|states| states.first_chunk()) {
            Some(words) => SegmentState::of_words(*words),
            None => stroke.solid_state(vertex),
        };
        let number = number as u16;
        let numbers = number..number.saturating_add(1).saturating_add(others as u16);
        stroke.numbered_shapes(vertex, state, numbers, &mut |_, shape| call(shape));
    }
}

/// How a stroke with caps, joins and dashes is drawn that goes on from row to row.
pub(super) struct WalkedStyle;

impl<C: BandColor, O: Order> PictureItem<C, O> for WalkedStyle {
    fn bounds(&self) -> Window {
        Window::EMPTY
    }

    fn draw(&self, _: &mut Band<'_, C, O>) {}

    fn translate(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, by: Point) {
        translate(pool.slice_mut(slot.at, slot.words), by);
    }

    fn enter(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, row: i32) {
        if let Some(mut stroke) = Parts::of(pool.slice_mut(slot.at, slot.words)) {
            stroke.clear();
            if !stroke.is_anew() {
                stroke.change(row);
            }
        }
    }

    fn draw_row(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        let Some(mut stroke) = Parts::of(pool.slice_mut(slot.at, slot.words)) else {
            return;
        };
        let word = C::Word::from_repeated(stroke.header[0]);
        if stroke.is_anew() {
            let (style, paths) = stored_style::read(stroke.stroke.style);
            let color = C::from_word(O::reorder(word));
            let Ok(()) = style.in_color(color).draw_on(&paths, band);
            return;
        }
        let (row, radius) = (band.window().top, stroke.header[RADIUS] as i32);
        // Beyond 16 bits, a run may be anywhere.
        let (left, right) = slot.extent.columns();
        let mut fill = |(start, end): (i32, i32)| {
            let (start, end) = (start.max(left), end.min(right));
            if start < end {
                fill_short_span(band, (start, end), word);
            }
        };
        let (polygons, discs) = stroke.active();
        for polygon in polygons {
            fill(convex_walk::next_row(polygon));
        }
        for disc in discs {
            fill(disc_walk::next_row(disc, radius, row));
        }
        if row + 1 == i32::from(slot.extent.end) {
            stroke.clear();
        } else if row + 1 >= stroke.header[NEXT_CHANGE] as i32 {
            stroke.change(row + 1);
        }
    }

    fn draw_rows(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        for row in slot.extent.rows(&band.window()) {
            if let Some(mut band) = band.one_row(row) {
                self.draw_row(slot, pool, &mut band);
            }
        }
    }
}

/// Moves a stroke by so many columns and rows.
fn translate(words: &mut [u32], by: Point) {
    let Some((header, rest)) = words.split_first_chunk_mut::<HEADER_WORDS>() else {
        return;
    };
    let [style, states] = halves(header[LENGTHS]);
    let [shapes, _] = halves(header[COUNTS]);
    let of_shapes = rest.get_mut(style + states..).unwrap_or_default();
    let of_shapes = of_shapes.get_mut(..shapes * StoredShape::WORDS).unwrap_or_default();
    for words in bytemuck::try_cast_slice_mut::<_, ShapeWords>(of_shapes).unwrap_or_default() {
        *words = StoredShape(*words).moved(by.y).0;
    }
    stored_style::translate(rest, by);
    header[RADIUS] &= !IS_ANEW;
    let (_, paths) = stored_style::read(rest.get(..style).unwrap_or_default());
    paths.paths(0, &mut |path| {
        if path.far_vertices().next().is_some() {
            header[RADIUS] |= IS_ANEW;
        }
    });
}
