//! Caps, joins and dashes against the ideal union of rectangles, wedges and discs in `i128`, each pixel drawn once.

use std::collections::BTreeSet;

use embedded_graphics::{
    mock_display::MockDisplay,
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{self, Line, Polyline, Primitive, Rectangle, Styled, StyledDimensions, StyledDrawable, Triangle},
};
use fixed::types::{I16F16, U8F8, U16F16};
use proptest::prelude::*;
use zrow::draw::{DrawOn, FillRule, LineCap, LineJoin, PathCommand, Polygon, PrimitiveStyle, StrokeStyle};

use crate::{
    checked_strokes::{STROKE, check, check_sub_pixel, drawn, open, open_path, screen, sub_pixel},
    common::{
        cases, config, encloses,
        numbers::{far, near},
        painted,
    },
    reference::ideal_stroke::{Style, ideal, primitives},
};

fn cap() -> impl Strategy<Value = LineCap> {
    prop::sample::select(vec![
        LineCap::WholePixel,
        LineCap::Butt,
        LineCap::Square,
        LineCap::Round,
    ])
}

fn join() -> impl Strategy<Value = LineJoin> {
    let limit = prop_oneof![
        2 => Just(4 << 8),
        2 => 200..5_000u16,
        1 => any::<u16>(),
    ];
    prop_oneof![
        2 => limit.prop_map(|bits| LineJoin::Miter { limit: U8F8::from_bits(bits) }),
        1 => Just(LineJoin::Bevel),
        1 => Just(LineJoin::Round),
    ]
}

fn style() -> impl Strategy<Value = Style> {
    (prop_oneof![1..12u32, 1..=40u32], cap(), join()).prop_map(|(width, cap, join)| Style {
        width,
        cap,
        join,
        dashes: None,
    })
}

fn dashes() -> impl Strategy<Value = (Vec<u32>, i32)> {
    let length = prop_oneof![
        2 => (1..20u32).prop_map(|pixels| pixels << 16),
        2 => 20_000..2_000_000u32,
        1 => Just(0),
    ];
    (
        prop::collection::vec(length, 1..6),
        prop_oneof![2 => any::<i32>(), 1 => Just(0)],
    )
}

/// Paths in 1/256 pixel, with whole pixels and hard corners among them.
fn path() -> impl Strategy<Value = Vec<(i32, i32)>> {
    let whole = || (-10..74i32).prop_map(|pixel| pixel * 256);
    let coordinate = || prop_oneof![whole(), -2_000..18_000i32];
    let step = prop_oneof![
        6 => (coordinate(), coordinate()).prop_map(|to| (0, to)),
        1 => Just((1, (0, 0))),
        1 => Just((2, (0, 0))),
        1 => Just((3, (0, 0))),
        2 => (-500..500i32, -500..500i32).prop_map(|to| (4, to)),
    ];
    prop::collection::vec(step, 1..7).prop_map(|steps| {
        let mut path: Vec<(i32, i32)> = Vec::new();
        for (kind, to) in steps {
            let last = path.last().copied().unwrap_or((3_000, 4_000));
            let before = path.len().checked_sub(2).map_or((1_000, 1_000), |index| path[index]);
            path.push(match kind {
                // The same point again; straight back; straight on; sharply back.
                1 => last,
                2 => before,
                3 => (last.0 + (last.0 - before.0) / 2, last.1 + (last.1 - before.1) / 2),
                4 => (before.0 + to.0, before.1 + to.1),
                _ => to,
            });
        }
        path
    })
}

proptest! {
    #![proptest_config(config(cases(50, 400)))]

    #[test]
    fn strokes_are_exact(path in path(), closed in any::<bool>(), style in style()) {
        prop_assume!(path.iter().all(|&(x, y)| x.abs() < 1 << 20 && y.abs() < 1 << 20));
        let free = check_sub_pixel(&path, closed, &style);
        prop_assume!(free.is_some());
    }

    #[test]
    fn dashes_are_exact(path in path(), closed in any::<bool>(), style in style(), dashes in dashes()) {
        prop_assume!(path.iter().all(|&(x, y)| x.abs() < 1 << 20 && y.abs() < 1 << 20));
        let style = Style { dashes: Some(dashes), ..style };
        let free = check_sub_pixel(&path, closed, &style);
        prop_assume!(free.is_some());
    }
}

fn same_as_wide_stroke<S>(shape: S, width: u32)
where
    S: Primitive
        + Clone
        + StyledDrawable<PrimitiveStyle<Rgb565>, Color = Rgb565, Output = ()>
        + for<'d> StyledDrawable<StrokeStyle<'d, Rgb565>, Color = Rgb565, Output = ()>
        + for<'d> StyledDimensions<StrokeStyle<'d, Rgb565>>,
    for<'d> Styled<S, StrokeStyle<'d, Rgb565>>: DrawOn<Color = Rgb565>,
    Styled<S, PrimitiveStyle<Rgb565>>: DrawOn<Color = Rgb565>,
{
    let style = PrimitiveStyle::with_stroke(STROKE, width);
    let wide: BTreeSet<(i32, i32)> = painted(screen(), |band| {
        let Ok(()) = shape.clone().into_styled(style).draw_on(band);
    })
    .into_iter()
    .map(|point| (point.x, point.y))
    .collect();
    assert_eq!(drawn(shape, style.into()), wide);
}

proptest! {
    #![proptest_config(config(cases(15, 120)))]

    #[test]
    fn the_default_is_the_wide_stroke(vertices in prop::collection::vec(far(), 3..7), x in -9..9i32, width in 2..24u32) {
        same_as_wide_stroke(Line::new(vertices[0], vertices[1]), width);
        same_as_wide_stroke(Triangle::new(vertices[0], vertices[1], vertices[2]), width);
        same_as_wide_stroke(Polyline { translate: Point::new(x, -x), vertices: &vertices }, width);
    }

    #[test]
    fn strokes_of_pixels_and_of_sub_pixels_are_the_same(vertices in prop::collection::vec(near(), 2..6), style in style(), dashes in dashes()) {
        let style = Style { dashes: Some(dashes), ..style };
        let points: Vec<(i32, i32)> = vertices.iter().map(|point| (point.x * 256, point.y * 256)).collect();
        style.with(|style| {
            prop_assert_eq!(drawn(Polyline::new(&vertices), style), drawn(open_path(&open(&points)), style));
            Ok(())
        })?;
    }

    /// Dashes of a line that do not touch are drawn one by one, those of a polyline never.
    #[test]
    fn dashes_one_by_one_are_those_of_a_polyline(
        (start, end) in prop_oneof![(near(), near()), (far(), far())],
        style in style(),
        (mut lengths, offset) in dashes(),
        gap in prop_oneof![-40..40i32, 0..500_000i32],
        step in 0..3usize,
    ) {
        // Around where the caps of two dashes touch.
        let reach = match style.cap {
            LineCap::Butt => 0,
            LineCap::WholePixel => 1 << 16,
            LineCap::Square | LineCap::Round => style.width << 16,
        };
        for gap_length in lengths.iter_mut().skip(step).step_by(2) {
            *gap_length = reach.saturating_add_signed(gap);
        }
        prop_assume!(lengths.iter().map(|&length| u64::from(length)).sum::<u64>() > 200_000);
        let style = Style { dashes: Some((lengths, offset)), ..style };
        style.with(|style| {
            prop_assert_eq!(drawn(Line::new(start, end), style), drawn(Polyline::new(&[start, end]), style));
            Ok(())
        })?;
    }

    #[test]
    fn curves_have_the_wide_stroke_too(points in prop::collection::vec((-2_000..18_000i32, -2_000..18_000i32), 4), closed in any::<bool>(), width in 2..12u32) {
        let points = sub_pixel(&points);
        let mut commands = vec![PathCommand::MoveTo(points[0]), PathCommand::CubicTo(points[1], points[2], points[3])];
        commands.extend(closed.then_some(PathCommand::Close));
        same_as_wide_stroke(open_path(&commands), width);
    }

    /// Lengths along level and upright segments are exact, and so are dashes: no pixel may go either way.
    #[test]
    fn dashes_along_the_axes_are_exact(
        turns in prop::collection::vec((any::<bool>(), -10_000..10_000i32), 1..6),
        width in 1..9u32,
        lengths in prop::collection::vec(prop_oneof![1..3_000_000u32, Just(0)], 1..5),
        offset in any::<i32>(),
    ) {
        prop_assume!(lengths.iter().map(|&length| u64::from(length)).sum::<u64>() > 40_000);
        // In 1/65,536 pixel.
        let mut points = vec![(4_000 * 256i64, 6_000 * 256i64)];
        for (level, step) in turns {
            let (x, y) = points[points.len() - 1];
            let step = i64::from(step) * 256;
            points.push(if level { (x + step, y) } else { (x, y + step) });
        }
        let cycle: i64 = lengths.iter().map(|&length| i64::from(length)).sum::<i64>() * (1 + lengths.len() as i64 % 2);
        let half = i64::from(width) << 15;
        let mut boxes = Vec::new();
        let mut before = 0;
        for corners in points.windows(2) {
            let ((x0, y0), (x1, y1)) = (corners[0], corners[1]);
            let length = (x1 - x0).abs() + (y1 - y0).abs();
            let mut begin = -i64::from(offset).rem_euclid(cycle);
            for index in 0.. {
                let (from, to) = ((begin - before).max(0), (begin + i64::from(lengths[index % lengths.len()]) - before).min(length));
                if begin > before + length {
                    break;
                }
                begin += i64::from(lengths[index % lengths.len()]);
                if index % 2 == 1 || from >= to {
                    continue;
                }
                let along = |start: i64, end: i64| {
                    let sign = (end - start).signum();
                    let ends = (start + sign * from, start + sign * to);
                    (ends.0.min(ends.1), ends.0.max(ends.1))
                };
                boxes.push(if y0 == y1 { (along(x0, x1), (y0 - half, y0 + half)) } else { ((x0 - half, x0 + half), along(y0, y1)) });
            }
            before += length;
        }
        let expected: BTreeSet<(i32, i32)> = screen().points().map(|point| (point.x, point.y)).filter(|&(x, y)| {
            let (x, y) = (i64::from(x) << 16, i64::from(y) << 16);
            boxes.iter().any(|&((left, right), (top, bottom))| left <= x && x < right && top <= y && y < bottom)
        }).collect();
        let units: Vec<(i32, i32)> = points.iter().map(|&(x, y)| ((x >> 8) as i32, (y >> 8) as i32)).collect();
        let style = Style { width, cap: LineCap::Butt, join: LineJoin::Miter { limit: U8F8::ZERO }, dashes: Some((lengths, offset)) };
        let drawn = style.with(|style| drawn(open_path(&open(&units)), style));
        // The bevels of corners under way are not in the boxes.
        for pixel in drawn.symmetric_difference(&expected) {
            prop_assert!(drawn.contains(pixel), "{:?}", pixel);
            let near_corner = |&(x, y): &(i64, i64)| ((i64::from(pixel.0) << 16) - x).abs() <= half && ((i64::from(pixel.1) << 16) - y).abs() <= half;
            prop_assert!(points[1..points.len() - 1].iter().any(near_corner), "{:?}", pixel);
        }
    }

    #[test]
    fn far_strokes_are_the_same_in_parts(vertices in prop::collection::vec(far(), 1..5), closed in any::<bool>(), style in style(), dashes in dashes(), solid in any::<bool>()) {
        let style = Style { dashes: (!solid).then_some(dashes), ..style };
        style.with(|style| match closed {
            true => drawn(Polygon::new(&[vertices.as_slice()], FillRule::EvenOdd), style),
            false => drawn(Polyline::new(&vertices), style),
        });
    }
}

/// 200 corners: what is rounded at each of them must not add up.
#[test]
fn dashes_do_not_drift_along_a_long_path() {
    // Up and down in steps whose lengths are no whole numbers, and then through the screen.
    let mut units: Vec<(i32, i32)> = (0..200)
        .map(|index| (-60_000 + 170 * index, -9_000 - 333 * (index % 2)))
        .collect();
    units.extend([(300, 700), (15_000, 9_100), (500, 15_000)]);
    let mut compared = 0;
    for length in (0..cases(2, 12)).map(|index| 150_001 + 7_919 * index) {
        for (cap, join) in [
            (LineCap::Butt, LineJoin::Bevel),
            (LineCap::Round, LineJoin::Round),
            (LineCap::Square, LineJoin::MITER),
        ] {
            let style = Style {
                width: 3,
                cap,
                join,
                dashes: Some((vec![length, 100_000], 12_345)),
            };
            // Where a dash ends as near as 1/1,000 pixel to a corner, the reference does not know.
            let Some(primitives) = primitives(&ideal(&units), false, &style) else {
                continue;
            };
            let drawn = style.with(|style| drawn(open_path(&open(&units)), style));
            assert!(check(&drawn, &primitives, &style) < 8);
            assert!(drawn.len() > 100);
            compared += 1;
        }
    }
    assert!(compared > cases(4, 12), "{compared}");
}

#[test]
fn round_dots_are_discs() {
    for width in 1..=40u32 {
        for (x, y) in [(32 * 256, 32 * 256), (32 * 256 + 128, 31 * 256 + 128), (8_001, 7_777)] {
            let points = open(&[(x, y)]);
            let style = StrokeStyle::new(STROKE, width).cap(LineCap::Round);
            let expected: BTreeSet<(i32, i32)> = screen()
                .points()
                .map(|point| (point.x, point.y))
                .filter(|&(column, row)| {
                    let (dx, dy) = (2 * (column * 256 - x), 2 * (row * 256 - y));
                    let surplus = dx * dx + dy * dy - (width * 256 * width * 256) as i32;
                    surplus < 0 || surplus == 0 && dx < 0
                })
                .collect();
            assert_eq!(drawn(open_path(&points), style), expected, "{width} at {x}, {y}");
        }
    }
}

#[test]
fn the_stroke_of_a_rectangle_goes_through_its_outermost_pixels() {
    let mut theirs = MockDisplay::new();
    let mut ours = MockDisplay::new();
    let square = Rectangle::new(Point::new(4, 4), Size::new(9, 7));
    for width in [1, 3, 5] {
        theirs.set_allow_overdraw(true);
        ours.set_allow_overdraw(true);
        let style = primitives::PrimitiveStyle::with_stroke(STROKE, width);
        square.into_styled(style).draw(&mut theirs).unwrap();
        square.into_styled(StrokeStyle::from(style)).draw(&mut ours).unwrap();
        ours.assert_eq(&theirs);
    }
    let nothing = Rectangle::new(Point::new(4, 4), Size::new(0, 7)).into_styled(StrokeStyle::new(STROKE, 9));
    let mut display = MockDisplay::<Rgb565>::new();
    nothing.draw(&mut display).unwrap();
    display.assert_eq(&MockDisplay::new());
}

/// Extreme numbers: no panic, and what must be covered is.
#[test]
fn extreme_strokes_do_not_wrap() {
    let ends = [i32::MIN, -8_192, 7, i32::MAX];
    let corners: Vec<Point> = ends
        .iter()
        .flat_map(|&x| ends.iter().map(move |&y| Point::new(x, y)))
        .collect();
    let lengths = [U16F16::MAX, U16F16::from_bits(70_000)];
    for (index, &a) in corners.iter().enumerate() {
        for &b in &corners[index..] {
            for (cap, join, width, dashes) in [
                (LineCap::Round, LineJoin::Round, u32::MAX, None),
                (
                    LineCap::Square,
                    LineJoin::Miter { limit: U8F8::MAX },
                    4_096,
                    Some(&lengths[..]),
                ),
                (
                    LineCap::Butt,
                    LineJoin::Miter { limit: U8F8::MAX },
                    1,
                    Some(&lengths[..]),
                ),
            ] {
                let mut style = StrokeStyle::new(STROKE, width).cap(cap).join(join);
                (style.dashes, style.dash_offset) = (dashes, I16F16::MIN);
                let path = [a, b, Point::new(7, 9)];
                for closed in [false, true] {
                    let contours = [&path[..]];
                    let all = painted(screen(), |band| {
                        let Ok(()) = match closed {
                            true => Polygon::new(&contours, FillRule::NonZero)
                                .into_styled(style)
                                .draw_on(band),
                            false => Polyline::new(&path).into_styled(style).draw_on(band),
                        };
                    });
                    let bounds = Polyline::new(&path).into_styled(style).bounding_box();
                    assert!(all.iter().all(|&point| closed || encloses(&bounds, point)));
                    if width == u32::MAX && !closed {
                        assert_eq!(all.len(), 64 * 64, "{path:?}");
                    }
                }
            }
        }
    }
    let whole = Rectangle::new(Point::new(i32::MIN, i32::MIN), Size::new(u32::MAX, u32::MAX));
    drawn(
        whole,
        StrokeStyle::new(STROKE, 9).dashes(&lengths).dash_offset(I16F16::MIN),
    );
}

/// More primitives in every row than are told apart at once, on top of each other and beside each other.
#[test]
fn dashes_of_a_dense_zigzag_are_exact() {
    for (step, width) in [(1, 1), (40, 3), (2, 1), (6, 2), (7, 5)]
        .into_iter()
        .take(cases(2, 5) as usize)
    {
        for (cap, join) in [(LineCap::Butt, LineJoin::MITER), (LineCap::Round, LineJoin::Round)] {
            let teeth = (0..90).map(|tooth| {
                (
                    300 + tooth * step * 16 % 15_013,
                    if tooth % 2 == 0 { 771 } else { 15_307 },
                )
            });
            let units: Vec<(i32, i32)> = teeth.collect();
            let style = Style {
                width,
                cap,
                join,
                dashes: Some((vec![347_001, 500_003, 91_007, 700_001], 1_234)),
            };
            let free = check_sub_pixel(&units, false, &style);
            assert!(free.is_some_and(|free| free < 40), "{free:?}: {style:?} {step}");
        }
    }
}
