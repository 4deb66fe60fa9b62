//! A texture under lights: what a texel reflects is as bright as the light at the vertices, and evenly between them.
//!
//! Guarantees: light has 32 steps; in full light each texel keeps its colour, and without light it is black.
//!
//! Cost of a pixel: three additions, a texel, a multiplication.

use core::{fmt, marker::PhantomData};

use crate::{
    geometry::TooSmall,
    mesh::{FaceSet, normal, unit_normal},
    shade::{
        BlendedColor, ChannelColor, InstructionSet, Sampler, Shading, Texture,
        layout::Layout,
        shading::{
            lambert::Lambert,
            lighting::{FULL, LIGHT_BITS, Lighting, ReflectedLight},
            mapped::Mapped,
            perspective::Perspective,
            textured::check_coordinates,
        },
        texture::{ImageOf, tolerance},
    },
    surface::BandColor,
    view::{Affine, Camera, Pose},
};

/// A picture on each face, of a [`Texture`] or of what a [`Sampler`] makes of one, under lights ([`Lighting`]).
///
/// Texture coordinates and light are divided by the depth at every 16th pixel of a span, or at every `STEP`th
/// ([`Perspective`]).
///
/// As a [`Look`](crate::scene::Look), or as the shading of one: `Whole<LitTextured<Texels<Rgb565, 64, 64>>>`.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LitTextured<T, L = Lambert<1>, const STEP: i32 = 16>(PhantomData<(T, L)>);

/// What [`LitTextured`] shading takes beside a mesh.
pub struct LitTexturedSkin<'a, T: Sampler, L = Lambert<1>> {
    /// The picture.
    pub image: ImageOf<'a, T>,
    /// The texture coordinates of the vertices, in 1/4,096 of the texture: u to the right, v down.
    pub coordinates: &'a [[i16; 2]],
    /// The normals of the vertices, on an octahedron: for a normal of length 1, x / s and y / s in 1/127, where s is |x| +
    /// |y| + |z|; where z is below 0, (1 - |y| / s) with the sign of x, and (1 - |x| / s) with the sign of y.
    /// A coordinate of 0 has either sign.
    pub normals: &'a [[i8; 2]],
    /// The lights.
    pub lights: L,
}

impl<T: Sampler, L: Copy> Copy for LitTexturedSkin<'_, T, L> {}

impl<T: Sampler, L: Copy> Clone for LitTexturedSkin<'_, T, L> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T: Sampler, L: fmt::Debug> fmt::Debug for LitTexturedSkin<'_, T, L> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut debug = formatter.debug_struct("LitTexturedSkin");
        debug.field("coordinates", &self.coordinates);
        debug.field("normals", &self.normals);
        debug.field("lights", &self.lights).finish_non_exhaustive()
    }
}

#[cfg(feature = "defmt")]
impl<T: Sampler, L: defmt::Format> defmt::Format for LitTexturedSkin<'_, T, L> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(
            formatter,
            "LitTexturedSkin {} normals {} under {}",
            self.coordinates,
            self.normals,
            self.lights
        );
    }
}

/// Fractional bits of the light that a texel is multiplied with.
const FACTOR_BITS: u32 = 5;

impl<T, L: Lighting, const STEP: i32> Shading for LitTextured<T, L, STEP>
where
    T: Sampler<Texture: Texture<Color: ChannelColor>>,
{
    type Color = <T::Texture as Texture>::Color;
    type Skin<'a> = LitTexturedSkin<'a, T, L>;
    type Uniforms = L::OfModel;
    type Attributes = Mapped<Perspective<3, STEP>, [i16; 1]>;
    const TOLERANCE: u16 = tolerance::<T::Texture>();
    const HAS_HOLES: bool = T::HAS_HOLES;

    fn check(skin: &Self::Skin<'_>, mesh: &FaceSet<'_>) -> Result<(), TooSmall> {
        check_coordinates(skin.coordinates, mesh)?;
        let vertices = mesh.vertices().len();
        if skin.normals.len() < vertices {
            return Err(TooSmall::Normals(vertices));
        }
        Ok(())
    }

    fn uniforms(skin: &Self::Skin<'_>, pose: &Pose, camera: &Camera) -> L::OfModel {
        skin.lights.seen_from(pose, camera)
    }

    #[inline]
    fn vertex(skin: &Self::Skin<'_>, lights: &L::OfModel, vertex: usize, position: [i32; 3]) -> Self::Attributes {
        skin.lit_vertex(vertex, |bytes| L::reflected(lights, unit_normal(bytes), position))
    }

    #[inline]
    fn transformed_vertex(
        skin: &Self::Skin<'_>,
        lights: &L::OfModel,
        normals: &Affine,
        vertex: usize,
        position: [i32; 3],
    ) -> Self::Attributes {
        skin.lit_vertex(vertex, |bytes| {
            L::reflected(lights, normals.unit_vector(normal(bytes)), position)
        })
    }

    #[inline]
    fn instructions(set: InstructionSet) -> [u32; 2] {
        [0, T::instructions(set).saturating_add(set.of([15, 10]))]
    }

    #[inline(always)]
    fn fragment(
        skin: &Self::Skin<'_>,
        _: <Self::Color as BandColor>::Word,
        [u, v, light]: &[i32; 3],
    ) -> Option<<Self::Color as BandColor>::Word> {
        let light = (light >> (16 + LIGHT_FRACTION_BITS)).clamp(0, BRIGHTEST);
        let light = light as u32;
        let texel = T::sample(&skin.image, [*u, *v])?;
        // Both ends are exact: 0 and 32 of 32.
        Some(<Self::Color as BlendedColor>::Layout::scaled(
            texel,
            light + (light >> (FACTOR_BITS - 1)),
        ))
    }
}

impl<T: Sampler, L> LitTexturedSkin<'_, T, L> {
    /// What varies from a vertex on, for the light on the two bytes of a normal.
    #[inline(always)]
    fn lit_vertex<const STEP: i32>(
        &self,
        vertex: usize,
        light: impl FnOnce([i8; 2]) -> ReflectedLight,
    ) -> Mapped<Perspective<3, STEP>, [i16; 1]> {
        let [u, v] = self.coordinates.get(vertex).copied().unwrap_or_default();
        let ReflectedLight { diffuse, specular } = light(self.normals.get(vertex).copied().unwrap_or_default());
        let light = ((diffuse + specular).min(FULL) * BRIGHTEST) >> (LIGHT_BITS - LIGHT_FRACTION_BITS);
        // Half a step above, to be rounded to the nearest.
        Mapped::new(Perspective([u, v, (light + (1 << (LIGHT_FRACTION_BITS - 1))) as i16]))
    }
}

/// Fractional bits of the light's steps at the vertices: few, so that light, whose steps are coarse, seldom decides that a face
/// is divided.
const LIGHT_FRACTION_BITS: u32 = 3;

/// Full light at the vertices.
const BRIGHTEST: i32 = (1 << FACTOR_BITS) - 1;
