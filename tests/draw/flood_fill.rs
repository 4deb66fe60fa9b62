//! Flood fill and boundary fill against a search pixel by pixel.

use std::{cell::Cell, collections::VecDeque, convert::Infallible};

use embedded_graphics::{
    draw_target::DrawTarget,
    geometry::{Dimensions, Point, Size},
    image::GetPixel,
    pixelcolor::Gray8,
    prelude::*,
    primitives::Rectangle,
};
use proptest::prelude::*;
use zrow::{
    band::{Band, Generic, Target},
    draw::SeedFill,
    geometry::{DrawError, TooSmall, Window},
};

use crate::common::{cases, config};

const NEW: Gray8 = Gray8::new(9);
const WALL: Gray8 = Gray8::new(1);
const FLOOR: Gray8 = Gray8::new(0);

/// A picture of small numbers.
#[derive(Clone, Debug, PartialEq)]
struct Picture {
    width: i32,
    height: i32,
    colors: Vec<u8>,
}

impl Picture {
    fn from_rows(rows: &[&str]) -> Self {
        Self {
            width: rows[0].len() as i32,
            height: rows.len() as i32,
            colors: rows
                .concat()
                .bytes()
                .map(|byte| if byte == b'#' { 1 } else { 0 })
                .collect(),
        }
    }

    fn area(&self, top_left: Point) -> Rectangle {
        Rectangle::new(top_left, Size::new(self.width as u32, self.height as u32))
    }

    fn at(&self, x: i32, y: i32) -> Option<u8> {
        let inside = (0..self.width).contains(&x) && (0..self.height).contains(&y);
        inside.then(|| self.colors[(y * self.width + x) as usize])
    }

    /// The reference: breadth first, pixel by pixel.
    fn filled(&self, seed: (i32, i32), eight: bool, is_inside: impl Fn(u8) -> bool) -> Self {
        let mut picture = self.clone();
        let mut queue = VecDeque::from([seed]);
        while let Some((x, y)) = queue.pop_front() {
            if !picture.at(x, y).is_some_and(&is_inside) {
                continue;
            }
            picture.colors[(y * self.width + x) as usize] = 9;
            for dy in -1..=1 {
                for dx in -1..=1 {
                    if dx == 0 || dy == 0 || eight {
                        queue.push_back((x + dx, y + dy));
                    }
                }
            }
        }
        picture
    }

    /// The picture after a seed fill whose stack grows from 3 slots to as many as it takes; the stops on the way are counted.
    fn seed_filled(
        &self,
        top_left: Point,
        begin: impl FnOnce(&Band<'_, Gray8>) -> SeedFill<Gray8, 3>,
    ) -> (Self, usize) {
        let mut words = self.colors.clone();
        let mut band = Band::new(self.area(top_left), &mut words).unwrap();
        let fill = begin(&band);
        let mut stops = 0;
        let left = run_on::<3, 6>(fill, &mut band, &mut stops)
            .and_then(|fill| run_on::<6, 12>(fill, &mut band, &mut stops))
            .and_then(|fill| run_on::<12, 48>(fill, &mut band, &mut stops))
            .and_then(|fill| run_on::<48, 400>(fill, &mut band, &mut stops))
            .and_then(|fill| run_on::<400, 401>(fill, &mut band, &mut stops));
        assert!(left.is_none());
        let filled = Self {
            colors: words,
            ..self.clone()
        };
        (filled, stops)
    }
}

/// Runs a fill. Where its stack is full, a second try has to stop at the same pixel; the fill is handed on.
fn run_on<const SMALL: usize, const LARGE: usize>(
    mut fill: SeedFill<Gray8, SMALL>,
    band: &mut Band<'_, Gray8>,
    stops: &mut usize,
) -> Option<SeedFill<Gray8, LARGE>> {
    match fill.run(band) {
        Ok(()) => None,
        Err(DrawError::TooSmall(full)) => {
            assert!(matches!(full, TooSmall::Searches(needed) if needed > SMALL));
            *stops += 1;
            let before = band.words().to_vec();
            assert_eq!(fill.run(band), Err(DrawError::TooSmall(full)));
            assert_eq!(band.words(), before);
            Some(fill.with_stack().unwrap())
        }
        Err(error @ DrawError::OutOfDomain { .. }) => panic!("{error}"),
        Err(DrawError::Target(never)) => match never {},
    }
}

fn check(picture: &Picture, seed: (i32, i32), top_left: Point) -> usize {
    let seed_pixel = top_left + Point::new(seed.0, seed.1);
    let mut most = 0;
    for eight in [false, true] {
        let old = picture.at(seed.0, seed.1);
        let expected = picture.filled(seed, eight, |color| Some(color) == old);
        let (filled, stops) = picture.seed_filled(top_left, |band| {
            SeedFill::flood(band, seed_pixel, NEW).eight_connected(eight)
        });
        assert_eq!(filled, expected, "flood from {seed:?}, eight: {eight}");
        most = most.max(stops);

        let expected = picture.filled(seed, eight, |color| color != 1 && color != 9);
        let (filled, stops) = picture.seed_filled(top_left, |_| {
            SeedFill::boundary(seed_pixel, WALL, NEW).eight_connected(eight)
        });
        assert_eq!(filled, expected, "boundary from {seed:?}, eight: {eight}");
        most = most.max(stops);
    }
    most
}

fn pictures() -> impl Strategy<Value = Picture> {
    (1i32..=24, 1i32..=24, 1u8..=4).prop_flat_map(|(width, height, colors)| {
        prop::collection::vec(0..=colors, (width * height) as usize).prop_map(move |colors| Picture {
            width,
            height,
            // More floor than anything else: areas are connected in many ways.
            colors: colors
                .into_iter()
                .map(|color| if color > 1 { 0 } else { color })
                .collect(),
        })
    })
}

proptest! {
    #![proptest_config(config(cases(1_500, 1_500)))]

    #[test]
    fn fills_reach_what_a_search_by_pixels_reaches(picture in pictures(), x in 0i32..24, y in 0i32..24, far: bool) {
        let top_left = if far { Point::new(i32::MAX - 30, i32::MIN) } else { Point::new(-7, 3) };
        check(&picture, (x % picture.width, y % picture.height), top_left);
    }

    /// Windows against the first and the last columns and rows that there are.
    #[test]
    fn fills_reach_the_ends_of_the_number_range(
        picture in pictures(),
        x in 0i32..24,
        y in 0i32..24,
        (is_right, is_low) in any::<(bool, bool)>(),
    ) {
        let corner = |is_last: bool, length: i32| if is_last { i32::MAX - length } else { i32::MIN };
        let top_left = Point::new(corner(is_right, picture.width), corner(is_low, picture.height));
        let seed = (x % picture.width, y % picture.height);
        check(&picture, seed, top_left);
        for eight in [false, true] {
            check_reads(&picture, seed, top_left, eight)?;
        }
    }

    #[test]
    fn no_pixel_is_read_often(picture in pictures(), x in 0i32..24, y in 0i32..24) {
        for eight in [false, true] {
            check_reads(&picture, (x % picture.width, y % picture.height), Point::zero(), eight)?;
        }
    }
}

/// A target that counts what is read and painted. Outside its window, everything has the floor's colour.
struct Counting<'a, 'b> {
    band: &'a mut Band<'b, Gray8>,
    reads: Cell<u64>,
    spans: u64,
    painted: u64,
}

impl Dimensions for Counting<'_, '_> {
    fn bounding_box(&self) -> Rectangle {
        self.band.bounding_box()
    }
}

impl DrawTarget for Counting<'_, '_> {
    type Color = Gray8;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Gray8>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        self.band.draw_iter(pixels)
    }

    fn fill_solid(&mut self, area: &Rectangle, color: Gray8) -> Result<(), Infallible> {
        let window = Window::from(*area);
        assert_eq!(
            window.intersection(&self.band.window()),
            window,
            "painted beyond the window"
        );
        self.spans += 1;
        self.painted += u64::from(window.width());
        self.band.fill_solid(area, color)
    }
}

impl GetPixel for Counting<'_, '_> {
    type Color = Gray8;

    fn pixel(&self, point: Point) -> Option<Gray8> {
        self.reads.set(self.reads.get() + 1);
        Some(self.band.pixel(point).unwrap_or(FLOOR))
    }
}

/// Fills a picture that goes on beyond its window, and counts.
fn check_reads(picture: &Picture, seed: (i32, i32), top_left: Point, eight: bool) -> Result<(), TestCaseError> {
    let mut words = picture.colors.clone();
    let mut band = Band::<Gray8>::new(picture.area(top_left), &mut words).unwrap();
    let seed_pixel = top_left + Point::new(seed.0, seed.1);
    let mut target = Counting {
        band: &mut band,
        reads: Cell::new(0),
        spans: 0,
        painted: 0,
    };
    let mut fill = SeedFill::<_, 400>::flood(&target, seed_pixel, NEW).eight_connected(eight);
    prop_assert_eq!(fill.run(&mut Generic(&mut target)), Ok(()));
    let Counting {
        reads, spans, painted, ..
    } = target;
    let filled = picture.filled(seed, eight, |color| Some(color) == picture.at(seed.0, seed.1));
    prop_assert_eq!(&words, &filled.colors);
    prop_assert_eq!(
        painted,
        words.iter().filter(|&&word| word == 9).count() as u64,
        "each pixel once"
    );
    let most = 3 * painted + 7 * spans + 2;
    prop_assert!(
        reads.get() <= most,
        "{} reads of {} pixels in {} spans",
        reads.get(),
        painted,
        spans
    );
    Ok(())
}

/// Two pixels above each other in the last column.
#[test]
fn the_last_column_takes_no_more_reads_than_any_other() {
    let picture = Picture::from_rows(&[".", "."]);
    for x in [0, i32::MIN, i32::MAX - 1] {
        for eight in [false, true] {
            check_reads(&picture, (0, 0), Point::new(x, 0), eight).unwrap();
        }
    }
}

/// A spiral, a comb from both sides, an island with a lake, a diagonal wall.
#[test]
fn hard_cases() {
    let spiral = Picture::from_rows(&[
        "...........",
        ".#########.",
        ".#.......#.",
        ".#.#####.#.",
        ".#.#...#.#.",
        ".#.#.###.#.",
        ".#.#.....#.",
        ".#.#######.",
        ".#.........",
        ".##########",
    ]);
    let comb = Picture::from_rows(&[
        "#.#.#.#.#.#.#",
        "#.#.#.#.#.#.#",
        "#...........#",
        "#.#.#.#.#.#.#",
        "#.#.#.#.#.#.#",
    ]);
    let lake = Picture::from_rows(&[
        "........", ".######.", ".#....#.", ".#.##.#.", ".#....#.", ".######.", "........",
    ]);
    let diagonal = Picture::from_rows(&["....#", "...#.", "..#..", ".#...", "#...."]);
    for picture in [spiral, comb, lake, diagonal] {
        for y in 0..picture.height {
            for x in 0..picture.width {
                check(&picture, (x, y), Point::zero());
            }
        }
    }
}

/// Teeth on both sides of one long run: each is a search of its own.
#[test]
fn a_full_stack_stops_and_goes_on() {
    let teeth = ".#".repeat(60);
    let row = ".".repeat(120);
    let picture = Picture::from_rows(&[&row, &teeth, &row, &teeth, &row, &teeth, &row]);
    assert!(check(&picture, (0, 2), Point::zero()) > 1);
}

#[test]
fn what_holds_more_does_not_fit_a_smaller_stack() {
    let picture = Picture::from_rows(&["...", "...", "..."]);
    let mut words = picture.colors.clone();
    let mut band = Band::<Gray8>::new(picture.area(Point::zero()), &mut words).unwrap();
    let mut fill = SeedFill::<_, 3>::flood(&band, Point::new(1, 1), NEW);
    let full = fill.run(&mut band).unwrap_err();
    assert!(matches!(full, DrawError::TooSmall(full) if full.needed() == 4));
    let needed = fill.with_stack::<0>().unwrap_err();
    assert_eq!(needed, TooSmall::Searches(1));
    assert!(fill.with_stack::<4>().unwrap().run(&mut band).is_ok());
    assert_eq!(words, [9; 9]);
}

#[test]
fn nothing_to_fill() {
    let picture = Picture::from_rows(&["..#", "..#"]);
    let mut words = picture.colors.clone();
    let mut band = Band::<Gray8>::new(picture.area(Point::zero()), &mut words).unwrap();
    for (seed, color) in [
        // Outside; already of that colour; on the boundary.
        (Point::new(3, 0), NEW),
        (Point::new(i32::MIN, i32::MAX), NEW),
        (Point::new(0, 0), FLOOR),
    ] {
        assert_eq!(
            SeedFill::<_, 3>::flood(&band, seed, color)
                .eight_connected(true)
                .run(&mut band),
            Ok(())
        );
    }
    for (seed, color) in [
        (Point::new(2, 0), NEW),
        (Point::new(0, 0), FLOOR),
        (Point::new(-1, 1), NEW),
    ] {
        assert_eq!(
            SeedFill::<_, 3>::boundary(seed, WALL, color)
                .eight_connected(true)
                .run(&mut band),
            Ok(())
        );
    }
    assert_eq!(words, picture.colors);
}

/// A target that fails once, at a given span.
struct Failing<'a, 'b> {
    band: &'a mut Band<'b, Gray8>,
    spans_left: Option<usize>,
}

impl Dimensions for Failing<'_, '_> {
    fn bounding_box(&self) -> Rectangle {
        self.band.bounding_box()
    }
}

impl DrawTarget for Failing<'_, '_> {
    type Color = Gray8;
    type Error = &'static str;

    fn draw_iter<I: IntoIterator<Item = Pixel<Gray8>>>(&mut self, _: I) -> Result<(), Self::Error> {
        Err("not asked for")
    }

    fn fill_solid(&mut self, area: &Rectangle, color: Gray8) -> Result<(), Self::Error> {
        match &mut self.spans_left {
            Some(0) => {
                self.spans_left = None;
                return Err("lost");
            }
            Some(left) => *left -= 1,
            None => {}
        }
        let Ok(()) = self.band.fill_solid(area, color);
        Ok(())
    }
}

impl GetPixel for Failing<'_, '_> {
    type Color = Gray8;

    fn pixel(&self, point: Point) -> Option<Gray8> {
        self.band.pixel(point)
    }
}

#[test]
fn a_target_that_failed_is_filled_by_the_next_run() {
    let picture = Picture::from_rows(&["....", ".##.", "....", "#..#", "...."]);
    let expected = picture.filled((0, 0), false, |color| color == 0);
    for spans_left in 0..8 {
        let mut words = picture.colors.clone();
        let mut band = Band::<Gray8>::new(picture.area(Point::zero()), &mut words).unwrap();
        let mut fill = SeedFill::<_, 16>::flood(&band, Point::zero(), NEW);
        let mut target = Failing {
            band: &mut band,
            spans_left: Some(spans_left),
        };
        let first = fill.run(&mut Generic(&mut target));
        assert!(first == Ok(()) || first == Err(DrawError::Target("lost")));
        // Six spans in all.
        assert_eq!(first.is_err(), spans_left < 6);
        assert_eq!(fill.run(&mut Generic(&mut target)), Ok(()));
        assert_eq!(words, expected.colors);
    }
}
