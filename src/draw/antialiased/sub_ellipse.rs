//! Circles, ellipses and arcs at 1/256 pixel, as polygons that are nowhere further from them than 1/64 pixel.

use core::num::NonZeroU32;

use fixed::types::{U0F16, U24F8};

use crate::{
    draw::{SubOutline, antialiased::sub_outline},
    geometry::{OutOfDomain, Sub8, SubPoint},
    view::{cosine, sine},
};

/// A filled circle or ellipse with a centre and radii in 1/256 pixel.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SubEllipse {
    center: SubPoint<Sub8>,
    radii: [u32; 2],
}

impl SubEllipse {
    /// An ellipse with these radii across and down, in pixels.
    ///
    /// # Errors
    /// [`OutOfDomain`] where it leaves the domain.
    pub fn new(center: SubPoint<Sub8>, radii: [U24F8; 2]) -> Result<Self, OutOfDomain> {
        let radii = radii.map(U24F8::to_bits);
        let [across, down] = radii;
        sub_outline::check_extent(center, across.max(down))?;
        Ok(Self { center, radii })
    }

    /// A circle.
    ///
    /// # Errors
    /// [`OutOfDomain`] where it leaves the domain.
    pub fn circle(center: SubPoint<Sub8>, radius: U24F8) -> Result<Self, OutOfDomain> {
        Self::new(center, [radius; 2])
    }

    /// How many edges its outline has, level ones included.
    pub fn edge_count(&self) -> usize {
        let [across, down] = self.radii;
        edges_of_turn(across.max(down)).get() as usize
    }
}

impl SubOutline for SubEllipse {
    fn edges(&self, edge: &mut dyn FnMut([i32; 2], [i32; 2])) {
        let [across, down] = self.radii;
        let count = edges_of_turn(across.max(down));
        let corner = |index: u32| on_ellipse(self.center, self.radii, part(TURN, index, count));
        sub_outline::close((0..count.get()).map(corner), edge);
    }

    fn is_simple(&self) -> bool {
        true
    }
}

/// An arc with a width and butt ends, or a whole ring: a gauge.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SubArc {
    center: SubPoint<Sub8>,
    outer: u32,
    inner: u32,
    start: u32,
    sweep: u32,
}

/// Units of an angle in a turn.
const TURN: u32 = 1 << 16;

impl SubArc {
    /// The arc from an angle over a part of a turn, clockwise on the screen from the x axis, between two radii in pixels.
    ///
    /// # Errors
    /// [`OutOfDomain`] where it leaves the domain.
    pub fn new(
        center: SubPoint<Sub8>,
        [inner, outer]: [U24F8; 2],
        start: U0F16,
        sweep: U0F16,
    ) -> Result<Self, OutOfDomain> {
        let (inner, outer) = (inner.min(outer).to_bits(), inner.max(outer).to_bits());
        sub_outline::check_extent(center, outer)?;
        Ok(Self {
            center,
            outer,
            inner,
            start: start.to_bits().into(),
            sweep: sweep.to_bits().into(),
        })
    }

    fn corner(&self, radius: u32, angle: u32) -> [i32; 2] {
        // Only the lower 16 bits count: a turn more is the same direction.
        on_ellipse(self.center, [radius; 2], self.start + angle)
    }
}

impl SubOutline for SubArc {
    fn edges(&self, edge: &mut dyn FnMut([i32; 2], [i32; 2])) {
        let count = NonZeroU32::MIN.saturating_add((self.sweep * edges_of_turn(self.outer).get()) >> 16);
        let angle = |index: u32| part(self.sweep, index, count);
        let indices = 0..count.get() + 1;
        let outer = indices.clone().map(|index| self.corner(self.outer, angle(index)));
        let inner = indices.rev().map(|index| self.corner(self.inner, angle(index)));
        sub_outline::close(outer.chain(inner), edge);
    }

    fn is_simple(&self) -> bool {
        true
    }
}

/// The point of an ellipse at an angle, rounded to 1/256 pixel.
fn on_ellipse(center: SubPoint<Sub8>, [across, down]: [u32; 2], angle: u32) -> [i32; 2] {
    let angle = U0F16::from_bits(angle as u16);
    let along = |radius: u32, part: i32| {
        // Below 2^21 times 2^30.
        ((i64::from(radius) * i64::from(part) + (1 << 29)) >> 30) as i32
    };
    [
        center.x_units() + along(across, cosine(angle).to_bits()),
        center.y_units() + along(down, sine(angle).to_bits()),
    ]
}

/// An angle of up to a turn times `index / count`, which are at most 1,612.
fn part(angle: u32, index: u32, count: NonZeroU32) -> u32 {
    angle * index / count
}

/// Edges of a whole turn, so many that none is further than 1/64 pixel from a circle of that radius in units: a multiple of
/// four, from 8 to 1,612.
fn edges_of_turn(radius: u32) -> NonZeroU32 {
    const LEAST: NonZeroU32 = NonZeroU32::new(8).unwrap();
    // A chord over 1/n of a turn is r (1 - cos(pi / n)) or about r pi^2 / (2 n^2) off: n^2 must be 316 times the radius.
    let least = u64::from(radius) * 316 / 256;
    let edges = (least.isqrt() as u32 + 4) & !3;
    NonZeroU32::new(edges).map_or(LEAST, |edges| edges.max(LEAST))
}

#[cfg(test)]
mod tests {
    use embedded_graphics::{
        mock_display::MockDisplay,
        pixelcolor::{Gray4, GrayColor},
    };

    use super::*;
    use crate::{
        coverage::SignedArea,
        draw::{
            AntialiasedPolygon, FillRule,
            pictures::{at, blended},
        },
    };

    fn drawn(outline: &impl SubOutline) -> MockDisplay<Gray4> {
        let polygon = AntialiasedPolygon::<128, 32>::prepare(outline, FillRule::NonZero).unwrap();
        blended(|band| polygon.draw(&SignedArea, Gray4::WHITE, band, &mut [0; 17]).unwrap())
    }

    fn pixels(number: f32) -> U24F8 {
        U24F8::from_num(number)
    }

    #[test]
    fn a_circle_about_the_centre_of_a_pixel() {
        let circle = SubEllipse::circle(at(4.0, 4.0), pixels(4.5)).unwrap();
        drawn(&circle).assert_pattern(&[
            " 18DFD81 ",
            "1CFFFFFC1",
            "8FFFFFFF8",
            "DFFFFFFFD",
            "FFFFFFFFF",
            "DFFFFFFFD",
            "8FFFFFFF8",
            "1CFFFFFC1",
            " 18DFD81 ",
        ]);
    }

    /// A radius of half a pixel covers a sixteenth of pi, 0.196, of each of the four pixels: 3 fifteenths.
    #[test]
    fn a_circle_about_the_corner_of_a_pixel_smaller_than_that() {
        let circle = SubEllipse::circle(at(1.5, 1.5), pixels(0.5)).unwrap();
        drawn(&circle).assert_pattern(&[
            "         ", //
            " 33      ",
            " 33      ",
        ]);
    }

    #[test]
    fn an_ellipse_cut_by_the_upper_edge() {
        let ellipse = SubEllipse::new(at(6.5, 1.5), [pixels(6.5), pixels(4.0)]).unwrap();
        drawn(&ellipse).assert_pattern(&[
            "1EFFFFFFFFFFE1",
            "6FFFFFFFFFFFF6",
            "6FFFFFFFFFFFF6",
            "1EFFFFFFFFFFE1",
            " 3DFFFFFFFFD3 ",
            "   5ADFFDA5   ",
        ]);
    }

    #[test]
    fn an_arc_over_three_quarters_begins_to_the_right_and_runs_downwards() {
        let gauge = SubArc::new(
            at(6.5, 6.5),
            [pixels(4.0), pixels(7.0)],
            U0F16::ZERO,
            U0F16::from_num(0.75),
        )
        .unwrap();
        drawn(&gauge).assert_pattern(&[
            "   18CE       ",
            "  5EFFF       ",
            " 5FFFFF       ",
            "1EFFD51       ",
            "8FFD1         ",
            "CFF5          ",
            "EFF1          ",
            "FFF1      1FFE",
            "CFF5      5FFC",
            "8FFD1    1DFF8",
            "1EFFD5115DFFE1",
            " 5FFFFFFFFFF5 ",
            "  5EFFFFFFE5  ",
            "   18CFEC81   ",
        ]);
    }
}
