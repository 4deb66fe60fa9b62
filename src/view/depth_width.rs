//! Depth as stored in the depth row: 16 or 32 bits, nearer is larger.

use crate::surface::PixelWord;

/// The width of a stored depth: `u16` or `u32`.
///
/// Depth is NDC z, affine in 1/w: nearly the greatest value at the near plane, falling to the smallest at infinity.
/// The cleared row holds 0, which is farther than everything. One unit at distance z is z²/(near * 65,535) of space
/// with `u16`, 256 times finer with `u32`, whose low 8 bits hold the fraction of a 24-bit depth.
///
/// A sign at a distance of the program's own, hidden by what is nearer: [`Camera::depth_at`](crate::scene::Camera::depth_at) says
/// what is stored there.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::I16F16;
/// use zrow::{
///     band::Band,
///     draw::{DrawOn, PrimitiveStyle},
///     geometry::Sub4,
///     scene::{Camera, FaceSet, Memory, Model},
/// };
///
/// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
/// let camera = Camera::new(area, I16F16::from_num(128))?;
/// let mesh = FaceSet::new(&[[-512, -512, 1024], [0, 512, 1024], [512, -512, 1024]], &[[0, 1, 2]])?;
/// let models = [Model::new(mesh, &[Rgb565::RED])?];
/// let mut memory = Memory::<Rgb565, 3, 1, 64, 64>::new();
/// let mut scene = memory.prepare(&camera, &models)?;
/// let sign = area.into_styled(PrimitiveStyle::with_fill(Rgb565::GREEN));
/// for (distance, color) in [(1000, Rgb565::GREEN), (1050, Rgb565::RED)] {
///     // The precision and the width of depths of a look that is neither `Fine` nor `Deep`.
///     let depth = camera.depth_at::<Sub4, u16>(I16F16::from_num(distance));
///     let mut words = [0; 64 * 64];
///     scene.draw_with(&mut Band::<Rgb565>::new(area, &mut words)?, |row| {
///         let Ok(()) = sign.draw_on(&mut row.at_depth(depth));
///     });
///     assert_eq!(words[32 * 64 + 32], color.into_storage());
/// }
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
pub trait DepthWidth: PixelWord + Default + Ord + Into<u32> + Send + Sync + sealed::Sealed {
    /// The value that a depth row is cleared to: farther than everything.
    const FARTHEST: Self;
    /// The greatest value that a depth row can hold: nothing is nearer.
    const NEAREST: Self;
    /// Fractional bits of the interpolated depth: 16 for `u16`, 8 for `u32`; 32 bits hold it either way.
    const FRACTION_BITS: u32;

    /// The stored depth for the ratio `near / z`, given in units of 1/2^31.
    fn from_near_over_z(ratio: u32) -> Self;
    /// The stored depth as a number of depth units.
    fn units(self) -> i32;
    /// The depth with that many units.
    fn from_units(units: i32) -> Self;
    /// What the row stores for an interpolated depth.
    fn from_interpolated(depth: u32) -> Self;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for u16 {}
    impl Sealed for u32 {}
}

impl DepthWidth for u16 {
    const FARTHEST: Self = 0;
    const NEAREST: Self = Self::MAX;
    const FRACTION_BITS: u32 = 16;

    #[inline]
    fn from_near_over_z(ratio: u32) -> u16 {
        // 1 to 65,535: 0 is the cleared row. Only the near plane itself meets the upper bound.
        ((ratio >> 15).min(65_534) as u16) + 1
    }

    #[inline]
    fn units(self) -> i32 {
        i32::from(self)
    }

    #[inline]
    fn from_units(units: i32) -> u16 {
        units as u16
    }

    #[inline]
    fn from_interpolated(depth: u32) -> u16 {
        (depth >> 16) as u16
    }
}

impl DepthWidth for u32 {
    const FARTHEST: Self = 0;
    const NEAREST: Self = Self::MAX;
    const FRACTION_BITS: u32 = 8;

    #[inline]
    fn from_near_over_z(ratio: u32) -> u32 {
        // 24 bits, 16 units away from both ends: that is more than rounding can move an interpolated depth.
        let span = (1u64 << 24) - 33;
        Self::from_units(16 + ((u64::from(ratio.min(1 << 31)) * span) >> 31) as i32)
    }

    #[inline]
    fn units(self) -> i32 {
        (self >> 8) as i32
    }

    #[inline]
    fn from_units(units: i32) -> u32 {
        (units as u32) << 8
    }

    #[inline]
    fn from_interpolated(depth: u32) -> u32 {
        depth
    }
}
