//! Strokes with caps, joins and dashes, as polygons and discs.
//!
//! Guarantees: the stroke is the union of
//! - for each segment, or each part of it that a dash covers, the rectangle of the stroke's width along it, with its corners
//!   rounded to 1/65,536 pixel. Dashes of a segment whose caps reach further than the pattern is long are one where these
//!   close the gap between them ([`DashPattern`] says which);
//! - for each corner that the stroke runs through, what the join adds at the outer side: the wedge up to the tip or up to
//!   the straight line between the outer corners, or the disc about the corner;
//! - for each end, of the path or of a dash, what the cap adds. Where a closed path is on before and after its first vertex,
//!   that is a corner and not an end.
//!
//! Discs are exact: a pixel belongs when the square of its distance to the centre is below that of half the width in
//! 1/65,536 pixel, and on a tie by the top-left rule. What is drawn of a dash does not depend on the window.
//!
//! With the default cap and join and without dashes it is the stroke of [`wide_stroke`](crate::scan::stroke::wide_stroke),
//! pixel by pixel; far segments, widths and their limits as there. Dashes are counted from the beginning of the path, seen
//! or not; how exactly, [`dash_pattern`](crate::scan::stroke::dash_pattern) says.
//!
//! Cost: dashes out of sight cost nothing. A segment with more than 32 of them near the window, or more than 4 that may
//! overlap, hands over none of them one by one: they are spans of a row, at most one for each pixel that the segment's
//! stroke has there without the gaps ([`dense_dashes`](crate::scan::stroke::dense_dashes)).

use crate::{
    geometry::{Bounds, Window},
    scan::{
        polygon::banded_polygon::EdgeSource,
        stroke::{
            DiscSide, LineCap, LineJoin,
            dash_pattern::{DISTANCE_BITS, DashCycle, DashPattern},
            dense_dashes::DenseDashes,
            grouped_primitives::EdgedPrimitive,
            pen::Pen,
            segment_dashes::{Ruler, SegmentDashes, StrokeEnds, distance},
            stroke_edge::StrokeEdge,
            wide_stroke::{
                Corner, FRACTION_BITS, Path, Position, Segment, UNIT, beyond_limit, cut, is_within, narrow, outer_sides,
            },
        },
    },
};

/// Most dashes of a segment near the window that are handed over one by one, if no two of them share a pixel.
const MOST_DISJOINT: usize = 32;
/// Most dashes of a segment near the window that are handed over one by one where they may overlap: all of these are drawn
/// together, and each makes the others' rows dearer.
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

/// A segment of a stroke, and what the stroke is like along it.
pub(super) struct StrokeSegment {
    /// The number of the vertex at which it begins.
    pub(super) number: usize,
    from: Position,
    to: Position,
    /// Its length along the path and where in the pattern of dashes it begins; both are 0 in a solid stroke.
    pub(super) length: i64,
    pub(super) position: i64,
    /// Whether the stroke runs into it from the segment before it.
    pub(super) comes_in: bool,
    pub(super) ends: StrokeEnds,
}

/// One of the shapes whose union is a stroke.
pub(super) struct Primitive<'a> {
    /// The corners of a convex polygon; all polygons have one sense of rotation. No corners where there are discs only.
    pub(super) corners: &'a [Corner],
    /// The centres of discs as wide as the stroke, for round caps and joins.
    pub(super) discs: [Option<Corner>; 2],
    /// The number of the segment whose dash the primitive is; `None` for any other primitive.
    segment: Option<usize>,
    /// All dashes of a segment, to be drawn row by row: then there are no corners and discs.
    dashes: Option<&'a DenseDashes<'a>>,
    /// Whether the polygon is what a join adds at a corner, which is the first of its corners.
    is_join: bool,
}

impl<'a> Primitive<'a> {
    const fn polygon(corners: &'a [Corner]) -> Self {
        Self {
            corners,
            discs: [None; 2],
            segment: None,
            dashes: None,
            is_join: false,
        }
    }

    const fn join(corners: &'a [Corner]) -> Self {
        Self {
            is_join: true,
            ..Self::polygon(corners)
        }
    }

    const fn disc(center: Corner) -> Self {
        Self {
            corners: &[],
            discs: [Some(center), None],
            segment: None,
            dashes: None,
            is_join: false,
        }
    }

    /// A window around the primitive's pixels; its discs have the radius `half_width`, in 1/65,536 pixel.
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

pub(super) type Sink<'s> = dyn FnMut(Primitive<'_>) + 's;

/// Shapes whose union is a stroke.
pub(crate) enum StrokeShape<'a> {
    /// A convex polygon, and the centres of discs that are as wide as the stroke: the rectangle along a part of a
    /// segment with its round caps, or no corners and the disc of a round join.
    Polygon(&'a [Corner], [Option<Corner>; 2]),
    /// The convex polygon that a join adds, of which the first corner is that of the path.
    Join(&'a [Corner]),
    /// The dashes of a segment with very many of them.
    Dashes(&'a DenseDashes<'a>),
}

/// A path with everything that shapes its stroke.
#[derive(Copy, Clone)]
pub struct StyledStroke<'a> {
    pub(super) path: Path<'a>,
    cap: LineCap,
    join: LineJoin,
    pub(super) dashes: Option<DashCycle<'a>>,
    /// Whether the first vertex is a corner.
    is_joined: bool,
}

impl<'a> StyledStroke<'a> {
    /// The stroke of a path. Cost: a square root a segment where a closed path is dashed.
    pub fn new(path: &Path<'a>, cap: LineCap, join: LineJoin, dashes: Option<DashPattern<'a>>) -> Self {
        let mut stroke = Self::without_first_corner(path, cap, join, dashes);
        stroke.is_joined = path.closed
            && stroke.dashes.is_none_or(|dashes| {
                let end = path.segments().fold(dashes.start, |along, (_, from, to)| {
                    dashes.after(along, distance(from, to))
                });
                dashes.dash_before(dashes.start).is_some() && is_inside_dash(&dashes, end)
            });
        stroke
    }

    /// The stroke of a path whose first vertex is no corner, even where the path is closed: for segments and corners one by one.
    pub(crate) fn without_first_corner(
        path: &Path<'a>,
        cap: LineCap,
        join: LineJoin,
        dashes: Option<DashPattern<'a>>,
    ) -> Self {
        Self {
            path: *path,
            cap,
            join,
            dashes: dashes.and_then(|dashes| dashes.cycle(cap, path.half_width)),
            is_joined: false,
        }
    }

    /// Generates the edges of the stroke near the window: of each dash, however many there are.
    ///
    /// Cost: a square root for each segment near the window, and for each segment at all where there are dashes.
    pub fn edges(&self, window: &Window, sink: &mut dyn FnMut(StrokeEdge)) {
        self.primitives(Some(window), MostDashes::ALL, &mut |primitive| {
            self.primitive_edges(&primitive, window, sink)
        });
    }

    fn primitive_edges(&self, primitive: &Primitive<'_>, window: &Window, sink: &mut dyn FnMut(StrokeEdge)) {
        match primitive.dashes {
            Some(dashes) => dashes.edges(window, sink),
            None => self.pen().shape_edges(primitive.corners, primitive.discs, window, sink),
        }
    }

    /// Calls `call` with each primitive near the window. The dashes of one segment are a row, if there are gaps between
    /// their caps; `path` is the number of the path.
    ///
    /// Cost: a square root for each segment near the window, and for each segment at all where there are dashes; at most
    /// [`MOST_DISJOINT`] primitives a segment, and one a corner.
    pub(crate) fn each_primitive(&self, path: usize, window: &Window, call: &mut dyn FnMut(&EdgedPrimitive<'_>)) {
        let are_disjoint = self.dashes_are_disjoint();
        let most = self.most_dashes(if are_disjoint { MOST_DISJOINT } else { MOST_OVERLAPPING });
        self.primitives(Some(window), most, &mut |primitive| {
            call(&EdgedPrimitive {
                around: primitive.pixels(self.path.half_width),
                row: primitive
                    .segment
                    .filter(|_| are_disjoint)
                    .map(|segment| (path, segment)),
                is_row_by_row: primitive.dashes.is_some(),
                edges: &|window: &Window, sink: &mut dyn FnMut(StrokeEdge)| {
                    self.primitive_edges(&primitive, window, sink)
                },
            });
        });
    }

    /// Calls `call` with the edges of each dash near the window, of a stroke whose [primitives are disjoint](Self::is_disjoint).
    pub fn each_dash(&self, window: &Window, call: &mut dyn FnMut(&EdgeSource<'_, StrokeEdge>)) {
        self.primitives(Some(window), MostDashes::ALL, &mut |primitive| {
            call(&|window, sink| self.primitive_edges(&primitive, window, sink));
        });
    }

    /// Generates the edges of all dashes near a window of one row as spans, and those of the corners.
    #[cfg(test)]
    pub(crate) fn dense_edges(&self, window: &Window, sink: &mut dyn FnMut(StrokeEdge)) {
        self.primitives(Some(window), self.most_dashes(0), &mut |primitive| {
            self.primitive_edges(&primitive, window, sink)
        });
    }

    /// Whether no two primitives share a pixel, and there are at most four to a pixel of the path's length: one segment,
    /// with dashes that are disjoint.
    pub fn is_disjoint(&self) -> bool {
        self.path.count == 2 && !self.path.closed && self.dashes_are_disjoint()
    }

    /// Whether no two dashes of a segment share a pixel; gaps below a quarter of a pixel count as shared.
    fn dashes_are_disjoint(&self) -> bool {
        /// The least gap between two dashes that count as disjoint, in 1/65,536 pixel: more than rounding moves them, and
        /// enough to bound their number.
        const MARGIN: i64 = UNIT / 4;
        let reach = self.cap.reach(self.path.half_width);
        let least = (2 * reach + MARGIN) << (DISTANCE_BITS - FRACTION_BITS);
        self.dashes.is_some_and(|dashes| dashes.shortest_gap >= least)
    }

    /// Hands over the convex polygons and the discs whose union is the stroke: the corners of one, and the centres of up to
    /// two others, which are as wide as the stroke. More than [`MOST_MEASURED`] dashes of a segment come together. Cost: a
    /// square root a segment.
    pub fn shapes(&self, sink: &mut dyn FnMut(StrokeShape<'_>)) {
        self.shapes_within(self.most_dashes(MOST_MEASURED), sink);
    }

    /// Hands over the convex polygons and the discs as [`shapes`](Self::shapes) does, each dash by itself, however many
    /// there are.
    pub fn all_shapes(&self, sink: &mut dyn FnMut(StrokeShape<'_>)) {
        self.shapes_within(MostDashes::ALL, sink);
    }

    fn shapes_within(&self, most: MostDashes, sink: &mut dyn FnMut(StrokeShape<'_>)) {
        self.primitives(None, most, &mut |primitive| {
            sink(match primitive.dashes {
                Some(dashes) => StrokeShape::Dashes(dashes),
                None if primitive.is_join => StrokeShape::Join(primitive.corners),
                None => StrokeShape::Polygon(primitive.corners, primitive.discs),
            });
        });
    }

    /// An upper bound for the number of dashes along the path, however short the lengths of the pattern are; 0 for a
    /// solid stroke. Cost: a square root and a division a segment.
    pub fn most_dashes_along(&self) -> u64 {
        let Some(dashes) = self.dashes else { return 0 };
        self.path.segments().fold(0u64, |sum, (_, from, to)| {
            sum.saturating_add(dashes.most_within(distance(from, to)))
        })
    }

    /// Whether no vertex is so far out that nothing is generated around it.
    pub fn is_near(&self) -> bool {
        self.path.far_vertices().next().is_none()
    }

    /// Whether the stroke is one rectangle with its caps.
    pub fn is_one_rectangle(&self) -> bool {
        self.dashes.is_none() && self.path.count == 2 && !self.path.closed
    }

    /// Whether all vertices are the centres of pixels, and all segments run along rows and columns.
    pub fn is_along_pixels(&self) -> bool {
        self.path.segments().all(|(_, from, to)| {
            let is_whole = |(x, y): Position| (x | y) & (UNIT - 1) == 0;
            (from.0 == to.0 || from.1 == to.1) && is_whole(from) && is_whole(to)
        })
    }

    /// Whether a stroke [along pixels](Self::is_along_pixels) may have a corner that is bevelled.
    pub fn bevels_along_pixels(&self) -> bool {
        self.join.bevels_right_angles(self.path.half_width) && self.axes_along_pixels() == [true; 2]
    }

    /// Whether a stroke [along pixels](Self::is_along_pixels) has sides along columns, and whether along rows. Without a
    /// segment it is level.
    pub fn axes_along_pixels(&self) -> [bool; 2] {
        let (mut is_upright, mut is_level) = (false, false);
        for (_, from, to) in self.path.segments() {
            is_upright |= from.0 == to.0;
            is_level |= from.1 == to.1;
        }
        [is_upright, is_level || !is_upright]
    }

    /// Whether there are no dashes, or only lengths of dashes, and an offset, that are multiples of half a pixel.
    pub fn has_dashes_in_halves(&self) -> bool {
        self.dashes.is_none_or(|dashes| dashes.is_in_halves())
    }

    /// The distance from the middle of the stroke to a side, in 1/65,536 pixel.
    pub fn half_width(&self) -> i64 {
        self.path.half_width
    }

    /// These bounds, enlarged so that the pixels of a disc about `center` lie in them; the disc is as wide as the stroke.
    pub fn with_disc(&self, bounds: Bounds, center: Corner) -> Bounds {
        let around = Primitive::disc(center).pixels(self.path.half_width);
        if bounds.contains(&around.into()) {
            return bounds;
        }
        bounds.around(&DiscSide::bounds(center, self.path.half_width as i32))
    }

    const fn pen(&self) -> Pen {
        Pen {
            cap: self.cap,
            half_width: self.path.half_width,
        }
    }

    fn most_dashes(&self, number: usize) -> MostDashes {
        let stretch = self.dashes.map_or(0, |dashes| dashes.stretch_of(number));
        MostDashes { number, stretch }
    }

    /// Calls with each segment that has a length, from the first one on. Cost: a square root a segment where there are dashes.
    pub(super) fn each_segment(&self, call: &mut dyn FnMut(StrokeSegment)) {
        self.walk(call);
    }

    /// What [`each_segment`](Self::each_segment) does, for what is called in each part of a window.
    // Always: without, a dashed polyline that is drawn anew in each row takes 5 % more cycles (Cortex-M4).
    #[inline(always)]
    fn walk(&self, mut call: impl FnMut(StrokeSegment)) {
        let mut position = self.dashes.map_or(0, |dashes| dashes.start);
        let mut is_first = true;
        let mut segments = self.path.segments().peekable();
        while let Some((number, from, to)) = segments.next() {
            let comes_in = if is_first {
                self.is_joined
            } else {
                self.dashes.is_none_or(|dashes| is_inside_dash(&dashes, position))
            };
            is_first = false;
            let length = self.dashes.map_or(0, |_| distance(from, to));
            call(StrokeSegment {
                number,
                from,
                to,
                length,
                position,
                comes_in,
                ends: StrokeEnds {
                    begins: !comes_in,
                    ends: segments.peek().is_none() && !self.is_joined,
                },
            });
            position = self.dashes.map_or(0, |dashes| dashes.after(position, length));
        }
    }

    /// Generates the primitives near a window, or all; at most so many dashes of a segment one by one.
    fn primitives(&self, window: Option<&Window>, most: MostDashes, sink: &mut Sink<'_>) {
        let mut first: Option<Segment> = None;
        let mut before: Option<Segment> = None;
        self.walk(|at| {
            let mut segment = Segment::new(at.from, at.to);
            if let (Some(before), true) = (&mut before, at.comes_in) {
                self.corner(before, &mut segment, window, sink);
            }
            match &self.dashes {
                None => self.solid(&mut segment, at.ends, window, sink),
                Some(dashes) => {
                    let dashes = SegmentDashes {
                        cycle: dashes,
                        position: at.position,
                        length: at.length,
                        ends: at.ends,
                    };
                    self.dashed(&mut segment, &dashes, (window, most), &mut |primitive| {
                        sink(Primitive {
                            segment: Some(at.number),
                            ..primitive
                        });
                    });
                }
            }
            first.get_or_insert(segment);
            before = Some(segment);
        });
        match (&mut before, &mut first) {
            (Some(last), Some(first)) if self.is_joined => self.corner(last, first, window, sink),
            (None, _) => self.dot(window, sink),
            _ => {}
        }
    }

    /// Hands over the stroke of a path whose vertices are all one: the caps of a level stroke.
    pub(super) fn dot(&self, window: Option<&Window>, sink: &mut Sink<'_>) {
        let is_on = |dashes: DashCycle<'_>| dashes.dashes(dashes.start, 1, (0, 1)).next().is_some();
        if self.path.count == 0 || !self.dashes.is_none_or(is_on) {
            return;
        }
        let center = (self.path.vertex)(0);
        let mut dot = Segment::new(center, (center.0 + UNIT, center.1));
        let ends = StrokeEnds {
            begins: true,
            ends: true,
        };
        if !beyond_limit(center) {
            self.part(&mut dot, (center, center), ends, window, sink);
        }
    }

    pub(super) fn solid(&self, segment: &mut Segment, ends: StrokeEnds, window: Option<&Window>, sink: &mut Sink<'_>) {
        if !is_within(segment.from, segment.to, self.pen().reach(), window) {
            return;
        }
        if let Some((from, to)) = cut(segment.from, segment.to) {
            let ends = StrokeEnds {
                begins: ends.begins && from == segment.from,
                ends: ends.ends && to == segment.to,
            };
            self.part(segment, (from, to), ends, window, sink);
        }
    }

    /// Hands over the parts of a segment that dashes cover.
    fn dashed(
        &self,
        segment: &mut Segment,
        dashes: &SegmentDashes<'_>,
        (window, most): (Option<&Window>, MostDashes),
        sink: &mut Sink<'_>,
    ) {
        if !is_within(segment.from, segment.to, self.pen().reach(), window) {
            return;
        }
        let Some(ruler) = Ruler::along(segment, dashes.length) else {
            return;
        };
        let (from, to) = ruler.visible(self.pen().reach(), window);
        let visible = dashes.between(from, to);
        if to - from > most.stretch && visible.clone().nth(most.number).is_some() {
            return self.dense(segment, dashes, ruler, sink);
        }
        for dash in visible {
            let ends = dashes.ends_of(&dash, &ruler);
            self.part(segment, (ruler.at(dash.from), ruler.at(dash.to)), ends, window, sink);
        }
    }

    /// Hands over all dashes of a segment as one primitive.
    #[inline(never)]
    fn dense(&self, segment: &mut Segment, dashes: &SegmentDashes<'_>, ruler: Ruler, sink: &mut Sink<'_>) {
        let dense = DenseDashes::new(self.pen(), dashes, ruler, segment.offsets(self.path.half_width));
        sink(Primitive {
            dashes: Some(&dense),
            ..Primitive::polygon(&[])
        });
    }

    /// Hands over the rectangle along a part of a segment, and its caps.
    pub(super) fn part(
        &self,
        segment: &mut Segment,
        part: (Position, Position),
        ends: StrokeEnds,
        window: Option<&Window>,
        sink: &mut Sink<'_>,
    ) {
        if !is_within(part.0, part.1, self.pen().reach(), window) {
            return;
        }
        let (corners, discs) = self
            .pen()
            .shape_of_part(&segment.offsets(self.path.half_width), part, ends);
        sink(Primitive {
            discs,
            ..Primitive::polygon(&corners)
        });
    }

    /// Hands over what the join adds at the outer side of the corner between two segments.
    pub(super) fn corner(
        &self,
        before: &mut Segment,
        after: &mut Segment,
        window: Option<&Window>,
        sink: &mut Sink<'_>,
    ) {
        let half_width = self.path.half_width;
        let corner = after.from;
        if beyond_limit(corner) || !is_within(corner, corner, self.join.reach(half_width) + UNIT, window) {
            return;
        }
        let normal_before = before.offsets(half_width).normal;
        let normal_after = after.offsets(half_width).normal;
        if self.join == LineJoin::Round {
            if normal_before != normal_after {
                sink(Primitive::disc(narrow(corner)));
            }
            return;
        }
        let Some((one, other)) = outer_sides(normal_before, normal_after) else {
            return;
        };
        let at = |offset: Position| narrow((corner.0 + offset.0, corner.1 + offset.1));
        match self.join.tip((before, after), (one, other), half_width) {
            Some(tip) => sink(Primitive::join(&[narrow(corner), at(one), at(tip), at(other)])),
            None => sink(Primitive::join(&[narrow(corner), at(one), at(other)])),
        }
    }
}

/// Whether a dash goes on through a distance along the path: it neither begins nor ends there.
fn is_inside_dash(dashes: &DashCycle<'_>, along: i64) -> bool {
    dashes.dash_before(along).is_some_and(|before| before > 0)
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
