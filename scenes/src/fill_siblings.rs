//! A picture of the tests by which filling methods find the pixels of a shape: a star filled by rows and by pixels, a triangle
//! by rows, by pixels and by blocks of pixels.

use core::{convert::Infallible, fmt::Write};

use embedded_graphics::{
    mono_font::ascii::FONT_5X8, pixelcolor::Rgb565, prelude::*, primitives::Rectangle, text::Alignment,
};
use fixed::types::I12F4;
use heapless::String;
use zrow::{
    band::{Band, Order, Span},
    draw::PrimitiveStyle,
    geometry::{Sub4, SubPoint, Vertex, Window},
    scan::{FillRule, Location, Polygons},
};

use crate::{
    PrepareError, Prepared, Scene,
    paint::{TITLE_COLOR, label, rgb, shape, title},
};

type Corner = SubPoint<Sub4>;

const LABEL_COLOR: Rgb565 = rgb(150, 165, 190);
/// Not tested.
const BLANK: Rgb565 = rgb(28, 34, 46);
/// Tested, and not inside.
const IN_VAIN: Rgb565 = rgb(112, 124, 152);
/// An edge that crosses the row, or a pixel on the boundary.
const CROSSED: Rgb565 = rgb(255, 202, 40);
const FILLED: Rgb565 = rgb(38, 198, 218);
/// A pixel that is filled without a test of its own.
const ACCEPTED: Rgb565 = rgb(129, 199, 100);
const REJECTED: Rgb565 = rgb(206, 78, 92);

/// Tests that a frame adds to each picture.
const TESTS: u32 = 40;
/// Frames until the last picture is complete, and some to look at it.
const FRAMES: u32 = 50;

/// What the colours mean.
const LEGEND: [(&str, Rgb565); 5] = [
    ("inside", FILLED),
    ("in vain", IN_VAIN),
    ("edge", CROSSED),
    ("accept", ACCEPTED),
    ("reject", REJECTED),
];
const LEGEND_POSITION: Point = Point::new(283, 22);

const fn corner(x: i16, y: i16) -> Corner {
    SubPoint {
        x: I12F4::from_bits(x),
        y: I12F4::from_bits(y),
    }
}

/// In sixteenths; four corners are on pixel centres.
const STAR: [Corner; 5] = [
    corner(152, 0),
    corner(256, 288),
    corner(0, 112),
    corner(304, 112),
    corner(48, 288),
];
const TRIANGLE: [Corner; 3] = [corner(13, 61), corner(755, 13), corner(205, 941)];

/// A grid of magnified pixels.
struct Grid {
    origin: Point,
    columns: i32,
    rows: i32,
    /// From one to the next; they themselves are `CELL` in size.
    distance: i32,
}

const CELL: Size = Size::new_equal(2);

const STAR_GRID: Grid = Grid {
    origin: Point::new(0, 18),
    columns: 20,
    rows: 20,
    distance: 3,
};
const TRIANGLE_GRID: Grid = Grid {
    origin: Point::new(0, 99),
    columns: 48,
    rows: 60,
    distance: 2,
};
/// Where the grids begin.
const COLUMNS: [i32; 3] = [6, 116, 220];

impl Grid {
    const fn in_column(&self, column: usize) -> Self {
        Self {
            origin: Point::new(COLUMNS[column], self.origin.y),
            ..*self
        }
    }

    fn window(&self) -> Window {
        Window {
            left: 0,
            top: 0,
            right: self.columns,
            bottom: self.rows,
        }
    }

    fn row(&self, y: i32) -> Window {
        Window {
            top: y,
            bottom: y + 1,
            ..self.window()
        }
    }

    /// Magnified pixels.
    fn cells(&self, span: Span) -> impl Iterator<Item = Rectangle> {
        let position = move |x: i32| self.origin + Point::new(x, span.y) * self.distance;
        (span.start..span.end).map(move |x| Rectangle::new(position(x), CELL))
    }

    /// A dot right of a row.
    fn dot(&self, y: i32, number: i32) -> Rectangle {
        let beyond = Point::new(self.columns, y) * self.distance + Point::new(2 + 3 * number, 0);
        Rectangle::new(self.origin + beyond, CELL)
    }
}

/// Makes tests as long as there are any left.
struct Tests<'a> {
    left: u32,
    paint: &'a mut dyn FnMut(Rectangle, Rgb565),
}

impl Tests<'_> {
    /// Shows the result of the next test; `false` where none is left.
    fn show(&mut self, area: Rectangle, color: Rgb565) -> bool {
        let is_left = self.left > 0;
        if is_left {
            self.left -= 1;
            (self.paint)(area, color);
        }
        is_left
    }
}

/// A way to fill, with the tests that it makes in a grid.
struct Way {
    name: &'static str,
    about: &'static str,
    grid: Grid,
    run: fn(&Grid, &mut Tests<'_>),
}

const WAYS: [Way; 6] = [
    Way {
        name: "edge table",
        about: "edges of its rows",
        grid: STAR_GRID.in_column(0),
        run: |grid, tests| test_edges(grid, &STAR, true, tests),
    },
    Way {
        name: "naive scan line",
        about: "edges",
        grid: STAR_GRID.in_column(1),
        run: |grid, tests| test_edges(grid, &STAR, false, tests),
    },
    Way {
        name: "brute force",
        about: "points",
        grid: STAR_GRID.in_column(2),
        run: test_points,
    },
    Way {
        name: "edge table",
        about: "edges of its rows",
        grid: TRIANGLE_GRID.in_column(0),
        run: |grid, tests| test_edges(grid, &TRIANGLE, true, tests),
    },
    Way {
        name: "edge functions",
        about: "pixels",
        grid: TRIANGLE_GRID.in_column(1),
        run: test_box,
    },
    Way {
        name: "hierarchical",
        about: "blocks, pixels",
        grid: TRIANGLE_GRID.in_column(2),
        run: test_blocks,
    },
];

/// Row by row: a dot for each edge that is tested, then the spans between those that cross.
fn test_edges(grid: &Grid, contour: &[Corner], only_active: bool, tests: &mut Tests<'_>) {
    // A row of pixel centres is crossed from the first one at or below the upper end to the last one above the lower end.
    let first_row_below = |corner: &Corner| (corner.y_units() + 15) >> 4;
    for y in 0..grid.rows {
        let mut dots = 0;
        let starts = contour.last().into_iter().chain(contour);
        for (from, to) in starts.zip(contour) {
            let ends = [from, to].map(first_row_below);
            let crosses = ends[0].min(ends[1]) <= y && y < ends[0].max(ends[1]);
            if only_active && !crosses {
                continue;
            }
            if !tests.show(grid.dot(y, dots), if crosses { CROSSED } else { IN_VAIN }) {
                return;
            }
            dots += 1;
        }
        // Never full: a row crosses no more edges than there are.
        let _ = Polygons::naive_scanline::<_, _, 5>(&[contour], FillRule::EvenOdd, &grid.row(y), |span| {
            for cell in grid.cells(span) {
                (tests.paint)(cell, FILLED);
            }
            Ok::<(), Infallible>(())
        });
    }
}

/// Each pixel of the bounding box.
fn test_points(grid: &Grid, tests: &mut Tests<'_>) {
    let ask = |contours: &[&[Corner]], rule, centre: &_| {
        let location = Polygons::winding_number(contours, rule, centre);
        let color = match location {
            Location::Inside => FILLED,
            Location::Outside => IN_VAIN,
            Location::OnBoundary => CROSSED,
        };
        let (x, y) = (Vertex::x_units(centre) / 16, Vertex::y_units(centre) / 16);
        for cell in grid.cells(Span::new(y, x, x + 1)) {
            tests.show(cell, color);
        }
        location
    };
    let Ok(()) = Polygons::brute_force(&[&STAR], FillRule::EvenOdd, &grid.window(), ask, |_| {
        Ok::<(), Infallible>(())
    });
}

/// The pixels that have their centres in the bounding box of the triangle.
fn bounding_box() -> Window {
    let (x, y) = (
        TRIANGLE.map(|corner| corner.x_units()),
        TRIANGLE.map(|corner| corner.y_units()),
    );
    let first = |units: [i32; 3]| (units.into_iter().fold(i32::MAX, i32::min) + 15) / 16;
    let end = |units: [i32; 3]| units.into_iter().fold(0, i32::max) / 16 + 1;
    Window {
        left: first(x),
        top: first(y),
        right: end(x),
        bottom: end(y),
    }
}

/// The triangle's pixels in one row of a window; none at its right end, where there are none.
fn span_of_triangle(y: i32, window: &Window) -> Span {
    let row = Window {
        top: y,
        bottom: y + 1,
        ..*window
    };
    let mut found = Span::new(y, window.right, window.right);
    let Ok(()) = Polygons::incremental_edge_triangle(TRIANGLE, &row, |span| {
        found = span;
        Ok::<(), Infallible>(())
    });
    found
}

/// Each row of the bounding box up to the first pixel beyond the span.
fn test_box(grid: &Grid, tests: &mut Tests<'_>) {
    let bounds = bounding_box();
    for y in bounds.top..bounds.bottom {
        let span = span_of_triangle(y, &bounds);
        let tested = Span::new(y, bounds.left, (span.end + 1).min(bounds.right));
        test_pixels(grid, tested, span, tests);
    }
}

fn test_pixels(grid: &Grid, tested: Span, filled: Span, tests: &mut Tests<'_>) {
    for (cell, x) in grid.cells(tested).zip(tested.start..) {
        let is_filled = filled.start <= x && x < filled.end;
        tests.show(cell, if is_filled { FILLED } else { IN_VAIN });
    }
}

/// Each block of the bounding box up to the first one beyond the triangle, and the pixels of those that are crossed.
fn test_blocks(grid: &Grid, tests: &mut Tests<'_>) {
    let bounds = bounding_box();
    for top in (bounds.top..bounds.bottom).step_by(8) {
        let mut met = false;
        for left in (bounds.left..bounds.right).step_by(8) {
            let block = Window {
                left,
                top,
                right: left + 8,
                bottom: top + 8,
            };
            let cover = Cover::of(&block);
            let visible = block.intersection(&bounds);
            let spans = |y| (Span::new(y, visible.left, visible.right), span_of_triangle(y, &visible));
            let rows = visible.top..visible.bottom;
            if cover == Cover::Something {
                met |= rows.clone().any(|y| !spans(y).1.is_empty());
                tests.show(Rectangle::zero(), IN_VAIN);
                for y in rows {
                    let (tested, filled) = spans(y);
                    test_pixels(grid, tested, filled, tests);
                }
                continue;
            }
            let color = if cover == Cover::Everything { ACCEPTED } else { REJECTED };
            if tests.show(Rectangle::zero(), color) {
                rows.flat_map(|y| grid.cells(spans(y).0))
                    .for_each(|cell| (tests.paint)(cell, color));
            }
            if met && cover == Cover::Nothing {
                break;
            }
            met |= cover == Cover::Everything;
        }
    }
}

/// What a block has of the triangle, as its corners tell.
#[derive(PartialEq, Eq)]
enum Cover {
    Nothing,
    Everything,
    Something,
}

impl Cover {
    fn of(block: &Window) -> Self {
        let [a, b, c] = TRIANGLE.map(|corner| (corner.x_units(), corner.y_units()));
        let (left, right) = (block.left * 16, (block.right - 1) * 16);
        let (top, bottom) = (block.top * 16, (block.bottom - 1) * 16);
        let corners = [(left, top), (right, top), (left, bottom), (right, bottom)];
        let mut cover = Self::Everything;
        for (from, to) in [(a, b), (b, c), (c, a)] {
            let inside = corners.map(|(x, y)| (to.0 - from.0) * (y - from.1) > (to.1 - from.1) * (x - from.0));
            if inside == [false; 4] {
                return Self::Nothing;
            }
            if inside != [true; 4] {
                cover = Self::Something;
            }
        }
        cover
    }
}

/// The scene; nothing outlives a row.
#[derive(Debug, Default)]
pub struct FillSiblings;

/// How far every picture is.
#[derive(Debug)]
pub struct Frame {
    tests: u32,
    /// The tests that each picture has made.
    tested: [u32; WAYS.len()],
}

impl Scene for FillSiblings {
    type Color = Rgb565;
    type Prepared<'s> = Frame;
    const NAME: &'static str = "fill-siblings";
    const TITLE: &'static str = "ways to fill: what each asks";
    const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(320, 240));
    const BACKGROUND: Rgb565 = rgb(16, 20, 28);
    const FRAMES: u32 = FRAMES;
    const PORTRAIT: u32 = FRAMES - 1;

    fn prepare(&mut self, frame: u32) -> Result<Frame, PrepareError> {
        let tests = (frame % FRAMES + 1) * TESTS;
        let tested = WAYS.each_ref().map(|way| {
            let mut counted = Tests {
                left: tests,
                paint: &mut |_, _| {},
            };
            (way.run)(&way.grid, &mut counted);
            tests - counted.left
        });
        Ok(Frame { tests, tested })
    }
}

impl Prepared for Frame {
    type Color = Rgb565;

    fn draw<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>) {
        title::<FillSiblings, O>(band);
        for ((text, color), line) in LEGEND.into_iter().zip(0..) {
            let at = LEGEND_POSITION + Point::new(0, 11 * line);
            label(band, text, at, Alignment::Left, &FONT_5X8, color);
        }
        for (way, tested) in WAYS.iter().zip(self.tested) {
            draw_way(band, way, self.tests);
            draw_label(band, way, tested);
        }
    }
}

fn draw_way<O: Order>(band: &mut Band<'_, Rgb565, O>, way: &Way, tests: u32) {
    let rows = (way.grid.rows * way.grid.distance) as u32;
    let area = Rectangle::new(
        way.grid.origin,
        Size::new(<FillSiblings as Scene>::AREA.size.width, rows),
    );
    if Window::from(band.bounding_box()).meets(&area.into()) {
        let mut paint = |cell: Rectangle, color| shape(band, &cell.into_styled(PrimitiveStyle::with_fill(color)));
        for y in 0..way.grid.rows {
            for cell in way.grid.cells(Span::new(y, 0, way.grid.columns)) {
                paint(cell, BLANK);
            }
        }
        let mut tests = Tests {
            left: tests,
            paint: &mut paint,
        };
        (way.run)(&way.grid, &mut tests);
    }
}

/// The name, and how many tests were made.
fn draw_label<O: Order>(band: &mut Band<'_, Rgb565, O>, way: &Way, tested: u32) {
    let under = way.grid.origin + Point::new(0, way.grid.rows * way.grid.distance + 1);
    let mut text = String::<32>::new();
    // Long enough for every name here.
    let _ = write!(text, "{tested} {}", way.about);
    for (line, text, color) in [(0, way.name, TITLE_COLOR), (8, text.as_str(), LABEL_COLOR)] {
        label(
            band,
            text,
            under + Point::new(0, line),
            Alignment::Left,
            &FONT_5X8,
            color,
        );
    }
}
