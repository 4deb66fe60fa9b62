//! Light on the side of a surface that is seen.
//!
//! A normal that points away from the camera is turned round: its surface is seen from behind.
//!
//! Source: faceforward() of the RenderMan shading language (Upstill 1990, "The RenderMan companion"); two-sided lighting as in
//! OpenGL (Segal, Akeley 1994).

use crate::{
    shade::{
        InstructionSet,
        shading::{
            lighting::{Lighting, ReflectedLight},
            point_light::{POSITION_BITS, in_model},
        },
    },
    view::{Camera, Pose},
};

/// The lights `L` on surfaces that are seen from both sides: where a normal points away from the camera, the light is that on
/// the other side. For looks that are [`DoubleSided`](crate::scene::DoubleSided); what is seen from the front has the light
/// that it has without.
///
/// Sides are told by the normals: of a face in [`FlatLit`](crate::shade::FlatLit) shading, of each vertex elsewhere. A smooth
/// surface has both sides along its silhouette, where the light changes from vertex to vertex. Where rays are parallel
/// ([`Orthographic`](crate::scene::Orthographic)) sides are those that are seen from the position of the camera.
///
/// Cost: three long multiplications a vertex, or a face where each has one normal. RAM: 12 bytes.
///
/// ```
/// use embedded_graphics::{pixelcolor::Gray8, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::{I16F16, U0F16};
/// use zrow::{
///     band::Band,
///     scene::{Camera, DoubleSided, FaceSet, Memory, Model, Pose, Rotation},
///     shade::{DirectionalLight, FlatLit, FlatLitSkin, Lambert, TwoSided},
/// };
///
/// type Paper = FlatLit<Gray8, TwoSided<Lambert<1>>>;
///
/// let vector = |x, y, z| [x, y, z].map(I16F16::from_num::<i32>);
/// let mesh = FaceSet::new(&[[-512, -512, 0], [0, 512, 0], [512, -512, 0]], &[[0, 1, 2]])?;
/// // The light is where the camera is.
/// let light = DirectionalLight::from_direction(vector(0, 0, -1), U0F16::from_num(0.5))?;
/// let lights = TwoSided(Lambert { ambient: U0F16::ZERO, lights: [light], points: [] });
/// // The normal of the front is that of its outside: towards -z.
/// let skin = FlatLitSkin { colors: &[Gray8::WHITE], normals: &[[127, 127]], lights };
/// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
/// let camera = Camera::new(area, I16F16::from_num(128))?;
/// let mut memory = Memory::<DoubleSided<Paper>, 3, 1, 64, 64>::new();
/// for turns in [0.0, 0.5] {
///     let pose = Pose::new(Rotation::about_y(U0F16::from_num(turns)), vector(0, 0, 1024));
///     let models = [Model::<Paper>::with_skin(mesh, skin)?.with_pose(pose)];
///     let mut words = [0; 64 * 64];
///     let mut band = Band::<Gray8>::new(area, &mut words)?;
///     memory.prepare(&camera, &models)?.draw(&mut band);
///     assert!((127..=128).contains(&band.words()[32 * 64 + 32]));
/// }
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TwoSided<L>(pub L);

impl<L: Lighting> Lighting for TwoSided<L> {
    /// The lights, and the camera in 1/16 of the vertices' unit, as a model sees them.
    type OfModel = (L::OfModel, [i32; 3]);
    const NEEDS_NORMALS: bool = L::NEEDS_NORMALS;
    const NEEDS_POSITIONS: bool = L::NEEDS_NORMALS || L::NEEDS_POSITIONS;

    #[inline]
    fn instructions(set: InstructionSet) -> u32 {
        L::instructions(set).saturating_add(set.of([200, 60]))
    }

    fn seen_from(&self, pose: &Pose, camera: &Camera) -> Self::OfModel {
        (
            self.0.seen_from(pose, camera),
            in_model(pose, &camera.pose().translation),
        )
    }

    #[inline(always)]
    fn reflected((lights, eye): &Self::OfModel, normal: [i32; 3], position: [i32; 3]) -> ReflectedLight {
        let ways = eye.iter().zip(position);
        let ways = ways.map(|(eye, coordinate)| eye - (coordinate << POSITION_BITS));
        // Ways below 2^30, and a vector of length 1 in 2.14.
        let products = normal
            .iter()
            .zip(ways)
            .map(|(part, way)| i64::from(*part) * i64::from(way));
        let is_seen_from_behind = products.sum::<i64>() < 0;
        let normal = normal.map(|part| if is_seen_from_behind { -part } else { part });
        L::reflected(lights, normal, position)
    }
}
