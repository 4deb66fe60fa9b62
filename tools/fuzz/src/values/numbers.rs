//! Numbers, with the edges of their types and of zrow's domains among them.

use arbitrary::{Arbitrary, Result, Unstructured};
use embedded_graphics::geometry::{Angle, Point, Size};

/// The ends of zrow's domains, in pixels.
const DOMAIN_ENDS: [i64; 8] = [1_023, 1_024, 2_047, 4_096, 8_191, 8_192, 16_383, 16_384];
/// Units of a pixel of zrow's formats.
const UNITS: [i64; 5] = [1, 16, 256, 8_192, 65_536];
/// The ends of integer types.
const TYPE_ENDS: [i64; 8] = [
    i16::MIN as i64,
    i16::MAX as i64,
    i32::MIN as i64,
    i32::MAX as i64,
    u32::MAX as i64,
    i64::MIN,
    i64::MAX,
    u16::MAX as i64,
];

/// A number at or next to a power of two, an end of a type or an end of a domain.
fn edge(bytes: &mut Unstructured<'_>) -> Result<i64> {
    let edge = match bytes.int_in_range(0..=3)? {
        0 => 1i64 << bytes.int_in_range(0..=62)?,
        1 => *bytes.choose(&TYPE_ENDS)?,
        2 => *bytes.choose(&DOMAIN_ENDS)?,
        _ => bytes.choose(&DOMAIN_ENDS)? * bytes.choose(&UNITS)?,
    };
    let signed = if bytes.arbitrary()? { edge.wrapping_neg() } else { edge };
    Ok(signed.wrapping_add(around_zero(bytes, -2, 2)?.into()))
}

/// Any number, where small ones are as likely as edges and as all others.
fn any(bytes: &mut Unstructured<'_>) -> Result<i64> {
    match bytes.arbitrary::<u8>()? {
        0..=99 => Ok(i64::from(bytes.arbitrary::<i8>()?)),
        100..=199 => edge(bytes),
        200..=227 => Ok(i64::from(bytes.arbitrary::<i32>()?)),
        _ => bytes.arbitrary(),
    }
}

/// A number from `least` to `most`, between which 0 is: zero bytes stand for 0.
pub(super) fn around_zero(bytes: &mut Unstructured<'_>, least: i32, most: i32) -> Result<i32> {
    let number = bytes.int_in_range(0..=most - least)?;
    Ok(if number > most { most - number } else { number })
}

/// The nearest number of another type.
fn clamped<N: TryFrom<i64>>(number: i64, least: N, greatest: N) -> N {
    N::try_from(number).unwrap_or(if number < 0 { least } else { greatest })
}

/// A number of any integer type: small ones, edges, arbitrary bits.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Number<N>(pub N);

macro_rules! numbers {
    ($($number:ty),+) => {$(
        impl<'a> Arbitrary<'a> for Number<$number> {
            fn arbitrary(bytes: &mut Unstructured<'a>) -> Result<Self> {
                Ok(Self(clamped(any(bytes)?, <$number>::MIN, <$number>::MAX)))
            }
        }
    )+};
}
numbers!(u8, i16, u16, i32, u32, i64, u64, usize);

/// Any `i32`.
pub type Int = Number<i32>;
/// Any `u32`.
pub type Count = Number<u32>;
/// Any `i64`.
pub type Large = Number<i64>;

/// A coordinate: near the picture mostly, and then relative to its corner; else anywhere.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub enum Px {
    /// Relative to the corner of the picture.
    Near(i16),
    /// As it is.
    Far(i32),
}

impl<'a> Arbitrary<'a> for Px {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> Result<Self> {
        Ok(match bytes.arbitrary::<u8>()? {
            0..=191 => Self::Near(around_zero(bytes, -6, 30)? as i16),
            192..=227 => Self::Near(around_zero(bytes, -700, 700)? as i16),
            _ => Self::Far(Int::arbitrary(bytes)?.0),
        })
    }
}

/// A pixel: near the picture mostly.
#[derive(Debug, Copy, Clone, PartialEq, Eq, Arbitrary)]
pub struct Spot {
    /// Column.
    pub x: Px,
    /// Row.
    pub y: Px,
}

/// A length in pixels: of the size of the picture mostly.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct Length(pub u32);

impl<'a> Arbitrary<'a> for Length {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> Result<Self> {
        Ok(Self(match bytes.arbitrary::<u8>()? {
            0..=159 => bytes.int_in_range(0..=28)?,
            160..=199 => bytes.int_in_range(0..=900)?,
            200..=213 => bytes.int_in_range(0..=70_000)?,
            _ => Count::arbitrary(bytes)?.0,
        }))
    }
}

impl Length {
    /// A size of two lengths.
    pub const fn by(self, height: Self) -> Size {
        Size::new(self.0, height.0)
    }
}

/// An angle: whole ones mostly, next to them, any float else, whatever its bits.
#[derive(Debug, Copy, Clone, PartialEq)]
pub struct Degrees(pub f32);

impl<'a> Arbitrary<'a> for Degrees {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> Result<Self> {
        const SPECIAL: [f32; 12] = [
            f32::NAN,
            f32::INFINITY,
            f32::NEG_INFINITY,
            f32::MAX,
            f32::MIN,
            f32::MIN_POSITIVE,
            1e-45,
            -1e-45,
            -0.0,
            1e20,
            -1e20,
            4_194_304.0,
        ];
        Ok(Self(match bytes.arbitrary::<u8>()? {
            0..=95 => (around_zero(bytes, -24, 24)? * 15) as f32,
            96..=159 => around_zero(bytes, -3_600, 3_600)? as f32 / 10.0,
            160..=191 => {
                let whole = (around_zero(bytes, -24, 24)? * 15) as f32;
                f32::from_bits(whole.to_bits().wrapping_add_signed(around_zero(bytes, -3, 3)?))
            }
            192..=223 => *bytes.choose(&SPECIAL)?,
            _ => f32::from_bits(bytes.arbitrary()?),
        }))
    }
}

impl Degrees {
    /// As embedded-graphics takes it.
    pub fn angle(self) -> Angle {
        Angle::from_degrees(self.0)
    }

    /// The number as radians: more floats come through than by [`angle`](Self::angle).
    pub fn as_radians(self) -> Angle {
        Angle::from_radians(self.0)
    }
}

impl Spot {
    /// The pixel, where the corner of the picture is at `origin`.
    pub fn from(self, origin: Point) -> Point {
        Point::new(self.x.from(origin.x), self.y.from(origin.y))
    }

    /// Whether it is at most 100 pixels from the corner of the picture, along each axis.
    pub fn is_near(self) -> bool {
        [self.x, self.y].iter().all(|axis| matches!(axis, Px::Near(-100..=100)))
    }
}

impl Px {
    /// The coordinate, where that of the picture's corner is `origin`.
    pub fn from(self, origin: i32) -> i32 {
        match self {
            Self::Near(offset) => origin.saturating_add(offset.into()),
            Self::Far(coordinate) => coordinate,
        }
    }
}
