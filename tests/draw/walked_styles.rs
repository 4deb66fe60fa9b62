//! Strokes in a `StrokeStyle` by copy, which go on from row to row, against the same strokes drawn anew.

use embedded_graphics::{
    pixelcolor::{Rgb565, raw::ToBytes},
    prelude::*,
    primitives::{Line, Polyline, Rectangle},
};
use fixed::types::{I16F16, U8F8, U16F16};
use proptest::prelude::*;
use zrow::{
    band::{Band, BigEndian},
    draw::{DrawOn, LineCap, LineJoin, Picture, PictureSlot, StrokeStyle},
    geometry::Window,
};

use crate::{
    common::{by_depth, cases, config},
    picture_display::{Display, in_bands},
    picture_items::{AREA, Prepared, Slot},
    stroke_items::stroke_items,
    walked_strokes::{check_pools, check_rows, vertices, with_picture},
};

const CAPS: [LineCap; 4] = [LineCap::WholePixel, LineCap::Butt, LineCap::Square, LineCap::Round];
const JOINS: [LineJoin; 4] = [
    LineJoin::MITER,
    LineJoin::Miter { limit: U8F8::MAX },
    LineJoin::Bevel,
    LineJoin::Round,
];

/// Patterns of dashes longer than a pixel and far shorter, with dashes and gaps of no length.
fn patterns() -> [Vec<U16F16>; 6] {
    [
        vec![],
        vec![7.0, 5.0],
        vec![3.0, 0.0, 0.0, 2.5, 1.25],
        vec![0.0, 4.0],
        vec![0.75, 0.25, 0.0, 1.0],
        vec![0.125],
    ]
    .map(|lengths| lengths.into_iter().map(U16F16::from_num).collect())
}

fn style(width: u32) -> StrokeStyle<'static, Rgb565> {
    StrokeStyle::new(Rgb565::RED, width)
}

/// What drawing the stroke of a polyline in an area is.
fn drawn(vertices: &[Point], style: StrokeStyle<'_, Rgb565>, area: Rectangle) -> Vec<u16> {
    let mut words = vec![0; (area.size.width * area.size.height) as usize];
    let Ok(()) = Polyline::new(vertices)
        .into_styled(style)
        .draw_on(&mut Band::<Rgb565>::new(area, &mut words).unwrap());
    words
}

fn check(vertices: &[Point], style: StrokeStyle<'_, Rgb565>) {
    with_picture(AREA, |picture| {
        picture.add(&Polyline::new(vertices).into_styled(style)).unwrap();
        check_rows(picture, AREA, &drawn(vertices, style, AREA));
    });
}

fn at(corners: &[(i32, i32)]) -> Vec<Point> {
    corners.iter().map(|&corner| corner.into()).collect()
}

/// A line to and fro that crosses itself often, and leaves the picture.
fn zigzag(vertices: i32) -> Vec<Point> {
    let vertex = |index| Point::new(index * 7 % 67 - 2, index * index * 5 % 71 - 9);
    (0..vertices).map(vertex).collect()
}

proptest! {
    #![proptest_config(config(cases(250, 5_000)))]

    #[test]
    fn strokes_are_those_that_are_drawn_anew(item in stroke_items(vertices(), Just(Rgb565::RED))) {
        let mut expected = vec![0; (AREA.size.width * AREA.size.height) as usize];
        item.draw(&mut Band::<Rgb565>::new(AREA, &mut expected).unwrap());
        with_picture(AREA, |picture| {
            item.add(picture).unwrap();
            check_rows(picture, AREA, &expected);
        });
    }

    /// Moved between two rows, out of sight and back.
    #[test]
    fn moved_strokes_are_those_that_are_drawn_anew(
        item in stroke_items((-30..90, -20..80).prop_map(Point::from), Just(Rgb565::RED)),
        steps in proptest::collection::vec((-40..40, -40..40), 1..4),
        rows in 0..40u32,
    ) {
        with_picture(AREA, |picture| {
            let id = item.add(picture).unwrap();
            let mut offset = Point::zero();
            let steps = steps.iter().copied().chain([(9_000, -31_000), (-9_000, 31_000)]);
            for by in steps.map(Point::from) {
                in_bands(picture, Rectangle::new(AREA.top_left, Size::new(AREA.size.width, rows)), &[1]);
                picture.translate(id, by).unwrap();
                offset += by;
                let elsewhere = Rectangle::new(AREA.top_left - offset, AREA.size);
                let mut expected = vec![0; (AREA.size.width * AREA.size.height) as usize];
                item.draw(&mut Band::<Rgb565>::new(elsewhere, &mut expected).unwrap());
                check_rows(picture, AREA, &expected);
            }
        });
    }
}

/// All caps and joins with all patterns, along crossing, level and upright segments, and to and fro.
#[test]
fn patterns_along_all_directions() {
    let paths = [
        zigzag(9),
        at(&[(-9, 20), (70, 20)]),
        at(&[(70, 21), (-9, 21), (-9, 30), (80, 31)]),
        at(&[(20, -9), (20, 80)]),
        at(&[(21, 80), (21, -9), (60, 40), (21, -9)]),
        at(&[(20, 20), (20, 20)]),
        at(&[(20, 20), (20, 20), (31, 47), (31, 47), (20, 20)]),
    ];
    let patterns = paths.iter().flat_map(|path| patterns().map(|lengths| (path, lengths)));
    for (path, lengths) in patterns.step_by(by_depth(5, 1, 1)) {
        for (cap, join) in CAPS.into_iter().flat_map(|cap| JOINS.map(|join| (cap, join))) {
            for (width, offset) in [(3, -2.5), (8, 4.0), (1, 0.0)].into_iter().take(cases(1, 3) as usize) {
                let style = style(width).cap(cap).join(join).dashes(&lengths);
                check(path, style.dash_offset(I16F16::from_num(offset)));
            }
        }
    }
}

#[test]
fn polylines_of_many_vertices() {
    for lengths in patterns().into_iter().take(4) {
        for width in [1, 9] {
            check(
                &zigzag(150),
                style(width).dashes(&lengths).cap(LineCap::Round).join(LineJoin::Round),
            );
        }
    }
}

/// Segments with so many dashes that they are kept in a list, and with one more.
#[test]
fn as_many_dashes_as_are_kept_in_a_list() {
    let lengths = [U16F16::lit("0.5"); 2];
    for (length, cap) in (62..67).flat_map(|length| CAPS.map(|cap| (length, cap))) {
        for (end, width) in [(Point::new(length, 0), 1), (Point::new(0, length), 3)] {
            let start = Point::new(-3, 6);
            check(
                &[start, start + end, start + end / 2],
                style(width).cap(cap).dashes(&lengths),
            );
        }
    }
}

#[test]
fn pools_of_every_size() {
    for lengths in patterns() {
        let style = style(3).dashes(&lengths).cap(LineCap::Round);
        check_pools(AREA, |picture| {
            picture.add(&Polyline::new(&zigzag(5)).into_styled(style))
        });
    }
}

/// A stroke that is drawn to its end and put in its own place sends nothing.
#[test]
fn the_same_stroke_again_changes_nothing() {
    let (mut slots, mut pool, mut buckets) = ([Slot::EMPTY; 1], [0; 9_000], [0; 47]);
    let mut areas = [Window::EMPTY; 4];
    let mut picture = Prepared::new(AREA, &mut slots, &mut pool, &mut buckets).with_damage(&mut areas, (1, 1));
    for lengths in patterns() {
        picture.clear();
        let vertices = at(&[(3, 9), (40, 20), (22, 45)]);
        let style = style(4).dashes(&lengths).cap(LineCap::Round);
        let stroke = Polyline::new(&vertices).into_styled(style);
        let id = picture.add(&stroke).unwrap();
        let mut display = Display::new(AREA);
        display.draw_damage(&mut picture, &[1]);
        in_bands(&mut picture, AREA, &[1]);
        picture.replace(id, &stroke).unwrap();
        assert_eq!(picture.next_damage(), None);
    }
}

/// The colour in the other order of bytes.
#[test]
fn bytes_in_the_other_order() {
    let stroke = Line::new(Point::new(0, 7), Point::new(30, 31)).into_styled(style(4).cap(LineCap::Round));
    let (mut slots, mut pool) = ([PictureSlot::EMPTY; 1], [0; 200]);
    let mut picture = Picture::<Rgb565, BigEndian>::new(AREA, &mut slots, &mut pool, &mut []);
    picture.add(&stroke).unwrap();
    let mut words = vec![0; (AREA.size.width * AREA.size.height) as usize];
    picture.draw(&mut Band::new(AREA, &mut words).unwrap());
    let red = u16::from_ne_bytes(Rgb565::RED.to_be_bytes());
    let expected = drawn(
        &[Point::new(0, 7), Point::new(30, 31)],
        style(4).cap(LineCap::Round),
        AREA,
    );
    assert_eq!(
        words,
        expected
            .iter()
            .map(|&word| if word == 0 { 0 } else { red })
            .collect::<Vec<_>>()
    );
}
