//! Filtered lines whose ends lie under one cone, and lines and their mirror images.

use std::collections::HashMap;

use embedded_graphics::{pixelcolor::Gray8, prelude::*, primitives::Rectangle};
use proptest::prelude::*;
use zrow::{
    band::Band,
    draw::FilteredLine,
    geometry::{Sub8, SubPoint, Window},
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

/// The coverage of all pixels of a window that have any.
fn coverages(start: Units, end: Units, window: &Window) -> HashMap<(i32, i32), u8> {
    let segment = FilteredLine::new(sub_point(start), sub_point(end)).unwrap();
    let mut coverages = HashMap::new();
    let Ok(()) = segment.cover(window, |span, coverage| {
        assert_eq!(span.end, span.start + 1);
        assert_eq!(coverages.insert((span.start, span.y), coverage), None);
        Ok::<(), core::convert::Infallible>(())
    });
    coverages
}

/// A generator of numbers that are as good as random, and every time the same (Knuth's constants).
struct Numbers(u64);

impl Numbers {
    fn next(&mut self, count: u32) -> u32 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (((self.0 >> 33) * u64::from(count)) >> 31) as u32
    }
}

/// The pixel of a line that is furthest from the filtered ideal, for no, one and both ends under the cone.
#[derive(Debug, Default, Clone, Copy)]
struct Worst([(f64, Units, Units); 3]);

impl Worst {
    /// Measures all pixels near a short line.
    fn measure(&mut self, start: Units, end: Units) {
        let ideal = Ideal::new(start, end);
        let found = coverages(start, end, &EVERYWHERE);
        let mut seen = 0;
        for y in (start.1.min(end.1) >> 8) - 2..(start.1.max(end.1) >> 8) + 4 {
            for x in (start.0.min(end.0) >> 8) - 2..(start.0.max(end.0) >> 8) + 4 {
                let coverage = found.get(&(x, y)).copied().unwrap_or(0);
                seen += usize::from(coverage > 0);
                let error = (f64::from(coverage) - ideal.volume((x, y)) * 255.0).abs();
                let worst = &mut self.0[ideal.ends_near((x, y))];
                if error > worst.0 {
                    *worst = (error, start, end);
                }
            }
        }
        assert_eq!(found.len(), seen, "nothing beyond the cone's reach");
    }

    fn check(&self) {
        let within = self.0.iter().zip(BOUNDS).all(|(worst, bound)| worst.0 < bound);
        assert!(within, "{self:?}");
    }
}

/// The line of the length given, in 1/256 pixel, at an angle in 1/4096 of a turn, with its middle near to a position.
fn turned(middle: Units, length: u32, angle: u32) -> (Units, Units) {
    let (sine, cosine) = (f64::from(angle) * std::f64::consts::TAU / 4096.0).sin_cos();
    let half = |part: f64| (f64::from(length) / 2.0 * part).round() as i32;
    let (dx, dy) = (half(cosine), half(sine));
    let odd = i32::from(length % 2 == 1);
    ((middle.0 - dx, middle.1 - dy), (middle.0 + dx + odd, middle.1 + dy))
}

#[test]
fn a_line_as_long_as_a_pixel_is_not_too_bright() {
    let found = coverages((-115, 0), (115, 0), &EVERYWHERE);
    // 139.25 is exact.
    assert!((139..=140).contains(&found[&(0, 0)]), "{}", found[&(0, 0)]);
}

#[test]
fn every_length_is_within_the_bound_at_any_angle_and_position() {
    let mut numbers = Numbers(1);
    let mut worst = Worst::default();
    for length in 1..=3 * 256 {
        for sample in 0..60 {
            let position = |numbers: &mut Numbers| numbers.next(256) as i32 - 128;
            let middle = (position(&mut numbers), position(&mut numbers));
            // Level, upright and diagonal lines, and any others; through the centre of a pixel, and anywhere.
            let (middle, angle) = match sample {
                0..4 => ((0, 0), sample * 512),
                4..8 => (middle, sample * 512),
                8..16 => ((0, 0), numbers.next(4096)),
                _ => (middle, numbers.next(4096)),
            };
            let (start, end) = turned(middle, length, angle);
            if start != end {
                worst.measure(start, end);
            }
        }
    }
    worst.check();
}

/// All lines within a square of half a pixel about a pixel's centre, at every 1/16 pixel.
#[test]
fn the_shortest_lines_are_within_the_bound() {
    let mut worst = Worst::default();
    for index in 0..8i32.pow(4) {
        let [x0, y0, x1, y1] = [0, 3, 6, 9].map(|shift| (index >> shift & 7) * 16 - 48);
        if (x0, y0) < (x1, y1) {
            worst.measure((x0, y0), (x1, y1));
        }
    }
    worst.check();
}

/// Changes of the plane that keep the grid of pixels: where a point goes.
const SYMMETRIES: [fn(Units) -> Units; 7] = [
    |(x, y)| (-x, y),
    |(x, y)| (x, -y),
    |(x, y)| (-x, -y),
    |(x, y)| (y, x),
    |(x, y)| (-y, x),
    |(x, y)| (y, -x),
    |(x, y)| (-y, -x),
];

/// Ends anywhere in the domain, at its boundary, and near to each other.
fn ends() -> impl Strategy<Value = (Units, Units)> {
    let most = 8191 * 256;
    let far = move || prop_oneof![4 => -most..=most, 1 => Just(most), 1 => Just(-most), 2 => -700..700i32];
    let near = || prop_oneof![3 => -700..700i32, 1 => (-2..3i32).prop_map(|pixel| pixel * 256)];
    // Lines at 45 degrees, level and upright ones have symmetries of their own.
    let straight = (near(), near(), -900..900i32, 0..4u8).prop_map(|(x, y, run, kind)| {
        let end = match kind {
            0 => (x + run, y),
            1 => (x, y + run),
            2 => (x + run, y + run),
            _ => (x + run, y - run),
        };
        ((x, y), end)
    });
    prop_oneof![
        2 => ((far(), far()), (far(), far())),
        3 => ((near(), near()), (near(), near())),
        2 => straight,
    ]
}

proptest! {
    #![proptest_config(config(cases(1_500, 20_000)))]

    /// A line that is mirrored, turned by a quarter, shifted by whole pixels or drawn from its other end has the
    /// same coverage in the pixels that correspond.
    #[test]
    fn mirrored_and_shifted_lines_have_the_same_coverage(
        ends in ends(), shift in (-8000..8000i32, -8000..8000i32), part in 0..=4i32, radius in 1..9i32,
    ) {
        let (start, end) = ends;
        let between = |from: i32, to: i32| (i64::from(from) + (i64::from(to) - i64::from(from)) * i64::from(part) / 4) as i32;
        let centre = (between(start.0, end.0) >> 8, between(start.1, end.1) >> 8);
        let around = |(x, y): (i32, i32)| Window {
            left: x - radius, top: y - radius, right: x + radius + 1, bottom: y + radius + 1,
        };
        let original = coverages(start, end, &around(centre));
        prop_assert_eq!(&coverages(end, start, &around(centre)), &original);
        for change in SYMMETRIES {
            let expected: HashMap<_, _> = original.iter().map(|(&pixel, &coverage)| (change(pixel), coverage)).collect();
            let found = coverages(change(start), change(end), &around(change(centre)));
            prop_assert_eq!(&found, &expected);
            let reversed = coverages(change(end), change(start), &around(change(centre)));
            prop_assert_eq!(&reversed, &expected);
        }
        // As far as the domain goes.
        let most = 8191 * 256;
        let room = |from: i32, to: i32, pixels: i32| {
            let (least, greatest) = (from.min(to), from.max(to));
            pixels.clamp((-most - least) / 256, (most - greatest) / 256)
        };
        let (dx, dy) = (room(start.0, end.0, shift.0), room(start.1, end.1, shift.1));
        let shifted = |(x, y): Units| (x + dx * 256, y + dy * 256);
        let expected: HashMap<_, _> = original.iter().map(|(&(x, y), &coverage)| ((x + dx, y + dy), coverage)).collect();
        let found = coverages(shifted(start), shifted(end), &around((centre.0 + dx, centre.1 + dy)));
        prop_assert_eq!(found, expected);
    }
}

#[test]
fn white_on_black_is_symmetric() {
    const SIZE: u32 = 9;
    let mut words = [0; (SIZE * SIZE) as usize];
    let mut band = Band::<Gray8>::new(Rectangle::new(Point::new(-4, -4), Size::new_equal(SIZE)), &mut words).unwrap();
    let line = FilteredLine::new(sub_point((-200, -200)), sub_point((200, 200))).unwrap();
    let Ok(()) = line.draw(&mut band, Gray8::WHITE);
    let at = |x: u32, y: u32| words[(y * SIZE + x) as usize];
    for y in 0..SIZE {
        for x in 0..SIZE {
            assert_eq!(at(x, y), at(y, x));
            assert_eq!(at(x, y), at(SIZE - 1 - y, SIZE - 1 - x));
        }
    }
    assert!(at(4, 4) > 180 && at(4, 5) > 60);
}
