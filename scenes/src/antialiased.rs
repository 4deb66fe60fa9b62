//! Antialiasing by style: every shape and stroke without it and, on its right, with it.

use embedded_graphics::{
    mono_font::ascii::FONT_5X8,
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{
        Arc, Circle, CornerRadiiBuilder, Ellipse, Line, Polyline, PrimitiveStyleBuilder, Rectangle, RoundedRectangle,
        Sector, Styled, Triangle,
    },
    text::Alignment,
};
use fixed::types::U16F16;
use zrow::{
    band::{Band, Order},
    draw::{Antialiased, DrawAntialiased, DrawOn, LineCap, LineJoin, PrimitiveStyle, StrokeAlignment, StrokeStyle},
};

use crate::{
    PrepareError, Prepared, Scene,
    paint::{label, rgb, shape, title},
};

const LABEL_COLOR: Rgb565 = rgb(150, 165, 190);
const FILL: Rgb565 = rgb(21, 101, 192);
const STROKE: Rgb565 = rgb(255, 202, 40);
const LINE: Rgb565 = rgb(236, 64, 122);
const DASHED: Rgb565 = rgb(38, 198, 218);

/// The upper left corner of the first cell of the table. Each cell shows a shape twice: without antialiasing and with it.
const CELLS: Point = Point::new(5, 24);
/// The distance between the upper left corners of neighbouring cells.
const CELL: Size = Size::new(63, 53);
/// The distance from a cell's shape without antialiasing to the antialiased one on its right.
const BESIDE: Point = Point::new(31, 0);

const DASHES: [U16F16; 2] = [U16F16::lit("5"), U16F16::lit("3.5")];
const DOTS: [U16F16; 2] = [U16F16::lit("0"), U16F16::lit("5.5")];
const HOOK: [Point; 4] = [
    Point::new(3, 22),
    Point::new(9, 5),
    Point::new(16, 21),
    Point::new(24, 12),
];

/// Edges of the outline with the most of them, the dots, and those in one row.
const EDGES: usize = 384;
const ACTIVE: usize = 64;

/// The scene, with the row memory that all shapes share.
#[derive(Debug)]
pub struct AntialiasedStyles([i32; 321]);

impl Default for AntialiasedStyles {
    fn default() -> Self {
        Self([0; 321])
    }
}

impl Scene for AntialiasedStyles {
    type Color = Rgb565;
    type Prepared<'s> = &'s mut Self;
    const NAME: &'static str = "antialiased";
    const TITLE: &'static str = "antialiasing is a style";
    const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(320, 240));
    const BACKGROUND: Rgb565 = rgb(16, 20, 28);

    fn prepare(&mut self, _frame: u32) -> Result<&mut Self, PrepareError> {
        Ok(self)
    }
}

impl Prepared for AntialiasedStyles {
    type Color = Rgb565;

    fn draw<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>) {
        title::<Self, O>(band);
        self.draw_closed_shapes(band);
        self.draw_open_shapes(band);
        self.draw_caps(band);
        self.draw_joins(band);
        self.draw_dashes(band);
    }
}

/// The upper left corner of a cell.
fn cell(column: i32, row: i32) -> Point {
    CELLS + Point::new(column * CELL.width as i32, row * CELL.height as i32)
}

/// A fill in a stroke.
fn both(alignment: StrokeAlignment) -> PrimitiveStyle<Rgb565> {
    PrimitiveStyleBuilder::new()
        .fill_color(FILL)
        .stroke_color(STROKE)
        .stroke_width(3)
        .stroke_alignment(alignment)
        .build()
        .into()
}

fn name<O: Order>(band: &mut Band<'_, Rgb565, O>, text: &str, at: Point) {
    label(
        band,
        text,
        at + Point::new(27, 36),
        Alignment::Center,
        &FONT_5X8,
        LABEL_COLOR,
    );
}

impl AntialiasedStyles {
    /// Draws a shape that lies relative to a point, twice.
    fn pair<O: Order, S: Primitive>(
        &mut self,
        band: &mut Band<'_, Rgb565, O>,
        (column, row, text): (i32, i32, &str),
        style: PrimitiveStyle<Rgb565>,
        at: impl Fn(Point) -> S,
    ) where
        Styled<S, PrimitiveStyle<Rgb565>>: DrawOn<Color = Rgb565>,
        Styled<S, Antialiased<PrimitiveStyle<Rgb565>>>: DrawAntialiased<Color = Rgb565>,
    {
        let left = cell(column, row);
        name(band, text, left);
        shape(band, &at(left).into_styled(style));
        self.smooth(band, &at(left + BESIDE).into_styled(style.antialiased()));
    }

    /// Draws the stroke of a shape twice.
    fn stroked<'d, O: Order, S: Primitive>(
        &mut self,
        band: &mut Band<'_, Rgb565, O>,
        (column, row, text): (i32, i32, &str),
        style: StrokeStyle<'d, Rgb565>,
        at: impl Fn(Point) -> S,
    ) where
        Styled<S, StrokeStyle<'d, Rgb565>>: DrawOn<Color = Rgb565>,
        Styled<S, Antialiased<StrokeStyle<'d, Rgb565>>>: DrawAntialiased<Color = Rgb565>,
    {
        let left = cell(column, row);
        name(band, text, left);
        shape(band, &at(left).into_styled(style));
        self.smooth(band, &at(left + BESIDE).into_styled(style.antialiased()));
    }

    fn smooth<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>, shape: &impl DrawAntialiased<Color = Rgb565>) {
        let drawn = shape.draw_on(&mut band.antialiased::<EDGES, ACTIVE>(&mut self.0));
        debug_assert!(drawn.is_ok(), "{drawn:?}");
    }

    fn draw_closed_shapes<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>) {
        let style = both(StrokeAlignment::Inside);
        self.pair(band, (0, 0, "circle"), style, |at| Circle::new(at, 27));
        self.pair(band, (1, 0, "ellipse"), style, |at| {
            Ellipse::new(at + Point::new(0, 5), Size::new(28, 18))
        });
        self.pair(band, (2, 0, "rounded"), style, |at| {
            let corners = CornerRadiiBuilder::new()
                .top_left(Size::new(9, 9))
                .bottom_right(Size::new(14, 9))
                .top_right(Size::new(4, 4))
                .build();
            RoundedRectangle::new(Rectangle::new(at + Point::new(0, 2), Size::new(28, 23)), corners)
        });
        self.pair(band, (3, 0, "rectangle"), style, |at| {
            Rectangle::new(at + Point::new(1, 3), Size::new(26, 21))
        });
        self.pair(band, (4, 0, "triangle"), style, |at| {
            let vertex = |x: i32, y: i32| at + Point::new(x, y);
            Triangle::new(vertex(1, 25), vertex(25, 20), vertex(11, 1))
        });
    }

    fn draw_open_shapes<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>) {
        let style = both(StrokeAlignment::Inside);
        self.pair(band, (0, 1, "sector"), style, |at| {
            Sector::new(at, 27, 150.0.deg(), 240.0.deg())
        });
        let arc = PrimitiveStyle::with_stroke(STROKE, 5);
        self.pair(band, (1, 1, "arc"), arc, |at| {
            Arc::new(at + Point::new(3, 3), 22, 135.0.deg(), 270.0.deg())
        });
        let thin = PrimitiveStyle::with_stroke(LINE, 1);
        self.pair(band, (2, 1, "circle, 1 px"), thin, |at| Circle::new(at, 27));
        for end in [(27, 2), (27, 9), (27, 17), (24, 25), (14, 27), (5, 27)] {
            let end = Point::new(end.0, end.1);
            self.pair(band, (3, 1, "lines, 1 px"), thin, |at| {
                Line::new(at + Point::new(1, 1), at + end)
            });
        }
        let wide = PrimitiveStyle::with_stroke(LINE, 4);
        self.pair(band, (4, 1, "line, 4 px"), wide, |at| {
            Line::new(at + Point::new(3, 20), at + Point::new(24, 7))
        });
    }

    fn draw_caps<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>) {
        let caps = [
            ("butt", LineCap::Butt),
            ("pixel", LineCap::WholePixel),
            ("square", LineCap::Square),
            ("round", LineCap::Round),
        ];
        for (column, (text, cap)) in (0..).zip(caps) {
            let style = StrokeStyle::new(LINE, 7).cap(cap);
            self.stroked(band, (column, 2, text), style, |at| {
                Line::new(at + Point::new(7, 20), at + Point::new(20, 8))
            });
        }
        let frame = StrokeStyle::new(LINE, 3).join(LineJoin::Round);
        self.stroked(band, (4, 2, "closed, round"), frame, |at| {
            let vertex = |x: i32, y: i32| at + Point::new(x, y);
            Triangle::new(vertex(3, 24), vertex(24, 19), vertex(11, 3))
        });
    }

    fn draw_joins<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>) {
        let joins = [
            ("miter", LineJoin::MITER),
            ("bevel", LineJoin::Bevel),
            ("round", LineJoin::Round),
        ];
        for (column, (text, join)) in (0..).zip(joins) {
            let style = StrokeStyle::new(DASHED, 5).cap(LineCap::Butt).join(join);
            self.hook(band, (column, 3, text), style);
        }
    }

    fn draw_dashes<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>) {
        let style = StrokeStyle::new(DASHED, 3).cap(LineCap::Butt);
        self.hook(band, (3, 3, "dashes"), style.dashes(&DASHES));
        self.hook(band, (4, 3, "dots"), style.cap(LineCap::Round).dashes(&DOTS));
    }

    fn hook<O: Order>(
        &mut self,
        band: &mut Band<'_, Rgb565, O>,
        (column, row, text): (i32, i32, &str),
        style: StrokeStyle<'_, Rgb565>,
    ) {
        let left = cell(column, row);
        name(band, text, left);
        let at = |offset: Point| HOOK.map(|point| point + offset);
        shape(band, &Polyline::new(&at(left)).into_styled(style));
        self.smooth(
            band,
            &Polyline::new(&at(left + BESIDE)).into_styled(style.antialiased()),
        );
    }
}
