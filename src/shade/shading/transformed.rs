//! Models that an affine map makes larger, stretches, shears or mirrors before their poses move them.
//!
//! Light stays right: the normals of a model go through the inverse transpose of its map, and are made as long as 1 again.

use core::marker::PhantomData;

use embedded_graphics::geometry::Point;

use crate::{
    geometry::TooSmall,
    mesh::{BoundingVolume, FacePlanes, FaceSet},
    shade::{InstructionSet, Planes, Shading},
    surface::BandColor,
    view::{Affine, Camera, Pose},
};

/// The shading `H` of models that an [`Affine`] map changes before their poses turn and move them.
///
/// What a model takes beside its mesh is that of `H` and its map: `(skin, map)`. A vertex costs three long multiplications a
/// coordinate instead of short ones; the normal of a vertex or a face that is lit a square root and three divisions of 32 bits.
/// Coordinates in eye space are within 2^-12 units and 2^-25 times the sum of the sizes of the vertex' coordinates; normals
/// within 2 units of 1/16,384 of the exact directions. Lights from points, highlights and fog see a vertex in the nearest whole
/// unit to where its map takes it: where these are to be as exact as for a posed model, the unit of the world is small beside
/// their distances. Shadings that are posed alone cost what they do without this type.
///
/// A map that mirrors turns outsides into outsides: the corners of its faces run the other way, and the second and the third
/// are exchanged, so that what was seen from the front still is. A map to a plane leaves faces on it; light on it comes from
/// the side that its normals point to, where they point to one.
///
/// As a [`Look`](crate::scene::Look), or as the shading of one: `Whole<Transformed<Gouraud<Rgb565>>>`. Not around itself:
/// compose the maps ([`Affine::then`]).
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::{I8F24, I16F16};
/// use zrow::{
///     geometry::InputError,
///     scene::{Affine, Camera, FaceSet, Memory, Model},
///     shade::Transformed,
/// };
///
/// type Scene = Transformed<Rgb565>;
///
/// let camera = Camera::new(Rectangle::new(Point::zero(), Size::new(64, 64)), I16F16::from_num(128))?;
/// let mesh = FaceSet::new(&[[-10, -10, 0], [0, 10, 0], [10, -10, 0]], &[[0, 1, 2]])?;
/// let mut memory = Memory::<Scene, 3, 1, 64, 64>::new();
/// // 60 times as wide, 30 times as high.
/// let map = Affine::scaled([60, 30, 1].map(I8F24::from_num::<i32>));
/// let mut model = Model::<Scene>::with_skin(mesh, (&[Rgb565::RED], map))?;
/// model.pose.translation = [0, 0, 1024].map(I16F16::from_num::<i32>);
/// let models = [model];
/// let scene = memory.prepare(&camera, &models)?;
/// let corner = |index: usize| scene.faces().next().map(|face| face.corners[index].point);
/// // 600 / 1,024 of a focal length of 32 pixels from the middle, which is between two pixels: in 1/16 pixel.
/// assert_eq!(corner(2).map(|point| point.x_units()), Some(504 + 300));
/// # Ok::<(), InputError>(())
/// ```
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Transformed<H>(PhantomData<H>);

impl<H: Shading> Shading for Transformed<H> {
    type Color = H::Color;
    type Skin<'a> = (H::Skin<'a>, Affine);
    /// Those of the shading, with lights as the posed model sees them, and the map of normals.
    type Uniforms = (H::Uniforms, Affine);
    type Attributes = H::Attributes;
    const TOLERANCE: <H::Attributes as Planes>::Tolerance = H::TOLERANCE;
    const HAS_HOLES: bool = H::HAS_HOLES;
    const BLENDS: bool = H::BLENDS;
    const HAS_BOUNDS: bool = H::HAS_BOUNDS;
    const HAS_PLANES: bool = H::HAS_PLANES;
    const HAS_AFFINE_MAP: bool = {
        assert!(
            !H::HAS_AFFINE_MAP,
            "compose the maps instead of Transformed around Transformed"
        );
        true
    };

    fn check((skin, _): &Self::Skin<'_>, mesh: &FaceSet<'_>) -> Result<(), TooSmall> {
        H::check(skin, mesh)
    }

    fn uniforms((skin, affine): &Self::Skin<'_>, pose: &Pose, camera: &Camera) -> Self::Uniforms {
        (H::uniforms(skin, pose, camera), affine.normals())
    }

    #[inline]
    fn vertex(
        (skin, affine): &Self::Skin<'_>,
        (uniforms, normals): &Self::Uniforms,
        vertex: usize,
        position: [i32; 3],
    ) -> H::Attributes {
        H::transformed_vertex(skin, uniforms, normals, vertex, affine.position(position))
    }

    #[inline]
    fn face(
        (skin, affine): &Self::Skin<'_>,
        (uniforms, normals): &Self::Uniforms,
        mesh: &FaceSet<'_>,
        face: usize,
    ) -> Option<<H::Color as BandColor>::Word> {
        H::transformed_face(skin, uniforms, [affine, normals], mesh, face)
    }

    #[inline]
    fn instructions(set: InstructionSet) -> [u32; 2] {
        H::instructions(set)
    }

    #[inline(always)]
    fn fragment(
        (skin, _): &Self::Skin<'_>,
        face: <H::Color as BandColor>::Word,
        attributes: &<H::Attributes as Planes>::Values,
    ) -> Option<<H::Color as BandColor>::Word> {
        H::fragment(skin, face, attributes)
    }

    #[inline]
    fn affine<'s>((_, affine): &'s Self::Skin<'_>) -> &'s Affine {
        affine
    }

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

    #[inline]
    fn bounds((skin, _): &Self::Skin<'_>) -> Option<BoundingVolume> {
        H::bounds(skin)
    }

    #[inline]
    fn planes<'a>((skin, _): &Self::Skin<'a>) -> Option<FacePlanes<'a>> {
        H::planes(skin)
    }
}
