//! Shadings whose pictures are numbers: the index of the face that is seen at a pixel, or one of its texture coordinates.

use embedded_graphics::pixelcolor::{Rgb888, raw::RawU24};
use zrow::{
    geometry::TooSmall,
    scene::{Affine, Camera, FaceSet, Model, Pose},
    shade::{Perspective, Shading, Transformed},
};

use crate::space::input::{FACES, SpaceInput};

/// The plainest look: a colour a face.
pub type Plain = Rgb888;

/// A shading that small scenes can have.
pub trait SpaceShading: Shading<Color = Rgb888> + Sized {
    /// The model of a scene; it shows the first or the second number of its vertices, where it shows one.
    ///
    /// # Errors
    /// The scene lacks something.
    fn model<'a>(input: &'a SpaceInput, mesh: FaceSet<'a>, shown: usize) -> Result<Model<'a, Self>, TooSmall>;
}

/// Colours that name faces: the index, and 1 more.
static COLORS: [Rgb888; FACES] = {
    let mut colors = [Rgb888::new(0, 0, 0); FACES];
    let mut index = 0;
    while index < FACES {
        colors[index] = Rgb888::new(0, 0, index as u8 + 1);
        index += 1;
    }
    colors
};

/// The face that a word of a picture names.
pub fn face_of(word: u32) -> Option<usize> {
    let number = embedded_graphics::pixelcolor::IntoStorage::into_storage(Rgb888::from(RawU24::from(word)));
    number.checked_sub(1).map(|index| index as usize)
}

impl SpaceShading for Rgb888 {
    fn model<'a>(_: &'a SpaceInput, mesh: FaceSet<'a>, _: usize) -> Result<Model<'a, Self>, TooSmall> {
        Model::new(mesh, &COLORS)
    }
}

impl SpaceShading for Transformed<Rgb888> {
    fn model<'a>(_: &'a SpaceInput, mesh: FaceSet<'a>, _: usize) -> Result<Model<'a, Self>, TooSmall> {
        Model::with_skin(mesh, (COLORS.as_slice(), Affine::IDENTITY))
    }
}

/// Pairs of numbers of vertices, and which of both is shown.
#[derive(Debug, Clone, Copy)]
pub struct Coordinates<'a> {
    of_vertices: &'a [[i16; 2]],
    shown: usize,
}

/// Texture coordinates in perspective, divided at every `STEP`th pixel where they may be off by more than so many 1/4,096 of a
/// texture; the word of a pixel is one of both with 16 fractional bits.
#[derive(Debug)]
pub struct InSpace<const TOLERANCE: u16, const STEP: i32 = 16>;

impl<const TOLERANCE: u16, const STEP: i32> Shading for InSpace<TOLERANCE, STEP> {
    type Color = Rgb888;
    type Skin<'a> = Coordinates<'a>;
    type Uniforms = ();
    type Attributes = Perspective<2, STEP>;
    const TOLERANCE: u16 = TOLERANCE;

    fn uniforms(_: &Coordinates<'_>, _: &Pose, _: &Camera) {}

    #[inline]
    fn vertex(skin: &Coordinates<'_>, (): &(), vertex: usize, _: [i32; 3]) -> Perspective<2, STEP> {
        Perspective(skin.of_vertices.get(vertex).copied().unwrap_or_default())
    }

    #[inline(always)]
    fn fragment(skin: &Coordinates<'_>, _: u32, values: &[i32; 2]) -> Option<u32> {
        values.get(skin.shown).map(|value| *value as u32)
    }
}

impl<const TOLERANCE: u16, const STEP: i32> SpaceShading for InSpace<TOLERANCE, STEP> {
    fn model<'a>(input: &'a SpaceInput, mesh: FaceSet<'a>, shown: usize) -> Result<Model<'a, Self>, TooSmall> {
        let of_vertices = &input.coordinates;
        Model::with_skin(mesh, Coordinates { of_vertices, shown })
    }
}

/// Texture coordinates in perspective, divided at every pixel: of models that are moved along z alone.
///
/// Three numbers of 16 bits are interpolated evenly on the screen: both texture coordinates divided by the distance, and 1
/// divided by the distance. A fragment divides the first two by the third one.
#[derive(Debug)]
pub struct EveryPixel;

impl Shading for EveryPixel {
    type Color = Rgb888;
    /// And the least distance of a vertex.
    type Skin<'a> = (Coordinates<'a>, i32);
    type Uniforms = ();
    type Attributes = [i16; 3];

    fn uniforms(_: &Self::Skin<'_>, _: &Pose, _: &Camera) {}

    #[inline]
    fn vertex((skin, least): &Self::Skin<'_>, (): &(), vertex: usize, [_, _, z]: [i32; 3]) -> [i16; 3] {
        let [u, v] = skin.of_vertices.get(vertex).copied().unwrap_or_default();
        // 32,000 at the nearest vertex, and for the whole texture there.
        let nearness = 32_000 * least / z.max(1);
        let of = |coordinate: i16| (i32::from(coordinate) * nearness + 2_048) >> 12;
        [of(u), of(v), nearness].map(|number| number as i16)
    }

    #[inline(always)]
    fn fragment((skin, _): &Self::Skin<'_>, _: u32, values: &[i32; 3]) -> Option<u32> {
        let [u, v, nearness] = values.map(|value| value.max(0) as u32);
        let divisor = (nearness >> 12).max(1);
        // In 1/4,096 of the texture, below 2^15. Both, as a texture takes them.
        let coordinates = core::hint::black_box([u, v].map(|product| (product + divisor / 2) / divisor));
        coordinates.get(skin.shown).map(|coordinate| coordinate << 16)
    }
}

impl SpaceShading for EveryPixel {
    fn model<'a>(input: &'a SpaceInput, mesh: FaceSet<'a>, shown: usize) -> Result<Model<'a, Self>, TooSmall> {
        let of_vertices = &input.coordinates;
        let least = input.vertices.iter().map(|[.., z]| i32::from(*z)).min().unwrap_or(1);
        Model::with_skin(mesh, (Coordinates { of_vertices, shown }, least))
    }
}
