//! Strokes along contours that go on from row to row: the vertices are words, and behind them lie the polygons of the stroke that the
//! row meets.
//!
//! ```text
//!     colour | fraction bits, words of the contours | width | active polygons, next scan | next change | contours | polygons ..
//! ```
//!
//! A segment's rectangle and the join at a vertex are generated when the first row comes in which they may have pixels, are stepped
//! from row to row, and leave after their last one. All have the stroke's colour, so that each is drawn by itself: their union needs
//! no order and no winding numbers. There is room for as many polygons as one row may meet.
//!
//! Guarantees: the pixels of [`wide_stroke`]. Cost of a row: a run of pixels for each polygon that it meets; where a polygon may begin,
//! a look at each vertex.

use core::{convert::Infallible, marker::PhantomData};

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
        },
        stroke::wide_stroke::{self, FRACTION_BITS},
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
    fn store_walked(&self, width: u32, payload: &mut Payload<'_>) -> Window {
        let format = payload.needed();
        payload.push_all(&[0, width, 0, 0]);
        let start = payload.needed();
        contours::write(self.write, self.offset, self.fraction_bits, payload);
        // A pool has no more words than 16 bits tell.
        let length = (payload.needed() - start) as u32;
        payload.set(format, self.fraction_bits | length << LENGTH_SHIFT);
        let (bounds, polygons) = measure(self.paths);
        for _ in 0..polygons * convex_walk::WORDS {
            payload.push(0);
        }
        bounds.to_rectangle().into()
    }
}

/// A box around the pixels of a stroke, and how many of its polygons are active in a row at most.
fn measure(paths: &Paths<'_>) -> (Bounds, usize) {
    let (mut bounds, mut divided) = (Bounds::EMPTY, 0);
    let (mut first, mut end) = (i32::MAX, i32::MIN);
    paths(&mut |path| {
        let (mut of_path, mut tests_left) = (Bounds::EMPTY, MOST_LINE_TESTS);
        path.polygons_where(
            &mut |rows| {
                (first, end) = (first.min(rows.start), end.max(rows.end));
                true
            },
            &mut |corners| {
                of_path = stroke::with_polygon(of_path, corners, &mut tests_left);
                // One of the parts is counted by its rows.
                let mut parts = 0usize;
                convex_walk::convex_parts(corners, &mut |_| parts += 1);
                divided += parts.saturating_sub(1);
            },
        );
        bounds = bounds.around(&of_path);
    });
    let mut strips = Strips::new(first..end);
    paths(&mut |path| {
        path.polygons_where(
            &mut |rows| {
                strips.push(rows);
                false
            },
            &mut |_| {},
        );
    });
    (bounds, strips.most() + divided)
}

/// The words of a stroke, taken apart.
struct Parts<'w> {
    header: &'w mut [u32; HEADER_WORDS],
    contours: &'w [u32],
    polygons: &'w mut [u32],
}

impl<'w> Parts<'w> {
    #[inline(always)]
    fn of(words: &'w mut [u32]) -> Option<Self> {
        let (header, rest) = words.split_first_chunk_mut::<HEADER_WORDS>()?;
        let (contours, polygons) = rest.split_at_mut_checked((header[FORMAT] >> LENGTH_SHIFT) as usize)?;
        Some(Self {
            header,
            contours,
            polygons,
        })
    }

    /// The words of the active polygons.
    #[inline(always)]
    fn active(&mut self) -> &mut [u32] {
        let end = usize::from(self.header[ACTIVE] as u16) * convex_walk::WORDS;
        self.polygons.get_mut(..end).unwrap_or_default()
    }

    /// The first row in which a polygon may begin, in 16 bits as all rows of a picture are.
    fn next_scan(&self) -> i32 {
        self.header[ACTIVE] as i32 >> 16
    }

    fn set_active(&mut self, count: usize, next_scan: i32, next_change: i32) {
        // As many as there is room for in the words of an item; rows of a picture.
        self.header[ACTIVE] = u32::from(count as u16) | (next_scan as u32) << 16;
        self.header[NEXT_CHANGE] = next_change as u32;
    }

    /// Drops all active polygons of the stroke.
    fn clear(&mut self) {
        self.active().fill(0);
        (self.header[ACTIVE], self.header[NEXT_CHANGE]) = (0, 0);
    }

    /// Lets the polygons go on that have an edge that ends in a row, drops those that have ended, and begins others: those that may
    /// have pixels in the row, but none in the row `after` or above it.
    #[inline(never)]
    fn change(&mut self, row: i32, after: i32) {
        let (mut count, mut next_change, mut next_scan) = (0, i32::MAX, self.next_scan());
        let active = self.active();
        for index in 0..active.len() / convex_walk::WORDS {
            let Some(mut polygon) = get(active, index) else {
                continue;
            };
            if convex_walk::change_row(&polygon) <= row {
                let Some(entered) = convex_walk::entered_again(&polygon, FRACTION_BITS, row) else {
                    continue;
                };
                polygon = entered;
            }
            next_change = next_change.min(convex_walk::change_row(&polygon));
            set(active, count, &polygon);
            count += 1;
        }
        // What has ended leaves nothing: strokes that are drawn to their ends have the same words if they are the same.
        active.get_mut(count * convex_walk::WORDS..).unwrap_or_default().fill(0);
        if next_scan <= row {
            let polygons = &mut *self.polygons;
            next_scan = begun(self.header, self.contours, row, after, &mut |corners| {
                if let Some(polygon) = convex_walk::enter(corners, FRACTION_BITS, row) {
                    next_change = next_change.min(convex_walk::change_row(&polygon));
                    let has_room = set(polygons, count, &polygon);
                    debug_assert!(has_room, "there is room for every polygon of a row");
                    count += usize::from(has_room);
                }
            });
        }
        self.set_active(count, next_scan, next_change.min(next_scan));
    }
}

/// Generates the polygons that may have pixels in a row, but none in the row `after` or above it. Returns the next row in which another
/// one may begin, or the last row that there is.
fn begun(header: &[u32; HEADER_WORDS], contours: &[u32], row: i32, after: i32, call: &mut dyn FnMut(Corners)) -> i32 {
    let fraction_bits = header[FORMAT] & ((1 << LENGTH_SHIFT) - 1);
    let contours = Contours::read(Reader::new(contours), fraction_bits);
    let mut next_scan = i16::MAX.into();
    let Ok(()) = contours.each(|vertices, is_closed| {
        let vertex = |number: usize| contours.position(vertices, number);
        let width_in_halves = 2 * u64::from(header[WIDTH]);
        let path = wide_stroke::Path::new(&vertex, vertices.len() / 2, is_closed, width_in_halves);
        path.polygons_where(
            &mut |rows| {
                if rows.start > row {
                    next_scan = rows.start.min(next_scan);
                }
                after < rows.start && rows.contains(&row)
            },
            &mut |corners| convex_walk::convex_parts(corners, call),
        );
        Ok::<(), Infallible>(())
    });
    next_scan
}

fn get(polygons: &[u32], index: usize) -> Option<ConvexWalk> {
    polygons.get(index * convex_walk::WORDS..)?.first_chunk().copied()
}

/// Sets the polygon with an index; `false` where there is no room for it.
fn set(polygons: &mut [u32], index: usize, polygon: &ConvexWalk) -> bool {
    let room = polygons
        .get_mut(index * convex_walk::WORDS..)
        .and_then(<[u32]>::first_chunk_mut);
    room.map(|room| *room = *polygon).is_some()
}

impl StrokeWords for WalkedStroke {
    const OFFSET: usize = HEADER_WORDS;

    fn enter(words: &mut [u32], row: i32) {
        let Some(mut stroke) = Parts::of(words) else { return };
        stroke.clear();
        stroke.set_active(0, i16::MIN.into(), row);
        stroke.change(row, i32::MIN);
    }

    #[inline(always)]
    fn draw_row<C: BandColor, O: Order>(words: &mut [u32], extent: Extent, band: &mut Band<'_, C, O>) {
        let Some(mut stroke) = Parts::of(words) else { return };
        let word = C::Word::from_repeated(stroke.header[0]);
        let (left, right) = extent.columns();
        for polygon in stroke.active().chunks_exact_mut(convex_walk::WORDS) {
            let (start, end) = convex_walk::next_row(polygon);
            // Beyond 16 bits, a run may be anywhere.
            let (start, end) = (start.max(left), end.min(right));
            if start < end {
                fill_short_span(band, (start, end), word);
            }
        }
        let next = band.window().top + 1;
        if next == i32::from(extent.end) {
            stroke.clear();
        } else if next >= stroke.header[NEXT_CHANGE] as i32 {
            stroke.change(next, next - 1);
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scan::{polygon::ceil_pixel, stroke::wide_stroke::Position};

    /// Paths of three vertices, in steps that include level and upright ones, sharp turns and returns, in several widths: no polygon has
    /// pixels in other rows than those by which it was asked for.
    #[test]
    fn polygons_lie_in_the_rows_by_which_they_are_asked_for() {
        let steps = || (-2..3).flat_map(|x| (-2..3).map(move |y| (x * 90_000 + y, y * 70_001 - x)));
        let add = |(x, y): Position, (right, down): Position| (x + right, y + down);
        for (one, other) in steps().flat_map(|one| steps().map(move |other| (one, other))) {
            let vertices = [(3, 5), add((3, 5), one), add(add((3, 5), one), other)];
            let vertex = |number: usize| vertices.get(number).copied().unwrap_or_default();
            for (width_in_halves, closed) in [1, 2, 3, 8, 41]
                .into_iter()
                .flat_map(|width| [(width, false), (width, true)])
            {
                let asked = core::cell::RefCell::new(0..0);
                wide_stroke::Path::new(&vertex, 3, closed, width_in_halves).polygons_where(
                    &mut |rows| {
                        asked.replace(rows);
                        true
                    },
                    &mut |corners| {
                        let rows = corners.iter().map(|&(_, y)| ceil_pixel(y, FRACTION_BITS));
                        let (first, end) = (rows.clone().min().unwrap_or(0), rows.max().unwrap_or(0));
                        let asked = asked.borrow();
                        assert!(
                            asked.start <= first && end <= asked.end,
                            "{asked:?}: {corners:?} of {vertices:?}"
                        );
                    },
                );
            }
        }
    }
}
