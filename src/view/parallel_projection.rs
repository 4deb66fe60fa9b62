//! Orthographic projection: all rays are parallel, so that a vertex takes two multiplications and no division.
//!
//! Guarantees: x and y are the eye point's times the scale, rounded once to units of the precision; depth is affine in z, and
//! exact to one unit: with `u16` one unit of depth is 1/65,536 of the way from the near to the far plane, taken up to the next
//! power of two.

use fixed::types::I16F16;

use crate::{
    geometry::leading_zeros,
    view::{Camera, DepthWidth, EyePoint, Projection, ScreenPrecision, ScreenVertex, WideVertex, projection::center},
};

impl<S: ScreenPrecision, D: DepthWidth> Projection<S, D> {
    /// The numbers of a camera whose rays are parallel.
    pub(crate) fn parallel(camera: &Camera) -> Self {
        let [center_x, center_y] = center::<S>(camera);
        let (near, far) = (camera.near().to_bits() >> 4, camera.far().to_bits() >> 4);
        // The way from near to far as 2^30 to 2^31; the camera checked that it is not below 0.
        let depth_exponent = leading_zeros(((far - near).max(2) - 1) as u32) - 1;
        let mut projection = Self::ZERO;
        (projection.near, projection.far) = (near, far);
        (projection.depth_exponent, projection.scale) = (depth_exponent, camera.scale().to_bits());
        (projection.center_x, projection.center_y) = (center_x, center_y);
        projection
    }

    /// Projects a vertex between the near and the far plane.
    #[inline]
    pub(crate) fn project_parallel(&self, EyePoint { x, y, z }: EyePoint) -> WideVertex {
        // 12 fractional bits, and 24 of the scale: a product of 30 and 31 bits.
        let shift = 36 - S::FRACTION_BITS;
        let units = |coordinate: i32| (i64::from(coordinate) * i64::from(self.scale) + (1 << (shift - 1))) >> shift;
        WideVertex {
            x: i64::from(self.center_x) + units(x),
            y: i64::from(self.center_y) - units(y),
            z: self.parallel_depth(z).units(),
        }
    }

    /// Projects a vertex to the same integers as [`project_parallel`](Self::project_parallel). `None` where it is not between
    /// the near and the far plane, or not on the screen.
    #[inline]
    pub(crate) fn project_parallel_inside(&self, eye: EyePoint) -> Option<ScreenVertex<S, D>> {
        // As an unsigned number, what is in front of the near plane is far above all distances behind it.
        if (eye.z - self.near) as u32 > (self.far - self.near) as u32 {
            return None;
        }
        let WideVertex { x, y, z } = self.project_parallel(eye);
        let domain = i64::from(S::MIN_UNITS)..=i64::from(S::MAX_UNITS);
        (domain.contains(&x) && domain.contains(&y)).then(|| ScreenVertex {
            x: S::narrow(x as i32),
            y: S::narrow(y as i32),
            z: D::from_units(z),
        })
    }

    /// Depth of a plane at that distance; the near plane's for anything nearer, the far plane's for anything farther away.
    pub(crate) fn parallel_depth_at(&self, distance: I16F16) -> D {
        self.parallel_depth((distance.to_bits() >> 4).min(self.far).max(self.near))
    }

    /// Depth at a distance between the near and the far plane.
    #[inline]
    fn parallel_depth(&self, z: i32) -> D {
        D::from_near_over_z(((self.far - z) as u32) << (self.depth_exponent & 31))
    }
}
