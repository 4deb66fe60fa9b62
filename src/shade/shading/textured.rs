//! Textures: each face has a piece of a picture, in perspective.
//!
//! Guarantees: texture coordinates are right at both ends of a span and at every 16th column, to within 1/4,096 of the texture
//! where the depths of a face differ by up to 100 times and it has no more than one texture (of a texture that repeats to so much
//! of a texture for each that it has), and step evenly in between; a face whose own planes are within 3/8 texel everywhere is drawn
//! without a division. A pixel has the nearest texel, or what a sampler makes of several. Cost of a pixel: two additions, a texel.
//!
//! Source: Catmull (1974), "A subdivision algorithm for computer display of curved surfaces".

use core::{fmt, marker::PhantomData};

use crate::{
    geometry::TooSmall,
    mesh::FaceSet,
    shade::{
        InstructionSet, Sampler, Shading, Texture,
        shading::{mapped::Mapped, perspective::Perspective},
        texture::{ImageOf, tolerance},
    },
    surface::BandColor,
    view::{Camera, Pose},
};

/// A picture on each face: of a [`Texture`], or of what a [`Sampler`] makes of one.
///
/// Texture coordinates are divided by the depth at every 16th pixel of a span, or at every `STEP`th ([`Perspective`]).
///
/// As a [`Look`](crate::scene::Look), or as the shading of one: `Whole<Textured<Texels<Rgb565, 64, 64>>>`, or with
/// divisions at every eighth pixel `Textured<Texels<Rgb565, 64, 64>, 8>`.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Textured<T, const STEP: i32 = 16>(PhantomData<T>);

/// What [`Textured`] shading takes beside a mesh.
pub struct TexturedSkin<'a, T: Sampler> {
    /// The picture.
    pub image: ImageOf<'a, T>,
    /// The texture coordinates of the vertices, in 1/4,096 of the texture: u to the right, v down. 0 to 4,096 is
    /// the whole texture.
    ///
    /// A vertex has one pair. Where faces that meet there need different ones, as at the corners of a cube whose sides show the whole
    /// texture each, the mesh has a vertex for each of them in the same place.
    pub coordinates: &'a [[i16; 2]],
}

impl<T: Sampler> Copy for TexturedSkin<'_, T> {}

impl<T: Sampler> Clone for TexturedSkin<'_, T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T: Sampler> fmt::Debug for TexturedSkin<'_, T> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut debug = formatter.debug_struct("TexturedSkin");
        debug.field("coordinates", &self.coordinates).finish_non_exhaustive()
    }
}

#[cfg(feature = "defmt")]
impl<T: Sampler> defmt::Format for TexturedSkin<'_, T> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "TexturedSkin {}", self.coordinates);
    }
}

impl<T: Sampler, const STEP: i32> Shading for Textured<T, STEP> {
    type Color = <T::Texture as Texture>::Color;
    type Skin<'a> = TexturedSkin<'a, T>;
    type Uniforms = ();
    type Attributes = Mapped<Perspective<2, STEP>, ()>;
    const TOLERANCE: u16 = tolerance::<T::Texture>();
    const HAS_HOLES: bool = T::HAS_HOLES;

    fn check(skin: &Self::Skin<'_>, mesh: &FaceSet<'_>) -> Result<(), TooSmall> {
        check_coordinates(skin.coordinates, mesh)
    }

    fn uniforms(_: &Self::Skin<'_>, _: &Pose, _: &Camera) {}

    #[inline]
    fn vertex(skin: &Self::Skin<'_>, (): &(), vertex: usize, _: [i32; 3]) -> Self::Attributes {
        Mapped::new(Perspective(skin.coordinates.get(vertex).copied().unwrap_or_default()))
    }

    #[inline]
    fn instructions(set: InstructionSet) -> [u32; 2] {
        [0, T::instructions(set)]
    }

    #[inline(always)]
    fn fragment(
        skin: &Self::Skin<'_>,
        _: <Self::Color as BandColor>::Word,
        coordinates: &[i32; 2],
    ) -> Option<<Self::Color as BandColor>::Word> {
        T::sample(&skin.image, *coordinates)
    }
}

/// Whether there are coordinates for all vertices.
pub(super) fn check_coordinates(coordinates: &[[i16; 2]], mesh: &FaceSet<'_>) -> Result<(), TooSmall> {
    let vertices = mesh.vertices().len();
    if coordinates.len() < vertices {
        Err(TooSmall::TextureCoordinates(vertices))
    } else {
        Ok(())
    }
}
