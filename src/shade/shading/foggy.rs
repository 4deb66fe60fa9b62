//! Fog: the farther away, the more of a colour has the place of a surface's own.
//!
//! ```text
//!     fog 1 |            ____      how far a point is between start and end, which grows evenly in space, is interpolated
//!           |        ___/          over a face in perspective; a curve, a table of 64 steps, says how much fog that is
//!         0 |_______/
//!           +-------|----|--->
//!                 start  end       distance along the camera's axis
//! ```
//!
//! Guarantees: fog has 33 steps; a face in front of its start keeps its colour, and one behind its end has the fog's. The depth
//! of a pixel in the fog is within 1/64 of the way from start to end at both ends of a span and at every 16th column, and steps
//! evenly in between ([`Perspective`] says how far that may be off), for faces that reach no farther than 63 times that way from
//! its start, in coordinates so small that 1/32,768 of them is no distance, and with depths that differ by up to 100 times.
//!
//! Cost of a pixel: an addition, a look-up, and two multiplications' worth of mixing.
//!
//! Source: linear and exponential fog as in OpenGL 1.0 (Segal and Akeley 1992).

use core::{marker::PhantomData, num::NonZeroU64};

use embedded_graphics::geometry::Point;
use fixed::types::I16F16;

use crate::{
    geometry::{TooSmall, quotient_nearest},
    mesh::{BoundingVolume, FacePlanes, FaceSet},
    shade::{
        BlendedColor, ChannelColor, InstructionSet, Planes, Shading, layout::Layout, shading::perspective::Perspective,
    },
    surface::BandColor,
    view::{Affine, Camera, EyeAxis, Pose},
};

/// The shading `H` in a fog.
///
/// As a [`Look`](crate::scene::Look), or as the shading of one: `Whole<Foggy<Rgb565>>`, `Foggy<Gouraud<Rgb565>>`. A model's
/// skin is what the shading in the fog takes, and the [`Fog`]: `(skin, fog)`.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Foggy<H>(PhantomData<H>);

/// A fog: from where to where along the camera's axis it gets thicker, and how.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Fog<'a, C> {
    /// The colour in and behind the thickest fog.
    pub color: C,
    /// The distance from which on there is fog.
    #[cfg_attr(feature = "defmt", defmt(Debug2Format))]
    pub start: I16F16,
    /// The distance from which on nothing else is seen, at least one unit beyond the start.
    #[cfg_attr(feature = "defmt", defmt(Debug2Format))]
    pub end: I16F16,
    /// How much fog there is at 64 distances from start to end, in 1/32: at most 32. [`Fog::LINEAR`], [`Fog::EXPONENTIAL`], or
    /// any.
    pub curve: &'a [u8; 64],
}

impl Fog<'static, ()> {
    /// Fog that grows evenly with the distance.
    pub const LINEAR: &'static [u8; 64] = &{
        let mut curve = [0; 64];
        let (mut rest, mut step) = (&mut curve as &mut [u8], 0);
        while let [fog, others @ ..] = rest {
            // 0 at the first step and 32 at the last.
            *fog = ((step * 32 + 31) / 63) as u8;
            (rest, step) = (others, step + 1);
        }
        curve
    };

    /// Fog as thick everywhere, of which light loses an even part on each unit of its way: 1 - e^(-4 x), and all at the end.
    pub const EXPONENTIAL: &'static [u8; 64] = &{
        let mut curve = [0; 64];
        // e^(-4/63) with 32 fractional bits.
        const LEFT_A_STEP: u64 = 4_030_747_640;
        let (mut rest, mut left) = (&mut curve as &mut [u8], 1u64 << 32);
        while let [fog, others @ ..] = rest {
            let is_last = others.is_empty();
            *fog = if is_last {
                32
            } else {
                32 - ((left * 32 + (1 << 31)) >> 32) as u8
            };
            (rest, left) = (others, (left * LEFT_A_STEP) >> 32);
        }
        curve
    };
}

/// The fog as a model sees it, and what is the same for all its vertices in the shading within.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FogOfModel<U> {
    within: U,
    /// How far a position of the model is along the camera's axis, in 1/4096 unit.
    #[cfg_attr(feature = "defmt", defmt(Debug2Format))]
    axis: EyeAxis,
    /// Where the fog starts, in 1/4096 unit.
    start: i32,
    /// The way from start to end in 1/4096 unit, at least one unit.
    way: i64,
    /// The reciprocal of that, with 40 fractional bits, times a whole way.
    per_unit: i64,
}

/// Fractional bits of a distance at the vertices, in parts of the way from start to end.
const DISTANCE_BITS: u32 = 9;
/// How many times the way from start to end a vertex may be away from the start: less than 16 bits can say by a whole way.
const FARTHEST: i64 = 63;
/// Bits of the number of a step of a curve.
const STEP_BITS: u32 = 6;

impl<U> FogOfModel<U> {
    /// How far a position of the model is beyond the start of the fog, in parts of the way to its end.
    fn distance(&self, position: [i32; 3]) -> i16 {
        // Not farther than 63 times the way: the product is below 2^55, and what is interpolated does not wrap.
        let distance = self.axis.distance(position) - i64::from(self.start);
        let farthest = FARTHEST * self.way;
        let distance = distance.min(farthest).max(-farthest);
        ((distance * self.per_unit) >> 40) as i16
    }
}

impl<H: Shading<Color: ChannelColor>> Shading for Foggy<H> {
    type Color = H::Color;
    /// What the shading in the fog takes beside a mesh, and the fog.
    type Skin<'a> = (H::Skin<'a>, Fog<'a, H::Color>);
    type Uniforms = FogOfModel<H::Uniforms>;
    type Attributes = (H::Attributes, Perspective<1>);
    /// A quarter of a step.
    const TOLERANCE: <Self::Attributes as Planes>::Tolerance = (H::TOLERANCE, 1 << (DISTANCE_BITS - STEP_BITS - 2));
    const HAS_HOLES: bool = H::HAS_HOLES;

    fn check((skin, _): &Self::Skin<'_>, mesh: &FaceSet<'_>) -> Result<(), TooSmall> {
        H::check(skin, mesh)
    }

    fn uniforms((skin, fog): &Self::Skin<'_>, pose: &Pose, camera: &Camera) -> Self::Uniforms {
        let [start, end] = [fog.start, fog.end].map(|distance| distance.to_bits() >> 4);
        let way = (i64::from(end) - i64::from(start)).max(1 << 12);
        FogOfModel {
            within: H::uniforms(skin, pose, camera),
            axis: EyeAxis::new(pose, camera.pose()),
            start,
            way,
            per_unit: quotient_nearest(
                1 << (40 + DISTANCE_BITS),
                NonZeroU64::new(way as u64).unwrap_or(NonZeroU64::MIN),
            ),
        }
    }

    #[inline]
    fn vertex(
        (skin, _): &Self::Skin<'_>,
        uniforms: &Self::Uniforms,
        vertex: usize,
        position: [i32; 3],
    ) -> Self::Attributes {
        (
            H::vertex(skin, &uniforms.within, vertex, position),
            Perspective([uniforms.distance(position)]),
        )
    }

    const HAS_AFFINE_MAP: bool = {
        assert!(!H::HAS_AFFINE_MAP, "Transformed goes around Foggy, not into it");
        false
    };

    const HAS_BOUNDS: bool = H::HAS_BOUNDS;
    const HAS_PLANES: bool = H::HAS_PLANES;

    #[inline]
    fn bounds((skin, _): &Self::Skin<'_>) -> Option<BoundingVolume> {
        H::bounds(skin)
    }

    #[inline]
    fn planes<'a>((skin, _): &Self::Skin<'a>) -> Option<FacePlanes<'a>> {
        H::planes(skin)
    }

    #[inline]
    fn transformed_vertex(
        (skin, _): &Self::Skin<'_>,
        uniforms: &Self::Uniforms,
        normals: &Affine,
        vertex: usize,
        position: [i32; 3],
    ) -> Self::Attributes {
        (
            H::transformed_vertex(skin, &uniforms.within, normals, vertex, position),
            Perspective([uniforms.distance(position)]),
        )
    }

    #[inline]
    fn transformed_face(
        (skin, _): &Self::Skin<'_>,
        uniforms: &Self::Uniforms,
        maps: [&Affine; 2],
        mesh: &FaceSet<'_>,
        face: usize,
    ) -> Option<<Self::Color as BandColor>::Word> {
        H::transformed_face(skin, &uniforms.within, maps, mesh, face)
    }

    #[inline]
    fn face(
        (skin, _): &Self::Skin<'_>,
        uniforms: &Self::Uniforms,
        mesh: &FaceSet<'_>,
        face: usize,
    ) -> Option<<Self::Color as BandColor>::Word> {
        H::face(skin, &uniforms.within, mesh, face)
    }

    #[inline]
    fn instructions(set: InstructionSet) -> [u32; 2] {
        let [face, fragment] = H::instructions(set);
        [face, fragment.saturating_add(set.of([33, 22]))]
    }

    #[inline(always)]
    fn fragment(
        (skin, fog): &Self::Skin<'_>,
        face: <Self::Color as BandColor>::Word,
        (values, [distance]): &<Self::Attributes as Planes>::Values,
    ) -> Option<<Self::Color as BandColor>::Word> {
        let word = H::fragment(skin, face, values)?;
        let step = (distance >> (16 + DISTANCE_BITS - STEP_BITS)).clamp(0, LAST_STEP);
        // 64 steps: the mask says that there is such a one.
        let factor = fog.curve.get(step as usize & LAST_STEP as usize).copied().unwrap_or(0);
        let factor = u32::from(factor).min(32);
        Some(<Self::Color as BlendedColor>::Layout::mixed(
            word,
            fog.color.to_word(),
            factor,
        ))
    }

    const BLENDS: bool = H::BLENDS;

    #[inline]
    fn is_translucent((skin, _): &Self::Skin<'_>) -> bool {
        H::is_translucent(skin)
    }

    #[inline(always)]
    fn blend(
        (skin, _): &Self::Skin<'_>,
        fragment: <H::Color as BandColor>::Word,
        behind: <H::Color as BandColor>::Word,
        position: Point,
    ) -> <H::Color as BandColor>::Word {
        H::blend(skin, fragment, behind, position)
    }
}

/// The number of the last step of a curve.
const LAST_STEP: i32 = (1 << STEP_BITS) - 1;
