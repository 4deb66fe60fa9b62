//! The dashes of a segment that has too many of them to draw one by one, as spans of a row.
//!
//! Dashes may be far shorter than a pixel, and round caps as wide as the stroke cover a pixel as often as there are dots
//! within its width. But a row has only so many pixel centres. It is walked from left to right:
//!
//! ```text
//!      segment  __/  /  /  /   dashes that the row's centres do not need
//!            __/  /  /
//!   row  . . * * . * . .       * : the dash that holds this centre is found from the centre's foot on the segment
//!      __/  /  /
//! ```
//!
//! The distance of the foot along the segment, taken modulo the pattern, says which dashes can hold the centre: those
//! whose caps reach it. Where these are many, because a cap reaches further than the pattern is long, the nearest few to
//! each side are enough. They are made into the polygons and discs that a dash is when it is drawn by itself, and where
//! these cross the row decides. Where one holds the centre, the walk goes on at the end of that one in the row; where none
//! does, at the next pixel or, behind the reach of all caps, where the next dash can begin.
//!
//! Guarantees: the pixels of the row that the union of all dashes has, no more and no less.
//! - Distances of feet and dashes err by less than [`MARGIN`], by which more dashes are looked at.
//! - With caps that reach further than the pattern is long, dashes whose square caps touch are one; of those with round caps
//!   the nearest [`NEIGHBOURS`] to each side of the foot are looked at. Gaps shorter than 2 sqrt(h) units, where h is half
//!   the width in units, are bridged then, but for two of a segment: so the centre of any other disc is further from the
//!   foot than these by 4 sqrt(h) units. Such a disc ends at least 8 units nearer to the segment than that of a neighbour
//!   does at the foot's height, and all positions together are rounded by fewer.
//!
//! Cost: for each span or gap in the row some 20 divisions for each dash that may hold the pixel, one where caps are not
//! round and up to eight where they are, with two square roots then; times half the number of lengths where caps reach over
//! several dashes. There are no more of these spans and gaps than the row has pixels of the segment's stroke without gaps.
//! Up to six rounds of the pattern are walked for each. Memory: none.

use crate::{
    geometry::{Bounds, Window, quotient_nearest},
    scan::{
        polygon::{Edge, Part, ScanEdge, shrunk_box::shrunk},
        stroke::{
            dash_pattern::{DISTANCE_BITS, Dash},
            pen::Pen,
            segment_dashes::{Ruler, SegmentDashes},
            stroke_edge::StrokeEdge,
            wide_stroke::{Direction, FRACTION_BITS, Offsets, Position, UNIT},
        },
    },
};

/// A distance in 1/65,536 pixel: more than what the positions of a dash and of a foot are rounded by.
const MARGIN: i64 = 16;
/// Dashes to each side of a foot that can hold its pixel centre by their caps, where these reach further than the pattern is
/// long.
const NEIGHBOURS: usize = 4;
/// Columns and rows of the largest box that is made smaller.
const LARGEST_BOX: u32 = 2048;
/// Bits by which distances along a path are finer than positions.
const FINER_BITS: u32 = DISTANCE_BITS - FRACTION_BITS;

/// Some of the dashes of a segment.
pub(crate) struct DenseDashes<'a> {
    pen: Pen,
    dashes: &'a SegmentDashes<'a>,
    ruler: Ruler,
    direction: Direction,
    offsets: Offsets,
}

/// How the walk along a row goes on from a pixel.
enum Step {
    /// The pixels up to this column, exclusive, are covered.
    CoveredTo(i32),
    /// The next pixels are not covered: so many, at least one.
    Gap(i64),
}

impl<'a> DenseDashes<'a> {
    pub(crate) fn new(pen: Pen, dashes: &'a SegmentDashes<'a>, ruler: Ruler, offsets: Offsets) -> Self {
        let direction = Direction::of((ruler.to.0 - ruler.from.0, ruler.to.1 - ruler.from.1));
        Self {
            pen,
            dashes,
            ruler,
            direction,
            offsets,
        }
    }

    /// A window around the pixels of all dashes.
    pub(crate) fn pixels(&self) -> Window {
        let reach = self.pen.reach();
        let (from, to) = (self.ruler.from, self.ruler.to);
        let pixel = |units: i64| (units >> FRACTION_BITS) as i32;
        Window {
            left: pixel(from.0.min(to.0) - reach),
            top: pixel(from.1.min(to.1) - reach),
            right: pixel(from.0.max(to.0) + reach) + 1,
            bottom: pixel(from.1.max(to.1) + reach) + 1,
        }
    }

    /// Grows bounds so that they hold the pixels of all dashes: to the smallest box around them where it has at most
    /// [`LARGEST_BOX`] columns and rows, otherwise around all that dashes could cover.
    ///
    /// Cost: that of looking at all pixels of the segment's stroke in a few rows and columns.
    #[must_use]
    pub fn grow(&self, bounds: Bounds) -> Bounds {
        let pixels = self.pixels();
        if bounds.contains(&pixels.into()) {
            return bounds;
        }
        bounds.around(&self.smallest_box(pixels))
    }

    fn smallest_box(&self, pixels: Window) -> Bounds {
        if pixels.width().max(pixels.height()) > LARGEST_BOX {
            return pixels.into();
        }
        let has_pixel = |row: &Window| {
            let mut has_pixel = false;
            self.edges(row, &mut |_| has_pixel = true);
            has_pixel
        };
        let smallest = shrunk(pixels, &mut |_, strip| {
            (strip.top..strip.bottom).any(|top| {
                has_pixel(&Window {
                    top,
                    bottom: top + 1,
                    ..*strip
                })
            })
        });
        smallest.into()
    }

    /// Generates the left and the right side of each span that the dashes cover in a window of one row.
    pub(crate) fn edges(&self, window: &Window, sink: &mut dyn FnMut(StrokeEdge)) {
        debug_assert!(window.height() <= 1);
        let Some((first, end)) = self.columns(window) else {
            return;
        };
        let row = window.top;
        let (mut span_start, mut x) = (first, first);
        while x < end {
            match self.step(x, row) {
                Step::CoveredTo(next) => x = next,
                Step::Gap(pixels) => {
                    span_sides(row, (span_start, x), sink);
                    x = (i64::from(x) + pixels).min(end.into()) as i32;
                    span_start = x;
                }
            }
        }
        span_sides(row, (span_start, x), sink);
    }

    /// The columns of a window that are near the stroke in its row, without gaps: from the first to the one behind the last.
    fn columns(&self, window: &Window) -> Option<(i32, i32)> {
        let Window { left, right, top, .. } = window.intersection(&self.pixels());
        let Direction { x, y, length, .. } = self.direction;
        // From the segment to a pixel centre, across it, times the length: `slope * column + start`. Components have 30 bits,
        // positions 31: below 2^62.
        let slope = y * UNIT;
        let start = -self.ruler.from.0 * y - (i64::from(top) * UNIT - self.ruler.from.1) * x;
        let widest = (self.pen.half_width + MARGIN) * length.get() as i64;
        let columns = match (
            (-start - widest).checked_div(slope),
            (widest - start).checked_div(slope),
        ) {
            (Some(one), Some(other)) => (
                (one.min(other) - 1).max(left.into()),
                (one.max(other) + 2).min(right.into()),
            ),
            // A level segment.
            _ if start.abs() <= widest => (left.into(), right.into()),
            _ => return None,
        };
        (columns.0 < columns.1).then_some((columns.0 as i32, columns.1 as i32))
    }

    /// Where a position has its foot, in distances along the segment; outside it beyond its ends.
    fn foot(&self, (x, y): Position) -> i64 {
        let Direction {
            x: right,
            y: down,
            length,
            ..
        } = self.direction;
        let ahead = |from: Position| quotient_nearest((x - from.0) * right + (y - from.1) * down, length) << FINER_BITS;
        // Within a few units; what is left over from there is found exactly.
        let near = self.ruler.nearest(self.ruler.begin + ahead(self.ruler.from));
        near + ahead(self.ruler.at(near))
    }

    /// Decides how the walk along a row goes on from a pixel.
    fn step(&self, x: i32, row: i32) -> Step {
        #[cfg(test)]
        crate::scan::stroke::work::step();
        let foot = self.foot((i64::from(x) * UNIT, i64::from(row) * UNIT));
        let margin = MARGIN << FINER_BITS;
        let reach = (self.pen.cap_reach() << FINER_BITS) + margin;
        let mut covered_to = x;
        // How far it is to the first dash that lies ahead in the row.
        let mut ahead = i64::MAX;
        let mut look_at = |dash: Dash| {
            let (begin, end) = (dash.from - reach, dash.to + reach);
            let distance = if self.direction.x < 0 { foot - end } else { begin - foot };
            if begin <= foot && foot <= end {
                ahead = 0;
                // Of round caps that overlap, the one that reaches furthest counts.
                if covered_to == x || self.pen.has_round_caps() {
                    covered_to = covered_to.max(self.covered_to(&dash, x, row));
                }
            } else if distance > 0 {
                ahead = ahead.min(distance);
            }
        };
        let cycle = self.dashes.cycle;
        // What is beyond the limit that the segment is cut at has no pixels.
        let middle = self.ruler.nearest(foot);
        // Each round has a dash: the last ones before the foot are among these, all around it, and the first behind it.
        let enter = middle - margin - NEIGHBOURS as i64 * cycle.length();
        let (mut before, mut behind) = ([None; NEIGHBOURS], 0);
        for dash in self.dashes.between(enter, i64::MAX) {
            if cycle.is_within_caps && dash.from < middle - margin {
                before.rotate_left(1);
                let [.., last] = &mut before;
                *last = Some(dash);
                continue;
            }
            look_at(dash);
            behind += usize::from(dash.from > middle + margin);
            let is_last = if cycle.is_within_caps {
                behind == NEIGHBOURS
            } else {
                dash.from > foot + reach
            };
            if is_last {
                break;
            }
        }
        before.into_iter().flatten().for_each(look_at);
        if covered_to > x {
            return Step::CoveredTo(covered_to);
        }
        // A pixel to the right is so far ahead: `direction.x / length`.
        let units = (ahead >> FINER_BITS).min(1 << 32);
        let pixels = (units * self.direction.length.get() as i64).checked_div(self.direction.x.abs());
        Step::Gap(pixels.map_or(if ahead > 0 { i64::from(i32::MAX) } else { 1 }, |units| {
            (units >> FRACTION_BITS).max(1)
        }))
    }

    /// Column behind the last one that the polygon or a disc of a dash covers, if it covers a pixel; else that pixel's.
    fn covered_to(&self, dash: &Dash, x: i32, row: i32) -> i32 {
        #[cfg(test)]
        crate::scan::stroke::work::step();
        let ends = self.dashes.ends_of(dash, &self.ruler);
        let part = (self.ruler.at(dash.from), self.ruler.at(dash.to));
        let (corners, discs) = self.pen.shape_of_part(&self.offsets, part, ends);
        let line = Window {
            left: x,
            top: row,
            right: x,
            bottom: row + 1,
        };
        let (mut covered_to, mut other) = (x, None);
        self.pen.shape_edges(&corners, discs, &line, &mut |side| {
            if side.first_row() > row || row >= side.end_row() {
                return;
            }
            // Both sides of the polygon in the row, or of a disc.
            let column = side.crossing_at(row).x;
            match other.take() {
                None => other = Some(column),
                Some(other) if column.min(other) <= x => covered_to = covered_to.max(column.max(other)),
                Some(_) => {}
            }
        });
        covered_to
    }
}

/// Generates both sides of a span, with the sense of rotation that the polygons of a stroke have.
fn span_sides(row: i32, (start, end): (i32, i32), sink: &mut dyn FnMut(StrokeEdge)) {
    if start >= end {
        return;
    }
    let corner = |column: i32, row: i32| (column << FRACTION_BITS, row << FRACTION_BITS);
    for (column, top, bottom) in [(start, row, row + 1), (end, row + 1, row)] {
        if let Some(side) = Edge::from_units(corner(column, top), corner(column, bottom), FRACTION_BITS, Part::Stroke) {
            sink(StrokeEdge::Straight(side));
        }
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::{collections::BTreeSet, vec, vec::Vec};

    use fixed::types::{I16F16, U16F16};
    use proptest::prelude::*;

    use super::*;
    use crate::cases::{cases, config};
    use crate::scan::{
        polygon::{
            banded_polygon,
            scanline_polygon::{FillRule, PartRule},
        },
        stroke::{DashPattern, LineCap, LineJoin, styled_stroke::StyledStroke, wide_stroke::Path},
    };

    type Pixels = BTreeSet<(i32, i32)>;

    /// The union of all dashes of a stroke, each filled by itself from where its shapes cross each row.
    fn one_by_one(stroke: &StyledStroke<'_>, window: &Window) -> Pixels {
        let mut pixels = Pixels::new();
        stroke.each_dash(window, &mut |source| {
            let mut edges = Vec::new();
            source(window, &mut |edge: StrokeEdge| edges.push(edge));
            for row in window.top..window.bottom {
                let mut crossings: Vec<(i32, i8)> = edges
                    .iter()
                    .filter(|edge| edge.first_row() <= row && row < edge.end_row())
                    .map(|edge| (edge.crossing_at(row).x, edge.windings().1))
                    .collect();
                crossings.sort_unstable();
                let mut winding = 0;
                for (index, &(x, change)) in crossings.iter().enumerate() {
                    winding += change;
                    let end = crossings.get(index + 1).map_or(x, |next| next.0);
                    if winding != 0 {
                        pixels.extend((x.max(window.left)..end.min(window.right)).map(|x| (x, row)));
                    }
                }
            }
        });
        pixels
    }

    /// A stroke with the dashes of every segment drawn as spans of rows, however few they are.
    fn as_spans(stroke: &StyledStroke<'_>, window: &Window) -> Pixels {
        let mut pixels = Pixels::new();
        for top in window.top..window.bottom {
            let row = Window {
                top,
                bottom: top + 1,
                ..*window
            };
            let source = |part: &Window, sink: &mut dyn FnMut(StrokeEdge)| stroke.dense_edges(part, sink);
            let rule = PartRule::fill(FillRule::NonZero);
            let Ok::<(), ()>(()) = banded_polygon::scan(&source, rule, &row, |span, _| {
                for x in span.start..span.end {
                    assert!(pixels.insert((x, span.y)), "({x}, {}) twice", span.y);
                }
                Ok(())
            }) else {
                return pixels;
            };
        }
        pixels
    }

    /// At these lengths rounding decides which dash a pixel centre lies in.
    #[test]
    fn dashes_of_a_few_units_are_the_dashes_one_by_one() {
        let mut drawn = 0;
        let ends = [
            (327_001, 5_003),
            (250_007, 270_011),
            (-3, -300_001),
            (-290_017, 123_457),
        ];
        for (x, y) in ends {
            for (lengths, cap) in [
                (&[3, 2][..], LineCap::Butt),
                (&[5], LineCap::Butt),
                (&[2, 0, 1, 9], LineCap::Butt),
                (&[0, 400], LineCap::Round),
                (&[1, 363], LineCap::Round),
                (&[0, 65_537], LineCap::WholePixel),
                (&[1, 65_537], LineCap::Square),
            ] {
                let vertex = |index: usize| {
                    if index == 0 {
                        (400_003, 390_001)
                    } else {
                        (400_003 + x, 390_001 + y)
                    }
                };
                let path = Path::new(&vertex, 2, false, 2);
                let lengths: Vec<U16F16> = lengths.iter().copied().map(U16F16::from_bits).collect();
                let stroke = StyledStroke::new(&path, cap, LineJoin::Bevel, Some(DashPattern::new(&lengths)));
                let window = Window {
                    left: 0,
                    top: 0,
                    right: 16,
                    bottom: 16,
                };
                let pixels = as_spans(&stroke, &window);
                assert_eq!(pixels, one_by_one(&stroke, &window), "{lengths:?} {cap:?} {x} {y}");
                drawn += pixels.len();
            }
        }
        assert!(drawn > 100, "{drawn}");
    }

    fn cap() -> impl Strategy<Value = LineCap> {
        prop::sample::select(vec![
            LineCap::WholePixel,
            LineCap::Butt,
            LineCap::Square,
            LineCap::Round,
        ])
    }

    /// In 1/65,536 pixel; long ones, too, and such as are about what the caps bridge.
    fn length() -> impl Strategy<Value = u32> {
        prop_oneof![
            3 => 64..3_000u32,
            2 => 3_000..300_000u32,
            1 => Just(0),
            1 => any::<u32>(),
            1 => (1..40u32).prop_map(|pixels| pixels << 16),
        ]
    }

    /// Vertices in 1/65,536 pixel: near a small window, and far away in any direction.
    fn vertex() -> impl Strategy<Value = Position> {
        let coordinate = || {
            prop_oneof![
                4 => -20 * UNIT..36 * UNIT,
                3 => (-20..36i64).prop_map(|pixel| pixel * UNIT),
                1 => -20_000 * UNIT..20_000 * UNIT,
                1 => i64::from(i32::MIN) * UNIT..=i64::from(i32::MAX) * UNIT,
            ]
        };
        (coordinate(), coordinate())
    }

    /// Corner of a window in pixels: in the middle of the domain, near its limit, and at it.
    fn origin() -> impl Strategy<Value = i32> {
        prop_oneof![3 => Just(0), 1 => -8_200..8_200i32, 1 => prop::sample::select(vec![-16_392, 16_376])]
    }

    proptest! {
        #![proptest_config(config(cases(300, 1_500)))]

        #[test]
        fn spans_of_dashes_are_the_dashes_one_by_one(
            vertices in prop::collection::vec(vertex(), 2..4),
            closed in any::<bool>(),
            width in prop_oneof![1..12u64, 1..=200u64, any::<u64>()],
            cap in cap(),
            lengths in prop::collection::vec(length(), 1..6),
            offset in any::<i32>(),
            origin in (origin(), origin()),
        ) {
            let lengths: Vec<U16F16> = lengths.into_iter().map(U16F16::from_bits).collect();
            let total: u64 = lengths.iter().map(|length| u64::from(length.to_bits())).sum();
            // Otherwise there is nothing to compare, or too much.
            prop_assume!(total >= 60 * lengths.len() as u64);
            let vertex = |index: usize| {
                let (x, y) = vertices[index];
                (x + i64::from(origin.0) * UNIT, y + i64::from(origin.1) * UNIT)
            };
            let path = Path::new(&vertex, vertices.len(), closed, width);
            let dashes = DashPattern::new(&lengths).offset(I16F16::from_bits(offset));
            let stroke = StyledStroke::new(&path, cap, LineJoin::Bevel, Some(dashes));
            let (left, top) = origin;
            let window = Window { left, top, right: left + 16, bottom: top + 16 };
            prop_assert_eq!(as_spans(&stroke, &window), one_by_one(&stroke, &window));
        }
    }
}
