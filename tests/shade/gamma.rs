//! Mixing light: every level over every level, to every coverage, against powers in floating point.

use embedded_graphics::{
    pixelcolor::{Bgr666, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb888},
    prelude::*,
    primitives::Rectangle,
};
use zrow::{
    band::{Band, Span},
    shade::{BlendTarget, ChannelColor},
};

use crate::common::{by_depth, channels::Channels, is_deep};

const ANYWHERE: Point = Point::new(3, -5);

/// What the documentation guarantees, in levels: rounding, and what the tables add.
const fn bound(tenths: u32) -> f64 {
    if tenths <= 25 { 0.502 } else { 0.53 }
}

/// The exact mixes that a level may stand for, and the light of the levels, in floating point.
struct Exact {
    light: Vec<f64>,
    nearest: Vec<[f64; 2]>,
}

impl Exact {
    fn new(max: u32, gamma: f64, bound: f64) -> Self {
        let light = |level: f64| (level / f64::from(max)).max(0.0).powf(gamma);
        let levels = || (0..=max).map(f64::from);
        Self {
            light: levels().map(light).collect(),
            nearest: levels()
                .map(|level| {
                    let least = if level < bound { -1.0 } else { light(level - bound) };
                    [least, light(level + bound)]
                })
                .collect(),
        }
    }

    /// Whether a level is near enough to the exact mix: in light, so that no root is drawn for each mix.
    fn allows(&self, level: u32, [color, below]: [u32; 2], coverage: u8) -> bool {
        let part = f64::from(coverage) / 255.0;
        let mix = self.light[color as usize] * part + self.light[below as usize] * (1.0 - part);
        let [least, greatest] = self.nearest[level as usize];
        least <= mix && mix <= greatest
    }
}

/// A band of one row that begins anywhere.
fn row<C: Channels>(words: &mut [C::Word]) -> Band<'_, C> {
    let area = Rectangle::new(ANYWHERE, Size::new(words.len() as u32, 1));
    Band::new(area, words).unwrap()
}

/// All pixels of that row.
fn whole(width: usize) -> Span {
    Span::new(ANYWHERE.y, ANYWHERE.x, ANYWHERE.x + width as i32)
}

/// Blends a colour over all words in linear light.
fn in_light<C: Channels, const TENTHS: u32>(words: &mut [C::Word], color: C, coverage: u8) {
    let span = whole(words.len());
    let Ok(()) = row::<C>(words)
        .in_linear_light::<TENTHS>()
        .blend_span(span, color, coverage);
}

/// A colour whose channels go through all levels, each its own way.
fn spread<C: Channels>(level: u32) -> C {
    let mut channel = 0;
    C::from_channels(C::MAX.map(|max| {
        channel += 1;
        if max == 0 {
            0
        } else {
            (level + channel * max / 3) % (max + 1)
        }
    }))
}

/// Every level over every level to every coverage, in all channels at a time; by default to every third one, from 0 to 255.
fn every_mix<C: Channels, const TENTHS: u32>() {
    let gamma = f64::from(TENTHS) / 10.0;
    let exact = C::MAX.map(|max| Exact::new(max, gamma, bound(TENTHS)));
    let levels = C::MAX.into_iter().max().unwrap_or(0);
    let below: Vec<C> = (0..=levels).map(spread).collect();
    let row: Vec<C::Word> = below.iter().map(|color| color.to_word()).collect();
    let mut words = row.clone();
    for color in (0..=levels).map(spread::<C>) {
        for coverage in (0..=255).step_by(by_depth(17, 3, 1)) {
            words.copy_from_slice(&row);
            in_light::<C, TENTHS>(&mut words, color, coverage);
            for (&word, &below) in words.iter().zip(&below) {
                let found = C::from_word(word).channels();
                for (channel, exact) in exact.iter().enumerate().filter(|&(channel, _)| C::MAX[channel] > 0) {
                    let [color, below] = [color, below].map(|color| color.channels()[channel]);
                    let found = found[channel];
                    let is_right = match coverage {
                        0 => found == below,
                        255 => found == color,
                        _ if color == below => found == color,
                        _ => exact.allows(found, [color, below], coverage),
                    };
                    assert!(
                        is_right,
                        "gamma {TENTHS}: {color} over {below} to {coverage} is {found}"
                    );
                }
            }
        }
    }
}

/// Calls `every_mix` for a colour type and each gamma.
macro_rules! every_mix {
    ($color:ty: $($tenths:literal),*) => {
        $(every_mix::<$color, $tenths>();)*
    };
}

#[test]
fn every_mix_of_8_bits_is_within_the_bound() {
    every_mix!(Gray8: 10, 18, 22, 24, 29, 30);
    if is_deep() {
        every_mix!(Gray8: 11, 12, 13, 14, 15, 16, 17, 19, 20, 21, 23, 25, 26, 27, 28);
    }
}

#[test]
fn every_channel_of_8_bits_is() {
    every_mix::<Rgb888, 24>();
}

#[test]
fn every_mix_of_fewer_bits_is() {
    every_mix!(Gray2: 10, 18, 22, 24, 29, 30);
    every_mix!(Gray4: 10, 18, 22, 24, 29, 30);
    every_mix!(Rgb555: 10, 18, 22, 24, 29, 30);
    every_mix!(Rgb565: 10, 18, 22, 24, 29, 30);
    every_mix!(Bgr666: 10, 18, 22, 24, 29, 30);
}

#[test]
fn a_gamma_of_one_mixes_levels() {
    let levels: [u8; 256] = std::array::from_fn(|level| level as u8);
    for color in (0..=255).map(Gray8::new) {
        for coverage in (0..=255).step_by(by_depth(5, 1, 1)) {
            let (mut light, mut encoded) = (levels, levels);
            in_light::<Gray8, 10>(&mut light, color, coverage);
            let Ok(()) = row(&mut encoded).blend_span(whole(256), color, coverage);
            assert_eq!(light, encoded);
        }
    }
}

#[test]
fn the_mix_of_a_dark_and_a_middle_level_is_right() {
    let found = Gray8::new(4).over::<24>(Gray8::new(108), 248, ANYWHERE);
    // 24.275 is exact.
    assert_eq!(found.luma(), 24);
}
