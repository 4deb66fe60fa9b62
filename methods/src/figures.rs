//! What other rasterizers fill as well: a triangle, a ring, a star and a letter, in squares of any size.

use core::f64::consts::TAU;

use heapless::Vec;

use crate::{CIRCLE_CORNERS, Contour, Rule, Shape, UNITS, around};

/// Columns and rows of the squares in which they are compared.
pub const FIGURE_SIZES: [u32; 3] = [16, 48, 200];

/// The square that the coordinates below are of.
const DRAWN_IN: f64 = 48.0;
const CENTER: (f64, f64) = (24.0, 24.0);

/// A shape that grows with its square.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Figure {
    /// Three corners.
    Triangle,
    /// A circle of 128 corners without one of 96.
    Ring,
    /// Seven corners, every third of them joined.
    Star,
    /// A letter with a stem, a round belly and a hole.
    Glyph,
}

const TRIANGLE: &[(f64, f64)] = &[(3.3, 2.1), (44.2, 17.7), (12.6, 45.4)];
const GLYPH: &[(f64, f64)] = &[
    (8.3, 4.1),
    (15.2, 4.1),
    (15.2, 18.0),
    (20.5, 13.3),
    (29.4, 13.2),
    (37.0, 18.1),
    (40.3, 27.4),
    (37.6, 37.2),
    (30.1, 43.0),
    (20.6, 42.4),
    (15.2, 38.0),
    (15.2, 42.3),
    (8.3, 42.3),
];

impl Figure {
    /// Every figure.
    pub const ALL: [Self; 4] = [Self::Triangle, Self::Ring, Self::Star, Self::Glyph];

    /// Its name in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Triangle => "triangle",
            Self::Ring => "ring",
            Self::Star => "star",
            Self::Glyph => "glyph",
        }
    }

    /// What the chips report its counts as, in a square of one of the [`FIGURE_SIZES`].
    pub const fn count_name(self, size: u32) -> &'static str {
        macro_rules! sized {
            ($name:literal) => {
                match size {
                    16 => concat!("figure.", $name, ".16"),
                    48 => concat!("figure.", $name, ".48"),
                    _ => concat!("figure.", $name, ".200"),
                }
            };
        }
        match self {
            Self::Triangle => sized!("triangle"),
            Self::Ring => sized!("ring"),
            Self::Star => sized!("star"),
            Self::Glyph => sized!("glyph"),
        }
    }

    /// In a square of so many pixels, with corners in 1/256 pixel, under the nonzero rule.
    pub fn shape(self, size: u32) -> Shape {
        let mut shape = Shape {
            contours: Vec::new(),
            rule: Rule::NonZero,
            units: UNITS,
        };
        let mut add = |corners: &mut dyn Iterator<Item = (f64, f64)>| {
            let contour: Contour = corners.map(|corner| in_square(corner, size)).collect();
            // None has more than two.
            let _ = shape.contours.push(contour);
        };
        match self {
            Self::Triangle => add(&mut TRIANGLE.iter().copied()),
            Self::Ring => {
                add(&mut regular(21.6, CIRCLE_CORNERS, 1.0));
                add(&mut regular(14.4, 96, -1.0));
            }
            Self::Star => add(&mut regular(22.0, 7, 3.0)),
            Self::Glyph => {
                add(&mut GLYPH.iter().copied());
                add(&mut regular(9.6, 32, -1.0));
            }
        }
        shape
    }
}

/// From the top on, by so many corners further each.
fn regular(radius: f64, corners: usize, step: f64) -> impl Iterator<Item = (f64, f64)> {
    around(CENTER, radius, corners, -TAU / 4.0, step * TAU / corners as f64)
}

/// From the corner of the drawn square to the centre of the first pixel of this one.
fn in_square((x, y): (f64, f64), size: u32) -> (i32, i32) {
    let position =
        |part: f64| libm::floor(part * f64::from(size) / DRAWN_IN * f64::from(UNITS) + 0.5) as i32 - UNITS / 2;
    (position(x), position(y))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Published with the bars, from the corner of the square in 1/256 pixel; two of its corners are rounded the other way.
    #[test]
    fn the_triangle_and_the_star_of_48_pixels_are_those_of_the_bars() {
        let triangle: &[_] = &[(845, 538), (11_315, 4_531), (3_226, 11_622)];
        let star: &[_] = &[
            (6_144, 512),
            (8_588, 11_218),
            (1_741, 2_632),
            (11_635, 7_397),
            (653, 7_397),
            (10_547, 2_632),
            (3_700, 11_218),
        ];
        for (figure, published) in [(Figure::Triangle, triangle), (Figure::Star, star)] {
            let shape = figure.shape(48);
            assert_eq!(shape.contours[0].len(), published.len());
            for (corner, published) in shape.contours[0].iter().zip(published) {
                let (right, down) = (corner.0 + 128 - published.0, corner.1 + 128 - published.1);
                assert!(right.abs() <= 1 && down.abs() <= 1, "{figure:?}: {corner:?}");
            }
        }
    }

    #[test]
    fn every_figure_lies_in_its_square() {
        for (figure, size) in Figure::ALL
            .into_iter()
            .flat_map(|figure| FIGURE_SIZES.map(|size| (figure, size)))
        {
            let inside = -128..=size as i32 * UNITS - 128;
            for (x, y) in figure.shape(size).contours.iter().flatten() {
                assert!(inside.contains(x) && inside.contains(y), "{figure:?} {size}: {x} {y}");
            }
        }
    }
}
