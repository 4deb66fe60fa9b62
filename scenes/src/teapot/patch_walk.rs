//! A bicubic patch at the corners of its cells: four cubic curves run down it, and what they have come to at a row are the
//! control values of the curve across (forward differences in two directions).

use super::{
    cubic_walk::CubicWalk,
    patches::{CONTROL_POINTS, Patch},
    vector::cross,
};

/// Which of Newell's coordinates are x to the right, y up and z away.
const AXES: [usize; 3] = [0, 2, 1];

/// Goes down the patch.
pub(super) struct PatchWalk {
    /// Three coordinates of each of the four curves.
    curves: [[CubicWalk; 4]; 3],
    steps: i64,
}

impl PatchWalk {
    /// From the first row of the patch's control points to the last in so many steps.
    pub(super) const fn new(patch: &Patch, steps: i64) -> Self {
        let mut curves = [[CubicWalk::new([0; 4], steps); 4]; 3];
        let mut index = 0;
        while index < 12 {
            let (axis, column) = (index / 4, index % 4);
            let controls = [
                coordinate(patch[column], axis),
                coordinate(patch[column + 4], axis),
                coordinate(patch[column + 8], axis),
                coordinate(patch[column + 12], axis),
            ];
            curves[axis][column] = CubicWalk::new(controls, steps);
            index += 1;
        }
        Self { curves, steps }
    }

    /// The row where the walk is.
    pub(super) const fn row(&self) -> RowWalk {
        let mut point = [CubicWalk::new([0; 4], self.steps); 3];
        let mut down = point;
        let mut axis = 0;
        while axis < 3 {
            let [one, two, three, four] = self.curves[axis];
            let values = [one.value(), two.value(), three.value(), four.value()];
            let slopes = [one.slope(), two.slope(), three.slope(), four.slope()];
            point[axis] = CubicWalk::new(values, self.steps);
            down[axis] = CubicWalk::new(slopes, self.steps);
            axis += 1;
        }
        RowWalk { point, down }
    }

    pub(super) const fn advance(&mut self) {
        let mut index = 0;
        while index < 12 {
            self.curves[index / 4][index % 4].advance();
            index += 1;
        }
    }
}

/// Goes across the patch, around the pot.
pub(super) struct RowWalk {
    point: [CubicWalk; 3],
    /// The derivatives of the point in the direction down the patch.
    down: [CubicWalk; 3],
}

impl RowWalk {
    /// The point of the surface, times the sixth power of the steps, in units of the control points.
    pub(super) const fn point(&self) -> [i64; 3] {
        values(&self.point)
    }

    /// The normal of the surface at the vertex that the walk has reached, outwards and of any length; 0 where the row is a point.
    pub(super) const fn normal(&self) -> [i64; 3] {
        let [x, y, z] = &self.point;
        cross(values(&self.down), [x.slope(), y.slope(), z.slope()])
    }

    pub(super) const fn advance(&mut self) {
        let mut axis = 0;
        while axis < 3 {
            self.point[axis].advance();
            self.down[axis].advance();
            axis += 1;
        }
    }
}

const fn values([x, y, z]: &[CubicWalk; 3]) -> [i64; 3] {
    [x.value(), y.value(), z.value()]
}

const fn coordinate(point: u16, axis: usize) -> i64 {
    CONTROL_POINTS[point as usize][AXES[axis]] as i64
}
