//! A box around what half planes leave of a ring, from its corners and the outermost points of its circles.
//!
//! A part of a ring between straight lines reaches furthest to a side either at the outermost point of the outer circle,
//! where the half planes leave that, or at a corner: where a line meets a circle, or another line. Of the inner circle no
//! point but a corner is the furthest one, since the ring goes on beyond it.
//!
//! ```text
//!          . o o .        o  outermost points of the outer circle
//!       o           x
//!     .     . . . x       x  corners: lines with the outer and the inner circle
//!    o    .
//!     .    . . . x
//!       .          x
//!          . . o
//! ```
//!
//! The ring is scaled until its radius has 14 bits, so that all numbers fit 32 bits, and every half plane and circle is
//! moved outwards by more than what that rounds.
//!
//! Guarantees: all points are in the box. Up to a radius of 500 pixels, a side is at most a pixel further out than the part
//! of the ring reaches, more only where a line grazes a circle. A pixel need not be there. Cost: an integer square root for
//! each half plane and one for each line and circle, all of 32 bits, three divisions for each half plane, and two of 64
//! bits for each pair of lines.

use core::num::NonZeroU32;

use crate::{
    geometry::Bounds,
    scan::round::half_plane::{Center, HalfPlane},
};

/// Bits of the scaled radius.
const RADIUS_BITS: u32 = 14;
/// Fractional bits of unit vectors.
const UNIT_BITS: u32 = 15;
/// How far half planes and circles are moved outwards, in scaled units: more than scaling and unit vectors round.
const MARGIN: i32 = 4;
/// How far the bounds are moved outwards from a corner, in scaled units: more than what computing a corner rounds.
const CORNER_MARGIN: i32 = 4;
/// A bound on the length of the normal vectors of half planes.
const LONGEST_NORMAL: i64 = 1449;
/// A distance that is larger than any circle's radius, in scaled units.
const FARTHEST: i32 = 1 << UNIT_BITS;

/// A position in scaled units, from the centre.
type Position = (i32, i32);

/// A half plane in scaled units: the points that are at least as far in the direction of a unit vector as a distance.
#[derive(Copy, Clone)]
struct ScaledHalfPlane {
    /// Unit vector with [`UNIT_BITS`]. Zero where the line has no direction: then all points are in the half plane or
    /// none.
    unit: Position,
    distance: i32,
}

impl ScaledHalfPlane {
    /// Scales a half plane and moves it outwards. Its limit is at most [`LONGEST_NORMAL`] times the radius.
    fn new(half_plane: &HalfPlane, scale: Scale) -> Self {
        const MORE_BITS: u32 = 5;
        let (x, y) = half_plane.normal;
        let square = (x * x + y * y).unsigned_abs();
        let length = (square << (2 * MORE_BITS)).isqrt();
        let Some(length) = NonZeroU32::new(length) else {
            let distance = if half_plane.least > 0 { FARTHEST } else { -FARTHEST };
            return Self { unit: (0, 0), distance };
        };
        let divided = |dividend: i32| {
            let quotient = (dividend.unsigned_abs() / length) as i32;
            if dividend < 0 { -quotient } else { quotient }
        };
        let limit = scale.scaled(half_plane.least) as i32;
        let unit = |normal: i32| divided(normal << (UNIT_BITS + MORE_BITS));
        Self {
            unit: (unit(x), unit(y)),
            distance: divided(limit << MORE_BITS) - MARGIN,
        }
    }

    fn contains(&self, (x, y): Position) -> bool {
        self.unit.0 * x + self.unit.1 * y >= (self.distance - CORNER_MARGIN) << UNIT_BITS
    }

    /// Where the half plane's line meets a circle about the centre; each coordinate is less than [`CORNER_MARGIN`] off.
    fn crossings(&self, radius: i32) -> Option<[Position; 2]> {
        if self.unit == (0, 0) || self.distance.abs() > radius {
            return None;
        }
        let half_chord = (radius * radius - self.distance * self.distance).unsigned_abs().isqrt() as i32;
        let (right, down) = self.unit;
        let position = |along: i32| {
            (
                (right * self.distance - down * along) >> UNIT_BITS,
                (down * self.distance + right * along) >> UNIT_BITS,
            )
        };
        Some([position(half_chord), position(-half_chord)])
    }

    /// Where the lines of two half planes meet, if that is not further away than any circle.
    fn meets(&self, other: &Self) -> Option<Position> {
        let product = |one: i32, other: i32| i64::from(one) * i64::from(other);
        let determinant = product(self.unit.0, other.unit.1) - product(self.unit.1, other.unit.0);
        let x = product(self.distance, other.unit.1) - product(other.distance, self.unit.1);
        let y = product(other.distance, self.unit.0) - product(self.distance, other.unit.0);
        let coordinate = |dividend: i64| {
            let quotient = (dividend << UNIT_BITS).checked_div(determinant)?;
            i32::try_from(quotient).ok().filter(|near| near.abs() < FARTHEST)
        };
        Some((coordinate(x)?, coordinate(y)?))
    }
}

/// The scale between half pixels and scaled units, a power of two.
#[derive(Copy, Clone)]
struct Scale {
    /// The left shift from half pixels to scaled units; a right shift where it is negative.
    shift: i32,
}

impl Scale {
    const fn of(radius: u32) -> Self {
        Self {
            shift: RADIUS_BITS as i32 - (u32::BITS - radius.leading_zeros()) as i32,
        }
    }

    /// Converts a length to scaled units, rounded down.
    const fn scaled(self, value: i64) -> i64 {
        if self.shift >= 0 {
            value << self.shift
        } else {
            value >> -self.shift
        }
    }

    /// Converts a scaled length to half pixels, rounded down.
    const fn half_pixels(self, scaled: i64) -> i64 {
        if self.shift >= 0 {
            scaled >> self.shift
        } else {
            scaled << -self.shift
        }
    }
}

/// What the half planes leave of a ring, moved outwards.
struct RingSector {
    scale: Scale,
    outer: i32,
    inner: i32,
    /// A position belongs to the part if all of these half planes contain it.
    half_planes: [Option<ScaledHalfPlane>; 3],
}

impl RingSector {
    fn new([outer, inner]: [u32; 2], half_planes: [Option<HalfPlane>; 3]) -> Self {
        let scale = Scale::of(outer);
        // Further away than the circle, a line has all of it on one side.
        let farthest = i64::from(outer) * LONGEST_NORMAL;
        let half_planes = half_planes.map(|half_plane| {
            let HalfPlane { normal, least } = half_plane?;
            let least = least.max(-farthest).min(farthest);
            Some(ScaledHalfPlane::new(&HalfPlane { normal, least }, scale))
        });
        Self {
            scale,
            outer: scale.scaled(outer.into()) as i32 + MARGIN,
            inner: scale.scaled(inner.into()) as i32 - MARGIN,
            half_planes,
        }
    }

    fn half_planes(&self) -> impl Iterator<Item = &ScaledHalfPlane> + Clone {
        self.half_planes.iter().flatten()
    }

    fn contains(&self, position: Position) -> bool {
        let (largest, smallest) = (self.outer + CORNER_MARGIN, self.inner - CORNER_MARGIN);
        let square = position.0 * position.0 + position.1 * position.1;
        square <= largest * largest
            && (smallest <= 0 || square >= smallest * smallest)
            && self.half_planes().all(|half_plane| half_plane.contains(position))
    }

    /// Calls `call` with each position where the part may reach furthest.
    fn for_each_corner(&self, call: &mut dyn FnMut(Position)) {
        let radius = self.outer;
        let mut add = |position| {
            if self.contains(position) {
                call(position);
            }
        };
        for outermost in [(radius, 0), (-radius, 0), (0, radius), (0, -radius)] {
            add(outermost);
        }
        let mut others = self.half_planes();
        while let Some(half_plane) = others.next() {
            for radius in [self.outer, self.inner.max(0)] {
                for position in half_plane.crossings(radius).into_iter().flatten() {
                    add(position);
                }
            }
            for other in others.clone() {
                if let Some(position) = half_plane.meets(other) {
                    add(position);
                }
            }
        }
    }

    /// The bounds of all corners, in half pixels from the centre.
    fn bounds(&self) -> Bounds {
        let mut scaled = Bounds::EMPTY;
        self.for_each_corner(&mut |(x, y)| {
            scaled = scaled
                .with((x - CORNER_MARGIN).into(), (y - CORNER_MARGIN).into())
                .with((x + CORNER_MARGIN).into(), (y + CORNER_MARGIN).into());
        });
        if scaled.is_empty() {
            return scaled;
        }
        let down = |value: i64| self.scale.half_pixels(value);
        let up = |value: i64| -self.scale.half_pixels(-value);
        Bounds {
            left: down(scaled.left),
            top: down(scaled.top),
            right: up(scaled.right),
            bottom: up(scaled.bottom),
        }
    }
}

/// A box around the pixels of a ring about a centre whose points all of the half planes have. The radii, of the outer and of
/// the inner circle, are in half pixels: the diameters in pixels.
pub(crate) fn sector_bounds(center: Center, radii: [u32; 2], half_planes: [Option<HalfPlane>; 3]) -> Bounds {
    let around = RingSector::new(radii, half_planes).bounds();
    if around.is_empty() {
        return around;
    }
    // The first pixel not before a position, and the last one not behind it.
    let first = |center: i64, half_pixels: i64| (center + half_pixels + 1) >> 1;
    let last = |center: i64, half_pixels: i64| (center + half_pixels) >> 1;
    Bounds {
        left: first(center.x_2, around.left),
        top: first(center.y_2, around.top),
        right: last(center.x_2, around.right),
        bottom: last(center.y_2, around.bottom),
    }
}
