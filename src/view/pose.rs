//! Where something is and how it is turned.

use fixed::types::I16F16;

use crate::view::Rotation;

/// A rotation, then a translation in units of the models' vertices.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct Pose {
    /// How it is turned.
    pub rotation: Rotation,
    /// Where its origin is: x, y, z.
    pub translation: [I16F16; 3],
}

impl Pose {
    /// At the origin, not turned.
    pub const IDENTITY: Self = Self {
        rotation: Rotation::IDENTITY,
        translation: [I16F16::ZERO; 3],
    };

    /// A pose.
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
