//! Ordered dithering against a plain reference: Bayer's matrix by its recursion, the display's levels by embedded-graphics'
//! conversion to 8 bits.

use std::convert::Infallible;

use embedded_graphics::{
    mock_display::MockDisplay,
    pixelcolor::{Bgr555, Bgr565, Bgr666, BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666, Rgb888},
    prelude::*,
    primitives::Rectangle,
};
use proptest::prelude::*;
use zrow::{
    band::{
        Band, BandColor, BigEndian, BytesSink, DisplaySink, Dithered, LittleEndian, LoopError, Order, PictureLoop, Span,
    },
    draw::{DrawOn, PrimitiveStyle},
    shade::BlendTarget,
};

use crate::common::{cases, channels::Channels, config};

/// A display's colour, and what embedded-graphics makes of it in 8 bits a channel.
trait Displayed: Channels<EightBit: Channels + From<Self>> {}
impl<C: Channels<EightBit: Channels + From<Self>>> Displayed for C {}

/// Calls a check for every colour of a display with fewer than 8 bits a channel, in both byte orders.
macro_rules! for_all_colors {
    ($check:ident $arguments:tt) => {
        for_all_colors!($check $arguments: BinaryColor, Gray2, Gray4, Rgb555, Bgr555, Rgb565, Bgr565, Rgb666, Bgr666)
    };
    ($check:ident $arguments:tt: $($color:ty),+) => {$(
        $check::<$color, LittleEndian> $arguments;
        $check::<$color, BigEndian> $arguments;
    )+};
}

/// Bayer's matrix of `size` x `size`, a power of two, by its recursion.
fn bayer(size: usize, x: usize, y: usize) -> usize {
    if size == 1 {
        return 0;
    }
    let half = size / 2;
    let quadrant = [[0, 2], [3, 1]][y / half % 2][x / half % 2];
    // The finest structure comes from the matrix of 2 x 2, so that neighbours differ most.
    4 * bayer(half, x % half, y % half) + quadrant
}

/// The threshold at a position of the picture.
fn threshold(position: Point) -> u32 {
    bayer(8, position.x.rem_euclid(8) as usize, position.y.rem_euclid(8) as usize) as u32
}

/// The levels of 8 bits that the levels of a channel stand for.
fn shown_levels<C: Displayed>(channel: usize) -> Vec<u32> {
    let shown = |level| {
        let mut channels = [0; 3];
        channels[channel] = level;
        C::EightBit::from(C::from_channels(channels)).channels()[channel]
    };
    (0..=C::MAX[channel]).map(shown).collect()
}

/// The levels of the display below and above a level of 8 bits, and what they stand for.
fn around(shown: &[u32], value: u32) -> ([u32; 2], [u32; 2]) {
    let lower = shown.iter().rposition(|&level| level <= value).unwrap();
    let upper = (lower + 1).min(shown.len() - 1);
    ([lower as u32, upper as u32], [shown[lower], shown[upper]])
}

/// The display's colour of a pixel.
fn expected<C: Displayed>(color: C::EightBit, position: Point) -> C {
    let values = color.channels();
    C::from_channels(std::array::from_fn(|channel| {
        if C::MAX[channel] == 0 {
            return 0;
        }
        let ([lower, upper], [below, above]) = around(&shown_levels::<C>(channel), values[channel]);
        // Of 64 steps from `below` to `above`, rounded; in halves, because there are no ties.
        let steps = (128 * (values[channel] - below) + (above - below)).checked_div(2 * (above - below));
        if threshold(position) < steps.unwrap_or(0) {
            upper
        } else {
            lower
        }
    }))
}

fn dithered<C: Displayed, O: Order>(area: Rectangle, colors: &[C::EightBit]) -> Vec<C> {
    let mut words: Vec<_> = colors
        .iter()
        .map(|&color| Band::<C::EightBit, O>::word(color))
        .collect();
    let band = Band::<C::EightBit, O>::new(area, &mut words)
        .unwrap()
        .into_dithered::<C>();
    assert_eq!((band.bounding_box(), band.words().len()), (area, colors.len()));
    band.colors().collect()
}

/// Every level in every channel, the channels running against each other, at every position.
fn every_level_is_right<C: Displayed, O: Order>() {
    for left in -9..8 {
        let area = Rectangle::new(Point::new(left, -left), Size::new(256, 1));
        let color = |value: u32| C::EightBit::from_channels([value, 255 - value, value * 7 % 256]);
        let colors: Vec<_> = (0..256).map(color).collect();
        let found = dithered::<C, O>(area, &colors);
        for ((position, &color), &found) in area.points().zip(&colors).zip(&found) {
            assert_eq!(found, expected(color, position), "{color:?} at {position}");
        }
    }
}

#[test]
fn each_level_takes_the_threshold_at_its_position() {
    for_all_colors!(every_level_is_right());
}

/// 8 bits to 8 bits: nothing changes.
#[test]
fn eight_bits_stay_as_they_are() {
    let area = Rectangle::new(Point::new(3, 5), Size::new(256, 1));
    let greys: Vec<_> = (0..=255).map(Gray8::new).collect();
    assert_eq!(dithered::<Gray8, LittleEndian>(area, &greys), greys);
    let colors: Vec<_> = (0..=255).map(|level| Rgb888::new(level, !level, level / 2)).collect();
    assert_eq!(dithered::<Rgb888, BigEndian>(area, &colors), colors);
}

/// Each colour that the display has stays itself, black and white among them.
fn colors_of_the_display_stay<C: Displayed, O: Order>() {
    let [first, second, third] = C::MAX;
    for one in 0..=first {
        let others = (0..=second).flat_map(|other| (0..=third).map(move |last| [one, other, last]));
        // A step through the largest sets, with no factor of 2 in it.
        let step = if first * second * third > 20_000 { 7 } else { 1 };
        let exact: Vec<C> = others.step_by(step).map(C::from_channels).collect();
        let colors: Vec<_> = exact.iter().map(|&color| C::EightBit::from(color)).collect();
        // In a row that has the lowest threshold.
        let area = Rectangle::new(Point::new(one as i32, 8), Size::new(colors.len() as u32, 1));
        assert_eq!(dithered::<C, O>(area, &colors), exact);
    }
}

#[test]
fn what_the_display_has_stays_itself() {
    for_all_colors!(colors_of_the_display_stay());
}

/// The mean of any 8 x 8 pixels of one colour is within half a step, and a brighter level is nowhere darker.
fn means_are_right<C: Displayed, O: Order>() {
    let channels = (0..3).filter(|&channel| C::MAX[channel] > 0);
    for channel in channels {
        let shown = shown_levels::<C>(channel);
        for corner in [Point::new(0, 0), Point::new(-3, 5), Point::new(6, -11)] {
            let area = Rectangle::new(corner, Size::new(8, 8));
            let mut darker = vec![0; 64];
            for value in 0..256 {
                let mut channels = [128; 3];
                channels[channel] = value;
                let color = C::EightBit::from_channels(channels);
                let found = dithered::<C, O>(area, &[color; 64]);
                let levels: Vec<u32> = found.iter().map(|color| color.channels()[channel]).collect();
                let sum: u32 = levels.iter().map(|&level| shown[level as usize]).sum();
                let (_, [below, above]) = around(&shown, value);
                assert!(2 * sum.abs_diff(64 * value) <= above - below, "{value}: {sum} / 64");
                assert!(
                    levels.iter().zip(&darker).all(|(level, darker)| level >= darker),
                    "{value} is darker"
                );
                darker = levels;
            }
        }
    }
}

#[test]
fn means_are_within_half_a_step() {
    for_all_colors!(means_are_right());
}

/// Black and white dithered is white blended over black, which takes its thresholds by another way.
#[test]
fn black_and_white_is_as_blended() {
    let area = Rectangle::new(Point::new(-5, 9), Size::new(17, 9));
    for alpha in 0..=255 {
        let mut words = [0; 17 * 9];
        let mut band = Band::<BinaryColor>::new(area, &mut words).unwrap();
        for y in area.rows() {
            let Ok(()) = band.blend_span(Span::new(y, -5, 12), BinaryColor::On, alpha);
        }
        let found = dithered::<BinaryColor, LittleEndian>(area, &[Gray8::new(alpha); 17 * 9]);
        assert_eq!(found, band.colors().collect::<Vec<_>>(), "{alpha}");
    }
}

/// Rows of runs, so that blocks of one colour follow each other, and of other colours.
fn picture<C: Displayed>(area: Rectangle, runs: &[(u8, [u8; 3])]) -> Vec<C::EightBit> {
    let colors = runs.iter().cycle().flat_map(|&(length, color)| {
        std::iter::repeat_n(C::EightBit::from_channels(color.map(u32::from)), usize::from(length))
    });
    colors.take((area.size.width * area.size.height) as usize).collect()
}

/// A picture drawn in bands of any height and dithered is each of its pixels dithered.
fn bands_are_alike<C: Displayed, O: Order>(area: Rectangle, rows: u32, runs: &[(u8, [u8; 3])]) {
    let colors = picture::<C>(area, runs);
    let mut found = Vec::new();
    let mut sink = Dithered::<C, _>::new(|band: Band<'_, C, O>| -> Result<(), Infallible> {
        found.extend(band.colors());
        Ok(())
    });
    let picture = PictureLoop::new(area, colors[0]).rows(rows).in_order::<O>();
    let mut buffer = vec![<C::EightBit as BandColor>::to_word(colors[0]); picture.words_needed()];
    let drawn = picture.draw(&mut buffer, &mut sink, |band| {
        let Ok(()) = band.fill_contiguous(&area, colors.iter().copied());
    });
    assert!(drawn.is_ok());
    let pixels = area.points().zip(&colors);
    let expected: Vec<C> = pixels.map(|(position, &color)| expected(color, position)).collect();
    assert_eq!(found, expected);
}

proptest! {
    #![proptest_config(config(cases(60, 600)))]

    #[test]
    fn bands_of_any_height_are_dithered_alike(
        (left, top) in prop_oneof![(-20i32..20, -20i32..20), Just((i32::MIN, i32::MAX - 12)), Just((i32::MAX - 45, i32::MIN))],
        (width, height) in (1u32..45, 1u32..12),
        rows in 1u32..13,
        runs in prop::collection::vec((prop_oneof![1u8..3, 1u8..60], any::<[u8; 3]>()), 1..12),
    ) {
        let area = Rectangle::new(Point::new(left, top), Size::new(width, height));
        for_all_colors!(bands_are_alike(area, rows, &runs));
    }
}

/// The loop in the finer colour, and a display or the bytes of one behind it.
#[test]
fn sinks_get_the_dithered_picture() {
    let mut display = MockDisplay::<Rgb565>::new();
    let area = display.bounding_box();
    let color = Rgb888::new(50, 100, 150);
    let square = Rectangle::new(Point::new(3, 2), Size::new(30, 20)).into_styled(PrimitiveStyle::with_fill(color));
    let mut row = [0; 64];
    PictureLoop::new(area, Rgb888::WHITE)
        .draw(&mut row, &mut Dithered::new(DisplaySink(&mut display)), |band| {
            square.draw_on(band)
        })
        .unwrap();
    let mut bytes = Vec::new();
    let mut sink = Dithered::<Rgb565, _>::new(BytesSink(|_: Rectangle, packed: &[u8]| -> Result<(), Infallible> {
        bytes.extend_from_slice(packed);
        Ok(())
    }));
    let mut rows = [0; 64 * 5];
    let picture = PictureLoop::new(area, Rgb888::WHITE).rows(5).in_order::<BigEndian>();
    picture.draw(&mut rows, &mut sink, |band| square.draw_on(band)).unwrap();
    for (position, bytes) in area.points().zip(bytes.chunks(2)) {
        let color = if square.bounding_box().contains(position) {
            color
        } else {
            Rgb888::WHITE
        };
        let expected: Rgb565 = expected(color, position);
        assert_eq!(display.get_pixel(position), Some(expected), "{position}");
        assert_eq!(bytes, expected.into_storage().to_be_bytes(), "{position}");
    }
    assert_eq!(bytes.len(), 2 * 64 * 64);
}

#[test]
fn an_error_of_the_display_is_handed_on() {
    let area = Rectangle::new(Point::zero(), Size::new(4, 4));
    let mut calls = 0;
    let mut sink = Dithered::<Gray4, _>::new(|_: Band<'_, Gray4>| {
        calls += 1;
        if calls == 3 { Err("broken") } else { Ok(()) }
    });
    let drawn = PictureLoop::new(area, Gray8::WHITE).draw(&mut [0; 4], &mut sink, |_| {});
    assert_eq!((drawn, calls), (Err(LoopError::Sink("broken")), 3));
}

#[test]
fn a_band_without_pixels_stays_so() {
    for size in [Size::new(0, u32::MAX), Size::new(u32::MAX, 0), Size::zero()] {
        let area = Rectangle::new(Point::new(-7, i32::MIN), size);
        let band = Band::<Rgb888>::new(area, &mut []).unwrap();
        assert!(band.into_dithered::<Rgb565>().words().is_empty());
    }
}
