//! Models with the planes of their faces, of which faces that are turned away are left out before vertices are transformed.

use core::marker::PhantomData;

use embedded_graphics::geometry::Point;

use crate::{
    geometry::TooSmall,
    mesh::{BoundingVolume, FacePlanes, FaceSet},
    shade::{InstructionSet, Planes, Shading},
    surface::BandColor,
    view::{Affine, Camera, Pose},
};

/// The shading `H` of models with the planes of their faces: a face that is turned away for certain is left out by one comparison
/// with its plane, before any vertex is transformed, and a vertex that only such faces have is not transformed at all. The
/// picture is the same, bit for bit: where a face is so nearly on edge, or so small on the screen, that rounding may turn it
/// round, its corners on the screen decide as ever.
///
/// The skin of a model is that of `H` together with the planes of its mesh: `(skin, planes)`, which [`FacePlanes`] finds in a
/// `const`.
/// They must be those of the mesh: of one that was [moved](FaceSet::morphed) in between, faces may be missing in the picture, or
/// reach behind the far plane without being cut there.
/// Models of which some may be off the screen, nearer than the near plane or behind the far plane, and all models in looks that
/// are [`Transformed`](crate::shade::Transformed), [`DoubleSided`](crate::scene::DoubleSided) or
/// [`Unhurried`](crate::scene::Unhurried), are prepared as without planes.
///
/// Cost: four multiplications a face and 8 bytes of its table, instead of the vertices that are not transformed. Count whether that
/// pays (`cargo run --release -- measure --only teapot`): the Utah teapot with its 992 faces, drawn flat on a Cortex-M4, takes 509,401
/// instructions with planes and 496,261 without, of which preparing is 116,354 and 103,184; lit by its vertices 880,037 and 866,181.
///
/// Source: Roberts (1963), "Machine perception of three-dimensional solids"; with the eye in the model's axes, as in Blinn (1993),
/// "Backface culling snags".
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::I16F16;
/// use zrow::{
///     scene::{Camera, Counted, FacePlanes, FaceSet, Memory, Model},
///     shade::WithPlanes,
/// };
///
/// const VERTICES: [[i16; 3]; 4] = [[-300, -300, 300], [300, -300, 300], [0, 300, 300], [0, 0, -300]];
/// const FACES: [[u16; 3]; 4] = [[0, 1, 2], [0, 2, 3], [1, 3, 2], [0, 3, 1]];
/// static TABLE: [[i16; 4]; 4] = FacePlanes::find(&VERTICES, &FACES);
///
/// let mesh = FaceSet::new(&VERTICES, &FACES)?;
/// let planes = FacePlanes::new(&mesh, &TABLE)?;
/// let mut model = Model::<WithPlanes<Rgb565>>::with_skin(mesh, (&[Rgb565::RED; 4], planes))?;
/// model.pose.translation = [0, 0, 2000].map(I16F16::from_num::<i32>);
/// let models = [model];
/// let camera = Camera::new(Rectangle::new(Point::zero(), Size::new(64, 64)), I16F16::from_num(128))?;
/// let mut memory = Memory::<Counted<WithPlanes<Rgb565>>, 4, 4, 64, 64>::new();
/// // The side that is turned away from the viewer.
/// assert_eq!(memory.prepare(&camera, &models)?.counters().faces_culled_by_planes, 1);
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct WithPlanes<H>(PhantomData<H>);

impl<H: Shading> Shading for WithPlanes<H> {
    type Color = H::Color;
    type Skin<'a> = (H::Skin<'a>, FacePlanes<'a>);
    type Uniforms = H::Uniforms;
    type Attributes = H::Attributes;
    const TOLERANCE: <H::Attributes as Planes>::Tolerance = H::TOLERANCE;
    const HAS_HOLES: bool = H::HAS_HOLES;
    const HAS_AFFINE_MAP: bool = H::HAS_AFFINE_MAP;
    const BLENDS: bool = H::BLENDS;
    const HAS_BOUNDS: bool = H::HAS_BOUNDS;
    const HAS_PLANES: bool = true;

    fn check((skin, planes): &Self::Skin<'_>, mesh: &FaceSet<'_>) -> Result<(), TooSmall> {
        let faces = mesh.faces().len();
        if planes.table().len() < faces {
            return Err(TooSmall::Normals(faces));
        }
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
    fn bounds((skin, _): &Self::Skin<'_>) -> Option<BoundingVolume> {
        H::bounds(skin)
    }

    #[inline]
    fn planes<'a>((_, planes): &Self::Skin<'a>) -> Option<FacePlanes<'a>> {
        Some(*planes)
    }
}
