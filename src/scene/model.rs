//! A model: a mesh, the skin that its shading takes, such as colours, normals or a texture, and its pose in the world.

use core::fmt;

use crate::{geometry::TooSmall, mesh::FaceSet, shade::Shading, surface::BandColor, view::Pose};

/// A face set, what its [`Shading`] takes, such as a colour for each face, and where it is.
///
/// `H` is the [`Shading`] of the scene's look; a colour, such as `Rgb565`, stands for one flat colour for each face. A pose
/// rotates and translates a model; one that is scaled or mirrored as well has a [`Transformed`](crate::shade::Transformed) shading.
///
/// Two models of one mesh, which lies in flash once:
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::I16F16;
/// use zrow::scene::{Camera, FaceSet, Memory, Model, Pose};
///
/// static SAIL: FaceSet = match FaceSet::new(&[[-300, -300, 0], [0, 300, 0], [300, -300, 0]], &[[0, 1, 2]]) {
///     Ok(faces) => faces,
///     Err(_) => panic!("a face names a vertex that is not there"),
/// };
/// let at = |x, z| Pose { translation: [x, 0, z].map(I16F16::from_num::<i32>), ..Pose::IDENTITY };
/// let models = [
///     Model::new(SAIL, &[Rgb565::RED])?.with_pose(at(-400, 1024)),
///     Model::new(SAIL, &[Rgb565::WHITE])?.with_pose(at(400, 1024)),
/// ];
/// let camera = Camera::new(Rectangle::new(Point::zero(), Size::new(64, 64)), I16F16::from_num(128))?;
/// let mut memory = Memory::<Rgb565, { 2 * SAIL.vertices().len() }, 2, 64, 64>::new();
/// let scene = memory.prepare(&camera, &models)?;
/// assert_eq!([20, 32, 44].map(|x| scene.face_at(Point::new(x, 32))), [Some(0), None, Some(1)]);
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
pub struct Model<'a, H: Shading> {
    /// The vertices and faces.
    mesh: FaceSet<'a>,
    /// What the shading takes beside the mesh, such as colours, normals or a texture.
    skin: H::Skin<'a>,
    /// The model's position and rotation in the world.
    pub pose: Pose,
}

impl<'a, C: BandColor> Model<'a, C> {
    /// A model at the origin, not rotated. Colours beyond the number of faces are not used.
    ///
    /// # Errors
    /// [`TooSmall`] with the number of faces, where there are fewer colours.
    pub const fn new(mesh: FaceSet<'a>, colors: &'a [C]) -> Result<Self, TooSmall> {
        let needed = mesh.faces().len();
        if colors.len() < needed {
            return Err(TooSmall::Colors(needed));
        }
        Ok(Self {
            mesh,
            skin: colors,
            pose: Pose::IDENTITY,
        })
    }

    /// The colours, in the order of the faces.
    pub const fn colors(&self) -> &'a [C] {
        self.skin
    }
}

impl<'a, H: Shading> Model<'a, H> {
    /// A model at the origin, not rotated, with what its shading takes beside the mesh.
    ///
    /// # Errors
    /// [`TooSmall`] where the skin has less than the mesh needs, with the number that it needs.
    pub fn with_skin(mesh: FaceSet<'a>, skin: H::Skin<'a>) -> Result<Self, TooSmall> {
        H::check(&skin, &mesh)?;
        Ok(Self {
            mesh,
            skin,
            pose: Pose::IDENTITY,
        })
    }

    /// A model of the same mesh and skin in another pose.
    #[must_use]
    pub fn with_pose(self, pose: Pose) -> Self {
        Self { pose, ..self }
    }

    /// The mesh of the model: its vertices and faces.
    pub const fn mesh(&self) -> &FaceSet<'a> {
        &self.mesh
    }

    /// The skin: what the model's shading takes beside the mesh, such as colours, normals or a texture.
    pub const fn skin(&self) -> &H::Skin<'a> {
        &self.skin
    }
}

impl<H: Shading> Model<'_, H> {
    /// Whether the affine map of its shading mirrors the model.
    #[inline]
    pub(super) fn is_mirrored(&self) -> bool {
        is_mirrored::<H>(&self.skin)
    }
}

/// Whether the affine map of a skin mirrors its model.
#[inline]
fn is_mirrored<H: Shading>(skin: &H::Skin<'_>) -> bool {
    H::HAS_AFFINE_MAP && H::affine(skin).is_mirrored()
}

/// The corners of a face of a model with this skin, in the order in which they run clockwise when it is seen from its outside:
/// that of the mesh, or the other way round where a map mirrors it.
#[inline]
pub(super) fn outward<H: Shading, T>(skin: &H::Skin<'_>, [a, b, c]: [T; 3]) -> [T; 3] {
    if is_mirrored::<H>(skin) { [a, c, b] } else { [a, b, c] }
}

impl<H: Shading> fmt::Debug for Model<'_, H> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut debug = formatter.debug_struct("Model");
        debug
            .field("mesh", &self.mesh)
            .field("pose", &self.pose)
            .finish_non_exhaustive()
    }
}

impl<H: Shading> Copy for Model<'_, H> {}

impl<H: Shading> Clone for Model<'_, H> {
    fn clone(&self) -> Self {
        *self
    }
}

#[cfg(feature = "defmt")]
impl<H: Shading> defmt::Format for Model<'_, H> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "Model of {} faces, {}", self.mesh.faces().len(), self.pose);
    }
}
