//! `zrow::shade`: blending at every alpha, ramps, and the weights of filters.

use anyhow::ensure;
use arbitrary::Arbitrary;
use embedded_graphics::{
    geometry::{Point, Size},
    pixelcolor::{
        Bgr565, BinaryColor, Gray2, Gray4, Gray8, GrayColor, PixelColor, Rgb555, Rgb565, Rgb666, Rgb888, RgbColor,
        raw::{RawData, RawU1, RawU2, RawU4, RawU8, RawU16, RawU24},
    },
    primitives::Rectangle,
};
use zrow::{
    band::{Band, BigEndian, Order, Span},
    coverage::{Bartlett, BoxFilter, Gaussian},
    shade::{BlendTarget, ChannelColor, ConeFilter, Ramp, SampleFilter},
};

use crate::{
    target::{Case, Verdict},
    values::{Int, Spot, Stage},
};

/// A colour over another one.
#[derive(Debug, Arbitrary)]
pub struct BlendCase {
    stage: Stage,
    colors: [u32; 2],
    alphas: [u8; 2],
    spot: Spot,
    length: u8,
}

/// The levels of a colour's channels, and the largest.
trait Levels {
    fn levels(self) -> Vec<(i32, i32)>;
}

macro_rules! levels {
    ($($color:ident: $($channel:ident $most:ident),+;)+) => {$(
        impl Levels for $color {
            fn levels(self) -> Vec<(i32, i32)> {
                vec![$((self.$channel().into(), $color::$most.into())),+]
            }
        }
    )+};
}
levels! {
    Rgb555: r MAX_R, g MAX_G, b MAX_B;
    Rgb565: r MAX_R, g MAX_G, b MAX_B;
    Bgr565: r MAX_R, g MAX_G, b MAX_B;
    Rgb666: r MAX_R, g MAX_G, b MAX_B;
    Rgb888: r MAX_R, g MAX_G, b MAX_B;
}

macro_rules! grey_levels {
    ($($color:ident: $most:literal;)+) => {$(
        impl Levels for $color {
            fn levels(self) -> Vec<(i32, i32)> {
                vec![(self.luma().into(), $most)]
            }
        }
    )+};
}
grey_levels! {
    Gray2: 3;
    Gray4: 15;
    Gray8: 255;
}

impl BlendCase {
    /// What holds of every colour and transfer function.
    fn check_ends<C, R, const TENTHS: u32>(&self) -> Verdict
    where
        C: ChannelColor + PixelColor<Raw = R> + From<R> + PartialEq + std::fmt::Debug,
        R: RawData + From<C>,
    {
        let [color, below] = self.colors.map(|raw| C::from(R::from_u32(raw)));
        // A band has no pixels beyond the number range.
        let point = self.stage.point(self.spot);
        let point = Point::new(point.x.min(i32::MAX - 64), point.y.min(i32::MAX - 1));
        let [alpha, _] = self.alphas;
        ensure!(
            color.over::<TENTHS>(below, 0, point) == below,
            "alpha 0 of {color:?} over {below:?}"
        );
        ensure!(
            color.over::<TENTHS>(below, 255, point) == color,
            "alpha 255 of {color:?} over {below:?}"
        );
        ensure!(
            color.over::<TENTHS>(color, alpha, point) == color,
            "{color:?} over itself"
        );
        // A run has the same pixels, and leaves the words beside it.
        let (length, guard) = (usize::from(self.length % 40), color.to_word());
        let word = BigEndian::reorder(below.to_word());
        let mut words = vec![guard; length + 4];
        words[2..2 + length].fill(word);
        self.blend_run::<C, TENTHS>(&mut words[2..2 + length], point, color, alpha)?;
        let pixel = |index: usize| {
            let x = point.x.wrapping_add(index as i32);
            BigEndian::reorder(color.over::<TENTHS>(below, alpha, Point::new(x, point.y)).to_word())
        };
        ensure!(
            words[2..2 + length]
                .iter()
                .enumerate()
                .all(|(index, word)| *word == pixel(index)),
            "{length} words at once are other ones than each by itself"
        );
        ensure!(
            words[..2].iter().chain(&words[2 + length..]).all(|word| *word == guard),
            "words beside the run are written"
        );
        Ok(())
    }

    /// Blends a colour over a row of big-endian words.
    fn blend_run<C: ChannelColor, const TENTHS: u32>(
        &self,
        words: &mut [C::Word],
        point: Point,
        color: C,
        alpha: u8,
    ) -> Verdict {
        let area = Rectangle::new(point, Size::new(words.len() as u32, 1));
        let mut band = Band::<C, BigEndian>::new(area, words)?;
        let span = Span::new(point.y, point.x, point.x.saturating_add(area.size.width as i32));
        let Ok(()) = if TENTHS == 10 {
            band.blend_span(span, color, alpha)
        } else {
            band.in_linear_light::<TENTHS>().blend_span(span, color, alpha)
        };
        Ok(())
    }

    /// A span of a band has the pixels that are blended one by one, as they are or in linear light, and no others.
    fn check_band<C: ChannelColor + PartialEq + std::fmt::Debug>(&self, [color, below]: [C; 2]) -> Verdict {
        let [alpha, _] = self.alphas;
        let Point { x, y } = self.stage.point(self.spot);
        // Room for the pixels beside the span.
        let (length, left) = (i32::from(self.length % 40), x.clamp(i32::MIN + 2, i32::MAX - 50));
        let (top, end) = (y.min(i32::MAX - 1), left + length);
        let area = Rectangle::new(Point::new(left - 2, top), Size::new(length as u32 + 4, 1));
        let mut words = vec![below.to_word(); length as usize + 4];
        for in_linear_light in [false, true] {
            let mut band = Band::<C, BigEndian>::new(area, &mut words)?;
            band.fill(below);
            let span = Span::new(top, left, end);
            let Ok(()) = if in_linear_light {
                band.in_linear_light::<22>().blend_span(span, color, alpha)
            } else {
                band.blend_span(span, color, alpha)
            };
            for (column, found) in (left - 2..).zip(band.colors()) {
                let point = Point::new(column, top);
                let expected = match (left <= column && column < end, in_linear_light) {
                    (false, _) => below,
                    (true, false) => color.over::<10>(below, alpha, point),
                    (true, true) => color.over::<22>(below, alpha, point),
                };
                ensure!(
                    found == expected,
                    "{found:?} at {point:?} of {span:?}, by itself {expected:?}; in linear light: {in_linear_light}"
                );
            }
        }
        Ok(())
    }

    /// Channels of a colour over another one: rounded once, and in order as the alpha grows.
    fn check_levels<C, R>(&self) -> Verdict
    where
        C: ChannelColor + PixelColor<Raw = R> + From<R> + PartialEq + std::fmt::Debug + Levels,
        R: RawData + From<C>,
    {
        self.check_ends::<C, R, 10>()?;
        self.check_ends::<C, R, 22>()?;
        self.check_ends::<C, R, 18>()?;
        self.check_ends::<C, R, 24>()?;
        let [color, below] = self.colors.map(|raw| C::from(R::from_u32(raw)));
        self.check_band([color, below])?;
        let point = self.stage.point(self.spot);
        let [one, other] = self.alphas;
        let (less, more) = (one.min(other), one.max(other));
        let encoded = [less, more].map(|alpha| color.over::<10>(below, alpha, point).levels());
        let linear = [less, more].map(|alpha| color.over::<22>(below, alpha, point).levels());
        for (channel, ((to, most), (from, _))) in color.levels().into_iter().zip(below.levels()).enumerate() {
            let exact = i32::from(less) * to + (255 - i32::from(less)) * from;
            let (found, _) = encoded[0][channel];
            ensure!(
                (2 * (255 * found - exact)).abs() <= 255,
                "channel {channel} of {color:?} over {below:?} by {less} is {found}"
            );
            for [less, more] in [&encoded, &linear] {
                let ((less, _), (more, _)) = (less[channel], more[channel]);
                let is_between = |level: i32| (from.min(to)..=from.max(to)).contains(&level) && level <= most;
                ensure!(
                    is_between(less) && is_between(more),
                    "channel {channel}: {less} and {more}"
                );
                let is_ordered = if from <= to { less <= more } else { less >= more };
                ensure!(
                    is_ordered,
                    "channel {channel} goes back from {less} to {more} between {from} and {to}"
                );
            }
        }
        Ok(())
    }
}

impl Case for BlendCase {
    fn check(&self) -> Verdict {
        self.check_levels::<Gray2, RawU2>()?;
        self.check_levels::<Gray4, RawU4>()?;
        self.check_levels::<Gray8, RawU8>()?;
        self.check_levels::<Rgb555, RawU16>()?;
        self.check_levels::<Rgb565, RawU16>()?;
        self.check_levels::<Bgr565, RawU16>()?;
        self.check_levels::<Rgb666, RawU24>()?;
        self.check_levels::<Rgb888, RawU24>()?;
        self.check_ends::<BinaryColor, RawU1, 10>()?;
        self.check_ends::<BinaryColor, RawU1, 22>()?;
        self.check_band(self.colors.map(|raw| BinaryColor::from(RawU1::from_u32(raw))))?;
        // Of 8 x 8 pixels anywhere, as many take the colour as the alpha says.
        let [alpha, _] = self.alphas;
        let Point { x, y } = self.stage.point(self.spot);
        let block = (0..8).flat_map(|row| (0..8).map(move |column| (column, row)));
        let taken = block.filter(|(column, row)| {
            let point = Point::new(x.wrapping_add(*column), y.wrapping_add(*row));
            BinaryColor::On.over::<10>(BinaryColor::Off, alpha, point) == BinaryColor::On
        });
        let expected = (i32::from(alpha) * 128 + 255) / 510;
        ensure!(taken.count() as i32 == expected, "{expected} pixels of 64 for {alpha}");
        Ok(())
    }
}

/// Colours at levels, and straight lines between them.
#[derive(Debug, Arbitrary)]
pub struct RampCase {
    stops: [(u8, [u8; 3]); 4],
    sorted: bool,
    level: u8,
}

impl Case for RampCase {
    fn check(&self) -> Verdict {
        let mut stops = self
            .stops
            .map(|(level, [red, green, blue])| (level, Rgb888::new(red, green, blue)));
        if self.sorted {
            stops.sort_by_key(|&(level, _)| level);
        }
        let is_sorted = stops.is_sorted_by_key(|&(level, _)| level);
        let ramp = match Ramp::new(stops) {
            Ok(ramp) => ramp,
            Err(error) => {
                ensure!(!is_sorted, "{error}");
                return Ok(());
            }
        };
        ensure!(is_sorted && Ramp::<0>::new([]).is_err(), "stops that do not ascend");
        let found = ramp.color_at(self.level).levels();
        let before = stops.iter().rev().find(|(stop, _)| *stop <= self.level);
        let after = stops.iter().find(|(stop, _)| *stop > self.level);
        let (from, to) = match (before, after) {
            (Some(from), Some(to)) => (from, to),
            (Some(only), None) | (None, Some(only)) => (only, only),
            (None, None) => return Ok(()),
        };
        let levels = i32::from(to.0) - i32::from(from.0);
        let way = i32::from(self.level) - i32::from(from.0);
        for ((found, _), ((from, _), (to, _))) in found.into_iter().zip(from.1.levels().into_iter().zip(to.1.levels()))
        {
            // Within 0.502 of the straight line.
            let exact = if levels == 0 {
                f64::from(from)
            } else {
                f64::from(from) + f64::from(to - from) * f64::from(way) / f64::from(levels)
            };
            ensure!(
                (f64::from(found) - exact).abs() <= 0.502,
                "{found} at {}, exactly {exact}",
                self.level
            );
        }
        Ok(())
    }
}

/// Weights and sums of filters, and a colour that stays the same.
#[derive(Debug, Arbitrary)]
pub struct FilterCase {
    index: Int,
    count: Int,
    level: u8,
}

/// The weights of a window are its own mirror images, and add up to a power of four.
fn check_weights<const N: usize, F: SampleFilter<N>>() -> Verdict {
    let side = F::PIXELS * N;
    let mut sum = 0u64;
    for (column, row) in (0..side).flat_map(|row| (0..side).map(move |column| (column, row))) {
        let weight = F::weight(column, row);
        sum += u64::from(weight);
        ensure!(
            weight == F::weight(side - 1 - column, row) && weight == F::weight(column, side - 1 - row),
            "{weight} at {column}, {row} is another one mirrored"
        );
    }
    ensure!(sum == 1 << (2 * F::SUM_BITS), "{sum} in all");
    ensure!(
        F::weight(side, 0) == 0 && F::weight(0, side) == 0,
        "weights beside the window"
    );
    Ok(())
}

impl Case for FilterCase {
    fn check(&self) -> Verdict {
        // Any sample, of the window or beside it.
        let [column, row] = [self.index.0, self.count.0].map(|index| index as u32 as usize);
        let weights = [
            <BoxFilter as SampleFilter<2>>::weight(column, row),
            <Bartlett as SampleFilter<16>>::weight(column, row),
            <ConeFilter as SampleFilter<8>>::weight(column, row),
            <Gaussian as SampleFilter<4>>::weight(column, row),
        ];
        ensure!(weights.iter().all(|&weight| weight < 1 << 24), "{weights:?}");
        check_weights::<2, BoxFilter>()?;
        check_weights::<16, Bartlett>()?;
        check_weights::<8, ConeFilter>()?;
        check_weights::<4, Gaussian>()?;
        let between = Ramp::between(Rgb888::BLACK, Rgb888::WHITE);
        let level = self.level;
        ensure!(
            between.color_at(level) == Rgb888::new(level, level, level),
            "level {level} of a ramp"
        );
        Ok(())
    }
}
