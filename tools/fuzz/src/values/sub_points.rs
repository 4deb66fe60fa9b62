//! Points between pixels, at either precision, in the domain or made by hand outside of it.

use arbitrary::{Arbitrary, Result, Unstructured};
use fixed::types::{I12F4, I24F8};
use zrow::geometry::{Sub4, Sub8, SubPixel, SubPoint};

use super::{Int, List, Stage, numbers::around_zero};

/// A sub-pixel precision whose points can be made of any bits.
pub trait ByHand: SubPixel {
    /// The point of these units, in the domain or not; what does not fit the number is cut to it.
    fn by_hand(x: i64, y: i64) -> SubPoint<Self>;
}

impl ByHand for Sub4 {
    fn by_hand(x: i64, y: i64) -> SubPoint<Self> {
        let bits = |units: i64| I12F4::from_bits(units.clamp(i16::MIN.into(), i16::MAX.into()) as i16);
        SubPoint { x: bits(x), y: bits(y) }
    }
}

impl ByHand for Sub8 {
    fn by_hand(x: i64, y: i64) -> SubPoint<Self> {
        let bits = |units: i64| I24F8::from_bits(units.clamp(i32::MIN.into(), i32::MAX.into()) as i32);
        SubPoint { x: bits(x), y: bits(y) }
    }
}

/// A coordinate in 1/256 pixel: near the picture mostly, and on pixels, between them or next to them.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub enum Units {
    /// From the first pixel's centre.
    Near(i32),
    /// At or near an end of the domain.
    DomainEnd(i32),
    /// Any bits: often outside the domain.
    Any(i32),
}

impl<'a> Arbitrary<'a> for Units {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> Result<Self> {
        Ok(match bytes.arbitrary::<u8>()? {
            0..=79 => Self::Near(around_zero(bytes, -4, 28)? * 256),
            80..=127 => Self::Near(around_zero(bytes, -8, 56)? * 128 + around_zero(bytes, -1, 1)?),
            128..=231 => Self::Near(around_zero(bytes, -4 * 256, 28 * 256)?),
            232..=243 => {
                let pixel = *bytes.choose(&[-8_191, -1_024, 1_023, 8_191])?;
                Self::DomainEnd(pixel * 256 + around_zero(bytes, -3, 3)? * *bytes.choose(&[1, 16, 256])?)
            }
            _ => Self::Any(Int::arbitrary(bytes)?.0),
        })
    }
}

impl Units {
    /// In units of a precision, where the first pixel of the picture has the coordinate `origin`.
    fn get<S: SubPixel>(self, origin: i32) -> i64 {
        let shift = Sub8::FRACTION_BITS - S::FRACTION_BITS;
        match self {
            Self::Near(units) => (i64::from(origin) << S::FRACTION_BITS) + i64::from(units >> shift),
            Self::DomainEnd(units) => i64::from(units >> shift),
            Self::Any(units) => i64::from(units),
        }
    }
}

/// A point between pixels.
#[derive(Debug, Copy, Clone, PartialEq, Eq, Arbitrary)]
pub struct SubSpot {
    /// Column.
    pub x: Units,
    /// Row.
    pub y: Units,
}

impl SubSpot {
    /// The point, which may lie outside the domain.
    pub fn by_hand<S: ByHand>(self, stage: &Stage) -> SubPoint<S> {
        let origin = stage.origin();
        S::by_hand(self.x.get::<S>(origin.x), self.y.get::<S>(origin.y))
    }

    /// The point, moved to the nearest one of the domain.
    pub fn inside<S: ByHand>(self, stage: &Stage) -> SubPoint<S> {
        let point = self.by_hand::<S>(stage);
        let clamp = |units: i32| i64::from(units.clamp(S::MIN_UNITS, S::MAX_UNITS));
        S::by_hand(clamp(point.x_units()), clamp(point.y_units()))
    }
}

/// Up to `CONTOURS` contours of up to `POINTS` points: some empty, some with repeated points.
#[derive(Debug, Clone, PartialEq, Eq, Arbitrary)]
pub struct SubContours<const CONTOURS: usize, const POINTS: usize>(List<List<SubSpot, POINTS>, CONTOURS>);

impl<const CONTOURS: usize, const POINTS: usize> SubContours<CONTOURS, POINTS> {
    /// The points, each moved into the domain.
    pub fn inside<S: ByHand>(&self, stage: &Stage) -> Vec<Vec<SubPoint<S>>> {
        let contours = self.0.0.iter();
        contours
            .map(|contour| contour.0.iter().map(|spot| spot.inside(stage)).collect())
            .collect()
    }

    /// The points, in the domain or not.
    pub fn by_hand<S: ByHand>(&self, stage: &Stage) -> Vec<Vec<SubPoint<S>>> {
        let contours = self.0.0.iter();
        contours
            .map(|contour| contour.0.iter().map(|spot| spot.by_hand(stage)).collect())
            .collect()
    }
}
