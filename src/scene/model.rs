//! A face set with colours, somewhere in the world.

use crate::{geometry::TooSmall, mesh::FaceSet, view::Pose};

/// A face set, a colour for each of its faces, and where it is.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct Model<'a, C> {
    mesh: FaceSet<'a>,
    colors: &'a [C],
    /// The model's position and rotation in the world.
    pub pose: Pose,
}

impl<'a, C> Model<'a, C> {
    /// A model at the origin, not turned. Colours beyond the number of faces are not used.
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
            colors,
            pose: Pose::IDENTITY,
        })
    }

    /// A model of the same mesh and colours in another pose.
    #[must_use]
    pub fn with_pose(self, pose: Pose) -> Self {
        Self { pose, ..self }
    }

    /// The mesh of the model: its vertices and faces.
    pub const fn mesh(&self) -> &FaceSet<'a> {
        &self.mesh
    }

    /// The colours, in the order of the faces.
    pub const fn colors(&self) -> &'a [C] {
        self.colors
    }
}

#[cfg(feature = "defmt")]
impl<C> defmt::Format for Model<'_, C> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "Model of {} faces, {}", self.mesh.faces().len(), self.pose);
    }
}
