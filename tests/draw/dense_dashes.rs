//! Dashes far below a pixel, and dots that overlap: against exact arithmetic for every pixel centre, the same in every
//! window, whatever the numbers.

use std::collections::BTreeSet;

use embedded_graphics::{
    mock_display::MockDisplay,
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Line, Polyline, Primitive, Rectangle, Styled, StyledDrawable, Triangle},
};
use fixed::types::{I16F16, U16F16};
use proptest::prelude::*;
use zrow::{
    draw::{DrawOn, FillRule, LineCap, LineJoin, Path, PathCommand, Polygon, StrokeStyle},
    geometry::{Sub8, SubPoint},
};

use crate::common::{cases, config, painted};

type Pixels = BTreeSet<(i32, i32)>;

const STROKE: Rgb565 = Rgb565::RED;

/// 1/65,536 pixel is 1, 1/256 pixel is 256.
const UNIT: i64 = 1 << 16;

const SCREEN: Rectangle = Rectangle::new(Point::zero(), Size::new(64, 64));

fn lengths(bits: &[u32]) -> Vec<U16F16> {
    bits.iter().map(|&bits| U16F16::from_bits(bits)).collect()
}

fn pixels(area: Rectangle, draw: impl FnOnce(&mut zrow::band::Band<'_, Rgb565>)) -> Pixels {
    painted(area, draw)
        .into_iter()
        .map(|point| (point.x, point.y))
        .collect()
}

/// The picture on a display that panics on a pixel drawn twice; the same in bands, in single rows and in columns.
fn drawn<S>(shape: &S, style: StrokeStyle<'_, Rgb565>) -> Pixels
where
    S: Primitive + Clone + for<'d> StyledDrawable<StrokeStyle<'d, Rgb565>, Color = Rgb565, Output = ()>,
    for<'d> Styled<S, StrokeStyle<'d, Rgb565>>: DrawOn<Color = Rgb565>,
{
    let styled = shape.clone().into_styled(style);
    let mut display = MockDisplay::new();
    styled.draw(&mut display).unwrap();
    let all: Pixels = SCREEN
        .points()
        .filter(|&point| display.get_pixel(point).is_some())
        .map(|point| (point.x, point.y))
        .collect();
    let rows = (0..7).map(|band| Rectangle::new(Point::new(0, 5 * band), Size::new(64, 5)));
    let single_rows = (35..43).map(|row| Rectangle::new(Point::new(0, row), Size::new(64, 1)));
    let columns = (0..3).map(|column| Rectangle::new(Point::new(22 * column, 43), Size::new(22, 21)));
    let parts: Pixels = rows
        .chain(single_rows)
        .chain(columns)
        .flat_map(|window| {
            pixels(window, |band| {
                let Ok(()) = styled.draw_on(band);
            })
        })
        .filter(|&(x, _)| x < 64)
        .collect();
    assert_eq!(parts, all, "in parts");
    all
}

/// A straight line between two positions in 1/256 pixel.
fn line(from: (i32, i32), to: (i32, i32)) -> [PathCommand<Sub8>; 2] {
    let point = |(x, y)| SubPoint::from_units(x, y).unwrap();
    [PathCommand::MoveTo(point(from)), PathCommand::LineTo(point(to))]
}

fn drawn_line(commands: &[PathCommand<Sub8>], style: StrokeStyle<'_, Rgb565>) -> Pixels {
    drawn(&Path::new(commands, FillRule::NonZero).unwrap(), style)
}

/// The dashes of a line of that length, in distances from its begin: from where to where, in the unit of the lengths.
fn dashes(lengths: &[u32], offset: i32, end: i64) -> Vec<(i64, i64)> {
    let lengths: Vec<i64> = lengths.iter().map(|&length| i64::from(length)).collect();
    let cycle = lengths.iter().sum::<i64>() * (1 + lengths.len() as i64 % 2);
    let mut begin = -i64::from(offset).rem_euclid(cycle);
    let mut dashes = Vec::new();
    for index in 0.. {
        let dash = (begin, begin + lengths[index % lengths.len()]);
        if begin >= end {
            return dashes;
        }
        begin = dash.1;
        if index % 2 == 0 && (dash.0 >= 0 || dash.1 > 0) {
            dashes.push((dash.0.max(0), dash.1.min(end)));
        }
    }
    dashes
}

fn short_lengths() -> impl Strategy<Value = Vec<u32>> {
    let length = prop_oneof![
        3 => 1..600u32,
        2 => 1..8u32,
        2 => 600..70_000u32,
        1 => Just(0),
    ];
    prop::collection::vec(length, 1..6).prop_filter("all are 0", |lengths| lengths.iter().any(|&length| length > 0))
}

/// A level or an upright line, forwards or backwards, and which way.
fn straight_line() -> impl Strategy<Value = ((i32, i32), (i32, i32), bool)> {
    let coordinate = || prop_oneof![-2_000..18_000i32, (-8..70i32).prop_map(|pixel| pixel * 256)];
    (coordinate(), coordinate(), coordinate(), any::<bool>()).prop_map(|(across, from, to, level)| {
        if level {
            ((from, across), (to, across), level)
        } else {
            ((across, from), (across, to), level)
        }
    })
}

proptest! {
    #![proptest_config(config(cases(20, 200)))]

    /// Lengths along level and upright lines are exact: a pixel belongs when its distance from the begin, taken modulo the
    /// pattern, is in a dash.
    #[test]
    fn butt_dashes_along_the_axes_are_taken_modulo_the_pattern(
        (from, to, level) in straight_line(),
        width in prop_oneof![1..9u32, 1..60u32],
        bits in short_lengths(),
        offset in any::<i32>(),
    ) {
        prop_assume!(from != to);
        let style = StrokeStyle::new(STROKE, width).cap(LineCap::Butt);
        let pattern = lengths(&bits);
        let style = style.dashes(&pattern).dash_offset(I16F16::from_bits(offset));
        let drawn = drawn_line(&line(from, to), style);
        let cycle: i64 = bits.iter().map(|&length| i64::from(length)).sum::<i64>() * (1 + bits.len() as i64 % 2);
        let half = i64::from(width) * UNIT / 2;
        let (start, end, middle) = if level { (from.0, to.0, from.1) } else { (from.1, to.1, from.0) };
        let (start, end, middle) = (i64::from(start) << 8, i64::from(end) << 8, i64::from(middle) << 8);
        for Point { x, y } in SCREEN.points() {
            let (along, across) = if level { (x, y) } else { (y, x) };
            let (along, across) = (i64::from(along) * UNIT, i64::from(across) * UNIT);
            // Left and top ends belong: backwards these are where dashes end.
            let distance = if start < end { along - start } else { start - along - 1 };
            let mut position = (distance + i64::from(offset)).rem_euclid(cycle);
            let mut index = 0;
            while position >= i64::from(bits[index % bits.len()]) {
                position -= i64::from(bits[index % bits.len()]);
                index += 1;
            }
            let on = index % 2 == 0 && (0..(end - start).abs()).contains(&distance);
            let expected = on && middle - half <= across && across < middle + half;
            prop_assert_eq!(drawn.contains(&(x, y)), expected, "{}, {}", x, y);
        }
    }

    /// Discs and rectangles of level and upright lines are exact, too.
    #[test]
    fn round_dashes_along_the_axes_are_discs_and_rectangles(
        (from, to, level) in straight_line(),
        width in prop_oneof![1..9u32, 1..120u32],
        gap in prop_oneof![0..600u32, 0..200_000u32],
        dash in prop_oneof![2 => Just(0), 1 => 0..200_000u32],
        offset in any::<i32>(),
    ) {
        prop_assume!(from != to);
        // Shorter gaps are bridged.
        let half = i64::from(width) * UNIT / 2;
        let gap = gap + (4 * half as u64).isqrt() as u32 + 1;
        let bits = [dash, gap];
        let pattern = lengths(&bits);
        let style = StrokeStyle::new(STROKE, width).cap(LineCap::Round);
        let style = style.dashes(&pattern).dash_offset(I16F16::from_bits(offset));
        let drawn = drawn_line(&line(from, to), style);
        let (start, end, middle) = if level { (from.0, to.0, from.1) } else { (from.1, to.1, from.0) };
        let (start, end, middle) = (i64::from(start) << 8, i64::from(end) << 8, i64::from(middle) << 8);
        let sign = (end - start).signum();
        let dashes: Vec<(i64, i64)> = dashes(&bits, offset, (end - start).abs())
            .into_iter()
            .map(|(from, to)| (start + sign * from, start + sign * to))
            .map(|(from, to)| (from.min(to), from.max(to)))
            .collect();
        for Point { x, y } in SCREEN.points() {
            let (along, across) = if level { (x, y) } else { (y, x) };
            let (along, across) = (i64::from(along) * UNIT, i64::from(across) * UNIT);
            let in_rectangle = |&(first, last): &(i64, i64)| {
                first <= along && along < last && middle - half <= across && across < middle + half
            };
            let in_disc = |center: i64| {
                let surplus = (along - center).pow(2) + (across - middle).pow(2) - half * half;
                let is_left = if level { along < center } else { across < middle };
                surplus < 0 || surplus == 0 && is_left
            };
            let expected = dashes.iter().any(|dash| in_rectangle(dash) || in_disc(dash.0) || in_disc(dash.1));
            prop_assert_eq!(drawn.contains(&(x, y)), expected, "{}, {}", x, y);
        }
    }
}

/// How far a pixel centre is inside a dashed line, or outside: in 1/65,536 pixel, within one of them.
fn depth(dashes: &[(i64, i64)], half: f64, cap: LineCap, (along, across): (f64, f64)) -> f64 {
    let (lengthening, is_round) = match cap {
        LineCap::Butt => (0.0, false),
        LineCap::WholePixel => (UNIT as f64 / 2.0, false),
        LineCap::Square => (half, false),
        LineCap::Round => (0.0, true),
    };
    let depth = |&(from, to): &(i64, i64)| {
        let (from, to) = (from as f64 - lengthening, to as f64 + lengthening);
        if is_round {
            return half - (along - along.clamp(from, to)).hypot(across);
        }
        (along - from).min(to - along).min(half - across.abs())
    };
    // Between two that overlap or touch there is no edge.
    let mut joined: Vec<(i64, i64)> = Vec::new();
    let bridge = (2.0 * lengthening) as i64;
    for &(from, to) in dashes {
        match joined.last_mut() {
            Some(last) if from - last.1 <= bridge => last.1 = to,
            _ => joined.push((from, to)),
        }
    }
    joined.iter().map(depth).fold(f64::MIN, f64::max)
}

proptest! {
    #![proptest_config(config(cases(15, 60)))]

    /// In any direction: pixels whose centres are not within the rounding of an edge.
    #[test]
    fn short_dashes_in_any_direction_are_exact(
        from in (-500..9_000i32, -500..9_000i32),
        to in (-500..9_000i32, -500..9_000i32),
        width in prop_oneof![1..6u32, 1..40u32],
        cap in prop::sample::select(vec![LineCap::WholePixel, LineCap::Butt, LineCap::Square, LineCap::Round]),
        bits in prop::collection::vec(prop_oneof![3 => 80..900u32, 2 => 900..40_000u32, 1 => Just(0)], 1..5),
        offset in any::<i32>(),
    ) {
        prop_assume!(from != to && bits.iter().any(|&length| length > 0));
        let pattern = lengths(&bits);
        let style = StrokeStyle::new(STROKE, width).cap(cap);
        let style = style.dashes(&pattern).dash_offset(I16F16::from_bits(offset));
        let drawn = drawn_line(&line(from, to), style);
        let units = |(x, y): (i32, i32)| (f64::from(x) * 256.0, f64::from(y) * 256.0);
        let (from, to) = (units(from), units(to));
        let length = (to.0 - from.0).hypot(to.1 - from.1);
        let direction = ((to.0 - from.0) / length, (to.1 - from.1) / length);
        let dashes = dashes(&bits, offset, length as i64 + 1);
        let half = f64::from(width) * UNIT as f64 / 2.0;
        for y in 0..32 {
            for x in 0..32 {
                let (right, down) = (f64::from(x) * UNIT as f64 - from.0, f64::from(y) * UNIT as f64 - from.1);
                let along = right * direction.0 + down * direction.1;
                let across = right * direction.1 - down * direction.0;
                let depth = depth(&dashes, half, cap, (along, across));
                if depth.abs() > 6.0 {
                    prop_assert_eq!(drawn.contains(&(x, y)), depth > 0.0, "{}, {}: {}", x, y, depth);
                }
            }
        }
    }
}

/// Coordinates of the whole type, most of them near the screen.
fn coordinate() -> impl Strategy<Value = i32> {
    prop_oneof![
        4 => -20..84i32,
        1 => -8192..8192i32,
        1 => any::<i32>(),
        1 => prop::sample::select(vec![i32::MIN, i32::MAX, 16_384, 16_385, -16_384, -16_385]),
    ]
}

fn point() -> impl Strategy<Value = Point> {
    (coordinate(), coordinate()).prop_map(|(x, y)| Point::new(x, y))
}

/// Lengths of the whole type, most of them far below a pixel.
fn any_lengths() -> impl Strategy<Value = Vec<u32>> {
    let length = prop_oneof![
        2 => 0..3u32,
        2 => 0..300u32,
        2 => 0..70_000u32,
        1 => any::<u32>(),
        1 => Just(u32::MAX),
    ];
    prop::collection::vec(length, 0..8)
}

proptest! {
    #![proptest_config(config(cases(30, 300)))]

    /// Bounded work, no overflow, no pixel twice and the same picture in every window, for numbers of the whole types.
    #[test]
    fn dashes_of_any_numbers_are_the_same_in_parts(
        points in prop::collection::vec(point(), 3),
        size in (any::<u32>(), 0..90u32),
        width in prop_oneof![3 => 1..20u32, 2 => 1..300u32, 1 => any::<u32>()],
        cap in prop::sample::select(vec![LineCap::WholePixel, LineCap::Butt, LineCap::Square, LineCap::Round]),
        join in prop::sample::select(vec![LineJoin::MITER, LineJoin::Bevel, LineJoin::Round]),
        bits in any_lengths(),
        offset in prop_oneof![any::<i32>(), Just(i32::MIN), Just(i32::MAX)],
        shape in 0..5,
    ) {
        let pattern = lengths(&bits);
        let style = StrokeStyle::new(STROKE, width).cap(cap).join(join);
        let style = style.dashes(&pattern).dash_offset(I16F16::from_bits(offset));
        match shape {
            0 => drawn(&Line::new(points[0], points[1]), style),
            1 => drawn(&Polyline::new(&points), style),
            2 => drawn(&Triangle::new(points[0], points[1], points[2]), style),
            3 => drawn(&Rectangle::new(points[0], Size::new(size.0, size.1)), style),
            _ => drawn(&Polygon::new(&[points.as_slice()], FillRule::NonZero), style),
        };
    }

    /// Curves are many short segments.
    #[test]
    fn short_dashes_of_curves_are_the_same_in_parts(
        points in prop::collection::vec((-2_000..18_000i32, -2_000..18_000i32), 4),
        closed in any::<bool>(),
        width in 1..20u32,
        cap in prop::sample::select(vec![LineCap::WholePixel, LineCap::Butt, LineCap::Square, LineCap::Round]),
        bits in short_lengths(),
    ) {
        let points: Vec<SubPoint<Sub8>> = points.iter().map(|&(x, y)| SubPoint::from_units(x, y).unwrap()).collect();
        let mut commands = vec![PathCommand::MoveTo(points[0]), PathCommand::CubicTo(points[1], points[2], points[3])];
        commands.extend(closed.then_some(PathCommand::Close));
        let pattern = lengths(&bits);
        drawn_line(&commands, StrokeStyle::new(STROKE, width).cap(cap).dashes(&pattern));
    }
}

/// A dash that is bridged to the next one, but comes in from before the line, among dashes that are far from each other.
#[test]
fn bridged_dashes_are_drawn_once() {
    for cap in [LineCap::WholePixel, LineCap::Butt, LineCap::Square, LineCap::Round] {
        for gap in [0, 1, 700, 1 << 16] {
            let pattern = lengths(&[3 << 16, gap, 2 << 16, 20 << 16]);
            for offset in 0..5 {
                let style = StrokeStyle::new(STROKE, 3).cap(cap).dashes(&pattern);
                let style = style.dash_offset(I16F16::from_num(offset));
                let ends = [Point::new(3, 5), Point::new(59, 41)];
                let line = drawn(&Line::new(ends[0], ends[1]), style);
                assert_eq!(line, drawn(&Polyline::new(&ends), style), "{cap:?}, {gap}, {offset}");
                assert!(line.len() > 20);
            }
        }
    }
}

/// Where the pattern lies with respect to the pixel centres decides: dashes of half a pixel on each centre or between them.
#[test]
fn pixel_centres_see_a_pattern_shorter_than_a_pixel() {
    let row = |bits: &[u32], offset: i32| -> String {
        let pattern = lengths(bits);
        let style = StrokeStyle::new(STROKE, 1).cap(LineCap::Butt);
        let style = style.dashes(&pattern).dash_offset(I16F16::from_bits(offset));
        let drawn = drawn(&Line::new(Point::new(0, 3), Point::new(12, 3)), style);
        (0..12)
            .map(|x| if drawn.contains(&(x, 3)) { '#' } else { '.' })
            .collect()
    };
    let half = 1 << 15;
    assert_eq!(row(&[half, half], 0), "############");
    assert_eq!(row(&[half, half], half as i32), "............");
    // A period of 3/4 pixel: each centre is 1/4 pixel further in it.
    assert_eq!(row(&[half / 2, half], 0), "#..#..#..#..");
    // Lengths of 1/65,536 pixel: even distances are on.
    assert_eq!(row(&[1, 1], 0), "############");
    assert_eq!(row(&[1], 1), "............");
    // What the caps bridge is solid.
    assert_eq!(row(&[0, 1], 0), "............");
    let dots = |cap| {
        let pattern = lengths(&[0, 1]);
        let style = StrokeStyle::new(STROKE, 3).cap(cap).dashes(&pattern);
        drawn(&Line::new(Point::new(5, 5), Point::new(12, 5)), style)
    };
    let solid = |cap| {
        let style = StrokeStyle::new(STROKE, 3).cap(cap);
        drawn(&Line::new(Point::new(5, 5), Point::new(12, 5)), style)
    };
    for cap in [LineCap::WholePixel, LineCap::Square, LineCap::Round] {
        assert_eq!(dots(cap), solid(cap), "{cap:?}");
    }
}

/// Patterns of whole and of broken pixels, of all caps, joins and shapes: no cap reaches further than the pattern is long.
#[test]
fn ordinary_dashes_have_the_pixels_they_had_when_each_was_drawn_by_itself() {
    let mut state = 0x0123_4567_u32;
    let mut random = |bound: u32| {
        // xorshift32.
        state ^= state << 13;
        state ^= state >> 17;
        state ^= state << 5;
        state % bound
    };
    // FNV-1a, of each pixel's column and row.
    let (mut hash, mut count) = (0xcbf2_9ce4_8422_2325_u64, 0);
    for _ in 0..2_000 {
        let points: Vec<Point> = (0..3 + random(3))
            .map(|_| Point::new(random(100) as i32 - 20, random(100) as i32 - 20))
            .collect();
        let width = 1 + random(13);
        let fraction = [0, 0xffff][random(2) as usize];
        let mut bits: Vec<u32> = (0..1 + random(4))
            .map(|_| (random(24) << 16) + random(1 + fraction))
            .collect();
        bits[0] += width << 15;
        let pattern = lengths(&bits);
        let offset = I16F16::from_bits((random(60) << 16) as i32 - (30 << 16) + random(1 + fraction) as i32);
        let caps = [LineCap::WholePixel, LineCap::Butt, LineCap::Square, LineCap::Round];
        let joins = [LineJoin::MITER, LineJoin::Bevel, LineJoin::Round];
        let style = StrokeStyle::new(STROKE, width)
            .cap(caps[random(4) as usize])
            .join(joins[random(3) as usize])
            .dashes(&pattern)
            .dash_offset(offset);
        let shape = random(4);
        let picture = pixels(SCREEN, |band| {
            let Ok(()) = match shape {
                0 => Line::new(points[0], points[1]).into_styled(style).draw_on(band),
                1 => Polyline::new(&points).into_styled(style).draw_on(band),
                2 => Triangle::new(points[0], points[1], points[2])
                    .into_styled(style)
                    .draw_on(band),
                _ => Rectangle::with_corners(points[0], points[1])
                    .into_styled(style)
                    .draw_on(band),
            };
        });
        count += picture.len();
        for (x, y) in picture {
            for byte in [x as u8, y as u8] {
                hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
            }
        }
    }
    assert_eq!((count, hash), (689_832, 12_085_723_154_164_739_311));
}
