//! A picture with magnified pixels, lines between them, numbers over them, and a caption.

use embedded_graphics::{
    mono_font::ascii::{FONT_4X6, FONT_5X8},
    pixelcolor::Rgb565,
    prelude::*,
    primitives::Rectangle,
    text::Alignment,
};
use heapless::{String, Vec};
use zrow::{
    band::{Band, BandColor, Order},
    geometry::Window,
};

use crate::{
    paint::{TITLE_COLOR, label, rgb},
    visibility::work::{BEHIND, COLUMNS, PIXELS, ROWS, Record},
};

const LABEL_COLOR: Rgb565 = rgb(150, 165, 190);
/// Pixels of the page along the side of a pixel of the picture.
pub const CELL: u32 = 3;
/// The size of the picture, and of the panel with its caption.
const PICTURE: Size = Size::new(COLUMNS as u32 * CELL, ROWS as u32 * CELL);
pub const PANEL: Size = Size::new(PICTURE.width, PICTURE.height + 30);

/// From the middle of a number to the row below its dark edge, with one row to spare.
const DIGIT_HEIGHT: i32 = 4;

/// A line between two pixels.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub enum Line {
    /// None.
    No,
    /// Darker than both pixels.
    Dark,
    /// Bright, for what the panel is about.
    Bright,
    /// Red, for what a method has to do seldom: a split of the painter's.
    Special,
}

/// A pixel of the picture.
#[derive(Debug, Copy, Clone)]
pub struct Cell {
    pub color: Rgb565,
    pub left: Line,
    pub top: Line,
}

/// A line of a caption.
pub type Text = String<44>;

/// A picture and its caption.
#[derive(Debug)]
pub struct Panel {
    pub cells: [Cell; PIXELS],
    /// Numbers, each at twice the pixel that it is over.
    pub numbers: Vec<([i32; 2], u32), 64>,
    pub name: &'static str,
    pub counted: Text,
    pub about: &'static str,
}

impl Panel {
    /// Nothing is drawn.
    pub const EMPTY: Self = Self {
        cells: [Cell {
            color: BEHIND,
            left: Line::No,
            top: Line::No,
        }; PIXELS],
        numbers: Vec::new(),
        name: "",
        counted: String::new(),
        about: "",
    };

    /// The picture of a method, darker.
    pub fn darkened(record: &Record) -> Self {
        Self::of(|pixel| {
            record
                .words
                .get(pixel)
                .map_or(BEHIND, |word| darker(Rgb565::from_word(*word)))
        })
    }

    /// In each pixel a color, by the pixel's index.
    pub fn of(color: impl Fn(usize) -> Rgb565) -> Self {
        let mut panel = Self::EMPTY;
        for (pixel, cell) in panel.cells.iter_mut().enumerate() {
            cell.color = color(pixel);
        }
        panel
    }

    /// The sides of rectangles as lines.
    pub fn with_areas(mut self, record: &Record) -> Self {
        for (cell, sides) in self.cells.iter_mut().zip(&record.sides) {
            let line = |is_there| if is_there { Line::Bright } else { Line::No };
            (cell.left, cell.top) = (line(sides.left), line(sides.top));
        }
        self
    }

    /// Ticks where spans begin.
    pub fn with_starts(mut self, record: &Record) -> Self {
        for (cell, _) in self.cells.iter_mut().zip(&record.starts).filter(|(_, starts)| **starts) {
            cell.left = Line::Bright;
        }
        self
    }

    /// The colour of a point of the magnified picture.
    fn color_at(&self, Point { x, y }: Point) -> Rgb565 {
        let [column, row] = [x, y].map(|at| at as usize / CELL as usize);
        let Some(cell) = self.cells.get(row * COLUMNS + column) else {
            return BEHIND;
        };
        let line = |at: i32, line| if at % CELL as i32 == 0 { line } else { Line::No };
        let left = line_color(line(x, cell.left), cell.color);
        left.or(line_color(line(y, cell.top), cell.color)).unwrap_or(cell.color)
    }

    /// Draws what lies in a band, with the upper left corner at a point.
    pub fn draw<O: Order>(&self, band: &mut Band<'_, Rgb565, O>, position: Point) {
        let window = Window::from(band.bounding_box());
        if !window.meets(&Rectangle::new(position, PANEL).into()) {
            return;
        }
        let picture = Rectangle::new(position, PICTURE).intersection(&band.bounding_box());
        let colors = picture.points().map(|point| self.color_at(point - position));
        let Ok(()) = band.fill_contiguous(&picture, colors);
        for ([x, y], number) in &self.numbers {
            let at = Point::new(x * CELL as i32, y * CELL as i32) / 2;
            // A tile at the lower edge may be lower than a digit is high.
            let y = at.y.min(PICTURE.height as i32 - DIGIT_HEIGHT);
            draw_number(band, position + Point::new(at.x, y), *number);
        }
        let under = position + Point::new(0, PICTURE.height as i32);
        caption(band, under, [self.name, self.counted.as_str(), self.about]);
    }
}

/// Draws the three lines of a caption below a picture, given the picture's lower left corner. The first one is the name.
pub fn caption<O: Order>(band: &mut Band<'_, Rgb565, O>, below: Point, [name, second, third]: [&str; 3]) {
    let lines = [(name, TITLE_COLOR), (second, LABEL_COLOR), (third, LABEL_COLOR)];
    for ((text, color), line) in lines.into_iter().zip(0..) {
        let position = below + Point::new(0, 3 + 9 * line);
        label(band, text, position, Alignment::Left, &FONT_5X8, color);
    }
}

fn line_color(line: Line, color: Rgb565) -> Option<Rgb565> {
    match line {
        Line::No => None,
        Line::Dark => Some(darker(color)),
        Line::Bright => Some(rgb(240, 236, 214)),
        Line::Special => Some(rgb(255, 40, 90)),
    }
}

/// A number in the middle of a point, dark around it.
fn draw_number<O: Order>(band: &mut Band<'_, Rgb565, O>, at: Point, number: u32) {
    let mut text = String::<10>::new();
    // As long as any number.
    let _ = core::fmt::Write::write_fmt(&mut text, format_args!("{number}"));
    for (x, y) in [(-1, 0), (1, 0), (0, -1), (0, 1)] {
        let beside = at + Point::new(x, y - 3);
        label(band, &text, beside, Alignment::Center, &FONT_4X6, Rgb565::BLACK);
    }
    label(
        band,
        &text,
        at - Point::new(0, 3),
        Alignment::Center,
        &FONT_4X6,
        TITLE_COLOR,
    );
}

/// Half as bright, and a little towards what is behind.
fn darker(color: Rgb565) -> Rgb565 {
    Rgb565::new(color.r() / 2, color.g() / 2, color.b() / 2 + 1)
}
