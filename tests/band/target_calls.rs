//! What a draw target can be asked for: calls with any numbers, the pixels that each of them asks for, in exact arithmetic,
//! and how the colours of an area may be read.

use std::{cell::Cell, collections::HashSet, rc::Rc};

use embedded_graphics::{
    Pixel,
    pixelcolor::{BinaryColor, Gray8, Rgb565, Rgb888, raw::RawU16},
    prelude::*,
    primitives::{Rectangle, Triangle},
};
use proptest::prelude::*;
use zrow::{
    band::{BandColor, Span},
    geometry::Window,
    shade::ChannelColor,
};

use crate::{common::encloses, reference::nearest_pixels::nearest};

/// A colour that a number stands for; no number stands for the colour of zero bits, which pictures begin with.
pub trait Numbered: BandColor + ChannelColor + core::fmt::Debug {
    fn numbered(number: u16) -> Self;
}

impl Numbered for Gray8 {
    fn numbered(number: u16) -> Self {
        Self::new((number % 255) as u8 + 1)
    }
}

impl Numbered for Rgb565 {
    fn numbered(number: u16) -> Self {
        RawU16::new(number.max(1)).into()
    }
}

impl Numbered for Rgb888 {
    fn numbered(number: u16) -> Self {
        Self::new(number as u8, (number >> 8) as u8, 77)
    }
}

/// What a target is asked for. Numbers stand for colours.
#[derive(Debug, Clone)]
pub enum Call {
    // All draw targets:
    Pixels(Vec<(Point, u16)>),
    /// Colours that are numbered through, as many as this.
    Contiguous(Rectangle, u128),
    Solid(Rectangle, u16),
    Clear(u16),
    // Targets:
    Span(Span, u16),
    Window(Window, u16),
    Line((Point, Point), u16),
    /// The vertices lie about the window's first pixel.
    Triangle([Point; 3], u16),
    // Targets that blend, with a coverage of all or nothing:
    Blend(Span, u16, bool),
    // Targets that multisample, with a mask of all samples or none:
    Samples(Span, u16, bool),
    SampleColors(Span, u128),
}

/// The number of colour `index` of a list that goes on for ever.
pub fn number_of(index: u128) -> u16 {
    (index % 65_521) as u16
}

/// Row and column in a rectangle of any size, in exact arithmetic.
fn offset_in(area: &Rectangle, point: Point) -> Option<(u128, u128)> {
    encloses(area, point).then(|| {
        let offset = |start: i32, value: i32| (i128::from(value) - i128::from(start)) as u128;
        (offset(area.top_left.y, point.y), offset(area.top_left.x, point.x))
    })
}

fn index_in(area: &Rectangle, point: Point) -> Option<u128> {
    offset_in(area, point).map(|(row, column)| row * u128::from(area.size.width) + column)
}

fn is_in_span(span: &Span, point: Point) -> bool {
    point.y == span.y && span.start <= point.x && point.x < span.end
}

/// Whether a pixel is the one of its column or row that is nearest to a line, ties to the larger coordinate.
fn is_on_line(&(from, to): &(Point, Point), point: Point) -> bool {
    let [x0, y0, x1, y1, x, y] = [from.x, from.y, to.x, to.y, point.x, point.y].map(i128::from);
    let (start, delta, minor_start, minor_delta, major, minor) = if (x1 - x0).abs() >= (y1 - y0).abs() {
        (x0, x1 - x0, y0, y1 - y0, x, y)
    } else {
        (y0, y1 - y0, x0, x1 - x0, y, x)
    };
    let way = (major - start) * delta.signum();
    let offset = nearest(way * minor_delta, delta.abs().max(1));
    (0..=delta.abs()).contains(&way) && (major == start || delta != 0) && minor == minor_start + offset
}

/// The pixels of a triangle that embedded-graphics fills, about the origin.
fn triangle_pixels(vertices: [Point; 3]) -> HashSet<Point> {
    let [a, b, c] = vertices;
    let triangle = Triangle::new(a, b, c).into_styled(embedded_graphics::primitives::PrimitiveStyle::with_fill(
        BinaryColor::On,
    ));
    triangle.pixels().map(|Pixel(point, _)| point).collect()
}

/// The pixels of a window that a call gives a colour, and its number; row by row.
pub fn asked_for(call: &Call, window: &Window) -> Vec<(Point, u16)> {
    let triangle = match call {
        Call::Triangle(vertices, _) => triangle_pixels(*vertices),
        _ => HashSet::new(),
    };
    let origin = Point::new(window.left, window.top);
    let number = |point: Point| match call {
        Call::Pixels(pixels) => pixels.iter().rev().find(|pixel| pixel.0 == point).map(|pixel| pixel.1),
        Call::Contiguous(area, count) => index_in(area, point).filter(|index| index < count).map(number_of),
        Call::Solid(area, number) => encloses(area, point).then_some(*number),
        Call::Clear(number) => Some(*number),
        Call::Span(span, number) | Call::Blend(span, number, true) | Call::Samples(span, number, true) => {
            is_in_span(span, point).then_some(*number)
        }
        Call::Blend(_, _, false) | Call::Samples(_, _, false) => None,
        Call::SampleColors(span, count) => {
            let index = (i128::from(point.x) - i128::from(span.start)) as u128;
            (is_in_span(span, point) && index < *count).then(|| number_of(index))
        }
        Call::Window(block, number) => block.contains(point).then_some(*number),
        Call::Line(line, number) => is_on_line(line, point).then_some(*number),
        Call::Triangle(_, number) => triangle.contains(&(point - origin)).then_some(*number),
    };
    points(window)
        .filter_map(|point| number(point).map(|number| (point, number)))
        .collect()
}

pub fn points(window: &Window) -> impl Iterator<Item = Point> + use<> {
    let columns = window.left..window.right;
    (window.top..window.bottom).flat_map(move |y| columns.clone().map(move |x| Point::new(x, y)))
}

/// How a list of colours was read.
#[derive(Debug, Clone, Default)]
pub struct Reading {
    pub calls: Rc<Cell<u128>>,
    /// One more than the last index that was asked for.
    pub reached: Rc<Cell<u128>>,
}

/// Colours that are numbered through, entered anywhere at once.
pub struct Colors<C> {
    next: u128,
    end: u128,
    reading: Reading,
    color: core::marker::PhantomData<C>,
}

impl<C> Colors<C> {
    pub fn new(end: u128, reading: &Reading) -> Self {
        Self {
            next: 0,
            end,
            reading: reading.clone(),
            color: core::marker::PhantomData,
        }
    }
}

impl<C: Numbered> Iterator for Colors<C> {
    type Item = C;

    fn next(&mut self) -> Option<C> {
        self.nth(0)
    }

    fn nth(&mut self, count: usize) -> Option<C> {
        let index = self.next + count as u128;
        self.next = index + 1;
        self.reading.calls.set(self.reading.calls.get() + 1);
        self.reading.reached.set(self.next);
        (index < self.end).then(|| C::numbered(number_of(index)))
    }
}

/// Checks how the colours of an area were read: the visible ones once, what is to their left or above them in one step a
/// row, and nothing behind the last one or behind the end.
pub fn check_reading(reading: &Reading, area: &Rectangle, end: u128, window: &Window) -> Result<(), TestCaseError> {
    let visible: Vec<Point> = points(window).filter(|&point| encloses(area, point)).collect();
    let rows: HashSet<i32> = visible.iter().map(|point| point.y).collect();
    let (calls, reached) = (reading.calls.get(), reading.reached.get());
    prop_assert!(
        calls <= (visible.len() + rows.len()) as u128,
        "{} reads of {:?}",
        calls,
        area
    );
    let last = visible.last().and_then(|&point| index_in(area, point));
    prop_assert!(
        reached <= last.map_or(0, |last| last + 1),
        "read on behind the last visible pixel"
    );
    let first_missing = visible
        .iter()
        .filter_map(|&point| index_in(area, point))
        .filter(|&index| index >= end)
        .min();
    if let Some(missing) = first_missing {
        prop_assert!(reached <= missing + 1, "read on behind the end");
    }
    Ok(())
}

/// Windows in the middle of the number range and at its ends.
fn windows() -> impl Strategy<Value = Window> {
    let start = prop_oneof![3 => -20..20i32, 1 => Just(i32::MIN), 1 => Just(i32::MAX - 12), 1 => any::<i32>()];
    (start.clone(), start, 1..=12u32, 1..=6u32).prop_map(|(left, top, width, height)| {
        let (left, top) = (left.min(i32::MAX - 12), top.min(i32::MAX - 12));
        Window::from(Rectangle::new(Point::new(left, top), Size::new(width, height)))
    })
}

/// Windows against the last columns and rows that there are.
fn last_windows() -> impl Strategy<Value = Window> {
    (1..=12i32, 1..=6i32, any::<bool>(), any::<bool>()).prop_map(|(width, height, is_right, is_low)| {
        let ends = |is_last: bool, length: i32| match is_last {
            true => (i32::MAX - length, i32::MAX),
            false => (i32::MIN, i32::MIN + length),
        };
        let ((left, right), (top, bottom)) = (ends(is_right, width), ends(is_low, height));
        Window {
            left,
            top,
            right,
            bottom,
        }
    })
}

/// A coordinate near a side of a window, where it would be near modulo a power of two, or anywhere.
fn coordinate(start: i32, end: i32) -> impl Strategy<Value = i32> {
    let near = prop_oneof![
        4 => (-3..16i32).prop_map(move |offset| start.saturating_add(offset)),
        1 => (-3..4i32).prop_map(move |offset| end.saturating_add(offset)),
    ];
    let far = (any::<bool>(), -3..4i32, 8..32u32).prop_map(move |(is_end, offset, bit)| {
        (if is_end { end } else { start })
            .wrapping_add(offset)
            .wrapping_add(1 << bit)
    });
    prop_oneof![
        10 => near,
        2 => far,
        1 => any::<i32>(),
        1 => prop::sample::select(vec![i32::MIN, i32::MIN + 1, -1, 0, i32::MAX - 1, i32::MAX]),
    ]
}

fn length() -> impl Strategy<Value = u32> {
    prop_oneof![
        8 => 0..20u32,
        1 => any::<u32>(),
        2 => prop::sample::select(vec![u32::MAX, u32::MAX - 1, 1 << 31, (1 << 31) - 1, 1 << 16]),
    ]
}

fn point(window: Window) -> impl Strategy<Value = Point> {
    (
        coordinate(window.left, window.right),
        coordinate(window.top, window.bottom),
    )
        .prop_map(|(x, y)| Point::new(x, y))
}

fn area(window: Window) -> impl Strategy<Value = Rectangle> {
    (point(window), length(), length())
        .prop_map(|(top_left, width, height)| Rectangle::new(top_left, Size::new(width, height)))
}

fn count() -> impl Strategy<Value = u128> {
    prop_oneof![3 => 0..120u128, 2 => Just(u128::from(u64::MAX)), 1 => Just(u128::MAX)]
}

fn span(window: Window) -> impl Strategy<Value = Span> {
    let x = || coordinate(window.left, window.right);
    (coordinate(window.top, window.bottom), x(), x()).prop_map(|(y, start, end)| Span::new(y, start, end))
}

/// The vertices of a triangle about the first pixel of a window, so near that all of them are pixels.
fn triangle(window: Window) -> impl Strategy<Value = [Point; 3]> {
    let near = |start: i32| {
        let before = 30.min(start.abs_diff(i32::MIN)) as i32;
        let behind = 30.min(start.abs_diff(i32::MAX)) as i32;
        -before..behind
    };
    let vertex = move || (near(window.left), near(window.top)).prop_map(|(x, y)| Point::new(x, y));
    [vertex(), vertex(), vertex()]
}

/// What every draw target can be asked for.
fn pixel_call(window: Window) -> impl Strategy<Value = Call> {
    let pixels = prop::collection::vec((point(window), any::<u16>()), 0..40);
    prop_oneof![
        pixels.prop_map(Call::Pixels),
        (area(window), count()).prop_map(|(area, count)| Call::Contiguous(area, count)),
        (area(window), any::<u16>()).prop_map(|(area, number)| Call::Solid(area, number)),
        any::<u16>().prop_map(Call::Clear),
    ]
}

pub fn call(window: Window) -> impl Strategy<Value = Call> {
    let block = (point(window), point(window)).prop_map(|(from, to)| Window {
        left: from.x,
        top: from.y,
        right: to.x,
        bottom: to.y,
    });
    prop_oneof![
        2 => pixel_call(window),
        1 => (span(window), any::<u16>()).prop_map(|(span, number)| Call::Span(span, number)),
        1 => (block, any::<u16>()).prop_map(|(block, number)| Call::Window(block, number)),
        2 => (triangle(window), any::<u16>()).prop_map(|(vertices, number)| Call::Triangle(vertices, number)),
        2 => ((point(window), point(window)), any::<u16>()).prop_map(|(line, number)| Call::Line(line, number)),
    ]
}

pub fn blend_call(window: Window) -> impl Strategy<Value = Call> {
    (span(window), any::<u16>(), any::<bool>())
        .prop_map(|(span, number, is_covered)| Call::Blend(span, number, is_covered))
}

pub fn sample_call(window: Window) -> impl Strategy<Value = Call> {
    prop_oneof![
        (span(window), any::<u16>(), any::<bool>())
            .prop_map(|(span, number, is_covered)| Call::Samples(span, number, is_covered)),
        (span(window), count()).prop_map(|(span, count)| Call::SampleColors(span, count)),
    ]
}

pub fn in_window<S: Strategy<Value = Call>>(call: impl Fn(Window) -> S) -> impl Strategy<Value = (Window, Vec<Call>)> {
    prop_oneof![4 => windows().boxed(), 1 => last_windows().boxed()]
        .prop_flat_map(move |window| (Just(window), prop::collection::vec(call(window), 1..4)))
}
