//! Diffuse light: a surface is as bright as the cosine of the angle between its normal and the direction of the light.
//!
//! Source: Lambert (1760), "Photometria".

use fixed::types::{I16F16, U0F16};

use crate::{
    geometry::InputError,
    shade::{
        InstructionSet,
        shading::{
            lighting::{FULL, Lighting, ReflectedLight},
            point_light::{ModelPoint, PointLight, in_model},
        },
    },
    view::{Camera, Pose},
};

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

    /// Light that comes from where a vector of any length points to, in the axes of the world: x to the right, y up, z away
    /// from the viewer. A surface that faces it has the light's intensity.
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

/// Ambient light, and any number of lights from a direction and from a point.
///
/// A surface has the ambient light, and of each light its intensity times the cosine of the angle to its normal, if that is not
/// behind it; at most 1 together.
///
/// Cost: for each vertex, three multiplications a light from a direction; a root, two divisions and about 15 multiplications a
/// light from a point.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Lambert<const LIGHTS: usize, const POINTS: usize = 0> {
    /// The light that comes from everywhere.
    #[cfg_attr(feature = "defmt", defmt(Debug2Format))]
    pub ambient: U0F16,
    /// The lights from a direction.
    pub lights: [DirectionalLight; LIGHTS],
    /// The lights from a point.
    pub points: [PointLight; POINTS],
}

/// Lights as a model sees them: in its own axes.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ModelLights<const LIGHTS: usize, const POINTS: usize> {
    pub(super) ambient: i32,
    /// To where lights come from, times their intensities, with 14 fractional bits.
    pub(super) towards: [[i32; 3]; LIGHTS],
    pub(super) points: [ModelPoint; POINTS],
}

impl<const LIGHTS: usize, const POINTS: usize> Lighting for Lambert<LIGHTS, POINTS> {
    type OfModel = ModelLights<LIGHTS, POINTS>;
    const NEEDS_NORMALS: bool = LIGHTS + POINTS > 0;
    const NEEDS_POSITIONS: bool = POINTS > 0;

    #[inline]
    fn instructions(set: InstructionSet) -> u32 {
        (LIGHTS as u32)
            .saturating_mul(set.of([30, 25]))
            .saturating_add((POINTS as u32).saturating_mul(set.of([790, 175])))
    }

    fn seen_from(&self, pose: &Pose, _: &Camera) -> ModelLights<LIGHTS, POINTS> {
        let to_model = pose.rotation.inverse();
        ModelLights {
            ambient: i32::from(self.ambient.to_bits() >> 1),
            towards: self.lights.each_ref().map(|light| {
                to_model
                    .turned(&light.towards)
                    .map(|coordinate| ((coordinate + 2) >> 2) as i32)
            }),
            points: self.points.each_ref().map(|point| ModelPoint {
                position: in_model(pose, &point.position),
                light: *point,
            }),
        }
    }

    /// The light on a surface, within 8 units of the exact light, and 10 more for each light from a point, which is more where
    /// the light is near: [`PointLight`] says how much.
    #[inline(always)]
    fn reflected(lights: &ModelLights<LIGHTS, POINTS>, normal: [i32; 3], position: [i32; 3]) -> ReflectedLight {
        let [x, y, z] = normal;
        let mut sum = lights.ambient;
        for [light_x, light_y, light_z] in &lights.towards {
            // Two vectors of length 1 at most, in 2.14 each: the product is below 2^29.
            let cosine = (x * light_x + y * light_y + z * light_z) >> 13;
            sum += cosine.max(0);
        }
        for point in &lights.points {
            sum += point.on(normal, position);
        }
        ReflectedLight {
            diffuse: sum.min(FULL),
            specular: 0,
        }
    }
}
