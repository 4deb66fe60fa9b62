//! The row that the picture shows: what the library makes of it, stage by stage.

use anyhow::Context;
use embedded_graphics::{
    pixelcolor::{Rgb565, WebColors},
    prelude::*,
    primitives::Rectangle,
};
use zrow::{
    band::Band,
    coverage::{CoverageMethod, SignedArea},
    draw::{AntialiasedPolygon, FillRule},
    geometry::{Sub8, SubPoint, TooSmall, Window},
};

/// Columns of the picture.
pub const COLUMNS: usize = 12;
/// Rows of the outline that are shown.
pub const ROWS: i32 = 7;
/// The row that is followed.
pub const ROW: i32 = 3;
/// The vertices of the outline, in 1/256 pixel; pixel centres are at whole pixels.
pub const OUTLINE: [(i32, i32); 3] = [(1_000, 40), (2_900, 1_130), (150, 1_420)];
/// The colour of the shape, and the one below it.
pub const COLORS: [Rgb565; 2] = [Rgb565::CSS_ORANGE_RED, Rgb565::CSS_MIDNIGHT_BLUE];

/// A row of pixels as the stages see it.
pub struct Row {
    /// How much of each pixel is covered, of 255.
    pub coverage: [u8; COLUMNS],
    /// The words of the band after blending.
    pub words: [u16; COLUMNS],
}

/// Draws the row with the library.
///
/// # Errors
/// Never for this outline: what would have to be larger.
pub fn draw() -> anyhow::Result<Row> {
    let corners = OUTLINE.map(|(x, y)| SubPoint::<Sub8>::from_units(x, y));
    let [a, b, c] = corners;
    let corners = [a?, b?, c?];
    let polygon = AntialiasedPolygon::<3, 3>::prepare(&[corners.as_slice()], FillRule::NonZero)?;
    let mut row_memory = [0; COLUMNS + 2];
    let window = Window {
        left: 0,
        top: ROW,
        right: COLUMNS as i32,
        bottom: ROW + 1,
    };
    let mut coverage = [0; COLUMNS];
    polygon.cover(
        &SignedArea,
        &window,
        row_memory.get_mut(..SignedArea::cells(COLUMNS)).context("cells")?,
        |span, value| {
            coverage[span.start as usize..span.end as usize].fill(value);
            Ok::<_, TooSmall>(())
        },
    )?;
    let [color, below] = COLORS;
    let mut words = [0; COLUMNS];
    let area = Rectangle::new(Point::new(0, ROW), Size::new(COLUMNS as u32, 1));
    let mut band = Band::<Rgb565>::new(area, &mut words)?;
    band.fill(below);
    polygon.draw(
        &SignedArea,
        color,
        &mut band,
        &mut row_memory[..SignedArea::cells(COLUMNS)],
    )?;
    Ok(Row { coverage, words })
}

/// Where the outline's edges cross the top and the bottom of the followed row: columns in pixels, from the left side of
/// pixel 0, in the order of the outline; `None` for an edge that does not reach the row.
pub fn segments() -> impl Iterator<Item = [(f64, f64); 2]> {
    // From pixel centres to the left and upper sides of pixels.
    let corner = |index: usize| {
        let (x, y) = OUTLINE[index % OUTLINE.len()];
        (f64::from(x) / 256.0 + 0.5, f64::from(y) / 256.0 + 0.5)
    };
    let (top, bottom) = (f64::from(ROW), f64::from(ROW + 1));
    (0..OUTLINE.len()).filter_map(move |index| {
        let ((x0, y0), (x1, y1)) = (corner(index), corner(index + 1));
        let at = |y: f64| (x0 + (x1 - x0) * (y - y0) / (y1 - y0), y);
        let (from, to) = (y0.clamp(top, bottom), y1.clamp(top, bottom));
        (from != to).then(|| [at(from), at(to)])
    })
}

/// The cells of the followed row: `cover` is the height by which edges cross a pixel's column (downwards counts as negative),
/// `area` the part of that height right of the edge inside of the pixel. Coverage is the sum of all covers to the left, and
/// the pixel's own area.
pub fn cells() -> [(f64, f64); COLUMNS] {
    let mut cells = [(0.0, 0.0); COLUMNS];
    for [from, to] in segments() {
        for (column, cell) in cells.iter_mut().enumerate() {
            // The stretch of the segment between the pixel's left and right sides.
            let (left, right) = (column as f64, column as f64 + 1.0);
            let along = |x: f64| {
                if to.0 == from.0 {
                    0.0
                } else {
                    (x - from.0) / (to.0 - from.0)
                }
            };
            let (first, last) = if to.0 >= from.0 {
                (along(left), along(right))
            } else {
                (along(right), along(left))
            };
            let (first, last) = (first.clamp(0.0, 1.0), last.clamp(0.0, 1.0));
            if last > first {
                let height = -(to.1 - from.1) * (last - first);
                let middle = from.0 + (to.0 - from.0) * (first + last) / 2.0 - left;
                cell.0 += height;
                cell.1 += height * (1.0 - middle);
            }
        }
    }
    cells
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_add_up_to_the_coverage_of_the_library() {
        let row = draw().unwrap();
        let mut covers = 0.0;
        for (&(cover, area), coverage) in cells().iter().zip(row.coverage) {
            let sum: f64 = covers + area;
            assert!(
                (255.0 * sum.abs() - f64::from(coverage)).abs() < 1.0,
                "{sum} for {coverage}"
            );
            covers += cover;
        }
        assert!(row.coverage.contains(&255));
    }
}
