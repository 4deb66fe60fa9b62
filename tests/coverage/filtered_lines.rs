//! Gupta-Sproull lines against the cone's volume over the line, in closed form.

use std::collections::HashMap;

use embedded_graphics::{
    pixelcolor::{Gray8, Rgb565},
    prelude::*,
    primitives::Rectangle,
};
use proptest::prelude::*;
use zrow::{
    band::Band,
    draw::FilteredLine,
    geometry::{InputError, Sub8, SubPoint, Window},
};

use crate::common::{cases, config};
use crate::reference::cone_volume::{BOUNDS, Ideal, Units};

const EVERYWHERE: Window = Window {
    left: i32::MIN,
    top: i32::MIN,
    right: i32::MAX,
    bottom: i32::MAX,
};

fn sub_point((x, y): Units) -> SubPoint<Sub8> {
    SubPoint::from_units(x, y).unwrap()
}

fn segment(start: Units, end: Units) -> FilteredLine {
    FilteredLine::new(sub_point(start), sub_point(end)).unwrap()
}

/// The coverage of all pixels in a window; each at most once.
fn coverages(segment: &FilteredLine, window: &Window) -> HashMap<(i32, i32), u8> {
    let mut coverages = HashMap::new();
    let Ok(()) = segment.cover(window, |span, coverage| {
        assert_eq!(span.end, span.start + 1);
        assert!(coverage > 0 && window.contains(Point::new(span.start, span.y)));
        assert_eq!(coverages.insert((span.start, span.y), coverage), None);
        Ok::<(), core::convert::Infallible>(())
    });
    coverages
}

/// Ends within some pixels, some of them at pixel centres and on straight lines.
fn near() -> impl Strategy<Value = Units> {
    let coordinate = || prop_oneof![3 => -2000..2000i32, 1 => (-7..7i32).prop_map(|pixel| pixel * 256)];
    (coordinate(), coordinate())
}

fn anywhere() -> impl Strategy<Value = Units> {
    let most = 8191 * 256;
    let coordinate = move || prop_oneof![-most..=most, Just(most), Just(-most), -2000..2000i32];
    (coordinate(), coordinate())
}

/// Largest distance of any pixel's coverage from the ideal in 1/255: where the cone reaches no end, one end, or both.
fn largest_errors(start: Units, end: Units, window: &Window) -> [f64; 3] {
    let ideal = Ideal::new(start, end);
    let found = coverages(&segment(start, end), window);
    let mut largest = [0f64; 3];
    for y in window.top..window.bottom {
        for x in window.left..window.right {
            let coverage = found.get(&(x, y)).copied().unwrap_or(0);
            let error = (f64::from(coverage) - ideal.volume((x, y)) * 255.0).abs();
            let ends = ideal.ends_near((x, y));
            largest[ends] = largest[ends].max(error);
        }
    }
    largest
}

fn within_bounds(largest: [f64; 3]) -> bool {
    largest.iter().zip(BOUNDS).all(|(&error, bound)| error < bound)
}

fn around(centre: (i32, i32), radius: i32) -> Window {
    Window {
        left: centre.0 - radius,
        top: centre.1 - radius,
        right: centre.0 + radius + 1,
        bottom: centre.1 + radius + 1,
    }
}

proptest! {
    #![proptest_config(config(cases(150, 150)))]

    #[test]
    fn shares_are_those_of_the_filtered_ideal(start in near(), end in near()) {
        prop_assume!(start != end);
        let largest = largest_errors(start, end, &around((0, 0), 11));
        prop_assert!(within_bounds(largest), "{largest:?}");
    }

    #[test]
    fn so_are_those_of_the_longest_lines(start in anywhere(), end in anywhere(), part in 0.0..1.0f64, at: bool) {
        prop_assume!(start != end);
        let part = if at { part.round() } else { part };
        let middle = |from: i32, to: i32| ((f64::from(from) + part * f64::from(to - from)) / 256.0).round() as i32;
        let centre = (middle(start.0, end.0), middle(start.1, end.1));
        let largest = largest_errors(start, end, &around(centre, 6));
        prop_assert!(within_bounds(largest), "{largest:?}");
    }
}

proptest! {
    #![proptest_config(config(cases(600, 600)))]

    #[test]
    fn either_end_may_come_first(start in anywhere(), end in anywhere()) {
        prop_assert_eq!(segment(start, end), segment(end, start));
    }

    #[test]
    fn a_window_shows_its_part_of_the_picture(
        start in near(), end in near(), corner in (-12..12i32, -12..12i32), size in (0..12i32, 0..12i32),
    ) {
        let line = segment(start, end);
        let window = Window { left: corner.0, top: corner.1, right: corner.0 + size.0, bottom: corner.1 + size.1 };
        let mut expected = coverages(&line, &EVERYWHERE);
        let bounds = Window::from(line.bounding_box());
        prop_assert!(expected.keys().all(|&(x, y)| bounds.contains(Point::new(x, y))));
        prop_assert!(start != end || expected.is_empty() && bounds.is_empty());
        expected.retain(|&(x, y), _| window.contains(Point::new(x, y)));
        prop_assert_eq!(coverages(&line, &window), expected);
    }

    #[test]
    fn far_lines_show_their_part_too(start in anywhere(), end in anywhere(), corner in (-20..20i32, -20..20i32)) {
        let line = segment(start, end);
        let whole = Window { left: -20, top: -20, right: 20, bottom: 20 };
        let mut rows = HashMap::new();
        for y in whole.top..whole.bottom {
            rows.extend(coverages(&line, &Window { top: y, bottom: y + 1, ..whole }));
        }
        prop_assert_eq!(&coverages(&line, &whole), &rows);
        let part = Window { left: corner.0, top: corner.1, ..whole };
        rows.retain(|&(x, y), _| part.contains(Point::new(x, y)));
        prop_assert_eq!(coverages(&line, &part), rows);
    }

    /// All but the ends: a column of a line that is rather level holds as much as is visible there, at any slope.
    #[test]
    fn columns_hold_the_visible_area(start in near(), run in 2560..20_000i32, slope in -1.0..=1.0f64) {
        let end = (start.0 + run, start.1 + (slope * f64::from(run)) as i32);
        let (ideal, found) = (Ideal::new(start, end), coverages(&segment(start, end), &EVERYWHERE));
        for x in (start.0 >> 8) + 4..(end.0 >> 8) - 3 {
            let sum: u32 = found.iter().filter(|(pixel, _)| pixel.0 == x).map(|(_, &coverage)| u32::from(coverage)).sum();
            let area = f64::from(sum) / 255.0 * ideal.direction.0;
            // Rounding: up to five pixels by half a level, and the table.
            prop_assert!((area - 1.0).abs() < 0.007 + 3.0 / 255.0, "{area}");
        }
    }

    #[test]
    fn all_shares_sum_to_the_area_of_the_line(start in near(), end in near()) {
        prop_assume!(start != end);
        let (ideal, found) = (Ideal::new(start, end), coverages(&segment(start, end), &EVERYWHERE));
        let area = found.values().map(|&coverage| f64::from(coverage)).sum::<f64>() / 255.0;
        // What the ends and rounding add, beside the 0.7 % of what lies between.
        prop_assert!((area - ideal.length).abs() < 0.05 + 0.01 * ideal.length, "{area} {}", ideal.length);
    }

    #[test]
    fn nothing_overflows(x: [i32; 2], y: [i32; 2], window: [i32; 4]) {
        let point = |index: usize| SubPoint::<Sub8> {
            x: fixed::types::I24F8::from_bits(x[index]),
            y: fixed::types::I24F8::from_bits(y[index]),
        };
        let most = 8191 * 256;
        let inside = x.into_iter().chain(y).all(|units| units.abs_diff(0) <= most);
        prop_assert_eq!(FilteredLine::new(point(0), point(1)).is_ok(), inside);
        let window = Window { left: window[0], top: window[1], right: window[2], bottom: window[3] };
        let _ = coverages(&segment((x[0] % 9999, y[0] % 9999), (x[1] % 9999, y[1] % 9999)), &window);
    }
}

#[test]
fn level_and_upright_lines_are_the_table() {
    // In the middle of a row: 199 there, 28 on both sides; between two rows: 127.5 in both.
    for (offset, expected) in [(0, [28, 199, 28]), (128, [0, 128, 128]), (-128, [128, 128, 0])] {
        let level = coverages(&segment((-2560, offset), (2560, offset)), &EVERYWHERE);
        let upright = coverages(&segment((offset, 2560), (offset, -2560)), &EVERYWHERE);
        for at in -8..=8 {
            for (side, coverage) in (-1..).zip(expected) {
                assert_eq!(level.get(&(at, side)).copied().unwrap_or(0), coverage);
                assert_eq!(upright.get(&(side, at)).copied().unwrap_or(0), coverage);
            }
        }
    }
}

#[test]
fn mirrored_lines_have_mirrored_pictures() {
    let (start, end) = ((-700, -301), (1900, 777));
    let original = coverages(&segment(start, end), &EVERYWHERE);
    let change = |changed: &dyn Fn(Units) -> Units| {
        let found = coverages(&segment(changed(start), changed(end)), &EVERYWHERE);
        assert_eq!(found.len(), original.len());
        for (&pixel, &coverage) in &original {
            assert_eq!(found[&changed(pixel)], coverage);
        }
    };
    change(&|(x, y)| (y, x));
    change(&|(x, y)| (-x, y));
    change(&|(x, y)| (x, -y));
    change(&|(x, y)| (-y, x));
}

#[test]
fn beyond_the_domain_is_an_error() {
    let far = SubPoint::<Sub8> {
        x: fixed::types::I24F8::from_bits(8191 * 256 + 1),
        y: fixed::types::I24F8::ZERO,
    };
    let error = InputError::OutOfDomain { min: -8191, max: 8191 };
    assert_eq!(FilteredLine::new(far, SubPoint::default()), Err(error));
    assert_eq!(FilteredLine::new(SubPoint::default(), far), Err(error));
}

/// A line over what is there, whole and row by row.
#[test]
fn rows_of_a_band_are_those_of_the_whole_picture() {
    let area = Rectangle::new(Point::new(-3, -2), Size::new(40, 30));
    let lines = [
        ((-900, 100), (9000, 5000)),
        ((300, 7000), (5000, -600)),
        ((256, 256), (8000, 300)),
    ];
    let draw = |area: Rectangle, words: &mut [u16]| {
        let mut band = Band::<Rgb565>::new(area, words).unwrap();
        band.fill(Rgb565::CSS_DARK_BLUE);
        for (start, end) in lines {
            let line = FilteredLine::new(sub_point(start), sub_point(end)).unwrap();
            let drawn = line.draw(&mut band, Rgb565::YELLOW);
            assert_eq!(drawn, Ok(()));
        }
    };
    let mut whole = vec![0; 40 * 30];
    draw(area, &mut whole);
    let mut row = vec![0; 40];
    for (y, expected) in (-2..).zip(whole.chunks(40)) {
        draw(Rectangle::new(Point::new(-3, y), Size::new(40, 1)), &mut row);
        assert_eq!(row, expected);
    }
    assert!(whole.iter().collect::<std::collections::HashSet<_>>().len() > 20);
}

#[test]
fn white_on_black_is_the_share() {
    let mut words = [0; 20 * 20];
    let mut band = Band::<Gray8>::new(Rectangle::new(Point::zero(), Size::new_equal(20)), &mut words).unwrap();
    let (start, end) = ((700, 900), (4000, 3111));
    let line = FilteredLine::new(sub_point(start), sub_point(end)).unwrap();
    let Ok(()) = line.draw(&mut band, Gray8::WHITE);
    let found = coverages(&segment(start, end), &EVERYWHERE);
    for (index, &word) in (0..).zip(&words) {
        assert_eq!(word, found.get(&(index % 20, index / 20)).copied().unwrap_or(0));
    }
}
