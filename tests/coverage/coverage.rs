//! The methods of antialiasing against the exact area of polygon and pixel.

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use fixed::types::{U0F16, U24F8};
use proptest::prelude::*;
use zrow::{
    band::Band,
    coverage::{AnyCoverage, CoverageMethod, InsideArea, SignedArea},
    draw::{AntialiasedPolygon, FillRule, SubArc, SubEllipse, SubLine, SubOutline},
    geometry::{Sub8, SubPoint, TooSmall, Window},
};

use crate::{
    common::{cases, config},
    measured::{SIZE, coverages, errors, furthest, prepare, sub_contours, window},
    reference::exact_area::{Contour, exact},
    shape_classes::{Numbers, SHAPES, classes, line, regular},
};

/// Nested and doubled contours: signed areas add up, the inside does not.
#[test]
fn windings_beyond_one_are_inside_once() {
    let square = |from: i32, to: i32| vec![(from, from), (to, from), (to, to), (from, to)];
    let doubled = [square(300, 2000), square(340, 1900)];
    for rule in [FillRule::EvenOdd, FillRule::NonZero] {
        let window = window(0, SIZE);
        let (rms, largest, _) = errors(
            &coverages(&InsideArea, &doubled, rule, &window),
            &exact(&doubled, rule, &window),
        );
        assert!(rms < 0.4 && largest < 0.51, "{rms} {largest}");
        // Signed areas fold by the rule where no pixel has sides of both.
        let nested = [square(300, 2000), square(700, 1500)];
        let (rms, largest, _) = errors(
            &coverages(&SignedArea, &nested, rule, &window),
            &exact(&nested, rule, &window),
        );
        assert!(rms < 0.4 && largest < 0.51, "{rms} {largest}");
    }
    let fan: Vec<Contour> = (0..64)
        .map(|turn| regular((20.0, 20.0), 15.0, 5, 1, f64::from(turn) * 0.01))
        .collect();
    let window = window(0, SIZE);
    let (rms, largest, _) = errors(
        &coverages(&InsideArea, &fan, FillRule::NonZero, &window),
        &exact(&fan, FillRule::NonZero, &window),
    );
    assert!(rms < 0.4 && largest < 1.0, "{rms} {largest}");
}

fn each_method(mut check: impl FnMut(&str, &dyn Fn(&[Contour], FillRule, &Window) -> Vec<u8>)) {
    macro_rules! check_each {
        ($([$name:ident] [$($method:tt)+])+) => { $(
            check(stringify!($name), &|contours, rule, window| {
                coverages(&<$($method)+>::default(), contours, rule, window)
            });
        )+ };
    }
    zrow_methods::coverage_methods!(check_each);
}

/// Two polygons on either side of an edge cover the pixels along it as the whole does, but for rounding.
#[test]
fn two_sides_of_an_edge_add_up() {
    let mut numbers = Numbers(7);
    for _ in 0..200 {
        let (top, bottom) = (numbers.next(40 * 256) + 256, numbers.next(40 * 256) + 256);
        let left = vec![(-200, -200), (top, -200), (bottom, 12_000), (-200, 12_000)];
        let right = vec![(top, -200), (12_500, -200), (12_500, 12_000), (bottom, 12_000)];
        each_method(|name, coverages| {
            let window = window(0, 44);
            let window = Window { bottom: 44, ..window };
            let left = coverages(std::slice::from_ref(&left), FillRule::NonZero, &window);
            let right = coverages(std::slice::from_ref(&right), FillRule::NonZero, &window);
            for (left, right) in left.iter().zip(&right) {
                let sum = i32::from(*left) + i32::from(*right);
                assert!((254..=256).contains(&sum), "{name}: {left} + {right}");
            }
        });
    }
}

/// Further to the right by 1/256 pixel never takes from the pixels at the right side nor gives to those at the left.
#[test]
fn moving_a_shape_is_monotone() {
    each_method(|name, coverages| {
        let mut before: Option<Vec<u8>> = None;
        for shift in 0..=256 {
            let slanted = vec![
                (1000 + shift, 300),
                (3000 + shift, 300),
                (3100 + shift, 2900),
                (1100 + shift, 2900),
            ];
            let now = coverages(&[slanted], FillRule::NonZero, &window(0, 8));
            // Columns 0 to 7 lie along the left side.
            if let Some(before) = before {
                assert!(
                    before.iter().zip(&now).all(|(before, now)| now <= before),
                    "{name} at {shift}"
                );
            }
            before = Some(now);
        }
    });
}

/// An edge that is cut in two at a point of 1/256 pixel on it is the same edge.
#[test]
fn a_corner_on_an_edge_changes_nothing() {
    let whole = vec![(100, 100), (100 + 7 * 1280, 100 + 5 * 1280), (300, 9000)];
    let cut = vec![
        (100, 100),
        (100 + 7 * 512, 100 + 5 * 512),
        (100 + 7 * 1280, 100 + 5 * 1280),
        (300, 9000),
    ];
    each_method(|name, coverages| {
        let window = window(0, SIZE);
        let difference = coverages(std::slice::from_ref(&whole), FillRule::NonZero, &window)
            .into_iter()
            .zip(coverages(std::slice::from_ref(&cut), FillRule::NonZero, &window))
            .map(|(whole, cut)| whole.abs_diff(cut))
            .max();
        assert_eq!(difference, Some(0), "{name}");
    });
}

#[test]
fn a_hairline_keeps_its_area() {
    let mut numbers = Numbers(99);
    for _ in 0..100 {
        let hairline = [line(&mut numbers, 0.15, None)];
        let window = window(0, SIZE);
        let area: f64 = exact(&hairline, FillRule::NonZero, &window).iter().sum();
        for coverages in [
            coverages(&SignedArea, &hairline, FillRule::NonZero, &window),
            coverages(&InsideArea, &hairline, FillRule::NonZero, &window),
        ] {
            let pixels = coverages.iter().filter(|coverage| **coverage > 0).count() as f64;
            let covered: f64 = coverages.iter().map(|coverage| f64::from(*coverage) / 255.0).sum();
            // Each pixel is rounded by half of 1/255 at most, and those that got nothing by as much.
            assert!((covered - area).abs() <= (pixels + 100.0) / 510.0, "{covered} {area}");
        }
    }
}

/// The coverage of one pixel, drawn through a window.
fn coverage_at<T: CoverageMethod>(
    method: &T,
    contours: &[Contour],
    rule: FillRule,
    window: &Window,
    [x, y]: [i32; 2],
) -> u8 {
    let index = (y - window.top) * (window.right - window.left) + x - window.left;
    coverages(method, contours, rule, window)[index as usize]
}

/// Edges that leave a window within a row of pixels: a pixel inside has the coverage that it has in every other window.
#[test]
fn a_pixel_is_covered_alike_whatever_the_sides_of_the_window() {
    let window = |left: i32, right: i32, top: i32, bottom: i32| Window {
        left,
        top,
        right,
        bottom,
    };
    let nearly_level = [vec![(328, 14), (-4, 88), (1864, 90)]];
    let large = [vec![(-19_507, 1204), (104_479, 42_871), (153_490, 8567)]];
    // The exact values are 40.504 and 119.5.
    for right in 5..12 {
        let window = window(0, right, 0, 1);
        assert_eq!(
            coverage_at(&SignedArea, &nearly_level, FillRule::NonZero, &window, [4, 0]),
            41,
            "{right}"
        );
        assert_eq!(
            coverage_at(&InsideArea, &nearly_level, FillRule::NonZero, &window, [4, 0]),
            41,
            "{right}"
        );
    }
    for left in [-500, -80, -40, -3, 0, 1, 2] {
        let window = window(left, 9, 8, 9);
        let found = coverage_at(&SignedArea, &large, FillRule::NonZero, &window, [2, 8]);
        assert_eq!(
            found,
            coverage_at(&InsideArea, &large, FillRule::NonZero, &window, [2, 8]),
            "{left}"
        );
        assert_eq!(found, 120, "{left}");
    }
}

/// A band that holds all rows of a shape and one that holds few: many edges in few rows are summed up in another way.
#[test]
fn a_pixel_is_covered_alike_whatever_the_height_of_the_band() {
    let triangle = [vec![(705, 101), (310, 1396), (1367, 512)]];
    for (top, bottom) in [(0, 8), (0, 5), (3, 5), (4, 5), (4, 8)] {
        let window = Window {
            left: 0,
            top,
            right: 4,
            bottom,
        };
        let found = coverage_at(&SignedArea, &triangle, FillRule::NonZero, &window, [3, 4]);
        // Exactly 116.504.
        assert_eq!(found, 117, "rows {top} to {bottom}");
    }
}

/// Corners in a box: any, far outside of every window, and such that many edges are nearly level, cross in the same row of
/// pixels, or meet.
fn outline_near() -> impl Strategy<Value = Vec<Contour>> {
    let corners = |width: i32, height: i32, count: usize| {
        let corner = (-width / 4..width, -height / 4..height);
        prop::collection::vec(prop::collection::vec(corner, 3..count), 1..3)
    };
    prop_oneof![
        corners(4_000, 3_000, 10),
        corners(160_000, 50_000, 6),
        corners(2_096_000, 2_096_000, 6),
        corners(6_000, 600, 16),
        corners(9_000, 40, 24),
        corners(700, 700, 24),
    ]
}

proptest! {
    #![proptest_config(config(cases(150, 1_500)))]

    /// The coverage of a pixel is a function of the outline and the pixel: any part of a window, whatever its sides and its
    /// height, has the values that the window around it has.
    #[test]
    fn coverage_is_a_function_of_the_outline_and_the_pixel(
        contours in outline_near(), even_odd: bool,
        start in (-6..12i32, -4..8i32), size in (1..14i32, 1..9i32), margins in [0..60i32, 0..9i32, 0..60i32, 0..9i32],
    ) {
        let rule = if even_odd { FillRule::EvenOdd } else { FillRule::NonZero };
        let (left, top) = start;
        let part = Window { left, top, right: left + size.0, bottom: top + size.1 };
        let [before, above, behind, below] = margins;
        let whole = Window { left: left - before, top: top - above, right: part.right + behind, bottom: part.bottom + below };
        let mut differing = None;
        each_method(|name, coverages| {
            let found = coverages(&contours, rule, &part);
            let around = coverages(&contours, rule, &whole);
            for (index, coverage) in (0i32..).zip(found) {
                let (x, y) = (left + index % size.0, top + index / size.0);
                let expected = around[((y - whole.top) * (whole.right - whole.left) + x - whole.left) as usize];
                if coverage != expected {
                    differing = Some(format!("{name}: ({x}, {y}) is {coverage}, and {expected} in {whole:?}"));
                }
            }
        });
        prop_assert_eq!(differing, None);
    }
}

/// Windows, bands and rows: what is covered does not depend on where the drawing stops.
#[test]
fn windows_cut_without_changing_a_coverage() {
    let mut numbers = Numbers(1234);
    for _ in 0..60 {
        let mut corner = || (numbers.next(120 * 256) - 36 * 256, numbers.next(120 * 256) - 36 * 256);
        let contours = [(0..5).map(|_| corner()).collect::<Contour>()];
        each_method(|name, coverages| {
            for rule in [FillRule::EvenOdd, FillRule::NonZero] {
                let whole = coverages(&contours, rule, &window(-40, 90));
                let part = Window {
                    left: 5,
                    top: 9,
                    right: 30,
                    bottom: 21,
                };
                let cut = coverages(&contours, rule, &part);
                for (index, coverage) in cut.iter().enumerate() {
                    let (x, y) = (5 + index % 25, 9 + index / 25);
                    let expected = whole[y * 130 + x + 40];
                    assert_eq!(*coverage, expected, "{name} {rule:?} {x} {y}");
                }
                for y in 9..21 {
                    let row = Window {
                        top: y,
                        bottom: y + 1,
                        ..part
                    };
                    let one = coverages(&contours, rule, &row);
                    assert_eq!(one, cut[(y as usize - 9) * 25..][..25], "{name} row {y}");
                }
            }
        });
    }
}

proptest! {
    #![proptest_config(config(cases(30, 300)))]

    /// The ends of the domain, and everything between: no panic, no overflow, coverage where it is due.
    #[test]
    fn any_polygon_of_the_domain_is_covered(
        contour in prop::collection::vec((-2_096_896..=2_096_896, -2_096_896..=2_096_896), 3..9),
        near in prop::collection::vec((-3000..9000, -3000..9000), 3..9),
        even_odd: bool,
    ) {
        let rule = if even_odd { FillRule::EvenOdd } else { FillRule::NonZero };
        let window = window(0, SIZE);
        each_method(|_, coverages| {
            coverages(std::slice::from_ref(&contour), rule, &window);
        });
        // Nothing crosses in a triangle, however long: the only error is that of rounding to 1/255.
        let triangle = [vec![contour[0], contour[1], near[0]]];
        let areas = exact(&triangle, rule, &window);
        for found in [coverages(&SignedArea, &triangle, rule, &window), coverages(&InsideArea, &triangle, rule, &window)] {
            let (error, pixel) = furthest(&found, &areas);
            prop_assert!(error <= 0.6, "{} in pixel {}", error, pixel);
        }
        let contours = [near];
        let areas = exact(&contours, rule, &window);
        let found = coverages(&InsideArea, &contours, rule, &window);
        let (error, pixel) = furthest(&found, &areas);
        prop_assert!(error < 4.0, "{} in pixel {}", error, pixel);
    }
}

/// The policy's method is never further from the exact area than the exact signed area is.
#[test]
fn the_policy_is_never_less_accurate_than_signed_area() {
    let window = window(0, SIZE);
    for (name, shapes) in classes() {
        let (mut simple, mut other) = (0, 0);
        for contours in &shapes {
            let areas = exact(contours, FillRule::NonZero, &window);
            let outline = sub_contours(contours);
            let slices: Vec<&[SubPoint<Sub8>]> = outline.iter().map(Vec::as_slice).collect();
            let method = prepare(contours, FillRule::NonZero).exact_method(slices.as_slice());
            simple += usize::from(method == AnyCoverage::SignedArea);
            other += usize::from(method == AnyCoverage::InsideArea);
            let (rms, ..) = errors(&coverages(&method, contours, FillRule::NonZero, &window), &areas);
            let (signed, ..) = errors(&coverages(&SignedArea, contours, FillRule::NonZero, &window), &areas);
            // As accurate, but for a different rounding where a row is cut at a corner.
            assert!(rms <= signed + 0.003, "{name}: {rms} {signed}");
        }
        println!("{name}: {simple} simple, {other} others");
        match name {
            "star" => assert_eq!(other, SHAPES),
            "ring" => assert_eq!(other, SHAPES),
            _ => assert!(simple >= 95, "{name}: {simple} simple, {other} others"),
        }
    }
}

#[test]
fn the_policy_sees_what_a_shape_is() {
    let method_of = |contour: &[(i32, i32)]| {
        let contours = [contour.to_vec()];
        let outline = sub_contours(&contours);
        prepare(&contours, FillRule::NonZero).exact_method(&[outline[0].as_slice()])
    };
    let rectangle = [(128, -128), (1408, -128), (1408, 640), (128, 640)];
    assert_eq!(method_of(&rectangle), AnyCoverage::CentreSample);
    assert_eq!(method_of(&rectangle.map(|(x, y)| (x + 1, y))), AnyCoverage::SignedArea);
    // A bow tie, one that meets itself in a corner, and one whose only crossing is with a level edge.
    assert_eq!(
        method_of(&[(0, 0), (2000, 0), (0, 2000), (2000, 2000)]),
        AnyCoverage::InsideArea
    );
    assert_eq!(
        method_of(&[(0, 0), (1000, 1000), (2000, 0), (2000, 2000), (1000, 1000), (0, 2000)]),
        AnyCoverage::InsideArea
    );
    assert_eq!(
        method_of(&[(0, 0), (2000, 0), (1000, -900), (1100, 900)]),
        AnyCoverage::InsideArea
    );
    // Two squares that meet in a corner, through which two level and two upright edges go.
    let squares = [
        (0, 0),
        (1000, 0),
        (1000, 1000),
        (2000, 1000),
        (2000, 2000),
        (1000, 2000),
        (1000, 1000),
        (0, 1000),
    ];
    assert_eq!(method_of(&squares), AnyCoverage::InsideArea);
}

/// Curved shapes and lines as outlines: their area, whatever they are made of.
#[test]
fn outlines_have_their_areas() {
    let window = Window {
        left: -2,
        top: -2,
        right: 130,
        bottom: 130,
    };
    let pixels = |outline: &dyn SubOutline| {
        let polygon = AntialiasedPolygon::<512, 512>::prepare(outline, FillRule::NonZero).unwrap();
        let mut memory = [0; 200];
        let (mut sum, mut edge_pixels) = (0.0, 0.0);
        polygon
            .cover(&InsideArea, &window, &mut memory, |span, coverage| {
                sum += f64::from(span.end - span.start) * f64::from(coverage) / 255.0;
                edge_pixels += f64::from(span.end - span.start) * f64::from(u8::from(coverage < 255));
                Ok::<_, TooSmall>(())
            })
            .unwrap();
        (sum, edge_pixels)
    };
    let point = |x: f64, y: f64| SubPoint::from_units((x * 256.0) as i32, (y * 256.0) as i32).unwrap();
    let length = |pixels: f64| U24F8::from_num(pixels);
    let pi = std::f64::consts::PI;
    for radius in [0.75, 3.0, 17.25, 60.0] {
        let circle = SubEllipse::circle(point(63.3, 64.6), length(radius)).unwrap();
        let ring = SubArc::new(
            point(63.3, 64.6),
            [length(radius / 2.0), length(radius)],
            U0F16::from_bits(999),
            U0F16::from_bits(40_000),
        )
        .unwrap();
        // Chords are up to 1/64 pixel inside, and coverage and corners are rounded.
        let bound = |length: f64, edge_pixels: f64| length / 64.0 + edge_pixels / 255.0 + 0.05;
        let (area, edge_pixels) = pixels(&circle);
        let expected = pi * radius * radius;
        assert!(
            (area - expected).abs() <= bound(2.0 * pi * radius, edge_pixels),
            "circle {radius}: {area} {expected}"
        );
        let (area, edge_pixels) = pixels(&ring);
        let expected = expected * 0.75 * 40_000.0 / 65_536.0;
        assert!(
            (area - expected).abs() <= bound(4.0 * pi * radius, edge_pixels),
            "arc {radius}: {area} {expected}"
        );
    }
    for (end, width) in [
        ((100.5, 20.25), 0.15),
        ((11.0, 90.0), 1.0),
        ((90.0, 11.1), 2.5),
        ((40.0, 11.0), 8.0),
    ] {
        let line = SubLine::new(point(10.0, 10.5), point(end.0, end.1), length(width)).unwrap();
        let (area, edge_pixels) = pixels(&line);
        let expected = f64::hypot(end.0 - 10.0, end.1 - 10.5) * (width * 256.0f64).floor() / 256.0;
        assert!(
            (area - expected).abs() <= edge_pixels / 255.0 + 0.5,
            "line {end:?}: {area} {expected}"
        );
    }
    assert!(SubEllipse::circle(point(8000.0, 0.0), length(200.0)).is_err());
    assert!(SubLine::new(point(0.0, 8191.0), point(0.0, 0.0), length(4.0)).is_err());
}

/// Drawn band after band or all at once: the same picture, over what is there.
#[test]
fn bands_give_the_whole_picture() {
    let area = Rectangle::new(Point::zero(), Size::new(48, 48));
    let star = regular((24.0, 24.0), 22.0, 7, 3, 0.3);
    let polygon = prepare(&[star], FillRule::NonZero);
    fn draw<T: CoverageMethod>(
        method: &T,
        polygon: &AntialiasedPolygon<512, 512>,
        area: Rectangle,
        rows: u32,
    ) -> Vec<u16> {
        let mut picture = Vec::new();
        let mut memory = vec![T::Cell::default(); T::cells(48)];
        for top in (0..48).step_by(rows as usize) {
            let part = Rectangle::new(Point::new(0, top), Size::new(48, rows)).intersection(&area);
            let mut words = vec![Rgb565::BLUE.into_storage(); 48 * part.size.height as usize];
            let mut band = Band::<Rgb565>::new(part, &mut words).unwrap();
            polygon.draw(method, Rgb565::YELLOW, &mut band, &mut memory).unwrap();
            picture.extend(words);
        }
        picture
    }
    macro_rules! check_each {
        ($([$name:ident] [$($method:tt)+])+) => { $(
            let method = <$($method)+>::default();
            let whole = draw(&method, &polygon, area, 48);
            for rows in [1, 2, 7, 16] {
                assert_eq!(draw(&method, &polygon, area, rows), whole, stringify!($name));
            }
        )+ };
    }
    zrow_methods::coverage_methods!(check_each);
}

#[test]
fn too_little_row_memory_is_said_before_anything_is_drawn() {
    let square = vec![(0, 0), (5000, 0), (5000, 5000), (0, 5000)];
    let mut memory = [0i32; 48];
    let drawn = prepare(&[square], FillRule::NonZero).cover(&SignedArea, &window(0, SIZE), &mut memory, |_, _| {
        panic!("a span");
    });
    assert_eq!(drawn, Err(TooSmall::Cells(49)));
}

#[test]
fn an_error_leaves_the_row_memory_empty() {
    #[derive(Debug, PartialEq)]
    enum Stop {
        TooSmall(TooSmall),
        Here,
    }
    impl From<TooSmall> for Stop {
        fn from(error: TooSmall) -> Self {
            Self::TooSmall(error)
        }
    }
    fn check<T: CoverageMethod<Cell: PartialEq>>(name: &str, method: &T) {
        let star = regular((24.0, 24.0), 22.0, 7, 3, 0.3);
        let polygon = prepare(&[star], FillRule::EvenOdd);
        let mut memory = vec![T::Cell::default(); T::cells(48)];
        let mut count = 0;
        let drawn = polygon.cover(method, &window(0, SIZE), &mut memory, |_, _| {
            count += 1;
            Ok::<_, TooSmall>(())
        });
        assert_eq!(drawn, Ok(()));
        for stop_after in 0..count.min(150) {
            let mut spans = 0;
            let drawn = polygon.cover(method, &window(0, SIZE), &mut memory, |_, _| {
                spans += 1;
                if spans > stop_after { Err(Stop::Here) } else { Ok(()) }
            });
            assert_eq!(drawn, Err(Stop::Here));
            assert!(
                memory.iter().all(|cell| *cell == T::Cell::default()),
                "{name} after {stop_after}"
            );
        }
    }
    macro_rules! check_each {
        ($([$name:ident] [$($method:tt)+])+) => {
            $(check(stringify!($name), &<$($method)+>::default());)+
        };
    }
    zrow_methods::coverage_methods!(check_each);
}
