//! The band, and any display behind `Generic`, as draw targets against a plain model; and the picture loop over any area at all.

use core::convert::Infallible;

use embedded_graphics::{
    Pixel,
    image::GetPixel,
    pixelcolor::{BinaryColor, Gray4, Rgb565, Rgb888, raw::RawU16},
    prelude::*,
    primitives::{Circle, PrimitiveStyle, Rectangle},
};
use proptest::prelude::*;
use zrow::{
    band::{Band, BandColor, BigEndian, Generic, LittleEndian, LoopError, Order, PictureLoop, Span, Target},
    geometry::{TooSmall, Window},
};

use crate::common::{cases, config};

fn color(value: u16) -> Rgb565 {
    RawU16::new(value).into()
}

/// Number `index` of a list of colours that goes on for ever and can be entered anywhere at once.
fn numbered_color(index: u128) -> Rgb565 {
    // Never black, which is what the band starts with.
    color((index % 65_535) as u16 + 1)
}

struct NumberedColors {
    next: u128,
    end: u128,
}

impl Iterator for NumberedColors {
    type Item = Rgb565;

    fn next(&mut self) -> Option<Rgb565> {
        self.nth(0)
    }

    fn nth(&mut self, count: usize) -> Option<Rgb565> {
        let index = self.next + count as u128;
        self.next = index + 1;
        (index < self.end).then(|| numbered_color(index))
    }
}

/// Row and column of a point in a rectangle of any size; `None` outside.
fn row_and_column(area: &Rectangle, point: Point) -> Option<(u128, u128)> {
    let offset = |start: i32, value: i32, length: u32| {
        let offset = i64::from(value) - i64::from(start);
        (0..i64::from(length)).contains(&offset).then_some(offset as u128)
    };
    let column = offset(area.top_left.x, point.x, area.size.width)?;
    Some((offset(area.top_left.y, point.y, area.size.height)?, column))
}

#[derive(Debug, Clone)]
enum Operation {
    Pixels(Vec<(Point, u16)>),
    Contiguous(Rectangle, u128),
    Solid(Rectangle, u16),
}

/// The picture that the operations make, pixel by pixel.
fn model(window: Rectangle, operations: &[Operation]) -> Vec<Rgb565> {
    let pixel = |point: Point| {
        let mut result = Rgb565::BLACK;
        for operation in operations {
            match operation {
                Operation::Pixels(pixels) => {
                    for &(pixel, value) in pixels {
                        if pixel == point {
                            result = color(value);
                        }
                    }
                }
                Operation::Contiguous(area, count) => {
                    let index =
                        row_and_column(area, point).map(|(row, column)| row * u128::from(area.size.width) + column);
                    if let Some(index) = index.filter(|index| index < count) {
                        result = numbered_color(index);
                    }
                }
                Operation::Solid(area, value) => {
                    if row_and_column(area, point).is_some() {
                        result = color(*value);
                    }
                }
            }
        }
        result
    };
    window.points().map(pixel).collect()
}

fn draw_all(target: &mut impl DrawTarget<Color = Rgb565, Error = Infallible>, operations: &[Operation]) {
    for operation in operations {
        let Ok(()) = match operation {
            Operation::Pixels(pixels) => {
                target.draw_iter(pixels.iter().map(|&(point, value)| Pixel(point, color(value))))
            }
            Operation::Contiguous(area, count) => target.fill_contiguous(area, NumberedColors { next: 0, end: *count }),
            Operation::Solid(area, value) => target.fill_solid(area, color(*value)),
        };
    }
}

/// A display that takes only what is inside it.
struct Strict {
    window: Rectangle,
    pixels: Vec<Rgb565>,
}

impl Dimensions for Strict {
    fn bounding_box(&self) -> Rectangle {
        self.window
    }
}

impl DrawTarget for Strict {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(point, color) in pixels {
            let (row, column) = row_and_column(&self.window, point).expect("a pixel outside the display");
            self.pixels[row as usize * self.window.size.width as usize + column as usize] = color;
        }
        Ok(())
    }

    fn fill_contiguous<I: IntoIterator<Item = Rgb565>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), Infallible> {
        let pixels = area.points().zip(colors).map(|(point, color)| Pixel(point, color));
        self.draw_iter(pixels.collect::<Vec<_>>())
    }

    fn fill_solid(&mut self, area: &Rectangle, color: Rgb565) -> Result<(), Infallible> {
        self.fill_contiguous(area, core::iter::repeat(color))
    }
}

fn drawn_through_generic(window: Rectangle, operations: &[Operation]) -> Vec<Rgb565> {
    let mut display = Strict {
        window,
        pixels: vec![Rgb565::BLACK; (window.size.width * window.size.height) as usize],
    };
    draw_all(&mut Generic(&mut display), operations);
    display.pixels
}

fn drawn<O: Order>(window: Rectangle, operations: &[Operation]) -> Vec<Rgb565> {
    let mut words = vec![0; (window.size.width * window.size.height) as usize];
    let mut band = Band::<Rgb565, O>::new(window, &mut words).unwrap();
    draw_all(&mut band, operations);
    let read_back: Vec<Option<Rgb565>> = window.points().map(|point| band.pixel(point)).collect();
    let colors: Vec<Rgb565> = band.colors().collect();
    assert_eq!(read_back, colors.iter().copied().map(Some).collect::<Vec<_>>());
    colors
}

/// Bands in the middle of the number range and at its ends.
fn window() -> impl Strategy<Value = Rectangle> {
    let corner = prop_oneof![3 => -20..20i32, 1 => Just(i32::MIN), 1 => Just(i32::MAX - 12)];
    (corner.clone(), corner, 1..12u32, 1..6u32).prop_map(|(x, y, width, height)| rectangle(x, y, width, height))
}

fn rectangle(x: i32, y: i32, width: u32, height: u32) -> Rectangle {
    Rectangle::new(Point::new(x, y), Size::new(width, height))
}

fn coordinate() -> impl Strategy<Value = i32> {
    prop_oneof![
        6 => -24..34i32,
        1 => any::<i32>(),
        2 => prop::sample::select(vec![i32::MIN, i32::MIN + 3, i32::MAX, i32::MAX - 1, i32::MAX - 10]),
    ]
}

fn length() -> impl Strategy<Value = u32> {
    prop_oneof![
        6 => 0..30u32,
        1 => any::<u32>(),
        2 => prop::sample::select(vec![u32::MAX, u32::MAX - 1, 1 << 31, (1 << 31) - 1]),
    ]
}

fn area() -> impl Strategy<Value = Rectangle> {
    (coordinate(), coordinate(), length(), length()).prop_map(|(x, y, width, height)| rectangle(x, y, width, height))
}

fn operation() -> impl Strategy<Value = Operation> {
    let count = prop_oneof![3 => 0..700u128, 1 => Just(u128::from(u64::MAX))];
    let pixel = (
        (coordinate(), coordinate()).prop_map(|(x, y)| Point::new(x, y)),
        any::<u16>(),
    );
    prop_oneof![
        prop::collection::vec(pixel, 0..40).prop_map(Operation::Pixels),
        (area(), count).prop_map(|(area, count)| Operation::Contiguous(area, count)),
        (area(), any::<u16>()).prop_map(|(area, value)| Operation::Solid(area, value)),
    ]
}

/// The columns that a window can hold: column `i32::MAX` is not among them.
fn clamped_length(start: i64, end: i64) -> i64 {
    (end.min(i64::from(i32::MAX)) - start.max(i64::from(i32::MIN))).max(0)
}

proptest! {
    #![proptest_config(config(cases(3_000, 3_000)))]

    #[test]
    fn what_is_inside_is_drawn_and_nothing_else(
        window in window(),
        operations in prop::collection::vec(operation(), 1..4),
    ) {
        let expected = model(window, &operations);
        prop_assert_eq!(drawn::<LittleEndian>(window, &operations), expected.clone());
        prop_assert_eq!(drawn::<BigEndian>(window, &operations), expected.clone());
        prop_assert_eq!(drawn_through_generic(window, &operations), expected);
    }

    #[test]
    fn a_band_over_any_area_says_how_many_words_it_needs(area in area(), length in 0..400usize) {
        let width = clamped_length(area.top_left.x.into(), i64::from(area.top_left.x) + i64::from(area.size.width));
        let height = clamped_length(area.top_left.y.into(), i64::from(area.top_left.y) + i64::from(area.size.height));
        // More words than can be counted are asked for as the largest number.
        let needed = usize::try_from(i128::from(width) * i128::from(height)).unwrap_or(usize::MAX);
        let mut words = vec![7u16; length];
        match Band::<Rgb565>::new(area, &mut words) {
            Ok(band) => prop_assert!(needed <= length && band.words().len() == needed),
            Err(error) => prop_assert!(needed > length && error.needed() == needed),
        }
    }

    /// Nothing is drawn outside the words, and nothing panics.
    #[test]
    fn spans_and_windows_of_any_numbers_stay_inside_the_words(
        window in window(),
        area in area(),
        (start, end) in (coordinate(), coordinate()),
    ) {
        let mut words = vec![0u16; 100];
        let mut band = Band::<Rgb565>::new(window, &mut words).unwrap();
        let needed = band.words().len();
        let raw = band.raw(Rgb565::RED);
        let Ok(()) = band.fill_window(Window::from(area), raw);
        let Ok(()) = band.fill_span(Span::new(area.top_left.y, start, end), raw);
        prop_assert!(words[needed..].iter().all(|&word| word == 0));
    }

    /// The bands tile the area, the buffer it asks for is enough and one word less is not, for any numbers.
    #[test]
    fn a_picture_loop_over_any_area_is_right_or_an_error(
        area in area(),
        rows in length(),
        grid in (length(), length()),
        aligned in any::<bool>(),
    ) {
        let mut picture_loop = PictureLoop::new(area, Rgb565::BLACK).rows(rows);
        if aligned {
            picture_loop = picture_loop.aligned(grid.0, grid.1);
        }
        let Some(first) = picture_loop.bands().next() else {
            prop_assert!(area.size.width == 0 || area.size.height == 0 || area.top_left.x == i32::MAX || area.top_left.y == i32::MAX);
            prop_assert_eq!(picture_loop.words_needed(), 0);
            return Ok(());
        };
        let (left, width, height) = (first.top_left.x, first.size.width, first.size.height);
        let grid_x = if aligned { i64::from(grid.0.max(1)) } else { 1 };
        let grid_y = if aligned { i64::from(grid.1.max(1)) } else { 1 };
        let outwards = |start: i32, length: u32, grid: i64| {
            let end = (i64::from(start) + i64::from(length)).min(i64::from(i32::MAX));
            let end = -((-end).div_euclid(grid) * grid);
            (
                (i64::from(start).div_euclid(grid) * grid).max(i32::MIN.into()),
                end.min(i32::MAX.into()),
            )
        };
        let (expected_left, expected_right) = outwards(area.top_left.x, area.size.width, grid_x);
        prop_assert_eq!((i64::from(left), i64::from(left) + i64::from(width)), (expected_left, expected_right));
        let (top, bottom) = outwards(area.top_left.y, area.size.height, grid_y);
        let rows = (i64::from(rows.max(1)) + grid_y - 1) / grid_y * grid_y;
        prop_assert_eq!((i64::from(first.top_left.y), i64::from(height)), (top, rows.min(bottom - top)));

        let mut expected_top = top;
        for band in picture_loop.bands().take(5) {
            prop_assert_eq!((band.top_left.x, band.size.width), (left, width));
            prop_assert_eq!(i64::from(band.top_left.y), expected_top);
            expected_top += i64::from(band.size.height);
            prop_assert!(i64::from(band.size.height) == rows || expected_top == bottom);
        }

        let needed = picture_loop.words_needed();
        prop_assert_eq!(needed, usize::try_from(u128::from(width) * u128::from(height)).unwrap_or(usize::MAX));
        if needed <= 10_000 {
            let mut words = vec![0; needed];
            let mut sent = 0;
            let mut sink = |_: Band<'_, Rgb565>| {
                sent += 1;
                if sent == 3 { Err(()) } else { Ok(()) }
            };
            let circle = Circle::new(area.top_left, 5).into_styled(PrimitiveStyle::with_fill(Rgb565::RED));
            let result = picture_loop.draw(&mut words, &mut sink, |band| {
                let Ok(()) = band.fill_solid(&area, Rgb565::BLUE);
                if area.top_left.x.unsigned_abs() < 1000 && area.top_left.y.unsigned_abs() < 1000 {
                    let Ok(()) = circle.draw(band);
                }
            });
            let bands = picture_loop.bands().take(3).count();
            prop_assert_eq!(result, if bands == 3 { Err(LoopError::Sink(())) } else { Ok(()) });
            words.pop();
            let mut sink = |_: Band<'_, Rgb565>| Err(());
            let result = picture_loop.draw(&mut words, &mut sink, |_| -> () { panic!("drawn") });
            prop_assert_eq!(result, Err(LoopError::TooSmall(TooSmall::Words(needed))));
        }
    }
}

#[test]
fn every_word_size_is_read_back_as_it_was_written() {
    fn check<C: BandColor + core::fmt::Debug, O: Order>(colors: &[C], words: &mut [C::Word]) {
        let area = rectangle(3, -2, colors.len() as u32, 1);
        let mut band = Band::<C, O>::new(area, words).unwrap();
        let Ok(()) = band.fill_contiguous(&area, colors.iter().copied());
        for (point, &color) in area.points().zip(colors) {
            assert_eq!(band.pixel(point), Some(color));
        }
        assert_eq!(band.pixel(Point::new(2, -2)), None);
        assert_eq!(band.pixel(Point::new(3, -3)), None);
        assert!(band.colors().eq(colors.iter().copied()));
        assert!(
            band.words().iter().eq(colors
                .iter()
                .map(|&color| O::reorder(color.to_word()))
                .collect::<Vec<_>>()
                .iter())
        );
    }
    let rgb888 = [Rgb888::new(1, 2, 3), Rgb888::new(255, 0, 128), Rgb888::WHITE];
    check::<_, LittleEndian>(&rgb888, &mut [0; 3]);
    check::<_, BigEndian>(&rgb888, &mut [0; 3]);
    let rgb565 = [Rgb565::new(1, 2, 3), Rgb565::new(31, 0, 16), Rgb565::WHITE];
    check::<_, LittleEndian>(&rgb565, &mut [0; 3]);
    check::<_, BigEndian>(&rgb565, &mut [0; 3]);
    check::<_, LittleEndian>(&[Gray4::new(3), Gray4::new(15), Gray4::new(0)], &mut [0; 3]);
    check::<_, BigEndian>(&[BinaryColor::On, BinaryColor::Off], &mut [0; 2]);
}

#[test]
fn a_band_skips_what_does_not_meet_it() {
    let mut words = [0u16; 20];
    let mut band = Band::<Rgb565>::new(rectangle(0, 10, 20, 1), &mut words).unwrap();
    let style = PrimitiveStyle::with_fill(Rgb565::RED);
    assert_eq!(band.draw(&Circle::new(Point::new(0, 11), 9).into_styled(style)), None);
    assert!(band.colors().all(|color| color == Rgb565::BLACK));
    assert_eq!(
        band.draw(&Circle::new(Point::new(0, 10), 9).into_styled(style)),
        Some(())
    );
    assert!(band.colors().any(|color| color == Rgb565::RED));
}

#[test]
fn rows_are_found_by_their_position_in_the_picture() {
    let mut words = [0u16; 6];
    let mut band = Band::<Rgb565>::new(rectangle(5, -1, 3, 2), &mut words).unwrap();
    band.row_mut(0).unwrap().fill(9);
    assert!(band.row_mut(-2).is_none());
    assert!(band.row_mut(1).is_none());
    assert_eq!(words, [0, 0, 0, 9, 9, 9]);
}
