//! Where something is and how it is turned.

use fixed::types::I16F16;

use crate::view::Rotation;

/// A rotation, then a translation in units of the models' vertices.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct Pose {
    /// The orientation of the object.
    pub rotation: Rotation,
    /// The position of the object's origin: x, y, z.
    pub translation: [I16F16; 3],
}

impl Pose {
    /// The pose at the origin, without rotation.
    pub const IDENTITY: Self = Self {
        rotation: Rotation::IDENTITY,
        translation: [I16F16::ZERO; 3],
    };

    /// The pose with this rotation, and then this translation.
    pub const fn new(rotation: Rotation, translation: [I16F16; 3]) -> Self {
        Self { rotation, translation }
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Pose {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(
            formatter,
            "{} at {}",
            self.rotation,
            self.translation.map(|coordinate| coordinate.to_num::<f32>())
        );
    }
}
