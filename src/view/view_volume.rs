//! The part of space that a camera sees, to tell what is wholly outside of it.
//!
//! A point has an outcode: a bit for each plane of the view volume that it is beyond. Only where the centre of a box, a sphere
//! or a cylinder is beyond a plane, all of it may be: where it reaches less far towards the plane than its centre is beyond it.
//! With the three vectors from the centre along its axes, and how far each goes towards the plane, a box reaches as far as
//! their sum, a sphere as the root of the sum of their squares, a cylinder as the one along its axis and the root of the
//! squares of the other two, also where a map makes an ellipsoid of the sphere. What is beyond no single plane and yet outside,
//! beside an edge of the volume, is not found.
//!
//! ```text
//!     \ left        right /      f x > (right - c) z    beyond the right side, for a focal length f and a
//!      \        +--+     /                              picture centre c
//!       \   ____|  |____/
//!        \      |  |   /        Beyond no plane: the box may be seen.
//!         \_____+--+__/ near
//! ```
//!
//! Guarantees: nothing that is snapped to a pixel of the picture is beyond a plane. The sides lie a pixel outside of the
//! picture, which is more than projection rounds by, and as much farther as eye coordinates and cuts are rounded by.
//!
//! Source: Cohen and Sutherland's outcodes (Newman and Sproull 1979, "Principles of interactive computer graphics"); volumes
//! against the planes of the view as in Clark (1976), "Hierarchical geometric models for visible surface algorithms".

use crate::{
    geometry::Window,
    view::{DepthWidth, EyePoint, Projection, ScreenPrecision},
};

/// The near and the far plane, and four sides.
const PLANES: u32 = 6;

/// The planes of what a camera sees.
#[derive(Debug, Copy, Clone)]
pub(crate) struct ViewVolume {
    near: i32,
    /// Beyond all points where there is no far plane.
    far: i32,
    /// Focal length or scale: what x and y are multiplied by.
    scale: i64,
    columns: Sides,
    rows: Sides,
}

/// Two sides of the picture that are opposite to each other.
#[derive(Debug, Copy, Clone)]
struct Sides {
    least: Side,
    greatest: Side,
}

/// A side of the picture: what a scaled coordinate at distance z is compared with, `per_unit * z + constant`.
#[derive(Debug, Copy, Clone)]
struct Side {
    per_unit: i64,
    constant: i64,
}

impl Side {
    fn at(self, z: i32) -> i64 {
        self.per_unit * i64::from(z) + self.constant
    }
}

impl Sides {
    /// The sides of pixels from `start` to before `end`, with a pixel more on each side.
    fn new<S: ScreenPrecision>(start: i32, end: i32, center: i32, scale: i64, is_orthographic: bool) -> Self {
        let side = |pixel: i32, sign: i64| {
            // Below 2^22.
            let units = i64::from((pixel << S::FRACTION_BITS) - center);
            if is_orthographic {
                // In eye space 12 fractional bits, and 24 of the scale.
                return Side {
                    per_unit: 0,
                    constant: units << (36 - S::FRACTION_BITS),
                };
            }
            Side {
                per_unit: units,
                // Three times a unit of x and four times one of z, for the vertex, the corner of the box and two cuts.
                constant: 4 * sign * (scale + units.abs()),
            }
        };
        Self {
            least: side(start - 1, -1),
            greatest: side(end, 1),
        }
    }

    /// Two bits: beyond the least side, and beyond the greatest one.
    fn outcode(&self, scaled: i64, z: i32) -> u32 {
        u32::from(scaled < self.least.at(z)) | u32::from(scaled > self.greatest.at(z)) << 1
    }
}

/// A vector of eye space in 1/4096 of the vertices' unit, below 2^31.
#[derive(Debug, Copy, Clone)]
struct EyeVector {
    x: i64,
    y: i64,
    z: i64,
}

impl EyeVector {
    fn between(from: EyePoint, to: EyePoint) -> Self {
        let difference = |to: i32, from: i32| i64::from(to) - i64::from(from);
        Self {
            x: difference(to.x, from.x),
            y: difference(to.y, from.y),
            z: difference(to.z, from.z),
        }
    }
}

/// How far a volume may reach more than it seems to, in 1/4096 unit of x, y and z: six for its three axes, which are computed
/// at half their length from two rounded points each, and one each for its centre and a vertex.
const ROUNDING: i64 = 8;

impl ViewVolume {
    /// Whether all of a volume is beyond one plane, so that nothing within it is seen. Of the volume are known the centre,
    /// three points half as far from it as it reaches along its axes, and along which of these it is straight.
    pub(crate) fn is_beyond(
        &self,
        center: EyePoint,
        halves: impl FnOnce() -> [EyePoint; 3],
        straight: [bool; 3],
    ) -> bool {
        let outcode = self.outcode(center);
        if outcode == 0 {
            return false;
        }
        let axes = halves().map(|half| EyeVector::between(center, half));
        (0..PLANES).any(|plane| {
            let by = self.distance_beyond(plane, center) - ROUNDING * self.most_per_unit(plane);
            // A half, as long as those of the axes.
            outcode & (1 << plane) != 0
                && u64::try_from(by >> 1)
                    .is_ok_and(|half| reaches_less(half, axes.map(|axis| self.along(plane, axis)), straight))
        })
    }

    /// How far a point is beyond a plane, in the plane's own unit, below 2^62.
    fn distance_beyond(&self, plane: u32, EyePoint { x, y, z }: EyePoint) -> i64 {
        let (columns, rows) = (i64::from(x) * self.scale, -i64::from(y) * self.scale);
        match plane {
            0 => i64::from(self.near) - i64::from(z),
            1 => i64::from(z) - i64::from(self.far),
            2 => self.columns.least.at(z) - columns,
            3 => columns - self.columns.greatest.at(z),
            4 => self.rows.least.at(z) - rows,
            _ => rows - self.rows.greatest.at(z),
        }
    }

    /// How far a vector goes along the normal of a plane, to whichever side, in the plane's own unit, below 2^63.
    fn along(&self, plane: u32, EyeVector { x, y, z }: EyeVector) -> u64 {
        let along = match plane {
            0 | 1 => z,
            2 => x * self.scale - self.columns.least.per_unit * z,
            3 => x * self.scale - self.columns.greatest.per_unit * z,
            4 => y * self.scale + self.rows.least.per_unit * z,
            _ => y * self.scale + self.rows.greatest.per_unit * z,
        };
        along.unsigned_abs()
    }

    /// The most that one unit of x, y and z each goes along the normal of a plane.
    fn most_per_unit(&self, plane: u32) -> i64 {
        self.scale_of(plane)
            + match plane {
                0 | 1 => 0,
                2 => self.columns.least.per_unit.abs(),
                3 => self.columns.greatest.per_unit.abs(),
                4 => self.rows.least.per_unit.abs(),
                _ => self.rows.greatest.per_unit.abs(),
            }
    }

    fn scale_of(&self, plane: u32) -> i64 {
        if plane < 2 { 1 } else { self.scale }
    }

    /// A bit for each plane that a point is beyond.
    fn outcode(&self, EyePoint { x, y, z }: EyePoint) -> u32 {
        // Coordinates below 2^30, times a focal length below 2^19 or a scale below 2^31.
        let columns = self.columns.outcode(i64::from(x) * self.scale, z);
        let rows = self.rows.outcode(-i64::from(y) * self.scale, z);
        u32::from(z < self.near) | u32::from(z > self.far) << 1 | columns << 2 | rows << 4
    }
}

/// Whether a volume reaches less far than a distance, by how far its axes go, which is its support function: those along which
/// it is straight one after the other, and the others in their plane or in space.
fn reaches_less(distance: u64, axes: [u64; 3], straight: [bool; 3]) -> bool {
    let mut rest = distance;
    let mut round = [0; 3];
    for ((axis, is_straight), round) in axes.into_iter().zip(straight).zip(&mut round) {
        if is_straight {
            let Some(left) = rest.checked_sub(axis) else {
                return false;
            };
            rest = left;
        } else {
            *round = axis;
        }
    }
    let [one, two, three] = round;
    // 31 bits are left, and 1 is added, so that three squares are below 2^64.
    let shift = 33u32.saturating_sub((one | two | three).leading_zeros());
    let square = |length: u64| if length == 0 { 0 } else { ((length >> shift) + 1).pow(2) };
    let reach = square(one) + square(two) + square(three);
    rest >>= shift;
    // Farther than the root of three times 2^62.
    rest > u64::from(u32::MAX) || rest * rest > reach
}

impl<S: ScreenPrecision, D: DepthWidth> Projection<S, D> {
    /// What is seen in a viewport, of a picture with parallel rays or in perspective, which ends at the far plane or does not.
    pub(crate) fn view_volume(&self, viewport: &Window, is_orthographic: bool, has_far_plane: bool) -> ViewVolume {
        let scale = i64::from(self.scale);
        let sides = |start, end, center| Sides::new::<S>(start, end, center, scale, is_orthographic);
        ViewVolume {
            near: self.near,
            far: if has_far_plane { self.far } else { i32::MAX },
            scale,
            columns: sides(viewport.left, viewport.right, self.center_x),
            rows: sides(viewport.top, viewport.bottom, self.center_y),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn round_axes_reach_as_far_as_the_root_of_their_squares() {
        let sphere = [false; 3];
        assert!(!reaches_less(12, [4, 4, 12], sphere));
        // 13.27; squares of one more each, 14.96.
        assert!(reaches_less(15, [4, 4, 12], sphere));
        let cylinder = [true, false, false];
        assert!(!reaches_less(16, [4, 4, 12], cylinder));
        assert!(reaches_less(18, [4, 4, 12], cylinder));
        assert!(!reaches_less(20, [4, 4, 12], [true; 3]));
        assert!(reaches_less(21, [4, 4, 12], [true; 3]));
        assert!(!reaches_less(0, [0; 3], sphere));
        // The root of three times 2^126 is 1.73 times 2^63.
        let most = (1 << 63) - 1;
        assert!(!reaches_less(most, [most; 3], sphere));
        assert!(!reaches_less(3 << 61, [1 << 61; 3], [true, false, true]));
        assert!(reaches_less(7 << 59, [1 << 60; 3], sphere));
        assert!(!reaches_less(3 << 59, [1 << 60; 3], sphere));
    }
}
