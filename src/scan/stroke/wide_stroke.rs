//! Strokes wider than a pixel, as polygons: a rectangle along each segment and a wedge at the outer side of each corner.
//!
//! Guarantees: the stroke is the union of
//! - for each segment the rectangle of the stroke's width along it, with its corners rounded to 1/65,536 pixel. At the ends
//!   of an open path it is half a pixel longer, so that a line reaches to the outer sides of the pixels of its end points;
//! - for each corner the wedge between the outer corners of both rectangles: up to the tip where their outer sides meet
//!   (miter join), or, where the tip is further away from the corner than twice the width, up to the straight line between
//!   them (bevel join).
//!
//! Segments with an end beyond +-16,384 pixels are first cut there, at 1/65,536 pixel; what lies within +-8,192 pixels
//! differs from the uncut stroke by nothing but that. Widths beyond 4,096 pixels count as 4,096.

use core::num::NonZeroU64;

use crate::{
    geometry::{Bounds, Window, quotient_nearest},
    scan::polygon::{Edge, Part},
};

/// Fractional bits of the corners.
pub const FRACTION_BITS: u32 = 16;
pub(crate) const UNIT: i64 = 1 << FRACTION_BITS;
/// Segments are cut at this distance from the origin, in units.
const LIMIT: i64 = 16_384 * UNIT;
/// The widest stroke, from the middle to a side.
const MAX_HALF_WIDTH: i64 = 2_048 * UNIT;

/// A position in 1/65,536 pixel, as wide as a moved pixel needs.
pub type Position = (i64, i64);

/// A corner of a polygon in 1/65,536 pixel.
pub type Corner = (i32, i32);

/// A path of straight segments.
#[derive(Copy, Clone)]
pub struct Path<'a> {
    /// The vertices of the path by number.
    pub vertex: &'a dyn Fn(usize) -> Position,
    /// How many vertices it has.
    pub count: usize,
    /// Whether it returns to its first vertex.
    pub closed: bool,
    /// The distance from the middle of the stroke to a side, in units.
    pub(crate) half_width: i64,
}

impl core::fmt::Debug for Path<'_> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        formatter
            .debug_struct("Path")
            .field("count", &self.count)
            .field("closed", &self.closed)
            .field("half_width", &self.half_width)
            .finish_non_exhaustive()
    }
}

impl<'a> Path<'a> {
    /// A path with a stroke whose width is given in half pixels.
    pub fn new(vertex: &'a dyn Fn(usize) -> Position, count: usize, closed: bool, width_in_halves: u64) -> Self {
        let width = i64::try_from(width_in_halves).unwrap_or(i64::MAX);
        Self {
            vertex,
            count,
            closed,
            half_width: width.saturating_mul(UNIT / 4).min(MAX_HALF_WIDTH),
        }
    }

    /// Generates the edges of the stroke near the window.
    pub fn edges(&self, window: &Window, sink: &mut dyn FnMut(Edge)) {
        self.polygons(Some(window), &mut |corners| each_side(corners, window, sink));
    }

    /// Generates the convex polygons whose union is the stroke, all with the same sense of rotation; those near the window,
    /// where one is given.
    pub fn polygons(&self, window: Option<&Window>, sink: &mut dyn FnMut(&[Corner])) {
        let mut first: Option<Segment> = None;
        let mut pending: Option<Segment> = None;
        for (_, from, to) in self.segments() {
            let mut segment = Segment::new(from, to);
            match &mut pending {
                Some(before) => {
                    self.join(before, &mut segment, window, sink);
                    before.rectangle_near(self.half_width, false, window, sink);
                }
                None => {
                    segment.begins_path = !self.closed;
                    first = Some(segment);
                }
            }
            pending = Some(segment);
        }
        match (pending, first) {
            (Some(mut last), Some(mut first)) => {
                if self.closed {
                    self.join(&mut last, &mut first, window, sink);
                }
                last.rectangle_near(self.half_width, !self.closed, window, sink);
            }
            _ if self.count > 0 => {
                let mut dot = Segment::dot((self.vertex)(0), self.half_width);
                dot.rectangle_near(self.half_width, true, window, sink);
            }
            _ => {}
        }
    }

    /// The segments that have a length: the number of the vertex at which each begins, and both ends. Of vertices at one position
    /// that follow each other, the last one counts.
    #[inline]
    pub(crate) fn segments(&self) -> impl Iterator<Item = (usize, Position, Position)> + use<'a> {
        let path = *self;
        let first = (path.vertex)(0);
        let mut from = first;
        (1..=path.last_number()).filter_map(move |number| {
            let to = if number == path.count {
                first
            } else {
                (path.vertex)(number)
            };
            let segment = (number - 1, from, to);
            from = to;
            (segment.1 != segment.2).then_some(segment)
        })
    }

    /// The vertices that are so far out that nothing is generated around them.
    pub(crate) fn far_vertices(&self) -> impl Iterator<Item = Position> {
        let vertices = (0..self.count).map(self.vertex);
        vertices.filter(|&position| beyond_limit(position))
    }

    /// A box around all pixels that a stroke which reaches so far from its path may have once it is moved, where it has far vertices:
    /// then a segment to one of them may be missing at its near end as well. It ends behind the pixels of which 16 bits tell that they
    /// are moved.
    pub(crate) fn out_of_reach(&self, reach: i64) -> Bounds {
        let pixel = |units: i64| (units >> FRACTION_BITS).clamp(i16::MIN.into(), i64::from(i16::MAX) - 1);
        let is_far = self.far_vertices().next().is_some();
        let vertices = (0..self.count).filter(|_| is_far).map(self.vertex);
        vertices.fold(Bounds::EMPTY, |bounds, (x, y)| {
            let bounds = bounds.with(pixel(x - reach), pixel(y - reach));
            bounds.with(pixel(x + reach), pixel(y + reach))
        })
    }

    /// How far the stroke may reach from its vertices, in units.
    pub(crate) const fn reach(&self) -> i64 {
        4 * self.half_width + UNIT
    }

    /// The number of the vertex, or the repeated first one, where the last segment ends.
    pub(crate) fn last_number(&self) -> usize {
        if self.closed {
            self.count
        } else {
            self.count.saturating_sub(1)
        }
    }

    /// The wedge at the outer side of the corner between two segments, if that is near the window.
    fn join(
        &self,
        before: &mut Segment,
        after: &mut Segment,
        window: Option<&Window>,
        sink: &mut dyn FnMut(&[Corner]),
    ) {
        let corner = after.from;
        if !is_near(corner, corner, self.half_width, window) || beyond_limit(corner) {
            return;
        }
        let normal_before = before.offsets(self.half_width).normal;
        let normal_after = after.offsets(self.half_width).normal;
        wedge(corner, (normal_before, normal_after), self.half_width, sink);
    }
}

/// Generates the wedge at the outer side of a corner, from the vectors to a side of the segments before and after it.
pub(crate) fn wedge(
    corner: Position,
    (normal_before, normal_after): (Position, Position),
    half_width: i64,
    sink: &mut dyn FnMut(&[Corner]),
) {
    let Some((one, other)) = outer_sides(normal_before, normal_after) else {
        return;
    };
    let at = |offset: Position| narrow((corner.0 + offset.0, corner.1 + offset.1));
    match miter_tip(one, other, half_width) {
        Some(tip) => sink(&[narrow(corner), at(one), at(tip), at(other)]),
        None => sink(&[narrow(corner), at(one), at(other)]),
    }
}

/// The vectors from a corner to the outer corners of both rectangles there, in the sense of rotation of the rectangles;
/// `None` where the path goes straight on, or straight back.
pub(crate) fn outer_sides(normal_before: Position, normal_after: Position) -> Option<(Position, Position)> {
    // The outer side is the one that the path turns away from.
    match cross(normal_before, normal_after) {
        0 => None,
        turn if turn > 0 => Some((negated(normal_after), negated(normal_before))),
        _ => Some((normal_before, normal_after)),
    }
}

/// Where the outer sides meet, seen from the corner; `None` where that is further away than four half widths, or too near
/// to make a difference.
pub(crate) fn miter_tip(one: Position, other: Position, half_width: i64) -> Option<Position> {
    let square = half_width * half_width;
    let product = one.0 * other.0 + one.1 * other.1;
    // (1 + cos) / 2 >= 1/16: the tip is at most four half widths away.
    let denominator = square + product;
    if denominator < square / 8 {
        return None;
    }
    // Squares are below 2^54: with 30 bits left the rounding stays below a unit.
    let shift = 34u32.saturating_sub(square.leading_zeros());
    let square = square >> shift;
    // Not negative. 0 only where half the width is below 3/65,536 pixel: then any tip is a unit or two away.
    let denominator = NonZeroU64::new((denominator >> shift) as u64).unwrap_or(NonZeroU64::MIN);
    let scale = |sum: i64| quotient_nearest(sum * square, denominator);
    let tip = (scale(one.0 + other.0), scale(one.1 + other.1));
    is_between(tip, one, other).then_some(tip)
}

/// Whether a tip lies between the sides that it joins: rounding must not turn the wedge over.
pub(crate) fn is_between(tip: Position, one: Position, other: Position) -> bool {
    cross(one, tip) < 0 && cross(tip, other) < 0
}

/// Generates the edges of a polygon that cross a row of the window.
pub(crate) fn each_side(corners: &[Corner], window: &Window, sink: &mut dyn FnMut(Edge)) {
    let mut from = match corners.last() {
        Some(&last) => last,
        None => return,
    };
    for &to in corners {
        // Before the divisions of an edge.
        let rows = (from.1.min(to.1) >> FRACTION_BITS, from.1.max(to.1) >> FRACTION_BITS);
        if rows.0 < window.bottom && rows.1 >= window.top {
            if let Some(edge) = Edge::from_units(from, to, FRACTION_BITS, Part::Stroke) {
                sink(edge);
            }
        }
        from = to;
    }
}

#[derive(Copy, Clone)]
pub(crate) struct Segment {
    pub(crate) from: Position,
    pub(crate) to: Position,
    pub(crate) begins_path: bool,
    pub(crate) offsets: Option<Offsets>,
}

/// Vectors across and along a segment. They take a square root, so they are computed only for segments near the window.
#[derive(Copy, Clone)]
pub(crate) struct Offsets {
    /// The vector from the middle of the stroke to a side.
    pub(crate) normal: Position,
    /// Half a pixel along the segment.
    pub(crate) half_pixel: Position,
}

impl Segment {
    pub(crate) fn new(from: Position, to: Position) -> Self {
        Self {
            from,
            to,
            begins_path: false,
            offsets: None,
        }
    }

    /// The direction of a segment that is longer than 0.
    pub(crate) fn direction(&self) -> Direction {
        Direction::of((self.to.0 - self.from.0, self.to.1 - self.from.1))
    }

    pub(crate) fn offsets(&mut self, half_width: i64) -> Offsets {
        let (from, to) = (self.from, self.to);
        *self
            .offsets
            .get_or_insert_with(|| Offsets::along((to.0 - from.0, to.1 - from.1), half_width))
    }

    /// A segment of no length as a dot, as high as the stroke is wide.
    pub(crate) fn dot(at: Position, half_width: i64) -> Self {
        Self {
            from: at,
            to: at,
            begins_path: true,
            offsets: Some(Offsets {
                normal: (0, half_width),
                half_pixel: (UNIT / 2, 0),
            }),
        }
    }

    /// The rectangle along the segment, if that is near the window.
    fn rectangle_near(
        &mut self,
        half_width: i64,
        ends_path: bool,
        window: Option<&Window>,
        sink: &mut dyn FnMut(&[Corner]),
    ) {
        if is_near(self.from, self.to, half_width, window) {
            self.rectangle(half_width, ends_path, sink);
        }
    }

    /// Generates the rectangle along the segment.
    // Not inlined: 1,400 bytes of flash less in programs with paths (opt-level 3, thumbv7m).
    #[inline(never)]
    pub(crate) fn rectangle(&mut self, half_width: i64, ends_path: bool, sink: &mut dyn FnMut(&[Corner])) {
        let Some((mut from, mut to)) = cut(self.from, self.to) else {
            return;
        };
        let Offsets { normal, half_pixel } = self.offsets(half_width);
        if self.begins_path && from == self.from {
            from = (from.0 - half_pixel.0, from.1 - half_pixel.1);
        }
        if ends_path && to == self.to {
            to = (to.0 + half_pixel.0, to.1 + half_pixel.1);
        }
        sink(&[
            narrow((from.0 + normal.0, from.1 + normal.1)),
            narrow((to.0 + normal.0, to.1 + normal.1)),
            narrow((to.0 - normal.0, to.1 - normal.1)),
            narrow((from.0 - normal.0, from.1 - normal.1)),
        ]);
    }
}

impl Offsets {
    /// The offsets of a segment along a vector that is not zero.
    fn along(vector: Position, half_width: i64) -> Self {
        let direction = Direction::of(vector);
        Self {
            normal: direction.normal(half_width),
            half_pixel: (
                direction.of_length(direction.x, UNIT / 2),
                direction.of_length(direction.y, UNIT / 2),
            ),
        }
    }
}

/// A vector to 30 bits, so that squares fit: exact unless it is longer than 2^14 pixels.
#[derive(Copy, Clone)]
pub(crate) struct Direction {
    pub(crate) x: i64,
    pub(crate) y: i64,
    /// The length of the vector (x, y), rounded down: below 2^31.
    pub(crate) length: NonZeroU64,
    /// How many bits the components were shifted up from those of the vector; negative where they were shifted down.
    pub(crate) scale: i32,
}

impl Direction {
    /// The direction of a vector that is not zero.
    pub(crate) fn of(vector: Position) -> Self {
        let longest = vector.0.unsigned_abs() | vector.1.unsigned_abs();
        let spare = longest.leading_zeros();
        let scaled = |component: i64| {
            let size = component.unsigned_abs();
            let size = if spare < 34 {
                size >> 34u32.saturating_sub(spare)
            } else {
                size << spare.saturating_sub(34).min(63)
            } as i64;
            if component < 0 { -size } else { size }
        };
        let (x, y) = (scaled(vector.0), scaled(vector.1));
        let length = NonZeroU64::new((x * x + y * y) as u64).map_or(NonZeroU64::MIN, NonZeroU64::isqrt);
        Self {
            x,
            y,
            length,
            scale: spare as i32 - 34,
        }
    }

    /// The vector across it with a length.
    pub(crate) fn normal(&self, length: i64) -> Position {
        (self.of_length(-self.y, length), self.of_length(self.x, length))
    }

    /// A component where the vector has another length.
    fn of_length(&self, component: i64, length: i64) -> i64 {
        quotient_nearest(component * length, self.length)
    }
}

pub(crate) fn cross(one: Position, other: Position) -> i64 {
    one.0 * other.1 - one.1 * other.0
}

pub(crate) fn negated(position: Position) -> Position {
    (-position.0, -position.1)
}

/// Converts a position to 32 bits: it is within the limit and the stroke's reach of it, so it fits.
pub(crate) fn narrow(position: Position) -> Corner {
    (position.0 as i32, position.1 as i32)
}

pub(crate) fn beyond_limit(position: Position) -> bool {
    position.0.abs() > LIMIT || position.1.abs() > LIMIT
}

/// Whether what is stroked between two positions can reach the window.
fn is_near(from: Position, to: Position, half_width: i64, window: Option<&Window>) -> bool {
    is_within(from, to, 4 * half_width + UNIT, window)
}

/// Whether something between two positions comes as near as `reach` to the window.
pub(crate) fn is_within(from: Position, to: Position, reach: i64, window: Option<&Window>) -> bool {
    let Some(window) = window else { return true };
    let meets = |a: i64, b: i64, first: i32, end: i32| {
        a.max(b) + reach >= i64::from(first) * UNIT && a.min(b) - reach <= i64::from(end) * UNIT
    };
    meets(from.0, to.0, window.left, window.right) && meets(from.1, to.1, window.top, window.bottom)
}

/// The part of a segment within the limit, each cut end within a unit of the exact one, the same in both directions.
///
/// Midpoint subdivision (Sproull and Sutherland 1968) with 12 bits more than a unit has, so that rounding does not add up.
pub(crate) fn cut(from: Position, to: Position) -> Option<(Position, Position)> {
    if !beyond_limit(from) && !beyond_limit(to) {
        return Some((from, to));
    }
    if to < from {
        return cut(to, from).map(|(to, from)| (from, to));
    }
    const MORE_BITS: u32 = 12;
    let finer = |position: Position| (position.0 << MORE_BITS, position.1 << MORE_BITS);
    let rounded = |position: Position| {
        let round = |component: i64| (component + (1 << (MORE_BITS - 1))) >> MORE_BITS;
        (round(position.0), round(position.1))
    };
    let limit = LIMIT << MORE_BITS;
    let sides: [fn(Position) -> i64; 4] = [
        |position| position.0,
        |position| -position.0,
        |position| position.1,
        |position| -position.1,
    ];
    let (mut from, mut to) = (finer(from), finer(to));
    for side in sides {
        match (side(from) > limit, side(to) > limit) {
            (true, true) => return None,
            (true, false) => from = boundary(from, to, side, limit),
            (false, true) => to = boundary(to, from, side, limit),
            (false, false) => {}
        }
    }
    Some((rounded(from), rounded(to)))
}

/// The last position on the path from `inside` to `outside` that is not beyond a limit.
fn boundary(outside: Position, inside: Position, side: fn(Position) -> i64, limit: i64) -> Position {
    let (mut outside, mut inside) = (outside, inside);
    loop {
        let middle = ((outside.0 + inside.0) >> 1, (outside.1 + inside.1) >> 1);
        if middle == inside || middle == outside {
            return inside;
        }
        if side(middle) > limit {
            outside = middle;
        } else {
            inside = middle;
        }
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Path<'_> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "Path of {} vertices", self.count);
    }
}
