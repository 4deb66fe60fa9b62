//! Filled circles and ellipses from two pixels to the largest of a screen's numbers.

use embedded_graphics::{
    geometry::{Point, Size},
    pixelcolor::Gray8,
    prelude::*,
    primitives::{Circle, Ellipse, PrimitiveStyle},
};
use zrow::{
    band::Band,
    draw::{self, DrawOn},
};
use zrow_methods::UPRIGHT_SCREEN;

use super::peers::quietly;
use crate::{
    axis::{Cell, Summary},
    digits::digits,
};

/// A shape that both libraries fill.
#[derive(Debug, Copy, Clone)]
enum Round {
    Circle(Circle),
    Ellipse(Ellipse),
}

/// A circle whose box begins at a point of the screen, or outside of it.
const fn circle(x: i32, y: i32, diameter: u32) -> Round {
    Round::Circle(Circle::new(Point::new(x, y), diameter))
}

/// An ellipse whose box begins at a point of the screen, or outside of it.
const fn ellipse(x: i32, y: i32, width: u32, height: u32) -> Round {
    Round::Ellipse(Ellipse::new(Point::new(x, y), Size::new(width, height)))
}

const CASES: &[(&str, Round)] = &[
    ("a circle of 200 pixels", circle(20, 60, 200)),
    ("32,769 pixels, its left end", circle(20, -16_000, 32_769)),
    ("46,342 pixels: the square exceeds 31 bits", circle(20, -23_000, 46_342)),
    (
        "1,000,000,001 pixels, its upper end",
        circle(-499_999_900, 100, 1_000_000_001),
    ),
    ("an ellipse of 2 x 8, none in its first row", ellipse(100, 100, 2, 8)),
    ("256 x 128", ellipse(-10, 50, 256, 128)),
    ("256 x 200", ellipse(-10, 50, 256, 200)),
    ("300 x 200", ellipse(-30, 50, 300, 200)),
    (
        "65,535 x 40,000, its right end",
        ellipse(-65_400, -19_900, 65_535, 40_000),
    ),
];

impl Round {
    /// Whether the centre of a pixel is inside, in whole numbers: distances from the middle are doubled.
    fn contains(&self, pixel: Point) -> bool {
        let (Point { x: left, y: top }, size) = match self {
            Self::Circle(circle) => (circle.top_left, Size::new_equal(circle.diameter)),
            Self::Ellipse(ellipse) => (ellipse.top_left, ellipse.size),
        };
        let [width, height] = [size.width, size.height].map(i128::from);
        let from_middle = |at: i32, first: i32, length: i128| 2 * (i128::from(at) - i128::from(first)) - (length - 1);
        let [dx, dy] = [from_middle(pixel.x, left, width), from_middle(pixel.y, top, height)];
        (dx * height).pow(2) + (dy * width).pow(2) < (width * height).pow(2)
    }
}

/// Fills a shape in a band of the whole screen.
type Fill = fn(Round, &mut Band<'_, Gray8>);

fn zrow(round: Round, band: &mut Band<'_, Gray8>) {
    let style = draw::PrimitiveStyle::with_fill(Gray8::WHITE);
    let Ok(()) = match round {
        Round::Circle(circle) => circle.into_styled(style).draw_on(band),
        Round::Ellipse(ellipse) => ellipse.into_styled(style).draw_on(band),
    };
}

fn embedded_graphics(round: Round, band: &mut Band<'_, Gray8>) {
    let style = PrimitiveStyle::with_fill(Gray8::WHITE);
    let Ok(()) = match round {
        Round::Circle(circle) => circle.into_styled(style).draw(band),
        Round::Ellipse(ellipse) => ellipse.into_styled(style).draw(band),
    };
}

/// Pixels of the screen that are filled and should not be, or the other way round; `None` where filling panics.
fn wrong_pixels(round: Round, fill: Fill) -> Option<usize> {
    let area = UPRIGHT_SCREEN.to_rectangle();
    let words = quietly(|| {
        let mut words = vec![0; (area.size.width * area.size.height) as usize];
        fill(round, &mut Band::new(area, &mut words).expect("a word for each pixel"));
        words
    })?;
    let pixels = area.points().zip(words);
    Some(
        pixels
            .filter(|(point, word)| round.contains(*point) != (*word != 0))
            .count(),
    )
}

/// A row for each shape.
pub fn summary() -> Summary {
    let area = UPRIGHT_SCREEN.to_rectangle();
    let rows = CASES.iter().map(|&(title, round)| {
        let seen = area.points().filter(|point| round.contains(*point)).count();
        let wrong = [zrow, embedded_graphics].map(|fill: Fill| match wrong_pixels(round, fill) {
            Some(wrong) => digits(wrong as f64),
            None => "panics".to_owned(),
        });
        let first = [title.to_owned(), digits(seen as f64)];
        first.into_iter().chain(wrong).map(Cell::from).collect()
    });
    Summary {
        title: "Filled circles and ellipses of any size".to_owned(),
        columns: [
            "shape",
            "visible pixels",
            "wrong pixels of zrow",
            "wrong pixels of embedded-graphics",
        ]
        .map(str::to_owned)
        .to_vec(),
        rows: rows.collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zrow_fills_the_pixels_inside() {
        for &(title, round) in CASES {
            assert_eq!(wrong_pixels(round, zrow), Some(0), "{title}");
        }
    }

    #[test]
    fn what_others_fill_wrongly_is_found() {
        assert_eq!(wrong_pixels(CASES[0].1, embedded_graphics), Some(0));
        assert_eq!(wrong_pixels(circle(20, -23_000, 46_342), embedded_graphics), None);
        // It begins with a row that has no pixel, and draws none at all.
        assert_eq!(wrong_pixels(ellipse(100, 100, 2, 8), embedded_graphics), Some(12));
    }
}
