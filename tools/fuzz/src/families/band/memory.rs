//! Bands in memory of any size.

use anyhow::ensure;
use arbitrary::Arbitrary;
use embedded_graphics::{
    geometry::{Dimensions, Point, Size},
    image::GetPixel,
    pixelcolor::{
        BinaryColor, Gray2, Gray4, Gray8, PixelColor, Rgb565, Rgb666, Rgb888,
        raw::{RawData, RawU1, RawU2, RawU4, RawU8, RawU16, RawU24, ToBytes},
    },
    prelude::PointsIter,
    primitives::Rectangle,
};
use zrow::{
    band::{Band, BandColor, BigEndian, LittleEndian, Order, Target},
    geometry::{TooSmall, Window},
    shade::ChannelColor,
};

use crate::{
    target::{Case, Verdict},
    values::{Count, Hue, Int, Spot, Stage},
};

/// The word of the colour that is dithered to another one.
type Word<C> = <<C as ChannelColor>::EightBit as BandColor>::Word;

/// The words and bytes of a band of any size, and what it is dithered to.
#[derive(Debug, Arbitrary)]
pub struct MemoryCase {
    stage: Stage,
    words: u16,
    any: [Int; 2],
    any_size: [Count; 2],
    point: Spot,
    raw: [u32; 8],
}

impl MemoryCase {
    /// Bytes that a display takes: whole ones for each row, several pixels in a byte below 8 bits. Channels of 24-bit
    /// colours leave some bits of their byte unused.
    fn check_bytes<C, R, O>(&self, unused_bits: u32) -> Verdict
    where
        C: BandColor + PixelColor<Raw = R> + From<R> + ToBytes,
        <C as ToBytes>::Bytes: AsRef<[u8]>,
        R: RawData + From<C>,
        R::Storage: Into<u32>,
        O: Order,
    {
        let (width, height) = (self.stage.window.width() as usize, self.stage.window.height() as usize);
        let colors: Vec<C> = (0..width * height)
            .map(|index| C::from(R::from_u32(self.raw[index % 8].rotate_left(index as u32))))
            .collect();
        let words: Vec<C::Word> = colors.iter().map(|color| Band::<C, O>::word(*color)).collect();
        let mut memory = words.clone();
        let band = Band::<C, O>::new(self.stage.area(), &mut memory)?;
        let bytes = band.into_bytes().to_vec();
        let bits = R::BITS_PER_PIXEL;
        let expected: Vec<u8> = match bits {
            0..8 => {
                let rows = colors.chunks(width);
                let packed = |group: &[C]| {
                    let levels = group.iter().map(|color| R::from(*color).into_inner().into() as u8);
                    let byte = levels.fold(0, |byte: u32, level| byte << bits | u32::from(level));
                    (byte << (bits * (8 / bits - group.len()))) as u8
                };
                rows.flat_map(|row| row.chunks(8 / bits).map(packed).collect::<Vec<_>>())
                    .collect()
            }
            // Three bytes a pixel, with the channel at the top of its byte.
            24 => {
                let channel_bits = 8 - unused_bits;
                let to_bytes = |color: &C| {
                    let word: u32 = R::from(*color).into_inner().into();
                    let channels = [word >> (2 * channel_bits), word >> channel_bits, word];
                    channels.map(|channel| (channel << unused_bits) as u8)
                };
                colors.iter().flat_map(to_bytes).collect()
            }
            _ => colors
                .iter()
                .flat_map(|color| color.to_be_bytes().as_ref().to_vec())
                .collect(),
        };
        ensure!(bytes == expected, "{bits} bits a pixel: {bytes:?}, not {expected:?}");
        Ok(())
    }
}

impl MemoryCase {
    /// A pixel is dithered by its colour and its position alone: in a band of all pixels, and in one of its own.
    fn check_dithered<C: ChannelColor, O: Order>(&self, word: impl Fn(u32) -> Word<C>) -> Verdict {
        let Self { stage, raw, .. } = self;
        let pixels = stage.pixels();
        // Runs of one colour, of different lengths.
        let length = raw[0] as usize % 19 + 1;
        let words: Vec<_> = (0..pixels)
            .map(|index| word(raw[index / length % 8].rotate_left((index / length) as u32)))
            .collect();
        let mut memory = words.clone();
        let band = Band::<C::EightBit, O>::new(stage.area(), &mut memory)?.into_dithered::<C>();
        ensure!(band.window() == stage.window, "another window");
        for ((position, color), word) in stage.area().points().zip(band.colors()).zip(words) {
            let mut memory = [word];
            let pixel = Rectangle::new(position, Size::new_equal(1));
            let alone = Band::<C::EightBit, O>::new(pixel, &mut memory)?.into_dithered::<C>();
            let alone = alone.pixel(position).map(C::to_word);
            ensure!(
                alone == Some(color.to_word()),
                "{position:?}: {:?}, not {alone:?}",
                color.to_word()
            );
        }
        Ok(())
    }
}

impl Case for MemoryCase {
    fn check(&self) -> Verdict {
        let Self { stage, .. } = self;
        // Any area, with few words.
        let area = Rectangle::new(
            Point::new(self.any[0].0, self.any[1].0),
            Size::new(self.any_size[0].0, self.any_size[1].0),
        );
        let mut words = vec![0u16; usize::from(self.words % 512)];
        for area in [area, stage.area()] {
            let window = Window::from(area);
            let needed = u128::from(window.width()) * u128::from(window.height());
            let length = words.len();
            match Band::<Rgb565>::new(area, &mut words) {
                Ok(mut band) => {
                    ensure!(
                        needed <= length as u128 && band.words().len() as u128 == needed,
                        "{needed} words"
                    );
                    ensure!(
                        band.words_mut().len() as u128 == needed,
                        "{needed} words, to be written"
                    );
                    ensure!(band.colors().count() as u128 == needed, "{needed} colours");
                    ensure!(
                        Window::from(band.bounding_box()) == window || window.is_empty(),
                        "another box"
                    );
                    ensure!(band.window() == window, "another window");
                    let point = stage.point(self.point);
                    let has_row = (window.top..window.bottom).contains(&point.y);
                    let row = band.row_mut(point.y).map(|row| row.len());
                    ensure!(
                        row == has_row.then_some(window.width() as usize),
                        "row {} has {row:?} words of {window:?}",
                        point.y
                    );
                    ensure!(
                        band.pixel(point).is_some() == window.contains(point),
                        "{point:?} in {window:?}"
                    );
                    band.fill(Hue::Odd.color());
                    ensure!(
                        band.colors().all(|color| color == Hue::Odd.color()),
                        "a fill leaves something out"
                    );
                }
                Err(error) => {
                    let is_right = matches!(error, TooSmall::Words(said) if said as u128 == needed);
                    ensure!(is_right && needed > length as u128, "{error}: for {needed} pixels");
                }
            }
        }
        self.check_dithered::<Rgb565, LittleEndian>(|raw| raw & 0xff_ffff)?;
        self.check_dithered::<Rgb565, BigEndian>(|raw| (raw & 0xff_ffff).to_be())?;
        self.check_dithered::<Rgb666, LittleEndian>(|raw| raw & 0xff_ffff)?;
        self.check_dithered::<Gray4, LittleEndian>(|raw| raw as u8)?;
        self.check_dithered::<BinaryColor, LittleEndian>(|raw| raw as u8)?;
        self.check_bytes::<BinaryColor, RawU1, LittleEndian>(0)?;
        self.check_bytes::<Gray2, RawU2, LittleEndian>(0)?;
        self.check_bytes::<Gray4, RawU4, BigEndian>(0)?;
        self.check_bytes::<Gray8, RawU8, LittleEndian>(0)?;
        self.check_bytes::<Rgb565, RawU16, LittleEndian>(0)?;
        self.check_bytes::<Rgb565, RawU16, BigEndian>(0)?;
        self.check_bytes::<Rgb666, RawU24, LittleEndian>(2)?;
        self.check_bytes::<Rgb888, RawU24, LittleEndian>(0)?;
        self.check_bytes::<Rgb888, RawU24, BigEndian>(0)
    }
}
