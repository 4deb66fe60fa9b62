//! Ways to the sine and the cosine of an angle: one entry each, for the desktop and the chips.

use core::f64::consts::FRAC_PI_2;

use fixed::types::{I2F30, U0F16};
use micromath::F32Ext;
use zrow::scene::Rotation;

/// A way to the sine and the cosine of an angle.
#[derive(Debug, Clone, Copy)]
pub struct Trigonometry {
    /// The name of this entry in the report's tables.
    pub name: &'static str,
    /// The name of this entry in what the firmware on the emulated chips reports.
    pub variant: &'static str,
    /// Bytes of tables, which lie in flash.
    pub table_bytes: usize,
    /// Sine and cosine in 2.30 of an angle in 1/65,536 of a turn.
    pub sine_cosine: fn(u16) -> [i32; 2],
}

/// Calls a macro with `[variant] [function] name, bytes of tables;` of each way to the sine and the cosine of an angle.
#[macro_export]
macro_rules! trigonometry {
    ($with:ident) => {
        $with! {
            [sine_polynomial] [$crate::polynomial] "zrow's polynomial", 20;
            [sine_micromath] [$crate::micromath] "micromath, f32", 0;
            [sine_libm] [$crate::libm_single] "libm, f32", 0;
            [sine_table] [$crate::nearest_entry] "table of 129", 258;
            [sine_interpolated] [$crate::interpolated_entry] "table of 129, interpolated", 258;
            [sine_cordic_16] [$crate::cordic::<16>] "CORDIC, 16 steps", 64;
            [sine_cordic_30] [$crate::cordic::<30>] "CORDIC, 30 steps", 120;
        }
    };
}

macro_rules! list {
    ($([$variant:ident] [$($function:tt)+] $name:literal, $bytes:literal;)+) => {
        /// Every way to the sine and the cosine of an angle.
        pub const TRIGONOMETRY: &[Trigonometry] = &[$(Trigonometry {
            name: $name,
            variant: stringify!($variant),
            table_bytes: $bytes,
            sine_cosine: $($function)+,
        }),+];
    };
}
trigonometry!(list);

/// What the chips report the counts of sines and cosines as.
pub const TRIGONOMETRY_COUNT: &str = "trigonometry";

/// Units of an angle in a quarter of a turn.
const QUARTER: u16 = 1 << 14;
const ONE: f32 = (1u32 << 30) as f32;

/// The library's own: a polynomial of degree 9 in fixed point, as a rotation has it.
pub fn polynomial(angle: u16) -> [i32; 2] {
    let rotation = Rotation::about_z(U0F16::from_bits(angle));
    let [[cosine, ..], [sine, ..], _] = rotation.matrix();
    [*sine, *cosine].map(I2F30::to_bits)
}

/// The angle from half a turn below 0 to half a turn above it, in radians.
fn radians(angle: u16) -> f32 {
    f32::from(angle as i16) * (core::f32::consts::PI / 32_768.0)
}

fn fixed(number: f32) -> i32 {
    (number * ONE) as i32
}

/// The crate `micromath`: approximations in `f32` that are small.
pub fn micromath(angle: u16) -> [i32; 2] {
    let (sine, cosine) = F32Ext::sin_cos(radians(angle));
    [sine, cosine].map(fixed)
}

/// The crate `libm`: `f32`, correct within an ulp.
pub fn libm_single(angle: u16) -> [i32; 2] {
    let (sine, cosine) = libm::sincosf(radians(angle));
    [sine, cosine].map(fixed)
}

/// Entries of the table of a quarter turn.
const ENTRIES: usize = 129;

/// Sines of a quarter turn, 32,768 for 1.
static SINES: [u16; ENTRIES] = {
    let mut sines = [0; ENTRIES];
    let mut index = 0;
    while index < ENTRIES {
        sines[index] = (taylor(FRAC_PI_2 * index as f64 / (ENTRIES - 1) as f64) * 32_768.0 + 0.5) as u16;
        index += 1;
    }
    sines
};

/// The sine of up to a quarter turn, in radians, to within 1e-13.
const fn taylor(angle: f64) -> f64 {
    let (mut sum, mut term, mut power) = (0.0, angle, 1.0);
    while power < 22.0 {
        sum += term;
        term *= -angle * angle / ((power + 1.0) * (power + 2.0));
        power += 2.0;
    }
    sum
}

/// The sine by that of an angle of up to a quarter turn.
fn by_quarter(angle: u16, of_quarter: impl Fn(u16) -> i32) -> i32 {
    let position = angle % QUARTER;
    let falls = angle & QUARTER != 0;
    let size = of_quarter(if falls { QUARTER - position } else { position });
    if angle < 2 * QUARTER { size } else { -size }
}

fn entry(index: u16) -> i32 {
    SINES.get(usize::from(index)).copied().map_or(0, i32::from)
}

/// The nearest entry of a table.
pub fn nearest_entry(angle: u16) -> [i32; 2] {
    [angle, angle.wrapping_add(QUARTER)].map(|angle| by_quarter(angle, |position| entry((position + 64) >> 7)) << 15)
}

/// Between two entries of a table.
pub fn interpolated_entry(angle: u16) -> [i32; 2] {
    [angle, angle.wrapping_add(QUARTER)].map(|angle| {
        let sine = by_quarter(angle, |position| {
            let (index, rest) = (position >> 7, i32::from(position & 127));
            // 15 and 7 bits, rounded together.
            entry(index) * (128 - rest) + entry(index + 1) * rest
        });
        sine << 8
    })
}

/// Arc tangents of 1, 1/2, 1/4 and so on, in 2^-32 of a turn.
static ARC_TANGENTS: [i32; 30] = [
    536_870_912,
    316_933_406,
    167_458_907,
    85_004_756,
    42_667_331,
    21_354_465,
    10_679_838,
    5_340_245,
    2_670_163,
    1_335_087,
    667_544,
    333_772,
    166_886,
    83_443,
    41_722,
    20_861,
    10_430,
    5_215,
    2_608,
    1_304,
    652,
    326,
    163,
    81,
    41,
    20,
    10,
    5,
    3,
    1,
];

/// The length that all steps together make 1, in 2.30: to 2^-30 the same for 16 steps and more.
const CORDIC_LENGTH: i32 = 652_032_874;

/// Turns a vector by smaller and smaller angles whose tangents are powers of two: shifts and additions alone.
///
/// Source: Volder (1959), "The CORDIC trigonometric computing technique".
pub fn cordic<const STEPS: usize>(angle: u16) -> [i32; 2] {
    let whole = i32::from(angle as i16) << 16;
    // Steps reach a quarter turn and 10 degrees to both sides; beyond, the opposite angle is taken.
    let is_far = !(-(1 << 30)..=1 << 30).contains(&whole);
    let mut rest = if is_far { whole ^ i32::MIN } else { whole };
    let (mut x, mut y) = (CORDIC_LENGTH, 0);
    for (shift, arc_tangent) in ARC_TANGENTS.iter().take(STEPS).enumerate() {
        let (step_x, step_y) = (y >> shift, x >> shift);
        if rest >= 0 {
            (x, y, rest) = (x - step_x, y + step_y, rest - arc_tangent);
        } else {
            (x, y, rest) = (x + step_x, y - step_y, rest + arc_tangent);
        }
    }
    if is_far { [-y, -x] } else { [y, x] }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against `libm` in `f64`, within what is known of each.
    #[test]
    fn each_way_is_as_exact_as_its_numbers_allow() {
        // The library's 2^-27, as documented. micromath's 0.2 %. Half an ulp of the angle, what pi is off, and half an ulp.
        // Half a step of 1/512 turn, and half a unit of 15 bits. An eighth of the square of a step, and that. The last angle
        // of 16 steps; that of 30, and half a unit of 2.30 a step.
        let step = core::f64::consts::TAU / 512.0;
        let most = [
            7.5e-9,
            2e-3,
            3e-7,
            step / 2.0 + 2e-5,
            step * step / 8.0 + 2e-5,
            3.1e-5 + 2e-8,
            3e-8,
        ];
        for (method, most) in TRIGONOMETRY.iter().zip(most) {
            let mut largest = 0.0f64;
            for angle in 0..=u16::MAX {
                let [sine, cosine] = (method.sine_cosine)(angle).map(|number| f64::from(number) / f64::from(1 << 30));
                let radians = f64::from(angle) * core::f64::consts::PI / 32_768.0;
                let error = libm::fabs(sine - libm::sin(radians)).max(libm::fabs(cosine - libm::cos(radians)));
                largest = largest.max(error);
            }
            assert!(largest <= most, "{}: {largest}, not {most}", method.name);
        }
    }
}
