//! A texture under lights: what a texel reflects is as bright as the light at the vertices, and evenly between them.
//!
//! Guarantees: light has 32 steps; in full light each texel keeps its colour, and without light it is black.
//!
//! Cost of a pixel: three additions, a texel, a multiplication.

use core::marker::PhantomData;

use crate::{
    geometry::TooSmall,
    mesh::{FaceSet, normal, unit_normal},
    shade::{
        ChannelColor, Shading,
        layout::Layout,
        shading::{
            lambert::{LIGHT_BITS, Lambert, ModelLights},
            perspective::Perspective,
            textured::{check_coordinates, texel, tolerance},
        },
    },
    view::{Affine, Pose},
};

/// A texture of `WIDTH` x `HEIGHT` texels, powers of two, which repeats in both directions, under `LIGHTS` lights.
///
/// As a [`Look`](crate::scene::Look), or as the shading of one: `Whole<LitTextured<Rgb565, 64, 64>>`.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LitTextured<C, const WIDTH: usize, const HEIGHT: usize, const LIGHTS: usize = 1>(PhantomData<C>);

/// What [`LitTextured`] shading takes beside a mesh.
#[derive(Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LitTexturedSkin<'a, C: ChannelColor, const WIDTH: usize, const HEIGHT: usize, const LIGHTS: usize = 1> {
    /// The texels, row by row, as words of the colour ([`BandColor::to_word`](crate::surface::BandColor::to_word)).
    pub texels: &'a [[C::Word; WIDTH]; HEIGHT],
    /// The texture coordinates of the vertices, in 1/4,096 of the texture: u to the right, v down.
    pub coordinates: &'a [[i16; 2]],
    /// The normals of the vertices, on an octahedron: for a normal of length 1, x / s and y / s in 1/127, where s is |x| + |y| + |z|;
    /// where z is below 0, (1 - |y| / s) with the sign of x, and (1 - |x| / s) with the sign of y.
    pub normals: &'a [[i8; 2]],
    /// The lights.
    pub lights: Lambert<LIGHTS>,
}

impl<C: ChannelColor, const WIDTH: usize, const HEIGHT: usize, const LIGHTS: usize> Copy
    for LitTexturedSkin<'_, C, WIDTH, HEIGHT, LIGHTS>
{
}

impl<C: ChannelColor, const WIDTH: usize, const HEIGHT: usize, const LIGHTS: usize> Clone
    for LitTexturedSkin<'_, C, WIDTH, HEIGHT, LIGHTS>
{
    fn clone(&self) -> Self {
        *self
    }
}

/// Fractional bits of the light that a texel is multiplied with.
const FACTOR_BITS: u32 = 5;

impl<C: ChannelColor, const WIDTH: usize, const HEIGHT: usize, const LIGHTS: usize> Shading
    for LitTextured<C, WIDTH, HEIGHT, LIGHTS>
{
    type Color = C;
    type Skin<'a> = LitTexturedSkin<'a, C, WIDTH, HEIGHT, LIGHTS>;
    type Uniforms = ModelLights<LIGHTS>;
    type Attributes = Perspective<3>;
    const TOLERANCE: u16 = tolerance(WIDTH, HEIGHT);

    fn check(skin: &Self::Skin<'_>, mesh: &FaceSet<'_>) -> Result<(), TooSmall> {
        check_coordinates(skin.coordinates, mesh)?;
        let vertices = mesh.vertices().len();
        if skin.normals.len() < vertices {
            return Err(TooSmall::Normals(vertices));
        }
        Ok(())
    }

    fn uniforms(skin: &Self::Skin<'_>, pose: &Pose) -> ModelLights<LIGHTS> {
        skin.lights.seen_from(pose)
    }

    #[inline]
    fn vertex(skin: &Self::Skin<'_>, lights: &ModelLights<LIGHTS>, vertex: usize) -> Perspective<3> {
        skin.lit_vertex(vertex, |bytes| lights.on(unit_normal(bytes)))
    }

    #[inline]
    fn transformed_vertex(
        skin: &Self::Skin<'_>,
        lights: &ModelLights<LIGHTS>,
        normals: &Affine,
        vertex: usize,
    ) -> Perspective<3> {
        skin.lit_vertex(vertex, |bytes| lights.on(normals.unit_vector(normal(bytes))))
    }

    #[inline]
    fn face(_: &Self::Skin<'_>, _: &ModelLights<LIGHTS>, _: usize) -> Option<C::Word> {
        Some(C::Layout::narrow(0))
    }

    #[inline(always)]
    fn fragment(skin: &Self::Skin<'_>, _: C::Word, [u, v, light]: &[i32; 3]) -> C::Word {
        let light = (light >> (16 + LIGHT_FRACTION_BITS)).clamp(0, BRIGHTEST);
        let light = light as u32;
        // Both ends are exact: 0 and 32 of 32.
        C::Layout::scaled(texel(skin.texels, [*u, *v]), light + (light >> (FACTOR_BITS - 1)))
    }
}

impl<C: ChannelColor, const WIDTH: usize, const HEIGHT: usize, const LIGHTS: usize>
    LitTexturedSkin<'_, C, WIDTH, HEIGHT, LIGHTS>
{
    /// What varies from a vertex on, for the light on the two bytes of a normal.
    #[inline(always)]
    fn lit_vertex(&self, vertex: usize, light: impl FnOnce([i8; 2]) -> i32) -> Perspective<3> {
        let [u, v] = self.coordinates.get(vertex).copied().unwrap_or_default();
        let light = light(self.normals.get(vertex).copied().unwrap_or_default());
        let light = (light * BRIGHTEST) >> (LIGHT_BITS - LIGHT_FRACTION_BITS);
        // Half a step above, to be rounded to the nearest.
        Perspective([u, v, (light + (1 << (LIGHT_FRACTION_BITS - 1))) as i16])
    }
}

/// Fractional bits of the light's steps at the vertices: few, so that light, whose steps are coarse, seldom decides that a face is
/// divided.
const LIGHT_FRACTION_BITS: u32 = 3;

/// Full light at the vertices.
const BRIGHTEST: i32 = (1 << FACTOR_BITS) - 1;
