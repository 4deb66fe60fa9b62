//! How the 3D stages store sub-pixel units.

use core::{fmt::Debug, num::Wrapping};

use fixed::types::I2F30;

use crate::geometry::{HAS_DIVIDER, Sub4, Sub8, SubPixel};

/// A [`SubPixel`] precision of screen vertices and edges: [`Sub4`] or [`Sub8`].
///
/// A [`Look`](crate::scene::Look) names one, and what is on the screen has it:
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::I16F16;
/// use zrow::{
///     geometry::SubPoint,
///     scene::{Camera, FaceSet, Fine, Look, Memory, Model, Prepared},
/// };
///
/// /// The leftmost vertex on the screen, as where a label is put, in any look.
/// fn leftmost<L: Look>(scene: &Prepared<'_, '_, L>) -> Option<SubPoint<L::Precision>> {
///     scene.points().map(|point| point.corner.point).min_by_key(|point| point.x)
/// }
///
/// let camera = Camera::new(Rectangle::new(Point::zero(), Size::new(64, 64)), I16F16::from_num(128))?;
/// let mesh = FaceSet::new(&[[-513, -512, 1024], [0, 512, 1024], [512, -512, 1024]], &[[0, 1, 2]])?;
/// let models = [Model::new(mesh, &[Rgb565::RED])?];
/// let (mut memory, mut fine) = (Memory::<Rgb565, 3, 1, 64, 64>::new(), Memory::<Fine<Rgb565>, 3, 1, 64, 64>::new());
/// assert_eq!(leftmost(&memory.prepare(&camera, &models)?).map(|point| point.x_units()), Some(248));
/// assert_eq!(leftmost(&fine.prepare(&camera, &models)?).map(|point| point.x_units()), Some(3960));
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
pub trait ScreenPrecision: SubPixel + sealed::Sealed {
    /// The integer type of a coordinate of the domain, or of the difference of two, in units.
    type Units: Copy + Debug + Default + PartialEq + Eq + Into<i32> + Send + Sync;

    /// Zero units, to initialise constants.
    const ZERO: Self::Units;
    /// A number outside the domain, which marks a vertex that is off the screen.
    const OUTSIDE: Self::Units;

    /// Position and fraction of an edge in one integer.
    type EdgeSum: EdgeSum;

    /// The integer type of a coordinate of eye space or of the screen before faces are clipped, or of the difference of
    /// two.
    type Wide: Copy + Debug + Default + Into<i64> + Send + Sync;

    /// An element of the rows that turn a vertex to eye space.
    type EyeElement: Copy + Debug + Send + Sync;
    /// What is added to a turned vertex in eye space.
    type EyeOffset: Copy + Debug + Send + Sync;

    /// Rounds an element of a rotation.
    fn eye_element(element: I2F30) -> Self::EyeElement;
    /// The product of a row of a rotation and a vector of up to 2^17 units with 16 fractional bits.
    fn eye_offset(row: &[I2F30; 3], vector: &[i64; 3]) -> Self::EyeOffset;
    /// A coordinate of a vertex in eye space, in 1/4096 of the vertices' unit.
    fn eye_coordinate(row: &[Self::EyeElement; 3], vertex: [i16; 3], offset: Self::EyeOffset) -> i32;
    /// An element with 30 fractional bits.
    fn eye_element_bits(element: Self::EyeElement) -> i32;
    /// An offset in 1/4096 of the vertices' unit, rounded down.
    fn eye_offset_bits(offset: Self::EyeOffset) -> i64;

    /// Converts a number that is known to fit.
    fn wide(number: i64) -> Self::Wide;
    /// Stores units that are known to fit; keeps the low bits of any other number.
    fn narrow(units: i32) -> Self::Units;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for crate::geometry::Sub4 {}
    impl Sealed for crate::geometry::Sub8 {}
    impl Sealed for i32 {}
    impl Sealed for i64 {}
}

impl ScreenPrecision for Sub4 {
    type Units = i16;
    const ZERO: i16 = 0;
    const OUTSIDE: i16 = i16::MIN;
    type EdgeSum = i32;
    // |x/z| < 2^15 times a focal length of 2,047 pixels in 1/16: below 2^30.
    type Wide = i32;
    /// In 2.14: 32-bit products.
    type EyeElement = i16;
    /// In 1/4096 unit.
    type EyeOffset = i32;

    #[inline]
    fn eye_element(element: I2F30) -> i16 {
        // At most 1 and rounding: 16,384 in 2.14.
        ((element.to_bits() + (1 << 15)) >> 16) as i16
    }

    /// The vector is at most 2^16 * sqrt(3) units long: the result is below 113,600 units or 2^29.
    #[inline(never)]
    fn eye_offset(row: &[I2F30; 3], vector: &[i64; 3]) -> i32 {
        let sum: i64 = row
            .iter()
            .zip(vector)
            // 2^30 * 2^33 would leave no room for the sum: four bits of the matrix give it.
            .map(|(element, coordinate)| i64::from(element.to_bits() >> 4) * coordinate)
            .sum();
        ((sum + (1 << 29)) >> 30) as i32
    }

    /// Three multiplications. A row is a unit vector within rounding, and a vertex is at most 32,768 * sqrt(3) long: the sum stays
    /// below 2^30 in 2.14, so nothing wraps.
    #[inline]
    fn eye_coordinate(row: &[i16; 3], vertex: [i16; 3], offset: i32) -> i32 {
        // Written out: a closure over an array is a loop through memory when the compiler minds the size.
        let ([a, b, c], [x, y, z]) = (*row, vertex);
        let sum = i32::from(a) * i32::from(x) + (i32::from(b) * i32::from(y)) + (i32::from(c) * i32::from(z));
        (sum >> 2) + offset
    }

    fn eye_element_bits(element: i16) -> i32 {
        i32::from(element) << 16
    }

    fn eye_offset_bits(offset: i32) -> i64 {
        offset.into()
    }

    #[inline]
    fn wide(number: i64) -> i32 {
        number as i32
    }

    #[inline]
    fn narrow(units: i32) -> i16 {
        units as i16
    }
}

impl ScreenPrecision for Sub8 {
    type Units = i32;
    const ZERO: i32 = 0;
    const OUTSIDE: i32 = i32::MIN;
    type EdgeSum = i64;
    type Wide = i64;
    /// In 2.30: a corner far from its model's origin is as exact as one at it.
    type EyeElement = I2F30;
    /// With 30 fractional bits, and half of 1/4096 unit more, so that the sum is rounded once.
    type EyeOffset = i64;

    #[inline]
    fn eye_element(element: I2F30) -> I2F30 {
        element
    }

    /// Exact for a vector of whole units: then a point of the world is the same one through every model that is turned alike.
    #[inline(never)]
    fn eye_offset(row: &[I2F30; 3], vector: &[i64; 3]) -> i64 {
        let product = |coordinates: [i64; 3]| {
            let products = row.iter().zip(coordinates);
            products
                .map(|(element, coordinate)| i64::from(element.to_bits()) * coordinate)
                .sum::<i64>()
        };
        // Whole units are at most 2^17, and the fraction below 2^16: both sums stay below 2^49.
        let fraction = product(vector.map(|coordinate| coordinate & 0xffff));
        product(vector.map(|coordinate| coordinate >> 16)) + ((fraction + (1 << 15)) >> 16) + (1 << 17)
    }

    /// Three multiplications of 32 by 32 bits; the sum stays below 2^48.
    #[inline]
    fn eye_coordinate(row: &[I2F30; 3], vertex: [i16; 3], offset: i64) -> i32 {
        let ([a, b, c], [x, y, z]) = (row.map(|element| i64::from(element.to_bits())), vertex.map(i64::from));
        ((a * x + b * y + c * z + offset) >> 18) as i32
    }

    fn eye_element_bits(element: I2F30) -> i32 {
        element.to_bits()
    }

    fn eye_offset_bits(offset: i64) -> i64 {
        offset >> 18
    }

    #[inline]
    fn wide(number: i64) -> i64 {
        number
    }

    #[inline]
    fn narrow(units: i32) -> i32 {
        units
    }
}

/// The column of an edge and its error term, a fraction of its height, in the upper and lower half of one integer, so
/// that one addition steps both.
///
/// The fraction counts up to the greatest lower half instead of to the height. A carry then moves the column by itself,
/// and leaves a lower half whose top bit is clear, because a height takes less than half of it.
pub trait EdgeSum: Copy + Debug + Ord + Send + Sync + sealed::Sealed {
    /// Added after a carry of the error term: the range of the lower half less the height of the edge.
    type CarryCorrection: Copy + Debug + PartialEq + Eq + Send + Sync;
    /// Carry corrections of the left and the right edge, packed into one integer.
    type CarryCorrections: Copy + Debug + PartialEq + Eq + Send + Sync;
    /// Column 0 and no fraction, to initialise constants.
    const ZERO: Self;
    /// The bits of the lower half, below those of the column.
    const FRACTION_BITS: u32;
    /// The carry corrections of two edges that need none.
    const NO_CARRY_CORRECTIONS: Self::CarryCorrections;

    /// The sum for a column, and for an error term: how much of the height is missing to the next carry, less one.
    fn new(column: i32, error_term: i32) -> Self;
    /// A step by whole columns and a remainder below the height.
    fn step(columns: i32, rest: i32) -> Self;
    /// The carry correction for an edge of this height, in units: what is added where the error term carries.
    fn carry_correction(height: i32) -> Self::CarryCorrection;
    /// The carry correction for an edge that is as high as one is higher than another, from theirs.
    fn carry_correction_of_rest(higher: Self::CarryCorrection, lower: Self::CarryCorrection) -> Self::CarryCorrection;
    /// The sum for a column with [`FRACTION_BITS`](Self::FRACTION_BITS), which needs no carry correction.
    fn fixed(columns: i32) -> Self;
    /// The column.
    fn column(self) -> i32;
    /// The carry corrections of a left and a right edge.
    fn carry_corrections(left: Self::CarryCorrection, right: Self::CarryCorrection) -> Self::CarryCorrections;
    /// The carry correction of the left edge, of the two that are packed into one integer.
    fn left_carry_correction(carry_corrections: Self::CarryCorrections) -> Self::CarryCorrection;
    /// The carry correction of the right edge, of the two that are packed into one integer.
    fn right_carry_correction(carry_corrections: Self::CarryCorrections) -> Self::CarryCorrection;
    /// One step further, without a carry correction.
    #[must_use]
    fn plus(self, step: Self) -> Self;
    /// The mean of two sums, each of which is rounded down to an even number before.
    #[must_use]
    fn mean(self, other: Self) -> Self;
    /// The sum after a step, with the carry correction added where that step carried.
    #[must_use]
    fn corrected(self, carry_correction: Self::CarryCorrection) -> Self;
}

/// The bits of the lower half of an [`EdgeSum`] of 32 bits below those of an error term.
const SPARE_BITS: u32 = <i32 as EdgeSum>::FRACTION_BITS - 16;

impl EdgeSum for i32 {
    type CarryCorrection = u16;
    type CarryCorrections = u32;
    const ZERO: Self = 0;
    /// Columns take 12 bits: those of the domain do, from the first column of a row on, which is one of them. The rest makes
    /// edges long that still need no carry correction, for processors that divide: others have carry corrections always, and
    /// those take fewer instructions with 16 bits.
    const FRACTION_BITS: u32 = if HAS_DIVIDER { 20 } else { 16 };
    const NO_CARRY_CORRECTIONS: u32 = 0;

    #[inline]
    fn new(column: i32, error_term: i32) -> Self {
        // For 16 bits equal to `column << 16 | !error_term & 0xffff`, for 0 <= error_term < 2^15. A level edge has any error
        // term, and crosses no row: in the last column of the domain its sum may wrap.
        let before = (column << Self::FRACTION_BITS) + ((1 << Self::FRACTION_BITS) - 1);
        (Wrapping(before) - Wrapping(error_term << SPARE_BITS)).0
    }

    #[inline]
    fn step(columns: i32, rest: i32) -> Self {
        (columns << Self::FRACTION_BITS) + (rest << SPARE_BITS)
    }

    #[inline]
    fn fixed(columns: i32) -> Self {
        columns
    }

    #[inline]
    fn carry_correction(height: i32) -> u16 {
        (-Wrapping(height as u16)).0
    }

    #[inline]
    fn carry_correction_of_rest(higher: u16, lower: u16) -> u16 {
        (Wrapping(higher) - Wrapping(lower)).0
    }

    #[inline]
    fn column(self) -> i32 {
        self >> Self::FRACTION_BITS
    }

    #[inline]
    fn carry_corrections(left: u16, right: u16) -> u32 {
        u32::from(left) | u32::from(right) << 16
    }

    #[inline]
    fn left_carry_correction(carry_corrections: u32) -> u16 {
        carry_corrections as u16
    }

    #[inline]
    fn right_carry_correction(carry_corrections: u32) -> u16 {
        (carry_corrections >> 16) as u16
    }

    #[inline]
    fn plus(self, step: Self) -> Self {
        (Wrapping(self) + Wrapping(step)).0
    }

    #[inline]
    fn mean(self, other: Self) -> Self {
        (self >> 1) + (other >> 1)
    }

    #[inline]
    fn corrected(self, carry_correction: u16) -> Self {
        if self & (1 << (Self::FRACTION_BITS - 1)) == 0 {
            (Wrapping(self) + Wrapping(i32::from(carry_correction) << SPARE_BITS)).0
        } else {
            self
        }
    }
}

impl EdgeSum for i64 {
    type CarryCorrection = u32;
    type CarryCorrections = u64;
    const ZERO: Self = 0;
    const FRACTION_BITS: u32 = 32;
    const NO_CARRY_CORRECTIONS: u64 = 0;

    #[inline]
    fn new(column: i32, error_term: i32) -> Self {
        (i64::from(column) << 32) | i64::from(!error_term as u32)
    }

    #[inline]
    fn step(columns: i32, rest: i32) -> Self {
        (i64::from(columns) << 32) + i64::from(rest)
    }

    #[inline]
    fn fixed(columns: i32) -> Self {
        i64::from(columns) << 16
    }

    #[inline]
    fn carry_correction(height: i32) -> u32 {
        (-Wrapping(height as u32)).0
    }

    #[inline]
    fn carry_correction_of_rest(higher: u32, lower: u32) -> u32 {
        (Wrapping(higher) - Wrapping(lower)).0
    }

    #[inline]
    fn column(self) -> i32 {
        (self >> 32) as i32
    }

    #[inline]
    fn carry_corrections(left: u32, right: u32) -> u64 {
        u64::from(left) | u64::from(right) << 32
    }

    #[inline]
    fn left_carry_correction(carry_corrections: u64) -> u32 {
        carry_corrections as u32
    }

    #[inline]
    fn right_carry_correction(carry_corrections: u64) -> u32 {
        (carry_corrections >> 32) as u32
    }

    #[inline]
    fn plus(self, step: Self) -> Self {
        (Wrapping(self) + Wrapping(step)).0
    }

    #[inline]
    fn mean(self, other: Self) -> Self {
        (self >> 1) + (other >> 1)
    }

    #[inline]
    fn corrected(self, carry_correction: u32) -> Self {
        if self as i32 >= 0 {
            (Wrapping(self) + Wrapping(i64::from(carry_correction))).0
        } else {
            self
        }
    }
}
