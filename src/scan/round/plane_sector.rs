//! The sector of the plane between two angles, row by row: which columns of a row lie in it.
//!
//! Guarantees: embedded-graphics' half planes, of whole normal vectors 1,024 long from micromath's sine and cosine, decided
//! exactly at any distance from the centre. Below half a turn a sector is what two half planes have in common, from there
//! on what either has; from a whole turn on it is the plane. Cost: two sines and two cosines a sector, then one division a
//! row and half plane.
//!
//! # Angles without a direction
//!
//! From 2^22 turns on, neighbouring `f32` numbers are two radians apart, and micromath's sines are 0 (from 2^31 turns on
//! they are of any size). Such an angle, an infinite one and one that is not a number have the zero vector as their normal:
//! every pixel of the plane counts as lying on the line along the angle.

use embedded_graphics::geometry::Angle;

pub use crate::scan::round::half_plane::{Center, Columns, HalfPlane, NORMAL_LENGTH};
use crate::{
    geometry::Bounds,
    scan::{polygon::edge_table::insertion_sort, round::sector_bounds::sector_bounds},
};

/// How two half planes make a sector.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
enum Operation {
    Intersection,
    Union,
    EntirePlane,
}

/// The directions from one angle to another, or all of them.
#[derive(Debug, Copy, Clone, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PlaneSector {
    first: Angle,
    last: Angle,
    operation: Operation,
}

impl PlaneSector {
    /// The directions from `start` on, over the angle `sweep`; a negative one goes the other way round. A sweep of a whole turn
    /// or more is every direction.
    pub fn new(start: Angle, sweep: Angle) -> Self {
        let turn = Angle::from_degrees(360.0);
        let operation = if sweep.abs() >= turn {
            Operation::EntirePlane
        } else if sweep.abs() >= Angle::from_degrees(180.0) {
            Operation::Union
        } else {
            Operation::Intersection
        };
        let end = start + sweep;
        let (first, last) = if sweep < Angle::zero() {
            (end, start)
        } else {
            (start, end)
        };
        Self { first, last, operation }
    }

    /// The two half planes of the sector: right of its first side and left of its last one. Both are moved outwards by `beyond`,
    /// in half pixels times [`NORMAL_LENGTH`].
    pub fn half_planes(&self, beyond: i64) -> [HalfPlane; 2] {
        [
            HalfPlane::right_of(self.first, beyond),
            HalfPlane::left_of(self.last, beyond),
        ]
    }

    /// A box around the pixels of a ring that are in it: in both of these half planes or in either, and in `another` one.
    /// The radii of the ring's circles are in half pixels, which are their diameters in pixels.
    ///
    /// Cost and how tight it is: as [`sector_bounds`].
    pub(crate) fn bounds(
        &self,
        center: Center,
        radii: [u32; 2],
        [right, left]: [HalfPlane; 2],
        another: Option<HalfPlane>,
    ) -> Bounds {
        let part = |one, other| sector_bounds(center, radii, [one, other, another]);
        match self.operation {
            Operation::Intersection => part(Some(right), Some(left)),
            Operation::Union => part(Some(right), None).around(&part(Some(left), None)),
            Operation::EntirePlane => part(None, None),
        }
    }

    /// The `visible` columns of a row that are in the sector, from those in each of its half planes: one run of columns or two
    /// that do not meet; a run may be empty.
    pub fn row_runs(&self, [right, left]: [Columns; 2], visible: Columns) -> [Columns; 2] {
        let none = Columns {
            end: visible.start,
            ..visible
        };
        match self.operation {
            Operation::Intersection => [right.intersection(left), none],
            Operation::Union if right.start.max(left.start) <= right.end.min(left.end) => {
                let (start, end) = (right.start.min(left.start), right.end.max(left.end));
                [Columns { start, end }, none]
            }
            Operation::Union => [right, left],
            Operation::EntirePlane => [visible, none],
        }
    }

    /// Whether column `x` of a row is in the sector, from the columns of that row in each of its half planes.
    pub fn contains(&self, [right, left]: &[Columns; 2], x: i32) -> bool {
        match self.operation {
            Operation::Intersection => right.contains(x) && left.contains(x),
            Operation::Union => right.contains(x) || left.contains(x),
            Operation::EntirePlane => true,
        }
    }
}

/// Hands over the runs of columns of a row that are of the same kind, from left to right. A kind can change at a border only:
/// `kind` is asked for the column at each visible border, and `None` is not handed over. Columns left of the first border have
/// no kind. The borders are put in order. Cost: their insertion sort.
///
/// # Errors
/// The first error that `emit` returns.
pub fn runs<K: Copy + PartialEq, E>(
    visible: Columns,
    borders: &mut [i32],
    kind: impl Fn(i32) -> Option<K>,
    mut emit: impl FnMut(Columns, K) -> Result<(), E>,
) -> Result<(), E> {
    // There are a few. The core library's sort holds a panic for orders that contradict themselves.
    insertion_sort(borders, 1, |&border| border);
    let mut start = visible.start;
    let mut current = None;
    for &border in borders.iter() {
        if !visible.contains(border) {
            continue;
        }
        let next = kind(border);
        if next != current {
            if let Some(kind) = current.filter(|_| border > start) {
                emit(Columns { start, end: border }, kind)?;
            }
            start = border;
            current = next;
        }
    }
    match current {
        Some(kind) if visible.end > start => emit(
            Columns {
                start,
                end: visible.end,
            },
            kind,
        ),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests;
