//! Bézier curves and what they become: their control points, their lines at several tolerances, filled and stroked paths;
//! and polynomials by forward differences.

use embedded_graphics::{
    mono_font::ascii::FONT_5X8,
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Line, PrimitiveStyleBuilder, Rectangle},
    text::Alignment,
};
use fixed::types::{I12F4, U8F8};
use zrow::{
    band::{Band, Order},
    draw::{
        FillRule, Path,
        PathCommand::{self, Close, CubicTo, LineTo, MoveTo, QuadraticTo},
        PreparedShape, PrimitiveStyle,
    },
    geometry::{InputError, Sub4, SubPoint},
    scan::{self, Bezier, PolynomialForwardDifference},
};

use crate::{
    PrepareError, Prepared, Scene,
    paint::{TITLE_COLOR, label, rgb, shape, title},
};

type Corner = SubPoint<Sub4>;

const LABEL_COLOR: Rgb565 = rgb(150, 165, 190);
const HULL: Rgb565 = rgb(96, 106, 128);
const CURVE: Rgb565 = rgb(255, 202, 40);
const DOT: Rgb565 = rgb(236, 64, 122);

/// A point in pixels.
const fn at(x: i16, y: i16) -> Corner {
    SubPoint {
        x: I12F4::from_bits(x * 16),
        y: I12F4::from_bits(y * 16),
    }
}

/// A cubic and a quadratic, by their control points.
const CUBIC: [Corner; 4] = [at(10, 98), at(34, 20), at(66, 106), at(86, 24)];
const QUADRATIC: [Corner; 3] = [at(100, 98), at(124, 20), at(150, 98)];

const CUBIC_PATH: [PathCommand<Sub4>; 4] = [
    MoveTo(CUBIC[0]),
    CubicTo(CUBIC[1], CUBIC[2], CUBIC[3]),
    MoveTo(QUADRATIC[0]),
    QuadraticTo(QUADRATIC[1], QUADRATIC[2]),
];

/// One curve, flattened three times: where it is moved to, and the tolerance.
const FLATTENED: [(i16, U8F8, &str); 3] = [
    (0, U8F8::lit("8"), "8 px"),
    (52, U8F8::lit("1"), "1 px"),
    (104, U8F8::lit("0.125"), "1/8 px"),
];

/// The curve that is flattened.
const fn bent(x: i16) -> [Corner; 4] {
    [at(170 + x, 102), at(162 + x, 10), at(216 + x, 118), at(206 + x, 28)]
}

/// A letter with two holes, of straight lines and quadratics.
const LETTER: [PathCommand<Sub4>; 20] = [
    MoveTo(at(12, 140)),
    LineTo(at(38, 140)),
    QuadraticTo(at(58, 140), at(58, 158)),
    QuadraticTo(at(58, 171), at(47, 175)),
    QuadraticTo(at(62, 179), at(62, 196)),
    QuadraticTo(at(62, 216), at(38, 216)),
    LineTo(at(12, 216)),
    Close,
    MoveTo(at(27, 151)),
    LineTo(at(36, 151)),
    QuadraticTo(at(45, 151), at(45, 160)),
    QuadraticTo(at(45, 170), at(35, 170)),
    LineTo(at(27, 170)),
    Close,
    MoveTo(at(27, 181)),
    LineTo(at(37, 181)),
    QuadraticTo(at(48, 181), at(48, 193)),
    QuadraticTo(at(48, 205), at(37, 205)),
    LineTo(at(27, 205)),
    Close,
];

/// A heart of four cubics.
const HEART: [PathCommand<Sub4>; 6] = [
    MoveTo(at(113, 216)),
    CubicTo(at(96, 200), at(74, 184), at(74, 162)),
    CubicTo(at(74, 136), at(108, 134), at(113, 158)),
    CubicTo(at(118, 134), at(152, 136), at(152, 162)),
    CubicTo(at(152, 184), at(130, 200), at(113, 216)),
    Close,
];

/// Chebyshev's polynomials (1854) of degree 2 to 5, from -1 to 1, with their colours: the coefficients of 1, t and so on.
const CHEBYSHEV: [([i32; 6], Rgb565); 4] = [
    ([1, -8, 8, 0, 0, 0], rgb(38, 198, 218)),
    ([-1, 18, -48, 32, 0, 0], rgb(156, 204, 101)),
    ([1, -32, 160, -256, 128, 0], rgb(171, 130, 235)),
    ([-1, 50, -400, 1120, -1280, 512], rgb(255, 138, 101)),
];
const PLOT: Rectangle = Rectangle::new(Point::new(176, 140), Size::new(129, 77));

/// The scene: what it keeps is in the frame.
#[derive(Debug, Default)]
pub struct Curves;

/// Everything that has a table or can be refused.
#[derive(Debug)]
pub struct Frame {
    controls: Path<'static, Sub4>,
    letter: PreparedShape<Path<'static, Sub4>, 60, 6>,
    heart: PreparedShape<Path<'static, Sub4>, 60, 6>,
    polynomials: [(PolynomialForwardDifference<6>, Rgb565); 4],
}

impl Scene for Curves {
    type Color = Rgb565;
    type Prepared<'s> = Frame;
    const NAME: &'static str = "curves";
    const TITLE: &'static str = "curves: Beziers, paths, polynomials";
    const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(320, 240));
    const BACKGROUND: Rgb565 = rgb(16, 20, 28);

    fn prepare(&mut self, _frame: u32) -> Result<Frame, PrepareError> {
        Ok(Frame {
            controls: Path::new(&CUBIC_PATH, FillRule::EvenOdd)?,
            letter: Path::new(&LETTER, FillRule::EvenOdd)?.prepare()?,
            heart: Path::new(&HEART, FillRule::NonZero)?.prepare()?,
            polynomials: CHEBYSHEV.map(|(coefficients, color)| (walk(coefficients), color)),
        })
    }
}

/// The values of a polynomial as rows of the plot, at each of its columns.
fn walk(coefficients: [i32; 6]) -> PolynomialForwardDifference<6> {
    const HALF: i32 = PLOT.size.height as i32 / 2;
    let mut rows = coefficients.map(|coefficient| -HALF * coefficient);
    rows[0] += PLOT.top_left.y + HALF;
    // 128 steps of degree 5 take 35 guard bits: never too fine.
    let walk: Result<_, InputError> = PolynomialForwardDifference::dyadic(&rows, 7);
    walk.unwrap_or_else(|_| PolynomialForwardDifference::rounded(&rows, 128, 32))
}

impl Prepared for Frame {
    type Color = Rgb565;

    fn draw<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>) {
        title::<Curves, O>(band);
        draw_controls(band, &self.controls);
        draw_flattened(band);
        draw_paths(band, &self.letter, &self.heart);
        draw_polynomials(band, &self.polynomials);
    }
}

fn small<O: Order>(band: &mut Band<'_, Rgb565, O>, text: &str, x: i32, y: i32) {
    label(band, text, Point::new(x, y), Alignment::Center, &FONT_5X8, LABEL_COLOR);
}

fn pixel(point: &Corner) -> Point {
    Point::new(point.x.round().to_num(), point.y.round().to_num())
}

fn line<O: Order>(band: &mut Band<'_, Rgb565, O>, from: Point, to: Point, color: Rgb565) {
    shape(
        band,
        &Line::new(from, to).into_styled(PrimitiveStyle::with_stroke(color, 1)),
    );
}

fn dot<O: Order>(band: &mut Band<'_, Rgb565, O>, center: Point, color: Rgb565) {
    let square = Rectangle::with_center(center, Size::new_equal(3));
    shape(band, &square.into_styled(PrimitiveStyle::with_fill(color)));
}

fn draw_controls<O: Order>(band: &mut Band<'_, Rgb565, O>, path: &Path<'static, Sub4>) {
    small(band, "a cubic, a quadratic", 80, 112);
    for controls in [&CUBIC[..], &QUADRATIC] {
        for (from, to) in controls.iter().zip(controls.iter().skip(1)) {
            line(band, pixel(from), pixel(to), HULL);
        }
    }
    shape(band, &path.into_styled(PrimitiveStyle::with_stroke(CURVE, 1)));
    for point in CUBIC.iter().chain(&QUADRATIC) {
        dot(band, pixel(point), DOT);
    }
}

fn draw_flattened<O: Order>(band: &mut Band<'_, Rgb565, O>) {
    small(band, "flattened to within", 240, 16);
    for (x, tolerance, name) in FLATTENED {
        small(band, name, 188 + i32::from(x), 112);
        let controls = bent(x);
        let Ok(curve) = Bezier::new(controls) else { continue };
        let mut from = pixel(&controls[0]);
        dot(band, from, DOT);
        for end in scan::Bezier::adaptive_forward_difference(&curve, tolerance) {
            let to = Point::new(end.x.round().to_num(), end.y.round().to_num());
            line(band, from, to, CURVE);
            dot(band, from, DOT);
            dot(band, to, DOT);
            from = to;
        }
    }
}

fn draw_paths<O: Order, const A: usize, const B: usize>(
    band: &mut Band<'_, Rgb565, O>,
    letter: &PreparedShape<Path<'static, Sub4>, A, 6>,
    heart: &PreparedShape<Path<'static, Sub4>, B, 6>,
) {
    small(band, "with holes", 38, 226);
    small(band, "stroked", 113, 226);
    let fill = PrimitiveStyle::with_fill(rgb(38, 198, 218));
    shape(band, &letter.into_styled(fill));
    let both: PrimitiveStyle<_> = PrimitiveStyleBuilder::new()
        .fill_color(DOT)
        .stroke_color(TITLE_COLOR)
        .stroke_width(3)
        .build()
        .into();
    shape(band, &heart.into_styled(both));
}

fn draw_polynomials<O: Order>(
    band: &mut Band<'_, Rgb565, O>,
    polynomials: &[(PolynomialForwardDifference<6>, Rgb565)],
) {
    small(band, "polynomials of degree 2 to 5", 240, 226);
    let middle = PLOT.center();
    let last = PLOT.top_left.x + 128;
    line(
        band,
        Point::new(PLOT.top_left.x, middle.y),
        Point::new(last, middle.y),
        HULL,
    );
    for (walk, color) in polynomials {
        let mut walk = *walk;
        let mut from = Point::new(PLOT.top_left.x, walk.value() as i32);
        while from.x < last {
            walk.advance();
            let to = Point::new(from.x + 1, walk.value() as i32);
            line(band, from, to, *color);
            from = to;
        }
    }
}
