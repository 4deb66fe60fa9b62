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

    /// The light on a surface, within 1 unit of the exact light, and 4 more for each light from a direction and 10 more for each
    /// light from a point, which is more where the light is near: [`PointLight`] says how much.
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

#[cfg(test)]
mod tests {
    use embedded_graphics::{
        geometry::{Point, Size},
        primitives::Rectangle,
    };

    use super::*;
    use crate::{
        cases::cases,
        shade::shading::double_vectors::{dot, unit},
        view::Rotation,
    };

    /// Each of many lights adds its rounding.
    fn check<const LIGHTS: usize>() {
        let mut state = 0x2545_f491u32;
        let mut next = || {
            // xorshift32 (Marsaglia 2003).
            state ^= state << 13;
            state ^= state >> 17;
            state ^= state << 5;
            state as i32
        };
        let area = Rectangle::new(Point::zero(), Size::new(64, 64));
        let camera = Camera::new(area, I16F16::from_num(128)).unwrap();
        let mut worst = 0.0f64;
        for _ in 0..cases(10_000, 200_000) {
            let directions = [0; LIGHTS].map(|_: i32| [next(), next(), next()]);
            // No more than full light together.
            let intensity = U0F16::from_bits(next() as u16 / LIGHTS as u16);
            let ambient = U0F16::from_bits(next() as u16 / 2);
            let angle = U0F16::from_bits(next() as u16);
            let rotation = Rotation::about([next(), next(), next()].map(I16F16::from_bits), angle).unwrap();
            let normal = unit([next(), next(), next()].map(f64::from)).map(|part| (part * 16_384.0).round() as i32);
            let lights = Lambert {
                ambient,
                lights: directions
                    .map(|way| DirectionalLight::from_direction(way.map(I16F16::from_bits), intensity).unwrap()),
                points: [],
            };
            let lights = lights.seen_from(&Pose::new(rotation, [I16F16::ZERO; 3]), &camera);
            let found = Lambert::<LIGHTS, 0>::reflected(&lights, normal, [0; 3]).diffuse;
            let normal = normal.map(|part| f64::from(part) / 16_384.0);
            let matrix = rotation.matrix().map(|row| row.map(|part| part.to_num::<f64>()));
            let in_world = matrix.map(|row| dot(row, normal));
            let cosines = directions.map(|way| dot(unit(way.map(f64::from)), in_world).max(0.0));
            let exact = ambient.to_num::<f64>() + intensity.to_num::<f64>() * cosines.iter().sum::<f64>();
            worst = worst.max((f64::from(found) - exact.min(1.0) * 32_768.0).abs());
        }
        assert!(worst <= 1.0 + 4.0 * LIGHTS as f64, "{worst}");
        assert!(worst > LIGHTS as f64 / 2.0, "{worst}");
    }

    #[test]
    fn light_from_directions_is_within_its_bound() {
        check::<1>();
        check::<4>();
        check::<16>();
    }
}
