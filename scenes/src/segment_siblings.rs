//! Clipping before and after: segments against an upright and a convex window, what Nicholl, Lee and Nicholl's rays
//! decide, and a polygon that Sutherland and Hodgman cut side by side.

use embedded_graphics::{
    Pixel,
    mono_font::ascii::{FONT_5X8, FONT_6X10},
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Circle, Line, Polyline, Rectangle},
    text::Alignment,
};
use fixed::types::I12F4;
use zrow::{
    band::{Band, Order},
    clip::Segments,
    draw::{FillRule, Polygon, PrimitiveStyle},
    geometry::{ConvexWindow, FixedPointWindow, Sub4, SubPoint},
};

use crate::{
    PrepareError, Prepared, Scene,
    paint::{label, rgb, shape},
};

type Corner = SubPoint<Sub4>;

const TITLE_COLOR: Rgb565 = rgb(255, 255, 255);
const LABEL_COLOR: Rgb565 = rgb(165, 178, 200);
const WINDOW: Rgb565 = rgb(255, 213, 79);
/// What is cut off, and what is not visible at all.
const CUT_OFF: Rgb565 = rgb(96, 104, 124);
const REJECTED: Rgb565 = rgb(214, 84, 84);
/// What is left of a segment that is cut, and one that is inside.
const KEPT: Rgb565 = rgb(90, 210, 250);
const WHOLE: Rgb565 = rgb(129, 230, 150);
const FILL: Rgb565 = rgb(34, 92, 130);

/// A point in pixels.
const fn at(x: i16, y: i16) -> Corner {
    SubPoint {
        x: I12F4::from_bits(x * 16),
        y: I12F4::from_bits(y * 16),
    }
}

/// The upright window, and what crosses it or does not.
const UPRIGHT: [Corner; 2] = [at(42, 50), at(122, 96)];
const SEGMENTS: [[Corner; 2]; 16] = [
    [at(8, 40), at(154, 58)],
    [at(12, 120), at(92, 32)],
    [at(30, 34), at(150, 114)],
    [at(60, 118), at(132, 40)],
    [at(52, 60), at(84, 56)],
    [at(92, 74), at(114, 90)],
    [at(60, 90), at(78, 78)],
    [at(10, 66), at(70, 72)],
    [at(100, 62), at(152, 82)],
    [at(20, 80), at(56, 116)],
    [at(8, 92), at(30, 118)],
    [at(104, 32), at(152, 48)],
    [at(118, 40), at(130, 64)],
    [at(132, 116), at(154, 90)],
    [at(14, 36), at(34, 60)],
    [at(80, 112), at(122, 106)],
];

/// Windows seen from a start that is inside, beyond one side, and beyond two.
const SEEN_FROM: [(&str, i16, (i16, i16)); 3] = [
    ("inside", 164, (28, 46)),
    ("one side", 216, (4, 46)),
    ("corner", 268, (5, 10)),
];
const SEEN_TOP: i16 = 30;
const SEEN_SIZE: Size = Size::new(48, 84);
const SEEN_WINDOW: [(i16, i16); 2] = [(14, 26), (36, 60)];
/// The side that is left through: left, right, above, below.
const SIDES: [Rgb565; 4] = [
    rgb(236, 80, 110),
    rgb(70, 160, 240),
    rgb(250, 180, 60),
    rgb(150, 110, 235),
];
const ENDS_INSIDE: Rgb565 = rgb(190, 220, 190);
const NOT_VISIBLE: Rgb565 = rgb(34, 38, 50);

const HEXAGON: [Corner; 6] = [
    at(46, 160),
    at(96, 150),
    at(128, 184),
    at(108, 224),
    at(62, 230),
    at(32, 198),
];
/// Parallel segments: the rows of their left ends.
const PARALLELS: [i16; 9] = [150, 158, 166, 174, 184, 194, 204, 214, 224];

/// Concave: without its upper part, its legs hang together by a bridge.
const COMB: [(i16, i16); 8] = [
    (-2, 8),
    (36, 0),
    (40, 30),
    (28, 33),
    (27, 14),
    (14, 16),
    (12, 33),
    (2, 30),
];
/// Windows with no side near the polygon, then with the left one, the upper, the right and the lower one as well.
const STEPS: [[(i16, i16); 2]; 5] = [
    [(-40, -40), (80, 80)],
    [(6, -40), (80, 80)],
    [(6, 20), (80, 80)],
    [(6, 20), (34, 80)],
    [(6, 20), (34, 29)],
];
/// What is shown of a window.
const FIELD: [(i16, i16); 2] = [(-3, -1), (43, 35)];
const OBLIQUE: [(i16, i16); 3] = [(3, 3), (37, 12), (14, 34)];
const STEPS_AT: [(i16, i16, &str); 6] = [
    (169, 146, "polygon"),
    (221, 146, "left"),
    (273, 146, "upper"),
    (169, 192, "right"),
    (221, 192, "lower"),
    (273, 192, "oblique"),
];

/// The scene; nothing outlives a row.
#[derive(Debug, Default)]
pub struct SegmentSiblings;

impl Scene for SegmentSiblings {
    type Color = Rgb565;
    type Prepared<'s> = &'s mut Self;
    const NAME: &'static str = "segment-siblings";
    const TITLE: &'static str = "clipping: before and after";
    const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(320, 240));
    const BACKGROUND: Rgb565 = rgb(16, 20, 28);

    fn prepare(&mut self, _frame: u32) -> Result<&mut Self, PrepareError> {
        ConvexWindow::new(&HEXAGON)?;
        for step in 0..STEPS_AT.len() {
            with_step(step, |_, _| {})?;
        }
        Ok(self)
    }
}

impl Prepared for SegmentSiblings {
    type Color = Rgb565;

    fn draw<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>) {
        let title = |band: &mut _, text, x, y| {
            label(band, text, Point::new(x, y), Alignment::Center, &FONT_6X10, TITLE_COLOR);
        };
        title(band, "midpoint subdivision", 81, 4);
        title(band, "Nicholl-Lee-Nicholl", 240, 4);
        title(band, "Cyrus-Beck", 81, 134);
        title(band, "Sutherland-Hodgman", 240, 134);
        for (text, x, color) in [("inside", 30, WHOLE), ("cut", 70, KEPT), ("outside", 114, REJECTED)] {
            label(band, text, Point::new(x, 17), Alignment::Center, &FONT_5X8, color);
        }
        let legend = "coloured by the side it leaves";
        let under = Point::new(240, 17);
        label(band, legend, under, Alignment::Center, &FONT_5X8, LABEL_COLOR);
        draw_segments(band);
        for part in SEEN_FROM {
            draw_seen_from(band, part);
        }
        draw_parallels(band);
        for (step, (x, y, name)) in STEPS_AT.into_iter().enumerate() {
            let drawn = with_step(step, |window, part| draw_step(band, step, window, part));
            debug_assert!(drawn.is_ok(), "it was prepared before");
            let under = Point::new(i32::from(x) + 18, i32::from(y) + 37);
            label(band, name, under, Alignment::Center, &FONT_5X8, LABEL_COLOR);
        }
    }
}

/// The nearest pixel.
fn pixel(corner: Corner) -> Point {
    let round = |units: i32| (units + 8) >> 4;
    Point::new(round(corner.x_units()), round(corner.y_units()))
}

fn line<O: Order>(band: &mut Band<'_, Rgb565, O>, from: Corner, to: Corner, color: Rgb565) {
    let line = Line::new(pixel(from), pixel(to));
    shape(band, &line.into_styled(PrimitiveStyle::with_stroke(color, 1)));
}

/// A closed line through up to 16 corners.
fn outline<O: Order>(band: &mut Band<'_, Rgb565, O>, corners: &[Corner], color: Rgb565) {
    let mut points = [Point::zero(); 17];
    let closed = corners.iter().chain(corners.first());
    let count = points
        .iter_mut()
        .zip(closed)
        .map(|(point, &corner)| *point = pixel(corner))
        .count();
    let polyline = Polyline::new(points.get(..count).unwrap_or_default());
    shape(band, &polyline.into_styled(PrimitiveStyle::with_stroke(color, 1)));
}

fn draw_segments<O: Order>(band: &mut Band<'_, Rgb565, O>) {
    let [first, last] = UPRIGHT;
    let Ok(window) = FixedPointWindow::new(first, last) else {
        return;
    };
    outline(band, &upright(first, last), WINDOW);
    for [from, to] in SEGMENTS {
        draw_clipped(band, (from, to), Segments::midpoint_subdivision(from, to, &window));
    }
}

fn draw_parallels<O: Order>(band: &mut Band<'_, Rgb565, O>) {
    let Ok(window) = ConvexWindow::new(&HEXAGON) else {
        return;
    };
    outline(band, &HEXAGON, WINDOW);
    for y in PARALLELS {
        let (from, to) = (at(6, y), at(156, y + 14));
        let part = Segments::cyrus_beck(from, to, &window);
        draw_clipped(band, (from, to), part.map(|part| part.ends_within(&window)));
    }
}

/// A segment as it was, and over it what is left of it, with its new ends.
fn draw_clipped<O: Order>(band: &mut Band<'_, Rgb565, O>, whole: (Corner, Corner), part: Option<(Corner, Corner)>) {
    let Some((start, end)) = part else {
        return line(band, whole.0, whole.1, REJECTED);
    };
    if part == Some(whole) {
        return line(band, start, end, WHOLE);
    }
    line(band, whole.0, whole.1, CUT_OFF);
    line(band, start, end, KEPT);
    for (old, new) in [(whole.0, start), (whole.1, end)] {
        if old != new {
            let dot = Circle::with_center(pixel(new), 3);
            shape(band, &dot.into_styled(PrimitiveStyle::with_fill(TITLE_COLOR)));
        }
    }
}

const fn upright(first: Corner, last: Corner) -> [Corner; 4] {
    let (upper, lower) = (Corner { x: last.x, y: first.y }, Corner { x: first.x, y: last.y });
    [first, upper, last, lower]
}

/// Each pixel in the colour of the side by which a segment to it leaves; hatched where it enters from above.
fn draw_seen_from<O: Order>(band: &mut Band<'_, Rgb565, O>, (name, left, (x, y)): (&str, i16, (i16, i16))) {
    let area = Rectangle::new(Point::new(left.into(), SEEN_TOP.into()), SEEN_SIZE);
    let [first, last] = SEEN_WINDOW.map(|(x, y)| at(left + x, SEEN_TOP + y));
    let from = at(left + x, SEEN_TOP + y);
    let Ok(window) = FixedPointWindow::new(first, last) else {
        return;
    };
    let pixels = area.intersection(&band.bounding_box()).points().map(|to| {
        let color = SubPoint::from_pixel(to).map_or(NOT_VISIBLE, |to| color_of_exit(from, to, &window));
        let enters_above = y < SEEN_WINDOW[0].1 && enters_above(from, to, &window);
        let is_hatched = enters_above && (to.x + to.y) % 3 == 0;
        Pixel(to, if is_hatched { NOT_VISIBLE } else { color })
    });
    let Ok(()) = band.draw_iter(pixels);
    outline(band, &upright(first, last), TITLE_COLOR);
    let dot = Circle::with_center(pixel(from), 5);
    shape(band, &dot.into_styled(PrimitiveStyle::with_fill(TITLE_COLOR)));
    let under = Point::new(i32::from(left) + 24, i32::from(SEEN_TOP) + 87);
    label(band, name, under, Alignment::Center, &FONT_5X8, LABEL_COLOR);
}

fn enters_above(from: Corner, to: Point, window: &FixedPointWindow<Sub4>) -> bool {
    SubPoint::from_pixel(to)
        .ok()
        .and_then(|to| Segments::nicholl_lee_nicholl(from, to, window))
        .is_some_and(|(start, _)| start.y == window.top_left().y)
}

fn color_of_exit(from: Corner, to: Corner, window: &FixedPointWindow<Sub4>) -> Rgb565 {
    let Some((_, end)) = Segments::nicholl_lee_nicholl(from, to, window) else {
        return NOT_VISIBLE;
    };
    let [left, right, above, below] = SIDES;
    let (first, last) = (window.top_left(), window.bottom_right());
    match end {
        end if end == to => ENDS_INSIDE,
        end if end.x == first.x => left,
        end if end.x == last.x => right,
        end if end.y == first.y => above,
        _ => below,
    }
}

/// The window of a step, and what it leaves of the polygon.
fn with_step(step: usize, draw: impl FnOnce(&[Corner], &[Corner])) -> Result<(), PrepareError> {
    let polygon = COMB.map(|corner| moved(step, corner));
    if let Some(&sides) = STEPS.get(step) {
        let [first, last] = sides.map(|corner| moved(step, corner));
        clip_step(&polygon, &upright(first, last), draw)
    } else {
        clip_step(&polygon, &OBLIQUE.map(|corner| moved(step, corner)), draw)
    }
}

fn clip_step(
    polygon: &[Corner],
    window: &[Corner],
    draw: impl FnOnce(&[Corner], &[Corner]),
) -> Result<(), PrepareError> {
    let part = ConvexWindow::new(window)?.sutherland_hodgman_2d::<16, 4>(polygon)?;
    draw(window, &part);
    Ok(())
}

fn moved(step: usize, (x, y): (i16, i16)) -> Corner {
    let (left, top, _) = STEPS_AT.get(step).copied().unwrap_or_default();
    at(left + x, top + y)
}

fn draw_step<O: Order>(band: &mut Band<'_, Rgb565, O>, step: usize, window: &[Corner], part: &[Corner]) {
    outline(band, &COMB.map(|corner| moved(step, corner)), CUT_OFF);
    let contours = [part];
    if let Ok(ready) = Polygon::new(&contours, FillRule::NonZero).prepare::<16, 16>() {
        shape(band, &ready.into_styled(PrimitiveStyle::with_fill(FILL)));
    }
    outline_within(band, step, window);
    outline(band, part, KEPT);
}

/// What of the window's sides lies in the field of its step.
fn outline_within<O: Order>(band: &mut Band<'_, Rgb565, O>, step: usize, window: &[Corner]) {
    let [first, last] = FIELD.map(|corner| moved(step, corner));
    let Ok(field) = FixedPointWindow::new(first, last) else {
        return;
    };
    let ends = window.iter().skip(1).chain(window.first());
    for (&from, &to) in window.iter().zip(ends) {
        if let Some((from, to)) = Segments::liang_barsky(from, to, &field) {
            line(band, from, to, WINDOW);
        }
    }
}
