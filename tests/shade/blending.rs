//! Blending against exact fractions. In linear light, see `gamma.rs`.

use embedded_graphics::{
    image::GetPixel,
    pixelcolor::{Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666, Rgb888},
    prelude::*,
    primitives::Rectangle,
};
use proptest::prelude::*;
use zrow::{
    band::{Band, BigEndian, LittleEndian, Order, Span},
    shade::{BlendTarget, ChannelColor},
};

use crate::common::channels::Channels;
use crate::common::{cases, config};

const ANYWHERE: Point = Point::new(3, -5);

/// `(alpha * color + (255 - alpha) * below) / 255`, to the nearest; there are no ties, because 255 is odd.
fn mixed(color: u32, below: u32, alpha: u8) -> u32 {
    let sum = color * u32::from(alpha) + below * u32::from(255 - alpha);
    (2 * sum + 255) / 510
}

#[test]
fn every_mix_of_8_bits_is_the_nearest_level() {
    for color in 0..=255 {
        for alpha in 0..=255 {
            let mut words: [u8; 256] = std::array::from_fn(|below| below as u8);
            let row = Rectangle::new(ANYWHERE, Size::new(256, 1));
            let mut band = Band::<Gray8>::new(row, &mut words).unwrap();
            let Ok(()) = band.blend_span(
                Span::new(ANYWHERE.y, ANYWHERE.x, ANYWHERE.x + 256),
                Gray8::new(color),
                alpha,
            );
            for (below, &word) in (0..).zip(&words) {
                assert_eq!(
                    u32::from(word),
                    mixed(color.into(), below, alpha),
                    "{color} over {below} to {alpha}"
                );
            }
        }
    }
}

/// Every level over every level in the widest channel, by every alpha (some of them for 8 bits), with the other channels
/// running against it.
fn every_channel<C: Channels>() {
    let max = C::MAX.into_iter().max().unwrap();
    let step = if max == 255 { 5 } else { 1 };
    let with = |level: u32| {
        let [first, second, third] = C::MAX;
        [level * first / max, level * second / max, third - level * third / max]
    };
    for color in (0..=max).step_by(step) {
        for below in 0..=max {
            for alpha in (0..=255).step_by(step) {
                let [above, under] = [with(color), with((below + color) % (max + 1))];
                let expected: [u32; 3] = std::array::from_fn(|channel| mixed(above[channel], under[channel], alpha));
                let found = C::from_channels(above).over::<10>(C::from_channels(under), alpha, ANYWHERE);
                assert_eq!(found.channels(), expected, "{above:?} over {under:?} to {alpha}");
            }
        }
    }
}

#[test]
fn channels_do_not_touch_each_other() {
    every_channel::<Gray2>();
    every_channel::<Gray4>();
    every_channel::<Gray8>();
    every_channel::<Rgb555>();
    every_channel::<Bgr555>();
    every_channel::<Rgb565>();
    every_channel::<Bgr565>();
    every_channel::<Rgb666>();
    every_channel::<Bgr666>();
    every_channel::<Rgb888>();
    every_channel::<Bgr888>();
}

fn ends_are_exact<C: Channels, const TENTHS: u32>() {
    for number in 0..4096u32 {
        let channel = |index: usize| (number * [7, 11, 13][index] + 5) % (C::MAX[index] + 1);
        let color = C::from_channels(std::array::from_fn(channel));
        let below = C::from_channels(std::array::from_fn(|index| {
            C::MAX[index] - channel((index + 1) % 3) % (C::MAX[index] + 1)
        }));
        assert_eq!(color.over::<TENTHS>(below, 0, ANYWHERE), below);
        assert_eq!(color.over::<TENTHS>(below, 255, ANYWHERE), color);
        let alpha = (number % 256) as u8;
        assert_eq!(color.over::<TENTHS>(color, alpha, ANYWHERE), color);
    }
}

#[test]
fn nothing_everything_and_the_same_colour_are_exact() {
    ends_are_exact::<Gray2, 10>();
    ends_are_exact::<Gray8, 10>();
    ends_are_exact::<Rgb565, 10>();
    ends_are_exact::<Bgr666, 10>();
    ends_are_exact::<Rgb888, 10>();
    ends_are_exact::<Gray2, 22>();
    ends_are_exact::<Gray4, 22>();
    ends_are_exact::<Gray8, 22>();
    ends_are_exact::<Rgb555, 22>();
    ends_are_exact::<Rgb565, 18>();
    ends_are_exact::<Bgr666, 24>();
    ends_are_exact::<Rgb888, 10>();
    ends_are_exact::<Rgb888, 30>();
}

#[test]
fn a_threshold_takes_its_share_of_every_8_by_8_pixels() {
    let on = |alpha: u8, corner: Point| -> Vec<Point> {
        let area = Rectangle::new(corner, Size::new_equal(8));
        area.points()
            .filter(|&position| BinaryColor::On.over::<10>(BinaryColor::Off, alpha, position) == BinaryColor::On)
            .collect()
    };
    let mut previous = Vec::new();
    for alpha in 0..=255u8 {
        let pixels = on(alpha, Point::zero());
        let exact = f64::from(alpha) * 64.0 / 255.0;
        assert!((pixels.len() as f64 - exact).abs() <= 0.5, "{alpha}: {}", pixels.len());
        assert!(previous.iter().all(|position| pixels.contains(position)), "{alpha}");
        previous = pixels;
        for corner in [Point::new(-3, 7), Point::new(i32::MAX - 8, i32::MIN)] {
            assert_eq!(on(alpha, corner).len(), previous.len());
        }
        for position in Rectangle::new(Point::zero(), Size::new_equal(8)).points() {
            let off = BinaryColor::Off.over::<22>(BinaryColor::On, alpha, position);
            assert_eq!(off.is_off(), previous.contains(&position));
        }
    }
    // Half of it is a chessboard.
    assert!(
        on(128, Point::zero())
            .iter()
            .all(|position| (position.x + position.y) % 2 == 0)
    );
}

/// A row of colours after a span was blended over it.
fn blended<O: Order>(row: &[u16], span: Span, color: Rgb565, alpha: u8) -> Vec<Rgb565> {
    let area = Rectangle::new(Point::new(-4, 9), Size::new(row.len() as u32, 1));
    let mut words = vec![0; row.len()];
    let mut band = Band::<Rgb565, O>::new(area, &mut words).unwrap();
    for (word, &value) in band.words_mut().iter_mut().zip(row) {
        *word = O::reorder(value);
    }
    let Ok(()) = band.blend_span(span, color, alpha);
    band.colors().collect()
}

proptest! {
    #![proptest_config(config(cases(500, 500)))]

    #[test]
    fn a_span_is_blended_and_nothing_beside_it(
        row in proptest::collection::vec(any::<u16>(), 1..40), color: u16, alpha: u8, ends: (usize, usize),
    ) {
        let color = Rgb565::from(embedded_graphics::pixelcolor::raw::RawU16::new(color));
        let (one, other) = (ends.0 % (row.len() + 1), ends.1 % (row.len() + 1));
        let inside = one.min(other)..one.max(other);
        let span = Span::new(9, inside.start as i32 - 4, inside.end as i32 - 4);
        let expected: Vec<Rgb565> = row.iter().enumerate().map(|(index, &word)| {
            let below = Rgb565::from(embedded_graphics::pixelcolor::raw::RawU16::new(word));
            let alpha = if inside.contains(&index) { alpha } else { 0 };
            let pairs = color.channels().into_iter().zip(below.channels());
            let channels: Vec<u32> = pairs.map(|(above, under)| mixed(above, under, alpha)).collect();
            Rgb565::from_channels([channels[0], channels[1], channels[2]])
        }).collect();
        prop_assert_eq!(&blended::<LittleEndian>(&row, span, color, alpha), &expected);
        prop_assert_eq!(&blended::<BigEndian>(&row, span, color, alpha), &expected);
    }

    #[test]
    fn a_broken_promise_does_not_panic(y: i32, start: i32, end: i32, alpha: u8) {
        let _ = blended::<LittleEndian>(&[0; 7], Span::new(y, start, end), Rgb565::WHITE, alpha);
    }
}

#[test]
fn what_comes_later_is_on_top() {
    let area = Rectangle::new(Point::zero(), Size::new(2, 1));
    let mut words = [0; 2];
    let mut band = Band::<Gray8>::new(area, &mut words).unwrap();
    for (color, alpha) in [(200, 255), (100, 128), (0, 51)] {
        let Ok(()) = band.blend_span(Span::new(0, 0, 1), Gray8::new(color), alpha);
        let Ok(()) = band
            .in_linear_light::<22>()
            .blend_span(Span::new(0, 1, 2), Gray8::new(color), alpha);
    }
    // 200, then 149.8, then four fifths of it.
    assert_eq!(band.pixel(Point::zero()), Some(Gray8::new(120)));
    let light = |level: f64| level.powf(2.2);
    let second = (light(200.0) * 127.0 / 255.0 + light(100.0) * 128.0 / 255.0)
        .powf(1.0 / 2.2)
        .round();
    let third = (light(second) * 0.8).powf(1.0 / 2.2).round();
    assert_eq!(band.pixel(Point::new(1, 0)), Some(Gray8::new(third as u8)));
}
