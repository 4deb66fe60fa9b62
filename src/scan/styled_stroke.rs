//! Strokes with caps, joins and dashes, as polygons and discs.
//!
//! Promises: the stroke is the union of
//! - for each segment, or each part of it that a dash covers, the rectangle of the stroke's width along it, with its corners
//!   rounded to 1/65,536 pixel. Dashes of a segment whose caps reach further than the pattern is long are one where these
//!   close the gap between them ([`DashPattern`](crate::scan::DashPattern) says which);
//! - for each corner that the stroke runs through, what the join adds at the outer side: the wedge up to the tip or up to
//!   the straight line between the outer corners, or the disc about the corner;
//! - for each end, of the path or of a dash, what the cap adds. Where a closed path is on before and after its first vertex,
//!   that is a corner and not an end.
//!
//! Discs are exact: a pixel belongs when the square of its distance to the centre is below that of half the width in
//! 1/65,536 pixel, and on a tie by the top-left rule. What is drawn of a dash does not depend on the window.
//!
//! With the default cap and join and without dashes it is the stroke of [`wide_stroke`](crate::scan::wide_stroke), pixel by
//! pixel; far segments, widths and their limits as there. Dashes are counted from the beginning of the path, seen or not;
//! how exactly, [`dash_pattern`](crate::scan::dash_pattern) says.
//!
//! Cost: dashes out of sight cost nothing. A segment with more than 32 of them near the window, or more than 4 that may
//! overlap, hands over none of them one by one: they are spans of a row, at most one for each pixel that the segment's
//! stroke has there without the gaps ([`dense_dashes`](crate::scan::dense_dashes)).

use core::num::NonZeroU64;

use crate::{
    geometry::{Bounds, Window},
    scan::{
        Crossing, DiscSide, Edge, LineCap, LineJoin, ScanEdge,
        banded_polygon::EdgeSource,
        dash_pattern::{DISTANCE_BITS, Dash, DashCycle, DashPattern, Dashes, Stretch},
        dense_dashes::DenseDashes,
        grouped_pieces::EdgedPiece,
        wide_stroke::{
            Corner, Direction, FRACTION_BITS, Offsets, Path, Position, Segment, UNIT, beyond_limit, cut, each_side,
            is_within, narrow, negated, outer_sides, round_divide,
        },
    },
};

/// Most dashes of a segment near the window that are handed over one by one, if no two of them share a pixel.
const MOST_DISJOINT: usize = 32;
/// Most of them otherwise: each one is one more to be drawn together with the others.
const MOST_OVERLAPPING: usize = 4;

/// Most dashes of a segment that the box around a stroke follows one by one.
const MOST_MEASURED: usize = 256;

/// Limit to the dashes of a segment that are handed over one by one.
#[derive(Copy, Clone)]
struct MostDashes {
    number: usize,
    /// A distance along the path within which there cannot be more dashes than that: these need not be counted.
    stretch: i64,
}

impl MostDashes {
    const ALL: Self = Self {
        number: usize::MAX,
        stretch: i64::MAX,
    };
}

/// One of the shapes whose union is a stroke.
struct Piece<'a> {
    /// Of a convex polygon; all have the same sense of rotation. None where there are discs only.
    corners: &'a [Corner],
    /// As wide as the stroke, about these positions.
    discs: [Option<Corner>; 2],
    /// The number of the segment that it is a dash of.
    segment: Option<usize>,
    /// All dashes of a segment, to be drawn row by row: then there are no corners and discs.
    dashes: Option<&'a DenseDashes<'a>>,
}

impl<'a> Piece<'a> {
    const fn polygon(corners: &'a [Corner]) -> Self {
        Self {
            corners,
            discs: [None; 2],
            segment: None,
            dashes: None,
        }
    }

    const fn disc(center: Corner) -> Self {
        Self {
            corners: &[],
            discs: [Some(center), None],
            segment: None,
            dashes: None,
        }
    }

    /// A window around its pixels, where discs are so wide.
    fn pixels(&self, half_width: i64) -> Window {
        if let Some(dashes) = self.dashes {
            return dashes.pixels();
        }
        let mut pixels = Window {
            left: i32::MAX,
            top: i32::MAX,
            right: i32::MIN,
            bottom: i32::MIN,
        };
        let mut include = |(x, y): Corner, reach: i32| {
            pixels.left = pixels.left.min((x - reach) >> FRACTION_BITS);
            pixels.top = pixels.top.min((y - reach) >> FRACTION_BITS);
            pixels.right = pixels.right.max(((x + reach) >> FRACTION_BITS) + 1);
            pixels.bottom = pixels.bottom.max(((y + reach) >> FRACTION_BITS) + 1);
        };
        for &corner in self.corners {
            include(corner, 0);
        }
        for center in self.discs.into_iter().flatten() {
            include(center, half_width as i32);
        }
        pixels
    }
}

type Sink<'s> = dyn FnMut(Piece<'_>) + 's;

/// Shapes whose union is a stroke.
pub(crate) enum StrokeShape<'a> {
    /// A convex polygon, and the centres of discs that are as wide as the stroke.
    Polygon(&'a [Corner], [Option<Corner>; 2]),
    /// The dashes of a segment with very many of them.
    Dashes(&'a DenseDashes<'a>),
}

/// A path with everything that shapes its stroke.
#[derive(Copy, Clone)]
pub struct StyledStroke<'a> {
    path: Path<'a>,
    cap: LineCap,
    join: LineJoin,
    dashes: Option<DashCycle<'a>>,
    /// Whether the first vertex is a corner.
    is_joined: bool,
}

impl<'a> StyledStroke<'a> {
    /// The stroke of a path. Cost: a square root a segment where a closed path is dashed.
    pub fn new(path: &Path<'a>, cap: LineCap, join: LineJoin, dashes: Option<DashPattern<'a>>) -> Self {
        let dashes = dashes.and_then(|dashes| dashes.cycle(cap, path.half_width));
        let is_joined = path.closed
            && dashes.is_none_or(|dashes| {
                let end = segments(path).fold(dashes.start, |place, (from, to)| {
                    dashes.after(place, distance(from, to))
                });
                dashes.dash_before(dashes.start).is_some() && is_inside_dash(&dashes, end)
            });
        Self {
            path: *path,
            cap,
            join,
            dashes,
            is_joined,
        }
    }

    /// Generates the edges of the stroke near the window: of each dash, however many there are.
    ///
    /// Cost: a square root for each segment near the window, and for each segment at all where there are dashes.
    pub fn edges(&self, window: &Window, sink: &mut dyn FnMut(StrokeEdge)) {
        self.pieces(Some(window), MostDashes::ALL, &mut |piece| {
            self.piece_edges(&piece, window, sink)
        });
    }

    fn piece_edges(&self, piece: &Piece<'_>, window: &Window, sink: &mut dyn FnMut(StrokeEdge)) {
        match piece.dashes {
            Some(dashes) => dashes.edges(window, sink),
            None => self.shape_edges(piece.corners, piece.discs, window, sink),
        }
    }

    /// Generates the edges of a polygon and of discs that reach the rows of a window: one after the other, so that those
    /// that cross a row are two of each.
    pub(super) fn shape_edges(
        &self,
        corners: &[Corner],
        discs: [Option<Corner>; 2],
        window: &Window,
        sink: &mut dyn FnMut(StrokeEdge),
    ) {
        #[cfg(test)]
        let sink = &mut |edge| {
            crate::scan::work::step();
            sink(edge);
        };
        each_side(corners, window, &mut |side| sink(StrokeEdge::Straight(side)));
        for center in discs.into_iter().flatten() {
            for side in DiscSide::both(center, self.path.half_width as i32) {
                if side.first_row() < side.end_row() {
                    sink(StrokeEdge::Disc(side));
                }
            }
        }
    }

    /// Calls with each piece near the window. Those of one segment are a row, if there are gaps between the caps of its
    /// dashes; the number is that of the path.
    ///
    /// Cost: a square root for each segment near the window, and for each segment at all where there are dashes; at most
    /// [`MOST_DISJOINT`] pieces a segment, and one a corner.
    pub(crate) fn each_piece(&self, path: usize, window: &Window, call: &mut dyn FnMut(&EdgedPiece<'_>)) {
        let are_apart = self.are_apart();
        let most = self.most_dashes(if are_apart { MOST_DISJOINT } else { MOST_OVERLAPPING });
        self.pieces(Some(window), most, &mut |piece| {
            call(&EdgedPiece {
                around: piece.pixels(self.path.half_width),
                row: piece.segment.filter(|_| are_apart).map(|segment| (path, segment)),
                is_row_by_row: piece.dashes.is_some(),
                edges: &|window: &Window, sink: &mut dyn FnMut(StrokeEdge)| self.piece_edges(&piece, window, sink),
            });
        });
    }

    /// Calls with the edges of each dash near the window, of a stroke that [is apart](Self::is_apart).
    pub fn each_dash(&self, window: &Window, call: &mut dyn FnMut(&EdgeSource<'_, StrokeEdge>)) {
        self.pieces(Some(window), MostDashes::ALL, &mut |piece| {
            call(&|window, sink| self.piece_edges(&piece, window, sink));
        });
    }

    /// Generates the edges of all dashes near a window of one row as spans, and those of the corners.
    #[cfg(test)]
    pub(super) fn dense_edges(&self, window: &Window, sink: &mut dyn FnMut(StrokeEdge)) {
        self.pieces(Some(window), self.most_dashes(0), &mut |piece| {
            self.piece_edges(&piece, window, sink)
        });
    }

    /// Whether no two pieces share a pixel, and there are at most four to a pixel of the path's length: one segment, with
    /// dashes apart.
    pub fn is_apart(&self) -> bool {
        self.path.count == 2 && !self.path.closed && self.are_apart()
    }

    /// Whether no two dashes of a segment share a pixel, by a quarter of a pixel.
    fn are_apart(&self) -> bool {
        /// In 1/65,536 pixel: more than what the rounding of two dashes is worth, and enough to bound their number.
        const MARGIN: i64 = UNIT / 4;
        let reach = self.cap.reach(self.path.half_width);
        let least = (2 * reach + MARGIN) << (DISTANCE_BITS - FRACTION_BITS);
        self.dashes.is_some_and(|dashes| dashes.shortest_gap >= least)
    }

    /// Hands over the convex polygons and the discs whose union is the stroke: the corners of one, and the centres of up to
    /// two others, which are as wide as the stroke. More than [`MOST_MEASURED`] dashes of a segment come together. Cost: a square root a segment.
    pub fn shapes(&self, sink: &mut dyn FnMut(StrokeShape<'_>)) {
        self.pieces(None, self.most_dashes(MOST_MEASURED), &mut |piece| {
            sink(match piece.dashes {
                Some(dashes) => StrokeShape::Dashes(dashes),
                None => StrokeShape::Polygon(piece.corners, piece.discs),
            });
        });
    }

    /// Around the pixels of a disc as wide as the stroke as well.
    pub fn with_disc(&self, bounds: Bounds, center: Corner) -> Bounds {
        let around = Piece::disc(center).pixels(self.path.half_width);
        if bounds.contains(&around.into()) {
            return bounds;
        }
        bounds.around(&DiscSide::bounds(center, self.path.half_width as i32))
    }

    fn most_dashes(&self, number: usize) -> MostDashes {
        let stretch = self.dashes.map_or(0, |dashes| dashes.stretch_of(number));
        MostDashes { number, stretch }
    }

    /// Generates the pieces near a window, or all; at most so many dashes of a segment one by one.
    fn pieces(&self, window: Option<&Window>, most: MostDashes, sink: &mut Sink<'_>) {
        let mut first: Option<Segment> = None;
        let mut before: Option<Segment> = None;
        let mut position = self.dashes.map_or(0, |dashes| dashes.start);
        let mut segments = segments(&self.path).enumerate().peekable();
        while let Some((number, (from, to))) = segments.next() {
            let mut segment = Segment::new(from, to);
            let comes_in = match &mut before {
                Some(before) => {
                    let comes_in = self.dashes.is_none_or(|dashes| is_inside_dash(&dashes, position));
                    if comes_in {
                        self.corner(before, &mut segment, window, sink);
                    }
                    comes_in
                }
                None => self.is_joined,
            };
            let ends = Ends {
                begins: !comes_in,
                ends: segments.peek().is_none() && !self.is_joined,
            };
            match &self.dashes {
                None => self.solid(&mut segment, ends, window, sink),
                Some(dashes) => {
                    let length = distance(from, to);
                    let dashes = SegmentDashes {
                        cycle: dashes,
                        position,
                        length,
                        ends,
                    };
                    position = dashes.cycle.after(position, length);
                    self.dashed(&mut segment, &dashes, (window, most), &mut |piece| {
                        sink(Piece {
                            segment: Some(number),
                            ..piece
                        });
                    });
                }
            }
            first.get_or_insert(segment);
            before = Some(segment);
        }
        match (&mut before, &mut first) {
            (Some(last), Some(first)) if self.is_joined => self.corner(last, first, window, sink),
            (None, _) => self.dot(window, sink),
            _ => {}
        }
    }

    /// A path whose vertices are all one has the caps of a level stroke.
    fn dot(&self, window: Option<&Window>, sink: &mut Sink<'_>) {
        let is_on = |dashes: DashCycle<'_>| dashes.dashes(dashes.start, 1, (0, 1)).next().is_some();
        if self.path.count == 0 || !self.dashes.is_none_or(is_on) {
            return;
        }
        let place = (self.path.vertex)(0);
        let mut dot = Segment::new(place, (place.0 + UNIT, place.1));
        let ends = Ends {
            begins: true,
            ends: true,
        };
        if !beyond_limit(place) {
            self.part(&mut dot, (place, place), ends, window, sink);
        }
    }

    fn solid(&self, segment: &mut Segment, ends: Ends, window: Option<&Window>, sink: &mut Sink<'_>) {
        if !is_within(segment.from, segment.to, self.reach(), window) {
            return;
        }
        if let Some((from, to)) = cut(segment.from, segment.to) {
            let ends = Ends {
                begins: ends.begins && from == segment.from,
                ends: ends.ends && to == segment.to,
            };
            self.part(segment, (from, to), ends, window, sink);
        }
    }

    /// The parts of a segment that are on.
    fn dashed(
        &self,
        segment: &mut Segment,
        dashes: &SegmentDashes<'_>,
        (window, most): (Option<&Window>, MostDashes),
        sink: &mut Sink<'_>,
    ) {
        if !is_within(segment.from, segment.to, self.reach(), window) {
            return;
        }
        let Some(ruler) = Ruler::along(segment, dashes.length) else {
            return;
        };
        let (from, to) = ruler.visible(self.reach(), window);
        let visible = dashes.between(from, to);
        if to - from > most.stretch && visible.clone().nth(most.number).is_some() {
            return self.dense(segment, dashes, ruler, sink);
        }
        for dash in visible {
            let ends = dashes.ends_of(&dash, &ruler);
            self.part(segment, (ruler.at(dash.from), ruler.at(dash.to)), ends, window, sink);
        }
    }

    /// Hands over all dashes of a segment as one piece.
    #[inline(never)]
    fn dense(&self, segment: &mut Segment, dashes: &SegmentDashes<'_>, ruler: Ruler, sink: &mut Sink<'_>) {
        let dense = DenseDashes::new(self, dashes, ruler, segment.offsets(self.path.half_width));
        sink(Piece {
            dashes: Some(&dense),
            ..Piece::polygon(&[])
        });
    }

    /// The rectangle along a part of a segment, and its caps.
    fn part(
        &self,
        segment: &mut Segment,
        part: (Position, Position),
        ends: Ends,
        window: Option<&Window>,
        sink: &mut Sink<'_>,
    ) {
        if !is_within(part.0, part.1, self.reach(), window) {
            return;
        }
        let (corners, discs) = self.shape_of_part(&segment.offsets(self.path.half_width), part, ends);
        sink(Piece {
            discs,
            ..Piece::polygon(&corners)
        });
    }

    /// The corners of the rectangle along a part of a segment, and the centres of its round caps.
    pub(super) fn shape_of_part(
        &self,
        offsets: &Offsets,
        (from, to): (Position, Position),
        ends: Ends,
    ) -> ([Corner; 4], [Option<Corner>; 2]) {
        let (right, down) = self.cap.extension(offsets);
        let moved = |(x, y): Position, (right, down): Position| (x + right, y + down);
        let first = if ends.begins {
            moved(from, (-right, -down))
        } else {
            from
        };
        let last = if ends.ends { moved(to, (right, down)) } else { to };
        let normal = offsets.normal;
        let opposite = negated(normal);
        let disc = |center: Position, is_there: bool| {
            let is_there = is_there && self.cap == LineCap::Round;
            is_there.then(|| narrow(center))
        };
        let corners = [
            narrow(moved(first, normal)),
            narrow(moved(last, normal)),
            narrow(moved(last, opposite)),
            narrow(moved(first, opposite)),
        ];
        let discs = [
            disc(from, ends.begins),
            disc(to, ends.ends && !(ends.begins && from == to)),
        ];
        (corners, discs)
    }

    /// What the join adds at the outer side of the corner between two segments.
    fn corner(&self, before: &mut Segment, after: &mut Segment, window: Option<&Window>, sink: &mut Sink<'_>) {
        let half_width = self.path.half_width;
        let corner = after.from;
        if beyond_limit(corner) || !is_within(corner, corner, self.join.reach(half_width) + UNIT, window) {
            return;
        }
        let normal_before = before.offsets(half_width).normal;
        let normal_after = after.offsets(half_width).normal;
        if self.join == LineJoin::Round {
            if normal_before != normal_after {
                sink(Piece::disc(narrow(corner)));
            }
            return;
        }
        let Some((one, other)) = outer_sides(normal_before, normal_after) else {
            return;
        };
        let at = |offset: Position| narrow((corner.0 + offset.0, corner.1 + offset.1));
        match self.join.tip((before, after), (one, other), half_width) {
            Some(tip) => sink(Piece::polygon(&[narrow(corner), at(one), at(tip), at(other)])),
            None => sink(Piece::polygon(&[narrow(corner), at(one), at(other)])),
        }
    }

    /// From the path to the outermost point of a rectangle or a cap, to one side.
    pub(super) fn reach(&self) -> i64 {
        2 * self.path.half_width + UNIT
    }

    /// From the end of a dash to the outermost point of its cap along the segment.
    pub(super) fn cap_reach(&self) -> i64 {
        self.cap.reach(self.path.half_width)
    }

    pub(super) fn has_round_caps(&self) -> bool {
        self.cap == LineCap::Round
    }

    /// From the middle of the stroke to a side, in units.
    pub(super) fn half_width(&self) -> i64 {
        self.path.half_width
    }
}

/// Which ends of something are ends of the stroke.
#[derive(Copy, Clone)]
pub(super) struct Ends {
    begins: bool,
    ends: bool,
}

/// The dashes of a segment, in distances from its begin.
#[derive(Copy, Clone)]
pub(super) struct SegmentDashes<'a> {
    pub(super) cycle: &'a DashCycle<'a>,
    /// Position in the cycle where the segment begins.
    position: i64,
    pub(super) length: i64,
    /// Which ends of the segment are ends of the stroke where a dash reaches them.
    ends: Ends,
}

impl<'a> SegmentDashes<'a> {
    /// The dashes that begin before `to` and do not end before `from`.
    pub(super) fn between(&self, from: i64, to: i64) -> Dashes<'a, 'a> {
        self.cycle.dashes(self.position, self.length, (from, to))
    }

    /// Which ends of a dash have a cap: not where it is cut at the limit, and not where it goes on around a corner.
    pub(super) fn ends_of(&self, dash: &Dash, ruler: &Ruler) -> Ends {
        Ends {
            begins: (dash.begins || self.ends.begins) && ruler.reaches(dash.from),
            ends: (dash.ends || self.ends.ends) && ruler.reaches(dash.to),
        }
    }
}

/// Distances along what is left of a segment when it is cut at the limit.
#[derive(Copy, Clone)]
pub(super) struct Ruler {
    pub(super) from: Position,
    pub(super) to: Position,
    /// The distances of both.
    pub(super) begin: i64,
    pub(super) end: i64,
}

impl Ruler {
    fn along(segment: &Segment, length: i64) -> Option<Self> {
        let (from, to) = cut(segment.from, segment.to)?;
        let begin = if from == segment.from {
            0
        } else if to == segment.to {
            // The length of a far segment may err by more than what is left of it is long.
            (length - distance(from, to)).max(0)
        } else {
            distance(segment.from, from)
        };
        let end = if to == segment.to {
            length
        } else {
            begin + distance(from, to)
        };
        Some(Self { from, to, begin, end })
    }

    /// Whether a distance is not beyond the limit.
    fn reaches(&self, distance: i64) -> bool {
        self.begin <= distance && distance <= self.end
    }

    /// The distance, or the end that it is beyond.
    pub(super) fn nearest(&self, distance: i64) -> i64 {
        debug_assert!(self.begin <= self.end);
        // Not by `Ord::clamp`, which panics where the ends are swapped: no compiler proves that they are not.
        distance.max(self.begin).min(self.end)
    }

    /// The position at a distance, to the nearest unit; for what is longer than 2^7 pixels within two.
    pub(super) fn at(&self, distance: i64) -> Position {
        if distance <= self.begin {
            return self.from;
        }
        if distance >= self.end {
            return self.to;
        }
        // To 31 bits: the products fit.
        let length = self.end - self.begin;
        let shift = 33u32.saturating_sub(length.leading_zeros());
        let part = (distance - self.begin) >> shift;
        let Some(whole) = NonZeroU64::new((length >> shift) as u64) else {
            return self.from;
        };
        let between = |from: i64, to: i64| from + round_divide((to - from) * part, whole);
        (between(self.from.0, self.to.0), between(self.from.1, self.to.1))
    }

    /// Distances between which all lies that comes as near as `reach` to the window, and some more.
    fn visible(&self, reach: i64, window: Option<&Window>) -> Stretch {
        let all = (self.begin, self.end);
        let Some(window) = window else { return all };
        let beside = self.between((self.from.0, self.to.0), (window.left, window.right), reach);
        let above = self.between((self.from.1, self.to.1), (window.top, window.bottom), reach);
        (beside.0.max(above.0), beside.1.min(above.1))
    }

    /// Distances between which the coordinates along an axis, from one to the other, are within `reach` of those pixels.
    fn between(&self, (from, to): (i64, i64), (first, end): (i32, i32), reach: i64) -> Stretch {
        /// Positions in 1/256 pixel and distances in 1/65,536: the products fit. Reaches have more than that to spare.
        const FEWER_BITS: u32 = 8;
        let all = (self.begin, self.end);
        let (first, end) = (i64::from(first) * UNIT - reach, i64::from(end) * UNIT + reach);
        let extent = (to - from).unsigned_abs() >> FEWER_BITS;
        // What is all within reach, or is shorter than 16 pixels, is not worth the divisions.
        let is_within = first <= from.min(to) && from.max(to) <= end;
        let is_short = extent < 16 << (FRACTION_BITS - FEWER_BITS);
        let (Some(extent), false) = (NonZeroU64::new(extent), is_within || is_short) else {
            return all;
        };
        let length = (self.end - self.begin) >> FEWER_BITS;
        let at = |coordinate: i64| {
            let part = ((coordinate - from) * (to - from).signum()) >> FEWER_BITS;
            let part = part.clamp(0, extent.get() as i64);
            self.begin + (round_divide(part * length, extent) << FEWER_BITS)
        };
        let (near, far) = (at(first), at(end));
        // What shifting and rounding are worth is less than a pixel.
        let margin = 2 << DISTANCE_BITS;
        (
            (near.min(far) - margin).max(self.begin),
            (near.max(far) + margin).min(self.end),
        )
    }
}

/// The segments of a path that have a length.
fn segments<'a>(path: &Path<'a>) -> impl Iterator<Item = (Position, Position)> + use<'a> {
    let path = *path;
    let first = (path.vertex)(0);
    let mut from = first;
    (1..=path.last_number()).filter_map(move |number| {
        let to = if number == path.count {
            first
        } else {
            (path.vertex)(number)
        };
        let segment = (from, to);
        from = to;
        (segment.0 != segment.1).then_some(segment)
    })
}

/// The distance between two positions, rounded down to 2^-29 of itself and to 1/2^24 pixel.
fn distance(from: Position, to: Position) -> i64 {
    if from == to {
        return 0;
    }
    const MORE_BITS: i32 = (DISTANCE_BITS - FRACTION_BITS) as i32;
    let direction = Direction::of((to.0 - from.0, to.1 - from.1));
    let shift = direction.scale - MORE_BITS;
    let length = direction.length.get() as i64;
    if shift > 0 {
        (length + (1 << (shift - 1))) >> shift
    } else {
        length << -shift
    }
}

/// Whether a dash goes on through a place: it neither begins nor ends there.
fn is_inside_dash(dashes: &DashCycle<'_>, place: i64) -> bool {
    dashes.dash_before(place).is_some_and(|before| before > 0)
}

/// An edge of a stroke.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum StrokeEdge {
    /// A side of a rectangle or of a wedge.
    Straight(Edge),
    /// A side of a disc.
    Disc(DiscSide),
}

/// The same question to either edge.
macro_rules! either {
    ($edge:expr, $side:ident => $answer:expr) => {
        match $edge {
            StrokeEdge::Straight($side) => $answer,
            StrokeEdge::Disc($side) => $answer,
        }
    };
}

impl ScanEdge for StrokeEdge {
    fn first_row(&self) -> i32 {
        either!(self, side => side.first_row())
    }

    fn end_row(&self) -> i32 {
        either!(self, side => side.end_row())
    }

    fn crossing_at(&self, row: i32) -> Crossing {
        either!(self, side => side.crossing_at(row))
    }

    fn next_crossing(&self, before: Crossing, row: i32) -> Crossing {
        either!(self, side => ScanEdge::next_crossing(side, before, row))
    }

    fn windings(&self) -> (i8, i8) {
        either!(self, side => side.windings())
    }
}

impl core::fmt::Debug for StyledStroke<'_> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        formatter
            .debug_struct("StyledStroke")
            .field("path", &self.path)
            .field("cap", &self.cap)
            .field("join", &self.join)
            .finish_non_exhaustive()
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for StyledStroke<'_> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "{} with {} and {}", self.path, self.cap, self.join);
    }
}
