//! All shapes in all styles.

use embedded_graphics::{
    mono_font::ascii::{FONT_5X8, FONT_6X10},
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Circle, Ellipse, Line, Polyline, PrimitiveStyleBuilder, Rectangle, Triangle},
    text::Alignment,
};
use zrow::{
    band::{Band, Order},
    draw::{PrimitiveStyle, StrokeAlignment, ThinCircle},
};

use crate::{
    PrepareError, Prepared, Scene,
    paint::{label, rgb, shape},
};

const TITLE_COLOR: Rgb565 = rgb(255, 255, 255);
const LABEL_COLOR: Rgb565 = rgb(150, 165, 190);
const STROKE: Rgb565 = rgb(90, 200, 250);
const FILL: Rgb565 = rgb(255, 112, 67);
const OUTLINE: Rgb565 = rgb(255, 255, 255);
const LINE: Rgb565 = rgb(255, 213, 79);
const THIN: Rgb565 = rgb(129, 230, 150);

/// Columns of the table, and where their middles are.
const COLUMNS: [(&str, i32); 6] = [
    ("rectangle", 75),
    ("circle", 121),
    ("ellipse", 167),
    ("triangle", 215),
    ("line", 252),
    ("polyline", 296),
];
/// Rows of the table, and their styles.
const ROWS: [(&str, Style); 6] = [
    ("1 px", Style::Stroke(1, StrokeAlignment::Center)),
    ("inside", Style::Stroke(5, StrokeAlignment::Inside)),
    ("center", Style::Stroke(5, StrokeAlignment::Center)),
    ("outside", Style::Stroke(5, StrokeAlignment::Outside)),
    ("fill", Style::Fill),
    ("both", Style::Both),
];
/// Widths of the lines and polylines in pixels, one for each row.
const WIDTHS: [(&str, u32); 6] = [("1", 1), ("2", 2), ("3", 3), ("4", 4), ("5", 5), ("7", 7)];
/// Radii of the thin circles in the last row.
const RADII: [u32; 10] = [1, 2, 3, 4, 5, 6, 7, 8, 10, 12];

const FIRST_ROW: i32 = 41;
const ROW_HEIGHT: i32 = 29;

#[derive(Copy, Clone)]
enum Style {
    Stroke(u32, StrokeAlignment),
    Fill,
    Both,
}

impl Style {
    fn style(self) -> PrimitiveStyle<Rgb565> {
        let builder = PrimitiveStyleBuilder::new();
        match self {
            Self::Stroke(width, alignment) => builder
                .stroke_color(STROKE)
                .stroke_width(width)
                .stroke_alignment(alignment),
            Self::Fill => builder.fill_color(FILL),
            Self::Both => builder.fill_color(FILL).stroke_color(STROKE).stroke_width(3),
        }
        .build()
        .into()
    }

    /// Whether the bare outline helps to see where the stroke lies.
    fn shows_outline(self) -> bool {
        matches!(self, Self::Stroke(2.., _))
    }
}

/// The scene; nothing outlives a row.
#[derive(Debug, Default)]
pub struct Shapes;

impl Scene for Shapes {
    type Color = Rgb565;
    type Prepared<'s> = &'s mut Self;
    const NAME: &'static str = "shapes";
    const TITLE: &'static str = "shapes and styles";
    const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(320, 240));
    const BACKGROUND: Rgb565 = rgb(16, 20, 28);

    fn prepare(&mut self, _frame: u32) -> Result<&mut Self, PrepareError> {
        Ok(self)
    }
}

impl Prepared for Shapes {
    type Color = Rgb565;

    fn draw<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>) {
        label(
            band,
            <Self as Scene>::TITLE,
            Point::new(160, 4),
            Alignment::Center,
            &FONT_6X10,
            TITLE_COLOR,
        );
        for (name, x) in COLUMNS {
            label(band, name, Point::new(x, 18), Alignment::Center, &FONT_5X8, LABEL_COLOR);
        }
        for ((row, (name, style)), (width_name, width)) in (0..).zip(ROWS).zip(WIDTHS) {
            let y = FIRST_ROW + row * ROW_HEIGHT;
            label(
                band,
                name,
                Point::new(6, y - 4),
                Alignment::Left,
                &FONT_5X8,
                LABEL_COLOR,
            );
            draw_areas(band, y, style.style());
            if style.shows_outline() {
                draw_areas(band, y, PrimitiveStyle::with_stroke(OUTLINE, 1));
            }
            label(
                band,
                width_name,
                Point::new(274, y - 4),
                Alignment::Center,
                &FONT_5X8,
                LABEL_COLOR,
            );
            draw_lines(band, y, width);
        }
        draw_thin_circles(band);
    }
}

/// Rectangle, circle, ellipse and triangle of one row of the table.
fn draw_areas<O: Order>(band: &mut Band<'_, Rgb565, O>, y: i32, style: PrimitiveStyle<Rgb565>) {
    let [rectangle, circle, ellipse, triangle, ..] = COLUMNS.map(|(_, x)| Point::new(x, y));
    shape(
        band,
        &Rectangle::with_center(rectangle, Size::new(30, 17)).into_styled(style),
    );
    shape(band, &Circle::with_center(circle, 19).into_styled(style));
    shape(
        band,
        &Ellipse::with_center(ellipse, Size::new(33, 17)).into_styled(style),
    );
    let corners = [(-11, 7), (2, -8), (11, 5)].map(|(x, y)| triangle + Point::new(x, y));
    let [a, b, c] = corners;
    shape(band, &Triangle::new(a, b, c).into_styled(style));
}

/// Line and polyline of one row of the table.
fn draw_lines<O: Order>(band: &mut Band<'_, Rgb565, O>, y: i32, width: u32) {
    let [.., line, polyline] = COLUMNS.map(|(_, x)| Point::new(x, y));
    let style = PrimitiveStyle::with_stroke(LINE, width);
    shape(
        band,
        &Line::with_delta(line - Point::new(13, -8), Point::new(26, -16)).into_styled(style),
    );
    let corners = [(-15, 9), (-7, -8), (2, 7), (8, -4), (15, 3)].map(|(x, y)| polyline + Point::new(x, y));
    shape(band, &Polyline::new(&corners).into_styled(style));
}

fn draw_thin_circles<O: Order>(band: &mut Band<'_, Rgb565, O>) {
    let y = FIRST_ROW + 6 * ROW_HEIGHT + 8;
    label(
        band,
        "thin circles",
        Point::new(6, y - 4),
        Alignment::Left,
        &FONT_5X8,
        LABEL_COLOR,
    );
    let mut x = 78;
    for radius in RADII {
        x += radius as i32;
        shape(
            band,
            &ThinCircle::new(Point::new(x, y), radius).into_styled(PrimitiveStyle::with_stroke(THIN, 1)),
        );
        x += radius as i32 + 11;
    }
}
