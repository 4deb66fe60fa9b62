//! The near plane as far away as the models allow: depths are then as fine as they can be, and no face is cut.

use fixed::types::I16F16;

use crate::{
    geometry::{InputError, Sub8},
    scene::{Model, prepare::affine_transform},
    shade::Shading,
    view::{Camera, EyeTransform, ToEye},
};

impl Camera {
    /// The camera with its near plane as far away as it may be in front of all vertices of some models, where they are and as
    /// the camera is turned now, at any precision of the look. Depths are as much finer as the near plane is farther away: with
    /// `u16` and faces at 2,000 units, 0.06 units instead of 7.6 where it goes from 8 units to 1,000.
    ///
    /// The distance is that of the nearest vertex, less 1/32,768 of the sum of the sizes of its coordinates and 1/256 unit,
    /// which is what coarse positions may be rounded by. Where there are no vertices, or none in front of the far plane and
    /// nearer than 32,768 units, the near plane stays.
    ///
    /// Cost: six multiplications a vertex.
    ///
    /// # Errors
    /// [`InputError::NearTooClose`] where a vertex is nearer than that plus 8 units or behind the camera: faces have to be cut there, and
    /// what is lost by that is for the program to say. [`InputError::ModelOutOfDomain`].
    pub fn near_for<H: Shading>(self, models: &[Model<'_, H>]) -> Result<Self, InputError> {
        let mut nearest = i32::MAX;
        for (index, model) in models.iter().enumerate() {
            nearest = nearest.min(if H::HAS_AFFINE_MAP {
                let transform = affine_transform(model, &self).ok_or(InputError::ModelOutOfDomain { model: index })?;
                nearest_of(model, &transform)
            } else {
                nearest_of(model, &EyeTransform::<Sub8>::new(&model.pose, self.pose()))
            });
        }
        let far = self.far().to_bits() >> 4;
        if nearest >= far {
            return Ok(self);
        }
        // In front of the far plane, so it fits.
        self.with_near(I16F16::from_bits(nearest.max(0) << 4))
    }
}

/// The least distance at which a vertex of a model may be seen, in 1/4096 unit.
fn nearest_of<H: Shading>(model: &Model<'_, H>, transform: &impl ToEye) -> i32 {
    let vertices = model.mesh().vertices().iter();
    let distances = vertices.map(|vertex| {
        let size = vertex
            .iter()
            .map(|coordinate| i32::from(coordinate.unsigned_abs()))
            .sum::<i32>();
        // Elements of 2.14 are rounded by 2^-15, the translation and the sum by less than 1/256 unit.
        transform.apply(*vertex).z - (size + 7) / 8 - 16
    });
    distances.min().unwrap_or(i32::MAX)
}
