//! How a ray marches through the cells of a uniform grid, from one to the next.
//!
//! ```text
//!     +---+---+---+---+        For each axis the ray knows at which distance it crosses the next boundary of cells, and how
//!     |   |   |   | *-->       far it is from one boundary to the next. It steps along the axis whose boundary comes first:
//!     +---+---+---*---+        a comparison and an addition for a cell, whatever the direction.
//!     |   |   *   |   |
//!     +---*---+---+---+        Amanatides and Woo call these tMax and tDelta.
//!   *-|---|   |   |   |
//!     +---+---+---+---+
//! ```
//!
//! Distances are integers, rounded down: a boundary is crossed at most a unit too early for each one that was crossed before, so
//! less than as many units as there are cells along an axis, and one. By as much as a ray gets ahead in that, the boxes of faces
//! are padded. So at each distance the ray is in a cell in which all faces are that its true point lies in the boxes of.
//!
//! Guarantees: a ray comes to all cells of the faces that it meets, in the order of distances. Cost: five divisions for x and for y
//! where a ray enters the grid, a comparison and an addition for each cell.
//!
//! Source: Amanatides and Woo 1987, "A fast voxel traversal algorithm for ray tracing".

use core::num::NonZeroU64;

use crate::visible::hidden_surfaces::ray_casting::{
    eye_space::Ray,
    uniform_grid::{GridAxis, MOST_ALONG_AXIS, UniformGrid},
};

/// How many units of distance too early a ray may turn into the next cell, at most.
pub(super) const MOST_EARLY: i32 = MOST_ALONG_AXIS + 1;

/// A distance that no ray reaches: those of all corners are shorter.
const NEVER: i32 = i32::MAX;

/// A ray in a cell of a grid.
#[derive(Debug)]
pub(super) struct RayMarch {
    axes: [AxisMarch; 3],
}

/// A ray in a cell of a grid, along one axis.
#[derive(Debug, Copy, Clone)]
struct AxisMarch {
    cell: i32,
    cells: i32,
    /// Whether cells are counted downwards: `-1` or `1`.
    step: i32,
    /// The distance at which the ray crosses the next boundary.
    next: i32,
    /// The distance from one boundary to the next.
    between: i32,
}

/// A ray along one axis: where it begins, and how far it goes for one unit of distance.
#[derive(Debug, Copy, Clone)]
struct AxisRay {
    start: i64,
    slope: i64,
}

impl RayMarch {
    /// The first cell that a ray comes to. `None` where it passes by.
    pub(super) fn enter(grid: &UniformGrid, ray: &Ray) -> Option<Self> {
        let ([a, b, c], [d, e, f]) = (ray.start.map(i64::from), ray.slope.map(i64::from));
        let [x, y, z] = grid.axes;
        let axes = [
            (AxisRay { start: a, slope: d }, x),
            (AxisRay { start: b, slope: e }, y),
            (AxisRay { start: c, slope: f }, z),
        ];
        let (mut first, mut last) = (0, NEVER);
        for (ray, axis) in &axes {
            let [enters, leaves] = ray.distances_within(axis)?;
            (first, last) = (first.max(enters), last.min(leaves));
        }
        (first <= last).then(|| Self {
            axes: axes.map(|(ray, axis)| ray.march(&axis, first)),
        })
    }

    /// The numbers of the cell in which the ray is.
    pub(super) fn cell(&self) -> [i32; 3] {
        self.axes.map(|axis| axis.cell)
    }

    /// Goes on to the next cell. Returns whether there is one that begins at most at a distance.
    pub(super) fn step(&mut self, farthest: i32) -> bool {
        let [x, y, z] = &mut self.axes;
        let across = if x.next < y.next { x } else { y };
        let axis = if across.next < z.next { across } else { z };
        if axis.next > farthest {
            return false;
        }
        axis.cell += axis.step;
        axis.next = axis.next.saturating_add(axis.between);
        (0..axis.cells).contains(&axis.cell)
    }
}

impl AxisRay {
    /// The distance at which the ray is at a coordinate, rounded down; 0 where it was there before.
    fn distance_at(&self, coordinate: i64) -> i32 {
        let way = (coordinate - self.start) * self.slope.signum();
        self.distance_of(way.max(0) as u64)
    }

    /// The distance in which the ray goes so far along the axis, rounded down.
    fn distance_of(&self, way: u64) -> i32 {
        match NonZeroU64::new(self.slope.unsigned_abs()) {
            Some(slope) => (way / slope).min(NEVER as u64) as i32,
            None => NEVER,
        }
    }

    /// The distances at which the ray enters the cells of an axis and leaves them, not too late and not too early. `None` where it
    /// runs beside them.
    fn distances_within(&self, axis: &GridAxis) -> Option<[i32; 2]> {
        let (least, greatest) = (axis.least, axis.boundary(axis.cells()));
        if self.slope == 0 {
            return (least..=greatest).contains(&self.start).then_some([0, NEVER]);
        }
        let (before, behind) = if self.slope > 0 {
            (least, greatest)
        } else {
            (greatest, least)
        };
        Some([self.distance_at(before), self.distance_at(behind).saturating_add(1)])
    }

    /// The cell of an axis in which the ray is at a distance, and how it goes on from there.
    fn march(&self, axis: &GridAxis, distance: i32) -> AxisMarch {
        let cell = axis.cell_of(self.start + self.slope * i64::from(distance));
        let ahead = axis.boundary(if self.slope > 0 { cell + 1 } else { cell });
        AxisMarch {
            cell,
            cells: axis.cells(),
            step: if self.slope > 0 { 1 } else { -1 },
            next: if self.slope == 0 {
                NEVER
            } else {
                self.distance_at(ahead)
            },
            between: self.distance_of(axis.size as u64),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    use super::*;
    use crate::visible::hidden_surfaces::ray_casting::eye_space::EyeBox;

    /// xorshift64 (Marsaglia 2003), from 0 to below a bound.
    fn numbers() -> impl FnMut(i64) -> i64 {
        let mut state = 0x0123_4567_89ab_cdef_u64;
        move |bound| {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state % bound as u64) as i64
        }
    }

    /// Whether the ray comes to a cell that a box of a point meets.
    fn comes_to(grid: &UniformGrid, ray: &Ray, point: &EyeBox) -> bool {
        let mut cells = Vec::new();
        grid.for_each_cell(point, |cell| cells.push(cell));
        let Some(mut march) = RayMarch::enter(grid, ray) else {
            return false;
        };
        loop {
            if cells.contains(&grid.index(march.cell())) {
                return true;
            }
            if !march.step(NEVER) {
                return false;
            }
        }
    }

    /// Cells that rays cross in few units of distance, so that rounding counts: each point of a ray, padded by what the ray may get
    /// ahead, meets one of its cells. Without the padding some points do not.
    #[test]
    fn a_ray_comes_to_the_cells_of_all_its_points() {
        let mut next = numbers();
        let mut missed_without = 0;
        for _ in 0..20_000 {
            let slope = [next(4_001) as i32 - 2_000, next(41) as i32 - 20, 1];
            let ray = Ray { start: [0; 3], slope };
            let distance = 10 + next(2_000);
            // A point at a distance with a fraction of 1/16, in a box of integers around it.
            let sixteenths = 16 * distance + next(16);
            let coordinates = slope.map(|slope| i64::from(slope) * sixteenths);
            let point = EyeBox {
                least: coordinates.map(|coordinate| coordinate >> 4),
                greatest: coordinates.map(|coordinate| (coordinate + 15) >> 4),
            };
            let padded = point.padded([2_000, 20, 0].map(|reach: i64| reach * i64::from(MOST_EARLY)));
            let more = [next(200_000), next(3_000), next(100)];
            let all = padded.around(point.padded(more));
            let grid = UniformGrid::new(&all, [1 << 20, 1 << 20, 1 << 10], 1 << next(16));
            assert!(comes_to(&grid, &ray, &padded), "{grid:?} {ray:?} {distance}");
            missed_without += usize::from(!comes_to(&grid, &ray, &point));
        }
        assert!(missed_without > 10, "{missed_without}");
    }
}
