//! Strokes with caps, joins and dashes, as polygons and discs.
//!
//! Promises: the stroke is the union of
//! - for each segment, or each part of it that a dash covers, the rectangle of the stroke's width along it, with its corners
//!   rounded to 1/65,536 pixel;
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

use crate::{
    geometry::Window,
    scan::{
        Crossing, DiscSide, Edge, LineCap, LineJoin, ScanEdge,
        dash_pattern::{DISTANCE_BITS, DashCycle, DashPattern, Stretch},
        grouped_pieces::EdgedPiece,
        wide_stroke::{
            Corner, Direction, FRACTION_BITS, Offsets, Path, Position, Segment, UNIT, beyond_limit, cut, each_side,
            is_within, narrow, outer_sides, round_divide,
        },
    },
};

/// One of the shapes whose union is a stroke.
struct Piece<'a> {
    /// Of a convex polygon; all have the same sense of rotation. None where there are discs only.
    corners: &'a [Corner],
    /// As wide as the stroke, about these positions.
    discs: [Option<Corner>; 2],
    /// The number of the segment that it is a dash of.
    segment: Option<usize>,
}

impl<'a> Piece<'a> {
    const fn polygon(corners: &'a [Corner]) -> Self {
        Self {
            corners,
            discs: [None; 2],
            segment: None,
        }
    }

    const fn disc(center: Corner) -> Self {
        Self {
            corners: &[],
            discs: [Some(center), None],
            segment: None,
        }
    }

    /// A window around its pixels, where discs are so wide.
    fn pixels(&self, half_width: i64) -> Window {
        let around = |&(x, y): &Corner, reach: i64| {
            let (x, y) = (i64::from(x), i64::from(y));
            [x - reach, y - reach, x + reach, y + reach].map(|units| (units >> FRACTION_BITS) as i32)
        };
        let corners = self.corners.iter().map(|corner| around(corner, 0));
        let discs = self.discs.iter().flatten().map(|center| around(center, half_width));
        let extent = corners.chain(discs).reduce(|one, other| {
            let [left, top, right, bottom] = other;
            [one[0].min(left), one[1].min(top), one[2].max(right), one[3].max(bottom)]
        });
        let [left, top, right, bottom] = extent.unwrap_or([0, 0, -1, -1]);
        Window {
            left,
            top,
            right: right.wrapping_add(1),
            bottom: bottom.wrapping_add(1),
        }
    }
}

type Sink<'s> = dyn FnMut(Piece<'_>) + 's;

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
        let dashes = dashes.and_then(|dashes| dashes.cycle());
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

    /// Generates the edges of the stroke near the window.
    ///
    /// Cost: a square root for each segment near the window, and for each segment at all where there are dashes.
    pub fn edges(&self, window: &Window, sink: &mut dyn FnMut(StrokeEdge)) {
        self.pieces(Some(window), &mut |piece| self.piece_edges(&piece, window, sink));
    }

    fn piece_edges(&self, piece: &Piece<'_>, window: &Window, sink: &mut dyn FnMut(StrokeEdge)) {
        each_side(piece.corners, window, &mut |side| sink(StrokeEdge::Straight(side)));
        for center in piece.discs.into_iter().flatten() {
            for side in DiscSide::both(center, self.path.half_width as i32) {
                if side.first_row() < side.end_row() {
                    sink(StrokeEdge::Disc(side));
                }
            }
        }
    }

    /// Calls with each piece near the window. Those of one segment are a row, if there are gaps between the caps of its
    /// dashes; the number is that of the path.
    pub(crate) fn each_piece(&self, path: usize, window: &Window, call: &mut dyn FnMut(&EdgedPiece<'_>)) {
        let are_apart = self.are_apart();
        self.pieces(Some(window), &mut |piece| {
            call(&EdgedPiece {
                around: piece.pixels(self.path.half_width),
                row: piece.segment.filter(|_| are_apart).map(|segment| (path, segment)),
                edges: &|window: &Window, sink: &mut dyn FnMut(StrokeEdge)| self.piece_edges(&piece, window, sink),
            });
        });
    }

    /// Whether no two pieces share a pixel: one segment, with dashes apart.
    pub fn is_apart(&self) -> bool {
        self.path.count == 2 && !self.path.closed && self.are_apart()
    }

    /// Whether no two dashes of a segment share a pixel.
    fn are_apart(&self) -> bool {
        /// In 1/65,536 pixel: more than what the rounding of two dashes is worth.
        const MARGIN: i64 = 16;
        let reach = self.cap.reach(self.path.half_width);
        let least = (2 * reach + MARGIN) << (DISTANCE_BITS - FRACTION_BITS);
        self.dashes.is_some_and(|dashes| dashes.shortest_gap() >= least)
    }

    /// Hands over two opposite corners of boxes that are around the stroke. Dashes reach to every vertex here, whether they
    /// do or not. Cost: a square root a segment.
    pub fn boxes(&self, sink: &mut dyn FnMut([Position; 2])) {
        let half = self.path.half_width;
        let around = |(x, y): Position, reach: i64| [(x - reach, y - reach), (x + reach, y + reach)];
        if self.dashes.is_some() {
            // As far as a square cap reaches to one side.
            let reach = half + half / 2 + UNIT;
            for (from, to) in segments(&self.path) {
                sink(around(from, reach));
                sink(around(to, reach));
            }
        }
        let solid = Self {
            dashes: None,
            is_joined: self.path.closed,
            ..*self
        };
        solid.pieces(None, &mut |piece| {
            let corners = piece.corners.iter().map(|&(x, y)| (i64::from(x), i64::from(y)));
            let extent = corners.map(|corner| [corner; 2]).reduce(|[first, last], [corner, _]| {
                [
                    (first.0.min(corner.0), first.1.min(corner.1)),
                    (last.0.max(corner.0), last.1.max(corner.1)),
                ]
            });
            let discs = piece.discs.into_iter().flatten();
            extent
                .into_iter()
                .chain(discs.map(|(x, y)| around((x.into(), y.into()), half)))
                .for_each(&mut *sink);
        });
    }

    fn pieces(&self, window: Option<&Window>, sink: &mut Sink<'_>) {
        let mut first: Option<Segment> = None;
        let mut before: Option<Segment> = None;
        let mut place = self.dashes.map_or(0, |dashes| dashes.start);
        let mut segments = segments(&self.path).enumerate().peekable();
        while let Some((number, (from, to))) = segments.next() {
            let mut segment = Segment::new(from, to);
            let comes_in = match &mut before {
                Some(before) => {
                    let comes_in = self.dashes.is_none_or(|dashes| is_inside_dash(&dashes, place));
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
                    place = self.dashed(&mut segment, ends, (dashes, place), window, &mut |piece| {
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
        let is_on = |dashes: DashCycle<'_>| dashes.dashes(dashes.start, (0, 1)).any(is_ahead);
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

    /// The parts of a segment that are on. Returns the place in the cycle behind it.
    fn dashed(
        &self,
        segment: &mut Segment,
        ends: Ends,
        (dashes, place): (&DashCycle<'_>, i64),
        window: Option<&Window>,
        sink: &mut Sink<'_>,
    ) -> i64 {
        let length = distance(segment.from, segment.to);
        let behind = dashes.after(place, length);
        if !is_within(segment.from, segment.to, self.reach(), window) {
            return behind;
        }
        let Some(ruler) = Ruler::along(segment, length) else {
            return behind;
        };
        for (begin, end) in dashes.dashes(place, ruler.visible(self.reach(), window)) {
            let (from, to) = (begin.max(0), end.min(length));
            if from > to {
                continue;
            }
            let ends = Ends {
                // At the first vertex, a dash without length has its caps even where another one runs through.
                begins: (begin > 0 || ends.begins || begin == end) && ruler.reaches(from),
                ends: (end <= length || ends.ends) && ruler.reaches(to),
            };
            if is_ahead((begin, end)) {
                self.part(segment, (ruler.at(from), ruler.at(to)), ends, window, sink);
            }
        }
        behind
    }

    /// The rectangle along a part of a segment, and its caps.
    fn part(
        &self,
        segment: &mut Segment,
        (from, to): (Position, Position),
        ends: Ends,
        window: Option<&Window>,
        sink: &mut Sink<'_>,
    ) {
        if !is_within(from, to, self.reach(), window) {
            return;
        }
        let offsets: Offsets = segment.offsets(self.path.half_width);
        let (right, down) = self.cap.extension(&offsets);
        let moved = |(x, y): Position, (right, down): Position| (x + right, y + down);
        let first = if ends.begins {
            moved(from, (-right, -down))
        } else {
            from
        };
        let last = if ends.ends { moved(to, (right, down)) } else { to };
        let normal = offsets.normal;
        let opposite = (-normal.0, -normal.1);
        let disc = |center: Position, is_there: bool| {
            let is_there = is_there && self.cap == LineCap::Round;
            is_there.then(|| narrow(center))
        };
        sink(Piece {
            corners: &[
                narrow(moved(first, normal)),
                narrow(moved(last, normal)),
                narrow(moved(last, opposite)),
                narrow(moved(first, opposite)),
            ],
            discs: [
                disc(from, ends.begins),
                disc(to, ends.ends && !(ends.begins && from == to)),
            ],
            segment: None,
        });
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
    fn reach(&self) -> i64 {
        2 * self.path.half_width + UNIT
    }
}

/// Which ends of something are ends of the stroke.
#[derive(Copy, Clone)]
struct Ends {
    begins: bool,
    ends: bool,
}

/// Distances along what is left of a segment when it is cut at the limit.
struct Ruler {
    from: Position,
    to: Position,
    /// The distances of both.
    begin: i64,
    end: i64,
}

impl Ruler {
    fn along(segment: &Segment, length: i64) -> Option<Self> {
        let (from, to) = cut(segment.from, segment.to)?;
        let begin = distance(segment.from, from);
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

    /// The position at a distance, to the nearest unit; for what is longer than 2^7 pixels within two.
    fn at(&self, distance: i64) -> Position {
        if distance <= self.begin {
            return self.from;
        }
        if distance >= self.end {
            return self.to;
        }
        // To 31 bits: the products fit.
        let length = self.end - self.begin;
        let shift = 33u32.saturating_sub(length.leading_zeros());
        let (part, whole) = ((distance - self.begin) >> shift, length >> shift);
        let between = |from: i64, to: i64| from + round_divide((to - from) * part, whole);
        (between(self.from.0, self.to.0), between(self.from.1, self.to.1))
    }

    /// Distances between which all lies that comes as near as `reach` to the window, and some more.
    fn visible(&self, reach: i64, window: Option<&Window>) -> Stretch {
        /// Positions in 1/256 pixel and distances in 1/65,536: the products fit.
        const FEWER_BITS: u32 = 8;
        let all = (self.begin, self.end);
        let Some(window) = window else { return all };
        let (width, height) = (self.to.0 - self.from.0, self.to.1 - self.from.1);
        let (from, to, first, end) = if width.abs() > height.abs() {
            (self.from.0, self.to.0, window.left, window.right)
        } else {
            (self.from.1, self.to.1, window.top, window.bottom)
        };
        let extent = (to - from).abs() >> FEWER_BITS;
        // What is shorter than 16 pixels is not worth the divisions.
        if extent < 16 << (FRACTION_BITS - FEWER_BITS) {
            return all;
        }
        let length = (self.end - self.begin) >> FEWER_BITS;
        let at = |coordinate: i64| {
            let part = ((coordinate - from) * (to - from).signum()) >> FEWER_BITS;
            let part = part.clamp(0, extent);
            self.begin + (round_divide(part * length, extent) << FEWER_BITS)
        };
        let near = at(i64::from(first) * UNIT - reach);
        let far = at(i64::from(end) * UNIT + reach);
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
    if shift > 0 {
        (direction.length + (1 << (shift - 1))) >> shift
    } else {
        direction.length << -shift
    }
}

/// Whether a dash has not ended where distances begin. One that ends there, and began before, has.
fn is_ahead((begin, end): Stretch) -> bool {
    begin >= 0 || end > 0
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
