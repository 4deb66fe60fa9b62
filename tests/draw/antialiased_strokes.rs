//! Antialiased strokes of lines and polylines with caps, joins and dashes, against the ideal strokes.

use std::f64::consts::TAU;

use embedded_graphics::{
    geometry::Point,
    pixelcolor::{Gray8, GrayColor},
    prelude::*,
    primitives::{Line, Polyline, Rectangle, StrokeAlignment},
};
use fixed::types::{I16F16, U8F8, U16F16};
use zrow::{
    band::Band,
    draw::{DrawOn, LineCap, LineJoin, StrokeStyle},
};

use crate::{
    antialiased_area::{AREA, CAPS, SIDE, Xorshift, compare, coverage, stroke},
    common::cases,
    reference::ideal_coverage::{along, distance},
};

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
    for index in 0..cases(16, 40) as usize {
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
    for index in 0..cases(3, 12) as usize {
        let line = Line::new(
            Point::new(random.between(-8, 8), random.between(-8, 40)),
            Point::new(random.between(30, 45), random.between(-8, 41)),
        );
        let (dash, gap) = (
            // No multiple of 1/2, whose dashes are those of lines without antialiasing along rows.
            f64::from(random.between(1, 80)) / 8.0 + 1.0 / 16.0,
            f64::from(random.between(48, 120)) / 8.0,
        );
        let (width, cap) = (random.between(1, 4) as u32, [LineCap::Butt, LineCap::Round][index % 2]);
        compare_dashes(&line, width, cap, (dash, gap), 0.0);
    }
}

/// Compares a line in dashes and gaps of two lengths, from an offset on, with the ideal one. Along rows and columns an even
/// width lies half a pixel further up or left, along pixels, if it has no round caps.
fn compare_dashes(line: &Line, width: u32, cap: LineCap, (dash, gap): (f64, f64), offset: f64) {
    let lengths = [dash, gap].map(U16F16::from_num);
    let style = StrokeStyle::new(Gray8::WHITE, width).cap(cap).dashes(&lengths);
    let style = style.dash_offset(I16F16::from_num(offset));
    let on_pixels = |is_along: bool| {
        let is_moved = is_along && width.is_multiple_of(2) && cap != LineCap::Round;
        if is_moved { 0.5 } else { 0.0 }
    };
    let moved = (
        on_pixels(line.start.x == line.end.x),
        on_pixels(line.start.y == line.end.y),
    );
    compare(
        &format!("{line:?}, {style:?}"),
        &line.into_styled(style.antialiased()),
        |x, y| {
            let (along, across, length) = along(line, x + moved.0, y + moved.1);
            let half = f64::from(width) / 2.0;
            let more = match cap {
                LineCap::WholePixel => 0.5,
                LineCap::Square => half,
                LineCap::Butt | LineCap::Round => 0.0,
            };
            (-9..60)
                .map(|index| f64::from(index) * (dash + gap) - offset)
                .map(|begin| (begin.max(0.0), (begin + dash).min(length)))
                .filter(|(begin, end)| begin < end)
                .any(|(begin, end)| {
                    let beyond = (begin - along).max(along - end);
                    match cap {
                        LineCap::Round => across.hypot(beyond.max(0.0)) < half,
                        _ => across.abs() < half && beyond < more,
                    }
                })
        },
    );
}

/// Level and upright lines.
const ALONG_PIXELS: [Line; 4] = [
    Line::new(Point::new(3, 5), Point::new(38, 5)),
    Line::new(Point::new(40, 31), Point::new(1, 31)),
    Line::new(Point::new(17, 2), Point::new(17, 41)),
    Line::new(Point::new(30, 39), Point::new(30, 4)),
];

#[test]
fn dashes_along_rows_and_columns() {
    let mut random = Xorshift::new(0x41d5);
    for index in 0..cases(16, 64) as usize {
        let mut eighths = |first, last| f64::from(random.between(first, last)) / 8.0;
        // No multiples of 1/2.
        let lengths = (eighths(2, 20) + 1.0 / 16.0, eighths(48, 80));
        let offset = eighths(0, 80);
        let width = random.between(1, 4) as u32;
        let line = &ALONG_PIXELS[(index + index / 4) % 4];
        compare_dashes(line, width, CAPS[index % 4], lengths, offset);
    }
}

/// What dashes of a line cover together is their lengths times the width.
#[test]
fn dashes_along_rows_and_columns_are_no_longer_than_they_are() {
    for (line, width) in ALONG_PIXELS
        .iter()
        .flat_map(|line| (1..=5).map(move |width| (line, width)))
    {
        for eighths in (1..64).step_by(5).filter(|eighths| eighths % 4 != 0) {
            let dash = f64::from(eighths) / 8.0;
            let lengths = [dash, 50.0].map(U16F16::from_num);
            let style = StrokeStyle::new(Gray8::WHITE, width)
                .cap(LineCap::Butt)
                .dashes(&lengths);
            let drawn = coverage(&line.into_styled(style.antialiased()));
            let sum: f64 = drawn.into_iter().map(|coverage| f64::from(coverage) / 255.0).sum();
            let error = sum - dash * f64::from(width);
            assert!(error.abs() <= 0.004 * f64::from(width), "{line:?}, {style:?}: {sum}");
        }
    }
}

/// In dashes of whole and half pixels, lines and corners are those of a stroke that is not antialiased.
#[test]
fn dashes_of_half_pixels_lie_along_pixels() {
    let mut random = Xorshift::new(0x4a1f);
    let corners = [(3, 5), (38, 5), (38, 30), (20, 30), (20, 12)].map(|(x, y)| Point::new(x, y));
    for _ in 0..cases(100, 400) {
        let mut halves = |first, last| f64::from(random.between(first, last)) / 2.0;
        let lengths = [halves(1, 12), halves(0, 12), halves(1, 5)].map(U16F16::from_num);
        let offset = I16F16::from_num(halves(-20, 20));
        let (width, cap) = (random.between(1, 6) as u32, CAPS[random.between(0, 2) as usize]);
        let style = StrokeStyle::new(Gray8::WHITE, width).cap(cap).dashes(&lengths);
        let style = style.dash_offset(offset);
        for line in ALONG_PIXELS {
            let [antialiased, sampled] = [
                coverage(&line.into_styled(style.antialiased())),
                sampled(&line.into_styled(style)),
            ];
            assert_eq!(antialiased, sampled, "{line:?}, {style:?}");
        }
        let polyline = Polyline::new(&corners);
        let [antialiased, sampled] = [
            coverage(&polyline.into_styled(style.antialiased())),
            sampled(&polyline.into_styled(style)),
        ];
        assert_eq!(antialiased, sampled, "{style:?}");
    }
}

/// The area is symmetric about this point.
const CENTER: Point = Point::new(21, 22);

/// A square about a point, bevelled at each corner of its outer side, and its hole: an even width lies half a pixel further up
/// and left, along pixels.
fn in_bevelled_square(width: u32, x: f64, y: f64) -> bool {
    let moved = if width.is_multiple_of(2) { 0.5 } else { 0.0 };
    let (right, down) = (
        (x - f64::from(CENTER.x) + moved).abs(),
        (y - f64::from(CENTER.y) + moved).abs(),
    );
    let half = f64::from(width) / 2.0;
    right.max(down) < 10.0 + half && right.max(down) > 10.0 - half && right + down < 20.0 + half
}

/// A square whose corners are all bevelled alike is its own mirror image, from left to right, upside down, and about a diagonal.
#[test]
fn bevelled_squares() {
    let limit = |limit: f64| LineJoin::Miter {
        limit: U8F8::from_num(limit),
    };
    for (width, join) in (1..=9).flat_map(|width| [LineJoin::Bevel, limit(1.0), limit(1.41)].map(|join| (width, join)))
    {
        let square = Rectangle::with_center(CENTER, Size::new(21, 21));
        let style = StrokeStyle::new(Gray8::WHITE, width).join(join).antialiased();
        let shape = square.into_styled(style);
        compare(&format!("{style:?}"), &shape, |x, y| in_bevelled_square(width, x, y));

        let drawn = coverage(&shape);
        let at = |from_center: Point| {
            let [x, y] = [
                CENTER.x - AREA.top_left.x + from_center.x,
                CENTER.y - AREA.top_left.y + from_center.y,
            ];
            drawn[(y * SIDE as i32 + x) as usize]
        };
        let moved = if width.is_multiple_of(2) { 1 } else { 0 };
        for (x, y) in (-20..20).flat_map(|x| (-20..20).map(move |y| (x, y))) {
            let mirrored = [(-x - moved, y), (x, -y - moved), (y, x)].map(|(x, y)| at(Point::new(x, y)));
            assert_eq!(mirrored, [at(Point::new(x, y)); 3], "{style:?}, {x}, {y}");
        }
    }
}

/// Corners with tips, along rows and columns: the pixels are those of a stroke that is not antialiased.
#[test]
fn squares_with_tips_lie_along_pixels() {
    for (width, limit) in (1..=9).flat_map(|width| [1.42, 2.0, 4.0].map(|limit| (width, limit))) {
        let join = LineJoin::Miter {
            limit: U8F8::from_num(limit),
        };
        let square = Rectangle::with_center(CENTER, Size::new(21, 21));
        let style = StrokeStyle::new(Gray8::WHITE, width).join(join);
        assert_eq!(
            coverage(&square.into_styled(style.antialiased())),
            sampled(&square.into_styled(style)),
            "{style:?}"
        );
    }
}

/// The coverage of each pixel by a stroke that is not antialiased: all or nothing.
fn sampled(shape: &impl DrawOn<Color = Gray8>) -> Vec<u8> {
    let mut words = vec![0; (SIDE * SIDE) as usize];
    let mut band = Band::<Gray8>::new(AREA, &mut words).unwrap();
    let Ok(()) = shape.draw_on(&mut band);
    words
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
    for _ in 0..cases(5, 12) {
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

/// Whether a point is in the stroke of two segments with a bevelled corner and round caps.
fn in_bevelled_stroke([a, b, c]: [Point; 3], half: f64, x: f64, y: f64) -> bool {
    let in_segment = |line: &Line| in_stroke(line, half, LineCap::Butt, x, y);
    let in_disc = |center: Point| (x - f64::from(center.x)).hypot(y - f64::from(center.y)) < half;
    // The corners of the bevel from the vertex, at right angles to both segments.
    let (before, after) = (b - a, c - b);
    let cross = |(ax, ay): (f64, f64), (bx, by): (f64, f64)| ax * by - ay * bx;
    let vector = |point: Point| (f64::from(point.x), f64::from(point.y));
    let side = -half * cross(vector(before), vector(after)).signum();
    let corner = |along: Point| {
        let (right, down) = vector(along);
        let size = right.hypot(down);
        (-down / size * side, right / size * side)
    };
    let (one, other) = (corner(before), corner(after));
    let from_vertex = (x - f64::from(b.x), y - f64::from(b.y));
    let area = cross(one, other);
    let parts = [cross(from_vertex, other) / area, cross(one, from_vertex) / area];
    let in_bevel = parts[0] >= 0.0 && parts[1] >= 0.0 && parts[0] + parts[1] < 1.0;
    in_segment(&Line::new(a, b)) || in_segment(&Line::new(b, c)) || in_disc(a) || in_disc(c) || in_bevel
}

/// The disc about an end of a segment that is shorter than the disc's radius reaches further back than the segment, where no round
/// join covers that.
#[test]
fn round_caps_of_short_segments_are_discs() {
    let style = StrokeStyle::new(Gray8::WHITE, 15)
        .cap(LineCap::Round)
        .join(LineJoin::Bevel);
    for corners in [
        [(8, 30), (24, 14), (25, 17)],
        [(25, 17), (24, 14), (8, 30)],
        [(8, 20), (38, 20), (34, 18)],
    ] {
        let vertices = corners.map(|(x, y)| Point::new(x, y));
        let polyline = Polyline::new(&vertices).into_styled(style.antialiased());
        compare(&format!("{vertices:?}"), &polyline, |x, y| {
            in_bevelled_stroke(vertices, 7.5, x, y)
        });
    }
    // A dash of 30 pixels, which ends 5 pixels behind the corner.
    let [a, b, end, c] = [(8, 30), (28, 15), (24, 12), (16, 6)].map(|(x, y)| Point::new(x, y));
    let lengths = [30, 40].map(U16F16::from_num::<i32>);
    let vertices = [a, b, c];
    let dashed = Polyline::new(&vertices).into_styled(style.dashes(&lengths).antialiased());
    compare("a dash", &dashed, |x, y| in_bevelled_stroke([a, b, end], 7.5, x, y));
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
