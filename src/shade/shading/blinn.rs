//! Highlights: a polished surface mirrors a light, the sharper the smoother it is.
//!
//! ```text
//!          N   H              H halves the angle between the way to the light L and the way to the eye V;
//!      L   |  /    V          highlight = strength * light * cos(angle between N and H) ^ exponent
//!        \ | / ___/
//!     ----\|/-/----
//! ```
//!
//! Guarantees: a highlight is within 16 + 4 * exponent of the exact one, in 1/32,768, where light and eye are at least 256 units
//! away and in directions less than 150 degrees apart, measured over millions of random cases, most of them near the middle of
//! the highlight. At 32 units it may be 300/32,768 more, because positions in a model are rounded to 1/16 unit.
//!
//! Source: Blinn (1977), "Models of light reflection for computer synthesized pictures".

use core::num::NonZeroU32;

use fixed::types::U0F16;

use crate::{
    shade::{
        InstructionSet,
        shading::{
            lambert::{Lambert, ModelLights},
            lighting::{FULL, LIGHT_BITS, Lighting, ReflectedLight},
            point_light::{POSITION_BITS, Way, in_model},
        },
    },
    view::{Camera, Pose},
};

/// Lights whose diffuse reflection is that of [`Lambert`], with highlights where a surface mirrors them to the camera.
///
/// Highlights are white in [`Gouraud`](crate::shade::Gouraud) and [`FlatLit`](crate::shade::FlatLit) shading. Under textures,
/// they brighten texels up to their own colours.
///
/// A highlight is within 3.2 % of full light of the exact one at the greatest sharpness, and within 1/1,000 at the least, where
/// light and eye are at least 256 units away and in directions less than 150 degrees apart; at 32 units it may be 1 % more.
///
/// Cost: for each vertex that a light falls on, two roots, six divisions and about 30 multiplications a light.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Blinn<const LIGHTS: usize, const POINTS: usize = 0> {
    /// The lights, and the diffuse reflection.
    pub diffuse: Lambert<LIGHTS, POINTS>,
    /// How much of a light is mirrored.
    #[cfg_attr(feature = "defmt", defmt(Debug2Format))]
    pub strength: U0F16,
    /// How sharp highlights are: the exponent of the cosine is 2 to the power of this, at most 2^8.
    pub sharpness: u8,
}

/// Lights as a model sees them, and the eye.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MirroredLights<const LIGHTS: usize, const POINTS: usize> {
    diffuse: ModelLights<LIGHTS, POINTS>,
    /// Position of the camera in 1/16 of the vertices' unit.
    eye: [i32; 3],
    strength: i32,
    sharpness: u8,
}

impl<const LIGHTS: usize, const POINTS: usize> Lighting for Blinn<LIGHTS, POINTS> {
    type OfModel = MirroredLights<LIGHTS, POINTS>;

    #[inline]
    fn instructions(set: InstructionSet) -> u32 {
        let highlights = ((LIGHTS + POINTS) as u32).saturating_mul(set.of([2_100, 270]));
        Lambert::<LIGHTS, POINTS>::instructions(set).saturating_add(highlights)
    }

    fn seen_from(&self, pose: &Pose, camera: &Camera) -> MirroredLights<LIGHTS, POINTS> {
        MirroredLights {
            diffuse: self.diffuse.seen_from(pose, camera),
            eye: in_model(pose, &camera.pose().translation),
            strength: i32::from(self.strength.to_bits() >> 1),
            sharpness: self.sharpness.min(8),
        }
    }

    fn reflected(lights: &MirroredLights<LIGHTS, POINTS>, normal: [i32; 3], position: [i32; 3]) -> ReflectedLight {
        let mut highlights = 0;
        let to_eye = Way::new(lights.way_to_eye(position)).unit();
        for towards in &lights.diffuse.towards {
            let way = Way::new(*towards);
            // From 14 fractional bits.
            let brightness = (way.whole_length() << 1).min(FULL as u32);
            highlights += mirrored(way.unit(), to_eye, normal, lights.sharpness, brightness);
        }
        for point in &lights.diffuse.points {
            let way = Way::new(point.way(position));
            highlights += mirrored(way.unit(), to_eye, normal, lights.sharpness, point.brightness(&way));
        }
        let ReflectedLight { diffuse, .. } = Lambert::<LIGHTS, POINTS>::reflected(&lights.diffuse, normal, position);
        ReflectedLight {
            diffuse,
            specular: (highlights.min(FULL) * lights.strength) >> 15,
        }
    }
}

impl<const LIGHTS: usize, const POINTS: usize> MirroredLights<LIGHTS, POINTS> {
    /// The way from a position of the model to the camera, in 1/16 of the vertices' unit: below 2^29.
    fn way_to_eye(&self, position: [i32; 3]) -> [i32; 3] {
        let mut way = self.eye;
        for (way, coordinate) in way.iter_mut().zip(position) {
            *way -= coordinate << POSITION_BITS;
        }
        way
    }
}

/// How much of a light of some brightness a surface mirrors into the eye, in units of 1/32,768. Directions and the normal have
/// a length of 1 with 14 fractional bits.
fn mirrored(to_light: [i32; 3], to_eye: [i32; 3], normal: [i32; 3], sharpness: u8, brightness: u32) -> i32 {
    if dot(normal, to_light) <= 0 {
        return 0;
    }
    let ([x, y, z], [eye_x, eye_y, eye_z]) = (to_light, to_eye);
    let half = Way::new([x + eye_x, y + eye_y, z + eye_z]);
    let cosine = u32::try_from(dot(normal, half.direction)).unwrap_or(0);
    let cosine = NonZeroU32::new(half.length).map_or(0, |length| cosine / length);
    let mut power = (cosine << 1).min(FULL as u32);
    for _ in 0..sharpness {
        power = (power * power) >> LIGHT_BITS;
    }
    ((power * brightness) >> LIGHT_BITS) as i32
}

/// The product of two vectors of which one has a length of 2^14 and the other coordinates below 2^15: below 2^31.
fn dot([x, y, z]: [i32; 3], [other_x, other_y, other_z]: [i32; 3]) -> i32 {
    x * other_x + y * other_y + z * other_z
}

#[cfg(test)]
mod tests {
    use embedded_graphics::{
        geometry::{Point, Size},
        primitives::Rectangle,
    };
    use fixed::types::I16F16;

    use super::*;
    use crate::{
        cases::cases,
        shade::{
            PointLight,
            shading::double_vectors::{dot, unit},
        },
    };

    /// Light and eye as near as the bound allows and farther away, and normals from the middle of the highlight on.
    #[test]
    fn highlights_are_within_their_bound() {
        let mut state = 0x2545_f491u32;
        let mut next = || {
            // xorshift32 (Marsaglia 2003).
            state ^= state << 13;
            state ^= state >> 17;
            state ^= state << 5;
            f64::from(state as i32) / f64::from(1u32 << 31)
        };
        let area = Rectangle::new(Point::zero(), Size::new(64, 64));
        let lens = Camera::new(area, I16F16::from_num(128)).unwrap();
        let mut worst = 0.0f64;
        for round in 0..cases(200_000, 5_000_000) {
            let sharpness = (round % 9) as u8;
            let (distance, beside) = (
                [256.0, 1_024.0][(round / 9 % 2) as usize],
                [0.02, 0.4][(round / 18 % 2) as usize],
            );
            let position = [0; 3].map(|_: i32| (next() * 3_000.0) as i32);
            let mut place = || {
                let way = unit([next(), next(), next()]).map(|part| part * distance);
                let mut coordinates = position.iter().zip(way);
                [(); 3].map(|()| {
                    let (coordinate, part) = coordinates.next().unwrap();
                    I16F16::from_num(f64::from(*coordinate) + part * 1.01)
                })
            };
            let (of_light, of_eye) = (place(), place());
            let way = |to: [I16F16; 3]| [0, 1, 2].map(|axis| to[axis].to_num::<f64>() - f64::from(position[axis]));
            let (to_light, to_eye) = (unit(way(of_light)), unit(way(of_eye)));
            let half = unit([0, 1, 2].map(|axis| to_light[axis] + to_eye[axis]));
            let normal = unit(half.map(|part| part + next() * beside)).map(|part| (part * 16_384.0).round() as i32);
            let exact_normal = normal.map(|part| f64::from(part) / 16_384.0);
            // The cosine of 150 degrees.
            if dot(to_light, to_eye) < -0.866 || dot(exact_normal, to_light) < 0.01 {
                continue;
            }
            let blinn = Blinn {
                diffuse: Lambert {
                    ambient: U0F16::ZERO,
                    lights: [],
                    points: [PointLight {
                        position: of_light,
                        intensity: U0F16::MAX,
                        half_distance: u16::MAX,
                    }],
                },
                strength: U0F16::MAX,
                sharpness,
            };
            let camera = lens.with_pose(Pose {
                translation: of_eye,
                ..Pose::IDENTITY
            });
            let lights = blinn.seen_from(&Pose::IDENTITY, &camera);
            let found = Blinn::<0, 1>::reflected(&lights, normal, position).specular;
            let square = f64::from(u16::MAX).powi(2);
            let brightness = square / (square + dot(way(of_light), way(of_light)));
            let exponent = 1 << sharpness;
            let exact = 32_768.0 * brightness * dot(exact_normal, half).clamp(0.0, 1.0).powi(exponent);
            worst = worst.max((f64::from(found) - exact).abs() / (16.0 + 4.0 * f64::from(exponent)));
        }
        assert!(worst > 0.7 && worst <= 1.0, "{worst}");
    }
}
