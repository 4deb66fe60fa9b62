//! Diffuse light: a surface is as bright as the cosine of the angle between its normal and the direction of the light.
//!
//! Source: Lambert (1760), "Photometria".

use fixed::types::{I16F16, U0F16};

use crate::{geometry::InputError, view::Pose};

/// Light from a direction, as from the sun: the same everywhere.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DirectionalLight {
    /// To where the light comes from, times its intensity.
    #[cfg_attr(feature = "defmt", defmt(Debug2Format))]
    towards: [I16F16; 3],
}

impl DirectionalLight {
    /// No light.
    pub const NONE: Self = Self {
        towards: [I16F16::ZERO; 3],
    };

    /// Light that comes from where a vector of any length points to, in the axes of the world: x to the right, y up, z away from
    /// the viewer. A surface that faces it has the light's intensity.
    ///
    /// # Errors
    /// [`InputError::NoDirection`] for a vector of length 0.
    pub const fn from_direction(towards: [I16F16; 3], intensity: U0F16) -> Result<Self, InputError> {
        let [x, y, z] = towards;
        let [mut x, mut y, mut z] = [x.to_bits() as i64, y.to_bits() as i64, z.to_bits() as i64];
        if x == 0 && y == 0 && z == 0 {
            return Err(InputError::NoDirection);
        }
        // The greatest coordinate from 2^30 on, so that the length has enough digits; three squares fit.
        while (x.unsigned_abs() | y.unsigned_abs() | z.unsigned_abs()) < 1 << 30 {
            (x, y, z) = (x << 1, y << 1, z << 1);
        }
        let length = ((x * x) as u64 + (y * y) as u64 + (z * z) as u64).isqrt();
        let intensity = intensity.to_bits();
        Ok(Self {
            towards: [
                part(x, intensity, length),
                part(y, intensity, length),
                part(z, intensity, length),
            ],
        })
    }
}

/// A coordinate of a vector of a length, as one of a vector as long as the intensity: rounded to the nearest 2^-16.
const fn part(coordinate: i64, intensity: u16, length: u64) -> I16F16 {
    let product = coordinate.unsigned_abs() * intensity as u64 + length / 2;
    let size = match product.checked_div(length) {
        Some(size) => size as i32,
        None => 0,
    };
    I16F16::from_bits(if coordinate < 0 { -size } else { size })
}

/// Ambient light, and any number of lights from a direction.
///
/// A surface has the ambient light, and of each light its intensity times the cosine of the angle to its normal, if that is not
/// behind it; at most 1 together.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Lambert<const LIGHTS: usize> {
    /// The light that comes from everywhere.
    #[cfg_attr(feature = "defmt", defmt(Debug2Format))]
    pub ambient: U0F16,
    /// The other lights.
    pub lights: [DirectionalLight; LIGHTS],
}

/// Fractional bits of a light.
pub(super) const LIGHT_BITS: u32 = 15;
/// Full light.
const FULL: i32 = 1 << LIGHT_BITS;

/// Lights as a model sees them: their directions in its own axes, in 2.14.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ModelLights<const LIGHTS: usize> {
    ambient: i32,
    towards: [[i32; 3]; LIGHTS],
}

impl<const LIGHTS: usize> Lambert<LIGHTS> {
    /// The lights in the axes of a model.
    pub(super) fn seen_from(&self, pose: &Pose) -> ModelLights<LIGHTS> {
        let to_model = pose.rotation.inverse();
        ModelLights {
            ambient: i32::from(self.ambient.to_bits() >> 1),
            towards: self.lights.each_ref().map(|light| {
                to_model
                    .turned(&light.towards)
                    .map(|coordinate| ((coordinate + 2) >> 2) as i32)
            }),
        }
    }
}

impl<const LIGHTS: usize> ModelLights<LIGHTS> {
    /// The light on a surface with a normal in 2.14, in units of 1/32,768: from 0 to 1, within 8 units of the exact one.
    #[inline]
    pub(super) fn on(&self, [x, y, z]: [i32; 3]) -> i32 {
        let mut sum = self.ambient;
        for [light_x, light_y, light_z] in &self.towards {
            // Two vectors of length 1 at most, in 2.14 each: the product is below 2^29.
            let cosine = (x * light_x + y * light_y + z * light_z) >> 13;
            sum += cosine.max(0);
        }
        sum.min(FULL)
    }
}
