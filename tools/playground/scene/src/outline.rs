//! The outline of an item: its points are rounded to the precision of the state, and the library's shapes make edges of them.

use embedded_graphics::{
    geometry::Point,
    pixelcolor::{Gray8, GrayColor},
    text::Text,
};
use zrow::{
    draw::{FillRule, OutlineTextStyle, SubEllipse, SubLine, SubOutline},
    fixed::types::U24F8,
    geometry::{InputError, Sub8, SubPoint},
};

use crate::{
    letters::LETTERS,
    state::{Item, Kind, Precision},
};

/// Receives both ends of each edge, in 1/256 pixel.
type Edges<'e> = &'e mut dyn FnMut([i32; 2], [i32; 2]);

impl Precision {
    /// A coordinate in 1/256 pixel, rounded to the precision; ties upwards.
    pub fn rounded(self, units: i32) -> i32 {
        let step = match self {
            Self::Whole => 256,
            Self::Sub4 => 16,
            Self::Sub8 => 1,
        };
        (units + step / 2).div_euclid(step) * step
    }
}

/// The outline of an item at a precision.
pub struct ItemOutline<'a> {
    /// The item.
    pub item: &'a Item,
    /// What its points are rounded to.
    pub precision: Precision,
}

impl ItemOutline<'_> {
    /// The rule by which the outline is filled.
    pub fn fill_rule(&self) -> FillRule {
        match self.item.kind {
            Kind::EvenOdd => FillRule::EvenOdd,
            _ => FillRule::NonZero,
        }
    }

    fn point(&self, index: usize) -> [i32; 2] {
        let point = self.item.points.get(index).copied().unwrap_or_default();
        point.map(|coordinate| self.precision.rounded(coordinate))
    }

    fn polygon(&self, edge: Edges<'_>) {
        let count = self.item.points.len();
        for index in 0..count {
            edge(self.point((index + count - 1) % count.max(1)), self.point(index));
        }
    }

    fn line(&self, edge: Edges<'_>) -> Result<(), InputError> {
        let width = U24F8::from_bits(self.item.size.unsigned_abs());
        SubLine::new(self.corner(0)?, self.corner(1)?, width)?.edges(edge);
        Ok(())
    }

    fn circle(&self, edge: Edges<'_>) -> Result<(), InputError> {
        let ([x0, y0], [x1, y1]) = (self.point(0), self.point(1));
        let (dx, dy) = (i64::from(x1 - x0), i64::from(y1 - y0));
        // To the nearest 1/256 pixel: half of twice the distance, rounded.
        let radius = ((4 * (dx * dx + dy * dy)).isqrt() + 1) / 2;
        let radius = self.precision.rounded(radius as i32).unsigned_abs();
        SubEllipse::circle(self.corner(0)?, U24F8::from_bits(radius))?.edges(edge);
        Ok(())
    }

    /// Calls with the text, which begins at whole pixels.
    fn with_text<R>(&self, call: impl FnOnce(&Text<'_, OutlineTextStyle<Gray8>>) -> R) -> R {
        let [x, y] = self.point(0).map(|units| Precision::Whole.rounded(units) / 256);
        let style = OutlineTextStyle::new(&LETTERS, U24F8::from_bits(self.item.size.unsigned_abs()), Gray8::WHITE);
        call(&Text::new(&self.item.text, Point::new(x, y), style))
    }

    fn corner(&self, index: usize) -> Result<SubPoint<Sub8>, InputError> {
        let [x, y] = self.point(index);
        SubPoint::from_units(x, y)
    }
}

impl SubOutline for ItemOutline<'_> {
    fn edges(&self, edge: Edges<'_>) {
        let result = match self.item.kind {
            Kind::Line => self.line(edge),
            Kind::Circle => self.circle(edge),
            Kind::Polygon | Kind::EvenOdd => {
                self.polygon(edge);
                Ok(())
            }
            Kind::Text => {
                self.with_text(|text| text.edges(edge));
                Ok(())
            }
        };
        debug_assert!(
            result.is_ok(),
            "what an address may name lies in the domain of the library"
        );
    }

    fn is_simple(&self) -> bool {
        match self.item.kind {
            Kind::Line | Kind::Circle => true,
            Kind::Text => self.with_text(|text| text.is_simple()),
            // The library looks whether edges cross.
            Kind::Polygon | Kind::EvenOdd => false,
        }
    }
}
