//! Shapes in antialiased styles, against the ideal shapes in `f64`, sampled at 32 x 32 points of each pixel; against the
//! shapes without antialiasing where they are to be equal; and in memory of any size.

use std::{convert::Infallible, f64::consts::TAU};

use embedded_graphics::{
    geometry::{Angle, Point, Size},
    pixelcolor::{Gray8, GrayColor},
    prelude::*,
    primitives::{
        Arc, Circle, CornerRadii, Ellipse, Line, Polyline, Rectangle, RoundedRectangle, Sector, StrokeAlignment,
        Styled, Triangle,
    },
};
use fixed::types::{U0F16, U16F16, U24F8};
use zrow::{
    band::Band,
    draw::{
        DashPattern, DrawAntialiased, DrawOn, FillRule, LineCap, LineJoin, Path, PathCommand, Polygon, PrimitiveStyle,
        PrimitiveStyleBuilder, StrokeStyle, SubArc, SubEllipse, SubLine,
    },
    geometry::{DrawError, Sub8, SubPoint, Table, TooSmall},
};

/// Random numbers from a fixed seed (xorshift32, Marsaglia 2003).
struct Xorshift(u32);

impl Xorshift {
    fn new(seed: u32) -> Self {
        Self(seed)
    }

    /// A number from the first one to the last one.
    fn between(&mut self, first: i32, last: i32) -> i32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        first + (self.0 % (last - first + 1) as u32) as i32
    }
}

const SIDE: u32 = 48;
const AREA: Rectangle = Rectangle::new(Point::new(-3, -2), Size::new(SIDE, SIDE));
const ALIGNMENTS: [StrokeAlignment; 3] = [
    StrokeAlignment::Inside,
    StrokeAlignment::Center,
    StrokeAlignment::Outside,
];
const CAPS: [LineCap; 4] = [LineCap::WholePixel, LineCap::Butt, LineCap::Square, LineCap::Round];

/// Edges of every outline of these tests, and those in one row.
const EDGES: usize = 4_096;
const ACTIVE: usize = 512;

/// The coverage of each pixel of the area by what is drawn in white on black.
fn coverage(shape: &impl DrawAntialiased<Color = Gray8>) -> Vec<u8> {
    in_bands(shape, SIDE)
}

fn in_bands(shape: &impl DrawAntialiased<Color = Gray8>, rows: u32) -> Vec<u8> {
    let mut row = [0; SIDE as usize + 1];
    let mut picture = Vec::new();
    for top in (0..SIDE).step_by(rows as usize) {
        let mut words = vec![0; (SIDE * rows) as usize];
        let area = Rectangle::new(AREA.top_left + Point::new(0, top as i32), Size::new(SIDE, rows));
        let mut band = Band::<Gray8>::new(area, &mut words).unwrap();
        shape.draw_on(&mut band.antialiased::<EDGES, ACTIVE>(&mut row)).unwrap();
        assert_eq!(row, [0; SIDE as usize + 1]);
        picture.extend(words);
    }
    picture.truncate((SIDE * SIDE) as usize);
    picture
}

/// The coverage of each pixel of the area by the points that `is_inside`.
fn ideal(is_inside: impl Fn(f64, f64) -> bool) -> Vec<f64> {
    const SAMPLES: i32 = 32;
    let offsets = || (0..SAMPLES).map(|index| (f64::from(index) + 0.5) / f64::from(SAMPLES) - 0.5);
    AREA.points()
        .map(|pixel| {
            let (x, y) = (f64::from(pixel.x), f64::from(pixel.y));
            let inside = offsets().flat_map(|right| offsets().map(move |down| (right, down)));
            let inside = inside.filter(|(right, down)| is_inside(x + right, y + down)).count();
            inside as f64 / f64::from(SAMPLES * SAMPLES)
        })
        .collect()
}

/// Chords are up to 1/64 pixel inside of a curve, 5.7/255 along the diagonal of a pixel; corners are rounded to 1/256 pixel,
/// 1.5/255; the ideal is sampled, up to 4/255 along a row.
const BOUND: f64 = 12.0;

/// Compares a drawn shape with an ideal one: every pixel within the bound, and all edge pixels together within a quarter of
/// it.
fn compare(name: &str, shape: &impl DrawAntialiased<Color = Gray8>, is_inside: impl Fn(f64, f64) -> bool) {
    let drawn = coverage(shape);
    assert_eq!(drawn, in_bands(shape, 1), "{name} in bands");
    let (mut sum, mut edges) = (0.0, 0);
    for (pixel, (&drawn, ideal)) in AREA.points().zip(drawn.iter().zip(ideal(is_inside))) {
        let error = f64::from(drawn) - 255.0 * ideal;
        assert!(
            error.abs() <= BOUND,
            "{name}, {pixel:?}: {drawn}, not {}",
            255.0 * ideal
        );
        if 0.0 < ideal && ideal < 1.0 {
            (sum, edges) = (sum + error, edges + 1);
        }
    }
    let mean = sum / f64::from(edges.max(40));
    assert!(
        mean.abs() <= BOUND / 4.0,
        "{name}: {mean} in the mean over {edges} pixels"
    );
}

fn fill() -> PrimitiveStyle<Gray8> {
    PrimitiveStyle::with_fill(Gray8::WHITE)
}

fn stroke(width: u32, alignment: StrokeAlignment) -> PrimitiveStyle<Gray8> {
    PrimitiveStyleBuilder::new()
        .stroke_color(Gray8::WHITE)
        .stroke_width(width)
        .stroke_alignment(alignment)
        .build()
}

/// A fill in a colour, in a white stroke.
fn filled(color: Gray8, width: u32, alignment: StrokeAlignment) -> PrimitiveStyle<Gray8> {
    let mut style = stroke(width, alignment);
    style.fill_color = Some(color);
    style
}

/// The widths of a stroke inside and outside of a shape of whole pixels.
fn widths(style: &PrimitiveStyle<Gray8>) -> (f64, f64) {
    (style.inside_stroke_width().into(), style.outside_stroke_width().into())
}

/// Compares the fill and the strokes of a closed shape whose `curve` is given in a box that is moved outwards.
fn compare_closed<S: Primitive + Copy + std::fmt::Debug>(shape: S, width: u32, curve: impl Fn(f64, f64, f64) -> bool)
where
    Styled<S, zrow::draw::Antialiased<PrimitiveStyle<Gray8>>>: DrawAntialiased<Color = Gray8>,
{
    compare(
        &format!("{shape:?}"),
        &shape.into_styled(fill().antialiased()),
        |x, y| curve(x, y, 0.0),
    );
    for alignment in ALIGNMENTS {
        let style = stroke(width, alignment);
        let (inside, outside) = widths(&style);
        let name = format!("{shape:?}, {width} {alignment:?}");
        compare(&name, &shape.into_styled(style.antialiased()), |x, y| {
            curve(x, y, outside) && !curve(x, y, -inside)
        });
    }
}

/// Whether a point is in the ellipse of a box.
fn in_ellipse(around: &Rectangle, beyond: f64, x: f64, y: f64) -> bool {
    let axis = |start: i32, length: u32, at: f64| {
        let radius = f64::from(length) / 2.0 + beyond;
        (at - f64::from(start) - (f64::from(length) - 1.0) / 2.0, radius)
    };
    let (right, across) = axis(around.top_left.x, around.size.width, x);
    let (below, down) = axis(around.top_left.y, around.size.height, y);
    across > 0.0 && down > 0.0 && (right / across).powi(2) + (below / down).powi(2) < 1.0
}

#[test]
fn circles_and_ellipses() {
    let mut random = Xorshift::new(0x0c1e);
    for _ in 0..12 {
        let top_left = Point::new(random.between(-8, 20), random.between(-8, 20));
        let size = Size::new(random.between(1, 40) as u32, random.between(1, 40) as u32);
        let width = random.between(1, 6) as u32;
        let circle = Circle::new(top_left, size.width);
        compare_closed(circle, width, |x, y, beyond| {
            in_ellipse(&circle.bounding_box(), beyond, x, y)
        });
        let ellipse = Ellipse::new(top_left, size);
        compare_closed(ellipse, width, |x, y, beyond| {
            in_ellipse(&ellipse.bounding_box(), beyond, x, y)
        });
    }
}

/// Radii that fit, so that they are not scaled down.
#[test]
fn rounded_rectangles() {
    let mut random = Xorshift::new(0x4e41);
    for _ in 0..12 {
        let around = Rectangle::new(
            Point::new(random.between(-8, 10), random.between(-8, 10)),
            Size::new(random.between(20, 40) as u32, random.between(20, 40) as u32),
        );
        let mut radius = || Size::new(random.between(0, 10) as u32, random.between(0, 10) as u32);
        let corners = CornerRadii {
            top_left: radius(),
            top_right: radius(),
            bottom_right: radius(),
            bottom_left: radius(),
        };
        let shape = RoundedRectangle::new(around, corners);
        compare_closed(shape, random.between(1, 4) as u32, |x, y, beyond| {
            let (left, top) = (f64::from(around.top_left.x) - 0.5, f64::from(around.top_left.y) - 0.5);
            let (right, bottom) = (left + f64::from(around.size.width), top + f64::from(around.size.height));
            let corner = |from_left: f64, from_top: f64, radius: Size| {
                let (across, down) = (f64::from(radius.width) + beyond, f64::from(radius.height) + beyond);
                let (right, down_from) = (across - from_left, down - from_top);
                across <= 0.0
                    || down <= 0.0
                    || right <= 0.0
                    || down_from <= 0.0
                    || (right / across).powi(2) + (down_from / down).powi(2) < 1.0
            };
            let (from_left, from_top) = (x - left + beyond, y - top + beyond);
            let (from_right, from_bottom) = (right + beyond - x, bottom + beyond - y);
            from_left.min(from_right).min(from_top).min(from_bottom) > 0.0
                && corner(from_left, from_top, corners.top_left)
                && corner(from_right, from_top, corners.top_right)
                && corner(from_right, from_bottom, corners.bottom_right)
                && corner(from_left, from_bottom, corners.bottom_left)
        });
    }
}

/// The middle of a circle's box.
fn middle(top_left: Point, diameter: u32) -> (f64, f64) {
    let half = (f64::from(diameter) - 1.0) / 2.0;
    (f64::from(top_left.x) + half, f64::from(top_left.y) + half)
}

/// Degrees from one angle to the direction of a point, clockwise.
fn degrees_from(start: f64, x: f64, y: f64) -> f64 {
    (y.atan2(x).to_degrees() - start).rem_euclid(360.0)
}

#[test]
fn arcs() {
    let mut random = Xorshift::new(0xa4c5);
    for index in 0..24 {
        let diameter = random.between(8, 40) as u32;
        let top_left = Point::new(random.between(-8, 10), random.between(-8, 10));
        let (start, sweep) = (random.between(-400, 400), random.between(-359, 359));
        let sweep = if index == 0 { 360 } else { sweep };
        let (start, sweep) = (start as f32, sweep as f32);
        let arc = Arc::new(
            top_left,
            diameter,
            Angle::from_degrees(start),
            Angle::from_degrees(sweep),
        );
        let style = stroke(random.between(1, 6) as u32, ALIGNMENTS[index % 3]);
        let (inside, outside) = widths(&style);
        let first = f64::from(start + sweep.min(0.0));
        let (center_x, center_y) = middle(top_left, diameter);
        compare(
            &format!("{arc:?}, {style:?}"),
            &arc.into_styled(style.antialiased()),
            |x, y| {
                let around = arc.bounding_box();
                let is_between = degrees_from(first, x - center_x, y - center_y) < f64::from(sweep.abs());
                is_between && in_ellipse(&around, outside, x, y) && !in_ellipse(&around, -inside, x, y)
            },
        );
    }
}

/// Between 60 and 300 degrees: sharper corners are cut off.
#[test]
fn sectors() {
    let mut random = Xorshift::new(0x5ec7);
    for _ in 0..12 {
        let diameter = random.between(20, 40) as u32;
        let top_left = Point::new(random.between(-8, 10), random.between(-8, 10));
        let (start, sweep) = (f64::from(random.between(-400, 400)), f64::from(random.between(60, 300)));
        let angle = |degrees: f64| Angle::from_degrees(degrees as f32);
        let sector = Sector::new(top_left, diameter, angle(start), angle(sweep));
        let (center_x, center_y) = middle(top_left, diameter);
        compare_closed(sector, random.between(1, 4) as u32, |x, y, beyond| {
            // How far the point lies beyond a side: to its left or to its right.
            let beyond_side = |degrees: f64, sign: f64| {
                let (sine, cosine) = degrees.to_radians().sin_cos();
                sign * ((y - center_y) * cosine - (x - center_x) * sine)
            };
            let (first, last) = (beyond_side(start, -1.0), beyond_side(start + sweep, 1.0));
            let nearest = if sweep < 180.0 {
                first.max(last)
            } else {
                first.min(last)
            };
            nearest < beyond + 0.5 && in_ellipse(&sector.bounding_box(), beyond, x, y)
        });
    }
}

/// Angles above 40 degrees, so that the corners are miters.
#[test]
fn triangles() {
    let mut random = Xorshift::new(0x7419);
    let mut compared = 0;
    while compared < 12 {
        let mut vertex = || Point::new(random.between(-8, 50), random.between(-8, 50));
        let triangle = Triangle::new(vertex(), vertex(), vertex());
        let [a, b, c] = triangle
            .vertices
            .map(|vertex| (f64::from(vertex.x), f64::from(vertex.y)));
        let angle = |at: (f64, f64), one: (f64, f64), other: (f64, f64)| {
            let direction = |to: (f64, f64)| (to.1 - at.1).atan2(to.0 - at.0);
            let between = (direction(one) - direction(other)).abs();
            between.min(TAU - between).to_degrees()
        };
        let sharpest = angle(a, b, c).min(angle(b, c, a)).min(angle(c, a, b));
        if sharpest < 40.0 {
            continue;
        }
        compared += 1;
        let sides = [(a, b), (b, c), (c, a)];
        let area = (b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0);
        // How far a point lies beyond the nearest line.
        let beyond = |x: f64, y: f64| {
            let distance = |(from, to): ((f64, f64), (f64, f64))| {
                let (right, down) = (to.0 - from.0, to.1 - from.1);
                (down * (x - from.0) - right * (y - from.1)) / right.hypot(down) * area.signum()
            };
            sides.map(distance).into_iter().fold(f64::MIN, f64::max)
        };
        compare(
            &format!("{triangle:?}"),
            &triangle.into_styled(fill().antialiased()),
            |x, y| beyond(x, y) < 0.5,
        );
        for alignment in ALIGNMENTS {
            let width = random.between(1, 5) as u32;
            let wide = f64::from(width);
            let (inner, outer) = match alignment {
                StrokeAlignment::Inside => (0.5 - wide, 0.5),
                StrokeAlignment::Center => (-wide / 2.0, wide / 2.0),
                StrokeAlignment::Outside => (0.5, 0.5 + wide),
            };
            let style = stroke(width, alignment).antialiased();
            compare(
                &format!("{triangle:?}, {style:?}"),
                &triangle.into_styled(style),
                |x, y| (inner..outer).contains(&beyond(x, y)),
            );
        }
    }
}

/// Along a line from its start, and across it.
fn along(line: &Line, x: f64, y: f64) -> (f64, f64, f64) {
    let (right, down) = (
        f64::from(line.end.x - line.start.x),
        f64::from(line.end.y - line.start.y),
    );
    let length = right.hypot(down);
    let (x, y) = (x - f64::from(line.start.x), y - f64::from(line.start.y));
    ((x * right + y * down) / length, (y * right - x * down) / length, length)
}

/// Whether a point is in the stroke of a line.
fn in_stroke(line: &Line, half: f64, cap: LineCap, x: f64, y: f64) -> bool {
    let (along, across, length) = along(line, x, y);
    let beyond = (-along).max(along - length);
    let reach = match cap {
        LineCap::WholePixel => 0.5,
        LineCap::Butt => 0.0,
        LineCap::Square => half,
        LineCap::Round => return across.hypot(beyond.max(0.0)) < half,
    };
    across.abs() < half && beyond < reach
}

#[test]
fn lines_with_every_cap() {
    let mut random = Xorshift::new(0x11e5);
    for index in 0..40 {
        let mut end = || Point::new(random.between(-20, 60), random.between(-20, 60));
        let line = Line::new(end(), end());
        if line.start.x == line.end.x || line.start.y == line.end.y {
            continue;
        }
        let (width, cap) = (random.between(1, 9) as u32, CAPS[index % 4]);
        let style = StrokeStyle::new(Gray8::WHITE, width).cap(cap).antialiased();
        compare(&format!("{line:?}, {style:?}"), &line.into_styled(style), |x, y| {
            in_stroke(&line, f64::from(width) / 2.0, cap, x, y)
        });
    }
}

#[test]
fn dashes() {
    let mut random = Xorshift::new(0xda54);
    for index in 0..12 {
        let line = Line::new(
            Point::new(random.between(-8, 8), random.between(-8, 40)),
            Point::new(random.between(30, 45), random.between(-8, 41)),
        );
        // Along rows, dashes are those of lines without antialiasing.
        if line.start.y == line.end.y {
            continue;
        }
        let (dash, gap) = (
            f64::from(random.between(1, 80)) / 8.0,
            f64::from(random.between(48, 120)) / 8.0,
        );
        let lengths = [dash, gap].map(U16F16::from_num);
        let (width, cap) = (random.between(1, 4) as u32, [LineCap::Butt, LineCap::Round][index % 2]);
        let style = StrokeStyle::new(Gray8::WHITE, width)
            .cap(cap)
            .dashes(DashPattern::new(&lengths));
        compare(
            &format!("{line:?}, {style:?}"),
            &line.into_styled(style.antialiased()),
            |x, y| {
                let (along, across, length) = along(&line, x, y);
                let half = f64::from(width) / 2.0;
                (0..60)
                    .map(|index| f64::from(index) * (dash + gap))
                    .filter(|begin| *begin < length)
                    .any(|begin| {
                        let beyond = (begin - along).max(along - (begin + dash).min(length));
                        match cap {
                            LineCap::Round => across.hypot(beyond.max(0.0)) < half,
                            _ => across.abs() < half && beyond < 0.0,
                        }
                    })
            },
        );
    }
}

/// The distance of a point from a path.
fn distance(vertices: &[Point], x: f64, y: f64) -> f64 {
    let segments = vertices.windows(2).filter(|pair| pair[0] != pair[1]);
    let distances = segments.map(|pair| {
        let (along, across, length) = along(&Line::new(pair[0], pair[1]), x, y);
        across.hypot((-along).max(along - length).max(0.0))
    });
    distances.fold(f64::MAX, f64::min)
}

fn zigzag(random: &mut Xorshift, count: usize) -> Vec<Point> {
    (0..count)
        .map(|_| Point::new(random.between(-12, 54), random.between(-12, 54)))
        .collect()
}

/// With round caps and joins the stroke is all that is near the path.
#[test]
fn polylines_with_round_joins() {
    let mut random = Xorshift::new(0x9011);
    for _ in 0..12 {
        let count = random.between(3, 7) as usize;
        let vertices = zigzag(&mut random, count);
        let width = random.between(1, 9) as u32;
        let style = StrokeStyle::new(Gray8::WHITE, width)
            .cap(LineCap::Round)
            .join(LineJoin::Round);
        let polyline = Polyline::new(&vertices);
        compare(
            &format!("{vertices:?}, {width}"),
            &polyline.into_styled(style.antialiased()),
            |x, y| distance(&vertices, x, y) < f64::from(width) / 2.0,
        );
    }
}

/// A pixel is wholly inside where its centre is further from the sides of the stroke than its corners are from its centre.
#[test]
fn strokes_have_no_seam() {
    let mut random = Xorshift::new(0x5ea5);
    let joins = [LineJoin::MITER, LineJoin::Bevel, LineJoin::Round];
    let (mut inside, mut worst) = (0, 255);
    for index in 0..120 {
        let count = random.between(3, 9) as usize;
        let mut vertices = zigzag(&mut random, count);
        if index % 4 == 0 {
            // Nearly straight, with short segments: a flattened curve.
            vertices = (0..24)
                .map(|step| {
                    let angle = f64::from(step) / 24.0 * TAU * 0.8;
                    Point::new((20.0 + 16.0 * angle.cos()) as i32, (20.0 + 16.0 * angle.sin()) as i32)
                })
                .collect();
        }
        let width = random.between(3, 12) as u32;
        let style = StrokeStyle::new(Gray8::WHITE, width)
            .join(joins[index % 3])
            .cap(LineCap::Round);
        let drawn = coverage(&Polyline::new(&vertices).into_styled(style.antialiased()));
        for (pixel, drawn) in AREA.points().zip(drawn) {
            let (x, y) = (f64::from(pixel.x), f64::from(pixel.y));
            // Inside a bevel the stroke reaches as far as along its segments, if the path is that near.
            let near = vertices.windows(2).any(|pair| {
                let line = Line::new(pair[0], pair[1]);
                pair[0] != pair[1] && in_stroke(&line, f64::from(width) / 2.0 - 0.72, LineCap::Butt, x, y) && {
                    let (along, _, length) = along(&line, x, y);
                    along > 0.72 && along < length - 0.72
                }
            });
            if near {
                inside += 1;
                worst = worst.min(drawn);
                assert_eq!(drawn, 255, "{vertices:?}, {style:?}, {pixel:?}");
            }
        }
    }
    assert!(inside > 10_000 && worst == 255, "{inside}");
}

/// Two bars of one stroke, end to end and around a corner: every pixel of both is covered wholly.
#[test]
fn a_joint_is_covered_wholly() {
    let bends = [
        [Point::new(2, 10), Point::new(20, 10), Point::new(38, 10)],
        [Point::new(2, 10), Point::new(20, 10), Point::new(38, 17)],
        [Point::new(2, 10), Point::new(20, 10), Point::new(21, 38)],
    ];
    for vertices in bends {
        let drawn = coverage(&Polyline::new(&vertices).into_styled(stroke(5, StrokeAlignment::Center).antialiased()));
        for (pixel, drawn) in AREA.points().zip(drawn) {
            let is_near = distance(&vertices, pixel.x.into(), pixel.y.into()) < 2.5 - 0.72;
            // The stroke ends half a pixel beyond its ends.
            let is_end = [vertices[0], vertices[2]].iter().any(|end| {
                let away = *end - pixel;
                away.x.abs().max(away.y.abs()) <= 3
            });
            assert!(!is_near || is_end || drawn == 255, "{vertices:?}, {pixel:?}: {drawn}");
        }
    }
}

/// What is drawn without antialiasing.
fn aliased(shape: &impl DrawOn<Color = Gray8>) -> Vec<u8> {
    let mut words = vec![0; (SIDE * SIDE) as usize];
    let mut band = Band::<Gray8>::new(AREA, &mut words).unwrap();
    let Ok(()) = shape.draw_on(&mut band);
    words
}

/// Asserts that a shape has the same pixels with and without antialiasing.
fn assert_equals_aliased(name: &str, smooth: &impl DrawAntialiased<Color = Gray8>, hard: &impl DrawOn<Color = Gray8>) {
    for (pixel, (smooth, hard)) in AREA.points().zip(coverage(smooth).iter().zip(aliased(hard))) {
        assert_eq!(*smooth, hard, "{name}, {pixel:?}");
    }
}

#[test]
fn level_and_upright_strokes_equal_those_without_antialiasing() {
    let ends = [(4, 9), (30, 9), (4, 33), (-20, 9)].map(|(x, y)| Point::new(x, y));
    for (width, end) in (1..9).flat_map(|width| ends.map(|end| (width, end))) {
        let line = Line::new(ends[0], end);
        let style = PrimitiveStyle::with_stroke(Gray8::WHITE, width);
        let name = format!("{line:?}, {width}");
        assert_equals_aliased(&name, &line.into_styled(style.antialiased()), &line.into_styled(style));
        for cap in [LineCap::WholePixel, LineCap::Butt, LineCap::Square] {
            let style = StrokeStyle::new(Gray8::WHITE, width).cap(cap);
            let name = format!("{name}, {cap:?}");
            assert_equals_aliased(&name, &line.into_styled(style.antialiased()), &line.into_styled(style));
        }
        let vertices = [(2, 3), (30, 3), (30, 20), (9, 20), (9, 40)].map(|(x, y)| Point::new(x, y));
        let polyline = Polyline::new(&vertices);
        let style = StrokeStyle::new(Gray8::WHITE, width);
        let name = format!("polyline, {width}");
        assert_equals_aliased(
            &name,
            &polyline.into_styled(style.antialiased()),
            &polyline.into_styled(style),
        );
    }
}

#[test]
fn rectangles_equal_those_without_antialiasing() {
    let mut random = Xorshift::new(0x4ec7);
    for index in 0..60 {
        let rectangle = Rectangle::new(
            Point::new(random.between(-8, 20), random.between(-8, 20)),
            Size::new(random.between(0, 30) as u32, random.between(0, 30) as u32),
        );
        let mut style = stroke(random.between(0, 7) as u32, ALIGNMENTS[index % 3]);
        style.fill_color = (index % 2 == 0).then_some(Gray8::new(90));
        let name = format!("{rectangle:?}, {style:?}");
        assert_equals_aliased(
            &name,
            &rectangle.into_styled(style.antialiased()),
            &rectangle.into_styled(style),
        );
    }
}

/// White in white: where black shows through between fill and stroke, a pixel inside is not white.
#[test]
fn nothing_shows_between_fill_and_stroke() {
    for (width, alignment) in (2..6).flat_map(|width| ALIGNMENTS.map(|alignment| (width, alignment))) {
        let style = filled(Gray8::WHITE, width, alignment).antialiased();
        let is_inside = |around: Rectangle| {
            let beyond = f64::from(style.0.outside_stroke_width());
            move |pixel: &Point| in_ellipse(&around, beyond - 0.75, pixel.x.into(), pixel.y.into())
        };
        let circle = Circle::new(Point::new(6, 6), 29);
        let drawn = coverage(&circle.into_styled(style));
        let inside = AREA
            .points()
            .zip(drawn)
            .filter(|(pixel, _)| is_inside(circle.bounding_box())(pixel));
        for (pixel, drawn) in inside {
            assert_eq!(drawn, 255, "{style:?}, {pixel:?}");
        }
    }
}

fn at(x: i32, y: i32) -> SubPoint<Sub8> {
    SubPoint::from_units(x, y).unwrap()
}

#[test]
fn shapes_at_sub_pixel_positions() {
    let radii = [U24F8::from_num(12.3), U24F8::from_num(15.9)];
    let (x, y) = (20.0 + 77.0 / 256.0, 18.0 + 200.0 / 256.0);
    let center = at(20 * 256 + 77, 18 * 256 + 200);
    let radius = |x_: f64, y_: f64| (x_ - x).hypot(y_ - y);
    let [inner, outer] = radii.map(f64::from);
    let ring = SubArc::ring(center, radii).unwrap().into_styled(fill().antialiased());
    compare("ring", &ring, |x, y| (inner..outer).contains(&radius(x, y)));
    let arc = SubArc::new(center, radii, U0F16::from_num(0.1), U0F16::from_num(0.65)).unwrap();
    compare("arc", &arc.into_styled(fill().antialiased()), |x_, y_| {
        (inner..outer).contains(&radius(x_, y_)) && degrees_from(36.0, x_ - x, y_ - y) < 0.65 * 360.0
    });
    let disc = SubEllipse::circle(center, radii[0]).unwrap();
    compare("disc", &disc.into_styled(fill().antialiased()), |x, y| {
        radius(x, y) < inner
    });
    let style = stroke(3, StrokeAlignment::Center).antialiased();
    compare("circle", &disc.into_styled(style), |x, y| {
        (radius(x, y) - inner).abs() < 1.5
    });
    let line = SubLine::new(at(300, 500), at(9_000, 9_000), U24F8::from_num(4.5)).unwrap();
    let bar = |x: f64, y: f64, more: f64| {
        let (right, down) = (8_700.0 / 256.0, 8_500.0 / 256.0);
        let length = f64::hypot(right, down);
        let (x, y) = (x - 300.0 / 256.0, y - 500.0 / 256.0);
        let (along, across) = ((x * right + y * down) / length, (y * right - x * down) / length);
        (-along).max(along - length) < more && across.abs() < 2.25 + more
    };
    compare("line", &line.into_styled(fill().antialiased()), |x, y| bar(x, y, 0.0));
    let style = stroke(2, StrokeAlignment::Center).antialiased();
    compare("border", &line.into_styled(style), |x, y| {
        bar(x, y, 1.0) && !bar(x, y, -1.0)
    });
}

/// The stroke of a path begins and ends at its ends, whatever the cap of whole pixels is.
#[test]
fn paths_have_butt_caps() {
    let commands = [
        PathCommand::MoveTo(at(1_000, 1_500)),
        PathCommand::LineTo(at(8_000, 6_500)),
    ];
    let path = Path::new(&commands, FillRule::NonZero).unwrap();
    let line = SubLine::new(at(1_000, 1_500), at(8_000, 6_500), U24F8::from_num(3)).unwrap();
    let by_line = coverage(&line.into_styled(fill().antialiased()));
    let by_path = coverage(&path.into_styled(stroke(3, StrokeAlignment::Center).antialiased()));
    for (pixel, (line, path)) in AREA.points().zip(by_line.iter().zip(&by_path)) {
        assert!(line.abs_diff(*path) <= 2, "{pixel:?}: {line}, {path}");
    }
}

#[test]
fn polygons_have_fill_and_stroke() {
    let corners = [(3, 4), (40, 9), (12, 41)].map(|(x, y)| Point::new(x, y));
    let contours = [corners.as_slice()];
    let polygon = Polygon::new(&contours, FillRule::NonZero);
    let closed = [corners.as_slice(), &corners[..1]].concat();
    let is_inside = |x: f64, y: f64| {
        closed
            .windows(2)
            .all(|pair| along(&Line::new(pair[0], pair[1]), x, y).1 > 0.0)
    };
    compare("fill", &polygon.into_styled(fill().antialiased()), is_inside);
    let style = StrokeStyle::new(Gray8::WHITE, 3).join(LineJoin::Round).antialiased();
    compare("stroke", &polygon.into_styled(style), |x, y| {
        distance(&closed, x, y) < 1.5
    });
}

/// An error says which memory is too small and how much is needed, and nothing is drawn; with that, it is drawn.
#[test]
fn too_little_memory_is_an_error_that_says_how_much() {
    let style = filled(Gray8::new(90), 3, StrokeAlignment::Center);
    let circle = Circle::new(Point::new(2, 2), 38).into_styled(style.antialiased());
    let mut words = vec![0; (SIDE * SIDE) as usize];
    let mut row = [0; SIDE as usize + 1];
    fn drawn<const EDGES: usize, const ACTIVE: usize>(
        shape: &impl DrawAntialiased<Color = Gray8>,
        words: &mut [u8],
        row: &mut [i32],
    ) -> Result<(), DrawError<Infallible>> {
        let mut band = Band::<Gray8>::new(AREA, words).unwrap();
        shape.draw_on(&mut band.antialiased::<EDGES, ACTIVE>(row))
    }
    let too_small = |table: Table, needed: usize| Err(DrawError::TooSmall(TooSmall { table, needed }));
    // The stroke has more edges than the fill: two circles, without the level edges of either.
    assert_eq!(
        drawn::<80, 64>(&circle, &mut words, &mut row),
        too_small(Table::Edges, 156)
    );
    assert_eq!(
        drawn::<155, 64>(&circle, &mut words, &mut row),
        too_small(Table::Edges, 156)
    );
    assert_eq!(
        drawn::<156, 1>(&circle, &mut words, &mut row),
        too_small(Table::ActiveEdges, 8)
    );
    assert_eq!(
        drawn::<156, 9>(&circle, &mut words, &mut row),
        too_small(Table::ActiveEdges, 14)
    );
    assert_eq!(
        drawn::<156, 14>(&circle, &mut words, &mut row[..48]),
        too_small(Table::Cells, 49)
    );
    assert!(words.iter().all(|&word| word == 0));
    assert_eq!(drawn::<156, 14>(&circle, &mut words, &mut row), Ok(()));
    assert_eq!(words, coverage(&circle));
}

#[test]
fn what_leaves_the_domain_is_an_error() {
    let mut words = vec![0; (SIDE * SIDE) as usize];
    let mut band = Band::<Gray8>::new(AREA, &mut words).unwrap();
    let mut row = [0; SIDE as usize + 1];
    let mut target = band.antialiased::<EDGES, ACTIVE>(&mut row);
    let far = Point::new(9_000, 10);
    let outcomes = [
        Line::new(Point::zero(), far)
            .into_styled(stroke(3, StrokeAlignment::Center).antialiased())
            .draw_on(&mut target),
        Triangle::new(Point::zero(), far, Point::new(3, 30))
            .into_styled(fill().antialiased())
            .draw_on(&mut target),
        Circle::new(Point::new(-9_000, -9_000), 18_000)
            .into_styled(fill().antialiased())
            .draw_on(&mut target),
        Rectangle::new(Point::zero(), Size::new(9_000, 20))
            .into_styled(fill().antialiased())
            .draw_on(&mut target),
    ];
    for outcome in outcomes {
        assert!(
            matches!(outcome, Err(DrawError::<Infallible>::OutOfDomain(_))),
            "{outcome:?}"
        );
    }
    assert!(words.iter().all(|&word| word == 0));
}

/// A dash pattern far below a pixel has no room anywhere, which is found without counting dashes one by one.
#[test]
fn too_many_dashes_are_an_error() {
    let lengths = [U16F16::from_bits(1); 2];
    let style = StrokeStyle::new(Gray8::WHITE, 3)
        .dashes(DashPattern::new(&lengths))
        .antialiased();
    let mut words = vec![0; (SIDE * SIDE) as usize];
    let mut band = Band::<Gray8>::new(AREA, &mut words).unwrap();
    let outcome = Line::new(Point::zero(), Point::new(8_000, 9))
        .into_styled(style)
        .draw_on(&mut band.antialiased::<EDGES, ACTIVE>(&mut [0; SIDE as usize + 1]));
    assert!(matches!(
        outcome,
        Err(DrawError::TooSmall(TooSmall {
            table: Table::Edges,
            needed: 1_000_000..
        }))
    ));
}

/// The same call: shapes without antialiasing have their pixels on a target with memory.
#[test]
fn other_shapes_are_drawn_as_on_the_target_itself() {
    let mut words = vec![0; (SIDE * SIDE) as usize];
    let mut band = Band::<Gray8>::new(AREA, &mut words).unwrap();
    let mut row = [0; SIDE as usize + 1];
    let mut target = band.antialiased::<EDGES, ACTIVE>(&mut row);
    let circle = Circle::new(Point::new(2, 2), 30).into_styled(stroke(3, StrokeAlignment::Inside));
    let triangle = Triangle::new(Point::new(2, 40), Point::new(30, 33), Point::new(41, 3)).into_styled(fill());
    let line = Line::new(Point::new(-9, 4), Point::new(40, 44)).into_styled(stroke(1, StrokeAlignment::Center));
    let Ok(()) = circle.draw_on(&mut target);
    let Ok(()) = triangle.draw_on(&mut target);
    let Ok(()) = line.draw_on(&mut target);
    let expected = [aliased(&circle), aliased(&triangle), aliased(&line)];
    let expected: Vec<u8> = (0..words.len())
        .map(|index| expected.iter().map(|words| words[index]).max().unwrap())
        .collect();
    assert_eq!(words, expected);
}
