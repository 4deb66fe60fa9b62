//! Models with a box, a sphere or a cylinder around them, which take next to no time where nothing of them is seen.

use core::marker::PhantomData;

use embedded_graphics::geometry::Point;

use crate::{
    geometry::TooSmall,
    mesh::{BoundingBox, BoundingVolume, FacePlanes, FaceSet},
    shade::{InstructionSet, Planes, Shading},
    surface::BandColor,
    view::{Affine, Camera, Pose},
};

/// The shading `H` of models with bounds each, a [`BoundingBox`] or, as `B`, a [`BoundingSphere`](crate::scene::BoundingSphere)
/// or a [`BoundingCylinder`](crate::scene::BoundingCylinder): a model whose bounds are wholly beyond the near plane, the far
/// plane or one side of the picture is left out as a whole. None of its vertices is transformed or lit, and none of its faces
/// is looked at; it has its place in the memory nonetheless. The picture is the same, bit for bit.
///
/// What a model takes beside its mesh is that of `H` and its bounds: `(skin, bounds)`, in the unit and the axes of the vertices
/// ([`FaceSet::bounds`], `BoundingSphere::around`, best in a `const`). What is not within the bounds may be missing in
/// pictures. In looks whose faces are not cut ([`Whole`](crate::scene::Whole)) a model that is left out is no error, wherever
/// it is.
///
/// Cost: for a model that is seen, the transformation of one vertex and its comparison with six planes; for one that is left
/// out, or reaches into the picture from outside, three vertices more, and how far they reach towards each plane that the first
/// is beyond. RAM: 12 bytes a model, 10 for a sphere. A box around several models, as in a hierarchy of them, is asked for with
/// [`Camera::may_see`].
///
/// As a [`Look`](crate::scene::Look), or as the shading of one: `Whole<Bounded<Gouraud<Rgb565>>>`. With
/// [`Transformed`](crate::shade::Transformed) in any order; the bounds are those of the vertices before the map.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::I16F16;
/// use zrow::{
///     geometry::InputError,
///     scene::{BoundingBox, Camera, Counted, FaceSet, Memory, Model},
///     shade::Bounded,
/// };
///
/// const TRIANGLE: FaceSet = match FaceSet::new(&[[-10, -10, 0], [0, 10, 0], [10, -10, 0]], &[[0, 1, 2]]) {
///     Ok(faces) => faces,
///     Err(_) => panic!("a face names a vertex that is not there"),
/// };
/// const BOUNDS: BoundingBox = TRIANGLE.bounds();
///
/// let camera = Camera::new(Rectangle::new(Point::zero(), Size::new(64, 64)), I16F16::from_num(8))?;
/// let mut memory = Memory::<Counted<Bounded<Rgb565>>, 6, 2, 64, 64>::new();
/// let mut models = [Model::<Bounded<Rgb565>>::with_skin(TRIANGLE, (&[Rgb565::RED], BOUNDS))?; 2];
/// models[0].pose.translation = [0, 0, 40].map(I16F16::from_num::<i32>);
/// // At the same distance, but far to the right.
/// models[1].pose.translation = [200, 0, 40].map(I16F16::from_num::<i32>);
/// let scene = memory.prepare(&camera, &models)?;
/// assert_eq!(scene.counters().faces_culled_by_bounds, 1);
/// assert_eq!(scene.faces().count(), 1);
/// # Ok::<(), InputError>(())
/// ```
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bounded<H, B = BoundingBox>(PhantomData<(H, B)>);

impl<H: Shading, B: Copy + Into<BoundingVolume> + 'static> Shading for Bounded<H, B> {
    type Color = H::Color;
    type Skin<'a> = (H::Skin<'a>, B);
    type Uniforms = H::Uniforms;
    type Attributes = H::Attributes;
    const TOLERANCE: <H::Attributes as Planes>::Tolerance = H::TOLERANCE;
    const HAS_HOLES: bool = H::HAS_HOLES;
    const HAS_AFFINE_MAP: bool = H::HAS_AFFINE_MAP;
    const BLENDS: bool = H::BLENDS;
    const HAS_BOUNDS: bool = true;
    const HAS_PLANES: bool = H::HAS_PLANES;

    fn check((skin, _): &Self::Skin<'_>, mesh: &FaceSet<'_>) -> Result<(), TooSmall> {
        H::check(skin, mesh)
    }

    fn uniforms((skin, _): &Self::Skin<'_>, pose: &Pose, camera: &Camera) -> H::Uniforms {
        H::uniforms(skin, pose, camera)
    }

    #[inline]
    fn vertex((skin, _): &Self::Skin<'_>, uniforms: &H::Uniforms, vertex: usize, position: [i32; 3]) -> H::Attributes {
        H::vertex(skin, uniforms, vertex, position)
    }

    #[inline]
    fn face(
        (skin, _): &Self::Skin<'_>,
        uniforms: &H::Uniforms,
        mesh: &FaceSet<'_>,
        face: usize,
    ) -> Option<<H::Color as BandColor>::Word> {
        H::face(skin, uniforms, mesh, face)
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
    fn affine<'s>((skin, _): &'s Self::Skin<'_>) -> &'s Affine {
        H::affine(skin)
    }

    #[inline]
    fn transformed_vertex(
        (skin, _): &Self::Skin<'_>,
        uniforms: &H::Uniforms,
        normals: &Affine,
        vertex: usize,
        position: [i32; 3],
    ) -> H::Attributes {
        H::transformed_vertex(skin, uniforms, normals, vertex, position)
    }

    #[inline]
    fn transformed_face(
        (skin, _): &Self::Skin<'_>,
        uniforms: &H::Uniforms,
        maps: [&Affine; 2],
        mesh: &FaceSet<'_>,
        face: usize,
    ) -> Option<<H::Color as BandColor>::Word> {
        H::transformed_face(skin, uniforms, maps, mesh, face)
    }

    #[inline]
    fn bounds((_, bounds): &Self::Skin<'_>) -> Option<BoundingVolume> {
        Some((*bounds).into())
    }

    #[inline]
    fn planes<'a>((skin, _): &Self::Skin<'a>) -> Option<FacePlanes<'a>> {
        H::planes(skin)
    }
}
