//! Textures: each face has a piece of a picture, in perspective.
//!
//! Guarantees: texture coordinates are right at both ends of a span and at every 16th column, to within 1/4,096 of the texture
//! where the depths of a face differ by up to 100 times, and step evenly in between; a face whose own planes are within 1/4
//! texel everywhere is drawn without a division. A pixel has the nearest texel. Cost of a pixel: two additions, a texel.
//!
//! Source: Catmull (1974), "A subdivision algorithm for computer display of curved surfaces".

use core::marker::PhantomData;

use crate::{
    geometry::TooSmall,
    mesh::FaceSet,
    shade::{Shading, shading::perspective::Perspective},
    surface::{BandColor, PixelWord},
    view::Pose,
};

/// A texture of `WIDTH` x `HEIGHT` texels, powers of two, which repeats in both directions.
///
/// As a [`Look`](crate::scene::Look), or as the shading of one: `Whole<Textured<Rgb565, 64, 64>>`.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Textured<C, const WIDTH: usize, const HEIGHT: usize>(PhantomData<C>);

/// What [`Textured`] shading takes beside a mesh.
#[derive(Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TexturedSkin<'a, C: BandColor, const WIDTH: usize, const HEIGHT: usize> {
    /// The texels, row by row, as words of the colour ([`BandColor::to_word`]).
    pub texels: &'a [[C::Word; WIDTH]; HEIGHT],
    /// The texture coordinates of the vertices, in 1/4,096 of the texture: u to the right, v down.
    pub coordinates: &'a [[i16; 2]],
}

impl<C: BandColor, const WIDTH: usize, const HEIGHT: usize> Copy for TexturedSkin<'_, C, WIDTH, HEIGHT> {}

impl<C: BandColor, const WIDTH: usize, const HEIGHT: usize> Clone for TexturedSkin<'_, C, WIDTH, HEIGHT> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<C: BandColor, const WIDTH: usize, const HEIGHT: usize> Shading for Textured<C, WIDTH, HEIGHT> {
    type Color = C;
    type Skin<'a> = TexturedSkin<'a, C, WIDTH, HEIGHT>;
    type Uniforms = ();
    type Attributes = Perspective<2>;
    const TOLERANCE: u16 = tolerance(WIDTH, HEIGHT);

    fn check(skin: &Self::Skin<'_>, mesh: &FaceSet<'_>) -> Result<(), TooSmall> {
        check_coordinates(skin.coordinates, mesh)
    }

    fn uniforms(_: &Self::Skin<'_>, _: &Pose) {}

    #[inline]
    fn vertex(skin: &Self::Skin<'_>, (): &(), vertex: usize) -> Perspective<2> {
        Perspective(skin.coordinates.get(vertex).copied().unwrap_or_default())
    }

    #[inline]
    fn face(_: &Self::Skin<'_>, (): &(), _: usize) -> Option<C::Word> {
        Some(C::Word::ZERO)
    }

    #[inline(always)]
    fn fragment(skin: &Self::Skin<'_>, _: C::Word, coordinates: &[i32; 2]) -> C::Word {
        texel(skin.texels, *coordinates)
    }
}

/// How far texture coordinates may be off, in 1/4,096 of a texture: 1/4 texel.
pub(super) const fn tolerance(width: usize, height: usize) -> u16 {
    assert!(
        width.is_power_of_two() && height.is_power_of_two() && width <= 4096 && height <= 4096,
        "width and height of a texture must be powers of two and at most 4,096"
    );
    let larger = if width > height { width } else { height };
    (4096 / 4 / larger) as u16
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

/// The texel at coordinates in 1/4,096 of the texture, with 16 fractional bits.
#[inline(always)]
pub(super) fn texel<W: PixelWord, const WIDTH: usize, const HEIGHT: usize>(
    texels: &[[W; WIDTH]; HEIGHT],
    [u, v]: [i32; 2],
) -> W {
    // Powers of two, so that a mask is the remainder, and the index is inside.
    let column = (u >> (28 - WIDTH.ilog2())) as usize & (WIDTH - 1);
    let row = (v >> (28 - HEIGHT.ilog2())) as usize & (HEIGHT - 1);
    texels
        .get(row)
        .and_then(|row| row.get(column))
        .copied()
        .unwrap_or(W::ZERO)
}
