//! Colours, fill and stroke.

use arbitrary::{Arbitrary, Result, Unstructured};
use embedded_graphics::{
    pixelcolor::{
        Rgb565,
        raw::{RawData, RawU16},
    },
    primitives::PrimitiveStyleBuilder,
};
use fixed::types::{I16F16, U8F8, U16F16};
use zrow::draw::{LineCap, LineJoin, PrimitiveStyle, StrokeAlignment, StrokeStyle};

use super::{Count, Int, Length, List};

/// A colour that no other part of a picture has.
#[derive(Debug, Copy, Clone, PartialEq, Eq, Arbitrary)]
pub enum Hue {
    /// One of two bytes that are alike.
    Even,
    /// One that byte order changes.
    Odd,
    /// All bits.
    White,
}

impl Hue {
    /// The colour.
    pub fn color(self) -> Rgb565 {
        Rgb565::from(RawU16::from_u32(match self {
            Self::Even => 0x4141,
            Self::Odd => 0x1f83,
            Self::White => 0xffff,
        }))
    }
}

/// Where a stroke lies.
#[derive(Debug, Copy, Clone, PartialEq, Eq, Arbitrary)]
pub enum Alignment {
    /// On the outline.
    Center,
    /// Inside of it.
    Inside,
    /// Outside of it.
    Outside,
}

impl Alignment {
    /// As a style takes it.
    pub const fn get(self) -> StrokeAlignment {
        match self {
            Self::Center => StrokeAlignment::Center,
            Self::Inside => StrokeAlignment::Inside,
            Self::Outside => StrokeAlignment::Outside,
        }
    }
}

/// The width of a stroke: a few pixels mostly.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
struct StrokeWidth(u32);

impl<'a> Arbitrary<'a> for StrokeWidth {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> Result<Self> {
        Ok(Self(match bytes.arbitrary::<u8>()? {
            0..=191 => bytes.int_in_range(0..=7)?,
            192..=223 => Length::arbitrary(bytes)?.0,
            _ => Count::arbitrary(bytes)?.0,
        }))
    }
}

/// Fill and stroke, either of which may be missing.
#[derive(Debug, Copy, Clone, PartialEq, Eq, Arbitrary)]
pub struct Style {
    fill: Option<Hue>,
    stroke: Option<Hue>,
    width: StrokeWidth,
    alignment: Alignment,
}

impl Style {
    /// As a shape takes it.
    pub fn get(self) -> PrimitiveStyle<Rgb565> {
        let builder = PrimitiveStyleBuilder::new()
            .stroke_width(self.width.0)
            .stroke_alignment(self.alignment.get());
        let builder = self.fill.map_or(builder, |fill| builder.fill_color(fill.color()));
        self.stroke
            .map_or(builder, |stroke| builder.stroke_color(stroke.color()))
            .build()
            .into()
    }

    /// As embedded-graphics takes it.
    pub fn peer(self) -> embedded_graphics::primitives::PrimitiveStyle<Rgb565> {
        let mut style = embedded_graphics::primitives::PrimitiveStyle::new();
        style.fill_color = self.fill.map(Hue::color);
        style.stroke_color = self.stroke.map(Hue::color);
        style.stroke_width = self.width.0;
        style.stroke_alignment = self.alignment.get();
        style
    }

    /// The width of the stroke.
    pub const fn width(self) -> u32 {
        self.width.0
    }

    /// Whether the stroke lies inside of the shape.
    pub const fn is_inside(self) -> bool {
        matches!(self.alignment, Alignment::Inside)
    }
}

/// Lengths of dashes, and where the path begins in them.
#[derive(Debug, Clone, PartialEq, Eq, Arbitrary)]
pub struct Dashes {
    lengths: List<DashLength, 6>,
    offset: Int,
}

/// Of a dash or a gap: a few pixels mostly.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
struct DashLength(U16F16);

impl<'a> Arbitrary<'a> for DashLength {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> Result<Self> {
        Ok(Self(match bytes.arbitrary::<u8>()? {
            0..=127 => U16F16::from_num(bytes.int_in_range(0..=9u16)?),
            128..=199 => U16F16::from_bits(bytes.int_in_range(0..=9 << 16)?),
            _ => U16F16::from_bits(Count::arbitrary(bytes)?.0),
        }))
    }
}

/// Ends, corners, dashes and width of a stroke.
#[derive(Debug, Clone, PartialEq, Eq, Arbitrary)]
pub struct Stroke {
    hue: Option<Hue>,
    width: StrokeWidth,
    cap: Cap,
    join: Join,
    dashes: Option<Dashes>,
}

#[derive(Debug, Copy, Clone, PartialEq, Eq, Arbitrary)]
enum Cap {
    WholePixel,
    Butt,
    Square,
    Round,
}

#[derive(Debug, Copy, Clone, PartialEq, Eq, Arbitrary)]
enum Join {
    Miter,
    MiterTo(u16),
    Bevel,
    Round,
}

/// Most lengths of a pattern.
pub const TAKEN_DASHES: usize = 6;

impl Stroke {
    /// The lengths of its dashes, in memory that [`style`](Self::style) borrows.
    pub fn lengths(&self) -> heapless::Vec<U16F16, TAKEN_DASHES> {
        let lengths = self.dashes.iter().flat_map(|dashes| &dashes.lengths.0);
        lengths.map(|length| length.0).collect()
    }

    /// As a shape takes it.
    pub fn style<'l>(&self, lengths: &'l [U16F16]) -> StrokeStyle<'l, Rgb565> {
        let mut style = StrokeStyle::new(Rgb565::from(RawU16::from_u32(0)), self.width.0)
            .cap(match self.cap {
                Cap::WholePixel => LineCap::WholePixel,
                Cap::Butt => LineCap::Butt,
                Cap::Square => LineCap::Square,
                Cap::Round => LineCap::Round,
            })
            .join(match self.join {
                Join::Miter => LineJoin::MITER,
                Join::MiterTo(limit) => LineJoin::Miter {
                    limit: U8F8::from_bits(limit),
                },
                Join::Bevel => LineJoin::Bevel,
                Join::Round => LineJoin::Round,
            });
        style.color = self.hue.map(Hue::color);
        match &self.dashes {
            Some(dashes) => style.dashes(lengths).dash_offset(I16F16::from_bits(dashes.offset.0)),
            None => style,
        }
    }
}
