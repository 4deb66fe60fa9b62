//! The part of space that a camera sees, to tell what is wholly outside of it.
//!
//! A point has an outcode: a bit for each plane of the view volume that it is beyond. Where the outcodes of all corners of a
//! box share a bit, the whole box is beyond that plane, and nothing within it is seen: trivial rejection. A box that is beyond
//! no single plane and yet outside, beside an edge of the volume, is not found.
//!
//! ```text
//!     \ left        right /      f x > (right - c) z    beyond the right side, for a focal length f and a
//!      \        +--+     /                              picture centre c
//!       \   ____|  |____/
//!        \      |  |   /        The box shares no bit: it may be seen.
//!         \_____+--+__/ near
//! ```
//!
//! Guarantees: nothing that is snapped to a pixel of the picture is beyond a plane. Eye coordinates are those that the vertices
//! of a mesh get, whose rounding is monotone, so that they lie between those of the box; the sides lie a pixel outside of the
//! picture, which is more than projection rounds by, and as much farther as eye coordinates and cuts are rounded by.
//!
//! Source: Cohen and Sutherland's outcodes (Newman and Sproull 1979, "Principles of interactive computer graphics"); boxes
//! against the view volume as in Clark (1976), "Hierarchical geometric models for visible surface algorithms".

use crate::{
    geometry::Window,
    view::{DepthWidth, EyePoint, Projection, ScreenPrecision},
};

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

impl ViewVolume {
    /// A bit for each plane that a point is beyond.
    pub(crate) fn outcode(&self, EyePoint { x, y, z }: EyePoint) -> u32 {
        // Coordinates below 2^30, times a focal length below 2^19 or a scale below 2^31.
        let columns = self.columns.outcode(i64::from(x) * self.scale, z);
        let rows = self.rows.outcode(-i64::from(y) * self.scale, z);
        u32::from(z < self.near) | u32::from(z > self.far) << 1 | columns << 2 | rows << 4
    }
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
