//! Paths of lines and curves.

use arbitrary::{Arbitrary, Result, Unstructured};
use fixed::types::U8F8;
use zrow::draw::PathCommand;

use super::{ByHand, List, Stage, SubSpot};

/// What the pen of a path does.
#[derive(Debug, Copy, Clone, PartialEq, Eq, Arbitrary)]
pub enum Command {
    /// Begins a contour.
    Move(SubSpot),
    /// A straight line.
    Line(SubSpot),
    /// A parabola.
    Quadratic(SubSpot, SubSpot),
    /// A cubic.
    Cubic(SubSpot, SubSpot, SubSpot),
    /// Back to the beginning of the contour.
    Close,
}

impl Command {
    fn get<S: ByHand>(self, point: impl Fn(SubSpot) -> zrow::geometry::SubPoint<S>) -> PathCommand<S> {
        match self {
            Self::Move(end) => PathCommand::MoveTo(point(end)),
            Self::Line(end) => PathCommand::LineTo(point(end)),
            Self::Quadratic(control, end) => PathCommand::QuadraticTo(point(control), point(end)),
            Self::Cubic(one, other, end) => PathCommand::CubicTo(point(one), point(other), point(end)),
            Self::Close => PathCommand::Close,
        }
    }
}

/// The commands as a path takes them, with points in the domain, or as they are.
pub fn commands<S: ByHand, const MOST: usize>(
    commands: &List<Command, MOST>,
    stage: &Stage,
    in_domain: bool,
) -> Vec<PathCommand<S>> {
    let commands = commands.0.iter();
    commands
        .map(|command| {
            command.get(|spot| {
                if in_domain {
                    spot.inside(stage)
                } else {
                    spot.by_hand(stage)
                }
            })
        })
        .collect()
}

/// How far lines may be from their curve: any number, 1/8 pixel often.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct Tolerance(pub U8F8);

impl<'a> Arbitrary<'a> for Tolerance {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> Result<Self> {
        Ok(Self(match bytes.arbitrary::<u8>()? {
            0..=99 => U8F8::from_bits(32),
            100..=179 => U8F8::from_bits(bytes.int_in_range(0..=300)?),
            _ => U8F8::from_bits(bytes.arbitrary()?),
        }))
    }
}
